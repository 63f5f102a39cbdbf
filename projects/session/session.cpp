#include "projects/session/session.h"

#include "projects/session/session_state.h"
#include "projects/session/write_together.h"
#include "runtime/base/assert.h"
#include "runtime/base/messages.h"
#include "runtime/controller/leave_hook.h"
#include "runtime/controller/retain.h"
#include "runtime/debug/frames.h"

#include <future>

namespace plc::session {

using controller::EventKind;
using PlcState = controller::State;

Session::State::State(driver::Built first, Settings s, std::shared_ptr<Versions> v)
    : settings(std::move(s)), versions(std::move(v)), history(settings.historyBudget),
      controller(first.program, settings.controller) {
    adopt(std::make_shared<const driver::Built>(std::move(first)));
    loadRetained();
    controller::setLeaveHook(controller, [this] { return leavesLongScan(); });
    controller.addObserver(*this);
    state.store(controller.state());
}

Session::State::~State() = default;

/// The version that runs from now on.
void Session::State::adopt(std::shared_ptr<const driver::Built> built) {
    if (!versions->of(built->program.get())) versions->add(built);
    current.store(versions->of(built->program.get()).get());
    if (!built->input) return;
    std::vector<std::pair<std::string, std::string>> sources;
    for (const driver::SourceFile& file : built->input->files) sources.emplace_back(file.path, file.text);
    history.describeProgram(built->program, std::move(sources), driver::recordedSettings(*built->input),
                            driver::libraryTexts(*built->input));
}

void Session::State::optimise(std::shared_ptr<const driver::Built> built) {
    if (!worker) return;
    worker->post([this, built = std::move(built)] {
        if (isQuitting.load() || built->program->optimised.load()) return;
        const auto progress = std::make_shared<Progress>();
        {
            const std::lock_guard lock(mutex);
            optimising = progress;
        }
        if (isQuitting.load()) progress->cancel(); // set before it could be seen
        const Result<void> done = driver::optimise(*built, progress.get());
        const std::lock_guard lock(mutex); // the quick code goes on
        optimising = nullptr;
        if (done || progress->isCancelled()) return;
        shared.refusals.push_back({errors::NotOptimised(done.error().message), done.error().place});
    });
}

Session::Session(driver::Built built, Settings settings)
    : m(std::make_unique<State>(std::move(built), std::move(settings), versions())) {}

Session::~Session() { end(); }

void Session::end() {
    m->isQuitting.store(true, std::memory_order_release);
    m->wakeUp.signal();
    if (m->thread.joinable()) m->thread.join();
    m->isQueueing.store(false);
    if (const auto work = optimising()) work->cancel();
    m->worker.reset();
    if (m->lastRetainScan != m->controller.nextScan() && !m->settings.retainFile.empty()) (void)saveRetained();
    m->settings.retainFile.clear(); // another session writes it from now on
}

const driver::Built& Session::built() const { return *m->current.load(std::memory_order_acquire); }
std::shared_ptr<const image::CompiledProgram> Session::program() const { return built().program; }
history::History& Session::history() { return m->history; }
const history::History& Session::history() const { return m->history; }

Status Session::status() const {
    Status status;
    status.halts = m->halts.load(std::memory_order_acquire); // before the state: a later halt is seen the next time
    status.state = m->state.load(std::memory_order_acquire); // the values that belong to it are published
    status.scans = m->scans.load(std::memory_order_relaxed);
    status.time = Nanoseconds(m->time.load(std::memory_order_relaxed));
    status.load = m->load.load(std::memory_order_relaxed);
    status.lastScanNs = m->lastScanNs.load(std::memory_order_relaxed);
    status.skippedScans = m->skipped.load(std::memory_order_relaxed);
    const history::Statistics recorded = m->history.statistics();
    status.position = recorded.end > 0 ? recorded.end - 1 : 0;
    if (!m->isQueueing.load(std::memory_order_acquire)) status.state = m->controller.state();
    const std::lock_guard lock(m->mutex);
    status.fault = m->shared.fault;
    status.simulationFault = m->shared.simulationFault;
    status.retainProblem = m->shared.retainProblem;
    return status;
}

// ---------------------------------------------------------------- stepped by the caller

controller::Controller& Session::controller() {
    PLC_ASSERT(!m->thread.joinable(), (void)0);
    return m->controller;
}

void Session::runHere(const std::function<bool(const controller::Controller&)>& stop) {
    PLC_ASSERT(!m->thread.joinable(), return );
    m->isQueueing.store(true, std::memory_order_release);
    m->controller.start();
    for (;;) {
        m->drain();
        if (m->controller.state() != PlcState::Running) break;
        const bool good = m->controller.scan();
        if (!good || stop(m->controller)) break;
        if (m->sharedIsStale) m->share(false);
    }
    m->isQueueing.store(false, std::memory_order_release);
    m->drain(); // posted while the last scan ran
    m->publish();
    m->share(true);
}

// ---------------------------------------------------------------- the scan thread

void Session::startThread(RunMode mode, bool paused) {
    if (m->sendsElsewhere({paused ? OrderKind::Pause : OrderKind::Start})) return;
    if (m->thread.joinable()) {
        setMode(mode);
        start();
        if (paused) pause();
        return;
    }
    m->mode = mode;
    State* s = m.get();
    m->worker = std::make_unique<Worker>([s] { s->tick(); });
    m->debugger = std::make_unique<debug::Debugger>(
        m->controller,
        [s](const std::string& text, const std::string& instance) {
            return s->versions->expression(*s->current.load(), text, instance);
        },
        [s](const debug::Halt& halt) { return s->serveHalt(halt); });
    m->debugger->setBreakpoints(m->breakpoints);
    m->lastRetainSave = wallNow();
    m->optimise(m->versions->of(built().program.get()));
    m->controller.start();
    if (paused) m->controller.pause();
    m->publish();
    m->share(true);
    m->isQueueing.store(true, std::memory_order_release);
    m->thread = std::thread([s] { s->run(); });
}

void Session::setMode(RunMode mode) {
    if (m->outlet) return; // it keeps its own time
    m->post(When::Now, [s = m.get(), mode] {
        s->mode = mode;
        s->mode.factor = std::max(mode.factor, 1e-6);
        s->needsAnchor = true;
    });
}

void Session::start() {
    if (m->sendsElsewhere({OrderKind::Start})) return;
    m->post(When::Now, [s = m.get()] {
        if (s->isHalted) {
            s->debugger->resume();
            s->goesOn = true;
        }
        s->pausesAfterScan = false;
        s->controller.start();
    });
}

void Session::pause() {
    if (m->sendsElsewhere({OrderKind::Pause})) return;
    m->post(When::Now, [s = m.get()] {
        if (s->isHalted)
            s->pausesAfterScan = true;
        else
            s->controller.pause();
    });
}

void Session::singleScan() {
    if (m->sendsElsewhere({OrderKind::SingleScan})) return;
    m->post(When::Now, [s = m.get()] {
        if (s->isHalted) { // the scan that stands is the one
            s->debugger->resume();
            s->goesOn = s->pausesAfterScan = true;
            return;
        }
        if (s->controller.state() == PlcState::Stopped) s->controller.start();
        s->controller.pause();
        if (s->controller.state() != PlcState::Paused) return;
        s->writes.apply(s->controller, true, s->newRefusals);
        (void)s->controller.scan();
    });
}

void Session::stop() {
    if (m->sendsElsewhere({OrderKind::Stop})) return;
    m->post(When::Leave, [s = m.get()] { s->controller.stop(); });
}

void Session::reset(controller::ResetKind kind) {
    if (m->outlet) return m->outlet->post({.kind = OrderKind::Reset, .reset = kind});
    m->post(When::Leave, [s = m.get(), kind] { s->controller.reset(kind); });
}

void Session::write(Target target, types::Value value, std::string origin) {
    if (m->outlet)
        return m->outlet->post({.kind = OrderKind::Write,
                                .values = {{std::move(target.path), std::move(value)}},
                                .origin = std::move(origin)});
    m->post(When::Now,
            [s = m.get(), target = std::move(target), value = std::move(value), origin = std::move(origin)]() mutable {
                s->writes.write(std::move(target), std::move(value), std::move(origin));
                if (!s->isQueueing.load()) s->writes.apply(s->controller, false, s->newRefusals);
            });
}

void Session::writeTogether(std::vector<Assignment> values, std::string origin) {
    if (m->outlet)
        return m->outlet->post(
            {.kind = OrderKind::WriteTogether, .values = std::move(values), .origin = std::move(origin)});
    m->post(When::Now,
            [s = m.get(), together = Together{std::move(values), std::move(origin)}] { s->writeNow(together); });
}

void Session::State::writeNow(const Together& together) {
    controller.actFor(together.origin);
    if (auto done = writeAllOrNone(controller, together.values); !done) newRefusals.push_back(done.error());
    controller.actFor({});
}

void Session::press(Target target, types::Value pressed, types::Value released, std::string origin) {
    if (m->outlet)
        return m->outlet->post({.kind = OrderKind::Press,
                                .values = {{target.path, std::move(pressed)}, {target.path, std::move(released)}},
                                .origin = std::move(origin)});
    m->post(When::Now, [s = m.get(), target = std::move(target), pressed = std::move(pressed),
                        released = std::move(released), origin = std::move(origin)]() mutable {
        s->writes.press(std::move(target), std::move(pressed), std::move(released), std::move(origin));
        if (!s->isQueueing.load())
            s->writes.apply(s->controller, s->controller.state() == PlcState::Running, s->newRefusals);
    });
}

void Session::release(Target target) {
    if (m->outlet) return m->outlet->post({.kind = OrderKind::Release, .path = std::move(target.path)});
    m->post(When::Now, [s = m.get(), target = std::move(target)]() mutable {
        s->writes.release(std::move(target));
        if (!s->isQueueing.load())
            s->writes.apply(s->controller, s->controller.state() == PlcState::Running, s->newRefusals);
    });
}

void Session::force(std::string path, types::Value value, std::string origin) {
    if (m->outlet)
        return m->outlet->post(
            {.kind = OrderKind::Force, .values = {{std::move(path), std::move(value)}}, .origin = std::move(origin)});
    m->post(When::Now, [s = m.get(), path = std::move(path), value = std::move(value), origin = std::move(origin)] {
        s->controller.actFor(origin);
        if (const Result<void> done = s->controller.force(path, value); !done) s->newRefusals.push_back(done.error());
        s->controller.actFor({});
    });
}

void Session::unforce(std::string path) {
    if (m->outlet) return m->outlet->post({.kind = OrderKind::Unforce, .path = std::move(path)});
    m->post(When::Now, [s = m.get(), path = std::move(path)] {
        if (const Result<void> done = s->controller.release(path); !done) s->newRefusals.push_back(done.error());
    });
}

void Session::unforceAll() {
    if (m->sendsElsewhere({OrderKind::UnforceAll})) return;
    m->post(When::Now, [s = m.get()] { s->controller.releaseAll(); });
}

std::vector<controller::Forced> Session::forces() const {
    const std::lock_guard lock(m->mutex);
    return m->shared.forces;
}

std::vector<controller::TaskStatistics> Session::taskStatistics() const {
    if (!m->isQueueing.load(std::memory_order_acquire)) return m->controller.statistics();
    const std::lock_guard lock(m->mutex);
    return m->shared.tasks;
}

ScanTimes Session::scanTimes() const {
    if (!m->isQueueing.load(std::memory_order_acquire)) return m->times;
    const std::lock_guard lock(m->mutex);
    return m->shared.times;
}

void Session::resetTaskStatistics() {
    if (m->sendsElsewhere({OrderKind::ResetStatistics})) return;
    m->post(When::Now, [s = m.get()] { s->controller.resetStatistics(); });
}

void Session::resetStatistics() {
    if (m->sendsElsewhere({OrderKind::ResetStatistics})) return;
    m->post(When::Now, [s = m.get()] {
        s->controller.resetStatistics();
        s->times = {};
    });
}

std::vector<controller::Event> Session::eventsSince(size_t index) const {
    if (!m->isQueueing.load(std::memory_order_acquire) && !m->outlet) m->share(true);
    const std::lock_guard lock(m->mutex);
    const size_t skipped = index > m->shared.firstEvent ? index - m->shared.firstEvent : 0;
    if (skipped >= m->shared.events.size()) return {};
    return {m->shared.events.begin() + static_cast<std::ptrdiff_t>(skipped), m->shared.events.end()};
}

std::vector<Error> Session::takeRefusals() {
    const std::lock_guard lock(m->mutex);
    return std::exchange(m->shared.refusals, {});
}

std::shared_ptr<Progress> Session::optimising() const {
    const std::lock_guard lock(m->mutex);
    return m->optimising;
}

void Session::latest(Snapshot& into) const {
    if (!m->isQueueing.load(std::memory_order_acquire)) {
        const std::span<const std::byte> image = m->controller.image();
        into.image.assign(image.begin(), image.end());
        into.program = m->controller.sharedProgram();
        into.scan = m->controller.nextScan() > 0 ? m->controller.nextScan() - 1 : 0;
        into.time = m->controller.lastTime();
        const history::Statistics recorded = m->history.statistics();
        into.position = recorded.end > 0 ? recorded.end - 1 : 0;
        into.isHalted = false;
        return;
    }
    if (!m->published.read([&](const Snapshot& newest) { into = newest; })) into = {};
}

// ---------------------------------------------------------------- other programs, other times

void Session::changeProgram(driver::Built next, std::function<void(const controller::OnlineChangeReport&)> done,
                            std::optional<std::vector<Breakpoint>> breakpoints, Together together) {
    auto built = std::make_shared<const driver::Built>(std::move(next));
    if (!built->program) {
        controller::OnlineChangeReport refused;
        refused.refusal = built->failure.isEmpty() ? errors::ProgramHasErrors() : built->failure;
        if (done) done(refused);
        return;
    }
    if (m->outlet) {
        Order order{.kind = OrderKind::ChangeProgram,
                    .values = std::move(together.values),
                    .origin = std::move(together.origin),
                    .built = std::move(built),
                    .done = std::move(done)};
        if (breakpoints) order.breakpoints = std::move(*breakpoints);
        return m->outlet->post(std::move(order));
    }
    m->post(When::Boundary, [s = m.get(), built = std::move(built), done = std::move(done),
                             breakpoints = std::move(breakpoints), together = std::move(together)] {
        const driver::Built* before = s->current.load();
        s->adopt(built); // before the controller tells its observers
        const controller::OnlineChangeReport report = s->controller.changeProgram(built->program);
        if (!report.refusal.isEmpty()) {
            s->current.store(before);
            s->newRefusals.push_back({report.refusal, {}});
        } else {
            if (breakpoints) s->breakpoints = *breakpoints;
            if (s->debugger && breakpoints)
                s->debugger->setBreakpoints(s->breakpoints);
            else if (s->debugger)
                s->debugger->programChanged();
            s->writeNow(together);
            s->optimise(built);
        }
        s->needsAnchor = true;
        s->publish();
        if (done) done(report);
    });
}

Result<void> Session::resumeFrom(history::Position position) {
    if (m->outlet) return m->outlet->whyNotBack();
    std::shared_ptr<const image::CompiledProgram> program;
    const std::optional<history::ScanStamp> stamp = m->history.stamp(position);
    std::vector<std::byte> image = m->history.seek(position, &program);
    if (image.empty() || !stamp || !program) return Error{errors::ScanNotRecorded(), {}};
    std::shared_ptr<const driver::Built> built = m->versions->of(program.get());
    if (!built) return Error{errors::RecordedProgramGone(), {}};
    auto finished = std::make_shared<std::promise<void>>();
    std::future<void> wait = finished->get_future();
    m->post(When::Leave, [s = m.get(), program, image = std::move(image), at = *stamp, built, finished] {
        if (s->settings.record) s->history.beginBranch(at.position);
        s->adopt(built);
        s->controller.resumeFrom(program, image, at.scan, at.time);
        if (s->debugger) s->debugger->programChanged();
        s->scans.store(at.scan + 1);
        s->time.store(at.time.count());
        s->needsAnchor = true;
        s->publish();
        finished->set_value();
    });
    wait.wait();
    return {};
}

// ---------------------------------------------------------------- debugging

void Session::setBreakpoints(std::vector<Breakpoint> breakpoints) {
    if (m->outlet) return m->outlet->post({.kind = OrderKind::SetBreakpoints, .breakpoints = std::move(breakpoints)});
    m->post(When::Now, [s = m.get(), wanted = std::move(breakpoints)]() mutable {
        s->breakpoints = wanted; // kept for the debugger that startThread makes
        if (s->debugger) s->debugger->setBreakpoints(std::move(wanted));
    });
}

void Session::resume() {
    if (m->sendsElsewhere({OrderKind::Resume})) return;
    m->post(When::Now, [s = m.get()] {
        if (!s->isHalted) return;
        s->debugger->resume();
        s->goesOn = true;
    });
}

void Session::step(Step kind) {
    if (m->outlet) return m->outlet->post({.kind = OrderKind::Step, .step = kind});
    m->post(When::Now, [s = m.get(), kind] {
        if (!s->debugger) return;
        s->debugger->step(kind);
        if (s->isHalted)
            s->goesOn = true;
        else
            s->controller.start();
    });
}

void Session::runTo(FileId file, uint32_t line) {
    if (m->outlet) return m->outlet->post({.kind = OrderKind::RunTo, .file = file, .line = line});
    m->post(When::Now, [s = m.get(), file, line] {
        if (!s->debugger) return;
        s->debugger->runTo(file, line);
        if (s->isHalted)
            s->goesOn = true;
        else
            s->controller.start();
    });
}

std::vector<FaultFrame> Session::haltFrames() const {
    const std::lock_guard lock(m->mutex);
    return m->shared.frames;
}

Message Session::haltProblem() const {
    const std::lock_guard lock(m->mutex);
    return m->shared.haltProblem;
}

std::vector<std::pair<std::string, types::Value>> Session::frameVariables(size_t frame) const {
    std::vector<std::pair<std::string, types::Value>> variables;
    const auto read = [&](const image::CompiledProgram& program, std::span<const std::byte> image,
                          const controller::FaultFrame& wanted) {
        for (debug::FrameVariable& variable : debug::frameVariables(program, image, wanted))
            variables.emplace_back(std::move(variable.name), std::move(variable.value));
    };
    controller::FaultFrame wanted;
    std::shared_ptr<const State::FaultImage> fault;
    {
        const std::lock_guard lock(m->mutex);
        const Session::State::Shared& shared = m->shared;
        if (shared.frames.empty() && shared.fault) fault = shared.faultImage;
        const std::vector<controller::FaultFrame>& frames = fault ? shared.fault->calls : shared.frames;
        if (frame >= frames.size()) return {};
        wanted = frames[frame];
    }
    if (fault) {
        read(*fault->program, fault->image, wanted);
        return variables;
    }
    Snapshot now;
    latest(now);
    if (now.isHalted && now.program) read(*now.program, now.image, wanted);
    return variables;
}

} // namespace plc::session
