// STRING and WSTRING: every operation is a call of runtime/library/text_runtime.h on places in the image; temporaries
// lie in the frame.
#include "runtime/compiler/codegen/emitter.h"

namespace plc::codegen {

using image::FaultCode;
using library::Intrinsic;
using tree::Expr;
using tree::ExprKind;
using tree::PlaceKind;
using types::Family;
using types::TypeKind;

llvm::Value* FunctionEmitter::textCall(const char* name, bool isWide, llvm::Type* result, std::vector<Value*> arguments,
                                       bool writes) {
    // The signature follows from the arguments; jit/ binds the names to text_runtime's functions.
    std::vector<llvm::Type*> parameters;
    for (Value* a : arguments) parameters.push_back(a->getType());
    chargeTexts(arguments);
    const std::string full = std::string(isWide ? "plc_wtext_" : "plc_text_") + name;
    return b.CreateCall(
        m.helper(full.c_str(), result, parameters,
                 writes ? ModuleEmitter::Effects::WritesArguments : ModuleEmitter::Effects::ReadsArguments),
        arguments);
}

namespace {
/// The most that a capacity can be: SEL and MUX choose between texts of known ones.
uint64_t greatest(const llvm::Value* capacity) {
    if (const auto* known = llvm::dyn_cast<llvm::ConstantInt>(capacity)) return known->getZExtValue();
    if (const auto* choice = llvm::dyn_cast<llvm::SelectInst>(capacity))
        return std::max(greatest(choice->getTrueValue()), greatest(choice->getFalseValue()));
    // Unknown: it is the capacity of an operand that was counted where it was made.
    return 0;
}
} // namespace

/// Texts are given as pointer and capacity; what a function does with them grows with their capacities.
void FunctionEmitter::chargeTexts(llvm::ArrayRef<Value*> arguments) {
    uint64_t units = 0;
    for (size_t i = 0; i + 1 < arguments.size(); ++i)
        // That is what a text looks like among the arguments.
        if (arguments[i]->getType()->isPointerTy() && arguments[i + 1]->getType() == m.i32)
            units += facts::textUnits(greatest(arguments[i + 1]));
    chargeUnits(units);
}

/// False: not Latin-1, and the last argument says what it is.
bool FunctionEmitter::addStringCode(std::vector<Value*>& arguments) {
    const types::StringCode code = m.types().strings;
    if (code == types::StringCode::Latin1) return true;
    arguments.push_back(int32(static_cast<uint32_t>(code)));
    return false;
}

void FunctionEmitter::assignText(const Text& to, const Text& from) {
    if (to.isWide == from.isWide) {
        // Cuts at the target's capacity and keeps its end mark; source and target may be the same.
        textCall("assign", to.isWide, m.voidType, {to.pointer, to.capacity, from.pointer, from.capacity}, true);
        watchTextWrite(to);
        return;
    }
    std::vector<llvm::Type*> parameters{m.ptr, m.i32, m.ptr, m.i32};
    std::vector<Value*> arguments{to.pointer, to.capacity, from.pointer, from.capacity};
    chargeTexts(arguments);
    const bool isLatin1 = addStringCode(arguments);
    if (!isLatin1) parameters.push_back(m.i32);
    if (to.isWide)
        b.CreateCall(m.helper(isLatin1 ? "plc_text_to_wide" : "plc_text_to_wide_by", m.voidType, parameters,
                              ModuleEmitter::Effects::WritesArguments),
                     arguments);
    else
        b.CreateStore(b.CreateCall(m.helper(isLatin1 ? "plc_wtext_to_narrow" : "plc_wtext_to_narrow_by", m.i8,
                                            parameters, ModuleEmitter::Effects::WritesArguments),
                                   arguments),
                      // Characters that STRING does not have become '?' and ENO of a conversion hears of it.
                      okSlot());
    watchTextWrite(to);
}

Text FunctionEmitter::textTemporary(types::TypeId type) {
    const Address a = temporary(type);
    return textAt(a);
}

Text FunctionEmitter::characterText(Value* code, bool isWide) {
    Address a;
    a.base = m_framePointer;
    // One character of either width and its end mark.
    a.constant = allocateTemporary(4, 4);
    const Text made{pointer(a), int32(1), isWide};
    textCall("from_character", isWide, m.voidType, {made.pointer, made.capacity, b.CreateZExtOrTrunc(code, m.i32)},
             true);
    return made;
}

Text FunctionEmitter::widened(const Text& narrow, uint32_t capacity) {
    Address a;
    a.base = m_framePointer;
    // One more for the end mark.
    a.constant = allocateTemporary((capacity + 1) * 2, 2);
    const Text made{pointer(a), int32(capacity), true};
    assignText(made, narrow);
    return made;
}

/// Text to read: a variable in place, a constant, or a temporary. CHAR and WCHAR count as texts of one character.
Text FunctionEmitter::text(const Expr& expr) {
    const Text made = plainText(expr);
    watchText(expr, made);
    return made;
}

Text FunctionEmitter::plainText(const Expr& expr) {
    if (m.types().family(expr.type) == Family::Character)
        return characterText(scalar(expr), m.types().storageKind(expr.type) == TypeKind::Wchar);
    switch (expr.kind) {
    case ExprKind::Load:
        return textAt(readAddress(*expr.place));
    case ExprKind::Constant: {
        const bool isWide = m.types().kind(expr.type) == TypeKind::Wstring;
        std::string bytes;
        uint32_t length = 0;
        if (const auto* narrow = std::get_if<std::string>(&expr.value.data)) {
            length = static_cast<uint32_t>(narrow->size());
            for (const char c : *narrow) {
                bytes += c;
                if (isWide) bytes += '\0';
            }
        } else if (const auto* wide = std::get_if<std::u16string>(&expr.value.data)) {
            length = static_cast<uint32_t>(wide->size());
            for (const char16_t c : *wide) {
                bytes += static_cast<char>(c & 0xFF);
                if (isWide) bytes += static_cast<char>(c >> 8);
            }
        }
        // The end mark of either width.
        bytes.append(2, '\0');
        return {m.constantBytes(bytes, isWide ? 2 : 1), int32(length), isWide};
    }
    case ExprKind::Sequence:
        sequence(expr);
        return text(*expr.a);
    default: {
        const Text made = textTemporary(expr.type);
        textInto(expr, made);
        return made;
    }
    }
}

void FunctionEmitter::textInto(const Expr& expr, const Text& target) {
    plainTextInto(expr, target);
    watchText(expr, target);
    watchTextWrite(target);
}

// Into a place of its own type: what is too long is cut there, once, at the end.
void FunctionEmitter::plainTextInto(const Expr& expr, const Text& target) {
    switch (expr.kind) {
    // The callee's result is in its frame and is copied before the next call uses that room.
    case ExprKind::Call: {
        const Returned returned = call(*expr.call);
        Address from;
        from.base = b.CreateInBoundsGEP(m.i8, m_image, returned.frame);
        from.type = expr.type;
        assignText(target, textAt(from));
        return;
    }
    case ExprKind::Convert: {
        const Expr& from = *expr.a;
        const Family family = m.types().family(from.type);
        if (m.types().isText(from.type) || family == Family::Character) {
            const bool narrows =
                m.types().isText(from.type) && m.types().kind(from.type) == TypeKind::Wstring && !target.isWide;
            assignText(target, text(from));
            storeOk(expr, narrows ? b.CreateICmpNE(b.CreateLoad(m.i8, okSlot()), b.getInt8(0)) : b.getTrue());
            return;
        }
        // The kind tells the library how the type is written: T#5s, TRUE, 3.
        Value* kind = int32(static_cast<uint32_t>(m.types().storageKind(from.type)));
        Value* value = scalar(from);
        if (family == Family::Real)
            textCall("from_real", target.isWide, m.voidType,
                     {target.pointer, target.capacity, kind, b.CreateFPExt(value, m.f64)}, true);
        else
            textCall("from_integer", target.isWide, m.voidType,
                     {target.pointer, target.capacity, kind, castInteger(value, from.type, m.i64)}, true);
        storeOk(expr, b.getTrue());
        return;
    }
    // Written into the target by either branch: a pointer to one of two temporaries would outlive it.
    case ExprKind::Conditional: {
        Value* condition = scalar(*expr.a);
        Block* yes = newBlock("yes");
        Block* no = newBlock("no");
        Block* done = newBlock("done");
        b.CreateCondBr(condition, yes, no);
        enter(yes);
        textInto(*expr.b, target);
        b.CreateBr(done);
        enter(no);
        textInto(*expr.c, target);
        b.CreateBr(done);
        enter(done);
        return;
    }
    case ExprKind::Intrinsic:
        textIntrinsicInto(expr, target);
        return;
    case ExprKind::Sequence:
        sequence(expr);
        textInto(*expr.a, target);
        return;
    default:
        assignText(target, text(expr));
        return;
    }
}

/// The text operands of an intrinsic, all of one width; what a later operand could change is copied first.
// One STRING beside a WSTRING makes all of them wide: no character is lost in the direction of WSTRING.
std::vector<Text> FunctionEmitter::textOperands(const Expr& expr) {
    // Left to right, as every operand.
    std::vector<Text> texts;
    bool isWide = false;
    const auto isTextual = [&](const Expr* e) {
        return m.types().isText(e->type) || m.types().family(e->type) == Family::Character;
    };
    for (size_t i = 0; i < expr.operands.size(); ++i) {
        const Expr* operand = expr.operands[i];
        if (!isTextual(operand)) continue;
        if (i > 0 && m.types().family(operand->type) == Family::Character && expr.intrinsic == Intrinsic::CharAt)
            continue;
        Text t = text(*operand);
        bool isExposed = false;
        for (size_t k = i + 1; k < expr.operands.size(); ++k) isExposed = isExposed || hasEffects(expr.operands[k]);
        // CONCAT(s, F()) where F writes s.
        if (isExposed && operand->kind == ExprKind::Load && m.types().isText(operand->type)) {
            const Text kept = textTemporary(operand->type);
            assignText(kept, t);
            t = kept;
        }
        isWide = isWide || t.isWide;
        texts.push_back(t);
    }
    if (isWide) {
        size_t n = 0;
        for (const Expr* operand : expr.operands) {
            if (!isTextual(operand) || n >= texts.size()) continue;
            if (!texts[n].isWide) {
                const auto* known = llvm::dyn_cast<llvm::ConstantInt>(texts[n].capacity);
                // 255: an upper bound where the capacity is not known here.
                texts[n] = widened(texts[n], known ? static_cast<uint32_t>(known->getZExtValue()) : 255);
            }
            ++n;
        }
    }
    return texts;
}

llvm::Value* FunctionEmitter::textCompare(library::BinaryOp op, const Text& left, const Text& right) {
    using library::BinaryOp;
    Text a = left, c = right;
    const auto widen = [&](Text& t) {
        const auto* known = llvm::dyn_cast<llvm::ConstantInt>(t.capacity);
        t = widened(t, known ? static_cast<uint32_t>(known->getZExtValue()) : 255);
    };
    if (a.isWide && !c.isWide) widen(c);
    if (c.isWide && !a.isWide) widen(a);
    // Character codes decide, and a text that ends earlier is less.
    Value* order = textCall("compare", a.isWide, m.i32, {a.pointer, a.capacity, c.pointer, c.capacity}, false);
    Value* zero = int32(0);
    switch (op) {
    case BinaryOp::Equal:
        return b.CreateICmpEQ(order, zero);
    case BinaryOp::NotEqual:
        return b.CreateICmpNE(order, zero);
    case BinaryOp::Less:
        return b.CreateICmpSLT(order, zero);
    case BinaryOp::LessEqual:
        return b.CreateICmpSLE(order, zero);
    case BinaryOp::Greater:
        return b.CreateICmpSGT(order, zero);
    default:
        return b.CreateICmpSGE(order, zero);
    }
}

llvm::Value* FunctionEmitter::textIntrinsicScalar(const Expr& expr) {
    const std::vector<Text> texts = textOperands(expr);
    const Text& t = texts.front();
    llvm::Type* wanted = m.scalarType(expr.type);
    switch (expr.intrinsic) {
    case Intrinsic::Len:
        return b.CreateZExtOrTrunc(textCall("length", t.isWide, m.i32, {t.pointer, t.capacity}, false), wanted);
    case Intrinsic::Find:
        return b.CreateZExtOrTrunc(
            textCall("find", t.isWide, m.i32, {t.pointer, t.capacity, texts[1].pointer, texts[1].capacity}, false),
            wanted);
    case Intrinsic::IsNumber: {
        Value* is = textCall("is_number", t.isWide, m.i8, {t.pointer, t.capacity}, false);
        return b.CreateICmpNE(is, b.getInt8(0));
    }
    case Intrinsic::AsciiOf: {
        Value* first = b.CreateAlignedLoad(t.isWide ? m.i16 : m.i8, t.pointer, llvm::Align(1));
        // ASC('') is 0.
        Value* isEmpty = b.CreateICmpEQ(t.capacity, int32(0));
        return b.CreateZExtOrTrunc(b.CreateSelect(isEmpty, llvm::Constant::getNullValue(first->getType()), first),
                                   wanted);
    }
    default: { // CharAt
        Value* index = countOf(*expr.operands[1]);
        Value* length = b.CreateZExt(textCall("length", t.isWide, m.i32, {t.pointer, t.capacity}, false), m.i64);
        // At the length itself is the end mark, which reads as 0.
        guard(b.CreateICmpUGT(index, length), FaultCode::StringIndex, index, int64(0), length);
        Value* at = b.CreateInBoundsGEP(t.isWide ? m.i16 : m.i8, t.pointer, index);
        return b.CreateZExtOrTrunc(b.CreateAlignedLoad(t.isWide ? m.i16 : m.i8, at, llvm::Align(1)), wanted);
    }
    }
}

/// SEL, MUX, MIN, MAX, LIMIT on texts.
llvm::Value* FunctionEmitter::chooseText(const Expr& expr, const Text& target) {
    switch (expr.intrinsic) {
    case Intrinsic::Sel: {
        Value* g = scalar(*expr.operands[0]);
        const Text no = text(*expr.operands[1]);
        const Text yes = text(*expr.operands[2]);
        Text chosen{b.CreateSelect(g, yes.pointer, no.pointer), b.CreateSelect(g, yes.capacity, no.capacity),
                    yes.isWide};
        // Different widths cannot be chosen by pointer: one is written, then perhaps the other over it.
        if (yes.isWide != no.isWide) {
            assignText(target, no);
            Block* take = newBlock("yes");
            Block* done = newBlock("done");
            b.CreateCondBr(g, take, done);
            enter(take);
            assignText(target, yes);
            b.CreateBr(done);
            enter(done);
            return nullptr;
        }
        assignText(target, chosen);
        return nullptr;
    }
    case Intrinsic::Mux: {
        Value* k = countOf(*expr.operands[0]);
        Text chosen;
        std::vector<Text> texts;
        for (size_t i = 1; i < expr.operands.size(); ++i) texts.push_back(text(*expr.operands[i]));
        chosen = texts.back();
        for (size_t i = texts.size() - 1; i-- > 0;) {
            Value* is = b.CreateICmpSLE(k, int64(static_cast<int64_t>(i)));
            chosen = {b.CreateSelect(is, texts[i].pointer, chosen.pointer),
                      b.CreateSelect(is, texts[i].capacity, chosen.capacity), chosen.isWide};
        }
        assignText(target, chosen);
        return nullptr;
    }
    default:
        break;
    }
    const std::vector<Text> texts = textOperands(expr);
    const auto pick = [&](const Text& candidate, const Text& best, bool isMaximum) {
        Value* wins = textCompare(isMaximum ? library::BinaryOp::Greater : library::BinaryOp::Less, candidate, best);
        return Text{b.CreateSelect(wins, candidate.pointer, best.pointer),
                    b.CreateSelect(wins, candidate.capacity, best.capacity), best.isWide};
    };
    // The same order of comparisons as for numbers (extreme, Limit): equal texts keep the first.
    Text best = texts[0];
    if (expr.intrinsic == Intrinsic::Limit && texts.size() >= 3) {
        best = pick(texts[2], pick(texts[0], texts[1], true), false);
    } else {
        for (size_t i = 1; i < texts.size(); ++i) best = pick(texts[i], best, expr.intrinsic == Intrinsic::Max);
    }
    assignText(target, best);
    return nullptr;
}

/// `target` may be an operand: the library's functions allow it, CONCAT is built beside it where it must.
void FunctionEmitter::textIntrinsicInto(const Expr& expr, const Text& target) {
    Value* ok = nullptr;
    const auto made = [&](const char* name, bool isWide, std::vector<Value*> arguments, bool hasOk) {
        Text to = target;
        // Made in the operands' width, then converted into the target.
        if (target.isWide != isWide) to = textTemporary(expr.type);
        arguments.insert(arguments.begin(), {to.pointer, to.capacity});
        Value* status = textCall(name, isWide, hasOk ? m.i8 : m.voidType, arguments, true);
        if (hasOk) ok = b.CreateICmpNE(status, b.getInt8(0));
        if (target.isWide != isWide) assignText(target, to);
    };
    switch (expr.intrinsic) {
    case Intrinsic::Left:
    case Intrinsic::Right: {
        const Text t = textOperands(expr)[0];
        made(expr.intrinsic == Intrinsic::Left ? "left" : "right", t.isWide,
             {t.pointer, t.capacity, countOf(*expr.operands[1])}, true);
        break;
    }
    case Intrinsic::Mid:
    case Intrinsic::Delete: {
        const Text t = textOperands(expr)[0];
        Value* length = countOf(*expr.operands[1]);
        made(expr.intrinsic == Intrinsic::Mid ? "mid" : "delete", t.isWide,
             {t.pointer, t.capacity, length, countOf(*expr.operands[2])}, true);
        break;
    }
    case Intrinsic::Insert: {
        const std::vector<Text> t = textOperands(expr);
        made("insert", t[0].isWide,
             {t[0].pointer, t[0].capacity, t[1].pointer, t[1].capacity, countOf(*expr.operands[2])}, true);
        break;
    }
    case Intrinsic::Replace: {
        const std::vector<Text> t = textOperands(expr);
        Value* length = countOf(*expr.operands[2]);
        made("replace", t[0].isWide,
             {t[0].pointer, t[0].capacity, t[1].pointer, t[1].capacity, length, countOf(*expr.operands[3])}, true);
        break;
    }
    case Intrinsic::Concat: {
        const std::vector<Text> texts = textOperands(expr);
        const bool isWide = texts.front().isWide;
        const Text to = target.isWide == isWide ? target : textTemporary(expr.type);
        for (size_t i = 0; i < texts.size(); ++i)
            // Piece by piece in the target; mayOverlap has said whether that is safe.
            textCall(i == 0 ? "assign" : "append", isWide, m.voidType,
                     {to.pointer, to.capacity, texts[i].pointer, texts[i].capacity}, true);
        if (target.isWide != isWide) assignText(target, to);
        break;
    }
    case Intrinsic::ToUpper:
    case Intrinsic::ToLower:
    case Intrinsic::Trim: {
        const Text t = textOperands(expr)[0];
        std::vector<Value*> arguments{t.pointer, t.capacity};
        const bool isPlain = t.isWide || expr.intrinsic == Intrinsic::Trim || addStringCode(arguments);
        made(expr.intrinsic == Intrinsic::ToUpper   ? (isPlain ? "upper" : "upper_by")
             : expr.intrinsic == Intrinsic::ToLower ? (isPlain ? "lower" : "lower_by")
                                                    : "trim",
             t.isWide, arguments, false);
        break;
    }
    case Intrinsic::CharOf: {
        Value* code = b.CreateTrunc(countOf(*expr.operands[0]), m.i32);
        textCall("from_character", target.isWide, m.voidType, {target.pointer, target.capacity, code}, true);
        break;
    }
    case Intrinsic::Sel:
    case Intrinsic::Mux:
    case Intrinsic::Max:
    case Intrinsic::Min:
    case Intrinsic::Limit:
        chooseText(expr, target);
        break;
    default: // MOVE
        if (!expr.operands.empty()) assignText(target, text(*expr.operands[0]));
        break;
    }
    storeOk(expr, ok ? ok : b.getTrue());
}

/// Whether building `expr` piece by piece in `target` could overwrite an operand that is still to be read. Only CONCAT
/// is built so: the library's functions take care of themselves.
bool FunctionEmitter::mayOverlap(const Expr& expr, const tree::Place& target) const {
    if (expr.kind == ExprKind::Conditional || expr.kind == ExprKind::Sequence) return true;
    if (expr.kind != ExprKind::Intrinsic || expr.intrinsic != Intrinsic::Concat) return false;
    const auto isSame = [&](const tree::Place& p) {
        return p.kind == target.kind && p.offset == target.offset && p.local == target.local && !p.base && !target.base;
    };
    const auto isApart = [&](const tree::Place& p) {
        if (p.kind == PlaceKind::Local && !m_tree.locals[p.local].isInOut)
            return target.kind != PlaceKind::Local || target.local != p.local;
        const bool isFixed = p.kind == PlaceKind::Absolute || p.kind == PlaceKind::Instance;
        return isFixed && p.kind == target.kind && p.offset != target.offset;
    };
    class Reads : public Walker {
    public:
        std::vector<const tree::Place*> places;

    protected:
        void onPlace(const tree::Place& place, Use) override { places.push_back(&place); }
    } reads;
    for (size_t i = 0; i < expr.operands.size(); ++i) {
        // A call may read the target while it is half built.
        if (hasEffects(expr.operands[i])) return true;
        if (i == 0 && expr.operands[0]->kind == ExprKind::Load && isSame(*expr.operands[0]->place))
            continue; // s := CONCAT(s, x)
        reads.walk(expr.operands[i]);
    }
    for (const tree::Place* place : reads.places)
        if (!isApart(*place)) return true;
    return false;
}

} // namespace plc::codegen
