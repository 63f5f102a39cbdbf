#include "runtime/types/string_code.h"

#include "runtime/base/code_pages.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <array>

namespace plc::types {

namespace {

using UpperHalf = std::array<char16_t, 128>;

const UpperHalf& pageOf(StringCode code) {
    switch (code) {
#define PLC_CODE_PAGE(Name, Shown, Others)                                                                             \
    case StringCode::Name: {                                                                                           \
        static const UpperHalf page = upperHalfOf(Shown);                                                              \
        return page;                                                                                                   \
    }
#include "runtime/base/code_pages.def"
    case StringCode::Latin1:
    case StringCode::Utf8:
        break;
    }
    static const UpperHalf none{};
    return none;
}

bool isContinuation(std::string_view bytes, size_t at) {
    return at < bytes.size() && (static_cast<unsigned char>(bytes[at]) & 0xC0) == 0x80;
}

/// Bytes from `at` on that are one character of UTF-8; 0: they are none.
size_t lengthOfCharacter(std::string_view bytes, size_t at) {
    const auto first = static_cast<unsigned char>(bytes[at]);
    const size_t length = first < 0x80   ? 1
                          : first < 0xC2 ? 0
                          : first < 0xE0 ? 2
                          : first < 0xF0 ? 3
                          : first < 0xF5 ? 4
                                         : 0;
    for (size_t i = 1; i < length; ++i)
        if (!isContinuation(bytes, at + i)) return 0;
    if (length == 0) return 0;
    size_t next = at;
    return decodeUtf8(bytes, next) == 0xFFFD && bytes.substr(at, length) != "\xEF\xBF\xBD" ? 0 : length;
}

/// Letters of ASCII, Latin with marks, Greek and Cyrillic, as far as code pages have both cases.
char16_t otherCase(char16_t c, bool toUpper) {
    const auto in = [&](char16_t low, char16_t high) { return c >= low && c <= high; };
    if (toUpper) {
        if (in('a', 'z') || (in(0xE0, 0xFE) && c != 0xF7) || (in(0x3B1, 0x3C9) && c != 0x3C2) || in(0x430, 0x44F))
            return static_cast<char16_t>(c - 32);
        if (c == 0xFF) return 0x178;
        if (in(0x450, 0x45F)) return static_cast<char16_t>(c - 80);
        if (in(0x139, 0x148) || in(0x179, 0x17E)) return (c & 1) ? c : static_cast<char16_t>(c - 1);
        if (in(0x100, 0x177) && c != 0x131 && c != 0x138) return static_cast<char16_t>(c & ~1);
        if (c == 0x491) return 0x490;
        if (c == 0x3AC) return 0x386;
        if (in(0x3AD, 0x3AF)) return static_cast<char16_t>(c - 37);
        if (c == 0x3CC) return 0x38C;
        if (in(0x3CD, 0x3CE)) return static_cast<char16_t>(c - 63);
        return c;
    }
    if (in('A', 'Z') || (in(0xC0, 0xDE) && c != 0xD7) || (in(0x391, 0x3A9) && c != 0x3A2) || in(0x410, 0x42F))
        return static_cast<char16_t>(c + 32);
    if (c == 0x178) return 0xFF;
    if (in(0x400, 0x40F)) return static_cast<char16_t>(c + 80);
    if (in(0x139, 0x148) || in(0x179, 0x17E)) return (c & 1) ? static_cast<char16_t>(c + 1) : c;
    if (in(0x100, 0x177) && c != 0x130 && c != 0x138) return static_cast<char16_t>(c | 1);
    if (c == 0x490) return 0x491;
    if (c == 0x386) return 0x3AC;
    if (in(0x388, 0x38A)) return static_cast<char16_t>(c + 37);
    if (c == 0x38C) return 0x3CC;
    if (in(0x38E, 0x38F)) return static_cast<char16_t>(c + 63);
    return c;
}

char otherLetter(StringCode code, char letter, bool toUpper) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte >= 0x80 && code == StringCode::Utf8) return letter;
    size_t at = 0;
    const char32_t c = characterAt(code, {&letter, 1}, at);
    if (c > 0xFFFF) return letter;
    const char16_t other = otherCase(static_cast<char16_t>(c), toUpper);
    if (other == c) return letter;
    const CharacterBytes bytes = bytesOfCharacter(code, other);
    return bytes.size == 1 ? bytes.data[0] : letter;
}

} // namespace

std::string_view nameOf(StringCode code) {
    switch (code) {
    case StringCode::Latin1:
        return "Latin-1";
    case StringCode::Utf8:
        return "UTF-8";
#define PLC_CODE_PAGE(Name, Shown, Others)                                                                             \
    case StringCode::Name:                                                                                             \
        return Shown;
#include "runtime/base/code_pages.def"
    }
    return {};
}

std::optional<StringCode> stringCodeNamed(std::string_view name) {
    const auto isNamed = [&](std::string_view shown, std::string_view others) {
        return isNameOfEncoding(name, shown, others);
    };
    if (isNamed("Latin-1", "latin1 iso-8859-1")) return StringCode::Latin1;
    if (isNamed("UTF-8", "utf8")) return StringCode::Utf8;
#define PLC_CODE_PAGE(Name, Shown, Others)                                                                             \
    if (isNamed(Shown, Others)) return StringCode::Name;
#include "runtime/base/code_pages.def"
    return std::nullopt;
}

std::vector<std::string> stringCodeNames() {
    return {
        "Latin-1",
        "UTF-8",
#define PLC_CODE_PAGE(Name, Shown, Others) Shown,
#include "runtime/base/code_pages.def"
    };
}

