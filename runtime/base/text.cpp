#include "runtime/base/text.h"

#include "runtime/base/chars.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace plc {

namespace {

char32_t foldCharacter(char32_t c) {
    if (c >= 'A' && c <= 'Z') return c + 32;
    if (c < 0x80) return c;
    if ((c >= 0xC0 && c <= 0xDE && c != 0xD7)) return c + 32;
    if (c >= 0x100 && c <= 0x17F) {
        if ((c >= 0x139 && c <= 0x148) || (c >= 0x179 && c <= 0x17E)) return (c & 1) ? c + 1 : c;
        if (c == 0x130 || c == 0x131 || c == 0x138 || c == 0x149 || c == 0x17F) return c;
        if (c == 0x178) return 0xFF;
        return c | 1;
    }
    const bool isEven = (c & 1) == 0;
    if ((c >= 0x1DE && c <= 0x1EF) || (c >= 0x1F8 && c <= 0x21F) || (c >= 0x222 && c <= 0x233))
        return isEven ? c + 1 : c;
    if (c >= 0x1CD && c <= 0x1DC) return isEven ? c : c + 1;
    if (c == 0x386) return 0x3AC;
    if (c >= 0x388 && c <= 0x38A) return c + 37;
    if (c == 0x38C) return 0x3CC;
    if (c == 0x38E || c == 0x38F) return c + 63;
    if (c == 0x3C2) return 0x3C3; // the sigma at a word's end
    if (c >= 0x391 && c <= 0x3AB && c != 0x3A2) return c + 32;
    if (c >= 0x410 && c <= 0x42F) return c + 32;
    if (c >= 0x400 && c <= 0x40F) return c + 80;
    if ((c >= 0x460 && c <= 0x481) || (c >= 0x48A && c <= 0x4BF) || (c >= 0x4D0 && c <= 0x52F))
        return isEven ? c + 1 : c; // Cyrillic beyond Russian
    if (c >= 0x4C1 && c <= 0x4CE) return isEven ? c : c + 1;
    if (c >= 0x531 && c <= 0x556) return c + 48;     // Armenian
    if (c >= 0x1C90 && c <= 0x1CBF) return c - 3008; // Georgian
    if (c == 0x1E9E) return 0xDF;
    if (c >= 0x1E00 && c <= 0x1EFF && !(c >= 0x1E96 && c <= 0x1E9F))
        return isEven ? c + 1 : c;                 // Latin with marks, Vietnamese
    if (c >= 0xFF21 && c <= 0xFF3A) return c + 32; // full width
    return c;
}

// Names are nearly always ASCII, and a check compares and folds them by the hundred thousand: that way makes no second
// string and looks at each byte once.
char foldAscii(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }
bool isAscii(char c) { return static_cast<unsigned char>(c) < 0x80; }

template <class T> std::string shortest(T value) {
    if (std::isnan(value)) return "NaN";
    if (std::isinf(value)) return value > 0 ? "INF" : "-INF";
    char buffer[64];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    std::string text(buffer, end);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text;
}

} // namespace

std::string foldCase(std::string_view utf8) {
    std::string out(utf8);
    size_t i = 0;
    for (; i < out.size() && isAscii(out[i]); ++i) out[i] = foldAscii(out[i]);
    out.resize(i);
    while (i < utf8.size())
        if (isAscii(utf8[i]))
            out += foldAscii(utf8[i++]);
        else
            appendUtf8(out, foldCharacter(decodeUtf8(utf8, i)));
    return out;
}

bool equalsIgnoringCase(std::string_view a, std::string_view b) {
    const size_t shorter = std::min(a.size(), b.size());
    size_t i = 0;
    for (; i < shorter && isAscii(a[i]) && isAscii(b[i]); ++i)
        if (foldAscii(a[i]) != foldAscii(b[i])) return false;
    // One letter of another script may have fewer bytes than its capital: only what is folded can be compared.
    return i == a.size() || i == b.size() ? a.size() == b.size() : foldCase(a.substr(i)) == foldCase(b.substr(i));
}

char32_t decodeUtf8(std::string_view text, size_t& at) {
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(at);
    size_t length = first < 0x80 ? 1 : (first >> 5) == 6 ? 2 : (first >> 4) == 14 ? 3 : (first >> 3) == 30 ? 4 : 0;
    if (length == 1) return text[at++];
    if (length == 0 || at + length > text.size()) {
        ++at;
        return 0xFFFD;
    }
    char32_t c = first & (0xFF >> (length + 1));
    for (size_t i = 1; i < length; ++i) {
        if ((byte(at + i) & 0xC0) != 0x80) {
            ++at;
            return 0xFFFD;
        }
        c = (c << 6) | (byte(at + i) & 0x3F);
    }
    const char32_t least = length == 2 ? 0x80 : length == 3 ? 0x800 : 0x10000;
    if (c < least || c > 0x10FFFF || (c >= 0xD800 && c <= 0xDFFF)) {
        ++at;
        return 0xFFFD;
    }
    at += length;
    return c;
}

std::optional<size_t> firstInvalidUtf8(std::string_view bytes) {
    for (size_t i = 0; i < bytes.size();) {
        const size_t before = i;
        if (decodeUtf8(bytes, i) == 0xFFFD && bytes.substr(before, 3) != "\xEF\xBF\xBD") return before;
    }
    return std::nullopt;
}

