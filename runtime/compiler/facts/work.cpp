#include "runtime/compiler/facts/work.h"

#include "runtime/compiler/facts/frames.h"
#include "runtime/compiler/facts/walk.h"

#include <algorithm>

namespace plc::facts {

using tree::Expr;
using tree::ExprKind;
using tree::Place;
using tree::Stmt;
using tree::StmtKind;

namespace {
constexpr uint64_t kLongFunction = 16 * kNodesPerUnit;
constexpr uint64_t kBytesPerNode = kBytesPerUnit / kNodesPerUnit;
// What takes longer than an ordinary node: the call of a function of the runtime library, the making of a text.
constexpr uint64_t kCallNodes = 4, kIntrinsicNodes = 8, kTextNodes = kNodesPerUnit;
} // namespace

bool isChargedByItself(const types::TypeTable& types, types::TypeId type) {
    if (!type.isValid()) return false;
    return types.isText(type) ? textUnits(types[type].capacity) > 0 : copyUnits(types[type].size) > 0;
}

/// Counts nodes along the longest way: of branches the longer one. Loops note what a pass costs and count as one node,
/// since each pass is charged by itself.
class WorkTable::Measure {
public:
    Measure(WorkTable& table, const tree::Program& program, const CalleesOf& calleesOf)
        : m_table(table), m_types(*program.types), m_calleesOf(calleesOf) {}

    uint64_t function(const tree::Function& function) {
        uint64_t nodes = 0;
        for (const tree::Local& local : function.locals) {
            if (local.isInOut) continue;
            nodes += 1 + expression(local.initial);
            if (!isScalar(m_types, local.type)) nodes += m_types[local.type].size / kBytesPerNode; // given or cleared
        }
        return nodes + body(function.body);
    }

private:
    uint64_t body(const std::vector<Stmt*>& statements) {
        uint64_t nodes = 0;
        for (const Stmt* stmt : statements)
            if (stmt) nodes += statement(*stmt);
        return nodes;
    }

    uint64_t statement(const Stmt& stmt) {
        switch (stmt.kind) {
        case StmtKind::If:
            return branches(stmt);
        case StmtKind::Case: {
            uint64_t longest = body(stmt.elseBody);
            for (const tree::CaseArm& arm : stmt.arms) longest = std::max(longest, body(arm.body));
            return 1 + expression(stmt.a) + longest;
        }
        case StmtKind::While:
        case StmtKind::Repeat:
            m_table.m_passes[&stmt] = expression(stmt.a) + body(stmt.body);
            return 1;
        case StmtKind::For:
            m_table.m_passes[&stmt] = body(stmt.body);
            return 1 + place(stmt.place) + expression(stmt.a) + expression(stmt.b) + expression(stmt.c);
        case StmtKind::Assign:
            return 1 + place(stmt.place) + expression(stmt.a) + smallCopy(stmt.place->type);
        case StmtKind::Bind:
        case StmtKind::Evaluate:
        case StmtKind::Exit:
        case StmtKind::Continue:
        case StmtKind::Return:
        case StmtKind::Label:
        case StmtKind::Jump:
            return 1 + place(stmt.place) + place(stmt.target) + expression(stmt.a);
        case StmtKind::Try:
            return kCallNodes + body(stmt.body) + body(stmt.elseBody) +
                   (stmt.arms.empty() ? 0 : body(stmt.arms[0].body));
        case StmtKind::Block:
            return body(stmt.body);
        }
        return 1;
    }

    /// A row of ELSIFs may be as long as it likes: no recursion along it.
    uint64_t branches(const Stmt& first) {
        uint64_t conditions = 0, longest = 0;
        for (const Stmt* stmt = &first;;) {
            conditions += 1 + expression(stmt->a);
            longest = std::max(longest, conditions + body(stmt->body));
            if (!elseIf(*stmt)) return std::max(longest, conditions + body(stmt->elseBody));
            stmt = elseIf(*stmt);
        }
    }

    uint64_t smallCopy(types::TypeId type) const {
        if (m_types.isText(type)) return kTextNodes / 2;
        return isScalar(m_types, type) || isChargedByItself(m_types, type) ? 0 : m_types[type].size / kBytesPerNode;
    }

    uint64_t place(const Place* place) {
        uint64_t nodes = 0;
        for (const Place* p = place; p; p = p->base) {
            nodes += 1 + expression(p->pointer) + expression(p->value);
            for (const Expr* index : p->indices) nodes += expression(index);
        }
        return nodes;
    }

    uint64_t expression(const Expr* expr) {
        if (!expr) return 0;
        uint64_t nodes = 1 + place(expr->place) + expression(expr->a) + place(expr->ok) + body(expr->statements);
        if (expr->kind == ExprKind::Conditional)
            nodes += std::max(expression(expr->b), expression(expr->c));
        else
            nodes += expression(expr->b) + expression(expr->c);
        for (const Expr* operand : expr->operands) nodes += expression(operand);
        if (expr->kind == ExprKind::Intrinsic || expr->kind == ExprKind::Convert) nodes += ofText(*expr);
        if (expr->kind == ExprKind::Intrinsic) nodes += kIntrinsicNodes;
        return expr->call ? nodes + call(*expr->call) : nodes;
    }

    uint64_t ofText(const Expr& expr) const {
        const auto isText = [&](const Expr* operand) { return operand && m_types.isText(operand->type); };
        const bool reads = isText(expr.a) || std::any_of(expr.operands.begin(), expr.operands.end(), isText);
        return reads || m_types.isText(expr.type) ? kTextNodes : 0;
    }

    uint64_t call(const tree::Call& call) {
        uint64_t nodes = kCallNodes + place(call.instance) + expression(call.interface);
        for (const tree::CallArgument& argument : call.arguments)
            nodes += 1 + expression(argument.value) + place(argument.place);
        uint64_t longest = 0;
        for (const uint32_t callee : m_calleesOf(call)) longest = std::max(longest, m_table.m_functions[callee].ofCall);
        return nodes + longest;
    }

    WorkTable& m_table;
    const types::TypeTable& m_types;
    const CalleesOf& m_calleesOf;
};

WorkTable::WorkTable(const tree::Program& program, const std::vector<uint32_t>& order, const std::vector<bool>& inCycle,
                     const CalleesOf& calleesOf)
    : m_functions(program.functions.size()) {
    Measure measure(*this, program, calleesOf);
    for (const uint32_t f : order) {
        OfFunction& made = m_functions[f];
        made.nodes = measure.function(program.functions[f]);
        const bool paysItself = inCycle[f] || made.nodes >= kLongFunction;
        made.ofCall = paysItself ? 0 : made.nodes;
        made.atEntry = paysItself ? 1 + made.nodes / kNodesPerUnit : 0;
    }
}

uint64_t WorkTable::ofPass(const Stmt& loop) const {
    const auto it = m_passes.find(&loop);
    return 1 + (it == m_passes.end() ? 0 : it->second / kNodesPerUnit);
}

} // namespace plc::facts
