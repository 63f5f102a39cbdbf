#include "app/online/device_connections.h"

#include "projects/devices/configuration/errors.h"

namespace plc::app {

DeviceConnections& DeviceConnections::of(editor::RunControl& control, editor::Workspace& workspace) {
    auto* known = control.findChild<DeviceConnections*>(QString(), Qt::FindDirectChildrenOnly);
    if (!known) known = new DeviceConnections(control, workspace);
    known->follow();
    return *known;
}

DeviceConnections::DeviceConnections(editor::RunControl& control, editor::Workspace& workspace)
    : QObject(&control), m_control(control), m_workspace(workspace) {}

void DeviceConnections::follow() {
    m_control.disconnect(this);
    connect(&m_control, &editor::RunControl::sessionChanged, this, &DeviceConnections::attach);
    connect(&m_control, &editor::RunControl::sessionAboutToEnd, this, &DeviceConnections::letGo);
}

std::vector<devices::Finding> DeviceConnections::findings(const devices::DeviceFile& file) const {
    const auto model = m_workspace.model();
    const bool hasLayout =
        model && !model->checked().analysis->hasErrors && model->checked().analysis->program != nullptr;
    return devices::checkDevices(file, hasLayout ? &model->checked().analysis->program->layout : nullptr,
                                 m_workspace.folder().toStdString());
}

/// A controller that does not run yet: the devices are described by the file as it is now.
void DeviceConnections::attach() {
    m_current = nullptr;
    m_refusal = devices::errors::NeedController();
    session::Session* session = m_control.session();
    if (!session) return emit changed();
    if (session->isMirror()) {
        m_refusal = devices::errors::ControllerElsewhere();
        return emit changed();
    }
    const std::string folder = m_workspace.folder().toStdString();
    const auto file = devices::DeviceFile::load(folder);
    if (!file)
        m_refusal = file.error().message;
    else if (file->devices().empty() && file->findings().empty())
        m_refusal = devices::errors::NoDevicesYet();
    else if (devices::hasErrors(devices::checkDevices(*file, &session->program()->layout, folder)))
        m_refusal = devices::errors::DevicesWrong();
    else
        m_current = m_all.emplace_back(std::make_unique<devices::Engine>(file->devices(), folder)).get();
    if (m_current) m_current->attach(session->controller());
    emit changed();
}

void DeviceConnections::letGo() {
    if (m_current) m_current->disconnect();
    m_current = nullptr;
    m_refusal = devices::errors::NeedController();
    emit changed();
}

Result<void> DeviceConnections::connectDevices() {
    if (!m_control.session()) return Error{devices::errors::NeedController(), {}};
    if (!m_current) return Error{m_refusal, {}};
    if (m_control.mode().pace != session::Pace::Real) return Error{devices::errors::NeedRealTime(), {}};
    m_current->connect();
    emit changed();
    return {};
}

void DeviceConnections::disconnectDevices() {
    if (m_current) m_current->disconnect();
    emit changed();
}

std::vector<devices::DeviceStatus> DeviceConnections::status() const {
    return m_current ? m_current->status() : std::vector<devices::DeviceStatus>();
}

} // namespace plc::app
