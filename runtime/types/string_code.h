// What the bytes of a STRING stand for: Latin-1, a code page or UTF-8, one for a whole program, as its project says
// ("stringEncoding"). Lengths and positions count bytes whatever it is. Values and pure functions, any thread.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plc::types {

enum class StringCode : uint8_t {
    Latin1,
    Utf8,
#define PLC_CODE_PAGE(Name, Shown, Others) Name,
#include "runtime/base/code_pages.def"
};

/// A byte that is no character (half of one in UTF-8, an unused place of a code page): this and the byte.
inline constexpr char32_t kRawByte = 0x110000;

[[nodiscard]] std::string_view nameOf(StringCode code); // "Latin-1", "UTF-8", "Windows-1251"
/// By one of its names, in any case.
[[nodiscard]] std::optional<StringCode> stringCodeNamed(std::string_view name);
[[nodiscard]] std::vector<std::string> stringCodeNames(); // as they are shown
/// Reads what the other functions need, so that they take no memory.
void prepare(StringCode code);

/// The next character, and `at` behind it.
[[nodiscard]] char32_t characterAt(StringCode code, std::string_view bytes, size_t& at);
[[nodiscard]] std::u32string charactersOf(StringCode code, std::string_view bytes);
/// False: the code does not have it, and `bytes` stays as it is. A raw byte is always there.
bool appendCharacter(StringCode code, std::string& bytes, char32_t character);
/// The bytes of a character, at most four; none when the code does not have it.
struct CharacterBytes {
    char data[4] = {};
    uint8_t size = 0;
};
[[nodiscard]] CharacterBytes bytesOfCharacter(StringCode code, char32_t character);

/// Raw bytes are shown as the character of their number.
[[nodiscard]] std::string utf8OfString(StringCode code, std::string_view bytes);
/// Fails at a character that the code does not have (its byte offset is written to `bad`).
[[nodiscard]] std::optional<std::string> stringOfUtf8(StringCode code, std::string_view utf8, size_t* bad = nullptr);
[[nodiscard]] std::u16string wideOfString(StringCode code, std::string_view bytes);
/// A character that the code does not have becomes '?' and `isWhole` false. Ends in front of the character that is too
/// long for `capacity`.
[[nodiscard]] std::string stringOfWide(StringCode code, std::u16string_view wide, bool& isWhole,
                                       size_t capacity = SIZE_MAX);

/// CHAR as WCHAR: the character of the byte; the byte's number where it is none.
[[nodiscard]] char16_t wideOfCharacter(StringCode code, unsigned char byte);
/// WCHAR as CHAR: none when the character is not one byte.
[[nodiscard]] std::optional<unsigned char> characterOfWide(StringCode code, char16_t wide);

/// The letter's counterpart: ASCII, Latin with marks, Greek, Cyrillic.
[[nodiscard]] char16_t upperCharacter(char16_t c);
[[nodiscard]] char16_t lowerCharacter(char16_t c);
/// The letter's counterpart where it is one byte too; in UTF-8 only of ASCII.
[[nodiscard]] char upperLetter(StringCode code, char letter);
[[nodiscard]] char lowerLetter(StringCode code, char letter);

} // namespace plc::types
