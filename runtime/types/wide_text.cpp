#include "runtime/types/wide_text.h"

namespace plc::types {

std::u32string charactersOfWide(std::u16string_view units) {
    std::u32string out;
    for (size_t i = 0; i < units.size(); ++i) {
        const char32_t unit = units[i];
        const bool isPair = (unit & 0xFC00) == 0xD800 && i + 1 < units.size() && (units[i + 1] & 0xFC00) == 0xDC00;
        if (isPair)
            out += 0x10000 + ((unit - 0xD800) << 10) + (units[++i] - 0xDC00u);
        else
            out += isHalfOfPair(unit) ? kRawByte + unit : unit;
    }
    return out;
}

std::u16string wideOfCharacters(std::u32string_view characters) {
    std::u16string out;
    for (const char32_t c : characters) {
        if (c >= kRawByte) {
            out += static_cast<char16_t>(c - kRawByte);
        } else if (c >= 0x10000) {
            out += static_cast<char16_t>(0xD800 + ((c - 0x10000) >> 10));
            out += static_cast<char16_t>(0xDC00 + ((c - 0x10000) & 0x3FF));
        } else {
            out += static_cast<char16_t>(c);
        }
    }
    return out;
}

} // namespace plc::types
