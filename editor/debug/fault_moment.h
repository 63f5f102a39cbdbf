// Takes the window to the scan in which the controller has faulted. A plant goes on after a fault and outputs become
// safe, so the newest scan is a later one: the window is taken back once, so that place, call stack and values are of
// one moment. Back to Live leads on. Owned by the main window; GUI thread.
#pragma once
#include "editor/debug/run_control.h"

namespace plc::editor {

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
