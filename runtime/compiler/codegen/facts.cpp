#include "runtime/compiler/codegen/facts.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace plc::codegen {

using tree::Expr;
using tree::ExprKind;
using tree::Function;
using tree::Local;
using tree::LocalKind;
using tree::Place;
using tree::PlaceKind;
using tree::Stmt;
using tree::StmtKind;
using types::TypeKind;

namespace {
uint32_t aligned(uint32_t offset, uint32_t align) { return (offset + align - 1) / align * align; }

bool isScalar(const types::TypeTable& types, types::TypeId type) {
    return !types.isAggregate(type) && !types.isText(type) && types.kind(type) != TypeKind::OpenArray;
}
} // namespace

uint32_t slotSize(const types::TypeTable& types, const Local& local) {
    if (!local.isInOut) return std::max(1u, types[local.type].size);
    return types.kind(local.type) == TypeKind::OpenArray ? types[local.type].size : 8;
}

FrameLayout layFrameOut(const types::TypeTable& types, const Function& function, const std::vector<bool>& inMemory) {
    FrameLayout layout;
    layout.offsets.assign(function.locals.size(), kNoFrame);
    const auto place = [&](size_t i) {
        if (layout.offsets[i] != kNoFrame || !inMemory[i]) return;
        const Local& local = function.locals[i];
        const uint32_t align = local.isInOut ? 8 : std::max(1u, types[local.type].align);
        layout.size = aligned(layout.size, align);
        layout.offsets[i] = layout.size;
        layout.size += slotSize(types, local);
    };
    const auto isShared = [&](size_t i) {
        return !function.locals[i].isInOut && !isScalar(types, function.locals[i].type);
    };
    const uint32_t result = function.resultLocal;
    if (result < function.locals.size() && isShared(result)) place(result);
    for (size_t i = 0; i < function.locals.size(); ++i)
        if ((function.locals[i].kind == LocalKind::Input || function.locals[i].kind == LocalKind::Output) &&
            isShared(i))
            place(i);
    for (size_t i = 0; i < function.locals.size(); ++i) place(i);
    layout.size = aligned(layout.size, 16);
    return layout;
}

// ---------------------------------------------------------------- sites

namespace {
bool isPlaced(const Stmt& stmt) { return stmt.range.file.isValid(); }

class SiteCollector : public Walker {
public:
    struct Found {
        const Stmt* stmt;
        bool stops;
    };
    std::vector<Found> visible;
    std::vector<const Stmt*> hidden;

protected:
    void onStmt(const Stmt& stmt) override {
        const Stmt* const before = m_before; // the sibling in front
        m_parents.push_back(&stmt);
        m_before = nullptr;
        if (!isPlaced(stmt) || stmt.kind == StmtKind::Label) return;
        if (stmt.isHidden) {
            hidden.push_back(&stmt);
            return;
        }
        if (stmt.kind == StmtKind::Block && !standsForOne(stmt)) return;
        bool isRepeated = before && before->range == stmt.range && !before->isHidden;
        for (size_t i = 0; i + 1 < m_parents.size(); ++i)
            isRepeated = isRepeated || (m_parents[i]->range == stmt.range && !m_parents[i]->isHidden);
        visible.push_back({&stmt, !isRepeated});
    }
    void afterStmt(const Stmt& stmt) override {
        m_parents.pop_back();
        m_before = &stmt;
    }

private:
    static bool standsForOne(const Stmt& block) {
        return std::any_of(block.body.begin(), block.body.end(),
                           [&](const Stmt* s) { return s && !s->isHidden && s->range == block.range; });
    }
    std::vector<const Stmt*> m_parents;
    const Stmt* m_before = nullptr;
};

using RangeKey = std::tuple<uint32_t, uint32_t, uint32_t>;
RangeKey keyOf(const SourceRange& range) { return {range.file.value, range.begin, range.end}; }
} // namespace

