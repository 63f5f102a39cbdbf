// Declarations that CodeModel writes: of an unknown name in the unit around it or among the globals, of an unknown
// member in the block, program or structure it should belong to.
#include "projects/analysis/code_model.h"

#include "projects/analysis/sections.h"
#include "runtime/base/text.h"

#include <algorithm>

namespace plc::analysis {

using lex::TokenKind;
using sema::Symbol;
using syntax::SectionKind;

namespace {

template <class Visit> void forEach(const std::vector<syntax::Decl*>& declarations, const Visit& visit) {
    for (const syntax::Decl* each : declarations) {
        visit(*each);
        if (each->kind == syntax::DeclKind::Namespace) forEach(each->space->declarations, visit);
    }
}

} // namespace

/// Called → a block is unknown; assigned from or to a literal or variable; a condition is BOOL.
std::string CodeModel::suggestedType(FileId file, uint32_t offset) const {
    const sema::Analysis& analysis = *m_checked.analysis;
    const std::string_view text = (*m_checked.sources)[file].text();
    const lex::TokenList& list = analysis.files[file.index()]->tokens;
    const auto typeOf = [&](const lex::Token& token) -> std::string {
        const std::string_view word = text.substr(token.begin, token.end - token.begin);
        switch (token.kind) {
        case TokenKind::True:
        case TokenKind::False:
        case TokenKind::Not:
            return "BOOL";
        case TokenKind::RealLiteral:
            return "REAL";
        case TokenKind::IntegerLiteral:
            return "INT";
        case TokenKind::DurationLiteral:
            return "TIME";
        case TokenKind::StringLiteral:
            return "STRING";
        case TokenKind::WstringLiteral:
            return "WSTRING";
        case TokenKind::Identifier: {
            const Symbol* symbol = findVisible(word, pouAt(file, offset));
            return symbol && symbol->type.isValid() && analysis.program ? (*analysis.program->types)[symbol->type].name
                                                                        : "";
        }
        default:
            return "";
        }
    };
    for (size_t i = 0; i + 2 < list.tokens.size(); ++i) {
        if (list.tokens[i].begin > offset || list.tokens[i].end <= offset) continue;
        const TokenKind next = list.tokens[i + 1].kind;
        std::string guess;
        if (next == TokenKind::Assign || (next >= TokenKind::Plus && next <= TokenKind::GreaterEqual))
            guess = typeOf(list.tokens[i + 2]);
        else if (i > 1 && list.tokens[i - 1].kind == TokenKind::Assign)
            guess = typeOf(list.tokens[i - 2]);
        else if (next == TokenKind::Then || next == TokenKind::And || next == TokenKind::Or ||
                 (i > 0 && (list.tokens[i - 1].kind == TokenKind::And || list.tokens[i - 1].kind == TokenKind::Not ||
                            list.tokens[i - 1].kind == TokenKind::If)))
            guess = "BOOL";
        return guess.empty() ? "INT" : guess;
    }
    return "INT";
}

std::optional<diagnostics::TextEdit> CodeModel::autoDeclare(FileId file, uint32_t offset, std::string_view name,
                                                            SectionKind section) const {
    const sema::Analysis& analysis = *m_checked.analysis;
    if (file.index() >= analysis.files.size()) return std::nullopt;
    const syntax::Pou* around = nullptr;
    forEach(analysis.files[file.index()]->declarations, [&](const syntax::Decl& each) {
        if (each.kind != syntax::DeclKind::Pou || offset < each.pou->range.begin || offset > each.pou->range.end)
            return;
        around = each.pou;
        for (const syntax::Pou* method : each.pou->methods)
            if (offset >= method->range.begin && offset <= method->range.end) around = method;
    });
    if (!around) return std::nullopt;
    const std::string line = "    " + std::string(name) + " : " + suggestedType(file, offset) + ";\n";
    if (section != SectionKind::Global)
        return declareIn(*around, section, file, (*m_checked.sources)[file].text(), line);
    for (size_t i = 0; i < analysis.files.size(); ++i) {
        if (!analysis.files[i]->library.empty()) continue;
        std::optional<diagnostics::TextEdit> edit;
        forEach(analysis.files[i]->declarations, [&](const syntax::Decl& each) {
            if (edit || each.kind != syntax::DeclKind::Globals || !each.globals->section ||
                each.globals->section->constant)
                return;
            if (const auto at = lineOfEnd(*each.globals->section, (*m_checked.sources)[FileId(i)].text()))
                edit = diagnostics::TextEdit{{FileId(i), *at, *at}, line};
        });
        if (edit) return edit;
    }
    return std::nullopt;
}

std::optional<diagnostics::TextEdit> CodeModel::declareMember(FileId file, uint32_t offset, std::string_view owner,
                                                              std::string_view name) const {
    const sema::Analysis& analysis = *m_checked.analysis;
    std::optional<diagnostics::TextEdit> edit;
    const std::string line = "    " + std::string(name) + " : " + suggestedType(file, offset) + ";\n";
    for (size_t i = 0; i < analysis.files.size() && !edit; ++i) {
        if (!analysis.files[i]->library.empty()) continue;
        const std::string_view text = (*m_checked.sources)[FileId(i)].text();
        forEach(analysis.files[i]->declarations, [&](const syntax::Decl& each) {
            if (each.kind == syntax::DeclKind::Pou && equalsIgnoringCase(each.pou->name.text, owner))
                edit = declareIn(*each.pou, SectionKind::Input, FileId(i), text, line);
            if (each.kind != syntax::DeclKind::Type || !each.type->spec ||
                !equalsIgnoringCase(each.type->name.text, owner) || each.type->spec->fields.empty())
                return;
            const uint32_t last = each.type->spec->fields.back()->range.end;
            const size_t newline = text.find('\n', last);
            if (newline == std::string_view::npos) return;
            const auto at = static_cast<uint32_t>(newline + 1);
            edit = diagnostics::TextEdit{{FileId(i), at, at}, line};
        });
    }
    return edit;
}

} // namespace plc::analysis
