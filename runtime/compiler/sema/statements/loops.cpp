// FOR, WHILE and REPEAT.
#include "runtime/compiler/sema/statements/loops.h"

#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/program/analyze.h"
#include "runtime/compiler/sema/statements/statements.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/types/conversion.h"

namespace plc::sema {

namespace {

/// FOR variable := from TO to BY by.
struct Count {
    TypeId storage; // of the variable; Unknown after an error
    TypeId counted; // in which it is computed
    Operand from, to, by;
    bool isGood = false;
    bool isDownwards = false; // as far as a constant step says
};

// A constant whole number; of anything else nothing can be said before it runs.
bool isInteger(const Operand& o) { return o.isConstant() && std::holds_alternative<int64_t>(o.expr->value.data); }

TypeId typeOfLoopVariable(Context& context, const syntax::Stmt& stmt, const Denoted& variable) {
    // A property has no place that could count; the standard wants a variable.
    const TypeId unknownType = context.elementary(TypeKind::Unknown);
    if (variable.kind == Denoted::Kind::Property)
        context.emit(stmt.target->range, findings::NotAssignable(context.textOf(stmt.target->range)));
    if (variable.kind != Denoted::Kind::Place || context.isKind(variable.place->type, TypeKind::Unknown))
        return unknownType;
    const TypeId type = variable.place->type;
    if (types::isInteger(context.types.family(type))) return context.types.storage(type);
    context.emit(stmt.target->range, findings::OperatorNotForType(Verbatim("FOR"), context.nameOf(type)));
    return unknownType;
}

/// The variable's own type; downwards or by a signed step, an unsigned one is counted in the next wider signed type, so
/// that 0 is passed and the loop ends.
TypeId countedType(const Context& context, const Count& count) {
    const bool isSigned = context.types.family(count.storage) == types::Family::Signed;
    const bool hasVariableStep = !count.by.isUnknown() && !count.by.isConstant() &&
                                 context.types.family(count.by.type()) == types::Family::Signed;
    if (isSigned || (!count.isDownwards && !hasVariableStep)) return count.storage;
    // FOR u := 5 TO 0 BY -1 with u : USINT: without a sign, 0 - 1 would be 255 and the loop would never end.
    const unsigned width = types::bitsOf(context.types.storageKind(count.storage));
    return context.elementary(width == 8 ? TypeKind::Int : width == 16 ? TypeKind::Dint : TypeKind::Lint);
}

Count countOf(Context& context, const syntax::Stmt& stmt, TypeId storage) {
    Count count;
    count.storage = count.counted = storage;
    count.isGood = !context.isKind(storage, TypeKind::Unknown);
    count.from = stmt.from ? expression(context, *stmt.from, storage) : unknown(context, stmt.range);
    count.to = stmt.to ? expression(context, *stmt.to, storage) : unknown(context, stmt.range);
    // BY without a hint: BY -1 of an unsigned variable is legal, see countedType.
    count.by = stmt.by ? expression(context, *stmt.by)
                       : constant(context, {context.elementary(TypeKind::Lint), int64_t(1)}, stmt.range, true);
    if (isInteger(count.by) && count.by.expr->value.integer() == 0)
        context.emit(count.by.expr->range, findings::EndlessLoop());
    // Bounds are looked at all the same, for their own mistakes and uses.
    if (!count.isGood) return count;
    count.isDownwards = isInteger(count.by) && count.by.expr->value.integer() < 0;
    count.counted = countedType(context, count);
    // Bounds are computed once, before the first round (7.3.3.4.2), in the type that is counted in.
    for (Operand* limit : {&count.from, &count.to})
        if (!limit->isUnknown()) *limit = converted(context, *limit, count.counted);
    count.by = converted(context, count.by, count.counted);
    return count;
}

/// The body is run at least once, as the constants say.
bool runs(const Count& count) {
    if (!isInteger(count.from) || !isInteger(count.to) || !count.by.isConstant()) return false;
    const int64_t from = count.from.expr->value.integer(), to = count.to.expr->value.integer();
    return count.isDownwards ? from >= to : from <= to;
}

bool isWritten(const syntax::Expr* e) {
    return e && (e->kind == syntax::ExprKind::Literal ||
                 (e->kind == syntax::ExprKind::Unary && e->base->kind == syntax::ExprKind::Literal));
}

/// FOR i := 5 TO 1: with numbers written there; what constants make of it may be meant.
void adviseNeverRuns(Context& context, const syntax::Stmt& stmt, const Count& count) {
    if (!runs(count) && isInteger(count.from) && isInteger(count.to) && count.by.isConstant() && isWritten(stmt.from) &&
        isWritten(stmt.to))
        context.emit(joined(stmt.from->range, stmt.to->range), findings::UnreachableCode());
}

// The range of a loop is its head: stepping shows where a round begins, not the whole body.
SourceRange headOf(const syntax::Stmt& stmt, const syntax::Expr* last) {
    if (!stmt.range.file.isValid() || !last) return stmt.range;
    return {stmt.range.file, stmt.range.begin, std::max(stmt.range.begin, last->range.end)};
}

} // namespace

/// FOR (edition 3, 7.3.3.4.2): the variable and its bounds are integers; they are computed once.
///   ok:    FOR i := 1 TO 10 BY 2 DO … END_FOR      wrong: FOR r := 1.0 TO 2.0 DO … END_FOR  (P2006)
///   advice: FOR i := 1 TO 10 BY 0 DO … END_FOR  (P3033)   FOR i := 5 TO 1 DO … END_FOR  (P3007)
void forStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    if (!stmt.target) return;
    const Denoted variable = target(context, *stmt.target);
    // Counted as read as well: the loop reads what it counts.
    if (variable.kind == Denoted::Kind::Place && variable.variable) count(context, *variable.variable, true, false);
    const Count count = countOf(context, stmt, typeOfLoopVariable(context, stmt, variable));
    tree::Stmt* made = newStmt(context, tree::StmtKind::For, headOf(stmt, stmt.to && stmt.by ? stmt.by : stmt.to));
    if (count.isGood) {
        made->place = variable.place;
        made->a = count.from.expr;
        made->b = count.to.expr;
        made->c = count.by.expr;
        made->operandType = count.counted;
    }
    const Flow before = context.flow;
    context.loops.push_back({});
    // Writing it inside is advised against; nested loops may share none.
    if (variable.variable) context.loopVariables.push_back(variable.variable);
    statements(context, stmt.body, made->body);
    if (variable.variable) context.loopVariables.pop_back();
    adviseNeverRuns(context, stmt, count);
    const Loop loop = context.loops.back();
    context.loops.pop_back();
    // A result that the body sets is set behind the loop only if the body surely runs and is not left before.
    const bool setInside = context.flow.isResultSet && (!loop.hasExit || loop.resultSetAtExit);
    context.flow.isReachable = before.isReachable;
    context.flow.isResultSet = before.isResultSet || (runs(count) && setInside);
    if (count.isGood && !count.from.isUnknown() && !count.to.isUnknown() && !count.by.isUnknown()) out.push_back(made);
}

