// Contacts and coils.
#include "runtime/compiler/ladder/edits.h"

#include "runtime/base/messages.h"
#include "runtime/base/text.h"
#include "runtime/compiler/ladder/projector.h"
#include "runtime/compiler/parse/parser.h"

#include <algorithm>

namespace plc::ladder {

using lex::TokenKind;
using syntax::Expr;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::StmtKind;

namespace {

constexpr int kOr = 1, kAnd = 3, kNot = 9;

int levelOf(const Expr& expr) {
    if (expr.kind == ExprKind::Binary && !expr.parenthesised) return lex::precedenceOf(expr.op);
    return kNot;
}

bool isPlace(const Expr& expr) {
    switch (expr.kind) {
    case ExprKind::NameRef:
    case ExprKind::Member:
    case ExprKind::Index:
    case ExprKind::Deref:
    case ExprKind::Bit:
    case ExprKind::Address:
        return true;
    default:
        return false;
    }
}

const Expr* findParent(const Expr* at, const Expr& wanted) {
    if (!at) return nullptr;
    const auto look = [&](const Expr* child) -> const Expr* {
        if (child == &wanted) return at;
        return findParent(child, wanted);
    };
    if (const Expr* found = look(at->base)) return found;
    if (const Expr* found = look(at->right)) return found;
    for (const syntax::Argument& argument : at->arguments)
        if (const Expr* found = look(argument.value)) return found;
    return nullptr;
}

void rootsOf(const Stmt& stmt, std::vector<const Expr*>& out) {
    for (const Expr* expr : {stmt.target, stmt.value, stmt.from, stmt.to, stmt.by})
        if (expr) out.push_back(expr);
    for (const syntax::IfBranch& branch : stmt.branches) {
        if (branch.condition) out.push_back(branch.condition);
        for (const Stmt* inner : branch.body) rootsOf(*inner, out);
    }
}

/// The expression with exactly this text; the outer one of a parenthesised pair.
const Expr* findExact(const Expr* expr, SourceRange range) {
    if (!expr || range.begin < expr->range.begin || expr->range.end < range.end) return nullptr;
    if (expr->range.begin == range.begin && expr->range.end == range.end) return expr;
    for (const Expr* inner : {expr->base, expr->right})
        if (const Expr* found = findExact(inner, range)) return found;
    for (const syntax::Argument& argument : expr->arguments)
        if (const Expr* found = findExact(argument.value, range)) return found;
    return nullptr;
}

void everyStatement(const syntax::Block& block, std::vector<const Stmt*>& out) {
    for (const Stmt* stmt : block) {
        out.push_back(stmt);
        for (const syntax::IfBranch& branch : stmt->branches) everyStatement(branch.body, out);
        for (const syntax::CaseArm& arm : stmt->arms) everyStatement(arm.body, out);
        everyStatement(stmt->body, out);
        everyStatement(stmt->elseBody, out);
    }
}

/// The part of `there` that stands where `wanted` stands in `here`, an expression of the same words.
const Expr* counterpart(const Expr* here, const Expr* there, const Expr& wanted) {
    if (!here || !there) return nullptr;
    if (here == &wanted) return there;
    if (const Expr* found = counterpart(here->base, there->base, wanted)) return found;
    if (const Expr* found = counterpart(here->right, there->right, wanted)) return found;
    for (size_t i = 0; i < here->arguments.size() && i < there->arguments.size(); ++i)
        if (const Expr* found = counterpart(here->arguments[i].value, there->arguments[i].value, wanted)) return found;
    return nullptr;
}

} // namespace

/// The text between the parentheses around an expression.
SourceRange innerRange(const Expr& expr, std::string_view text) {
    SourceRange range = expr.range;
    if (!expr.parenthesised) return range;
    const auto blank = [&](uint32_t at) {
        return text[at] == ' ' || text[at] == '\t' || text[at] == '\n' || text[at] == '\r';
    };
    // one pair; what stays of ((a)) stays in its own
    ++range.begin, --range.end;
    while (range.begin < range.end && blank(range.begin)) ++range.begin;
    while (range.end > range.begin && blank(range.end - 1)) --range.end;
    return range;
}

LadderEditor::LadderEditor(std::string_view text, const syntax::SyntaxFile& file, const Unit& unit,
                           const Diagram& diagram, const DeclaredTypes& types)
    : m_text(text), m_file(file), m_unit(unit), m_diagram(diagram), m_types(types) {}

Result<Edits> LadderEditor::finish(Edits edits) {
    std::sort(edits.begin(), edits.end(), [](const TextEdit& a, const TextEdit& b) {
        return a.range.begin != b.range.begin ? a.range.begin < b.range.begin : a.range.end < b.range.end;
    });
    for (size_t i = 1; i < edits.size(); ++i)
        if (edits[i].range.begin < edits[i - 1].range.end) return Error{errors::EditInTextOnly(), {}};
    return edits;
}

/// An expression as a user types it, read once to know that it is one and how tightly it binds.
Result<LadderEditor::Operand> LadderEditor::parsed(std::string_view operand) const {
    std::string text(operand);
    while (!text.empty() && text.back() == ' ') text.pop_back();
    while (!text.empty() && text.front() == ' ') text.erase(0, 1);
    diagnostics::Sink sink;
    syntax::SyntaxFile file;
    const Expr* expr = text.empty() ? nullptr : parse::parseExpression(file, text, sink);
    const bool hasMore = expr && text.find_first_not_of(" ", expr->range.end) != std::string::npos;
    if (!expr || sink.hasErrors() || expr->kind == ExprKind::Error || hasMore || text.find(';') != std::string::npos)
        return Error{errors::NotAnExpressionText(text), {}};
    return Operand{text, levelOf(*expr), isPlace(*expr)};
}

std::string LadderEditor::fitted(const Operand& operand, int level) {
    return operand.level < level ? "(" + operand.text + ")" : operand.text;
}

RungId LadderEditor::rungOf(NodeId wanted) const {
    for (size_t i = 0; i < m_diagram.rungs.size(); ++i) {
        const std::vector<NodeId> nodes = m_diagram.nodesOf(m_diagram.rungs[i]);
        if (std::find(nodes.begin(), nodes.end(), wanted) != nodes.end()) return RungId(i);
    }
    return {};
}

const Expr* LadderEditor::parentOf(const Expr& expr, const Rung& rung) const {
    std::vector<const Expr*> roots;
    for (const Stmt* stmt : rung.statements) rootsOf(*stmt, roots);
    for (const Expr* root : roots)
        if (const Expr* parent = findParent(root, expr)) return parent;
    return nullptr;
}

/// As the projector sees it: y := NOT (e) is a negated coil behind e.
const Expr* LadderEditor::powerOf(const Stmt& stmt) const {
    if (stmt.kind == StmtKind::If) return stmt.branches.front().condition;
    if (stmt.kind != StmtKind::Assign) return nullptr;
    const Expr* value = stmt.value;
    while (value->kind == ExprKind::AssignChain) value = value->right;
    const bool negated = m_diagram.form == Form::Ladder && stmt.op == TokenKind::Assign && isNot(*value) &&
                         value->base->parenthesised && !value->parenthesised;
    return negated ? value->base : value;
}

const Stmt* LadderEditor::firstWithPower(const Rung& rung) const {
    for (const Stmt* stmt : rung.statements)
        if (stmt->kind != StmtKind::Call && powerOf(*stmt)) return stmt;
    return nullptr;
}

std::vector<const Expr*> LadderEditor::sameIn(const Rung& rung, NodeId id) const {
    const Expr& expr = *m_diagram[id].expr;
    std::vector<const Expr*> out{&expr};
    const Stmt* first = firstWithPower(rung);
    if (!first || rung.branches.size() < 2) return out;
    std::vector<NodeId> shared; // only what stands before the branch
    Rung power;
    power.power = rung.power;
    shared = m_diagram.nodesOf(power);
    if (std::find(shared.begin(), shared.end(), id) == shared.end()) return out;
    std::vector<const Expr*> parts;
    andParts(*powerOf(*first), parts);
    for (const Stmt* stmt : rung.statements) {
        if (stmt == first || stmt->kind == StmtKind::Call || !powerOf(*stmt)) continue;
        std::vector<const Expr*> others;
        andParts(*powerOf(*stmt), others);
        for (size_t i = 0; i < parts.size() && i < others.size(); ++i)
            if (const Expr* found = counterpart(parts[i], others[i], expr)) {
                out.push_back(found);
                break;
            }
    }
    return out;
}

/// `expr OP operand` in the place of `expr`, with the parentheses that the place around needs.
TextEdit LadderEditor::combined(const Expr& expr, const Rung& rung, const Operand& operand, int level,
                                Place place) const {
    const std::string word = level == kAnd ? " AND " : " OR ";
    const Expr* parent = parentOf(expr, rung);
    int around = 0;
    if (parent && parent->kind == ExprKind::Binary) around = lex::precedenceOf(parent->op);
    if (parent && parent->kind == ExprKind::Unary) around = kNot;
    // Inside its own parentheses nothing around counts.
    const bool opens = levelOf(expr) < level;
    std::string own = slice(expr.range);
    if (opens) own = "(" + own + ")";
    const std::string other = fitted(operand, level);
    std::string text = place == Place::After ? own + word + other : other + word + own;
    if (around > level) text = "(" + text + ")";
    // as little as possible is replaced: what stays in the middle stays
    if (!opens && around <= level) {
        const uint32_t where = place == Place::After ? expr.range.end : expr.range.begin;
        return {{expr.range.file, where, where}, place == Place::After ? word + other : other + word};
    }
    return {expr.range, std::move(text)};
}

Result<Edits> LadderEditor::insertContact(NodeId beside, Place place, std::string_view text) const {
    const auto operand = parsed(text);
    if (!operand) return operand.error();
    const RungId rung = rungOf(beside);
    if (!rung.isValid() || !m_diagram[beside].expr) return Error{errors::SelectContactOrWire(), {}};
    const NodeKind kind = m_diagram[beside].kind;
    if (kind == NodeKind::Operand && m_diagram.form == Form::Ladder) return Error{errors::PinHasNoContacts(), {}};
    Edits edits;
    for (const Expr* expr : sameIn(m_diagram[rung], beside))
        edits.push_back(combined(*expr, m_diagram[rung], *operand, kAnd, place));
    return finish(std::move(edits));
}

Result<Edits> LadderEditor::insertAt(const std::vector<SourceRange>& places, Place place,
                                     const std::string& text) const {
    const auto operand = parsed(text);
    if (!operand) return operand.error();
    std::vector<const Stmt*> statements;
    everyStatement(m_unit.body->statements, statements);
    Edits edits;
    for (const SourceRange& wanted : places)
        for (const Stmt* stmt : statements) {
            std::vector<const Expr*> roots;
            rootsOf(*stmt, roots);
            const Expr* found = nullptr;
            for (const Expr* root : roots)
                if (!found) found = findExact(root, wanted);
            if (!found) continue;
            Rung around; // only its statements count
            around.statements = {stmt};
            edits.push_back(combined(*found, around, *operand, kAnd, place));
            break;
        }
    if (edits.size() != places.size()) return Error{errors::EditInTextOnly(), {}};
    return finish(std::move(edits));
}

Result<Edits> LadderEditor::insertParallel(NodeId with, std::string_view text) const {
    const auto operand = parsed(text);
    if (!operand) return operand.error();
    const RungId rung = rungOf(with);
    if (!rung.isValid() || !m_diagram[with].expr) return Error{errors::SelectContactOrWire(), {}};
    Edits edits;
    for (const Expr* expr : sameIn(m_diagram[rung], with))
        edits.push_back(combined(*expr, m_diagram[rung], *operand, kOr, Place::After));
    return finish(std::move(edits));
}

Result<Edits> LadderEditor::appendContact(RungId id, std::string_view text) const {
    const auto operand = parsed(text);
    if (!operand) return operand.error();
    const Rung& rung = m_diagram[id];
    const Stmt* stmt = firstWithPower(rung);
    if (!stmt) return Error{errors::RungHasNoCondition(), {}};
    const Expr& power = *powerOf(*stmt);
    if (rung.power.isValid() && m_diagram[rung.power].kind == NodeKind::Series) {
        // the last one that all outputs share
        NodeId last = m_diagram[rung.power].children.back();
        if (m_diagram[last].expr && m_diagram[last].kind != NodeKind::Box)
            return insertContact(last, Place::After, text);
    } else if (rung.power.isValid() && m_diagram[rung.power].expr) {
        return insertContact(rung.power, Place::After, text);
    }
    if (power.kind == ExprKind::Literal && power.op == TokenKind::True) {
        Edits edits;
        for (const Stmt* each : rung.statements)
            if (each->kind != StmtKind::Call && powerOf(*each)) edits.push_back({powerOf(*each)->range, operand->text});
        return finish(std::move(edits));
    }
    return finish({combined(power, rung, *operand, kAnd, Place::After)});
}

/// What stays of AND and OR is the other side; anything else becomes TRUE.
Edits LadderEditor::removal(const Expr& expr, const Rung& rung) const {
    const Expr* parent = parentOf(expr, rung);
    const bool isChain = parent && parent->kind == ExprKind::Binary &&
                         (lex::precedenceOf(parent->op) == kOr || lex::precedenceOf(parent->op) == kAnd);
    if (!isChain) return {{expr.range, "TRUE"}};
    const bool isLeft = parent->base == &expr;
    const Expr& stays = isLeft ? *parent->right : *parent->base;
    SourceRange gone = isLeft ? SourceRange{expr.range.file, expr.range.begin, stays.range.begin}
                              : SourceRange{expr.range.file, stays.range.end, expr.range.end};
    const Expr* around = parentOf(*parent, rung);
    const bool lonely = parent->parenthesised && (isLeaf(stays) || isNot(stays)) &&
                        !(around && around->kind == ExprKind::Unary) && !(around == nullptr && isNot(stays));
    if (!lonely) return {{gone, {}}};
    // (a OR b) without b is a
    if (isLeft)
        return {{{gone.file, parent->range.begin, gone.end}, {}},
                {{gone.file, stays.range.end, parent->range.end}, {}}};
    return {{{gone.file, parent->range.begin, stays.range.begin}, {}},
            {{gone.file, gone.begin, parent->range.end}, {}}};
}

Result<Edits> LadderEditor::remove(NodeId id) const {
    const RungId rungId = rungOf(id);
    if (!rungId.isValid()) return Error{errors::SelectToDelete(), {}};
    const Rung& rung = m_diagram[rungId];
    const Node& node = m_diagram[id];
    for (const Branch& branch : rung.branches)
        if (branch.output == id) return removeOutput(id);
    if (!node.expr) return Error{errors::DeleteCallInText(), {}};
    Edits edits;
    for (const Expr* expr : sameIn(rung, id))
        for (TextEdit& edit : removal(*expr, rung)) edits.push_back(std::move(edit));
    return finish(std::move(edits));
}

Result<Edits> LadderEditor::negate(NodeId id) const {
    const RungId rung = rungOf(id);
    if (!rung.isValid()) return Error{errors::SelectContactPinOrCoil(), {}};
    const Node& node = m_diagram[id];
    if (node.kind == NodeKind::Coil)
        return setCoil(id, node.coil == CoilKind::Negated ? CoilKind::Normal : CoilKind::Negated);
    if (!node.expr || node.kind == NodeKind::Series || node.kind == NodeKind::Parallel)
        return Error{errors::SelectContactPinOrCoil(), {}};
    Edits edits;
    for (const Expr* expr : sameIn(m_diagram[rung], id)) {
        const SourceRange inner = innerRange(*expr, m_text);
        if (isNot(*expr)) {
            edits.push_back({{inner.file, expr->operatorRange.begin, expr->base->range.begin}, {}});
        } else if (isLeaf(*expr) || expr->kind == ExprKind::Call) {
            edits.push_back({{inner.file, inner.begin, inner.begin}, "NOT "});
        } else if (expr->parenthesised) {
            edits.push_back({{inner.file, expr->range.begin, expr->range.begin}, "NOT "});
        } else {
            edits.push_back({{inner.file, inner.begin, inner.begin}, "NOT ("});
            edits.push_back({{inner.file, inner.end, inner.end}, ")"});
        }
    }
    return finish(std::move(edits));
}

Result<Edits> LadderEditor::setOperand(NodeId id, std::string_view text) const {
    const auto operand = parsed(text);
    if (!operand) return operand.error();
    const RungId rung = rungOf(id);
    if (!rung.isValid()) return Error{errors::SelectToChange(), {}};
    const Node& node = m_diagram[id];
    if (node.kind == NodeKind::Coil) {
        if (!operand->isPlace) return Error{errors::CoilWritesVariable(), {}};
        return finish({{node.operand->range, operand->text}});
    }
    if (node.kind == NodeKind::Edge) return finish({{innerRange(*node.operand, m_text), operand->text}});
    if (!node.expr) return Error{errors::HasNoOperand(), {}};
    Edits edits;
    for (const Expr* expr : sameIn(m_diagram[rung], id)) {
        const bool keepsNot = node.negated && isNot(*expr);
        const Expr& inner = keepsNot ? *expr->base : *expr;
        int level = 0;
        if (keepsNot) {
            level = inner.parenthesised ? 0 : kNot;
        } else if (!inner.parenthesised) {
            const Expr* parent = parentOf(*expr, m_diagram[rung]);
            if (parent && parent->kind == ExprKind::Binary)
                level = lex::precedenceOf(parent->op) + (parent->right == expr ? 1 : 0);
            if (parent && parent->kind == ExprKind::Unary) level = kNot;
        }
        edits.push_back({innerRange(inner, m_text), fitted(*operand, level)});
    }
    return finish(std::move(edits));
}

} // namespace plc::ladder
