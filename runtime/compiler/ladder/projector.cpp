// Statements: which ones make a rung together, which ones frame others, and the comments that belong to them.
#include "runtime/compiler/ladder/projector.h"

#include "runtime/base/text.h"

#include <algorithm>

namespace plc::ladder {

using lex::TokenKind;
using syntax::Expr;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::StmtKind;

namespace {

constexpr size_t kMostOutputs = 8; // of one IF as a rung; a longer one is a frame

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

bool isNameByte(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

bool hasError(const Expr* expr) {
    if (!expr) return false;
    if (expr->kind == ExprKind::Error || hasError(expr->base) || hasError(expr->right)) return true;
    return std::any_of(expr->arguments.begin(), expr->arguments.end(),
                       [](const syntax::Argument& a) { return a.instructions || hasError(a.value); });
}

bool containsCall(const Expr* expr) {
    if (!expr) return false;
    if (expr->kind == ExprKind::Call || containsCall(expr->base) || containsCall(expr->right)) return true;
    return std::any_of(expr->arguments.begin(), expr->arguments.end(),
                       [](const syntax::Argument& a) { return containsCall(a.value); });
}

/// Of AND, in order; anything else is its only part.
void andParts(const Expr& expr, std::vector<const Expr*>& out) {
    if (expr.kind != ExprKind::Binary || expr.op != TokenKind::And) {
        out.push_back(&expr);
        return;
    }
    andParts(*expr.base, out);
    andParts(*expr.right, out);
}

std::string_view rootName(const Expr* place) {
    while (place && place->base) place = place->base;
    return place ? place->name.text : std::string_view();
}

size_t countStatements(const syntax::Block& block);
size_t countStatements(const Stmt& stmt) {
    if (stmt.kind == StmtKind::Empty) return 0;
    size_t count = 1 + countStatements(stmt.body) + countStatements(stmt.elseBody);
    for (const syntax::IfBranch& branch : stmt.branches) count += countStatements(branch.body);
    for (const syntax::CaseArm& arm : stmt.arms) count += countStatements(arm.body);
    return count;
}
size_t countStatements(const syntax::Block& block) {
    size_t count = 0;
    for (const Stmt* stmt : block) count += countStatements(*stmt);
    return count;
}

std::string withoutMarkers(std::string_view comment) {
    if (comment.starts_with("//")) {
        while (comment.starts_with('/')) comment.remove_prefix(1);
    } else {
        comment.remove_prefix(std::min<size_t>(2, comment.size()));
        if (comment.ends_with("*)") || comment.ends_with("*/")) comment.remove_suffix(2);
    }
    while (!comment.empty() && (isBlank(comment.front()) || comment.front() == '*')) comment.remove_prefix(1);
    while (!comment.empty() && (isBlank(comment.back()) || comment.back() == '*')) comment.remove_suffix(1);
    return std::string(comment);
}

/// {network 'title'}, {region 'title'}
std::string titleOf(std::string_view pragma) {
    for (const std::string_view word : {"{network", "{region"}) {
        if (pragma.size() <= word.size() || !equalsIgnoringCase(pragma.substr(0, word.size()), word)) continue;
        pragma.remove_prefix(word.size());
        if (pragma.ends_with('}')) pragma.remove_suffix(1);
        while (!pragma.empty() && (isBlank(pragma.front()) || pragma.front() == '\'' || pragma.front() == '"'))
            pragma.remove_prefix(1);
        while (!pragma.empty() && (isBlank(pragma.back()) || pragma.back() == '\'' || pragma.back() == '"'))
            pragma.remove_suffix(1);
        return std::string(pragma);
    }
    return {};
}

} // namespace

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
    markReads();
    numberBoxes();
    return std::move(m_diagram);
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

// ---------------------------------------------------------------- comments

bool Projector::hasComments(uint32_t begin, uint32_t end) const {
    const auto& comments = m_file.tokens.comments;
    const auto at = std::lower_bound(comments.begin(), comments.end(), begin,
                                     [](const lex::Comment& c, uint32_t offset) { return c.begin < offset; });
    return at != comments.end() && at->begin < end;
}

/// The comments from `floor` to the end of the rung's last line, and the title of a network above it.
void Projector::annotate(Rung& rung, uint32_t floor) {
    const auto& comments = m_file.tokens.comments;
    auto at = std::lower_bound(comments.begin(), comments.end(), floor,
                               [](const lex::Comment& c, uint32_t offset) { return c.begin < offset; });
    const size_t newline = m_text.find('\n', rung.range.end);
    const auto lineEnd = static_cast<uint32_t>(newline == std::string_view::npos ? m_text.size() : newline);
    uint32_t behind = rung.range.end;
    const auto note = [&](const lex::Comment& comment) {
        const std::string text = withoutMarkers(m_text.substr(comment.begin, comment.end - comment.begin));
        if (!text.empty()) rung.note += (rung.note.empty() ? "" : "\n") + text;
    };
    for (; at != comments.end() && at->begin < lineEnd; ++at) {
        if (at->begin < rung.range.begin) {
            if (rung.comment.end == 0) rung.comment = {rung.range.file, at->begin, at->end};
            rung.comment.end = at->end;
        } else if (at->begin >= rung.range.end) {
            const std::string_view between = m_text.substr(behind, at->begin - behind);
            if (!std::all_of(between.begin(), between.end(), isBlank) || at->end > lineEnd) break;
            if (rung.trailing.end == 0) rung.trailing = {rung.range.file, at->begin, at->end};
            rung.trailing.end = behind = at->end;
        }
        note(*at);
    }
    for (const lex::Token& token : m_file.tokens.tokens) {
        if (token.begin >= rung.range.begin) break;
        if (token.kind != TokenKind::Pragma || token.begin < floor) continue;
        if (std::string title = titleOf(m_text.substr(token.begin, token.end - token.begin)); !title.empty())
            rung.title = std::move(title);
    }
    m_floor = behind;
}

/// What is written below the last statement of a block has no statement to belong to.
void Projector::closingComment(uint32_t begin, uint32_t end, int depth) {
    const auto& comments = m_file.tokens.comments;
    for (const lex::Comment& comment : comments) {
        if (comment.begin < begin) continue;
        if (comment.begin >= end) break;
        const std::string_view between = m_text.substr(begin, comment.begin - begin);
        if (!std::all_of(between.begin(), between.end(), isBlank)) break;
        const std::string text = withoutMarkers(m_text.substr(comment.begin, comment.end - comment.begin));
        begin = comment.end;
        m_floor = std::max(m_floor, begin);
        if (text.empty()) continue;
        Rung& rung = addRung(RungKind::Comment, depth);
        rung.range = rung.comment = {m_unit.range.file, comment.begin, comment.end};
        rung.note = text;
    }
}

// ---------------------------------------------------------------- blocks and frames

void Projector::block(const syntax::Block& block, int depth, uint32_t begin, uint32_t end) {
    m_floor = begin;
    for (size_t at = 0; at < block.size();) {
        const Stmt& stmt = *block[at];
        if (stmt.kind == StmtKind::Empty && slice(stmt.range) == ";") {
            ++at;
        } else if (isLogic(stmt)) {
            at = logicRung(block, at, depth);
        } else {
            frame(stmt, depth);
            ++at;
        }
    }
    closingComment(m_floor, end, depth);
}

bool Projector::isLogic(const Stmt& stmt) const {
    switch (stmt.kind) {
    case StmtKind::Assign:
        return !hasError(stmt.target) && stmt.value && !hasError(stmt.value);
    case StmtKind::Call:
        return stmt.value && !hasError(stmt.value);
    case StmtKind::Return:
        return !hasError(stmt.value);
    case StmtKind::If:
        return isSimpleIf(stmt);
    case StmtKind::Jump:
    case StmtKind::Exit:
    case StmtKind::Continue:
        return true;
    default:
        return false;
    }
}

/// One condition, and what it drives can stand behind it.
bool Projector::isSimpleIf(const Stmt& stmt) const {
    if (stmt.branches.size() != 1 || !stmt.branches[0].condition || hasError(stmt.branches[0].condition)) return false;
    const syntax::Block& body = stmt.branches[0].body;
    if (body.empty() || body.size() > kMostOutputs || hasComments(stmt.range.begin, stmt.range.end)) return false;
    return std::all_of(body.begin(), body.end(),
                       [&](const Stmt* inner) { return inner->kind != StmtKind::If && isLogic(*inner); });
}

void Projector::textRung(const Stmt& stmt, int depth) {
    Rung& rung = addRung(RungKind::Text, depth);
    rung.statements.push_back(&stmt);
    rung.range = stmt.range;
    rung.text = slice(stmt.range);
    annotate(rung, m_floor);
    m_diagram.share.text += std::max<size_t>(1, countStatements(stmt));
}

void Projector::head(const Stmt& stmt, int depth, std::string text, SourceRange range, const Expr* condition) {
    const NodeId power = condition ? this->power(*condition) : NodeId();
    Rung& rung = addRung(RungKind::Head, depth);
    rung.statements.push_back(&stmt);
    rung.range = range;
    rung.power = power;
    rung.text = std::move(text);
    annotate(rung, m_floor);
}

void Projector::tail(const Stmt& stmt, int depth, std::string text, const Expr* condition) {
    const NodeId power = condition ? this->power(*condition) : NodeId();
    Rung& rung = addRung(RungKind::Tail, depth);
    rung.statements.push_back(&stmt);
    rung.range = {stmt.range.file, std::max(stmt.range.begin, stmt.range.end - 1), stmt.range.end};
    rung.text = std::move(text);
    rung.power = power;
    annotate(rung, stmt.range.end);
}

void Projector::frame(const Stmt& stmt, int depth) {
    const auto upTo = [&](const Expr* last) {
        return SourceRange{stmt.range.file, stmt.range.begin, last ? last->range.end : stmt.range.begin};
    };
    switch (stmt.kind) {
    case StmtKind::If:
        return ifFrame(stmt, depth);
    case StmtKind::Case:
        return caseFrame(stmt, depth);
    case StmtKind::For: {
        if (!stmt.target || !stmt.from || !stmt.to) return textRung(stmt, depth);
        std::string text = "FOR " + plain(*stmt.target) + " := " + plain(*stmt.from) + " TO " + plain(*stmt.to);
        if (stmt.by) text += " BY " + plain(*stmt.by);
        head(stmt, depth, std::move(text), upTo(stmt.by ? stmt.by : stmt.to), nullptr);
        block(stmt.body, depth + 1, m_floor, stmt.range.end);
        tail(stmt, depth, "END_FOR");
        break;
    }
    case StmtKind::While:
        if (!stmt.value) return textRung(stmt, depth);
        head(stmt, depth, "WHILE", upTo(stmt.value), stmt.value);
        block(stmt.body, depth + 1, m_floor, stmt.range.end);
        tail(stmt, depth, "END_WHILE");
        break;
    case StmtKind::Repeat:
        if (!stmt.value) return textRung(stmt, depth);
        head(stmt, depth, "REPEAT", {stmt.range.file, stmt.range.begin, stmt.range.begin + 6}, nullptr);
        block(stmt.body, depth + 1, m_floor, stmt.value->range.begin);
        tail(stmt, depth, "UNTIL", stmt.value);
        break;
    case StmtKind::Label: {
        Rung& rung = addRung(RungKind::Label, depth);
        rung.statements.push_back(&stmt);
        rung.range = stmt.range;
        rung.text = std::string(stmt.name.text);
        annotate(rung, m_floor);
        m_diagram.share.drawn += 1;
        return;
    }
    default:
        return textRung(stmt, depth);
    }
    m_diagram.share.framed += 1;
}

void Projector::ifFrame(const Stmt& stmt, int depth) {
    for (const syntax::IfBranch& branch : stmt.branches)
        if (hasError(branch.condition)) return textRung(stmt, depth);
    for (size_t i = 0; i < stmt.branches.size(); ++i) {
        const syntax::IfBranch& branch = stmt.branches[i];
        const uint32_t end = branch.condition ? branch.condition->range.end : branch.range.begin + 4;
        head(stmt, depth,
             i == 0             ? "IF"
             : branch.condition ? "ELSIF"
                                : "ELSE",
             {stmt.range.file, branch.range.begin, end}, branch.condition);
        m_floor = std::max(m_floor, end);
        block(branch.body, depth + 1, m_floor, branch.range.end);
        m_floor = std::max(m_floor, i + 1 < stmt.branches.size() ? branch.range.end : m_floor);
    }
    tail(stmt, depth, "END_IF");
    m_diagram.share.framed += 1;
}

void Projector::caseFrame(const Stmt& stmt, int depth) {
    if (!stmt.value || hasError(stmt.value)) return textRung(stmt, depth);
    head(stmt, depth, "CASE " + plain(*stmt.value), {stmt.range.file, stmt.range.begin, stmt.value->range.end},
         nullptr);
    for (const syntax::CaseArm& arm : stmt.arms) {
        std::string labels;
        uint32_t end = arm.range.begin;
        for (const syntax::CaseLabel& label : arm.labels) {
            labels += (labels.empty() ? "" : ", ") + plain(*label.low);
            if (label.high) labels += ".." + plain(*label.high);
            end = std::max(end, (label.high ? label.high : label.low)->range.end);
        }
        head(stmt, depth + 1, labels + ":", {stmt.range.file, arm.range.begin, end}, nullptr);
        m_floor = std::max(m_floor, end);
        block(arm.body, depth + 2, m_floor, arm.range.end);
    }
    if (stmt.hasElse) {
        const uint32_t at = stmt.elseBody.empty() ? stmt.range.end : stmt.elseBody.front()->range.begin;
        uint32_t floor = m_floor;
        head(stmt, depth + 1, "ELSE", {stmt.range.file, std::min(floor, at), at}, nullptr);
        m_floor = std::max(floor, m_floor);
        block(stmt.elseBody, depth + 2, m_floor, stmt.range.end);
    }
    tail(stmt, depth, "END_CASE");
    m_diagram.share.framed += 1;
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
            m_diagram.nodes[box.index()].outputs.push_back(
                {std::string(next->value->name.text), plain(*next->target), false, false, next->range});
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
