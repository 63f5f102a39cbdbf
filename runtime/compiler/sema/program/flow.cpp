// Whole-program checks after the bodies: variables nobody uses, calls that come back to themselves.
#include "runtime/compiler/sema/program/flow.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/layout/initial_values.h"
#include "runtime/compiler/sema/program/analyze.h"

#include "runtime/base/text.h"

namespace plc::sema {

using syntax::SectionKind;

static void checkUnusedGlobals(WorldBuilder& world);
static void gatherConfigured(WorldBuilder& world);
static void checkUnusedActions(WorldBuilder& world);
static void checkFrames(WorldBuilder& world, const std::vector<std::vector<uint32_t>>& edges,
                        const std::vector<std::vector<uint32_t>>& components);

/// Globals nobody reads or writes. Located ones are what the machine has, constants what a list offers.
void checkUnusedGlobals(WorldBuilder& world) {
    for (Variable& variable : world.globals) {
        if (variable.kind != SectionKind::Global || variable.isProgramInstance || variable.isConstant ||
            variable.isLocated || !variable.declaration || !variable.range.file.isValid())
            continue;
        if (isLibraryFile(world, variable.range.file) || variable.reads || variable.writes ||
            world.types.kind(variable.type) == TypeKind::Unknown || world.types.kind(variable.type) == TypeKind::Block)
            continue;
        // usedElsewhere: names in panels, traces, tests and devices. With a dot: the last part of a path.
        const std::string name = foldCase(variable.name);
        if (world.options.usedElsewhere.contains(name) || world.options.usedElsewhere.contains("." + name)) continue;
        auto& diagnostic = world.emit(variable.range, findings::UnusedVariable(variable.name));
        // "a, b : INT" loses b too when the declaration goes; then there is no fix.
        if (variable.declaration->names.size() == 1)
            diagnostic.fixes.push_back({fixes::RemoveDeclaration(), {{variable.declaration->range, ""}}});
    }
}

/// Variables that a VAR_CONFIG or VAR_ACCESS names.
void gatherConfigured(WorldBuilder& world) {
    const auto gather = [&](const std::vector<syntax::VarSection*>& sections) {
        for (const syntax::VarSection* section : sections) {
            if (section->kind != SectionKind::Config && section->kind != SectionKind::Access) continue;
            for (const syntax::VarDecl* declaration : section->declarations) {
                if (declaration->configPath.empty()) continue;
                const std::string_view last = declaration->configPath.back().text;
                // A[3] of a path is A.
                world.options.usedElsewhere.insert("." + foldCase(last.substr(0, last.find('['))));
            }
        }
    };
    for (const Configuration& configuration : world.configurations) {
        gather(configuration.declaration->sections);
        for (const syntax::ResourceDecl* resource : configuration.declaration->resources) gather(resource->sections);
    }
    for (const Unit& unit : world.units)
        if (unit.kind == UnitKind::Program && unit.pou) gather(unit.pou->sections);
}

/// ACTIONs that no step, call or panel names.
void checkUnusedActions(WorldBuilder& world) {
    std::vector<bool> used(world.symbols.size(), false);
    for (const Reference& reference : world.references)
        if (reference.symbol.isValid() && reference.range != world.symbols[reference.symbol.index()].declaration)
            // The declaration itself is a reference as well, for renaming; it is no use.
            used[reference.symbol.index()] = true;
    for (const Unit& unit : world.units) {
        if (unit.kind != UnitKind::Action || unit.isLibrary() || !unit.symbol.isValid() || used[unit.symbol.index()] ||
            world.options.usedElsewhere.contains("." + foldCase(unit.name)) || hasSyntaxErrorAt(world, unit.range))
            continue;
        world.emit(unit.range, findings::UnusedVariable(unit.name));
    }
}

namespace {

/// What something outside of the text uses, by number: every variable is asked for, and a text would be folded each
/// time.
class UsedElsewhere {
public:
    explicit UsedElsewhere(const World& world) {
        for (const std::string& name : world.options.usedElsewhere) {
            const NameId id = name.starts_with('.') ? world.names.find(std::string_view(name).substr(1)) : NameId();
            if (!id.isValid()) continue;
            if (id.index() >= m_used.size()) m_used.resize(id.index() + 1);
            m_used[id.index()] = true;
        }
    }
    [[nodiscard]] bool contains(NameId id) const {
        return id.isValid() && id.index() < m_used.size() && m_used[id.index()];
    }

private:
    std::vector<bool> m_used;
};

} // namespace

///   ok:    VAR x : INT := 1; y : INT; END_VAR y := x;
///   advice: VAR x : INT; END_VAR  that nothing names (P3005)   y := x;  where nothing writes x (P3006)
// All of these are advice: a program runs as well with an unused variable. Names that something outside of the text
// uses (panels, traces, devices) are given by who asks for the check.
void checkUsage(WorldBuilder& world) {
    gatherConfigured(world);
    checkUnusedGlobals(world);
    checkUnusedActions(world);
    const UsedElsewhere usedElsewhere(world);
    const NameId chart = world.key("__chart0");
    for (Unit& unit : world.units) {
        if (unit.isLibrary() || unit.kind == UnitKind::Interface ||
            (unit.owner && unit.owner->kind == UnitKind::Interface))
            continue;
        // __chart0 is what the lowering of a chart adds. SFCInit, SFCPause … are flags that the chart itself reads.
        const bool hasChart = unit.members.contains(chart);
        for (Variable& variable : unit.variables) {
            if (hasChart && equalsIgnoringCase(std::string_view(variable.name).substr(0, 3), "SFC"))
                continue; // flags of the chart
            // Parameters are part of an interface: that this body does not use one says nothing.
            const bool isOwn = variable.kind == SectionKind::Var || variable.kind == SectionKind::Temp ||
                               variable.kind == SectionKind::Stat || variable.kind == SectionKind::Inst;
            if (!isOwn || variable.isResult || !variable.declaration || !variable.range.file.isValid() ||
                variable.name.starts_with("__"))
                continue;
            const auto known = unit.members.find(variable.id);
            // A name that is declared twice, or that an ACTION has too, was reported; counts of uses belong to the
            // other.
            if (world.types.kind(variable.type) == TypeKind::Unknown || known == unit.members.end() ||
                known->second.variable != &variable || known->second.unit)
                continue;
            if (usedElsewhere.contains(variable.id) || hasSyntaxErrorAt(world, variable.range)) continue;
            if (variable.reads == 0 && variable.writes == 0) {
                // A located variable that nothing uses is the wiring list of the machine.
                if (variable.isLocated) continue;
                auto& diagnostic = world.emit(variable.range, findings::UnusedVariable(variable.name));
                if (variable.declaration->names.size() == 1 && variable.declaration->range.file.isValid())
                    diagnostic.fixes.push_back({fixes::RemoveDeclaration(), {{variable.declaration->range, ""}}});
                continue;
            }
            const TypeKind kind = world.types.kind(variable.type);
            const bool hasValue = variable.declaration->initial || hasConstructor(variable.spec);
            if (variable.writes == 0 && !hasValue && !variable.isConstant && !variable.isLocated &&
                // Aggregates are written by element, by address or by a call; counting that wrongly would accuse good
                // programs.
                kind != TypeKind::Block && kind != TypeKind::Unknown && kind != TypeKind::Array &&
                kind != TypeKind::Struct && kind != TypeKind::Union)
                world.emit(variable.range, findings::NeverWritten(variable.name));
        }
    }
}

namespace {

// A chain of 100,000 calls is a legal (generated) program: recursion here would end the stack.
/// Tarjan's strongly connected components, without recursion.
class Components {
public:
    explicit Components(const std::vector<std::vector<uint32_t>>& edges)
        : m_edges(edges), m_index(edges.size(), 0), m_low(edges.size(), 0), m_onStack(edges.size(), false) {
        for (uint32_t i = 0; i < edges.size(); ++i)
            if (!m_index[i]) visit(i);
    }
    std::vector<std::vector<uint32_t>> found;

private:
    struct Step {
        uint32_t node;
        size_t next;
    };
    void visit(uint32_t root) {
        std::vector<Step> work{{root, 0}};
        while (!work.empty()) {
            const uint32_t node = work.back().node;
            if (work.back().next == 0) {
                m_index[node] = m_low[node] = ++m_counter;
                m_stack.push_back(node);
                m_onStack[node] = true;
            }
            if (work.back().next < m_edges[node].size()) {
                const uint32_t to = m_edges[node][work.back().next++];
                if (!m_index[to])
                    work.push_back({to, 0});
                else if (m_onStack[to])
                    m_low[node] = std::min(m_low[node], m_index[to]);
                continue;
            }
            work.pop_back();
            if (!work.empty()) m_low[work.back().node] = std::min(m_low[work.back().node], m_low[node]);
            if (m_low[node] != m_index[node]) continue;
            std::vector<uint32_t> component;
            for (;;) {
                const uint32_t top = m_stack.back();
                m_stack.pop_back();
                m_onStack[top] = false;
                component.push_back(top);
                if (top == node) break;
            }
            std::sort(component.begin(), component.end());
            found.push_back(std::move(component));
        }
    }
    const std::vector<std::vector<uint32_t>>& m_edges;
    std::vector<uint32_t> m_index, m_low, m_stack;
    std::vector<bool> m_onStack;
    uint32_t m_counter = 0;
};

} // namespace

/// The locals of one path of calls must fit into the frames' area together.
///   wrong: FUNCTION F … VAR a, b : ARRAY[0..200000000] OF BYTE; END_VAR  (P3023)
void checkFrames(WorldBuilder& world, const std::vector<std::vector<uint32_t>>& edges,
                 const std::vector<std::vector<uint32_t>>& components) {
    std::vector<uint64_t> needed(world.functions.size(), 0); // with what is called
    std::vector<bool> isReported(world.functions.size(), false);
    // One pass suffices, because Tarjan gives components in reverse topological order.
    for (const std::vector<uint32_t>& component : components) { // the called come before their callers
        uint64_t own = 0, below = 0;
        bool wasReported = false;
        for (const uint32_t index : component) {
            for (const tree::Local& local : world.functions[index].locals)
                // In-outs are an address and, for texts and open arrays, a length.
                own += local.isInOut ? 16 : world.types[local.type].size;
            for (const uint32_t to : edges[index]) {
                below = std::max(below, needed[to]);
                wasReported = wasReported || isReported[to];
            }
        }
        // Reported once, where it first becomes too large, and not at every caller above.
        const bool isTooLarge = own + below > kMaximumData;
        for (const uint32_t index : component) {
            // Cut off, so that a sum over a wide graph cannot wrap.
            needed[index] = std::min(own + below, 2 * kMaximumData);
            isReported[index] = isTooLarge || wasReported;
        }
        if (isTooLarge && !wasReported)
            world.emit(world.functions[component.front()].declaration,
                       findings::ImageTooLarge(own + below, kMaximumData));
    }
}

namespace {

/// Who may call whom, by function. A call that is dispatched may reach every method in the slot.
class CallGraph {
public:
    explicit CallGraph(WorldBuilder& world)
        : m_world(world), m_edges(world.functions.size()), m_units(world.functions.size(), nullptr),
          m_callsFrom(world.functions.size()) {
        std::vector<std::vector<uint32_t>> bySlot(world.slotNames.size());
        for (Unit& unit : world.units) {
            if (!unit.function.isValid()) continue;
            m_units[unit.function.index()] = &unit;
            if (unit.slot != Id<int>::kNone && !(unit.owner && unit.owner->kind == UnitKind::Interface))
                bySlot[unit.slot].push_back(unit.function.value);
        }
        for (const Call& call : world.calls) add(call, bySlot);
        // Sorted and unique: checkCycle asks by binary search, and large programs call the same function a thousand
        // times.
        for (auto& list : m_edges) {
            std::sort(list.begin(), list.end());
            list.erase(std::unique(list.begin(), list.end()), list.end());
        }
    }

