// Values. What an operation means is written in library/evaluate.cpp, which folds constants and serves watches; the
// agreement tests compare both on random programs, so a difference here is a difference between a constant and a
// variable.
#include "runtime/compiler/codegen/emitter.h"

#include <cstring>

namespace plc::codegen {

using image::FaultCode;
using library::BinaryOp;
using tree::Expr;
using tree::ExprKind;
using types::Family;
using types::TypeKind;

namespace {
bool isSignedNumber(Family family) {
    return family != Family::Unsigned && family != Family::Bits && family != Family::Bool &&
           family != Family::Character && family != Family::Other;
}
} // namespace

llvm::Value* FunctionEmitter::scalar(const Expr& expr) {
    // Watched code tells each value; a counter has no address that could be told.
    if (m.options.watched && expr.kind == ExprKind::Load && !counterOf(*expr.place)) return watchedLoad(expr);
    Value* value = plainScalar(expr);
    watchValue(expr, value);
    return value;
}

llvm::Value* FunctionEmitter::plainScalar(const Expr& expr) {
    switch (expr.kind) {
    case ExprKind::Constant:
        return scalarConstant(expr.value, expr.type);
    case ExprKind::Load:
        if (const Counter* counter = counterOf(*expr.place))
            // The variable itself is written as well in each pass; its register is quicker and its range is known.
            return b.CreateTrunc(b.CreateLoad(m.i64, counter->value), m.scalarType(expr.type));
        return load(readAddress(*expr.place));
    case ExprKind::Unary:
        return unary(expr);
    case ExprKind::Binary:
        return binary(expr);
    case ExprKind::AndThen:
    case ExprKind::OrElse:
        return shortCircuit(expr);
    case ExprKind::Convert:
        return convertExpr(expr);
    case ExprKind::AddressOf:
    case ExprKind::InterfaceOf: {
        // A pointer is an offset into the image, so that it means the same in every copy of it: history, online change.
        const Address a = address(*expr.place);
        Value* at = a.isImage ? offset(a) : int64(0);
        return b.CreateZExtOrTrunc(at, m.scalarType(expr.type));
    }
    case ExprKind::Intrinsic:
        return intrinsic(expr);
    case ExprKind::Call: {
        const Returned returned = call(*expr.call);
        // A call without a result, as an operand of something the checker has refused.
        return returned.result ? returned.result
                               : static_cast<Value*>(llvm::Constant::getNullValue(
                                     m.isScalar(expr.type) ? m.scalarType(expr.type) : m.i64));
    }
    case ExprKind::Conditional:
        return conditional(expr);
    case ExprKind::Sequence:
        sequence(expr);
        return expr.a ? scalar(*expr.a) : static_cast<Value*>(int64(0));
    case ExprKind::Bound:
        return bound(expr);
    case ExprKind::IsNull:
        return b.CreateICmpEQ(b.CreateZExtOrTrunc(scalar(*expr.a), m.i64), int64(0));
    case ExprKind::TryCast:
        return tryCast(expr);
    }
    return int64(0);
}

llvm::Value* FunctionEmitter::scalarConstant(const types::Value& value, types::TypeId type) {
    llvm::Type* wanted = m.scalarType(type);
    if (wanted->isFloatingPointTy()) {
        const double real = std::holds_alternative<double>(value.data)    ? value.real()
                            : std::holds_alternative<int64_t>(value.data) ? static_cast<double>(value.integer())
                                                                          : 0.0;
        // Rounded here once, from the LREAL that the literal was folded in.
        if (wanted->isFloatTy()) return llvm::ConstantFP::get(m.context, llvm::APFloat(static_cast<float>(real)));
        return llvm::ConstantFP::get(m.context, llvm::APFloat(real));
    }
    const int64_t integer = std::holds_alternative<int64_t>(value.data) ? value.integer() : 0;
    if (wanted == m.i1) return b.getInt1(integer != 0);
    return llvm::ConstantInt::get(wanted, static_cast<uint64_t>(integer));
}

llvm::Value* FunctionEmitter::unary(const Expr& expr) {
    Value* a = scalar(*expr.a);
    switch (expr.unary) {
    case library::UnaryOp::Negate:
        // FNeg and not 0 - a: -0.0 has a sign.
        return a->getType()->isFloatingPointTy() ? b.CreateFNeg(a) : b.CreateNeg(a);
    case library::UnaryOp::Not:
        return b.CreateNot(a);
    }
    return a;
}

llvm::Value* FunctionEmitter::binary(const Expr& expr) {
    // A comparison's own type is BOOL; signs are those of what is compared.
    const types::TypeId type = expr.operandType.isValid() ? expr.operandType : expr.a->type;
    const bool isComparison = expr.binary >= BinaryOp::Equal;
    if (m.types().isText(expr.a->type) || m.types().isText(expr.b->type)) {
        Text a = text(*expr.a);
        if (hasEffects(expr.b) && expr.a->kind == ExprKind::Load) { // b may change what a names
            const Text kept = textTemporary(expr.a->type);
            assignText(kept, a);
            a = kept;
        }
        return textCompare(expr.binary, a, text(*expr.b));
    }
    // By bytes, only where the checker allows it.
    if (m.types().isAggregate(expr.a->type) && isComparison) {
        const Address a = aggregate(*expr.a);
        const Address c = aggregate(*expr.b);
        // Comparing a megabyte takes as long as a loop over it.
        chargeUnits(facts::copyUnits(m.types()[expr.a->type].size));
        Value* same = b.CreateCall(
            m.helper("plc_compare_bytes", m.i32, {m.ptr, m.ptr, m.i32}, ModuleEmitter::Effects::ReadsArguments),
            {pointer(a), pointer(c), int32(m.types()[expr.a->type].size)});
        return expr.binary == BinaryOp::NotEqual ? b.CreateICmpNE(same, int32(0)) : b.CreateICmpEQ(same, int32(0));
    }
    // Both operands before the operation, from left to right.
    Value* a = scalar(*expr.a);
    Value* c = scalar(*expr.b);
    if (isComparison) return compare(expr.binary, a, c, type);
    const bool isReal = a->getType()->isFloatingPointTy();
    switch (expr.binary) {
    case BinaryOp::Add:
        // Without nsw: integers wrap (D11), and LLVM must not conclude anything from an overflow.
        return isReal ? b.CreateFAdd(a, c) : b.CreateAdd(a, c);
    case BinaryOp::Subtract:
        return isReal ? b.CreateFSub(a, c) : b.CreateSub(a, c);
    case BinaryOp::Multiply:
        return isReal ? b.CreateFMul(a, c) : b.CreateMul(a, c);
    case BinaryOp::Divide:
        if (isReal) return b.CreateFDiv(a, c);
        return divide(a, c, type, false, expr.b);
    case BinaryOp::Modulo:
        // LLVM's frem would call a libm of its own choice.
        if (isReal) return mathCall("plc_fmodf", "plc_fmod", {a, c});
        return divide(a, c, type, true, expr.b);
    case BinaryOp::And:
        return b.CreateAnd(a, c);
    case BinaryOp::Or:
        return b.CreateOr(a, c);
    case BinaryOp::Xor:
        return b.CreateXor(a, c);
    default:
        return a;
    }
}

/// Integer division: 0 faults; MIN / -1 = MIN and MIN MOD -1 = 0 without the processor's trap.
llvm::Value* FunctionEmitter::divide(Value* a, Value* c, types::TypeId type, bool isModulo, const Expr*) {
    llvm::Type* wanted = a->getType();
    // A fault and not a value: the standard says "error", and a silent 0 hides the mistake in a plant.
    guard(b.CreateICmpEQ(c, llvm::Constant::getNullValue(wanted)), FaultCode::DivisionByZero);
    if (!isSignedNumber(m.types().family(type))) return isModulo ? b.CreateURem(a, c) : b.CreateUDiv(a, c);
    const unsigned width = wanted->getIntegerBitWidth();
    // Narrower than the processor divides: MIN / -1 fits into 32 bits and wraps when it is cut.
    if (width < 32) {
        Value* wideA = b.CreateSExt(a, m.i32);
        Value* wideC = b.CreateSExt(c, m.i32);
        return b.CreateTrunc(isModulo ? b.CreateSRem(wideA, wideC) : b.CreateSDiv(wideA, wideC), wanted);
    }
    if (const auto* known = llvm::dyn_cast<llvm::ConstantInt>(c); known && !known->isMinusOne())
        return isModulo ? b.CreateSRem(a, c) : b.CreateSDiv(a, c);
    // idiv traps on MIN / -1: divided by 1 instead and negated, which wraps to MIN.
    Value* isMinusOne = b.CreateICmpEQ(c, llvm::Constant::getAllOnesValue(wanted));
    Value* safe = b.CreateSelect(isMinusOne, llvm::ConstantInt::get(wanted, 1), c);
    if (isModulo) return b.CreateSRem(a, safe);
    return b.CreateSelect(isMinusOne, b.CreateNeg(a), b.CreateSDiv(a, safe));
}

llvm::Value* FunctionEmitter::compare(BinaryOp op, Value* a, Value* c, types::TypeId type) {
    // IEEE 754: nothing is equal to NaN, less or greater; only <> holds.
    using P = llvm::CmpInst;
    if (a->getType()->isFloatingPointTy()) {
        switch (op) {
        case BinaryOp::Equal:
            return b.CreateFCmpOEQ(a, c);
        case BinaryOp::NotEqual:
            // U: true with NaN. The others are O: false with NaN.
            return b.CreateFCmpUNE(a, c);
        case BinaryOp::Less:
            return b.CreateFCmpOLT(a, c);
        case BinaryOp::LessEqual:
            return b.CreateFCmpOLE(a, c);
        case BinaryOp::Greater:
            return b.CreateFCmpOGT(a, c);
        default:
            return b.CreateFCmpOGE(a, c);
        }
    }
    if (a->getType() != c->getType()) { // pointers and NULL
        a = b.CreateZExtOrTrunc(a, m.i64);
        c = b.CreateZExtOrTrunc(c, m.i64);
    }
    const bool s = isSignedNumber(m.types().family(type));
    switch (op) {
    case BinaryOp::Equal:
        return b.CreateICmpEQ(a, c);
    case BinaryOp::NotEqual:
        return b.CreateICmpNE(a, c);
    case BinaryOp::Less:
        return b.CreateICmp(s ? P::ICMP_SLT : P::ICMP_ULT, a, c);
    case BinaryOp::LessEqual:
        return b.CreateICmp(s ? P::ICMP_SLE : P::ICMP_ULE, a, c);
    case BinaryOp::Greater:
        return b.CreateICmp(s ? P::ICMP_SGT : P::ICMP_UGT, a, c);
    default:
        return b.CreateICmp(s ? P::ICMP_SGE : P::ICMP_UGE, a, c);
    }
}

llvm::Value* FunctionEmitter::shortCircuit(const Expr& expr) {
    const bool isAnd = expr.kind == ExprKind::AndThen;
    Value* a = scalar(*expr.a);
    // Not the block that the condition began in: evaluating it may have made others.
    Block* from = b.GetInsertBlock();
    Block* second = newBlock("second");
    Block* done = newBlock("done");
    b.CreateCondBr(a, isAnd ? second : done, isAnd ? done : second);
    enter(second);
    Value* c = scalar(*expr.b);
    Block* end = b.GetInsertBlock();
    b.CreateBr(done);
    enter(done);
    llvm::PHINode* result = b.CreatePHI(m.i1, 2);
    result->addIncoming(b.getInt1(!isAnd), from);
    result->addIncoming(c, end);
    return result;
}

llvm::Value* FunctionEmitter::conditional(const Expr& expr) {
    Value* condition = scalar(*expr.a);
    Block* yes = newBlock("yes");
    Block* no = newBlock("no");
    Block* done = newBlock("done");
    b.CreateCondBr(condition, yes, no);
    enter(yes);
    Value* first = scalar(*expr.b);
    // Where the branch ends, which is seldom where it began.
    Block* yesEnd = b.GetInsertBlock();
    b.CreateBr(done);
    enter(no);
    Value* second = scalar(*expr.c);
    Block* noEnd = b.GetInsertBlock();
    b.CreateBr(done);
    enter(done);
    llvm::PHINode* result = b.CreatePHI(first->getType(), 2);
    result->addIncoming(first, yesEnd);
    result->addIncoming(second, noEnd);
    return result;
}

// LOWER_BOUND and UPPER_BOUND of ARRAY[*]; of other arrays the checker has made constants.
llvm::Value* FunctionEmitter::bound(const Expr& expr) {
    const Address a = address(*expr.place);
    const auto bounds = boundsOf(a);
    const auto dimension = static_cast<size_t>(std::max<int64_t>(0, expr.selector));
    Value* value = dimension >= bounds.size() ? static_cast<Value*>(int64(0))
                   : expr.isUpper             ? bounds[dimension].second
                                              : bounds[dimension].first;
    return b.CreateSExtOrTrunc(value, m.scalarType(expr.type));
}

/// The offset when an instance of the wanted kind lies there, else 0. Never faults.
llvm::Value* FunctionEmitter::tryCast(const Expr& expr) {
    Value* at = b.CreateZExtOrTrunc(scalar(*expr.a), m.i64);
    const types::Type& type = m.types()[expr.type];
    const types::TypeId wanted = type.kind == TypeKind::Interface ? expr.type : type.element;
    bool any = false;
    // One byte for each block number: whether it is, or implements, what is wanted.
    llvm::GlobalVariable* flags = m.blockFlags(wanted, any);
    // No block of the program could be it.
    if (!any) return int64(0);
    Block* from = b.GetInsertBlock();
    Block* look = newBlock("look");
    Block* known = newBlock("known");
    Block* done = newBlock("done");
    b.CreateCondBr(isLive(at, int64(8)), look, done);
    enter(look);
    Value* number =
        b.CreateZExt(b.CreateAlignedLoad(m.i32, b.CreateInBoundsGEP(m.i8, m_image, at), llvm::Align(1)), m.i64);
    b.CreateCondBr(b.CreateICmpULT(number, int64(m.facts.blockCount())), known, done);
    enter(known);
    Value* fits = b.CreateICmpNE(b.CreateLoad(m.i8, b.CreateInBoundsGEP(m.i8, flags, number)), b.getInt8(0));
    Value* result = b.CreateSelect(fits, at, int64(0));
    b.CreateBr(done);
    enter(done);
    llvm::PHINode* phi = b.CreatePHI(m.i64, 3);
    phi->addIncoming(int64(0), from);
    phi->addIncoming(int64(0), look);
    phi->addIncoming(result, known);
    return phi;
}

// ---------------------------------------------------------------- aggregates

Address FunctionEmitter::aggregate(const Expr& expr) {
    // An aggregate is its address; who needs it to last copies it.
    const Address a = plainAggregate(expr);
    if (m.options.watched && expr.kind != ExprKind::Constant)
        watch(image::WatchKind::Bytes, &expr, b.CreatePtrToInt(pointer(a), m.i64), int64(m.types()[expr.type].size));
    return a;
}

Address FunctionEmitter::plainAggregate(const Expr& expr) {
    switch (expr.kind) {
    case ExprKind::Load:
        return readAddress(*expr.place);
    case ExprKind::Constant: {
        const types::Type& type = m.types()[expr.type];
        std::vector<std::byte> bytes = type.initial;
        // Constants are in the module and not in the image: nothing may write them, and they cost no room in a
        // recording.
        bytes.resize(std::max(1u, type.size));
        if (expr.value.hasValue()) types::writeValue(m.types(), expr.type, expr.value, bytes);
        Address a;
        a.base = m.constantBytes(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), 8);
        a.isImage = false;
        a.type = expr.type;
        a.align = 8;
        return a;
    }
    case ExprKind::Convert:
        return aggregate(*expr.a);
    case ExprKind::Sequence:
        sequence(expr);
        return aggregate(*expr.a);
    default: {
        const Address a = temporary(expr.type);
        aggregateInto(expr, a);
        return a;
    }
    }
}

