#include "runtime/library/evaluate.h"
#include "runtime/types/conversion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

using namespace plc;
using namespace plc::library;
using namespace plc::types;

namespace {

/// One call as a person would write its operands: "INT 5", "STRING 'abc'".
struct Row {
    const char* function;
    std::vector<const char*> operands;
    const char* expected; // type and value; '!' in front: ENO FALSE
};

struct Intrinsics : testing::Test {
    TypeTable table;

    TypeId typeNamed(std::string_view name) {
        if (name == "STRING") return table.string(80);
        if (name == "WSTRING") return table.wstring(80);
        if (name == "STRING(5)") return table.string(5);
        for (uint32_t k = 0; k <= static_cast<uint32_t>(TypeKind::Wchar); ++k)
            if (spelling(static_cast<TypeKind>(k)) == name) return TypeTable::of(static_cast<TypeKind>(k));
        ADD_FAILURE() << "no type " << name;
        return {};
    }
    Value parse(std::string_view text) {
        const size_t blank = text.find(' ');
        const auto value = parseValue(table, typeNamed(text.substr(0, blank)), text.substr(blank + 1));
        EXPECT_TRUE(value) << text;
        return value.value_or(Value{});
    }
    std::string show(const Evaluated& result) {
        if (result.error == EvaluationError::DivisionByZero) return "division by zero";
        if (result.error == EvaluationError::StringIndex) return "string index";
        if (result.error != EvaluationError::None) return "not evaluable";
        return (result.ok ? "" : "!") + table[result.value.type].name + " " + toText(table, result.value);
    }
    /// The operands are of the types the checker would have given them.
    Evaluated call(const Row& row) {
        const Signature* signature = findSignature(row.function);
        EXPECT_TRUE(signature && signature->intrinsic) << row.function;
        std::vector<Value> operands;
        for (const char* operand : row.operands) operands.push_back(parse(operand));
        TypeId result = operands.empty() ? TypeId() : operands[0].type;
        if (signature->rule == Rule::SecondOperand) result = operands.at(1).type;
        if (signature->result != TypeKind::Unknown)
            result = typeNamed(signature->result == TypeKind::String ? "STRING" : spelling(signature->result));
        return evaluateIntrinsic(table, *signature->intrinsic, result, operands, nullptr, signature->selector);
    }
    void expectAll(std::initializer_list<Row> rows) {
        for (const Row& row : rows) {
            std::string what = row.function;
            for (const char* operand : row.operands) what += std::string(" ") + operand;
            EXPECT_EQ(show(call(row)), row.expected) << what;
        }
    }
    std::string binary(BinaryOp op, const char* a, const char* b) {
        const Value left = parse(a), right = parse(b);
        return show(evaluateBinary(table, op, left.type, left, right));
    }
};

} // namespace

TEST_F(Intrinsics, LiteralsAreComputedWithAllBits) {
    const auto literal = [](BinaryOp op, WideInteger a, WideInteger b) { return evaluateWide(op, a, b); };
    const WideInteger most = UINT64_MAX, least = INT64_MIN;
    EXPECT_TRUE(literal(BinaryOp::Add, most, 1) == most + 1);
    EXPECT_TRUE(literal(BinaryOp::Subtract, least, 1) == least - 1);
    EXPECT_TRUE(literal(BinaryOp::Divide, least, -1) == -least) << "no wrapping to the least LINT";
    EXPECT_TRUE(literal(BinaryOp::Modulo, -7, 3) == WideInteger(-1));
    EXPECT_TRUE(literal(BinaryOp::Less, -1, most) == WideInteger(1)) << "-1 is less than any unsigned number";
    EXPECT_FALSE(literal(BinaryOp::Divide, 1, 0));
    EXPECT_FALSE(literal(BinaryOp::Modulo, 1, 0));
}

