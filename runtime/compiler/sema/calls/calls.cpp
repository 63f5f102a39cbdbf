// Calls of functions, methods and accessors: arguments are matched with parameters, defaults made explicit, dispatch
// chosen.
#include "runtime/compiler/sema/calls/calls.h"

#include "runtime/compiler/sema/calls/any_inputs.h"
#include "runtime/compiler/sema/calls/standard_calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/layout/units.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/operators/operators.h"
#include "runtime/compiler/sema/statements/statements.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"
#include "runtime/types/conversion.h"

namespace plc::sema {
static void holdInputs(Context& context, tree::Call& call, std::vector<tree::Stmt*>& before);
static tree::Expr* defaultOf(Context& context, Variable& parameter, SourceRange range);
static void recordCall(Context& context, tree::FunctionId to, bool isDispatched, SourceRange range);
static Operand withEnable(Context& context, Operand value, const Matched& matched, SourceRange range);

namespace {
/// The outputs of SPLIT_DATE and its like are any integers (table 36): a part whose range fits is no loss.
bool fitsPartOfDate(const Unit& unit, const Variable& part, TypeKind to) {
    if (!unit.isLibrary() || !unit.name.starts_with("SPLIT_")) return false;
    // UINT holds every part, the year as well.
    if (to == TypeKind::Uint) return true;
    if (to != TypeKind::Usint && to != TypeKind::Sint) return false;
    // The milliseconds are missing: 999 does not fit into a byte.
    return part.name == "MONTH" || part.name == "DAY" || part.name == "HOUR" || part.name == "MINUTE" ||
           part.name == "SECOND";
}
} // namespace

using syntax::ArgumentKind;
using syntax::SectionKind;

/// ARRAY[*] in VAR_OUTPUT, which is passed by reference and written as F(a => x).
static bool isArrayOutput(const Variable& parameter) {
    return parameter.isInOut() && parameter.section && parameter.section->kind == SectionKind::Output;
}

/// Which argument belongs to which parameter: by name, or by position.
///   ok:    t(IN := TRUE, Q => b); F(1, 2);
///   wrong: t(INN := TRUE);  (P2009)   F(1, 2, 3);  of two (P2011)   t(IN := TRUE, IN := FALSE);  (P2012)
///          t(Q := b);  (P2036)
Matched match(Context& context, const syntax::Expr& call, const std::string& name,
              const std::vector<Variable*>& parameters) {
    Matched out;
    for (Variable* parameter : parameters) out.matches.push_back({nullptr, parameter});
    const auto find = [&](NameId id) -> Match* {
        for (Match& match : out.matches)
            if (match.parameter->id == id) return &match;
        // A library may give a pin a second name by {attribute 'alias'}; both are members that lead to the same
        // variable.
        for (Match& match : out.matches) { // aliases of a pin
            if (!match.parameter->owner) continue;
            const auto it = match.parameter->owner->members.find(id);
            if (it != match.parameter->owner->members.end() && it->second.variable == match.parameter) return &match;
        }
        return nullptr;
    };
    // Two rounds over the parameters in one counter: the first takes inputs and in-outs, the second outputs.
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
                context.emit(argument.range, findings::TooManyArguments(name, inputs));
                out.isGood = false;
                break;
            }
            match->argument = &argument;
            continue;
        }
        out.isFormal = true;
        if (!argument.name.isValid()) continue;
        Match* match = find(context.key(argument.name.text));
        // Only where the unit has no parameter of that name: a block may declare EN itself and do with it what it
        // likes.
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
            suggest(context, context.emit(argument.name.range, findings::UnknownParameter(name, argument.name.text)),
                    argument.name.range, argument.name.text, candidates);
            out.isGood = false;
            continue;
        }
        const SectionKind kind = match->parameter->kind;
        // := where => is needed is the most frequent slip of those who come from other languages; the fix only turns
        // the sign.
        const bool isOutput = kind == SectionKind::Output || isArrayOutput(*match->parameter);
        if (isOutput != (argument.kind == ArgumentKind::Output)) {
            const Verbatim own(isOutput ? "=>" : ":=");
            auto what = isOutput                     ? phrases::AnOutput()
                        : kind == SectionKind::InOut ? phrases::AnInOutParameter()
                                                     : phrases::AnInput();
            auto& diagnostic = context.emit(
                argument.name.range, findings::MixedOutputArgument(match->parameter->name, std::move(what), own));
            const std::string_view text = context.world.textOf(argument.range);
            const size_t at = text.find(isOutput ? ":=" : "=>");
            if (at != std::string_view::npos) {
                const auto begin = argument.range.begin + static_cast<uint32_t>(at);
                diagnostic.fixes.push_back({fixes::Write(own), {{{argument.range.file, begin, begin + 2}, own.text}}});
            }
            out.isGood = false;
            continue;
        }
        // The parameter's use is noted before it is known whether it is given twice: renaming must reach both.
        refer(context, argument.name.range, match->parameter->symbol, isOutput ? Access::Read : Access::Write);
        if (match->argument) {
            context.emit(argument.name.range, findings::ArgumentTwice(match->parameter->name));
            out.isGood = false;
            continue;
        }
        match->argument = &argument;
    }
    // Calls with side effects in named arguments must run in the order in which they can be read.
    // Arguments are evaluated as written, whatever the order of the declarations; what is omitted has no effects.
    std::stable_sort(out.matches.begin(), out.matches.end(), [](const Match& a, const Match& b) {
        return a.argument && (!b.argument || a.argument < b.argument);
    });
    return out;
}

