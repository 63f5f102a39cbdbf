// <interface> of a POU and the vendors' additions to it as the text of a declaration; the plain text that CODESYS puts
// beside it wins. Pure functions, any thread.
#pragma once
#include "projects/exchange/base/assemble.h"
#include "projects/exchange/base/xml.h"

namespace plc::exchange {

/// The declaration of a POU, method, property, interface: header and sections.
[[nodiscard]] std::string declarationOf(pugi::xml_node element, PieceKind kind, const std::string& name);
/// The plain text that stands beside the element's <interface>, or "".
[[nodiscard]] std::string plainInterface(pugi::xml_node element);
/// VAR_GLOBAL … END_VAR of one <globalVars>, plain text first.
[[nodiscard]] std::string globalsText(pugi::xml_node globalVars, const std::string& indent = {});
/// One section of an <interface>; empty for what is no section.
[[nodiscard]] std::string sectionText(pugi::xml_node section, const std::string& indent);

} // namespace plc::exchange
