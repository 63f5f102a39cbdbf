// The devices of the running project in the studio: attached to each new controller, connected only when asked. A child
// of the RunControl, because the controllers that look at them, also those in its archive, must end first. GUI thread.
#pragma once
#include "editor/debug/run_control.h"
#include "editor/workspace/workspace.h"
#include "projects/devices/configuration/device_check.h"
#include "projects/devices/engine.h"

#include <QObject>

namespace plc::app {

class DeviceConnections : public QObject {
    Q_OBJECT
public:
    /// The one of this control; made when there is none. Hears of it again after the control's connections were cut.
    static DeviceConnections& of(editor::RunControl& control, editor::Workspace& workspace);

    /// What the file and the program say together, as they are now.
    [[nodiscard]] std::vector<devices::Finding> findings(const devices::DeviceFile& file) const;
    [[nodiscard]] bool isConnected() const { return m_current && m_current->isConnected(); }
    /// An error says why it cannot: no controller, no devices, errors in the file.
    Result<void> connectDevices();
    void disconnectDevices();
    [[nodiscard]] std::vector<devices::DeviceStatus> status() const;

signals:
    void changed();

private:
    DeviceConnections(editor::RunControl& control, editor::Workspace& workspace);
    void follow();
    void attach();
    void letGo();

    editor::RunControl& m_control;
    editor::Workspace& m_workspace;
    devices::Engine* m_current = nullptr;
    std::vector<std::unique_ptr<devices::Engine>> m_all; // of every controller there was: each still points to its own
    Message m_refusal;                                   // why there is none
};

} // namespace plc::app
