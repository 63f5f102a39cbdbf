#include "runtime/debug/debugger.h"

#include "runtime/base/messages.h"

#include <algorithm>

namespace plc::debug {

namespace {

image::CallRecord entryOf(const image::RuntimeContext& context) {
    return context.depth > 0 ? context.calls[0] : image::CallRecord{};
}
bool isSameEntry(const image::CallRecord& a, const image::CallRecord& b) {
    return a.function == b.function && a.instance == b.instance;
}

} // namespace

Debugger::Debugger(controller::Controller& controller, Compile compile, OnHalt onHalt)
    : m_controller(controller), m_compile(std::move(compile)), m_onHalt(std::move(onHalt)) {
    // The hook is called at flagged statements only; a program without breakpoints pays a byte's look, and only in
    // quick code.
    m_controller.setSiteHook([this](uint32_t site, uint32_t instance, uint32_t) { atSite(site, instance); });
}

Debugger::~Debugger() { m_controller.setSiteHook({}); }

void Debugger::setBreakpoints(std::vector<Breakpoint> breakpoints) {
    m_breakpoints = std::move(breakpoints);
    programChanged();
}

void Debugger::programChanged() {
    const image::CompiledProgram& program = m_controller.program();
    m_active.clear();
    for (size_t i = 0; i < m_breakpoints.size(); ++i) {
        const Breakpoint& breakpoint = m_breakpoints[i];
        if (!breakpoint.isEnabled) continue;
        Active active;
        active.index = i;
        active.sites = sitesOfLine(program, breakpoint.file, breakpoint.line).sites;
        if (!breakpoint.instance.empty()) {
            const Result<image::Place> place = program.layout.find(breakpoint.instance);
            if (!place) continue; // no such instance in this version
            active.instance = place->offset;
        }
        m_active.push_back(std::move(active));
    }
    // A step goes on in the new version: it asks for depth and task, which an online change leaves alone.
    if (m_mode == Mode::ToLine && !m_isHalted) m_mode = Mode::Free; // its line belongs to the version before
    markSites();
}

void Debugger::markSites() {
    const std::span<uint8_t> flags = m_controller.siteFlags();
    // Over and Out cannot mark the statement where they end: which it is depends on calls and conditions. All are
    // asked.
    const bool steps = m_mode == Mode::In || m_mode == Mode::Over || m_mode == Mode::Out;
    std::fill(flags.begin(), flags.end(), uint8_t(steps ? 1 : 0));
    for (const Active& active : m_active)
        for (const uint32_t site : active.sites) flags[site] = 1;
    if (m_mode == Mode::ToLine)
        for (const uint32_t site : m_target) flags[site] = 1;
    // Optimised code has no sites; it comes back as soon as nobody waits for one.
    m_controller.useQuickCode(m_mode != Mode::Free || !m_active.empty());
}

void Debugger::resume() {
    m_mode = Mode::Free;
    markSites();
}

void Debugger::step(Step step) {
    m_mode = step == Step::In ? Mode::In : step == Step::Over ? Mode::Over : Mode::Out;
    if (!m_isHalted) m_mode = Mode::In; // from a running controller: halt at the next statement
    m_fromDepth = m_controller.context().depth;
    m_fromScan = m_controller.nextScan();
    // Task and program by what was called first: the depth alone is the same in another task.
    m_fromEntry = entryOf(m_controller.context());
    markSites();
}

void Debugger::runTo(FileId file, uint32_t line) {
    m_target = sitesOfLine(m_controller.program(), file, line).sites;
    m_mode = m_target.empty() ? Mode::Free : Mode::ToLine;
    markSites();
}

bool Debugger::stepEnds(uint32_t site) const {
    const image::RuntimeContext& context = m_controller.context();
    switch (m_mode) {
    case Mode::Free:
        return false;
    case Mode::In:
        return true;
    case Mode::ToLine:
        return std::find(m_target.begin(), m_target.end(), site) != m_target.end();
    case Mode::Over:
    case Mode::Out:
        break;
    }
    // A step stays in its task's program; when that has ended, it halts at its first statement in the next scan.
    if (!isSameEntry(entryOf(context), m_fromEntry)) return false;
    if (m_controller.nextScan() != m_fromScan) return true;
    return m_mode == Mode::Over ? context.depth <= m_fromDepth : context.depth < m_fromDepth;
}

bool Debugger::conditionHolds(Active& active, uint32_t site, uint32_t instance, Message& problem) {
    const Breakpoint& breakpoint = m_breakpoints[active.index];
    if (breakpoint.condition.empty()) return true;
    auto known = std::find_if(active.conditions.begin(), active.conditions.end(),
                              [&](const auto& entry) { return entry.first == instance; });
    if (known == active.conditions.end()) {
        const image::CompiledProgram& program = m_controller.program();
        const image::FunctionInfo& function = program.functions[program.sites[site].function];
        // Compiled when it is first met, for this instance: "x > 3" means the x of the block that halts.
        const std::string path = instance ? program.layout.pathAt(instance, function.instanceType) : std::string();
        Result<expression::Expression> compiled = m_compile(breakpoint.condition, path);
        if (!compiled) problem = compiled.error().message;
        active.conditions.emplace_back(instance, compiled ? std::move(*compiled) : expression::Expression());
        known = active.conditions.end() - 1;
    }
    if (!known->second.isValid()) {
        if (problem.isEmpty()) problem = errors::ConditionNotEvaluated();
        return true; // halting shows what is wrong; passing in silence would not
    }
    return known->second.isTrue(m_controller.image());
}

std::optional<Halt> Debugger::breakpointHit(uint32_t site, uint32_t instance) {
    std::optional<Halt> hit;
    for (Active& active : m_active) {
        if (std::find(active.sites.begin(), active.sites.end(), site) == active.sites.end()) continue;
        if (active.instance && *active.instance != instance) continue;
        Halt halt;
        if (!conditionHolds(active, site, instance, halt.problem)) continue;
        // All breakpoints of the statement count, also those behind the one that halts.
        ++active.hits;
        if (active.hits < m_breakpoints[active.index].hitCount || hit) continue;
        halt.breakpoint = active.index;
        hit = std::move(halt);
    }
    return hit;
}

void Debugger::atSite(uint32_t site, uint32_t instance) {
    std::optional<Halt> hit = breakpointHit(site, instance);
    if (!hit && !stepEnds(site)) return;
    if (!hit) hit.emplace();
    hit->site = site;
    halt(std::move(*hit));
}

void Debugger::halt(Halt halt) {
    m_mode = Mode::Free;
    m_isHalted = true;
    m_controller.setHalted(true);
    halt.frames = m_controller.callPath(halt.site);
    markSites();
    const std::string place = halt.frames.empty() ? std::string() : halt.frames.front().function;
    m_controller.report(controller::EventKind::Breakpoint,
                        halt.problem.isEmpty() ? errors::Plainly(place) : errors::About(place, halt.problem));
    // Returns when somebody goes on; until then the scan thread serves reads, writes and forces in there (D8).
    const Going going = m_onHalt(halt);
    m_isHalted = false;
    m_controller.setHalted(false);
    if (going == Going::Abandon) {
        m_mode = Mode::Free;
        markSites();
        m_controller.abandonScan();
    }
}

} // namespace plc::debug
