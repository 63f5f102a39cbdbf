// Text at the borders: UTF-8 files, Latin-1 STRING, UTF-16 WSTRING, names without case. Pure functions, any thread.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plc {

/// Case-folded spelling of a name (ASCII, Latin, Greek, Cyrillic); names compare by it. Other scripts pass unchanged.
std::string foldCase(std::string_view utf8);
bool equalsIgnoringCase(std::string_view a, std::string_view b);

/// Byte offset of the first invalid UTF-8 sequence, or none.
std::optional<size_t> firstInvalidUtf8(std::string_view bytes);
/// Decodes one character at `at` and advances it; 0xFFFD for an invalid byte.
char32_t decodeUtf8(std::string_view text, size_t& at);
void appendUtf8(std::string& out, char32_t character);
/// Latin-1 bytes ⇄ UTF-8. The way to Latin-1 fails at a character above U+00FF (its byte offset is written to `bad`).
std::string latin1ToUtf8(std::string_view latin1);
std::optional<std::string> utf8ToLatin1(std::string_view utf8, size_t* bad = nullptr);
std::u16string utf8ToUtf16(std::string_view utf8);
std::string utf16ToUtf8(std::u16string_view utf16);

/// Shortest text that reads back the same number: "1.5", "0.1", "1e+30", "NaN", "INF", "-INF"; always with a point or
/// exponent ("5.0").
std::string shortestReal(double value);
std::string shortestReal(float value);

/// Edit distance without case, for "did you mean".
size_t editDistance(std::string_view a, std::string_view b);
/// The nearest of `candidates` within a third of the name's length, or none.
std::optional<std::string> nearestName(std::string_view name, const std::vector<std::string>& candidates);

/// A letter of a name in any script (ASCII letters and everything above U+00BF but × ÷ and punctuation blocks).
bool isNameLetter(char32_t character);

} // namespace plc
