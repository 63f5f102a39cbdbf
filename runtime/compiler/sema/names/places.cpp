// Places: how storage is named in the checked tree. Constant offsets are added up as far as they go.
#include "runtime/compiler/sema/names/places.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/values/expressions.h"

namespace plc::sema {

tree::Place* absolutePlace(Context& context, uint32_t offset, TypeId type, int16_t bit, SourceRange range) {
    tree::Place* place = context.arena.make<tree::Place>();
    place->kind = tree::PlaceKind::Absolute;
    place->type = type;
    place->range = range;
    place->offset = offset;
    place->bit = bit;
    return place;
}

tree::Place* localPlace(Context& context, uint32_t local, TypeId type, SourceRange range) {
    tree::Place* place = context.arena.make<tree::Place>();
    place->kind = tree::PlaceKind::Local;
    place->type = type;
    place->range = range;
    place->local = local;
    return place;
}

tree::Place* thisPlace(Context& context, SourceRange range) {
    Unit* self = context.scope.unit ? context.scope.unit->self() : nullptr;
    const TypeId type = context.scope.structure.isValid() ? context.scope.structure
                        : self                            ? self->type
                                                          : context.elementary(TypeKind::Unknown);
    // A watch expression has no THIS; it is seen from an instance whose place is known.
    if (context.instanceBase) return absolutePlace(context, *context.instanceBase, type, -1, range);
    tree::Place* place = absolutePlace(context, 0, type, -1, range);
    place->kind = tree::PlaceKind::Instance;
    return place;
}

tree::Place* fieldPlace(Context& context, tree::Place* base, uint32_t offset, TypeId type, int16_t bit,
                        SourceRange range) {
    tree::Place* place = context.arena.make<tree::Place>();
    place->type = type;
    place->range = range;
    place->bit = bit;
    // One place for a.b.c instead of three: code and debugger see a constant offset.
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

tree::Place* dereferenced(Context& context, tree::Place* reference, SourceRange range) {
    return referredBy(context, load(context, reference, range), range);
}

// Null is checked by the code that reads or writes through it, with the place that is written here.
tree::Place* referredBy(Context& context, const Operand& reference, SourceRange range) {
    tree::Place* place = context.arena.make<tree::Place>();
    place->kind = tree::PlaceKind::Deref;
    place->type = context.types[reference.type()].element;
    place->range = range;
    place->pointer = reference.expr;
    return place;
}

// F().x and (a + b).3: the value is kept for as long as the expression.
tree::Place* temporary(Context& context, const Operand& operand) {
    tree::Place* place = context.arena.make<tree::Place>();
    place->kind = tree::PlaceKind::Temporary;
    place->type = operand.type();
    place->range = operand.expr->range;
    place->value = operand.expr;
    return place;
}

tree::Place* rootOf(tree::Place* place) {
    while (place->base) place = place->base;
    return place;
}

void takeAddress(Context& context, tree::Place* place) {
    // It is then kept in the frame, in the image; others may be registers, which nothing can point to.
    tree::Place* root = rootOf(place);
    if (root->kind == tree::PlaceKind::Local && context.function && root->local < context.function->locals.size() &&
        !context.function->locals[root->local].isInOut)
        context.function->locals[root->local].isAddressTaken = true;
}

// Addresses are those of bytes: bits have none, characters of texts are of a text's own layout, temporaries end with
// their expression.
bool hasAddress(const tree::Place* place) {
    if (place->bit >= 0) return false;
    for (const tree::Place* at = place; at; at = at->base) {
        if (at->kind == tree::PlaceKind::Bit || at->kind == tree::PlaceKind::TextIndex ||
            at->kind == tree::PlaceKind::Temporary)
            return false;
    }
    return true;
}

uint32_t newLocal(Context& context, std::string name, TypeId type, bool isInOut) {
    tree::Local local;
    local.name = std::move(name);
    local.type = type;
    // Made by the compiler: shown nowhere, but recorded with the frame like any other.
    local.isHidden = true;
    local.isInOut = isInOut;
    context.function->locals.push_back(std::move(local));
    return static_cast<uint32_t>(context.function->locals.size() - 1);
}

// VAR_TEMP of a block is a local of its body and of each action, made when it is first named: bodies that do not use it
// have nothing to initialise.
uint32_t temporaryOf(Context& context, Variable& variable) {
    if (const auto it = context.temporaries.find(&variable); it != context.temporaries.end()) return it->second;
    const uint32_t local = newLocal(context, variable.name, variable.type);
    tree::Local& made = context.function->locals[local];
    made.isHidden = false;
    made.declaration = variable.range;
    // Before its initial value is checked, which may name it.
    context.temporaries.emplace(&variable, local);
    if (variable.declaration && variable.declaration->initial && !context.types.isAggregate(variable.type)) {
        const Operand initial =
            converted(context, expression(context, *variable.declaration->initial, variable.type), variable.type);
        if (!initial.isUnknown()) context.function->locals[local].initial = initial.expr;
    } else if (variable.declaration && variable.declaration->initial) {
        const Operand initial = aggregate(context, *variable.declaration->initial, variable.type);
        if (!initial.isUnknown()) context.function->locals[local].initial = initial.expr;
    }
    return local;
}

} // namespace plc::sema
