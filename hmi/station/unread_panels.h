// The panels of a project that are on disk but could not be understood. A function, main thread.
#pragma once
#include <QStringList>

namespace plc::hmi {

struct PanelProject;

/// Names; each has a problem of its own in the project.
QStringList unreadPanels(const PanelProject& project);

} // namespace plc::hmi
