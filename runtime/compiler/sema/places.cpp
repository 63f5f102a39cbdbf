// Places: how storage is named in the checked tree. Constant offsets are added up as far as they go.
#include "runtime/compiler/sema/checker.h"

namespace plc::sema {

tree::Place* Checker::absolutePlace(uint32_t offset, TypeId type, int16_t bit, SourceRange range) {
    tree::Place* place = arena.make<tree::Place>();
    place->kind = tree::PlaceKind::Absolute;
    place->type = type;
    place->range = range;
    place->offset = offset;
    place->bit = bit;
    return place;
}

tree::Place* Checker::localPlace(uint32_t local, TypeId type, SourceRange range) {
    tree::Place* place = arena.make<tree::Place>();
    place->kind = tree::PlaceKind::Local;
    place->type = type;
    place->range = range;
    place->local = local;
    return place;
}

tree::Place* Checker::thisPlace(SourceRange range) {
    Unit* self = scope.unit ? scope.unit->self() : nullptr;
    const TypeId type = self ? self->type : elementary(TypeKind::Unknown);
    if (instanceBase) return absolutePlace(*instanceBase, type, -1, range);
    tree::Place* place = absolutePlace(0, type, -1, range);
    place->kind = tree::PlaceKind::Instance;
    return place;
}

tree::Place* Checker::fieldPlace(tree::Place* base, uint32_t offset, TypeId type, int16_t bit, SourceRange range) {
    tree::Place* place = arena.make<tree::Place>();
    place->type = type;
    place->range = range;
    place->bit = bit;
    if (base->bit < 0 && (base->kind == tree::PlaceKind::Absolute || base->kind == tree::PlaceKind::Instance ||
                          base->kind == tree::PlaceKind::Field)) {
        place->kind = base->kind;
        place->offset = base->offset + offset;
        place->base = base->base;
        return place;
    }
    place->kind = tree::PlaceKind::Field;
    place->offset = offset;
    place->base = base;
    return place;
}

tree::Place* Checker::dereferenced(tree::Place* reference, SourceRange range) {
    tree::Place* place = arena.make<tree::Place>();
    place->kind = tree::PlaceKind::Deref;
    place->type = types[reference->type].element;
    place->range = range;
    place->pointer = load(reference, range).expr;
    return place;
}

tree::Place* Checker::temporary(const Operand& operand) {
    tree::Place* place = arena.make<tree::Place>();
    place->kind = tree::PlaceKind::Temporary;
    place->type = operand.type();
    place->range = operand.expr->range;
    place->value = operand.expr;
    return place;
}

tree::Place* Checker::rootOf(tree::Place* place) {
    while (place->base) place = place->base;
    return place;
}

void Checker::takeAddress(tree::Place* place) {
    tree::Place* root = rootOf(place);
    if (root->kind == tree::PlaceKind::Local && function && root->local < function->locals.size() &&
        !function->locals[root->local].isInOut)
        function->locals[root->local].isAddressTaken = true;
}

bool Checker::hasAddress(const tree::Place* place) const {
    if (place->bit >= 0) return false;
    for (const tree::Place* at = place; at; at = at->base) {
        if (at->kind == tree::PlaceKind::Bit || at->kind == tree::PlaceKind::TextIndex ||
            at->kind == tree::PlaceKind::Temporary)
            return false;
    }
    return true;
}

uint32_t Checker::newLocal(std::string name, TypeId type, bool isInOut) {
    tree::Local local;
    local.name = std::move(name);
    local.type = type;
    local.isHidden = true;
    local.isInOut = isInOut;
    function->locals.push_back(std::move(local));
    return static_cast<uint32_t>(function->locals.size() - 1);
}

uint32_t Checker::temporaryOf(Variable& variable) {
    if (const auto it = temporaries.find(&variable); it != temporaries.end()) return it->second;
    const uint32_t local = newLocal(variable.name, variable.type);
    tree::Local& made = function->locals[local];
    made.isHidden = false;
    made.declaration = variable.range;
    temporaries.emplace(&variable, local);
    if (variable.declaration && variable.declaration->initial && !types.isAggregate(variable.type)) {
        const Operand initial = converted(expression(*variable.declaration->initial, variable.type), variable.type);
        if (!initial.isUnknown()) function->locals[local].initial = initial.expr;
    } else if (variable.declaration && variable.declaration->initial) {
        const Operand initial = aggregate(*variable.declaration->initial, variable.type);
        if (!initial.isUnknown()) function->locals[local].initial = initial.expr;
    }
    return local;
}

} // namespace plc::sema
