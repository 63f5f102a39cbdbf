// Code pages with one byte for each character: what their upper halves stand for, in the program itself, since a built
// program runs where the system may know none of them. Functions, any thread.
#pragma once
#include <array>
#include <string_view>

namespace plc {

/// The characters of the bytes from 0x80 on; 0 where the code page has none, and everywhere when it is not known.
/// `codePage`: as code_pages.def shows it.
[[nodiscard]] std::array<char16_t, 128> upperHalfOf(std::string_view codePage);

/// Whether `name`, in any case, is what an encoding is shown as or one of its other names (in lower case, with blanks
/// between them).
[[nodiscard]] bool isNameOfEncoding(std::string_view name, std::string_view shown, std::string_view others);

} // namespace plc
