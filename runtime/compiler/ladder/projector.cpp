// Statements: which ones make a rung together, which ones frame others, and the comments that belong to them.
#include "runtime/compiler/ladder/projector.h"

#include "runtime/base/chars.h"
#include "runtime/base/text.h"

#include <algorithm>

namespace plc::ladder {

using lex::TokenKind;
using syntax::Expr;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::StmtKind;

namespace {

std::string firstLine(std::string_view text) {
    const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
    const size_t begin = line.find_first_not_of(" \t/");
    return begin == std::string_view::npos ? std::string() : std::string(line.substr(begin));
}

bool containsCall(const Expr* expr) {
    if (!expr) return false;
    if (expr->kind == ExprKind::Call || containsCall(expr->base) || containsCall(expr->right)) return true;
    return std::any_of(expr->arguments.begin(), expr->arguments.end(),
                       [](const syntax::Argument& a) { return containsCall(a.value); });
}

std::string_view rootName(const Expr* place) {
    while (place && place->base) place = place->base;
    return place ? place->name.text : std::string_view();
}

} // namespace

void andParts(const Expr& expr, std::vector<const Expr*>& out) {
    if (expr.kind != ExprKind::Binary || expr.op != TokenKind::And) {
        out.push_back(&expr);
        return;
    }
    andParts(*expr.base, out);
    andParts(*expr.right, out);
}

Share& Share::operator+=(const Share& other) {
    drawn += other.drawn;
    framed += other.framed;
    text += other.text;
    return *this;
}

std::string unparenthesised(std::string text) {
    for (;;) {
        if (text.size() < 2 || text.front() != '(' || text.back() != ')') return text;
        int depth = 0;
        for (size_t i = 0; i + 1 < text.size(); ++i) {
            depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
            if (depth == 0) return text;
        }
        text = text.substr(1, text.size() - 2);
        while (!text.empty() && text.front() == ' ') text.erase(0, 1);
        while (!text.empty() && text.back() == ' ') text.pop_back();
    }
}

Diagram project(std::string_view text, const syntax::SyntaxFile& file, const Unit& unit, const DeclaredTypes& types,
                Form form) {
    return Projector(text, file, unit, types, form).run();
}

Projector::Projector(std::string_view text, const syntax::SyntaxFile& file, const Unit& unit,
                     const DeclaredTypes& types, Form form)
    : m_text(text), m_file(file), m_unit(unit), m_types(types), m_scope{unit.pou, unit.owner} {
    m_diagram.form = form;
}

Diagram Projector::run() {
    if (!m_unit.body) return std::move(m_diagram);
    const syntax::Body& body = *m_unit.body;
    constexpr uint32_t kTextOfANode = 16; // about; nodes are large, so that growing by copies costs
    m_diagram.nodes.reserve(body.range.length() / kTextOfANode);
    if (body.language == syntax::BodyLanguage::St) {
        uint32_t begin = body.range.begin;
        // the comment above the first statement belongs to it
        for (const lex::Token& token : m_file.tokens.tokens)
            if (token.end <= body.range.begin && token.kind != TokenKind::Pragma)
                begin = token.end;
            else if (token.begin >= body.range.begin)
                break;
        block(body.statements, 0, begin, std::max(m_unit.range.end, body.range.end));
    } else if (body.language != syntax::BodyLanguage::None) {
        Rung& rung = addRung(RungKind::Text, 0);
        rung.range = body.range;
        rung.text = std::string(m_text.substr(body.range.begin, body.range.length()));
        m_diagram.share.text += std::max<size_t>(1, body.statements.size());
    }
    std::vector<std::vector<NodeId>> nodes;
    nodes.reserve(m_diagram.rungs.size());
    for (const Rung& rung : m_diagram.rungs) nodes.push_back(m_diagram.nodesOf(rung));
    markReads(nodes);
    numberBoxes(nodes);
    describeVariables();
    return std::move(m_diagram);
}

/// What the declaration says of each operand.
void Projector::describeVariables() {
    for (Node& node : m_diagram.nodes) {
        if (!node.operand || node.operand->kind == ExprKind::Literal) continue;
        const syntax::VarDecl* variable = m_types.declarationOf(*node.operand, m_scope);
        if (!variable) continue;
        node.comment = firstLine(variable->comment);
        if (variable->names.empty() || equalsIgnoringCase(variable->names.front().text, node.operand->name.text))
            node.address = std::string(variable->address);
    }
}

Rung& Projector::addRung(RungKind kind, int depth) {
    Rung rung;
    rung.kind = kind;
    rung.depth = depth;
    m_diagram.rungs.push_back(std::move(rung));
    return m_diagram.rungs.back();
}

NodeId Projector::add(Node node) {
    m_diagram.nodes.push_back(std::move(node));
    return NodeId(m_diagram.nodes.size() - 1);
}

std::string Projector::slice(SourceRange range) const {
    return std::string(m_text.substr(range.begin, range.length()));
}

std::string Projector::plain(const Expr& expr) const {
    std::string out;
    for (const char c : slice(expr.range)) {
        if (!isBlank(c))
            out += c;
        else if (!out.empty() && out.back() != ' ')
            out += ' ';
    }
    return unparenthesised(std::move(out));
}

std::string Projector::folded(SourceRange range) const {
    std::string out;
    bool hasGap = false;
    for (const char c : slice(range)) {
        if (isBlank(c)) {
            hasGap = true;
            continue;
        }
        if (hasGap && !out.empty() && isNameByte(out.back()) && isNameByte(c)) out += ' '; // NOT e is not note
        hasGap = false;
        out += c;
    }
    return foldCase(out);
}

// ---------------------------------------------------------------- rungs

/// An empty line, a comment on a line of its own or a pragma keeps two statements in rungs of their own.
bool Projector::areNeighbours(const Stmt& first, const Stmt& second) const {
    const std::string_view between =
        m_text.substr(first.range.end, second.range.begin - std::min(second.range.begin, first.range.end));
    return std::count(between.begin(), between.end(), '\n') < 2 && between.find('{') == std::string_view::npos;
}

bool Projector::isInstanceCall(const Stmt& stmt) const {
    if (stmt.kind != StmtKind::Call || !stmt.value || stmt.value->kind != ExprKind::Call) return false;
    const Expr& base = *stmt.value->base;
    if (base.kind != ExprKind::NameRef && base.kind != ExprKind::Member && base.kind != ExprKind::Index) return false;
    const syntax::Pou* callee = m_types.calleeOf(base, m_scope);
    if (callee) return callee->kind == syntax::PouKind::FunctionBlock || callee->kind == syntax::PouKind::Program;
    return std::any_of(stmt.value->arguments.begin(), stmt.value->arguments.end(),
                       [](const syntax::Argument& a) { return a.kind == syntax::ArgumentKind::Input; });
}

namespace {

/// What a rung of this power begins with, as Projector::logic walks.
const Expr* firstLeaf(const Expr* expr) {
    while (expr && expr->kind == ExprKind::Binary && (expr->op == TokenKind::And || expr->op == TokenKind::AndThen))
        expr = expr->base;
    return expr;
}

/// Whether a leaf with this text becomes a contact, as Projector::logic walks.
template <class Same> bool reachesContact(const Expr& expr, const Same& same) {
    if (expr.kind == ExprKind::Binary && (expr.op == TokenKind::And || expr.op == TokenKind::Or ||
                                          expr.op == TokenKind::AndThen || expr.op == TokenKind::OrElse))
        return reachesContact(*expr.base, same) || reachesContact(*expr.right, same);
    if (expr.kind == ExprKind::Unary && expr.op == TokenKind::Not) return isLeaf(*expr.base) && same(*expr.base);
    return same(expr);
}

/// The first leaf with this text where Projector::value walks.
template <class Same> bool reachesPin(const Expr& expr, const Same& same) {
    switch (expr.kind) {
    case ExprKind::Binary:
        return reachesPin(*expr.base, same) || reachesPin(*expr.right, same);
    case ExprKind::Unary:
        return !isLeaf(*expr.base) && reachesPin(*expr.base, same);
    case ExprKind::Call:
        return std::any_of(expr.arguments.begin(), expr.arguments.end(), [&](const syntax::Argument& a) {
            return a.kind != syntax::ArgumentKind::Output && a.value && reachesPin(*a.value, same);
        });
    default:
        return same(expr);
    }
}

} // namespace

bool Projector::usesOutput(const Stmt& stmt, const std::string& output) const {
    const Expr* power = powerOf(stmt);
    return power && reachesContact(*power, [&](const Expr& leaf) { return folded(leaf.range) == output; });
}

bool Projector::beginsWithWaiting(const Stmt& stmt) const {
    const auto isOutput = [&](const Expr& leaf) {
        return leaf.kind == ExprKind::Member && folded(leaf.base->range) == m_waiting->instance;
    };
    if (m_diagram.form == Form::Ladder) {
        const Expr* leaf = firstLeaf(powerOf(stmt));
        return leaf && isOutput(*leaf);
    }
    if (stmt.kind == StmtKind::If) return reachesPin(*stmt.branches[0].condition, isOutput);
    if (stmt.kind == StmtKind::Assign || stmt.kind == StmtKind::Call) return reachesPin(*stmt.value, isOutput);
    return false;
}

/// trig(CLK := x);  y := trig.Q AND …;
void Projector::takeEdges(const syntax::Block& block, size_t& at, Rung& rung) {
    m_watched.clear();
    if (m_diagram.form != Form::Ladder) return;
    size_t end = at;
    std::vector<Watched> found;
    for (; end < block.size(); ++end) {
        const Stmt& stmt = *block[end];
        if (end > at && !areNeighbours(*block[end - 1], stmt)) return;
        if (stmt.kind != StmtKind::Call || stmt.value->kind != ExprKind::Call) break;
        const Expr& call = *stmt.value;
        const syntax::Pou* callee = m_types.calleeOf(*call.base, m_scope);
        if (!callee || call.arguments.size() != 1 || !call.arguments[0].value || !isLeaf(*call.arguments[0].value))
            break;
        const bool isRising = equalsIgnoringCase(callee->name.text, "R_TRIG");
        if ((!isRising && !equalsIgnoringCase(callee->name.text, "F_TRIG")) ||
            call.arguments[0].kind == syntax::ArgumentKind::Output)
            break;
        found.push_back({&stmt, call.arguments[0].value, folded(call.base->range) + ".q", !isRising, false});
    }
    if (found.empty() || end >= block.size()) return;
    const Stmt& user = *block[end];
    if (!isLogic(user) ||
        !std::all_of(found.begin(), found.end(), [&](const Watched& w) { return usesOutput(user, w.output); }))
        return;
    for (const Watched& watched : found) rung.statements.push_back(watched.call);
    m_watched = std::move(found);
    at = end;
}

void Projector::fill(Rung& rung, const Stmt& stmt) {
    if (stmt.kind == StmtKind::If) {
        rung.power = power(*stmt.branches[0].condition);
        for (const Stmt* inner : stmt.branches[0].body) outputsOf(*inner, rung.branches, true);
        return;
    }
    const bool isBlocks = m_diagram.form == Form::Blocks;
    if (isBoolAssignment(stmt) || (isBlocks && stmt.kind == StmtKind::Assign)) {
        const Expr* asked = powerOf(stmt);
        const Expr* last = stmt.value;
        while (last->kind == ExprKind::AssignChain) last = last->right;
        rung.power = isBlocks ? value(*last) : power(*asked);
        coils(stmt, rung.branches);
        return;
    }
    outputsOf(stmt, rung.branches, false);
}

/// From `at`: edge detectors, calls and what begins with their outputs, then coils behind the same contacts.
size_t Projector::logicRung(const syntax::Block& block, size_t at, int depth) {
    Rung rung;
    rung.depth = depth;
    const uint32_t floor = m_floor;
    m_waiting.reset();
    takeEdges(block, at, rung);
    const auto neighbour = [&](size_t i) -> const Stmt* {
        return i < block.size() && isLogic(*block[i]) && areNeighbours(*block[i - 1], *block[i]) ? block[i] : nullptr;
    };
    const Stmt* stmt = block[at];
    while (isInstanceCall(*stmt)) {
        rung.statements.push_back(stmt);
        const Expr* argument = m_diagram.form == Form::Ladder ? powerArgument(*stmt->value) : nullptr;
        const NodeId before = argument ? power(*argument) : NodeId();
        const NodeId box = callBox(*stmt->value, stmt, false);
        NodeId chain = box;
        if (before.isValid()) {
            Node series;
            series.kind = NodeKind::Series;
            series.range = m_diagram[box].range;
            series.children = {before, box};
            chain = add(std::move(series));
        }
        ++at;
        if (m_waiting && !m_waiting->isUsed) rung.branches.push_back({{}, m_waiting->chain});
        m_waiting = Waiting{box, chain, folded(stmt->value->base->range), false};
        // t := timer.ET; is the pin's target
        while (const Stmt* next = neighbour(at)) {
            if (next->kind != StmtKind::Assign || next->op != TokenKind::Assign ||
                next->value->kind != ExprKind::Member || isBoolAssignment(*next) ||
                folded(next->value->base->range) != m_waiting->instance)
                break;
            m_diagram.nodes[box.index()].outputs.push_back({std::string(next->value->name.text), plain(*next->target),
                                                            false, false, next->range, next->value->range});
            rung.statements.push_back(next);
            ++at;
        }
        const Stmt* next = neighbour(at);
        if (!next || !beginsWithWaiting(*next)) {
            m_waiting.reset();
            rung.power = before;
            rung.branches.push_back({{}, box});
            stmt = nullptr;
            break;
        }
        stmt = next;
    }
    if (stmt) {
        rung.statements.push_back(stmt);
        fill(rung, *stmt);
        if (m_waiting && !m_waiting->isUsed) rung.branches.insert(rung.branches.begin(), {{}, m_waiting->chain});
        ++at;
        m_prefix.clear();
        if (const Expr* asked = powerOf(*stmt)) andParts(*asked, m_prefix);
        m_isShared = false;
        while (const Stmt* next = neighbour(at)) {
            if (!joins(rung, *next)) break;
            rung.statements.push_back(next);
            ++at;
        }
    }
    m_waiting.reset();
    m_watched.clear();
    rung.range = joined(rung.statements.front()->range, rung.statements.back()->range);
    for (const Stmt* each : rung.statements) m_diagram.share.drawn += countStatements(*each);
    annotate(rung, floor);
    m_diagram.rungs.push_back(std::move(rung));
    return at;
}

bool Projector::writesInto(const std::vector<const Stmt*>& statements, const std::string& reads) const {
    const auto reads_ = [&](std::string_view name) {
        const std::string wanted = foldCase(name);
        for (size_t at = reads.find(wanted); at != std::string::npos && !wanted.empty();
             at = reads.find(wanted, at + 1)) {
            const bool begins = at == 0 || !isNameByte(reads[at - 1]);
            const bool ends = at + wanted.size() >= reads.size() || !isNameByte(reads[at + wanted.size()]);
            if (begins && ends) return true;
        }
        return false;
    };
    const auto writes = [&](const auto& self, const Stmt& stmt) -> bool {
        if (stmt.kind == StmtKind::Call) return true; // whoever is called may write anything
        if (stmt.target && (reads_(rootName(stmt.target)) || containsCall(stmt.target))) return true;
        for (const Expr* at = stmt.value; at; at = at->kind == ExprKind::AssignChain ? at->right : nullptr)
            if (at->kind == ExprKind::AssignChain && reads_(rootName(at->base))) return true;
        if (containsCall(stmt.value)) return true;
        for (const syntax::IfBranch& branch : stmt.branches)
            for (const Stmt* inner : branch.body)
                if (self(self, *inner)) return true;
        return false;
    };
    return std::any_of(statements.begin(), statements.end(), [&](const Stmt* s) { return writes(writes, *s); });
}

/// A statement behind the same contacts branches off after them, when nothing of what they read is written in between.
bool Projector::joins(Rung& rung, const Stmt& stmt) {
    const Expr* asked = powerOf(stmt);
    if (m_diagram.form != Form::Ladder || !asked || m_prefix.empty() || stmt.kind == StmtKind::Call) return false;
    std::vector<const Expr*> parts;
    andParts(*asked, parts);
    size_t shared = 0;
    std::string reads;
    while (shared < parts.size() && shared < m_prefix.size()) {
        const std::string text = unparenthesised(folded(parts[shared]->range));
        if (text != unparenthesised(folded(m_prefix[shared]->range)) || containsCall(parts[shared])) break;
        if (parts[shared]->kind == ExprKind::Literal) break;
        reads += text + " ";
        ++shared;
    }
    if (shared == 0 || (m_isShared && shared < m_prefix.size())) return false;
    std::vector<const Stmt*> writers;
    for (const Stmt* each : rung.statements)
        if (each->kind != StmtKind::Call) writers.push_back(each); // calls come before what reads them
    if (writesInto(writers, reads)) return false;
    const bool splits = !m_isShared && shared < m_prefix.size();
    if (splits && (rung.branches.size() != 1 || !rung.power.isValid() ||
                   m_diagram[rung.power].children.size() != m_prefix.size()))
        return false;
    const bool isIf = stmt.kind == StmtKind::If;
    if (shared < parts.size() && (isIf ? stmt.branches[0].body.size() > 1 : stmt.value->kind == ExprKind::AssignChain))
        return false; // several outputs behind contacts of their own
    const auto series = [&](std::vector<NodeId> children) {
        if (children.empty()) return NodeId();
        if (children.size() == 1) return children[0];
        Node node;
        node.kind = NodeKind::Series;
        node.range = joined(m_diagram[children.front()].range, m_diagram[children.back()].range);
        node.children = std::move(children);
        return add(std::move(node));
    };
    if (splits) {
        const std::vector<NodeId> all = m_diagram[rung.power].children; // one each, as chain() made them
        const auto cut = all.begin() + static_cast<std::ptrdiff_t>(shared);
        rung.branches[0].tail = series({cut, all.end()});
        rung.power = series({all.begin(), cut});
        m_prefix.resize(shared);
    }
    m_isShared = true;
    std::vector<NodeId> rest;
    for (size_t i = shared; i < parts.size(); ++i) rest.push_back(logic(*parts[i], false, false));
    std::vector<Branch> more;
    if (isIf) {
        for (const Stmt* inner : stmt.branches[0].body) outputsOf(*inner, more, true);
    } else {
        coils(stmt, more);
    }
    more[0].tail = series(std::move(rest));
    rung.branches.insert(rung.branches.end(), more.begin(), more.end());
    return true;
}

} // namespace plc::ladder
