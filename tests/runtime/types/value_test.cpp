#include "runtime/types/value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

using namespace plc::types;

namespace {

TypeId of(TypeKind kind) { return TypeTable::of(kind); }

struct Types {
    TypeTable table;
    TypeId color = table.declare(TypeKind::Enum, "Color");
    TypeId point = table.declare(TypeKind::Struct, "Point");
    TypeId flags = table.declare(TypeKind::Struct, "Flags");
    TypeId matrix;
    Types() {
        Type& colors = table.edit(color);
        colors.element = of(TypeKind::Int);
        colors.size = colors.align = 2;
        colors.enumerators = {{"Red", 0, {}, {}}, {"Green", 5, {}, {}}, {"Blue", -1, {}, {}}};
        Type& points = table.edit(point);
        points.fields.resize(4);
        points.fields[0] = {.name = "x", .type = of(TypeKind::Int)};
        points.fields[1] = {.name = "name", .type = table.string(5)};
        points.fields[2] = {.name = "y", .type = of(TypeKind::Lreal), .aliases = {"height"}};
        points.fields[3] = {.name = "secret", .type = of(TypeKind::Byte), .isPrivate = true};
        table.layoutFields(point);
        Type& bits = table.edit(flags);
        for (const char* name : {"a", "b", "c"}) {
            Field field;
            field.name = name;
            field.type = of(TypeKind::Bool);
            field.bit = 0;
            bits.fields.push_back(field);
        }
        table.layoutFields(flags);
        matrix = table.array({{1, 2}, {0, 2}}, of(TypeKind::Int));
    }
};

std::string roundTrip(Types& t, TypeId type, const char* text) {
    const auto value = parseValue(t.table, type, text);
    if (!value) return "(refused)";
    std::vector<std::byte> bytes(t.table[type].size);
    writeValue(t.table, type, *value, bytes);
    const Value back = readValue(t.table, type, bytes);
    EXPECT_EQ(back, *value) << text;
    return toText(t.table, back);
}

} // namespace

TEST(ValueText, GoesThroughTheImageAndBack) {
    Types t;
    struct Row {
        TypeId type;
        const char* written;
        const char* shown;
    };
    for (const auto& [type, written, shown] : {
             Row{of(TypeKind::Bool), "TRUE", "TRUE"},
             Row{of(TypeKind::Bool), "false", "FALSE"},
             Row{of(TypeKind::Bool), "BOOL#1", "TRUE"},
             Row{of(TypeKind::Int), "-32768", "-32768"},
             Row{of(TypeKind::Int), "INT#16#7F", "127"},
             Row{of(TypeKind::Int), "16#FFFF", "-1"},
             Row{of(TypeKind::Int), "1_000", "1000"},
             Row{of(TypeKind::Usint), "255", "255"},
             Row{of(TypeKind::Byte), "2#1111_0000", "240"},
             Row{of(TypeKind::Ulint), "18446744073709551615", "18446744073709551615"},
             Row{of(TypeKind::Lint), "-9223372036854775808", "-9223372036854775808"},
             Row{of(TypeKind::Lword), "16#FFFF_FFFF_FFFF_FFFF", "18446744073709551615"},
             Row{of(TypeKind::Real), "1.1", "1.1"},
             Row{of(TypeKind::Real), "5", "5.0"},
             Row{of(TypeKind::Lreal), "0.1", "0.1"},
             Row{of(TypeKind::Lreal), "1E30", "1e+30"},
             Row{of(TypeKind::Lreal), "-INF", "-INF"},
             Row{of(TypeKind::Time), "T#1.5s", "T#1s500ms"},
             Row{of(TypeKind::Ltime), "LTIME#5us", "LTIME#5us"},
             Row{of(TypeKind::Date), "D#2024-2-29", "D#2024-02-29"},
             Row{of(TypeKind::Tod), "TOD#6:30", "TOD#06:30:00"},
             Row{of(TypeKind::Dt), "DT#2024-2-29-6:30:0.5", "DT#2024-02-29-06:30:00.500"},
             Row{of(TypeKind::Char), "'A'", "'A'"},
             Row{of(TypeKind::Wchar), "\"\u20AC\"", "\"\u20AC\""},
             Row{t.color, "Green", "Green"},
             Row{t.color, "Color.blue", "Blue"},
             Row{t.color, "Color#Red", "Red"},
             Row{t.color, "7", "7"},
             Row{t.table.string(10), "'it$'s $24 5'", "'it$'s $$ 5'"},
             Row{t.table.string(10), "'\u00E4\u00F6$N'", "'\u00E4\u00F6$N'"},
             Row{t.table.wstring(10), "\"\u03A9 $\"a$\"\"", "\"\u03A9 $\"a$\"\""},
             Row{t.matrix, "[1, 2, 3, 4, 5, 6]", "[1, 2, 3, 4, 5, 6]"},
             Row{t.matrix, "[2(7), 1]", "[7, 7, 1, 0, 0, 0]"},
             Row{t.point, "(x := 3, name := 'ab', height := 2.5)", "(x := 3, name := 'ab', y := 2.5)"},
             Row{t.flags, "(b := TRUE)", "(a := FALSE, b := TRUE, c := FALSE)"},
             Row{of(TypeKind::Null), "NULL", "NULL"},
         })
        EXPECT_EQ(roundTrip(t, type, written), shown) << written;
}

