// The words of panel files (choices, colour roles, symbols, kinds of values) as the designer shows them. Pure
// functions, any thread.
#pragma once
#include <QString>

#include <string_view>

namespace plc::hmi {

/// "momentary" of "action" is "Momentary"; a word that has no title is shown as it is.
QString choiceTitle(std::string_view property, std::string_view word);
QString roleTitle(const QString& role);
QString symbolTitle(const QString& symbol);
/// What an expression must give: "number", "bool", …
QString valueKindTitle(std::string_view kind);

} // namespace plc::hmi
