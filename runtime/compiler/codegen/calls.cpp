// Calls. What a callee gets, in this order: the context of the scan thread, the image, THIS as a pointer into it, the
// offset of its frame, then inputs and in-outs in the order of its locals. Scalars travel in registers, everything else
// as an address; results and outputs that are no scalars stay in the callee's frame, which is free again afterwards.
#include "runtime/compiler/codegen/emitter.h"

namespace plc::codegen {

using image::CallRecord;
using image::FaultCode;
using image::RuntimeContext;
using tree::ArgumentMode;
using tree::Call;
using tree::Local;
using tree::LocalKind;
using types::TypeKind;

/// Leaves {site, callee, THIS, frame} for the call path; returns the depth to go back to.
llvm::Value* FunctionEmitter::pushCall(Value* function, Value* self, Value* frame) {
    // Records are an array and not a list: a halted program shows them from another thread without following pointers.
    Value* depth = loadContext(m.i32, offsetof(RuntimeContext, depth));
    guard(b.CreateICmpUGE(depth, int32(image::kMaximumDepth)), FaultCode::StackOverflow);
    Value* record = b.CreateInBoundsGEP(m.i8, m_context,
                                        b.CreateAdd(b.CreateShl(b.CreateZExt(depth, m.i64), int64(4), "", true, true),
                                                    int64(offsetof(RuntimeContext, calls)), "", true, true));
    // The shift by four above.
    static_assert(sizeof(CallRecord) == 16);
    const auto put = [&](Value* value, size_t at) {
        llvm::StoreInst* stored = b.CreateStore(value, b.CreateConstInBoundsGEP1_64(m.i8, record, at));
        if (!m.isQuick()) stored->setMetadata(llvm::LLVMContext::MD_tbaa, m.contextTag());
    };
    put(int32(m_site), offsetof(CallRecord, site));
    put(function, offsetof(CallRecord, function));
    put(self, offsetof(CallRecord, instance));
    put(frame, offsetof(CallRecord, frame));
    storeContext(b.CreateAdd(depth, int32(1)), offsetof(RuntimeContext, depth));
    return depth;
}

// The depth that pushCall found, not "one less": a callee that faulted and was caught may have left it anywhere.
void FunctionEmitter::popCall(Value* depth) { storeContext(depth, offsetof(RuntimeContext, depth)); }

/// The implementation for the block that lies at `self64`, after checking that one with this method lies there.
llvm::Value* FunctionEmitter::resolveTarget(const Call& call, Value* self64, Value*& functionId) {
    // `number` is read from wherever the reference leads, so it may be anything: every use of it is checked first.
    const uint32_t method = call.callee.value;
    // One table for each method: code, number and size of the block, by block number.
    llvm::GlobalVariable* table = m.dispatchTable(method);
    Value* number =
        b.CreateZExt(b.CreateAlignedLoad(m.i32, b.CreateInBoundsGEP(m.i8, m_image, self64), llvm::Align(1)), m.i64);
    guard(b.CreateICmpUGE(number, int64(std::max(1u, m.facts.blockCount()))), FaultCode::ForeignReference, self64);
    // The row of dispatchTable.
    auto* row = llvm::StructType::get(m.context, {m.ptr, m.i32, m.i32});
    Value* at = b.CreateInBoundsGEP(row, table, number);
    Value* code = b.CreateLoad(m.ptr, at);
    Value* size = b.CreateZExt(b.CreateLoad(m.i32, b.CreateStructGEP(row, at, 2)), m.i64);
    functionId = b.CreateLoad(m.i32, b.CreateStructGEP(row, at, 1));
    // A number at the very end of the image: its block would reach beyond.
    Value* isOutside = b.CreateICmpUGT(b.CreateAdd(self64, size), int64(m.program.layout.imageSize));
    guard(b.CreateOr(b.CreateICmpEQ(code, llvm::ConstantPointerNull::get(m.ptr)), isOutside),
          FaultCode::ForeignReference, self64);
    // One implementation only: called directly, so that it can be inlined.
    // The guards above stay: the place may hold anything a wrong pointer led to.
    uint32_t only = 0;
    bool isUnique = true;
    for (const Target& target : m.facts.targetsOf(method)) {
        const uint32_t f = target.function != 0 ? target.function : method;
        isUnique = isUnique && (only == 0 || only == f);
        only = f;
    }
    if (isUnique && only != 0 && !m.program.functions[only].isAbstract && m.abi(only).type == m.abi(method).type) {
        functionId = int32(only);
        return m.function(only);
    }
    return code;
}

/// Values for the callee's parameters behind ctx, image, THIS, frame, evaluated in the order written.
std::vector<llvm::Value*> FunctionEmitter::callArguments(const Call& call) {
    const tree::Function& callee = m.program.functions[call.callee.index()];
    std::vector<std::vector<Value*>> byLocal(callee.locals.size());
    for (size_t n = 0; n < call.arguments.size(); ++n) {
        const tree::CallArgument& argument = call.arguments[n];
        if (argument.local >= callee.locals.size()) continue;
        const Local& local = callee.locals[argument.local];
        std::vector<Value*>& values = byLocal[argument.local];
        if (argument.mode == ArgumentMode::InOut && argument.place) {
            // A constant or a temporary outside the image has no offset; the checker has made a local of it before.
            const Address a = address(*argument.place);
            values.push_back(a.isImage ? offset(a) : int64(0));
            if (m.types().kind(local.type) == TypeKind::OpenArray)
                for (auto [low, high] : boundsOf(a)) {
                    values.push_back(low);
                    values.push_back(high);
                }
            continue;
        }
        if (argument.mode != ArgumentMode::Input || !argument.value) continue;
        if (m.isScalar(local.type)) {
            values.push_back(scalar(*argument.value));
            guardRange(values.back(), *argument.value, local.type);
            continue;
        }
        // A text or structure is given as an address: what comes later in the call must not change it any more.
        // F(s, G()) where G writes s: F was given s as it was when the argument was evaluated.
        bool isExposed = false;
        for (size_t k = n + 1; k < call.arguments.size(); ++k)
            isExposed = isExposed || hasEffects(call.arguments[k].value) || hasEffects(call.arguments[k].place);
        if (m.types().isText(local.type)) {
            const types::TypeId from = argument.value->type;
            const Text given = text(*argument.value);
            // Same capacity: the callee may read it in place. Otherwise it is copied into a text of the parameter's
            // capacity, whose end mark the callee relies on.
            const bool fits = !isExposed && from == local.type && argument.value->kind == tree::ExprKind::Load;
            if (fits) {
                values.push_back(given.pointer);
            } else {
                const Text made = textTemporary(local.type);
                assignText(made, given);
                values.push_back(made.pointer);
            }
            continue;
        }
        Address a = aggregate(*argument.value);
        if (isExposed) {
            const Address kept = temporary(local.type);
            copy(kept, a, m.types()[local.type].size);
            a = kept;
        }
        values.push_back(pointer(a));
    }
    // By local and not by argument: a call may name its arguments in any order, and leave some out.
    std::vector<Value*> all;
    for (uint32_t i = 0; i < callee.locals.size(); ++i) {
        const Local& local = callee.locals[i];
        std::vector<Value*>& values = byLocal[i];
        if (local.isInOut) {
            if (local.kind != LocalKind::InOut) continue;
            const size_t wanted =
                m.types().kind(local.type) == TypeKind::OpenArray ? 1 + 2 * m.types()[local.type].dimensions.size() : 1;
            // The offset 0 and bounds 0..-1: using it faults, being asked for its bounds does not.
            while (values.size() < wanted)
                values.push_back(int64(values.size() % 2 == 0 && !values.empty() ? -1 : 0)); // left out: null, empty
            all.insert(all.end(), values.begin(), values.begin() + static_cast<ptrdiff_t>(wanted));
        } else if (local.kind == LocalKind::Input) {
            if (!values.empty()) {
                all.push_back(values.front());
                // What the checker left out is the type's own zero; declared defaults came as arguments.
            } else if (m.isScalar(local.type)) {
                all.push_back(llvm::Constant::getNullValue(m.scalarType(local.type)));
            } else {
                std::vector<std::byte> bytes = m.types()[local.type].initial;
                bytes.resize(std::max(1u, m.types()[local.type].size));
                all.push_back(
                    m.constantBytes(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()), 8));
            }
        }
    }
    return all;
}