    [[nodiscard]] const std::vector<std::vector<uint32_t>>& edges() const { return m_edges; }

    void checkCycle(const std::vector<uint32_t>& component) {
        const uint32_t first = whereToFix(component);
        const auto& own = m_edges[first];
        if (component.size() == 1 && !std::binary_search(own.begin(), own.end(), first)) return;
        // The code generator counts the depth of these, so that endless recursion is a fault and no crash.
        for (const uint32_t index : component) m_world.functions[index].mayRecurse = true;
        if (m_units[first]) report(component, first);
    }

private:
    void add(const Call& call, const std::vector<std::vector<uint32_t>>& bySlot) {
        m_edges[call.from].push_back(call.to);
        m_callsFrom[call.from].push_back(&call);
        const tree::Function& called = m_world.functions[call.to];
        if (!call.isDispatched || called.methodSlot == Id<int>::kNone) return;
        // As many edges as there are methods of that name in blocks derived from the instance's type.
        for (const uint32_t candidate : bySlot[called.methodSlot]) {
            const Unit* unit = m_units[candidate];
            if (unit && unit->self() &&
                (!called.instanceType.isValid() ||
                 m_world.types.isDerivedFrom(unit->self()->type, called.instanceType)))
                m_edges[call.from].push_back(candidate);
        }
    }