TEST_F(Intrinsics, AProductBeyondAllBitsStaysFarOutOfRange) {
    const WideInteger most = UINT64_MAX;
    EXPECT_TRUE(evaluateWide(BinaryOp::Multiply, most, most) > most);
    EXPECT_TRUE(evaluateWide(BinaryOp::Multiply, WideInteger(1) << 126, -4) < -most);
}

TEST_F(Intrinsics, IntegersWrapInTheirType) {
    EXPECT_EQ(binary(BinaryOp::Add, "INT 32767", "INT 1"), "INT -32768");
    EXPECT_EQ(binary(BinaryOp::Subtract, "UINT 0", "UINT 1"), "UINT 65535");
    EXPECT_EQ(binary(BinaryOp::Multiply, "INT 300", "INT 300"), "INT 24464");
    EXPECT_EQ(binary(BinaryOp::Divide, "INT -7", "INT 2"), "INT -3");
    EXPECT_EQ(binary(BinaryOp::Modulo, "INT -7", "INT 2"), "INT -1");
    EXPECT_EQ(binary(BinaryOp::Modulo, "INT 7", "INT -2"), "INT 1");
    EXPECT_EQ(binary(BinaryOp::Divide, "INT -32768", "INT -1"), "INT -32768");
    EXPECT_EQ(binary(BinaryOp::Modulo, "INT -32768", "INT -1"), "INT 0");
    EXPECT_EQ(binary(BinaryOp::Divide, "LINT -9223372036854775808", "LINT -1"), "LINT -9223372036854775808");
    EXPECT_EQ(binary(BinaryOp::Divide, "ULINT 18446744073709551615", "ULINT 2"), "ULINT 9223372036854775807");
    EXPECT_EQ(binary(BinaryOp::Divide, "INT 1", "INT 0"), "division by zero");
    EXPECT_EQ(binary(BinaryOp::Modulo, "ULINT 1", "ULINT 0"), "division by zero");
    EXPECT_EQ(binary(BinaryOp::And, "WORD 16#FF0F", "WORD 16#0FFF"), "WORD 3855");
    EXPECT_EQ(binary(BinaryOp::Xor, "BOOL 1", "BOOL 1"), "BOOL FALSE");
}

TEST_F(Intrinsics, RealsAreSingleWhereTheyAreReal) {
    EXPECT_EQ(binary(BinaryOp::Add, "REAL 0.1", "REAL 0.2"), "REAL 0.3");
    EXPECT_EQ(binary(BinaryOp::Add, "LREAL 0.1", "LREAL 0.2"), "LREAL 0.30000000000000004");
    EXPECT_EQ(binary(BinaryOp::Add, "REAL 16777216", "REAL 1"), "REAL 16777216.0");
    EXPECT_EQ(binary(BinaryOp::Divide, "REAL 1", "REAL 0"), "REAL INF");
    EXPECT_EQ(binary(BinaryOp::Divide, "REAL 0", "REAL 0").substr(0, 8), "REAL NaN");
    EXPECT_EQ(binary(BinaryOp::Equal, "REAL NaN", "REAL NaN"), "BOOL FALSE");
    EXPECT_EQ(binary(BinaryOp::NotEqual, "REAL NaN", "REAL NaN"), "BOOL TRUE");
    EXPECT_EQ(binary(BinaryOp::LessEqual, "REAL NaN", "REAL 1"), "BOOL FALSE");
    EXPECT_EQ(binary(BinaryOp::GreaterEqual, "REAL NaN", "REAL 1"), "BOOL FALSE");
}

