#include "projects/exchange/base/beremiz_extension.h"

#include "runtime/base/text.h"

namespace plc::exchange {

bool isBeremizExtension(const XmlFile& file) { return is(file.root(), "CFile") || is(file.root(), "PyFile"); }

// A declaration for each, in one list for all extensions: a program names them with VAR_EXTERNAL.
void readBeremizExtension(const XmlFile& file, Imported& imported) {
    static constexpr std::string_view kList = "Extensions";
    std::string variables;
    for (const pugi::xml_node each : childOf(file.root(), "variables").children()) {
        const std::string name = attribute(each, "name"), type = attribute(each, "type");
        if (name.empty() || type.empty()) continue;
        const std::string initial = attribute(each, "initial"), comment = attribute(each, "desc");
        variables += "    " + name + " : " + type + (initial.empty() ? "" : " := " + initial) + ";" +
                     (comment.empty() ? "" : " // " + comment) + "\n";
    }
    if (variables.empty()) return imported.report.add(file.place(), remarks::ElementNotRead(localName(file.root())));
    const std::string section = "VAR_GLOBAL\n" + variables + "END_VAR\n";
    ++imported.report.units["VAR_GLOBAL"];
    addFile(imported, "", std::string(kList), section);
    imported.report.add(file.place(), remarks::ExtensionVariables(imported.files.back().path));
}

} // namespace plc::exchange