// Outputs in the order: those in the frame, then those in registers. The frame is the one that is overwritten first.
void FunctionEmitter::takeOutputs(const Call& call, Value* returned, Value* frame) {
    const uint32_t calleeIndex = call.callee.value;
    const tree::Function& callee = m.program.functions[calleeIndex];
    const Abi& abi = m.abi(calleeIndex);
    // Outputs that stay in the callee's frame first: evaluating a target may call and so use that memory again.
    std::vector<std::pair<const tree::CallArgument*, Address>> kept;
    bool hasEffect = false;
    for (const tree::CallArgument& argument : call.arguments)
        if (argument.mode == ArgumentMode::Output && argument.place)
            hasEffect = hasEffect || hasEffects(argument.place);
    for (const tree::CallArgument& argument : call.arguments) {
        if (argument.mode != ArgumentMode::Output || !argument.place) continue;
        const Local& local = callee.locals[argument.local];
        if (m.isScalar(local.type)) continue;
        Address from;
        // An output in the callee's frame, at the same offset there as for the callee itself.
        from.baseOffset = frame;
        from.base = b.CreateInBoundsGEP(m.i8, m_image, from.baseOffset);
        from.constant = m.frameOffset(calleeIndex, argument.local);
        from.type = local.type;
        if (hasEffect) {
            const Address copyOf = temporary(local.type);
            copy(copyOf, from, m.types()[local.type].size);
            from = copyOf;
        }
        kept.push_back({&argument, from});
    }
    for (const auto& [argument, from] : kept) {
        const Address to = address(*argument->place);
        if (m.types().isText(from.type) && m.types().isText(to.type))
            assignText(textAt(to), textAt(from));
        else
            copy(to, from, std::min(m.types()[from.type].size, m.types()[to.type].size));
    }
    for (const tree::CallArgument& argument : call.arguments) {
        if (argument.mode != ArgumentMode::Output || !argument.place) continue;
        const Local& local = callee.locals[argument.local];
        if (!m.isScalar(local.type)) continue;
        unsigned element = abi.returnsScalar ? 1 : 0;
        for (const uint32_t output : abi.scalarOutputs) {
            if (output == argument.local) break;
            ++element;
        }
        // One value is returned as it is, several as a structure: the result first, then outputs in order.
        Value* value = abi.returned == 1 ? returned : b.CreateExtractValue(returned, element);
        const Address to = address(*argument.place);
        // A character or number that goes into a text.
        if (m.types().isText(to.type)) {
            const Text target = textAt(to);
            Value* kind = int32(static_cast<uint32_t>(m.types().storageKind(local.type)));
            if (value->getType()->isFloatingPointTy())
                textCall("from_real", target.isWide, m.voidType,
                         {target.pointer, target.capacity, kind, b.CreateFPExt(value, m.f64)}, true);
            else
                textCall("from_integer", target.isWide, m.voidType,
                         {target.pointer, target.capacity, kind, castInteger(value, local.type, m.i64)}, true);
            continue;
        }
        store(to, convert(value, local.type, argument.place->type));
    }
}