void appendUtf8(std::string& out, char32_t c) {
    if (c < 0x80) {
        out += static_cast<char>(c);
    } else if (c < 0x800) {
        out += static_cast<char>(0xC0 | (c >> 6));
        out += static_cast<char>(0x80 | (c & 0x3F));
    } else if (c < 0x10000) {
        out += static_cast<char>(0xE0 | (c >> 12));
        out += static_cast<char>(0x80 | ((c >> 6) & 0x3F));
        out += static_cast<char>(0x80 | (c & 0x3F));
    } else {
        out += static_cast<char>(0xF0 | (c >> 18));
        out += static_cast<char>(0x80 | ((c >> 12) & 0x3F));
        out += static_cast<char>(0x80 | ((c >> 6) & 0x3F));
        out += static_cast<char>(0x80 | (c & 0x3F));
    }
}

std::string latin1ToUtf8(std::string_view latin1) {
    std::string out;
    for (const char c : latin1) appendUtf8(out, static_cast<unsigned char>(c));
    return out;
}

std::optional<std::string> utf8ToLatin1(std::string_view utf8, size_t* bad) {
    std::string out;
    for (size_t i = 0; i < utf8.size();) {
        const size_t before = i;
        const char32_t c = decodeUtf8(utf8, i);
        if (c > 0xFF) {
            if (bad) *bad = before;
            return std::nullopt;
        }
        out += static_cast<char>(c);
    }
    return out;
}

std::u16string utf8ToUtf16(std::string_view utf8) {
    std::u16string out;
    for (size_t i = 0; i < utf8.size();) {
        const char32_t c = decodeUtf8(utf8, i);
        if (c >= 0x10000) {
            out += static_cast<char16_t>(0xD800 + ((c - 0x10000) >> 10));
            out += static_cast<char16_t>(0xDC00 + ((c - 0x10000) & 0x3FF));
        } else {
            out += static_cast<char16_t>(c);
        }
    }
    return out;
}

std::string utf16ToUtf8(std::u16string_view utf16) {
    std::string out;
    for (size_t i = 0; i < utf16.size(); ++i) {
        char32_t c = utf16[i];
        if (c >= 0xD800 && c < 0xDC00 && i + 1 < utf16.size() && utf16[i + 1] >= 0xDC00 && utf16[i + 1] < 0xE000)
            c = 0x10000 + ((c - 0xD800) << 10) + (utf16[++i] - 0xDC00);
        else if (c >= 0xD800 && c < 0xE000)
            c = 0xFFFD;
        appendUtf8(out, c);
    }
    return out;
}

std::string shortestReal(double value) { return shortest(value); }
std::string shortestReal(float value) { return shortest(value); }

size_t editDistance(std::string_view left, std::string_view right) {
    const std::string a = foldCase(left), b = foldCase(right);
    std::vector<size_t> earlier(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (size_t i = 1; i <= a.size(); ++i) {
        earlier.swap(last);
        last.swap(row);
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) // two letters changed places
                row[j] = std::min(row[j], earlier[j - 2] + 1);
        }
    }
    return row[b.size()];
}

/// The ASCII characters of a name without case, some of them as one. An edit adds at most one and takes at most one.
static uint32_t charactersOf(std::string_view name) {
    uint32_t out = 0;
    for (const char c : name)
        if (static_cast<unsigned char>(c) < 0x80) out |= 1u << (static_cast<unsigned char>(c) & 31);
    return out;
}

/// Bytes at the beginning that are the same, of ASCII without case.
static size_t sameBeginning(std::string_view a, std::string_view b) {
    const auto isSame = [](char x, char y) { return asciiLower(x) == asciiLower(y); };
    return static_cast<size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end(), isSame).first - a.begin());
}

/// Of several at the same distance the one that begins as the name does ("leve": "level" and not "leave"), then the
/// first in the order of bytes, whatever the order of the candidates.
std::optional<std::string> nearestName(std::string_view name, const std::vector<std::string>& candidates) {
    const std::string* best = nullptr;
    size_t bestBeginning = 0;
    size_t bestDistance = std::max<size_t>(1, name.size() / 3); // the largest that counts, until one is found
    const uint32_t characters = charactersOf(name);
    for (const std::string& candidate : candidates) {
        if (candidate.size() + bestDistance < name.size() || name.size() + bestDistance < candidate.size()) continue;
        const auto different = static_cast<size_t>(std::popcount(characters ^ charactersOf(candidate)));
        if (different > 2 * bestDistance) continue; // most names are this far away
        const size_t distance = editDistance(name, candidate);
        if (distance > bestDistance || distance >= candidate.size()) continue;
        const size_t beginning = sameBeginning(name, candidate);
        if (best && distance == bestDistance &&
            (beginning < bestBeginning || (beginning == bestBeginning && candidate >= *best)))
            continue;
        best = &candidate;
        bestBeginning = beginning;
        bestDistance = distance;
    }
    return best ? std::optional(*best) : std::nullopt;
}

bool isNameLetter(char32_t c) {
    if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')) return true;
    if (c < 0xC0) return c == 0xAA || c == 0xB5 || c == 0xBA;
    if (c == 0xD7 || c == 0xF7 || c == 0xFFFD || c == 0xFEFF) return false;
    if (c >= 0x2000 && c <= 0x2BFF) return false; // punctuation, arrows, mathematical and box symbols
    if (c >= 0x3000 && c <= 0x3004) return false; // CJK punctuation
    return !(c >= 0x3008 && c <= 0x3020) && !(c >= 0xFF00 && c <= 0xFF20);
}

} // namespace plc
