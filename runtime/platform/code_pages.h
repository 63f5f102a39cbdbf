// Code pages with one byte for each character, as the system's library of conversions knows them. Function, any thread.
#pragma once
#include <array>

namespace plc::platform {

/// The characters of the bytes from 0x80 on; 0 where the code page has none, and everywhere when it is not known.
[[nodiscard]] std::array<char16_t, 128> upperHalfOf(const char* codePage);

} // namespace plc::platform
