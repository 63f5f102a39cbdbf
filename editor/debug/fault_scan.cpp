#include "editor/debug/fault_scan.h"

#include "editor/debug/run_control.h"
#include "runtime/debug/frames.h"
#include "runtime/inside/rerun.h"

namespace plc::editor {

namespace {

/// A scan made again; none where it does not lead to the same fault.
std::optional<inside::Rerun> repeated(const session::Session& session, history::Position at,
                                      const controller::Fault& fault) {
    inside::Rerunner rerunner(session.history());
    auto made = rerunner.run(at);
    if (!made || !made->isExact() || !made->fault || made->fault->range != fault.range ||
        made->fault->calls.size() != fault.calls.size())
        return {};
    return std::move(*made);
}

} // namespace

struct FaultScan::Repeated {
    history::Position position = 0;
    controller::Nanoseconds time{}; // of the fault: a position is used again after a reset
    std::optional<inside::Rerun> rerun;
};

FaultScan::FaultScan(RunControl& control) : m_control(control) {
    // What is kept holds a program: it ends with the session, not with the next question.
    connect(&control, &RunControl::sessionAboutToEnd, this, &FaultScan::forget);
    connect(&control, &RunControl::sessionChanged, this, &FaultScan::forget);
}

FaultScan::~FaultScan() = default;

void FaultScan::forget() {
    m_last.reset();
    m_repeated.reset();
}

std::optional<history::Position> FaultScan::position() {
    const session::Session* session = m_control.session();
    const std::optional<controller::Fault>& fault = m_control.status().fault;
    if (!session || !fault || m_control.status().state != controller::State::Fault) return {};
    const auto scanAt = [&](history::Position at) {
        const std::optional<history::ScanStamp> stamp = session->history().stamp(at);
        return stamp ? std::optional(stamp->scan) : std::nullopt;
    };
    if (m_last && scanAt(*m_last) == fault->scan) return m_last;
    m_last.reset();
    const history::Statistics all = session->history().statistics();
    for (history::Position at = all.end; at-- > all.first;) {
        const std::optional<uint64_t> scan = scanAt(at);
        if (!scan || *scan < fault->scan) break;
        if (*scan != fault->scan) continue; // only the plant has run since
        m_last = at;
        break;
    }
    return m_last;
}

bool FaultScan::isShown() {
    return m_control.viewed() && !m_control.showsRecorded() && m_control.viewed() == position();
}

std::vector<std::pair<std::string, types::Value>> FaultScan::variables(size_t frame) {
    if (!m_control.session()) return {};
    const session::Session& session = *m_control.session();
    const std::optional<history::Position> at = position();
    if (!at) return session.frameVariables(frame);
    const controller::Fault& fault = *m_control.status().fault;
    if (!m_repeated || m_repeated->position != *at || m_repeated->time != fault.time)
        m_repeated = std::make_unique<Repeated>(Repeated{*at, fault.time, repeated(session, *at, fault)});
    if (!m_repeated->rerun) return session.frameVariables(frame);
    const inside::Rerun& scan = *m_repeated->rerun;
    std::vector<std::pair<std::string, types::Value>> out;
    if (frame < scan.fault->calls.size())
        for (debug::FrameVariable& each :
             debug::frameVariables(*scan.input.program, scan.image, scan.fault->calls[frame]))
            out.emplace_back(std::move(each.name), std::move(each.value));
    return out;
}

} // namespace plc::editor