TEST_F(Intrinsics, ComparisonsKnowSignsAndTexts) {
    EXPECT_EQ(binary(BinaryOp::Greater, "ULINT 18446744073709551615", "ULINT 1"), "BOOL TRUE");
    EXPECT_EQ(binary(BinaryOp::Less, "LINT -1", "LINT 1"), "BOOL TRUE");
    EXPECT_EQ(binary(BinaryOp::Less, "TIME T#-1s", "TIME T#0s"), "BOOL TRUE");
    EXPECT_EQ(binary(BinaryOp::Less, "STRING 'AB'", "STRING 'ABC'"), "BOOL TRUE");
    EXPECT_EQ(binary(BinaryOp::LessEqual, "STRING 'B'", "STRING 'ABC'"), "BOOL FALSE");
    EXPECT_EQ(binary(BinaryOp::Equal, "STRING ''", "STRING ''"), "BOOL TRUE");
    EXPECT_EQ(binary(BinaryOp::Greater, "STRING '\u00E4'", "STRING 'z'"), "BOOL TRUE");
    EXPECT_EQ(binary(BinaryOp::Add, "STRING 'a'", "STRING 'b'"), "not evaluable");
}

TEST_F(Intrinsics, UnaryOperators) {
    const auto unary = [&](UnaryOp op, const char* text) {
        const Value operand = parse(text);
        return show(evaluateUnary(table, op, operand.type, operand));
    };
    EXPECT_EQ(unary(UnaryOp::Negate, "INT -32768"), "INT -32768");
    EXPECT_EQ(unary(UnaryOp::Negate, "REAL 1.5"), "REAL -1.5");
    EXPECT_EQ(unary(UnaryOp::Negate, "TIME T#1s"), "TIME T#-1s");
    EXPECT_EQ(unary(UnaryOp::Not, "BOOL TRUE"), "BOOL FALSE");
    EXPECT_EQ(unary(UnaryOp::Not, "BYTE 16#0F"), "BYTE 240");
    EXPECT_EQ(unary(UnaryOp::Not, "INT 0"), "INT -1");
    EXPECT_EQ(unary(UnaryOp::Not, "REAL 0"), "not evaluable");
}

TEST_F(Intrinsics, Numbers) {
    expectAll({{"ABS", {"INT -5"}, "INT 5"},
               {"ABS", {"INT -32768"}, "INT -32768"},
               {"ABS", {"REAL -1.2"}, "REAL 1.2"},
               {"ABS", {"TIME T#-1s"}, "TIME T#1s"},
               {"ABS", {"UINT 65535"}, "UINT 65535"},
               {"SQRT", {"REAL 9"}, "REAL 3.0"},
               {"SQRT", {"LREAL 2"}, "LREAL 1.4142135623730951"},
               {"LOG", {"REAL 10"}, "REAL 1.0"},
               {"EXP", {"LREAL 1"}, "LREAL 2.718281828459045"},
               {"LN", {"LREAL 1"}, "LREAL 0.0"},
               {"LN", {"LREAL 0"}, "LREAL -INF"},
               {"SIN", {"REAL 0"}, "REAL 0.0"},
               {"COS", {"REAL 0"}, "REAL 1.0"},
               {"ATAN2", {"LREAL 1", "LREAL 1"}, "LREAL 0.7853981633974483"},
               {"SQR", {"REAL 4"}, "REAL 16.0"},
               {"SQR", {"INT 300"}, "INT 24464"},
               {"TRUNC", {"REAL 3.9"}, "DINT 3"},
               {"TRUNC", {"REAL -2.5"}, "DINT -2"},
               {"TRUNC", {"REAL 1e30"}, "DINT 2147483647"},
               {"TRUNC_INT", {"LREAL -1e30"}, "INT -32768"},
               {"FLOOR", {"REAL 2.8"}, "REAL 2.0"},
               {"FLOOR", {"REAL -2.8"}, "REAL -3.0"},
               {"CEIL", {"REAL 2.1"}, "REAL 3.0"},
               {"FLOOR_INT", {"REAL -2.8"}, "INT -3"},
               {"ROUND", {"REAL 2.5"}, "REAL 2.0"},
               {"FRAC", {"LREAL 2.75"}, "LREAL 0.75"},
               {"FRAC", {"LREAL -3.5"}, "LREAL -0.5"},
               {"DEG_TO_RAD", {"LREAL 180"}, "LREAL 3.141592653589793"},
               {"RAD_TO_DEG", {"LREAL 3.141592653589793"}, "LREAL 180.0"},
               {"DEG_TO_RAD", {"REAL 180"}, "REAL 3.1415927"},
               {"MOVE", {"STRING 'a'"}, "STRING 'a'"}});
    EXPECT_TRUE(std::isnan(call({"SQRT", {"REAL -1"}, ""}).value.real()));
}

