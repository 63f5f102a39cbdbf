// A diagram of a unit whose declaration is text (TwinCAT, CODESYS 2.3): its statements, the variables they need in the
// declaration, and the diagram itself for the way back. Functions, any thread.
#pragma once
#include "projects/exchange/base/assemble.h"
#include "projects/exchange/base/imported.h"
#include "projects/exchange/graphs/chart_import.h"
#include "projects/exchange/graphs/diagram.h"

namespace plc::exchange {

/// The variables of a declaration and their types, as written.
[[nodiscard]] std::map<std::string, std::string> variableTypesIn(std::string_view declaration);
/// Variables with their types, as a section of `owner`.
void declareIn(Piece& owner, const std::vector<std::pair<std::string, std::string>>& variables);
/// `diagram` is an <LD>, <FBD> or <CFC> of PLCopen; `unit` is its path in exchange.json, `owner` takes the
/// declarations.
[[nodiscard]] std::string diagramText(pugi::xml_node diagram, const XmlFile& file, const std::string& unit,
                                      Piece& owner, Imported& out);
/// `chart` is an <SFC> of PLCopen; the actions that are written inside it become members of `owner`.
[[nodiscard]] std::string chartBody(pugi::xml_node chart, const XmlFile& file, const std::string& unit,
                                    const std::map<std::string, std::string>& transitions, Piece& owner, Imported& out);

} // namespace plc::exchange
