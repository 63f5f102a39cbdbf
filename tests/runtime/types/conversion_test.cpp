#include "runtime/types/conversion.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace plc::types;
using enum plc::types::TypeKind;

namespace {

TypeId of(TypeKind kind) { return TypeTable::of(kind); }

/// "INT 5" → "REAL 5.0": both sides as type and text.
struct Row {
    TypeKind from;
    const char* text;
    TypeKind to;
    const char* expected; // a leading '!' = ENO FALSE
};

struct Conversions : testing::Test {
    TypeTable table;
    TypeId string = table.string(80), wstring = table.wstring(80);
    TypeId typeOf(TypeKind kind) const { return kind == String ? string : kind == Wstring ? wstring : of(kind); }
    void expectAll(std::initializer_list<Row> rows) const {
        for (const Row& row : rows) {
            const auto value = parseValue(table, typeOf(row.from), row.text);
            ASSERT_TRUE(value) << spelling(row.from) << " " << row.text;
            bool ok = false;
            const Value result = convert(table, *value, typeOf(row.to), &ok);
            EXPECT_EQ((ok ? "" : "!") + toText(table, result), row.expected)
                << spelling(row.from) << " " << row.text << " to " << table[typeOf(row.to)].name;
            EXPECT_EQ(result.type, typeOf(row.to));
        }
    }
};

} // namespace

TEST_F(Conversions, IntegersWrap) {
    expectAll({{Dint, "65536", Int, "0"},
               {Dint, "40000", Int, "-25536"},
               {Int, "-1", Uint, "65535"},
               {Int, "-1", Ulint, "18446744073709551615"},
               {Uint, "65535", Int, "-1"},
               {Usint, "200", Sint, "-56"},
               {Lword, "16#FFFFFFFFFFFFFFFF", Dword, "4294967295"},
               {Byte, "255", Lint, "255"},
               {Int, "0", Bool, "FALSE"},
               {Int, "256", Bool, "TRUE"},
               {Bool, "TRUE", Dword, "1"},
               {Int, "321", Char, "'A'"},
               {Char, "'A'", Int, "65"}});
}

TEST_F(Conversions, RealsRoundToEvenAndSaturate) {
    expectAll({{Real, "0.5", Int, "0"},
               {Real, "1.5", Int, "2"},
               {Real, "2.5", Int, "2"},
               {Real, "-1.5", Int, "-2"},
               {Real, "-0.5", Int, "0"},
               {Real, "1e10", Int, "32767"},
               {Real, "-1e10", Int, "-32768"},
               {Lreal, "1e30", Lint, "9223372036854775807"},
               {Lreal, "-1e30", Lint, "-9223372036854775808"},
               {Lreal, "1e30", Ulint, "18446744073709551615"},
               {Real, "-1", Uint, "0"},
               {Lreal, "NaN", Dint, "0"},
               {Lreal, "INF", Dint, "2147483647"},
               {Lreal, "4294967295.4", Udint, "4294967295"},
               {Real, "0.2", Bool, "TRUE"},
               {Real, "0", Bool, "FALSE"},
               {Lreal, "0.1", Real, "0.1"},
               {Lreal, "1e300", Real, "INF"},
               {Dint, "16777217", Real, "16777216.0"},
               {Dint, "16777217", Lreal, "16777217.0"},
               {Ulint, "18446744073709551615", Lreal, "18446744073709551616.0"}});
}

TEST_F(Conversions, TruncationCuts) {
    for (const auto& [value, expected] : {std::pair{3.9, 3}, {-2.5, -2}, {0.9, 0}, {1e10, 32767}, {-1e10, -32768}})
        EXPECT_EQ(truncate(table, {of(Lreal), value}, of(Int)).integer(), expected) << value;
    EXPECT_EQ(truncate(table, {of(Lreal), std::nan("")}, of(Int)).integer(), 0);
}

TEST_F(Conversions, TimesCountMilliseconds) {
    expectAll({{Time, "T#1s500ms", Int, "1500"},
               {Time, "T#1500us", Dint, "1"},
               {Time, "T#-1500us", Dint, "-1"},
               {Time, "T#49d17h2m47s296ms", Udint, "0"},
               {Time, "T#2s", Real, "2000.0"},
               {Time, "T#1us", Bool, "TRUE"},
               {Int, "1500", Time, "T#1s500ms"},
               {Word, "65535", Time, "T#1m5s535ms"},
               {Int, "-5", Time, "T#-5ms"},
               {Real, "1500.4", Time, "T#1s500ms"},
               {Real, "1e30", Time, "T#106751d23h47m16s854ms"},
               {Bool, "TRUE", Time, "T#1ms"},
               {Ltime, "LTIME#1us", Dint, "1000"},
               {Dint, "1000", Ltime, "LTIME#1us"},
               {Time, "T#1ms", Ltime, "LTIME#1ms"},
               {Ltime, "LTIME#1ns", Time, "T#1ns"},
               {Ltime, "LTIME#1s", Lreal, "1e+09"}});
}

