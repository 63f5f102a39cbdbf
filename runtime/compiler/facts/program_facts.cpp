#include "runtime/compiler/facts/program_facts.h"

#include "runtime/compiler/facts/ranges.h"

#include <algorithm>
#include <unordered_set>

namespace plc::facts {

using tree::Expr;
using tree::ExprKind;
using tree::Function;
using tree::Local;
using tree::Place;
using tree::PlaceKind;
using tree::Stmt;
using tree::StmtKind;
using types::TypeKind;

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
        case StmtKind::Try:
            m_out.hasTry = m_out.canFault = true;
            break;
        case StmtKind::Assign:
            if (mayLeaveRange(*m_program.types, *stmt.a, stmt.place->type)) m_out.canFault = true;
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
        note(expr.type);
        if (expr.kind == ExprKind::Call && expr.call) call(*expr.call);
    }

    void onPlace(const Place& place, Use use) override {
        note(place.type);
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
    /// Values that are charged where they are copied.
    void note(types::TypeId type) {
        if (isChargedByItself(*m_program.types, type)) m_out.charges = m_out.canFault = true;
    }
    void noteParameters(uint32_t callee) {
        for (const Local& local : m_program.functions[callee].locals)
            if (local.kind != tree::LocalKind::Local && !local.isInOut) note(local.type);
    }
    void call(const tree::Call& call) {
        const uint32_t callee = call.callee.value;
        if (call.dispatch == tree::Call::Dispatch::Direct) {
            addCallee(callee, call);
            return;
        }
        m_out.canFault = true;
        // Charged by itself, also where no block implements the interface.
        if (m_program.functions[callee].mayRecurse) m_out.charges = true;
        noteParameters(callee);
        for (const Target& target : m_facts.targetsOf(callee))
            if (target.function != 0) addCallee(target.function, call);
    }
    void addCallee(uint32_t callee, const tree::Call& call) {
        if (callee == 0 || callee >= m_all.size()) return;
        if (m_called.insert(callee).second) {
            m_out.callees.push_back(callee);
            noteParameters(callee);
        }
        std::vector<bool> given(m_all[callee].mayBeNull.size(), false);
        for (const tree::CallArgument& argument : call.arguments)
            if (argument.mode == tree::ArgumentMode::Input && argument.value &&
                argument.local < m_program.functions[callee].locals.size() &&
                mayLeaveRange(*m_program.types, *argument.value,
                              m_program.functions[callee].locals[argument.local].type))
                m_out.canFault = true;
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
    std::unordered_set<uint32_t> m_called;
};
} // namespace

/// Callees' writes in the caller's terms: their THIS was already counted where its place escaped into the call.
void ProgramFacts::spreadWrites() {
    for (uint32_t f = 1; f < m_functions.size(); ++f) m_functions[f].writes = ownWrites(m_program, f);
    for (bool changed = true; changed;) {
        changed = false;
        for (const uint32_t index : m_order) {
            FunctionFacts& f = m_functions[index];
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
    measureWork();
    recordLongPaths();
    spread();
    spreadWrites();
}

Result<void> ProgramFacts::fits() const {
    const uint64_t room = frameRoom(m_program);
    std::vector<uint64_t> needs(m_functions.size(), 0);
    for (const uint32_t f : m_order) {
        const Function& function = m_program.functions[f];
        uint64_t deepest = 0;
        for (const uint32_t g : m_functions[f].callees)
            if (!m_functions[g].isUnbounded) deepest = std::max(deepest, needs[g]);
        needs[f] =
            deepest + layFrameOut(*m_program.types, function, std::vector<bool>(function.locals.size(), true)).size;
        if (needs[f] > room) return tooLarge(m_program, f, needs[f]);
    }
    return {};
}

void ProgramFacts::measureWork() {
    std::vector<bool> inCycle(m_functions.size());
    for (size_t f = 0; f < m_functions.size(); ++f) inCycle[f] = m_functions[f].inCycle;
    m_work = WorkTable(m_program, m_order, inCycle, [this](const tree::Call& call) {
        if (call.dispatch == tree::Call::Dispatch::Direct) return std::vector<uint32_t>{call.callee.value};
        std::vector<uint32_t> reached;
        for (const Target& target : targetsOf(call.callee.value))
            if (target.function != 0) reached.push_back(target.function);
        return reached;
    });
    for (uint32_t f = 1; f < m_functions.size(); ++f)
        if (m_work.atEntry(f) > 0) m_functions[f].charges = m_functions[f].canFault = true;
}

/// Calls that can fault leave a record, and there are so many records: that bounds the depth of calls, and with it what
/// they take of the machine's stack, the same in each tier. Calls that cannot fault are bounded by the length of their
/// way through the program; where that is too long, or below a cycle, they are recorded as well.
void ProgramFacts::recordLongPaths() {
    std::vector<uint32_t> below(m_functions.size(), 1), above(m_functions.size(), 1); // calls, the function included
    for (const uint32_t f : m_order)
        for (const uint32_t g : m_functions[f].callees) below[f] = std::max(below[f], below[g] + 1);
    for (auto f = m_order.rbegin(); f != m_order.rend(); ++f) {
        FunctionFacts& facts = m_functions[*f];
        if (facts.inCycle || above[*f] + below[*f] - 1 > image::kMaximumDepth) facts.canFault = true;
        for (const uint32_t g : facts.callees) {
            above[g] = std::max(above[g], facts.inCycle ? image::kMaximumDepth + 1 : above[*f] + 1);
        }
    }
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
        if (m_tier == Tier::Quick || facts.hasTry) inMemory[i] = true; // protected parts are functions of their own
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
                m_order.push_back(g);
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
        for (const uint32_t index : m_order) {
            FunctionFacts& f = m_functions[index];
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

} // namespace plc::facts
