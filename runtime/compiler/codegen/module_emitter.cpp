// A module for a part of the program: types and signatures, entries for the controller, tables for dispatch, and alias
// nodes that tell LLVM which parts of the image are apart. Lives while one part is emitted; parts run on several
// threads, each with a context of its own, and share only what is const.
#include "runtime/compiler/codegen/emitter.h"

#include <algorithm>

namespace plc::codegen {

using image::RuntimeContext;
using tree::LocalKind;
using types::TypeKind;

namespace {
// The rest is for the controller, library functions in C++ and signal handlers.
/// Of the scan thread's own stack, for generated code. Threads have 8 MiB.
constexpr int64_t kHostStack = 3 * 1024 * 1024;
} // namespace

ModuleEmitter::ModuleEmitter(llvm::LLVMContext& llvmContext, const tree::Program& tree, const ProgramFacts& known,
                             const Options& wanted, Part which)
    : frameSizes(tree.functions.size(), 0), context(llvmContext),
      module(std::make_unique<llvm::Module>("plc", llvmContext)), program(tree), options(wanted), facts(known),
      part(which), m_abis(tree.functions.size()), m_functions(tree.functions.size()), m_needs(tree.functions.size()) {
    // Asked for at nearly every instruction; here they are looked up once.
    i1 = llvm::Type::getInt1Ty(context);
    i8 = llvm::Type::getInt8Ty(context);
    i16 = llvm::Type::getInt16Ty(context);
    i32 = llvm::Type::getInt32Ty(context);
    i64 = llvm::Type::getInt64Ty(context);
    ptr = llvm::PointerType::getUnqual(context);
    f32 = llvm::Type::getFloatTy(context);
    f64 = llvm::Type::getDoubleTy(context);
    voidType = llvm::Type::getVoidTy(context);
    llvm::MDBuilder builder(context);
    // Two trees: the image and the context of the thread never alias. Below "image" a node for each field and root that
    // is apart from all others.
    llvm::MDNode* root = builder.createTBAARoot("plc");
    m_imageNode = builder.createTBAAScalarTypeNode("image", root);
    llvm::MDNode* contextNode = builder.createTBAAScalarTypeNode("context", root);
    m_contextTag = builder.createTBAAStructTagNode(contextNode, contextNode, 0);
    taint();
}

Result<std::unique_ptr<llvm::Module>> ModuleEmitter::emit() {
    for (uint32_t f = 1; f < program.functions.size(); ++f) {
        if (!isOwn(f) || program.functions[f].isAbstract) continue;
        // Quick code has every function, because a debugger or a test may call it.
        if (!isQuick() && !facts[f].isReachable) continue;
        if (isCancelled(options.progress)) return std::move(module);
        FunctionEmitter(*this, f).emit();
        // Temporaries count too, so it is known only now.
        if (const uint64_t room = facts::frameRoom(program); frameSizes[f] > room)
            return facts::tooLarge(program, f, frameSizes[f]);
    }
    emitEntries();
    // Frame sizes are constants in code that was written before they were known.
    resolvePatches();
    if (!isQuick()) limitInlining();
    return std::move(module);
}

/// Inlining everything that is called once would make one function of a whole plant, and optimising that takes minutes.
/// What is long gains nothing by it; callers with many calls take in only what is short.
void ModuleEmitter::limitInlining() {
    // In instructions and calls. Converted plants have functions of tens of thousands.
    constexpr unsigned kLong = 500, kShort = 80, kManyCalls = 40;
    constexpr size_t kManyBlocks = 8000; // a CASE or row of ELSIFs of thousands: passes grow with the square of them
    for (llvm::Function* function : m_functions) {
        if (!function || function->isDeclaration()) continue;
        if (function->getInstructionCount() > kLong) function->addFnAttr(llvm::Attribute::NoInline);
        if (function->size() <= kManyBlocks) continue;
        function->addFnAttr(llvm::Attribute::NoInline);
        // LLVM demands NoInline with it.
        function->addFnAttr(llvm::Attribute::OptimizeNone);
    }
    for (llvm::Function* function : m_functions) {
        if (!function || function->isDeclaration()) continue;
        std::vector<llvm::CallBase*> calls;
        for (llvm::BasicBlock& block : *function)
            for (llvm::Instruction& instruction : block)
                if (auto* call = llvm::dyn_cast<llvm::CallBase>(&instruction);
                    call && call->getCalledFunction() && !call->getCalledFunction()->isDeclaration() &&
                    call->getCalledFunction() != m_raise)
                    calls.push_back(call);
        if (calls.size() < kManyCalls) continue;
        for (llvm::CallBase* call : calls)
            if (call->getCalledFunction()->getInstructionCount() > kShort) call->setIsNoInline();
    }
}

/// What tasks and the initializer run; quick code also has every body and action that needs no arguments, for tests and
/// tools.
std::vector<uint32_t> ModuleEmitter::entryFunctions() const {
    std::vector<bool> isEntry(program.functions.size(), false);
    const auto add = [&](uint32_t f) {
        if (f != 0 && f < isEntry.size()) isEntry[f] = true;
    };
    for (const image::Task& task : program.tasks)
        for (const image::TaskProgram& p : task.programs)
            for (const uint32_t f : {p.function, p.connectIn, p.connectOut}) add(f);
    if (program.initializer.isValid()) add(program.initializer.value);
    std::vector<uint32_t> entries;
    for (uint32_t f = 1; f < program.functions.size(); ++f) {
        const tree::Function& tree = program.functions[f];
        if (!isOwn(f) || tree.isAbstract) continue;
        const bool hasParameters = std::any_of(tree.locals.begin(), tree.locals.end(),
                                               [](const tree::Local& l) { return l.kind != LocalKind::Local; });
        if (isEntry[f] || (isQuick() && !hasParameters)) entries.push_back(f);
    }
    return entries;
}

void ModuleEmitter::emitEntries() {
    llvm::StructType* row = llvm::StructType::get(context, {i64, ptr});
    std::vector<llvm::Constant*> rows;
    for (const uint32_t f : entryFunctions())
        rows.push_back(llvm::ConstantStruct::get(row, {llvm::ConstantInt::get(i64, f), emitEntry(f)}));
    // Ends with zeros; the JIT reads the table by its name, so no symbol is looked up for each function.
    rows.push_back(llvm::Constant::getNullValue(row));
    llvm::Constant* table = llvm::ConstantArray::get(llvm::ArrayType::get(row, rows.size()), rows);
    newConstant("plc.entries." + std::to_string(part.index), table)->setLinkage(llvm::GlobalValue::ExternalLinkage);
}

// ---------------------------------------------------------------- types and signatures

bool ModuleEmitter::isScalar(types::TypeId type) const {
    return !types().isAggregate(type) && !types().isText(type) && types().kind(type) != TypeKind::OpenArray;
}

llvm::Type* ModuleEmitter::memoryType(types::TypeId type) {
    switch (types().storageKind(type)) {
    case TypeKind::Real:
        return f32;
    case TypeKind::Lreal:
        return f64;
    case TypeKind::Interface:
    case TypeKind::Pointer:
    case TypeKind::Reference:
    case TypeKind::Null:
        return i64;
    default:
        break;
    }
    switch (types()[types().storage(type)].size) {
    case 1:
        return i8;
    case 2:
        return i16;
    case 4:
        return i32;
    default:
        return i64;
    }
}

// BOOL is a byte in memory and a bit in registers: comparisons and branches stay short.
llvm::Type* ModuleEmitter::scalarType(types::TypeId type) {
    return types().storageKind(type) == TypeKind::Bool ? i1 : memoryType(type);
}

const Abi& ModuleEmitter::abi(uint32_t index) {
    // Made when first asked for; callers and callee get the same from the tree alone, in whichever part they are.
    Abi& abi = m_abis[index];
    if (abi.type) return abi;
    const tree::Function& tree = program.functions[index];
    std::vector<llvm::Type*> parameters{ptr, ptr, ptr, i64}, returned;
    if (tree.resultLocal < tree.locals.size() && isScalar(tree.locals[tree.resultLocal].type)) {
        abi.returnsScalar = true;
        returned.push_back(scalarType(tree.locals[tree.resultLocal].type));
    }
    for (uint32_t i = 0; i < tree.locals.size(); ++i) {
        const tree::Local& local = tree.locals[i];
        if (local.isInOut) {
            if (local.kind != LocalKind::InOut) continue;
            parameters.push_back(i64);
            if (types().kind(local.type) == TypeKind::OpenArray)
                for (size_t d = 0; d < types()[local.type].dimensions.size() * 2; ++d) parameters.push_back(i64);
        } else if (local.kind == LocalKind::Input) {
            parameters.push_back(isScalar(local.type) ? scalarType(local.type) : ptr);
        } else if (local.kind == LocalKind::Output && isScalar(local.type)) {
            abi.scalarOutputs.push_back(i);
            returned.push_back(scalarType(local.type));
        }
    }
    abi.returned = static_cast<unsigned>(returned.size());
    llvm::Type* result = returned.empty()       ? voidType
                         : returned.size() == 1 ? returned[0]
                                                : llvm::StructType::get(context, returned);
    abi.type = llvm::FunctionType::get(result, parameters, false);
    return abi;
}

void ModuleEmitter::addAttributes(llvm::Function& f) {
    f.setDoesNotThrow();
    // Not to warn anybody: LLVM reports large frames through its diagnostics, the only place where they can be read.
    f.addFnAttr("warn-stack-size", std::to_string(kSmallStackFrame)); // the JIT hears of larger ones
    if (options.threadSanitizer) f.addFnAttr(llvm::Attribute::SanitizeThread);
    if (isQuick()) return;
    // The context is never reached through the image. THIS (2) has no such attribute: it points into the image (1).
    f.addParamAttr(0, llvm::Attribute::NoAlias);
    f.addParamAttr(0, llvm::Attribute::NonNull);
    f.addParamAttr(0, llvm::Attribute::getWithDereferenceableBytes(context, sizeof(RuntimeContext)));
    f.addParamAttr(1, llvm::Attribute::NonNull);
    f.addParamAttr(1, llvm::Attribute::getWithDereferenceableBytes(context, std::max(64u, program.layout.imageSize)));
}

llvm::Function* ModuleEmitter::function(uint32_t index) {
    llvm::Function*& f = m_functions[index];
    if (f) return f;
    const bool isInternal = !isQuick() || program.functions[index].isAbstract; // watched code calls quick code
    const auto linkage = isInternal ? llvm::GlobalValue::InternalLinkage : llvm::GlobalValue::ExternalLinkage;
    f = llvm::Function::Create(abi(index).type, linkage, "plc.f." + std::to_string(index), *module);
    addAttributes(*f);
    // Called only through a broken instance: a fault with a name instead of a missing symbol.
    if (program.functions[index].isAbstract) {
        llvm::IRBuilder<> builder(llvm::BasicBlock::Create(context, "", f));
        builder.CreateCall(raise(),
                           {f->getArg(0), builder.getInt32(static_cast<uint32_t>(image::FaultCode::AbstractCall)),
                            builder.getInt32(0), builder.getInt64(0), builder.getInt64(0), builder.getInt64(0)});
        builder.CreateUnreachable();
    }
    return f;
}

uint32_t ModuleEmitter::frameOffset(uint32_t index, uint32_t local) const { return facts[index].frame.offsets[local]; }

// ---------------------------------------------------------------- entries and frame sizes

llvm::Function* ModuleEmitter::emitEntry(uint32_t index) {
    auto* type = llvm::FunctionType::get(voidType, {ptr, ptr, i32}, false);
    auto* entry =
        llvm::Function::Create(type, llvm::GlobalValue::InternalLinkage, "plc.entry." + std::to_string(index), *module);
    addAttributes(*entry);
    // The entry is what the controller calls: it sets up the frame, the limits and the first call record.
    entry->addFnAttr(kGuardsStack); // sets the limit
    llvm::IRBuilder<> b(llvm::BasicBlock::Create(context, "", entry));
    llvm::Value* ctx = entry->getArg(0);
    const auto field = [&](size_t offset) { return b.CreateConstInBoundsGEP1_64(i8, ctx, offset); };
    llvm::Value* frame = b.CreateLoad(i32, field(offsetof(RuntimeContext, frameTop)));
    auto* tooFar = new llvm::ICmpInst(b.GetInsertBlock(), llvm::CmpInst::ICMP_UGT, frame, b.getInt32(0));
    patchNeed(tooFar, 1, index);
    auto* bad = llvm::BasicBlock::Create(context, "", entry);
    auto* ok = llvm::BasicBlock::Create(context, "", entry);
    b.CreateCondBr(tooFar, bad, ok);
    b.SetInsertPoint(bad);
    b.CreateCall(raise(), {ctx, b.getInt32(static_cast<uint32_t>(image::FaultCode::StackOverflow)), b.getInt32(0),
                           b.getInt64(0), b.getInt64(0), b.getInt64(0)});
    b.CreateUnreachable();
    b.SetInsertPoint(ok);
    llvm::Value* here = b.CreatePtrToInt(b.CreateIntrinsic(llvm::Intrinsic::frameaddress, {ptr}, {b.getInt32(0)}), i64);
    b.CreateStore(b.CreateSub(here, b.getInt64(kHostStack)), field(offsetof(RuntimeContext, stackLimit)));
    // The outermost record: no site, the entry itself.
    const size_t record = offsetof(RuntimeContext, calls);
    b.CreateStore(b.getInt32(0), field(record + offsetof(image::CallRecord, site)));
    b.CreateStore(b.getInt32(index), field(record + offsetof(image::CallRecord, function)));
    b.CreateStore(entry->getArg(2), field(record + offsetof(image::CallRecord, instance)));
    b.CreateStore(frame, field(record + offsetof(image::CallRecord, frame)));
    b.CreateStore(b.getInt32(1), field(offsetof(RuntimeContext, depth)));
    std::vector<llvm::Value*> arguments{ctx, entry->getArg(1),
                                        b.CreateInBoundsGEP(i8, entry->getArg(1), b.CreateZExt(entry->getArg(2), i64)),
                                        b.CreateZExt(frame, i64)};
    llvm::FunctionType* called = abi(index).type;
    for (unsigned i = 4; i < called->getNumParams(); ++i)
        // Only functions without parameters are entries of tasks; tests call others with zeros.
        arguments.push_back(llvm::Constant::getNullValue(called->getParamType(i)));
    b.CreateCall(function(index), arguments);
    // 0 between calls: whoever looks from outside knows that nothing runs.
    b.CreateStore(b.getInt32(0), field(offsetof(RuntimeContext, depth)));
    b.CreateRetVoid();
    return entry;
}

/// Bytes of frame area a call of `index` uses at most, calls into cycles left out (those check for themselves). In
/// quick code every function checks its own.
uint64_t ModuleEmitter::need(uint32_t index) {
    if (isQuick()) return frameSizes[index];
    if (m_needs[index]) return *m_needs[index];
    // Callees first, without recursion: calls may be nested as deep as the program likes.
    std::vector<uint32_t> waiting{index};
    while (!waiting.empty()) {
        const uint32_t f = waiting.back();
        uint64_t deepest = 0;
        bool isComplete = true;
        for (const uint32_t callee : facts[f].callees) {
            if (facts[callee].isUnbounded) continue;
            if (m_needs[callee]) {
                deepest = std::max(deepest, *m_needs[callee]);
            } else {
                waiting.push_back(callee);
                isComplete = false;
            }
        }
        if (!isComplete) continue;
        m_needs[f] = frameSizes[f] + deepest;
        waiting.pop_back();
    }
    return *m_needs[index];
}

void ModuleEmitter::resolvePatches() {
    for (const SizePatch& patch : m_sizePatches) {
        uint64_t value = frameSizes[patch.function];
        if (patch.isNeed) {
            const uint64_t wanted = need(patch.function);
            value = wanted > program.layout.imageSize ? 0 : program.layout.imageSize - wanted;
        }
        patch.instruction->setOperand(
            patch.operand, llvm::ConstantInt::get(patch.instruction->getOperand(patch.operand)->getType(), value));
    }
}

// ---------------------------------------------------------------- helpers and tables

llvm::FunctionCallee ModuleEmitter::helper(const char* name, llvm::Type* result, llvm::ArrayRef<llvm::Type*> parameters,
                                           Effects effects) {
    llvm::FunctionCallee callee = module->getOrInsertFunction(name, llvm::FunctionType::get(result, parameters, false));
    auto* f = llvm::cast<llvm::Function>(callee.getCallee());
    // It has its attributes already.
    if (f->doesNotThrow()) return callee;
    f->setDoesNotThrow();
    switch (effects) {
    case Effects::None:
        // Effects matter most of all that is known of a call: without them every library function would reload the
        // whole image.
        f->setDoesNotAccessMemory();
        f->setWillReturn();
        break;
    case Effects::ReadsArguments:
        f->setOnlyReadsMemory();
        [[fallthrough]];
    case Effects::WritesArguments:
        f->setOnlyAccessesArgMemory();
        f->setWillReturn();
        for (unsigned i = 0; i < parameters.size(); ++i)
            if (parameters[i]->isPointerTy()) f->addParamAttr(i, llvm::Attribute::NoCapture);
        break;
    case Effects::Context: // keeps off the image, may not come back: loops may hold variables in registers meanwhile
    case Effects::Fault:   // the image at the fault is the last record: what was written before must be there
        f->setMemoryEffects(
            llvm::MemoryEffects::argMemOnly() | llvm::MemoryEffects::inaccessibleMemOnly() |
            (effects == Effects::Fault ? llvm::MemoryEffects::readOnly() : llvm::MemoryEffects::none()));
        f->addParamAttr(0, llvm::Attribute::NoCapture);
        break;
    case Effects::Any:
        break;
    }
    return callee;
}

llvm::Function* ModuleEmitter::raise() {
    if (m_raise) return m_raise;
    auto* type = llvm::FunctionType::get(voidType, {ptr, i32, i32, i64, i64, i64}, false);
    m_raise = llvm::Function::Create(type, llvm::GlobalValue::InternalLinkage, "plc.raise", *module);
    // One cold function for all faults: each guard then costs one call in a block of its own.
    m_raise->addFnAttr(llvm::Attribute::NoInline);
    m_raise->addFnAttr(llvm::Attribute::Cold);
    m_raise->setDoesNotReturn();
    m_raise->setDoesNotThrow();
    llvm::IRBuilder<> b(llvm::BasicBlock::Create(context, "", m_raise));
    const auto put = [&](unsigned argument, size_t offset) {
        b.CreateStore(m_raise->getArg(argument), b.CreateConstInBoundsGEP1_64(i8, m_raise->getArg(0), offset));
    };
    put(1, offsetof(RuntimeContext, fault));
    put(2, offsetof(RuntimeContext, faultSite));
    for (unsigned i = 0; i < 3; ++i) put(3 + i, offsetof(RuntimeContext, faultDetail) + i * 8);
    llvm::FunctionCallee leave = helper("plc_fault", voidType, {ptr}, Effects::Fault);
    llvm::cast<llvm::Function>(leave.getCallee())->setDoesNotReturn();
    b.CreateCall(leave, {m_raise->getArg(0)});
    b.CreateUnreachable();
    return m_raise;
}

/// One call a statement instead of branches in place: half the time to compile. THIS and frame stand in the newest call
/// record.
llvm::Function* ModuleEmitter::siteCheck() {
    if (m_siteCheck) return m_siteCheck;
    m_siteCheck = llvm::Function::Create(llvm::FunctionType::get(voidType, {ptr, i32}, false),
                                         llvm::GlobalValue::InternalLinkage, "plc.site", *module);
    m_siteCheck->setDoesNotThrow();
    llvm::Value *ctx = m_siteCheck->getArg(0), *site = m_siteCheck->getArg(1);
    auto* entry = llvm::BasicBlock::Create(context, "", m_siteCheck);
    auto* stop = llvm::BasicBlock::Create(context, "", m_siteCheck);
    auto* go = llvm::BasicBlock::Create(context, "", m_siteCheck);
    llvm::IRBuilder<> b(entry);
    const auto field = [&](size_t offset) { return b.CreateConstInBoundsGEP1_64(i8, ctx, offset); };
    b.CreateStore(site, field(offsetof(RuntimeContext, currentSite)));
    // A byte for each site: whether somebody wants to stop there.
    llvm::Value* flags = b.CreateLoad(ptr, field(offsetof(RuntimeContext, siteFlags)));
    llvm::Value* flag = b.CreateLoad(i8, b.CreateInBoundsGEP(i8, flags, b.CreateZExt(site, i64)));
    b.CreateCondBr(b.CreateICmpNE(flag, b.getInt8(0)), stop, go);
    b.SetInsertPoint(stop);
    static_assert(sizeof(image::CallRecord) == 16);
    llvm::Value* depth = b.CreateZExt(b.CreateLoad(i32, field(offsetof(RuntimeContext, depth))), i64);
    llvm::Value* record = b.CreateInBoundsGEP(i8, field(offsetof(RuntimeContext, calls)),
                                              b.CreateShl(b.CreateSub(depth, b.getInt64(1)), b.getInt64(4)));
    llvm::Value* instance =
        b.CreateLoad(i32, b.CreateConstInBoundsGEP1_64(i8, record, offsetof(image::CallRecord, instance)));
    llvm::Value* frame =
        b.CreateLoad(i32, b.CreateConstInBoundsGEP1_64(i8, record, offsetof(image::CallRecord, frame)));
    b.CreateCall(helper("plc_at_site", voidType, {ptr, i32, i32, i32}, Effects::Any), {ctx, site, instance, frame});
    b.CreateBr(go);
    b.SetInsertPoint(go);
    b.CreateRetVoid();
    return m_siteCheck;
}

llvm::FunctionCallee ModuleEmitter::budgetUsedUp() {
    llvm::FunctionCallee callee = helper("plc_budget_used_up", voidType, {ptr}, Effects::Context);
    llvm::cast<llvm::Function>(callee.getCallee())->addFnAttr(llvm::Attribute::Cold);
    return callee;
}

llvm::GlobalVariable* ModuleEmitter::newConstant(const std::string& name, llvm::Constant* value) {
    auto* global = llvm::cast<llvm::GlobalVariable>(module->getOrInsertGlobal(name, value->getType()));
    global->setInitializer(value);
    global->setConstant(true);
    global->setLinkage(llvm::GlobalValue::PrivateLinkage);
    return global;
}

llvm::GlobalVariable* ModuleEmitter::constantBytes(std::string bytes, uint32_t align) {
    // Equal bytes are one constant, whatever they are of.
    llvm::GlobalVariable*& global = m_constants[bytes];
    if (global) {
        if (global->getAlign().valueOrOne().value() < align) global->setAlignment(llvm::Align(align));
        return global;
    }
    llvm::Constant* value = llvm::ConstantDataArray::getString(context, bytes, false);
    global = newConstant("plc.c." + std::to_string(m_constants.size()), value);
    global->setAlignment(llvm::Align(align));
    global->setUnnamedAddr(llvm::GlobalValue::UnnamedAddr::Global);
    return global;
}

/// {code, function number, size of the block} for every block number; code null where the block does not fit.
llvm::GlobalVariable* ModuleEmitter::dispatchTable(uint32_t method) {
    // A table for each method name that is dispatched, with a row for each block number.
    llvm::GlobalVariable*& table = m_dispatchTables[method];
    if (table) return table;
    llvm::StructType* row = llvm::StructType::get(context, {ptr, i32, i32});
    std::vector<llvm::Constant*> rows(std::max(1u, facts.blockCount()), llvm::Constant::getNullValue(row));
    for (const Target& target : facts.targetsOf(method)) {
        const uint32_t f =
            target.function != 0 && abi(target.function).type == abi(method).type ? target.function : method;
        if (!program.functions[f].isAbstract && !isQuick() && !facts[f].isReachable) continue;
        if (f == method && !program.functions[f].isAbstract && target.function == 0) continue;
        rows[target.blockNumber] =
            llvm::ConstantStruct::get(row, {function(f), llvm::ConstantInt::get(i32, f),
                                            llvm::ConstantInt::get(i32, types()[target.block].size)});
    }
    llvm::ArrayType* type = llvm::ArrayType::get(row, rows.size());
    table = newConstant("plc.dispatch." + std::to_string(method), llvm::ConstantArray::get(type, rows));
    return table;
}

llvm::GlobalVariable* ModuleEmitter::blockFlags(types::TypeId wanted, bool& any) {
    std::string flags(std::max(1u, facts.blockCount()), '\0');
    const bool isInterface = types().kind(wanted) == TypeKind::Interface;
    any = false;
    for (uint32_t n = 1; n < facts.blockCount(); ++n) {
        const types::TypeId block = facts.blockType(n);
        if (!block.isValid()) continue;
        if (isInterface ? !types().implements(block, wanted) : !types().isDerivedFrom(block, wanted)) continue;
        flags[n] = 1;
        any = true;
    }
    llvm::GlobalVariable*& table = m_blockFlags[wanted.value];
    if (!table) table = constantBytes(flags, 1);
    return table;
}

// ---------------------------------------------------------------- alias nodes

llvm::MDNode* ModuleEmitter::aliasTag(llvm::MDNode* node) {
    llvm::MDNode*& tag = m_tags[node];
    if (!tag) tag = llvm::MDBuilder(context).createTBAAStructTagNode(node, node, 0);
    return tag;
}

llvm::MDNode* ModuleEmitter::contextTag() { return m_contextTag; }

llvm::MDNode* ModuleEmitter::fieldNode(types::TypeId container, size_t field) {
    // The type that declares the field stands for all that inherit it.
    // Fields of a base have the same index in everything that extends it.
    while (types()[container].base.isValid() && field < types()[types()[container].base].fields.size())
        container = types()[container].base;
    const types::Field& f = types()[container].fields[field];
    if (f.bit >= 0) { // BIT members share their byte
        while (field > 0 && types()[container].fields[field - 1].bit >= 0 &&
               types()[container].fields[field - 1].offset == f.offset)
            --field;
    }
    llvm::MDNode*& node = m_fieldNodes[{container.value, static_cast<uint32_t>(field)}];
    if (!node)
        node = llvm::MDBuilder(context).createTBAAScalarTypeNode(
            "f" + std::to_string(container.value) + "." + std::to_string(field), m_imageNode);
    return node;
}

llvm::MDNode* ModuleEmitter::rootNode(size_t root) {
    llvm::MDNode*& node = m_rootNodes[root];
    if (!node) node = llvm::MDBuilder(context).createTBAAScalarTypeNode("r" + std::to_string(root), m_imageNode);
    return node;
}

// -1: no root of its own, or one that shares its bytes.
int ModuleEmitter::rootAt(uint32_t offset) const {
    auto it =
        std::upper_bound(m_rootsByOffset.begin(), m_rootsByOffset.end(), std::pair<uint32_t, size_t>{offset, SIZE_MAX});
    if (it == m_rootsByOffset.begin()) return -1;
    --it;
    const image::Root& root = program.layout.roots[it->second];
    return offset < root.offset + std::max(1u, types()[root.type].size) ? static_cast<int>(it->second) : -1;
}

/// Types whose storage may overlap other variables: members of unions, located variables, locals of functions (frames
/// are reused). Their fields get no alias node of their own.
void ModuleEmitter::taint() {
    for (size_t t = 0; t < types().count(); ++t) {
        const types::Type& type = types()[types::TypeId(t)];
        if (type.kind == TypeKind::Union)
            for (const types::Field& field : type.fields) taintType(field.type);
    }
    for (const tree::Function& function : program.functions)
        for (const tree::Local& local : function.locals)
            if (!local.isInOut) taintType(local.type);
    const image::Layout& layout = program.layout;
    for (size_t i = 0; i < layout.roots.size(); ++i) {
        const image::Root& root = layout.roots[i];
        // What has an address may be under another name as well (%MW0 and %MB1), bits share bytes.
        const bool isOwn = (root.area == image::Area::Global || root.area == image::Area::Program) &&
                           root.address.empty() && root.bit < 0;
        if (isOwn)
            m_rootsByOffset.push_back({root.offset, i});
        else
            taintType(root.type);
    }
    std::sort(m_rootsByOffset.begin(), m_rootsByOffset.end());
    // Two names of one storage (VAR_ACCESS and such): neither is precise.
    std::vector<std::pair<uint32_t, size_t>> apart;
    for (size_t i = 0; i < m_rootsByOffset.size(); ++i) {
        const auto end = [&](size_t k) {
            return layout.roots[m_rootsByOffset[k].second].offset +
                   types()[layout.roots[m_rootsByOffset[k].second].type].size;
        };
        const bool overlaps = (i > 0 && end(i - 1) > m_rootsByOffset[i].first) ||
                              (i + 1 < m_rootsByOffset.size() && end(i) > m_rootsByOffset[i + 1].first);
        if (overlaps)
            taintType(layout.roots[m_rootsByOffset[i].second].type);
        else
            apart.push_back(m_rootsByOffset[i]);
    }
    m_rootsByOffset = std::move(apart);
}

void ModuleEmitter::taintType(types::TypeId id) {
    const types::Type& type = types()[id];
    if (type.kind == TypeKind::Array || type.kind == TypeKind::OpenArray) return taintType(type.element);
    if (type.kind != TypeKind::Struct && type.kind != TypeKind::Union && type.kind != TypeKind::Block) return;
    // Also ends the recursion: types refer to themselves only by pointers, which are not followed.
    if (!m_tainted.insert(id.value).second) return;
    if (type.base.isValid()) taintType(type.base);
    for (const types::Field& field : type.fields) taintType(field.type);
}

Result<std::unique_ptr<llvm::Module>> emitModule(llvm::LLVMContext& context, const tree::Program& program,
                                                 const ProgramFacts& facts, const Options& options, Part part) {
    return ModuleEmitter(context, program, facts, options, part).emit();
}

} // namespace plc::codegen
