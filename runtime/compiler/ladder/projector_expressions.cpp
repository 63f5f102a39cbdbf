// Expressions: as contacts on wires (ladder), as boxes and operands (function blocks, and pins in a ladder).
#include "runtime/base/text.h"
#include "runtime/compiler/ladder/projector.h"

#include <algorithm>

namespace plc::ladder {

using lex::TokenKind;
using syntax::Expr;
using syntax::ExprKind;

namespace {

bool isOp(const Expr& expr, TokenKind op) { return expr.kind == ExprKind::Binary && expr.op == op; }

bool isTrue(const Expr& expr) { return expr.kind == ExprKind::Literal && expr.op == TokenKind::True; }

/// Drawn as a contact with an operand on each side.
bool isComparing(const Expr& expr) {
    if (expr.kind != ExprKind::Binary) return false;
    switch (expr.op) {
    case TokenKind::Equal:
    case TokenKind::NotEqual:
    case TokenKind::Less:
    case TokenKind::LessEqual:
    case TokenKind::Greater:
    case TokenKind::GreaterEqual:
    case TokenKind::Xor:
        return true;
    default:
        return false;
    }
}

/// The operators' names as functions (IEC 61131-3, tables 24 to 28).
std::string titleOf(TokenKind op) {
    switch (op) {
    case TokenKind::Plus:
        return "ADD";
    case TokenKind::Minus:
        return "SUB";
    case TokenKind::Star:
        return "MUL";
    case TokenKind::Slash:
        return "DIV";
    case TokenKind::Power:
        return "EXPT";
    case TokenKind::Equal:
        return "EQ";
    case TokenKind::NotEqual:
        return "NE";
    case TokenKind::Less:
        return "LT";
    case TokenKind::LessEqual:
        return "LE";
    case TokenKind::Greater:
        return "GT";
    case TokenKind::GreaterEqual:
        return "GE";
    default:
        return std::string(lex::spelling(op)); // AND, OR, XOR, MOD, AND_THEN, OR_ELSE
    }
}

/// a + b + c is one box with three inputs.
bool takesMoreInputs(TokenKind op) {
    switch (op) {
    case TokenKind::Plus:
    case TokenKind::Star:
    case TokenKind::And:
    case TokenKind::Or:
    case TokenKind::Xor:
    case TokenKind::AndThen:
    case TokenKind::OrElse:
        return true;
    default:
        return false;
    }
}

void gather(const Expr& expr, TokenKind op, std::vector<const Expr*>& out) {
    if (!isOp(expr, op)) {
        out.push_back(&expr);
        return;
    }
    gather(*expr.base, op, out);
    gather(*expr.right, op, out);
}

/// Only to the left: a + (b + c) keeps its order.
void gatherLeft(const Expr& expr, TokenKind op, std::vector<const Expr*>& out) {
    if (isOp(*expr.base, op) && takesMoreInputs(op))
        gatherLeft(*expr.base, op, out);
    else
        out.push_back(expr.base);
    out.push_back(expr.right);
}

} // namespace

bool isLeaf(const Expr& expr) {
    switch (expr.kind) {
    case ExprKind::Unary:
    case ExprKind::Binary:
    case ExprKind::Call:
    case ExprKind::AssignChain:
        return false;
    default:
        return true;
    }
}

/// The power of a rung; none for TRUE: straight from the rail.
NodeId Projector::power(const Expr& expr) {
    if (m_diagram.form == Form::Blocks) return value(expr);
    return isTrue(expr) ? NodeId() : logic(expr, true, true);
}

/// `atRail`: nothing stands to the left of it; `isFirst`: it is what the rung begins with.
NodeId Projector::logic(const Expr& expr, bool atRail, bool isFirst) {
    if (isOp(expr, TokenKind::And) || isOp(expr, TokenKind::AndThen))
        return chain(expr, NodeKind::Series, atRail, isFirst);
    if (isOp(expr, TokenKind::Or) || isOp(expr, TokenKind::OrElse))
        return chain(expr, NodeKind::Parallel, atRail, isFirst);
    if (isNot(expr)) return notOf(expr, atRail);
    if (isComparing(expr)) return compare(expr);
    if (expr.kind == ExprKind::Call && isFirst) return callBox(expr, nullptr, false);
    if (isFirst)
        if (const NodeId waiting = takeWaiting(expr); waiting.isValid()) return waiting;
    if (Watched* watched = watchedBy(expr)) return edgeContact(expr, *watched, false);
    return contact(expr, expr, false);
}

NodeId Projector::chain(const Expr& expr, NodeKind kind, bool atRail, bool isFirst) {
    std::vector<const Expr*> parts;
    gather(expr, expr.op, parts);
    Node node;
    node.kind = kind;
    node.expr = &expr;
    node.range = expr.range;
    node.isShort = expr.op == TokenKind::AndThen || expr.op == TokenKind::OrElse;
    const bool isSeries = kind == NodeKind::Series;
    for (const Expr* part : parts) {
        const bool begins = part == parts.front();
        node.children.push_back(logic(*part, atRail && (!isSeries || begins), isFirst && isSeries && begins));
    }
    return add(std::move(node));
}

NodeId Projector::notOf(const Expr& expr, bool atRail) {
    const Expr& inner = *expr.base;
    if (isLeaf(inner)) {
        if (Watched* watched = watchedBy(inner)) return edgeContact(expr, *watched, true);
        return contact(expr, inner, true);
    }
    if (isComparing(inner)) {
        const NodeId id = compare(inner);
        Node& node = m_diagram.nodes[id.index()];
        node.negated = true;
        node.expr = &expr;
        node.range = expr.range;
        return id;
    }
    // The wire itself can only be inverted where nothing stands to the left of what is inverted.
    if (!atRail) return contact(expr, inner, true);
    Node node;
    node.kind = NodeKind::Invert;
    node.expr = &expr;
    node.range = expr.range;
    node.children.push_back(logic(inner, true, false));
    return add(std::move(node));
}

NodeId Projector::compare(const Expr& expr) {
    Node node;
    node.kind = NodeKind::Compare;
    node.expr = &expr;
    node.operand = expr.base;
    node.right = expr.right;
    node.range = expr.range;
    node.label = plain(*expr.base);
    node.op = std::string(lex::spelling(expr.op));
    node.below = plain(*expr.right);
    return add(std::move(node));
}

NodeId Projector::contact(const Expr& expr, const Expr& operand, bool negated) {
    Node node;
    node.kind = NodeKind::Contact;
    node.expr = &expr;
    node.operand = &operand;
    node.range = expr.range;
    node.negated = negated;
    node.label = plain(operand);
    return add(std::move(node));
}

NodeId Projector::edgeContact(const Expr& expr, Watched& watched, bool negated) {
    watched.isUsed = true;
    Node node;
    node.kind = NodeKind::Edge;
    node.expr = &expr;
    node.operand = watched.clock;
    node.stmt = watched.call;
    node.range = expr.range;
    node.negated = negated;
    node.isFalling = watched.isFalling;
    node.label = plain(*watched.clock);
    node.instance = plain(*watched.call->value->base);
    return add(std::move(node));
}

NodeId Projector::operandNode(const Expr& expr, const Expr& operand, bool negated) {
    Node node;
    node.kind = NodeKind::Operand;
    node.expr = &expr;
    node.operand = &operand;
    node.range = expr.range;
    node.negated = negated;
    node.label = plain(operand);
    return add(std::move(node));
}

/// What stands at a pin of a box: in a ladder a Boolean expression is contacts from the rail.
NodeId Projector::pinValue(const Expr& expr) {
    if (m_diagram.form == Form::Ladder) {
        const bool isChain = isOp(expr, TokenKind::And) || isOp(expr, TokenKind::Or) ||
                             isOp(expr, TokenKind::AndThen) || isOp(expr, TokenKind::OrElse) ||
                             (isNot(expr) && !isLeaf(*expr.base));
        if (isChain && m_types.isBool(expr, m_scope) != DeclaredTypes::Truth::No) return logic(expr, true, false);
    }
    return value(expr);
}

NodeId Projector::value(const Expr& expr) {
    if (expr.kind == ExprKind::Binary) return operatorBox(expr);
    if (expr.kind == ExprKind::Call) return callBox(expr, nullptr, false);
    if (expr.kind == ExprKind::Unary && !isLeaf(*expr.base)) {
        const NodeId inner = value(*expr.base);
        if (expr.op == TokenKind::Plus) return inner;
        if (expr.op == TokenKind::Not && m_diagram[inner].kind == NodeKind::Box) {
            m_diagram.nodes[inner.index()].negated = !m_diagram[inner].negated;
            m_diagram.nodes[inner.index()].expr = &expr;
            m_diagram.nodes[inner.index()].range = expr.range;
            return inner;
        }
        Node node;
        node.kind = NodeKind::Box;
        node.expr = &expr;
        node.range = expr.range;
        node.label = expr.op == TokenKind::Not ? "NOT" : "NEG";
        node.inputs.push_back({"", inner, false, expr.base->range});
        node.outputs.push_back({"", "", false, true, {}});
        return add(std::move(node));
    }
    if (isNot(expr)) return operandNode(expr, *expr.base, true);
    if (m_diagram.form == Form::Blocks)
        if (const NodeId waiting = takeWaiting(expr); waiting.isValid()) return waiting;
    return operandNode(expr, expr, false);
}

NodeId Projector::operatorBox(const Expr& expr) {
    std::vector<const Expr*> parts;
    gatherLeft(expr, expr.op, parts);
    Node node;
    node.kind = NodeKind::Box;
    node.expr = &expr;
    node.range = expr.range;
    node.label = titleOf(expr.op);
    node.isShort = expr.op == TokenKind::AndThen || expr.op == TokenKind::OrElse;
    for (const Expr* part : parts) node.inputs.push_back({"", pinValue(*part), false, part->range});
    node.outputs.push_back({"", "", false, true, {}});
    return add(std::move(node));
}

/// The block that was called just before, when `leaf` is one of its outputs: the wire goes on from that pin.
NodeId Projector::takeWaiting(const Expr& leaf) {
    if (!m_waiting || m_waiting->isUsed || leaf.kind != ExprKind::Member) return {};
    if (folded(leaf.base->range) != m_waiting->instance) return {};
    Node& box = m_diagram.nodes[m_waiting->box.index()];
    m_waiting->isUsed = true;
    const auto same = std::find_if(box.outputs.begin(), box.outputs.end(), [&](const OutputPin& pin) {
        return equalsIgnoringCase(pin.name, leaf.name.text) && !pin.negated;
    });
    OutputPin pin{std::string(leaf.name.text), {}, false, true, leaf.range, leaf.range};
    if (same != box.outputs.end()) {
        pin.target = same->target;
        box.outputs.erase(same);
    }
    box.outputs.insert(box.outputs.begin(), std::move(pin));
    return m_waiting->chain;
}

Projector::Watched* Projector::watchedBy(const Expr& leaf) {
    if (leaf.kind != ExprKind::Member || m_watched.empty()) return nullptr;
    const std::string text = folded(leaf.range);
    for (Watched& watched : m_watched)
        if (watched.output == text) return &watched;
    return nullptr;
}

} // namespace plc::ladder
