// Types and initial values of PLCopen XML as text of declarations. Pure functions, any thread.
#pragma once
#include "projects/exchange/base/assemble.h"
#include "projects/exchange/base/xml.h"

namespace plc::exchange {

/// The text of what a <type>, <baseType> or <returnType> holds: "ARRAY [0..9] OF INT". `indent` is that of the
/// declaration, for structures over several lines.
[[nodiscard]] std::string typeText(pugi::xml_node holder, const std::string& indent = {});
/// The text of an <initialValue> or <value>: "5", "[1, 2(0)]", "(a := 1)".
[[nodiscard]] std::string valueText(pugi::xml_node holder);
/// A <dataType> as TYPE … END_TYPE.
[[nodiscard]] std::string typeDeclaration(pugi::xml_node dataType);
/// One <variable> as "name AT %IX0.0 : BOOL := TRUE; // comment", with the comment above when it is long.
[[nodiscard]] std::string variableText(pugi::xml_node variable, const std::string& indent);
/// {attribute 'name' := 'value'} lines of an element's addData.
[[nodiscard]] std::string attributeLines(pugi::xml_node element, const std::string& indent);

} // namespace plc::exchange
