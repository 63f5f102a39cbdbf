// errors::DivisionByZero(), errors::NoVariable(name)…: what runtime and projects say, from messages.def; and what the
// system says, as one of them. For the sources that report; headers need result.h only. Functions, any thread.
#pragma once
#include "runtime/base/result.h"

#include <system_error>

namespace plc::errors {
using messages::Integer, messages::Name, messages::Names, messages::Nested, messages::Path, messages::Thing;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"Errors", #Row, Text};
#include "runtime/base/messages.def"

/// What the system answered: errno, or the code of std::filesystem.
[[nodiscard]] Message ofSystem(int code);
[[nodiscard]] inline Message ofSystem(const std::error_code& code) { return ofSystem(code.value()); }

/// The message with its place in front.
[[nodiscard]] Message withPlace(const Error& error);

/// As a recording keeps it: the name of its row and the arguments, so that it is read in any language later. A message
/// of another list is kept as its English text, as are the texts of older recordings.
[[nodiscard]] std::string packed(const Message& message);
[[nodiscard]] Message unpacked(std::string_view text);
} // namespace plc::errors
