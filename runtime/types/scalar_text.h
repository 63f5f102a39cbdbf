// Scalars as text and back without allocating, for conversions inside a scan (X_TO_STRING, STRING_TO_X). Pure
// functions, any thread.
#pragma once
#include "runtime/types/type.h"

#include <optional>
#include <string_view>

namespace plc::types {

/// Long enough for any scalar.
struct ScalarText {
    char data[64];
    uint32_t size = 0;
    void append(std::string_view text);
    void append(int64_t number, unsigned minimumDigits = 1);
    [[nodiscard]] std::string_view view() const { return {data, size}; }
};

/// BOOL, integers, bit strings (decimal), times and dates, as X_TO_STRING gives them.
[[nodiscard]] ScalarText scalarText(TypeKind kind, int64_t value);
/// The shortest text that reads back as the same REAL or LREAL.
[[nodiscard]] ScalarText realText(TypeKind kind, double value);
/// STRING_TO_X: leading blanks do not count; a number may be followed by other text; none where the text has no meaning
/// in `kind`.
[[nodiscard]] std::optional<int64_t> integerFromText(TypeKind kind, std::string_view text);
[[nodiscard]] std::optional<double> realFromText(TypeKind kind, std::string_view text);
/// The whole of it (blanks at the ends aside) is one integer or real number.
[[nodiscard]] bool isNumberText(std::string_view text);

/// The character that `$` and `c` stand for in a string (IEC 61131-3, table 6): line ends, page, tab, the quotes and
/// `$` itself; not the forms of hexadecimal digits.
[[nodiscard]] std::optional<char32_t> escapedCharacter(char c);

} // namespace plc::types
