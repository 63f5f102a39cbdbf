// What names mean: NameRef, Member, Index, Deref, Bit, Address → a place, a value, a unit, a type…
#include "runtime/compiler/sema/names/names.h"

#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/declare/tests.h"
#include "runtime/compiler/sema/names/elements.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/places.h"
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
using types::TypeTable;

static Denoted denoteName(Context& context, const syntax::Expr& e, Access access, TypeId hint);
static Denoted memberOf(Context& context, tree::Place* base, Denoted from, const syntax::Name& name, SourceRange range,
                        Access access);
static bool hasMembers(Context& context, Variable& variable, std::string_view name);
static Denoted denoteMember(Context& context, const syntax::Expr& e, Access access, TypeId hint);

namespace {

/// A name of an instruction list that stands where the operator does.
bool isOperatorIn(const syntax::Block& instructions, SourceRange range) {
    return std::any_of(instructions.begin(), instructions.end(), [&](const syntax::Stmt* s) {
        return s->il && (s->il->op.range == range || isOperatorIn(s->il->body, range));
    });
}
bool isOperatorOf(const syntax::Pou& pou, SourceRange range) {
    if (isOperatorIn(pou.body.instructions, range)) return true;
    const auto inAction = [&](const syntax::ActionDecl* a) { return isOperatorIn(a->body.instructions, range); };
    if (std::any_of(pou.actions.begin(), pou.actions.end(), inAction)) return true;
    return pou.body.chart && std::any_of(pou.body.chart->actions.begin(), pou.body.chart->actions.end(), inAction);
}
using DK = Denoted::Kind;

Denoted unitOf(Unit& unit, tree::Place* instance) {
    Denoted out;
    out.kind = DK::Unit;
    out.unit = &unit;
    out.instance = instance;
    return out;
}

bool isParameterKind(SectionKind kind) {
    return kind == SectionKind::Input || kind == SectionKind::Output || kind == SectionKind::InOut;
}

std::string_view accessWord(syntax::Access access) {
    switch (access) {
    case syntax::Access::Private:
        return "PRIVATE";
    case syntax::Access::Protected:
        return "PROTECTED";
    case syntax::Access::Internal:
        return "INTERNAL";
    default:
        return "PUBLIC";
    }
}

syntax::Access accessOf(const syntax::VarSection* section) {
    if (!section) return syntax::Access::Default;
    if (section->isPrivate) return syntax::Access::Private;
    if (section->isProtected) return syntax::Access::Protected;
    if (section->isInternal) return syntax::Access::Internal;
    return syntax::Access::Default;
}
} // namespace

///   ok:    METHOD PUBLIC M      wrong: b.M()  of METHOD PRIVATE M (P2026)
bool checkAccess(Context& context, syntax::Access access, const Unit* owner, const std::string& name,
                 SourceRange range) {
    if (context.isExpression || context.isTest || isAccessible(access, owner, context.scope))
        return true; // a watch sees everything
    context.emit(range, findings::NoAccess(name, accessWord(access)));
    return false;
}

///   wrong: THIS^.x  in a FUNCTION (P3018)
Denoted denote(Context& context, const syntax::Expr& e, Access access, TypeId hint) {
    switch (e.kind) {
    case ExprKind::NameRef:
        return denoteName(context, e, access, hint);
    case ExprKind::Member:
        return denoteMember(context, e, access, hint);
    case ExprKind::Index:
        return denoteIndex(context, e, access);
    case ExprKind::Bit:
        return denoteBit(context, e, access);
    case ExprKind::Deref:
        return denoteDeref(context, e, access);
    case ExprKind::Address:
        return denoteAddress(context, e);
    case ExprKind::This:
    case ExprKind::Super: {
        Unit* self = context.scope.unit ? context.scope.unit->self() : nullptr;
        if (!self || (e.kind == ExprKind::Super && !self->base)) {
            context.emit(e.range, findings::NotAllowedHere(Verbatim(e.kind == ExprKind::Super ? "SUPER" : "THIS"),
                                                           self ? phrases::In(self->name) : phrases::Here()));
            return {};
        }
        Denoted out = placeOf(thisPlace(context, e.range));
        if (e.kind == ExprKind::Super) {
            out.place->type = self->base->type;
            out.isSuper = true;
        }
        return out;
    }
    case ExprKind::Error:
        return {};
    default: {
        const Operand operand = expression(context, e, hint);
        return operand.isUnknown() ? Denoted{} : valueOf(operand);
    }
    }
}