SiteTable::SiteTable(const tree::Program& program) : sites(1) {
    for (uint32_t f = 1; f < program.functions.size(); ++f) {
        SiteCollector collector;
        collector.walkFunction(program.functions[f]);
        std::map<RangeKey, uint32_t> byRange;
        const auto siteFor = [&](const Stmt& stmt) {
            const auto [it, isNew] = byRange.emplace(keyOf(stmt.range), static_cast<uint32_t>(sites.size()));
            if (isNew) sites.push_back({f, stmt.range});
            return it->second;
        };
        for (const SiteCollector::Found& found : collector.visible)
            m_places[found.stmt] = {siteFor(*found.stmt), found.stops};
        // Made statements belong to the text they stand for, or else to the narrowest statement around: faults in them
        // are shown there.
        for (const Stmt* stmt : collector.hidden) {
            uint32_t best = 0;
            if (const auto it = byRange.find(keyOf(stmt->range)); it != byRange.end()) {
                best = it->second;
            } else {
                for (auto around = byRange.upper_bound({stmt->range.file.value, stmt->range.begin, UINT32_MAX});
                     around != byRange.begin();) {
                    --around;
                    const auto [file, begin, end] = around->first;
                    if (file != stmt->range.file.value) break;
                    if (end < stmt->range.end) continue;
                    best = around->second; // the last to begin in front of it and hold it
                    break;
                }
            }
            m_places[stmt] = {best != 0 ? best : siteFor(*stmt), false};
        }
    }
}

SiteTable::Place SiteTable::at(const Stmt& stmt) const {
    const auto it = m_places.find(&stmt);
    return it == m_places.end() ? Place{} : it->second;
}

DebugMap makeDebugMap(const tree::Program& program) {
    DebugMap map;
    map.sites = SiteTable(program).sites;
    map.functions.resize(program.functions.size());
    for (size_t f = 1; f < program.functions.size(); ++f) {
        const Function& function = program.functions[f];
        image::FunctionInfo& info = map.functions[f];
        info.name = function.name;
        info.library = function.library;
        info.instanceType = function.instanceType;
        info.declaration = function.declaration;
        const FrameLayout layout =
            layFrameOut(*program.types, function, std::vector<bool>(function.locals.size(), true));
        info.frameSize = layout.size;
        for (size_t i = 0; i < function.locals.size(); ++i) {
            const Local& local = function.locals[i];
            info.locals.push_back({local.name, local.type, layout.offsets[i], local.isInOut, local.isHidden});
        }
    }
    return map;
}

// ---------------------------------------------------------------- whole program

namespace {
class FunctionScan : public Walker {
public:
    FunctionScan(const ProgramFacts& facts, const tree::Program& program, FunctionFacts& out,
                 std::vector<FunctionFacts>& all, std::vector<bool>& inMemory)
        : m_facts(facts), m_program(program), m_out(out), m_all(all), m_inMemory(inMemory) {}

protected:
    void onStmt(const Stmt& stmt) override {
        switch (stmt.kind) {
        case StmtKind::While:
        case StmtKind::Repeat:
        case StmtKind::For:
        case StmtKind::Jump:
            m_out.hasLoop = m_out.charges = m_out.canFault = true;
            break;
        default:
            break;
        }
    }

    void onExpr(const Expr& expr) override {
        const types::TypeTable& types = *m_program.types;
        if (expr.kind == ExprKind::Binary &&
            (expr.binary == library::BinaryOp::Divide || expr.binary == library::BinaryOp::Modulo)) {
            const bool isConstant = expr.b && expr.b->kind == ExprKind::Constant &&
                                    std::holds_alternative<int64_t>(expr.b->value.data) && expr.b->value.integer() != 0;
            const types::TypeId type = expr.operandType.isValid() ? expr.operandType : expr.type;
            if (types.family(type) != types::Family::Real && !isConstant) m_out.canFault = true;
        }
        if (expr.kind == ExprKind::Intrinsic &&
            (expr.intrinsic == library::Intrinsic::DivDuration || expr.intrinsic == library::Intrinsic::CharAt))
            m_out.canFault = true;
        if (expr.kind == ExprKind::Call && expr.call) call(*expr.call);
    }

