// Trees of bodies with other places. A node that two others share is shared in the copy as well: code generation knows
// temporaries by their node.
#include "runtime/compiler/sema/kept/last_check.h"

#include "runtime/compiler/sema/kept_bodies.h"
#include "runtime/compiler/sema/world.h"

namespace plc::sema {

namespace {

class Copying {
public:
    Copying(const Moves& moves, Arena& arena) : m_moves(moves), m_arena(arena) {}

    void function(tree::Function& function) {
        for (tree::Local& local : function.locals) local.initial = expr(local.initial);
        statements(function.body);
    }

private:
    template <class T> using Copies = std::unordered_map<const T*, T*>;

    /// The copy of a node: `fill` moves it on, once.
    template <class T, class Fill> T* copy(Copies<T>& copies, const T* node, const Fill& fill) {
        if (!node) return nullptr;
        // Before `fill`, which may come back here by another way.
        if (const auto it = copies.find(node); it != copies.end()) return it->second;
        T* made = m_arena.make<T>(*node);
        copies.emplace(node, made);
        fill(*made);
        return made;
    }

    // Every pointer of a node is listed here by hand: one that is forgotten would leave the copy pointing into the
    // record. KeptBodies compares whole trees after random edits for that.
    tree::Place* place(const tree::Place* node) {
        return copy(m_places, node, [&](tree::Place& made) {
            made.range = m_moves(made.range);
            made.base = place(made.base);
            for (tree::Expr*& index : made.indices) index = expr(index);
            made.pointer = expr(made.pointer);
            made.value = expr(made.value);
        });
    }

    tree::Call* call(const tree::Call* node) {
        return copy(m_calls, node, [&](tree::Call& made) {
            made.instance = place(made.instance);
            made.interface = expr(made.interface);
            for (tree::CallArgument& argument : made.arguments) {
                argument.value = expr(argument.value);
                argument.place = place(argument.place);
            }
        });
    }

    tree::Expr* expr(const tree::Expr* node) {
        return copy(m_exprs, node, [&](tree::Expr& made) {
            made.range = m_moves(made.range);
            made.place = place(made.place);
            made.a = expr(made.a);
            made.b = expr(made.b);
            made.c = expr(made.c);
            for (tree::Expr*& operand : made.operands) operand = expr(operand);
            made.call = call(made.call);
            statements(made.statements);
            made.ok = place(made.ok);
        });
    }

    void statements(std::vector<tree::Stmt*>& list) {
        for (tree::Stmt*& each : list) each = statement(each);
    }

    tree::Stmt* statement(const tree::Stmt* node) {
        return copy(m_stmts, node, [&](tree::Stmt& made) {
            made.range = m_moves(made.range);
            made.place = place(made.place);
            made.target = place(made.target);
            made.a = expr(made.a);
            made.b = expr(made.b);
            made.c = expr(made.c);
            statements(made.body);
            statements(made.elseBody);
            for (tree::CaseArm& arm : made.arms) statements(arm.body);
        });
    }

    const Moves& m_moves;
    Arena& m_arena;
    Copies<tree::Place> m_places;
    Copies<tree::Call> m_calls;
    Copies<tree::Expr> m_exprs;
    Copies<tree::Stmt> m_stmts;
};

std::shared_ptr<tree::Program> copyOf(const tree::Program& program) {
    auto copy = std::make_shared<tree::Program>();
    // Bodies are shared with the original as long as they are not moved: it lives as long as the analysis that is
    // passed on.
    copy->functions = program.functions;
    copy->dispatch = program.dispatch;
    copy->types = program.types;
    copy->layout = program.layout;
    copy->initialImage = program.initialImage;
    copy->initializer = program.initializer;
    copy->tasks = program.tasks;
    return copy;
}

} // namespace

void moveTree(tree::Function& function, const Moves& moves, Arena& arena) { Copying(moves, arena).function(function); }

std::shared_ptr<const Analysis> withTreesInPlace(const std::shared_ptr<const Analysis>& analysis) {
    const World& world = *static_cast<const World*>(analysis->scopes.get());
    if (!world.check || !analysis->program) return analysis;
    std::shared_ptr<tree::Program> program;
    for (size_t i = 0; i < world.units.size(); ++i) {
        const BodyRecord* record = world.check->records[i].get();
        // Made from this very text.
        if (!record || record->shapes == world.check->shapes) continue;
        const Moves moves(*record->shapes, *world.check->shapes);
        if (!moves.isNeeded()) continue;
        if (!program) program = copyOf(*analysis->program);
        moveTree(program->functions[world.units[i].function.index()], moves, program->arena);
    }
    if (!program) return analysis;
    auto moved = std::make_shared<Analysis>(*analysis);
    moved->program = std::move(program);
    return moved;
}

} // namespace plc::sema
