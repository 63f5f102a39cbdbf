// Characters and the UTF-16 code units of a WSTRING, which counts units: a text that was cut can begin or end with half
// of a pair. Such a half is kept as a raw unit, like a byte that is no character (kRawByte). Pure functions, any
// thread.
#pragma once
#include "runtime/types/string_code.h"

namespace plc::types {

[[nodiscard]] constexpr bool isHalfOfPair(char32_t unit) { return unit >= 0xD800 && unit < 0xE000; }

/// The characters of a text; half a pair becomes kRawByte and the unit.
[[nodiscard]] std::u32string charactersOfWide(std::u16string_view units);
/// The units of characters, raw ones as they are: halves that meet are one character again.
[[nodiscard]] std::u16string wideOfCharacters(std::u32string_view characters);

} // namespace plc::types
