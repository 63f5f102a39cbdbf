// FB_FormatString of TwinCAT's utilities and the functions that make its arguments, in ST: texts with values in them
// are what programs show on panels and write into logs. Texts, any thread.
#pragma once
#include <string>
#include <string_view>

namespace plc::exchange {

/// The block and the type of its arguments.
[[nodiscard]] std::string_view formatStringText();
/// FB_FormatString2, which uses it.
[[nodiscard]] std::string_view formatString2Text();
/// F_INT of "INT"; empty for a type that has no such function.
[[nodiscard]] std::string formatArgumentText(std::string_view type);

} // namespace plc::exchange
