// Constants: folded when first asked for, in any order, across units.
// Folding is the only part of declarations where order is free in both directions, hence the care about depth: a
// generated list of 100,000 constants, each one more than the next, must fold.
#include "runtime/compiler/sema/values/constants.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include <algorithm>

namespace plc::sema {
static Variable* constantNamed(const World& world, const syntax::Expr& e, const Scope& scope);
static void gatherConstants(const World& world, const syntax::Expr* root, const Scope& scope,
                            std::vector<Variable*>& out);
static bool planFolding(WorldBuilder& world, Variable& variable, std::vector<Variable*>& waiting);
static void foldNeeded(WorldBuilder& world, Variable& first);
static const types::Value* fold(WorldBuilder& world, Variable& variable);

/// The constant that a name or a qualified name means and that is not folded yet.
Variable* constantNamed(const World& world, const syntax::Expr& e, const Scope& scope) {
    Variable* variable = nullptr;
    if (e.kind == syntax::ExprKind::NameRef) {
        const Found found = lookup(world, scope, world.names.find(e.name.text));
        variable = found.member.variable ? found.member.variable : found.entity.variable;
    } else if (e.kind == syntax::ExprKind::Member && e.base && e.base->kind == syntax::ExprKind::NameRef) {
        const Found found = lookup(world, scope, world.names.find(e.base->name.text));
        const NameId id = world.names.find(e.name.text);
        if (found.list) {
            const auto it = found.list->variables.find(id);
            variable = it == found.list->variables.end() ? nullptr : it->second;
        } else if (found.space) {
            variable = lookupIn(*found.space, id).entity.variable;
        } else if (found.entity.unit) {
            variable = findMember(*found.entity.unit, id).variable;
        }
    }
    // Only those still to be folded are of interest.
    return variable && variable->isConstant && variable->folding == Folding::Open ? variable : nullptr;
}

void gatherConstants(const World& world, const syntax::Expr* root, const Scope& scope, std::vector<Variable*>& out) {
    // A list instead of recursion: an expression may be a thousand operators deep.
    std::vector<const syntax::Expr*> open;
    if (root) open.push_back(root);
    while (!open.empty()) {
        const syntax::Expr& e = *open.back();
        open.pop_back();
        if (Variable* constant = constantNamed(world, e, scope)) out.push_back(constant);
        if (e.base) open.push_back(e.base);
        if (e.right) open.push_back(e.right);
        for (const syntax::Argument& argument : e.arguments)
            if (argument.value) open.push_back(argument.value);
    }
}

/// Adds what the initial value of a constant needs. False: it needs itself.
bool planFolding(WorldBuilder& world, Variable& variable, std::vector<Variable*>& waiting) {
    variable.isFoldingPlanned = true;
    if (!variable.declaration) return true;
    std::vector<Variable*> needed;
    gatherConstants(world, variable.declaration->initial, variable.scope, needed);
    // STRING(N): the type needs a constant as well.
    if (variable.spec) gatherConstants(world, variable.spec->length, variable.scope, needed);
    for (Variable* each : needed) {
        if (each->isFoldingPlanned) return false;
        waiting.push_back(each);
    }
    return true;
}

/// Constants may be declared in any order. Those that one needs are folded before it without recursion, because a list
/// in reverse order is a chain as long as the list. A cycle is left to the recursion, which reports it where it began.
void foldNeeded(WorldBuilder& world, Variable& first) {
    std::vector<Variable*> waiting{&first};
    while (!waiting.empty()) {
        Variable& variable = *waiting.back();
        if (!variable.isFoldingPlanned) {
            // A cycle: fold() below meets Working and reports it.
            if (!planFolding(world, variable, waiting)) return;
            continue;
        }
        waiting.pop_back();
        if (&variable != &first && variable.folding == Folding::Open && !fold(world, variable)) return;
    }
}

const types::Value* constantOf(WorldBuilder& world, Variable& variable) {
    if (variable.folding == Folding::Open && !variable.isFoldingPlanned) foldNeeded(world, variable);
    return fold(world, variable);
}

const types::Value* constantOf(const Check& check, Variable& variable) {
    if (check.builder) return constantOf(*check.builder, variable);
    return variable.folding == Folding::Constant ? &variable.value : nullptr;
}

///   ok:    a : INT := b; b : INT := 5;  (CONSTANT)      wrong: a : INT := b; b : INT := a;  (P3003)
const types::Value* fold(WorldBuilder& world, Variable& variable) {
    switch (variable.folding) {
    case Folding::Constant:
        return &variable.value;
    case Folding::Dynamic:
        return nullptr;
    // Met while it is being folded: it needs itself.
    case Folding::Working:
        world.emit(variable.range, findings::TypeCycle(variable.name));
        variable.folding = Folding::Dynamic;
        return nullptr;
    case Folding::Open:
        break;
    }
    const syntax::Expr* initial = variable.declaration ? variable.declaration->initial : nullptr;
    const Waiting wait(world.waiting, 4 + (initial ? initial->height : 0));
    if (wait.isTooDeep) {
        world.emit(variable.range, findings::NestedTooDeep());
        return nullptr;
    }
    const TypeId type = typeOf(world, variable);
    variable.folding = Folding::Working;
    // Its type was reported.
    if (!completeType(world, type, variable.range) || world.types.kind(type) == TypeKind::Unknown) {
        variable.folding = Folding::Dynamic;
        return nullptr;
    }
    if (!initial) {
        variable.value = types::initialValue(world.types, type);
        variable.value.type = type;
        variable.folding = Folding::Constant;
        return &variable.value;
    }
    Context checker(world, variable.scope, world.sink, world.arena);
    const Operand value = converted(checker, expression(checker, *initial, type), type);
    // Dynamic: the cycle was reported further down.
    if (variable.folding == Folding::Dynamic || value.isUnknown()) {
        variable.folding = Folding::Dynamic;
        return nullptr;
    }
    if (!value.isConstant()) {
        world.emit(initial->range, findings::NotConstant());
        variable.folding = Folding::Dynamic;
        return nullptr;
    }
    variable.value = value.expr->value;
    if (world.types.isText(type)) { // cut to its capacity
        const uint32_t capacity = world.types[type].capacity;
        if (auto* narrow = std::get_if<std::string>(&variable.value.data); narrow && narrow->size() > capacity)
            narrow->resize(capacity);
        if (auto* wide = std::get_if<std::u16string>(&variable.value.data); wide && wide->size() > capacity)
            wide->resize(capacity);
    }
    variable.value.type = type;
    variable.folding = Folding::Constant;
    return &variable.value;
}

// By now every type is complete, so the order no longer matters.
void checkConstants(WorldBuilder& world) {
    const auto check = [&](Variable& variable) {
        if (variable.isConstant && variable.kind != syntax::SectionKind::External &&
            isFoldable(world.types, typeOf(world, variable)))
            constantOf(world, variable);
    };
    for (Variable& variable : world.globals) check(variable);
    for (Unit& unit : world.units)
        for (Variable& variable : unit.variables) check(variable);
}

} // namespace plc::sema