/// Keeps the values so far in locals, because what follows copies a variable before the call: it would otherwise be
/// read before them.
void holdInputs(Context& context, tree::Call& call, std::vector<tree::Stmt*>& before) {
    for (tree::CallArgument& argument : call.arguments)
        if (argument.mode == tree::ArgumentMode::Input && argument.value)
            argument.value = held(context, argument.value, before);
}

/// The value of an expression that is computed by a statement in `before`.
tree::Expr* held(Context& context, tree::Expr* value, std::vector<tree::Stmt*>& before) {
    // Nothing can change a constant before it is read.
    if (value->kind == tree::ExprKind::Constant) return value;
    tree::Place* place = localPlace(context, newLocal(context, "argument", value->type), value->type, value->range);
    before.push_back(assignStmt(context, place, value, {}));
    return load(context, place, value->range).expr;
}

void holdPlace(Context& context, tree::Place* place, const syntax::Expr& text, std::vector<tree::Stmt*>& before) {
    if (!context.function || !containsCall(text)) return;
    std::vector<tree::Place*> path; // from the variable on, as it is read
    for (; place; place = place->base) path.insert(path.begin(), place);
    for (tree::Place* each : path) {
        for (tree::Expr*& index : each->indices) index = held(context, index, before);
        if (each->pointer) each->pointer = held(context, each->pointer, before);
    }
}

// What an input has when a call leaves it out (2.5.1.1).
tree::Expr* defaultOf(Context& context, Variable& parameter, SourceRange range) {
    const TypeId type = typeOf(context, parameter);
    if (parameter.declaration && parameter.declaration->initial) {
        // The default is seen from where the parameter is declared, not from where the call is, and was reported
        // there.
        Context inner(context, parameter.scope, context.sink, context.arena);
        inner.isMuted = true;
        // A watch on another thread may be checked while the program runs; its context must leave the World as it is.
        inner.isExpression = context.isExpression; // which adds no types
        const Operand value = context.types.isAggregate(type)
                                  ? aggregate(inner, *parameter.declaration->initial, type)
                                  : converted(inner, expression(inner, *parameter.declaration->initial, type), type);
        // A default that is not constant is computed by the callee at its start; here the type's own value is given for
        // it.
        if (!value.isUnknown() && value.isConstant()) return value.expr;
    }
    // A large array by value would become a constant of that size in the code, once per call.
    if (!fitsIntoCode(context, type, range)) return unknown(context, range).expr;
    types::Value value = types::initialValue(context.types, type);
    value.type = type;
    return constant(context, std::move(value), {}).expr;
}