tree::Place* place(Context& context, const syntax::Expr& e, Access access) {
    const Denoted denoted = denote(context, e, access);
    if (denoted.kind == DK::Nothing) return nullptr;
    if (denoted.kind == DK::Place) return denoted.place;
    context.emit(e.range, findings::NotAssignable(context.textOf(e.range)));
    return nullptr;
}

Denoted denoteName(Context& context, const syntax::Expr& e, Access access, TypeId hint) {
    if (!e.name.isValid()) return {};
    const Found result = lookup(context.world, context.scope, context.key(e.name.text));
    return found(context, result, e.name, access, hint);
}

/// A name of the unit itself or of those around it. Nothing: it has none.
static std::optional<Denoted> foundMember(Context& context, const Found& result, const syntax::Name& name,
                                          Access access) {
    if (result.member.variable && result.member.variable->isResult && access == Access::Call &&
        !result.member.unit) { // F(…) inside F
        Unit& own = *result.member.variable->owner;
        refer(context, name.range, own.symbol, Access::Read);
        return unitOf(own, own.owner ? thisPlace(context, name.range) : nullptr);
    }
    if (result.member.variable && !(access == Access::Call && result.member.unit))
        return ofVariable(context, *result.member.variable, nullptr, name.range, access);
    if (result.member.unit) {
        refer(context, name.range, result.member.unit->symbol, Access::Read);
        Denoted out = unitOf(*result.member.unit,
                             context.function || context.isExpression ? thisPlace(context, name.range) : nullptr);
        return out;
    }
    if (result.member.property) {
        Denoted out;
        out.kind = DK::Property;
        out.property = result.member.property;
        out.instance = thisPlace(context, name.range);
        refer(context, name.range, out.property->symbol, access);
        return out;
    }
    return std::nullopt;
}

static Denoted refuseAmbiguous(Context& context, const Found& result, const syntax::Name& name) {
    std::vector<std::string> all;
    for (const std::string& where : result.ambiguous)
        all.push_back((where.empty() ? "" : where + ".") + std::string(name.text));
    auto& diagnostic = context.emit(name.range, findings::AmbiguousName(name.text, all));
    for (const std::string& where : result.ambiguous)
        if (!where.empty())
            diagnostic.fixes.push_back({fixes::Write(where + "." + std::string(name.text)),
                                        {{name.range, where + "." + std::string(name.text)}}});
    return {};
}

/// Several enumerations may have the name: the type wanted chooses.
static Denoted foundEnumerator(Context& context, const Found& result, const syntax::Name& name, TypeId hint) {
    const EnumeratorRef* chosen = result.enumerators.size() == 1 ? &result.enumerators.front() : nullptr;
    for (const EnumeratorRef& ref : result.enumerators)
        if (hint.isValid() && (ref.type->type == hint || (context.world.enumsByType.count(hint) &&
                                                          context.world.enumsByType.at(hint) == ref.type)))
            chosen = &ref;
    if (chosen) return valueOf(enumerator(context, *chosen, name.range));
    std::vector<std::string> all;
    for (const EnumeratorRef& ref : result.enumerators) all.push_back(ref.type->name + "." + std::string(name.text));
    auto& diagnostic = context.emit(name.range, findings::AmbiguousName(name.text, all));
    for (const EnumeratorRef& ref : result.enumerators)
        diagnostic.fixes.push_back({fixes::Write(ref.type->name + "." + std::string(name.text)),
                                    {{name.range, ref.type->name + "." + std::string(name.text)}}});
    return {};
}

