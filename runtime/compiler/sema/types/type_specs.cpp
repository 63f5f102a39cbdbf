// Type specifications → TypeIds. A name is resolved when asked for; sizes are completed separately (completeType), so
// that a pointer may name a type that holds it.
#include "runtime/compiler/sema/types/type_specs.h"

#include "runtime/compiler/sema/calls/any_inputs.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/declare/configuration.h"
#include "runtime/compiler/sema/declare/declare.h"
#include "runtime/compiler/sema/declare/generic_blocks.h"
#include "runtime/compiler/sema/layout/initial_values.h"
#include "runtime/compiler/sema/layout/relative_addresses.h"
#include "runtime/compiler/sema/layout/units.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/program/analyze.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"

#include <cstring>

namespace plc::sema {

using syntax::TypeSpecKind;
using types::TypeTable;

static TypeId resolveArray(WorldBuilder& world, const syntax::TypeSpec& spec, const Scope& scope);
static TypeId nested(WorldBuilder& world, TypeId type, SourceRange range);
static uint64_t neededBytes(const World& world, TypeId type);
static TypeId resolveSubrange(WorldBuilder& world, const syntax::TypeSpec& spec, const Scope& scope);

namespace {

struct ElementaryName {
    std::string_view name;
    TypeKind kind;
};
// Those of the standard from the list, then long forms (table 10), then what CODESYS calls the widths of its machine:
// 64 bits here.
constexpr ElementaryName kElementaryNames[] = {
#define PLC_ELEMENTARY(Name, Spelling, Bytes, Family) {Spelling, TypeKind::Name},
#include "runtime/types/elementary.def"
    {"TIME_OF_DAY", TypeKind::Tod},    {"DATE_AND_TIME", TypeKind::Dt}, {"LTIME_OF_DAY", TypeKind::Ltod},
    {"LDATE_AND_TIME", TypeKind::Ldt}, {"BIT", TypeKind::Bool},         {"FLOAT", TypeKind::Real},
    {"__UXINT", TypeKind::Ulint},      {"__XINT", TypeKind::Lint},      {"__XWORD", TypeKind::Lword},
};

} // namespace

std::optional<TypeKind> elementaryNamed(std::string_view name) {
    for (const ElementaryName& entry : kElementaryNames)
        if (entry.name.size() == name.size() && equalsIgnoringCase(entry.name, name)) return entry.kind;
    return std::nullopt;
}

///   ok:    ARRAY[1..3] OF INT      wrong: ARRAY[1..x] OF INT  with a variable x (P2019)
std::optional<int64_t> constantInteger(const Check& check, const syntax::Expr* expr, const Scope& scope) {
    if (!expr) return std::nullopt;
    // While bodies are checked the World is const and nobody waits: bounds are resolved by then.
    uint32_t none = 0;
    const Waiting wait(check.builder ? check.builder->waiting : none, expr->height);
    if (wait.isTooDeep) {
        check.emit(expr->range, findings::NestedTooDeep());
        return std::nullopt;
    }
    Context checker(check, scope, check.gathered.sink, check.gathered.arena);
    const Operand operand = expression(checker, *expr);
    if (operand.isUnknown()) return std::nullopt;
    if (!operand.isConstant() || !std::holds_alternative<int64_t>(operand.expr->value.data)) {
        check.emit(expr->range, findings::NotConstant());
        return std::nullopt;
    }
    return operand.expr->value.integer();
}

namespace {

/// What other languages call the elementary types.
std::string_view ownNameOf(std::string_view foreign) {
    static constexpr std::pair<std::string_view, std::string_view> rows[] = {
        {"BOOLEAN", "BOOL"}, {"BIT", "BOOL"},      {"INTEGER", "INT"},  {"SHORT", "INT"},   {"LONG", "DINT"},
        {"INT8", "SINT"},    {"INT16", "INT"},     {"INT32", "DINT"},   {"INT64", "LINT"},  {"UINT8", "USINT"},
        {"UINT16", "UINT"},  {"UINT32", "UDINT"},  {"UINT64", "ULINT"}, {"FLOAT", "REAL"},  {"FLOAT32", "REAL"},
        {"SINGLE", "REAL"},  {"FLOAT64", "LREAL"}, {"DOUBLE", "LREAL"}, {"TEXT", "STRING"}, {"DATETIME", "DT"},
        {"TIMESPAN", "TIME"}};
    for (const auto& [name, own] : rows)
        if (equalsIgnoringCase(foreign, name)) return own;
    return {};
}

} // namespace

///   wrong: x : Motr;  where nothing is called so (P3002)
TypeId resolveNamed(const Check& check, const syntax::Path& path, const Scope& scope, SourceRange range) {
    const TypeId unknown = TypeTable::of(TypeKind::Unknown);
    if (path.empty()) return unknown;
    // Before elementary names: a type of the user may be called like one of CODESYS's (BIT, FLOAT).
    const Found found = lookupPath(check.world, scope, path);
    if (path.size() == 1) {
        const std::string_view name = path.front().text;
        const bool hidden = found.entity.type || (found.entity.unit && found.entity.unit->type.isValid());
        if (!hidden) {
            if (const auto kind = elementaryNamed(name)) return TypeTable::of(*kind);
            if (equalsIgnoringCase(name, "STRING")) return check.gathered.types.string(80);
            if (equalsIgnoringCase(name, "WSTRING")) return check.gathered.types.wstring(80);
        }
    }
    std::string text;
    for (const syntax::Name& name : path) text += (text.empty() ? "" : ".") + std::string(name.text);
    if (!found.ambiguous.empty() && (found.entity.type || found.entity.unit)) {
        std::vector<std::string> all;
        for (const std::string& where : found.ambiguous) all.push_back(where + "." + text);
        auto& diagnostic = check.emit(range, findings::AmbiguousName(text, all));
        for (const std::string& where : found.ambiguous)
            diagnostic.fixes.push_back({fixes::Write(where + "." + text), {{range, where + "." + text}}});
        return unknown;
    }
    if (found.entity.type) {
        refer(check, path.back().range, found.entity.type->symbol, true, false);
        return resolveDeclared(check, *found.entity.type);
    }
    if (found.entity.unit && found.entity.unit->type.isValid()) {
        refer(check, path.back().range, found.entity.unit->symbol, true, false);
        return found.entity.unit->type;
    }
    // "int32" comes from somebody who knows other languages: the fix says what it is here.
    if (const std::string own(ownNameOf(text)); !own.empty()) {
        check.emit(range, findings::UnknownType(text)).fixes.push_back({fixes::Write(own), {{range, own}}});
        return unknown;
    }
    if (path.size() > 1) { // a name of a namespace that has no such type
        const Found around = lookupPath(check.world, scope, {path.begin(), path.end() - 1});
        std::vector<std::string> names;
        if (around.space) addNames(check.world, *around.space, names);
        suggest(check.gathered, check.emit(around.space ? path.back().range : range, findings::UnknownType(text)),
                path.back().range, path.back().text, names);
        return unknown;
    }
    std::vector<std::string> candidates;
    const auto collect = [&](const Space& space) {
        for (const auto& [id, entities] : space.entities)
            for (const Entity& entity : entities) {
                if (entity.type) candidates.push_back(entity.type->name);
                if (entity.unit && entity.unit->type.isValid()) candidates.push_back(entity.unit->name);
            }
    };
    for (Space* space = scope.space; space; space = space->parent) collect(*space);
    for (Space* library : check.world.libraries) collect(*library);
    for (const ElementaryName& entry : kElementaryNames) candidates.emplace_back(entry.name);
    candidates.insert(candidates.end(), {"STRING", "WSTRING"});
    suggest(check.gathered, check.emit(range, findings::UnknownType(text)), range, text, candidates);
    return unknown;
}

/// TYPE Name : … ; a name for a type is that type. With an initial value of its own it is a copy of it, completed
/// later, because the value may need types that are not complete yet.
///   ok:    TYPE Percent : INT := 50; END_TYPE      wrong: TYPE A : B; B : A; END_TYPE  (P3003)
TypeId resolveDeclared(WorldBuilder& world, DeclaredType& declared) {
    if (declared.progress == Progress::Done) return declared.type;
    if (declared.progress == Progress::Working) {
        world.emit(declared.declaration->name.range, findings::TypeCycle(declared.name));
        return TypeTable::of(TypeKind::Unknown);
    }
    const Waiting wait(world.waiting, 4);
    if (wait.isTooDeep) {
        world.emit(declared.declaration->name.range, findings::NestedTooDeep());
        return TypeTable::of(TypeKind::Unknown);
    }
    declared.progress = Progress::Working;
    // The name is passed on for an anonymous structure, which then is the type.
    TypeId behind = resolveSpec(world, declared.declaration->spec, declared.scope, declared.name);
    if (declared.declaration->initial && world.types.kind(behind) != TypeKind::Unknown) {
        const TypeKind kind = world.types.kind(behind);
        // Elementary types are shared by all: with an initial value of its own it becomes a subrange of full width.
        const bool wraps = types::isElementary(kind) || kind == TypeKind::Subrange;
        const TypeId copy = world.types.declare(wraps ? TypeKind::Subrange : kind, declared.name);
        types::Type& type = world.types.edit(copy);
        if (wraps) {
            const types::Type& original = world.types[behind];
            type.element = original.kind == TypeKind::Subrange ? original.element : behind;
            type.low = original.kind == TypeKind::Subrange ? original.low : INT64_MIN;
            type.high = original.kind == TypeKind::Subrange ? original.high : INT64_MAX;
            type.size = original.size;
            type.align = original.align;
        } else {
            type.element = world.types[behind].element;
            type.capacity = world.types[behind].capacity;
            type.dimensions = world.types[behind].dimensions;
            type.base = world.types[behind].base;
        }
        type.declaration = declared.declaration->name.range;
        type.comment = std::string(declared.declaration->comment);
        type.space = declared.scope.space ? declared.scope.space->qualified : std::string();
        world.aliasesByType[copy] = &declared;
        // Same type for assignments (sameType follows this), another for initial values.
        world.aliasOf[copy] = behind;
        if (const auto it = world.enumsByType.find(behind); it != world.enumsByType.end())
            world.enumsByType[copy] = it->second;
        if (Unit* unit = world.unitOf(behind)) world.unitsByType[copy] = unit;
        behind = copy;
    }
    declared.type = behind;
    declared.progress = Progress::Done;
    world.symbols[declared.symbol.index()].type = behind;
    return behind;
}

TypeId resolveDeclared(const Check& check, DeclaredType& declared) {
    return check.builder ? resolveDeclared(*check.builder, declared) : declared.type;
}

/// What is written behind a colon. Only names are followed, no sizes: a pointer may name a type that holds it.
///   ok:    STRING(20)      wrong: STRING(70000)  (P2018)
TypeId resolveSpec(WorldBuilder& world, const syntax::TypeSpec* spec, const Scope& scope,
                   std::string_view anonymousName) {
    const TypeId unknown = TypeTable::of(TypeKind::Unknown);
    if (!spec) return unknown;
    switch (spec->kind) {
    case TypeSpecKind::Error:
        return unknown;
    case TypeSpecKind::Named: {
        if (spec->path.empty()) return resolveNamed(world, spec->path, scope, spec->range);
        const SourceRange range = joined(spec->path.front().range, spec->path.back().range);
        if (spec->bounds.empty()) return resolveNamed(world, spec->path, scope, range);
        const auto path = pathOfGeneric(world, *spec, scope);
        return path ? resolveNamed(world, *path, scope, range) : unknown;
    }
    case TypeSpecKind::String: {
        // STRING and WSTRING come as one kind of syntax; the word is kept as its path.
        const bool wide = !spec->path.empty() && equalsIgnoringCase(spec->path.front().text, "WSTRING");
        // The standard leaves it to the implementer; 80 is CODESYS's.
        int64_t length = 80;
        if (spec->length) {
            const auto given = constantInteger(world, spec->length, scope);
            if (given && (*given < 1 || *given > 65535))
                world.emit(spec->length->range,
                           findings::ConstantOutOfRange(std::to_string(*given),
                                                        std::string(wide ? "WSTRING" : "STRING") + "(1..65535)"));
            else if (given)
                length = *given;
        }
        return wide ? world.types.wstring(static_cast<uint32_t>(length))
                    : world.types.string(static_cast<uint32_t>(length));
    }
    case TypeSpecKind::Array:
        return resolveArray(world, *spec, scope);
    case TypeSpecKind::OpenArray: {
        const TypeId element = resolvePart(world, spec->element, scope);
        return world.types.kind(element) == TypeKind::Unknown
                   ? unknown
                   : nested(world, world.types.openArray(std::max<size_t>(1, spec->bounds.size()), element),
                            spec->range);
    }
    case TypeSpecKind::Pointer:
    case TypeSpecKind::RefTo: {
        const TypeId target = resolvePart(world, spec->element, scope);
        return world.types.kind(target) == TypeKind::Unknown ? unknown
                                                             : nested(world, world.types.pointer(target), spec->range);
    }
    case TypeSpecKind::Reference: {
        const TypeId target = resolvePart(world, spec->element, scope);
        return world.types.kind(target) == TypeKind::Unknown
                   ? unknown
                   : nested(world, world.types.reference(target), spec->range);
    }
    case TypeSpecKind::Enum: {
        const auto it = world.enumsBySpec.find(spec);
        return it == world.enumsBySpec.end() ? unknown : it->second->type;
    }
    case TypeSpecKind::Struct:
    case TypeSpecKind::Union: {
        const auto it = world.typesBySpec.find(spec);
        if (it != world.typesBySpec.end()) return it->second;
        return declareStruct(world, *spec,
                             std::string(anonymousName.empty()
                                             ? (spec->kind == TypeSpecKind::Union ? "UNION" : "STRUCT")
                                             : anonymousName),
                             scope);
    }
    case TypeSpecKind::Subrange:
        return resolveSubrange(world, *spec, scope);
    // Made by lowerings for temporaries: the type of an expression, muted because the expression itself is checked
    // elsewhere.
    case TypeSpecKind::Inferred: {
        if (!spec->inferredFrom) return unknown;
        diagnostics::Sink silent;
        Context checker(world, scope, silent, world.arena);
        checker.isMuted = true;
        const Operand operand = settled(checker, expression(checker, *spec->inferredFrom));
        return operand.isUnknown() ? unknown : operand.type();
    }
    }
    return unknown;
}

/// What another type is made of. ARRAY[*] has its bounds from who calls: no array, structure or pointer has any to
/// give.
///   ok:    STRUCT a : ARRAY[1..3] OF INT; END_STRUCT      wrong: STRUCT a : ARRAY[*] OF INT; END_STRUCT  (P3018)
TypeId resolvePart(WorldBuilder& world, const syntax::TypeSpec* spec, const Scope& scope) {
    const TypeId type = resolveSpec(world, spec, scope);
    if (world.types.kind(type) != TypeKind::OpenArray) return type;
    world.emit(spec->range, findings::NotAllowedHere(Verbatim("ARRAY[*]"), phrases::Here()));
    return TypeTable::of(TypeKind::Unknown);
}

///   ok:    ARRAY[1..3] OF INT      wrong: ARRAY[3..1] OF INT  (P3027)
TypeId resolveArray(WorldBuilder& world, const syntax::TypeSpec& spec, const Scope& scope) {
    const TypeId unknown = TypeTable::of(TypeKind::Unknown);
    const TypeId element = resolvePart(world, spec.element, scope);
    std::vector<types::Dimension> dimensions;
    bool good = world.types.kind(element) != TypeKind::Unknown;
    uint64_t count = 1;
    for (const syntax::Bounds& bounds : spec.bounds) {
        const auto low = constantInteger(world, bounds.low, scope), high = constantInteger(world, bounds.high, scope);
        if (!low || !high) {
            good = false;
            continue;
        }
        if (*low > INT64_MIN && *high == *low - 1 && isInGeneric(scope)) {
            dimensions.push_back({*low, *low});
            continue;
        }
        if (*high < *low || *low < INT32_MIN || *high > INT32_MAX) {
            world.emit(joined(bounds.low->range, bounds.high->range), findings::ArraySizeInvalid(*low, *high));
            good = false;
            continue;
        }
        dimensions.push_back({*low, *high});
        // Each factor has at most 32 bits and the product is cut at 2^40: it cannot wrap.
        count = std::min<uint64_t>(count * dimensions.back().count(), uint64_t(1) << 40);
    }
    if (!good || dimensions.empty()) return unknown;
    if (count > (1u << 28)) {
        world.emit(spec.range, findings::ImageTooLarge(count, 1u << 28));
        return unknown;
    }
    return nested(world, world.types.array(std::move(dimensions), element), spec.range);
}

/// How deep a type is made of others. A pointer begins again behind a type with a name, which may hold it.
uint32_t nestingOf(const World& world, TypeId type) {
    return type.index() < world.nestings.size() ? world.nestings[type.index()] : 0;
}

void noteNesting(WorldBuilder& world, TypeId type, uint32_t nesting) {
    if (world.nestings.size() <= type.index())
        world.nestings.resize(std::max<size_t>(world.types.count(), type.index() + 1), 0);
    world.nestings[type.index()] = nesting;
}

/// An array, pointer or reference that was just made, unless it is nested too deeply.
///   wrong: POINTER TO POINTER TO … INT, more than 60 of them  (P1019)
TypeId nested(WorldBuilder& world, TypeId type, SourceRange range) {
    const TypeId element = world.types[type].element;
    const TypeKind inner = world.types.kind(element);
    // A pointer to a named type ends the nesting: lists and trees are legal.
    const bool isDirect = world.types.kind(type) != TypeKind::Pointer && world.types.kind(type) != TypeKind::Reference;
    const bool isMade = inner == TypeKind::Array || inner == TypeKind::OpenArray || inner == TypeKind::Pointer ||
                        inner == TypeKind::Reference;
    noteNesting(world, type, 1 + (isDirect || isMade ? nestingOf(world, element) : 0));
    if (nestingOf(world, type) <= kMaximumNesting) return type;
    world.emit(range, findings::NestedTooDeep());
    return TypeTable::of(TypeKind::Unknown);
}

/// Of a type that was laid out; one without a size needs more than there is.
uint64_t neededBytes(const World& world, TypeId id) {
    const types::Type& type = world.types[id];
    // Size 0 means that layout gave up because it would not fit into 32 bits.
    if (type.size != 0) return type.size;
    uint64_t needed = 0;
    for (const types::Field& field : type.fields) needed += world.types[field.type].size;
    if (type.kind != TypeKind::Array) return std::max(needed, kMaximumData + 1);
    needed = world.types[type.element].size;
    for (const types::Dimension& d : type.dimensions) needed = std::min(needed, uint64_t(1) << 31) * d.count();
    return needed;
}

/// A type that takes more memory than there is, or whose initial value does, is reported where it is laid out: what
/// doubles with each line is never made.
///   wrong: T1 : STRUCT a, b : T0; END_STRUCT … T40 : STRUCT a, b : T39; END_STRUCT  (P3023)
bool checkSize(WorldBuilder& world, TypeId type, SourceRange range) {
    if (world.tooLarge.contains(type)) return false;
    const uint64_t needed = neededBytes(world, type);
    world.initialBytes += world.types[type].initial.size();
    const bool isLarge = needed > kMaximumData;
    if (!isLarge && world.initialBytes <= kMaximumInitialBytes) return true;
    world.emit(range, findings::ImageTooLarge(isLarge ? needed : world.initialBytes,
                                              isLarge ? kMaximumData : kMaximumInitialBytes));
    // What is thrown away does not count against the next type.
    world.initialBytes -= world.types[type].initial.size();
    world.types.edit(type).initial = {};
    world.types.edit(type).size = world.types[type].align; // something, for what is laid out behind it
    world.tooLarge.insert(type);
    return false;
}

TypeId resolveSubrange(WorldBuilder& world, const syntax::TypeSpec& spec, const Scope& scope) {
    const TypeId base =
        spec.element ? resolveSpec(world, spec.element, scope) : resolveNamed(world, spec.path, scope, spec.range);
    if (world.types.kind(base) == TypeKind::Unknown || spec.bounds.empty()) return base;
    if (!types::isInteger(world.types.family(base))) {
        world.emit(spec.range, findings::OperatorNotForType(phrases::ASubrange(), world.nameOf(base)));
        return base;
    }
    const auto low = constantInteger(world, spec.bounds.front().low, scope),
               high = constantInteger(world, spec.bounds.front().high, scope);
    if (!low || !high) return base;
    const auto [least, greatest] = TypeTable::integerRange(world.types.storageKind(base));
    const auto outside = [&](int64_t value) {
        return value < least || (value > 0 && static_cast<uint64_t>(value) > greatest);
    };
    if (*low > *high || outside(*low) || outside(*high)) {
        world.emit(joined(spec.bounds.front().low->range, spec.bounds.front().high->range),
                   findings::ArraySizeInvalid(*low, *high));
        return base;
    }
    return world.types.subrange(world.types.storage(base), *low, *high);
}

/// Edition 3, 6.5.3: ARRAY[*] as input, output or in-out of a function or method, as in-out of a block.
static bool isPassedAsArray(const Variable& variable) {
    const bool isOpen = variable.kind == syntax::SectionKind::Input || variable.kind == syntax::SectionKind::Output;
    return isOpen && !variable.isResult && variable.owner &&
           (variable.owner->kind == UnitKind::Function || variable.owner->kind == UnitKind::Method);
}

///   ok:    VAR_GLOBAL g : INT; END_VAR … VAR_EXTERNAL g : INT; END_VAR      wrong: without the VAR_GLOBAL (P3022)
///          VAR a : ARRAY[*] OF INT; END_VAR  (P3018)
TypeId typeOf(WorldBuilder& world, Variable& variable) {
    if (variable.typeProgress == Progress::Done) return variable.type;
    // x : ARRAY[0..x] …: the cycle is reported where it began.
    if (variable.typeProgress == Progress::Working) return TypeTable::of(TypeKind::Unknown);
    const Waiting wait(world.waiting, 4);
    if (wait.isTooDeep) {
        world.emit(variable.range, findings::NestedTooDeep());
        return TypeTable::of(TypeKind::Unknown);
    }
    variable.typeProgress = Progress::Working;
    variable.type = anyInputType(world, variable);
    if (!variable.type.isValid()) variable.type = resolveSpec(world, variable.spec, variable.scope, variable.name);
    if (variable.kind == syntax::SectionKind::External) {
        Variable* target = globalOf(world, variable);
        // VAR_EXTERNAL repeats the type (2.4.3); a different one is another variable.
        if (!target || !sameType(world, typeOf(world, *target), variable.type)) {
            if (world.types.kind(variable.type) != TypeKind::Unknown)
                world.emit(variable.range, findings::ExternalNotFound(variable.name, world.nameOf(variable.type)));
        } else {
            variable.target = target;
            if (variable.isConstant == false) variable.isConstant = target->isConstant;
        }
    }
    if (world.types.kind(variable.type) == TypeKind::OpenArray && isPassedAsArray(variable)) {
        // its bounds are the caller's: passed by reference, an input is not written
        variable.isReadOnlyReference = variable.kind == syntax::SectionKind::Input;
        variable.kind = syntax::SectionKind::InOut;
    }
    if (variable.kind != syntax::SectionKind::InOut && world.types.kind(variable.type) == TypeKind::OpenArray) {
        world.emit(variable.spec ? variable.spec->range : variable.range,
                   findings::NotAllowedHere(Verbatim("ARRAY[*]"), phrases::InThisSection()));
        variable.type = TypeTable::of(TypeKind::Unknown);
    }
    variable.typeProgress = Progress::Done;
    if (variable.symbol.isValid() && !variable.isResult && variable.declaration && variable.section)
        world.symbols[variable.symbol.index()].type = variable.type;
    return variable.type;
}

TypeId typeOf(const Check& check, Variable& variable) {
    return check.builder ? typeOf(*check.builder, variable) : variable.type;
}

// Types with a name are the same only as themselves (name equivalence); arrays, pointers and texts by what they are
// made of.
bool sameType(const World& world, TypeId a, TypeId b) {
    // Deeper than any type may be nested; never a loop.
    for (int guard = 0; guard < 64; ++guard) {
        if (const auto it = world.aliasOf.find(a); it != world.aliasOf.end()) a = it->second;
        if (const auto it = world.aliasOf.find(b); it != world.aliasOf.end()) b = it->second;
        if (a == b) return true;
        const types::Type &x = world.types[a], &y = world.types[b];
        // Unknown is the same as everything: no second message.
        if (x.kind == TypeKind::Unknown || y.kind == TypeKind::Unknown) return true;
        if (x.kind != y.kind) return false;
        switch (x.kind) {
        case TypeKind::Array:
            if (x.dimensions.size() != y.dimensions.size()) return false;
            for (size_t i = 0; i < x.dimensions.size(); ++i)
                if (x.dimensions[i].low != y.dimensions[i].low || x.dimensions[i].high != y.dimensions[i].high)
                    return false;
            break;
        case TypeKind::OpenArray:
            if (x.dimensions.size() != y.dimensions.size()) return false;
            break;
        case TypeKind::Pointer:
        case TypeKind::Reference:
            break;
        case TypeKind::String:
        case TypeKind::Wstring:
            return x.capacity == y.capacity;
        case TypeKind::Subrange:
            return x.element == y.element && x.low == y.low && x.high == y.high;
        default:
            return false;
        }
        a = x.element;
        b = y.element;
    }
    return false;
}

} // namespace plc::sema
