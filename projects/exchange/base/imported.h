// What an import makes of files of another tool: the texts of a project, what has no home in them, and the report. A
// value; any thread.
#pragma once
#include "projects/exchange/base/report.h"
#include "runtime/image/address.h"
#include "runtime/types/string_code.h"

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
    types::StringCode strings = types::StringCode::Latin1;          // what its STRING constants need
    nlohmann::ordered_json side = nlohmann::ordered_json::object(); // exchange.json, by unit and id
    Report report;
};

/// Of a body, as hexadecimal: one that is the same as when it was imported goes out as the diagram it came from.
[[nodiscard]] std::string hashOf(const std::string& text);
/// Adds `text` as src/FOLDER/NAME.st; a second unit of that name gets a number.
void addFile(Imported& imported, const std::string& folder, const std::string& name, std::string text);
/// A name as a file's: characters that a file name cannot have become _.
[[nodiscard]] std::string fileNameOf(const std::string& name);

} // namespace plc::exchange
