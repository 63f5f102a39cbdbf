// What the power drives: coils, assignments and calls as boxes, jumps and returns.
#include "runtime/base/text.h"
#include "runtime/compiler/ladder/projector.h"

#include <algorithm>

namespace plc::ladder {

using lex::TokenKind;
using syntax::Expr;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::StmtKind;
using Truth = DeclaredTypes::Truth;

namespace {

const Expr& lastValue(const Expr& value) {
    const Expr* at = &value;
    while (at->kind == ExprKind::AssignChain) at = at->right;
    return *at;
}

/// In the order in which they are written: the innermost of a := b := c first.
std::vector<const Expr*> targetsOf(const Stmt& stmt) {
    std::vector<const Expr*> out{stmt.target};
    for (const Expr* at = stmt.value; at->kind == ExprKind::AssignChain; at = at->right) out.push_back(at->base);
    std::reverse(out.begin(), out.end());
    return out;
}

bool looksLogical(const Expr& expr) {
    if (expr.kind == ExprKind::Unary) return expr.op == TokenKind::Not;
    return expr.kind == ExprKind::Binary && (expr.op == TokenKind::And || expr.op == TokenKind::Or);
}

constexpr std::string_view kPowerFormals[] = {"en", "in", "clk", "cu", "cd", "s1", "s", "set", "execute", "enable"};

} // namespace

bool Projector::isBoolAssignment(const Stmt& stmt) const {
    if (stmt.kind != StmtKind::Assign || !stmt.target || !stmt.value) return false;
    if (stmt.op == TokenKind::SetAssign || stmt.op == TokenKind::ResetAssign) return true;
    if (stmt.op != TokenKind::Assign) return false;
    for (const Expr* at = stmt.value; at->kind == ExprKind::AssignChain; at = at->right)
        if (at->op != TokenKind::Assign) return false;
    const Expr& value = lastValue(*stmt.value);
    const Truth target = m_types.isBool(*stmt.target, m_scope);
    if (target != Truth::Unknown) return target == Truth::Yes;
    const Truth type = m_types.isBool(value, m_scope);
    return type == Truth::Yes || (type == Truth::Unknown && looksLogical(value));
}

/// What a statement asks before it writes; null when it always does.
const Expr* Projector::powerOf(const Stmt& stmt) const {
    if (stmt.kind == StmtKind::If) return stmt.branches.front().condition;
    if (stmt.kind == StmtKind::Call) return stmt.value->kind == ExprKind::Call ? powerArgument(*stmt.value) : nullptr;
    if (!isBoolAssignment(stmt)) return nullptr;
    const Expr& value = lastValue(*stmt.value);
    // y := NOT (e): a negated coil
    const bool negated = stmt.op == TokenKind::Assign && value.kind == ExprKind::Unary && value.op == TokenKind::Not &&
                         value.base->parenthesised && !value.parenthesised;
    return negated ? value.base : &value;
}

void Projector::coils(const Stmt& stmt, std::vector<Branch>& out) {
    const Expr& value = lastValue(*stmt.value);
    for (const Expr* target : targetsOf(stmt)) {
        Node node;
        node.kind = NodeKind::Coil;
        node.operand = target;
        node.stmt = &stmt;
        node.range = target->range;
        node.label = plain(*target);
        node.coil = stmt.op == TokenKind::SetAssign                             ? CoilKind::Set
                    : stmt.op == TokenKind::ResetAssign                         ? CoilKind::Reset
                    : m_diagram.form == Form::Ladder && powerOf(stmt) != &value ? CoilKind::Negated
                                                                                : CoilKind::Normal;
        out.push_back({{}, add(std::move(node))});
    }
}

/// y := TRUE under a condition is a set coil, y := FALSE a reset coil.
NodeId Projector::conditionalCoil(const Stmt& stmt, bool on) {
    Node node;
    node.kind = NodeKind::Coil;
    node.operand = stmt.target;
    node.stmt = &stmt;
    node.range = stmt.range;
    node.label = plain(*stmt.target);
    node.coil = on ? CoilKind::Set : CoilKind::Reset;
    node.isConditional = true;
    return add(std::move(node));
}

/// A number, text, structure or reference: the last operator or function writes, or a MOVE.
NodeId Projector::assignBox(const Stmt& stmt, bool hasPower) {
    const Expr& value = lastValue(*stmt.value);
    const bool isPlain = stmt.op == TokenKind::Assign;
    NodeId root;
    if (isPlain && (value.kind == ExprKind::Binary || value.kind == ExprKind::Call)) root = this->value(value);
    if (!root.isValid() || m_diagram[root].kind != NodeKind::Box) {
        const NodeId operand = root.isValid() ? root : pinValue(value);
        Node node;
        node.kind = NodeKind::Box;
        node.label = isPlain ? "MOVE" : std::string(lex::spelling(stmt.op));
        node.inputs.push_back({"", operand, false, value.range});
        root = add(std::move(node));
    }
    Node& box = m_diagram.nodes[root.index()];
    box.stmt = &stmt;
    box.range = stmt.range;
    if (m_diagram.form == Form::Ladder || hasPower) box.inputs.insert(box.inputs.begin(), {"EN", {}, false, {}, true});
    box.outputs.erase(std::remove_if(box.outputs.begin(), box.outputs.end(),
                                     [](const OutputPin& pin) { return pin.isFlow && pin.name.empty(); }),
                      box.outputs.end());
    size_t at = 0;
    for (const Expr* target : targetsOf(stmt))
        box.outputs.insert(box.outputs.begin() + static_cast<std::ptrdiff_t>(at++),
                           {"", plain(*target), box.negated, false, target->range, value.range});
    return root;
}

NodeId Projector::control(const Stmt& stmt) {
    Node node;
    node.stmt = &stmt;
    node.range = stmt.range;
    node.kind = stmt.kind == StmtKind::Jump       ? NodeKind::Jump
                : stmt.kind == StmtKind::Exit     ? NodeKind::Exit
                : stmt.kind == StmtKind::Continue ? NodeKind::Continue
                                                  : NodeKind::Return;
    if (stmt.kind == StmtKind::Jump) node.label = std::string(stmt.name.text);
    if (stmt.kind == StmtKind::Return && stmt.value) node.label = plain(*stmt.value);
    return add(std::move(node));
}

void Projector::outputsOf(const Stmt& stmt, std::vector<Branch>& out, bool hasPower) {
    switch (stmt.kind) {
    case StmtKind::Assign: {
        const bool isConstant = stmt.value->kind == ExprKind::Literal &&
                                (stmt.value->op == TokenKind::True || stmt.value->op == TokenKind::False);
        if (hasPower && stmt.op == TokenKind::Assign && isConstant && isBoolAssignment(stmt)) {
            out.push_back({{}, conditionalCoil(stmt, stmt.value->op == TokenKind::True)});
        } else {
            out.push_back({{}, assignBox(stmt, hasPower)});
        }
        return;
    }
    case StmtKind::Call:
        if (stmt.value->kind == ExprKind::Call) {
            out.push_back({{}, callBox(*stmt.value, &stmt, hasPower)});
        } else { // an action without parentheses
            Node node;
            node.kind = NodeKind::Box;
            node.stmt = &stmt;
            node.range = stmt.range;
            node.label = plain(*stmt.value);
            node.inputs.push_back({"EN", {}, false, {}, true});
            out.push_back({{}, add(std::move(node))});
        }
        return;
    case StmtKind::Jump:
    case StmtKind::Return:
    case StmtKind::Exit:
    case StmtKind::Continue:
        out.push_back({{}, control(stmt)});
        return;
    default:
        return;
    }
}

bool Projector::isPowerFormal(const Expr& call, const syntax::Argument& argument, size_t index) const {
    if (const syntax::Pou* callee = m_types.calleeOf(*call.base, m_scope)) {
        size_t number = 0;
        for (const syntax::VarSection* section : callee->sections) {
            if (section->kind != syntax::SectionKind::Input && section->kind != syntax::SectionKind::InOut) continue;
            for (const syntax::VarDecl* variable : section->declarations)
                for (const syntax::Name& name : variable->names) {
                    const bool isIt =
                        argument.name.isValid() ? equalsIgnoringCase(name.text, argument.name.text) : number == index;
                    if (isIt) return section->kind == syntax::SectionKind::Input && m_types.isBoolType(variable->type);
                    ++number;
                }
        }
    }
    const std::string name = foldCase(argument.name.text);
    return std::any_of(std::begin(kPowerFormals), std::end(kPowerFormals),
                       [&](std::string_view formal) { return formal == name; }) &&
           argument.value && m_types.isBool(*argument.value, m_scope) != Truth::No;
}

/// The first input of a call when it is a BOOL: the wire from the left ends in it.
const Expr* Projector::powerArgument(const Expr& call) const {
    for (size_t i = 0; i < call.arguments.size(); ++i) {
        const syntax::Argument& argument = call.arguments[i];
        if (argument.kind == syntax::ArgumentKind::Output) continue;
        return argument.value && isPowerFormal(call, argument, i) ? argument.value : nullptr;
    }
    return nullptr;
}

/// `stmt`: a call for itself; null: a function in an expression. `hasPower`: a wire leads to its EN.
NodeId Projector::callBox(const Expr& call, const Stmt* stmt, bool hasPower) {
    const syntax::Pou* callee = m_types.calleeOf(*call.base, m_scope);
    const bool isBlock = callee &&
                         (callee->kind == syntax::PouKind::FunctionBlock || callee->kind == syntax::PouKind::Program) &&
                         !equalsIgnoringCase(plain(*call.base), callee->name.text);
    Node box;
    box.kind = NodeKind::Box;
    box.expr = &call;
    box.stmt = stmt;
    box.range = stmt ? stmt->range : call.range;
    box.label = isBlock ? std::string(callee->name.text) : plain(*call.base);
    if (isBlock) box.instance = plain(*call.base);
    const bool isLadder = m_diagram.form == Form::Ladder;
    const Expr* power = isLadder && stmt && !hasPower ? powerArgument(call) : nullptr;
    if (hasPower || (isLadder && stmt && !power)) box.inputs.push_back({"EN", {}, false, {}, true});
    addArguments(box, call, callee, power);
    if (!stmt) box.outputs.insert(box.outputs.begin(), {"", "", false, true, {}});
    return add(std::move(box));
}

void Projector::addArguments(Node& box, const Expr& call, const syntax::Pou* callee, const Expr* power) {
    std::vector<std::string_view> formals;
    if (callee)
        for (const syntax::VarSection* section : callee->sections)
            if (section->kind == syntax::SectionKind::Input || section->kind == syntax::SectionKind::InOut)
                for (const syntax::VarDecl* variable : section->declarations)
                    for (const syntax::Name& name : variable->names) formals.push_back(name.text);
    for (size_t i = 0; i < call.arguments.size(); ++i) {
        const syntax::Argument& argument = call.arguments[i];
        std::string name(argument.name.text);
        if (name.empty() && i < formals.size()) name = std::string(formals[i]);
        if (argument.kind == syntax::ArgumentKind::Output) {
            box.outputs.push_back({std::move(name), argument.value ? plain(*argument.value) : std::string(),
                                   argument.negated, false, argument.range});
            continue;
        }
        const bool isPower = power && argument.value == power;
        const NodeId node = isPower || !argument.value ? NodeId() : pinValue(*argument.value);
        box.inputs.push_back({std::move(name), node, argument.negated, argument.range, isPower});
    }
}

} // namespace plc::ladder
