#include "projects/exchange/base/format_functions.h"

#include "runtime/base/text.h"

namespace plc::exchange {
namespace {

constexpr std::string_view kText = R"ST(TYPE T_Arg :
STRUCT
    kind : INT; // 0 nothing, 1 whole number, 2 real number, 3 text
    whole : LINT;
    number : LREAL;
    text : STRING(255);
END_STRUCT
END_TYPE

/// A text with values in the places of %d, %u, %x, %b, %f, %s and so on, with width, precision and the flags 0 and -.
FUNCTION_BLOCK FB_FormatString
VAR_INPUT
    sFormat : STRING(255);
    arg1, arg2, arg3, arg4, arg5, arg6, arg7, arg8, arg9, arg10 : T_Arg;
END_VAR
VAR_OUTPUT
    bError : BOOL;
    nErrId : UDINT;
    sOut : STRING(255);
END_VAR
VAR
    args : ARRAY[1..10] OF T_Arg;
    next, place, width, precision : INT;
    isZeroed, isLeft, hasPrecision : BOOL;
    letter, piece : STRING(255);
END_VAR
args[1] := arg1;
args[2] := arg2;
args[3] := arg3;
args[4] := arg4;
args[5] := arg5;
args[6] := arg6;
args[7] := arg7;
args[8] := arg8;
args[9] := arg9;
args[10] := arg10;
bError := FALSE;
nErrId := 0;
sOut := '';
next := 0;
place := 1;
WHILE place <= LEN(sFormat) DO
    letter := MID(sFormat, 1, place);
    place := place + 1;
    IF letter <> '%' OR place > LEN(sFormat) THEN
        sOut := CONCAT(sOut, letter);
        CONTINUE;
    END_IF
    ReadFlags();
    letter := MID(sFormat, 1, place);
    place := place + 1;
    IF letter = '%' THEN
        sOut := CONCAT(sOut, letter);
        CONTINUE;
    END_IF
    next := next + 1;
    IF next > 10 THEN
        bError := TRUE;
        RETURN;
    END_IF
    bError := bError OR args[next].kind = 0;
    piece := Converted(args[next], letter);
    WHILE LEN(piece) < width DO
        IF isLeft THEN
            piece := CONCAT(piece, ' ');
        ELSIF isZeroed AND LEFT(piece, 1) = '-' THEN
            piece := CONCAT('-0', DELETE(piece, 1, 1));
        ELSIF isZeroed THEN
            piece := CONCAT('0', piece);
        ELSE
            piece := CONCAT(' ', piece);
        END_IF
    END_WHILE
    sOut := CONCAT(sOut, piece);
END_WHILE

METHOD PRIVATE ReadFlags
VAR
    digit : STRING(1);
END_VAR
isZeroed := FALSE;
isLeft := FALSE;
hasPrecision := FALSE;
width := 0;
precision := 6;
WHILE place <= LEN(sFormat) DO
    digit := MID(sFormat, 1, place);
    IF digit = '.' THEN
        hasPrecision := TRUE;
        precision := 0;
    ELSIF digit = '-' THEN
        isLeft := TRUE;
    ELSIF digit = '0' AND width = 0 AND NOT hasPrecision THEN
        isZeroed := TRUE;
    ELSIF digit >= '0' AND digit <= '9' AND hasPrecision THEN
        precision := MIN(precision * 10 + STRING_TO_INT(digit), 15);
    ELSIF digit >= '0' AND digit <= '9' THEN
        width := MIN(width * 10 + STRING_TO_INT(digit), 255);
    ELSIF digit <> '+' AND digit <> '#' AND digit <> ' ' THEN
        RETURN;
    END_IF
    place := place + 1;
END_WHILE
END_METHOD

METHOD PRIVATE Converted : STRING(255)
VAR_INPUT
    value : T_Arg;
    letter : STRING(1);
END_VAR
IF value.kind = 3 THEN
    Converted := value.text;
    IF hasPrecision THEN
        Converted := LEFT(value.text, precision);
    END_IF
ELSIF letter = 'f' OR letter = 'F' OR letter = 'e' OR letter = 'E' OR letter = 'g' THEN
    Converted := Fixed(SEL(value.kind = 2, TO_LREAL(value.whole), value.number));
ELSIF value.kind = 2 THEN
    Converted := LINT_TO_STRING(TRUNC(value.number));
ELSIF letter = 'x' OR letter = 'X' THEN
    Converted := Digits(TO_ULINT(value.whole), 16, letter = 'X');
ELSIF letter = 'b' OR letter = 'B' THEN
    Converted := Digits(TO_ULINT(value.whole), 2, FALSE);
ELSIF letter = 'o' THEN
    Converted := Digits(TO_ULINT(value.whole), 8, FALSE);
ELSIF letter = 'u' THEN
    Converted := ULINT_TO_STRING(TO_ULINT(value.whole));
ELSE
    Converted := LINT_TO_STRING(value.whole);
END_IF
END_METHOD

METHOD PRIVATE Digits : STRING(255)
VAR_INPUT
    value : ULINT;
    base : ULINT;
    isUpper : BOOL;
END_VAR
VAR
    digit : INT;
END_VAR
Digits := '';
REPEAT
    digit := TO_INT(value MOD base) + 1;
    Digits := CONCAT(SEL(isUpper, MID('0123456789abcdef', 1, digit), MID('0123456789ABCDEF', 1, digit)), Digits);
    value := value / base;
UNTIL value = 0
END_REPEAT
END_METHOD

METHOD PRIVATE Fixed : STRING(255)
VAR_INPUT
    value : LREAL;
END_VAR
VAR
    i : INT;
    scale, rest : LREAL;
    whole : LINT;
    fraction : STRING(255);
END_VAR
IF value <> value OR ABS(value) >= 9.2E18 THEN
    Fixed := LREAL_TO_STRING(value);
    RETURN;
END_IF
scale := 1;
FOR i := 1 TO precision DO
    scale := scale * 10;
END_FOR
whole := TRUNC(ABS(value));
rest := (ABS(value) - TO_LREAL(whole)) * scale + 0.5;
IF rest >= scale THEN
    whole := whole + 1;
    rest := 0;
END_IF
Fixed := LINT_TO_STRING(whole);
IF precision > 0 THEN
    fraction := LINT_TO_STRING(TRUNC(rest));
    WHILE LEN(fraction) < precision DO
        fraction := CONCAT('0', fraction);
    END_WHILE
    Fixed := CONCAT(CONCAT(Fixed, '.'), fraction);
END_IF
IF value < 0 THEN
    Fixed := CONCAT('-', Fixed);
END_IF
END_METHOD
END_FUNCTION_BLOCK
)ST";

constexpr std::string_view kTextByPointers =
    R"ST(/// FB_FormatString with texts of any length, given by their addresses.
FUNCTION_BLOCK FB_FormatString2
VAR_INPUT
    pFormatString : POINTER TO BYTE;
    arg1, arg2, arg3, arg4, arg5, arg6, arg7, arg8, arg9, arg10 : T_Arg;
    pOutString : POINTER TO BYTE;
    nOutSize : UDINT; // bytes, the end mark included
END_VAR
VAR_OUTPUT
    bError : BOOL;
    nErrId : UDINT;
END_VAR
VAR
    format : FB_FormatString;
    text : STRING(255);
    source, target : POINTER TO BYTE;
    i, length : INT;
END_VAR
bError := pFormatString = 0 OR pOutString = 0 OR nOutSize = 0;
IF bError THEN
    RETURN;
END_IF
source := pFormatString;
target := ADR(text);
length := 0;
WHILE length < 255 AND_THEN source^ <> 0 DO
    target^ := source^;
    source := source + 1;
    target := target + 1;
    length := length + 1;
END_WHILE
target^ := 0;
format(sFormat := text, arg1 := arg1, arg2 := arg2, arg3 := arg3, arg4 := arg4, arg5 := arg5, arg6 := arg6,
    arg7 := arg7, arg8 := arg8, arg9 := arg9, arg10 := arg10);
bError := format.bError OR TO_UDINT(LEN(format.sOut)) >= nOutSize;
nErrId := format.nErrId;
target := pOutString;
FOR i := 0 TO LEN(format.sOut) - 1 DO
    IF TO_UDINT(i) + 1 >= nOutSize THEN
        EXIT;
    END_IF
    target^ := format.sOut[i];
    target := target + 1;
END_FOR
target^ := 0;
END_FUNCTION_BLOCK
)ST";

