// Changes of CodeModel that reach further than a name: a unit leaves with what refers to it.
#include "projects/analysis/code_model.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <map>

namespace plc::analysis {

using lex::TokenKind;

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

/// The smallest part of a file that can become a comment without leaving half of anything: a statement, a declaration,
/// a program in a RESOURCE, an association of a step, a transition, EXTENDS and IMPLEMENTS.
class Removable {
public:
    Removable(const syntax::SyntaxFile& file, uint32_t at) : m_file(file), m_at(at) { walk(file.declarations); }
    [[nodiscard]] const std::optional<SourceRange>& found() const { return m_found; }

private:
    bool take(const SourceRange& range) {
        if (m_at < range.begin || m_at >= range.end) return false;
        m_found = range;
        return true;
    }
    void block(const syntax::Block& statements) {
        for (const syntax::Stmt* each : statements) {
            if (!take(each->range)) continue;
            block(each->body);
            for (const syntax::IfBranch& branch : each->branches) block(branch.body);
            for (const syntax::CaseArm& arm : each->arms) block(arm.body);
            block(each->elseBody);
        }
    }
    void body(const syntax::Body& of) {
        block(of.instructions.empty() ? of.statements : of.instructions);
        if (!of.chart) return;
        for (const syntax::StepDecl* step : of.chart->steps)
            for (const syntax::ActionAssociation& each : step->actions) take(each.range);
        for (const syntax::TransitionDecl* each : of.chart->transitions) take(each->range);
        for (const syntax::ActionDecl* each : of.chart->actions) body(each->body);
    }
    void sections(const std::vector<syntax::VarSection*>& all) {
        for (const syntax::VarSection* section : all)
            for (const syntax::VarDecl* each : section->declarations) declaration(*each);
    }
    void declaration(const syntax::VarDecl& each) {
        if (take(each.range) && each.type)
            for (const syntax::VarDecl* field : each.type->fields) declaration(*field);
    }
    /// "EXTENDS A", "IMPLEMENTS A"; of several only the name with its comma.
    void clause(const std::vector<syntax::Path>& paths) {
        for (size_t i = 0; i < paths.size(); ++i) {
            if (paths[i].empty()) continue;
            SourceRange range{m_file.file, paths[i].front().range.begin, paths[i].back().range.end};
            if (m_at < range.begin || m_at >= range.end) continue;
            const auto& tokens = m_file.tokens.tokens;
            const auto here = std::find_if(tokens.begin(), tokens.end(),
                                           [&](const lex::Token& token) { return token.begin == range.begin; });
            if (here == tokens.begin() || here == tokens.end()) continue;
            if (paths.size() == 1 || i > 0)
                range.begin = (here - 1)->begin; // the word, or the comma before
            else
                range.end = paths[1].front().range.begin;
            m_found = range;
        }
    }
    void pou(const syntax::Pou& of) {
        clause(of.extends);
        clause(of.implements);
        sections(of.sections);
        body(of.body);
        for (const syntax::Pou* each : of.methods) pou(*each);
        for (const syntax::Property* each : of.properties)
            for (const syntax::Pou* part : {each->get, each->set})
                if (part) pou(*part);
        for (const syntax::ActionDecl* each : of.actions) body(each->body);
    }
    void walk(const std::vector<syntax::Decl*>& declarations) {
        for (const syntax::Decl* each : declarations) {
            if (each->pou) pou(*each->pou);
            if (each->type && take(each->range) && each->type->spec)
                for (const syntax::VarDecl* field : each->type->spec->fields) declaration(*field);
            if (each->globals && each->globals->section) sections({each->globals->section});
            if (each->configuration) {
                sections(each->configuration->sections);
                for (const syntax::ResourceDecl* resource : each->configuration->resources) {
                    sections(resource->sections);
                    for (const syntax::ProgramInstance* program : resource->programs) take(program->range);
                }
            }
            if (each->test) {
                sections(each->test->sections);
                block(each->test->body);
            }
            if (each->space) walk(each->space->declarations);
        }
    }

