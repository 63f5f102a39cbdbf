// However broken a text is, the checker ends and says so.
#include "tests/runtime/compiler/sema/checked.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

using namespace plc;
using namespace plc::sema_test;

namespace {

const char* const kProgram = R"(
TYPE Color : (Red, Green := 5, Blue) := Green; END_TYPE
TYPE Pair : STRUCT a : INT := 3; b : ARRAY[1..2] OF REAL := [1.0, 1(0.5)]; c : Color; END_STRUCT END_TYPE
INTERFACE IShape METHOD Area : REAL END_METHOD PROPERTY Name : STRING GET END_GET END_PROPERTY END_INTERFACE
FUNCTION_BLOCK Shape IMPLEMENTS IShape
VAR_INPUT start : BOOL R_EDGE; size : REAL := 2.0; END_VAR
VAR_IN_OUT io : Pair; END_VAR
VAR t : TON := (PT := T#1s); next : REF_TO INT := REF(count); count : INT; END_VAR
METHOD Area : REAL Area := size * size; END_METHOD
PROPERTY Name : STRING GET Name := 'shape'; END_GET END_PROPERTY
METHOD FB_Init : BOOL VAR_INPUT bInitRetains : BOOL; bInCopyCode : BOOL; n : INT; END_VAR count := n; FB_Init := TRUE; END_METHOD
t(IN := start); count := count + io.a; next^ := next^ + 1;
END_FUNCTION_BLOCK
FUNCTION Sum : DINT
VAR_INPUT limit : INT; END_VAR
VAR_IN_OUT values : ARRAY[*] OF INT; END_VAR
VAR i : DINT; END_VAR
Sum := 0;
FOR i := LOWER_BOUND(values, 1) TO UPPER_BOUND(values, 1) DO
    IF i > limit THEN EXIT; ELSIF values[i] < 0 THEN CONTINUE; END_IF
    Sum := Sum + values[i];
END_FOR
END_FUNCTION
PROGRAM Main
VAR CONSTANT n : INT := 2 * m; m : INT := 2; END_VAR
VAR shape : Shape(n := 5); p : Pair := (a := 1, b := [3.0, 4.0]); any : IShape; values : ARRAY[0..n] OF INT := [5(1)]; w : WORD; s : STRING(20) := 'a$'b'; out AT %QX0.1 : BOOL; total : DINT; END_VAR
shape(start := NOT out, io := p);
any := shape;
total := Sum(limit := 3, values := values) + REAL_TO_DINT(any.Area());
w.3 := s[0] = 'a' OR p.c = Color.Blue;
CASE p.c OF Red, Green: s := CONCAT(s, any.Name); Blue: out := w.3 AND_THEN total > 5; END_CASE
WHILE total > 100 DO total := total / 2; END_WHILE
REPEAT total := total + 1; UNTIL total MOD 7 = 0 END_REPEAT
END_PROGRAM
CONFIGURATION C
TASK Fast(INTERVAL := T#10ms, PRIORITY := 1);
PROGRAM Run WITH Fast : Main;
END_CONFIGURATION
)";

void cutAndSwap(const std::string& text, size_t step) {
    diagnostics::Sink sink;
    const lex::TokenList tokens = lex::tokenize(FileId(0), text, sink);
    for (size_t i = 0; i + 1 < tokens.tokens.size(); i += step) {
        const auto& token = tokens.tokens[i];
        static_cast<void>(check({{"cut.st", text.substr(0, token.begin), ""}}, false));
        static_cast<void>(check({{"gap.st", text.substr(0, token.begin) + text.substr(token.end), ""}}, false));
        const auto& next = tokens.tokens[i + 1];
        static_cast<void>(check({{"swap.st",
                                  text.substr(0, token.begin) + text.substr(next.begin, next.end - next.begin) + " " +
                                      text.substr(token.begin, token.end - token.begin) + text.substr(next.end),
                                  ""}},
                                false));
        const auto& other = tokens.tokens[(i * 7 + 13) % (tokens.tokens.size() - 1)];
        static_cast<void>(check(
            {{"other.st",
              text.substr(0, token.begin) + text.substr(other.begin, other.end - other.begin) + text.substr(token.end),
              ""}},
            false));
    }
}

} // namespace

TEST(BrokenTexts, TheWholeOneIsFine) {
    const CheckedText checked = check(kProgram);
    EXPECT_EQ(checked.messages(false), std::vector<std::string>{}) << checked.all();
}

TEST(BrokenTexts, CutAtEachTokenOrWithTokensSwappedEnd) { cutAndSwap(kProgram, 1); }

TEST(BrokenTexts, TheCorpusCutAndSwappedEnds) {
    const char* corpus = std::getenv("STEPWISE_CORPUS");
    if (!corpus) GTEST_SKIP() << "STEPWISE_CORPUS does not name a corpus";
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(corpus) / "st")) {
        std::ifstream in(entry.path(), std::ios::binary);
        std::stringstream text;
        text << in.rdbuf();
        cutAndSwap(text.str(), 3);
    }
}
