// __TRY: a protected part is a function of its own that runs on the frame of the one it belongs to, called through the
// controller, which comes back from it when a fault leaves it. All locals of such a function lie in the frame.
#include "runtime/compiler/codegen/emitter.h"

#include <algorithm>

namespace plc::codegen {

using image::Leaving;
using image::RuntimeContext;

FunctionEmitter::FunctionEmitter(const FunctionEmitter& outer, llvm::Function* part)
    : m(outer.m), b(outer.m.context), m_index(outer.m_index), m_tree(outer.m_tree), m_facts(outer.m_facts),
      m_abi(outer.m_abi), m_function(part) {
    m_context = part->getArg(0);
    m_image = part->getArg(1);
    m_thisPointer = part->getArg(2);
    m_frame64 = part->getArg(3);
    // The part goes on behind the temporaries of what surrounds it, in the same frame.
    m_temporaryTop = outer.m_temporaryTop;
    m_frameSize = outer.m_frameSize;
    m_site = m_firstSite = outer.m_site;
    m_cause = outer.m_cause;
}

/// The slots of VAR_IN_OUT, as the function itself left them in the frame.
void FunctionEmitter::loadInOuts() {
    for (uint32_t i = 0; i < m_tree.locals.size(); ++i) {
        if (!m_tree.locals[i].isInOut) continue;
        Address slot;
        slot.base = m_framePointer;
        slot.constant = m_facts.frame.offsets[i];
        const auto load = [&](llvm::AllocaInst* into) {
            b.CreateStore(b.CreateAlignedLoad(m.i64, pointer(slot), llvm::Align(1)), into);
            slot.constant += 8;
        };
        load(m_locals[i]);
        for (const auto& [low, high] : m_localBounds[i]) {
            load(low);
            load(high);
        }
    }
}

void FunctionEmitter::emitPart(const std::vector<tree::Stmt*>& statements) {
    Block* start = emitEntry();
    // EXIT, CONTINUE and RETURN inside of the part leave it as a number, since no branch goes from one function to
    // another.
    m_leaving = newSlot(m.i32, "leaving");
    enter(start);
    if (m.options.watched) m_where = b.CreateOr(m_this64, b.CreateShl(m_frame64, int64(32)));
    loadInOuts();
    body(statements);
    jump(m_return);
    enter(m_return);
    b.CreateRet(b.CreateLoad(m.i32, m_leaving));
    closeBlocks();
    guardStack();
}

/// How the part was left: a Leaving or an exception code.
llvm::Value* FunctionEmitter::protectedPart(const std::vector<tree::Stmt*>& statements) {
    auto* type = llvm::FunctionType::get(m.i32, {m.ptr, m.ptr, m.ptr, m.i64}, false);
    auto* part = llvm::Function::Create(type, llvm::GlobalValue::InternalLinkage, "plc.try." + std::to_string(m_index),
                                        *m.module);
    m.addAttributes(*part);
    FunctionEmitter emitter(*this, part);
    emitter.emitPart(statements);
    // The frame is that of the function, so it must be as large as its parts need.
    m_frameSize = std::max(m_frameSize, emitter.m_frameSize);
    return b.CreateCall(
        m.helper("plc_protect", m.i32, {m.ptr, m.ptr, m.ptr, m.i64, m.ptr}, ModuleEmitter::Effects::Any),
        {m_context, m_image, m_thisPointer, m_frame64, part});
}

llvm::Value* FunctionEmitter::isFault(Value* left) {
    // Codes of exceptions begin above the ways to leave.
    return b.CreateICmpUGT(left, int32(static_cast<uint32_t>(Leaving::Return)));
}

// Behind the statement the program goes on as if nothing had been, unless it was left or nobody caught the fault.
void FunctionEmitter::protectedStatement(const tree::Stmt& stmt) {
    llvm::AllocaInst* left = newSlot(m.i32, "left");
    b.CreateStore(protectedPart(stmt.body), left);
    // Order: the part, its handler if it faulted, __FINALLY in any case, and only then on to where it was left for.
    if (stmt.place) catchFault(stmt, left);
    if (!stmt.arms.empty()) finish(stmt.arms.front().body, left);
    goOnLeaving(b.CreateLoad(m.i32, left));
}

/// __CATCH: protected itself when __FINALLY must follow it.
void FunctionEmitter::catchFault(const tree::Stmt& stmt, llvm::AllocaInst* left) {
    Block* caught = newBlock("caught");
    Block* done = newBlock("tried");
    Value* code = b.CreateLoad(m.i32, left);
    branchUnlikely(isFault(code), caught, done);
    enter(caught);
    // It is handled: the controller must not see it at the end of the scan.
    storeContext(int32(0), offsetof(RuntimeContext, fault));
    b.CreateStore(int32(0), left);
    auto* stored = llvm::cast<llvm::IntegerType>(m.scalarType(stmt.place->type));
    store(address(*stmt.place), b.CreateZExtOrTrunc(code, stored));
    if (stmt.arms.empty())
        body(stmt.elseBody);
    else
        b.CreateStore(protectedPart(stmt.elseBody), left);
    jump(done);
    enter(done);
}

/// __FINALLY, and behind it the fault that nothing caught, with the details that it had.
void FunctionEmitter::finish(const std::vector<tree::Stmt*>& statements, llvm::AllocaInst* left) {
    // Kept while __FINALLY runs, which may fault and be caught itself.
    Value* code = loadContext(m.i32, offsetof(RuntimeContext, fault));
    Value* site = loadContext(m.i32, offsetof(RuntimeContext, faultSite));
    Value* details[3];
    for (size_t i = 0; i < 3; ++i) details[i] = loadContext(m.i64, offsetof(RuntimeContext, faultDetail) + i * 8);
    storeContext(int32(0), offsetof(RuntimeContext, fault));
    body(statements);
    Block* again = newBlock("again");
    Block* done = newBlock("finished");
    branchUnlikely(isFault(b.CreateLoad(m.i32, left)), again, done);
    enter(again);
    b.CreateCall(m.raise(), {m_context, code, site, details[0], details[1], details[2]});
    b.CreateUnreachable();
    enter(done);
}

/// EXIT, CONTINUE and RETURN: here, or by whoever runs this part.
void FunctionEmitter::leave(Leaving how) {
    if (how != Leaving::Return && !m_loops.empty()) {
        b.CreateBr(how == Leaving::Exit ? m_loops.back().exit : m_loops.back().next);
    } else if (m_leaving || how == Leaving::Return) {
        // Inside of a part: the outer function does the rest.
        if (m_leaving) b.CreateStore(int32(static_cast<uint32_t>(how)), m_leaving);
        b.CreateBr(m_return);
    } else {
        return; // no loop: reported by the checker
    }
    // Statements behind it are emitted although nothing reaches them.
    enter(newBlock("dead"));
}

void FunctionEmitter::goOnLeaving(Value* left) {
    Block* done = newBlock("done");
    llvm::SwitchInst* choice = b.CreateSwitch(left, done);
    for (const Leaving how : {Leaving::Exit, Leaving::Continue, Leaving::Return}) {
        Block* block = newBlock("leave");
        choice->addCase(b.getInt32(static_cast<uint32_t>(how)), block);
        enter(block);
        leave(how);
        jump(done);
    }
    enter(done);
}

} // namespace plc::codegen
