// Import as a whole: finds what a path holds, reads it in memory, and writes the project that came of it. Nothing is
// written before writeProjects. Functions, any thread.
#pragma once
#include "projects/exchange/base/imported.h"
#include "projects/model/project.h"
#include "projects/storage/text_encoding.h"
#include "runtime/base/progress.h"
#include "runtime/base/result.h"

namespace plc::exchange {

/// What becomes of a folder with several projects of another tool.
enum class TreeDivision : uint8_t {
    IfNeeded, // one project, unless units of equal names would meet in it: then one for each, with what it uses
    Together
};
struct ImportOptions {
    TreeDivision division = TreeDivision::IfNeeded;
    std::optional<projects::Encoding> codePage; // of files that do not say theirs; nothing: it is guessed
    std::string only;                           // the project of that name and what it uses; empty: all
    Progress* progress = nullptr;
};

/// Reads a file, the folder of a .sln, .tsproj or .plcproj, or every file of a folder that an import knows; the reports
/// say which were left out. At least one.
[[nodiscard]] Result<std::vector<Imported>> importProjects(const std::string& path, const ImportOptions& options);
/// The same as one project, whatever meets in it.
[[nodiscard]] Result<Imported> importFrom(const std::string& path);
/// Loose files as one project; folders by themselves are not looked into.
[[nodiscard]] Result<Imported> importFiles(const std::vector<std::string>& paths);
/// A file that is read by importing it: of TwinCAT or CODESYS by its name, PLCopen XML by its content.
[[nodiscard]] bool isForeignFile(const std::string& path);
/// As a project in memory, without a folder.
[[nodiscard]] projects::Project toProject(const Imported& imported);
/// The folder of one of several projects that are written to `folder`: below it, or it itself when there is one.
[[nodiscard]] std::string folderOf(const std::vector<Imported>& projects, size_t index, const std::string& folder);
/// Writes all or nothing; the folder must not exist or must be empty.
Result<void> writeProjects(const std::vector<Imported>& projects, const std::string& folder, Progress* progress);
Result<void> writeImported(const Imported& imported, const std::string& folder);

} // namespace plc::exchange
