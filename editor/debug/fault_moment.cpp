#include "editor/debug/fault_moment.h"

#include "editor/debug/fault_scan.h"

namespace plc::editor {

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
    if (const std::optional<history::Position> at = m_control.faultScan().position()) m_control.view(at);
}

} // namespace plc::editor
