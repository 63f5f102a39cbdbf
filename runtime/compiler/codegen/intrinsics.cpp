// A case here and one in library/intrinsics.cpp have the same meaning; tests compare them on random arguments, and what
// can be said once is in intrinsic_meanings.def. Standard functions in LLVM; library/intrinsics.cpp is the reference.
#include "runtime/compiler/codegen/emitter.h"

#include <numbers>

namespace plc::codegen {

using image::FaultCode;
using image::ImageHeader;
using library::Intrinsic;
using tree::Expr;
using types::Family;
using types::TypeKind;

namespace {
bool isSignedFamily(Family f) {
    return f == Family::Signed || f == Family::Duration || f == Family::Date || f == Family::TimeOfDay ||
           f == Family::DateTime;
}
} // namespace

/// The C library's function under a name LLVM does not know, so that it neither folds nor replaces it: every tier and
/// the evaluator get the same bits.
llvm::Value* FunctionEmitter::mathCall(const char* single, const char* wide, std::initializer_list<Value*> operands) {
    std::vector<Value*> arguments(operands);
    llvm::Type* type = arguments[0]->getType();
    const std::vector<llvm::Type*> parameters(arguments.size(), type);
    return b.CreateCall(m.helper(type->isFloatTy() ? single : wide, type, parameters, ModuleEmitter::Effects::None),
                        arguments);
}

llvm::Value* FunctionEmitter::mathFunction(const Expr& expr) {
    llvm::Type* type = m.scalarType(expr.type);
    const auto operand = [&](size_t i) {
        return convert(scalar(*expr.operands[i]), expr.operands[i]->type, expr.type);
    };
    switch (expr.intrinsic) {
    case Intrinsic::Sqrt:
        return b.CreateUnaryIntrinsic(llvm::Intrinsic::sqrt, operand(0)); // correctly rounded everywhere
#define PLC_MATH1(Name, function)                                                                                      \
    case Intrinsic::Name:                                                                                              \
        return mathCall("plc_" #function "f", "plc_" #function, {operand(0)});
#define PLC_MATH2(Name, function)                                                                                      \
    case Intrinsic::Name: {                                                                                            \
        Value* first = operand(0);                                                                                     \
        return mathCall("plc_" #function "f", "plc_" #function, {first, operand(1)});                                  \
    }
#include "runtime/library/intrinsic_meanings.def"
    case Intrinsic::DegToRad:
    case Intrinsic::RadToDeg: {
        const double factor = expr.intrinsic == Intrinsic::DegToRad ? std::numbers::pi / 180 : 180 / std::numbers::pi;
        const Expr& angle = *expr.operands[0];
        Value* wide = convert(scalar(angle), angle.type, types::TypeTable::of(TypeKind::Lreal));
        return b.CreateFPCast(b.CreateFMul(wide, llvm::ConstantFP::get(m.f64, factor)), type);
    }
    case Intrinsic::Frac: {
        Value* x = operand(0);
        return b.CreateFSub(x, b.CreateUnaryIntrinsic(llvm::Intrinsic::trunc, x));
    }
    default:
        return llvm::Constant::getNullValue(type);
    }
}

llvm::Value* FunctionEmitter::wholeNumber(const Expr& expr, llvm::Intrinsic::ID round) {
    const Expr& operand = *expr.operands[0];
    Value* value = scalar(operand);
    // TRUNC of an integer is the integer.
    if (!value->getType()->isFloatingPointTy()) return convert(value, operand.type, expr.type);
    Value* whole = b.CreateUnaryIntrinsic(round, value);
    if (m.types().family(expr.type) == Family::Real) return b.CreateFPCast(whole, m.scalarType(expr.type));
    return realToInteger(whole, expr.type);
}

llvm::Value* FunctionEmitter::absolute(const Expr& expr) {
    Value* value = scalar(*expr.operands[0]);
    if (value->getType()->isFloatingPointTy())
        return b.CreateFPCast(b.CreateUnaryIntrinsic(llvm::Intrinsic::fabs, value), m.scalarType(expr.type));
    value = convert(value, expr.operands[0]->type, expr.type);
    if (!isSignedFamily(m.types().family(expr.type))) return value;
    // ABS of the least number is itself: it wraps like every integer operation.
    // The first of equal operands is kept, and NaN never wins: as the evaluator compares.
    return b.CreateSelect(b.CreateICmpSLT(value, llvm::Constant::getNullValue(value->getType())), b.CreateNeg(value),
                          value);
}

// Positions, lengths and counts of shifts: any integer type, as 64 bits with a sign.
llvm::Value* FunctionEmitter::countOf(const Expr& expr) {
    Value* raw = scalar(expr);
    if (raw->getType()->isFloatingPointTy()) raw = convert(raw, expr.type, types::TypeTable::of(TypeKind::Lint));
    Value* count = castInteger(raw, expr.type, m.i64);
    // A count above 2^63 as ULINT is "very many", not negative.
    const TypeKind kind = m.types().storageKind(expr.type);
    if (kind != TypeKind::Ulint && kind != TypeKind::Lword) return count;
    return b.CreateSelect(b.CreateICmpSLT(count, int64(0)), int64(INT64_MAX), count);
}

llvm::Value* FunctionEmitter::shift(const Expr& expr) {
    llvm::Type* type = m.scalarType(expr.type);
    const unsigned bits = type->getIntegerBitWidth();
    Value* value = convert(scalar(*expr.operands[0]), expr.operands[0]->type, expr.type);
    Value* count = countOf(*expr.operands[1]);
    if (expr.intrinsic == Intrinsic::Rol || expr.intrinsic == Intrinsic::Ror) {
        // fshl takes the count modulo the width; a negative one turns the other way, as SRem and wrapping give it.
        Value* turn = b.CreateTrunc(b.CreateSRem(count, int64(bits)), type);
        return b.CreateIntrinsic(expr.intrinsic == Intrinsic::Rol ? llvm::Intrinsic::fshl : llvm::Intrinsic::fshr,
                                 {type}, {value, value, turn});
    }
    // LLVM's shifts are poison from the width on; the standard shifts everything out.
    Value* inside = b.CreateICmpULT(count, int64(bits));
    Value* amount = b.CreateTrunc(b.CreateSelect(inside, count, int64(0)), type);
    Value* shifted = expr.intrinsic == Intrinsic::Shl ? b.CreateShl(value, amount) : b.CreateLShr(value, amount);
    return b.CreateSelect(inside, shifted, llvm::Constant::getNullValue(type));
}

llvm::Value* FunctionEmitter::better(Value* candidate, Value* best, types::TypeId type, bool isMaximum) {
    return b.CreateSelect(
        compare(isMaximum ? library::BinaryOp::Greater : library::BinaryOp::Less, candidate, best, type), candidate,
        best);
}

// MIN and MAX of any number of operands, from left to right.
llvm::Value* FunctionEmitter::extreme(const Expr& expr) {
    Value* best = nullptr;
    for (const Expr* operand : expr.operands) {
        Value* value = convert(scalar(*operand), operand->type, expr.type);
        best = best ? better(value, best, expr.type, expr.intrinsic == Intrinsic::Max) : value;
    }
    return best;
}

llvm::Value* FunctionEmitter::mux(const Expr& expr) {
    Value* k = countOf(*expr.operands[0]);
    Value* result = nullptr;
    // From the last down: a K beyond it takes the last, a negative one the first.
    std::vector<Value*> values;
    for (size_t i = 1; i < expr.operands.size(); ++i)
        // All inputs are evaluated, in their order (they may be calls).
        values.push_back(convert(scalar(*expr.operands[i]), expr.operands[i]->type, expr.type));
    for (size_t i = values.size(); i-- > 0;)
        result =
            result ? b.CreateSelect(b.CreateICmpSLE(k, int64(static_cast<int64_t>(i))), values[i], result) : values[i];
    return result;
}

llvm::Value* FunctionEmitter::durationTimes(const Expr& expr, bool isDivision) {
    Value* duration = scalar(*expr.operands[0]);
    const Expr& number = *expr.operands[1];
    if (m.types().family(number.type) == Family::Real) {
        // The product of nanoseconds and a real is rounded and held in range by the library.
        Value* factor = b.CreateFPCast(scalar(number), m.f64);
        return b.CreateCall(m.helper(isDivision ? "plc_divide_duration" : "plc_multiply_duration", m.i64,
                                     {m.i64, m.f64}, ModuleEmitter::Effects::None),
                            {duration, factor});
    }
    if (isDivision) return divide(duration, countOf(number), types::TypeTable::of(TypeKind::Lint), false, &number);
    return b.CreateMul(duration, castInteger(scalar(number), number.type, m.i64));
}

// Through an integer of the same width: LLVM has no cast from float to a wider integer.
llvm::Value* FunctionEmitter::sameBits(const Expr& expr) {
    Value* value = scalar(*expr.operands[0]);
    llvm::Type* to = m.scalarType(expr.type);
    // REAL_TO_DWORD bit by bit, pointers as LWORD: no conversion of values.
    if (value->getType() == to) return value;
    if (value->getType()->isFloatTy()) value = b.CreateBitCast(value, m.i32);
    if (value->getType()->isDoubleTy()) value = b.CreateBitCast(value, m.i64);
    if (to == m.i1) return b.CreateICmpNE(value, llvm::Constant::getNullValue(value->getType()));
    if (to->isFloatTy()) return b.CreateBitCast(b.CreateZExtOrTrunc(value, m.i32), to);
    if (to->isDoubleTy()) return b.CreateBitCast(castInteger(value, expr.operands[0]->type, m.i64), to);
    return castInteger(value, expr.operands[0]->type, to);
}

llvm::Value* FunctionEmitter::headerField(size_t at, llvm::Type* stored, types::TypeId type) {
    // From the image's header, which the controller writes before each scan: a replayed scan reads the same time.
    Value* value = b.CreateAlignedLoad(stored, b.CreateConstInBoundsGEP1_64(m.i8, m_image, at), llvm::Align(4));
    if (m.scalarType(type) == m.i1) return b.CreateICmpNE(value, llvm::Constant::getNullValue(stored));
    return b.CreateZExtOrTrunc(value, m.scalarType(type));
}

/// Functions of the runtime library on 64-bit numbers; those that can fail hand ENO back through a slot.
llvm::Value* FunctionEmitter::intrinsicByHelper(const Expr& expr) {
    const auto count = [&](size_t i) { return countOf(*expr.operands[i]); };
    const auto kindOf = [&](types::TypeId type) { return int32(static_cast<uint32_t>(m.types().storageKind(type))); };
    // As a word, without a sign.
    const auto word = [&](size_t i) { return b.CreateZExtOrTrunc(scalar(*expr.operands[i]), m.i64); };
    const auto simple = [&](const char* name, std::vector<Value*> arguments) {
        std::vector<llvm::Type*> parameters;
        for (Value* a : arguments) parameters.push_back(a->getType());
        return b.CreateCall(m.helper(name, m.i64, parameters, ModuleEmitter::Effects::None), arguments);
    };
    const auto withOk = [&](const char* name, std::vector<Value*> arguments) {
        arguments.push_back(okSlot());
        std::vector<llvm::Type*> parameters;
        for (Value* a : arguments) parameters.push_back(a->getType());
        return b.CreateCall(m.helper(name, m.i64, parameters, ModuleEmitter::Effects::WritesArguments), arguments);
    };
    std::vector<Value*> counts;
    Value* result = nullptr;
    switch (expr.intrinsic) {
    case Intrinsic::ExptInt: {
        Value* base = castInteger(scalar(*expr.operands[0]), expr.operands[0]->type, m.i64);
        result = simple("plc_power_integer", {base, count(1)});
        break;
    }
    case Intrinsic::DatePart:
        result = simple("plc_date_part", {scalar(*expr.operands[0]), int64(expr.selector)});
        break;
    case Intrinsic::TimePart:
        result = simple("plc_time_part", {scalar(*expr.operands[0]), int64(expr.selector)});
        break;
    case Intrinsic::ConcatDate:
    case Intrinsic::ConcatTod:
    case Intrinsic::ConcatDt:
        for (size_t i = 0; i < expr.operands.size(); ++i) counts.push_back(count(i));
        result = withOk(expr.intrinsic == Intrinsic::ConcatDate  ? "plc_concat_date"
                        : expr.intrinsic == Intrinsic::ConcatTod ? "plc_concat_tod"
                                                                 : "plc_concat_dt",
                        counts);
        break;
    case Intrinsic::BcdTo:
        result = withOk("plc_bcd_to_integer", {word(0), kindOf(expr.type)});
        break;
    case Intrinsic::ToBcd: {
        Value* value = castInteger(scalar(*expr.operands[0]), expr.operands[0]->type, m.i64);
        result = withOk("plc_integer_to_bcd", {value, kindOf(expr.operands[0]->type), kindOf(expr.type)});
        break;
    }
    case Intrinsic::IsValidBcd: {
        Value* valid =
            b.CreateCall(m.helper("plc_is_valid_bcd", m.i8, {m.i64}, ModuleEmitter::Effects::None), {word(0)});
        return b.CreateICmpNE(valid, b.getInt8(0));
    }
    default:
        return llvm::Constant::getNullValue(m.scalarType(expr.type));
    }
    return b.CreateTrunc(result, m.scalarType(expr.type));
}

/// In the type of the result.
llvm::Value* FunctionEmitter::operandAs(const Expr& expr, size_t which) {
    return convert(scalar(*expr.operands[which]), expr.operands[which]->type, expr.type);
}

llvm::Value* FunctionEmitter::square(const Expr& expr) {
    Value* x = operandAs(expr, 0);
    return x->getType()->isFloatingPointTy() ? b.CreateFMul(x, x) : b.CreateMul(x, x);
}

llvm::Value* FunctionEmitter::selected(const Expr& expr) {
    Value* g = scalar(*expr.operands[0]);
    Value* no = operandAs(expr, 1);
    Value* yes = operandAs(expr, 2);
    return b.CreateSelect(g, yes, no);
}

/// MIN(MAX(IN, MN), MX): with MN > MX the upper limit wins (table 27).
llvm::Value* FunctionEmitter::limited(const Expr& expr) {
    Value* mn = operandAs(expr, 0);
    Value* in = operandAs(expr, 1);
    Value* mx = operandAs(expr, 2);
    return better(mx, better(mn, in, expr.type, true), expr.type, false);
}

/// A date and a time of day, both counted in nanoseconds.
llvm::Value* FunctionEmitter::sum(const Expr& expr) {
    Value* date = scalar(*expr.operands[0]); // operands from left to right
    return b.CreateAdd(date, scalar(*expr.operands[1]));
}

/// A text where a character is wanted.
llvm::Value* FunctionEmitter::firstCharacter(const Expr& expr) {
    const Text made = text(expr);
    return b.CreateZExtOrTrunc(b.CreateAlignedLoad(made.isWide ? m.i16 : m.i8, made.pointer, llvm::Align(1)),
                               m.scalarType(expr.type));
}

llvm::Value* FunctionEmitter::isFinite(const Expr& expr) {
    Value* x = scalar(*expr.operands[0]);
    if (!x->getType()->isFloatingPointTy()) return b.getTrue();
    return b.CreateFCmpOLT(b.CreateUnaryIntrinsic(llvm::Intrinsic::fabs, x),
                           llvm::ConstantFP::getInfinity(x->getType()));
}

llvm::Value* FunctionEmitter::swappedBytes(const Expr& expr) {
    Value* value = scalar(*expr.operands[0]);
    if (value->getType()->isIntegerTy() && value->getType()->getIntegerBitWidth() >= 16)
        value = b.CreateUnaryIntrinsic(llvm::Intrinsic::bswap, value);
    return convert(value, expr.operands[0]->type, expr.type);
}

llvm::Value* FunctionEmitter::intrinsic(const Expr& expr) {
    Value* result = nullptr;
    bool hasOk = false;
    switch (expr.intrinsic) {
#define PLC_MATH1(Name, function)                                                                                      \
    case Intrinsic::Name:                                                                                              \
        result = mathFunction(expr);                                                                                   \
        break;
#define PLC_MATH2(Name, function) PLC_MATH1(Name, function)
#define PLC_OF_SCAN(Name, field)                                                                                       \
    case Intrinsic::Name:                                                                                              \
        result = headerField(offsetof(ImageHeader, field), b.getIntNTy(8 * sizeof(ImageHeader::field)), expr.type);    \
        break;
#include "runtime/library/intrinsic_meanings.def"
    case Intrinsic::Abs:
        result = absolute(expr);
        break;
    case Intrinsic::Sqrt:
    case Intrinsic::DegToRad:
    case Intrinsic::RadToDeg:
    case Intrinsic::Frac:
        result = mathFunction(expr);
        break;
    case Intrinsic::Square:
        result = square(expr);
        break;
    case Intrinsic::Trunc:
    case Intrinsic::TruncReal:
        result = wholeNumber(expr, llvm::Intrinsic::trunc);
        break;
    case Intrinsic::Floor:
        result = wholeNumber(expr, llvm::Intrinsic::floor);
        break;
    case Intrinsic::Ceil:
        result = wholeNumber(expr, llvm::Intrinsic::ceil);
        break;
    case Intrinsic::RoundReal:
        result = wholeNumber(expr, llvm::Intrinsic::roundeven);
        break;
    case Intrinsic::Shl:
    case Intrinsic::Shr:
    case Intrinsic::Rol:
    case Intrinsic::Ror:
        result = shift(expr);
        break;
    case Intrinsic::Sel:
        result = selected(expr);
        break;
    case Intrinsic::Max:
    case Intrinsic::Min:
        result = extreme(expr);
        break;
    case Intrinsic::Limit:
        result = limited(expr);
        break;
    case Intrinsic::Mux:
        result = mux(expr);
        break;
    case Intrinsic::Move:
        result = operandAs(expr, 0);
        break;
    case Intrinsic::Len:
    case Intrinsic::Find:
    case Intrinsic::IsNumber:
    case Intrinsic::CharAt:
    case Intrinsic::AsciiOf:
        result = textIntrinsicScalar(expr);
        break;
    case Intrinsic::Left:
    case Intrinsic::Right:
    case Intrinsic::Mid:
    case Intrinsic::Concat:
    case Intrinsic::Insert:
    case Intrinsic::Delete:
    case Intrinsic::Replace:
    case Intrinsic::ToUpper:
    case Intrinsic::ToLower:
    case Intrinsic::Trim:
    case Intrinsic::CharOf:
        result = firstCharacter(expr);
        hasOk = true;
        break;
    case Intrinsic::MulDuration:
        result = durationTimes(expr, false);
        break;
    case Intrinsic::DivDuration:
        result = durationTimes(expr, true);
        break;
    case Intrinsic::ConcatDateTod:
        result = sum(expr);
        break;
    case Intrinsic::ConcatDate:
    case Intrinsic::ConcatTod:
    case Intrinsic::ConcatDt:
    case Intrinsic::BcdTo:
    case Intrinsic::ToBcd:
        result = intrinsicByHelper(expr);
        storeOk(expr, b.CreateICmpNE(b.CreateLoad(m.i8, okSlot()), b.getInt8(0)));
        hasOk = true;
        break;
    case Intrinsic::ExptInt:
    case Intrinsic::DatePart:
    case Intrinsic::TimePart:
    case Intrinsic::IsValidBcd:
        result = intrinsicByHelper(expr);
        break;
    case Intrinsic::IsValid:
        result = isFinite(expr);
        break;
    case Intrinsic::SameBits:
        result = sameBits(expr);
        break;
    case Intrinsic::SwapBytes:
        result = swappedBytes(expr);
        break;
    }
    // ENO of what cannot fail.
    if (!hasOk) storeOk(expr, b.getTrue());
    return result;
}

} // namespace plc::codegen