    void onPlace(const Place& place, Use use) override {
        for (const Place* p = &place; p; p = p->base) {
            switch (p->kind) {
            case PlaceKind::Index: {
                const bool isOpen = p->base && m_program.types->kind(p->base->type) == TypeKind::OpenArray;
                for (const Expr* index : p->indices)
                    if (isOpen || index->kind != ExprKind::Constant) m_out.canFault = true;
                break;
            }
            case PlaceKind::TextIndex:
            case PlaceKind::Deref:
                m_out.canFault = true;
                break;
            case PlaceKind::InOutSlot:
                m_out.canFault = m_out.hasSlots = true;
                break;
            default:
                break;
            }
        }
        const Place& root = rootOf(place);
        if (use == Use::Address && root.kind == PlaceKind::Local && root.local < m_inMemory.size())
            m_inMemory[root.local] = true;
    }

private:
    void call(const tree::Call& call) {
        const uint32_t callee = call.callee.value;
        if (call.dispatch == tree::Call::Dispatch::Direct) {
            addCallee(callee, call);
            return;
        }
        m_out.canFault = true;
        for (const Target& target : m_facts.targetsOf(callee))
            if (target.function != 0) addCallee(target.function, call);
    }
    void addCallee(uint32_t callee, const tree::Call& call) {
        if (callee == 0 || callee >= m_all.size()) return;
        if (std::find(m_out.callees.begin(), m_out.callees.end(), callee) == m_out.callees.end())
            m_out.callees.push_back(callee);
        std::vector<bool> given(m_all[callee].mayBeNull.size(), false);
        for (const tree::CallArgument& argument : call.arguments)
            if (argument.mode == tree::ArgumentMode::InOut && argument.place && argument.local < given.size())
                given[argument.local] = true;
        for (size_t i = 0; i < given.size(); ++i)
            if (!given[i]) m_all[callee].mayBeNull[i] = true;
    }

    const ProgramFacts& m_facts;
    const tree::Program& m_program;
    FunctionFacts& m_out;
    std::vector<FunctionFacts>& m_all;
    std::vector<bool>& m_inMemory;
};
} // namespace

// ---------------------------------------------------------------- what functions write

void WriteSummary::addAbsolute(Extent extent) {
    constexpr size_t kMany = 32; // then one extent around all
    for (Extent& known : absolutes) {
        if (extent.begin > known.end || known.begin > extent.end) continue;
        known = {std::min(known.begin, extent.begin), std::max(known.end, extent.end)};
        return;
    }
    absolutes.push_back(extent);
    if (absolutes.size() <= kMany) return;
    Extent all = absolutes.front();
    for (const Extent& each : absolutes) all = {std::min(all.begin, each.begin), std::max(all.end, each.end)};
    absolutes = {all};
}

bool extentOf(const types::TypeTable& types, const Place& place, WriteSummary::Extent& extent) {
    const Place* whole = &place; // the outermost part without an index below it
    for (const Place* p = &place; p; p = p->base) {
        if (p->kind == PlaceKind::InOutSlot || p->kind == PlaceKind::Deref || p->kind == PlaceKind::Temporary)
            return false;
        if ((p->kind == PlaceKind::Index || p->kind == PlaceKind::TextIndex || p->kind == PlaceKind::Bit) && p->base)
            whole = p->base;
    }
    extent.begin = 0;
    for (const Place* p = whole; p; p = p->base) extent.begin += p->offset;
    extent.end = extent.begin + std::max(1u, types[whole->type].size);
    return true;
}

namespace {
class WriteScan : public Walker {
public:
    WriteScan(const tree::Program& program, uint32_t function, std::vector<FunctionFacts>& all)
        : m_program(program), m_writes(all[function].writes) {}

protected:
    void onPlace(const Place& place, Use use) override {
        if (use == Use::Read || place.kind == PlaceKind::Temporary) return;
        const Place& root = rootOf(place);
        if (root.kind == PlaceKind::Local) return; // its own, or an IN_OUT: the caller's affair
        WriteSummary::Extent extent;
        if (!extentOf(*m_program.types, place, extent))
            m_writes.anything = true;
        else if (root.kind == PlaceKind::Instance)
            m_writes.instance = true;
        else
            m_writes.addAbsolute(extent);
    }
    void onExpr(const Expr& expr) override {
        if (expr.kind != ExprKind::Call || !expr.call) return;
        if (expr.call->dispatch != tree::Call::Dispatch::Direct) m_writes.anything = true;
    }

private:
    const tree::Program& m_program;
    WriteSummary& m_writes;
};
} // namespace

