// Inputs of CODESYS's ANY types. The block receives a structure of type class, address and size, so any variable can
// be connected; what it does with the bytes is its own business.
#include "runtime/compiler/sema/calls/any_inputs.h"

#include "runtime/compiler/sema/calls/special_calls.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/statements/statements.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"

namespace plc::sema {
namespace {

using types::Family;

// Names and not tokens: the standard has ANY_NUM and the others only in its tables, as the types of standard functions,
// so a variable of somebody may be called so.
constexpr std::string_view kFamilies[] = {"ANY", "ANY_NUM", "ANY_INT", "ANY_REAL", "ANY_BIT", "ANY_STRING", "ANY_DATE"};

// Only inputs: an output or a local of the type would be a structure whose pointer nobody has set. A result counts as
// no input although GET accessors keep theirs in a variable.
/// "ANY_NUM"; "" of another type.
std::string_view familyOf(const Variable& variable) {
    if (variable.kind != syntax::SectionKind::Input || !variable.spec || variable.isResult || !variable.owner ||
        variable.spec->kind != syntax::TypeSpecKind::Named || variable.spec->path.size() != 1)
        return {};
    for (const std::string_view each : kFamilies)
        if (equalsIgnoringCase(variable.spec->path.front().text, each)) return each;
    return {};
}

// Figure 5 of edition 3 (6.4.3), flattened: what a branch of the tree holds.
bool belongs(const Context& context, TypeId type, std::string_view family) {
    const Family own = context.types.family(type);
    const bool isBits = own == Family::Bits || own == Family::Bool;
    const bool isWhole = own == Family::Signed || own == Family::Unsigned;
    if (family == "ANY") return true;
    if (family == "ANY_NUM") return isWhole || own == Family::Real;
    if (family == "ANY_INT") return isWhole;
    if (family == "ANY_REAL") return own == Family::Real;
    if (family == "ANY_BIT") return isBits;
    if (family == "ANY_STRING") return context.types.isText(type);
    return own == Family::Date;
}

} // namespace

int64_t typeClassOf(const types::TypeTable& types, TypeId type) {
    switch (types.kind(type)) {
    case TypeKind::Bool:
        return 0;
    case TypeKind::Byte:
        return 2;
    case TypeKind::Word:
        return 3;
    case TypeKind::Dword:
        return 4;
    case TypeKind::Lword:
        return 5;
    case TypeKind::Sint:
        return 6;
    case TypeKind::Int:
        return 7;
    case TypeKind::Dint:
        return 8;
    case TypeKind::Lint:
        return 9;
    case TypeKind::Usint:
        return 10;
    case TypeKind::Uint:
        return 11;
    case TypeKind::Udint:
        return 12;
    case TypeKind::Ulint:
        return 13;
    case TypeKind::Real:
        return 14;
    case TypeKind::Lreal:
        return 15;
    case TypeKind::String:
        return 16;
    case TypeKind::Wstring:
        return 17;
    case TypeKind::Time:
        return 18;
    case TypeKind::Pointer:
        return 22;
    case TypeKind::Reference:
        return 23;
    case TypeKind::Subrange:
        return 24;
    case TypeKind::Enum:
        return 25;
    case TypeKind::Array:
        return 26;
    default:
        // The class of USERDEF; programs compare with it to refuse what they do not know.
        return 28; // a type of the user, a date
    }
}

// The structure has an address, so what is only a value (a sum, a literal, a bit) needs a variable for as long as the
// call lasts.
/// The argument's place; a value is kept in a local. Null: it was reported.
tree::Place* placeOfArgument(Context& context, const syntax::Expr& argument, std::vector<tree::Stmt*>& before) {
    const Denoted denoted = denote(context, argument, Access::Read);
    if (denoted.kind == Denoted::Kind::Nothing) return nullptr;
    if (denoted.kind == Denoted::Kind::Place && hasAddress(denoted.place)) return denoted.place;
    const Operand given = settled(context, value(context, denoted, argument, {}));
    if (given.isUnknown()) return nullptr;
    tree::Place* kept = localPlace(context, newLocal(context, "argument", given.type()), given.type(), argument.range);
    before.push_back(assignStmt(context, kept, given.expr, {}));
    return kept;
}

bool isAnyInput(const World& world, const Variable& variable) {
    return world.anyInput.isValid() && variable.type == world.anyInput;
}

TypeId anyInputType(WorldBuilder& world, const Variable& variable) {
    if (familyOf(variable).empty()) return {};
    // One structure serves all ANY types: which family is accepted is decided by the declared name at each call.
    if (world.anyInput.isValid()) return world.anyInput;
    world.anyInput = world.types.declare(TypeKind::Struct, "ANY");
    const TypeId pointer = world.types.pointer(types::TypeTable::of(TypeKind::Byte));
    types::Type& type = world.types.edit(world.anyInput);
    const std::pair<const char*, TypeId> fields[] = {{"TypeClass", types::TypeTable::of(TypeKind::Int)},
                                                     {"pValue", pointer},
                                                     {"diSize", types::TypeTable::of(TypeKind::Dint)}};
    for (const auto& [name, fieldType] : fields) {
        types::Field field;
        field.name = name;
        field.type = fieldType;
        type.fields.push_back(std::move(field));
    }
    world.types.layoutFields(world.anyInput, 0);
    return world.anyInput;
}

///   ok:    F(x)  with VAR_INPUT a : ANY_NUM and x : REAL      wrong: F('x')  (P2003)
Operand anyArgument(Context& context, const Variable& parameter, const syntax::Expr& argument) {
    // Outside of a body (in an initial value, in a watch) there is no frame that could hold the structure.
    if (!context.function) return unknown(context, argument.range);
    tree::Expr* sequence = newSequence(context, context.world.anyInput, argument.range);
    tree::Place* place = placeOfArgument(context, argument, sequence->statements);
    if (!place || context.isKind(place->type, TypeKind::Unknown)) return unknown(context, argument.range);
    if (!belongs(context, place->type, familyOf(parameter))) {
        context.emit(argument.range, findings::TypeMismatch(context.nameOf(place->type), familyOf(parameter)));
        return unknown(context, argument.range);
    }
    const TypeId type = context.world.anyInput;
    tree::Place* made = localPlace(context, newLocal(context, "any", type), type, argument.range);
    const auto set = [&](const char* name, const auto& valueOf) {
        const types::Field* field = context.types[type].findField(name);
        tree::Place* at = fieldPlace(context, made, field->offset, field->type, -1, argument.range);
        sequence->statements.push_back(assignStmt(context, at, valueOf(field->type).expr, {}));
    };
    // The size is the variable's own, not the capacity's rounded one: MEMCPY with diSize copies exactly the variable.
    const int64_t size = context.types[place->type].size, number = typeClassOf(context.types, place->type);
    set("TypeClass", [&](TypeId t) { return constant(context, {t, number}, argument.range); });
    set("pValue", [&](TypeId t) { return addressOf(context, place, t, argument.range); });
    set("diSize", [&](TypeId t) { return constant(context, {t, size}, argument.range); });
    sequence->a = load(context, made, argument.range).expr;
    return {sequence, &context.types};
}

} // namespace plc::sema