// Straight into the target where that is possible: an aggregate of a megabyte should be copied once.
void FunctionEmitter::aggregateInto(const Expr& expr, const Address& target) {
    const uint32_t size = m.types()[expr.type].size;
    if (expr.kind == ExprKind::Call) {
        const Returned returned = call(*expr.call);
        // The result is in the callee's frame until the next call uses that memory.
        Address from;
        from.baseOffset = returned.frame;
        from.base = b.CreateInBoundsGEP(m.i8, m_image, from.baseOffset);
        copy(target, from, size);
        return;
    }
    // Only the chosen one is evaluated: the other may be large, or fault.
    const bool isChoice = expr.kind == ExprKind::Conditional ||
                          (expr.kind == ExprKind::Intrinsic && expr.intrinsic == library::Intrinsic::Sel);
    if (isChoice) {
        const Expr* no = expr.kind == ExprKind::Conditional ? expr.c : expr.operands[1];
        const Expr* yes = expr.kind == ExprKind::Conditional ? expr.b : expr.operands[2];
        Value* condition = scalar(expr.kind == ExprKind::Conditional ? *expr.a : *expr.operands[0]);
        Block* yesBlock = newBlock("yes");
        Block* noBlock = newBlock("no");
        Block* done = newBlock("done");
        b.CreateCondBr(condition, yesBlock, noBlock);
        enter(yesBlock);
        aggregateInto(*yes, target);
        b.CreateBr(done);
        enter(noBlock);
        aggregateInto(*no, target);
        b.CreateBr(done);
        enter(done);
        return;
    }
    if (expr.kind == ExprKind::Intrinsic && expr.intrinsic == library::Intrinsic::Mux) {
        Value* k = castInteger(scalar(*expr.operands[0]), expr.operands[0]->type, m.i64);
        const int64_t last = static_cast<int64_t>(expr.operands.size()) - 2;
        Block* done = newBlock("done");
        Block* lastBlock = newBlock("last");
        // As library/intrinsics.cpp: a negative K takes the first operand, one beyond the last takes the last.
        k = b.CreateSelect(b.CreateICmpSLT(k, int64(0)), int64(0), k);
        // Aggregates are not evaluated before the choice: only one of them is copied.
        llvm::SwitchInst* choice = b.CreateSwitch(k, lastBlock);
        for (int64_t i = 0; i <= last; ++i) {
            Block* block = i == last ? lastBlock : newBlock("choice");
            if (i != last) choice->addCase(b.getInt64(static_cast<uint64_t>(i)), block);
            enter(block);
            aggregateInto(*expr.operands[static_cast<size_t>(i) + 1], target);
            b.CreateBr(done);
        }
        enter(done);
        return;
    }
    if (expr.kind == ExprKind::Intrinsic && !expr.operands.empty()) { // MOVE, SameBits
        copy(target, aggregate(*expr.operands[0]), size);
        return;
    }
    copy(target, aggregate(expr), size);
}

