#include "runtime/compiler/format/structure.h"

#include <algorithm>

namespace plc::format {

using namespace syntax;
using lex::SoftWord;
using lex::Token;
using lex::TokenKind;

Structure::Structure(const SyntaxFile& file, std::string_view text,
                     const std::vector<diagnostics::Diagnostic>& diagnostics)
    : m_tokens(file.tokens.tokens), m_text(text) {
    // a declaration with a mistake stays as it is, and so does what belongs to none
    std::vector<std::pair<uint32_t, uint32_t>> good;
    uint32_t at = 0;
    bool anyError = false;
    for (const auto& d : diagnostics) anyError |= d.severity == diagnostics::Severity::Error;
    const auto wholeLines = [&](uint32_t begin, uint32_t end) {
        while (begin > 0 && text[begin - 1] != '\n') --begin;
        while (end < text.size() && text[end] != '\n') ++end;
        m_frozen.emplace_back(begin, end);
    };
    if (anyError) {
        for (const Decl* decl : file.declarations) {
            bool bad = false;
            for (const auto& d : diagnostics)
                bad |=
                    d.severity == diagnostics::Severity::Error && d.range.begin <= decl->range.end && d.range.end >= at;
            if (bad) wholeLines(at, decl->range.end);
            at = decl->range.end;
        }
        for (const auto& d : diagnostics)
            if (d.severity == diagnostics::Severity::Error && d.range.end >= at) {
                wholeLines(at, static_cast<uint32_t>(text.size()));
                break;
            }
    }
    declarations(file.declarations);
    for (size_t i = 0; i < m_tokens.size(); ++i) { // TYPE … END_TYPE
        if (m_tokens[i].kind != TokenKind::TypeWord) continue;
        begins(m_tokens[i].begin);
        if (i + 1 < m_tokens.size() && !m_tokens[i + 1].afterNewline) continue; // TYPE Name : and STRUCT below it
        for (size_t j = i + 1; j < m_tokens.size(); ++j) {
            if (m_tokens[j].kind == TokenKind::TypeWord) break;
            if (m_tokens[j].kind != TokenKind::EndType) continue;
            region(m_tokens[i].end, m_tokens[j].begin);
            break;
        }
    }
    std::vector<uint32_t> regions; // REGION … END_REGION, indented as a block
    for (size_t i = 0; i < m_tokens.size(); ++i) {
        const Token& token = m_tokens[i];
        if (token.kind == TokenKind::Pragma) {
            // name { ExternalVisible := 'False' } : BOOL;
            const bool isInside =
                !token.afterNewline && i + 1 < m_tokens.size() && m_tokens[i + 1].kind == TokenKind::Colon;
            if (!isInside) begins(token.begin);
            const char first = text[token.begin];
            if (first == 'R' || first == 'r') {
                regions.push_back(token.end);
            } else if ((first == 'E' || first == 'e') && !regions.empty()) {
                region(regions.back(), token.begin);
                regions.pop_back();
            }
            if (first != '{' && i + 1 < m_tokens.size()) begins(m_tokens[i + 1].begin);
            continue;
        }
        switch (token.kind) {
        case TokenKind::Else:
        case TokenKind::Elsif:
        case TokenKind::Until:
        case TokenKind::Catch:
        case TokenKind::Finally:
        case TokenKind::EndTry:
        case TokenKind::Then:
        case TokenKind::Do:
        case TokenKind::Struct:
        case TokenKind::EndOfFile:
            begins(token.begin);
            break;
        default:
            if (lex::isKeyword(token.kind) && lex::spelling(token.kind).starts_with("END_")) begins(token.begin);
            break;
        }
    }
    std::sort(m_regionBegins.begin(), m_regionBegins.end());
    std::sort(m_regionEnds.begin(), m_regionEnds.end());
    std::sort(m_frozen.begin(), m_frozen.end());
}

int Structure::depthAt(uint32_t offset) const {
    const auto begun = std::upper_bound(m_regionBegins.begin(), m_regionBegins.end(), offset) - m_regionBegins.begin();
    const auto ended = std::upper_bound(m_regionEnds.begin(), m_regionEnds.end(), offset) - m_regionEnds.begin();
    return static_cast<int>(begun - ended);
}

bool Structure::isFrozen(uint32_t begin, uint32_t end) const {
    return std::any_of(m_frozen.begin(), m_frozen.end(),
                       [&](const auto& range) { return begin < range.second && end > range.first; });
}

void Structure::region(uint32_t begin, uint32_t end) {
    if (end < begin) return;
    m_regionBegins.push_back(begin);
    m_regionEnds.push_back(end);
}

size_t Structure::tokenAt(uint32_t offset) const {
    return static_cast<size_t>(std::lower_bound(m_tokens.begin(), m_tokens.end(), offset,
                                                [](const Token& t, uint32_t at) { return t.begin < at; }) -
                               m_tokens.begin());
}

size_t Structure::lastTokenOf(SourceRange range) const {
    size_t at = tokenAt(range.end);
    while (at > 0 &&
           (at >= m_tokens.size() || m_tokens[at].begin >= range.end || m_tokens[at].kind == TokenKind::Semicolon))
        --at;
    return at;
}

void Structure::inside(SourceRange range) {
    const size_t first = tokenAt(range.begin), last = lastTokenOf(range);
    if (last > first && last < m_tokens.size()) region(m_tokens[first].end, m_tokens[last].begin);
}

void Structure::labelColonBehind(uint32_t offset) {
    const size_t at = tokenAt(offset);
    for (size_t i = at; i < std::min(at + 8, m_tokens.size()); ++i) {
        if (m_tokens[i].kind == TokenKind::Pragma) continue;
        if (m_tokens[i].kind == TokenKind::Colon) m_labelColons.insert(m_tokens[i].begin);
        return;
    }
}

/// Soft words that are keywords there: of a header, never of an expression.
void Structure::softWordsIn(SourceRange range) {
    for (size_t i = tokenAt(range.begin); i < m_tokens.size() && m_tokens[i].begin < range.end; ++i)
        if (m_tokens[i].soft != SoftWord::None) soft(m_tokens[i].begin);
}

void Structure::declarations(const std::vector<Decl*>& list) {
    for (const Decl* decl : list) {
        begins(decl->range.begin);
        if (decl->pou) unit(*decl->pou);
        if (decl->type) {
            begins(decl->type->range.begin);
            type(decl->type->spec);
        }
        if (decl->globals) section(*decl->globals->section);
        if (decl->configuration) configuration(*decl->configuration);
        if (decl->test) {
            soft(decl->test->range.begin); // its body stands as a unit's does
            for (const VarSection* s : decl->test->sections) section(*s);
            block(decl->test->body);
        }
        if (decl->space) {
            soft(decl->range.begin);
            declarations(decl->space->declarations);
        }
        if (decl->kind == DeclKind::Using) soft(decl->range.begin);
    }
}

void Structure::unit(const Pou& pou) {
    begins(pou.range.begin);
    // modifiers, EXTENDS, IMPLEMENTS: not the names themselves
    for (size_t i = tokenAt(pou.header.begin); i < m_tokens.size() && m_tokens[i].begin < pou.header.end; ++i)
        if (m_tokens[i].soft != SoftWord::None && m_tokens[i].begin != pou.name.range.begin) soft(m_tokens[i].begin);
    for (const VarSection* s : pou.sections) section(*s);
    if (pou.kind == PouKind::Method || pou.kind == PouKind::PropertyGet || pou.kind == PouKind::PropertySet ||
        pou.kind == PouKind::Interface) {
        if (pou.hasEnd) inside(pou.range);
        soft(pou.range.begin);
    }
    body(pou.body);
    for (const Pou* method : pou.methods) unit(*method);
    for (const Property* p : pou.properties) property(*p);
    for (const ActionDecl* a : pou.actions) action(*a);
}

void Structure::property(const Property& property) {
    begins(property.range.begin);
    soft(property.range.begin);
    inside(property.range);
    if (property.get) unit(*property.get);
    if (property.set) unit(*property.set);
}

void Structure::action(const ActionDecl& action) {
    begins(action.range.begin);
    soft(action.range.begin);
    labelColonBehind(action.name.range.end);
    for (const VarSection* s : action.sections) section(*s);
    body(action.body);
}

void Structure::section(const VarSection& section) {
    begins(section.range.begin);
    inside(section.range);
    const uint32_t firstDecl = section.declarations.empty() ? section.range.end : section.declarations[0]->range.begin;
    softWordsIn({section.range.file, section.range.begin, firstDecl});
    for (const VarDecl* decl : section.declarations) variable(*decl);
}

void Structure::variable(const VarDecl& decl) {
    begins(decl.range.begin);
    m_declarations.insert(decl.range.begin);
    type(decl.type);
}

void Structure::type(const TypeSpec* spec) {
    if (!spec) return;
    switch (spec->kind) {
    case TypeSpecKind::Struct:
    case TypeSpecKind::Union:
        begins(spec->range.begin);
        if (spec->kind == TypeSpecKind::Union) soft(spec->range.begin);
        inside(spec->range);
        for (const VarDecl* field : spec->fields) variable(*field);
        break;
    case TypeSpecKind::Enum:
        for (const EnumeratorDecl& e : spec->enumerators) begins(e.range.begin);
        if (!spec->enumerators.empty()) {
            size_t close = tokenAt(spec->enumerators.back().range.end);
            while (close < m_tokens.size() && m_tokens[close].kind != TokenKind::RightParen &&
                   m_tokens[close].begin < spec->range.end)
                ++close;
            if (close < m_tokens.size()) {
                region(spec->enumerators.front().range.begin, m_tokens[close].begin);
                begins(m_tokens[close].begin);
                const size_t open = tokenAt(spec->enumerators.front().range.begin);
                if (open > 0 && m_tokens[open - 1].kind == TokenKind::LeftParen) begins(m_tokens[open - 1].begin);
            }
        }
        break;
    case TypeSpecKind::Pointer:
    case TypeSpecKind::Reference:
    case TypeSpecKind::RefTo:
        soft(spec->range.begin);
        break;
    default:
        break;
    }
    type(spec->element);
}

void Structure::body(const Body& body) {
    if (body.chart) return chart(*body.chart);
    if (body.language == BodyLanguage::Il) { // columns of instructions are the author's
        if (!body.statements.empty()) {
            uint32_t begin = body.statements.front()->range.begin, end = body.statements.back()->range.end;
            while (begin > 0 && m_text[begin - 1] != '\n') --begin;
            while (end < m_text.size() && m_text[end] != '\n') ++end;
            m_frozen.emplace_back(begin, end);
        }
        return;
    }
    block(body.statements);
}

void Structure::block(const Block& list) {
    for (const Stmt* stmt : list) statement(*stmt);
}

void Structure::statement(const Stmt& stmt) {
    begins(stmt.range.begin);
    // the token behind a range: what ends the block
    const auto tokenBehind = [&](uint32_t end) {
        size_t at = tokenAt(end);
        while (at < m_tokens.size() && m_tokens[at].kind == TokenKind::Pragma) ++at; // END_REGION
        return at < m_tokens.size() ? m_tokens[at].begin : end;
    };
    const auto headerEnd = [&](uint32_t from, TokenKind word, uint32_t limit) {
        for (size_t i = tokenAt(from); i < m_tokens.size() && m_tokens[i].begin < limit; ++i)
            if (m_tokens[i].kind == word) return m_tokens[i].end;
        return from;
    };
    switch (stmt.kind) {
    case StmtKind::If:
        for (const IfBranch& branch : stmt.branches) {
            const uint32_t from = branch.condition
                                      ? headerEnd(branch.condition->range.end, TokenKind::Then, stmt.range.end)
                                      : branch.range.begin + 4;
            region(from, tokenBehind(branch.range.end));
            block(branch.body);
        }
        break;
    case StmtKind::Case: {
        inside(stmt.range);
        for (const CaseArm& arm : stmt.arms) {
            begins(arm.range.begin);
            if (arm.labels.empty()) continue;
            const CaseLabel& last = arm.labels.back();
            const uint32_t labelEnd = (last.high ? last.high : last.low)->range.end;
            labelColonBehind(labelEnd);
            region(labelEnd, tokenBehind(arm.range.end));
            block(arm.body);
        }
        if (stmt.hasElse) {
            // ELSE stands where the labels' CASE does
            size_t at = stmt.arms.empty() ? tokenAt(stmt.value->range.end) : tokenAt(stmt.arms.back().range.end);
            while (at < m_tokens.size() && m_tokens[at].kind != TokenKind::Else) ++at;
            if (at < m_tokens.size()) {
                m_regionEnds.push_back(m_tokens[at].begin);
                m_regionBegins.push_back(m_tokens[at].end);
            }
            block(stmt.elseBody);
        }
        break;
    }
    case StmtKind::For:
    case StmtKind::While:
        region(headerEnd(stmt.kind == StmtKind::While ? stmt.value->range.end : stmt.to->range.end, TokenKind::Do,
                         stmt.range.end),
               m_tokens[lastTokenOf(stmt.range)].begin);
        block(stmt.body);
        break;
    case StmtKind::Repeat: {
        uint32_t end = stmt.value ? stmt.value->range.begin : stmt.range.end;
        for (size_t i = tokenAt(end); i > 0 && m_tokens[i].begin > stmt.range.begin; --i)
            if (m_tokens[i].kind == TokenKind::Until) {
                end = m_tokens[i].begin;
                break;
            }
        region(m_tokens[tokenAt(stmt.range.begin)].end, end);
        block(stmt.body);
        break;
    }
    case StmtKind::Try: {
        const auto part = [&](uint32_t from, uint32_t end, const Block& statements) {
            region(from, tokenBehind(end));
            block(statements);
        };
        for (const IfBranch& branch : stmt.branches)
            part(branch.condition ? headerEnd(branch.condition->range.end, TokenKind::RightParen, stmt.range.end)
                                  : m_tokens[tokenAt(branch.range.begin)].end,
                 branch.range.end, branch.body);
        if (stmt.hasElse) {
            size_t at = tokenAt(stmt.branches.back().range.end);
            while (at < m_tokens.size() && m_tokens[at].kind != TokenKind::Finally) ++at;
            if (at < m_tokens.size()) region(m_tokens[at].end, m_tokens[lastTokenOf(stmt.range)].begin);
            block(stmt.elseBody);
        }
        break;
    }
    case StmtKind::Label:
        labelColonBehind(stmt.name.range.end);
        break;
    case StmtKind::Run:
    case StmtKind::Assert:
    case StmtKind::Force:
    case StmtKind::Release:
    case StmtKind::Compare:
    case StmtKind::PowerOff:
        soft(stmt.range.begin);
        if (stmt.countsScans && stmt.to) softWordsIn({stmt.range.file, stmt.to->range.end, stmt.range.end});
        break;
    case StmtKind::Jump:
        soft(stmt.range.begin);
        break;
    default:
        break;
    }
}

void Structure::chart(const SfcBody& chart) {
    for (const StepDecl* step : chart.steps) {
        begins(step->range.begin);
        soft(step->range.begin);
        inside(step->range);
        labelColonBehind(step->name.range.end);
        for (const ActionAssociation& a : step->actions) begins(a.range.begin);
    }
    for (const TransitionDecl* t : chart.transitions) {
        begins(t->range.begin);
        soft(t->range.begin);
        inside(t->range);
        for (size_t i = tokenAt(t->range.begin);
             i < m_tokens.size() && m_tokens[i].begin < t->range.end && m_tokens[i].kind != TokenKind::To; ++i)
            if ((m_tokens[i].soft == SoftWord::From || m_tokens[i].soft == SoftWord::Priority) &&
                m_tokens[i].begin != t->name.range.begin)
                soft(m_tokens[i].begin);
        if (!t->ilCondition.empty()) body({.language = BodyLanguage::Il, .statements = t->ilCondition});
    }
    for (const ActionDecl* a : chart.actions) {
        inside(a->range); // beside steps, which are indented
        action(*a);
    }
}

void Structure::configuration(const ConfigurationDecl& configuration) {
    soft(configuration.range.begin);
    inside(configuration.range);
    for (const VarSection* s : configuration.sections) section(*s);
    for (const ResourceDecl* resource : configuration.resources) {
        if (resource->name.isValid()) {
            begins(resource->range.begin);
            soft(resource->range.begin);
            if (resource->on.isValid())
                softWordsIn({resource->range.file, resource->name.range.end, resource->on.range.begin});
            inside(resource->range);
        }
        for (const VarSection* s : resource->sections) section(*s);
        for (const TaskDecl* task : resource->tasks) {
            begins(task->range.begin);
            soft(task->range.begin);
        }
        for (const ProgramInstance* program : resource->programs) {
            begins(program->range.begin);
            if (program->task.isValid())
                softWordsIn({program->range.file, program->name.range.end, program->task.range.begin});
        }
    }
}

} // namespace plc::format
