// The standard functions by name: parameters with every accepted spelling, overload rules, and the intrinsic each
// becomes. One table (signatures.cpp); the checker resolves calls with it, completion and the reference show it.
// Immutable, any thread.
#pragma once
#include "runtime/types/type_table.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plc::library {

enum class Intrinsic : uint8_t {
#define PLC_INTRINSIC(Name) Name,
#include "runtime/library/intrinsics.def"
};

/// What a parameter accepts (edition 3, figure 5: hierarchy of generic types).
/// AnyBit takes integers too (CODESYS shifts and masks them); AnyText takes CHAR and WCHAR as texts of one character.
enum class Generic : uint8_t {
    Fixed,
    Any,
    AnyElementary,
    AnyMagnitude,
    AnyNum,
    AnyInt,
    AnyReal,
    AnyBit,
    AnyText,
    AnyDate,
    AnyDuration,
    AnyNumOrDuration
};

struct Parameter {
    std::string_view name;                    // IEC name: IN1
    std::vector<std::string_view> otherNames; // STR1, …
    Generic generic = Generic::Any;
    types::TypeKind fixed = types::TypeKind::Unknown; // Generic::Fixed; String = any text length
    bool isOutput = false;
};

/// How operand types become one: see `Signature::Rule`.
enum class Rule : uint8_t {
    Common,       // all generic operands are converted to their common type, which is the result
    FirstOperand, // the result has the first operand's type; others as declared
    FixedResult,  // result is `result`; generic operands as they are
    RealOperand, // operands become REAL/LREAL (LREAL when any integer operand is wider than 16 bits or LREAL), which is
                 // the result
    SecondOperand, // SEL, MUX: operands from the second on are made common, which is the result
    Compare,       // common operand type, result BOOL, chain for more than two (GT, GE, EQ, LE, LT, NE)
    Special,       // `special` of sema: SIZEOF, ADR, REF, LOWER_BOUND, EXPT, conversions, INDEXOF…
};

/// A function form of an operator (ADD, AND, GT …) has `operatorName` instead of an intrinsic: the call means the
/// operator written between its operands, with the operator's own rules for their types, then converted to `result`
/// where that is set (SUB_DATE_DATE). One parameter: "NOT", "-" (NEG) are unary; with `selector` ≥ 0 the right operand
/// is that constant (INC: + 1). TRUNC and its like give the type that is wanted where they stand; `result` where none
/// is.
struct Signature {
    std::string_view name; // upper case
    std::vector<Parameter> parameters;
    bool isExtensible = false; // the last parameter repeats: IN1, IN2, … IN17
    Rule rule = Rule::Common;
    types::TypeKind result = types::TypeKind::Unknown; // FixedResult
    std::optional<Intrinsic> intrinsic;
    std::string_view operatorName; // "+", "AND", "=", …
    int64_t selector = -1;         // DatePart, TimePart
    std::string_view summary;      // one line for hover and reference
};

/// Without case; none for unknown names and for conversions.
[[nodiscard]] const Signature* findSignature(std::string_view name);
[[nodiscard]] std::span<const Signature> signatures();

/// INT_TO_REAL, TO_REAL, REAL_TRUNC_INT, BCD_TO_INT, BYTE_BCD_TO_USINT, …: every X_TO_Y by pattern.
struct Conversion {
    enum class How : uint8_t { Convert, Truncate, FromBcd, ToBcd } how = How::Convert;
    types::TypeKind from = types::TypeKind::Unknown; // Unknown: overloaded (TO_INT)
    types::TypeKind to = types::TypeKind::Unknown;   // String/Wstring: default capacity
};
[[nodiscard]] std::optional<Conversion> findConversion(std::string_view name);

} // namespace plc::library