TEST_F(Conversions, DatesCountSecondsAndTimesOfDayMilliseconds) {
    expectAll({{Date, "D#1970-1-2", Udint, "86400"},
               {Udint, "86401", Date, "D#1970-01-02"},
               {Dt, "DT#1970-1-1-0:1:0", Dint, "60"},
               {Dint, "60", Dt, "DT#1970-01-01-00:01:00"},
               {Tod, "TOD#0:0:1.5", Udint, "1500"},
               {Udint, "86400000", Tod, "TOD#00:00:00"},
               {Ldate, "LDATE#1970-1-2", Lint, "86400000000000"},
               {Ldt, "LDT#1970-1-1-0:0:1", Lint, "1000000000"},
               {Ltod, "LTOD#0:0:1", Lint, "1000000000"},
               {Dt, "DT#2024-2-29-6:30:0", Date, "D#2024-02-29"},
               {Dt, "DT#2024-2-29-6:30:1.5", Tod, "TOD#06:30:01.500"},
               {Dt, "DT#1969-12-31-23:0:0", Date, "D#1969-12-31"},
               {Dt, "DT#1969-12-31-23:0:0", Tod, "TOD#23:00:00"},
               {Date, "D#2024-2-29", Dt, "DT#2024-02-29-00:00:00"},
               {Tod, "TOD#6:30", Time, "T#6h30m"},
               {Time, "T#30h", Tod, "TOD#06:00:00"},
               {Date, "D#2024-2-29", Tod, "TOD#00:00:00"},
               {Dt, "DT#1970-1-1-0:0:1", Real, "1.0"},
               {Real, "1.0", Dt, "DT#1970-01-01-00:00:01"}});
}

TEST_F(Conversions, TextsOfScalars) {
    expectAll({{Int, "-5", String, "'-5'"},
               {Word, "255", String, "'255'"},
               {Ulint, "18446744073709551615", String, "'18446744073709551615'"},
               {Bool, "TRUE", String, "'TRUE'"},
               {Real, "23.67", String, "'23.67'"},
               {Real, "5", String, "'5.0'"},
               {Lreal, "0.1", String, "'0.1'"},
               {Lreal, "NaN", String, "'NaN'"},
               {Time, "T#1s500ms", String, "'T#1s500ms'"},
               {Date, "D#2024-2-9", String, "'D#2024-02-09'"},
               {Tod, "TOD#1:2:3", String, "'TOD#01:02:03'"},
               {Dt, "DT#2024-2-9-1:2:3", String, "'DT#2024-02-09-01:02:03'"},
               {Char, "'A'", String, "'A'"},
               {Int, "7", Wstring, "\"7\""},
               {String, "'abc'", Wstring, "\"abc\""},
               {Wstring, "\"abc\"", String, "'abc'"},
               {Wstring, "\"a\u20AC\"", String, "!'a?'"}});
}

TEST_F(Conversions, ScalarsOfTexts) {
    expectAll({{String, "'123'", Int, "123"},
               {String, "' -5 '", Int, "-5"},
               {String, "'+5'", Int, "5"},
               {String, "'12;3'", Int, "12"},
               {String, "'3.7'", Int, "3"},
               {String, "''", Int, "!0"},
               {String, "'ABC'", Int, "!0"},
               {String, "'-'", Int, "!0"},
               {String, "'40000'", Int, "!0"},
               {String, "'-32768'", Int, "-32768"},
               {String, "'16#FF'", Int, "255"},
               {String, "'2#101'", Usint, "5"},
               {String, "'-1'", Usint, "!0"},
               {String, "'18446744073709551615'", Ulint, "18446744073709551615"},
               {String, "'99999999999999999999'", Ulint, "!0"},
               {String, "'12.45'", Real, "12.45"},
               {String, "'-1.5e3 V'", Lreal, "-1500.0"},
               {String, "'x'", Real, "!0.0"},
               {String, "'.5'", Real, "0.5"},
               {String, "'infinity'", Lreal, "!0.0"},
               {String, "'INF'", Lreal, "INF"},
               {String, "'TRUE'", Bool, "TRUE"},
               {String, "'true'", Bool, "TRUE"},
               {String, "'FALSE'", Bool, "FALSE"},
               {String, "'yes'", Bool, "!FALSE"},
               {String, "'T#1s'", Time, "T#1s"},
               {String, "'soon'", Time, "!T#0s"},
               {String, "'D#2024-02-29'", Date, "D#2024-02-29"},
               {String, "'TOD#6:30'", Tod, "TOD#06:30:00"},
               {String, "'DT#2024-02-29-06:30:00'", Dt, "DT#2024-02-29-06:30:00"},
               {String, "'AB'", Char, "'A'"},
               {String, "''", Char, "!''"},
               {Wstring, "\"123\"", Int, "123"},
               {Wstring, "\"1\u20AC\"", Int, "1"}});
}

TEST_F(Conversions, ATextIsCutToTheTarget) {
    const TypeId small = table.string(3);
    EXPECT_EQ(toText(table, convert(table, {string, std::string("abcdef")}, small)), "'abc'");
    EXPECT_EQ(toText(table, convert(table, {of(Dint), int64_t{123456}}, small)), "'123'");
}