TEST_F(Intrinsics, Powers) {
    const auto power = [&](const char* base, const char* exponent) {
        const Value operands[] = {parse(base), parse(exponent)};
        const bool isReal = std::holds_alternative<double>(operands[0].data);
        return show(evaluateIntrinsic(table, isReal ? Intrinsic::Expt : Intrinsic::ExptInt, operands[0].type, operands,
                                      nullptr));
    };
    EXPECT_EQ(power("INT 2", "INT 5"), "INT 32");
    EXPECT_EQ(power("INT 2", "INT 15"), "INT -32768");
    EXPECT_EQ(power("INT 2", "INT 16"), "INT 0");
    EXPECT_EQ(power("INT 0", "INT 0"), "INT 1");
    EXPECT_EQ(power("INT -1", "INT -3"), "INT -1");
    EXPECT_EQ(power("INT 2", "INT -1"), "INT 0");
    EXPECT_EQ(power("LINT 3", "LINT 39"), "LINT 4052555153018976267");
    EXPECT_EQ(power("REAL 2", "REAL 0.5"), "REAL 1.4142135");
    EXPECT_EQ(power("LREAL 2", "LREAL -1"), "LREAL 0.5");
}

TEST_F(Intrinsics, Shifts) {
    expectAll({{"SHL", {"BYTE 16#81", "INT 1"}, "BYTE 2"},
               {"SHL", {"BYTE 1", "INT 8"}, "BYTE 0"},
               {"SHL", {"BYTE 1", "INT -1"}, "BYTE 0"},
               {"SHR", {"BYTE 16#81", "INT 1"}, "BYTE 64"},
               {"SHR", {"SINT -128", "INT 7"}, "SINT 1"},
               {"SHR", {"LWORD 16#8000000000000000", "INT 63"}, "LWORD 1"},
               {"SHL", {"LWORD 1", "ULINT 18446744073709551615"}, "LWORD 0"},
               {"ROL", {"BYTE 16#81", "INT 1"}, "BYTE 3"},
               {"ROL", {"BYTE 16#81", "INT 9"}, "BYTE 3"},
               {"ROL", {"BYTE 16#81", "INT -1"}, "BYTE 192"},
               {"ROR", {"BYTE 16#81", "INT 1"}, "BYTE 192"},
               {"ROR", {"WORD 1", "INT 16"}, "WORD 1"},
               {"ROL", {"LWORD 1", "INT 63"}, "LWORD 9223372036854775808"},
               {"SHL", {"INT 16384", "INT 1"}, "INT -32768"}});
}

TEST_F(Intrinsics, Selection) {
    expectAll({{"SEL", {"BOOL FALSE", "INT 1", "INT 2"}, "INT 1"},
               {"SEL", {"BOOL TRUE", "STRING 'a'", "STRING 'b'"}, "STRING 'b'"},
               {"MAX", {"INT 1", "INT 7", "INT -3"}, "INT 7"},
               {"MIN", {"INT 1", "INT 7", "INT -3"}, "INT -3"},
               {"MAX", {"STRING 'AB'", "STRING 'ABC'"}, "STRING 'ABC'"},
               {"MIN", {"TIME T#1s", "TIME T#-1s"}, "TIME T#-1s"},
               {"MAX", {"ULINT 18446744073709551615", "ULINT 1"}, "ULINT 18446744073709551615"},
               {"LIMIT", {"INT 0", "INT 11", "INT 10"}, "INT 10"},
               {"LIMIT", {"INT 0", "INT -1", "INT 10"}, "INT 0"},
               {"LIMIT", {"INT 0", "INT 5", "INT 10"}, "INT 5"},
               {"LIMIT", {"INT 10", "INT 5", "INT 0"}, "INT 0"},
               {"LIMIT", {"REAL 0", "REAL 0.5", "REAL 1"}, "REAL 0.5"},
               {"MUX", {"INT 0", "INT 10", "INT 11", "INT 12"}, "INT 10"},
               {"MUX", {"INT 2", "INT 10", "INT 11", "INT 12"}, "INT 12"},
               {"MUX", {"INT 3", "INT 10", "INT 11", "INT 12"}, "INT 12"},
               {"MUX", {"INT -1", "INT 10", "INT 11", "INT 12"}, "INT 10"}});
}

