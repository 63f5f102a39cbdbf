#include "runtime/library/evaluate.h"

#include "runtime/types/conversion.h"

#include <cmath>

namespace plc::library {
namespace {

using types::Family;
using types::TypeId;
using types::TypeKind;
using types::TypeTable;
using types::Value;

Evaluated boolean(bool truth) { return {{TypeTable::of(TypeKind::Bool), int64_t(truth)}}; }
bool isUnsigned(TypeKind kind) {
    const Family family = types::familyOf(kind);
    return family != Family::Signed && family != Family::Duration && family != Family::Date &&
           family != Family::TimeOfDay && family != Family::DateTime;
}

/// -1, 0, 1; 2 when the operands have no order (NaN).
int order(double a, double b) { return a < b ? -1 : a > b ? 1 : a == b ? 0 : 2; }
int order(int64_t a, int64_t b, bool areUnsigned) {
    if (areUnsigned) return static_cast<uint64_t>(a) < static_cast<uint64_t>(b) ? -1 : a != b;
    return a < b ? -1 : a != b;
}

bool holds(BinaryOp op, int order) {
    switch (op) {
    case BinaryOp::Equal:
        return order == 0;
    case BinaryOp::NotEqual:
        return order != 0;
    case BinaryOp::Less:
        return order == -1;
    case BinaryOp::LessEqual:
        return order == -1 || order == 0;
    case BinaryOp::Greater:
        return order == 1;
    case BinaryOp::GreaterEqual:
        return order == 1 || order == 0;
    default:
        return false; // no comparison
    }
}
Evaluated compared(BinaryOp op, int order) { return boolean(holds(op, order)); }

bool isComparison(BinaryOp op) { return op >= BinaryOp::Equal; }

Evaluated divideIntegers(const Value& as, TypeKind kind, bool isModulo, int64_t a, int64_t b) {
    if (b == 0) return failed(EvaluationError::DivisionByZero);
    int64_t result = 0;
    if (isUnsigned(kind)) {
        const auto left = static_cast<uint64_t>(a), right = static_cast<uint64_t>(b);
        result = static_cast<int64_t>(isModulo ? left % right : left / right);
    } else if (b == -1) { // MIN / -1 = MIN
        result = isModulo ? 0 : static_cast<int64_t>(0 - static_cast<uint64_t>(a));
    } else {
        result = isModulo ? a % b : a / b;
    }
    return {{as.type, types::wrapInteger(kind, result)}};
}

/// + - * AND OR XOR, which overflow in their own way in each width: unsigned types wrap, WideInteger does not get
/// there.
template <class Integer> std::optional<Integer> withoutDivision(BinaryOp op, Integer a, Integer b) {
    switch (op) {
    case BinaryOp::Add:
        return a + b;
    case BinaryOp::Subtract:
        return a - b;
    case BinaryOp::Multiply:
        return a * b;
    case BinaryOp::And:
        return a & b;
    case BinaryOp::Or:
        return a | b;
    case BinaryOp::Xor:
        return a ^ b;
    default:
        return std::nullopt;
    }
}

Evaluated onIntegers(TypeId type, TypeKind kind, BinaryOp op, int64_t a, int64_t b) {
    if (isComparison(op)) return compared(op, order(a, b, isUnsigned(kind)));
    if (op == BinaryOp::Divide || op == BinaryOp::Modulo)
        return divideIntegers({type, {}}, kind, op == BinaryOp::Modulo, a, b);
    const auto result = withoutDivision(op, static_cast<uint64_t>(a), static_cast<uint64_t>(b));
    if (!result) return failed(EvaluationError::NotEvaluable);
    return {{type, types::wrapInteger(kind, static_cast<int64_t>(*result))}};
}

template <class Number> Evaluated onReals(TypeId type, BinaryOp op, Number a, Number b) {
    if (isComparison(op)) return compared(op, order(a, b));
    switch (op) {
    case BinaryOp::Add:
        return {{type, static_cast<double>(a + b)}};
    case BinaryOp::Subtract:
        return {{type, static_cast<double>(a - b)}};
    case BinaryOp::Multiply:
        return {{type, static_cast<double>(a * b)}};
    case BinaryOp::Divide:
        return {{type, static_cast<double>(a / b)}};
    case BinaryOp::Modulo:
        return {{type, static_cast<double>(std::fmod(a, b))}};
    default:
        return failed(EvaluationError::NotEvaluable);
    }
}

template <class Text> Evaluated onTexts(BinaryOp op, const Text& a, const Text& b) {
    if (!isComparison(op)) return failed(EvaluationError::NotEvaluable);
    const int result = a.compare(b);
    return compared(op, result < 0 ? -1 : result > 0 ? 1 : 0);
}

} // namespace

Evaluated evaluateBinary(const TypeTable& types, BinaryOp op, TypeId type, const Value& left, const Value& right) {
    const TypeKind kind = types.storageKind(type);
    if (left.data.index() != right.data.index()) return failed(EvaluationError::NotEvaluable);
    if (const auto* a = std::get_if<int64_t>(&left.data)) return onIntegers(type, kind, op, *a, right.integer());
    if (const auto* a = std::get_if<double>(&left.data)) {
        if (kind == TypeKind::Real) return onReals(type, op, static_cast<float>(*a), static_cast<float>(right.real()));
        return onReals(type, op, *a, right.real());
    }
    if (const auto* a = std::get_if<std::string>(&left.data)) return onTexts(op, *a, std::get<std::string>(right.data));
    if (const auto* a = std::get_if<std::u16string>(&left.data))
        return onTexts(op, *a, std::get<std::u16string>(right.data));
    return failed(EvaluationError::NotEvaluable);
}

std::optional<WideInteger> evaluateWide(BinaryOp op, WideInteger left, WideInteger right) {
    if (isComparison(op)) return holds(op, left < right ? -1 : left != right);
    if (op == BinaryOp::Divide || op == BinaryOp::Modulo) {
        if (right == 0) return std::nullopt;
        return op == BinaryOp::Divide ? left / right : left % right;
    }
    WideInteger product = 0;
    if (op == BinaryOp::Multiply && __builtin_mul_overflow(left, right, &product)) {
        const auto largest = static_cast<WideInteger>(~static_cast<unsigned __int128>(0) >> 1);
        return (left < 0) == (right < 0) ? largest : -largest;
    }
    return withoutDivision(op, left, right);
}

Evaluated evaluateUnary(const TypeTable& types, UnaryOp op, TypeId type, const Value& operand) {
    const TypeKind kind = types.storageKind(type);
    if (const auto* number = std::get_if<int64_t>(&operand.data)) {
        if (op == UnaryOp::Negate)
            return {{type, types::wrapInteger(kind, static_cast<int64_t>(0 - static_cast<uint64_t>(*number)))}};
        return {{type, kind == TypeKind::Bool ? int64_t(*number == 0) : types::wrapInteger(kind, ~*number)}};
    }
    if (const auto* number = std::get_if<double>(&operand.data); number && op == UnaryOp::Negate)
        return {{type, -*number}};
    return failed(EvaluationError::NotEvaluable);
}

} // namespace plc::library
