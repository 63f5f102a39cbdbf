// Text files of other tools: UTF-8, UTF-16 (either byte order) and Windows-1252 become UTF-8, and go out as they came.
// Pure functions, any thread.
#pragma once
#include "runtime/base/result.h"

#include <string>
#include <string_view>

namespace plc::projects {

enum class Encoding : uint8_t { Utf8, Utf8Bom, Utf16Le, Utf16Be, Windows1252 };

struct DecodedText {
    std::string text; // UTF-8, without a byte order mark
    Encoding encoding = Encoding::Utf8;
};

/// Never fails: what is neither UTF-16 nor valid UTF-8 is read as Windows-1252, in which every byte is a character.
[[nodiscard]] DecodedText decodeText(std::string_view bytes);
/// The bytes of a file in that encoding; an error names the first character that Windows-1252 does not have.
[[nodiscard]] Result<std::string> encodeText(std::string_view utf8, Encoding encoding);
[[nodiscard]] std::string_view nameOf(Encoding encoding);

} // namespace plc::projects
