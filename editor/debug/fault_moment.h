// The scan in which the controller has faulted. A plant goes on after a fault and outputs become safe, so the newest
// scan is a later one: the window is taken to the scan of the fault once, so that place, call stack and values are of
// one moment. Back to Live leads on. Owned by the main window; GUI thread.
#pragma once
#include "editor/debug/run_control.h"

namespace plc::editor {

/// Where the scan of the present fault is in the recording; none without a fault, or where it was not recorded.
[[nodiscard]] std::optional<history::Position> faultPosition(const RunControl& control);
/// The scan that is looked at is that of the present fault.
[[nodiscard]] bool showsFault(const RunControl& control);

/// Name and value of the variables of a frame of the present fault. Optimised code keeps locals in registers, so the
/// scan is made again by the quick code; where that does not lead to the same fault, what the session has kept.
[[nodiscard]] std::vector<std::pair<std::string, types::Value>> faultVariables(const RunControl& control, size_t frame);

class FaultMoment : public QObject {
    Q_OBJECT
public:
    explicit FaultMoment(RunControl& control, QObject* parent = nullptr);

private:
    void look();

    RunControl& m_control;
    bool m_isSeen = false; // the present fault
};

} // namespace plc::editor
