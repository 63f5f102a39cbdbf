#include "runtime/base/messages.h"
#include "runtime/compiler/driver/driver.h"
#include "runtime/compiler/driver/keeps_analysis.h"
#include "runtime/compiler/facts/program_facts.h"
#include "runtime/compiler/jit/jit.h"

namespace plc::driver {

namespace {

const sema::Analysis* analysisOf(const std::shared_ptr<const image::CompiledProgram>& program) {
    const auto* owner = std::get_deleter<KeepsAnalysis>(program);
    return owner ? owner->analysis.get() : nullptr;
}

} // namespace

const tree::Program* treeOf(const std::shared_ptr<const image::CompiledProgram>& program) {
    const sema::Analysis* analysis = analysisOf(program);
    return analysis ? analysis->program.get() : nullptr;
}

Checked checkedOf(const std::shared_ptr<const image::CompiledProgram>& program) {
    const auto* owner = std::get_deleter<KeepsAnalysis>(program);
    if (!owner) return {};
    return {std::make_shared<const SourceSet>(program->sources), owner->analysis};
}

namespace {

/// The functions and all that can call them, directly or through others.
std::vector<bool> withCallers(const tree::Program& tree, const std::vector<uint32_t>& functions) {
    const size_t count = tree.functions.size();
    std::vector<bool> wanted(count, functions.empty());
    if (functions.empty()) return wanted;
    const facts::ProgramFacts facts(tree, facts::Tier::Quick);
    std::vector<std::vector<uint32_t>> callers(count);
    for (uint32_t f = 1; f < count; ++f)
        for (const uint32_t callee : facts[f].callees) callers[callee].push_back(f);
    std::vector<uint32_t> work;
    const auto add = [&](uint32_t f) {
        if (f == 0 || f >= count || wanted[f]) return;
        wanted[f] = true;
        work.push_back(f);
    };
    for (const uint32_t f : functions) add(f);
    while (!work.empty()) {
        const uint32_t f = work.back();
        work.pop_back();
        for (const uint32_t caller : callers[f]) add(caller);
    }
    return wanted;
}

} // namespace

Result<std::shared_ptr<const image::Code>> compileWatched(const std::shared_ptr<const image::CompiledProgram>& program,
                                                          const std::vector<uint32_t>& functions, Progress* progress) {
    const tree::Program* tree = treeOf(program);
    if (!tree || !program->quick) return Error{errors::NotBuiltFromSources(), {}};
    return jit::compileWatched(*tree, withCallers(*tree, functions), program->quick, progress);
}

} // namespace plc::driver
