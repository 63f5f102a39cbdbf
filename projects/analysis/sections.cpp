#include "projects/analysis/sections.h"

#include "runtime/compiler/parse/section_keyword.h"

#include <algorithm>

namespace plc::analysis {

using syntax::SectionKind;

std::optional<uint32_t> lineOfEnd(const syntax::VarSection& section, std::string_view text) {
    const size_t end = text.substr(section.range.begin, section.range.length()).rfind('\n'); // the line of END_VAR
    if (end == std::string_view::npos) return std::nullopt;
    return static_cast<uint32_t>(section.range.begin + end + 1);
}

namespace {

/// "    name : TYPE := value;" as a line of its own.
std::string lineOf(const syntax::VarDecl& declaration, size_t name, std::string_view text) {
    const auto slice = [&](SourceRange range) { return std::string(text.substr(range.begin, range.length())); };
    std::string line = "    " + std::string(declaration.names[name].text);
    if (!declaration.address.empty()) line += " AT " + std::string(declaration.address);
    if (declaration.type) line += " : " + slice(declaration.type->range);
    if (declaration.initial) line += " := " + slice(declaration.initial->range);
    return line + ";\n";
}

/// What stands in front of and behind the declaration on its lines is another one's.
bool sharesLine(const syntax::VarSection& section, const syntax::VarDecl& declaration, SourceRange lines) {
    const bool isBeside = section.range.begin >= lines.begin || section.range.end <= lines.end;
    return isBeside ||
           std::any_of(section.declarations.begin(), section.declarations.end(), [&](const syntax::VarDecl* other) {
               return other != &declaration && other->range.begin < lines.end && other->range.end > lines.begin;
           });
}

/// One name of several goes with its comma; the last of a line that others share with its semicolon.
SourceRange withoutName(const syntax::VarDecl& declaration, size_t name, std::string_view text) {
    SourceRange gone = declaration.names[name].range;
    if (declaration.names.size() > 1) {
        if (name > 0)
            gone.begin = declaration.names[name - 1].range.end;
        else
            gone.end = declaration.names[1].range.begin;
        return gone;
    }
    gone = declaration.range;
    const size_t semicolon = text.find(';', gone.end - 1);
    if (semicolon != std::string_view::npos) gone.end = static_cast<uint32_t>(semicolon + 1);
    while (gone.end < text.size() && text[gone.end] == ' ') ++gone.end;
    return gone;
}

} // namespace

uint32_t lineBegin(std::string_view text, uint32_t at) {
    while (at > 0 && text[at - 1] != '\n') --at;
    return at;
}

diagnostics::TextEdit declareIn(const syntax::Pou& pou, SectionKind kind, FileId file, std::string_view text,
                                const std::string& line) {
    for (const syntax::VarSection* section : pou.sections)
        if (section->kind == kind && !section->constant && !section->retain && !section->persistent)
            if (const auto at = lineOfEnd(*section, text)) return {{file, *at, *at}, line};
    uint32_t at = pou.header.end;
    if (kind != SectionKind::Input || pou.sections.empty())
        for (const syntax::VarSection* section : pou.sections) at = std::max(at, section->range.end);
    else
        at = pou.sections.front()->range.begin;
    if (kind == SectionKind::Input && !pou.sections.empty())
        at = lineBegin(text, at);
    else {
        while (at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\t' || text[at - 1] == '\n' || text[at - 1] == '\r'))
            --at; // what is between header and first statement may be empty lines
        while (at < text.size() && text[at] != '\n') ++at;
        if (at < text.size()) ++at;
    }
    return {{file, at, at}, std::string(syntax::keywordOf(kind)) + "\n" + line + "END_VAR\n"};
}

std::vector<diagnostics::TextEdit> moveToSection(const syntax::Pou& pou, const syntax::VarSection& from,
                                                 const syntax::VarDecl& declaration, size_t name, SectionKind to,
                                                 SourceRange lines, std::string_view text) {
    if (from.kind == to && !from.constant && !from.retain && !from.persistent) return {};
    const FileId file = declaration.range.file;
    const bool isWhole = declaration.names.size() == 1 && !sharesLine(from, declaration, lines);
    SourceRange gone = isWhole ? lines : withoutName(declaration, name, text);
    std::string moved =
        isWhole ? std::string(text.substr(lines.begin, lines.length())) : lineOf(declaration, name, text);
    if (!moved.ends_with('\n')) moved += '\n';
    // The last one takes its section along.
    const bool isLast = isWhole && from.declarations.size() == 1;
    if (isLast) {
        const std::string_view before = text.substr(from.range.begin, lines.begin - from.range.begin),
                               behind = text.substr(lines.end, from.range.end - lines.end);
        const bool isPlain = before.find('\n') == before.size() - 1 && behind.find('\n') == std::string_view::npos;
        if (isPlain) {
            gone = {file, lineBegin(text, from.range.begin), from.range.end};
            while (gone.end < text.size() && text[gone.end] != '\n') ++gone.end;
            if (gone.end < text.size()) ++gone.end;
        }
    }
    diagnostics::TextEdit put = declareIn(pou, to, file, text, moved);
    if (put.range.begin > gone.begin && put.range.begin < gone.end) return {};
    gone.file = file;
    if (put.range.begin == gone.begin || put.range.begin == gone.end) return {{gone, put.text}};
    std::vector<diagnostics::TextEdit> out{{gone, ""}, std::move(put)};
    if (out[1].range.begin < out[0].range.begin) std::swap(out[0], out[1]);
    return out;
}

} // namespace plc::analysis