/// The variable that an IN_OUT parameter stands for; what has no address goes in and out by copy.
///   ok:    F(io := x); F(io := w.3);      wrong: F(io := 5);  (P2013)   F(io := c);  with a constant c (P2005)
tree::Place* inOutTarget(Context& context, Variable& parameter, const syntax::Argument& argument,
                         std::vector<tree::Stmt*>& before, std::vector<tree::Stmt*>& after) {
    const TypeId type = typeOf(context, parameter);
    const SourceRange range = argument.value->range;
    // VAR_IN_OUT CONSTANT and REFERENCE TO that is only read take values as well: what is never written may be a copy.
    const bool isConstant = (parameter.section && parameter.section->constant) || parameter.isReadOnlyReference;
    const Denoted denoted = denote(context, *argument.value, isConstant ? Access::Read : Access::ReadWrite);
    if (denoted.kind == Denoted::Kind::Nothing || context.isKind(type, TypeKind::Unknown)) return nullptr;
    const auto refuse = [&]() -> tree::Place* {
        context.emit(range, findings::InOutNeedsVariable(parameter.name, context.nameOf(type)));
        return nullptr;
    };
    // A local of the caller that has an address for the length of the call.
    const auto held = [&](Operand value) -> tree::Place* {
        const uint32_t local = newLocal(context, parameter.name, type);
        tree::Place* place = localPlace(context, local, type, range);
        takeAddress(context, place);
        before.push_back(assignStmt(context, place, value.expr, {}));
        return place;
    };
    if (denoted.kind != Denoted::Kind::Place) {
        if (!isConstant) return refuse();
        const Operand value = converted(context, sema::value(context, denoted, *argument.value, type), type);
        return value.isUnknown() ? nullptr : held(value);
    }
    if (denoted.isReadOnly && !isConstant) {
        context.emit(range, findings::NotAssignable(denoted.whyReadOnly));
        return nullptr;
    }
    if (!isConstant) tellConstantInput(context, denoted, *argument.value);
    tree::Place* place = denoted.place;
    const types::Type &wanted = context.types[type], &given = context.types[place->type];
    if (given.kind == TypeKind::Unknown) return nullptr;
    // Bounds may differ, that is what ARRAY[*] is for; the number of dimensions and the element may not.
    if (wanted.kind == TypeKind::OpenArray) {
        const bool good = (given.kind == TypeKind::Array || given.kind == TypeKind::OpenArray) &&
                          given.dimensions.size() == wanted.dimensions.size() &&
                          sameType(context.world, given.element, wanted.element);
        if (!good) return refuse();
        takeAddress(context, place);
        return place;
    }
    if (context.types.isText(type) && given.kind == wanted.kind) {
        // The callee writes up to its own capacity: a longer text is safe in place, a shorter one would be overrun.
        if (given.capacity >= wanted.capacity && hasAddress(place)) {
            takeAddress(context, place);
            return place;
        }
        holdPlace(context, place, *argument.value, before);
        tree::Place* copy = held(load(context, place, range)); // shorter than the parameter: in and out by copy
        if (!isConstant) after.push_back(assignStmt(context, place, load(context, copy, range).expr, {}));
        return copy;
    }
    // A derived block may stand for its base (edition 3, 6.6.5), a subrange for its base and back, since the callee
    // checks no bounds of the caller.
    const bool same =
        sameType(context.world, place->type, type) ||
        (wanted.kind == TypeKind::Block && context.types.isDerivedFrom(place->type, type)) ||
        (wanted.kind == TypeKind::Subrange && context.types.storage(place->type) == context.types.storage(type)) ||
        (given.kind == TypeKind::Subrange && context.types.storage(place->type) == type) ||
        (given.kind == TypeKind::Enum && !given.isStrict && context.types.storage(place->type) == type);
    // The reference is made for this call: the callee may point it elsewhere without effect on the caller's block.
    if (wanted.kind == TypeKind::Interface && given.kind == TypeKind::Block &&
        context.types.implements(place->type, type)) {
        const Operand value = converted(context, load(context, place, range), type);
        return value.isUnknown() ? nullptr : held(value);
    }
    if (!same) return refuse();
    if (!hasAddress(place)) { // a bit: in and out by copy
        holdPlace(context, place, *argument.value, before);
        tree::Place* copy = held(load(context, place, range));
        if (!isConstant) after.push_back(assignStmt(context, place, load(context, copy, range).expr, {}));
        return copy;
    }
    takeAddress(context, place);
    return place;
}

