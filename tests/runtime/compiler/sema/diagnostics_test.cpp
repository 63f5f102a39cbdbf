// Every message of P2xxx and P3xxx: a program that causes it, with the text it points at, and one that does not.
#include "tests/runtime/compiler/sema/checked.h"

#include <gtest/gtest.h>

using namespace plc;
using namespace plc::sema_test;

namespace {

struct Row {
    const char* code;
    const char* wrong;
    std::vector<std::string> expected; // all messages that are no infos (infos too where the code is one)
    const char* right;
};

/// VAR … | statements → a program; a text that declares units itself stays as it is.
std::string program(std::string_view text) {
    const size_t bar = text.find('|');
    if (bar == std::string_view::npos) return std::string(text);
    return "PROGRAM Main\nVAR\n" + std::string(text.substr(0, bar)) + "\nEND_VAR\n" +
           std::string(text.substr(bar + 1)) + "\nEND_PROGRAM\n";
}

const Row kExpressions[] = {
    {"P2001", "x : INT;|x := y;", {"P2001 'y'"}, "x, y : INT;|x := y; y := 1;"},
    {"P2001",
     "x : INT;|x := missing + 1; missing2();",
     {"P2001 'missing'", "P2001 'missing2'"},
     "x : INT;|x := x + 1;"},
    {"P2002", "t : TON;|t(IN := t.Z);", {"P2002 'Z'"}, "t : TON;|t(IN := t.Q);"},
    {"P2002",
     "TYPE P : STRUCT x : INT; END_STRUCT END_TYPE PROGRAM Main VAR p : P; END_VAR p.y := 1; END_PROGRAM",
     {"P2002 'y'"},
     "TYPE P : STRUCT x : INT; END_STRUCT END_TYPE PROGRAM Main VAR p : P; END_VAR p.x := 1; END_PROGRAM"},
    {"P2002",
     "TYPE C : (Red, Green); END_TYPE PROGRAM Main VAR c : C; END_VAR c := C.Blue; END_PROGRAM",
     {"P2002 'Blue'"},
     "TYPE C : (Red, Green); END_TYPE PROGRAM Main VAR c : C; END_VAR c := C.Green; END_PROGRAM"},
    {"P2003", "x : INT;|x := 'a text';", {"P2003 ''a text''"}, "x : INT;|x := STRING_TO_INT('12');"},
    {"P2003", "b : BOOL; r : REAL;|b := r;", {"P2003 'r'"}, "b : BOOL; r : REAL;|b := r > 0.0; r := 1.0;"},
    {"P2003", "t : TIME;|t := 5;", {"P2003 '5'"}, "t : TIME;|t := T#5ms;"},
    {"P2003",
     "a : ARRAY[1..3] OF INT; b : ARRAY[1..4] OF INT;|a := b;",
     {"P2003 'b'"},
     "a : ARRAY[1..3] OF INT; b : ARRAY[1..3] OF INT;|a := b;"},
    {"P2004", "i : INT; d : DINT := 5;|i := d;", {"P2004 'd'"}, "i : INT := 1; d : DINT;|d := i;"},
    {"P2004", "i : INT; r : REAL := 5;|i := r;", {"P2004 'r'"}, "i : INT := 1; r : REAL;|r := i;"},
    {"P2004", "r : REAL; l : LREAL := 1.0;|r := l;", {"P2004 'l'"}, "r : REAL := 1.0; l : LREAL;|l := r;"},
    {"P2005", "VAR CONSTANT c : INT := 5; END_VAR", {}, ""},
    {"P2005",
     "PROGRAM Main VAR CONSTANT c : INT := 5; END_VAR c := 6; END_PROGRAM",
     {"P2005 'c'"},
     "PROGRAM Main VAR c : INT := 5; END_VAR c := 6; END_PROGRAM"},
    {"P2005", "t : TON;|t.Q := TRUE;", {"P2005 't.Q'"}, "t : TON;|t.IN := TRUE; t();"},
    {"P2005", "x : INT;|x + 1 := 5;", {"P1013 '+'"}, "x : INT;|x := 5;"},
    {"P2006", "b : BOOL; c : BOOL;|b := b + c;", {"P2006 '+'"}, "b : BOOL; c : BOOL;|b := b OR c;"},
    {"P2006", "r : REAL;|r := NOT r;", {"P2006 'NOT r'"}, "w : WORD;|w := NOT w;"},
    {"P2006", "r : REAL;|r := r MOD 2.0;", {"P2006 'MOD'"}, "i : INT;|i := i MOD 2;"},
    {"P2006", "s : STRING; i : INT;|i := ABS(s);", {"P2006 's'"}, "i : INT;|i := ABS(i);"},
    {"P2006", "s : STRING;|s := SWAP(s);", {"P2006 's'"}, "w : WORD;|w := SWAP(w);"},
    {"P2007", "t : TIME; d : DATE;|t := t + d;", {"P2007 '+'"}, "t : TIME; d : DT;|d := d + t;"},
    {"P2007", "s : STRING; i : INT; b : BOOL;|b := s = i;", {"P2007 '='"}, "s : STRING; b : BOOL;|b := s = 'a';"},
    {"P2007", "r : REAL; b : BOOL;|b := r = NULL;", {"P2007 '='"}, "p : POINTER TO INT; b : BOOL;|b := p = NULL;"},
    {"P2007", "i : INT; b : BOOL;|b := i = NULL;", {"P2007 '='"}, "p : POINTER TO INT; b : BOOL;|b := p = NULL;"},
    {"P2007", "s : STRING; b : BOOL;|b := s = NULL;", {"P2007 '='"}, "p : POINTER TO INT; b : BOOL;|b := p = NULL;"},
    {"P2007", "f : TON; b : BOOL;|b := f = NULL;", {"P2007 '='"}, "p : POINTER TO INT; b : BOOL;|b := p = NULL;"},
    {"P2007",
     "a : ARRAY[1..2] OF INT; b : BOOL;|b := a = NULL;",
     {"P2007 '='"},
     "p : POINTER TO INT; b : BOOL;|b := p = NULL;"},
    {"P2008", "x : INT;|x();", {"P2008 'x'"}, "x : TON;|x();"},
    {"P2008", "x : INT;|TON(IN := TRUE); x := 1;", {"P2008 'TON'"}, "x : INT; t : TON;|t(IN := TRUE); x := 1;"},
    {"P2009", "t : TON;|t(INN := TRUE);", {"P2009 'INN'"}, "t : TON;|t(IN := TRUE);"},
    {"P2009",
     "r : REAL;|r := LIMIT(MN := 1.0, INN := r, MX := 2.0);",
     {"P2009 'INN'"},
     "r : REAL;|r := LIMIT(MN := 1.0, IN := r, MX := 2.0);"},
    {"P2010",
     "FUNCTION F : INT VAR_INPUT a, b : INT; END_VAR F := a + b; END_FUNCTION PROGRAM Main VAR x : INT; END_VAR x := "
     "F(1); END_PROGRAM",
     {"P2010 'F'"},
     "FUNCTION F : INT VAR_INPUT a, b : INT; END_VAR F := a + b; END_FUNCTION PROGRAM Main VAR x : INT; END_VAR x := "
     "F(1, 2); END_PROGRAM"},
    {"P2010",
     "FUNCTION_BLOCK B VAR_IN_OUT x : INT; END_VAR x := 1; END_FUNCTION_BLOCK PROGRAM Main VAR b : B; END_VAR b(); "
     "END_PROGRAM",
     {"P2010 'b'"},
     "FUNCTION_BLOCK B VAR_IN_OUT x : INT; END_VAR x := 1; END_FUNCTION_BLOCK PROGRAM Main VAR b : B; i : INT; END_VAR "
     "b(x := i); END_PROGRAM"},
    {"P2011", "r : REAL;|r := SIN(1.0, 2.0);", {"P2011 '2.0'"}, "r : REAL;|r := SIN(1.0);"},
    {"P2011",
     "FUNCTION F : INT VAR_INPUT a : INT; END_VAR F := a; END_FUNCTION PROGRAM Main VAR x : INT; END_VAR x := F(1, 2); "
     "END_PROGRAM",
     {"P2011 '2'"},
     "FUNCTION F : INT VAR_INPUT a : INT; END_VAR F := a; END_FUNCTION PROGRAM Main VAR x : INT; END_VAR x := F(1); "
     "END_PROGRAM"},
    {"P2012", "t : TON;|t(IN := TRUE, IN := FALSE);", {"P2012 'IN'"}, "t : TON;|t(IN := TRUE, PT := T#1s);"},
    {"P2013",
     "FUNCTION_BLOCK B VAR_IN_OUT x : INT; END_VAR x := 1; END_FUNCTION_BLOCK PROGRAM Main VAR b : B; END_VAR b(x := "
     "5); END_PROGRAM",
     {"P2013 '5'"},
     "FUNCTION_BLOCK B VAR_IN_OUT x : INT; END_VAR x := 1; END_FUNCTION_BLOCK PROGRAM Main VAR b : B; i : INT; END_VAR "
     "b(x := i); END_PROGRAM"},
    {"P2014", "x : INT;|x[1] := 5;", {"P2014 'x'"}, "x : ARRAY[1..2] OF INT;|x[1] := 5;"},
    {"P2015",
     "x : ARRAY[1..2, 1..2] OF INT;|x[1] := 5;",
     {"P2015 'x[1]'"},
     "x : ARRAY[1..2, 1..2] OF INT;|x[1, 2] := 5;"},
    {"P2016", "x : ARRAY[1..2] OF INT;|x[3] := 5;", {"P2016 '3'"}, "x : ARRAY[1..2] OF INT;|x[2] := 5;"},
    {"P2017", "x : INT;|x := x / 0;", {"P2017 '0'"}, "x : INT;|x := x / 2;"},
    {"P2017", "x : INT;|x := x MOD (1 - 1);", {"P2017 '(1 - 1)'"}, "x : REAL;|x := x / 0.0;"},
    {"P2018", "x : INT;|x := 40000;", {"P2018 '40000'"}, "x : DINT;|x := 40000;"},
    {"P2018", "x : BYTE := 256;|x := x;", {"P2018 '256'"}, "x : BYTE := 255;|x := x;"},
    {"P2018", "x : INT(1..10);|x := 11;", {"P2018 '11'"}, "x : INT(1..10);|x := 10;"},
    {"P2018", "x : SINT;|x := SINT#200;", {"P2018 'SINT#200'"}, "x : SINT;|x := SINT#16#FF;"},
    {"P2019",
     "x : INT; a : ARRAY[1..x] OF INT;|a[1] := 1; x := 1;",
     {"P2019 'x'"},
     "a : ARRAY[1..3] OF INT;|a[1] := 1;"},
    {"P2019",
     "x, y : INT;|CASE x OF y: x := 1; END_CASE y := 1;",
     {"P2019 'y'"},
     "x : INT;|CASE x OF 1: x := 1; END_CASE"},
    {"P2019",
     "FUNCTION F : INT VAR_INPUT a : INT; END_VAR VAR_STAT s : INT := a; END_VAR F := s; END_FUNCTION "
     "PROGRAM Main VAR x : INT; END_VAR x := F(1); END_PROGRAM",
     {"P2019 'a'"},
     "FUNCTION F : INT VAR_INPUT a : INT; END_VAR VAR s : INT := a; END_VAR F := s; END_FUNCTION "
     "PROGRAM Main VAR x : INT; END_VAR x := F(1); END_PROGRAM"},
    {"P2019",
     "FUNCTION F : INT VAR b AT %MW1 : INT := i; END_VAR VAR i : INT; END_VAR F := b; END_FUNCTION "
     "PROGRAM Main VAR x : INT; END_VAR x := F(); END_PROGRAM",
     {"P2019 'i'"},
     "FUNCTION F : INT VAR b AT %MW1 : INT := 3; END_VAR F := b; END_FUNCTION "
     "PROGRAM Main VAR x : INT; END_VAR x := F(); END_PROGRAM"},
    {"P2020", "x : INT;|x^ := 5;", {"P2020 'x'"}, "x : REF_TO INT; i : INT;|x := REF(i); x^ := 5;"},
    {"P2021", "x : BYTE;|x.8 := TRUE;", {"P2021 '8'"}, "x : BYTE;|x.7 := TRUE;"},
    {"P2022", "x : INT;|IF x THEN x := 1; END_IF", {"P2022 'x'"}, "x : INT;|IF x > 0 THEN x := 1; END_IF"},
    {"P2023",
     "FUNCTION F VAR_INPUT a : INT; END_VAR END_FUNCTION PROGRAM Main VAR x : INT; END_VAR x := F(1); END_PROGRAM",
     {"P2023 'F(1)'"},
     "FUNCTION F : INT VAR_INPUT a : INT; END_VAR F := a; END_FUNCTION PROGRAM Main VAR x : INT; END_VAR x := F(1); "
     "END_PROGRAM"},
    {"P2023",
     "x : BOOL; t : TON;|x := t(IN := TRUE);",
     {"P2023 't(IN := TRUE)'"},
     "x : BOOL; t : TON;|t(IN := TRUE, Q => x);"},
    {"P2024",
     "TYPE A : (Red, Green); END_TYPE TYPE B : (Red, Blue); END_TYPE PROGRAM Main VAR i : INT; END_VAR i := Red; "
     "END_PROGRAM",
     {"P2024 'Red'"},
     "TYPE A : (Red, Green); END_TYPE TYPE B : (Red, Blue); END_TYPE PROGRAM Main VAR b : B; END_VAR b := Red; b := "
     "B#Red; END_PROGRAM"},
    {"P2025",
     "FUNCTION_BLOCK ABSTRACT B END_FUNCTION_BLOCK PROGRAM Main VAR b : B; END_VAR b(); END_PROGRAM",
     {"P2025 'B'", "P2025 'b'"},
     "FUNCTION_BLOCK ABSTRACT B END_FUNCTION_BLOCK FUNCTION_BLOCK C EXTENDS B END_FUNCTION_BLOCK PROGRAM Main VAR b : "
     "C; END_VAR b(); END_PROGRAM"},
    {"P2026",
     "FUNCTION_BLOCK B METHOD PRIVATE M : INT M := 1; END_METHOD END_FUNCTION_BLOCK PROGRAM Main VAR b : B; i : INT; "
     "END_VAR i := b.M(); END_PROGRAM",
     {"P2026 'M'"},
     "FUNCTION_BLOCK B METHOD PUBLIC M : INT M := 1; END_METHOD END_FUNCTION_BLOCK PROGRAM Main VAR b : B; i : INT; "
     "END_VAR i := b.M(); END_PROGRAM"},
    {"P2027", "s : STRING;|s := 'Ω';", {"P2027 ''Ω''"}, "s : WSTRING;|s := \"Ω\";"},
    {"P2028", "s : STRING(3);|s := 'abcd';", {"P2028 ''abcd''"}, "s : STRING(4);|s := 'abcd';"},
    {"P2029", "r : REAL; i : INT := 3;|r := i / 2;", {"P2029 'i / 2'"}, "r : REAL; i : INT := 3;|r := i / 2.0;"},
    {"P2029", "r : REAL;|r := 1 / 2;", {"P2029 '1 / 2'"}, "r : REAL;|r := 4 / 2;"},
    {"P2030",
     "d : DINT; i : INT := 3;|d := i * i;",
     {"P2030 'i * i'"},
     "d : DINT; i : INT := 3;|d := INT_TO_DINT(i) * i;"},
    {"P2031",
     "l : LINT := 1; u : ULINT := 1; b : BOOL;|b := l < u;",
     {"P2031 '<'"},
     "l : INT := 1; u : UINT := 1; b : BOOL;|b := l < u;"},
    {"P2032",
     "TYPE C : (Red, Green); END_TYPE TYPE D : (Up, Down); END_TYPE PROGRAM Main VAR c : C; d : D; b : BOOL; END_VAR "
     "b := c = d; END_PROGRAM",
     {"P2032 '='"},
     "TYPE C : (Red, Green); END_TYPE PROGRAM Main VAR c, d : C; b : BOOL; END_VAR b := c = d; END_PROGRAM"},
    {"P2032",
     "TYPE C : (Red, Green); END_TYPE PROGRAM Main VAR c : C; i : INT := 1; END_VAR c := i; END_PROGRAM",
     {"P2032 'i'"},
     "TYPE C : (Red, Green); END_TYPE PROGRAM Main VAR c : C; i : INT; END_VAR i := c; c := Green; END_PROGRAM"},
    {"P2033", "x : INT;|x;", {"P2033 'x'"}, "x : INT;|x := x;"},
    {"P2033", "r : REAL;|SIN(r); r := 1.0;", {"P2033 'SIN'"}, "r : REAL;|r := SIN(r);"},
    {"P2034", "x : BOOL;|x := %IX99999999.0;", {"P2034 '%IX99999999.0'"}, "x : BOOL;|x := %IX0.7;"},
    {"P2036",
     "t : TON; b : BOOL;|t(IN := TRUE, Q := b); b := FALSE;",
     {"P2036 'Q'"},
     "t : TON; b : BOOL;|t(IN := TRUE, Q => b);"},
    {"P2037",
     "p : REF_TO BOOL; w : WORD;|p := REF(w.3);",
     {"P2037 'REF(w.3)'"},
     "p : REF_TO WORD; w : WORD;|p := REF(w);"},
};

const Row kDeclarations[] = {
    {"P3001", "x : INT; X : BOOL;|x := 1;", {"P3001 'X'"}, "x : INT; y : BOOL;|x := 1; y := TRUE;"},
    {"P3001",
     "FUNCTION F : INT F := 1; END_FUNCTION FUNCTION f : INT f := 1; END_FUNCTION PROGRAM Main END_PROGRAM",
     {"P3001 'f'"},
     "FUNCTION F : INT F := 1; END_FUNCTION PROGRAM Main END_PROGRAM"},
    {"P3001",
     "TYPE E : (A, B, A); END_TYPE PROGRAM Main END_PROGRAM",
     {"P3001 'A'"},
     "TYPE E : (A, B, C); END_TYPE PROGRAM Main END_PROGRAM"},
    {"P3002", "x : Motr;|;", {"P3002 'Motr'"}, "x : TON;|x();"},
    {"P3003",
     "TYPE A : STRUCT b : B; END_STRUCT END_TYPE TYPE B : STRUCT a : A; END_STRUCT END_TYPE PROGRAM Main END_PROGRAM",
     {"P3003 'A'"},
     "TYPE A : STRUCT b : REF_TO B; END_STRUCT END_TYPE TYPE B : STRUCT a : REF_TO A; END_STRUCT END_TYPE PROGRAM Main "
     "END_PROGRAM"},
    {"P3003",
     "FUNCTION_BLOCK B VAR inner : B; END_VAR inner(); END_FUNCTION_BLOCK PROGRAM Main VAR b : B; END_VAR b(); "
     "END_PROGRAM",
     {"P3003 'B'"},
     "FUNCTION_BLOCK B VAR next : REF_TO B; END_VAR next := NULL; END_FUNCTION_BLOCK PROGRAM Main VAR b : B; END_VAR "
     "b(); END_PROGRAM"},
    {"P3003",
     "PROGRAM Main VAR CONSTANT a : INT := b; b : INT := a; END_VAR VAR x : INT; END_VAR x := a; END_PROGRAM",
     {"P3003 'a'"},
     "PROGRAM Main VAR CONSTANT a : INT := b; b : INT := 5; END_VAR VAR x : INT; END_VAR x := a; END_PROGRAM"},
    {"P3004",
     "FUNCTION F : INT VAR_INPUT n : INT; END_VAR F := F(n - 1); END_FUNCTION PROGRAM Main VAR x : INT; END_VAR x := "
     "F(3); END_PROGRAM",
     {"P3004 'F(n - 1)'"},
     "FUNCTION F : INT VAR_INPUT n : INT; END_VAR F := n - 1; END_FUNCTION PROGRAM Main VAR x : INT; END_VAR x := "
     "F(3); END_PROGRAM"},
    {"P3004",
     "FUNCTION F : INT F := G(); END_FUNCTION FUNCTION G : INT G := F(); END_FUNCTION PROGRAM Main VAR x : INT; "
     "END_VAR x := F(); END_PROGRAM",
     {"P3004 'F()'"},
     "FUNCTION F : INT F := G(); END_FUNCTION FUNCTION G : INT G := 1; END_FUNCTION PROGRAM Main VAR x : INT; END_VAR "
     "x := F(); END_PROGRAM"},
    {"P3005", "x : INT;|;", {"P3005 'x'"}, "x : INT;|x := 1;"},
    {"P3006", "x, y : INT;|y := x;", {"P3006 'x'"}, "x : INT := 1; y : INT;|y := x;"},
    {"P3007", "x : INT;|RETURN; x := 1;", {"P3007 'x := 1;'"}, "x : INT;|IF x > 1 THEN RETURN; END_IF x := 1;"},
    {"P3007",
     "x : INT;|WHILE TRUE DO EXIT; x := 1; END_WHILE",
     {"P3007 'x := 1;'"},
     "x : INT;|WHILE TRUE DO x := 1; EXIT; END_WHILE"},
    {"P3008",
     "FUNCTION F : INT VAR_INPUT a : INT; END_VAR IF a > 0 THEN F := 1; END_IF END_FUNCTION PROGRAM Main VAR x : INT; "
     "END_VAR x := F(1); END_PROGRAM",
     {"P3008 'F'"},
     "FUNCTION F : INT VAR_INPUT a : INT; END_VAR IF a > 0 THEN F := 1; ELSE F := 2; END_IF END_FUNCTION PROGRAM Main "
     "VAR x : INT; END_VAR x := F(1); END_PROGRAM"},
    {"P3008",
     "FUNCTION F : INT VAR_INPUT a : INT; END_VAR IF a > 0 THEN RETURN; END_IF F := 1; END_FUNCTION PROGRAM Main VAR x "
     ": INT; END_VAR x := F(1); END_PROGRAM",
     {"P3008 'F'"},
     "FUNCTION F : INT VAR_INPUT a : INT; END_VAR F := 1; IF a > 0 THEN RETURN; END_IF F := 2; END_FUNCTION PROGRAM "
     "Main VAR x : INT; END_VAR x := F(1); END_PROGRAM"},
    {"P3009",
     "TYPE C : (Red, Green); END_TYPE PROGRAM Main VAR c : C; END_VAR CASE c OF Red: c := Green; END_CASE END_PROGRAM",
     {"P3009 'CASE'"},
     "TYPE C : (Red, Green); END_TYPE PROGRAM Main VAR c : C; END_VAR CASE c OF Red: c := Green; Green: c := Red; "
     "END_CASE END_PROGRAM"},
    {"P3010",
     "x : INT;|CASE x OF 1..3: x := 0; 2: x := 1; END_CASE",
     {"P3010 '2'"},
     "x : INT;|CASE x OF 1..3: x := 0; 4: x := 1; END_CASE"},
    {"P3011",
     "a AT %MW0 : WORD; b AT %MB1 : BYTE;|a := 1; b := 2;",
     {"P3011 '%MB1'"},
     "a AT %MW0 : WORD; b AT %MB2 : BYTE;|a := 1; b := 2;"},
    {"P3012",
     "PROGRAM P END_PROGRAM CONFIGURATION C TASK Fast(INTERVAL := T#10ms); TASK Fast(INTERVAL := T#20ms); PROGRAM I "
     "WITH Fast : P; END_CONFIGURATION",
     {"P3012 'Fast'"},
     "PROGRAM P END_PROGRAM CONFIGURATION C TASK Fast(INTERVAL := T#10ms); TASK Slow(INTERVAL := T#20ms); PROGRAM I "
     "WITH Fast : P; END_CONFIGURATION"},
    {"P3013",
     "PROGRAM P END_PROGRAM CONFIGURATION C TASK Fast(INTERVAL := T#10ms); PROGRAM I WITH Fats : P; END_CONFIGURATION",
     {"P3013 'Fats'"},
     "PROGRAM P END_PROGRAM CONFIGURATION C TASK Fast(INTERVAL := T#10ms); PROGRAM I WITH Fast : P; END_CONFIGURATION"},
    {"P3014",
     "INTERFACE I METHOD M END_METHOD END_INTERFACE FUNCTION_BLOCK B IMPLEMENTS I END_FUNCTION_BLOCK PROGRAM Main VAR "
     "b : B; END_VAR b(); END_PROGRAM",
     {"P3014 'I'"},
     "INTERFACE I METHOD M END_METHOD END_INTERFACE FUNCTION_BLOCK B IMPLEMENTS I METHOD M END_METHOD "
     "END_FUNCTION_BLOCK PROGRAM Main VAR b : B; END_VAR b(); END_PROGRAM"},
    {"P3015",
     "FUNCTION_BLOCK A METHOD M : INT M := 1; END_METHOD END_FUNCTION_BLOCK FUNCTION_BLOCK B EXTENDS A METHOD M : REAL "
     "M := 1.0; END_METHOD END_FUNCTION_BLOCK PROGRAM Main VAR b : B; END_VAR b(); END_PROGRAM",
     {"P3015 'M'"},
     "FUNCTION_BLOCK A METHOD M : INT M := 1; END_METHOD END_FUNCTION_BLOCK FUNCTION_BLOCK B EXTENDS A METHOD M : INT "
     "M := 2; END_METHOD END_FUNCTION_BLOCK PROGRAM Main VAR b : B; END_VAR b(); END_PROGRAM"},
    {"P3016",
     "FUNCTION_BLOCK FINAL A END_FUNCTION_BLOCK FUNCTION_BLOCK B EXTENDS A END_FUNCTION_BLOCK PROGRAM Main VAR b : B; "
     "END_VAR b(); END_PROGRAM",
     {"P3016 'A'"},
     "FUNCTION_BLOCK A END_FUNCTION_BLOCK FUNCTION_BLOCK B EXTENDS A END_FUNCTION_BLOCK PROGRAM Main VAR b : B; "
     "END_VAR b(); END_PROGRAM"},
    {"P3017",
     "INTERFACE A END_INTERFACE FUNCTION_BLOCK B EXTENDS A END_FUNCTION_BLOCK PROGRAM Main VAR b : B; END_VAR b(); "
     "END_PROGRAM",
     {"P3017 'A'"},
     "INTERFACE A END_INTERFACE FUNCTION_BLOCK B IMPLEMENTS A END_FUNCTION_BLOCK PROGRAM Main VAR b : B; END_VAR b(); "
     "END_PROGRAM"},
    {"P3018",
     "FUNCTION F : INT VAR RETAIN x : INT; END_VAR F := x; x := 1; END_FUNCTION PROGRAM Main VAR i : INT; END_VAR i := "
     "F(); END_PROGRAM",
     {"P3018 'x'"},
     "FUNCTION F : INT VAR x : INT; END_VAR F := x; x := 1; END_FUNCTION PROGRAM Main VAR i : INT; END_VAR i := F(); "
     "END_PROGRAM"},
    {"P3018",
     "TYPE T : STRUCT a : ARRAY[*] OF INT; END_STRUCT; END_TYPE PROGRAM Main VAR t : T; END_VAR t := t; END_PROGRAM",
     {"P3018 'ARRAY[*] OF INT'"},
     "TYPE T : STRUCT a : ARRAY[0..1] OF INT; END_STRUCT; END_TYPE PROGRAM Main VAR t : T; END_VAR t := t; "
     "END_PROGRAM"},
    {"P3018",
     "TYPE T : UNION a : ARRAY[*] OF INT; END_UNION; END_TYPE PROGRAM Main VAR t : T; END_VAR t := t; END_PROGRAM",
     {"P3018 'ARRAY[*] OF INT'"},
     "TYPE T : UNION a : ARRAY[0..1] OF INT; END_UNION; END_TYPE PROGRAM Main VAR t : T; END_VAR t := t; END_PROGRAM"},
    {"P3018",
     "TYPE T : ARRAY[0..1] OF ARRAY[*] OF INT; END_TYPE PROGRAM Main VAR t : T; END_VAR t := t; END_PROGRAM",
     {"P3018 'ARRAY[*] OF INT'"},
     "TYPE T : ARRAY[0..1] OF ARRAY[0..1] OF INT; END_TYPE PROGRAM Main VAR t : T; END_VAR t := t; END_PROGRAM"},
    {"P3018",
     "TYPE T : POINTER TO ARRAY[*] OF INT; END_TYPE PROGRAM Main VAR t : T; END_VAR t := t; END_PROGRAM",
     {"P3018 'ARRAY[*] OF INT'"},
     "TYPE T : POINTER TO ARRAY[0..1] OF INT; END_TYPE PROGRAM Main VAR t : T; END_VAR t := t; END_PROGRAM"},
    {"P3018",
     "TYPE T : REF_TO ARRAY[*] OF INT; END_TYPE PROGRAM Main VAR t : T; END_VAR t := t; END_PROGRAM",
     {"P3018 'ARRAY[*] OF INT'"},
     "TYPE T : REF_TO ARRAY[0..1] OF INT; END_TYPE PROGRAM Main VAR t : T; END_VAR t := t; END_PROGRAM"},
    {"P3019",
     "x : INT;|JMP there; x := 1; here: x := 2;",
     {"P3019 'there'"},
     "x : INT;|IF x = 2 THEN JMP here; END_IF x := 1; here: x := 2;"},
    {"P3020", "x : INT;|x := 1; EXIT;", {"P3020 'EXIT;'"}, "x : INT;|WHILE x < 5 DO x := x + 1; EXIT; END_WHILE"},
    {"P3021",
     "i : INT;|FOR i := 1 TO 5 DO i := i + 1; END_FOR",
     {"P3021 'i'"},
     "i, j : INT;|FOR i := 1 TO 5 DO j := i + 1; END_FOR"},
    {"P3022",
     "PROGRAM Main VAR_EXTERNAL g : INT; END_VAR g := 1; END_PROGRAM",
     {"P3022 'g'"},
     "VAR_GLOBAL g : INT; END_VAR PROGRAM Main VAR_EXTERNAL g : INT; END_VAR g := 1; END_PROGRAM"},
    {"P3023",
     "a, b, c : ARRAY[1..100000000] OF BYTE;|a[1] := 1; b[1] := 1; c[1] := 1;",
     {"P3023 'Main'"},
     "a : ARRAY[1..1000] OF BYTE;|a[1] := 1;"},
    {"P3024", "FUNCTION F : INT F := 1; END_FUNCTION", {"P3024"}, "PROGRAM Main END_PROGRAM"},
    {"P3025",
     "PROGRAM A END_PROGRAM PROGRAM B END_PROGRAM",
     {"P3025 'B'"},
     "PROGRAM Main END_PROGRAM PROGRAM B END_PROGRAM"},
    {"P3026",
     "USING Nowhere; PROGRAM Main END_PROGRAM",
     {"P3026 'Nowhere'"},
     "NAMESPACE Here FUNCTION F : INT F := 1; END_FUNCTION END_NAMESPACE USING Here; PROGRAM Main VAR x : INT; END_VAR "
     "x := F(); END_PROGRAM"},
    {"P3027", "a : ARRAY[3..1] OF INT;|a[1] := 1;", {"P3027 '3..1'"}, "a : ARRAY[1..3] OF INT;|a[1] := 1;"},
    {"P3028",
     "PROGRAM P VAR x : INT; END_VAR x := 1; END_PROGRAM CONFIGURATION C VAR_CONFIG I.y : INT := 5; END_VAR PROGRAM I "
     ": P; END_CONFIGURATION",
     {"P3028 'I.y'"},
     "PROGRAM P VAR x : INT; END_VAR x := 1; END_PROGRAM CONFIGURATION C VAR_CONFIG I.x : INT := 5; END_VAR PROGRAM I "
     ": P; END_CONFIGURATION"},
    {"P3029", "x AT %I* : BOOL;|x := x;", {"P3029 '%I*'"}, "x AT %IX0.0 : BOOL; y : BOOL;|y := x;"},
    {"P3030",
     "FUNCTION F : BOOL VAR t : TON; END_VAR t(IN := TRUE, PT := T#1s); F := t.Q; END_FUNCTION PROGRAM Main VAR b : "
     "BOOL; END_VAR b := F(); END_PROGRAM",
     {"P3030 't'"},
     "FUNCTION_BLOCK F VAR t : TON; END_VAR t(IN := TRUE, PT := T#1s); END_FUNCTION_BLOCK PROGRAM Main VAR b : F; "
     "END_VAR b(); END_PROGRAM"},
    {"P3031",
     "a : ARRAY[1..2] OF INT := [1, 2, 3];|a[1] := 1;",
     {"P3031 '[1, 2, 3]'"},
     "a : ARRAY[1..3] OF INT := [1, 2, 3];|a[1] := 1;"},
    {"P3031",
     "a : ARRAY[1..2] OF INT := [3(0)];|a[1] := 1;",
     {"P3031 '[3(0)]'"},
     "a : ARRAY[1..3] OF INT := [3(0)];|a[1] := 1;"},
    {"P3032",
     "FUNCTION_BLOCK B METHOD M : INT VAR_INPUT n : INT; END_VAR M := 0; IF n > 0 THEN M := M(n - 1); END_IF "
     "END_METHOD END_FUNCTION_BLOCK PROGRAM Main VAR b : B; i : INT; END_VAR i := b.M(3); END_PROGRAM",
     {"P3032 'M(n - 1)'"},
     "FUNCTION_BLOCK B METHOD M : INT VAR_INPUT n : INT; END_VAR M := n; END_METHOD END_FUNCTION_BLOCK PROGRAM Main "
     "VAR b : B; i : INT; END_VAR i := b.M(3); END_PROGRAM"},
};

bool isInfo(std::string_view code) { return code == "P2033" || code == "P3006" || code == "P3024"; }

void checkRow(const Row& row) {
    const CheckedText wrong = check(program(row.wrong));
    EXPECT_EQ(wrong.messages(isInfo(row.code)), row.expected) << row.code << " of\n"
                                                              << row.wrong << "\n"
                                                              << wrong.all();
    const CheckedText right = check(program(row.right));
    for (const std::string& message : right.messages())
        EXPECT_NE(message.substr(0, 5), row.code) << "in the right one:\n" << row.right << "\n" << right.all();
    EXPECT_FALSE(right.analysis->hasErrors) << row.right << "\n" << right.all();
}

} // namespace

