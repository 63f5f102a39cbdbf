// Text files of other tools: UTF-8, UTF-16 (either byte order) and the code pages of code_pages.def become UTF-8, and
// go out as they came. Pure functions, any thread.
#pragma once
#include "runtime/base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plc::projects {

enum class Encoding : uint8_t {
    Utf8,
    Utf8Bom,
    Utf16Le,
    Utf16Be,
#define PLC_CODE_PAGE(Name, Shown, Others) Name,
#include "runtime/base/code_pages.def"
};

struct DecodedText {
    std::string text; // UTF-8, without a byte order mark
    Encoding encoding = Encoding::Utf8;
    bool isGuessed = false; // nothing in the file says which code page it is
};

/// Never fails: what is neither UTF-16 nor valid UTF-8 is read in the code page `otherwise`, without one in
/// Windows-1251 when its words are Cyrillic, else in Windows-1252. In a code page every byte is a character.
[[nodiscard]] DecodedText decodeText(std::string_view bytes, std::optional<Encoding> otherwise = {});
/// The bytes of a file in that encoding; an error names the first character that the code page does not have.
[[nodiscard]] Result<std::string> encodeText(std::string_view utf8, Encoding encoding);
[[nodiscard]] std::string_view nameOf(Encoding encoding);
/// Not a Unicode one.
[[nodiscard]] bool isCodePage(Encoding encoding);
/// By one of its names, in any case.
[[nodiscard]] std::optional<Encoding> encodingNamed(std::string_view name);
/// As they are shown.
[[nodiscard]] std::vector<std::string> codePageNames();
/// The code page of that name; an error lists those there are.
[[nodiscard]] Result<Encoding> parseCodePage(std::string_view name);

} // namespace plc::projects