TEST_F(Intrinsics, Texts) {
    expectAll({{"LEN", {"STRING 'Demo'"}, "INT 4"},
               {"LEN", {"STRING ''"}, "INT 0"},
               {"LEN", {"STRING '\u00E4\u00F6'"}, "INT 2"},
               {"LEFT", {"STRING '1234567'", "INT 2"}, "STRING '12'"},
               {"LEFT", {"STRING '12'", "INT 9"}, "STRING '12'"},
               {"LEFT", {"STRING '12'", "INT 0"}, "STRING ''"},
               {"LEFT", {"STRING '12'", "INT -1"}, "!STRING ''"},
               {"RIGHT", {"STRING '1234567'", "INT 2"}, "STRING '67'"},
               {"RIGHT", {"STRING '12'", "INT 9"}, "STRING '12'"},
               {"RIGHT", {"STRING '12'", "INT -1"}, "!STRING ''"},
               {"MID", {"STRING '1234567'", "INT 2", "INT 3"}, "STRING '34'"},
               {"MID", {"STRING '1234567'", "INT 9", "INT 6"}, "STRING '67'"},
               {"MID", {"STRING '1234567'", "INT 2", "INT 0"}, "!STRING ''"},
               {"MID", {"STRING '1234567'", "INT 2", "INT -1"}, "!STRING ''"},
               {"MID", {"STRING '123'", "INT 2", "INT 4"}, "!STRING ''"},
               {"CONCAT", {"STRING 'AB'", "STRING 'CD'"}, "STRING 'ABCD'"},
               {"CONCAT", {"STRING 'A'", "STRING ''", "STRING 'C'"}, "STRING 'AC'"},
               {"CONCAT", {"STRING(5) 'ABC'", "STRING 'DEF'"}, "STRING(5) 'ABCDE'"},
               {"INSERT", {"STRING 'ABC'", "STRING 'XY'", "INT 2"}, "STRING 'ABXYC'"},
               {"INSERT", {"STRING 'ABC'", "STRING 'XY'", "INT 0"}, "STRING 'XYABC'"},
               {"INSERT", {"STRING 'ABC'", "STRING 'XY'", "INT 3"}, "STRING 'ABCXY'"},
               {"INSERT", {"STRING 'ABC'", "STRING 'XY'", "INT 4"}, "!STRING 'ABCXY'"},
               {"INSERT", {"STRING 'ABC'", "STRING 'XY'", "INT -1"}, "!STRING ''"},
               {"DELETE", {"STRING 'ABXYC'", "INT 2", "INT 3"}, "STRING 'ABC'"},
               {"DELETE", {"STRING 'ABC'", "INT 9", "INT 2"}, "STRING 'A'"},
               {"DELETE", {"STRING 'ABC'", "INT 1", "INT 4"}, "!STRING 'ABC'"},
               {"DELETE", {"STRING 'ABC'", "INT 1", "INT 0"}, "!STRING ''"},
               {"REPLACE", {"STRING 'ABCDEFGF'", "STRING 'X'", "INT 2", "INT 3"}, "STRING 'ABXEFGF'"},
               {"REPLACE", {"STRING 'ABC'", "STRING 'X'", "INT 0", "INT 4"}, "STRING 'ABCX'"},
               {"REPLACE", {"STRING 'ABC'", "STRING 'X'", "INT 1", "INT 0"}, "!STRING ''"},
               {"FIND", {"STRING 'ABCBCDEFG'", "STRING 'BC'"}, "INT 2"},
               {"FIND", {"STRING 'ABC'", "STRING 'bc'"}, "INT 0"},
               {"FIND", {"STRING 'ABC'", "STRING ''"}, "INT 0"},
               {"FIND", {"STRING 'AB'", "STRING 'ABC'"}, "INT 0"},
               {"FIND", {"STRING ''", "STRING 'A'"}, "INT 0"},
               {"TO_UPPER", {"STRING 'a\u00E4z\u00F7\u00DF1'"}, "STRING 'A\u00C4Z\u00F7\u00DF1'"},
               {"TO_LOWER", {"STRING 'A\u00C4Z\u00D7'"}, "STRING 'a\u00E4z\u00D7'"},
               {"TRIM", {"STRING '  a b '"}, "STRING 'a b'"},
               {"F_toASC", {"STRING 'AB'"}, "BYTE 65"},
               {"F_toASC", {"STRING ''"}, "BYTE 0"},
               {"F_toCHR", {"INT 65"}, "STRING 'A'"},
               {"F_toCHR", {"INT 0"}, "STRING ''"}});
}

