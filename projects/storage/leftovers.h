// Files that a saving left behind when it was killed: written aside, never put in place. Any thread; the folder's files
// are only touched when no process is writing them.
#pragma once
#include <string>

namespace plc::projects {

/// The name a file is written under until it is complete.
[[nodiscard]] std::string nameWhileSaving(const std::string& path);
/// Removes the leftovers of processes that are gone, from a project's folder and the folders of its parts.
void removeLeftovers(const std::string& folder);

} // namespace plc::projects
