#include "runtime/library/signatures.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace plc::library {
namespace {

using types::TypeKind;
using Names = std::vector<std::string_view>;

Parameter any(std::string_view name, Generic generic, Names others = {}) { return {name, std::move(others), generic}; }
Parameter fixed(std::string_view name, TypeKind kind, Names others = {}) {
    return {name, std::move(others), Generic::Fixed, kind};
}

Signature intrinsic(std::string_view name, std::vector<Parameter> parameters, Rule rule, Intrinsic code,
                    std::string_view summary, TypeKind result = TypeKind::Unknown, int64_t selector = -1) {
    return {name, std::move(parameters), false, rule, result, code, {}, selector, summary};
}
Signature operation(std::string_view name, std::vector<Parameter> parameters, Rule rule, std::string_view spelling,
                    std::string_view summary, TypeKind result = TypeKind::Unknown, int64_t selector = -1) {
    return {name, std::move(parameters), false, rule, result, std::nullopt, spelling, selector, summary};
}
Signature special(std::string_view name, std::vector<Parameter> parameters, std::string_view summary,
                  TypeKind result = TypeKind::Unknown) {
    return {name, std::move(parameters), false, Rule::Special, result, std::nullopt, {}, -1, summary};
}
Signature extensible(Signature signature) {
    signature.isExtensible = true;
    return signature;
}

using Table = std::vector<Signature>;

/// Tables 23 and 24 (edition 2), 24 and 25 (edition 3), and the names that CODESYS, TwinCAT and text books add.
void addNumeric(Table& table) {
    const auto number = any("IN", Generic::AnyNum);
    const auto real = any("IN", Generic::AnyReal);
    table.push_back(intrinsic("ABS", {any("IN", Generic::AnyNumOrDuration)}, Rule::Common, Intrinsic::Abs,
                              "Absolute value; the least integer stays as it is"));
    const auto function = [&](std::string_view name, Intrinsic code, std::string_view summary) {
        table.push_back(intrinsic(name, {number}, Rule::RealOperand, code, summary));
    };
    function("SQRT", Intrinsic::Sqrt, "Square root; NaN below 0");
    function("LN", Intrinsic::Ln, "Natural logarithm");
    function("LOG", Intrinsic::Log, "Logarithm to base 10");
    function("EXP", Intrinsic::Exp, "e to the power of IN");
    function("SIN", Intrinsic::Sin, "Sine of an angle in radians");
    function("COS", Intrinsic::Cos, "Cosine of an angle in radians");
    function("TAN", Intrinsic::Tan, "Tangent of an angle in radians");
    function("ASIN", Intrinsic::Asin, "Arc sine in radians");
    function("ACOS", Intrinsic::Acos, "Arc cosine in radians");
    function("ATAN", Intrinsic::Atan, "Arc tangent in radians");
    function("SINH", Intrinsic::Sinh, "Hyperbolic sine");
    function("COSH", Intrinsic::Cosh, "Hyperbolic cosine");
    function("TANH", Intrinsic::Tanh, "Hyperbolic tangent");
    table.push_back(intrinsic("ATAN2", {any("Y", Generic::AnyNum, {"IN1"}), any("X", Generic::AnyNum, {"IN2"})},
                              Rule::RealOperand, Intrinsic::Atan2, "Angle of the point (X, Y), -π to π"));
    function("DEG_TO_RAD", Intrinsic::DegToRad, "Degrees to radians");
    function("RAD_TO_DEG", Intrinsic::RadToDeg, "Radians to degrees");
    function("RAD", Intrinsic::DegToRad, "Degrees to radians");
    function("DEG", Intrinsic::RadToDeg, "Radians to degrees");
    function("FRAC", Intrinsic::Frac, "Fraction of IN, with its sign");
    function("FLOOR", Intrinsic::Floor, "Greatest whole number not above IN");
    function("CEIL", Intrinsic::Ceil, "Least whole number not below IN");
    function("CEILING", Intrinsic::Ceil, "Least whole number not below IN");
    function("ROUND", Intrinsic::RoundReal, "Nearest whole number, halves to the even one");
    const auto cut = [&](std::string_view name, Intrinsic code, TypeKind result, std::string_view summary) {
        table.push_back(intrinsic(name, {any("IN", Generic::AnyNum)}, Rule::FixedResult, code, summary, result));
    };
    cut("TRUNC", Intrinsic::Trunc, TypeKind::Dint,
        "Whole part of IN, towards zero, in the expected type (DINT if there is none)");
    cut("TRUNC_INT", Intrinsic::Trunc, TypeKind::Int, "Whole part of IN as INT, towards zero");
    cut("TRUNC_DINT", Intrinsic::Trunc, TypeKind::Dint, "Whole part of IN as DINT, towards zero");
    cut("TRUNC_LINT", Intrinsic::Trunc, TypeKind::Lint, "Whole part of IN as LINT, towards zero");
    cut("FLOOR_INT", Intrinsic::Floor, TypeKind::Int, "Greatest INT not above IN");
    cut("FLOOR_DINT", Intrinsic::Floor, TypeKind::Dint, "Greatest DINT not above IN");
    cut("CEIL_INT", Intrinsic::Ceil, TypeKind::Int, "Least INT not below IN");
    cut("CEIL_DINT", Intrinsic::Ceil, TypeKind::Dint, "Least DINT not below IN");
    table.push_back(
        intrinsic("LTRUNC", {real}, Rule::RealOperand, Intrinsic::TruncReal, "Whole part of IN as a real number"));
    table.push_back(intrinsic("SQR", {number}, Rule::Common, Intrinsic::Square, "IN times IN"));
    table.push_back(special(
        "EXPT", {any("IN1", Generic::AnyNum, {"BASE", "IN"}), any("IN2", Generic::AnyNum, {"EXPONENT", "EXP", "N"})},
        "IN1 to the power of IN2"));
    const auto magnitude = any("IN1", Generic::AnyMagnitude, {"IN"}), second = any("IN2", Generic::AnyMagnitude);
    table.push_back(extensible(operation("ADD", {magnitude, second}, Rule::Common, "+", "Sum of all operands")));
    table.push_back(extensible(operation("MUL", {magnitude, second}, Rule::Common, "*", "Product of all operands")));
    table.push_back(operation("SUB", {magnitude, second}, Rule::Common, "-", "IN1 - IN2"));
    table.push_back(operation("DIV", {magnitude, second}, Rule::Common, "/", "IN1 / IN2"));
    table.push_back(operation("MOD", {any("IN1", Generic::AnyInt, {"IN"}), any("IN2", Generic::AnyInt)}, Rule::Common,
                              "MOD", "Remainder of IN1 / IN2, with the sign of IN1"));
    table.push_back(operation("NEG", {any("IN", Generic::AnyNumOrDuration)}, Rule::FirstOperand, "-", "-IN"));
    table.push_back(
        operation("INC", {any("IN", Generic::AnyInt)}, Rule::FirstOperand, "+", "IN + 1", TypeKind::Unknown, 1));
    table.push_back(
        operation("DEC", {any("IN", Generic::AnyInt)}, Rule::FirstOperand, "-", "IN - 1", TypeKind::Unknown, 1));
    table.push_back(intrinsic("MOVE", {any("IN", Generic::Any)}, Rule::FirstOperand, Intrinsic::Move, "IN itself"));
}

/// Tables 25 and 26 (edition 2): shift and Boolean functions.
void addBits(Table& table) {
    const auto shift = [&](std::string_view name, Intrinsic code, std::string_view summary) {
        table.push_back(intrinsic(name, {any("IN", Generic::AnyBit), any("N", Generic::AnyInt, {"COUNT"})},
                                  Rule::FirstOperand, code, summary));
    };
    shift("SHL", Intrinsic::Shl, "IN shifted left by N bits, zeros from the right");
    shift("SHR", Intrinsic::Shr, "IN shifted right by N bits, zeros from the left");
    shift("ROL", Intrinsic::Rol, "IN rotated left by N bits");
    shift("ROR", Intrinsic::Ror, "IN rotated right by N bits");
    const auto first = any("IN1", Generic::AnyBit, {"IN"}), second = any("IN2", Generic::AnyBit);
    table.push_back(extensible(operation("AND", {first, second}, Rule::Common, "AND", "Bitwise AND of all operands")));
    table.push_back(extensible(operation("OR", {first, second}, Rule::Common, "OR", "Bitwise OR of all operands")));
    table.push_back(
        extensible(operation("XOR", {first, second}, Rule::Common, "XOR", "Bitwise exclusive OR of all operands")));
    table.push_back(
        operation("NOT", {any("IN", Generic::AnyBit)}, Rule::FirstOperand, "NOT", "All bits of IN inverted"));
}

/// Tables 27 and 28 (edition 2): selection and comparison.
void addSelection(Table& table) {
    table.push_back(intrinsic("SEL", {fixed("G", TypeKind::Bool), any("IN0", Generic::Any), any("IN1", Generic::Any)},
                              Rule::SecondOperand, Intrinsic::Sel, "IN1 if G is TRUE, otherwise IN0"));
    const auto first = any("IN1", Generic::AnyElementary, {"IN"}), second = any("IN2", Generic::AnyElementary);
    table.push_back(extensible(intrinsic("MAX", {first, second}, Rule::Common, Intrinsic::Max, "Greatest operand")));
    table.push_back(extensible(intrinsic("MIN", {first, second}, Rule::Common, Intrinsic::Min, "Least operand")));
    table.push_back(intrinsic("LIMIT",
                              {any("MN", Generic::AnyElementary, {"MIN"}), any("IN", Generic::AnyElementary),
                               any("MX", Generic::AnyElementary, {"MAX"})},
                              Rule::Common, Intrinsic::Limit, "IN, but not below MN and not above MX"));
    table.push_back(extensible(intrinsic(
        "MUX", {any("K", Generic::AnyInt), any("IN0", Generic::Any), any("IN1", Generic::Any)}, Rule::SecondOperand,
        Intrinsic::Mux, "The operand numbered K from 0; the first or last if K is out of range")));
    const auto compare = [&](std::string_view name, std::string_view spelling, std::string_view summary) {
        table.push_back(extensible(operation(name, {first, second}, Rule::Compare, spelling, summary, TypeKind::Bool)));
    };
    compare("GT", ">", "TRUE if each operand is greater than the next");
    compare("GE", ">=", "TRUE if no operand is less than the next");
    compare("EQ", "=", "TRUE if all operands are equal");
    compare("LE", "<=", "TRUE if no operand is greater than the next");
    compare("LT", "<", "TRUE if each operand is less than the next");
    table.push_back(operation("NE", {any("IN1", Generic::Any), any("IN2", Generic::Any)}, Rule::Compare, "<>",
                              "TRUE if the operands differ", TypeKind::Bool));
}

/// Table 29 (edition 2), with the parameter names of the IEC, of CODESYS and of TwinCAT, and the W-forms for WSTRING.
void addText(Table& table) {
    for (const bool isWide : {false, true}) {
        const auto text = [&](std::string_view name, Names others) {
            return isWide ? fixed(name, TypeKind::Wstring, std::move(others))
                          : any(name, Generic::AnyText, std::move(others));
        };
        const auto whole = [&](std::string_view name, Names others) {
            return any(name, Generic::AnyInt, std::move(others));
        };
        const auto name = [&](std::string_view narrow, std::string_view wide) { return isWide ? wide : narrow; };
        const auto in = text("IN", {"STR", "IN1", "STR1"});
        const auto in1 = text("IN1", {"STR1", "IN", "STR"}), in2 = text("IN2", {"STR2"});
        const auto length = whole("L", {"LEN", "SIZE", "N"});
        const auto position = whole("P", {"POS"});
        table.push_back(intrinsic(name("LEN", "WLEN"), {in}, Rule::FixedResult, Intrinsic::Len, "Number of characters",
                                  TypeKind::Int));
        table.push_back(intrinsic(name("LEFT", "WLEFT"), {in, length}, Rule::FirstOperand, Intrinsic::Left,
                                  "The first L characters"));
        table.push_back(intrinsic(name("RIGHT", "WRIGHT"), {in, length}, Rule::FirstOperand, Intrinsic::Right,
                                  "The last L characters"));
        table.push_back(intrinsic(name("MID", "WMID"), {in, length, position}, Rule::FirstOperand, Intrinsic::Mid,
                                  "L characters from position P (the first is 1)"));
        table.push_back(extensible(intrinsic(name("CONCAT", "WCONCAT"), {in1, in2}, Rule::Common, Intrinsic::Concat,
                                             "Concatenation of all strings")));
        table.push_back(intrinsic(name("INSERT", "WINSERT"), {in1, in2, position}, Rule::FirstOperand,
                                  Intrinsic::Insert,
                                  "IN1 with IN2 inserted after position P; 0 inserts it at the front"));
        table.push_back(intrinsic(name("DELETE", "WDELETE"), {in, length, position}, Rule::FirstOperand,
                                  Intrinsic::Delete, "IN without L characters from position P"));
        table.push_back(intrinsic(name("REPLACE", "WREPLACE"), {in1, in2, length, position}, Rule::FirstOperand,
                                  Intrinsic::Replace, "IN1 with L characters from position P replaced by IN2"));
        table.push_back(intrinsic(name("FIND", "WFIND"), {in1, in2}, Rule::FixedResult, Intrinsic::Find,
                                  "Position of the first IN2 in IN1, 0 if there is none", TypeKind::Int));
    }
    const auto text = any("IN", Generic::AnyText, {"STR", "IN1"});
    for (const std::string_view name : {"TO_UPPER", "TOUPPER", "UPPER_CASE", "F_TOUCASE"})
        table.push_back(intrinsic(name, {text}, Rule::FirstOperand, Intrinsic::ToUpper, "IN in upper case"));
    for (const std::string_view name : {"TO_LOWER", "TOLOWER", "LOWER_CASE", "F_TOLCASE"})
        table.push_back(intrinsic(name, {text}, Rule::FirstOperand, Intrinsic::ToLower, "IN in lower case"));
    table.push_back(
        intrinsic("TRIM", {text}, Rule::FirstOperand, Intrinsic::Trim, "IN without leading and trailing spaces"));
    for (const std::string_view name : {"ISNUMBER", "IS_NUMBER", "IS_NUMERIC"})
        table.push_back(intrinsic(name, {text}, Rule::FixedResult, Intrinsic::IsNumber,
                                  "TRUE if the whole of IN is a number", TypeKind::Bool));
    for (const std::string_view name : {"F_TOASC", "ASC"})
        table.push_back(intrinsic(name, {any("IN", Generic::AnyText, {"STR", "CH"})}, Rule::FixedResult,
                                  Intrinsic::AsciiOf, "Code of the first character, 0 for an empty text",
                                  TypeKind::Byte));
    for (const std::string_view name : {"F_TOCHR", "CHR"})
        table.push_back(intrinsic(name, {any("IN", Generic::AnyInt, {"C", "CODE"})}, Rule::FixedResult,
                                  Intrinsic::CharOf, "String with the character that has this code", TypeKind::String));
}

/// Table 30 (edition 2), tables 34 to 36 (edition 3).
void addTimes(Table& table) {
    struct Row {
        std::string_view name;
        std::string_view spelling;
        TypeKind left, right, result;
        std::string_view summary;
    };
    using enum TypeKind;
    for (const Row& row : {
             Row{"ADD_TIME", "+", Time, Time, Time, "Sum of two durations"},
             Row{"ADD_LTIME", "+", Ltime, Ltime, Ltime, "Sum of two durations"},
             Row{"ADD_TOD_TIME", "+", Tod, Time, Tod, "Time of day later by a duration"},
             Row{"ADD_LTOD_LTIME", "+", Ltod, Ltime, Ltod, "Time of day later by a duration"},
             Row{"ADD_DT_TIME", "+", Dt, Time, Dt, "Date and time later by a duration"},
             Row{"ADD_LDT_LTIME", "+", Ldt, Ltime, Ldt, "Date and time later by a duration"},
             Row{"SUB_TIME", "-", Time, Time, Time, "Difference of two durations"},
             Row{"SUB_LTIME", "-", Ltime, Ltime, Ltime, "Difference of two durations"},
             Row{"SUB_DATE_DATE", "-", Date, Date, Time, "Time between two dates"},
             Row{"SUB_LDATE_LDATE", "-", Ldate, Ldate, Ltime, "Time between two dates"},
             Row{"SUB_TOD_TIME", "-", Tod, Time, Tod, "Time of day earlier by a duration"},
             Row{"SUB_LTOD_LTIME", "-", Ltod, Ltime, Ltod, "Time of day earlier by a duration"},
             Row{"SUB_TOD_TOD", "-", Tod, Tod, Time, "Time between two times of day"},
             Row{"SUB_LTOD_LTOD", "-", Ltod, Ltod, Ltime, "Time between two times of day"},
             Row{"SUB_DT_TIME", "-", Dt, Time, Dt, "Date and time earlier by a duration"},
             Row{"SUB_LDT_LTIME", "-", Ldt, Ltime, Ldt, "Date and time earlier by a duration"},
             Row{"SUB_DT_DT", "-", Dt, Dt, Time, "Time between two dates with their times"},
             Row{"SUB_LDT_LDT", "-", Ldt, Ldt, Ltime, "Time between two dates with their times"},
         })
        table.push_back(operation(row.name, {fixed("IN1", row.left), fixed("IN2", row.right)}, Rule::FixedResult,
                                  row.spelling, row.summary, row.result));
    const auto factor = any("IN2", Generic::AnyNum, {"N"});
    for (const auto& [name, kind] :
         {std::pair<std::string_view, TypeKind>{"MULTIME", Time}, {"MUL_TIME", Time}, {"MUL_LTIME", Ltime}})
        table.push_back(intrinsic(name, {fixed("IN1", kind, {"IN"}), factor}, Rule::FirstOperand,
                                  Intrinsic::MulDuration, "Duration times a number"));
    for (const auto& [name, kind] :
         {std::pair<std::string_view, TypeKind>{"DIVTIME", Time}, {"DIV_TIME", Time}, {"DIV_LTIME", Ltime}})
        table.push_back(intrinsic(name, {fixed("IN1", kind, {"IN"}), factor}, Rule::FirstOperand,
                                  Intrinsic::DivDuration, "Duration divided by a number"));

    const auto whole = [](std::string_view name) { return any(name, Generic::AnyInt); };
    const std::vector<Parameter> date{whole("YEAR"), whole("MONTH"), whole("DAY")};
    const std::vector<Parameter> time{whole("HOUR"), whole("MINUTE"), whole("SECOND"), whole("MILLISECOND")};
    std::vector<Parameter> both = date;
    both.insert(both.end(), time.begin(), time.end());
    table.push_back(intrinsic("CONCAT_DATE", date, Rule::FixedResult, Intrinsic::ConcatDate,
                              "Date from year, month and day", Date));
    table.push_back(intrinsic("CONCAT_LDATE", date, Rule::FixedResult, Intrinsic::ConcatDate,
                              "Date from year, month and day", Ldate));
    table.push_back(
        intrinsic("CONCAT_TOD", time, Rule::FixedResult, Intrinsic::ConcatTod, "Time of day from its parts", Tod));
    table.push_back(
        intrinsic("CONCAT_LTOD", time, Rule::FixedResult, Intrinsic::ConcatTod, "Time of day from its parts", Ltod));
    table.push_back(
        intrinsic("CONCAT_DT", both, Rule::FixedResult, Intrinsic::ConcatDt, "Date and time from its parts", Dt));
    table.push_back(
        intrinsic("CONCAT_LDT", both, Rule::FixedResult, Intrinsic::ConcatDt, "Date and time from its parts", Ldt));
    const auto join = [&](std::string_view name, TypeKind day, TypeKind clock, TypeKind result) {
        table.push_back(intrinsic(name, {fixed("IN1", day, {"DATE"}), fixed("IN2", clock, {"TOD"})}, Rule::FixedResult,
                                  Intrinsic::ConcatDateTod, "Date and time from a date and a time of day", result));
    };
    join("CONCAT_DATE_TOD", Date, Tod, Dt);
    join("CONCAT_DATE_LTOD", Date, Ltod, Ldt);
    join("CONCAT_LDATE_LTOD", Ldate, Ltod, Ldt);
    const auto part = [&](std::string_view name, Intrinsic code, int64_t which, std::string_view summary) {
        table.push_back(intrinsic(name, {any("IN", Generic::AnyDate)}, Rule::FixedResult, code, summary, Int, which));
    };
    part("DAY_OF_WEEK", Intrinsic::DatePart, 3, "0 for Sunday to 6 for Saturday");
    part("YEAR_OF", Intrinsic::DatePart, 0, "Year of a date");
    part("MONTH_OF", Intrinsic::DatePart, 1, "Month of a date, 1 to 12");
    part("DAY_OF", Intrinsic::DatePart, 2, "Day of the month, 1 to 31");
    part("HOUR_OF", Intrinsic::TimePart, 0, "Hour of a time of day or date and time");
    part("MINUTE_OF", Intrinsic::TimePart, 1, "Minute of a time of day or date and time");
    part("SECOND_OF", Intrinsic::TimePart, 2, "Second of a time of day or date and time");
    part("MILLISECOND_OF", Intrinsic::TimePart, 3, "Millisecond of a time of day or date and time");

    table.push_back(intrinsic("TIME", {}, Rule::FixedResult, Intrinsic::Time,
                              "Clock of the controller: time since its first scan", Time));
    table.push_back(intrinsic("LTIME", {}, Rule::FixedResult, Intrinsic::Time,
                              "Clock of the controller: time since its first scan", Ltime));
    table.push_back(intrinsic("NOW", {}, Rule::FixedResult, Intrinsic::Calendar, "Date and time at this scan", Dt));
    table.push_back(intrinsic("FIRST_SCAN", {}, Rule::FixedResult, Intrinsic::FirstScan,
                              "TRUE in the first scan after a start or reset", Bool));
    table.push_back(
        intrinsic("SCAN_NUMBER", {}, Rule::FixedResult, Intrinsic::ScanNumber, "Number of this scan, from 0", Ulint));
    table.push_back(intrinsic("TASK_PERIOD", {}, Rule::FixedResult, Intrinsic::TaskPeriod,
                              "Interval of the running task, T#0s if it is not cyclic", Time));
}

/// Edition 3, tables 22 (validity) and 39 (byte order), and reading one type's bits as another.
void addRepresentation(Table& table) {
    using enum TypeKind;
    table.push_back(intrinsic("IS_VALID", {any("IN", Generic::AnyReal)}, Rule::FixedResult, Intrinsic::IsValid,
                              "TRUE if IN is a finite number", Bool));
    table.push_back(intrinsic("IS_VALID_BCD", {any("IN", Generic::AnyBit)}, Rule::FixedResult, Intrinsic::IsValidBcd,
                              "TRUE if every digit of IN is 0 to 9", Bool));
    for (const std::string_view name : {"TO_BIG_ENDIAN", "FROM_BIG_ENDIAN", "BIG_ENDIAN_TO", "SWAP"})
        table.push_back(intrinsic(name, {any("IN", Generic::AnyMagnitude)}, Rule::FirstOperand, Intrinsic::SwapBytes,
                                  "IN with its bytes in reverse order"));
    for (const std::string_view name : {"TO_LITTLE_ENDIAN", "FROM_LITTLE_ENDIAN", "LITTLE_ENDIAN_TO"})
        table.push_back(intrinsic(name, {any("IN", Generic::AnyElementary)}, Rule::FirstOperand, Intrinsic::Move,
                                  "IN itself: this is the order of this machine"));
    const auto reread = [&](std::string_view name, TypeKind from, TypeKind to) {
        table.push_back(intrinsic(name, {fixed("IN", from)}, Rule::FixedResult, Intrinsic::SameBits,
                                  "The bits of IN read as another type", to));
    };
    reread("REAL_AS_DWORD", Real, Dword);
    reread("DWORD_AS_REAL", Dword, Real);
    reread("LREAL_AS_LWORD", Lreal, Lword);
    reread("LWORD_AS_LREAL", Lword, Lreal);
}

void addSpecial(Table& table) {
    using enum TypeKind;
    const auto array = any("ARR", Generic::Any, {"IN"}), dimension = any("DIM", Generic::AnyInt);
    table.push_back(
        special("LOWER_BOUND", {array, dimension}, "Lower bound of an array's dimension (the first is 1)", Dint));
    table.push_back(
        special("UPPER_BOUND", {array, dimension}, "Upper bound of an array's dimension (the first is 1)", Dint));
    table.push_back(special("SIZEOF", {any("IN", Generic::Any)}, "Bytes of a variable or type", Udint));
    table.push_back(special("XSIZEOF", {any("IN", Generic::Any)}, "Bytes of a variable or type", Ulint));
    table.push_back(special("ADR", {any("IN", Generic::Any)}, "Address of a variable, for a POINTER TO it"));
    table.push_back(special("REF", {any("IN", Generic::Any)}, "Reference to a variable, for a REF_TO its type"));
    table.push_back(
        special("BITADR", {any("IN", Generic::Any)}, "Bit offset of a located variable within its area", Dword));
    table.push_back(special("INDEXOF", {any("IN", Generic::Any)}, "Number of a program unit", Dint));
    table.push_back(
        special("__ISVALIDREF", {any("IN", Generic::Any)}, "TRUE if a reference refers to a variable", Bool));
    table.push_back(special("__QUERYINTERFACE", {any("FROM", Generic::Any), any("TO", Generic::Any)},
                            "TRUE where FROM's block implements TO's interface, which then is set", Bool));
    table.push_back(special("__NEW", {any("TYPE", Generic::Any)},
                            "Address of a new variable of a type; 0 when the project's memory for it is used up"));
    table.push_back(special("__DELETE", {any("POINTER", Generic::Any)}, "Deletes a variable created by __NEW"));
    table.push_back(special("__POUNAME", {}, "Name of the program unit that this is in", String));
    table.push_back(special("__POSITION", {}, "Where this is: the line, and the position in it", String));
    table.push_back(special("__VARINFO", {any("IN", Generic::Any)},
                            "Name, type, size and place of a variable, as an __SYSTEM.VAR_INFO"));
    table.push_back(special("TEST_AND_SET", {any("IN", Generic::Any)},
                            "TRUE if IN was set before; IN is set at the same time", Bool));
    table.push_back(special("__QUERYPOINTER", {any("FROM", Generic::Any), any("TO", Generic::Any)},
                            "TRUE where FROM refers to a block, whose address TO then holds", Bool));
}

std::string upperCase(std::string_view name) {
    std::string upper(name);
    std::ranges::transform(upper, upper.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return upper;
}

struct Lookup {
    Table table;
    std::unordered_map<std::string_view, size_t> byName;
    Lookup() {
        addNumeric(table);
        addBits(table);
        addSelection(table);
        addText(table);
        addTimes(table);
        addRepresentation(table);
        addSpecial(table);
        std::ranges::sort(table, {}, &Signature::name);
        for (size_t i = 0; i < table.size(); ++i) byName.emplace(table[i].name, i);
    }
};

const Lookup& lookup() {
    static const Lookup instance;
    return instance;
}

/// The elementary type a part of a conversion's name means; Unknown when it is none.
TypeKind typeNamed(std::string_view name) {
    static const std::unordered_map<std::string_view, TypeKind> names = [] {
        std::unordered_map<std::string_view, TypeKind> map{
#define PLC_ELEMENTARY(Name, Spelling, Bytes, Family) {Spelling, TypeKind::Name},
#include "runtime/types/elementary.def"
            {"STRING", TypeKind::String},    {"WSTRING", TypeKind::Wstring},   {"TIME_OF_DAY", TypeKind::Tod},
            {"DATE_AND_TIME", TypeKind::Dt}, {"LTIME_OF_DAY", TypeKind::Ltod}, {"LDATE_AND_TIME", TypeKind::Ldt}};
        return map;
    }();
    const auto found = names.find(name);
    return found == names.end() ? TypeKind::Unknown : found->second;
}

bool isIntegerName(TypeKind kind) { return kind != TypeKind::Unknown && types::isInteger(types::familyOf(kind)); }

/// The bit string with as many bits as an integer has: what INT_TO_BCD gives.
TypeKind bitsLike(TypeKind integer) {
    switch (types::bitsOf(integer)) {
    case 8:
        return TypeKind::Byte;
    case 16:
        return TypeKind::Word;
    case 32:
        return TypeKind::Dword;
    default:
        return TypeKind::Lword;
    }
}

std::optional<Conversion> bcdConversion(std::string_view left, std::string_view right) {
    using How = Conversion::How;
    // BCD_TO_INT; WORD_BCD_TO_UINT
    if (left == "BCD" || left.ends_with("_BCD")) {
        const TypeKind to = typeNamed(right);
        if (!isIntegerName(to)) return std::nullopt;
        if (left == "BCD") return Conversion{How::FromBcd, TypeKind::Unknown, to};
        const TypeKind from = typeNamed(left.substr(0, left.size() - 4));
        return isIntegerName(from) ? std::optional(Conversion{How::FromBcd, from, to}) : std::nullopt;
    }
    // INT_TO_BCD; UINT_TO_BCD_WORD; TO_BCD_WORD
    if (right != "BCD" && !right.starts_with("BCD_")) return std::nullopt;
    const TypeKind from = typeNamed(left);
    if (!left.empty() && left != "ANY" && !isIntegerName(from)) return std::nullopt;
    if (right == "BCD")
        return Conversion{How::ToBcd, from, from == TypeKind::Unknown ? TypeKind::Word : bitsLike(from)};
    const TypeKind to = typeNamed(right.substr(4));
    return isIntegerName(to) ? std::optional(Conversion{How::ToBcd, from, to}) : std::nullopt;
}

} // namespace

std::span<const Signature> signatures() { return lookup().table; }

const Signature* findSignature(std::string_view name) {
    const std::string upper = upperCase(name);
    const auto found = lookup().byName.find(upper);
    return found == lookup().byName.end() ? nullptr : &lookup().table[found->second];
}

std::optional<Conversion> findConversion(std::string_view name) {
    using How = Conversion::How;
    const std::string upper = upperCase(name);
    const std::string_view text = upper;
    if (lookup().byName.contains(text)) return std::nullopt;
    // REAL_TRUNC_INT
    if (const size_t at = text.find("_TRUNC_"); at != std::string_view::npos) {
        const TypeKind from = typeNamed(text.substr(0, at)), to = typeNamed(text.substr(at + 7));
        const bool fits =
            from != TypeKind::Unknown && types::familyOf(from) == types::Family::Real && isIntegerName(to);
        return fits ? std::optional(Conversion{How::Truncate, from, to}) : std::nullopt;
    }
    std::string_view left, right;
    if (text.starts_with("TO_")) {
        right = text.substr(3);
    } else {
        const size_t at = text.find("_TO_");
        if (at == std::string_view::npos) return std::nullopt;
        if (at == 0) return std::nullopt;
        left = text.substr(0, at);
        right = text.substr(at + 4);
    }
    if (const auto bcd = bcdConversion(left, right)) return bcd;
    const TypeKind from = typeNamed(left), to = typeNamed(right);
    if (to == TypeKind::Unknown || (from == TypeKind::Unknown && !left.empty() && left != "ANY")) return std::nullopt;
    return Conversion{How::Convert, from, to};
}

} // namespace plc::library
