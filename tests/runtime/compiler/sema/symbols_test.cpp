#include "tests/runtime/compiler/sema/checked.h"

#include <gtest/gtest.h>

using namespace plc;
using namespace plc::sema_test;

namespace {

/// "name@line:column" of what the reference at the n-th `needle` of the text leads to.
std::string targetOf(const CheckedText& checked, std::string_view needle, int nth = 1) {
    const std::string_view text = (*checked.sources)[FileId(0)].text();
    size_t at = 0;
    for (int i = 0; i < nth; ++i) at = text.find(needle, i ? at + 1 : 0);
    for (const sema::Reference& reference : checked.analysis->references) {
        if (reference.range.file != FileId(0) || reference.range.begin != at) continue;
        const sema::Symbol& symbol = checked.analysis->symbols[reference.symbol.index()];
        std::string where = symbol.name;
        if (symbol.declaration.file.isValid())
            where += "@" + std::to_string(
                               (*checked.sources)[symbol.declaration.file].lineColumn(symbol.declaration.begin).line);
        return where + (reference.isWrite ? " written" : "") + (reference.isRead ? " read" : "");
    }
    return "nothing";
}

const char* const kText = R"(TYPE Pair : STRUCT
    left : INT; // the left one
END_STRUCT END_TYPE
TYPE Mode : (Idle, Run); END_TYPE
FUNCTION_BLOCK Motor
VAR_INPUT
    speed : INT;
END_VAR
METHOD Start : BOOL
    Start := speed > 0;
END_METHOD
END_FUNCTION_BLOCK
PROGRAM Main
VAR
    pair : Pair;
    motor : Motor;
    mode : Mode;
END_VAR
pair.left := 5;
motor(speed := pair.left);
IF motor.Start() THEN mode := Run; END_IF
END_PROGRAM
)";

} // namespace

TEST(Symbols, EachNameLeadsToItsDeclaration) {
    const CheckedText checked = check(kText);
    ASSERT_FALSE(checked.analysis->hasErrors) << checked.all();
    EXPECT_EQ(targetOf(checked, "Pair;"), "Pair@1 read");
    EXPECT_EQ(targetOf(checked, "Motor;"), "Motor@5 read");
    EXPECT_EQ(targetOf(checked, "pair.left := 5"), "pair@15 written");
    EXPECT_EQ(targetOf(checked, "left := 5"), "left@2 written");
    EXPECT_EQ(targetOf(checked, "left);"), "left@2 read");
    EXPECT_EQ(targetOf(checked, "speed := pair"), "speed@7 written");
    EXPECT_EQ(targetOf(checked, "Start()"), "Start@9 read");
    EXPECT_EQ(targetOf(checked, "Run; END_IF"), "Run@4 read");
    EXPECT_EQ(targetOf(checked, "speed > 0"), "speed@7 read");
}

TEST(Symbols, CarryPathTypeAndComment) {
    const CheckedText checked = check(kText);
    for (const sema::Symbol& symbol : checked.analysis->symbols) {
        if (symbol.name == "left") {
            EXPECT_EQ(symbol.comment, "the left one");
        }
        if (symbol.name == "mode") {
            EXPECT_EQ(symbol.path, "Main.mode");
        }
        if (symbol.name == "speed" && symbol.owner == "Motor") {
            EXPECT_EQ(symbol.section, types::FieldSection::Input);
        }
    }
}