// The order of evaluation: the instance, the arguments as written, then the dispatch, so that an argument which changes
// an interface variable does not change whom this call reaches.
FunctionEmitter::Returned FunctionEmitter::call(const Call& call) {
    const uint32_t callee = call.callee.value;
    const FunctionFacts& facts = m.facts[callee];
    // THIS of functions is the image itself at 0; nobody reads it.
    Value* self64 = int64(0);
    Value* self = m_image;
    if (call.dispatch == Call::Dispatch::Interface && call.interface) {
        self64 = b.CreateZExtOrTrunc(scalar(*call.interface), m.i64);
        self = b.CreateInBoundsGEP(m.i8, m_image, self64);
    } else if (call.instance) {
        const Address a = address(*call.instance);
        self64 = a.isImage ? offset(a) : int64(0);
        if (a.isImage) self = pointer(a);
    }
    std::vector<Value*> arguments = callArguments(call);
    Value* target = nullptr;
    Value* functionId = int32(callee);
    // THIS of a virtual call is a variable of a block type, so something lives there; an interface may hold any number.
    const bool isDirect = call.dispatch == Call::Dispatch::Direct;
    if (isDirect) {
        target = m.function(callee);
    } else {
        if (call.dispatch == Call::Dispatch::Interface) guardReference(self64, int64(8));
        target = resolveTarget(call, self64, functionId);
    }
    // A recursion is a loop: the watchdog must be able to end it.
    if (m.program.functions[callee].mayRecurse || facts.inCycle) charge(int64(1));
    // A record costs four stores. A callee that cannot fault never shows a call path in optimised code.
    const bool isRecorded = m.isQuick() || !isDirect || facts.canFault;
    const bool charges = !isDirect || facts.charges;
    Value* depth =
        isRecorded ? pushCall(functionId, b.CreateTrunc(self64, m.i32), b.CreateTrunc(m_nextFrame, m.i32)) : nullptr;
    // The budget is in a register of this function; the callee continues with what the context says.
    if (charges) flushBudget();
    watch(image::WatchKind::Call, &call, b.CreateZExt(functionId, m.i64));
    arguments.insert(arguments.begin(), {m_context, m_image, self, m_nextFrame});
    llvm::CallInst* returned = b.CreateCall(m.abi(callee).type, target, arguments);
    // Faults leave by longjmp to the controller, not by unwinding.
    returned->setDoesNotThrow();
    if (charges) reloadBudget();
    if (depth) popCall(depth);
    takeOutputs(call, returned, m_nextFrame);
    Returned result;
    result.frame = m_nextFrame;
    const Abi& abi = m.abi(callee);
    if (abi.returnsScalar)
        result.result = abi.returned == 1 ? static_cast<Value*>(returned) : b.CreateExtractValue(returned, 0u);
    return result;
}

} // namespace plc::codegen
