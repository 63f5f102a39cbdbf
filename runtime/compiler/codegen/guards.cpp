// What may go wrong while a program runs, and the way out of its scan. A check is a compare and a branch to a cold
// block that does not come back, so that the code that runs stays in one piece.
#include "runtime/base/assert.h"
#include "runtime/compiler/codegen/emitter.h"
#include "runtime/compiler/facts/ranges.h"

namespace plc::codegen {

using image::FaultCode;
using image::RuntimeContext;

/// Weights are for the optimiser; quick code is laid out as it is written.
llvm::BranchInst* FunctionEmitter::branchUnlikely(Value* condition, Block* rare, Block* usual) {
    llvm::BranchInst* branch = b.CreateCondBr(condition, rare, usual);
    if (!m.isQuick())
        branch->setMetadata(llvm::LLVMContext::MD_prof, llvm::MDBuilder(m.context).createBranchWeights(1, 1 << 20));
    return branch;
}

/// Leaves the scan with `code` when `isBad`. The way out is a cold block with one call, away from the code that runs.
void FunctionEmitter::guard(Value* isBad, FaultCode code, Value* d0, Value* d1, Value* d2) {
    // IRBuilder folds constants, so checks that cannot fail are gone before they are made.
    if (const auto* constant = llvm::dyn_cast<llvm::ConstantInt>(isBad); constant && constant->isZero()) return;
    Block* rare = newBlock("fault");
    Block* usual = newBlock("ok");
    branchUnlikely(isBad, rare, usual);
    enter(rare);
    b.CreateCall(m.raise(), {m_context, int32(static_cast<uint32_t>(code)), int32(m_site), d0 ? d0 : int64(0),
                             d1 ? d1 : int64(0), d2 ? d2 : int64(0)});
    b.CreateUnreachable();
    enter(usual);
}

/// What follows is dead, but still needs a block to be written into.
void FunctionEmitter::raiseAlways(FaultCode code) {
    b.CreateCall(m.raise(),
                 {m_context, int32(static_cast<uint32_t>(code)), int32(m_site), int64(0), int64(0), int64(0)});
    b.CreateUnreachable();
    enter(newBlock("dead"));
}

// Subranges keep their promise at each assignment, so that indices of that type need no check.
void FunctionEmitter::guardRange(Value* value, const tree::Expr& from, types::TypeId target) {
    // x : INT(1..10) := y with y of the same subrange needs no check; facts/ranges.h decides.
    if (!facts::mayLeaveRange(m.types(), from, target)) return;
    const types::Type& range = m.types()[target];
    Value* wide = castInteger(value, target, m.i64);
    const bool isUnsigned = m.types().family(target) != types::Family::Signed;
    Value* low = int64(range.low);
    Value* high = int64(range.high);
    Value* bad = isUnsigned ? b.CreateOr(b.CreateICmpULT(wide, low), b.CreateICmpUGT(wide, high))
                            : b.CreateOr(b.CreateICmpSLT(wide, low), b.CreateICmpSGT(wide, high));
    guard(bad, FaultCode::ValueOutOfRange, wide, low, high);
}

/// `size` bytes at `offset` lie within declared variables or within frames that are alive (this function's and its
/// callers').
llvm::Value* FunctionEmitter::isLive(Value* at, Value* size) {
    const image::Layout& layout = m.program.layout;
    const int64_t dataBegin = sizeof(image::ImageHeader);
    // "at + size <= end" could overflow; "at <= end - size" cannot, as long as the room is not negative.
    Value* dataRoom = b.CreateSub(int64(static_cast<int64_t>(layout.dataEnd) - dataBegin), size);
    Value* inData =
        b.CreateAnd(b.CreateICmpSGE(dataRoom, int64(0)), b.CreateICmpULE(b.CreateSub(at, int64(dataBegin)), dataRoom));
    // Frames above m_nextFrame are of calls that have returned: a pointer to one of them is stale.
    Value* frameLast = b.CreateSub(m_nextFrame, size);
    Value* inFrame = b.CreateAnd(b.CreateICmpSGE(at, int64(layout.frameBegin)), b.CreateICmpSLE(at, frameLast));
    return b.CreateOr(inData, inFrame);
}

/// A pointer is an offset into the image, so that it can be checked: it lies within declared data, or within a frame
/// that is alive. Data is asked first, because nearly every pointer leads there.
// Called for each use of a pointer, also twice in a row for the same one: LLVM removes what is known already.
void FunctionEmitter::guardReference(Value* at, Value* size) {
    const image::Layout& layout = m.program.layout;
    const int64_t dataBegin = sizeof(image::ImageHeader);
    Block* frames = newBlock("not_data");
    Block* bad = newBlock("bad_reference");
    Block* ok = newBlock("ok");
    Value* dataRoom = b.CreateSub(int64(static_cast<int64_t>(layout.dataEnd) - dataBegin), size);
    Value* inData = b.CreateICmpULE(b.CreateSub(at, int64(dataBegin)), dataRoom);
    // larger than all data together: the room is negative, and unsigned it would look endless
    if (const auto* known = llvm::dyn_cast<llvm::ConstantInt>(dataRoom); !known || known->isNegative())
        inData = b.CreateAnd(inData, b.CreateICmpSGE(dataRoom, int64(0)));
    llvm::BranchInst* branch = b.CreateCondBr(inData, ok, frames);
    if (!m.isQuick())
        branch->setMetadata(llvm::LLVMContext::MD_prof, llvm::MDBuilder(m.context).createBranchWeights(1 << 10, 1));
    enter(frames);
    Value* frameLast = b.CreateSub(m_nextFrame, size);
    Value* inFrame = b.CreateAnd(b.CreateICmpSGE(at, int64(layout.frameBegin)), b.CreateICmpSLE(at, frameLast));
    branchUnlikely(b.CreateNot(inFrame), bad, ok);
    enter(bad);
    // Which fault it is, is only asked in the cold block.
    Value* code = b.CreateSelect(b.CreateICmpEQ(at, int64(0)), int32(static_cast<uint32_t>(FaultCode::NullReference)),
                                 int32(static_cast<uint32_t>(FaultCode::ForeignReference)));
    b.CreateCall(m.raise(), {m_context, code, int32(m_site), at, int64(0), int64(0)});
    b.CreateUnreachable();
    enter(ok);
}

/// The word at `at` (already live for the block's size) names `block` or one derived from it, and all of it lies inside
/// the image.
void FunctionEmitter::guardBlock(Value* at, types::TypeId block) {
    const types::Type& type = m.types()[block];
    // a block that nothing extends has no header that could be asked
    if (type.kind == types::TypeKind::Block && type.blockNumber == 0) return;
    // Reading the number is safe: the caller has checked that the block's bytes are within the image.
    bool any = false;
    llvm::GlobalVariable* flags = m.blockFlags(block, any);
    Value* number = b.CreateAlignedLoad(m.i32, b.CreateInBoundsPtrAdd(m_image, at), llvm::Align(1));
    Value* number64 = b.CreateZExt(number, m.i64);
    Block* bad = newBlock("bad_block");
    Block* known = newBlock("known_block");
    Block* ok = newBlock("ok");
    branchUnlikely(b.CreateICmpUGE(number64, int64(m.facts.blockCount())), bad, known);
    enter(known);
    Value* fits = b.CreateLoad(m.i8, b.CreateInBoundsGEP(m.i8, flags, number64));
    branchUnlikely(b.CreateICmpEQ(fits, b.getInt8(0)), bad, ok);
    enter(bad);
    b.CreateCall(m.raise(), {m_context, int32(static_cast<uint32_t>(FaultCode::ForeignReference)), int32(m_site), at,
                             int64(0), int64(0)});
    b.CreateUnreachable();
    enter(ok);
}

/// Loops and calls pay from a budget. The clock is read only when it is used up, so that a pass costs a subtraction.
/// Optimised code holds the budget in a register while it loops; calls and the end of a function write it back.
void FunctionEmitter::charge(Value* amount) {
    PLC_ASSERT(m_facts.charges, return ); // callers would go on with what they think is left
    // Signed and counted down: it is used up when it falls below 0, whatever the last amount was.
    const size_t at = offsetof(RuntimeContext, loopBudget);
    Value* left = m_budget ? static_cast<Value*>(b.CreateLoad(m.i64, m_budget)) : loadContext(m.i64, at);
    left = b.CreateSub(left, amount);
    if (m_budget)
        b.CreateStore(left, m_budget);
    else
        storeContext(left, at);
    Block* usedUp = newBlock("budget");
    Block* ok = newBlock("ok");
    branchUnlikely(b.CreateICmpSLT(left, int64(0)), usedUp, ok);
    enter(usedUp);
    // The watchdog may decide to fault here, and then says where.
    storeContext(int32(m_site), offsetof(RuntimeContext, faultSite));
    if (m_budget) storeContext(left, at);
    b.CreateCall(m.budgetUsedUp(), {m_context});
    if (m_budget) b.CreateStore(loadContext(m.i64, at), m_budget);
    b.CreateBr(ok);
    enter(ok);
}

// 0: the facts say that this path is paid for elsewhere.
void FunctionEmitter::chargeUnits(uint64_t units) {
    if (units > 0) charge(int64(static_cast<int64_t>(units)));
}

// Before a call and at the end: whoever runs next counts on in the context.
void FunctionEmitter::flushBudget() {
    if (m_budget) storeContext(b.CreateLoad(m.i64, m_budget), offsetof(RuntimeContext, loopBudget));
}

// At the start and behind a call, which may have used some of it.
void FunctionEmitter::reloadBudget() {
    if (m_budget) b.CreateStore(loadContext(m.i64, offsetof(RuntimeContext, loopBudget)), m_budget);
}

} // namespace plc::codegen
