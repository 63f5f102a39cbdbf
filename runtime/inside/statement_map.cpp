#include "runtime/inside/statement_map.h"

namespace plc::inside {

using tree::Stmt;
using tree::StmtKind;

StatementMap::StatementMap(const tree::Program& tree)
    : m_assignments(tree.functions.size()), m_branches(tree.functions.size()) {
    for (uint32_t f = 1; f < tree.functions.size(); ++f) add(tree.functions[f].body, nullptr, f, 0);
}

const StatementMap::Around* StatementMap::around(const Stmt& stmt) const {
    const auto found = m_around.find(&stmt);
    return found == m_around.end() ? nullptr : &found->second;
}

void StatementMap::add(const std::vector<Stmt*>& body, const Stmt* parent, uint32_t function, int64_t arm) {
    for (const Stmt* stmt : body) {
        if (!stmt) continue;
        m_around[stmt] = {parent, &body, function, arm};
        if (stmt->kind == StmtKind::Assign) m_assignments[function].push_back(stmt);
        if (stmt->kind == StmtKind::If || stmt->kind == StmtKind::Case) m_branches[function].push_back(stmt);
        for (const tree::Expr* expr : {stmt->a, stmt->b, stmt->c}) addCalls(expr, *stmt, function);
        add(stmt->body, stmt, function, 1);
        // The numbers are those that a branch reports when it runs: 1 and 0 of IF, the index of CASE, -1 of its ELSE.
        add(stmt->elseBody, stmt, function, stmt->kind == StmtKind::Case ? -1 : 0);
        for (size_t i = 0; i < stmt->arms.size(); ++i) add(stmt->arms[i].body, stmt, function, static_cast<int64_t>(i));
    }
}

void StatementMap::addCalls(const tree::Expr* expr, const Stmt& stmt, uint32_t function) {
    if (!expr) return;
    addCalls(expr->a, stmt, function);
    addCalls(expr->b, stmt, function);
    addCalls(expr->c, stmt, function);
    for (const tree::Expr* operand : expr->operands) addCalls(operand, stmt, function);
    // What an expression needs done first belongs to the statement around it.
    if (!expr->statements.empty()) add(expr->statements, &stmt, function, 1);
    if (!expr->call) return;
    m_callers.insert(&stmt);
    for (const tree::CallArgument& argument : expr->call->arguments) addCalls(argument.value, stmt, function);
}

bool StatementMap::calls(const std::vector<Stmt*>& body) const {
    for (const Stmt* stmt : body) {
        if (!stmt) continue;
        if (m_callers.contains(stmt) || calls(stmt->body) || calls(stmt->elseBody)) return true;
        for (const tree::CaseArm& arm : stmt->arms)
            if (calls(arm.body)) return true;
    }
    return false;
}

bool StatementMap::mayLeave(const Stmt& stmt) const {
    if (stmt.kind == StmtKind::Return || stmt.kind == StmtKind::Exit || stmt.kind == StmtKind::Continue ||
        stmt.kind == StmtKind::Jump)
        return true;
    // An EXIT that leaves only a loop further in counts as well: too many are looked at, never too few.
    const auto any = [&](const std::vector<Stmt*>& body) {
        for (const Stmt* each : body)
            if (each && mayLeave(*each)) return true;
        return false;
    };
    if (any(stmt.body) || any(stmt.elseBody)) return true;
    for (const tree::CaseArm& arm : stmt.arms)
        if (any(arm.body)) return true;
    return false;
}

} // namespace plc::inside
