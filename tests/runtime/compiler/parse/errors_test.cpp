#include "tests/runtime/compiler/parse/outline.h"

#include <gtest/gtest.h>

using namespace plc::parse::testing;

namespace {
struct Row {
    const char* body; // of a program that starts on line 1, so the body's first line is 2
    const char* codes;
};
} // namespace

TEST(SyntaxErrors, GiveOneMessageForOneMistake) {
    for (const Row& row : {
             Row{"a := 1\nb := 2;", "P1011@2:6"},
             {"a := b c;", "P1013@2:8"},
             {"a := ;", "P1010@2:6"},
             {"a := (b + c;\nd := 1;", "P1010@2:12"},
             {"a := b + c);\nd := 1;", "P1013@2:11"},
             {"y = ln(x);", "P1014@2:3"},
             {"IF a := b THEN c := 1; END_IF", "P1015@2:6"},
             {"WHILE (a := b) AND c DO END_WHILE", "P1015@2:10"},
             {"IF a\n  b := 1;\nEND_IF", "P1010@2:4"},
             {"IF a THEN b := 1;\nc := 2;", "P1012@2:1"},
             {"FOR i := 1 TO 3 DO\n IF a THEN b := 1;\nEND_FOR\nc := 1;", "P1012@3:2"},
             {"END_IF\na := 1;", "P1013@2:1"},
             {"x := 3,14;", "P1017@2:6"},
             {"x := 'abc;\ny := 1;", "P1003@2:6"},
             {"foo('abc);\ny := 1;", "P1003@2:5"},
             {"x := 5 $ 3;", "P1001@2:8"},
             {"x := |a| + |b|;\ny := 1;", "P1001@2:6"},
             {"x := \xE2\x80\x98text\xE2\x80\x99;", "P1001@2:6"},
             {"x := a \xE2\x80\x93 b;", "P1001@2:8"},
             {"(* never closed\nx := 1;", "P1002@2:1"},
             {"f(a b);", "P1010@2:5"},
             {"f(a, );", "P1010@2:6"},
             {"a[, 2] := 1;", "P1010@2:3"},
             {"a[1, , 2] := 1;", "P1010@2:6"},
             {"a[1, ] := 1;", "P1010@2:6"},
             {"a[] := 1;", "P1010@2:3"},
             {"f(a;\nx := 1;", "P1010@2:4"},
             {"FOR i = 1 TO 3 DO END_FOR", "P1010@2:7"},
             {"FOR i := 1 DO END_FOR", "P1010@2:12"},
             {"CASE x OF\n 1: a := 1;\n 2 a := 2;\nEND_CASE", "P1013@4:2"},
             {"motor.\nx := 1;", "P1010@3:1"},
             {"REPEAT a := 1; END_REPEAT", "P1010@2:16"},
             {"IFF a THEN b := 1; END_IF", "P1010@2:1"},
             {"WHLIE a DO b := 1; END_WHILE", "P1010@2:1"},
             {"a := INT#;", "P1010@2:10"},
             {"x := 16#G;", "P1005@2:6"},
             {"a + b;", "P1013@2:3"},
             {"a := b ELSE c := d;", "P1011@2:6"},
             {"RUN T#5s;", "P6001@2:1"},
             {"x : = 5;", "P1010@2:3"},
         }) {
        const std::string text = std::string("PROGRAM p\n") + row.body + "\nEND_PROGRAM\n";
        EXPECT_EQ(Parsed(text).codes(), row.codes) << row.body;
    }
}

