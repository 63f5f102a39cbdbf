// What is declared in the worst order, nested or doubled without end is checked or reported, never an end of the
// process.
#include "tests/runtime/compiler/sema/checked.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

using namespace plc;
using namespace plc::sema_test;

namespace {

const char* const kMain = "PROGRAM Main\nVAR a : INT; END_VAR\na := a + 1;\nEND_PROGRAM\n";

/// `line` for each of last..first (the worst order) or first..last.
std::string lines(int first, int last, const std::function<std::string(const std::string&, const std::string&)>& line) {
    std::string out;
    const int step = first <= last ? 1 : -1;
    for (int i = first; i != last + step; i += step) out += line(std::to_string(i), std::to_string(i - 1)) + "\n";
    return out;
}

std::string repeated(const std::string& text, int times) {
    std::string out;
    for (int i = 0; i < times; ++i) out += text;
    return out;
}

/// The codes of all errors, each once.
std::string errorsOf(const std::string& text) {
    std::set<std::string> codes;
    const CheckedText checked = check(text);
    for (const diagnostics::Diagnostic& diagnostic : checked.analysis->diagnostics)
        if (diagnostic.severity == diagnostics::Severity::Error)
            codes.insert(std::string(diagnostics::codeOf(diagnostic.kind)));
    std::string out;
    for (const std::string& code : codes) out += (out.empty() ? "" : " ") + code;
    return out;
}

constexpr int kMany = 20'000;

} // namespace

TEST(Limits, ConstantsMayBeDeclaredInAnyOrder) {
    const auto constant = [](const std::string& i, const std::string& before) {
        return "c" + i + " : DINT := c" + before + " + 1;";
    };
    const std::string list = lines(kMany, 1, constant);
    EXPECT_EQ(errorsOf("VAR_GLOBAL CONSTANT\n" + list + "c0 : DINT := 1;\nEND_VAR\n" + kMain), "");
    EXPECT_EQ(
        errorsOf("{gvl L}\nVAR_GLOBAL CONSTANT\n" +
                 lines(kMany, 1, [](const auto& i, const auto& b) { return "c" + i + " : DINT := L.c" + b + ";"; }) +
                 "c0 : DINT := 1;\nEND_VAR\n" + kMain),
        "");
    EXPECT_EQ(errorsOf("PROGRAM Main\nVAR CONSTANT\n" + list +
                       "c0 : DINT := 1;\nEND_VAR\nVAR a : DINT; END_VAR\na := c" + std::to_string(kMany) +
                       ";\nEND_PROGRAM\n"),
              "");
    // a cycle at the end of the chain is still one
    EXPECT_NE(errorsOf("VAR_GLOBAL CONSTANT\n" + lines(40, 1, constant) + "c0 : DINT := c3;\nEND_VAR\n" + kMain)
                  .find("P3003"),
              std::string::npos);
    EXPECT_NE(errorsOf("VAR_GLOBAL CONSTANT\n" + list + "c0 : DINT := c3;\nEND_VAR\n" + kMain), "");
}

TEST(Limits, ChainsOfTypesInReverseOrderAreReported) {
    struct Row {
        const char* what;
        std::string text;
        const char* errors;
    };
    const auto types = [](const std::function<std::string(const std::string&, const std::string&)>& line,
                          const std::string& last) {
        return "TYPE\n" + lines(kMany, 1, line) + last + "\nEND_TYPE\n" + kMain;
    };
    const std::vector<Row> rows = {
        {"aliases", types([](auto& i, auto& b) { return "A" + i + " : A" + b + ";"; }, "A0 : INT;"), "P1019"},
        {"aliases with values", types([](auto& i, auto& b) { return "A" + i + " : A" + b + " := 1;"; }, "A0 : INT;"),
         "P1019"},
        {"arrays", types([](auto& i, auto& b) { return "A" + i + " : ARRAY[0..0] OF A" + b + ";"; }, "A0 : INT;"),
         "P1019"},
        {"pointers", types([](auto& i, auto& b) { return "A" + i + " : POINTER TO A" + b + ";"; }, "A0 : INT;"),
         "P1019"},
        {"enumerations",
         types([](auto& i, auto& b) { return "E" + i + " : (a" + i + " := a" + b + ");"; }, "E0 : (a0);"), "P1019"},
        {"structures",
         types([](auto& i, auto& b) { return "S" + i + " : STRUCT a : S" + b + "; END_STRUCT"; },
               "S0 : STRUCT a : INT; END_STRUCT"),
         "P1019"},
        {"bases of structures",
         types([](auto& i, auto& b) { return "S" + i + " EXTENDS S" + b + " : STRUCT END_STRUCT"; },
               "S0 : STRUCT a : INT; END_STRUCT"),
         "P1019"},
        {"bases of blocks",
         lines(kMany, 1,
               [](auto& i, auto& b) { return "FUNCTION_BLOCK B" + i + " EXTENDS B" + b + "\nEND_FUNCTION_BLOCK"; }) +
             "FUNCTION_BLOCK B0\nEND_FUNCTION_BLOCK\n" + kMain,
         "P1019"},
        {"bases of interfaces",
         lines(kMany, 1, [](auto& i, auto& b) { return "INTERFACE I" + i + " EXTENDS I" + b + "\nEND_INTERFACE"; }) +
             "INTERFACE I0\nEND_INTERFACE\n" + kMain,
         "P1019"},
        {"instances",
         lines(kMany, 1,
               [](auto& i, auto& b) {
                   return "FUNCTION_BLOCK B" + i + "\nVAR b : B" + b + "; END_VAR\nb();\nEND_FUNCTION_BLOCK";
               }) +
             "FUNCTION_BLOCK B0\nEND_FUNCTION_BLOCK\n" + kMain,
         "P1019"},
        {"lengths",
         "VAR_GLOBAL\n" +
             lines(kMany, 1,
                   [](auto& i, auto& b) { return "s" + i + " : ARRAY[0..SIZEOF(s" + b + ") - 1] OF BYTE;"; }) +
             "s0 : BYTE;\nEND_VAR\n" + kMain,
         "P1019"},
    };
    for (const Row& row : rows) EXPECT_EQ(errorsOf(row.text), row.errors) << row.what;
}

