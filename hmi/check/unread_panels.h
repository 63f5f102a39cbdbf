// The panels of a project that are on disk, and those of them that could not be understood. Functions, any thread.
#pragma once
#include "hmi/view/scene/ready_faceplates.h"

#include <QStringList>

#include <vector>

namespace plc::hmi {

/// Names of the panel files of a project's folder, sorted.
QStringList panelsOnDisk(const QString& folder);
/// Those that are not among `panels`: their files have a finding of their own, and what they say and use is unknown.
QStringList unreadPanels(const QString& folder, const std::vector<NamedPanel>& panels);

} // namespace plc::hmi