TEST(ValueText, WhatDoesNotFitIsRefused) {
    Types t;
    struct Row {
        TypeId type;
        const char* text;
    };
    for (const auto& [type, text] : {
             Row{of(TypeKind::Bool), "2"},
             Row{of(TypeKind::Int), "32768"},
             Row{of(TypeKind::Int), "1.5"},
             Row{of(TypeKind::Usint), "-1"},
             Row{of(TypeKind::Byte), "16#100"},
             Row{of(TypeKind::Int), "abc"},
             Row{of(TypeKind::Int), ""},
             Row{of(TypeKind::Real), "1e50"},
             Row{of(TypeKind::Real), "x"},
             Row{of(TypeKind::Time), "5"},
             Row{t.color, "Yellow"},
             Row{t.table.string(3), "'abcd'"},
             Row{t.table.string(3), "'abc"},
             Row{t.table.string(3), "abc"},
             Row{t.table.string(9), "'\u20AC'"},
             Row{t.matrix, "[1,2,3,4,5,6,7]"},
             Row{t.matrix, "[99(1)]"},
             Row{t.matrix, "1,2"},
             Row{t.point, "(z := 1)"},
             Row{t.point, "(x := 1"},
             Row{t.table.subrange(of(TypeKind::Int), 1, 5), "6"},
             Row{of(TypeKind::Int), "5 5"},
         })
        EXPECT_FALSE(parseValue(t.table, type, text)) << text;
}

TEST(ValueText, NumbersCanBeShownByTheirBits) {
    Types t;
    EXPECT_EQ(toText(t.table, {of(TypeKind::Word), int64_t{255}}, NumberFormat::Hex), "16#00FF");
    EXPECT_EQ(toText(t.table, {of(TypeKind::Sint), int64_t{-1}}, NumberFormat::Hex), "16#FF");
    EXPECT_EQ(toText(t.table, {of(TypeKind::Byte), int64_t{5}}, NumberFormat::Binary), "2#00000101");
    EXPECT_EQ(toText(t.table, {of(TypeKind::Bool), int64_t{1}}, NumberFormat::Hex), "TRUE");
    EXPECT_EQ(toText(t.table, {t.color, int64_t{5}}, NumberFormat::Hex), "Green");
}

TEST(ValueJson, UsesItsOwnKindsWhereTheyAreExact) {
    Types t;
    EXPECT_EQ(toJson(t.table, {of(TypeKind::Bool), int64_t{1}}), "true");
    EXPECT_EQ(toJson(t.table, {of(TypeKind::Int), int64_t{-5}}), "-5");
    EXPECT_EQ(toJson(t.table, {of(TypeKind::Lint), int64_t{1} << 53}), "9007199254740992");
    EXPECT_EQ(toJson(t.table, {of(TypeKind::Lint), (int64_t{1} << 53) + 1}), "\"9007199254740993\"");
    EXPECT_EQ(toJson(t.table, {of(TypeKind::Ulint), int64_t{-1}}), "\"18446744073709551615\"");
    EXPECT_EQ(toJson(t.table, {of(TypeKind::Lreal), 0.1}), "0.1");
    EXPECT_EQ(toJson(t.table, {of(TypeKind::Real), static_cast<double>(0.1f)}), "0.1");
    EXPECT_EQ(toJson(t.table, {of(TypeKind::Lreal), std::nan("")}), "\"NaN\"");
    EXPECT_EQ(toJson(t.table, {of(TypeKind::Lreal), -HUGE_VAL}), "\"-INF\"");
    EXPECT_EQ(toJson(t.table, {of(TypeKind::Time), int64_t{1'500'000'000}}), "\"T#1s500ms\"");
    EXPECT_EQ(toJson(t.table, {t.color, int64_t{5}}), "\"Green\"");
    EXPECT_EQ(toJson(t.table, {t.table.string(9), std::string("a\"\\\n\xE4")}), "\"a\\\"\\\\\\u000a\u00E4\"");
    EXPECT_EQ(toJson(t.table, *parseValue(t.table, t.matrix, "[1,2,3,4,5,6]")), "[[1,2,3],[4,5,6]]");
    EXPECT_EQ(toJson(t.table, *parseValue(t.table, t.point, "(x:=1,name:='a')")), "{\"x\":1,\"name\":\"a\",\"y\":0.0}");
}

TEST(Value, ABitIsReadAndWrittenAlone) {
    Types t;
    std::byte bytes[] = {std::byte{0b1010'0101}};
    EXPECT_TRUE(readValue(t.table, of(TypeKind::Bool), bytes, 0).isTrue());
    EXPECT_FALSE(readValue(t.table, of(TypeKind::Bool), bytes, 1).isTrue());
    writeValue(t.table, of(TypeKind::Bool), {of(TypeKind::Bool), int64_t{1}}, bytes, 1);
    writeValue(t.table, of(TypeKind::Bool), {of(TypeKind::Bool), int64_t{0}}, bytes, 7);
    EXPECT_EQ(bytes[0], std::byte{0b0010'0111});
}

TEST(Value, ATextIsCutToItsCapacity) {
    Types t;
    const TypeId type = t.table.string(3);
    std::byte bytes[] = {std::byte{1}, std::byte{1}, std::byte{1}, std::byte{1}, std::byte{9}};
    writeValue(t.table, type, {type, std::string("abcdef")}, bytes);
    EXPECT_EQ(std::get<std::string>(readValue(t.table, type, bytes).data), "abc");
    EXPECT_EQ(bytes[4], std::byte{9}) << "the byte behind the text belongs to somebody else";
}

TEST(Value, ATextWithoutAnEndIsReadToItsCapacity) {
    Types t;
    const TypeId type = t.table.string(3);
    std::byte bytes[4];
    std::memset(bytes, 'x', sizeof bytes);
    EXPECT_EQ(std::get<std::string>(readValue(t.table, type, bytes).data), "xxx");
}