TEST(SyntaxErrors, InDeclarations) {
    for (const Row& row : {
             Row{"PROGRAM p\nVAR x INT; END_VAR END_PROGRAM", "P1016@2:5"},
             {"PROGRAM p\nVAR x : INT y : INT; END_VAR END_PROGRAM", "P1011@2:11"},
             {"PROGRAM p\nVAR x : INT\n y : INT; END_VAR END_PROGRAM", "P1011@2:11"},
             {"PROGRAM p\nVAR x := INT; END_VAR END_PROGRAM", "P1010@2:7"},
             {"PROGRAM p\nVAR x : ; y : INT; END_VAR END_PROGRAM", "P1010@2:9"},
             {"PROGRAM p\nVAR x y : INT; END_VAR END_PROGRAM", "P1010@2:7"},
             {"PROGRAM p\nVAR x : INT;\nx := 1;\nEND_PROGRAM", "P1012@2:1"},
             {"PROGRAM p\nVAR x : ARRAY[1..] OF INT; END_VAR END_PROGRAM", "P1018@2:15"},
             {"PROGRAM p\nVAR x : ARRAY[1..3] INT; END_VAR END_PROGRAM", "P1010@2:21"},
             {"PROGRAM p\nVAR x : ARRAY 1..3 OF INT; END_VAR END_PROGRAM", "P1010@2:15"},
             {"PROGRAM p\nVAR x AT : BOOL; y : INT; END_VAR END_PROGRAM", "P1010@2:10"},
             {"PROGRAM p\nVAR 1x : BOOL; y : INT; END_VAR END_PROGRAM", "P1005@2:5"},
             {"PROGRAM\nVAR x : INT; END_VAR END_PROGRAM", "P1010@2:1"},
             {"PROGRAM p\nEND_FUNCTION", "P1010@2:1"},
             {"TYPE t STRUCT a : INT; END_STRUCT END_TYPE", "P1016@1:6"},
             {"TYPE t : (a, b END_TYPE\nPROGRAM p END_PROGRAM", "P1010@1:16"},
             {"TYPE t : STRUCT a : INT; END_TYPE\nPROGRAM p END_PROGRAM", "P1012@1:10"},
             {"x := 1;\ny := 2;\nPROGRAM p END_PROGRAM", "P1013@1:1"},
             {"FUNCTION_BLOCK f PROPERTY p : INT x := 1; END_PROPERTY END_FUNCTION_BLOCK", "P1010@1:35"},
             {"PROGRAM p STEP a: b(N) END_STEP STEP c END_STEP END_PROGRAM", "P1022@1:22 P1010@1:38"},
             {"PROGRAM p STEP a: END_STEP TRANSITION FROM a TO a := x END_TRANSITION END_PROGRAM", "P1022@1:54"},
             {"PROGRAM p STEP a: END_STEP TRANSITION a TO a := x; END_TRANSITION END_PROGRAM", "P1010@1:41"},
             {"PROGRAM p STEP a: TRANSITION FROM a TO b := x; END_TRANSITION END_PROGRAM", "P1012@1:11"},
             {"PROGRAM p\nLD a\nAND( b\nST c\nEND_PROGRAM", "P4022@3:1"},
             {"PROGRAM p\nLD a\nx := 5;\nST c\nEND_PROGRAM", "P1013@3:3"},
             {"CONFIGURATION c RESOURCE r TASK t(INTERVAL := T#1s) PROGRAM p : q; END_RESOURCE END_CONFIGURATION",
              "P1011@1:51"},
             {"{wrongpragma x}\nPROGRAM p END_PROGRAM", "P1020@1:1"},
         })
        EXPECT_EQ(Parsed(row.body).codes(), row.codes) << row.body;
}

TEST(SyntaxErrors, TwentyMistakesGiveAboutTwentyMessages) {
    std::string text = "PROGRAM p\nVAR a, b : INT; END_VAR\n";
    for (int i = 0; i < 5; ++i) text += "a := b +;\nIF a THEN b := (1; END_IF\na = 3;\nb := 1,5;\nok := TRUE;\n";
    text += "END_PROGRAM\n";
    const Parsed parsed(text);
    EXPECT_EQ(parsed.errors(), 20u) << parsed.codes();
}

TEST(SyntaxErrors, AFileThatIsNoTextIsOneMessage) {
    std::string picture = "\x89PNG\r\n\x1A\n";
    for (int i = 0; i < 20'000; ++i) picture += static_cast<char>((i * 7919 + i / 13) % 251);
    EXPECT_EQ(Parsed(picture).codes(), "P1004@1:1");
    EXPECT_EQ(Parsed(std::string(100, '\0')).codes(), "P1004@1:1");
    // A slip of the keyboard is only itself.
    EXPECT_EQ(Parsed("PROGRAM p\na := 1;\x01\nEND_PROGRAM").codes(), "P1001@2:8");
    EXPECT_EQ(Parsed("PROGRAM p\nEND_PROGRAM\n\x1A").errors(), 1u);
}

TEST(SyntaxErrors, OfferAFixThatMends) {
    for (const char* text :
         {"PROGRAM p\na := 1\nb := 2;\nEND_PROGRAM", "PROGRAM p\ny = ln(x);\nEND_PROGRAM",
          "PROGRAM p\nIF a := b THEN c(); END_IF\nEND_PROGRAM", "PROGRAM p\nx := 3,14;\nEND_PROGRAM",
          "PROGRAM p VAR x INT; END_VAR END_PROGRAM", "TYPE t STRUCT END_STRUCT END_TYPE",
          "PROGRAM p VAR_IN_OUT x : ARRAY[1.., 0..] OF INT; END_VAR END_PROGRAM",
          "PROGRAM p\nIF a\n b(); END_IF\nEND_PROGRAM", "PROGRAM p\nx := 'a;\nEND_PROGRAM",
          "PROGRAM p\nIFF a THEN END_IF\nEND_PROGRAM", "PROGRAM p\nx := a \xE2\x80\x93 b;\nEND_PROGRAM",
          "PROGRAM p\nx := \xE2\x80\x98t\xE2\x80\x99;\nEND_PROGRAM", "PROGRAM p END_FUNCTION",
          "PROGRAM p\nIF a THEN\n b();\nEND_PROGRAM", "PROGRAM p\nVAR x : INT;\nx := 1;\nEND_PROGRAM"}) {
        const Parsed parsed(text);
        ASSERT_EQ(parsed.diagnostics.size(), 1u) << text << parsed.codes();
        ASSERT_EQ(parsed.diagnostics[0].fixes.size(), 1u) << text;
        std::string repaired = text;
        auto edits = parsed.diagnostics[0].fixes[0].edits;
        for (auto it = edits.rbegin(); it != edits.rend(); ++it)
            repaired.replace(it->range.begin, it->range.length(), it->text);
        const Parsed again(repaired);
        EXPECT_EQ(again.codes(), "") << repaired;
    }
}
