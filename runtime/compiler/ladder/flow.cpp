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
    FlowWalk(std::string_view text, const Diagram& diagram, const Answers& answers, std::vector<Power>& power)
        : m_text(text), m_diagram(diagram), m_answers(answers), m_power(power) {}

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
            for (const NodeId child : node.children) before = walk(child, before);
            return before;
        case NodeKind::Parallel: {
            Power any = Power::Off;
            for (const NodeId child : node.children) any = either(any, walk(child, before));
            return any;
        }
        case NodeKind::Invert:
            return inverted(walk(node.children[0], before));
        case NodeKind::Box:
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

    std::string_view m_text;
    const Diagram& m_diagram;
    const Answers& m_answers;
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
        return {node.instance + ".Q", {}, nullptr};
    case NodeKind::Box:
        for (const OutputPin& pin : node.outputs)
            if (pin.isFlow && !pin.name.empty() && !node.instance.empty())
                return {node.instance + "." + pin.name, {}, nullptr};
        return node.expr && !node.stmt ? asked(node.expr) : Question();
    default:
        return {};
    }
}

void computeFlow(std::string_view text, const Diagram& diagram, const Rung& rung, const Answers& answers,
                 std::vector<Power>& power) {
    FlowWalk walk(text, diagram, answers, power);
    const Power shared = rung.power.isValid() ? walk.walk(rung.power, Power::On) : Power::On;
    for (const Branch& branch : rung.branches) {
        const Power tail = branch.tail.isValid() ? walk.walk(branch.tail, shared) : shared;
        walk.walk(branch.output, tail);
    }
}

} // namespace plc::ladder
