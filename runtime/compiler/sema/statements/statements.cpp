// Statements → checked statements; reachability and "is the result set" are followed on the way.
#include "runtime/compiler/sema/statements/statements.h"

#include "runtime/compiler/sema/calls/call_statements.h"
#include "runtime/compiler/sema/calls/calls.h"
#include "runtime/compiler/sema/calls/special_calls.h"
#include "runtime/compiler/sema/context.h"
#include "runtime/compiler/sema/declare/tests.h"
#include "runtime/compiler/sema/layout/initial_values.h"
#include "runtime/compiler/sema/layout/layout.h"
#include "runtime/compiler/sema/layout/units.h"
#include "runtime/compiler/sema/names/lookup.h"
#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/program/analyze.h"
#include "runtime/compiler/sema/statements/case_statement.h"
#include "runtime/compiler/sema/statements/loops.h"
#include "runtime/compiler/sema/statements/protected.h"
#include "runtime/compiler/sema/types/conversions.h"
#include "runtime/compiler/sema/types/type_specs.h"
#include "runtime/compiler/sema/values/expressions.h"

#include "runtime/types/conversion.h"

#include "runtime/base/text.h"

namespace plc::sema {

using lex::TokenKind;
using syntax::StmtKind;

static void statement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
static void ifStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
static void returnStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
static void labelStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
static void jumpStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);

tree::Stmt* newStmt(Context& context, tree::StmtKind kind, SourceRange range) {
    tree::Stmt* stmt = context.arena.make<tree::Stmt>();
    stmt->kind = kind;
    stmt->range = range;
    // Without a place in a text it is hidden: no stop, no step, no coverage.
    stmt->isHidden = !range.file.isValid();
    return stmt;
}

tree::Stmt* assignStmt(Context& context, tree::Place* place, tree::Expr* value, SourceRange range) {
    tree::Stmt* stmt = newStmt(context, tree::StmtKind::Assign, range);
    stmt->place = place;
    stmt->a = value;
    stmt->operandType = place->type;
    return stmt;
}

///   ok:    IF x > 1 THEN RETURN; END_IF x := 1;      advice: RETURN; x := 1;  (P3007)
void statements(Context& context, const syntax::Block& block, std::vector<tree::Stmt*>& out) {
    // One message for a stretch of unreachable statements, at its first.
    bool reported = false;
    for (size_t i = 0; i < block.size(); ++i) {
        const syntax::Stmt& stmt = *block[i];
        // A JMP may lead to a label, also from below.
        if (!context.flow.isReachable && stmt.kind == StmtKind::Label) context.flow.isReachable = true;
        if (!context.flow.isReachable && !reported && !context.insideUnreachable && stmt.kind != StmtKind::Empty &&
            stmt.range.file.isValid() && block.back()->range.file == stmt.range.file && !stmt.origin) {
            context.emit(stmt.range, findings::UnreachableCode());
            reported = true;
        }
        // Statements inside of an unreachable IF are as unreachable as it is, and not worth a message each.
        const bool outer = std::exchange(context.insideUnreachable,
                                         context.insideUnreachable || (reported && !context.flow.isReachable));
        statement(context, stmt, out);
        context.insideUnreachable = outer;
    }
}

