// Calls of functions, methods and accessors: arguments are matched with parameters, defaults made explicit, dispatch
// chosen.
#include "runtime/compiler/sema/checker.h"

#include "runtime/base/text.h"
#include "runtime/types/conversion.h"

namespace plc::sema {

namespace {
/// The outputs of SPLIT_DATE and its like are any integers (table 36): a part whose range fits is no loss.
bool fitsPartOfDate(const Unit& unit, const Variable& part, TypeKind to) {
    if (!unit.isLibrary() || !unit.name.starts_with("SPLIT_")) return false;
    if (to == TypeKind::Uint) return true;
    if (to != TypeKind::Usint && to != TypeKind::Sint) return false;
    return part.name == "MONTH" || part.name == "DAY" || part.name == "HOUR" || part.name == "MINUTE" ||
           part.name == "SECOND";
}
} // namespace

using syntax::ArgumentKind;
using syntax::SectionKind;

/// Which argument belongs to which parameter: by name, or by position.
///   ok:    t(IN := TRUE, Q => b); F(1, 2);
///   wrong: t(INN := TRUE);  (P2009)   F(1, 2, 3);  of two (P2011)   t(IN := TRUE, IN := FALSE);  (P2012)
///          t(Q := b);  (P2036)
Checker::Matched Checker::match(const syntax::Expr& call, const std::string& name,
                                const std::vector<Variable*>& parameters) {
    Matched out;
    for (Variable* parameter : parameters) out.matches.push_back({nullptr, parameter});
    const auto find = [&](NameId id) -> Match* {
        for (Match& match : out.matches)
            if (match.parameter->id == id) return &match;
        for (Match& match : out.matches) { // aliases of a pin
            if (!match.parameter->owner) continue;
            const auto it = match.parameter->owner->members.find(id);
            if (it != match.parameter->owner->members.end() && it->second.variable == match.parameter) return &match;
        }
        return nullptr;
    };
    size_t next = 0;
    // positional: inputs and in-outs in order of declaration, then outputs
    const auto nextPositional = [&]() -> Match* {
        for (; next < 2 * out.matches.size(); ++next) {
            Match& match = out.matches[next % out.matches.size()];
            const bool isOutput = match.parameter->kind == SectionKind::Output;
            if (isOutput == (next >= out.matches.size()) && !match.argument) {
                ++next;
                return &match;
            }
        }
        return nullptr;
    };
    size_t inputs = 0;
    for (const Match& match : out.matches) inputs += match.parameter->kind != SectionKind::Output;
    for (const syntax::Argument& argument : call.arguments) {
        if (argument.kind == ArgumentKind::Positional) {
            if (!argument.value) continue;
            Match* match = nextPositional();
            if (!match) {
                emit(argument.range, findings::TooManyArguments(name, inputs));
                out.isGood = false;
                break;
            }
            match->argument = &argument;
            continue;
        }
        out.isFormal = true;
        if (!argument.name.isValid()) continue;
        Match* match = find(world.key(argument.name.text));
        if (!match && equalsIgnoringCase(argument.name.text, "EN") && argument.kind == ArgumentKind::Input) {
            out.en = &argument;
            continue;
        }
        if (!match && equalsIgnoringCase(argument.name.text, "ENO") && argument.kind == ArgumentKind::Output) {
            out.eno = &argument;
            continue;
        }
        if (!match) {
            std::vector<std::string> candidates;
            for (const Variable* parameter : parameters) candidates.push_back(parameter->name);
            world.suggest(emit(argument.name.range, findings::UnknownParameter(name, argument.name.text)),
                          argument.name.range, argument.name.text, candidates);
            out.isGood = false;
            continue;
        }
        const SectionKind kind = match->parameter->kind;
        const bool isOutput = kind == SectionKind::Output;
        if (isOutput != (argument.kind == ArgumentKind::Output)) {
            const Verbatim own(isOutput ? "=>" : ":=");
            auto what = isOutput                     ? phrases::AnOutput()
                        : kind == SectionKind::InOut ? phrases::AnInOutParameter()
                                                     : phrases::AnInput();
            auto& diagnostic =
                emit(argument.name.range, findings::MixedOutputArgument(match->parameter->name, std::move(what), own));
            const std::string_view text = world.textOf(argument.range);
            const size_t at = text.find(isOutput ? ":=" : "=>");
            if (at != std::string_view::npos) {
                const auto begin = argument.range.begin + static_cast<uint32_t>(at);
                diagnostic.fixes.push_back({fixes::Write(own), {{{argument.range.file, begin, begin + 2}, own.text}}});
            }
            out.isGood = false;
            continue;
        }
        refer(argument.name.range, match->parameter->symbol, isOutput ? Access::Read : Access::Write);
        if (match->argument) {
            emit(argument.name.range, findings::ArgumentTwice(match->parameter->name));
            out.isGood = false;
            continue;
        }
        match->argument = &argument;
    }
    // Arguments are evaluated as written, whatever the order of the declarations; what is omitted has no effects.
    std::stable_sort(out.matches.begin(), out.matches.end(), [](const Match& a, const Match& b) {
        return a.argument && (!b.argument || a.argument < b.argument);
    });
    return out;
}

/// Keeps the values so far in locals, because what follows copies a variable before the call: it would otherwise be
/// read before them.
void Checker::holdInputs(tree::Call& call, std::vector<tree::Stmt*>& before) {
    for (tree::CallArgument& argument : call.arguments)
        if (argument.mode == tree::ArgumentMode::Input && argument.value) argument.value = held(argument.value, before);
}

/// The value of an expression that is computed by a statement in `before`.
tree::Expr* Checker::held(tree::Expr* value, std::vector<tree::Stmt*>& before) {
    if (value->kind == tree::ExprKind::Constant) return value;
    tree::Place* place = localPlace(newLocal("argument", value->type), value->type, value->range);
    before.push_back(assignStmt(place, value, {}));
    return load(place, value->range).expr;
}

tree::Expr* Checker::defaultOf(Variable& parameter, SourceRange range) {
    const TypeId type = world.typeOf(parameter);
    if (parameter.declaration && parameter.declaration->initial) {
        Checker inner(world, parameter.scope, sink, arena);
        inner.isMuted = true;
        const Operand value = types.isAggregate(type)
                                  ? inner.aggregate(*parameter.declaration->initial, type)
                                  : inner.converted(inner.expression(*parameter.declaration->initial, type), type);
        if (!value.isUnknown() && value.isConstant()) return value.expr;
    }
    if (!fitsIntoCode(type, range)) return unknown(range).expr;
    types::Value value = types::initialValue(types, type);
    value.type = type;
    return constant(std::move(value), {}).expr;
}

/// The variable that an IN_OUT parameter stands for; what has no address goes in and out by copy.
///   ok:    F(io := x); F(io := w.3);      wrong: F(io := 5);  (P2013)   F(io := c);  with a constant c (P2005)
tree::Place* Checker::inOutTarget(Variable& parameter, const syntax::Argument& argument,
                                  std::vector<tree::Stmt*>& before, std::vector<tree::Stmt*>& after) {
    const TypeId type = world.typeOf(parameter);
    const SourceRange range = argument.value->range;
    const bool isConstant = parameter.section && parameter.section->constant;
    const Denoted denoted = denote(*argument.value, isConstant ? Access::Read : Access::ReadWrite);
    if (denoted.kind == Denoted::Kind::Nothing || isKind(type, TypeKind::Unknown)) return nullptr;
    const auto refuse = [&]() -> tree::Place* {
        emit(range, findings::InOutNeedsVariable(parameter.name, nameOf(type)));
        return nullptr;
    };
    const auto held = [&](Operand value) -> tree::Place* {
        const uint32_t local = newLocal(parameter.name, type);
        tree::Place* place = localPlace(local, type, range);
        takeAddress(place);
        before.push_back(assignStmt(place, value.expr, {}));
        return place;
    };
    if (denoted.kind != Denoted::Kind::Place) {
        if (!isConstant) return refuse();
        const Operand value = converted(this->value(denoted, *argument.value, type), type);
        return value.isUnknown() ? nullptr : held(value);
    }
    if (denoted.isReadOnly && !isConstant) {
        emit(range, findings::NotAssignable(denoted.whyReadOnly));
        return nullptr;
    }
    tree::Place* place = denoted.place;
    const types::Type &wanted = types[type], &given = types[place->type];
    if (given.kind == TypeKind::Unknown) return nullptr;
    if (wanted.kind == TypeKind::OpenArray) {
        const bool good = (given.kind == TypeKind::Array || given.kind == TypeKind::OpenArray) &&
                          given.dimensions.size() == wanted.dimensions.size() &&
                          world.sameType(given.element, wanted.element);
        if (!good) return refuse();
        takeAddress(place);
        return place;
    }
    if (types.isText(type) && given.kind == wanted.kind) {
        if (given.capacity >= wanted.capacity && hasAddress(place)) {
            takeAddress(place);
            return place;
        }
        tree::Place* copy = held(load(place, range)); // shorter than the parameter: in and out by copy
        if (!isConstant) after.push_back(assignStmt(place, load(copy, range).expr, {}));
        return copy;
    }
    const bool same = world.sameType(place->type, type) ||
                      (wanted.kind == TypeKind::Block && types.isDerivedFrom(place->type, type)) ||
                      (wanted.kind == TypeKind::Subrange && types.storage(place->type) == types.storage(type)) ||
                      (given.kind == TypeKind::Subrange && types.storage(place->type) == type);
    if (wanted.kind == TypeKind::Interface && given.kind == TypeKind::Block && types.implements(place->type, type)) {
        const Operand value = converted(load(place, range), type);
        return value.isUnknown() ? nullptr : held(value);
    }
    if (!same) return refuse();
    if (!hasAddress(place)) { // a bit: in and out by copy
        tree::Place* copy = held(load(place, range));
        if (!isConstant) after.push_back(assignStmt(place, load(copy, range).expr, {}));
        return copy;
    }
    takeAddress(place);
    return place;
}

void Checker::recordCall(tree::FunctionId to, bool isDispatched, SourceRange range) {
    if (functionId.isValid() && !isMuted) world.calls.push_back({functionId.value, to.value, isDispatched, range});
}

void Checker::prepareCall(tree::Call& call, const Denoted& callee, SourceRange range) {
    Unit& unit = *callee.unit;
    call.callee = unit.function;
    if (callee.interface) {
        call.dispatch = tree::Call::Dispatch::Interface;
        call.interface = callee.interface;
    } else if (unit.owner || unit.isInstanced()) {
        call.instance = callee.instance ? callee.instance : thisPlace(range);
        takeAddress(call.instance);
        const bool dispatches =
            unit.isOverridden && !callee.isSuper && !callee.isExact && !unit.isFinal && unit.slot != Id<int>::kNone;
        if (dispatches)
            call.dispatch = tree::Call::Dispatch::Virtual;
        else if (unit.isAbstract && unit.kind != UnitKind::Action && !callee.isSuper)
            call.dispatch = tree::Call::Dispatch::Virtual;
    }
    recordCall(unit.function, call.dispatch != tree::Call::Dispatch::Direct, range);
}

/// A call of a function or method as a value.
///   ok:    x := F(1, 2); x := F(a := 1);  where b has an initial value      wrong: x := F(1);  (P2010)
Operand Checker::callUnit(const Denoted& callee, const syntax::Expr& e) {
    Unit& unit = *callee.unit;
    world.completeUnit(unit, e.range);
    if (isExpression) {
        emit(e.range, findings::NotAllowedInExpression(unit.name));
        return unknown(e.range);
    }
    if (!function && !isMuted && !isInitialiser) {
        emit(e.range, findings::NotConstant());
        return unknown(e.range);
    }
    tree::Expr* result = arena.make<tree::Expr>();
    result->kind = tree::ExprKind::Call;
    result->type = unit.result.isValid() ? unit.result : elementary(TypeKind::Void);
    result->range = e.range;
    if (!function) return {result, &types}; // only its type is asked for
    tree::Call* call = arena.make<tree::Call>();
    result->call = call;
    prepareCall(*call, callee, e.range);
    Matched matched = match(e, unit.name, unit.parameters);
    std::vector<tree::Stmt*> before, after;
    bool good = matched.isGood;
    for (const Match& each : matched.matches) {
        Variable& parameter = *each.parameter;
        const TypeId type = world.typeOf(parameter);
        const syntax::Argument* argument = each.argument;
        tree::CallArgument made;
        made.local = parameter.local;
        if (parameter.kind == SectionKind::Output) {
            made.mode = tree::ArgumentMode::Output;
            if (!argument || !argument->value) continue;
            TypeId wanted;
            const Denoted target = this->target(*argument->value, &wanted);
            if (target.kind == Denoted::Kind::Nothing) {
                good = false;
                continue;
            }
            Operand probe = load(localPlace(0, type, argument->value->range), argument->value->range);
            if (target.kind == Denoted::Kind::Place && !argument->negated &&
                target.place->kind != tree::PlaceKind::TextIndex) {
                if (!fitsPartOfDate(unit, parameter, types.storageKind(target.place->type)) &&
                    converted(probe, target.place->type).isUnknown())
                    good = false;
                made.place = target.place;
            } else { // a property, a negated pin: through a local
                tree::Place* held = localPlace(newLocal(parameter.name, type), type, argument->value->range);
                made.place = held;
                Operand value = load(held, argument->value->range);
                if (argument->negated) value = inverted(value, argument->value->range);
                assignTo(target, value, {}, after, true);
            }
        } else if (parameter.kind == SectionKind::InOut) {
            made.mode = tree::ArgumentMode::InOut;
            if (!argument || !argument->value) {
                emit(e.base ? e.base->range : e.range, findings::MissingArgument(parameter.name, unit.name));
                good = false;
                continue;
            }
            std::vector<tree::Stmt*> copies;
            made.place = inOutTarget(parameter, *argument, copies, after);
            if (!made.place) good = false;
            if (!copies.empty()) holdInputs(*call, before);
            before.insert(before.end(), copies.begin(), copies.end());
        } else {
            if (!argument || !argument->value) {
                const bool hasDefault = parameter.declaration && parameter.declaration->initial;
                if (!matched.isFormal && !hasDefault) {
                    emit(e.base ? e.base->range : e.range, findings::MissingArgument(parameter.name, unit.name));
                    good = false;
                    continue;
                }
                made.value = defaultOf(parameter, e.range);
            } else {
                const Operand value = expression(*argument->value, type);
                Operand fitting = converted(value, type);
                if (argument->negated) fitting = inverted(fitting, argument->value->range);
                if (fitting.isUnknown()) good = false;
                made.value = fitting.expr;
            }
        }
        call->arguments.push_back(made);
    }
    Operand out{result, &types};
    if (!good) return unit.result.isValid() && !isKind(unit.result, TypeKind::Void) ? unknown(e.range) : out;
    if (!before.empty() || !after.empty()) {
        tree::Expr* sequence = arena.make<tree::Expr>();
        sequence->kind = tree::ExprKind::Sequence;
        sequence->range = e.range;
        sequence->type = result->type;
        sequence->statements = std::move(before);
        if (isKind(result->type, TypeKind::Void)) {
            tree::Stmt* evaluate = newStmt(tree::StmtKind::Evaluate, {});
            evaluate->a = result;
            sequence->statements.push_back(evaluate);
        } else {
            tree::Place* held = localPlace(newLocal(unit.name, result->type), result->type, e.range);
            sequence->statements.push_back(assignStmt(held, result, {}));
            sequence->a = load(held, e.range).expr;
        }
        sequence->statements.insert(sequence->statements.end(), after.begin(), after.end());
        out = {sequence, &types};
    }
    return withEnable(out, matched, e.range);
}

/// EN and ENO of a call whose unit declares neither: the call happens only when EN is TRUE, ENO says whether it did.
Operand Checker::withEnable(Operand value, const Matched& matched, SourceRange range) {
    if (!matched.en && !matched.eno) return value;
    StandardArguments arguments;
    arguments.en = matched.en;
    arguments.eno = matched.eno;
    return withEnable(value, arguments, range);
}

Operand Checker::withEnable(Operand value, const StandardArguments& arguments, SourceRange range) {
    if ((!arguments.en && !arguments.eno) || value.isUnknown()) return value;
    const TypeId boolean = elementary(TypeKind::Bool);
    if (!function) {
        emit(range, isExpression ? findings::NotAllowedInExpression(Verbatim("ENO")) : findings::NotConstant());
        return unknown(range);
    }
    value = settled(value);
    tree::Expr* en = arguments.en && arguments.en->value ? condition(*arguments.en->value) : nullptr;
    tree::Place* eno = nullptr;
    if (arguments.eno && arguments.eno->value) {
        const Denoted denoted = target(*arguments.eno->value);
        if (denoted.kind == Denoted::Kind::Place && types.storageKind(denoted.place->type) == TypeKind::Bool)
            eno = denoted.place;
        else if (denoted.kind != Denoted::Kind::Nothing)
            mismatch(arguments.eno->value->range, boolean, denoted.place ? denoted.place->type : boolean);
    }
    tree::Expr& computed = value.expr->kind == tree::ExprKind::Sequence && value.expr->a ? *value.expr->a : *value.expr;
    const bool setsOk = computed.kind == tree::ExprKind::Intrinsic || computed.kind == tree::ExprKind::Convert;
    if (eno && setsOk) computed.ok = eno;
    const auto sequence = [&](tree::Expr* inner, bool ok) {
        tree::Expr* out = arena.make<tree::Expr>();
        out->kind = tree::ExprKind::Sequence;
        out->range = range;
        out->type = value.type();
        out->statements.push_back(assignStmt(eno, constant({boolean, int64_t(ok)}, range).expr, {}));
        out->a = inner;
        return out;
    };
    tree::Expr* yes = eno && !setsOk ? sequence(value.expr, true) : value.expr;
    if (!en) return {yes, &types};
    const bool isVoid = isKind(value.type(), TypeKind::Void);
    if (isVoid) { // only as a statement: IF en THEN … END_IF
        tree::Expr* out = arena.make<tree::Expr>();
        out->kind = tree::ExprKind::Sequence;
        out->range = range;
        out->type = value.type();
        tree::Stmt* choice = newStmt(tree::StmtKind::If, {});
        choice->a = en;
        tree::Stmt* evaluate = newStmt(tree::StmtKind::Evaluate, {});
        evaluate->a = value.expr;
        if (eno) choice->body.push_back(assignStmt(eno, constant({boolean, int64_t(1)}, range).expr, {}));
        choice->body.push_back(evaluate);
        if (eno) choice->elseBody.push_back(assignStmt(eno, constant({boolean, int64_t(0)}, range).expr, {}));
        out->statements.push_back(choice);
        return {out, &types};
    }
    if (!fitsIntoCode(value.type(), range)) return unknown(range);
    types::Value zero = types::initialValue(types, value.type());
    zero.type = value.type();
    tree::Expr* no = constant(std::move(zero), range).expr;
    tree::Expr* out = arena.make<tree::Expr>();
    out->kind = tree::ExprKind::Conditional;
    out->type = value.type();
    out->range = range;
    out->a = en;
    out->b = yes;
    out->c = eno ? sequence(no, false) : no;
    return {out, &types};
}

///   wrong: x := block.Speed;  where Speed has only SET (P2023)
Operand Checker::propertyValue(const Denoted& denoted, SourceRange range) {
    Property& property = *denoted.property;
    if (!property.get) {
        emit(range, findings::NoValue(property.name));
        return unknown(range);
    }
    if (isExpression) {
        emit(range, findings::NotAllowedInExpression(property.name));
        return unknown(range);
    }
    checkAccess(property.get->access, property.owner, property.name, range);
    Denoted callee;
    callee.kind = Denoted::Kind::Unit;
    callee.unit = property.get;
    callee.instance = denoted.instance;
    callee.interface = denoted.interface;
    callee.isSuper = denoted.isSuper;
    callee.isExact = denoted.isExact;
    syntax::Expr bare;
    bare.kind = syntax::ExprKind::Call;
    bare.range = range;
    return callUnit(callee, bare);
}

///   ok:    x := F(1);      wrong: b := t(IN := TRUE);  with t : TON (P2023)   x := y(1);  with y : INT (P2008)
Operand Checker::call(const syntax::Expr& e, TypeId hint) {
    const Denoted callee = denote(*e.base, Access::Call, hint);
    const auto checkArguments = [&] { // for the names inside, although the call itself is wrong
        for (const syntax::Argument& argument : e.arguments)
            if (argument.value) {
                if (argument.kind == ArgumentKind::Output)
                    denote(*argument.value, Access::Write);
                else
                    expression(*argument.value);
            }
    };
    switch (callee.kind) {
    case Denoted::Kind::Nothing:
        checkArguments();
        return unknown(e.range);
    case Denoted::Kind::Unit: {
        Unit& unit = *callee.unit;
        if (unit.kind == UnitKind::Function || unit.kind == UnitKind::Method) return callUnit(callee, e);
        if (unit.kind == UnitKind::Action || unit.kind == UnitKind::Program)
            emit(e.range, isExpression ? findings::NotAllowedInExpression(unit.name) : findings::NoValue(unit.name));
        else
            emit(e.base->range, findings::NotCallable(phrases::TypeNotInstance(unit.name)));
        checkArguments();
        return unknown(e.range);
    }
    case Denoted::Kind::Standard:
        return standardCall(callee.name, e, hint);
    case Denoted::Kind::Place:
        if (isKind(callee.place->type, TypeKind::Block))
            emit(e.range, isExpression ? findings::NotAllowedInExpression(textOf(e.base->range))
                                       : findings::NoValue(textOf(e.base->range)));
        else if (!isKind(callee.place->type, TypeKind::Unknown))
            emit(e.base->range, library::findSignature(world.textOf(e.base->range))
                                    ? findings::NotCallable(phrases::VariableHidesFunction(textOf(e.base->range)))
                                    : findings::NotCallable(textOf(e.base->range)));
        checkArguments();
        return unknown(e.range);
    case Denoted::Kind::Type:
        if (library::findSignature(world.textOf(e.base->range)))
            return standardCall(world.textOf(e.base->range), e, hint); // TIME()
        [[fallthrough]];
    default:
        emit(e.base->range, findings::NotCallable(textOf(e.base->range)));
        checkArguments();
        return unknown(e.range);
    }
}

} // namespace plc::sema
