// What the word before # says of a literal: T#5s, DATE#2024-01-01, INT#5. A pure function, any thread.
#pragma once
#include <cstdint>
#include <string_view>

namespace plc::lex {

enum class PrefixKind : uint8_t { Type, Duration, Date, TimeOfDay, DateTime, Bcd };
[[nodiscard]] PrefixKind prefixKind(std::string_view word);

} // namespace plc::lex