TEST(Diagnostics, ExpressionsPointAtTheSmallestWrongThing) {
    for (const Row& row : kExpressions)
        if (!row.expected.empty()) checkRow(row);
}

TEST(Diagnostics, DeclarationsPointAtTheSmallestWrongThing) {
    for (const Row& row : kDeclarations) checkRow(row);
}

TEST(Diagnostics, ANameOfTwoLibrariesNeedsItsNamespace) {
    const char* block = "FUNCTION_BLOCK Blink VAR_OUTPUT q : BOOL; END_VAR q := NOT q; END_FUNCTION_BLOCK";
    const auto with = [&](const char* text) {
        return check({{"test.st", text, ""}, {"a.st", block, "First"}, {"b.st", block, "Second"}}).messages();
    };
    EXPECT_EQ(with("PROGRAM Main VAR b : Blink; END_VAR b(); END_PROGRAM"), std::vector<std::string>{"P2024 'Blink'"});
    EXPECT_EQ(with("PROGRAM Main VAR b : Second.Blink; END_VAR b(); END_PROGRAM"), std::vector<std::string>{});
    EXPECT_EQ(with("FUNCTION_BLOCK Blink END_FUNCTION_BLOCK PROGRAM Main VAR b : Blink; END_VAR b(); END_PROGRAM"),
              std::vector<std::string>{});
}

