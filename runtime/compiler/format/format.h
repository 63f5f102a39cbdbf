// The formatter: same tokens, same comments, tidy blanks. Pure functions, any thread.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace plc::format {

enum class KeywordCase : uint8_t { Upper, Lower, AsWritten };

struct FormatOptions {
    KeywordCase keywords = KeywordCase::Upper;
    int indentWidth = 4;
    bool useTabs = false;
    int maxBlankLines = 1;          // in a row
    bool alignComments = true;      // behind declarations and statements of neighbouring lines
    bool alignDeclarations = false; // the colons of neighbouring declarations
};

/// The tokens and comments stay the same and in order; formatting the result changes nothing. Lines with syntax errors
/// stay byte for byte.
[[nodiscard]] std::string format(std::string_view text, const FormatOptions& options);

} // namespace plc::format