void prepare(StringCode code) { (void)pageOf(code); }

char32_t characterAt(StringCode code, std::string_view bytes, size_t& at) {
    const auto byte = static_cast<unsigned char>(bytes[at]);
    if (code == StringCode::Utf8) {
        const size_t length = lengthOfCharacter(bytes, at);
        if (length > 0) return decodeUtf8(bytes, at);
        ++at;
        return kRawByte + byte;
    }
    ++at;
    if (byte < 0x80 || code == StringCode::Latin1) return byte;
    const char16_t c = pageOf(code)[byte - 0x80u];
    return c == 0 ? kRawByte + byte : c;
}

std::u32string charactersOf(StringCode code, std::string_view bytes) {
    std::u32string out;
    for (size_t at = 0; at < bytes.size();) out += characterAt(code, bytes, at);
    return out;
}

CharacterBytes bytesOfCharacter(StringCode code, char32_t c) {
    const auto single = [](char32_t byte) { return CharacterBytes{{static_cast<char>(byte)}, 1}; };
    if (c >= kRawByte) return single(c - kRawByte);
    if (c < 0x80 || (code == StringCode::Latin1 && c <= 0xFF)) return single(c);
    if (code == StringCode::Latin1) return {};
    if (code == StringCode::Utf8) {
        if (c >= 0xD800 && c < 0xE000) return {}; // half of a pair is no character
        if (c < 0x800) return {{static_cast<char>(0xC0 | (c >> 6)), static_cast<char>(0x80 | (c & 0x3F))}, 2};
        if (c < 0x10000)
            return {{static_cast<char>(0xE0 | (c >> 12)), static_cast<char>(0x80 | ((c >> 6) & 0x3F)),
                     static_cast<char>(0x80 | (c & 0x3F))},
                    3};
        return {{static_cast<char>(0xF0 | (c >> 18)), static_cast<char>(0x80 | ((c >> 12) & 0x3F)),
                 static_cast<char>(0x80 | ((c >> 6) & 0x3F)), static_cast<char>(0x80 | (c & 0x3F))},
                4};
    }
    const UpperHalf& page = pageOf(code);
    for (size_t i = 0; i < page.size(); ++i)
        if (page[i] == c) return single(static_cast<char32_t>(0x80 + i));
    // as an unused place is shown
    if (c >= 0x80 && c < 0x100 && page[c - 0x80] == 0) return single(c);
    return {};
}

bool appendCharacter(StringCode code, std::string& bytes, char32_t character) {
    const CharacterBytes made = bytesOfCharacter(code, character);
    bytes.append(made.data, made.size);
    return made.size > 0;
}

std::string utf8OfString(StringCode code, std::string_view bytes) {
    std::string out;
    for (size_t at = 0; at < bytes.size();) {
        const char32_t c = characterAt(code, bytes, at);
        appendUtf8(out, c >= kRawByte ? c - kRawByte : c);
    }
    return out;
}

std::optional<std::string> stringOfUtf8(StringCode code, std::string_view utf8, size_t* bad) {
    std::string out;
    for (size_t at = 0; at < utf8.size();) {
        const size_t begin = at;
        if (appendCharacter(code, out, decodeUtf8(utf8, at))) continue;
        if (bad) *bad = begin;
        return std::nullopt;
    }
    return out;
}

std::u16string wideOfString(StringCode code, std::string_view bytes) {
    std::u16string out;
    for (size_t at = 0; at < bytes.size();) {
        char32_t c = characterAt(code, bytes, at);
        if (c >= kRawByte) c -= kRawByte;
        if (c > 0xFFFF) {
            out += static_cast<char16_t>(0xD800 + ((c - 0x10000) >> 10));
            c = 0xDC00 + ((c - 0x10000) & 0x3FF);
        }
        out += static_cast<char16_t>(c);
    }
    return out;
}

std::string stringOfWide(StringCode code, std::u16string_view wide, bool& isWhole, size_t capacity) {
    std::string out;
    for (size_t at = 0; at < wide.size(); ++at) {
        char32_t c = wide[at];
        const bool isPair = c >= 0xD800 && c < 0xDC00 && at + 1 < wide.size() && (wide[at + 1] & 0xFC00) == 0xDC00;
        if (isPair) c = 0x10000 + ((c - 0xD800) << 10) + (wide[++at] - 0xDC00u);
        const CharacterBytes bytes = bytesOfCharacter(code, c);
        if (out.size() + std::max<size_t>(bytes.size, 1) > capacity) break;
        isWhole = isWhole && bytes.size > 0;
        if (bytes.size == 0)
            out += '?';
        else
            out.append(bytes.data, bytes.size);
    }
    return out;
}

char16_t wideOfCharacter(StringCode code, unsigned char byte) {
    const auto letter = static_cast<char>(byte);
    size_t at = 0;
    const char32_t c = characterAt(code, {&letter, 1}, at);
    return static_cast<char16_t>(c >= kRawByte ? c - kRawByte : c);
}

std::optional<unsigned char> characterOfWide(StringCode code, char16_t wide) {
    const CharacterBytes bytes = bytesOfCharacter(code, wide);
    if (bytes.size != 1) return std::nullopt;
    return static_cast<unsigned char>(bytes.data[0]);
}

char16_t upperCharacter(char16_t c) { return otherCase(c, true); }
char16_t lowerCharacter(char16_t c) { return otherCase(c, false); }
char upperLetter(StringCode code, char letter) { return otherLetter(code, letter, true); }
char lowerLetter(StringCode code, char letter) { return otherLetter(code, letter, false); }

} // namespace plc::types
