#include "runtime/library/text_runtime.h"

#include "runtime/types/conversion.h"
#include "runtime/types/scalar_text.h"
#include "runtime/types/string_code.h"

#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace plc::library {
namespace {

using types::TypeKind;

template <class C> uint32_t lengthOf(const C* text, uint32_t capacity) {
    if constexpr (sizeof(C) == 1) return static_cast<uint32_t>(strnlen(text, capacity));
    uint32_t length = 0;
    while (length < capacity && text[length] != 0) ++length;
    return length;
}

template <class C> using View = std::basic_string_view<C>;

template <class C> View<C> viewOf(const C* text, uint32_t capacity) { return {text, lengthOf(text, capacity)}; }

/// The result under construction: never longer than its capacity, always terminated.
template <class C> class Output {
public:
    Output(C* to, uint32_t capacity) : m_to(to), m_capacity(capacity) {}
    void append(View<C> part) {
        const size_t count = std::min<size_t>(part.size(), m_capacity - m_length);
        if (count == 0) return; // an empty view may have no address
        std::memcpy(m_to + m_length, part.data(), count * sizeof(C));
        m_length += static_cast<uint32_t>(count);
    }
    void append(C c) {
        if (m_length < m_capacity) m_to[m_length++] = c;
    }
    void finish() { m_to[m_length] = 0; }
    [[nodiscard]] uint32_t length() const { return m_length; }

private:
    C* m_to;
    uint32_t m_capacity;
    uint32_t m_length = 0;
};

template <class C> bool overlaps(const C* to, uint32_t capacity, View<C> operand) {
    if (operand.empty()) return false; // it may have no address
    const std::less<const C*> before;
    return before(operand.data(), to + capacity + 1) && before(to, operand.data() + operand.size() + 1);
}

/// Builds the result in place, or beside it where it would overwrite an operand before that is read.
template <class C, class Build>
void produce(C* to, uint32_t capacity, std::initializer_list<View<C>> operands, Build build) {
    bool isApart = true;
    for (const View<C>& operand : operands) isApart = isApart && !overlaps(to, capacity, operand);
    if (isApart) {
        Output<C> out(to, capacity);
        build(out);
        return out.finish();
    }
    constexpr uint32_t kSmall = 1'000;
    std::array<C, kSmall + 1> small;
    std::basic_string<C> large;
    if (capacity > kSmall) large.resize(capacity + 1);
    C* scratch = capacity > kSmall ? large.data() : small.data();
    Output<C> out(scratch, capacity);
    build(out);
    out.finish();
    std::memcpy(to, scratch, (out.length() + 1) * sizeof(C));
}

template <class C> void assign(C* to, uint32_t toCapacity, const C* from, uint32_t fromCapacity) {
    const uint32_t length = std::min(lengthOf(from, fromCapacity), toCapacity);
    std::memmove(to, from, length * sizeof(C));
    to[length] = 0;
}

template <class C> void append(C* to, uint32_t toCapacity, const C* from, uint32_t fromCapacity) {
    const uint32_t begin = lengthOf(to, toCapacity);
    const uint32_t length = std::min(lengthOf(from, fromCapacity), toCapacity - begin);
    std::memmove(to + begin, from, length * sizeof(C));
    to[begin + length] = 0;
}

template <class C> int32_t compare(View<C> a, View<C> b) {
    const int order = a.compare(b); // char_traits<char> compares unsigned
    return order < 0 ? -1 : order > 0 ? 1 : 0;
}

template <class C> uint8_t left(C* to, uint32_t capacity, View<C> text, int64_t count) {
    produce<C>(to, capacity, {text}, [&](Output<C>& out) {
        if (count > 0) out.append(text.substr(0, static_cast<size_t>(count)));
    });
    return count >= 0;
}

template <class C> uint8_t right(C* to, uint32_t capacity, View<C> text, int64_t count) {
    produce<C>(to, capacity, {text}, [&](Output<C>& out) {
        if (count > 0)
            out.append(text.substr(text.size() - std::min<uint64_t>(text.size(), static_cast<uint64_t>(count))));
    });
    return count >= 0;
}

/// Where a position from 1 lies, as an index that is at most the length; `isInside` is false beyond `last`.
struct Spot {
    bool isPossible = true;
    bool isInside = true;
    size_t index = 0;
};
Spot spotOf(int64_t position, int64_t length, size_t size, size_t last) {
    if (position < 1 || length < 0) return {false, false, 0};
    const auto index = static_cast<uint64_t>(position) - 1;
    return {true, index <= last, static_cast<size_t>(std::min<uint64_t>(index, size))};
}

template <class C> uint8_t mid(C* to, uint32_t capacity, View<C> text, int64_t length, int64_t position) {
    const Spot spot = spotOf(position, length, text.size(), text.empty() ? 0 : text.size() - 1);
    produce<C>(to, capacity, {text}, [&](Output<C>& out) {
        if (spot.isPossible) out.append(text.substr(spot.index, static_cast<size_t>(length)));
    });
    return spot.isInside;
}

template <class C> uint8_t insert(C* to, uint32_t capacity, View<C> a, View<C> b, int64_t position) {
    const bool isPossible = position >= 0;
    const bool isInside = isPossible && static_cast<uint64_t>(position) <= a.size();
    const size_t at = isInside ? static_cast<size_t>(position) : a.size();
    produce<C>(to, capacity, {a, b}, [&](Output<C>& out) {
        if (!isPossible) return;
        out.append(a.substr(0, at));
        out.append(b);
        out.append(a.substr(at));
    });
    return isInside;
}

template <class C>
uint8_t replace(C* to, uint32_t capacity, View<C> a, View<C> b, int64_t length, int64_t position, size_t last) {
    const Spot spot = spotOf(position, length, a.size(), last);
    produce<C>(to, capacity, {a, b}, [&](Output<C>& out) {
        if (!spot.isPossible) return;
        out.append(a.substr(0, spot.index));
        out.append(b);
        const uint64_t cut = std::min<uint64_t>(static_cast<uint64_t>(length), a.size() - spot.index);
        out.append(a.substr(spot.index + static_cast<size_t>(cut)));
    });
    return spot.isInside;
}

/// Knuth, Morris and Pratt: no longer than both texts together, whatever they hold.
template <class C> size_t findInLong(View<C> a, View<C> b) {
    std::vector<uint32_t> matched(b.size(), 0); // characters of b that are known to stand before a mismatch
    for (uint32_t i = 1, known = 0; i < b.size(); ++i) {
        while (known > 0 && b[i] != b[known]) known = matched[known - 1];
        matched[i] = known += b[i] == b[known] ? 1 : 0;
    }
    for (size_t i = 0, known = 0; i < a.size(); ++i) {
        while (known > 0 && a[i] != b[known]) known = matched[known - 1];
        if (a[i] == b[known]) ++known;
        if (known == b.size()) return i + 1 - known;
    }
    return View<C>::npos;
}

template <class C> uint32_t find(View<C> a, View<C> b) {
    constexpr size_t kShort = 1 << 16; // comparisons at the worst
    if (b.empty() || b.size() > a.size()) return 0;
    const size_t at = a.size() * b.size() <= kShort ? a.find(b) : findInLong(a, b);
    return at == View<C>::npos ? 0 : static_cast<uint32_t>(at + 1);
}

// Letters with a counterpart in the same character set.
char16_t upperOf(char16_t c, bool isWide) {
    if (isWide) return types::upperCharacter(c);
    if (c >= 'a' && c <= 'z') return static_cast<char16_t>(c - 32);
    return c >= 0xE0 && c <= 0xFE && c != 0xF7 ? static_cast<char16_t>(c - 32) : c;
}
char16_t lowerOf(char16_t c, bool isWide) {
    if (isWide) return types::lowerCharacter(c);
    if (c >= 'A' && c <= 'Z') return static_cast<char16_t>(c + 32);
    return c >= 0xC0 && c <= 0xDE && c != 0xD7 ? static_cast<char16_t>(c + 32) : c;
}

template <class C, class Map> void mapped(C* to, uint32_t capacity, View<C> text, Map map) {
    produce<C>(to, capacity, {text}, [&](Output<C>& out) {
        for (const C c : text)
            out.append(
                static_cast<C>(map(static_cast<char16_t>(static_cast<std::make_unsigned_t<C>>(c)), sizeof(C) == 2)));
    });
}

template <class C> void trim(C* to, uint32_t capacity, View<C> text) {
    const auto isBlank = [](C c) { return c == ' ' || c == '\t'; };
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    produce<C>(to, capacity, {text}, [&](Output<C>& out) { out.append(text); });
}

template <class C> void fromAscii(C* to, uint32_t capacity, std::string_view text) {
    Output<C> out(to, capacity);
    for (const char c : text) out.append(static_cast<C>(c));
    out.finish();
}

/// The begin of a text as ASCII: enough for any number; what is not Latin-1 becomes '?', which ends a number.
struct Ascii {
    std::array<char, 512> data;
    size_t size = 0;
    template <class C> explicit Ascii(View<C> text) {
        while (size < text.size() && size < data.size()) {
            const auto c = static_cast<std::make_unsigned_t<C>>(text[size]);
            data[size++] = c > 0xFF ? '?' : static_cast<char>(c);
        }
    }
    [[nodiscard]] std::string_view view() const { return {data.data(), size}; }
};

template <class C> int64_t toInteger(View<C> text, uint32_t kind, uint8_t* ok) {
    const auto target = static_cast<TypeKind>(kind);
    if (sizeof(C) == 2 && target == TypeKind::Wchar) {
        *ok = !text.empty();
        return text.empty() ? 0 : static_cast<int64_t>(static_cast<std::make_unsigned_t<C>>(text.front()));
    }
    const auto number = types::integerFromText(target, Ascii(text).view());
    *ok = number.has_value();
    return number.value_or(0);
}

template <class C> double toReal(View<C> text, uint32_t kind, uint8_t* ok) {
    const auto number = types::realFromText(static_cast<TypeKind>(kind), Ascii(text).view());
    *ok = number.has_value();
    return number.value_or(0);
}

constexpr int64_t kMillisecond = 1'000'000;
constexpr int64_t kDay = 86'400'000 * kMillisecond;

int64_t dayOf(int64_t nanoseconds) { return nanoseconds / kDay - (nanoseconds % kDay < 0 ? 1 : 0); }

} // namespace
} // namespace plc::library

