#include "runtime/compiler/lex/literal_prefix.h"

#include "runtime/base/text.h"

namespace plc::lex {

PrefixKind prefixKind(std::string_view word) {
    struct Row {
        std::string_view word;
        PrefixKind kind;
    };
    static constexpr Row rows[] = {
        {"T", PrefixKind::Duration},
        {"TIME", PrefixKind::Duration},
        {"LT", PrefixKind::Duration},
        {"LTIME", PrefixKind::Duration},
        {"D", PrefixKind::Date},
        {"DATE", PrefixKind::Date},
        {"LD", PrefixKind::Date},
        {"LDATE", PrefixKind::Date},
        {"TOD", PrefixKind::TimeOfDay},
        {"LTOD", PrefixKind::TimeOfDay},
        {"TIME_OF_DAY", PrefixKind::TimeOfDay},
        {"DT", PrefixKind::DateTime},
        {"LTIME_OF_DAY", PrefixKind::TimeOfDay},
        {"DATE_AND_TIME", PrefixKind::DateTime},
        {"LDT", PrefixKind::DateTime},
        {"LDATE_AND_TIME", PrefixKind::DateTime},
        {"C", PrefixKind::Bcd},
    };
    for (const Row& row : rows)
        if (word.size() == row.word.size() && equalsIgnoringCase(word, row.word)) return row.kind;
    return PrefixKind::Type;
}

} // namespace plc::lex
