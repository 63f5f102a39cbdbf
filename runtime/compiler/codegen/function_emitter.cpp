// One function of the program as one LLVM function. Quick code (each statement stops on demand, everything in memory)
// and optimised code come from the same emitter; where they differ, isQuick() is asked.
#include "runtime/compiler/codegen/emitter.h"

#include <algorithm>

namespace plc::codegen {

using image::RuntimeContext;
using tree::Local;
using tree::LocalKind;
using types::TypeKind;

namespace {
/// The slots of VAR_IN_OUT that a body follows, and those that it binds itself.
// Walks the body once before it is emitted: what is followed at the entry has to be known there.
class SlotFinder : public Walker {
public:
    std::vector<const tree::Place*> slots, bound;

protected:
    void onStmt(const tree::Stmt& stmt) override {
        if (stmt.kind == tree::StmtKind::Bind) bound.push_back(stmt.place);
    }
    void onPlace(const tree::Place& place, Use) override {
        for (const tree::Place* p = &place; p; p = p->base)
            if (p->kind == tree::PlaceKind::InOutSlot) slots.push_back(p);
    }
};

/// Offset from THIS when `place` lies at a fixed one.
bool fixedFromThis(const tree::Place* place, uint32_t& offset) {
    for (; place; place = place->base) {
        if (place->kind != tree::PlaceKind::Instance && place->kind != tree::PlaceKind::Field) return false;
        offset += place->offset;
        if (place->kind == tree::PlaceKind::Instance) return true;
    }
    return true;
}
} // namespace

FunctionEmitter::FunctionEmitter(ModuleEmitter& module, uint32_t index)
    : m(module), b(module.context), m_index(index), m_tree(module.program.functions[index]),
      m_facts(module.facts[index]), m_abi(module.abi(index)), m_function(module.function(index)) {
    m_context = m_function->getArg(0);
    m_image = m_function->getArg(1);
    m_thisPointer = m_function->getArg(2);
    m_frame64 = m_function->getArg(3);
}

void FunctionEmitter::emit() {
    // The blocks of a function: "entry" with all slots, "start" with the prologue, the body, and "return", which every
    // way out goes through.
    emitPrologue();
    body(m_tree.body);
    jump(m_return);
    emitEpilogue();
    guardStack();
}

/// What a function takes of the machine's own stack is known only when there is machine code. Where it may be much, the
/// function asks for room at its entry; the others are bounded by the depth of calls (jit/stack_use.h).
void FunctionEmitter::guardStack() {
    // LLVM keeps about one value for each of these alive at worst; below, the fixed room for a depth of calls is
    // enough.
    constexpr unsigned kManyInstructions = 256, kManyParameters = 32;
    if (!m.options.guardsEveryStack && m_function->getInstructionCount() <= kManyInstructions &&
        m_function->arg_size() <= kManyParameters)
        return;
    m_function->addFnAttr(kGuardsStack);
    // Between "entry" and "start", since only now is known how long the body is.
    Block* start = llvm::cast<llvm::BranchInst>(m_entryEnd)->getSuccessor(0);
    Block* check = newBlock("stack");
    llvm::cast<llvm::BranchInst>(m_entryEnd)->setSuccessor(0, check);
    enter(check);
    m_site = m_firstSite;
    Value* here = b.CreatePtrToInt(b.CreateStackSave(), m.i64);
    guard(b.CreateICmpULT(here, loadContext(m.i64, offsetof(RuntimeContext, stackLimit))),
          image::FaultCode::StackOverflow);
    b.CreateBr(start);
}

FunctionEmitter::Block* FunctionEmitter::newBlock(const char* name) {
    return Block::Create(m.context, m.isQuick() ? "" : name, m_function);
}

void FunctionEmitter::jump(Block* target) {
    // A body that ended in RETURN has closed its block.
    if (!b.GetInsertBlock()->getTerminator()) b.CreateBr(target);
}

/// At the entry: one slot however often the place is passed, and one that the optimiser takes into a register.
llvm::AllocaInst* FunctionEmitter::newSlot(llvm::Type* type, const char* name) {
    // An alloca anywhere else would take stack in each pass of a loop, and mem2reg leaves it alone.
    llvm::IRBuilder<> entry(m_entryEnd);
    llvm::AllocaInst* slot = entry.CreateAlloca(type, nullptr, name);
    entry.CreateStore(llvm::Constant::getNullValue(type), slot);
    return slot;
}

llvm::Value* FunctionEmitter::contextField(size_t at) { return b.CreateConstInBoundsGEP1_64(m.i8, m_context, at); }

llvm::LoadInst* FunctionEmitter::loadContext(llvm::Type* type, size_t at) {
    // With a TBAA tag of its own: writing the image never changes the context, so it can stay in registers.
    llvm::LoadInst* value = b.CreateLoad(type, contextField(at));
    if (!m.isQuick()) value->setMetadata(llvm::LLVMContext::MD_tbaa, m.contextTag());
    return value;
}

void FunctionEmitter::storeContext(Value* value, size_t at) {
    llvm::StoreInst* stored = b.CreateStore(value, contextField(at));
    if (!m.isQuick()) stored->setMetadata(llvm::LLVMContext::MD_tbaa, m.contextTag());
}

// Sites that do not stop (inside of a statement) still name the place of a fault.
void FunctionEmitter::setSite(const tree::Stmt& stmt) {
    const auto [site, stops] = m.facts.sites().at(stmt);
    if (site == 0) return;
    m_site = site;
    // Optimised code has no stops; its site is only there for faults.
    if (!m.isQuick() || !stops) return;
    b.CreateCall(m.siteCheck(), {m_context, int32(site)});
}

FunctionEmitter::Block* FunctionEmitter::emitEntry() {
    Block* entry = newBlock("entry");
    Block* start = newBlock("start");
    m_return = newBlock("return");
    enter(entry);
    m_entryEnd = b.CreateBr(start);
    b.SetInsertPoint(m_entryEnd);
    // THIS travels as a pointer, which the optimiser follows through inlining; its offset is for what asks for an
    // address
    // Subtracting pointers into the same object is what LLVM can undo after inlining.
    if (m_tree.instanceType.isValid())
        m_this64 = b.CreateSub(b.CreatePtrToInt(m_thisPointer, m.i64), b.CreatePtrToInt(m_image, m.i64));
    else
        m_this64 = int64(0);
    m_framePointer = b.CreateInBoundsGEP(m.i8, m_image, m_frame64);
    // how large the frame is turns out when the body is written: the constant is exchanged at the end
    auto* next = llvm::BinaryOperator::CreateAdd(m_frame64, int64(0), "next", m_entryEnd->getIterator());
    m_nextFrame = next;
    m.patchFrameSize(next, 1, m_index);
    m_labels.assign(m_tree.labelCount + 1, nullptr);
    m_labelPlaced.assign(m_tree.labelCount + 1, false);
    // A local is in a slot (a register later) or in the frame (kNoFrame says which): in the frame when its address is
    // taken, when it is no scalar, and always in quick code, where a debugger looks at it.
    m_locals.assign(m_tree.locals.size(), nullptr);
    m_localBounds.resize(m_tree.locals.size());
    for (size_t i = 0; i < m_tree.locals.size(); ++i) {
        const Local& local = m_tree.locals[i];
        if (local.isInOut) {
            m_locals[i] = newSlot(m.i64, "inout");
            if (m.types().kind(local.type) == TypeKind::OpenArray)
                for (size_t d = 0; d < m.types()[local.type].dimensions.size(); ++d)
                    m_localBounds[i].push_back({newSlot(m.i64, "low"), newSlot(m.i64, "high")});
        } else if (m_facts.frame.offsets[i] == kNoFrame) {
            m_locals[i] = newSlot(m.memoryType(local.type), "local");
        }
    }
    // Not with __TRY: a fault comes back past the store that would write the register back.
    if (!m.isQuick() && m_facts.hasLoop && !m_facts.hasTry) m_budget = newSlot(m.i64, "budget");
    return start;
}

// The order is the promise: room for the frame is asked for before anything is written into it, the budget is paid
// before work begins, and parameters are stored before initial values, which may use them.
void FunctionEmitter::emitPrologue() {
    // Temporaries begin behind the locals.
    m_temporaryTop = m_frameSize = m_facts.frame.size;
    enter(emitEntry());
    reloadBudget();
    for (const tree::Stmt* stmt : m_tree.body)
        if (const uint32_t site = m.facts.sites().siteOf(*stmt)) {
            m_site = m_firstSite = site; // faults before the first statement are shown there
            break;
        }
    // elsewhere the checker has added up the frames on every path of calls
    // Quick code may be called in any order by the debugger, and recursion has no sum.
    if (m.isQuick() || m_facts.isUnbounded) {
        auto* tooFar = new llvm::ICmpInst(b.GetInsertBlock(), llvm::CmpInst::ICMP_UGT, m_frame64, int64(0));
        m.patchNeed(tooFar, 1, m_index);
        guard(tooFar, image::FaultCode::StackOverflow);
    }
    // The machine's stack as well: 3 MiB of it are for generated code (kHostStack).
    if (m_facts.inCycle) {
        Value* here = b.CreatePtrToInt(b.CreateIntrinsic(llvm::Intrinsic::frameaddress, {m.ptr}, {int32(0)}), m.i64);
        guard(b.CreateICmpULT(here, loadContext(m.i64, offsetof(RuntimeContext, stackLimit))),
              image::FaultCode::StackOverflow);
    }
    chargeUnits(m.facts.work().atEntry(m_index));

    // THIS and frame in one word, handed on with each report.
    if (m.options.watched) m_where = b.CreateOr(m_this64, b.CreateShl(m_frame64, int64(32)));
    watch(image::WatchKind::Begin, &m_tree, int64(m_index));
    // Behind context, image, THIS and frame. The order is that of callArguments and abi.
    unsigned argument = 4;
    for (uint32_t i = 0; i < m_tree.locals.size(); ++i) {
        const Local& local = m_tree.locals[i];
        if (local.kind == LocalKind::Input && !local.isInOut) {
            Value* given = m_function->getArg(argument++);
            if (m.isScalar(local.type)) {
                store(localAddress(i), given);
            } else {
                const Address target = localAddress(i);
                b.CreateMemCpy(pointer(target), llvm::MaybeAlign(1), given, llvm::MaybeAlign(1),
                               m.types()[local.type].size);
                watchPlace(image::WatchKind::Write, nullptr, target);
            }
        } else if (local.isInOut) {
            const bool isParameter = local.kind == LocalKind::InOut;
            if (!isParameter) continue;
            Value* given = m_function->getArg(argument++);
            b.CreateStore(given, m_locals[i]);
            Address slot;
            slot.base = m_framePointer;
            const bool isInFrame = m_facts.frame.offsets[i] != kNoFrame;
            slot.constant = isInFrame ? m_facts.frame.offsets[i] : 0;
            // quick code leaves it in the frame too, where a halted program is looked at
            if (isInFrame) b.CreateAlignedStore(given, pointer(slot), llvm::Align(1));
            for (auto& [low, high] : m_localBounds[i])
                for (llvm::AllocaInst* bound : {low, high}) {
                    Value* value = m_function->getArg(argument++);
                    b.CreateStore(value, bound);
                    slot.constant += 8;
                    if (isInFrame) b.CreateAlignedStore(value, pointer(slot), llvm::Align(1));
                }
        }
    }
    // Optimised code follows a slot once, here, instead of at every use. One that must not be followed becomes 0: the
    // fault belongs to the statement that uses it, if it is ever reached.
    if (!m.isQuick() && m_facts.hasSlots) {
        SlotFinder finder;
        finder.walkFunction(m_tree);
        // A call of another block binds its in-outs in this very body: such a slot is followed at its use.
        std::set<uint32_t> bound; // a slot that is bound in this body is followed as it then is
        for (const tree::Place* place : finder.bound) {
            uint32_t at = place->offset;
            if (place->kind == tree::PlaceKind::InOutSlot && fixedFromThis(place->base, at)) bound.insert(at);
        }
        for (const tree::Place* place : finder.slots) {
            uint32_t at = 0;
            if (!fixedFromThis(place->base, at)) continue;
            at += place->offset;
            if (m_slots.count(at) || bound.count(at)) continue;
            Slot& slot = m_slots[at];
            const Address where = slotAddress(*place);
            slot.offset = newSlot(m.i64, "slot");
            Value* raw = b.CreateAlignedLoad(m.i64, pointer(where), llvm::Align(1));
            Value* size = int64(m.types()[place->type].size);
            Value* ok = b.getTrue();
            if (m.types().kind(place->type) == TypeKind::OpenArray) {
                Address boundAt = where;
                size = int64(m.types()[m.types()[place->type].element].size);
                for (size_t d = 0; d < m.types()[place->type].dimensions.size(); ++d) {
                    boundAt.constant += 8;
                    Value* low = b.CreateAlignedLoad(m.i64, pointer(boundAt), llvm::Align(1));
                    boundAt.constant += 8;
                    Value* high = b.CreateAlignedLoad(m.i64, pointer(boundAt), llvm::Align(1));
                    Value* count = b.CreateAdd(b.CreateSub(high, low), int64(1));
                    // bounds are read from memory that a wild pointer may have written: no product may wrap
                    ok = b.CreateAnd(ok, b.CreateICmpULE(count, int64(1 << 30)));
                    size = b.CreateMul(size, b.CreateAnd(count, int64((int64_t(1) << 31) - 1)));
                    ok = b.CreateAnd(ok, b.CreateICmpULE(size, int64(1 << 30)));
                    slot.bounds.push_back({newSlot(m.i64, "low"), newSlot(m.i64, "high")});
                    b.CreateStore(low, slot.bounds.back().first);
                    b.CreateStore(high, slot.bounds.back().second);
                }
            }
            ok = b.CreateAnd(ok, isLive(raw, size));
            // followSlot knows 0 and finds out then what is wrong.
            b.CreateStore(b.CreateSelect(ok, raw, int64(0)), slot.offset);
        }
    }
    for (uint32_t i = 0; i < m_tree.locals.size(); ++i)
        // In each call: functions keep nothing.
        if (!m_tree.locals[i].isInOut && m_tree.locals[i].kind != LocalKind::Input) initialiseLocal(i);
}

// Locals begin in each call with what their type or declaration says; what a frame held before must not be seen.
void FunctionEmitter::initialiseLocal(uint32_t index) {
    const Local& local = m_tree.locals[index];
    const types::Type& type = m.types()[local.type];
    const Address target = localAddress(index);
    if (m.isScalar(local.type)) {
        if (local.initial) {
            store(target, scalar(*local.initial));
            return;
        }
        llvm::Type* memory = m.memoryType(local.type);
        llvm::Constant* value = llvm::Constant::getNullValue(memory);
        if (!type.initial.empty()) {
            uint64_t bits = 0;
            // Enumerations and subranges have initial bytes of their own; little endian, as the image is.
            std::memcpy(&bits, type.initial.data(), std::min<size_t>(8, type.initial.size()));
            value = memory->isIntegerTy() ? llvm::ConstantInt::get(memory, bits)
                    : memory->isFloatTy()
                        ? llvm::ConstantFP::get(m.context, llvm::APFloat(llvm::APFloat::IEEEsingle(),
                                                                         llvm::APInt(32, bits & 0xffffffffu)))
                        : llvm::ConstantFP::get(m.context,
                                                llvm::APFloat(llvm::APFloat::IEEEdouble(), llvm::APInt(64, bits)));
        }
        b.CreateAlignedStore(value, pointer(target), alignOf(target).valueOrOne());
        watchPlace(image::WatchKind::Write, nullptr, target);
        return;
    }
    if (type.initial.empty()) {
        // All of the capacity: a frame is reused memory and must not show what lay there before.
        b.CreateMemSet(pointer(target), b.getInt8(0), std::max(1u, type.size), llvm::MaybeAlign(1));
    } else {
        const std::string bytes(reinterpret_cast<const char*>(type.initial.data()), type.initial.size());
        b.CreateMemCpy(pointer(target), llvm::MaybeAlign(1), m.constantBytes(bytes, 1), llvm::MaybeAlign(1), type.size);
    }
    if (!local.initial) return;
    // Temporaries of the initial value are free behind it.
    const uint64_t top = m_temporaryTop;
    if (m.types().isText(local.type))
        textInto(*local.initial, textAt(target));
    else
        aggregateInto(*local.initial, target);
    m_temporaryTop = top;
}

void FunctionEmitter::emitEpilogue() {
    enter(m_return);
    flushBudget();
    watch(image::WatchKind::End, &m_tree);
    if (m_abi.returned == 0) {
        b.CreateRetVoid();
    } else {
        std::vector<Value*> values;
        // Read here and not where it was written: every way out comes by.
        if (m_abi.returnsScalar) values.push_back(load(localAddress(m_tree.resultLocal)));
        for (const uint32_t output : m_abi.scalarOutputs) values.push_back(load(localAddress(output)));
        if (values.size() == 1) {
            b.CreateRet(values[0]);
        } else {
            Value* all = llvm::PoisonValue::get(m_abi.type->getReturnType());
            for (unsigned i = 0; i < values.size(); ++i) all = b.CreateInsertValue(all, values[i], i);
            b.CreateRet(all);
        }
    }
    closeBlocks();
    // Frames begin at multiples of 16, so that locals of every type are aligned.
    m.frameSizes[m_index] = (m_frameSize + 15) / 16 * 16;
}

/// Blocks left open (dead code behind EXIT, RETURN, JMP) end nowhere.
void FunctionEmitter::closeBlocks() {
    for (Block& block : *m_function)
        if (!block.getTerminator()) new llvm::UnreachableInst(m.context, &block);
}

/// Beyond the greatest frame the offset means nothing: then the function is refused.
uint32_t FunctionEmitter::allocateTemporary(uint64_t size, uint32_t align) {
    // A stack: whoever takes the top back frees all behind it. The frame is as large as the highest top ever was.
    m_temporaryTop = (m_temporaryTop + align - 1) / align * align;
    const uint64_t at = m_temporaryTop;
    m_temporaryTop += std::max<uint64_t>(1, size);
    m_frameSize = std::max(m_frameSize, m_temporaryTop);
    return static_cast<uint32_t>(std::min(at, facts::kMaximumFrame));
}

Address FunctionEmitter::temporary(types::TypeId type) {
    const types::Type& t = m.types()[type];
    Address address;
    address.base = m_framePointer;
    address.baseOffset = m_frame64;
    address.constant = allocateTemporary(t.size, 16);
    address.type = type;
    address.align = 1;
    return address;
}

} // namespace plc::codegen