/// Callees' writes in the caller's terms: their THIS was already counted where its place escaped into the call.
void ProgramFacts::spreadWrites() {
    for (uint32_t f = 1; f < m_functions.size(); ++f)
        WriteScan(m_program, f, m_functions).walkFunction(m_program.functions[f]);
    for (bool changed = true; changed;) {
        changed = false;
        for (FunctionFacts& f : m_functions) {
            for (const uint32_t g : f.callees) {
                const WriteSummary& callee = m_functions[g].writes;
                if (callee.anything && !f.writes.anything) f.writes.anything = changed = true;
                if (f.writes.anything) continue;
                for (const WriteSummary::Extent& extent : std::vector(callee.absolutes)) {
                    const bool isKnown = std::any_of(
                        f.writes.absolutes.begin(), f.writes.absolutes.end(),
                        [&](const WriteSummary::Extent& e) { return e.begin <= extent.begin && extent.end <= e.end; });
                    if (isKnown) continue;
                    f.writes.addAbsolute(extent);
                    changed = true;
                }
            }
        }
    }
}

ProgramFacts::ProgramFacts(const tree::Program& program, Tier tier)
    : m_program(program), m_tier(tier), m_sites(program), m_functions(program.functions.size()) {
    const types::TypeTable& types = *program.types;
    for (uint32_t t = 0; t < types.count(); ++t) {
        const types::Type& type = types[types::TypeId(t)];
        if (type.kind != TypeKind::Block || type.blockNumber == 0) continue;
        if (m_blocks.size() <= type.blockNumber) m_blocks.resize(type.blockNumber + 1);
        m_blocks[type.blockNumber] = types::TypeId(t);
    }
    for (uint32_t f = 1; f < program.functions.size(); ++f)
        m_functions[f].mayBeNull.assign(program.functions[f].locals.size(), false);
    for (uint32_t f = 1; f < program.functions.size(); ++f)
        if (program.functions[f].methodSlot != Id<int>::kNone) m_targets[f] = findTargets(f);
    for (uint32_t f = 1; f < program.functions.size(); ++f) collect(f);
    findCycles();
    spread();
    spreadWrites();
}

void ProgramFacts::collect(uint32_t index) {
    const Function& function = m_program.functions[index];
    FunctionFacts& facts = m_functions[index];
    const types::TypeTable& types = *m_program.types;
    std::vector<bool> inMemory(function.locals.size());
    for (size_t i = 0; i < function.locals.size(); ++i) {
        const Local& local = function.locals[i];
        inMemory[i] = !local.isInOut && (local.isAddressTaken || !isScalar(types, local.type));
    }
    FunctionScan scan(*this, m_program, facts, m_functions, inMemory);
    scan.walkFunction(function);
    for (size_t i = 0; i < function.locals.size(); ++i) {
        if (function.locals[i].isInOut) inMemory[i] = false;
        if (m_tier == Tier::Quick) inMemory[i] = true;
    }
    facts.frame = layFrameOut(types, function, inMemory);
}

const std::vector<Target>& ProgramFacts::targetsOf(uint32_t method) const {
    static const std::vector<Target> none;
    const auto it = m_targets.find(method);
    return it == m_targets.end() ? none : it->second;
}