void recordCall(Context& context, tree::FunctionId to, bool isDispatched, SourceRange range) {
    // The call graph finds recursion and what a task reaches. Muted checks look at the same text a second time.
    if (context.functionId.isValid() && !context.isMuted)
        context.gathered.calls.push_back({context.functionId.value, to.value, isDispatched, range});
}

void prepareCall(Context& context, tree::Call& call, const Denoted& callee, SourceRange range) {
    Unit& unit = *callee.unit;
    call.callee = unit.function;
    if (callee.interface) {
        call.dispatch = tree::Call::Dispatch::Interface;
        call.interface = callee.interface;
    } else if (unit.owner || unit.isInstanced()) {
        call.instance = callee.instance ? callee.instance : thisPlace(context, range);
        takeAddress(context, call.instance);
        // Direct where nobody overrides: SUPER^ and a variable of the exact type need no table, and the optimiser can
        // inline.
        const bool dispatches =
            unit.isOverridden && !callee.isSuper && !callee.isExact && !unit.isFinal && unit.slot != Id<int>::kNone;
        if (dispatches) call.dispatch = tree::Call::Dispatch::Virtual;
        // There is no body to call directly; that nobody overrides it was reported where the block is declared.
        else if (unit.isAbstract && unit.kind != UnitKind::Action && !callee.isSuper)
            call.dispatch = tree::Call::Dispatch::Virtual;
    }
    recordCall(context, unit.function, call.dispatch != tree::Call::Dispatch::Direct, range);
}