TEST_F(Intrinsics, WideTexts) {
    expectAll({{"WLEN", {"WSTRING \"\u03A9\u20AC\""}, "INT 2"},
               {"WLEFT", {"WSTRING \"\u03A9\u20ACx\"", "INT 2"}, "WSTRING \"\u03A9\u20AC\""},
               {"WMID", {"WSTRING \"abc\"", "INT 1", "INT 2"}, "WSTRING \"b\""},
               {"WCONCAT", {"WSTRING \"a\"", "WSTRING \"\u20AC\""}, "WSTRING \"a\u20AC\""},
               {"WFIND", {"WSTRING \"a\u20AC\"", "WSTRING \"\u20AC\""}, "INT 2"},
               {"WINSERT", {"WSTRING \"ac\"", "WSTRING \"b\"", "INT 1"}, "WSTRING \"abc\""},
               {"WDELETE", {"WSTRING \"abc\"", "INT 1", "INT 2"}, "WSTRING \"ac\""},
               {"WREPLACE", {"WSTRING \"abc\"", "WSTRING \"x\"", "INT 1", "INT 2"}, "WSTRING \"axc\""},
               {"WRIGHT", {"WSTRING \"abc\"", "INT 1"}, "WSTRING \"c\""},
               {"TO_UPPER", {"WSTRING \"\u03C9\u044F\u0151\u00FF\""}, "WSTRING \"\u03A9\u042F\u0150\u0178\""},
               {"TO_LOWER", {"WSTRING \"\u03A9\u042F\u0150\u0178\""}, "WSTRING \"\u03C9\u044F\u0151\u00FF\""}});
}

TEST_F(Intrinsics, NumbersInTextsAreRecognised) {
    for (const auto& [text, expected] : {std::pair{"STRING '12'", true},
                                         {"STRING ' -1.5e3 '", true},
                                         {"STRING '+7'", true},
                                         {"STRING '16#FF'", true},
                                         {"STRING '.5'", true},
                                         {"STRING '5.'", true},
                                         {"STRING ''", false},
                                         {"STRING '12;'", false},
                                         {"STRING 'x'", false},
                                         {"STRING '-'", false},
                                         {"STRING '1 2'", false},
                                         {"STRING '1e'", false},
                                         {"WSTRING \"12\"", true}})
        EXPECT_EQ(call({"IsNumber", {text}, ""}).value.isTrue(), expected) << text;
}