std::vector<Target> ProgramFacts::findTargets(uint32_t method) const {
    std::vector<Target> targets;
    const Function& declared = m_program.functions[method];
    const types::TypeTable& types = *m_program.types;
    for (uint32_t b = 1; b < m_blocks.size(); ++b) {
        if (!m_blocks[b].isValid()) continue;
        const bool fits = types.kind(declared.instanceType) == TypeKind::Interface
                              ? types.implements(m_blocks[b], declared.instanceType)
                              : types.isDerivedFrom(m_blocks[b], declared.instanceType);
        if (!fits) continue;
        Target target{b, m_blocks[b], 0};
        if (b < m_program.dispatch.size() && declared.methodSlot < m_program.dispatch[b].size()) {
            const tree::FunctionId id = m_program.dispatch[b][declared.methodSlot];
            if (id.isValid() && id.value != 0 && !m_program.functions[id.index()].isAbstract)
                target.function = id.value;
        }
        targets.push_back(target);
    }
    return targets;
}

types::TypeId ProgramFacts::blockType(uint32_t blockNumber) const {
    return blockNumber < m_blocks.size() ? m_blocks[blockNumber] : types::TypeId();
}

/// Tarjan's strongly connected components without recursion (a program may nest calls as deep as it likes).
void ProgramFacts::findCycles() {
    const size_t count = m_functions.size();
    std::vector<uint32_t> order(count, 0), low(count, 0), stack;
    std::vector<bool> onStack(count, false);
    uint32_t next = 1;
    struct Visit {
        uint32_t function;
        size_t callee;
    };
    for (uint32_t start = 1; start < count; ++start) {
        if (order[start]) continue;
        std::vector<Visit> visits{{start, 0}};
        order[start] = low[start] = next++;
        stack.push_back(start);
        onStack[start] = true;
        while (!visits.empty()) {
            Visit& visit = visits.back();
            const uint32_t f = visit.function;
            if (visit.callee < m_functions[f].callees.size()) {
                const uint32_t g = m_functions[f].callees[visit.callee++];
                if (g == f) m_functions[f].inCycle = true;
                if (!order[g]) {
                    order[g] = low[g] = next++;
                    stack.push_back(g);
                    onStack[g] = true;
                    visits.push_back({g, 0});
                } else if (onStack[g]) {
                    low[f] = std::min(low[f], order[g]);
                }
                continue;
            }
            visits.pop_back();
            if (!visits.empty()) low[visits.back().function] = std::min(low[visits.back().function], low[f]);
            if (low[f] != order[f]) continue;
            const bool isLoop = stack.back() != f;
            for (;;) {
                const uint32_t g = stack.back();
                stack.pop_back();
                onStack[g] = false;
                if (isLoop) m_functions[g].inCycle = true;
                if (g == f) break;
            }
        }
    }
}

void ProgramFacts::spread() {
    for (FunctionFacts& f : m_functions)
        if (f.inCycle) f.isUnbounded = f.canFault = f.charges = true;
    for (size_t f = 1; f < m_functions.size(); ++f) {
        const Function& function = m_program.functions[f];
        for (size_t i = 0; i < function.locals.size(); ++i)
            if (function.locals[i].isInOut && m_functions[f].mayBeNull[i]) m_functions[f].canFault = true;
        if (function.mayRecurse) m_functions[f].canFault = m_functions[f].charges = true;
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (FunctionFacts& f : m_functions) {
            for (const uint32_t g : f.callees) {
                const FunctionFacts& callee = m_functions[g];
                if ((callee.canFault && !f.canFault) || (callee.charges && !f.charges) ||
                    (callee.isUnbounded && !f.isUnbounded)) {
                    f.canFault |= callee.canFault;
                    f.charges |= callee.charges;
                    f.isUnbounded |= callee.isUnbounded;
                    changed = true;
                }
            }
        }
    }
    std::vector<uint32_t> work;
    const auto reach = [&](uint32_t f) {
        if (f == 0 || f >= m_functions.size() || m_functions[f].isReachable) return;
        m_functions[f].isReachable = true;
        work.push_back(f);
    };
    if (m_program.initializer.isValid()) reach(m_program.initializer.value);
    for (const image::Task& task : m_program.tasks)
        for (const image::TaskProgram& p : task.programs) {
            reach(p.function);
            reach(p.connectIn);
            reach(p.connectOut);
        }
    while (!work.empty()) {
        const uint32_t f = work.back();
        work.pop_back();
        for (const uint32_t g : m_functions[f].callees) reach(g);
    }
}

} // namespace plc::codegen
