#include "runtime/library/signatures.h"

#include <gtest/gtest.h>

#include <set>

using namespace plc::library;
using plc::types::TypeKind;

TEST(Signatures, EveryStandardFunctionIsThere) {
    for (const char* name : {
             "ABS",
             "SQRT",
             "LN",
             "LOG",
             "EXP",
             "SIN",
             "COS",
             "TAN",
             "ASIN",
             "ACOS",
             "ATAN",
             "ATAN2",
             "ADD",
             "MUL",
             "SUB",
             "DIV",
             "MOD",
             "EXPT",
             "MOVE",
             "SHL",
             "SHR",
             "ROL",
             "ROR",
             "AND",
             "OR",
             "XOR",
             "NOT",
             "SEL",
             "MAX",
             "MIN",
             "LIMIT",
             "MUX",
             "GT",
             "GE",
             "EQ",
             "LE",
             "LT",
             "NE",
             "LEN",
             "LEFT",
             "RIGHT",
             "MID",
             "CONCAT",
             "INSERT",
             "DELETE",
             "REPLACE",
             "FIND",
             "WLEN",
             "WLEFT",
             "WRIGHT",
             "WMID",
             "WCONCAT",
             "WINSERT",
             "WDELETE",
             "WREPLACE",
             "WFIND",
             "ADD_TIME",
             "ADD_TOD_TIME",
             "ADD_DT_TIME",
             "SUB_TIME",
             "SUB_DATE_DATE",
             "SUB_TOD_TIME",
             "SUB_TOD_TOD",
             "SUB_DT_TIME",
             "SUB_DT_DT",
             "MULTIME",
             "DIVTIME",
             "CONCAT_DATE_TOD",
             "CONCAT_DATE",
             "CONCAT_TOD",
             "CONCAT_DT",
             "DAY_OF_WEEK",
             "ADD_LTIME",
             "MUL_TIME",
             "MUL_LTIME",
             "DIV_TIME",
             "INC",
             "DEC",
             "NEG",
             "FRAC",
             "FLOOR",
             "SQR",
             "DEG_TO_RAD",
             "RAD_TO_DEG",
             "TRUNC",
             "TRUNC_INT",
             "TIME",
             "LTIME",
             "F_toASC",
             "F_toCHR",
             "TO_UPPER",
             "IsNumber",
             "IS_VALID",
             "IS_VALID_BCD",
             "LOWER_BOUND",
             "UPPER_BOUND",
             "SIZEOF",
             "ADR",
             "REF",
             "TO_BIG_ENDIAN",
             "CEIL",
             "SINH",
         })
        EXPECT_TRUE(findSignature(name)) << name;
    EXPECT_FALSE(findSignature("TON"));
    EXPECT_FALSE(findSignature(""));
}

TEST(Signatures, EachSaysHowItIsComputed) {
    std::set<std::string_view> names;
    for (const Signature& signature : signatures()) {
        EXPECT_TRUE(names.insert(signature.name).second) << signature.name << " stands there twice";
        EXPECT_FALSE(signature.summary.empty()) << signature.name;
        const int ways =
            signature.intrinsic.has_value() + !signature.operatorName.empty() + (signature.rule == Rule::Special);
        EXPECT_EQ(ways, 1) << signature.name;
        EXPECT_EQ(findSignature(signature.name), &signature);
        EXPECT_EQ(signature.rule == Rule::FixedResult,
                  signature.rule == Rule::FixedResult && signature.result != TypeKind::Unknown)
            << signature.name;
        std::set<std::string_view> parameters;
        for (const Parameter& parameter : signature.parameters)
            EXPECT_TRUE(parameters.insert(parameter.name).second) << signature.name;
        for (const Parameter& parameter : signature.parameters)
            for (const std::string_view other : parameter.otherNames)
                EXPECT_TRUE(parameters.insert(other).second) << signature.name << " " << other;
    }
}

TEST(Conversions, AreFoundByTheirPattern) {
    using How = Conversion::How;
    using enum TypeKind;
    struct Row {
        const char* name;
        How how;
        TypeKind from, to;
    };
    for (const auto& [name, how, from, to] : {
             Row{"INT_TO_REAL", How::Convert, Int, Real},
             Row{"int_to_real", How::Convert, Int, Real},
             Row{"TO_INT", How::Convert, Unknown, Int},
             Row{"ANY_TO_INT", How::Convert, Unknown, Int},
             Row{"STRING_TO_INT", How::Convert, String, Int},
             Row{"WSTRING_TO_STRING", How::Convert, Wstring, String},
             Row{"DATE_AND_TIME_TO_TIME_OF_DAY", How::Convert, Dt, Tod},
             Row{"DT_TO_DATE", How::Convert, Dt, Date},
             Row{"TIME_TO_REAL", How::Convert, Time, Real},
             Row{"REAL_TRUNC_INT", How::Truncate, Real, Int},
             Row{"LREAL_TRUNC_ULINT", How::Truncate, Lreal, Ulint},
             Row{"BCD_TO_INT", How::FromBcd, Unknown, Int},
             Row{"WORD_BCD_TO_UINT", How::FromBcd, Word, Uint},
             Row{"INT_TO_BCD", How::ToBcd, Int, Word},
             Row{"USINT_TO_BCD", How::ToBcd, Usint, Byte},
             Row{"UINT_TO_BCD_WORD", How::ToBcd, Uint, Word},
             Row{"TO_BCD_DWORD", How::ToBcd, Unknown, Dword},
             Row{"BOOL_TO_STRING", How::Convert, Bool, String},
         }) {
        const auto conversion = findConversion(name);
        ASSERT_TRUE(conversion) << name;
        EXPECT_EQ(conversion->how, how) << name;
        EXPECT_EQ(conversion->from, from) << name;
        EXPECT_EQ(conversion->to, to) << name;
    }
    for (const char* name : {"TO_UPPER", "DEG_TO_RAD", "FOO_TO_INT", "INT_TO_FOO", "TO_", "_TO_INT", "INT_TO_", "TOINT",
                             "STRING_TRUNC_INT", "REAL_TO_BCD", "TO_BIG_ENDIAN"})
        EXPECT_FALSE(findConversion(name)) << name;
}

TEST(Conversions, EveryPairOfElementaryTypesHasItsName) {
    size_t count = 0;
    for (uint32_t from = 0; from <= static_cast<uint32_t>(TypeKind::Wchar); ++from) {
        for (uint32_t to = 0; to <= static_cast<uint32_t>(TypeKind::Wchar); ++to) {
            const std::string name = std::string(plc::types::spelling(static_cast<TypeKind>(from))) + "_TO_" +
                                     std::string(plc::types::spelling(static_cast<TypeKind>(to)));
            EXPECT_TRUE(findConversion(name)) << name;
            ++count;
        }
    }
    EXPECT_EQ(count, 625u);
}
