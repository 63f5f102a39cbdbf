// Whole rungs, their comments, and blocks put into them.
#include "runtime/compiler/ladder/edits.h"

#include "runtime/base/messages.h"
#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"

#include <algorithm>

namespace plc::ladder {

using lex::TokenKind;
using syntax::Stmt;
using syntax::StmtKind;

namespace {

bool isBlankLine(std::string_view text) { return text.find_first_not_of(" \t\r\n") == std::string_view::npos; }

bool isIdentifier(std::string_view text) {
    if (text.empty() || (text[0] >= '0' && text[0] <= '9')) return false;
    for (size_t at = 0; at < text.size();) {
        const char first = text[at];
        const char32_t c = decodeUtf8(text, at);
        if (!isNameLetter(c) && first != '_' && !(first >= '0' && first <= '9')) return false;
    }
    return true;
}

} // namespace

std::string LadderEditor::lineEnd() const {
    const size_t at = m_text.find('\n');
    return at != std::string_view::npos && at > 0 && m_text[at - 1] == '\r' ? "\r\n" : "\n";
}

uint32_t LadderEditor::lineBegin(uint32_t at) const {
    while (at > 0 && m_text[at - 1] != '\n') --at;
    return at;
}

uint32_t LadderEditor::lineBehind(uint32_t at) const {
    const size_t newline = m_text.find('\n', at);
    return static_cast<uint32_t>(newline == std::string_view::npos ? m_text.size() : newline + 1);
}

std::string LadderEditor::indentOf(uint32_t at) const {
    const uint32_t begin = lineBegin(at);
    uint32_t end = begin;
    while (end < m_text.size() && (m_text[end] == ' ' || m_text[end] == '\t')) ++end;
    return std::string(m_text.substr(begin, end - begin));
}

SourceRange LadderEditor::statementLines(SourceRange range) const {
    const uint32_t begin = lineBegin(range.begin), end = lineBehind(range.end);
    const bool before = isBlankLine(m_text.substr(begin, range.begin - begin));
    const bool behind = isBlankLine(m_text.substr(range.end, end - range.end));
    if (before && behind) return {range.file, begin, end};
    if (before && !behind) return range;
    // another statement stands before it on the line: the blanks between go
    uint32_t from = range.begin;
    while (from > 0 && (m_text[from - 1] == ' ' || m_text[from - 1] == '\t')) --from;
    return {range.file, from, range.end};
}

SourceRange LadderEditor::extentOf(const Rung& rung) const {
    SourceRange range = rung.range;
    if (rung.kind == RungKind::Head || rung.kind == RungKind::Tail) range = rung.statements.front()->range;
    if (rung.comment.end) range.begin = rung.comment.begin;
    if (rung.trailing.end) range.end = rung.trailing.end;
    return statementLines(range);
}

Result<Edits> LadderEditor::insertRung(RungId beside, Place place, std::string_view statement) const {
    const std::string end = lineEnd();
    diagnostics::Sink sink;
    syntax::SyntaxFile file;
    const std::string checked(statement);
    const syntax::Block block = parse::parseStatements(file, checked, sink);
    if (block.empty() || sink.hasErrors()) return Error{errors::NotAStatement(checked), {}};
    if (!beside.isValid()) {
        if (!m_unit.body || !m_diagram.rungs.empty()) return Error{errors::SelectRungBeside(), {}};
        const uint32_t at = m_unit.body->range.begin;
        const bool needsLine = at > 0 && m_text[at - 1] != '\n';
        return finish({{{m_unit.range.file, at, at}, (needsLine ? end : "") + checked + (needsLine ? "" : end)}});
    }
    const Rung& rung = m_diagram[beside];
    if (rung.kind == RungKind::Head && rung.statements.front()->kind != StmtKind::If && place == Place::After)
        place = Place::Before;
    const SourceRange extent = extentOf(rung);
    const std::string indent =
        indentOf(rung.kind == RungKind::Head || rung.kind == RungKind::Tail ? rung.statements.front()->range.begin
                                                                            : rung.range.begin);
    if (place == Place::Before) {
        const bool ownLine = extent.begin == lineBegin(extent.begin);
        return finish({{{extent.file, extent.begin, extent.begin},
                        ownLine ? indent + checked + end + end : checked + end + end + indent}});
    }
    const bool ownLine = extent.end > 0 && m_text[extent.end - 1] == '\n';
    std::string text = ownLine ? end + indent + checked + end : end + end + indent + checked;
    if (!ownLine && !isBlankLine(m_text.substr(extent.end, lineBehind(extent.end) - extent.end)))
        text += end + end + indent;
    return finish({{{extent.file, extent.end, extent.end}, std::move(text)}});
}

Result<Edits> LadderEditor::removeRung(RungId id) const {
    const SourceRange extent = extentOf(m_diagram[id]);
    return finish({{extent, {}}});
}

Result<Edits> LadderEditor::moveRung(RungId id, Place place, RungId anchor) const {
    if (id == anchor) return Edits{};
    const Rung& rung = m_diagram[id];
    const Rung& other = m_diagram[anchor];
    if (rung.depth != other.depth || rung.kind == RungKind::Tail || other.kind == RungKind::Comment)
        return Error{errors::RungStaysInBlock(), {}};
    // between them no frame may end: all rungs on the way are as deep or deeper
    for (size_t i = std::min(id.index(), anchor.index()); i <= std::max(id.index(), anchor.index()); ++i) {
        const Rung& between = m_diagram.rungs[i];
        const bool leaves =
            between.depth < rung.depth ||
            (between.depth == rung.depth && between.kind == RungKind::Head &&
             i != std::min(id.index(), anchor.index()) && between.statements.front()->range.begin < rung.range.begin &&
             between.statements.front()->range.end > rung.range.end);
        if (leaves) return Error{errors::RungStaysInBlock(), {}};
    }
    const SourceRange from = extentOf(rung), to = extentOf(other);
    const auto isWhole = [&](SourceRange range) {
        return range.begin == lineBegin(range.begin) && range.end > 0 && m_text[range.end - 1] == '\n';
    };
    if (!isWhole(from) || !isWhole(to)) return Error{errors::StatementsOnOneLine(), {}};
    if (from.begin < to.end && to.begin < from.end) return Error{errors::RungIntoItself(), {}};
    const std::string moved = slice(from), end = lineEnd();
    // An empty line keeps rungs apart that would become one.
    const uint32_t at = place == Place::Before ? to.begin : to.end;
    if (at == from.begin || at == from.end) return Edits{};
    const std::string text = place == Place::Before ? moved + end : end + moved;
    return finish({{from, {}}, {{to.file, at, at}, text}});
}

Result<Edits> LadderEditor::setComment(RungId id, std::string_view comment) const {
    const Rung& rung = m_diagram[id];
    if (rung.kind == RungKind::Tail) return Error{errors::SelectRungOfComment(), {}};
    const std::string end = lineEnd(), indent = indentOf(rung.range.begin);
    std::vector<std::string> lines;
    for (size_t at = 0; at <= comment.size() && !comment.empty();) {
        const size_t newline = std::min(comment.find('\n', at), comment.size());
        std::string line(comment.substr(at, newline - at));
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
        lines.push_back("// " + line);
        at = newline + 1;
    }
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : end + indent) + line;
    if (rung.comment.end) {
        if (text.empty()) return finish({{statementLines(rung.comment), {}}});
        return finish({{rung.comment, std::move(text)}});
    }
    if (text.empty()) return Edits{};
    const uint32_t at = rung.range.begin;
    if (!isBlankLine(m_text.substr(lineBegin(at), at - lineBegin(at))))
        return finish({{{rung.range.file, at, at}, end + text + end}});
    return finish({{{rung.range.file, at, at}, text + end + indent}});
}