static Denoted refuseUnknown(Context& context, const syntax::Name& name) {
    if (context.isTest && isAccessName(context.world, name.text)) return {};
    const bool isInstruction =
        context.scope.unit && context.scope.unit->pou && isOperatorOf(*context.scope.unit->pou, name.range);
    std::vector<std::string> candidates;
    if (maySuggest(context)) candidates = visibleNames(context.world, context.scope);
    if (isInstruction)
        for (const char* op :
             {"LD",  "LDN", "ST",   "STN",   "AND", "ANDN", "ORN",   "XOR", "ADD",  "SUB",   "MUL", "DIV",
              "MOD", "JMP", "JMPC", "JMPCN", "CAL", "CALC", "CALCN", "RET", "RETC", "RETCN", "NOT"})
            candidates.emplace_back(op);
    suggest(context,
            context.emit(name.range,
                         isInstruction ? findings::IlUnknownOperator(name.text) : findings::UndeclaredName(name.text)),
            name.range, name.text, candidates);
    return {};
}

///   ok:    x := x + 1;      wrong: x := y;  where nothing is called y (P2001)
Denoted found(Context& context, const Found& result, const syntax::Name& name, Access access, TypeId hint) {
    if (const auto member = foundMember(context, result, name, access)) return *member;
    if (!result.ambiguous.empty()) return refuseAmbiguous(context, result, name);
    if (result.entity.variable) return ofVariable(context, *result.entity.variable, nullptr, name.range, access);
    if (!result.enumerators.empty() && !(access == Access::Call && result.entity.unit))
        return foundEnumerator(context, result, name, hint);
    if (result.entity.unit) {
        Unit& unit = *result.entity.unit;
        refer(context, name.range, unit.symbol, Access::Read);
        if (access != Access::Call && unit.kind == UnitKind::Program && unit.instance && !unit.pou->methods.size()) {
            // a program's name stands for its only instance
        }
        return unitOf(unit, nullptr);
    }
    if (result.entity.type) {
        Denoted out;
        out.kind = DK::Type;
        out.declaredType = result.entity.type;
        out.type = resolveDeclared(context.world, *result.entity.type);
        refer(context, name.range, result.entity.type->symbol, Access::Read);
        return out;
    }
    const bool isStandard = library::findSignature(name.text) || library::findConversion(name.text);
    if (isStandard && !(result.list && !result.list->name.empty() && access != Access::Call)) {
        Denoted out;
        out.kind = DK::Standard;
        out.name = name.text;
        return out;
    }
    if (result.list) {
        Denoted out;
        out.kind = DK::List;
        out.list = result.list;
        return out;
    }
    if (result.space) {
        Denoted out;
        out.kind = DK::Space;
        out.space = result.space;
        return out;
    }
    if (const auto kind = elementaryNamed(name.text)) {
        Denoted out;
        out.kind = DK::Type;
        out.type = context.elementary(*kind);
        return out;
    }
    if (equalsIgnoringCase(name.text, "NULL")) {
        tree::Expr* null = constant(context, {context.elementary(TypeKind::Null), int64_t(0)}, name.range).expr;
        return valueOf({null, &context.types});
    }
    if (context.isExpression) { // names that only the image has: VAR_ACCESS
        if (const auto place = context.world.program->layout.find(name.text))
            return placeOf(absolutePlace(context, place->offset, place->type, place->bit, name.range));
    }
    return refuseUnknown(context, name);
}

