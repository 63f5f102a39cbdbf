#include "runtime/compiler/jit/jit.h"
#include "runtime/base/messages.h"

#include "runtime/compiler/facts/program_facts.h"
#include "runtime/compiler/jit/object_code.h"
#include "runtime/compiler/jit/stack_use.h"
#include "runtime/compiler/jit/write_marks.h"
#include "runtime/image/written_pages.h"
#include "runtime/library/text_runtime.h"

#include <llvm/ExecutionEngine/Orc/CompileUtils.h>
#include <llvm/ExecutionEngine/Orc/ExecutionUtils.h>
#include <llvm/ExecutionEngine/Orc/LLJIT.h>
#include <llvm/IR/Verifier.h>
#include <llvm/Passes/PassBuilder.h>
#include <llvm/Support/CommandLine.h>
#include <llvm/Support/DynamicLibrary.h>
#include <llvm/Support/TargetSelect.h>
#include <llvm/Target/TargetMachine.h>
#include <llvm/Transforms/Instrumentation/ThreadSanitizer.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <thread>

namespace plc::jit {

namespace {

image::RuntimeSymbols g_symbols; // set once at start-up, before the first compile

int32_t compareBytes(const void* a, const void* b, uint32_t size) { return std::memcmp(a, b, size); }

struct Symbol {
    const char* name;
    void* address;
};

template <class Function> void* addressOf(Function* function) { return reinterpret_cast<void*>(function); }

// Functions of the C library under names LLVM does not know: those that intrinsics are, and the remainder.
#define PLC_MATH1(Name, function)                                                                                      \
    {"plc_" #function, addressOf<double(double)>(&::function)},                                                        \
        {"plc_" #function "f", addressOf<float(float)>(&::function##f)},
#define PLC_MATH2(Name, function)                                                                                      \
    {"plc_" #function, addressOf<double(double, double)>(&::function)},                                                \
        {"plc_" #function "f", addressOf<float(float, float)>(&::function##f)},
// What LLVM itself may call where the processor has no instruction for it.
#define PLC_OWN1(Name)                                                                                                 \
    {#Name, addressOf<double(double)>(&::Name)}, { #Name "f", addressOf < float(float)>(&::Name##f) }

const Symbol kMath[] = {
    {"plc_fmod", addressOf<double(double, double)>(&::fmod)},
    {"plc_fmodf", addressOf<float(float, float)>(&::fmodf)},
    PLC_OWN1(floor),
    PLC_OWN1(ceil),
    PLC_OWN1(trunc),
    PLC_OWN1(sqrt),
    PLC_OWN1(fabs),
    PLC_OWN1(rint),
    PLC_OWN1(nearbyint),
#include "runtime/library/intrinsic_meanings.def"
};
#undef PLC_OWN1

// roundeven is missing in older C libraries; the rounding mode is always to nearest even.
double roundEven(double value) { return std::nearbyint(value); }
float roundEvenSingle(float value) { return std::nearbyintf(value); }

/// What a PLC program decides seldom changes from one scan to the next: in a chain of dependent results a well
/// predicted branch beats a select, which always waits for its condition (limits and dead bands of controllers). LLVM
/// has these as options only, as the reach of its search for earlier stores.
void preferBranches() {
    const char* const words[] = {
        "stepwise",
        "-disable-select-optimize=false",
        "-mispredict-default-rate=2",
        "-select-opti-loop-cycle-gain-threshold=1",
        "-select-opti-loop-relative-gain-threshold=20",
        "-select-opti-loop-gradient-gain-threshold=10",
        "-memdep-block-number-limit=50"}; // a third of the time of large programs for nothing measurable
    llvm::raw_null_ostream nowhere;       // an LLVM without one of them goes on as it is
    llvm::cl::ParseCommandLineOptions(static_cast<int>(std::size(words)), words, "", &nowhere);
}

void initialiseTargets() {
    static std::once_flag once;
    std::call_once(once, [] {
        llvm::InitializeNativeTarget();
        llvm::InitializeNativeTargetAsmPrinter();
        llvm::InitializeNativeTargetAsmParser();
        // Of those that `stepwise build` makes code for.
        LLVMInitializeX86TargetInfo();
        LLVMInitializeX86Target();
        LLVMInitializeX86TargetMC();
        LLVMInitializeX86AsmPrinter();
        LLVMInitializeX86AsmParser();
        LLVMInitializeAArch64TargetInfo();
        LLVMInitializeAArch64Target();
        LLVMInitializeAArch64TargetMC();
        LLVMInitializeAArch64AsmPrinter();
        LLVMInitializeAArch64AsmParser();
        preferBranches();
    });
}

Error failed(llvm::Error error) { return Error{errors::CodeGeneratorFailed(llvm::toString(std::move(error))), ""}; }

llvm::orc::SymbolMap runtimeSymbols(llvm::orc::LLJIT& jit) {
    llvm::orc::SymbolMap map;
    const auto add = [&](llvm::StringRef name, void* address) {
        map[jit.mangleAndIntern(name)] = {llvm::orc::ExecutorAddr::fromPtr(address),
                                          llvm::JITSymbolFlags::Exported | llvm::JITSymbolFlags::Callable};
    };
    for (const Symbol& symbol : kMath) add(symbol.name, symbol.address);
    for (const library::RuntimeSymbol& symbol : library::runtimeSymbols())
        add(llvm::StringRef(symbol.name.data(), symbol.name.size()), symbol.address);
    add("roundeven", addressOf(&roundEven));
    add("roundevenf", addressOf(&roundEvenSingle));
    add("plc_compare_bytes", addressOf(&compareBytes));
    add("plc_mark_written", addressOf(&image::markWritten));
    add("plc_fault", addressOf(g_symbols.fault));
    add("plc_budget_used_up", addressOf(g_symbols.budgetUsedUp));
    add("plc_at_site", addressOf(g_symbols.atSite));
    add("plc_protect", addressOf(g_symbols.protect));
    add("memcpy", addressOf<void*(void*, const void*, size_t)>(&std::memcpy));
    add("memmove", addressOf<void*(void*, const void*, size_t)>(&std::memmove));
    add("memset", addressOf<void*(void*, int, size_t)>(&std::memset));
    add("bcmp", addressOf<int(const void*, const void*, size_t)>(&std::memcmp));
    return map;
}

void instrument(llvm::Module& module, llvm::TargetMachine& machine) {
    llvm::PassBuilder builder(&machine);
    llvm::LoopAnalysisManager loops;
    llvm::FunctionAnalysisManager functions;
    llvm::CGSCCAnalysisManager sccs;
    llvm::ModuleAnalysisManager modules;
    builder.registerModuleAnalyses(modules);
    builder.registerCGSCCAnalyses(sccs);
    builder.registerFunctionAnalyses(functions);
    builder.registerLoopAnalyses(loops);
    builder.crossRegisterProxies(loops, functions, sccs, modules);
    llvm::FunctionPassManager passes;
    passes.addPass(llvm::ThreadSanitizerPass());
    llvm::ModulePassManager all;
    all.addPass(llvm::createModuleToFunctionPassAdaptor(std::move(passes)));
    all.run(module, modules);
}

/// How far the parts of a program have come together; each is several steps.
class Steps {
public:
    Steps(const codegen::Options& options, uint32_t count)
        : m_progress(options.progress), m_from(options.progressFrom), m_count(count) {}
    /// So many more steps are done; false when the work is to end.
    bool done(double steps) {
        const double all = m_done.fetch_add(steps, std::memory_order_relaxed) + steps;
        return goesOn(m_progress, m_from + (1 - m_from) * all / m_count);
    }
    [[nodiscard]] bool isCancelled() const { return plc::isCancelled(m_progress); }

private:
    Progress* m_progress;
    double m_from;
    uint32_t m_count;
    std::atomic<double> m_done{0};
};
constexpr uint32_t kEmitSteps = 2, kOptimiseSteps = 5, kObjectSteps = 3;

/// Cancelled, the passes that are left do nothing.
void optimise(llvm::Module& module, llvm::TargetMachine& machine, Steps& steps) {
    constexpr double kLooksPerFunction = 8; // of the pass that the pipeline asks most often
    const auto functions = static_cast<double>(std::max<size_t>(1, module.size()));
    double looks = 0;
    llvm::PassInstrumentationCallbacks callbacks;
    callbacks.registerShouldRunOptionalPassCallback(
        [&steps](llvm::StringRef, const llvm::Any&) { return !steps.isCancelled(); });
    callbacks.registerAfterPassCallback([&](llvm::StringRef pass, const llvm::Any&, const llvm::PreservedAnalyses&) {
        if (pass != "InstCombinePass" || ++looks > kLooksPerFunction * functions) return;
        (void)steps.done(kOptimiseSteps / (kLooksPerFunction * functions));
    });
    llvm::PipelineTuningOptions tuning;
    tuning.LoopVectorization = true;
    tuning.SLPVectorization = true;
    llvm::PassBuilder builder(&machine, tuning, std::nullopt, &callbacks);
    llvm::LoopAnalysisManager loops;
    llvm::FunctionAnalysisManager ofFunctions;
    llvm::CGSCCAnalysisManager sccs;
    llvm::ModuleAnalysisManager modules;
    builder.registerModuleAnalyses(modules);
    builder.registerCGSCCAnalyses(sccs);
    builder.registerFunctionAnalyses(ofFunctions);
    builder.registerLoopAnalyses(loops);
    builder.crossRegisterProxies(loops, ofFunctions, sccs, modules);
    llvm::ModulePassManager passes = builder.buildPerModuleDefaultPipeline(llvm::OptimizationLevel::O2);
    passes.run(module, modules);
}

/// STEPWISE_DUMP_IR=folder writes what the tiers made, for looking at kernels.
void dump(const llvm::Module& module, const std::string& name) {
    const char* folder = std::getenv("STEPWISE_DUMP_IR");
    if (!folder) return;
    std::error_code error;
    llvm::raw_fd_ostream out(std::string(folder) + "/" + name + ".ll", error);
    if (!error) module.print(out, nullptr);
}

} // namespace

void setRuntimeSymbols(const image::RuntimeSymbols& symbols) { g_symbols = symbols; }

namespace {

using Object = std::unique_ptr<llvm::MemoryBuffer>;

/// Processor of this machine, options of the tier.
llvm::Expected<llvm::orc::JITTargetMachineBuilder> machineFor(bool isQuick) {
    auto builder = llvm::orc::JITTargetMachineBuilder::detectHost();
    if (!builder) return builder;
    builder->setCodeGenOptLevel(isQuick ? llvm::CodeGenOptLevel::None : llvm::CodeGenOptLevel::Default);
    if (isQuick) { // the large code model would keep every call from fast instruction selection; the linker makes stubs
                   // instead
        builder->setRelocationModel(llvm::Reloc::PIC_);
        builder->setCodeModel(llvm::CodeModel::Small);
    } else { // jump tables of whole addresses: a CASE costs one load less
        builder->setRelocationModel(llvm::Reloc::Static);
        builder->setCodeModel(llvm::CodeModel::Large);
    }
    builder->getOptions().EnableFastISel = isQuick;
    builder->getOptions().AllowFPOpFusion = llvm::FPOpFusion::Strict; // a * b + c rounds twice, in every tier
    return builder;
}

using Machine = std::unique_ptr<llvm::TargetMachine>;

llvm::Expected<Machine> machineHere(bool isQuick) {
    auto builder = machineFor(isQuick);
    if (!builder) return builder.takeError();
    return builder->createTargetMachine();
}

/// For a program that is linked once, without a loader.
llvm::Expected<Machine> machineThere(const ObjectFor& wanted) {
    llvm::orc::JITTargetMachineBuilder builder{llvm::Triple(wanted.triple)};
    builder.setCPU(wanted.cpu);
    builder.setCodeGenOptLevel(llvm::CodeGenOptLevel::Default);
    builder.setRelocationModel(llvm::Reloc::Static);
    builder.setCodeModel(llvm::CodeModel::Small);
    builder.getOptions().AllowFPOpFusion = llvm::FPOpFusion::Strict;
    return builder.createTargetMachine();
}

/// The bytes that an object file carries beside the code.
void addData(llvm::Module& module, const ObjectFor& wanted) {
    const auto add = [&](const std::string& name, llvm::Constant* value) {
        auto* global = llvm::cast<llvm::GlobalVariable>(module.getOrInsertGlobal(name, value->getType()));
        global->setInitializer(value);
        global->setConstant(true);
    };
    add(wanted.dataName, llvm::ConstantDataArray::getString(module.getContext(), wanted.data, false));
    add(wanted.dataName + "_size",
        llvm::ConstantInt::get(llvm::Type::getInt64Ty(module.getContext()), wanted.data.size()));
}

/// "plc.f.7", "plc.entry.7" → the name of function 7.
std::string functionName(const tree::Program& program, const std::string& symbol) {
    const size_t number = std::strtoul(symbol.c_str() + symbol.rfind('.') + 1, nullptr, 10);
    return number < program.functions.size() ? program.functions[number].name : symbol;
}

/// Tree → object file, on any thread: nothing is shared but the tree and what is known about it.
Result<Object> compilePart(const tree::Program& program, const facts::ProgramFacts& facts,
                           const codegen::Options& options, codegen::Part part, Steps& steps,
                           const ObjectFor* elsewhere = nullptr) {
    const Error cancelled{errors::Cancelled(), ""};
    const bool isQuick = options.tier == codegen::Tier::Quick;
    auto machine = elsewhere ? machineThere(*elsewhere) : machineHere(isQuick);
    if (!machine) return failed(machine.takeError());
    llvm::LLVMContext context;
    context.setDiscardValueNames(isQuick);
    const StackUse stack(context);
    auto emitted = codegen::emitModule(context, program, facts, options, part);
    if (!emitted) return emitted.error();
    const std::unique_ptr<llvm::Module> module = std::move(*emitted);
    if (!steps.done(kEmitSteps)) return cancelled;
    module->setDataLayout((*machine)->createDataLayout());
    module->setTargetTriple((*machine)->getTargetTriple().str());
    dump(*module, isQuick ? "quick" + std::to_string(part.index) : "plain");
#ifndef NDEBUG
    std::string broken;
    llvm::raw_string_ostream stream(broken);
    if (llvm::verifyModule(*module, &stream)) return Error{errors::CodeGeneratorBroken(stream.str()), ""};
#endif
    if (options.threadSanitizer) instrument(*module, **machine);
    const bool marks = marksWrites(program.layout);
    if (!isQuick && marks) keepImageArguments(*module);
    if (!isQuick) optimise(*module, **machine, steps);
    if (steps.isCancelled()) return cancelled;
    if (marks) markWrites(*module, program.layout.imageSize);
    if (!isQuick) dump(*module, "optimised");
    if (elsewhere) addData(*module, *elsewhere);
    auto object = llvm::orc::SimpleCompiler(**machine)(*module);
    if (!object) return failed(object.takeError());
    (void)steps.done(kObjectSteps);
    bool isBounded = true;
    for (const StackUse::Frame& frame : stack.large()) {
        if (frame.bytes > kMaximumStackFrame)
            return Error{errors::StackFrameTooLarge(functionName(program, frame.function)), ""};
        isBounded = isBounded && frame.isGuarded;
    }
    if (!isBounded && !options.guardsEveryStack) { // inlining made a large frame: the same again, with more questions
        codegen::Options careful = options;
        careful.guardsEveryStack = true;
        return compilePart(program, facts, careful, part, steps, elsewhere);
    }
    return std::move(*object);
}

/// Quick code of large programs is made by several threads; optimised code is one module, so that everything can be
/// inlined.
uint32_t partsFor(const tree::Program& program, const codegen::Options& options) {
    constexpr size_t kFunctionsPerPart = 40;
    if (options.tier != codegen::Tier::Quick) return 1;
    const size_t wanted = program.functions.size() / kFunctionsPerPart + 1;
    return static_cast<uint32_t>(std::min<size_t>({wanted, std::max(1u, std::thread::hardware_concurrency()), 8}));
}

std::vector<Result<Object>> compileParts(const tree::Program& program, const facts::ProgramFacts& facts,
                                         const codegen::Options& options, uint32_t count) {
    std::vector<Result<Object>> objects;
    const bool isQuick = options.tier == codegen::Tier::Quick;
    Steps steps(options, count * (kEmitSteps + (isQuick ? 0 : kOptimiseSteps) + kObjectSteps));
    for (uint32_t i = 0; i < count; ++i) objects.push_back(Error{errors::NotCompiled(), ""});
    std::vector<std::thread> threads;
    for (uint32_t i = 1; i < count; ++i)
        threads.emplace_back([&, i] { objects[i] = compilePart(program, facts, options, {i, count}, steps); });
    objects[0] = compilePart(program, facts, options, {0, count}, steps);
    for (std::thread& thread : threads) thread.join();
    return objects;
}

struct EntryRow {
    uint64_t function;
    image::Entry code;
};

} // namespace

namespace {

/// The functions that watched code does not hold itself lie in the quick code.
llvm::Error defineQuickFunctions(llvm::orc::LLJIT& jit, const tree::Program& program, const std::vector<bool>& only,
                                 const image::Code& quick) {
    auto& from = *static_cast<llvm::orc::LLJIT*>(quick.keepAlive.get());
    llvm::orc::SymbolMap map;
    for (uint32_t f = 1; f < program.functions.size(); ++f) {
        if (only[f] || program.functions[f].isAbstract) continue;
        const std::string name = "plc.f." + std::to_string(f);
        auto address = from.lookup(name);
        if (!address) return address.takeError();
        map[jit.mangleAndIntern(name)] = {*address, llvm::JITSymbolFlags::Exported | llvm::JITSymbolFlags::Callable};
    }
    if (map.empty()) return llvm::Error::success();
    return jit.getMainJITDylib().define(llvm::orc::absoluteSymbols(std::move(map)));
}

/// What watched code needs beside itself.
struct QuickCode {
    std::shared_ptr<const image::Code> code;
    std::shared_ptr<llvm::orc::LLJIT> jit;
};

Result<std::shared_ptr<const image::Code>> compileOver(const tree::Program& program, const codegen::Options& options,
                                                       const std::shared_ptr<const image::Code>& quick) {
    initialiseTargets();
    const bool isQuick = options.tier == codegen::Tier::Quick;
    auto machine = machineFor(isQuick);
    if (!machine) return failed(machine.takeError());
    llvm::orc::LLJITBuilder builder;
    builder.setJITTargetMachineBuilder(std::move(*machine));
    auto jit = builder.create();
    if (!jit) return failed(jit.takeError());
    llvm::orc::JITDylib& library = (*jit)->getMainJITDylib();
    if (options.threadSanitizer) {
        if (!llvm::sys::DynamicLibrary::SearchForAddressOfSymbol("__tsan_func_entry"))
            return Error{errors::ThreadSanitizerNeeded(), ""};
        auto process =
            llvm::orc::DynamicLibrarySearchGenerator::GetForCurrentProcess((*jit)->getDataLayout().getGlobalPrefix());
        if (process)
            library.addGenerator(std::move(*process));
        else
            llvm::consumeError(process.takeError());
    }
    if (auto error = library.define(llvm::orc::absoluteSymbols(runtimeSymbols(**jit)))) return failed(std::move(error));

    if (quick)
        if (auto error = defineQuickFunctions(**jit, program, *options.only, *quick)) return failed(std::move(error));
    const facts::ProgramFacts facts(program, options.tier);
    if (auto fits = facts.fits(); !fits) return fits.error();
    const uint32_t parts = partsFor(program, options);
    for (Result<Object>& object : compileParts(program, facts, options, parts)) {
        if (!object) return object.error();
        if (auto error = (*jit)->addObjectFile(std::move(*object))) return failed(std::move(error));
    }
    auto code = std::make_shared<image::Code>();
    code->hasSites = isQuick;
    code->marksWrites = marksWrites(program.layout);
    if (quick) code->entries = quick->entries;
    code->entries.resize(program.functions.size(), nullptr);
    for (uint32_t part = 0; part < parts; ++part) {
        auto table = (*jit)->lookup("plc.entries." + std::to_string(part));
        if (!table) return failed(table.takeError());
        for (const EntryRow* row = table->toPtr<const EntryRow*>(); row->function != 0; ++row)
            code->entries[row->function] = row->code;
    }
    std::shared_ptr<llvm::orc::LLJIT> own(std::move(*jit));
    if (quick)
        code->keepAlive = std::make_shared<QuickCode>(QuickCode{quick, std::move(own)});
    else
        code->keepAlive = std::move(own);
    return std::shared_ptr<const image::Code>(std::move(code));
}

} // namespace

Result<std::shared_ptr<const image::Code>> compile(const tree::Program& program, const codegen::Options& options) {
    return compileOver(program, options, nullptr);
}

Result<std::shared_ptr<const image::Code>> compileWatched(const tree::Program& program, const std::vector<bool>& only,
                                                          std::shared_ptr<const image::Code> quick,
                                                          Progress* progress) {
    codegen::Options options;
    options.watched = true;
    options.only = &only;
    options.progress = progress;
    return compileOver(program, options, quick);
}

Result<std::string> compileObject(const tree::Program& program, const ObjectFor& wanted) {
    initialiseTargets();
    codegen::Options options;
    options.tier = codegen::Tier::Optimised;
    const facts::ProgramFacts facts(program, options.tier);
    if (auto fits = facts.fits(); !fits) return fits.error();
    Steps steps(options, kEmitSteps + kOptimiseSteps + kObjectSteps);
    auto object = compilePart(program, facts, options, {}, steps, &wanted);
    if (!object) return object.error();
    return (*object)->getBuffer().str();
}

} // namespace plc::jit
