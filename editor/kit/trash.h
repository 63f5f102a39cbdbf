// What the user deletes goes to where the desktop keeps deleted files, so that it can be had back. GUI thread.
#pragma once

#include <QString>

namespace plc::kit {

/// Moves a file to the trash, or removes it where there is none. False: the file is still there.
[[nodiscard]] bool removeToTrash(const QString& path);

} // namespace plc::kit
