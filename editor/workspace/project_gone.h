// Whether the folder of an open project has been removed, moved or cannot be reached: then nothing that is open may be
// given up because its file is missing. A function, any thread.
#pragma once
#include "projects/model/project.h"

#include <QFile>
#include <QString>

namespace plc::editor {

[[nodiscard]] inline bool isProjectGone(const projects::Project& project) {
    if (project.json.empty()) return false; // a folder without a project file
    return !QFile::exists(QString::fromStdString(project.folder) + QStringLiteral("/project.json"));
}

} // namespace plc::editor
