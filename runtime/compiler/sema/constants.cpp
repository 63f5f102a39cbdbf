// Constants: folded when first asked for, in any order, across units.
#include "runtime/compiler/sema/checker.h"

namespace plc::sema {

const types::Value* World::constantOf(Variable& variable) {
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
    const TypeId type = typeOf(variable);
    variable.folding = Folding::Working;
    if (!completeType(type, variable.range) || types.kind(type) == TypeKind::Unknown) {
        variable.folding = Folding::Dynamic;
        return nullptr;
    }
    const syntax::Expr* initial = variable.declaration ? variable.declaration->initial : nullptr;
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
