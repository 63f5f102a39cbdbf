// TwinCAT's files (.TcPOU .TcDUT .TcGVL .TcIO .TcTTO, .plcproj) into the texts of a project. Functions, any thread.
#pragma once
#include "projects/exchange/base/imported.h"
#include "projects/exchange/base/tasks.h"
#include "projects/exchange/base/xml.h"

namespace plc::exchange {

[[nodiscard]] bool isTwinCat(const XmlFile& file);
void importTwinCat(const XmlFile& file, const std::string& folder, Imported& imported, ForeignTasks& tasks);

[[nodiscard]] bool isTwinCatProject(const XmlFile& file);
/// Name and libraries.
void readTwinCatProject(const XmlFile& file, Imported& imported);

} // namespace plc::exchange
