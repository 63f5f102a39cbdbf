// The scan thread: drains commands at scan boundaries, paces the scans, publishes what they made, serves commands at a
// breakpoint (D8).
#include "projects/session/session_state.h"
#include "runtime/base/messages.h"
#include "runtime/platform/scheduling.h"

#include <algorithm>
#include <cstring>

namespace plc::session {

using controller::EventKind;
using PlcState = controller::State;

namespace {
constexpr int64_t kPublishEvery = 5'000'000, kShareEvery = 5'000'000, kStatisticsEvery = 100'000'000,
                  kLoadWindow = 250'000'000;
constexpr int64_t kRest = 1'000'000'000, kRetry = 1'000'000; // while no scan is due; what was not published comes soon
constexpr size_t kEventsKept = 100'000;
} // namespace

int64_t wallNow() { return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count(); }

void Session::State::post(When when, std::function<void()> run) {
    if (!isQueueing.load(std::memory_order_acquire)) {
        run();
        share(true);
        return;
    }
    commands.push({when, std::move(run)});
    wakeUp.signal();
}

bool Session::State::scansAreWanted() const {
    switch (controller.state()) {
    case PlcState::Running:
        return true;
    case PlcState::Paused:
    case PlcState::Halted:
        return false;
    case PlcState::Stopped:
    case PlcState::Fault:
        return controller.hasSimulation() && !controller.simulationFault(); // the plant goes on
    }
    return false;
}

void Session::State::run() {
    platform::nameThread("scan"); // how a server finds it to make it urgent
    platform::wakeExactly();
    while (!isQuitting.load(std::memory_order_acquire)) {
        drain();
        keepFaultImage();
        if (!scansAreWanted()) {
            reportSkipped(wallNow());
            const bool isPublished = publish();
            share(true);
            needsAnchor = true;
            load.store(0, std::memory_order_relaxed);
            busyNs = 0;
            loadSince = wallNow();
            if (commands.isEmpty() && deferred.empty() && !isQuitting.load(std::memory_order_acquire))
                wakeUp.wait(controller.state() == PlcState::Running ? 0 : isPublished ? kRest : kRetry);
            continue;
        }
        const bool isStopped = controller.state() != PlcState::Running; // only the plant: at its own pace
        if (mode.pace == Pace::Fastest && !isStopped)
            scanFast();
        else
            scanInRealTime(wallNow(), mode.pace == Pace::Factor && !isStopped ? mode.factor : 1.0);
    }
    publish();
}

void Session::State::drain() {
    leaveAskedAt = 0;
    const uint64_t end = commands.pushed(); // what comes meanwhile waits for the next boundary: the scans go on
    for (;;) {                              // a command may itself defer others
        std::optional<Command> command;
        if (!deferred.empty()) {
            command = std::move(deferred.front());
            deferred.pop_front();
        } else {
            command = commands.popBefore(end);
        }
        if (!command) break;
        command->run();
        sharedIsStale = true;
    }
    if (!writes.isEmpty()) {
        writes.apply(controller, controller.state() == PlcState::Running, newRefusals);
        sharedIsStale = true;
    }
    showState();
}

bool Session::State::leavesLongScan() {
    constexpr int64_t kPatience = 200'000'000; // an ordinary scan is over by then
    if (!isQueueing.load(std::memory_order_relaxed)) return false;
    bool isAsked = isQuitting.load(std::memory_order_acquire);
    const uint64_t end = commands.pushed();
    while (std::optional<Command> command = commands.popBefore(end)) {
        isAsked = isAsked || command->when == When::Leave;
        deferred.push_back(std::move(*command));
    }
    const int64_t now = wallNow();
    if (isAsked && leaveAskedAt == 0) leaveAskedAt = now;
    return leaveAskedAt != 0 && now - leaveAskedAt >= kPatience;
}

void Session::State::anchor(int64_t now) {
    wallAnchor = now;
    plcAnchor = controller.nextDue().count();
    needsAnchor = false;
}

void Session::State::scanInRealTime(int64_t now, double factor) {
    if (needsAnchor || factor != anchoredFactor) anchor(now);
    anchoredFactor = factor;
    const auto plcNow = plcAnchor + static_cast<int64_t>(static_cast<double>(now - wallAnchor) * factor);
    const int64_t due = controller.nextDue().count();
    if (due > plcNow) {
        const auto wait = static_cast<int64_t>(static_cast<double>(due - plcNow) / factor);
        if (wait > kPublishEvery / 2 || now - lastPublish >= kPublishEvery) publish();
        if (sharedIsStale && (wait > 200'000 || now - lastShare >= kShareEvery)) share(wait > 200'000);
        wakeUp.wait(std::clamp<int64_t>(wait, 0, 100'000'000));
        return;
    }
    const uint64_t scan = controller.nextScan();
    haltedNs = 0;
    (void)controller.scan(Nanoseconds(plcNow));
    const int64_t end = wallNow(), begin = now + haltedNs;
    if (mode.pace == Pace::Real) times.add({scan, controller.lastTime(), plcNow - due, end - begin});
    lastScanNs.store(end - begin, std::memory_order_relaxed);
    afterScans(begin, end);
}

/// Virtual time: as many scans as fit into about a millisecond before looking at the clock again; fewer, but one at
/// least, when commands wait.
void Session::State::scanFast() {
    int64_t begin = wallNow();
    haltedNs = 0;
    const int64_t last = std::max<int64_t>(lastScanNs.load(std::memory_order_relaxed), 100);
    const auto batch = std::clamp<int64_t>(1'000'000 / last, 1, 256);
    int64_t done = 0;
    do {
        if (!writes.isEmpty()) writes.apply(controller, true, newRefusals);
        (void)controller.scan();
        ++done;
        if (pausesAfterScan) break; // asked for while it stood at a breakpoint
    } while (done < batch && controller.state() == PlcState::Running && commands.isEmpty() && deferred.empty() &&
             !isQuitting.load(std::memory_order_relaxed));
    const int64_t end = wallNow();
    begin += haltedNs;
    needsAnchor = true;
    lastScanNs.store((end - begin) / done, std::memory_order_relaxed);
    afterScans(begin, end);
}

/// At most one mark a second, and one when the scans end: all of them are counted in the end.
void Session::State::reportSkipped(int64_t now) {
    if (controller.skippedScans() == skippedReported) return;
    controller.report(EventKind::SkippedScans, errors::Count(controller.skippedScans() - skippedReported));
    skippedReported = controller.skippedScans();
    skippedReportedAt = now;
}

void Session::State::keepFaultImage() {
    if (controller.state() != PlcState::Fault) {
        if (!faultImage) return;
        faultImage.reset();
        sharedIsStale = true;
    } else if (!faultImage) {
        const std::span<const std::byte> image = controller.image();
        faultImage =
            std::make_shared<const FaultImage>(FaultImage{{image.begin(), image.end()}, controller.sharedProgram()});
        share(true); // before anybody sees the state
    }
}

void Session::State::afterScans(int64_t begin, int64_t end) {
    keepFaultImage();
    if (pausesAfterScan) {
        pausesAfterScan = false;
        controller.pause();
    }
    showState();
    busyNs += end - begin;
    if (loadSince == 0) loadSince = begin;
    if (end - loadSince >= kLoadWindow) {
        load.store(std::min(1.0, static_cast<double>(busyNs) / static_cast<double>(end - loadSince)),
                   std::memory_order_relaxed);
        busyNs = 0;
        loadSince = end;
    }
    skipped.store(controller.skippedScans(), std::memory_order_relaxed);
    if (end - skippedReportedAt > 1'000'000'000) reportSkipped(end);
    if (end - lastPublish >= kPublishEvery) publish();
    if (end - lastShare >= (sharedIsStale ? kShareEvery : kStatisticsEvery)) share(false);
}

// ---------------------------------------------------------------- at a breakpoint

debug::Going Session::State::serveHalt(const debug::Halt& halt) {
    const int64_t since = wallNow();
    isHalted = true;
    goesOn = leavesScan = false;
    haltFrames = halt.frames;
    haltProblem = halt.problem;
    bool isFresh = false, isCounted = false;
    while (!goesOn && !leavesScan) {
        if (isQuitting.load(std::memory_order_acquire)) leavesScan = true;
        const uint64_t end = commands.pushed(); // what comes meanwhile wakes up again
        while (std::optional<Command> command = goesOn || leavesScan ? std::nullopt : commands.popBefore(end)) {
            isFresh = false;
            if (command->when == When::Now) {
                command->run();
                writes.apply(controller, false, newRefusals);
            } else {
                leavesScan = command->when == When::Leave;
                if (!leavesScan) newRefusals.push_back({errors::OnlineChangeWaits(), {}});
                deferred.push_back(std::move(*command));
            }
        }
        if (goesOn || leavesScan) break;
        if (!isFresh && publish()) {
            sharedIsStale = true;
            share(true);
            isFresh = true;
            if (!std::exchange(isCounted, true)) halts.fetch_add(1, std::memory_order_release);
        }
        wakeUp.wait(isFresh ? kRest : kRetry);
    }
    isHalted = false;
    haltedNs += wallNow() - since;
    haltFrames.clear();
    haltProblem = {};
    needsAnchor = true;
    sharedIsStale = true;
    if (!leavesScan) state.store(PlcState::Running, std::memory_order_release);
    return leavesScan ? debug::Going::Abandon : debug::Going::On;
}

// ---------------------------------------------------------------- what others see

bool Session::State::publish() {
    lastPublish = wallNow();
    Snapshot* next = published.begin();
    if (!next) return false; // readers hold every spare one; the next publication comes soon
    const std::span<const std::byte> image = controller.image();
    next->image.resize(image.size());
    // The frame area is of interest only where the scan stands.
    const size_t size = isHalted ? image.size() : std::min<size_t>(image.size(), controller.program().layout.dataEnd);
    std::memcpy(next->image.data(), image.data(), size);
    std::memset(next->image.data() + size, 0, image.size() - size);
    if (next->program != controller.sharedProgram()) next->program = controller.sharedProgram();
    next->scan = controller.nextScan() > 0 ? controller.nextScan() - 1 : 0;
    next->time = controller.lastTime();
    const history::Statistics recorded = history.statistics();
    next->position = recorded.end > 0 ? recorded.end - 1 : 0;
    next->isHalted = isHalted;
    published.publish();
    publishedState = stateNow();
    if (std::exchange(savesRetain, false)) wantsRetainSaved.store(true, std::memory_order_release);
    return true;
}

PlcState Session::State::stateNow() const { return isHalted ? PlcState::Halted : controller.state(); }

void Session::State::showState() {
    const PlcState now = stateNow();
    if (publishedState != now && !publish()) return; // with the next publication
    state.store(now, std::memory_order_release);
}

void Session::State::share(bool mayWait) {
    std::unique_lock lock(mutex, std::defer_lock);
    if (mayWait)
        lock.lock();
    else if (!lock.try_lock())
        return; // at the next boundary
    putShared();
}

void Session::State::putShared() {
    shared.fault = controller.fault();
    shared.faultImage = faultImage;
    shared.simulationFault = controller.simulationFault();
    shared.forces = controller.forces();
    shared.frames = haltFrames;
    shared.haltProblem = haltProblem;
    shared.tasks = controller.statistics();
    shared.times = times;
    lastShare = wallNow();
    for (controller::Event& event : newEvents) shared.events.push_back(std::move(event));
    newEvents.clear();
    for (; shared.events.size() > kEventsKept; ++shared.firstEvent) shared.events.pop_front();
    for (Error& refusal : newRefusals) shared.refusals.push_back(std::move(refusal));
    newRefusals.clear();
    sharedIsStale = false;
    showState();
}

void Session::State::scanFinished(std::span<const std::byte> image, uint64_t scan, Nanoseconds at) {
    if (settings.record) history.append(image, scan, at, controller.dirtyPages());
    scans.store(scan + 1, std::memory_order_relaxed);
    time.store(at.count(), std::memory_order_relaxed);
}

void Session::State::outsideActed(const image::Outside& outside) {
    if (settings.record) history.outsideActed(outside);
}

void Session::State::actedWhileHalted(std::span<const image::OutsideNote> notes) {
    if (settings.record) history.actedWhileHalted(notes);
}

void Session::State::programChanged(std::shared_ptr<const image::CompiledProgram> program) {
    if (settings.record) history.beginProgram(std::move(program));
}

void Session::State::eventHappened(const controller::Event& event) {
    newEvents.push_back(event);
    sharedIsStale = true;
    if (settings.record) history.mark(static_cast<int>(event.kind), event.text, event.time);
    if (event.kind == EventKind::Stopped || event.kind == EventKind::Fault) savesRetain = true;
}

} // namespace plc::session
