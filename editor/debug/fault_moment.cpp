#include "editor/debug/fault_moment.h"

#include "runtime/debug/frames.h"
#include "runtime/inside/rerun.h"

namespace plc::editor {

std::optional<history::Position> faultPosition(const RunControl& control) {
    // Asked at every refresh, while the plant may go on for hours: found once.
    static std::pair<const session::Session*, history::Position> last;
    const session::Session* session = control.session();
    const std::optional<controller::Fault>& fault = control.status().fault;
    if (!session || !fault || control.status().state != controller::State::Fault) {
        last = {};
        return {};
    }
    const auto scanAt = [&](history::Position at) {
        const std::optional<history::ScanStamp> stamp = session->history().stamp(at);
        return stamp ? std::optional(stamp->scan) : std::nullopt;
    };
    if (last.first == session && scanAt(last.second) == fault->scan) return last.second;
    const history::Statistics all = session->history().statistics();
    for (history::Position at = all.end; at-- > all.first;) {
        const std::optional<uint64_t> scan = scanAt(at);
        if (!scan || *scan < fault->scan) return {};
        if (*scan != fault->scan) continue; // only the plant has run since
        last = {session, at};
        return at;
    }
    return {};
}

bool showsFault(const RunControl& control) {
    return control.viewed() && !control.showsRecorded() && control.viewed() == faultPosition(control);
}

namespace {

/// The scan of a fault, made again: the last that was asked for. GUI thread.
struct FaultyScan {
    const session::Session* of = nullptr;
    history::Position position = 0;
    controller::Nanoseconds time{};
    std::optional<inside::Rerun> rerun;

    bool isThat(const session::Session& session, history::Position at, const controller::Fault& fault) const {
        return of == &session && position == at && time == fault.time;
    }
    void make(const session::Session& session, history::Position at, const controller::Fault& fault) {
        of = &session, position = at, time = fault.time;
        rerun.reset();
        inside::Rerunner rerunner(session.history());
        if (auto made = rerunner.run(at)) rerun = std::move(*made);
        const bool isSame = rerun && rerun->isExact() && rerun->fault && rerun->fault->range == fault.range &&
                            rerun->fault->calls.size() == fault.calls.size();
        if (!isSame) rerun.reset();
    }
};

} // namespace

std::vector<std::pair<std::string, types::Value>> faultVariables(const RunControl& control, size_t frame) {
    static FaultyScan last;
    if (!control.session()) return {};
    const std::optional<history::Position> at = faultPosition(control);
    if (!at) return control.session()->frameVariables(frame);
    const session::Session& session = *control.session();
    const controller::Fault& fault = *control.status().fault;
    if (!last.isThat(session, *at, fault)) last.make(session, *at, fault);
    if (!last.rerun) return session.frameVariables(frame);
    std::vector<std::pair<std::string, types::Value>> out;
    if (frame < last.rerun->fault->calls.size())
        for (debug::FrameVariable& each :
             debug::frameVariables(*last.rerun->input.program, last.rerun->image, last.rerun->fault->calls[frame]))
            out.emplace_back(std::move(each.name), std::move(each.value));
    return out;
}

FaultMoment::FaultMoment(RunControl& control, QObject* parent) : QObject(parent), m_control(control) {
    m_isSeen = control.status().state == controller::State::Fault; // by the window before this one
    connect(&control, &RunControl::statusChanged, this, &FaultMoment::look);
    connect(&control, &RunControl::sessionChanged, this, [this] { m_isSeen = false; });
}

void FaultMoment::look() {
    if (m_control.status().state != controller::State::Fault) {
        m_isSeen = false;
        return;
    }
    if (std::exchange(m_isSeen, true) || m_control.viewed() || m_control.showsRecorded()) return;
    if (const std::optional<history::Position> at = faultPosition(m_control)) m_control.view(at);
}

} // namespace plc::editor
