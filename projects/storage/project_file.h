// Projects on disk: open a folder, or loose ST files; atomic save (temporary file, fsync, rename). Loading and saving
// our own file changes no byte. Functions, any thread.
#pragma once
#include "projects/model/project.h"
#include "projects/storage/text_encoding.h"
#include "runtime/base/result.h"

namespace plc::projects {

/// `paths`: one folder with project.json, or any number of ST files (libraries then come from the command line).
[[nodiscard]] Result<Project> openProject(const std::vector<std::string>& paths);
/// The texts of panels, alarms, operator texts and traces as they are on disk now (Project::companions).
[[nodiscard]] std::vector<std::string> readCompanions(const std::string& folder);
[[nodiscard]] Result<std::string> readFile(const std::string& path);
/// A source as UTF-8, whatever it is written in; of code pages the one that "encoding" in project.json names.
[[nodiscard]] Result<DecodedText> readSourceText(const std::string& path);
/// Writes a source in the encoding that the file has now (UTF-8 for a new one), or in `wanted`.
Result<void> writeSourceText(const std::string& path, std::string_view utf8, std::optional<Encoding> wanted = {});
/// All or nothing: the old file or the new one, never a mixture, whatever happens in between. A file with equal content
/// is not written.
Result<void> writeFileAtomically(const std::string& path, std::string_view content);
/// A file that does not exist yet, without waiting for the disk: for many at once whose origin is still there.
Result<void> writeNewFile(const std::string& path, std::string_view content);
/// What `project.json` says into the fields of the project; an error, with `file` as its place, leaves some of them
/// unread.
Result<void> readSettings(Project& project, const std::string& file);
Result<void> saveProjectFile(const Project& project);
/// project.json of a folder as it is on disk; an empty object when there is none.
[[nodiscard]] Result<nlohmann::ordered_json> readProjectJson(const std::string& folder);
/// What `after` says otherwise than `before` goes into `target`; what else `target` says stays.
void carryChanges(const nlohmann::ordered_json& before, const nlohmann::ordered_json& after,
                  nlohmann::ordered_json& target);

} // namespace plc::projects