/// `instance`: the block it is a variable of; null: seen from inside, or a global.
///   wrong: c := 6;  with VAR CONSTANT c (P2005)   x := b.temp;  with VAR_TEMP temp (P2026)
Denoted ofVariable(Context& context, Variable& declared, tree::Place* instance, SourceRange range, Access access) {
    const TypeId type = typeOf(context.world, declared);
    refer(context, range, declared.symbol, access);
    Variable& variable = declared.target ? *declared.target : declared;
    if (!context.isMuted && !context.isExpression) {
        for (Variable* counted : {&declared, &variable}) {
            if (access != Access::Write) ++counted->reads;
            if (access != Access::Read) ++counted->writes;
        }
    }
    if (declared.isResult && access != Access::Read && access != Access::Call) context.flow.isResultSet = true;
    Denoted out;
    out.variable = &variable;
    const bool isRead = access == Access::Read || access == Access::Call;
    if (variable.isConstant && isFoldable(context.types, type)) {
        if (const types::Value* value = constantOf(context.world, variable)) {
            if (!isRead) {
                context.emit(range, findings::NotAssignable(phrases::ConstantVariable(variable.name)));
                return {};
            }
            out.kind = DK::Value;
            out.value = constant(context, *value, range);
            return out;
        }
        return {};
    }
    if (context.isKind(type, TypeKind::Unknown)) return {};
    tree::Place* place = nullptr;
    switch (variable.storage) {
    case Storage::None:
        if (variable.kind == SectionKind::External ||
            !context.function) { // not laid out yet: only its type is asked for
            place = absolutePlace(context, 0, type, -1, range);
            break;
        }
        place = absolutePlace(context, 0, type, -1, range);
        break;
    case Storage::Absolute:
        place = absolutePlace(context, variable.offset, type, variable.bit, range);
        break;
    case Storage::Instance: {
        tree::Place* base = instance ? instance : thisPlace(context, range);
        if (variable.isInOut()) {
            place = context.arena.make<tree::Place>();
            place->kind = tree::PlaceKind::InOutSlot;
            place->type = type;
            place->range = range;
            place->base = base;
            place->offset = variable.offset;
            break;
        }
        const bool isEdge = !instance && variable.edgeOffset != Id<int>::kNone && isRead;
        place = fieldPlace(context, base, isEdge ? variable.edgeOffset : variable.offset, type, -1, range);
        break;
    }
    case Storage::Local:
        if (context.isExpression) {
            context.emit(range, findings::NotAllowedInExpression(variable.name));
            return {};
        }
        place = localPlace(context, variable.local, type, range);
        break;
    case Storage::Temporary:
        if (context.isExpression || instance) {
            context.emit(range, context.isExpression ? findings::NotAllowedInExpression(variable.name)
                                                     : findings::NoAccess(variable.name, Verbatim("VAR_TEMP")));
            return {};
        }
        place = context.function ? localPlace(context, temporaryOf(context, variable), type, range)
                                 : absolutePlace(context, 0, type, -1, range);
        break;
    }
    out.kind = DK::Place;
    out.place = context.isKind(type, TypeKind::Reference) ? dereferenced(context, place, range) : place;
    out.isExact = context.isKind(type, TypeKind::Block) && !variable.isInOut();
    if (variable.isConstant || (variable.section && variable.section->constant && !instance)) {
        out.isReadOnly = true;
        out.whyReadOnly = phrases::ConstantVariable(variable.name);
    } else if (variable.isReadOnlyReference) {
        out.isReadOnly = true;
        out.whyReadOnly = phrases::AnInput();
    } else if (instance && !context.isExpression && !context.isTest) {
        if (variable.kind == SectionKind::Output && !variable.isProgramInstance && variable.owner &&
            variable.owner->kind == UnitKind::Block) {
            out.isReadOnly = true;
            out.whyReadOnly = phrases::OutputOfBlock(variable.name);
        } else if (variable.kind == SectionKind::Var && variable.owner && variable.owner->kind == UnitKind::Block &&
                   !context.isKind(type, TypeKind::Block) && !(variable.section && variable.section->isPublic)) {
            out.isReadOnly = true;
            out.whyReadOnly = phrases::LocalOf(variable.name, variable.owner->name);
        }
    }
    return out;
}