namespace lib = plc::library;

#define PLC_DEFINE_TEXT_FUNCTIONS(Prefix, C)                                                                           \
    uint32_t Prefix##_length(const C* text, uint32_t capacity) { return lib::lengthOf(text, capacity); }               \
    void Prefix##_assign(C* to, uint32_t toCapacity, const C* from, uint32_t fromCapacity) {                           \
        lib::assign(to, toCapacity, from, fromCapacity);                                                               \
    }                                                                                                                  \
    void Prefix##_append(C* to, uint32_t toCapacity, const C* from, uint32_t fromCapacity) {                           \
        lib::append(to, toCapacity, from, fromCapacity);                                                               \
    }                                                                                                                  \
    int32_t Prefix##_compare(const C* a, uint32_t aCapacity, const C* b, uint32_t bCapacity) {                         \
        return lib::compare(lib::viewOf(a, aCapacity), lib::viewOf(b, bCapacity));                                     \
    }                                                                                                                  \
    uint8_t Prefix##_left(C* to, uint32_t toCapacity, const C* text, uint32_t capacity, int64_t count) {               \
        return lib::left(to, toCapacity, lib::viewOf(text, capacity), count);                                          \
    }                                                                                                                  \
    uint8_t Prefix##_right(C* to, uint32_t toCapacity, const C* text, uint32_t capacity, int64_t count) {              \
        return lib::right(to, toCapacity, lib::viewOf(text, capacity), count);                                         \
    }                                                                                                                  \
    uint8_t Prefix##_mid(C* to, uint32_t toCapacity, const C* text, uint32_t capacity, int64_t length,                 \
                         int64_t position) {                                                                           \
        return lib::mid(to, toCapacity, lib::viewOf(text, capacity), length, position);                                \
    }                                                                                                                  \
    uint8_t Prefix##_insert(C* to, uint32_t toCapacity, const C* a, uint32_t aCapacity, const C* b,                    \
                            uint32_t bCapacity, int64_t position) {                                                    \
        return lib::insert(to, toCapacity, lib::viewOf(a, aCapacity), lib::viewOf(b, bCapacity), position);            \
    }                                                                                                                  \
    uint8_t Prefix##_delete(C* to, uint32_t toCapacity, const C* text, uint32_t capacity, int64_t length,              \
                            int64_t position) {                                                                        \
        const auto view = lib::viewOf(text, capacity);                                                                 \
        return lib::replace(to, toCapacity, view, {}, length, position, view.empty() ? 0 : view.size() - 1);           \
    }                                                                                                                  \
    uint8_t Prefix##_replace(C* to, uint32_t toCapacity, const C* a, uint32_t aCapacity, const C* b,                   \
                             uint32_t bCapacity, int64_t length, int64_t position) {                                   \
        const auto view = lib::viewOf(a, aCapacity);                                                                   \
        return lib::replace(to, toCapacity, view, lib::viewOf(b, bCapacity), length, position, view.size());           \
    }                                                                                                                  \
    uint32_t Prefix##_find(const C* a, uint32_t aCapacity, const C* b, uint32_t bCapacity) {                           \
        return lib::find(lib::viewOf(a, aCapacity), lib::viewOf(b, bCapacity));                                        \
    }                                                                                                                  \
    void Prefix##_upper(C* to, uint32_t toCapacity, const C* text, uint32_t capacity) {                                \
        lib::mapped(to, toCapacity, lib::viewOf(text, capacity), lib::upperOf);                                        \
    }                                                                                                                  \
    void Prefix##_lower(C* to, uint32_t toCapacity, const C* text, uint32_t capacity) {                                \
        lib::mapped(to, toCapacity, lib::viewOf(text, capacity), lib::lowerOf);                                        \
    }                                                                                                                  \
    void Prefix##_trim(C* to, uint32_t toCapacity, const C* text, uint32_t capacity) {                                 \
        lib::trim(to, toCapacity, lib::viewOf(text, capacity));                                                        \
    }                                                                                                                  \
    uint8_t Prefix##_is_number(const C* text, uint32_t capacity) {                                                     \
        return plc::types::isNumberText(lib::Ascii(lib::viewOf(text, capacity)).view());                               \
    }                                                                                                                  \
    void Prefix##_from_character(C* to, uint32_t toCapacity, uint32_t code) {                                          \
        to[0] = toCapacity > 0 ? static_cast<C>(code) : static_cast<C>(0);                                             \
        if (to[0] != 0) to[1] = 0;                                                                                     \
    }                                                                                                                  \
    void Prefix##_from_integer(C* to, uint32_t toCapacity, uint32_t kind, int64_t value) {                             \
        lib::fromAscii(to, toCapacity, plc::types::scalarText(static_cast<plc::types::TypeKind>(kind), value).view()); \
    }                                                                                                                  \
    void Prefix##_from_real(C* to, uint32_t toCapacity, uint32_t kind, double value) {                                 \
        lib::fromAscii(to, toCapacity, plc::types::realText(static_cast<plc::types::TypeKind>(kind), value).view());   \
    }                                                                                                                  \
    int64_t Prefix##_to_integer(const C* text, uint32_t capacity, uint32_t kind, uint8_t* ok) {                        \
        return lib::toInteger(lib::viewOf(text, capacity), kind, ok);                                                  \
    }                                                                                                                  \
    double Prefix##_to_real(const C* text, uint32_t capacity, uint32_t kind, uint8_t* ok) {                            \
        return lib::toReal(lib::viewOf(text, capacity), kind, ok);                                                     \
    }

