// Programs whose one scan takes years, one for each kind of work that it may be in when somebody asks for its end. No
// task is configured: whoever runs them gives the watchdog its time. Values.
#pragma once
#include "tests/support/long_scans.h"

namespace plc {

inline std::vector<LongScan> kindsOfLongScans() {
    const auto inMain = [](const std::string& variables, const std::string& statements) {
        return "PROGRAM Main\nVAR\n" + variables + "\nEND_VAR\n" + statements + "\nEND_PROGRAM\n";
    };
    const std::string forEver = "WHILE i >= 0 DO ", end = " i := i + 1; END_WHILE";
    return {
        {"Texts",
         inMain("i : LINT; s, r : STRING(60000);",
                "s := 'a'; FOR i := 1 TO 15 DO s := CONCAT(s, s); END_FOR\n" + forEver +
                    "r := REPLACE(INSERT(DELETE(s, 5, 7), 'abc', 100), 'xyz', 10, 10); IF r = s OR r < s THEN i := 0; "
                    "END_IF;" +
                    end),
         "i"},
        {"WideTexts",
         inMain("i : LINT; s, r : WSTRING(30000);", "s := \"a\"; FOR i := 1 TO 14 DO s := CONCAT(s, s); END_FOR\n" +
                                                        forEver + "r := CONCAT(RIGHT(s, 9000), LEFT(s, 9000));" + end),
         "i"},
        {"Conversions",
         inMain("i : LINT; s : STRING; r : LREAL;",
                forEver + "s := LREAL_TO_STRING(r); r := STRING_TO_LREAL(s) + 1.5; s := CONCAT(LINT_TO_STRING(i), s);" +
                    end),
         "i"},
        {"Structures",
         "TYPE S : STRUCT x : ARRAY[0..100000] OF LREAL; t : ARRAY[0..100] OF STRING(200); END_STRUCT END_TYPE\n" +
             inMain("a, b : ARRAY[0..20] OF S; i : DINT;", forEver + "a[i MOD 20].x[3] := i; b := a;" + end),
         "i"},
        {"LargeParameters",
         "FUNCTION_BLOCK B\nVAR_INPUT a : ARRAY[0..10000000] OF BYTE; END_VAR\nVAR_OUTPUT c : ARRAY[0..10000000] OF "
         "BYTE; END_VAR\nc := a;\nEND_FUNCTION_BLOCK\n" +
             inMain("b : B; x : ARRAY[0..10000000] OF BYTE; i : LINT;", forEver + "b(a := x, c => x);" + end),
         "i"},
        {"CaughtFaults",
         inMain("i, z : DINT; e : __SYSTEM.ExceptionCode;",
                forEver + "__TRY z := 1 / (z - z); __CATCH(e) z := z + 1; __ENDTRY" + end),
         "i"},
        {"Methods",
         "FUNCTION_BLOCK B\nMETHOD Deep : LINT\nVAR_INPUT n : LINT; END_VAR\nIF n <= 0 THEN Deep := 1; ELSE Deep := "
         "Deep(n - 1) + Deep(n - 2); END_IF\nEND_METHOD\nPROPERTY P : LINT\nGET\nP := "
         "Deep(90);\nEND_GET\nEND_PROPERTY\n"
         "END_FUNCTION_BLOCK\n" +
             inMain("b : B; y : LINT;", "y := b.P;"),
         "y"},
        {"Interfaces",
         "INTERFACE I\nMETHOD M : LINT\nVAR_INPUT n : LINT; END_VAR\nEND_METHOD\nEND_INTERFACE\nFUNCTION_BLOCK B "
         "IMPLEMENTS I\nVAR_INPUT nx : I; END_VAR\nMETHOD M : LINT\nVAR_INPUT n : LINT; END_VAR\nIF n <= 0 THEN M := "
         "1; ELSE "
         "M "
         ":= nx.M(n - 1) + nx.M(n - 2); END_IF\nEND_METHOD\nEND_FUNCTION_BLOCK\n" +
             inMain("a, b : B; y : LINT;", "a.nx := b; b.nx := a; y := a.M(90);"),
         "y"},
        {"InstructionList",
         "PROGRAM Main\nVAR a : LINT; END_VAR\nLD 0\nST a\nagain:\nLD a\nADD LINT#1\nST a\nJMP again\nEND_PROGRAM\n",
         "a"},
        {"Sorting",
         inMain("a : ARRAY[0..1000000] OF LREAL; i, j : DINT; t : LREAL;",
                "FOR i := 0 TO 1000000 DO a[i] := 1000000 - i; END_FOR\nFOR i := 0 TO 999999 DO FOR j := 0 TO 999999 - "
                "i DO IF a[j] > a[j + 1] THEN t := a[j]; a[j] := a[j + 1]; a[j + 1] := t; END_IF END_FOR END_FOR"),
         "i"},
        {"Mathematics",
         inMain("x : LREAL; i : LINT;",
                forEver + "x := EXPT(1.0000001, i) + SIN(x) + LN(x + 2) + SQRT(x) + ATAN(x);" + end),
         "i"},
        {"ClearedLocals",
         "FUNCTION F : BYTE\nVAR_INPUT q : DINT; END_VAR\nVAR t : ARRAY[0..20000000] OF BYTE; END_VAR\nt[q] := 5; F := "
         "t[q];\nEND_FUNCTION\n" +
             inMain("i : DINT; b : BYTE;", forEver + "b := b + F(i MOD 1000);" + end),
         "i"},
        {"Plant",
         "{attribute 'simulation'}\nPROGRAM Plant\nVAR i : LINT; END_VAR\n" + forEver + end + "\nEND_PROGRAM\n" +
             inMain("i : LINT;", "i := i + 1;"),
         "i"},
    };
}

} // namespace plc
