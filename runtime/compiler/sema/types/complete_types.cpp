// Types are completed: sizes, fields, values of enumerations, initial bytes. Separate from resolving names, so that a
// pointer may name a type that holds it; a type that needs itself here is a cycle.
#include "runtime/compiler/sema/types/type_specs.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/layout/initial_values.h"
#include "runtime/compiler/sema/layout/relative_addresses.h"
#include "runtime/compiler/sema/layout/units.h"
#include "runtime/compiler/sema/program/analyze.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"

#include <cstring>

namespace plc::sema {

using syntax::TypeSpecKind;
using types::TypeTable;

static bool completeArray(WorldBuilder& world, TypeId type, SourceRange usedAt);
static void completeAlias(WorldBuilder& world, DeclaredType& type, SourceRange usedAt);

///   ok:    A : STRUCT b : REF_TO A; END_STRUCT      wrong: A : STRUCT b : A; END_STRUCT  (P3003)
void reportCycle(WorldBuilder& world, TypeId type, SourceRange usedAt) {
    const types::Type& t = world.types[type];
    world.emit(usedAt.file.isValid() ? usedAt : t.declaration, findings::TypeCycle(t.name));
}

/// What is being completed already needs itself; so deep a chain of others is reported before it ends the stack.
template <class Complete>
static bool completeOnce(WorldBuilder& world, TypeId type, Progress progress, SourceRange usedAt, Complete complete) {
    // Met again on the way down: the type contains itself.
    if (progress == Progress::Working) {
        reportCycle(world, type, usedAt);
        return false;
    }
    const Waiting wait(world.completing, 1, kMaximumNesting + kMaximumBases);
    if (wait.isTooDeep) {
        world.emit(usedAt, findings::NestedTooDeep());
        return false;
    }
    complete();
    return !world.tooLarge.contains(type);
}

bool completeType(WorldBuilder& world, TypeId type, SourceRange usedAt) {
    const TypeKind kind = world.types.kind(type);
    if (types::isElementary(kind)) return true;
    if (world.tooLarge.contains(type)) return false;
    // An alias with an initial value is a type of its own and completed like one.
    if (const auto alias = world.aliasesByType.find(type); alias != world.aliasesByType.end()) {
        completeAlias(world, *alias->second, usedAt);
        return world.types[type].size != 0;
    }
    if (kind == TypeKind::Array && world.aliasOf.count(type)) return true; // has its own initial value
    switch (kind) {
    case TypeKind::Enum:
        if (const auto it = world.enumsByType.find(type); it != world.enumsByType.end())
            completeEnum(world, *it->second);
        return true;
    case TypeKind::Array:
        return completeArray(world, type, usedAt);
    case TypeKind::Struct:
    case TypeKind::Union: {
        const auto it = world.structsByType.find(type);
        if (it == world.structsByType.end()) return true;
        StructType& made = *it->second;
        return completeOnce(world, type, made.progress, usedAt, [&] { completeStruct(world, made); });
    }
    case TypeKind::Block: {
        Unit* unit = world.unitOf(type);
        if (!unit) return true;
        return completeOnce(world, type, unit->layoutProgress, usedAt, [&] { completeUnit(world, *unit, usedAt); });
    }
    default:
        return true;
    }
}

bool completeType(const Check& check, TypeId type, SourceRange usedAt) {
    return check.builder ? completeType(*check.builder, type, usedAt) : !check.world.tooLarge.contains(type);
}

bool completeArray(WorldBuilder& world, TypeId type, SourceRange usedAt) {
    const bool good = completeType(world, world.types[type].element, usedAt);
    const types::Type& element = world.types[world.types[type].element];
    noteNesting(world, type, 1 + nestingOf(world, world.types[type].element));
    if (nestingOf(world, type) > kMaximumNesting) {
        world.emit(usedAt, findings::NestedTooDeep());
        return false;
    }
    // Again when the element got initial bytes only after the array was laid out.
    if (world.types[type].size != 0 && world.types[type].initial.empty() == element.initial.empty()) return good;
    world.types.layoutArray(type);
    return checkSize(world, type, usedAt) && good;
}

void completeAlias(WorldBuilder& world, DeclaredType& declared, SourceRange usedAt) {
    const TypeId behind = world.aliasOf[declared.type];
    // First, so that asking for it again below does not start over.
    world.aliasesByType.erase(declared.type);
    completeType(world, behind, usedAt);
    noteNesting(world, declared.type, nestingOf(world, behind));
    types::Type& type = world.types.edit(declared.type);
    const types::Type& original = world.types[behind];
    // Everything of the original but its name: a copy, so that its initial value can differ.
    if (type.kind != TypeKind::Subrange) {
        std::string name = std::move(type.name);
        std::string space = std::move(type.space);
        const SourceRange range = type.declaration;
        std::string comment = std::move(type.comment);
        type = original;
        type.name = std::move(name);
        type.space = std::move(space);
        type.declaration = range;
        type.comment = std::move(comment);
        if (const auto it = world.structsByType.find(behind); it != world.structsByType.end())
            world.structsByType[declared.type] = it->second;
    }
    InitialValue initial;
    initial.bytes = original.initial;
    initial.bytes.resize(original.size);
    initialise(world, initial, behind, 0, -1, declared.declaration->initial, declared.scope, nullptr);
    world.types.edit(declared.type).initial = initial.bytes;
    checkSize(world, declared.type, declared.declaration->name.range);
    if (!initial.dynamics.empty()) world.typeInitials[declared.type].dynamics = std::move(initial.dynamics);
}

/// The integer that is written for an enumeration, else INT.
static TypeId baseOfEnum(WorldBuilder& world, const EnumType& enumeration) {
    const syntax::TypeSpec& spec = *enumeration.spec;
    const TypeId usual = TypeTable::of(TypeKind::Int);
    if (!spec.element && spec.path.empty()) return usual;
    const TypeId named = spec.element ? resolveSpec(world, spec.element, enumeration.scope)
                                      : resolveNamed(world, spec.path, enumeration.scope, spec.range);
    if (types::isInteger(world.types.family(named))) return world.types.storage(named);
    if (world.types.kind(named) != TypeKind::Unknown)
        world.emit(spec.element ? spec.element->range : spec.range,
                   findings::OperatorNotForType(phrases::AnEnumeration(), world.nameOf(named)));
    return usual;
}

/// The values: as written, else one more than the one before.
static void numberEnumerators(WorldBuilder& world, const EnumType& enumeration, TypeId base) {
    const syntax::TypeSpec& spec = *enumeration.spec;
    const auto [least, greatest] = TypeTable::integerRange(world.types.kind(base));
    // The first is 0 unless it says something else (table 12 of edition 2).
    int64_t next = 0;
    for (size_t i = 0; i < spec.enumerators.size(); ++i) {
        const syntax::EnumeratorDecl& declared = spec.enumerators[i];
        if (declared.value) {
            if (const auto value = constantInteger(world, declared.value, enumeration.scope)) next = *value;
        }
        if (next < least || (next > 0 && static_cast<uint64_t>(next) > greatest))
            world.emit(declared.value ? declared.value->range : declared.name.range,
                       findings::ConstantOutOfRange(std::to_string(next), world.nameOf(base)));
        world.types.edit(enumeration.type).enumerators[i].value = next;
        // Without a sign: one more than the greatest wraps instead of being undefined, and was reported already.
        next = static_cast<int64_t>(static_cast<uint64_t>(next) + 1);
    }
}

/// What a variable of the type has at first: the initial value of the type, else the first of its values.
static int64_t initialOfEnum(WorldBuilder& world, const EnumType& enumeration) {
    const std::vector<types::Enumerator>& all = world.types[enumeration.type].enumerators;
    const int64_t first = all.empty() ? 0 : all.front().value;
    if (!enumeration.initial) return first;
    Context checker(world, enumeration.scope, world.sink, world.arena);
    const Operand value =
        converted(checker, expression(checker, *enumeration.initial, enumeration.type), enumeration.type);
    if (value.isConstant() && std::holds_alternative<int64_t>(value.expr->value.data))
        return value.expr->value.integer();
    if (!value.isUnknown()) world.emit(enumeration.initial->range, findings::NotConstant());
    return first;
}

void completeEnum(WorldBuilder& world, EnumType& enumeration) {
    if (enumeration.progress != Progress::Open) return;
    // A value may name an enumerator of another enumeration, whose value names …
    const Waiting wait(world.waiting, 8);
    if (wait.isTooDeep) return (void)world.emit(enumeration.spec->range, findings::NestedTooDeep());
    // Enumerations that need each other end here: Working is not Open, and a value that is not known yet counts as 0.
    enumeration.progress = Progress::Working;
    const TypeId base = baseOfEnum(world, enumeration);
    world.types.edit(enumeration.type).element = base;
    world.types.edit(enumeration.type).size = world.types[base].size;
    world.types.edit(enumeration.type).align = world.types[base].align;
    numberEnumerators(world, enumeration, base);
    enumeration.progress = Progress::Done;
    const int64_t first = initialOfEnum(world, enumeration);
    // No bytes mean zeros.
    if (first == 0) return;
    types::Type& type = world.types.edit(enumeration.type);
    type.initial.resize(type.size);
    std::memcpy(type.initial.data(), &first, type.size);
}

void completeEnum(const Check& check, EnumType& enumeration) {
    if (check.builder) completeEnum(*check.builder, enumeration);
}

/// A field by its name; of a structure without a search, because a machine's whole data may be one.
const types::Field* fieldOf(const World& world, TypeId type, std::string_view name) {
    // By a table where there is one: a search through 10,000 fields for each use of one was seen in a generated
    // program.
    const auto made = world.structsByType.find(type);
    if (made == world.structsByType.end() || made->second->indices.empty()) return world.types[type].findField(name);
    const auto found = made->second->indices.find(world.names.find(name));
    return found == made->second->indices.end() ? nullptr : &world.types[type].fields[found->second];
}

namespace {

/// The fields of a structure while they are gathered, its base's first.
struct Fields {
    std::vector<types::Field> all;
    std::vector<const syntax::VarDecl*> declarations; // of its own, behind the inherited ones
    std::unordered_set<NameId> known;
    size_t inherited = 0;
    uint32_t nesting = 0;
};

/// EXTENDS: the base's fields lie at the beginning. Invalid: none.
TypeId inheritFields(WorldBuilder& world, StructType& made, Fields& fields) {
    if (!made.spec->extends) return {};
    const TypeId base = resolveSpec(world, made.spec->extends, made.scope);
    if (world.types.kind(base) != TypeKind::Struct) {
        if (world.types.kind(base) != TypeKind::Unknown)
            world.emit(made.spec->extends->range, findings::NotExtendable(world.nameOf(base), made.name));
        return {};
    }
    if (!completeType(world, base, made.spec->extends->range)) return base;
    // A copy, with the same offsets: a pointer to the structure is a pointer to its base.
    fields.all = world.types[base].fields;
    fields.inherited = fields.all.size();
    fields.nesting = nestingOf(world, base); // its base is laid out and initialised as a part of it
    for (const types::Field& field : fields.all) fields.known.insert(world.key(field.name));
    if (const auto it = world.structsByType.find(base); it != world.structsByType.end())
        made.symbols = it->second->symbols;
    return base;
}

/// The type of a field, complete; Unknown after an error.
TypeId fieldType(WorldBuilder& world, const StructType& made, const syntax::VarDecl& declaration) {
    const TypeId type = resolvePart(world, declaration.type, made.scope);
    const SourceRange at = declaration.type ? declaration.type->range : declaration.range;
    // Fields are stored in the structure, so their size is needed now.
    if (!completeType(world, type, at)) return TypeTable::of(TypeKind::Unknown);
    if (nestingOf(world, type) < kMaximumNesting) return type;
    world.emit(at, findings::NestedTooDeep());
    return TypeTable::of(TypeKind::Unknown);
}

/// BIT: one of eight in a byte; elsewhere it is a BOOL.
bool isBitField(const World& world, const syntax::VarDecl& declaration, TypeId type) {
    const syntax::TypeSpec* spec = declaration.type;
    return spec && spec->kind == TypeSpecKind::Named && spec->path.size() == 1 &&
           equalsIgnoringCase(spec->path.front().text, "BIT") && world.types.kind(type) == TypeKind::Bool;
}

///   wrong: STRUCT a : INT; a : REAL; END_STRUCT  (P3001)
void addFields(WorldBuilder& world, StructType& made, const syntax::VarDecl& declaration, Fields& fields) {
    const TypeId type = fieldType(world, made, declaration);
    fields.nesting = std::max(fields.nesting, 1 + nestingOf(world, type));
    for (const syntax::Name& name : declaration.names) {
        if (!fields.known.insert(world.key(name.text)).second) {
            world.emit(name.range, findings::DuplicateName(name.text));
            continue;
        }
        types::Field field;
        field.name = std::string(name.text);
        field.type = type;
        field.declaration = name.range;
        field.comment = std::string(declaration.comment);
        // 0 means "a bit, somewhere": layoutFields deals out the bits of a byte in order.
        field.bit = isBitField(world, declaration, type) ? 0 : -1;
        for (const syntax::Pragma& pragma : declaration.pragmas)
            if (pragma.isAttribute && equalsIgnoringCase(pragma.key, "alias")) field.aliases.emplace_back(pragma.value);
        fields.all.push_back(std::move(field));
        fields.declarations.push_back(&declaration);
        made.symbols.push_back(
            addSymbol(world, SymbolKind::Variable, name.text, made.name, name.range, declaration.comment));
        world.symbols.back().type = type;
    }
}

/// The initial bytes: the base's, then each field's own.
InitialValue initialOfFields(WorldBuilder& world, const StructType& made, TypeId base, const Fields& fields) {
    InitialValue initial;
    initial.bytes = world.types[made.type].initial;
    initial.bytes.resize(world.types[made.type].size);
    if (fields.inherited && !world.types[base].initial.empty())
        std::memcpy(initial.bytes.data(), world.types[base].initial.data(),
                    std::min(initial.bytes.size(), world.types[base].initial.size()));
    if (const auto it = world.typeInitials.find(base); fields.inherited && it != world.typeInitials.end())
        initial.dynamics = it->second.dynamics;
    Scope scope = made.scope;
    scope.structure = made.type;
    for (size_t i = fields.inherited; i < world.types[made.type].fields.size(); ++i) {
        const types::Field field = world.types[made.type].fields[i]; // a copy: completing others moves the table
        const syntax::VarDecl& declaration = *fields.declarations[i - fields.inherited];
        initialiseDeclared(world, initial, field.type, field.offset, field.bit, declaration.initial, scope,
                           declaration.type);
    }
    return initial;
}

void initialiseStruct(WorldBuilder& world, StructType& made, TypeId base, const Fields& fields) {
    InitialValue initial = initialOfFields(world, made, base, fields);
    const bool isZero =
        std::all_of(initial.bytes.begin(), initial.bytes.end(), [](std::byte b) { return b == std::byte{}; });
    world.types.edit(made.type).initial = isZero ? std::vector<std::byte>{} : initial.bytes;
    world.typeInitials[made.type].dynamics = std::move(initial.dynamics);
    // Done before its own initial value, which may be a list of the type itself.
    made.progress = Progress::Done;
    if (!made.initial) return;
    InitialValue whole; // TYPE T : STRUCT … END_STRUCT := (a := 1)
    whole.bytes = world.types[made.type].initial;
    whole.bytes.resize(world.types[made.type].size);
    initialise(world, whole, made.type, 0, -1, made.initial, made.scope, nullptr);
    world.types.edit(made.type).initial = whole.bytes;
    std::vector<DynamicInit>& dynamics = world.typeInitials[made.type].dynamics;
    for (const DynamicInit& dynamic : whole.dynamics)
        if (!dynamic.isConstruction || dynamic.type != made.type) dynamics.push_back(dynamic);
}

} // namespace

// Fields, then places, then initial bytes: each step needs the one before it of every field.
void completeStruct(WorldBuilder& world, StructType& made) {
    if (made.progress != Progress::Open) return;
    made.progress = Progress::Working;
    Fields fields;
    const TypeId base = inheritFields(world, made, fields);
    for (const syntax::VarDecl* declaration : made.spec->fields) addFields(world, made, *declaration, fields);
    locateMembers(world, made, fields.all, fields.inherited, fields.declarations);
    // Only here: everything above may add types, which moves the table.
    types::Type& type = world.types.edit(made.type);
    type.base = base;
    type.fields = std::move(fields.all);
    noteNesting(world, made.type, fields.nesting);
    world.types.layoutFields(made.type);
    const SourceRange declared = world.types[made.type].declaration;
    if (!checkSize(world, made.type, declared.file.isValid() ? declared : made.spec->range)) {
        made.progress = Progress::Done;
        return;
    }
    for (uint32_t i = 0; i < type.fields.size(); ++i) {
        made.indices.try_emplace(world.key(type.fields[i].name), i);
        for (const std::string& alias : type.fields[i].aliases) made.indices.try_emplace(world.key(alias), i);
    }
    if (std::any_of(type.fields.begin(), type.fields.end(), [](const types::Field& f) { return f.isLocated; }))
        for (types::Field& field : type.fields) field.isLocated = true; // where it lies for those that extend it
    initialiseStruct(world, made, base, fields);
}

} // namespace plc::sema