TEST_F(Intrinsics, TimesAndDates) {
    expectAll({{"MULTIME", {"TIME T#1s", "INT 3"}, "TIME T#3s"},
               {"MULTIME", {"TIME T#1s", "REAL 1.5"}, "TIME T#1s500ms"},
               {"DIVTIME", {"TIME T#1s", "INT 4"}, "TIME T#250ms"},
               {"DIVTIME", {"TIME T#1s", "INT 0"}, "division by zero"},
               {"DIVTIME", {"TIME T#1s", "REAL 0"}, "TIME T#106751d23h47m16s854ms775us807ns"},
               {"DIVTIME", {"TIME T#1s", "REAL 0.5"}, "TIME T#2s"},
               {"MUL_LTIME", {"LTIME LTIME#1us", "INT -2"}, "LTIME LTIME#-2us"},
               {"CONCAT_DATE", {"INT 2024", "INT 2", "INT 29"}, "DATE D#2024-02-29"},
               {"CONCAT_DATE", {"INT 2023", "INT 2", "INT 29"}, "!DATE D#1970-01-01"},
               {"CONCAT_TOD", {"INT 6", "INT 30", "INT 1", "INT 500"}, "TOD TOD#06:30:01.500"},
               {"CONCAT_TOD", {"INT 24", "INT 0", "INT 0", "INT 0"}, "!TOD TOD#00:00:00"},
               {"CONCAT_DT",
                {"INT 2024", "INT 2", "INT 29", "INT 6", "INT 30", "INT 0", "INT 0"},
                "DT DT#2024-02-29-06:30:00"},
               {"CONCAT_DATE_TOD", {"DATE D#2024-2-29", "TOD TOD#6:30"}, "DT DT#2024-02-29-06:30:00"},
               {"DAY_OF_WEEK", {"DATE D#2024-2-29"}, "INT 4"},
               {"DAY_OF_WEEK", {"DATE D#1970-1-1"}, "INT 4"},
               {"DAY_OF_WEEK", {"DATE D#1969-12-28"}, "INT 0"},
               {"DAY_OF_WEEK", {"DATE D#2026-10-17"}, "INT 6"},
               {"YEAR_OF", {"DATE D#2024-2-29"}, "INT 2024"},
               {"MONTH_OF", {"DT DT#2024-2-29-1:0:0"}, "INT 2"},
               {"DAY_OF", {"DATE D#2024-2-29"}, "INT 29"},
               {"HOUR_OF", {"TOD TOD#6:30:1.5"}, "INT 6"},
               {"MINUTE_OF", {"DT DT#1969-12-31-23:59:58"}, "INT 59"},
               {"SECOND_OF", {"TOD TOD#6:30:1.5"}, "INT 1"},
               {"MILLISECOND_OF", {"TOD TOD#6:30:1.5"}, "INT 500"}});
}

TEST_F(Intrinsics, BinaryCodedDecimals) {
    const auto bcd = [&](Intrinsic code, const char* operand, const char* result) {
        const Value operands[] = {parse(operand)};
        return show(evaluateIntrinsic(table, code, typeNamed(result), operands, nullptr));
    };
    EXPECT_EQ(bcd(Intrinsic::BcdTo, "WORD 16#1234", "INT"), "INT 1234");
    EXPECT_EQ(bcd(Intrinsic::BcdTo, "BYTE 16#99", "INT"), "INT 99");
    EXPECT_EQ(bcd(Intrinsic::BcdTo, "WORD 16#12A4", "INT"), "!INT 0");
    EXPECT_EQ(bcd(Intrinsic::BcdTo, "WORD 16#9999", "SINT"), "!SINT 0");
    EXPECT_EQ(bcd(Intrinsic::BcdTo, "LWORD 16#9999999999999999", "ULINT"), "ULINT 9999999999999999");
    EXPECT_EQ(bcd(Intrinsic::ToBcd, "INT 1234", "WORD"), "WORD 4660");
    EXPECT_EQ(bcd(Intrinsic::ToBcd, "INT -1", "WORD"), "!WORD 0");
    EXPECT_EQ(bcd(Intrinsic::ToBcd, "INT 10000", "WORD"), "!WORD 0");
    EXPECT_EQ(bcd(Intrinsic::ToBcd, "UINT 99", "BYTE"), "BYTE 153");
    EXPECT_EQ(bcd(Intrinsic::ToBcd, "UINT 100", "BYTE"), "!BYTE 0");
    expectAll({{"IS_VALID_BCD", {"WORD 16#1299"}, "BOOL TRUE"},
               {"IS_VALID_BCD", {"WORD 16#12A9"}, "BOOL FALSE"},
               {"IS_VALID", {"REAL 1"}, "BOOL TRUE"},
               {"IS_VALID", {"REAL NaN"}, "BOOL FALSE"},
               {"IS_VALID", {"LREAL INF"}, "BOOL FALSE"}});
}

