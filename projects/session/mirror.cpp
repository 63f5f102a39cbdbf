#include "projects/session/mirror.h"

#include "projects/session/session_state.h"
#include "runtime/base/assert.h"

namespace plc::session {

using PlcState = controller::State;

namespace {
constexpr size_t kEventsMirrored = 10'000;
}

bool Session::State::sendsElsewhere(Order order) {
    if (!outlet) return false;
    outlet->post(std::move(order));
    return true;
}

bool Session::isMirror() const { return m->outlet != nullptr; }

std::unique_ptr<Session> Mirror::open(driver::Built built, Settings settings, std::shared_ptr<Outlet> outlet) {
    PLC_ASSERT(outlet, return nullptr);
    settings.retainFile.clear(); // what is retained is kept there
    auto session = std::make_unique<Session>(std::move(built), std::move(settings));
    Session::State& state = *session->m;
    state.outlet = std::move(outlet);
    if (state.settings.record) state.history.beginProgram(session->program());
    state.isQueueing.store(true, std::memory_order_release); // readers see what was published
    return session;
}

void Mirror::scanned(std::span<const std::byte> image, uint64_t scan, Nanoseconds time, const image::Outside* outside) {
    Session::State& state = *m.m;
    const image::Layout& layout = m.program()->layout;
    PLC_ASSERT(image.size() >= layout.dataEnd, return );
    const bool beganAgain = scan < state.scans.load(std::memory_order_relaxed); // it was reset or restarted
    if (state.settings.record && beganAgain) state.history.beginBranch(history::kNoParent);
    if (state.settings.record && outside) state.history.outsideActed(*outside);
    if (state.settings.record) state.history.append(image, scan, time);
    state.scans.store(scan + 1, std::memory_order_relaxed);
    state.time.store(time.count(), std::memory_order_relaxed);
    show(image, false);
}

void Mirror::show(std::span<const std::byte> image, bool isHalted) {
    Session::State& state = *m.m;
    Snapshot* next = state.published.begin();
    if (!next) return; // readers hold every spare one; the next scan comes soon
    next->program = m.program();
    next->image.assign(next->program->layout.imageSize, std::byte(0));
    std::copy_n(image.begin(), std::min(image.size(), next->image.size()), next->image.begin());
    const uint64_t scans = state.scans.load(std::memory_order_relaxed);
    next->scan = scans > 0 ? scans - 1 : 0;
    next->time = Nanoseconds(state.time.load(std::memory_order_relaxed));
    const history::Statistics recorded = state.history.statistics();
    next->position = recorded.end > 0 ? recorded.end - 1 : 0;
    next->isHalted = isHalted;
    state.published.publish();
}

void Mirror::told(Figures figures) {
    Session::State& state = *m.m;
    const std::lock_guard lock(state.mutex);
    const Status& status = figures.status;
    if (state.history.statistics().end == 0) { // else those that were shown count
        state.scans.store(status.scans, std::memory_order_relaxed);
        state.time.store(status.time.count(), std::memory_order_relaxed);
    }
    state.lastScanNs.store(status.lastScanNs, std::memory_order_relaxed);
    state.load.store(status.load, std::memory_order_relaxed);
    state.skipped.store(status.skippedScans, std::memory_order_relaxed);
    state.shared.fault = status.fault;
    state.shared.simulationFault = status.simulationFault;
    state.shared.retainProblem = status.retainProblem;
    state.shared.forces = std::move(figures.forces);
    state.shared.tasks = std::move(figures.tasks);
    state.shared.frames = std::move(figures.frames);
    state.shared.haltProblem = std::move(figures.haltProblem);
    state.state.store(status.state, std::memory_order_relaxed);
    state.halts.store(status.halts, std::memory_order_release);
}

void Mirror::happened(controller::Event event) {
    Session::State& state = *m.m;
    if (state.settings.record) state.history.mark(static_cast<int>(event.kind), event.text, event.time);
    const std::lock_guard lock(state.mutex);
    state.shared.events.push_back(std::move(event));
    for (; state.shared.events.size() > kEventsMirrored; ++state.shared.firstEvent) state.shared.events.pop_front();
}

void Mirror::refused(Error why) {
    const std::lock_guard lock(m.m->mutex);
    m.m->shared.refusals.push_back(std::move(why));
}

void Mirror::programChanged(driver::Built built) {
    PLC_ASSERT(built.program, return );
    m.m->adopt(std::make_shared<const driver::Built>(std::move(built)));
    if (m.m->settings.record) m.m->history.beginProgram(m.program());
}

} // namespace plc::session