    /// One of the project before one of a library: where its writer can change it.
    [[nodiscard]] uint32_t whereToFix(const std::vector<uint32_t>& component) const {
        const auto own = std::find_if(component.begin(), component.end(),
                                      [&](uint32_t index) { return m_units[index] && !m_units[index]->isLibrary(); });
        return own == component.end() ? component.front() : *own;
    }

    /// Every member is a function, program or action: there the standard forbids it, methods are guarded instead.
    [[nodiscard]] bool isForbidden(const std::vector<uint32_t>& component) const {
        return std::all_of(component.begin(), component.end(), [&](uint32_t index) {
            const Unit* unit = m_units[index];
            return unit && (unit->kind == UnitKind::Function || unit->kind == UnitKind::Program ||
                            unit->kind == UnitKind::Action);
        });
    }

    void report(const std::vector<uint32_t>& component, uint32_t first) {
        const std::vector<uint32_t> way = wayRound(component, first);
        const std::string& name = m_world.functions[first].name;
        const SourceRange range = callOf(way.back(), first);
        if (!isForbidden(component)) {
            m_world.emit(range, findings::RecursiveMethod(name));
            return;
        }
        std::string chain;
        for (const uint32_t each : way) chain += m_world.functions[each].name + " → ";
        m_world.emit(range, findings::Recursion(name, chain + name));
    }