/// A call of a function or method as a value.
///   ok:    x := F(1, 2); x := F(a := 1);  where b has an initial value      wrong: x := F(1);  (P2010)
Operand callUnit(Context& context, const Denoted& callee, const syntax::Expr& e) {
    Unit& unit = *callee.unit;
    completeUnit(context, unit, e.range);
    // D7: an expression shown beside the program must not change it, and a call may.
    if (context.isExpression) {
        context.emit(e.range, findings::NotAllowedInExpression(unit.name));
        return unknown(context, e.range);
    }
    if (!context.function && !context.isMuted && !context.isInitialiser) {
        context.emit(e.range, findings::NotConstant());
        return unknown(context, e.range);
    }
    tree::Expr* result = context.arena.make<tree::Expr>();
    result->kind = tree::ExprKind::Call;
    result->type = unit.result.isValid() ? unit.result : context.elementary(TypeKind::Void);
    result->range = e.range;
    // Constants of declarations, and muted first looks that only ask for a type: there is no frame for arguments.
    if (!context.function) return {result, &context.types}; // only its type is asked for
    tree::Call* call = context.arena.make<tree::Call>();
    result->call = call;
    prepareCall(context, *call, callee, e.range);
    Matched matched = match(context, e, unit.name, unit.parameters);
    // `before` runs ahead of the call and `after` behind it; with either the call becomes a sequence with its result
    // held.
    std::vector<tree::Stmt*> before, after;
    bool good = matched.isGood;
    for (const Match& each : matched.matches) {
        Variable& parameter = *each.parameter;
        const TypeId type = typeOf(context, parameter);
        const syntax::Argument* argument = each.argument;
        tree::CallArgument made;
        made.local = parameter.local;
        if (parameter.kind == SectionKind::Output) {
            made.mode = tree::ArgumentMode::Output;
            if (!argument || !argument->value) continue;
            TypeId wanted;
            const Denoted target = sema::target(context, *argument->value, &wanted);
            if (target.kind == Denoted::Kind::Nothing) {
                good = false;
                continue;
            }
            // Local 0 is "some value of this type": only convertibility is asked, the load is never emitted.
            Operand probe = load(context, localPlace(context, 0, type, argument->value->range), argument->value->range);
            if (target.kind == Denoted::Kind::Place && !argument->negated &&
                target.place->kind != tree::PlaceKind::TextIndex) {
                if (!fitsPartOfDate(unit, parameter, context.types.storageKind(target.place->type)) &&
                    converted(context, probe, target.place->type).isUnknown())
                    good = false;
                made.place = target.place;
            } else { // a property, a negated pin: through a local
                tree::Place* held =
                    localPlace(context, newLocal(context, parameter.name, type), type, argument->value->range);
                made.place = held;
                Operand value = load(context, held, argument->value->range);
                if (argument->negated) value = inverted(context, value, argument->value->range);
                assignTo(context, target, value, {}, after, true);
            }
        } else if (parameter.kind == SectionKind::InOut) {
            made.mode = tree::ArgumentMode::InOut;
            if (!argument || !argument->value) {
                context.emit(e.base ? e.base->range : e.range, findings::MissingArgument(parameter.name, unit.name));
                good = false;
                continue;
            }
            std::vector<tree::Stmt*> copies;
            made.place = inOutTarget(context, parameter, *argument, copies, after);
            if (!made.place) good = false;
            // F(x, io := y) with a copy of y: x was to be read first, but copies now run ahead of the call.
            if (!copies.empty()) holdInputs(context, *call, before);
            before.insert(before.end(), copies.begin(), copies.end());
        } else {
            if (!argument || !argument->value) {
                const bool hasDefault = parameter.declaration && parameter.declaration->initial;
                // 2.5.1.1: a call with names may omit inputs, one by position has all of them.
                if (!matched.isFormal && !hasDefault) {
                    context.emit(e.base ? e.base->range : e.range,
                                 findings::MissingArgument(parameter.name, unit.name));
                    good = false;
                    continue;
                }
                made.value = defaultOf(context, parameter, e.range);
            } else if (isAnyInput(context.world, parameter)) {
                const Operand any = anyArgument(context, parameter, *argument->value);
                good = good && !any.isUnknown();
                made.value = any.expr;
            } else {
                const Operand value = expression(context, *argument->value, type);
                Operand fitting = converted(context, value, type);
                // NOT on the pin turns the bits of the parameter's type, thus after the conversion.
                if (argument->negated) fitting = inverted(context, fitting, argument->value->range);
                if (fitting.isUnknown()) good = false;
                made.value = fitting.expr;
            }
        }
        call->arguments.push_back(made);
    }
    Operand out{result, &context.types};
    if (!good)
        // A wrong call of something without a result is kept: as a statement it has no value that could be unknown.
        return unit.result.isValid() && !context.isKind(unit.result, TypeKind::Void) ? unknown(context, e.range) : out;
    if (!before.empty() || !after.empty()) {
        tree::Expr* sequence = newSequence(context, result->type, e.range);
        sequence->statements = std::move(before);
        // The result is read before `after` runs: what is copied back might overwrite what it was computed from.
        if (context.isKind(result->type, TypeKind::Void)) {
            tree::Stmt* evaluate = newStmt(context, tree::StmtKind::Evaluate, {});
            evaluate->a = result;
            sequence->statements.push_back(evaluate);
        } else {
            tree::Place* held = localPlace(context, newLocal(context, unit.name, result->type), result->type, e.range);
            sequence->statements.push_back(assignStmt(context, held, result, {}));
            sequence->a = load(context, held, e.range).expr;
        }
        sequence->statements.insert(sequence->statements.end(), after.begin(), after.end());
        out = {sequence, &context.types};
    }
    return withEnable(context, out, matched, e.range);
}

