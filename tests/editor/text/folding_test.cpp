// Every construct of several lines folds from its first line to its last.
#include "projects/analysis/block_structure.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace plc::editor {
namespace {

using analysis::FoldLine, analysis::foldLines;

class Folding : public testing::TestWithParam<const char*> {};

TEST_P(Folding, FromTheFirstLineToTheLast) {
    const std::string text = std::string(GetParam());
    const std::vector<FoldLine> lines = foldLines(text + "\nafter\n");
    ASSERT_GE(lines.size(), 3u);
    EXPECT_TRUE(lines[0].isHeader) << text;
    const auto last = static_cast<size_t>(std::count(text.begin(), text.end(), '\n'));
    for (size_t line = 1; line <= last; ++line) EXPECT_GE(lines[line].level, 1) << text << " line " << line;
    EXPECT_EQ(lines[last + 1].level, 0) << text;
}

INSTANTIATE_TEST_SUITE_P(
    Constructs, Folding,
    testing::Values("IF a THEN\n  b := 1;\nELSIF c THEN\n  b := 2;\nELSE\n  b := 3;\nEND_IF",
                    "CASE a OF\n  1: b := 1;\nEND_CASE", "FOR i := 1 TO 3 DO\n  b := i;\nEND_FOR",
                    "WHILE a DO\n  b := 1;\nEND_WHILE", "REPEAT\n  b := 1;\nUNTIL a\nEND_REPEAT",
                    "TYPE S :\nSTRUCT\n  x : INT;\nEND_STRUCT\nEND_TYPE", "TYPE E :\n(\n  A,\n  B\n);\nEND_TYPE",
                    "TYPE U :\nUNION\n  x : INT;\nEND_UNION\nEND_TYPE", "VAR_GLOBAL CONSTANT\n  x : INT := 1;\nEND_VAR",
                    "FUNCTION F : INT\nF := 1;\nEND_FUNCTION",
                    "FUNCTION_BLOCK ABSTRACT B EXTENDS A\nEND_FUNCTION_BLOCK",
                    "METHOD PUBLIC Start : BOOL\n  x := 1;\nEND_METHOD", "METHOD Start\n  x := 1;\nEND_METHOD",
                    "INTERFACE I\nMETHOD M\nEND_METHOD\nEND_INTERFACE",
                    "NAMESPACE N\nTYPE T : INT;\nEND_TYPE\nEND_NAMESPACE",
                    "PROPERTY Speed : REAL\nGET\n  Speed := 1;\nEND_GET\nEND_PROPERTY",
                    "ACTION Go:\n  x := 1;\nEND_ACTION", "INITIAL_STEP Ready:\n  A(N);\nEND_STEP",
                    "STEP Work:\n  A(N);\nEND_STEP", "TRANSITION FROM A TO B\n  := x;\nEND_TRANSITION",
                    "CONFIGURATION C\nRESOURCE R ON Pc\nTASK T(INTERVAL := T#1ms);\nPROGRAM P WITH T : Main;\n"
                    "END_RESOURCE\nEND_CONFIGURATION",
                    "TEST 'works'\nRUN T#1s;\nEND_TEST", "(* one\n   two *)", "{region 'pumps'}\nx := 1;\n{endregion}",
                    "REGION Pumps and valves\n  x := 1;\nEND_REGION"));

} // namespace
} // namespace plc::editor