    /// The shortest, from the first of them to the one that calls it.
    [[nodiscard]] std::vector<uint32_t> wayRound(const std::vector<uint32_t>& component, uint32_t first) const {
        std::vector<uint32_t> from(m_edges.size(), Id<int>::kNone), queue{first};
        uint32_t last = Id<int>::kNone;
        for (size_t i = 0; i < queue.size() && last == Id<int>::kNone; ++i) {
            for (const uint32_t to : m_edges[queue[i]]) {
                if (to == first) {
                    last = queue[i];
                    break;
                }
                if (from[to] != Id<int>::kNone || !std::binary_search(component.begin(), component.end(), to)) continue;
                from[to] = queue[i];
                queue.push_back(to);
            }
        }
        if (last == Id<int>::kNone) last = first;
        std::vector<uint32_t> way;
        for (uint32_t at = last; at != first && at != Id<int>::kNone; at = from[at]) way.push_back(at);
        way.push_back(first);
        std::reverse(way.begin(), way.end());
        return way;
    }

    /// The call that closes the circle; the callee's name when it is in no text.
    [[nodiscard]] SourceRange callOf(uint32_t caller, uint32_t callee) const {
        const uint32_t slot = m_world.functions[callee].methodSlot;
        for (const Call* call : m_callsFrom[caller])
            if (call->to == callee ||
                (call->isDispatched && slot != Id<int>::kNone && m_world.functions[call->to].methodSlot == slot))
                return call->range;
        return m_units[callee]->range;
    }

    WorldBuilder& m_world;
    std::vector<std::vector<uint32_t>> m_edges;
    std::vector<Unit*> m_units;
    std::vector<std::vector<const Call*>> m_callsFrom;
};

/// What is called through an interface may be any method of the slot, in blocks that are made later as well.
void guardInterfaceMethods(WorldBuilder& world) {
    std::unordered_set<uint32_t> slots;
    for (const Call& call : world.calls)
        if (call.isDispatched && world.functions[call.to].isAbstract) slots.insert(world.functions[call.to].methodSlot);
    for (tree::Function& function : world.functions)
        if (function.methodSlot != Id<int>::kNone && slots.contains(function.methodSlot)) function.mayRecurse = true;
}

} // namespace

/// Recursion of functions is not allowed (edition 2, 2.5); that of methods is guarded while it runs.
///   wrong: FUNCTION F … F := F(n - 1); END_FUNCTION  (P3004)
///   advice: METHOD M … M := M(n - 1); END_METHOD  (P3032)
void checkRecursion(WorldBuilder& world) {
    CallGraph graph(world);
    const std::vector<std::vector<uint32_t>> components = Components(graph.edges()).found;
    checkFrames(world, graph.edges(), components);
    for (const std::vector<uint32_t>& component : components) graph.checkCycle(component);
    guardInterfaceMethods(world);
}

} // namespace plc::sema