TEST(Limits, NestingInTheBestOrderIsReportedToo) {
    const std::string structures =
        "TYPE\nS0 : STRUCT a : INT; END_STRUCT\n" +
        lines(1, kMany, [](auto& i, auto& b) { return "S" + i + " : STRUCT a : S" + b + "; END_STRUCT"; }) +
        "END_TYPE\n";
    EXPECT_EQ(errorsOf(structures + "PROGRAM Main\nVAR s : S" + std::to_string(kMany) + "; END_VAR\nEND_PROGRAM\n"),
              "P1019");
    const std::string pointers =
        "TYPE\nP0 : INT;\n" + lines(1, kMany, [](auto& i, auto& b) { return "P" + i + " : POINTER TO P" + b + ";"; }) +
        "END_TYPE\n";
    EXPECT_EQ(errorsOf(pointers + kMain), "P1019");
    const std::string bases = "FUNCTION_BLOCK B0\nEND_FUNCTION_BLOCK\n" + lines(1, 3000, [](auto& i, auto& b) {
                                  return "FUNCTION_BLOCK B" + i + " EXTENDS B" + b + "\nEND_FUNCTION_BLOCK";
                              });
    EXPECT_EQ(errorsOf(bases + kMain), "P1019");
    // what an engineer writes is far below
    const std::string fifty =
        "TYPE\n" + lines(50, 1, [](auto& i, auto& b) { return "S" + i + " : STRUCT a : S" + b + "; END_STRUCT"; }) +
        "S0 : STRUCT a : INT := 3; END_STRUCT\nEND_TYPE\nPROGRAM Main\nVAR s : S50; END_VAR\nEND_PROGRAM\n";
    EXPECT_EQ(errorsOf(fifty), "");
    const std::string list = "TYPE\nNode : STRUCT next : POINTER TO Node; value : Item; END_STRUCT\n"
                             "Item : STRUCT owner : POINTER TO Node; END_STRUCT\nEND_TYPE\n";
    EXPECT_EQ(errorsOf(list + kMain), "");
}

/// Of each level there are two interfaces, which both extend both of the level below: 2^80 ways to the last.
TEST(Limits, InterfacesOnManyWaysAreSearchedOnce) {
    std::string text = "INTERFACE A0\nMETHOD m : INT\nEND_METHOD\nEND_INTERFACE\nINTERFACE B0\nEND_INTERFACE\n";
    text += lines(1, 80, [](auto& i, auto& b) {
        return "INTERFACE A" + i + " EXTENDS A" + b + ", B" + b + "\nEND_INTERFACE\nINTERFACE B" + i + " EXTENDS A" +
               b + ", B" + b + "\nEND_INTERFACE";
    });
    text += "FUNCTION_BLOCK F IMPLEMENTS A80\nMETHOD m : INT\nm := 1;\nEND_METHOD\nEND_FUNCTION_BLOCK\n"
            "PROGRAM Main\nVAR f : F; i : A80; n : INT; END_VAR\ni := f;\nn := i.m() + i.none;\nEND_PROGRAM\n";
    EXPECT_EQ(errorsOf(text), "P2002");
}