TEST_F(Conversions, EveryPairGivesAValueOfTheTarget) {
    std::vector<TypeId> all{string, wstring};
    for (uint32_t k = 0; k <= static_cast<uint32_t>(Wchar); ++k) all.push_back(of(static_cast<TypeKind>(k)));
    for (const TypeId from : all) {
        for (const TypeId to : all) {
            const Value result = convert(table, initialValue(table, from), to);
            std::vector<std::byte> bytes(table[to].size);
            writeValue(table, to, result, bytes);
            EXPECT_EQ(toText(table, readValue(table, to, bytes)), toText(table, result))
                << table[from].name << " to " << table[to].name;
            EXPECT_EQ(result.type, to);
        }
    }
}

TEST_F(Conversions, WhichMayBeLeftUnwritten) {
    struct Case {
        TypeKind from, to;
        Implicit expected;
    };
    for (const auto& [from, to, expected] : {
             Case{Int, Int, Implicit::Same},         Case{Int, Dint, Implicit::Widening},
             Case{Dint, Int, Implicit::Narrowing},   Case{Usint, Int, Implicit::Widening},
             Case{Uint, Int, Implicit::Narrowing},   Case{Int, Uint, Implicit::Narrowing},
             Case{Byte, Usint, Implicit::Widening},  Case{Word, Uint, Implicit::Widening},
             Case{Word, Int, Implicit::Narrowing},   Case{Byte, Word, Implicit::Widening},
             Case{Word, Byte, Implicit::Narrowing},  Case{Int, Word, Implicit::Narrowing},
             Case{Int, Real, Implicit::Widening},    Case{Word, Real, Implicit::Widening},
             Case{Dint, Real, Implicit::Narrowing},  Case{Dint, Lreal, Implicit::Widening},
             Case{Lint, Lreal, Implicit::Narrowing}, Case{Real, Lreal, Implicit::Widening},
             Case{Lreal, Real, Implicit::Narrowing}, Case{Real, Int, Implicit::Narrowing},
             Case{Bool, Int, Implicit::Forbidden},   Case{Int, Bool, Implicit::Forbidden},
             Case{Real, Bool, Implicit::Forbidden},  Case{Bool, Byte, Implicit::Widening},
             Case{Time, Ltime, Implicit::Widening},  Case{Ltime, Time, Implicit::Narrowing},
             Case{Time, Dint, Implicit::Forbidden},  Case{Dint, Time, Implicit::Forbidden},
             Case{Date, Ldate, Implicit::Widening},  Case{Date, Dt, Implicit::Forbidden},
             Case{Tod, Time, Implicit::Forbidden},   Case{Char, Wchar, Implicit::Widening},
             Case{Char, Byte, Implicit::Widening},   Case{Char, Int, Implicit::Widening},
             Case{Int, Char, Implicit::Narrowing},   Case{Byte, Char, Implicit::Widening},
         })
        EXPECT_EQ(implicitConversion(table, of(from), of(to)), expected) << spelling(from) << " to " << spelling(to);
    EXPECT_EQ(implicitConversion(table, string, table.string(5)), Implicit::Widening);
    EXPECT_EQ(implicitConversion(table, of(Char), string), Implicit::Widening);
    EXPECT_EQ(implicitConversion(table, string, wstring), Implicit::Widening);
    EXPECT_EQ(implicitConversion(table, wstring, string), Implicit::Narrowing);
    EXPECT_EQ(implicitConversion(table, string, of(Int)), Implicit::Forbidden);
    EXPECT_EQ(implicitConversion(table, of(Unknown), of(Int)), Implicit::Same);
    EXPECT_EQ(implicitConversion(table, of(Null), table.pointer(of(Int))), Implicit::Widening);
    EXPECT_EQ(implicitConversion(table, table.pointer(of(Int)), table.pointer(of(Real))), Implicit::Narrowing);
    EXPECT_EQ(implicitConversion(table, table.pointer(of(Int)), of(Lword)), Implicit::Widening);
    EXPECT_EQ(implicitConversion(table, table.array({{0, 3}}, of(Int)), table.openArray(1, of(Int))), Implicit::Same);
}

TEST_F(Conversions, AnEnumIsANumberButNotTheOtherWayRound) {
    const TypeId color = table.declare(Enum, "Color");
    Type& type = table.edit(color);
    type.element = of(Int);
    type.size = type.align = 2;
    type.enumerators = {{"Red", 0, {}, {}}, {"Many", 300, {}, {}}};
    EXPECT_EQ(implicitConversion(table, color, of(Int)), Implicit::Widening);
    EXPECT_EQ(implicitConversion(table, color, of(Word)), Implicit::Widening);
    EXPECT_EQ(implicitConversion(table, color, of(Byte)), Implicit::Narrowing);
    EXPECT_EQ(implicitConversion(table, of(Int), color), Implicit::Narrowing);
    EXPECT_EQ(implicitConversion(table, of(Bool), color), Implicit::Forbidden);
    EXPECT_EQ(implicitConversion(table, color, table.declare(Enum, "Other")), Implicit::Narrowing);
}
