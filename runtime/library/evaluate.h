// Reference semantics of operators and intrinsics on Values: the constant folder and the expression evaluator use it,
// tests hold generated code against it. Pure functions, any thread.
#pragma once
#include "runtime/image/layout.h"
#include "runtime/library/signatures.h"

#include <optional>

namespace plc::library {

enum class UnaryOp : uint8_t { Negate, Not };
enum class BinaryOp : uint8_t {
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    And,
    Or,
    Xor,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual
};

enum class EvaluationError : uint8_t {
    None,
    DivisionByZero,
    IndexOutOfRange,
    NullReference,
    StringIndex,
    NotEvaluable
};

struct Evaluated {
    types::Value value;
    bool ok = true; // ENO
    EvaluationError error = EvaluationError::None;
};
[[nodiscard]] inline Evaluated failed(EvaluationError error) { return {{}, false, error}; }

/// Both operands are of `type` (integer wraps in it; text compares by character; REAL in single precision).
[[nodiscard]] Evaluated evaluateBinary(const types::TypeTable& types, BinaryOp op, types::TypeId type,
                                       const types::Value& left, const types::Value& right);
[[nodiscard]] Evaluated evaluateUnary(const types::TypeTable& types, UnaryOp op, types::TypeId type,
                                      const types::Value& operand);
/// Of literals without a type, which are computed with all bits there are: a product beyond them stays the largest. A
/// comparison gives 0 or 1; nothing after a division by zero.
using WideInteger = __int128;
[[nodiscard]] std::optional<WideInteger> evaluateWide(BinaryOp op, WideInteger left, WideInteger right);
/// `header` gives clock and scan; null while folding (Time, FirstScan… then are NotEvaluable).
[[nodiscard]] Evaluated evaluateIntrinsic(const types::TypeTable& types, Intrinsic intrinsic, types::TypeId result,
                                          std::span<const types::Value> operands, const image::ImageHeader* header,
                                          int64_t selector = -1);

} // namespace plc::library