/// Each asked the other what the value is, until the stack was full.
TEST(Limits, ElementsForAStructureAreAMistake) {
    const std::string type = "TYPE S : STRUCT a : INT; END_STRUCT END_TYPE\nFUNCTION_BLOCK F\nEND_FUNCTION_BLOCK\n";
    EXPECT_EQ(errorsOf(type + "PROGRAM Main\nVAR s : S := [1, 2]; END_VAR\nEND_PROGRAM\n"), "P2003");
    EXPECT_EQ(errorsOf(type + "PROGRAM Main\nVAR s : S; END_VAR\ns := [1, 2];\nEND_PROGRAM\n"), "P2003");
    EXPECT_EQ(errorsOf(type + "PROGRAM Main\nVAR f : F := [1]; END_VAR\nEND_PROGRAM\n"), "P2003");
    EXPECT_EQ(errorsOf(type + "PROGRAM Main\nVAR s : ARRAY[1..2] OF S := [[1], [2]]; END_VAR\nEND_PROGRAM\n"), "P2003");
}

TEST(Limits, WhatDoublesWithEachLineIsReportedWhereItIsTooLarge) {
    const std::string structures =
        "TYPE\nT0 : STRUCT a : INT := 1; END_STRUCT\n" +
        lines(1, 70, [](auto& i, auto& b) { return "T" + i + " : STRUCT a, b : T" + b + "; END_STRUCT"; }) +
        "END_TYPE\n";
    EXPECT_EQ(errorsOf(structures + "PROGRAM Main\nVAR t : T70; END_VAR\nEND_PROGRAM\n"), "P3023");
    const std::string blocks =
        "FUNCTION_BLOCK B0\nVAR x : INT := 1; END_VAR\nEND_FUNCTION_BLOCK\n" + lines(1, 50, [](auto& i, auto& b) {
            return "FUNCTION_BLOCK B" + i + "\nVAR a, b : B" + b + "; END_VAR\na(); b();\nEND_FUNCTION_BLOCK";
        });
    EXPECT_EQ(errorsOf(blocks + "PROGRAM Main\nVAR b : B50; END_VAR\nb();\nEND_PROGRAM\n"), "P3023");
    const std::string arrays =
        "TYPE\nA0 : ARRAY[0..999] OF S; S : STRUCT x : INT := 3; END_STRUCT\n" +
        lines(1, 20, [](auto& i, auto& b) { return "A" + i + " : ARRAY[0..999] OF A" + b + ";"; }) + "END_TYPE\n";
    EXPECT_EQ(errorsOf(arrays + "PROGRAM Main\nVAR a : A20; END_VAR\nEND_PROGRAM\n"), "P3023");
}

TEST(Limits, SumsOfSizesDoNotWrap) {
    const std::string big = "ARRAY[0..268435455] OF BYTE";
    std::string sixteen;
    for (int i = 0; i < 16; ++i) sixteen += "t" + std::to_string(i) + " : " + big + ";\n";
    EXPECT_EQ(errorsOf("FUNCTION F : INT\nVAR_INPUT q : DINT; END_VAR\nVAR\n" + sixteen +
                       "END_VAR\nt15[q] := 5;\nF := t15[q];\nEND_FUNCTION\nPROGRAM Main\nVAR a : INT; END_VAR\na := "
                       "F(1);\nEND_PROGRAM\n"),
              "P3023");
    EXPECT_EQ(errorsOf("FUNCTION_BLOCK B\nVAR\n" + sixteen +
                       "END_VAR\nEND_FUNCTION_BLOCK\nPROGRAM Main\nVAR b : B; END_VAR\nb();\nEND_PROGRAM\n"),
              "P3023");
    EXPECT_EQ(errorsOf("TYPE S : STRUCT\n" + sixteen +
                       "END_STRUCT END_TYPE\nPROGRAM Main\nVAR s : S; END_VAR\nEND_PROGRAM\n"),
              "P3023");
    EXPECT_EQ(
        errorsOf(
            "PROGRAM Main\nVAR a : ARRAY[0..65535, 0..65535, 0..65535, 0..65535] OF LREAL; END_VAR\nEND_PROGRAM\n"),
        "P3023");
    // VAR_TEMP: those that are used
    std::string uses;
    for (int i = 0; i < 16; ++i) uses += "t" + std::to_string(i) + "[5] := 1;\n";
    EXPECT_EQ(errorsOf("PROGRAM Main\nVAR_TEMP\n" + sixteen + "END_VAR\n" + uses + "END_PROGRAM\n"), "P3023");
    // a path of calls
    const std::string path = "FUNCTION F0 : INT\nVAR t : " + big +
                             "; END_VAR\nt[1] := 5;\nF0 := t[1];\nEND_FUNCTION\n" + lines(1, 15, [&](auto& i, auto& b) {
                                 return "FUNCTION F" + i + " : INT\nVAR t : " + big + "; END_VAR\nt[1] := 5;\nF" + i +
                                        " := t[1] + F" + b + "();\nEND_FUNCTION";
                             });
    EXPECT_EQ(errorsOf(path + "PROGRAM Main\nVAR a : INT; END_VAR\na := F15();\nEND_PROGRAM\n"), "P3023");
    EXPECT_EQ(errorsOf("PROGRAM Main\nVAR t : ARRAY[0..200000000] OF BYTE; END_VAR\nt[5] := 1;\nEND_PROGRAM\n"), "");
}

