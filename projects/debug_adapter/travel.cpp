// The way through the recording: out of the live scan, back and forward over scans, into the live scan again.
#include "projects/debug_adapter/debuggee.h"

#include "projects/protocol/errors.h"

#include <algorithm>
#include <thread>

namespace plc::dap {

namespace errors = protocol::errors;
using debug::Step;
using std::chrono::milliseconds;
using PlcState = controller::State;

namespace {
constexpr milliseconds kSlice{20}; // between looks for a pause
}

Result<void> Debuggee::show(history::Position position) {
    auto look = m_insight->look(position);
    if (!look) return look.error();
    m_scan = std::make_unique<inside::SlowScan>(*look);
    takeLines();
    return {};
}

void Debuggee::takeLines() {
    if (!m_scan) return;
    std::vector<inside::SlowScan::LineOf> lines;
    for (const debug::Breakpoint& each : m_breakpoints)
        if (each.isEnabled) lines.push_back({each.file, each.line});
    m_scan->setBreakpoints(std::move(lines));
}

std::optional<history::Position> Debuggee::before(history::Position position) const {
    const std::vector<history::PositionRange> chain = history::chainTo(history().branches(), position + 1);
    for (auto range = chain.rbegin(); range != chain.rend(); ++range)
        if (range->begin < position) {
            const history::Position found = std::min(range->end, position) - 1;
            if (found < history().statistics().first) return std::nullopt;
            return found;
        }
    return std::nullopt;
}

std::optional<history::Position> Debuggee::behind(history::Position position) const {
    const history::Position end = history().statistics().end;
    for (const history::PositionRange& range : history::chainTo(history().branches(), end))
        if (position + 1 < range.end) return std::max(range.begin, position + 1);
    return std::nullopt;
}

bool Debuggee::turnTo(std::optional<history::Position> position, bool isBack) {
    while (position) {
        if (!show(*position)) return false;
        if (m_scan->stops() > 0) {
            m_scan->goTo(isBack ? m_scan->stops() : 0);
            return true;
        }
        position = isBack ? before(*position) : behind(*position);
    }
    return false;
}

/// Among the statements of the finished scan the one before which it stood.
bool Debuggee::standAt(const controller::FaultFrame& frame, std::span<const std::byte> image) {
    constexpr size_t kMost = 5000; // of a statement in a long loop
    const size_t begin = sizeof(image::ImageHeader), end = program().layout.dataEnd;
    std::optional<size_t> first;
    size_t tried = 0;
    for (size_t stop = 0; stop < m_scan->stops() && tried < kMost; ++stop) {
        m_scan->goTo(stop);
        if (!(m_scan->range() == frame.range)) continue;
        const auto frames = m_scan->stackTrace(); // a function has no instance of its own
        if (frames.empty()) continue;
        const std::string& instance = frames.front().instance;
        if (!instance.empty() && !frame.instance.empty() && instance != frame.instance) continue;
        ++tried;
        if (!first) first = stop;
        const std::span<const std::byte> now = m_scan->image();
        if (now.size() >= end && image.size() >= end &&
            std::equal(now.begin() + begin, now.begin() + static_cast<std::ptrdiff_t>(end), image.begin() + begin))
            return true;
    }
    if (first) m_scan->goTo(*first);
    return first.has_value();
}

/// The scan that stands is finished first: only then is it recorded.
Result<void> Debuggee::enterPast() {
    if (m_session->status().state == PlcState::Stopped) return Error{errors::BeginOfRecording(), {}}; // not begun yet
    const std::vector<controller::FaultFrame> frames = m_session->haltFrames();
    const session::Snapshot halted = snapshot();
    const history::Position position = history().statistics().end;
    m_session->setBreakpoints({});
    m_session->pause();
    m_session->resume();
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    for (PlcState state = m_session->status().state; state != PlcState::Paused && state != PlcState::Fault;
         state = m_session->status().state) {
        if (std::chrono::steady_clock::now() > end) return Error{errors::ScanGoesOn(), {}};
        std::this_thread::sleep_for(milliseconds(1));
    }
    m_session->setBreakpoints(m_breakpoints);
    m_snapshot.reset();
    if (auto shown = show(position); !shown) return shown.error();
    if (frames.empty() || !standAt(frames.front(), halted.image)) m_scan->goTo(0);
    return {};
}

void Debuggee::leavePast(Stop::Why why) {
    if (!m_session || m_session->status().state == PlcState::Fault) { // there is nothing behind
        if (m_scan->stops() > 0) m_scan->goTo(m_scan->stops() - 1);
        m_motion = Motion::Forward;
        const auto failed = fault();
        m_stop =
            Stop{failed ? Stop::Why::Fault : Stop::Why::Begin, failed ? failed->message : errors::EndOfRecording()};
        return;
    }
    m_scan.reset();
    live(why);
    if (why == Stop::Why::Step)
        m_session->step(Step::In);
    else
        m_session->start();
}

// ---------------------------------------------------------------- back

void Debuggee::stepBack() {
    m_isPauseAsked = false;
    if (!m_scan)
        if (auto past = enterPast(); !past) {
            m_motion = Motion::Back;
            m_stop = Stop{Stop::Why::Begin, past.error().message};
            return;
        }
    bool moved = m_scan->stepBack(Step::Over);
    if (!moved) {
        const history::Position here = m_scan->look().position();
        moved = turnTo(before(here), true) && m_scan->stepBack(Step::Over);
        if (!moved) (void)turnTo(here, false);
    }
    m_motion = Motion::Back;
    m_stop = moved ? Stop{Stop::Why::Step, {}} : Stop{Stop::Why::Begin, errors::BeginOfRecording()};
}

void Debuggee::reverseContinue() {
    m_isPauseAsked = false;
    m_motion = Motion::Back;
    if (m_scan) return;
    if (auto past = enterPast(); !past) m_stop = Stop{Stop::Why::Begin, past.error().message};
}

bool Debuggee::isAtBreakpoint() {
    if (m_scan->isAtEnd()) return false;
    const SourceRange range = m_scan->range();
    const uint32_t line = program().sources[range.file].lineColumn(range.begin).line;
    const std::vector<inside::SlowScan::Frame> frames = m_scan->stackTrace();
    return std::any_of(m_breakpoints.begin(), m_breakpoints.end(), [&](const debug::Breakpoint& each) {
        if (!each.isEnabled || each.file != range.file || each.line != line) return false;
        if (each.condition.empty()) return true;
        const auto value = m_scan->evaluate(each.condition, frames.empty() ? inside::kNone : frames.front().id);
        return !value || value->isTrue(); // as live: one that cannot be evaluated halts
    });
}

std::optional<Stop> Debuggee::pollBack() {
    for (const auto end = std::chrono::steady_clock::now() + kSlice; std::chrono::steady_clock::now() < end;) {
        if (m_isPauseAsked) return stand(Stop::Why::Pause);
        if (m_scan->reverseContinue()) {
            if (isAtBreakpoint()) return stand(Stop::Why::Breakpoint);
            continue;
        }
        const history::Position here = m_scan->look().position();
        if (turnTo(before(here), true)) continue;
        (void)turnTo(here, false);
        return stand(Stop::Why::Begin, errors::BeginOfRecording());
    }
    return std::nullopt;
}

// ---------------------------------------------------------------- forward

std::optional<Stop> Debuggee::pollForward() {
    for (const auto end = std::chrono::steady_clock::now() + kSlice; std::chrono::steady_clock::now() < end;) {
        if (m_isPauseAsked) return stand(Stop::Why::Pause);
        if (m_scan->goOn() && !m_scan->isAtEnd()) {
            if (isAtBreakpoint()) return stand(Stop::Why::Breakpoint);
            continue;
        }
        if (!turnTo(behind(m_scan->look().position()), false)) {
            leavePast(Stop::Why::Breakpoint);
            return std::nullopt;
        }
        if (isAtBreakpoint()) return stand(Stop::Why::Breakpoint);
    }
    return std::nullopt;
}

} // namespace plc::dap