///   advice: WHILE TRUE DO x := 1; END_WHILE  (P3033)
void whileStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    tree::Stmt* made = newStmt(context, tree::StmtKind::While, headOf(stmt, stmt.value));
    if (stmt.value) made->a = condition(context, *stmt.value);
    const Flow before = context.flow;
    context.loops.push_back({});
    statements(context, stmt.body, made->body);
    const Loop loop = context.loops.back();
    context.loops.pop_back();
    // WHILE TRUE with EXIT is the usual way to write a loop with its end in the middle; what follows is reached by EXIT
    // only.
    const bool endless = made->a && made->a->kind == tree::ExprKind::Constant && made->a->value.isTrue();
    context.flow = before;
    if (endless && !loop.hasExit && !loop.isLeft && before.isReachable) {
        context.emit(stmt.value->range, findings::EndlessLoop());
    } else if (endless) {
        context.flow.isReachable = before.isReachable && loop.hasExit;
        context.flow.isResultSet = before.isResultSet || loop.resultSetAtExit;
    }
    if (made->a) out.push_back(made);
}

///   advice: REPEAT x := 1; UNTIL FALSE END_REPEAT  (P3033)
void repeatStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    tree::Stmt* made = newStmt(context, tree::StmtKind::Repeat,
                               stmt.range.file.isValid() && stmt.value ? stmt.value->range : stmt.range);
    const Flow before = context.flow;
    context.loops.push_back({});
    statements(context, stmt.body, made->body);
    const Loop loop = context.loops.back();
    context.loops.pop_back();
    // REPEAT runs once in any case, so what its body sets is set.
    const bool set = context.flow.isResultSet && (!loop.hasExit || loop.resultSetAtExit);
    if (stmt.value) made->a = condition(context, *stmt.value);
    if (made->a && made->a->kind == tree::ExprKind::Constant && made->a->value.hasValue() && !made->a->value.isTrue() &&
        !loop.hasExit && !loop.isLeft && context.flow.isReachable)
        context.emit(stmt.value->range, findings::EndlessLoop());
    context.flow.isReachable = before.isReachable && (context.flow.isReachable || loop.hasExit || before.isReachable);
    context.flow.isResultSet = before.isResultSet || set;
    if (made->a) out.push_back(made);
}

} // namespace plc::sema