TEST(Limits, InitialValuesTakeNoMoreThanTheyMay) {
    const std::string nested = repeated("2(", 80) + "1" + repeated(")", 80);
    EXPECT_EQ(
        errorsOf("PROGRAM Main\nVAR a : ARRAY[0..3] OF INT := [" + nested + "]; END_VAR\na[0] := 1;\nEND_PROGRAM\n"),
        "P3031");
    EXPECT_EQ(errorsOf("PROGRAM Main\nVAR x : INT; a : ARRAY[0..200000000] OF INT := [200000001(x)]; END_VAR\nx := "
                       "a[0];\nEND_PROGRAM\n"),
              "P3023");
    EXPECT_EQ(errorsOf("PROGRAM Main\nVAR x : INT; a : ARRAY[0..100000000] OF INT := [100000001(x)]; END_VAR\nx := "
                       "a[0];\nEND_PROGRAM\n"),
              "P2019");
    const std::string function =
        "FUNCTION F : INT\nVAR_INPUT a : ARRAY[0..100000000] OF BYTE; b : INT; END_VAR\nF := a[1] + b;\nEND_FUNCTION\n";
    EXPECT_EQ(errorsOf(function + "PROGRAM Main\nVAR x : INT; END_VAR\nx := F(b := 1);\nEND_PROGRAM\n"), "P3023");
    EXPECT_EQ(errorsOf("FUNCTION F : INT\nVAR a : ARRAY[0..100000000] OF BYTE := [100000001(1)]; END_VAR\nF := "
                       "a[1];\nEND_FUNCTION\n" +
                       std::string(kMain)),
              "P3023");
    EXPECT_EQ(
        errorsOf("PROGRAM Main\nVAR a : ARRAY[0..100000000] OF BYTE; END_VAR\na := [100000001(1)];\nEND_PROGRAM\n"),
        "P3023");
}

TEST(Limits, LongListsAreNoLongerThanTheyAre) {
    const std::string arms = lines(0, kMany, [](auto& i, auto&) { return i + " : b := " + i + ";"; });
    EXPECT_EQ(errorsOf("PROGRAM Main\nVAR a, b : DINT; END_VAR\nCASE a OF\n" + arms + "END_CASE\nEND_PROGRAM\n"), "");
    EXPECT_EQ(
        errorsOf("PROGRAM Main\nVAR a, b : DINT; END_VAR\nCASE a OF\n" + arms + "7 : b := 1;\nEND_CASE\nEND_PROGRAM\n"),
        "P3010");
    EXPECT_EQ(errorsOf("PROGRAM Main\nVAR a : ULINT; b : DINT; END_VAR\nCASE a OF\n18446744073709551615 : b := "
                       "1;\n0..9223372036854775807 : b := 2;\n"
                       "18446744073709551600..18446744073709551615 : b := 3;\nEND_CASE\nEND_PROGRAM\n"),
              "P3010");
    std::string names = "e0";
    for (int i = 1; i < kMany; ++i) names += ",\ne" + std::to_string(i);
    const std::string members = lines(0, kMany - 1, [](auto& i, auto&) { return "E.e" + i + " : b := " + i + ";"; });
    EXPECT_EQ(errorsOf("TYPE E : (" + names +
                       ") DINT; END_TYPE\nPROGRAM Main\nVAR a : E; b : DINT; END_VAR\nCASE a OF\n" + members +
                       "END_CASE\nEND_PROGRAM\n"),
              "");
    const std::string fields = lines(0, kMany, [](auto& i, auto&) { return "f" + i + " : INT;"; });
    const std::string uses = lines(0, kMany, [](auto& i, auto&) { return "s.F" + i + " := 1;"; });
    EXPECT_EQ(errorsOf("TYPE S : STRUCT\n" + fields + "END_STRUCT END_TYPE\nPROGRAM Main\nVAR s : S; END_VAR\n" + uses +
                       "s.g := 1;\nEND_PROGRAM\n"),
              "P2002");
    const std::string located = lines(1, kMany, [](auto& i, auto&) { return "v" + i + " AT %MW" + i + " : INT;"; });
    EXPECT_EQ(errorsOf("VAR_GLOBAL\n" + located + "END_VAR\n" + kMain), "");
    EXPECT_EQ(errorsOf("NAMESPACE " + repeated("n.", kMany) + "n\nEND_NAMESPACE\n" + kMain), "P1019");
}
