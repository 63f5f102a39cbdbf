#include "projects/storage/text_encoding.h"

#include "runtime/base/messages.h"
#include "runtime/base/text.h"

#include <array>

namespace plc::projects {

namespace {

/// Windows-1252 from 0x80 to 0x9F; 0: not assigned, kept as the control character.
constexpr std::array<char16_t, 32> kHigh = {0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021,
                                            0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0,      0x017D, 0,
                                            0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014,
                                            0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};

std::string fromWindows1252(std::string_view bytes) {
    std::string out;
    out.reserve(bytes.size() + bytes.size() / 8);
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        const char16_t high = byte >= 0x80 && byte < 0xA0 ? kHigh[byte - 0x80] : 0;
        appendUtf8(out, high ? high : byte);
    }
    return out;
}

std::string fromUtf16(std::string_view bytes, bool bigEndian) {
    std::u16string units;
    units.reserve(bytes.size() / 2);
    for (size_t i = 0; i + 1 < bytes.size(); i += 2) {
        const auto first = static_cast<unsigned char>(bytes[i]), second = static_cast<unsigned char>(bytes[i + 1]);
        units.push_back(static_cast<char16_t>(bigEndian ? first << 8 | second : second << 8 | first));
    }
    return utf16ToUtf8(units);
}

/// Text of a program is mostly ASCII: every other byte is zero.
bool looksLikeUtf16(std::string_view bytes, size_t zeroAt) {
    if (bytes.size() < 4 || bytes.size() % 2 != 0) return false;
    const size_t looked = std::min<size_t>(bytes.size(), 400);
    size_t zeros = 0;
    for (size_t i = zeroAt; i < looked; i += 2)
        if (bytes[i] == '\0') ++zeros;
    return zeros * 10 >= looked / 2 * 7;
}

Result<std::string> toWindows1252(std::string_view utf8) {
    std::string out;
    out.reserve(utf8.size());
    for (size_t at = 0; at < utf8.size();) {
        const size_t begin = at;
        const char32_t c = decodeUtf8(utf8, at);
        if (c < 0x80 || (c >= 0xA0 && c <= 0xFF)) {
            out += static_cast<char>(c);
            continue;
        }
        const auto* const found = std::find(kHigh.begin(), kHigh.end(), c);
        if (found != kHigh.end())
            out += static_cast<char>(0x80 + (found - kHigh.begin()));
        else if (c < 0xA0 && kHigh[c - 0x80] == 0)
            out += static_cast<char>(c);
        else
            return Error{errors::NotInWindows1252(utf8.substr(begin, at - begin)), ""};
    }
    return out;
}

std::string toUtf16(std::string_view utf8, bool bigEndian) {
    std::string out = bigEndian ? "\xFE\xFF" : "\xFF\xFE";
    for (const char16_t unit : utf8ToUtf16(utf8)) {
        const char high = static_cast<char>(unit >> 8), low = static_cast<char>(unit & 0xFF);
        out += bigEndian ? high : low;
        out += bigEndian ? low : high;
    }
    return out;
}

} // namespace

DecodedText decodeText(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) {
        const std::string_view rest = bytes.substr(3);
        if (!firstInvalidUtf8(rest)) return {std::string(rest), Encoding::Utf8Bom};
        return {fromWindows1252(rest), Encoding::Windows1252};
    }
    if (bytes.starts_with("\xFF\xFE")) return {fromUtf16(bytes.substr(2), false), Encoding::Utf16Le};
    if (bytes.starts_with("\xFE\xFF")) return {fromUtf16(bytes.substr(2), true), Encoding::Utf16Be};
    if (looksLikeUtf16(bytes, 1)) return {fromUtf16(bytes, false), Encoding::Utf16Le};
    if (looksLikeUtf16(bytes, 0)) return {fromUtf16(bytes, true), Encoding::Utf16Be};
    if (firstInvalidUtf8(bytes)) return {fromWindows1252(bytes), Encoding::Windows1252};
    return {std::string(bytes), Encoding::Utf8};
}

Result<std::string> encodeText(std::string_view utf8, Encoding encoding) {
    switch (encoding) {
    case Encoding::Utf8:
        return std::string(utf8);
    case Encoding::Utf8Bom:
        return "\xEF\xBB\xBF" + std::string(utf8);
    case Encoding::Utf16Le:
        return toUtf16(utf8, false);
    case Encoding::Utf16Be:
        return toUtf16(utf8, true);
    case Encoding::Windows1252:
        return toWindows1252(utf8);
    }
    return std::string(utf8);
}

std::string_view nameOf(Encoding encoding) {
    switch (encoding) {
    case Encoding::Utf8:
        return "UTF-8";
    case Encoding::Utf8Bom:
        return "UTF-8 with a byte order mark";
    case Encoding::Utf16Le:
    case Encoding::Utf16Be:
        return "UTF-16";
    case Encoding::Windows1252:
        return "Windows-1252";
    }
    return {};
}

} // namespace plc::projects