/// EN and ENO of a call whose unit declares neither: the call happens only when EN is TRUE, ENO says whether it did.
Operand withEnable(Context& context, Operand value, const Matched& matched, SourceRange range) {
    if (!matched.en && !matched.eno) return value;
    StandardArguments arguments;
    arguments.en = matched.en;
    arguments.eno = matched.eno;
    return withEnable(context, value, arguments, range);
}

// The value when EN is FALSE is the initial one of its type: the standard leaves it open, zero is what a newcomer
// expects.
Operand withEnable(Context& context, Operand value, const StandardArguments& arguments, SourceRange range) {
    if ((!arguments.en && !arguments.eno) || value.isUnknown()) return value;
    const TypeId boolean = context.elementary(TypeKind::Bool);
    if (!context.function) {
        context.emit(range, context.isExpression ? findings::NotAllowedInExpression(Verbatim("ENO"))
                                                 : findings::NotConstant());
        return unknown(context, range);
    }
    value = settled(context, value);
    tree::Expr* en = arguments.en && arguments.en->value ? condition(context, *arguments.en->value) : nullptr;
    tree::Place* eno = nullptr;
    if (arguments.eno && arguments.eno->value) {
        const Denoted denoted = target(context, *arguments.eno->value);
        if (denoted.kind == Denoted::Kind::Place && context.types.storageKind(denoted.place->type) == TypeKind::Bool)
            eno = denoted.place;
        else if (denoted.kind != Denoted::Kind::Nothing)
            mismatch(context, arguments.eno->value->range, boolean, denoted.place ? denoted.place->type : boolean);
    }
    // Intrinsics and conversions report failure themselves (a division by zero, a number out of range): then ENO is
    // their own, not merely "EN was TRUE" (2.5.1.2).
    tree::Expr& computed = value.expr->kind == tree::ExprKind::Sequence && value.expr->a ? *value.expr->a : *value.expr;
    const bool setsOk = computed.kind == tree::ExprKind::Intrinsic || computed.kind == tree::ExprKind::Convert;
    if (eno && setsOk) computed.ok = eno;
    const auto sequence = [&](tree::Expr* inner, bool ok) {
        tree::Expr* out = newSequence(context, value.type(), range);
        out->statements.push_back(assignStmt(context, eno, constant(context, {boolean, int64_t(ok)}, range).expr, {}));
        out->a = inner;
        return out;
    };
    tree::Expr* yes = eno && !setsOk ? sequence(value.expr, true) : value.expr;
    if (!en) return {yes, &context.types};
    const bool isVoid = context.isKind(value.type(), TypeKind::Void);
    // A conditional has a value; what gives none needs a statement around it.
    if (isVoid) { // only as a statement: IF en THEN … END_IF
        tree::Expr* out = newSequence(context, value.type(), range);
        tree::Stmt* choice = newStmt(context, tree::StmtKind::If, {});
        choice->a = en;
        tree::Stmt* evaluate = newStmt(context, tree::StmtKind::Evaluate, {});
        evaluate->a = value.expr;
        if (eno)
            choice->body.push_back(assignStmt(context, eno, constant(context, {boolean, int64_t(1)}, range).expr, {}));
        choice->body.push_back(evaluate);
        if (eno)
            choice->elseBody.push_back(
                assignStmt(context, eno, constant(context, {boolean, int64_t(0)}, range).expr, {}));
        out->statements.push_back(choice);
        return {out, &context.types};
    }
    if (!fitsIntoCode(context, value.type(), range)) return unknown(context, range);
    types::Value zero = types::initialValue(context.types, value.type());
    zero.type = value.type();
    tree::Expr* no = constant(context, std::move(zero), range).expr;
    tree::Expr* out = context.arena.make<tree::Expr>();
    out->kind = tree::ExprKind::Conditional;
    out->type = value.type();
    out->range = range;
    out->a = en;
    out->b = yes;
    out->c = eno ? sequence(no, false) : no;
    return {out, &context.types};
}