///   ok:    t.Q; p.x      wrong: t.Z  with t : TON (P2002)
Denoted memberOf(Context& context, tree::Place* base, Denoted from, const syntax::Name& name, SourceRange range,
                 Access access) {
    const TypeId type = base->type;
    const NameId id = context.key(name.text);
    const auto unknownMember = [&]() -> Denoted {
        suggest(context, context.emit(name.range, findings::UnknownMember(context.nameOf(type), name.text)), name.range,
                name.text, memberNames(context.world, type));
        return {};
    };
    switch (context.types.kind(type)) {
    case TypeKind::Unknown:
        return {};
    case TypeKind::Struct:
    case TypeKind::Union: {
        const types::Field* field = fieldOf(context.world, type, name.text);
        if (!field) return unknownMember();
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
        if (out.place != place) out.isReadOnly = false;
        out.isExact = true;
        out.isSuper = false;
        return out;
    }
    case TypeKind::Block: {
        Unit* unit = context.world.unitOf(type);
        if (!unit) return unknownMember();
        Member member = findMember(context.world, *unit, id);
        const bool fromInside = base->kind == tree::PlaceKind::Instance && base->offset == 0 && context.scope.unit &&
                                context.scope.unit->self() &&
                                context.types.isDerivedFrom(context.scope.unit->self()->type, type);
        if (member.variable && (member.unit || member.property) && !fromInside &&
            !isParameterKind(member.variable->kind))
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
            checkAccess(context, accessOf(member.variable->section), member.variable->owner, member.variable->name,
                        name.range);
            Denoted out = ofVariable(context, *member.variable, fromInside ? nullptr : base, range, access);
            if (out.kind == DK::Place && name.range.file.isValid() && !out.variable) out.variable = member.variable;
            return out;
        }
        if (member.property) {
            checkAccess(context, member.property->declaration->access, member.property->owner, member.property->name,
                        name.range);
            Denoted out;
            out.kind = DK::Property;
            out.property = member.property;
            out.instance = base;
            out.isSuper = from.isSuper;
            out.isExact = from.isExact;
            refer(context, name.range, out.property->symbol, access);
            return out;
        }
        return unknownMember();
    }
    case TypeKind::Interface: {
        Unit* unit = context.world.unitOf(type);
        if (!unit) return unknownMember();
        const Member member = findMember(context.world, *unit, id);
        Denoted out;
        if (member.unit) {
            refer(context, name.range, member.unit->symbol, Access::Read);
            out = unitOf(*member.unit, nullptr);
        } else if (member.property) {
            refer(context, name.range, member.property->symbol, access);
            out.kind = DK::Property;
            out.property = member.property;
        } else {
            return unknownMember();
        }
        out.interface = load(context, base, range).expr;
        return out;
    }
    case TypeKind::Pointer: {
        auto& diagnostic = context.emit(name.range, findings::UnknownMember(context.nameOf(type), name.text));
        const SourceRange dot{name.range.file, name.range.begin - 1, name.range.begin - 1};
        if (context.types[context.types[type].element].findField(name.text))
            diagnostic.fixes.push_back({fixes::Dereference(), {{dot, "^"}}});
        return {};
    }
    default:
        if (const auto bit = namedBit(context, from, base, name, range)) return *bit;
        return unknownMember();
    }
}

/// Whether a variable of this type could have such a member; scalars have none.
bool hasMembers(Context& context, Variable& variable, std::string_view name) {
    const TypeId type = typeOf(context.world, variable);
    const TypeKind kind = context.types.kind(type);
    if (kind == TypeKind::Struct || kind == TypeKind::Union) return fieldOf(context.world, type, name) != nullptr;
    return kind == TypeKind::Block || kind == TypeKind::Interface || kind == TypeKind::Pointer ||
           kind == TypeKind::Reference || kind == TypeKind::Unknown;
}

/// What a returned REFERENCE TO refers to: a variable elsewhere, which can be written.
static tree::Place* referredBy(Context& context, const Operand& reference, SourceRange range) {
    tree::Place* place = context.arena.make<tree::Place>();
    place->kind = tree::PlaceKind::Deref;
    place->type = context.types[reference.type()].element;
    place->range = range;
    place->pointer = reference.expr;
    return place;
}

