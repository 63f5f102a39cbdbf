#include "tests/runtime/compiler/parse/outline.h"
#include "tests/support/paths.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

using namespace plc::parse::testing;
namespace fs = std::filesystem;

namespace {

std::string readFile(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

std::vector<fs::path> libraryFiles() {
    std::vector<fs::path> out;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(plc::sourceDir()) / "runtime/library/st"))
        if (entry.path().extension() == ".st") out.push_back(entry.path());
    std::sort(out.begin(), out.end());
    return out;
}

/// One text with every construct, for the loops that break it at each token.
const char* everything() {
    return "NAMESPACE n\nTYPE e : (a, b := 2) INT := a; s : STRUCT x : ARRAY[1..2] OF INT := [1, 2]; END_STRUCT; "
           "END_TYPE\nEND_NAMESPACE\n"
           "{gvl G}\nVAR_GLOBAL g AT %QX0.0 : BOOL; END_VAR\n"
           "INTERFACE i METHOD m : INT END_METHOD END_INTERFACE\n"
           "FUNCTION_BLOCK f IMPLEMENTS i\nVAR_INPUT c : BOOL R_EDGE; END_VAR\nMETHOD m : INT m := 1; "
           "END_METHOD\nPROPERTY p : INT GET p := 1; END_GET SET END_SET END_PROPERTY\n"
           "IF c THEN x[1, 2].y := f(a := 1, b => q) + INT#16#7F; ELSIF d THEN ; ELSE JMP l; END_IF\nl: CASE s OF 1, "
           "2..3: a(); ELSE b(); END_CASE\n"
           "FOR i := 1 TO 10 BY 2 DO EXIT; END_FOR WHILE a DO CONTINUE; END_WHILE REPEAT a := b := c; UNTIL d "
           "END_REPEAT\nRETURN;\nEND_FUNCTION_BLOCK\n"
           "PROGRAM il\nLD a\nAND( b\nOR c\n)\nst: JMPC st\nCAL t(IN := a)\nEND_PROGRAM\n"
           "PROGRAM sfc\nINITIAL_STEP s0: a(N); b(D, T#1s, c); END_STEP\nTRANSITION FROM s0 TO (s1, s0) := a AND s0.X; "
           "END_TRANSITION\nSTEP s1: END_STEP\nACTION a: x := 'it$'s'; END_ACTION\nEND_PROGRAM\n"
           "CONFIGURATION c RESOURCE r ON x TASK t(INTERVAL := T#1s, PRIORITY := 1); PROGRAM p WITH t : q(a := "
           "%IX0.0); END_RESOURCE VAR_CONFIG r.p.x AT %QW0 : INT; END_VAR END_CONFIGURATION\n"
           "TEST 'x' RUN T#1s; ASSERT a = b, 'm'; END_TEST\n";
}

void breakAtEveryToken(const std::string& text, const std::string& what) {
    const Parsed whole(text);
    ASSERT_EQ(whole.errors(), 0u) << what << whole.codes();
    const auto& tokens = whole.file->tokens.tokens;
    const size_t stride = std::max<size_t>(1, tokens.size() / 700);
    for (size_t i = 0; i + 1 < tokens.size(); i += stride) {
        const auto& token = tokens[i];
        // cut: whatever remains must be read with few messages
        const Parsed cut(text.substr(0, token.begin));
        EXPECT_LE(cut.errors(), 12u) << what << " cut at " << token.begin;
        // drop one token
        const Parsed dropped(text.substr(0, token.begin) + " " + text.substr(token.end));
        EXPECT_LE(dropped.errors(), 12u) << what << " without the token at " << token.begin << " " << dropped.codes();
        // swap with the next
        const auto& next = tokens[i + 1];
        const Parsed swapped(text.substr(0, token.begin) + text.substr(next.begin, next.end - next.begin) + " " +
                             text.substr(token.begin, token.end - token.begin) + text.substr(next.end));
        EXPECT_LE(swapped.errors(), 15u) << what << " swapped at " << token.begin << " " << swapped.codes();
    }
}

} // namespace

TEST(Robustness, ABrokenTextIsReadWithFewMessages) { breakAtEveryToken(everything(), "everything"); }