///   wrong: x := block.Speed;  where Speed has only SET (P2023)
// Reading a property is a call of its GET.
Operand propertyValue(Context& context, const Denoted& denoted, SourceRange range) {
    Property& property = *denoted.property;
    if (!property.get) {
        context.emit(range, findings::NoValue(property.name));
        return unknown(context, range);
    }
    if (context.isExpression) {
        context.emit(range, findings::NotAllowedInExpression(property.name));
        return unknown(context, range);
    }
    // The accessor's own access counts: PUBLIC to read and PRIVATE to write is usual.
    checkAccess(context, property.get->access, property.owner, property.name, range);
    Denoted callee;
    callee.kind = Denoted::Kind::Unit;
    callee.unit = property.get;
    callee.instance = denoted.instance;
    callee.interface = denoted.interface;
    callee.isSuper = denoted.isSuper;
    callee.isExact = denoted.isExact;
    // A property is read by a call without arguments; the text has no call expression, so one is made.
    syntax::Expr bare;
    bare.kind = syntax::ExprKind::Call;
    bare.range = range;
    return callUnit(context, callee, bare);
}

// Of calls whose callee is unknown: their arguments have mistakes and uses of their own.
void checkArguments(Context& context, const syntax::Expr& call) {
    for (const syntax::Argument& argument : call.arguments) {
        if (!argument.value) continue;
        if (argument.kind == ArgumentKind::Output)
            denote(context, *argument.value, Access::Write);
        else
            expression(context, *argument.value);
    }
}

///   ok:    x := F(1);      wrong: b := t(IN := TRUE);  with t : TON (P2023)   x := y(1);  with y : INT (P2008)
Operand call(Context& context, const syntax::Expr& e, TypeId hint) {
    const Denoted callee = denote(context, *e.base, Access::Call, hint);
    switch (callee.kind) {
    case Denoted::Kind::Nothing:
        checkArguments(context, e);
        return unknown(context, e.range);
    case Denoted::Kind::Unit: {
        Unit& unit = *callee.unit;
        if (unit.kind == UnitKind::Function || unit.kind == UnitKind::Method) return callUnit(context, callee, e);
        if (unit.kind == UnitKind::Action || unit.kind == UnitKind::Program)
            context.emit(e.range, context.isExpression ? findings::NotAllowedInExpression(unit.name)
                                                       : findings::NoValue(unit.name));
        else
            context.emit(e.base->range, findings::NotCallable(phrases::TypeNotInstance(unit.name)));
        checkArguments(context, e);
        return unknown(context, e.range);
    }
    case Denoted::Kind::Standard:
        return standardCall(context, callee.name, e, hint);
    case Denoted::Kind::Place:
        if (context.isKind(callee.place->type, TypeKind::Block))
            context.emit(e.range, context.isExpression ? findings::NotAllowedInExpression(context.textOf(e.base->range))
                                                       : findings::NoValue(context.textOf(e.base->range)));
        else if (!context.isKind(callee.place->type, TypeKind::Unknown))
            context.emit(e.base->range,
                         library::findSignature(context.world.textOf(e.base->range))
                             ? findings::NotCallable(phrases::VariableHidesFunction(context.textOf(e.base->range)))
                             : findings::NotCallable(context.textOf(e.base->range)));
        checkArguments(context, e);
        return unknown(context, e.range);
    // TIME, DATE and their kin are types and functions; parentheses decide.
    case Denoted::Kind::Type:
        if (library::findSignature(context.world.textOf(e.base->range)))
            return standardCall(context, context.world.textOf(e.base->range), e, hint); // TIME()
        [[fallthrough]];
    default:
        context.emit(e.base->range, findings::NotCallable(context.textOf(e.base->range)));
        checkArguments(context, e);
        return unknown(context, e.range);
    }
}

} // namespace plc::sema
