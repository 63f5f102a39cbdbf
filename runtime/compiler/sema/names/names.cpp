// What names mean: NameRef, Member, Index, Deref, Bit, Address → a place, a value, a unit, a type…
// A name is looked up once (lookup.cpp); what it means then depends on where it is used: `found` chooses among
// everything of that name by the access that is wanted, in the order in which an outer thing is hidden by an inner one.
#include "runtime/compiler/sema/names/names.h"

#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/declare/tests.h"
#include "runtime/compiler/sema/names/elements.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/members.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/names/unknown_base.h"
#include "runtime/compiler/sema/program/analyze.h"
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
        // Among the initial values of a structure THIS is the structure, also where that is written in a block.
        const bool isInStructure = context.scope.structure.isValid();
        if (isInStructure && e.kind == ExprKind::This) return placeOf(thisPlace(context, e.range));
        // self(): the block a method or action belongs to.
        Unit* self = context.scope.unit && !isInStructure ? context.scope.unit->self() : nullptr;
        if (e.kind == ExprKind::Super && hasUnknownBase(self)) return {};
        if (!self || (e.kind == ExprKind::Super && !self->base)) {
            context.emit(e.range, findings::NotAllowedHere(Verbatim(e.kind == ExprKind::Super ? "SUPER" : "THIS"),
                                                           self ? phrases::In(self->name) : phrases::Here()));
            return {};
        }
        Denoted out = placeOf(thisPlace(context, e.range));
        if (e.kind == ExprKind::Super) {
            // The same instance seen as its base: fields have the same offsets.
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
    // A property or a constant has no place that anybody could refer to.
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
    // A variable hides a method of its name, except where it is called.
    if (result.member.variable && !(access == Access::Call && result.member.unit))
        return ofVariable(context, *result.member.variable, nullptr, name.range, access);
    if (context.scope.structure.isValid() && (result.member.unit || result.member.property)) {
        context.emit(name.range, findings::NotConstant());
        return Denoted{};
    }
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
    // Each of the full names is a fix: one of them is meant.
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
    // color := Red finds Color.Red although Light.Red exists, because the left side says which.
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
    // Names of VAR_ACCESS are made with the layout, after this.
    if (context.isTest && isAccessName(context.world, name.text)) return {};
    if (context.scope.unit && hasUnknownBase(context.scope.unit->self())) return {};
    // In an instruction list an unknown word at the place of an operator is a misspelt operator.
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
    // After everything that is declared around the structure: a field does not hide a constant of its name.
    if (result.isNothing() && access != Access::Call)
        if (const auto field = fieldOfThis(context, name, access)) return *field;
    if (const auto member = foundMember(context, result, name, access)) return *member;
    // After members: what the unit has itself is never ambiguous.
    if (!result.ambiguous.empty()) return refuseAmbiguous(context, result, name);
    if (result.entity.variable) return ofVariable(context, *result.entity.variable, nullptr, name.range, access);
    if (!result.enumerators.empty() && !(access == Access::Call && result.entity.unit))
        return foundEnumerator(context, result, name, hint);
    if (result.entity.unit) {
        Unit& unit = *result.entity.unit;
        refer(context, name.range, unit.symbol, Access::Read);
        return unitOf(unit, nullptr);
    }
    if (result.entity.type) {
        Denoted out;
        out.kind = DK::Type;
        out.declaredType = result.entity.type;
        out.type = resolveDeclared(context, *result.entity.type);
        refer(context, name.range, result.entity.type->symbol, Access::Read);
        return out;
    }
    // Standard functions come after everything that the program declares: a project may have a MAX of its own.
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
    // INT as an operand: SIZEOF(INT), or a cast INT(x).
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

/// The value of a constant; Nothing when it was reported, or is written to.
static Denoted ofConstant(Context& context, Variable& variable, SourceRange range, bool isRead) {
    // Folded here if nobody has asked before; a cycle was reported and gives nothing.
    const types::Value* value = constantOf(context, variable);
    if (!value) return {};
    if (!isRead) {
        context.emit(range, findings::NotAssignable(phrases::ConstantVariable(variable.name)));
        return {};
    }
    Denoted out = valueOf(constant(context, *value, range));
    out.variable = &variable;
    return out;
}

/// A field of THIS, or of `instance`. An in-out is a slot that holds where its argument is.
static tree::Place* instancePlace(Context& context, const Variable& variable, TypeId type, tree::Place* instance,
                                  SourceRange range, bool isRead) {
    tree::Place* base = instance ? instance : thisPlace(context, range);
    if (variable.isInOut()) {
        tree::Place* slot = context.arena.make<tree::Place>();
        slot->kind = tree::PlaceKind::InOutSlot;
        slot->type = type;
        slot->range = range;
        slot->base = base;
        slot->offset = variable.offset;
        return slot;
    }
    // inside its block an input with R_EDGE reads as its edge; from outside it is what was passed
    const bool isEdge = !instance && variable.edgeOffset != Id<int>::kNone && isRead;
    return fieldPlace(context, base, isEdge ? variable.edgeOffset : variable.offset, type, -1, range);
}

/// Where the variable is, by how it is stored; null: reported.
static tree::Place* storedPlace(Context& context, Variable& variable, TypeId type, tree::Place* instance,
                                SourceRange range, bool isRead) {
    // A structure's initial values are its type's: they are made without the unit it is written in.
    const bool isOfUnit = variable.storage != Storage::None && variable.storage != Storage::Absolute;
    if (isOfUnit && !instance && context.scope.structure.isValid()) {
        context.emit(range, findings::NotConstant());
        return nullptr;
    }
    switch (variable.storage) {
    case Storage::None: // not laid out yet: only its type is asked for
        // Offset 0: bodies are only checked once everything has its place, so this one is never emitted.
        return absolutePlace(context, 0, type, -1, range);
    case Storage::Absolute:
        return absolutePlace(context, variable.offset, type, variable.bit, range);
    case Storage::Instance:
        return instancePlace(context, variable, type, instance, range, isRead);
    case Storage::Local:
        if (context.isExpression) {
            context.emit(range, findings::NotAllowedInExpression(variable.name));
            return nullptr;
        }
        // What a function keeps (VAR_STAT, an address) begins before any call, when it has no locals.
        if (context.function && variable.owner && variable.owner->function != context.functionId) {
            context.emit(range, findings::NotConstant());
            return nullptr;
        }
        return localPlace(context, variable.local, type, range);
    case Storage::Temporary:
        if (!context.isExpression && !instance)
            return context.function ? localPlace(context, temporaryOf(context, variable), type, range)
                                    : absolutePlace(context, 0, type, -1, range);
        context.emit(range, context.isExpression ? findings::NotAllowedInExpression(variable.name)
                                                 : findings::NoAccess(variable.name, Verbatim("VAR_TEMP")));
        return nullptr;
    }
    return nullptr;
}

/// Constants everywhere; from outside also what a block keeps to itself or gives out.
static void noteReadOnly(Context& context, Denoted& out, const Variable& variable, TypeId type, bool isOutside) {
    const bool isDeclared = variable.section && variable.section->constant && !isOutside;
    // TwinCAT lets a block write its own VAR_INPUT CONSTANT; see tellConstantInput.
    const bool isOwnInput = isDeclared && variable.kind == SectionKind::Input && !context.world.options.strict;
    if (variable.isConstant || (isDeclared && !isOwnInput)) {
        out.isReadOnly = true;
        out.whyReadOnly = phrases::ConstantVariable(variable.name);
        return;
    }
    if (variable.isReadOnlyReference) {
        out.isReadOnly = true;
        out.whyReadOnly = phrases::AnInput();
        return;
    }
    // A watch may write everything, and a test is the machine's surroundings.
    if (!isOutside || context.isExpression || context.isTest) return;
    const bool isPublic = variable.section && variable.section->isPublic;
    const bool isOfBlock = variable.owner && variable.owner->kind == UnitKind::Block;
    if (variable.kind == SectionKind::Output && !variable.isProgramInstance && isOfBlock) {
        out.isReadOnly = true;
        out.whyReadOnly = phrases::OutputOfBlock(variable.name);
    } else if (variable.kind == SectionKind::Var && isOfBlock && !context.isKind(type, TypeKind::Block) && !isPublic) {
        out.isReadOnly = true;
        out.whyReadOnly = phrases::LocalOf(variable.name, variable.owner->name);
    }
}

/// `instance`: the block it is a variable of; null: seen from inside, or a global.
///   wrong: c := 6;  with VAR CONSTANT c (P2005)   x := b.temp;  with VAR_TEMP temp (P2026)
Denoted ofVariable(Context& context, Variable& declared, tree::Place* instance, SourceRange range, Access access) {
    const TypeId type = typeOf(context, declared);
    refer(context, range, declared.symbol, access);
    // VAR_EXTERNAL: the global that it refers to.
    Variable& variable = declared.target ? *declared.target : declared;
    if (!context.isMuted && !context.isExpression) {
        // Both are used: the declaration in the unit and the global.
        for (Variable* counted : {&declared, &variable})
            count(context, *counted, access != Access::Write, access != Access::Read);
    }
    // Flow is followed by names: writing any part of the result counts as setting it.
    if (declared.isResult && access != Access::Read && access != Access::Call) context.flow.isResultSet = true;
    const bool isRead = access == Access::Read || access == Access::Call;
    if (variable.isConstant && isFoldable(context.types, type)) {
        Denoted out = ofConstant(context, variable, range, isRead || access == Access::Address);
        if (access == Access::Address) out.variable = &variable; // ADR finds where it is stored
        return out;
    }
    if (context.isKind(type, TypeKind::Unknown)) return {};
    tree::Place* place = storedPlace(context, variable, type, instance, range, isRead);
    if (!place) return {};
    Denoted out = placeOf(context.isKind(type, TypeKind::Reference) ? dereferenced(context, place, range) : place);
    out.variable = &variable;
    // What is behind an in-out may be derived from the declared block.
    out.isExact = context.isKind(type, TypeKind::Block) && !variable.isInOut();
    noteReadOnly(context, out, variable, type, instance != nullptr);
    return out;
}

} // namespace plc::sema
