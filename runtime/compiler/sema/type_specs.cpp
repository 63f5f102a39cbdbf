// Type specifications → TypeIds. A name is resolved when asked for; sizes are completed separately (completeType), so
// that a pointer may name a type that holds it.
#include "runtime/compiler/sema/checker.h"

#include "runtime/base/text.h"

#include <cstring>

namespace plc::sema {

using syntax::TypeSpecKind;
using types::TypeTable;

namespace {

struct ElementaryName {
    std::string_view name;
    TypeKind kind;
};
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
std::optional<int64_t> World::constantInteger(const syntax::Expr* expr, const Scope& scope) {
    if (!expr) return std::nullopt;
    const Waiting wait(waitingCounter(), expr->height);
    if (wait.isTooDeep) {
        emit(expr->range, findings::NestedTooDeep());
        return std::nullopt;
    }
    Checker checker(*this, scope, sink, arena);
    const Operand operand = checker.expression(*expr);
    if (operand.isUnknown()) return std::nullopt;
    if (!operand.isConstant() || !std::holds_alternative<int64_t>(operand.expr->value.data)) {
        emit(expr->range, findings::NotConstant());
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
TypeId World::resolveNamed(const syntax::Path& path, const Scope& scope, SourceRange range) {
    const TypeId unknown = TypeTable::of(TypeKind::Unknown);
    if (path.empty()) return unknown;
    const Found found = lookupPath(scope, path);
    if (path.size() == 1) {
        const std::string_view name = path.front().text;
        const bool hidden = found.entity.type || (found.entity.unit && found.entity.unit->type.isValid());
        if (!hidden) {
            if (const auto kind = elementaryNamed(name)) return TypeTable::of(*kind);
            if (equalsIgnoringCase(name, "STRING")) return types.string(80);
            if (equalsIgnoringCase(name, "WSTRING")) return types.wstring(80);
        }
    }
    std::string text;
    for (const syntax::Name& name : path) text += (text.empty() ? "" : ".") + std::string(name.text);
    if (!found.ambiguous.empty() && (found.entity.type || found.entity.unit)) {
        std::vector<std::string> all;
        for (const std::string& where : found.ambiguous) all.push_back(where + "." + text);
        auto& diagnostic = emit(range, findings::AmbiguousName(text, all));
        for (const std::string& where : found.ambiguous)
            diagnostic.fixes.push_back({fixes::Write(where + "." + text), {{range, where + "." + text}}});
        return unknown;
    }
    if (found.entity.type) {
        refer(path.back().range, found.entity.type->symbol, true, false);
        return resolveDeclared(*found.entity.type);
    }
    if (found.entity.unit && found.entity.unit->type.isValid()) {
        refer(path.back().range, found.entity.unit->symbol, true, false);
        return found.entity.unit->type;
    }
    if (const std::string own(ownNameOf(text)); !own.empty()) {
        emit(range, findings::UnknownType(text)).fixes.push_back({fixes::Write(own), {{range, own}}});
        return unknown;
    }
    if (path.size() > 1) { // a name of a namespace that has no such type
        const Found around = lookupPath(scope, {path.begin(), path.end() - 1});
        std::vector<std::string> names;
        if (around.space) addNames(*around.space, names);
        suggest(emit(around.space ? path.back().range : range, findings::UnknownType(text)), path.back().range,
                path.back().text, names);
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
    for (Space* library : libraries) collect(*library);
    for (const ElementaryName& entry : kElementaryNames) candidates.emplace_back(entry.name);
    candidates.insert(candidates.end(), {"STRING", "WSTRING"});
    suggest(emit(range, findings::UnknownType(text)), range, text, candidates);
    return unknown;
}

TypeId World::resolveDeclared(DeclaredType& declared) {
    if (declared.progress == Progress::Done) return declared.type;
    if (declared.progress == Progress::Working) {
        emit(declared.declaration->name.range, findings::TypeCycle(declared.name));
        return TypeTable::of(TypeKind::Unknown);
    }
    const Waiting wait(waitingCounter(), 4);
    if (wait.isTooDeep) {
        emit(declared.declaration->name.range, findings::NestedTooDeep());
        return TypeTable::of(TypeKind::Unknown);
    }
    declared.progress = Progress::Working;
    TypeId behind = resolveSpec(declared.declaration->spec, declared.scope, declared.name);
    if (declared.declaration->initial && types.kind(behind) != TypeKind::Unknown) {
        const TypeKind kind = types.kind(behind);
        const bool wraps = types::isElementary(kind) || kind == TypeKind::Subrange;
        const TypeId copy = types.declare(wraps ? TypeKind::Subrange : kind, declared.name);
        types::Type& type = types.edit(copy);
        if (wraps) {
            const types::Type& original = types[behind];
            type.element = original.kind == TypeKind::Subrange ? original.element : behind;
            type.low = original.kind == TypeKind::Subrange ? original.low : INT64_MIN;
            type.high = original.kind == TypeKind::Subrange ? original.high : INT64_MAX;
            type.size = original.size;
            type.align = original.align;
        } else {
            type.element = types[behind].element;
            type.capacity = types[behind].capacity;
            type.dimensions = types[behind].dimensions;
            type.base = types[behind].base;
        }
        type.declaration = declared.declaration->name.range;
        type.comment = std::string(declared.declaration->comment);
        type.space = declared.scope.space ? declared.scope.space->qualified : std::string();
        aliasesByType[copy] = &declared;
        aliasOf[copy] = behind;
        if (const auto it = enumsByType.find(behind); it != enumsByType.end()) enumsByType[copy] = it->second;
        if (Unit* unit = unitOf(behind)) unitsByType[copy] = unit;
        behind = copy;
    }
    declared.type = behind;
    declared.progress = Progress::Done;
    symbols[declared.symbol.index()].type = behind;
    return behind;
}

TypeId World::resolveSpec(const syntax::TypeSpec* spec, const Scope& scope, std::string_view anonymousName) {
    const TypeId unknown = TypeTable::of(TypeKind::Unknown);
    if (!spec) return unknown;
    switch (spec->kind) {
    case TypeSpecKind::Error:
        return unknown;
    case TypeSpecKind::Named:
        return resolveNamed(spec->path, scope,
                            spec->path.empty() ? spec->range
                                               : joined(spec->path.front().range, spec->path.back().range));
    case TypeSpecKind::String: {
        const bool wide = !spec->path.empty() && equalsIgnoringCase(spec->path.front().text, "WSTRING");
        int64_t length = 80;
        if (spec->length) {
            const auto given = constantInteger(spec->length, scope);
            if (given && (*given < 1 || *given > 65535))
                emit(spec->length->range,
                     findings::ConstantOutOfRange(std::to_string(*given),
                                                  std::string(wide ? "WSTRING" : "STRING") + "(1..65535)"));
            else if (given)
                length = *given;
        }
        return wide ? types.wstring(static_cast<uint32_t>(length)) : types.string(static_cast<uint32_t>(length));
    }
    case TypeSpecKind::Array:
        return resolveArray(*spec, scope);
    case TypeSpecKind::OpenArray: {
        const TypeId element = resolveSpec(spec->element, scope);
        return types.kind(element) == TypeKind::Unknown
                   ? unknown
                   : nested(types.openArray(std::max<size_t>(1, spec->bounds.size()), element), spec->range);
    }
    case TypeSpecKind::Pointer:
    case TypeSpecKind::RefTo: {
        const TypeId target = resolveSpec(spec->element, scope);
        return types.kind(target) == TypeKind::Unknown ? unknown : nested(types.pointer(target), spec->range);
    }
    case TypeSpecKind::Reference: {
        const TypeId target = resolveSpec(spec->element, scope);
        return types.kind(target) == TypeKind::Unknown ? unknown : nested(types.reference(target), spec->range);
    }
    case TypeSpecKind::Enum: {
        const auto it = enumsBySpec.find(spec);
        return it == enumsBySpec.end() ? unknown : it->second->type;
    }
    case TypeSpecKind::Struct:
    case TypeSpecKind::Union: {
        const auto it = typesBySpec.find(spec);
        if (it != typesBySpec.end()) return it->second;
        return declareStruct(*spec,
                             std::string(anonymousName.empty()
                                             ? (spec->kind == TypeSpecKind::Union ? "UNION" : "STRUCT")
                                             : anonymousName),
                             scope);
    }
    case TypeSpecKind::Subrange:
        return resolveSubrange(*spec, scope);
    case TypeSpecKind::Inferred: {
        if (!spec->inferredFrom) return unknown;
        diagnostics::Sink silent;
        Checker checker(*this, scope, silent, arena);
        checker.isMuted = true;
        const Operand operand = checker.settled(checker.expression(*spec->inferredFrom));
        return operand.isUnknown() ? unknown : operand.type();
    }
    }
    return unknown;
}

///   ok:    ARRAY[1..3] OF INT      wrong: ARRAY[3..1] OF INT  (P3027)
TypeId World::resolveArray(const syntax::TypeSpec& spec, const Scope& scope) {
    const TypeId unknown = TypeTable::of(TypeKind::Unknown);
    const TypeId element = resolveSpec(spec.element, scope);
    std::vector<types::Dimension> dimensions;
    bool good = types.kind(element) != TypeKind::Unknown;
    uint64_t count = 1;
    for (const syntax::Bounds& bounds : spec.bounds) {
        const auto low = constantInteger(bounds.low, scope), high = constantInteger(bounds.high, scope);
        if (!low || !high) {
            good = false;
            continue;
        }
        if (*high < *low || *low < INT32_MIN || *high > INT32_MAX) {
            emit(joined(bounds.low->range, bounds.high->range), findings::ArraySizeInvalid(*low, *high));
            good = false;
            continue;
        }
        dimensions.push_back({*low, *high});
        count = std::min<uint64_t>(count * dimensions.back().count(), uint64_t(1) << 40);
    }
    if (!good || dimensions.empty()) return unknown;
    if (count > (1u << 28)) {
        emit(spec.range, findings::ImageTooLarge(count, 1u << 28));
        return unknown;
    }
    return nested(types.array(std::move(dimensions), element), spec.range);
}

/// How deep a type is made of others. A pointer begins again behind a type with a name, which may hold it.
uint32_t World::nestingOf(TypeId type) const { return type.index() < nestings.size() ? nestings[type.index()] : 0; }

void World::noteNesting(TypeId type, uint32_t nesting) {
    if (nestings.size() <= type.index()) nestings.resize(std::max<size_t>(types.count(), type.index() + 1), 0);
    nestings[type.index()] = nesting;
}

/// An array, pointer or reference that was just made, unless it is nested too deeply.
///   wrong: POINTER TO POINTER TO … INT, more than 60 of them  (P1019)
TypeId World::nested(TypeId type, SourceRange range) {
    const TypeId element = types[type].element;
    const TypeKind inner = types.kind(element);
    const bool isDirect = types.kind(type) != TypeKind::Pointer && types.kind(type) != TypeKind::Reference;
    const bool isMade = inner == TypeKind::Array || inner == TypeKind::OpenArray || inner == TypeKind::Pointer ||
                        inner == TypeKind::Reference;
    noteNesting(type, 1 + (isDirect || isMade ? nestingOf(element) : 0));
    if (nestingOf(type) <= kMaximumNesting) return type;
    emit(range, findings::NestedTooDeep());
    return TypeTable::of(TypeKind::Unknown);
}

/// Of a type that was laid out; one without a size needs more than there is.
uint64_t World::neededBytes(TypeId id) const {
    const types::Type& type = types[id];
    if (type.size != 0) return type.size;
    uint64_t needed = 0;
    for (const types::Field& field : type.fields) needed += types[field.type].size;
    if (type.kind != TypeKind::Array) return std::max(needed, kMaximumData + 1);
    needed = types[type.element].size;
    for (const types::Dimension& d : type.dimensions) needed = std::min(needed, uint64_t(1) << 31) * d.count();
    return needed;
}

/// A type that takes more memory than there is, or whose initial value does, is reported where it is laid out: what
/// doubles with each line is never made.
///   wrong: T1 : STRUCT a, b : T0; END_STRUCT … T40 : STRUCT a, b : T39; END_STRUCT  (P3023)
bool World::checkSize(TypeId type, SourceRange range) {
    if (tooLarge.contains(type)) return false;
    const uint64_t needed = neededBytes(type);
    initialBytes += types[type].initial.size();
    const bool isLarge = needed > kMaximumData;
    if (!isLarge && initialBytes <= kMaximumInitialBytes) return true;
    emit(range,
         findings::ImageTooLarge(isLarge ? needed : initialBytes, isLarge ? kMaximumData : kMaximumInitialBytes));
    initialBytes -= types[type].initial.size();
    types.edit(type).initial = {};
    types.edit(type).size = types[type].align; // something, for what is laid out behind it
    tooLarge.insert(type);
    return false;
}

TypeId World::resolveSubrange(const syntax::TypeSpec& spec, const Scope& scope) {
    const TypeId base = spec.element ? resolveSpec(spec.element, scope) : resolveNamed(spec.path, scope, spec.range);
    if (types.kind(base) == TypeKind::Unknown || spec.bounds.empty()) return base;
    if (!types::isInteger(types.family(base))) {
        emit(spec.range, findings::OperatorNotForType(phrases::ASubrange(), nameOf(base)));
        return base;
    }
    const auto low = constantInteger(spec.bounds.front().low, scope),
               high = constantInteger(spec.bounds.front().high, scope);
    if (!low || !high) return base;
    const auto [least, greatest] = TypeTable::integerRange(types.storageKind(base));
    const auto outside = [&](int64_t value) {
        return value < least || (value > 0 && static_cast<uint64_t>(value) > greatest);
    };
    if (*low > *high || outside(*low) || outside(*high)) {
        emit(joined(spec.bounds.front().low->range, spec.bounds.front().high->range),
             findings::ArraySizeInvalid(*low, *high));
        return base;
    }
    return types.subrange(types.storage(base), *low, *high);
}

///   ok:    VAR_GLOBAL g : INT; END_VAR … VAR_EXTERNAL g : INT; END_VAR      wrong: without the VAR_GLOBAL (P3022)
///          VAR a : ARRAY[*] OF INT; END_VAR  (P3018)
TypeId World::typeOf(Variable& variable) {
    if (variable.typeProgress == Progress::Done) return variable.type;
    if (variable.typeProgress == Progress::Working) return TypeTable::of(TypeKind::Unknown);
    const Waiting wait(waitingCounter(), 4);
    if (wait.isTooDeep) {
        emit(variable.range, findings::NestedTooDeep());
        return TypeTable::of(TypeKind::Unknown);
    }
    variable.typeProgress = Progress::Working;
    variable.type = resolveSpec(variable.spec, variable.scope, variable.name);
    if (variable.kind == syntax::SectionKind::External) {
        Scope outside = variable.scope;
        outside.unit = nullptr;
        Variable* target = lookup(outside, variable.id).entity.variable;
        if (!target || !sameType(typeOf(*target), variable.type)) {
            if (types.kind(variable.type) != TypeKind::Unknown)
                emit(variable.range, findings::ExternalNotFound(variable.name, nameOf(variable.type)));
        } else {
            variable.target = target;
            if (variable.isConstant == false) variable.isConstant = target->isConstant;
        }
    }
    if (variable.kind != syntax::SectionKind::InOut && types.kind(variable.type) == TypeKind::OpenArray) {
        emit(variable.spec ? variable.spec->range : variable.range,
             findings::NotAllowedHere(Verbatim("ARRAY[*]"), phrases::InThisSection()));
        variable.type = TypeTable::of(TypeKind::Unknown);
    }
    variable.typeProgress = Progress::Done;
    if (variable.symbol.isValid() && !variable.isResult && variable.declaration && variable.section)
        symbols[variable.symbol.index()].type = variable.type;
    return variable.type;
}

bool World::sameType(TypeId a, TypeId b) const {
    for (int guard = 0; guard < 64; ++guard) {
        if (const auto it = aliasOf.find(a); it != aliasOf.end()) a = it->second;
        if (const auto it = aliasOf.find(b); it != aliasOf.end()) b = it->second;
        if (a == b) return true;
        const types::Type &x = types[a], &y = types[b];
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

///   ok:    A : STRUCT b : REF_TO A; END_STRUCT      wrong: A : STRUCT b : A; END_STRUCT  (P3003)
void World::reportCycle(TypeId type, SourceRange usedAt) {
    const types::Type& t = types[type];
    emit(usedAt.file.isValid() ? usedAt : t.declaration, findings::TypeCycle(t.name));
}

bool World::completeType(TypeId type, SourceRange usedAt) {
    const TypeKind kind = types.kind(type);
    if (types::isElementary(kind)) return true;
    if (tooLarge.contains(type)) return false;
    if (const auto alias = aliasesByType.find(type); alias != aliasesByType.end()) {
        completeAlias(*alias->second, usedAt);
        return types[type].size != 0;
    }
    if (kind == TypeKind::Array && aliasOf.count(type)) return true; // has its own initial value
    switch (kind) {
    case TypeKind::Enum:
        if (const auto it = enumsByType.find(type); it != enumsByType.end()) completeEnum(*it->second);
        return true;
    case TypeKind::Array:
        return completeArray(type, usedAt);
    case TypeKind::Struct:
    case TypeKind::Union: {
        const auto it = structsByType.find(type);
        if (it == structsByType.end()) return true;
        if (it->second->progress == Progress::Working) {
            reportCycle(type, usedAt);
            return false;
        }
        const Waiting wait(completingCounter(), 1, kMaximumNesting + kMaximumBases);
        if (wait.isTooDeep) {
            emit(usedAt, findings::NestedTooDeep());
            return false;
        }
        completeStruct(*it->second);
        return !tooLarge.contains(type);
    }
    case TypeKind::Block: {
        Unit* unit = unitOf(type);
        if (!unit) return true;
        if (unit->layoutProgress == Progress::Working) {
            reportCycle(type, usedAt);
            return false;
        }
        const Waiting wait(completingCounter(), 1, kMaximumNesting + kMaximumBases);
        if (wait.isTooDeep) {
            emit(usedAt, findings::NestedTooDeep());
            return false;
        }
        completeUnit(*unit, usedAt);
        return !tooLarge.contains(type);
    }
    default:
        return true;
    }
}

bool World::completeArray(TypeId type, SourceRange usedAt) {
    const bool good = completeType(types[type].element, usedAt);
    const types::Type& element = types[types[type].element];
    noteNesting(type, 1 + nestingOf(types[type].element));
    if (nestingOf(type) > kMaximumNesting) {
        emit(usedAt, findings::NestedTooDeep());
        return false;
    }
    if (types[type].size != 0 && types[type].initial.empty() == element.initial.empty()) return good;
    types.layoutArray(type);
    return checkSize(type, usedAt) && good;
}

void World::completeAlias(DeclaredType& declared, SourceRange usedAt) {
    const TypeId behind = aliasOf[declared.type];
    aliasesByType.erase(declared.type);
    completeType(behind, usedAt);
    noteNesting(declared.type, nestingOf(behind));
    types::Type& type = types.edit(declared.type);
    const types::Type& original = types[behind];
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
        if (const auto it = structsByType.find(behind); it != structsByType.end())
            structsByType[declared.type] = it->second;
    }
    InitialValue initial;
    initial.bytes = original.initial;
    initial.bytes.resize(original.size);
    initialise(initial, behind, 0, -1, declared.declaration->initial, declared.scope, nullptr);
    types.edit(declared.type).initial = initial.bytes;
    checkSize(declared.type, declared.declaration->name.range);
    if (!initial.dynamics.empty()) typeInitials[declared.type].dynamics = std::move(initial.dynamics);
}

void World::completeEnum(EnumType& enumeration) {
    if (enumeration.progress != Progress::Open) return;
    const Waiting wait(waitingCounter(), 8);
    if (wait.isTooDeep) return (void)emit(enumeration.spec->range, findings::NestedTooDeep());
    enumeration.progress = Progress::Working;
    const syntax::TypeSpec& spec = *enumeration.spec;
    TypeId base = TypeTable::of(TypeKind::Int);
    if (spec.element || !spec.path.empty()) {
        const TypeId named = spec.element ? resolveSpec(spec.element, enumeration.scope)
                                          : resolveNamed(spec.path, enumeration.scope, spec.range);
        if (types::isInteger(types.family(named)))
            base = types.storage(named);
        else if (types.kind(named) != TypeKind::Unknown)
            emit(spec.element ? spec.element->range : spec.range,
                 findings::OperatorNotForType(phrases::AnEnumeration(), nameOf(named)));
    }
    types.edit(enumeration.type).element = base;
    types.edit(enumeration.type).size = types[base].size;
    types.edit(enumeration.type).align = types[base].align;
    const auto [least, greatest] = TypeTable::integerRange(types.kind(base));
    int64_t next = 0;
    for (size_t i = 0; i < spec.enumerators.size(); ++i) {
        const syntax::EnumeratorDecl& declared = spec.enumerators[i];
        if (declared.value) {
            if (const auto value = constantInteger(declared.value, enumeration.scope)) next = *value;
        }
        if (next < least || (next > 0 && static_cast<uint64_t>(next) > greatest))
            emit(declared.value ? declared.value->range : declared.name.range,
                 findings::ConstantOutOfRange(std::to_string(next), nameOf(base)));
        types.edit(enumeration.type).enumerators[i].value = next;
        next = static_cast<int64_t>(static_cast<uint64_t>(next) + 1);
    }
    enumeration.progress = Progress::Done;
    int64_t first = types[enumeration.type].enumerators.empty() ? 0 : types[enumeration.type].enumerators.front().value;
    if (enumeration.initial) {
        Checker checker(*this, enumeration.scope, sink, arena);
        const Operand value =
            checker.converted(checker.expression(*enumeration.initial, enumeration.type), enumeration.type);
        if (value.isConstant() && std::holds_alternative<int64_t>(value.expr->value.data))
            first = value.expr->value.integer();
        else if (!value.isUnknown())
            emit(enumeration.initial->range, findings::NotConstant());
    }
    types::Type& type = types.edit(enumeration.type);
    if (first != 0) {
        type.initial.resize(type.size);
        std::memcpy(type.initial.data(), &first, type.size);
    }
}

/// A field by its name; of a structure without a search, because a machine's whole data may be one.
const types::Field* World::fieldOf(TypeId type, std::string_view name) {
    const auto made = structsByType.find(type);
    if (made == structsByType.end() || made->second->indices.empty()) return types[type].findField(name);
    const auto found = made->second->indices.find(key(name));
    return found == made->second->indices.end() ? nullptr : &types[type].fields[found->second];
}

void World::completeStruct(StructType& made) {
    if (made.progress != Progress::Open) return;
    made.progress = Progress::Working;
    uint32_t nesting = 0;
    std::unordered_set<NameId> known;
    std::vector<types::Field> fields;
    std::vector<const syntax::VarDecl*> declarations;
    TypeId base;
    if (made.spec->extends) {
        base = resolveSpec(made.spec->extends, made.scope);
        if (types.kind(base) != TypeKind::Struct) {
            if (types.kind(base) != TypeKind::Unknown)
                emit(made.spec->extends->range, findings::NotExtendable(nameOf(base), made.name));
            base = {};
        } else if (completeType(base, made.spec->extends->range)) {
            fields = types[base].fields;
            nesting = nestingOf(base); // its base is laid out and initialised as a part of it
            for (const types::Field& field : fields) known.insert(key(field.name));
            if (const auto it = structsByType.find(base); it != structsByType.end()) made.symbols = it->second->symbols;
        }
    }
    const size_t inherited = fields.size();
    for (const syntax::VarDecl* declaration : made.spec->fields) {
        TypeId type = resolveSpec(declaration->type, made.scope);
        const SourceRange at = declaration->type ? declaration->type->range : declaration->range;
        if (!completeType(type, at)) type = TypeTable::of(TypeKind::Unknown);
        if (nestingOf(type) >= kMaximumNesting) {
            emit(at, findings::NestedTooDeep());
            type = TypeTable::of(TypeKind::Unknown);
        }
        nesting = std::max(nesting, 1 + nestingOf(type));
        const bool isBit = declaration->type && declaration->type->kind == TypeSpecKind::Named &&
                           declaration->type->path.size() == 1 &&
                           equalsIgnoringCase(declaration->type->path.front().text, "BIT") &&
                           types.kind(type) == TypeKind::Bool;
        for (const syntax::Name& name : declaration->names) {
            if (!known.insert(key(name.text)).second) {
                emit(name.range, findings::DuplicateName(name.text));
                continue;
            }
            types::Field field;
            field.name = std::string(name.text);
            field.type = type;
            field.declaration = name.range;
            field.comment = std::string(declaration->comment);
            field.bit = isBit ? 0 : -1;
            for (const syntax::Pragma& pragma : declaration->pragmas)
                if (pragma.isAttribute && equalsIgnoringCase(pragma.key, "alias"))
                    field.aliases.emplace_back(pragma.value);
            fields.push_back(std::move(field));
            declarations.push_back(declaration);
            made.symbols.push_back(
                addSymbol(SymbolKind::Variable, name.text, made.name, name.range, declaration->comment));
            symbols.back().type = type;
        }
    }
    locateMembers(made, fields, inherited, declarations);
    types::Type& type = types.edit(made.type);
    type.base = base;
    type.fields = std::move(fields);
    noteNesting(made.type, nesting);
    types.layoutFields(made.type);
    if (!checkSize(made.type,
                   types[made.type].declaration.file.isValid() ? types[made.type].declaration : made.spec->range)) {
        made.progress = Progress::Done;
        return;
    }
    for (uint32_t i = 0; i < type.fields.size(); ++i) {
        made.indices.try_emplace(key(type.fields[i].name), i);
        for (const std::string& alias : type.fields[i].aliases) made.indices.try_emplace(key(alias), i);
    }
    if (std::any_of(type.fields.begin(), type.fields.end(), [](const types::Field& f) { return f.isLocated; }))
        for (types::Field& field : type.fields) field.isLocated = true; // where it lies for those that extend it
    InitialValue initial;
    initial.bytes = types[made.type].initial;
    initial.bytes.resize(types[made.type].size);
    if (inherited && !types[base].initial.empty())
        std::memcpy(initial.bytes.data(), types[base].initial.data(),
                    std::min(initial.bytes.size(), types[base].initial.size()));
    if (const auto it = typeInitials.find(base); inherited && it != typeInitials.end())
        initial.dynamics = it->second.dynamics;
    for (size_t i = inherited; i < types[made.type].fields.size(); ++i) {
        const types::Field field = types[made.type].fields[i];
        const syntax::VarDecl& declaration = *declarations[i - inherited];
        initialiseDeclared(initial, field.type, field.offset, field.bit, declaration.initial, made.scope,
                           declaration.type);
    }
    const bool isZero =
        std::all_of(initial.bytes.begin(), initial.bytes.end(), [](std::byte b) { return b == std::byte{}; });
    types.edit(made.type).initial = isZero ? std::vector<std::byte>{} : initial.bytes;
    typeInitials[made.type].dynamics = std::move(initial.dynamics);
    made.progress = Progress::Done;
    if (made.initial) { // TYPE T : STRUCT … END_STRUCT := (a := 1)
        InitialValue whole;
        whole.bytes = types[made.type].initial;
        whole.bytes.resize(types[made.type].size);
        initialise(whole, made.type, 0, -1, made.initial, made.scope, nullptr);
        types.edit(made.type).initial = whole.bytes;
    }
}

} // namespace plc::sema
