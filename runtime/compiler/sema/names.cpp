// What names mean: NameRef, Member, Index, Deref, Bit, Address → a place, a value, a unit, a type…
#include "runtime/compiler/sema/checker.h"

#include "runtime/base/text.h"

#include <algorithm>

namespace plc::sema {

using syntax::ExprKind;
using syntax::SectionKind;
using types::TypeTable;

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
bool Checker::checkAccess(syntax::Access access, const Unit* owner, const std::string& name, SourceRange range) {
    if (isExpression || isTest || world.isAccessible(access, owner, scope)) return true; // a watch sees everything
    emit(range, findings::NoAccess(name, accessWord(access)));
    return false;
}

///   wrong: THIS^.x  in a FUNCTION (P3018)
Denoted Checker::denote(const syntax::Expr& e, Access access, TypeId hint) {
    switch (e.kind) {
    case ExprKind::NameRef:
        return denoteName(e, access, hint);
    case ExprKind::Member:
        return denoteMember(e, access, hint);
    case ExprKind::Index:
        return denoteIndex(e, access);
    case ExprKind::Bit:
        return denoteBit(e, access);
    case ExprKind::Deref:
        return denoteDeref(e, access);
    case ExprKind::Address:
        return denoteAddress(e);
    case ExprKind::This:
    case ExprKind::Super: {
        Unit* self = scope.unit ? scope.unit->self() : nullptr;
        if (!self || (e.kind == ExprKind::Super && !self->base)) {
            emit(e.range, findings::NotAllowedHere(Verbatim(e.kind == ExprKind::Super ? "SUPER" : "THIS"),
                                                   self ? phrases::In(self->name) : phrases::Here()));
            return {};
        }
        Denoted out = placeOf(thisPlace(e.range));
        if (e.kind == ExprKind::Super) {
            out.place->type = self->base->type;
            out.isSuper = true;
        }
        return out;
    }
    case ExprKind::Error:
        return {};
    default: {
        const Operand operand = expression(e, hint);
        return operand.isUnknown() ? Denoted{} : valueOf(operand);
    }
    }
}

tree::Place* Checker::place(const syntax::Expr& e, Access access) {
    const Denoted denoted = denote(e, access);
    if (denoted.kind == DK::Nothing) return nullptr;
    if (denoted.kind == DK::Place) return denoted.place;
    emit(e.range, findings::NotAssignable(textOf(e.range)));
    return nullptr;
}

Denoted Checker::denoteName(const syntax::Expr& e, Access access, TypeId hint) {
    if (!e.name.isValid()) return {};
    const World::Found result = world.lookup(scope, world.key(e.name.text));
    return found(result, e.name, access, hint);
}

///   ok:    x := x + 1;      wrong: x := y;  where nothing is called y (P2001)
Denoted Checker::found(const World::Found& result, const syntax::Name& name, Access access, TypeId hint) {
    if (result.member.variable && result.member.variable->isResult && access == Access::Call &&
        !result.member.unit) { // F(…) inside F
        Unit& own = *result.member.variable->owner;
        refer(name.range, own.symbol, Access::Read);
        return unitOf(own, own.owner ? thisPlace(name.range) : nullptr);
    }
    if (result.member.variable && !(access == Access::Call && result.member.unit))
        return ofVariable(*result.member.variable, nullptr, name.range, access);
    if (result.member.unit) {
        refer(name.range, result.member.unit->symbol, Access::Read);
        Denoted out = unitOf(*result.member.unit, function || isExpression ? thisPlace(name.range) : nullptr);
        return out;
    }
    if (result.member.property) {
        Denoted out;
        out.kind = DK::Property;
        out.property = result.member.property;
        out.instance = thisPlace(name.range);
        refer(name.range, out.property->symbol, access);
        return out;
    }
    if (!result.ambiguous.empty()) {
        std::vector<std::string> all;
        for (const std::string& where : result.ambiguous)
            all.push_back((where.empty() ? "" : where + ".") + std::string(name.text));
        auto& diagnostic = emit(name.range, findings::AmbiguousName(name.text, all));
        for (const std::string& where : result.ambiguous)
            if (!where.empty())
                diagnostic.fixes.push_back({fixes::Write(where + "." + std::string(name.text)),
                                            {{name.range, where + "." + std::string(name.text)}}});
        return {};
    }
    if (result.entity.variable) return ofVariable(*result.entity.variable, nullptr, name.range, access);
    if (!result.enumerators.empty() && !(access == Access::Call && result.entity.unit)) {
        const EnumeratorRef* chosen = result.enumerators.size() == 1 ? &result.enumerators.front() : nullptr;
        for (const EnumeratorRef& ref : result.enumerators)
            if (hint.isValid() &&
                (ref.type->type == hint || (world.enumsByType.count(hint) && world.enumsByType.at(hint) == ref.type)))
                chosen = &ref;
        if (chosen) return valueOf(enumerator(*chosen, name.range));
        std::vector<std::string> all;
        for (const EnumeratorRef& ref : result.enumerators)
            all.push_back(ref.type->name + "." + std::string(name.text));
        auto& diagnostic = emit(name.range, findings::AmbiguousName(name.text, all));
        for (const EnumeratorRef& ref : result.enumerators)
            diagnostic.fixes.push_back({fixes::Write(ref.type->name + "." + std::string(name.text)),
                                        {{name.range, ref.type->name + "." + std::string(name.text)}}});
        return {};
    }
    if (result.entity.unit) {
        Unit& unit = *result.entity.unit;
        refer(name.range, unit.symbol, Access::Read);
        if (access != Access::Call && unit.kind == UnitKind::Program && unit.instance && !unit.pou->methods.size()) {
            // a program's name stands for its only instance
        }
        return unitOf(unit, nullptr);
    }
    if (result.entity.type) {
        Denoted out;
        out.kind = DK::Type;
        out.declaredType = result.entity.type;
        out.type = world.resolveDeclared(*result.entity.type);
        refer(name.range, result.entity.type->symbol, Access::Read);
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
        out.type = elementary(*kind);
        return out;
    }
    if (equalsIgnoringCase(name.text, "NULL")) {
        tree::Expr* null = constant({elementary(TypeKind::Null), int64_t(0)}, name.range).expr;
        return valueOf({null, &types});
    }
    if (isExpression) { // names that only the image has: VAR_ACCESS
        if (const auto place = world.program->layout.find(name.text))
            return placeOf(absolutePlace(place->offset, place->type, place->bit, name.range));
    }
    if (isTest && world.isAccessName(name.text)) return {};
    const bool isInstruction = scope.unit && scope.unit->pou && isOperatorOf(*scope.unit->pou, name.range);
    std::vector<std::string> candidates = world.visibleNames(scope);
    if (isInstruction)
        for (const char* op :
             {"LD",  "LDN", "ST",   "STN",   "AND", "ANDN", "ORN",   "XOR", "ADD",  "SUB",   "MUL", "DIV",
              "MOD", "JMP", "JMPC", "JMPCN", "CAL", "CALC", "CALCN", "RET", "RETC", "RETCN", "NOT"})
            candidates.emplace_back(op);
    world.suggest(
        emit(name.range, isInstruction ? findings::IlUnknownOperator(name.text) : findings::UndeclaredName(name.text)),
        name.range, name.text, candidates);
    return {};
}

/// `instance`: the block it is a variable of; null: seen from inside, or a global.
///   wrong: c := 6;  with VAR CONSTANT c (P2005)   x := b.temp;  with VAR_TEMP temp (P2026)
Denoted Checker::ofVariable(Variable& declared, tree::Place* instance, SourceRange range, Access access) {
    const TypeId type = world.typeOf(declared);
    refer(range, declared.symbol, access);
    Variable& variable = declared.target ? *declared.target : declared;
    if (!isMuted && !isExpression) {
        for (Variable* counted : {&declared, &variable}) {
            if (access != Access::Write) ++counted->reads;
            if (access != Access::Read) ++counted->writes;
        }
    }
    if (declared.isResult && access != Access::Read && access != Access::Call) flow.isResultSet = true;
    Denoted out;
    out.variable = &variable;
    const bool isRead = access == Access::Read || access == Access::Call;
    if (variable.isConstant && isFoldable(types, type)) {
        if (const types::Value* value = world.constantOf(variable)) {
            if (!isRead) {
                emit(range, findings::NotAssignable(phrases::ConstantVariable(variable.name)));
                return {};
            }
            out.kind = DK::Value;
            out.value = constant(*value, range);
            return out;
        }
        return {};
    }
    if (isKind(type, TypeKind::Unknown)) return {};
    tree::Place* place = nullptr;
    switch (variable.storage) {
    case Storage::None:
        if (variable.kind == SectionKind::External || !function) { // not laid out yet: only its type is asked for
            place = absolutePlace(0, type, -1, range);
            break;
        }
        place = absolutePlace(0, type, -1, range);
        break;
    case Storage::Absolute:
        place = absolutePlace(variable.offset, type, variable.bit, range);
        break;
    case Storage::Instance: {
        tree::Place* base = instance ? instance : thisPlace(range);
        if (variable.isInOut()) {
            place = arena.make<tree::Place>();
            place->kind = tree::PlaceKind::InOutSlot;
            place->type = type;
            place->range = range;
            place->base = base;
            place->offset = variable.offset;
            break;
        }
        const bool isEdge = !instance && variable.edgeOffset != Id<int>::kNone && isRead;
        place = fieldPlace(base, isEdge ? variable.edgeOffset : variable.offset, type, -1, range);
        break;
    }
    case Storage::Local:
        if (isExpression) {
            emit(range, findings::NotAllowedInExpression(variable.name));
            return {};
        }
        place = localPlace(variable.local, type, range);
        break;
    case Storage::Temporary:
        if (isExpression || instance) {
            emit(range, isExpression ? findings::NotAllowedInExpression(variable.name)
                                     : findings::NoAccess(variable.name, Verbatim("VAR_TEMP")));
            return {};
        }
        place = function ? localPlace(temporaryOf(variable), type, range) : absolutePlace(0, type, -1, range);
        break;
    }
    out.kind = DK::Place;
    out.place = isKind(type, TypeKind::Reference) ? dereferenced(place, range) : place;
    out.isExact = isKind(type, TypeKind::Block) && !variable.isInOut();
    if (variable.isConstant || (variable.section && variable.section->constant && !instance)) {
        out.isReadOnly = true;
        out.whyReadOnly = phrases::ConstantVariable(variable.name);
    } else if (instance && !isExpression && !isTest) {
        if (variable.kind == SectionKind::Output && !variable.isProgramInstance && variable.owner &&
            variable.owner->kind == UnitKind::Block) {
            out.isReadOnly = true;
            out.whyReadOnly = phrases::OutputOfBlock(variable.name);
        } else if (variable.kind == SectionKind::Var && variable.owner && variable.owner->kind == UnitKind::Block &&
                   !isKind(type, TypeKind::Block)) {
            out.isReadOnly = true;
            out.whyReadOnly = phrases::LocalOf(variable.name, variable.owner->name);
        }
    }
    return out;
}

///   ok:    t.Q; p.x      wrong: t.Z  with t : TON (P2002)
Denoted Checker::memberOf(tree::Place* base, Denoted from, const syntax::Name& name, SourceRange range, Access access) {
    const TypeId type = base->type;
    const NameId id = world.key(name.text);
    const auto unknownMember = [&]() -> Denoted {
        world.suggest(emit(name.range, findings::UnknownMember(nameOf(type), name.text)), name.range, name.text,
                      world.memberNames(type));
        return {};
    };
    switch (types.kind(type)) {
    case TypeKind::Unknown:
        return {};
    case TypeKind::Struct:
    case TypeKind::Union: {
        const types::Field* field = world.fieldOf(type, name.text);
        if (!field) return unknownMember();
        if (const auto it = world.structsByType.find(type); it != world.structsByType.end()) {
            const auto index = static_cast<size_t>(field - types[type].fields.data());
            if (index < it->second->symbols.size()) refer(name.range, it->second->symbols[index], access);
        }
        tree::Place* place = fieldPlace(base, field->offset, field->bit >= 0 ? elementary(TypeKind::Bool) : field->type,
                                        field->bit, range);
        Denoted out = from;
        out.kind = DK::Place;
        out.place = isKind(place->type, TypeKind::Reference) ? dereferenced(place, range) : place;
        if (out.place != place) out.isReadOnly = false;
        out.isExact = true;
        out.isSuper = false;
        return out;
    }
    case TypeKind::Block: {
        Unit* unit = world.unitOf(type);
        if (!unit) return unknownMember();
        Member member = world.findMember(*unit, id);
        const bool fromInside = base->kind == tree::PlaceKind::Instance && base->offset == 0 && scope.unit &&
                                scope.unit->self() && types.isDerivedFrom(scope.unit->self()->type, type);
        if (member.variable && (member.unit || member.property) && !fromInside &&
            !isParameterKind(member.variable->kind))
            member.variable = nullptr;
        if (member.unit && (access == Access::Call || !member.variable)) {
            Unit& called = *member.unit;
            checkAccess(called.access, called.owner, called.name, name.range);
            refer(name.range, called.symbol, Access::Read);
            Denoted out = unitOf(called, base);
            out.isSuper = from.isSuper;
            out.isExact = from.isExact;
            return out;
        }
        if (member.variable) {
            checkAccess(accessOf(member.variable->section), member.variable->owner, member.variable->name, name.range);
            Denoted out = ofVariable(*member.variable, fromInside ? nullptr : base, range, access);
            if (out.kind == DK::Place && name.range.file.isValid() && !out.variable) out.variable = member.variable;
            return out;
        }
        if (member.property) {
            checkAccess(member.property->declaration->access, member.property->owner, member.property->name,
                        name.range);
            Denoted out;
            out.kind = DK::Property;
            out.property = member.property;
            out.instance = base;
            out.isSuper = from.isSuper;
            out.isExact = from.isExact;
            refer(name.range, out.property->symbol, access);
            return out;
        }
        return unknownMember();
    }
    case TypeKind::Interface: {
        Unit* unit = world.unitOf(type);
        if (!unit) return unknownMember();
        const Member member = world.findMember(*unit, id);
        Denoted out;
        if (member.unit) {
            refer(name.range, member.unit->symbol, Access::Read);
            out = unitOf(*member.unit, nullptr);
        } else if (member.property) {
            refer(name.range, member.property->symbol, access);
            out.kind = DK::Property;
            out.property = member.property;
        } else {
            return unknownMember();
        }
        out.interface = load(base, range).expr;
        return out;
    }
    case TypeKind::Pointer: {
        auto& diagnostic = emit(name.range, findings::UnknownMember(nameOf(type), name.text));
        const SourceRange dot{name.range.file, name.range.begin - 1, name.range.begin - 1};
        if (types[types[type].element].findField(name.text))
            diagnostic.fixes.push_back({fixes::Dereference(), {{dot, "^"}}});
        return {};
    }
    default:
        return unknownMember();
    }
}

/// Whether a variable of this type could have such a member; scalars have none.
bool Checker::hasMembers(Variable& variable, std::string_view name) {
    const TypeId type = world.typeOf(variable);
    const TypeKind kind = types.kind(type);
    if (kind == TypeKind::Struct || kind == TypeKind::Union) return world.fieldOf(type, name) != nullptr;
    return kind == TypeKind::Block || kind == TypeKind::Interface || kind == TypeKind::Pointer ||
           kind == TypeKind::Reference || kind == TypeKind::Unknown;
}

Denoted Checker::denoteMember(const syntax::Expr& e, Access access, TypeId hint) {
    if (!e.base) return {};
    const syntax::Expr& base = *e.base;
    if (!e.name.isValid()) return {};
    const NameId id = world.key(e.name.text);
    Denoted from;
    const Access baseAccess = access == Access::Address ? Access::ReadWrite : access;
    if (base.kind == ExprKind::NameRef) {
        const World::Found result = world.lookup(scope, world.key(base.name.text));
        Variable* own = result.member.variable     ? result.member.variable
                        : result.ambiguous.empty() ? result.entity.variable
                                                   : nullptr;
        if (isExpression && own && own->isProgramInstance && own->program &&
            !world.findMember(*own->program, id)) // a name only the image has: VAR_ACCESS of a program
            if (const auto place =
                    world.program->layout.find(std::string(base.name.text) + "." + std::string(e.name.text)))
                return placeOf(absolutePlace(place->offset, place->type, place->bit, e.range));
        if (own && !hasMembers(*own, e.name.text)) { // a variable may have the name of its type: Light.Red
            const World::Found outer = world.lookup(scope, world.key(base.name.text), true);
            if (outer.entity.type && world.enumsByType.count(world.resolveDeclared(*outer.entity.type))) {
                World::Found typeOnly;
                typeOnly.entity.type = outer.entity.type;
                from = found(typeOnly, base.name, Access::Read, {});
                own = nullptr;
            }
        }
        const bool isOwn = own || from.kind != DK::Nothing;
        if (!isOwn && result.list) { // GVL.x, also where a program unit has the list's name
            if (const auto it = result.list->variables.find(id); it != result.list->variables.end())
                return ofVariable(*it->second, nullptr, e.range, access);
            if (!result.entity.unit && !result.entity.type && !result.space) {
                std::vector<std::string> candidates;
                for (const auto& [key, variable] : result.list->variables) candidates.push_back(variable->name);
                world.suggest(emit(e.name.range, findings::UnknownMember(result.list->name, e.name.text)), e.name.range,
                              e.name.text, candidates);
                return {};
            }
        }
        if (!isOwn && result.space && !result.entity.unit && !result.entity.type && !result.member) {
            return found(world.lookupIn(*result.space, id), e.name, access, hint);
        }
        if (from.kind == DK::Nothing)
            from = found(result, base.name, baseAccess == Access::Call ? Access::ReadWrite : baseAccess, {});
    } else {
        from = denote(base, baseAccess == Access::Call ? Access::ReadWrite : baseAccess);
    }
    switch (from.kind) {
    case DK::Nothing:
        return {};
    case DK::Place:
        return memberOf(from.place, from, e.name, e.range, access);
    case DK::Value: {
        if (isKind(from.value.type(), TypeKind::Interface)) {
            Denoted out = memberOf(temporary(from.value), from, e.name, e.range, access);
            out.interface = from.value.expr;
            return out;
        }
        Denoted out = memberOf(temporary(from.value), from, e.name, e.range, access);
        out.isReadOnly = true;
        out.whyReadOnly = textOf(e.range);
        return out;
    }
    case DK::Property: {
        const Operand value = propertyValue(from, base.range);
        if (value.isUnknown()) return {};
        tree::Place* held = temporary(value);
        const bool isReference = isKind(value.type(), TypeKind::Reference);
        if (isReference) {
            tree::Place* place = arena.make<tree::Place>();
            place->kind = tree::PlaceKind::Deref;
            place->type = types[value.type()].element;
            place->range = base.range;
            place->pointer = value.expr;
            held = place;
        }
        Denoted out = memberOf(held, {}, e.name, e.range, access);
        if (!isReference && out.kind == DK::Place && !isKind(value.type(), TypeKind::Interface)) {
            out.isReadOnly = true;
            out.whyReadOnly = textOf(e.range);
        }
        return out;
    }
    case DK::Type: {
        if (const auto it = world.enumsByType.find(from.type); it != world.enumsByType.end()) {
            EnumType& enumeration = *it->second;
            if (const auto named = enumeration.indices.find(id); named != enumeration.indices.end()) {
                Operand value = enumerator({&enumeration, named->second}, e.name.range);
                value.expr->range = e.range;
                return valueOf(value);
            }
        }
        world.suggest(emit(e.name.range, findings::UnknownMember(textOf(base.range), e.name.text)), e.name.range,
                      e.name.text, world.memberNames(from.type));
        return {};
    }
    case DK::Unit: {
        Unit& unit = *from.unit;
        const Member member = unit.isInstanced() ? world.findMember(unit, id) : Member{};
        if (member.variable && ((member.variable->isConstant && isFoldable(types, world.typeOf(*member.variable))) ||
                                member.variable->storage == Storage::Absolute))
            return ofVariable(*member.variable, nullptr, e.range, access);
        if (unit.kind == UnitKind::Program) {
            Unit* self = scope.unit ? scope.unit->self() : nullptr;
            tree::Place* instance = nullptr;
            if (self == &unit)
                instance = thisPlace(base.range);
            else if (unit.instance)
                instance = absolutePlace(unit.instance->offset, unit.type, -1, base.range);
            if (instance) {
                Denoted exact;
                exact.isExact = true;
                Denoted out = memberOf(instance, exact, e.name, e.range, access);
                if (!isKind(unit.type, TypeKind::Unknown) && out.kind == DK::Place && out.variable &&
                    out.variable->owner && out.variable->owner->kind == UnitKind::Program && !out.variable->isConstant)
                    out.isReadOnly = false;
                return out;
            }
            if (!function && !isExpression && member.variable)
                return ofVariable(*member.variable, nullptr, e.range, access);
        }
        if (unit.kind == UnitKind::Program)
            emit(base.range, findings::NoValue(unit.name));
        else
            world.suggest(emit(e.name.range, findings::UnknownMember(unit.name, e.name.text)), e.name.range,
                          e.name.text, world.memberNames(unit.type));
        return {};
    }
    case DK::List: {
        const auto it = from.list->variables.find(id);
        if (it != from.list->variables.end()) return ofVariable(*it->second, nullptr, e.range, access);
        std::vector<std::string> candidates;
        for (const auto& [known, variable] : from.list->variables) candidates.push_back(variable->name);
        world.suggest(emit(e.name.range, findings::UnknownMember(from.list->name, e.name.text)), e.name.range,
                      e.name.text, candidates);
        return {};
    }
    case DK::Space: {
        const World::Found result = world.lookupIn(*from.space, id);
        const bool isStandard = library::findSignature(e.name.text) || library::findConversion(e.name.text);
        if (!result.isNothing() || isStandard || elementaryNamed(e.name.text))
            return found(result, e.name, access, hint);
        std::vector<std::string> candidates;
        world.addNames(*from.space, candidates);
        world.suggest(emit(e.name.range, findings::UnknownMember(from.space->qualified, e.name.text)), e.name.range,
                      e.name.text, candidates);
        return {};
    }
    case DK::Standard:
        emit(base.range, findings::NoValue(textOf(base.range)));
        return {};
    }
    return {};
}

} // namespace plc::sema
