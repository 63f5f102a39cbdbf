// __NEW and __DELETE, lowered to two functions of the controller's memory and ordinary statements (decision 018). No
// new kind of tree: recording, stepping and "why" see what they see everywhere.
#include "runtime/compiler/sema/calls/dynamic_memory.h"

#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/calls/special_calls.h"
#include "runtime/compiler/sema/layout/initial_values.h"
#include "runtime/compiler/sema/layout/units.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/operators/operators.h"
#include "runtime/compiler/sema/program/analyze.h"
#include "runtime/compiler/sema/statements/statements.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/base/text.h"

namespace plc::sema {
namespace {

bool isPossible(Context& context, const syntax::Expr& e, size_t least, size_t most) {
    const std::string name = context.textOf(e.base->range);
    // Memory is asked for in the project, because it belongs to the image and thus to every recording.
    if (!context.world.options.memoryForNew) {
        context.emit(e.base->range, findings::NoMemoryForNew(name));
        return false;
    }
    if (e.arguments.size() < least) {
        context.emit(e.base->range, findings::MissingArgument(Verbatim("IN"), name));
        return false;
    }
    if (e.arguments.size() > most) {
        context.emit(e.arguments[most].range, findings::TooManyArguments(name, most));
        return false;
    }
    // Without a value the parser has reported it.
    for (const syntax::Argument& argument : e.arguments)
        if (!argument.value) return false;
    if (context.function) return true;
    context.emit(e.range, context.isExpression ? findings::NotAllowedInExpression(name) : findings::NotConstant());
    return false;
}

/// One of the two functions of the memory, which the driver adds to the standard library.
Operand callMemory(Context& context, const char* name, Operand argument, SourceRange range) {
    // Found by its name as if the user had written it: the two functions are ST with an intrinsic inside, in a file
    // that is only there when the project has such memory.
    const Found known = lookup(context.world, context.scope, context.key(name));
    Unit* unit = known.entity.unit;
    if (!unit) return unknown(context, range);
    completeUnit(context, *unit, range);
    Denoted callee;
    callee.kind = Denoted::Kind::Unit;
    callee.unit = unit;
    tree::Expr* result = context.arena.make<tree::Expr>();
    result->kind = tree::ExprKind::Call;
    result->type = unit->result;
    result->range = range;
    result->call = context.arena.make<tree::Call>();
    prepareCall(context, *result->call, callee, range);
    tree::CallArgument given;
    given.local = unit->parameters.front()->local;
    given.value = argument.expr;
    result->call->arguments.push_back(given);
    return {result, &context.types};
}

/// T of POINTER TO T, which the parser reads as POINTER(T).
const syntax::Expr* pointedType(const syntax::Expr& e) {
    const bool isPointer = e.kind == syntax::ExprKind::Call && e.base && e.base->kind == syntax::ExprKind::NameRef &&
                           e.base->name.isValid() && equalsIgnoringCase(e.base->name.text, "POINTER");
    return isPointer && e.arguments.size() == 1 ? e.arguments.front().value : nullptr;
}

/// The type that __NEW names; invalid: it was reported.
TypeId namedType(Context& context, const syntax::Expr& e) {
    // Recursive: POINTER TO POINTER TO T. The parser bounds the depth.
    if (const syntax::Expr* target = pointedType(e)) {
        const TypeId type = namedType(context, *target);
        return type.isValid() ? context.types.pointer(type) : TypeId();
    }
    const Denoted denoted = denote(context, e, Access::Read);
    if (denoted.kind == Denoted::Kind::Nothing) return {};
    Unit* unit = denoted.kind == Denoted::Kind::Unit ? denoted.unit : nullptr;
    const TypeId type = denoted.kind == Denoted::Kind::Type ? denoted.type : unit ? unit->type : TypeId();
    // Blocks, structures and elementary types; a program or an interface has no variable to make.
    const bool isMade =
        type.isValid() && !context.isKind(type, TypeKind::Interface) && (!unit || unit->kind == UnitKind::Block);
    if (!isMade) {
        context.emit(e.range, findings::UnknownType(context.textOf(e.range)));
        return {};
    }
    // As with a variable of the type (edition 3, 6.6.5): it would have methods without a body.
    if (unit && unit->isAbstract) {
        context.emit(e.range, findings::AbstractInstance(unit->name));
        return {};
    }
    return completeType(context, type, e.range) ? type : TypeId();
}

tree::Place* behind(Context& context, Operand pointer, TypeId type, SourceRange range) {
    tree::Place* place = context.arena.make<tree::Place>();
    place->kind = tree::PlaceKind::Deref;
    place->type = type;
    place->range = range;
    place->pointer = pointer.expr;
    return place;
}

/// What a declared variable of the type begins with, in each of the elements made.
std::vector<tree::Stmt*> initialisation(Context& context, tree::Place* made, tree::Place* count, TypeId type,
                                        SourceRange range) {
    // Memory comes zeroed, so types that begin with zeros and construct nothing need no loop at all.
    const bool hasValue = !context.types[type].initial.empty(), constructs = needsConstruction(context.world, type);
    if (!hasValue && !constructs) return {};
    const TypeId lint = context.elementary(TypeKind::Lint), lword = context.elementary(TypeKind::Lword);
    tree::Place* number = localPlace(context, newLocal(context, "number", lint), lint, range);
    // made[number] without an array type: its length is only known when it runs. By bytes, as POINTER arithmetic is not
    // in the language's terms of the tree.
    const auto elementAs = [&](TypeId seen) {
        const Operand size = constant(context, {lint, int64_t(context.types[type].size)}, range);
        const Operand step =
            makeBinary(context, library::BinaryOp::Multiply, lint, load(context, number, range), size, range);
        const Operand from = sameBits(context, load(context, made, range), lint);
        const Operand sum = makeBinary(context, library::BinaryOp::Add, lint, from, step, range);
        return behind(context, sameBits(context, sameBits(context, sum, lword), context.types.pointer(seen)), seen,
                      range);
    };
    const auto element = [&] { return elementAs(type); };
    tree::Stmt* loop = newStmt(context, tree::StmtKind::For, {});
    loop->place = number;
    loop->operandType = lint;
    loop->a = constant(context, {lint, int64_t(0)}, range).expr;
    const Operand one = constant(context, {lint, int64_t(1)}, range);
    loop->b = makeBinary(context, library::BinaryOp::Subtract, lint, load(context, count, range), one, range).expr;
    loop->c = constant(context, {lint, int64_t(1)}, range).expr;
    if (const uint32_t block = context.types[type].blockNumber; block > 0) { // what makes it a block comes first
        const TypeId udint = context.elementary(TypeKind::Udint);
        loop->body.push_back(
            assignStmt(context, elementAs(udint), constant(context, {udint, int64_t(block)}, range).expr, {}));
    }
    // The initial value is already known as that of a local; copying one is shorter than assigning each field again.
    if (hasValue) { // a local begins with it
        tree::Place* fresh = localPlace(context, newLocal(context, "fresh", type), type, range);
        loop->body.push_back(assignStmt(context, element(), load(context, fresh, range).expr, {}));
    }
    // FB_Init and dynamic initial values, in the same order as for declared variables (initial_values.cpp).
    if (constructs) {
        DynamicInit construction;
        construction.type = type;
        construction.isConstruction = true;
        construction.scope = context.scope;
        emitDynamics(
            context, {construction}, [&](const DynamicInit&) { return element(); }, loop->body);
    }
    return {loop};
}

} // namespace

/// p := __NEW(T) or __NEW(T, n): a variable of its own that lives until __DELETE; 0 when the memory is used up.
///   ok:    p := __NEW(Motor);  with p : POINTER TO Motor      wrong: __NEW(x)  with a variable x (P3002)
Operand newCall(Context& context, const syntax::Expr& e) {
    if (!isPossible(context, e, 1, 2)) return unknown(context, e.range);
    const TypeId type = namedType(context, *e.arguments[0].value);
    if (!type.isValid()) return unknown(context, e.range);
    const TypeId lint = context.elementary(TypeKind::Lint), pointer = context.types.pointer(type);
    Operand wanted = constant(context, {lint, int64_t(1)}, e.range);
    if (e.arguments.size() > 1) wanted = converted(context, expression(context, *e.arguments[1].value, lint), lint);
    // n is evaluated once and kept: the loop, the size and the address all need the same number.
    if (wanted.isUnknown()) return unknown(context, e.range);
    tree::Place* count = localPlace(context, newLocal(context, "count", lint), lint, e.range);
    tree::Place* made = localPlace(context, newLocal(context, "made", pointer), pointer, e.range);
    // An empty structure still needs an address of its own.
    const Operand size = constant(context, {lint, int64_t(std::max(1u, context.types[type].size))}, e.range);
    const Operand bytes =
        makeBinary(context, library::BinaryOp::Multiply, lint, load(context, count, e.range), size, e.range);
    const Operand address = callMemory(context, "__ALLOCATE", bytes, e.range);
    if (address.isUnknown()) return unknown(context, e.range);
    tree::Expr* sequence = newSequence(context, pointer, e.range);
    sequence->statements.push_back(assignStmt(context, count, wanted.expr, {}));
    sequence->statements.push_back(assignStmt(context, made, sameBits(context, address, pointer).expr, {}));
    if (std::vector<tree::Stmt*> begin = initialisation(context, made, count, type, e.range); !begin.empty()) {
        tree::Stmt* choice = newStmt(context, tree::StmtKind::If, {});
        // No memory: the pointer is 0 and nothing is initialised; the program decides what that means.
        choice->a = inverted(context, isNull(context, load(context, made, e.range), e.range), e.range).expr;
        choice->body = std::move(begin);
        sequence->statements.push_back(choice);
    }
    sequence->a = load(context, made, e.range).expr;
    return {sequence, &context.types};
}

/// __DELETE(p): FB_Exit of a block runs, the memory is free, p is 0. What __NEW did not make faults; 0 does nothing.
///   wrong: __DELETE(x)  with x : INT (P2020)
Operand deleteCall(Context& context, const syntax::Expr& e) {
    if (!isPossible(context, e, 1, 1)) return unknown(context, e.range);
    const syntax::Expr& argument = *e.arguments[0].value;
    const Denoted denoted = denote(context, argument, Access::ReadWrite);
    if (denoted.kind == Denoted::Kind::Nothing) return unknown(context, e.range);
    if (denoted.kind != Denoted::Kind::Place || !context.isKind(denoted.place->type, TypeKind::Pointer)) {
        context.emit(argument.range, findings::NotAPointer(context.textOf(argument.range)));
        return unknown(context, e.range);
    }
    tree::Place* pointer = denoted.place;
    const TypeId type = context.types[pointer->type].element, boolean = context.elementary(TypeKind::Bool),
                 lword = context.elementary(TypeKind::Lword);
    // __DELETE of 0 does nothing, as in C++: callers need no question of their own.
    tree::Stmt* choice = newStmt(context, tree::StmtKind::If, {});
    choice->a = inverted(context, isNull(context, load(context, pointer, e.range), e.range), e.range).expr;
    Unit* unit = context.world.unitOf(type);
    const Member end = unit ? findMember(*unit, context.key("FB_Exit")) : Member{};
    // FB_Exit(bInCopyCode : BOOL) of CODESYS; with another signature it is a method that only has the name.
    if (end.unit && end.unit->kind == UnitKind::Method && end.unit->parameters.size() <= 1) {
        completeUnit(context, *end.unit, e.range);
        Denoted callee;
        callee.kind = Denoted::Kind::Unit;
        callee.unit = end.unit;
        callee.instance = behind(context, load(context, pointer, e.range), type, e.range);
        tree::Expr* call = context.arena.make<tree::Expr>();
        call->kind = tree::ExprKind::Call;
        call->type = end.unit->result.isValid() ? end.unit->result : context.elementary(TypeKind::Void);
        call->range = e.range;
        call->call = context.arena.make<tree::Call>();
        prepareCall(context, *call->call, callee, e.range);
        for (Variable* parameter : end.unit->parameters)
            call->call->arguments.push_back({parameter->local, tree::ArgumentMode::Input,
                                             constant(context, {boolean, int64_t(0)}, e.range).expr, nullptr});
        tree::Stmt* evaluate = newStmt(context, tree::StmtKind::Evaluate, {});
        evaluate->a = call;
        choice->body.push_back(evaluate);
    }
    const Operand given = sameBits(context, load(context, pointer, e.range), lword);
    const Operand released = callMemory(context, "__RELEASE", given, e.range);
    if (released.isUnknown()) return unknown(context, e.range);
    tree::Stmt* foreign = newStmt(context, tree::StmtKind::If, {});
    foreign->a = inverted(context, released, e.range).expr;
    const TypeId byte = context.elementary(TypeKind::Byte); // no variable is there: the fault of a foreign reference
    // Reading from address 1 is no trick of the machine: the controller checks each address, so this is its ordinary
    // fault, with the place of the __DELETE.
    const Operand nowhere = constant(context, {context.types.pointer(byte), int64_t(1)}, e.range);
    tree::Stmt* fault = newStmt(context, tree::StmtKind::Evaluate, {});
    fault->a = load(context, behind(context, nowhere, byte, e.range), e.range).expr;
    foreign->body.push_back(fault);
    choice->body.push_back(foreign);
    choice->body.push_back(
        // Last, because FB_Exit and the release still read it.
        assignStmt(context, pointer, constant(context, {pointer->type, int64_t(0)}, e.range).expr, {}));
    tree::Expr* sequence = newSequence(context, context.elementary(TypeKind::Void), e.range);
    sequence->statements.push_back(choice);
    return {sequence, &context.types};
}

} // namespace plc::sema