Result<Edits> LadderEditor::setText(RungId id, std::string_view statements) const {
    const Rung& rung = m_diagram[id];
    if (rung.kind != RungKind::Text) return Error{errors::SelectTextBox(), {}};
    return finish({{rung.range, std::string(statements)}});
}

// ---------------------------------------------------------------- blocks

Edits LadderEditor::declare(std::string_view name, std::string_view type) const {
    if (!isIdentifier(name) || !m_unit.pou) return {};
    if (m_types.isDeclared(name, {m_unit.pou, m_unit.owner})) return {};
    const std::string end = lineEnd();
    for (const syntax::VarSection* section : m_unit.pou->sections) {
        if (section->kind != syntax::SectionKind::Var || section->constant) continue;
        // before END_VAR
        uint32_t at = section->range.end;
        for (const lex::Token& token : m_file.tokens.tokens)
            if (token.kind == TokenKind::EndVar && token.begin >= section->range.begin &&
                token.end <= section->range.end)
                at = token.begin;
        const std::string declaration = std::string(name) + " : " + std::string(type) + ";";
        const uint32_t line = lineBegin(at);
        if (isBlankLine(m_text.substr(line, at - line)))
            return {{{section->range.file, line, line}, indentOf(at) + "    " + declaration + end}};
        return {{{section->range.file, at, at}, declaration + " "}};
    }
    const uint32_t at = m_unit.pou->header.end;
    return {{{m_unit.range.file, at, at},
             end + "VAR" + end + "    " + std::string(name) + " : " + std::string(type) + ";" + end + "END_VAR"}};
}

Result<Edits> LadderEditor::insertBlock(RungId id, std::string_view instance, std::string_view type) const {
    if (!isIdentifier(instance)) return Error{errors::InstanceNotAName(std::string(instance)), {}};
    const syntax::Pou* block = m_types.pou(type);
    if (!block || block->kind != syntax::PouKind::FunctionBlock)
        return Error{errors::NoFunctionBlock(std::string(type)), {}};
    const Rung& rung = m_diagram[id];
    const Stmt* stmt = firstWithPower(rung);
    if (!stmt || rung.branches.size() != 1) return Error{errors::SelectRungWithOneOutput(), {}};
    std::string power, flow, others;
    for (const syntax::VarSection* section : block->sections)
        for (const syntax::VarDecl* variable : section->declarations)
            for (const syntax::Name& name : variable->names) {
                const bool isBool = m_types.isBoolType(variable->type);
                const std::string pin(name.text);
                if (section->kind == syntax::SectionKind::Output && isBool && flow.empty()) flow = pin;
                if (section->kind != syntax::SectionKind::Input) continue;
                const std::string typeName = variable->type && !variable->type->path.empty()
                                                 ? foldCase(variable->type->path.back().text)
                                                 : std::string();
                if (isBool && power.empty())
                    power = pin;
                else if (typeName == "time")
                    others += ", " + pin + " := T#1s";
                else if (typeName == "int")
                    others += ", " + pin + " := 1";
            }
    if (power.empty() || flow.empty()) return Error{errors::BlockPinsNotBool(std::string(type)), {}};
    const syntax::Expr& value = *powerOf(*stmt);
    const std::string own = slice(value.range), indent = indentOf(stmt->range.begin);
    Edits edits = declare(instance, type);
    edits.push_back({{stmt->range.file, stmt->range.begin, stmt->range.begin},
                     std::string(instance) + "(" + power + " := " + own + others + ");" + lineEnd() + indent});
    edits.push_back({value.range, std::string(instance) + "." + flow});
    return finish(std::move(edits));
}

} // namespace plc::ladder
