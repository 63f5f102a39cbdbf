// The reports of watched code (D13): the quick code says what it computes, so that the meaning of the language is
// written once.
#include "runtime/compiler/codegen/emitter.h"

namespace plc::codegen {

using image::WatchedContext;
using image::WatchKind;

/// Hands a report to whoever watches; one function, so that each report is one call.
llvm::Function* ModuleEmitter::watchFunction() {
    if (m_watch) return m_watch;
    auto* type = llvm::FunctionType::get(voidType, {ptr, i64, i32, i64, i64, i64}, false);
    m_watch = llvm::Function::Create(type, llvm::GlobalValue::InternalLinkage, "plc.watch", *module);
    m_watch->setDoesNotThrow();
    llvm::IRBuilder<> b(llvm::BasicBlock::Create(context, "", m_watch));
    // The context of watched code begins as an ordinary one and has the watcher behind it.
    llvm::Value* watcher =
        b.CreateLoad(ptr, b.CreateConstInBoundsGEP1_64(i8, m_watch->getArg(0), offsetof(WatchedContext, watch)));
    std::vector<llvm::Value*> arguments;
    for (llvm::Argument& argument : m_watch->args()) arguments.push_back(&argument);
    b.CreateCall(type, watcher, arguments);
    b.CreateRetVoid();
    return m_watch;
}

void FunctionEmitter::watch(WatchKind kind, const void* node, Value* a, Value* more) {
    // Behind RETURN there is nothing to report.
    if (!m.options.watched || b.GetInsertBlock()->getTerminator()) return;
    b.CreateCall(m.watchFunction(),
                 {m_context, int64(static_cast<int64_t>(reinterpret_cast<intptr_t>(node))),
                  int32(static_cast<uint32_t>(kind)), m_where, a ? a : int64(0), more ? more : int64(0)});
}

void FunctionEmitter::watchValue(const tree::Expr& expr, Value* value) {
    if (!m.options.watched || expr.kind == tree::ExprKind::Constant) return;
    llvm::Type* type = value->getType();
    // Values travel as 64 bits; who receives them knows the type from the node.
    if (type->isFloatTy()) value = b.CreateBitCast(value, m.i32);
    if (type->isDoubleTy()) value = b.CreateBitCast(value, m.i64);
    if (!value->getType()->isIntegerTy()) return;
    watch(WatchKind::Value, &expr, b.CreateZExtOrTrunc(value, m.i64));
}

/// A read variable and its value are one report: half of what watched code says are these two.
llvm::Value* FunctionEmitter::watchedLoad(const tree::Expr& expr) {
    const tree::Place& place = *expr.place;
    const Address from =
        place.kind == tree::PlaceKind::TextIndex ? textIndexAddress(place, Purpose::Read) : address(place);
    Value* value = load(from);
    if (from.isImage)
        watchPlace(WatchKind::Load, &expr, from);
    else
        watchValue(expr, value);
    return value;
}

void FunctionEmitter::watchText(const tree::Expr& expr, const Text& text) {
    if (!m.options.watched || expr.kind == tree::ExprKind::Constant) return;
    Value* shape = b.CreateZExt(text.capacity, m.i64);
    // Capacity in the low half, width above it.
    if (text.isWide) shape = b.CreateOr(shape, int64(int64_t(1) << 32));
    watch(WatchKind::Text, &expr, b.CreatePtrToInt(text.pointer, m.i64), shape);
}

void FunctionEmitter::watchPlace(WatchKind kind, const void* node, const Address& address, uint32_t size) {
    if (!m.options.watched || !address.isImage) return;
    if (size == 0) size = m.types()[address.type].size;
    Address whole = address;
    int bit = address.bit;
    if (bit >= 8) { // of a wide integer: the byte that holds it
        whole.constant += bit / 8;
        bit %= 8;
    }
    if (bit >= 0) size = 1;
    // Size below, bit + 1 above it: 0 means the whole bytes.
    watch(kind, node, b.CreatePtrToInt(pointer(whole), m.i64), int64(int64_t(bit + 1) << 32 | int64_t(size)));
}

void FunctionEmitter::watchTextWrite(const Text& text) {
    if (!m.options.watched) return;
    const auto* known = llvm::dyn_cast<llvm::ConstantInt>(text.capacity);
    // A capacity that is only known when it runs is one of SEL or MUX; 80 is then a guess that covers the usual.
    const int64_t size = ((known ? static_cast<int64_t>(known->getZExtValue()) : 80) + 1) * (text.isWide ? 2 : 1);
    watch(WatchKind::Write, m_cause, b.CreatePtrToInt(text.pointer, m.i64), int64(size));
}

} // namespace plc::codegen
