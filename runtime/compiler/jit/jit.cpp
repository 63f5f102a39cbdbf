#include "runtime/compiler/jit/jit.h"

#include "runtime/library/text_runtime.h"

#include <llvm/ExecutionEngine/Orc/CompileUtils.h>
#include <llvm/ExecutionEngine/Orc/ExecutionUtils.h>
#include <llvm/ExecutionEngine/Orc/LLJIT.h>
#include <llvm/IR/Verifier.h>
#include <llvm/Passes/PassBuilder.h>
#include <llvm/Support/TargetSelect.h>
#include <llvm/Target/TargetMachine.h>
#include <llvm/Transforms/Instrumentation/ThreadSanitizer.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <mutex>

namespace plc::jit {

namespace {

image::RuntimeSymbols g_symbols; // set once at start-up, before the first compile

int32_t compareBytes(const void* a, const void* b, uint32_t size) { return std::memcmp(a, b, size); }

struct Symbol {
    const char* name;
    void* address;
};

template <class Function> void* addressOf(Function* function) { return reinterpret_cast<void*>(function); }

#define PLC_MATH1(Name) {"plc_" #Name, addressOf<double(double)>(&::Name)}, {"plc_" #Name "f", addressOf<float(float)>(&::Name##f)}
#define PLC_MATH2(Name) {"plc_" #Name, addressOf<double(double, double)>(&::Name)}, {"plc_" #Name "f", addressOf<float(float, float)>(&::Name##f)}
// What LLVM itself may call where the processor has no instruction for it.
#define PLC_OWN1(Name) {#Name, addressOf<double(double)>(&::Name)}, {#Name "f", addressOf<float(float)>(&::Name##f)}

const Symbol kMath[] = {
    PLC_MATH1(log),   PLC_MATH1(log10), PLC_MATH1(exp),  PLC_MATH1(sin),  PLC_MATH1(cos),   PLC_MATH1(tan), PLC_MATH1(asin), PLC_MATH1(acos), PLC_MATH1(atan),
    PLC_MATH1(sinh),  PLC_MATH1(cosh),  PLC_MATH1(tanh), PLC_MATH2(pow),  PLC_MATH2(atan2), PLC_MATH2(fmod),
    PLC_OWN1(floor),  PLC_OWN1(ceil),   PLC_OWN1(trunc), PLC_OWN1(sqrt),  PLC_OWN1(fabs),   PLC_OWN1(rint), PLC_OWN1(nearbyint),
};
#undef PLC_MATH1
#undef PLC_MATH2
#undef PLC_OWN1

// roundeven is missing in older C libraries; the rounding mode is always to nearest even.
double roundEven(double value) { return std::nearbyint(value); }
float roundEvenSingle(float value) { return std::nearbyintf(value); }

void initialiseTargets() {
    static std::once_flag once;
    std::call_once(once, [] {
        llvm::InitializeNativeTarget();
        llvm::InitializeNativeTargetAsmPrinter();
        llvm::InitializeNativeTargetAsmParser();
    });
}

Error failed(llvm::Error error) { return Error{"The code generator failed: " + llvm::toString(std::move(error)), ""}; }

llvm::orc::SymbolMap runtimeSymbols(llvm::orc::LLJIT& jit) {
    llvm::orc::SymbolMap map;
    const auto add = [&](llvm::StringRef name, void* address) {
        map[jit.mangleAndIntern(name)] = {llvm::orc::ExecutorAddr::fromPtr(address), llvm::JITSymbolFlags::Exported | llvm::JITSymbolFlags::Callable};
    };
    for (const Symbol& symbol : kMath) add(symbol.name, symbol.address);
    for (const library::RuntimeSymbol& symbol : library::runtimeSymbols()) add(llvm::StringRef(symbol.name.data(), symbol.name.size()), symbol.address);
    add("roundeven", addressOf(&roundEven));
    add("roundevenf", addressOf(&roundEvenSingle));
    add("plc_compare_bytes", addressOf(&compareBytes));
    add("plc_fault", addressOf(g_symbols.fault));
    add("plc_budget_used_up", addressOf(g_symbols.budgetUsedUp));
    add("plc_at_site", addressOf(g_symbols.atSite));
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

void optimise(llvm::Module& module, llvm::TargetMachine& machine) {
    llvm::PipelineTuningOptions tuning;
    tuning.LoopVectorization = true;
    tuning.SLPVectorization = true;
    llvm::PassBuilder builder(&machine, tuning);
    llvm::LoopAnalysisManager loops;
    llvm::FunctionAnalysisManager functions;
    llvm::CGSCCAnalysisManager sccs;
    llvm::ModuleAnalysisManager modules;
    builder.registerModuleAnalyses(modules);
    builder.registerCGSCCAnalyses(sccs);
    builder.registerFunctionAnalyses(functions);
    builder.registerLoopAnalyses(loops);
    builder.crossRegisterProxies(loops, functions, sccs, modules);
    llvm::ModulePassManager passes = builder.buildPerModuleDefaultPipeline(llvm::OptimizationLevel::O2);
    passes.run(module, modules);
}

/// STEPWISE_DUMP_IR=folder writes what the tiers made, for looking at kernels.
void dump(const llvm::Module& module, const char* name) {
    const char* folder = std::getenv("STEPWISE_DUMP_IR");
    if (!folder) return;
    std::error_code error;
    llvm::raw_fd_ostream out(std::string(folder) + "/" + name + ".ll", error);
    if (!error) module.print(out, nullptr);
}

} // namespace

void setRuntimeSymbols(const image::RuntimeSymbols& symbols) { g_symbols = symbols; }

Result<std::shared_ptr<const image::Code>> compile(const tree::Program& program, const codegen::DebugMap& debug, const codegen::Options& options) {
    initialiseTargets();
    const bool isQuick = options.tier == codegen::Tier::Quick;
    auto machineBuilder = llvm::orc::JITTargetMachineBuilder::detectHost();
    if (!machineBuilder) return failed(machineBuilder.takeError());
    machineBuilder->setCodeGenOptLevel(isQuick ? llvm::CodeGenOptLevel::None : llvm::CodeGenOptLevel::Default);
    machineBuilder->getOptions().EnableFastISel = isQuick;
    machineBuilder->getOptions().AllowFPOpFusion = llvm::FPOpFusion::Strict; // a * b + c rounds twice, in every tier
    auto machine = machineBuilder->createTargetMachine();
    if (!machine) return failed(machine.takeError());

    auto context = std::make_unique<llvm::LLVMContext>();
    context->setDiscardValueNames(isQuick);
    std::unique_ptr<llvm::Module> module = codegen::emitModule(*context, program, debug, options);
    module->setDataLayout((*machine)->createDataLayout());
    module->setTargetTriple((*machine)->getTargetTriple().str());
    dump(*module, isQuick ? "quick" : "plain");
#ifndef NDEBUG
    std::string broken;
    llvm::raw_string_ostream stream(broken);
    if (llvm::verifyModule(*module, &stream)) return Error{"The code generator made a broken module: " + stream.str(), ""};
#endif
    if (options.threadSanitizer) instrument(*module, **machine);
    if (!isQuick) optimise(*module, **machine);
    if (!isQuick) dump(*module, "optimised");

    llvm::orc::LLJITBuilder builder;
    builder.setJITTargetMachineBuilder(std::move(*machineBuilder));
    auto jit = builder.create();
    if (!jit) return failed(jit.takeError());
    llvm::orc::JITDylib& library = (*jit)->getMainJITDylib();
    if (options.threadSanitizer) {
        auto process = llvm::orc::DynamicLibrarySearchGenerator::GetForCurrentProcess((*jit)->getDataLayout().getGlobalPrefix());
        if (process) library.addGenerator(std::move(*process));
        else llvm::consumeError(process.takeError());
    }
    if (auto error = library.define(llvm::orc::absoluteSymbols(runtimeSymbols(**jit)))) return failed(std::move(error));

    std::vector<uint32_t> entries;
    for (const llvm::Function& function : *module) {
        llvm::StringRef name = function.getName();
        uint32_t index = 0;
        if (name.consume_front("plc.entry.") && !name.getAsInteger(10, index)) entries.push_back(index);
    }
    if (auto error = (*jit)->addIRModule(llvm::orc::ThreadSafeModule(std::move(module), std::move(context)))) return failed(std::move(error));
    auto code = std::make_shared<image::Code>();
    code->hasSites = isQuick;
    code->entries.resize(program.functions.size(), nullptr);
    for (const uint32_t index : entries) {
        auto address = (*jit)->lookup("plc.entry." + std::to_string(index));
        if (!address) return failed(address.takeError());
        code->entries[index] = address->toPtr<image::Entry>();
    }
    code->keepAlive = std::shared_ptr<llvm::orc::LLJIT>(std::move(*jit));
    return std::shared_ptr<const image::Code>(std::move(code));
}

} // namespace plc::jit