TEST(Robustness, TheLibraryIsReadAndSurvivesBreaking) {
    const auto files = libraryFiles();
    ASSERT_FALSE(files.empty());
    for (const fs::path& path : files) {
        const Parsed parsed(readFile(path));
        EXPECT_EQ(parsed.errors(), 0u) << path << " " << parsed.codes();
    }
    for (size_t i = 0; i < files.size(); i += std::max<size_t>(1, files.size() / 6))
        breakAtEveryToken(readFile(files[i]), files[i].string());
}

TEST(Robustness, AnyBytesAreRead) {
    uint32_t state = 1;
    const auto random = [&](uint32_t limit) {
        state = state * 1664525u + 1013904223u;
        return (state >> 8) % limit;
    };
    static const char* words[] = {"IF",
                                  "THEN",
                                  "END_IF",
                                  "VAR",
                                  "END_VAR",
                                  "(",
                                  ")",
                                  "[",
                                  "]",
                                  "{",
                                  "}",
                                  "'",
                                  "\"",
                                  "(*",
                                  "*)",
                                  "//",
                                  "\n",
                                  ":=",
                                  ":",
                                  ";",
                                  ",",
                                  "..",
                                  ".",
                                  "#",
                                  "16#",
                                  "T#",
                                  "x",
                                  "5",
                                  "%IX",
                                  "CASE",
                                  "OF",
                                  "STEP",
                                  "TRANSITION",
                                  "FROM",
                                  "TO",
                                  "PROGRAM",
                                  "END_PROGRAM",
                                  "LD",
                                  "AND(",
                                  "METHOD",
                                  "ACTION",
                                  "TYPE",
                                  "STRUCT",
                                  "ELSE",
                                  "TEST",
                                  "NAMESPACE",
                                  "CONFIGURATION",
                                  "\xff",
                                  "\xe2\x80",
                                  "ü",
                                  "$",
                                  "END_CASE",
                                  "-",
                                  "NOT"};
    for (int round = 0; round < 400; ++round) {
        std::string text;
        for (int i = 0; i < 200; ++i) {
            if (random(20) == 0) text += static_cast<char>(random(256));
            text += words[random(std::size(words))];
            if (random(3) != 0) text += ' ';
        }
        const Parsed parsed(text);
        EXPECT_NE(parsed.file, nullptr);
    }
}

TEST(Robustness, LongInputIsReadInLinearTime) {
    std::string unit =
        "FUNCTION_BLOCK fb\nVAR_INPUT\n    start : BOOL; // starts\n    level : REAL := 1.5;\nEND_VAR\nVAR\n    t : "
        "TON;\n    state : INT;\n    buffer : ARRAY[0..9] OF REAL;\nEND_VAR\n"
        "t(IN := start AND NOT t.Q, PT := T#100ms);\nIF t.Q THEN\n    state := state + 1;\nELSIF level > 10.0 THEN\n   "
        " state := 0;\nEND_IF\n"
        "CASE state OF\n    0: buffer[0] := level * 2.0;\n    1, 2: buffer[state] := buffer[state - 1] + level / "
        "3.0;\nELSE\n    state := LIMIT(0, state, 9);\nEND_CASE\nEND_FUNCTION_BLOCK\n";
    std::string text;
    for (int i = 0; i < 400; ++i) text += unit;
    double best = 1e9;
    size_t lines = 0;
    for (int i = 0; i < 3; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        const Parsed parsed(text);
        best =
            std::min(best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
        EXPECT_EQ(parsed.errors(), 0u);
        lines = parsed.sources.files[0].lineCount();
    }
    std::printf("%zu lines read in %.1f ms\n", lines, best);
    RecordProperty("milliseconds", static_cast<int>(best));
    EXPECT_LT(best, 3000.0); // a hang, not a slow machine
    std::string parens(200000, '('), ifs;
    for (int i = 0; i < 50000; ++i) ifs += "CASE a OF 1: ";
    EXPECT_NE(Parsed("PROGRAM p x := " + parens).file, nullptr);
    EXPECT_NE(Parsed("PROGRAM p " + ifs).file, nullptr);
    EXPECT_NE(Parsed("PROGRAM p VAR x : " +
                     [] {
                         std::string s;
                         for (int i = 0; i < 50000; ++i) s += "ARRAY[1..2] OF ";
                         return s;
                     }())
                  .file,
              nullptr);
}
