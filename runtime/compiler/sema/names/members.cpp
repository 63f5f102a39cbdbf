// Members: what stands behind a dot, by what stands before it — a value, a property, a type, a unit, a list of globals,
// a namespace.
#include "runtime/compiler/sema/names/members.h"

#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/names/elements.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/names/unknown_base.h"
#include "runtime/compiler/sema/program/oop.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/constants.h"
#include "runtime/compiler/sema/values/expressions.h"
#include "runtime/compiler/sema/values/literals.h"

#include "runtime/base/text.h"

#include <algorithm>

namespace plc::sema {

using syntax::ExprKind;
using syntax::SectionKind;
using DK = Denoted::Kind;

namespace {

bool isParameterKind(SectionKind kind) {
    return kind == SectionKind::Input || kind == SectionKind::Output || kind == SectionKind::InOut;
}

syntax::Access accessOf(const syntax::VarSection* section) {
    if (!section) return syntax::Access::Default;
    if (section->isPrivate) return syntax::Access::Private;
    if (section->isProtected) return syntax::Access::Protected;
    if (section->isInternal) return syntax::Access::Internal;
    return syntax::Access::Default;
}

// Silent where a base is unknown: the member may well be there.
Denoted unknownMember(Context& context, TypeId type, const syntax::Name& name) {
    if (hasUnknownBase(context.world.unitOf(type))) return {};
    suggest(context, context.emit(name.range, findings::UnknownMember(context.nameOf(type), name.text)), name.range,
            name.text, memberNames(context.world, type));
    return {};
}

Denoted memberOfStruct(Context& context, tree::Place* base, const Denoted& from, const syntax::Name& name,
                       SourceRange range, Access access) {
    const TypeId type = base->type;
    const types::Field* field = fieldOf(context.world, type, name.text);
    if (!field) return unknownMember(context, type, name);
    if (const auto it = context.world.structsByType.find(type); it != context.world.structsByType.end()) {
        const auto index = static_cast<size_t>(field - context.types[type].fields.data());
        if (index < it->second->symbols.size()) refer(context, name.range, it->second->symbols[index], access);
    }
    tree::Place* place =
        fieldPlace(context, base, field->offset, field->bit >= 0 ? context.elementary(TypeKind::Bool) : field->type,
                   field->bit, range);
    Denoted out = from;
    out.kind = DK::Place;
    out.place = context.isKind(place->type, TypeKind::Reference) ? dereferenced(context, place, range) : place;
    // Behind a reference the constness of the structure ends.
    if (out.place != place) out.isReadOnly = false;
    out.isExact = true;
    out.isSuper = false;
    return out;
}

/// Is the place THIS of the block, or of one that is derived from it? Then nothing is hidden.
bool isSeenFromInside(const Context& context, const tree::Place& base) {
    if (base.kind != tree::PlaceKind::Instance || base.offset != 0 || !context.scope.unit) return false;
    Unit* self = context.scope.unit->self();
    return self && context.types.isDerivedFrom(self->type, base.type);
}

Denoted propertyOf(Context& context, Property& property, const Denoted& from, tree::Place* instance,
                   const syntax::Name& name, Access access) {
    // The property's; that of GET or SET is checked when it is known which one runs.
    checkAccess(context, property.declaration->access, property.owner, property.name, name.range);
    Denoted out;
    out.kind = DK::Property;
    out.property = &property;
    out.instance = instance;
    out.isSuper = from.isSuper;
    out.isExact = from.isExact;
    refer(context, name.range, property.symbol, access);
    return out;
}

Denoted memberOfBlock(Context& context, tree::Place* base, const Denoted& from, const syntax::Name& name,
                      SourceRange range, Access access) {
    Unit* unit = context.world.unitOf(base->type);
    if (!unit) return unknownMember(context, base->type, name);
    Member member = findMember(*unit, context.key(name.text));
    const bool fromInside = isSeenFromInside(context, *base);
    // a local of the block does not hide its method or property of that name from outside
    if (member.variable && (member.unit || member.property) && !fromInside && !isParameterKind(member.variable->kind))
        member.variable = nullptr;
    if (member.unit && (access == Access::Call || !member.variable)) {
        Unit& called = *member.unit;
        checkAccess(context, called.access, called.owner, called.name, name.range);
        refer(context, name.range, called.symbol, Access::Read);
        Denoted out = unitOf(called, base);
        out.isSuper = from.isSuper;
        out.isExact = from.isExact;
        return out;
    }
    if (member.variable) {
        Variable& variable = *member.variable;
        checkAccess(context, accessOf(variable.section), variable.owner, variable.name, name.range);
        // From inside, THIS^.x is x: the same place, and nothing of the block is read only.
        Denoted out = ofVariable(context, variable, fromInside ? nullptr : base, range, access);
        if (out.kind == DK::Place && name.range.file.isValid() && !out.variable) out.variable = member.variable;
        return out;
    }
    if (member.property) return propertyOf(context, *member.property, from, base, name, access);
    return unknownMember(context, base->type, name);
}

Denoted memberOfInterface(Context& context, tree::Place* base, const syntax::Name& name, SourceRange range,
                          Access access) {
    Unit* unit = context.world.unitOf(base->type);
    if (!unit) return unknownMember(context, base->type, name);
    const Member member = findMember(*unit, context.key(name.text));
    Denoted out;
    if (member.unit) {
        refer(context, name.range, member.unit->symbol, Access::Read);
        out = unitOf(*member.unit, nullptr);
    } else if (member.property) {
        refer(context, name.range, member.property->symbol, access);
        out.kind = DK::Property;
        out.property = member.property;
    } else {
        return unknownMember(context, base->type, name);
    }
    // Called through the interface: which block it is, and thus which code, is only known when it runs.
    out.interface = load(context, base, range).expr;
    return out;
}

///   wrong: p.x  with p : POINTER TO S (P2002): p^.x is meant
Denoted memberOfPointer(Context& context, TypeId type, const syntax::Name& name) {
    auto& diagnostic = context.emit(name.range, findings::UnknownMember(context.nameOf(type), name.text));
    const SourceRange dot{name.range.file, name.range.begin - 1, name.range.begin - 1};
    if (context.types[context.types[type].element].findField(name.text))
        diagnostic.fixes.push_back({fixes::Dereference(), {{dot, "^"}}});
    return {};
}

///   ok:    t.Q; p.x      wrong: t.Z  with t : TON (P2002)
Denoted memberOf(Context& context, tree::Place* base, const Denoted& from, const syntax::Name& name, SourceRange range,
                 Access access) {
    switch (context.types.kind(base->type)) {
    case TypeKind::Unknown:
        return {};
    case TypeKind::Struct:
    case TypeKind::Union:
        return memberOfStruct(context, base, from, name, range, access);
    case TypeKind::Block:
        return memberOfBlock(context, base, from, name, range, access);
    case TypeKind::Interface:
        return memberOfInterface(context, base, name, range, access);
    case TypeKind::Pointer:
        return memberOfPointer(context, base->type, name);
    default:
        if (const auto bit = namedBit(context, from, base, name, range)) return *bit;
        return unknownMember(context, base->type, name);
    }
}

/// Whether a variable of this type could have such a member; scalars have none.
// Asked where a variable hides something of the same name: motor.speed with motor : INT can only mean the other one.
bool hasMembers(Context& context, Variable& variable, std::string_view name) {
    const TypeId type = typeOf(context, variable);
    const TypeKind kind = context.types.kind(type);
    if (kind == TypeKind::Struct || kind == TypeKind::Union) return fieldOf(context.world, type, name) != nullptr;
    return kind == TypeKind::Block || kind == TypeKind::Interface || kind == TypeKind::Pointer ||
           kind == TypeKind::Reference || kind == TypeKind::Unknown;
}

/// A member of a value that no variable holds: the value is kept in a temporary for it.
Denoted memberOfValue(Context& context, const Denoted& from, const syntax::Expr& e, Access access) {
    // A function gives an interface: its methods are called on what it gives, once.
    if (context.isKind(from.value.type(), TypeKind::Interface)) {
        Denoted out = memberOf(context, temporary(context, from.value), from, e.name, e.range, access);
        out.interface = from.value.expr;
        return out;
    }
    if (context.isKind(from.value.type(), TypeKind::Reference))
        return memberOf(context, referredBy(context, from.value, e.base->range), {}, e.name, e.range, access);
    Denoted out = memberOf(context, temporary(context, from.value), from, e.name, e.range, access);
    out.isReadOnly = true;
    out.whyReadOnly = context.textOf(e.range);
    return out;
}

/// A member of what a property gives; behind a REFERENCE TO it can be written.
Denoted memberOfProperty(Context& context, const Denoted& from, const syntax::Expr& e, Access access) {
    const syntax::Expr& base = *e.base;
    const Operand value = propertyValue(context, from, base.range);
    if (value.isUnknown()) return {};
    tree::Place* held = temporary(context, value);
    // PROPERTY p : REFERENCE TO S: p.x := 1 writes the variable that GET refers to.
    const bool isReference = context.isKind(value.type(), TypeKind::Reference);
    if (isReference) held = referredBy(context, value, base.range);
    Denoted out = memberOf(context, held, {}, e.name, e.range, access);
    if (!isReference && out.kind == DK::Place && !context.isKind(value.type(), TypeKind::Interface)) {
        out.isReadOnly = true;
        out.whyReadOnly = context.textOf(e.range);
    }
    return out;
}

/// Color.Red
Denoted memberOfType(Context& context, const Denoted& from, const syntax::Expr& e) {
    const syntax::Expr& base = *e.base;
    const NameId id = context.key(e.name.text);
    if (const auto it = context.world.enumsByType.find(from.type); it != context.world.enumsByType.end()) {
        EnumType& enumeration = *it->second;
        if (const auto named = enumeration.indices.find(id); named != enumeration.indices.end()) {
            Operand value = enumerator(context, {&enumeration, named->second}, e.name.range);
            value.expr->range = e.range;
            return valueOf(value);
        }
    }
    suggest(context, context.emit(e.name.range, findings::UnknownMember(context.textOf(base.range), e.name.text)),
            e.name.range, e.name.text, memberNames(context.world, from.type));
    return {};
}

/// A constant of a block by its type, or a variable of a program by the name of the program.
Denoted memberOfUnit(Context& context, const Denoted& from, const syntax::Expr& e, Access access) {
    const syntax::Expr& base = *e.base;
    const NameId id = context.key(e.name.text);
    Unit& unit = *from.unit;
    const Member member = unit.isInstanced() ? findMember(unit, id) : Member{};
    if (member.variable &&
        ((member.variable->isConstant && isFoldable(context.types, typeOf(context, *member.variable))) ||
         member.variable->storage == Storage::Absolute))
        return ofVariable(context, *member.variable, nullptr, e.range, access);
    if (unit.kind == UnitKind::Program) {
        Unit* self = context.scope.unit ? context.scope.unit->self() : nullptr;
        tree::Place* instance = nullptr;
        // Inside of its own body the name of the program is THIS, whichever instance runs.
        if (self == &unit)
            instance = thisPlace(context, base.range);
        else if (unit.instance)
            instance = absolutePlace(context, unit.instance->offset, unit.type, -1, base.range);
        if (instance) {
            Denoted exact;
            exact.isExact = true;
            Denoted out = memberOf(context, instance, exact, e.name, e.range, access);
            if (!context.isKind(unit.type, TypeKind::Unknown) && out.kind == DK::Place && out.variable &&
                out.variable->owner && out.variable->owner->kind == UnitKind::Program && !out.variable->isConstant)
                out.isReadOnly = false;
            return out;
        }
        // In declarations only the type is asked for; several instances do not matter.
        if (!context.function && !context.isExpression && member.variable)
            return ofVariable(context, *member.variable, nullptr, e.range, access);
    }
    if (unit.kind == UnitKind::Program)
        context.emit(base.range, findings::NoValue(unit.name));
    else if (!hasUnknownBase(&unit))
        suggest(context, context.emit(e.name.range, findings::UnknownMember(unit.name, e.name.text)), e.name.range,
                e.name.text, memberNames(context.world, unit.type));
    return {};
}

/// R1.A: the instance of a program that several resources have under one name.
Variable* instanceIn(const World& world, const GlobalsList& list, NameId id) {
    for (const Instance& instance : world.instances)
        if (instance.variable->id == id && equalsIgnoringCase(instance.resourceName, list.name))
            return instance.variable;
    return nullptr;
}

/// GVL.x
Denoted memberOfList(Context& context, const Denoted& from, const syntax::Expr& e, Access access) {
    const NameId id = context.key(e.name.text);
    const auto it = from.list->variables.find(id);
    if (it != from.list->variables.end()) return ofVariable(context, *it->second, nullptr, e.range, access);
    if (Variable* instance = instanceIn(context.world, *from.list, id))
        return ofVariable(context, *instance, nullptr, e.range, access);
    std::vector<std::string> candidates;
    for (const auto& [known, variable] : from.list->variables) candidates.push_back(variable->name);
    suggest(context, context.emit(e.name.range, findings::UnknownMember(from.list->name, e.name.text)), e.name.range,
            e.name.text, candidates);
    return {};
}

/// Lib.F, also of the standard functions.
Denoted memberOfSpace(Context& context, const Denoted& from, const syntax::Expr& e, Access access, TypeId hint) {
    const NameId id = context.key(e.name.text);
    const Found result = lookupIn(*from.space, id);
    const bool isStandard = library::findSignature(e.name.text) || library::findConversion(e.name.text);
    if (!result.isNothing() || isStandard || elementaryNamed(e.name.text))
        return found(context, result, e.name, access, hint);
    std::vector<std::string> candidates;
    addNames(context.world, *from.space, candidates);
    suggest(context, context.emit(e.name.range, findings::UnknownMember(from.space->qualified, e.name.text)),
            e.name.range, e.name.text, candidates);
    return {};
}

/// What stands before the dot. `isWhole`: the answer is that for all of `name.member`, found or reported.
Denoted denoteBase(Context& context, const syntax::Expr& e, Access access, TypeId hint, bool& isWhole) {
    const syntax::Expr& base = *e.base;
    const NameId id = context.key(e.name.text);
    const Access baseAccess = access == Access::Call || access == Access::Address ? Access::ReadWrite : access;
    isWhole = false;
    if (base.kind != ExprKind::NameRef) return denote(context, base, baseAccess);
    isWhole = true;
    Denoted from;
    const Found result = lookup(context.world, context.scope, context.key(base.name.text));
    Variable* own = result.member.variable     ? result.member.variable
                    : result.ambiguous.empty() ? result.entity.variable
                                               : nullptr;
    if (context.isExpression && own && own->isProgramInstance && own->program &&
        !findMember(*own->program, id)) // a name only the image has: VAR_ACCESS of a program
        if (const auto place =
                context.world.program->layout.find(std::string(base.name.text) + "." + std::string(e.name.text)))
            return placeOf(absolutePlace(context, place->offset, place->type, place->bit, e.range));
    if (own && !hasMembers(context, *own, e.name.text)) { // a variable may have the name of its type: Light.Red
        const Found outer = lookup(context.world, context.scope, context.key(base.name.text), true);
        if (outer.entity.type && context.world.enumsByType.count(resolveDeclared(context, *outer.entity.type))) {
            Found typeOnly;
            typeOnly.entity.type = outer.entity.type;
            from = found(context, typeOnly, base.name, Access::Read, {});
            own = nullptr;
        }
    }
    const bool isOwn = own || from.kind != DK::Nothing;
    if (!isOwn && result.list) { // GVL.x, also where a program unit has the list's name
        if (const auto it = result.list->variables.find(id); it != result.list->variables.end())
            return ofVariable(context, *it->second, nullptr, e.range, access);
        if (Variable* instance = instanceIn(context.world, *result.list, id))
            return ofVariable(context, *instance, nullptr, e.range, access);
        if (!result.entity.unit && !result.entity.type && !result.space) {
            std::vector<std::string> candidates;
            for (const auto& [key, variable] : result.list->variables) candidates.push_back(variable->name);
            suggest(context, context.emit(e.name.range, findings::UnknownMember(result.list->name, e.name.text)),
                    e.name.range, e.name.text, candidates);
            return {};
        }
    }
    // Lib.F where Lib is a namespace and nothing else; a unit of that name wins.
    if (!isOwn && result.space && !result.entity.unit && !result.entity.type && !result.member) {
        return found(context, lookupIn(*result.space, id), e.name, access, hint);
    }
    isWhole = false;
    // What is found for the base decides how the name behind the dot is read.
    if (from.kind != DK::Nothing) return from;
    return found(context, result, base.name, baseAccess, {});
}

} // namespace

std::optional<Denoted> fieldOfThis(Context& context, const syntax::Name& name, Access access) {
    const TypeId structure = context.scope.structure;
    if (!structure.isValid() || !fieldOf(context.world, structure, name.text)) return std::nullopt;
    tree::Place* self = thisPlace(context, name.range);
    return memberOfStruct(context, self, placeOf(self), name, name.range, access);
}

// By what is in front of the dot. Names of units, lists and namespaces are no values, so they are looked up before
// anything is evaluated.
Denoted denoteMember(Context& context, const syntax::Expr& e, Access access, TypeId hint) {
    if (!e.base) return {};
    if (!e.name.isValid()) return {};
    bool isWhole = false;
    const Denoted from = denoteBase(context, e, access, hint, isWhole);
    if (isWhole) return from;
    switch (from.kind) {
    case DK::Nothing:
        return {};
    case DK::Place:
        return memberOf(context, from.place, from, e.name, e.range, access);
    case DK::Value:
        return memberOfValue(context, from, e, access);
    case DK::Property:
        return memberOfProperty(context, from, e, access);
    case DK::Type:
        return memberOfType(context, from, e);
    case DK::Unit:
        return memberOfUnit(context, from, e, access);
    case DK::List:
        return memberOfList(context, from, e, access);
    case DK::Space:
        return memberOfSpace(context, from, e, access, hint);
    case DK::Standard:
        context.emit(e.base->range, findings::NoValue(context.textOf(e.base->range)));
        return {};
    }
    return {};
}

} // namespace plc::sema
