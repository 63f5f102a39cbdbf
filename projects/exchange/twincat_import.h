// TwinCAT's files (.TcPOU .TcDUT .TcGVL .TcIO .TcTTO, .plcproj) and the native export of CODESYS V3 into the texts of a
// project. Functions, any thread.
#pragma once
#include "projects/exchange/imported.h"
#include "projects/exchange/xml.h"

namespace plc::exchange {

/// A TASK of a file of its own; the configuration is written when all files are read.
struct TwinCatTask {
    std::string name, interval, priority;
    std::vector<std::string> programs;
};
struct TwinCatProject {
    std::vector<TwinCatTask> tasks;
};

[[nodiscard]] bool isTwinCat(const XmlFile& file);
void importTwinCat(const XmlFile& file, const std::string& folder, Imported& imported, TwinCatProject& project);
/// CONFIGURATION with the tasks that the files name; nothing without tasks.
void addConfiguration(const TwinCatProject& project, Imported& imported);

[[nodiscard]] bool isTwinCatProject(const XmlFile& file);
/// Name and libraries.
void readTwinCatProject(const XmlFile& file, Imported& imported);

[[nodiscard]] bool isCodesysExport(const XmlFile& file);
void importCodesysExport(const XmlFile& file, Imported& imported);

} // namespace plc::exchange