struct Argument {
    std::string_view type, kind, member, conversion;
};
constexpr Argument kArguments[] = {
    {"BOOL", "1", "whole", "TO_LINT(in)"},  {"BYTE", "1", "whole", "TO_LINT(in)"},
    {"WORD", "1", "whole", "TO_LINT(in)"},  {"DWORD", "1", "whole", "TO_LINT(in)"},
    {"LWORD", "1", "whole", "TO_LINT(in)"}, {"SINT", "1", "whole", "in"},
    {"USINT", "1", "whole", "in"},          {"INT", "1", "whole", "in"},
    {"UINT", "1", "whole", "in"},           {"DINT", "1", "whole", "in"},
    {"UDINT", "1", "whole", "in"},          {"LINT", "1", "whole", "in"},
    {"ULINT", "1", "whole", "TO_LINT(in)"}, {"REAL", "2", "number", "in"},
    {"LREAL", "2", "number", "in"},         {"STRING", "3", "text", "in"},
};

} // namespace

std::string_view formatStringText() { return kText; }
std::string_view formatString2Text() { return kTextByPointers; }

std::string formatArgumentText(std::string_view type) {
    for (const Argument& each : kArguments) {
        if (!equalsIgnoringCase(each.type, type)) continue;
        const std::string name = "F_" + std::string(each.type), length = each.type == "STRING" ? "(255)" : "";
        return "FUNCTION " + name + " : T_Arg\nVAR_INPUT\n    in : " + std::string(each.type) + length +
               ";\nEND_VAR\n" + name + ".kind := " + std::string(each.kind) + ";\n" + name + "." +
               std::string(each.member) + " := " + std::string(each.conversion) + ";\nEND_FUNCTION\n";
    }
    return {};
}

} // namespace plc::exchange
