// Constants: folded when first asked for, in any order, across units.
#include "runtime/compiler/sema/checker.h"

#include <algorithm>

namespace plc::sema {

/// The constant that a name or a qualified name means and that is not folded yet.
Variable* World::constantNamed(const syntax::Expr& e, const Scope& scope) {
    Variable* variable = nullptr;
    if (e.kind == syntax::ExprKind::NameRef) {
        const Found found = lookup(scope, key(e.name.text));
        variable = found.member.variable ? found.member.variable : found.entity.variable;
    } else if (e.kind == syntax::ExprKind::Member && e.base && e.base->kind == syntax::ExprKind::NameRef) {
        const Found found = lookup(scope, key(e.base->name.text));
        const NameId id = key(e.name.text);
        if (found.list) {
            const auto it = found.list->variables.find(id);
            variable = it == found.list->variables.end() ? nullptr : it->second;
        } else if (found.space) {
            variable = lookupIn(*found.space, id).entity.variable;
        } else if (found.entity.unit) {
            variable = findMember(*found.entity.unit, id).variable;
        }
    }
    return variable && variable->isConstant && variable->folding == Folding::Open ? variable : nullptr;
}

void World::gatherConstants(const syntax::Expr* root, const Scope& scope, std::vector<Variable*>& out) {
    std::vector<const syntax::Expr*> open;
    if (root) open.push_back(root);
    while (!open.empty()) {
        const syntax::Expr& e = *open.back();
        open.pop_back();
        if (Variable* constant = constantNamed(e, scope)) out.push_back(constant);
        if (e.base) open.push_back(e.base);
        if (e.right) open.push_back(e.right);
        for (const syntax::Argument& argument : e.arguments)
            if (argument.value) open.push_back(argument.value);
    }
}

/// Adds what the initial value of a constant needs. False: it needs itself.
bool World::planFolding(Variable& variable, std::vector<Variable*>& waiting) {
    variable.isFoldingPlanned = true;
    if (!variable.declaration) return true;
    std::vector<Variable*> needed;
    gatherConstants(variable.declaration->initial, variable.scope, needed);
    if (variable.spec) gatherConstants(variable.spec->length, variable.scope, needed);
    for (Variable* each : needed) {
        if (each->isFoldingPlanned) return false;
        waiting.push_back(each);
    }
    return true;
}

/// Constants may be declared in any order. Those that one needs are folded before it without recursion, because a list
/// in reverse order is a chain as long as the list. A cycle is left to the recursion, which reports it where it began.
void World::foldNeeded(Variable& first) {
    std::vector<Variable*> waiting{&first};
    while (!waiting.empty()) {
        Variable& variable = *waiting.back();
        if (!variable.isFoldingPlanned) {
            if (!planFolding(variable, waiting)) return;
            continue;
        }
        waiting.pop_back();
        if (&variable != &first && variable.folding == Folding::Open && !fold(variable)) return;
    }
}

const types::Value* World::constantOf(Variable& variable) {
    if (variable.folding == Folding::Open && !variable.isFoldingPlanned) foldNeeded(variable);
    return fold(variable);
}

///   ok:    a : INT := b; b : INT := 5;  (CONSTANT)      wrong: a : INT := b; b : INT := a;  (P3003)
const types::Value* World::fold(Variable& variable) {
    switch (variable.folding) {
    case Folding::Constant:
        return &variable.value;
    case Folding::Dynamic:
        return nullptr;
    case Folding::Working:
        emit(variable.range, findings::TypeCycle(variable.name));
        variable.folding = Folding::Dynamic;
        return nullptr;
    case Folding::Open:
        break;
    }
    const syntax::Expr* initial = variable.declaration ? variable.declaration->initial : nullptr;
    const Waiting wait(waitingCounter(), 4 + (initial ? initial->height : 0));
    if (wait.isTooDeep) {
        emit(variable.range, findings::NestedTooDeep());
        return nullptr;
    }
    const TypeId type = typeOf(variable);
    variable.folding = Folding::Working;
    if (!completeType(type, variable.range) || types.kind(type) == TypeKind::Unknown) {
        variable.folding = Folding::Dynamic;
        return nullptr;
    }
    if (!initial) {
        variable.value = types::initialValue(types, type);
        variable.value.type = type;
        variable.folding = Folding::Constant;
        return &variable.value;
    }
    Checker checker(*this, variable.scope, sink, arena);
    const Operand value = checker.converted(checker.expression(*initial, type), type);
    if (variable.folding == Folding::Dynamic || value.isUnknown()) {
        variable.folding = Folding::Dynamic;
        return nullptr;
    }
    if (!value.isConstant()) {
        emit(initial->range, findings::NotConstant());
        variable.folding = Folding::Dynamic;
        return nullptr;
    }
    variable.value = value.expr->value;
    if (types.isText(type)) { // cut to its capacity
        const uint32_t capacity = types[type].capacity;
        if (auto* narrow = std::get_if<std::string>(&variable.value.data); narrow && narrow->size() > capacity)
            narrow->resize(capacity);
        if (auto* wide = std::get_if<std::u16string>(&variable.value.data); wide && wide->size() > capacity)
            wide->resize(capacity);
    }
    variable.value.type = type;
    variable.folding = Folding::Constant;
    return &variable.value;
}

void World::checkConstants() {
    const auto check = [&](Variable& variable) {
        if (variable.isConstant && variable.kind != syntax::SectionKind::External &&
            isFoldable(types, typeOf(variable)))
            constantOf(variable);
    };
    for (Variable& variable : globals) check(variable);
    for (Unit& unit : units)
        for (Variable& variable : unit.variables)
            if (variable.kind == syntax::SectionKind::Var || variable.kind == syntax::SectionKind::Stat)
                check(variable);
}

} // namespace plc::sema