// ---------------------------------------------------------------- what is known about a value

// What values an index can have, from its types, constants and counters: enough to leave out most checks of loops over
// arrays. Everything here has to be true for every value that the code can compute.
Range FunctionEmitter::rangeOf(const Expr& expr) {
    const Family family = m.types().family(expr.type);
    // Of types of eight bytes nothing is assumed: ULINT does not fit into a Range.
    // What any value of the type can be; every rule below may only narrow it.
    Range own;
    if (m.isScalar(expr.type) && (types::isInteger(family) || family == Family::Bool) &&
        m.types()[m.types().storage(expr.type)].size < 8) {
        const auto [low, high] = types::TypeTable::integerRange(m.types().storageKind(expr.type));
        own = {low, static_cast<int64_t>(high)};
    }
    // A result beyond the type's range wraps, and then nothing is known.
    const auto within = [&](Range r) { return r.low >= own.low && r.high <= own.high ? r : own; };
    switch (expr.kind) {
    case ExprKind::Constant:
        if (std::holds_alternative<int64_t>(expr.value.data)) return {expr.value.integer(), expr.value.integer()};
        return own;
    case ExprKind::Load:
        if (const Counter* counter = counterOf(*expr.place)) return counter->range;
        return own;
    case ExprKind::Convert: {
        const Family from = m.types().family(expr.a->type);
        if (!m.isScalar(expr.a->type) || (!types::isInteger(from) && from != Family::Bool) || !types::isInteger(family))
            return own;
        return within(rangeOf(*expr.a));
    }
    case ExprKind::Binary: {
        if (!types::isInteger(family)) return own;
        const Range a = rangeOf(*expr.a), c = rangeOf(*expr.b);
        Range r;
        switch (expr.binary) {
        case BinaryOp::Add:
            if (__builtin_add_overflow(a.low, c.low, &r.low) || __builtin_add_overflow(a.high, c.high, &r.high))
                return own;
            return within(r);
        case BinaryOp::Subtract:
            if (__builtin_sub_overflow(a.low, c.high, &r.low) || __builtin_sub_overflow(a.high, c.low, &r.high))
                return own;
            return within(r);
        // Only by a constant that is not negative: otherwise the ends may change places.
        case BinaryOp::Multiply:
            if (c.low != c.high || c.low < 0 || __builtin_mul_overflow(a.low, c.low, &r.low) ||
                __builtin_mul_overflow(a.high, c.low, &r.high))
                return own;
            return within(r);
        case BinaryOp::Modulo:
            // Division cuts towards zero (edition 3, table 29), so that the remainder has the sign of the left operand.
            if (c.low != c.high || c.low <= 0) return own;
            return within({a.low >= 0 ? 0 : -(c.low - 1), c.low - 1});
        case BinaryOp::Divide:
            if (c.low != c.high || c.low <= 0 || (family == Family::Unsigned && a.low < 0)) return own;
            if (family == Family::Bits && a.low < 0) return own;
            return within({a.low / c.low, a.high / c.low});
        // i AND 16#F is within 0..15, which is how rings are indexed.
        case BinaryOp::And:
            if (c.low == c.high && c.low >= 0) return within({0, c.low});
            return own;
        default:
            return own;
        }
    }
    default:
        return own;
    }
}

void FunctionEmitter::sequence(const Expr& expr) {
    const uint32_t site = m_site; // what follows belongs to the statement around
    body(expr.statements);
    m_site = site;
}

void FunctionEmitter::storeOk(const Expr& expr, Value* ok) {
    if (expr.ok) store(address(*expr.ok), ok);
}

} // namespace plc::codegen
