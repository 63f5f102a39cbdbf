#include "runtime/compiler/ladder/flow.h"

#include "runtime/compiler/ladder/projector.h"

#include <algorithm>

namespace plc::ladder {

namespace {

Power both(Power a, Power b) {
    if (a == Power::Off || b == Power::Off) return Power::Off;
    return a == Power::Unknown || b == Power::Unknown ? Power::Unknown : Power::On;
}

Power either(Power a, Power b) {
    if (a == Power::On || b == Power::On) return Power::On;
    return a == Power::Unknown || b == Power::Unknown ? Power::Unknown : Power::Off;
}

Power inverted(Power power) {
    return power == Power::On ? Power::Off : power == Power::Off ? Power::On : Power::Unknown;
}

class FlowWalk {
public:
    FlowWalk(std::string_view text, const Diagram& diagram, const Answers& answers, const Executed& isExecuted,
             std::vector<Power>& power)
        : m_text(text), m_diagram(diagram), m_answers(answers), m_isExecuted(isExecuted), m_power(power) {}

    [[nodiscard]] bool isExecuted(const syntax::Stmt* stmt) const {
        return !m_isExecuted || !stmt || m_isExecuted(reportedRange(*stmt));
    }

    Power reach(NodeId id, Power before, bool isReached) {
        return isReached ? walk(id, before) : skip(id, Power::Unknown);
    }

    Power walk(NodeId id, Power before) {
        const Power after = behind(id, before);
        m_power[id.index()] = after;
        return after;
    }

private:
    Power own(NodeId id) {
        const Question question = questionOf(m_text, m_diagram, id);
        return question.text.empty() ? Power::Unknown : m_answers(question);
    }

    Power behind(NodeId id, Power before) {
        const Node& node = m_diagram[id];
        switch (node.kind) {
        case NodeKind::Contact:
        case NodeKind::Compare:
        case NodeKind::Edge:
            return both(before, node.negated ? inverted(own(id)) : own(id));
        case NodeKind::Series:
            for (const NodeId child : node.children)
                before = node.isShort && before == Power::Off ? skip(child, Power::Off) : walk(child, before);
            return before;
        case NodeKind::Parallel: {
            Power any = Power::Off;
            for (const NodeId child : node.children)
                if (node.isShort && any == Power::On)
                    skip(child, Power::Unknown);
                else
                    any = either(any, walk(child, before));
            return any;
        }
        case NodeKind::Invert:
            return inverted(walk(node.children[0], before));
        case NodeKind::Box:
            if (!isExecuted(node.stmt)) return skip(id, before == Power::Off ? Power::Off : Power::Unknown);
            for (const Pin& pin : node.inputs)
                if (pin.node.isValid()) walk(pin.node, Power::On);
            return own(id);
        case NodeKind::Operand:
            return own(id);
        case NodeKind::Coil:
        case NodeKind::Jump:
        case NodeKind::Return:
        case NodeKind::Exit:
        case NodeKind::Continue:
            return before;
        }
        return Power::Unknown;
    }

    /// What was not evaluated, because what is before it decided alone.
    Power skip(NodeId id, Power power) {
        m_power[id.index()] = power;
        for (const NodeId child : m_diagram[id].children) skip(child, power);
        for (const Pin& pin : m_diagram[id].inputs)
            if (pin.node.isValid()) skip(pin.node, Power::Unknown);
        return power;
    }

    std::string_view m_text;
    const Diagram& m_diagram;
    const Answers& m_answers;
    const Executed& m_isExecuted;
    std::vector<Power>& m_power;
};

} // namespace

Question questionOf(std::string_view text, const Diagram& diagram, NodeId id) {
    const Node& node = diagram[id];
    const auto asked = [&](const syntax::Expr* expr) {
        return Question{unparenthesised(std::string(text.substr(expr->range.begin, expr->range.length()))), expr->range,
                        expr};
    };
    switch (node.kind) {
    case NodeKind::Contact:
    case NodeKind::Operand:
        return node.operand ? asked(node.operand) : Question();
    case NodeKind::Compare: // without the NOT of a negated one
        return asked(node.negated && node.expr->kind == syntax::ExprKind::Unary ? node.expr->base : node.expr);
    case NodeKind::Edge:
        return {node.instance + ".Q", node.negated ? node.expr->base->range : node.expr->range, nullptr};
    case NodeKind::Box:
        for (const OutputPin& pin : node.outputs)
            if (pin.isFlow && !pin.name.empty() && !node.instance.empty())
                return {node.instance + "." + pin.name, pin.range, nullptr};
        return node.expr && !node.stmt ? asked(node.expr) : Question();
    default:
        return {};
    }
}

SourceRange reportedRange(const syntax::Stmt& stmt) {
    const auto upTo = [&](const syntax::Expr* last) {
        return last ? SourceRange{stmt.range.file, stmt.range.begin, std::max(stmt.range.begin, last->range.end)}
                    : stmt.range;
    };
    switch (stmt.kind) {
    case syntax::StmtKind::If:
        return upTo(stmt.branches.front().condition);
    case syntax::StmtKind::While:
        return upTo(stmt.value);
    case syntax::StmtKind::For:
        return upTo(stmt.by ? stmt.by : stmt.to);
    default:
        return stmt.range;
    }
}

namespace {

/// The statement of a rung that contacts belong to.
const syntax::Stmt* statementAround(const Rung& rung, SourceRange contacts) {
    for (const syntax::Stmt* stmt : rung.statements)
        if (stmt->range.begin <= contacts.begin && contacts.end <= stmt->range.end) return stmt;
    return nullptr;
}

} // namespace

bool isRungExecuted(const Diagram& diagram, const Rung& rung, const Executed& isExecuted) {
    if (!isExecuted || rung.statements.empty()) return true;
    const syntax::Stmt& first = *rung.statements.front();
    const bool isLater = (rung.kind == RungKind::Head || rung.kind == RungKind::Tail) &&
                         rung.range.begin != first.range.begin; // ELSIF, UNTIL: known by its condition
    if (!isLater) return isExecuted(reportedRange(first));
    return rung.power.isValid() ? isExecuted(diagram[rung.power].range) : isExecuted(reportedRange(first));
}

void computeFlow(std::string_view text, const Diagram& diagram, const Rung& rung, const Answers& answers,
                 std::vector<Power>& power, const Executed& isExecuted) {
    FlowWalk walk(text, diagram, answers, isExecuted, power);
    const bool isReached = isRungExecuted(diagram, rung, isExecuted);
    const Power rail = isReached ? Power::On : Power::Unknown;
    const Power shared = rung.power.isValid() ? walk.reach(rung.power, rail, isReached) : rail;
    for (const Branch& branch : rung.branches) {
        Power behind = shared;
        if (branch.tail.isValid()) {
            const bool isAsked = isReached && walk.isExecuted(statementAround(rung, diagram[branch.tail].range));
            behind = walk.reach(branch.tail, isAsked ? shared : Power::Unknown, isAsked);
        }
        const bool isLeftOut = behind == Power::On && !walk.isExecuted(diagram[branch.output].stmt); // behind a RETURN
        walk.walk(branch.output, isLeftOut ? Power::Unknown : behind);
    }
}

} // namespace plc::ladder
