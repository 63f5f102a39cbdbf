#include "runtime/inside/coverage.h"

#include "runtime/compiler/driver/driver.h"

#include <algorithm>

namespace plc::inside {

using image::WatchKind;
using library::BinaryOp;
using tree::Expr;
using tree::ExprKind;
using tree::Stmt;
using tree::StmtKind;

namespace {

constexpr uint8_t kNotEvaluated = 2;
// A decision of 30 conditions has more combinations than memory; so many show each alone long before.
constexpr size_t kMostVectors = 4096; // of one decision

bool isBool(const tree::Program& tree, const Expr& expr) {
    return tree.types->storageKind(expr.type) == types::TypeKind::Bool;
}

bool isConnective(const tree::Program& tree, const Expr& expr) {
    if (expr.kind == ExprKind::AndThen || expr.kind == ExprKind::OrElse) return true;
    if (!isBool(tree, expr)) return false;
    if (expr.kind == ExprKind::Unary) return expr.unary == library::UnaryOp::Not;
    return expr.kind == ExprKind::Binary &&
           (expr.binary == BinaryOp::And || expr.binary == BinaryOp::Or || expr.binary == BinaryOp::Xor);
}

/// What lowering adds to a transition or an action carries the text of its statement, or of what it assigns.
bool isAdded(const Stmt& stmt, const Expr& expr) {
    return expr.range == stmt.range || (stmt.place && expr.range == stmt.place->range);
}

void conditionsOf(const tree::Program& tree, const Stmt& stmt, const Expr* expr, std::vector<const Expr*>& out) {
    // A constant cannot go both ways: counting it would make full coverage impossible.
    if (!expr || expr->kind == ExprKind::Constant) return;
    if (!isConnective(tree, *expr)) {
        if (!isAdded(stmt, *expr)) out.push_back(expr);
        return;
    }
    conditionsOf(tree, stmt, expr->a, out);
    conditionsOf(tree, stmt, expr->b, out);
}

std::string oneLine(const image::CompiledProgram& program, SourceRange range) {
    if (range.file.index() >= program.sources.files.size()) return {};
    return std::string(program.sources[range.file].slice(range));
}

} // namespace

size_t FunctionCoverage::statementsRun() const {
    return static_cast<size_t>(
        std::count_if(statements.begin(), statements.end(), [](const auto& s) { return s.count > 0; }));
}
size_t FunctionCoverage::branchesTaken() const {
    return static_cast<size_t>(
        std::count_if(branches.begin(), branches.end(), [](const auto& b) { return b.count > 0; }));
}
size_t FunctionCoverage::conditionCount() const {
    size_t all = 0;
    for (const DecisionCoverage& decision : decisions) all += decision.conditions.size();
    return all;
}
size_t FunctionCoverage::conditionsMet() const {
    size_t met = 0;
    for (const DecisionCoverage& decision : decisions)
        for (const ConditionCoverage& condition : decision.conditions) met += condition.decidedAlone ? 1 : 0;
    return met;
}

Coverage::Coverage(std::shared_ptr<const image::CompiledProgram> program)
    : m_program(std::move(program)), m_tree(driver::treeOf(m_program)) {
    if (!m_tree) return;
    for (uint32_t f = 1; f < m_tree->functions.size(); ++f)
        if (isCounted(f)) gather(m_tree->functions[f].body, f);
}

bool Coverage::isCounted(uint32_t function) const {
    const image::FunctionInfo& info = m_program->functions[function];
    // The user cannot test the insides of a library, and a test is not what is tested.
    return info.library.empty() && !info.name.starts_with("Test__");
}

void Coverage::gather(const std::vector<Stmt*>& body, uint32_t function) {
    Unit& unit = m_units[function];
    for (const Stmt* stmt : body) {
        if (!stmt) continue;
        const bool isNamed = stmt->range.file.isValid() && stmt->range.end > stmt->range.begin;
        const bool isBranch = stmt->kind == StmtKind::If || stmt->kind == StmtKind::Case;
        if (isNamed && !stmt->isHidden && stmt->kind != StmtKind::Block && stmt->kind != StmtKind::Label)
            unit.statements[stmt->range.begin] = {stmt->range, 0};
        if (isNamed && !stmt->isHidden && isBranch) {
            const auto add = [&](int64_t arm, std::string name) {
                unit.branches[{stmt->range.begin, arm}] = {stmt->range, std::move(name), 0};
            };
            if (stmt->kind == StmtKind::If) {
                add(1, "then");
                add(0, "else");
            } else {
                for (size_t i = 0; i < stmt->arms.size(); ++i)
                    add(static_cast<int64_t>(i), "arm " + std::to_string(i + 1));
                add(-1, "else");
            }
        }
        for (const Expr* expr : {stmt->a, stmt->b, stmt->c}) gatherDecision(*stmt, expr, function);
        gather(stmt->body, function);
        gather(stmt->elseBody, function);
        for (const tree::CaseArm& arm : stmt->arms) gather(arm.body, function);
    }
}

void Coverage::gatherDecision(const Stmt& stmt, const Expr* expr, uint32_t function) {
    if (!expr || !expr->range.file.isValid() || !isBool(*m_tree, *expr)) return;
    Decision decision;
    decision.root = expr;
    conditionsOf(*m_tree, stmt, expr, decision.conditions);
    if (decision.conditions.empty()) return;
    const auto index = static_cast<uint32_t>(m_decisions.size());
    m_decisionOf[expr] = index;
    for (const Expr* condition : decision.conditions) m_conditionOf[condition] = index;
    m_units[function].decisions.push_back(index);
    m_decisions.push_back(std::move(decision));
}

void Coverage::finishDecision(Decision& decision, const std::map<const Expr*, uint8_t>& values, bool result) {
    if (decision.seen.size() >= kMostVectors) return;
    std::vector<uint8_t> vector;
    for (const Expr* condition : decision.conditions) {
        const auto value = values.find(condition);
        vector.push_back(value == values.end() ? kNotEvaluated : value->second);
    }
    vector.push_back(result ? 1 : 0);
    decision.seen.insert(std::move(vector));
}

Result<void> Coverage::add(Insight& insight, Position at) {
    LookOptions options;
    options.each = [this](const Look& look, const Event& event, uint32_t function) { count(look, event, function); };
    const auto look = insight.look(at, options);
    if (!look) return look.error();
    return {};
}

void Coverage::count(const Look& look, const Event& event, uint32_t function) {
    if (&look.tree() != m_tree) return;
    const uint32_t depth = event.activation;
    if (m_values.size() <= depth) m_values.resize(depth + 1);
    std::map<const Expr*, uint8_t>& values = m_values[depth];
    if (event.kind == WatchKind::Begin) values.clear();
    const auto unit = m_units.find(function);
    if (unit == m_units.end()) return;
    if (event.kind == WatchKind::Statement) {
        const auto found = unit->second.statements.find(event.stmt()->range.begin);
        if (found != unit->second.statements.end() && found->second.range == event.stmt()->range) ++found->second.count;
    } else if (event.kind == WatchKind::Arm) {
        const auto found = unit->second.branches.find({event.stmt()->range.begin, static_cast<int64_t>(event.bits)});
        if (found != unit->second.branches.end()) ++found->second.count;
        // An IF without ELSE has no report for it: what was not taken is the rest.
    } else if (event.kind == WatchKind::Value) {
        if (m_conditionOf.count(event.expr()) != 0) values[event.expr()] = event.bits != 0 ? 1 : 0;
        const auto root = m_decisionOf.find(event.expr());
        if (root == m_decisionOf.end()) return;
        Decision& decision = m_decisions[root->second];
        finishDecision(decision, values, event.bits != 0);
        // The same decision runs again in the next pass of a loop; what it did not evaluate then must not be what
        // it was now.
        for (const Expr* condition : decision.conditions) values.erase(condition);
    }
}

size_t Coverage::addAll(const history::History& history, Progress* progress) {
    Insight insight(history, m_code);
    insight.setCancel([progress] { return isCancelled(progress); });
    const history::Statistics all = history.statistics();
    size_t failed = 0;
    for (Position at = all.first; at < all.end; ++at) {
        if (!goesOn(progress, static_cast<double>(at - all.first) / static_cast<double>(all.scans))) break;
        if (!add(insight, at)) ++failed;
    }
    return failed;
}

DecisionCoverage Coverage::coverageOf(const Decision& decision) const {
    DecisionCoverage out;
    out.range = decision.root->range;
    const size_t count = decision.conditions.size();
    for (size_t i = 0; i < count; ++i) {
        ConditionCoverage condition;
        condition.range = decision.conditions[i]->range;
        for (const std::vector<uint8_t>& a : decision.seen) {
            condition.wasTrue = condition.wasTrue || a[i] == 1;
            condition.wasFalse = condition.wasFalse || a[i] == 0;
        }
        for (auto a = decision.seen.begin(); a != decision.seen.end() && !condition.decidedAlone; ++a)
            for (auto b = std::next(a); b != decision.seen.end() && !condition.decidedAlone; ++b) {
                // Modified condition/decision coverage: two runs that differ in this condition and in the result, the
                // others being equal or, behind a short circuit, without a say.
                if ((*a)[i] == (*b)[i] || (*a)[i] == kNotEvaluated || (*b)[i] == kNotEvaluated) continue;
                if ((*a)[count] == (*b)[count]) continue;
                bool othersAgree = true;
                for (size_t k = 0; k < count; ++k)
                    othersAgree = othersAgree && (k == i || (*a)[k] == (*b)[k] || (*a)[k] == kNotEvaluated ||
                                                  (*b)[k] == kNotEvaluated);
                condition.decidedAlone = othersAgree;
            }
        if (!condition.decidedAlone) {
            const std::string text = oneLine(*m_program, condition.range);
            condition.missing = !condition.wasTrue    ? text + " = TRUE"
                                : !condition.wasFalse ? text + " = FALSE"
                                                      : text + " both ways with the others unchanged";
        }
        out.conditions.push_back(std::move(condition));
    }
    return out;
}

std::vector<FunctionCoverage> Coverage::functions() const {
    std::vector<FunctionCoverage> all;
    for (const auto& [function, unit] : m_units) {
        FunctionCoverage out;
        out.name = m_program->functions[function].name;
        for (const auto& [begin, statement] : unit.statements) {
            if (out.file.empty()) out.file = m_program->sources[statement.range.file].path();
            out.statements.push_back(statement);
        }
        if (out.statements.empty()) continue;
        for (const auto& [key, branch] : unit.branches) {
            out.branches.push_back(branch);
            if (branch.name != "else" || branch.count > 0) continue;
            // The ELSE that nobody wrote: as often as the statement ran without another arm.
            const auto ran = unit.statements.find(key.first);
            uint64_t taken = 0;
            for (const auto& [other, each] : unit.branches)
                if (other.first == key.first) taken += each.count;
            if (ran != unit.statements.end() && ran->second.count > taken)
                out.branches.back().count = ran->second.count - taken;
        }
        for (const uint32_t decision : unit.decisions) out.decisions.push_back(coverageOf(m_decisions[decision]));
        all.push_back(std::move(out));
    }
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return all;
}

} // namespace plc::inside
