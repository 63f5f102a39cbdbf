// Statements that hold others, the text of comments, and what has no picture.
#include "runtime/base/chars.h"
#include "runtime/base/text.h"
#include "runtime/compiler/ladder/projector.h"

#include <algorithm>

namespace plc::ladder {

using lex::TokenKind;
using syntax::Expr;
using syntax::ExprKind;
using syntax::Stmt;
using syntax::StmtKind;

namespace {

constexpr size_t kMostOutputs = 8; // of one IF as a rung; a longer one is a frame

bool hasError(const Expr* expr) {
    if (!expr) return false;
    if (expr->kind == ExprKind::Error || hasError(expr->base) || hasError(expr->right)) return true;
    return std::any_of(expr->arguments.begin(), expr->arguments.end(),
                       [](const syntax::Argument& a) { return a.instructions || hasError(a.value); });
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
    const auto& tokens = m_file.tokens.tokens;
    auto token = std::lower_bound(tokens.begin(), tokens.end(), floor,
                                  [](const lex::Token& t, uint32_t offset) { return t.begin < offset; });
    for (; token != tokens.end() && token->begin < rung.range.begin; ++token) {
        if (token->kind != TokenKind::Pragma) continue;
        if (std::string title = titleOf(m_text.substr(token->begin, token->end - token->begin)); !title.empty())
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

} // namespace plc::ladder
