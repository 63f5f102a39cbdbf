// X_TO_Y as types::convert means it, inline for scalars.
#include "runtime/compiler/codegen/emitter.h"

#include "runtime/types/conversion.h"

namespace plc::codegen {

using tree::Expr;
using types::Family;
using types::TypeKind;

namespace {
constexpr int64_t kDay = 86'400'000'000'000; // ns

// All are a signed count of nanoseconds, dates from 1970.
bool isTime(Family f) {
    return f == Family::Duration || f == Family::Date || f == Family::TimeOfDay || f == Family::DateTime;
}
bool isSigned(Family f) { return f == Family::Signed || isTime(f); }

} // namespace

// Widened by the sign of where it comes from, cut without a question: wrapping is what the language says.
llvm::Value* FunctionEmitter::castInteger(Value* value, types::TypeId from, llvm::Type* to) {
    if (value->getType() == to) return value;
    return isSigned(m.types().family(from)) ? b.CreateSExtOrTrunc(value, to) : b.CreateZExtOrTrunc(value, to);
}

llvm::Value* FunctionEmitter::integerToReal(Value* value, types::TypeId from, llvm::Type* to) {
    return isSigned(m.types().family(from)) ? b.CreateSIToFP(value, to) : b.CreateUIToFP(value, to);
}

llvm::Value* FunctionEmitter::startOfDay(Value* nanoseconds) {
    // Rounds down also before 1970, where the remainder is negative.
    Value* rest = b.CreateSRem(nanoseconds, int64(kDay));
    Value* below = b.CreateSelect(b.CreateICmpSLT(rest, int64(0)), int64(kDay), int64(0));
    return b.CreateSub(b.CreateSub(nanoseconds, rest), below);
}

llvm::Value* FunctionEmitter::fitTime(Value* nanoseconds, TypeKind to) {
    // A DT has a date and a time of day: each takes its part, as types::convert does.
    const Family family = types::familyOf(to);
    if (family == Family::Date) return startOfDay(nanoseconds);
    if (family == Family::TimeOfDay) return b.CreateSub(nanoseconds, startOfDay(nanoseconds));
    return nanoseconds;
}

/// A whole (already rounded) real as an integer: saturating, NaN gives 0.
llvm::Value* FunctionEmitter::realToInteger(Value* whole, types::TypeId to) {
    // ONE: false for 0 and for NaN.
    if (m.types().storageKind(to) == TypeKind::Bool)
        return b.CreateFCmpONE(whole, llvm::Constant::getNullValue(whole->getType()));
    // The saturating intrinsics: plain fptosi is undefined out of range, and processors differ.
    const bool s = isSigned(m.types().family(to));
    return b.CreateIntrinsic(s ? llvm::Intrinsic::fptosi_sat : llvm::Intrinsic::fptoui_sat,
                             {m.scalarType(to), whole->getType()}, {whole});
}

llvm::Value* FunctionEmitter::convert(Value* value, types::TypeId from, types::TypeId to, Value** ok) {
    const TypeKind source = m.types().storageKind(from), target = m.types().storageKind(to);
    llvm::Type* wanted = m.scalarType(to);
    // By storage: a subrange or an enumeration is converted as its base.
    if (source == target) return value;
    const Family fromFamily = m.types().family(from), toFamily = m.types().family(to);
    // From real, from time, from everything else: within each, special targets first.
    if (fromFamily == Family::Real) {
        if (toFamily == Family::Real) return b.CreateFPCast(value, wanted);
        if (isTime(toFamily)) {
            Value* wide = b.CreateFPExt(value, m.f64);
            return b.CreateCall(m.helper("plc_real_to_time", m.i64, {m.f64, m.i32}, ModuleEmitter::Effects::None),
                                {wide, int32(static_cast<uint32_t>(target))});
        }
        if (target == TypeKind::Bool) return realToInteger(value, to);
        // Rounds halves to even (IEC 60559), as the standard asks of REAL_TO_INT (2.5.1.5.1).
        return realToInteger(b.CreateUnaryIntrinsic(llvm::Intrinsic::roundeven, value), to);
    }
    if (isTime(fromFamily)) {
        if (isTime(toFamily)) return fitTime(value, target);
        if (target == TypeKind::Bool) return b.CreateICmpNE(value, int64(0));
        // TIME_TO_DINT gives milliseconds, DATE_TO_… days: each kind has the unit it had before times became 64 bits.
        const int64_t unit = types::nanosecondsOf(source);
        Value* count = unit == 1 ? value : b.CreateSDiv(value, int64(unit));
        if (toFamily == Family::Real) return b.CreateSIToFP(count, wanted);
        // Wraps, like every narrowing of integers that is written out.
        return b.CreateTrunc(count, wanted);
    }
    // Integers, bits, BOOL, characters, pointers.
    if (toFamily == Family::Real) return integerToReal(value, from, wanted);
    if (isTime(toFamily)) {
        const int64_t unit = types::nanosecondsOf(target);
        Value* count = castInteger(value, from, m.i64);
        return fitTime(unit == 1 ? count : b.CreateMul(count, int64(unit)), target);
    }
    if (target == TypeKind::Bool) return b.CreateICmpNE(value, llvm::Constant::getNullValue(value->getType()));
    if (fromFamily == Family::Character && toFamily == Family::Character &&
        m.types().strings != types::StringCode::Latin1)
        return convertCharacter(value, target, ok);
    return castInteger(value, from, wanted);
}

/// CHAR ⇄ WCHAR where the numbers of a character differ: STRING is not Latin-1.
llvm::Value* FunctionEmitter::convertCharacter(Value* value, TypeKind to, Value** ok) {
    Value* code = int32(static_cast<uint32_t>(m.types().strings));
    const auto call = [&](const char* helper) {
        return b.CreateCall(m.helper(helper, m.i32, {m.i32, m.i32}, ModuleEmitter::Effects::None),
                            {b.CreateZExtOrTrunc(value, m.i32), code});
    };
    if (to == TypeKind::Wchar)
        return b.CreateTrunc(call("plc_char_to_wide_by"), m.scalarType(types::TypeTable::of(to)));
    Value* made = call("plc_wchar_to_narrow_by");
    Value* isKnown = b.CreateICmpSGE(made, int32(0));
    if (ok) *ok = isKnown;
    return b.CreateTrunc(b.CreateSelect(isKnown, made, int32('?')), m.scalarType(types::TypeTable::of(to)));
}

// A conversion as it is in the tree, with ENO where the call had one.
llvm::Value* FunctionEmitter::convertExpr(const Expr& expr) {
    if (m.types().isText(expr.a->type)) {
        Value* result = convertText(*expr.a, expr.type);
        // Only text can fail to be a number; every other conversion sets ENO.
        if (expr.ok) storeOk(expr, b.CreateICmpNE(b.CreateLoad(m.i8, okSlot()), b.getInt8(0)));
        return result;
    }
    // The counter of a FOR is kept in 64 bits: widening its variable costs nothing.
    if (expr.a->kind == tree::ExprKind::Load && m.scalarType(expr.type) == m.i64 &&
        types::isInteger(m.types().family(expr.type)))
        if (const Counter* counter = counterOf(*expr.a->place)) return b.CreateLoad(m.i64, counter->value);
    Value* ok = b.getTrue();
    Value* result = convert(scalar(*expr.a), expr.a->type, expr.type, &ok);
    storeOk(expr, ok);
    return result;
}

llvm::Value* FunctionEmitter::okSlot() {
    // One for the function: it is read directly after each call that writes it.
    if (!m_ok) m_ok = newSlot(m.i8, "ok");
    return m_ok;
}

/// WSTRING_TO_CHAR where STRING is not Latin-1: as a STRING of one byte, which is 0 when there is nothing to convert.
llvm::Value* FunctionEmitter::firstNarrowed(const Text& wide) {
    Address a;
    a.base = m_framePointer;
    a.constant = allocateTemporary(2, 1); // one character and its end mark
    const Text made{pointer(a), int32(1), false};
    assignText(made, wide);
    Value* first = b.CreateLoad(m.i8, made.pointer);
    Value* isWhole = b.CreateICmpNE(b.CreateLoad(m.i8, okSlot()), b.getInt8(0));
    b.CreateStore(b.CreateZExt(b.CreateAnd(isWhole, b.CreateICmpNE(first, b.getInt8(0))), m.i8), okSlot());
    return first;
}

/// STRING_TO_X; `expr` is the text.
llvm::Value* FunctionEmitter::convertText(const Expr& expr, types::TypeId to) {
    Text from = text(expr);
    const TypeKind target = m.types().storageKind(to);
    // The first character has another number in the other width.
    if (m.types().strings != types::StringCode::Latin1) {
        if (target == TypeKind::Wchar && !from.isWide) from = widened(from, 1);
        if (target == TypeKind::Char && from.isWide) return firstNarrowed(from);
    }
    Value* ok = okSlot();
    Value* kind = int32(static_cast<uint32_t>(target));
    const std::string prefix = from.isWide ? "plc_wtext_" : "plc_text_";
    if (m.types().family(to) == Family::Real) {
        Value* real = b.CreateCall(m.helper((prefix + "to_real").c_str(), m.f64, {m.ptr, m.i32, m.i32, m.ptr},
                                            ModuleEmitter::Effects::WritesArguments),
                                   {from.pointer, from.capacity, kind, ok});
        return b.CreateFPCast(real, m.scalarType(to));
    }
    Value* integer = b.CreateCall(m.helper((prefix + "to_integer").c_str(), m.i64, {m.ptr, m.i32, m.i32, m.ptr},
                                           ModuleEmitter::Effects::WritesArguments),
                                  {from.pointer, from.capacity, kind, ok});
    if (m.scalarType(to) == m.i1) return b.CreateICmpNE(integer, int64(0));
    // The library has already held the number within the range of `kind`.
    return b.CreateTrunc(integer, m.scalarType(to));
}

} // namespace plc::codegen
