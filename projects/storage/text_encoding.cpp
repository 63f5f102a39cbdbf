#include "projects/storage/text_encoding.h"

#include "projects/storage/errors.h"
#include "runtime/base/code_pages.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <array>

namespace plc::projects {

namespace {

using CodePage = std::array<char16_t, 128>;

/// The characters of a code page from 0x80 on. A byte without one stays the control character of its number, so that it
/// comes out again.
CodePage readCodePage(Encoding encoding) {
    CodePage out = upperHalfOf(nameOf(encoding));
    for (size_t i = 0; i < out.size(); ++i)
        if (out[i] == 0) out[i] = static_cast<char16_t>(0x80 + i);
    return out;
}

const CodePage& codePageOf(Encoding encoding) {
    switch (encoding) {
#define PLC_CODE_PAGE(Name, Shown, Others)                                                                             \
    case Encoding::Name: {                                                                                             \
        static const CodePage page = readCodePage(Encoding::Name);                                                     \
        return page;                                                                                                   \
    }
#include "runtime/base/code_pages.def"
    case Encoding::Utf8:
    case Encoding::Utf8Bom:
    case Encoding::Utf16Le:
    case Encoding::Utf16Be:
        break;
    }
    static const CodePage none{};
    return none;
}

std::string fromCodePage(std::string_view bytes, Encoding encoding) {
    const CodePage& page = codePageOf(encoding);
    std::string out;
    out.reserve(bytes.size() + bytes.size() / 8);
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x80)
            out += c;
        else
            appendUtf8(out, page[byte - 0x80u]);
    }
    return out;
}

bool isLatinLetter(unsigned char byte) { return (byte | 0x20) >= 'a' && (byte | 0x20) <= 'z'; }

/// Words of Windows-1251 are letters from 0xC0 on without Latin ones between them, and o and a are the most frequent of
/// them; in Western texts such bytes are alone among Latin letters, in Greek ones those two letters are the rarest.
bool looksCyrillic(std::string_view bytes) {
    size_t inWords = 0, among = 0, frequent = 0, others = 0;
    for (size_t at = 0; at < bytes.size();) {
        const size_t begin = at;
        const auto byteAt = [&](size_t i) { return static_cast<unsigned char>(bytes[i]); };
        for (; at < bytes.size() && byteAt(at) >= 0xC0; ++at) {
            const unsigned char small = byteAt(at) | 0x20;
            frequent += small == 0xEE || small == 0xE0;
        }
        if (at == begin) {
            others += byteAt(at) >= 0x80;
            ++at;
            continue;
        }
        const bool isAmong =
            (begin > 0 && isLatinLetter(byteAt(begin - 1))) || (at < bytes.size() && isLatinLetter(byteAt(at)));
        if (isAmong)
            among += at - begin;
        else if (at - begin > 1) // a letter alone is a word in French, too
            inWords += at - begin;
    }
    return inWords > 2 * among && inWords > 4 * others && frequent * 12 > inWords;
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

Error notInCodePage(Encoding encoding, std::string_view character) {
    if (encoding == Encoding::Windows1252) return Error{errors::NotInWindows1252(character), ""};
    return Error{errors::NotInCodePage(nameOf(encoding), character), ""};
}

Result<std::string> toCodePage(std::string_view utf8, Encoding encoding) {
    const CodePage& page = codePageOf(encoding);
    std::string out;
    out.reserve(utf8.size());
    for (size_t at = 0; at < utf8.size();) {
        const size_t begin = at;
        const char32_t c = decodeUtf8(utf8, at);
        if (c < 0x80) {
            out += static_cast<char>(c);
            continue;
        }
        const auto* const found = std::find(page.begin(), page.end(), c);
        if (found == page.end()) return notInCodePage(encoding, utf8.substr(begin, at - begin));
        out += static_cast<char>(0x80 + (found - page.begin()));
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

DecodedText decodeText(std::string_view bytes, std::optional<Encoding> otherwise) {
    const auto inCodePage = [&](std::string_view text) {
        const Encoding guess = looksCyrillic(text) ? Encoding::Windows1251 : Encoding::Windows1252;
        const Encoding page = otherwise && isCodePage(*otherwise) ? *otherwise : guess;
        return DecodedText{fromCodePage(text, page), page, !otherwise};
    };
    if (bytes.starts_with("\xEF\xBB\xBF")) {
        const std::string_view rest = bytes.substr(3);
        return firstInvalidUtf8(rest) ? inCodePage(rest) : DecodedText{std::string(rest), Encoding::Utf8Bom};
    }
    if (bytes.starts_with("\xFF\xFE")) return {fromUtf16(bytes.substr(2), false), Encoding::Utf16Le};
    if (bytes.starts_with("\xFE\xFF")) return {fromUtf16(bytes.substr(2), true), Encoding::Utf16Be};
    if (looksLikeUtf16(bytes, 1)) return {fromUtf16(bytes, false), Encoding::Utf16Le};
    if (looksLikeUtf16(bytes, 0)) return {fromUtf16(bytes, true), Encoding::Utf16Be};
    if (firstInvalidUtf8(bytes)) return inCodePage(bytes);
    return {std::string(bytes), Encoding::Utf8};
}

Result<std::string> encodeText(std::string_view utf8, Encoding encoding) {
    if (isCodePage(encoding)) return toCodePage(utf8, encoding);
    if (encoding == Encoding::Utf8Bom) return "\xEF\xBB\xBF" + std::string(utf8);
    if (encoding == Encoding::Utf16Le || encoding == Encoding::Utf16Be)
        return toUtf16(utf8, encoding == Encoding::Utf16Be);
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
#define PLC_CODE_PAGE(Name, Shown, Others)                                                                             \
    case Encoding::Name:                                                                                               \
        return Shown;
#include "runtime/base/code_pages.def"
    }
    return {};
}

bool isCodePage(Encoding encoding) { return encoding > Encoding::Utf16Be; }

std::optional<Encoding> encodingNamed(std::string_view name) {
    const auto isNamed = [&](std::string_view shown, std::string_view others) {
        return isNameOfEncoding(name, shown, others);
    };
    if (isNamed("UTF-8", "utf8")) return Encoding::Utf8;
    if (isNamed("UTF-16", "utf-16le")) return Encoding::Utf16Le;
    if (isNamed("UTF-16BE", "")) return Encoding::Utf16Be;
#define PLC_CODE_PAGE(Name, Shown, Others)                                                                             \
    if (isNamed(Shown, Others)) return Encoding::Name;
#include "runtime/base/code_pages.def"
    return std::nullopt;
}

std::vector<std::string> codePageNames() {
    return {
#define PLC_CODE_PAGE(Name, Shown, Others) Shown,
#include "runtime/base/code_pages.def"
    };
}

Result<Encoding> parseCodePage(std::string_view name) {
    const auto encoding = encodingNamed(name);
    if (encoding && isCodePage(*encoding)) return *encoding;
    return Error{errors::EncodingUnknown(name, {codePageNames()}), ""};
}

} // namespace plc::projects