///   ok:    WHILE x < 5 DO EXIT; END_WHILE      wrong: x := 1; EXIT;  (P3020)   ASSERT x = 1;  in a PROGRAM (P6001)
void statement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    switch (stmt.kind) {
    case StmtKind::Empty:
        return;
    case StmtKind::Assign:
        return assignment(context, stmt, out);
    case StmtKind::Call:
        return callStatement(context, stmt, out);
    case StmtKind::If:
        return ifStatement(context, stmt, out);
    case StmtKind::Case:
        return caseStatement(context, stmt, out);
    case StmtKind::For:
        return forStatement(context, stmt, out);
    case StmtKind::While:
        return whileStatement(context, stmt, out);
    case StmtKind::Repeat:
        return repeatStatement(context, stmt, out);
    case StmtKind::Try:
        return tryStatement(context, stmt, out);
    case StmtKind::Exit:
    case StmtKind::Continue:
        if (context.loops.empty()) {
            context.emit(stmt.range,
                         findings::OutsideLoop(Verbatim(stmt.kind == StmtKind::Exit ? "EXIT" : "CONTINUE")));
            return;
        }
        // What is set at an EXIT is what holds behind the loop, as far as it is left there.
        if (stmt.kind == StmtKind::Exit) {
            context.loops.back().hasExit = true;
            context.loops.back().resultSetAtExit = context.loops.back().resultSetAtExit && context.flow.isResultSet;
        }
        out.push_back(newStmt(context, stmt.kind == StmtKind::Exit ? tree::StmtKind::Exit : tree::StmtKind::Continue,
                              stmt.range));
        context.flow.isReachable = false;
        return;
    case StmtKind::Return:
        return returnStatement(context, stmt, out);
    case StmtKind::Label:
        return labelStatement(context, stmt, out);
    case StmtKind::Jump:
        return jumpStatement(context, stmt, out);
    case StmtKind::Block: {
        tree::Stmt* made = newStmt(context, tree::StmtKind::Block, stmt.range);
        statements(context, stmt.body, made->body);
        out.push_back(made);
        return;
    }
    case StmtKind::Il:
        return; // lowered before
    case StmtKind::Run:
    case StmtKind::Assert:
    case StmtKind::Force:
    case StmtKind::Release:
    case StmtKind::Compare:
    case StmtKind::PowerOff: {
        if (context.isTest) return testStatement(context, stmt, out);
        // In the order of the kinds from Run on.
        static constexpr const char* kWords[] = {"RUN", "ASSERT", "FORCE", "RELEASE", "COMPARE", "POWER_OFF"};
        context.emit(stmt.range, findings::TestUnknownStatement(
                                     Verbatim(kWords[static_cast<int>(stmt.kind) - static_cast<int>(StmtKind::Run)])));
        return;
    }
    }
}

// What holds behind the IF is what holds behind each of its branches that can be left at its end.
void ifStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    const Flow before = context.flow;
    Flow joined{false, true};
    bool hasElse = false;
    // ELSIF is an IF in the ELSE of the one before: `into` walks down.
    std::vector<tree::Stmt*>* into = &out;
    for (const syntax::IfBranch& branch : stmt.branches) {
        context.flow = before;
        if (!branch.condition) {
            hasElse = true;
            statements(context, branch.body, *into);
        } else {
            // IF and its condition, so that a step shows the decision and not the branches.
            const SourceRange range =
                into == &out
                    ? (stmt.range.file.isValid() ? SourceRange{stmt.range.file, stmt.range.begin,
                                                               std::max(stmt.range.begin, branch.condition->range.end)}
                                                 : stmt.range)
                    : branch.condition->range;
            tree::Stmt* choice = newStmt(context, tree::StmtKind::If, range);
            choice->a = condition(context, *branch.condition);
            statements(context, branch.body, choice->body);
            into->push_back(choice);
            into = &choice->elseBody;
        }
        if (context.flow.isReachable) joined.isResultSet = joined.isResultSet && context.flow.isResultSet;
        joined.isReachable = joined.isReachable || context.flow.isReachable;
    }
    if (!hasElse) {
        // Without ELSE the way past all branches joins them as well.
        joined.isResultSet = (joined.isReachable ? joined.isResultSet : true) && before.isResultSet;
        joined.isReachable = joined.isReachable || before.isReachable;
    }
    context.flow = joined;
    if (!before.isReachable) context.flow.isReachable = false;
}

/// RETURN(condition); of CODESYS in a unit without a result: leaves it when the condition is TRUE.
static void returnWhen(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    tree::Stmt* choice = newStmt(context, tree::StmtKind::If, stmt.range);
    choice->a = condition(context, *stmt.value);
    if (context.flow.isReachable) context.returnsSet = context.returnsSet && context.flow.isResultSet;
    choice->body.push_back(newStmt(context, tree::StmtKind::Return, stmt.range));
    choice->body.back()->isHidden = true;
    out.push_back(choice);
}

void returnStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    // RETURN leaves every loop around it: none of them is endless.
    for (Loop& loop : context.loops) loop.isLeft = true;
    if (stmt.value) {
        Unit* unit = context.scope.unit;
        // RETURN(x) is CODESYS's conditional return in a unit without a result, and a value where there is one.
        if (unit && !unit->resultVariable && stmt.value->parenthesised) return returnWhen(context, stmt, out);
        if (!unit || !unit->resultVariable) {
            expression(context, *stmt.value);
            context.emit(stmt.value->range, findings::NotAllowedHere(phrases::ReturnWithValue(),
                                                                     unit ? phrases::In(unit->name) : phrases::Here()));
            return;
        }
        Variable& result = *unit->resultVariable;
        const Operand value = converted(context, expression(context, *stmt.value, result.type), result.type);
        if (!value.isUnknown())
            out.push_back(assignStmt(context, localPlace(context, result.local, result.type, stmt.value->range),
                                     value.expr, stmt.range));
        context.flow.isResultSet = true;
    }
    if (context.flow.isReachable) context.returnsSet = context.returnsSet && context.flow.isResultSet;
    tree::Stmt* made = newStmt(context, tree::StmtKind::Return, stmt.range);
    // RETURN x is one step: the assignment is the visible half.
    if (stmt.value) made->isHidden = true;
    out.push_back(made);
    context.flow.isReachable = false;
}

// Before the body: a jump forward has to find its label. Labels of all blocks are in one list, as JMP may lead
// anywhere.
void declareLabels(Context& context, const syntax::Block& block) {
    for (const syntax::Stmt* stmt : block) {
        if (stmt->kind == StmtKind::Label && stmt->name.isValid()) {
            Label label;
            label.id = tree::LabelId(context.function->labelCount++);
            label.range = stmt->name.range;
            const std::string id = foldCase(stmt->name.text);
            if (context.labels.count(id))
                context.emit(stmt->name.range, findings::DuplicateName(stmt->name.text));
            else {
                label.symbol =
                    addSymbol(context.gathered, SymbolKind::Label, stmt->name.text,
                              context.scope.unit ? context.scope.unit->qualified : std::string(), stmt->name.range);
                context.labels.emplace(id, label);
            }
        }
        declareLabels(context, stmt->body);
        declareLabels(context, stmt->elseBody);
        for (const syntax::IfBranch& branch : stmt->branches) declareLabels(context, branch.body);
        for (const syntax::CaseArm& arm : stmt->arms) declareLabels(context, arm.body);
    }
}

void labelStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    const auto it = context.labels.find(foldCase(stmt.name.text));
    if (it == context.labels.end()) return;
    // A label is no step.
    tree::Stmt* made = newStmt(context, tree::StmtKind::Label, {});
    made->label = it->second.id;
    out.push_back(made);
    context.flow.isReachable = true;
}

///   ok:    JMP here; … here: x := 2;      wrong: JMP there;  (P3019)
void jumpStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    for (Loop& loop : context.loops) loop.isLeft = true;
    const auto it = context.labels.find(foldCase(stmt.name.text));
    tree::Expr* when = stmt.value ? condition(context, *stmt.value) : nullptr;
    if (it == context.labels.end()) {
        std::vector<std::string> candidates;
        for (const auto& [id, label] : context.labels) candidates.emplace_back(context.world.textOf(label.range));
        suggest(context, context.emit(stmt.name.range, findings::UnknownLabel(stmt.name.text)), stmt.name.range,
                stmt.name.text, candidates);
        return;
    }
    it->second.isUsed = true;
    refer(context, stmt.name.range, it->second.symbol, Access::Read);
    tree::Stmt* made = newStmt(context, tree::StmtKind::Jump, stmt.range);
    made->label = it->second.id;
    made->a = when;
    out.push_back(made);
    // A conditional jump may go on.
    if (!when) context.flow.isReachable = false;
}

} // namespace plc::sema