    const syntax::SyntaxFile& m_file;
    uint32_t m_at;
    std::optional<SourceRange> m_found;
};

/// Takes the semicolon behind, too.
SourceRange withSemicolon(SourceRange range, std::string_view text) {
    uint32_t at = range.end;
    while (at < text.size() && isBlank(text[at])) ++at;
    if (at < text.size() && text[at] == ';') range.end = at + 1;
    return range;
}

/// Whole lines get a // each, a part of a line is put between (* and *).
void commentOut(const SourceRange& range, std::string_view text, std::vector<diagnostics::TextEdit>& out) {
    const size_t newline = range.begin == 0 ? std::string_view::npos : text.rfind('\n', range.begin - 1);
    const size_t first = newline == std::string_view::npos ? 0 : newline + 1;
    bool isAlone = true;
    for (size_t i = first; i < range.begin; ++i) isAlone = isAlone && isBlank(text[i]);
    size_t rest = range.end;
    while (rest < text.size() && isBlank(text[rest])) ++rest;
    isAlone = isAlone && (rest >= text.size() || text[rest] == '\n' || text.substr(rest, 2) == "//");
    if (!isAlone) {
        out.push_back({{range.file, range.begin, range.begin}, "(* "});
        out.push_back({{range.file, range.end, range.end}, " *)"});
        return;
    }
    const size_t indent = range.begin - first;
    for (size_t line = first; line < range.end;) {
        const size_t end = std::min(text.find('\n', line), text.size());
        size_t at = line;
        while (at < end && at - line < indent && isBlank(text[at])) ++at;
        if (text.substr(at, end - at).find_first_not_of(" \t\r") != std::string_view::npos)
            out.push_back({{range.file, static_cast<uint32_t>(at), static_cast<uint32_t>(at)}, "// "});
        line = end + 1;
    }
}

const OutlineItem* itemAt(const std::vector<OutlineItem>& items, uint32_t nameBegin) {
    for (const OutlineItem& item : items) {
        if (item.nameRange.begin == nameBegin) return &item;
        if (const OutlineItem* inner = itemAt(item.children, nameBegin)) return inner;
    }
    return nullptr;
}

/// With the comments and pragmas that stand directly above, and the rest of its last line when that is empty.
SourceRange wholeUnit(SourceRange range, const lex::TokenList& tokens, std::string_view text) {
    const auto isDirectlyBefore = [&](uint32_t begin, uint32_t end) {
        if (end > range.begin) return false;
        const std::string_view between = text.substr(end, range.begin - end);
        if (between.find_first_not_of(" \t\r\n") != std::string_view::npos ||
            std::count(between.begin(), between.end(), '\n') > 1)
            return false;
        while (begin > 0 && isBlank(text[begin - 1])) --begin;
        return begin == 0 || text[begin - 1] == '\n';
    };
    for (bool grew = true; grew;) {
        grew = false;
        for (const lex::Comment& comment : tokens.comments)
            if (isDirectlyBefore(comment.begin, comment.end)) range.begin = comment.begin, grew = true;
        for (const lex::Token& token : tokens.tokens)
            if (token.kind == TokenKind::Pragma && isDirectlyBefore(token.begin, token.end))
                range.begin = token.begin, grew = true;
    }
    while (range.end < text.size() && (isBlank(text[range.end]) || text[range.end] == ';')) ++range.end;
    if (range.end < text.size() && text[range.end] == '\n') ++range.end;
    while (range.begin > 0 && isBlank(text[range.begin - 1])) --range.begin;
    // Of the empty lines around one is enough.
    if (range.begin >= 2 && text[range.begin - 1] == '\n' && text[range.begin - 2] == '\n' && range.end < text.size() &&
        text[range.end] == '\n')
        ++range.end;
    return range;
}

} // namespace

std::vector<FileEdits> CodeModel::removal(FileId file, uint32_t offset, bool commentsOutUses) const {
    const auto& files = m_checked.analysis->files;
    const std::vector<OutlineItem> items = outline(file);
    const OutlineItem* item = itemAt(items, offset);
    if (!item) return {};
    const SourceRange gone = wholeUnit(item->range, files[file.index()]->tokens, sources()[file].text());
    std::map<FileId, std::vector<SourceRange>> commented;
    if (commentsOutUses)
        for (const Use& use : uses(file, offset)) {
            const bool isGone = use.range.file == file && use.range.begin >= gone.begin && use.range.end <= gone.end;
            if (use.isDeclaration || isGone || !files[use.range.file.index()]->library.empty()) continue;
            const auto found = Removable(*files[use.range.file.index()], use.range.begin).found();
            SourceRange range = withSemicolon(found.value_or(use.range), sources()[use.range.file].text());
            range.file = use.range.file;
            auto& here = commented[use.range.file];
            const auto holds = [](const SourceRange& outer, const SourceRange& inner) {
                return outer.begin <= inner.begin && outer.end >= inner.end;
            };
            if (std::any_of(here.begin(), here.end(), [&](const SourceRange& other) { return holds(other, range); }))
                continue;
            std::erase_if(here, [&](const SourceRange& other) { return holds(range, other); });
            here.push_back(range);
        }
    std::map<FileId, std::vector<diagnostics::TextEdit>> edits;
    edits[file].push_back({gone, ""});
    for (const auto& [where, ranges] : commented)
        for (const SourceRange& range : ranges) commentOut(range, sources()[where].text(), edits[where]);
    std::vector<FileEdits> out;
    for (auto& [where, list] : edits) {
        std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.range.begin < b.range.begin; });
        out.push_back({where, std::move(list)});
    }
    return out;
}

} // namespace plc::analysis