/// A member of a value that no variable holds: the value is kept in a temporary for it.
static Denoted memberOfValue(Context& context, const Denoted& from, const syntax::Expr& e, Access access) {
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
static Denoted memberOfProperty(Context& context, const Denoted& from, const syntax::Expr& e, Access access) {
    const syntax::Expr& base = *e.base;
    const Operand value = propertyValue(context, from, base.range);
    if (value.isUnknown()) return {};
    tree::Place* held = temporary(context, value);
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
static Denoted memberOfType(Context& context, const Denoted& from, const syntax::Expr& e) {
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
static Denoted memberOfUnit(Context& context, const Denoted& from, const syntax::Expr& e, Access access) {
    const syntax::Expr& base = *e.base;
    const NameId id = context.key(e.name.text);
    Unit& unit = *from.unit;
    const Member member = unit.isInstanced() ? findMember(context.world, unit, id) : Member{};
    if (member.variable &&
        ((member.variable->isConstant && isFoldable(context.types, typeOf(context.world, *member.variable))) ||
         member.variable->storage == Storage::Absolute))
        return ofVariable(context, *member.variable, nullptr, e.range, access);
    if (unit.kind == UnitKind::Program) {
        Unit* self = context.scope.unit ? context.scope.unit->self() : nullptr;
        tree::Place* instance = nullptr;
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
        if (!context.function && !context.isExpression && member.variable)
            return ofVariable(context, *member.variable, nullptr, e.range, access);
    }
    if (unit.kind == UnitKind::Program)
        context.emit(base.range, findings::NoValue(unit.name));
    else
        suggest(context, context.emit(e.name.range, findings::UnknownMember(unit.name, e.name.text)), e.name.range,
                e.name.text, memberNames(context.world, unit.type));
    return {};
}

/// GVL.x
static Denoted memberOfList(Context& context, const Denoted& from, const syntax::Expr& e, Access access) {
    const NameId id = context.key(e.name.text);
    const auto it = from.list->variables.find(id);
    if (it != from.list->variables.end()) return ofVariable(context, *it->second, nullptr, e.range, access);
    std::vector<std::string> candidates;
    for (const auto& [known, variable] : from.list->variables) candidates.push_back(variable->name);
    suggest(context, context.emit(e.name.range, findings::UnknownMember(from.list->name, e.name.text)), e.name.range,
            e.name.text, candidates);
    return {};
}

/// Lib.F, also of the standard functions.
static Denoted memberOfSpace(Context& context, const Denoted& from, const syntax::Expr& e, Access access, TypeId hint) {
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
static Denoted denoteBase(Context& context, const syntax::Expr& e, Access access, TypeId hint, bool& isWhole) {
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
        !findMember(context.world, *own->program, id)) // a name only the image has: VAR_ACCESS of a program
        if (const auto place =
                context.world.program->layout.find(std::string(base.name.text) + "." + std::string(e.name.text)))
            return placeOf(absolutePlace(context, place->offset, place->type, place->bit, e.range));
    if (own && !hasMembers(context, *own, e.name.text)) { // a variable may have the name of its type: Light.Red
        const Found outer = lookup(context.world, context.scope, context.key(base.name.text), true);
        if (outer.entity.type && context.world.enumsByType.count(resolveDeclared(context.world, *outer.entity.type))) {
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
        if (!result.entity.unit && !result.entity.type && !result.space) {
            std::vector<std::string> candidates;
            for (const auto& [key, variable] : result.list->variables) candidates.push_back(variable->name);
            suggest(context, context.emit(e.name.range, findings::UnknownMember(result.list->name, e.name.text)),
                    e.name.range, e.name.text, candidates);
            return {};
        }
    }
    if (!isOwn && result.space && !result.entity.unit && !result.entity.type && !result.member) {
        return found(context, lookupIn(*result.space, id), e.name, access, hint);
    }
    isWhole = false;
    if (from.kind != DK::Nothing) return from;
    return found(context, result, base.name, baseAccess, {});
}

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