TEST_F(Intrinsics, Representations) {
    expectAll({{"REAL_AS_DWORD", {"REAL 1"}, "DWORD 1065353216"},
               {"DWORD_AS_REAL", {"DWORD 16#3F800000"}, "REAL 1.0"},
               {"LREAL_AS_LWORD", {"LREAL 1"}, "LWORD 4607182418800017408"},
               {"LWORD_AS_LREAL", {"LWORD 16#3FF0000000000000"}, "LREAL 1.0"},
               {"TO_BIG_ENDIAN", {"WORD 16#1234"}, "WORD 13330"},
               {"TO_BIG_ENDIAN", {"BYTE 16#12"}, "BYTE 18"},
               {"SWAP", {"DWORD 16#01020304"}, "DWORD 67305985"},
               {"TO_LITTLE_ENDIAN", {"WORD 16#1234"}, "WORD 4660"},
               {"SWAP", {"INT 255"}, "INT -256"}});
}

TEST_F(Intrinsics, ACharacterOfATextIsGuarded) {
    const auto at = [&](const char* text, int64_t index) {
        const Value operands[] = {parse(text), {typeNamed("LINT"), index}};
        return show(evaluateIntrinsic(table, Intrinsic::CharAt, typeNamed("BYTE"), operands, nullptr));
    };
    EXPECT_EQ(at("STRING 'ABC'", 0), "BYTE 65");
    EXPECT_EQ(at("STRING 'ABC'", 2), "BYTE 67");
    EXPECT_EQ(at("STRING 'ABC'", 3), "BYTE 0") << "the end mark";
    EXPECT_EQ(at("STRING 'ABC'", 4), "string index");
    EXPECT_EQ(at("STRING 'ABC'", -1), "string index");
    EXPECT_EQ(at("STRING ''", 1), "string index");
}

TEST_F(Intrinsics, TheClockIsTheHeaders) {
    image::ImageHeader header;
    header.timeNs = 1'500'000'000;
    header.calendarNs = 946'684'800'000'000'000;
    header.scan = 7;
    header.taskPeriodNs = 10'000'000;
    const auto clock = [&](const char* name, const image::ImageHeader* of) {
        const Signature* signature = findSignature(name);
        return show(evaluateIntrinsic(table, *signature->intrinsic, TypeTable::of(signature->result), {}, of));
    };
    EXPECT_EQ(clock("TIME", &header), "TIME T#1s500ms");
    EXPECT_EQ(clock("LTIME", &header), "LTIME LTIME#1s500ms");
    EXPECT_EQ(clock("NOW", &header), "DT DT#2000-01-01-00:00:00");
    EXPECT_EQ(clock("FIRST_SCAN", &header), "BOOL TRUE");
    EXPECT_EQ(clock("SCAN_NUMBER", &header), "ULINT 7");
    EXPECT_EQ(clock("TASK_PERIOD", &header), "TIME T#10ms");
    EXPECT_EQ(clock("TIME", nullptr), "not evaluable");
}