TEST(Diagnostics, AProjectsNameHidesTheStandards) {
    const CheckedText checked = check("FUNCTION LIMIT : INT VAR_INPUT a : INT; END_VAR LIMIT := a; END_FUNCTION "
                                      "PROGRAM Main VAR x : INT; t : INT; END_VAR x := LIMIT(5); t := x; END_PROGRAM");
    EXPECT_EQ(checked.messages(), std::vector<std::string>{}) << checked.all();
}

TEST(Diagnostics, OneMistakeGivesOneMessage) {
    const CheckedText checked = check("PROGRAM Main VAR a : Missing; b : INT; END_VAR a.x := 1; b := a.y + 2; a(); IF "
                                      "a.z > b THEN b := a; END_IF END_PROGRAM");
    EXPECT_EQ(checked.messages(), std::vector<std::string>{"P3002 'Missing'"}) << checked.all();
}

TEST(Diagnostics, NearNamesAreOffered) {
    const CheckedText checked =
        check("PROGRAM Main VAR pressure : INT; END_VAR presure := 5; pressure := 1; END_PROGRAM");
    ASSERT_EQ(checked.analysis->diagnostics.size(), 1u);
    ASSERT_EQ(checked.analysis->diagnostics[0].fixes.size(), 1u);
    EXPECT_EQ(checked.analysis->diagnostics[0].fixes[0].edits[0].text, "pressure");
}
