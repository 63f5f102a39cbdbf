// What an import makes of files of another tool: the texts of a project, what has no home in them, and the report. A
// value; nothing is written before writeImported.
#pragma once
#include "projects/exchange/report.h"
#include "projects/model/project.h"
#include "runtime/base/progress.h"
#include "runtime/base/result.h"
#include "runtime/image/address.h"

#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace plc::exchange {

struct ImportedFile {
    std::string path; // in the project: "src/Drives/Axis.st"
    std::string text;
    std::string name = {}; // of the unit in its own tool
};

struct Imported {
    std::string name;
    std::vector<ImportedFile> files;
    std::set<std::string> libraries;                                // of ours
    std::set<std::string> namespaces;                               // of the imported projects themselves
    std::set<std::string> projectNames;                             // theirs, folded
    std::map<std::string, std::string> aliases;                     // namespace that a reference gives → its library
    std::set<std::string> coveredNamespaces = {"Tc2_System"};       // of foreign libraries whose names are here, too
    uint32_t memoryForNew = 0;                                      // bytes, for programs that use __NEW
    image::Addressing addressing = image::Addressing::Bytes;        // what %MW1 counts in the tool it comes from
    nlohmann::ordered_json side = nlohmann::ordered_json::object(); // exchange.json, by unit and id
    Report report;
};

/// Of a body, as hexadecimal: one that is the same as when it was imported goes out as the diagram it came from.
[[nodiscard]] std::string hashOf(const std::string& text);
/// Adds `text` as src/FOLDER/NAME.st; a second unit of that name gets a number.
void addFile(Imported& imported, const std::string& folder, const std::string& name, std::string text);
/// A name as a file's: characters that a file name cannot have become _.
[[nodiscard]] std::string fileNameOf(const std::string& name);

/// What becomes of a folder with several projects of another tool.
enum class TreeDivision : uint8_t {
    IfNeeded, // one project, unless units of equal names would meet in it: then one for each, with what it uses
    Together
};
struct ImportOptions {
    TreeDivision division = TreeDivision::IfNeeded;
    std::string only; // the project of that name and what it uses; empty: all
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
/// XML of TwinCAT or PLCopen, by the first bytes: no source of ours.
[[nodiscard]] bool looksLikeXml(std::string_view bytes);

} // namespace plc::exchange