extern "C" {
PLC_DEFINE_TEXT_FUNCTIONS(plc_text, char)
PLC_DEFINE_TEXT_FUNCTIONS(plc_wtext, char16_t)

void plc_text_to_wide(char16_t* to, uint32_t toCapacity, const char* from, uint32_t fromCapacity) {
    lib::Output<char16_t> out(to, toCapacity);
    for (const char c : lib::viewOf(from, fromCapacity))
        out.append(static_cast<char16_t>(static_cast<unsigned char>(c)));
    out.finish();
}

uint8_t plc_wtext_to_narrow(char* to, uint32_t toCapacity, const char16_t* from, uint32_t fromCapacity) {
    lib::Output<char> out(to, toCapacity);
    bool isWhole = true;
    for (const char16_t c : lib::viewOf(from, fromCapacity)) {
        isWhole = isWhole && c <= 0xFF;
        out.append(c > 0xFF ? '?' : static_cast<char>(c));
    }
    out.finish();
    return isWhole;
}

void plc_text_to_wide_by(char16_t* to, uint32_t toCapacity, const char* from, uint32_t fromCapacity, uint32_t code) {
    lib::Output<char16_t> out(to, toCapacity);
    const lib::View<char> text = lib::viewOf(from, fromCapacity);
    for (size_t at = 0; at < text.size();) {
        char32_t c = plc::types::characterAt(static_cast<plc::types::StringCode>(code), text, at);
        if (c >= plc::types::kRawByte) c -= plc::types::kRawByte;
        if (c > 0xFFFF) {
            if (out.length() + 2 > toCapacity) break; // no half of a character
            out.append(static_cast<char16_t>(0xD800 + ((c - 0x10000) >> 10)));
            c = 0xDC00 + ((c - 0x10000) & 0x3FF);
        }
        out.append(static_cast<char16_t>(c));
    }
    out.finish();
}

uint8_t plc_wtext_to_narrow_by(char* to, uint32_t toCapacity, const char16_t* from, uint32_t fromCapacity,
                               uint32_t code) {
    lib::Output<char> out(to, toCapacity);
    bool isWhole = true;
    const lib::View<char16_t> text = lib::viewOf(from, fromCapacity);
    for (size_t at = 0; at < text.size(); ++at) {
        char32_t c = text[at];
        if (c >= 0xD800 && c < 0xDC00 && at + 1 < text.size() && (text[at + 1] & 0xFC00) == 0xDC00)
            c = 0x10000 + ((c - 0xD800) << 10) + (text[++at] - 0xDC00u);
        const plc::types::CharacterBytes bytes =
            plc::types::bytesOfCharacter(static_cast<plc::types::StringCode>(code), c);
        isWhole = isWhole && bytes.size > 0;
        if (bytes.size == 0) {
            out.append('?');
            continue;
        }
        if (out.length() + bytes.size > toCapacity) break;
        out.append(lib::View<char>(bytes.data, bytes.size));
    }
    out.finish();
    return isWhole;
}

uint32_t plc_char_to_wide_by(uint32_t character, uint32_t code) {
    return plc::types::wideOfCharacter(static_cast<plc::types::StringCode>(code),
                                       static_cast<unsigned char>(character));
}
int32_t plc_wchar_to_narrow_by(uint32_t character, uint32_t code) {
    const auto made =
        plc::types::characterOfWide(static_cast<plc::types::StringCode>(code), static_cast<char16_t>(character));
    return made ? *made : -1;
}

void plc_text_upper_by(char* to, uint32_t toCapacity, const char* text, uint32_t capacity, uint32_t code) {
    const lib::View<char> from = lib::viewOf(text, capacity);
    lib::produce<char>(to, toCapacity, {from}, [&](lib::Output<char>& out) {
        for (const char c : from) out.append(plc::types::upperLetter(static_cast<plc::types::StringCode>(code), c));
    });
}
void plc_text_lower_by(char* to, uint32_t toCapacity, const char* text, uint32_t capacity, uint32_t code) {
    const lib::View<char> from = lib::viewOf(text, capacity);
    lib::produce<char>(to, toCapacity, {from}, [&](lib::Output<char>& out) {
        for (const char c : from) out.append(plc::types::lowerLetter(static_cast<plc::types::StringCode>(code), c));
    });
}

int64_t plc_date_part(int64_t nanoseconds, int64_t which) {
    const int64_t day = lib::dayOf(nanoseconds);
    if (which == 3) return ((day + 4) % 7 + 7) % 7; // 1970-01-01 was a Thursday
    const plc::types::CivilDate date = plc::types::civilFromDays(day);
    return which == 0 ? date.year : which == 1 ? date.month : date.day;
}

int64_t plc_time_part(int64_t nanoseconds, int64_t which) {
    const int64_t milliseconds = (nanoseconds % lib::kDay + lib::kDay) % lib::kDay /
                                 lib::kMillisecond; // the oldest midnight is no number of 64 bits
    switch (which) {
    case 0:
        return milliseconds / 3'600'000;
    case 1:
        return milliseconds / 60'000 % 60;
    case 2:
        return milliseconds / 1'000 % 60;
    default:
        return milliseconds % 1'000;
    }
}

int64_t plc_concat_date(int64_t year, int64_t month, int64_t day, uint8_t* ok) {
    *ok = year >= 1678 && year <= 2261 && month >= 1 && month <= 12 && day >= 1 && day <= 31 &&
          plc::types::isValidDate({static_cast<int>(year), static_cast<int>(month), static_cast<int>(day)});
    if (!*ok) return 0;
    return plc::types::daysFromCivil({static_cast<int>(year), static_cast<int>(month), static_cast<int>(day)}) *
           lib::kDay;
}

int64_t plc_concat_tod(int64_t hour, int64_t minute, int64_t second, int64_t millisecond, uint8_t* ok) {
    const auto isWithin = [](int64_t value, int64_t limit) { return value >= 0 && value < limit; };
    *ok = isWithin(hour, 24) && isWithin(minute, 60) && isWithin(second, 60) && isWithin(millisecond, 1'000);
    return *ok ? (((hour * 60 + minute) * 60 + second) * 1'000 + millisecond) * lib::kMillisecond : 0;
}

int64_t plc_concat_dt(int64_t year, int64_t month, int64_t day, int64_t hour, int64_t minute, int64_t second,
                      int64_t millisecond, uint8_t* ok) {
    uint8_t isDate = 0, isTime = 0;
    const int64_t date = plc_concat_date(year, month, day, &isDate);
    const int64_t time = plc_concat_tod(hour, minute, second, millisecond, &isTime);
    *ok = isDate && isTime;
    return *ok ? date + time : 0;
}

uint8_t plc_is_valid_bcd(uint64_t digits) {
    for (; digits != 0; digits >>= 4)
        if ((digits & 15) > 9) return 0;
    return 1;
}

int64_t plc_bcd_to_integer(uint64_t digits, uint32_t kind, uint8_t* ok) {
    uint64_t value = 0;
    for (int shift = 60; shift >= 0; shift -= 4) value = value * 10 + ((digits >> shift) & 15);
    *ok = plc_is_valid_bcd(digits) &&
          value <= plc::types::TypeTable::integerRange(static_cast<plc::types::TypeKind>(kind)).second;
    return *ok ? static_cast<int64_t>(value) : 0;
}

int64_t plc_integer_to_bcd(int64_t value, uint32_t fromKind, uint32_t toKind, uint8_t* ok) {
    using plc::types::Family;
    const bool isNegative =
        value < 0 && plc::types::familyOf(static_cast<plc::types::TypeKind>(fromKind)) == Family::Signed;
    auto rest = static_cast<uint64_t>(value);
    const unsigned bits = plc::types::bitsOf(static_cast<plc::types::TypeKind>(toKind));
    uint64_t digits = 0;
    for (unsigned shift = 0; shift < bits; shift += 4, rest /= 10) digits |= (rest % 10) << shift;
    *ok = !isNegative && rest == 0;
    return *ok ? static_cast<int64_t>(digits) : 0;
}

int64_t plc_power_integer(int64_t base, int64_t exponent) {
    if (exponent < 0) return base == 1 ? 1 : base == -1 ? (exponent % 2 == 0 ? 1 : -1) : 0;
    uint64_t result = 1, square = static_cast<uint64_t>(base);
    for (auto rest = static_cast<uint64_t>(exponent); rest != 0; rest >>= 1, square *= square)
        if (rest & 1) result *= square;
    return static_cast<int64_t>(result);
}

int64_t plc_multiply_duration(int64_t nanoseconds, double factor) {
    return plc::types::roundToInteger(plc::types::TypeKind::Lint, static_cast<double>(nanoseconds) * factor);
}

int64_t plc_divide_duration(int64_t nanoseconds, double divisor) {
    return plc::types::roundToInteger(plc::types::TypeKind::Lint, static_cast<double>(nanoseconds) / divisor);
}

int64_t plc_real_to_time(double value, uint32_t kind) {
    return plc::types::timeFromReal(static_cast<plc::types::TypeKind>(kind), value);
}
} // extern "C"

namespace plc::library {

std::span<const RuntimeSymbol> runtimeSymbols() {
#define PLC_SYMBOL(Name)                                                                                               \
    RuntimeSymbol { #Name, reinterpret_cast < void*>(&Name) }
#define PLC_TEXT_SYMBOLS(Prefix)                                                                                       \
    PLC_SYMBOL(Prefix##_length), PLC_SYMBOL(Prefix##_assign), PLC_SYMBOL(Prefix##_append),                             \
        PLC_SYMBOL(Prefix##_compare), PLC_SYMBOL(Prefix##_left), PLC_SYMBOL(Prefix##_right), PLC_SYMBOL(Prefix##_mid), \
        PLC_SYMBOL(Prefix##_insert), PLC_SYMBOL(Prefix##_delete), PLC_SYMBOL(Prefix##_replace),                        \
        PLC_SYMBOL(Prefix##_find), PLC_SYMBOL(Prefix##_upper), PLC_SYMBOL(Prefix##_lower), PLC_SYMBOL(Prefix##_trim),  \
        PLC_SYMBOL(Prefix##_is_number), PLC_SYMBOL(Prefix##_from_character), PLC_SYMBOL(Prefix##_from_integer),        \
        PLC_SYMBOL(Prefix##_from_real), PLC_SYMBOL(Prefix##_to_integer), PLC_SYMBOL(Prefix##_to_real)
    static const RuntimeSymbol symbols[] = {
        PLC_TEXT_SYMBOLS(plc_text),         PLC_TEXT_SYMBOLS(plc_wtext),       PLC_SYMBOL(plc_text_to_wide),
        PLC_SYMBOL(plc_wtext_to_narrow),    PLC_SYMBOL(plc_date_part),         PLC_SYMBOL(plc_time_part),
        PLC_SYMBOL(plc_concat_date),        PLC_SYMBOL(plc_concat_tod),        PLC_SYMBOL(plc_concat_dt),
        PLC_SYMBOL(plc_bcd_to_integer),     PLC_SYMBOL(plc_integer_to_bcd),    PLC_SYMBOL(plc_is_valid_bcd),
        PLC_SYMBOL(plc_power_integer),      PLC_SYMBOL(plc_multiply_duration), PLC_SYMBOL(plc_divide_duration),
        PLC_SYMBOL(plc_real_to_time),       PLC_SYMBOL(plc_text_to_wide_by),   PLC_SYMBOL(plc_wtext_to_narrow_by),
        PLC_SYMBOL(plc_text_upper_by),      PLC_SYMBOL(plc_text_lower_by),     PLC_SYMBOL(plc_char_to_wide_by),
        PLC_SYMBOL(plc_wchar_to_narrow_by),
    };
#undef PLC_TEXT_SYMBOLS
#undef PLC_SYMBOL
    return symbols;
}

} // namespace plc::library
