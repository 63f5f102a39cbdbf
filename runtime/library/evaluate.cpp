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
Evaluated failed(EvaluationError error) { return {{}, false, error}; }

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

Evaluated compared(BinaryOp op, int order) {
    switch (op) {
    case BinaryOp::Equal:
        return boolean(order == 0);
    case BinaryOp::NotEqual:
        return boolean(order != 0);
    case BinaryOp::Less:
        return boolean(order == -1);
    case BinaryOp::LessEqual:
        return boolean(order == -1 || order == 0);
    case BinaryOp::Greater:
        return boolean(order == 1);
    case BinaryOp::GreaterEqual:
        return boolean(order == 1 || order == 0);
    default:
        return failed(EvaluationError::NotEvaluable);
    }
}

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

Evaluated onIntegers(TypeId type, TypeKind kind, BinaryOp op, int64_t a, int64_t b) {
    if (isComparison(op)) return compared(op, order(a, b, isUnsigned(kind)));
    const auto left = static_cast<uint64_t>(a), right = static_cast<uint64_t>(b);
    uint64_t result = 0;
    switch (op) {
    case BinaryOp::Add:
        result = left + right;
        break;
    case BinaryOp::Subtract:
        result = left - right;
        break;
    case BinaryOp::Multiply:
        result = left * right;
        break;
    case BinaryOp::And:
        result = left & right;
        break;
    case BinaryOp::Or:
        result = left | right;
        break;
    case BinaryOp::Xor:
        result = left ^ right;
        break;
    case BinaryOp::Divide:
        return divideIntegers({type, {}}, kind, false, a, b);
    case BinaryOp::Modulo:
        return divideIntegers({type, {}}, kind, true, a, b);
    default:
        return failed(EvaluationError::NotEvaluable);
    }
    return {{type, types::wrapInteger(kind, static_cast<int64_t>(result))}};
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
