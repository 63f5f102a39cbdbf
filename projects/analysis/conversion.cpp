#include "projects/analysis/conversion.h"

#include "projects/analysis/sections.h"
#include "runtime/base/messages.h"
#include "runtime/base/text.h"
#include "runtime/compiler/lower/convert.h"
#include "runtime/compiler/parse/parser.h"

#include <algorithm>
#include <functional>
#include <map>
#include <optional>

namespace plc::analysis {

namespace {

using syntax::BodyLanguage;

/// A body and the unit that holds its variables.
struct Found {
    std::string unit;
    const syntax::Pou* pou = nullptr;
    const syntax::Body* body = nullptr;
    SourceRange header; // of what the body belongs to: PROGRAM …, ACTION …
    bool isInner = false;
};

void collect(const std::vector<syntax::Decl*>& declarations, std::vector<Found>& out) {
    const auto add = [&](const std::string& unit, const syntax::Pou& pou, const syntax::Body& body, SourceRange header,
                         bool isInner) {
        if (body.language == BodyLanguage::St || body.language == BodyLanguage::Il)
            out.push_back({unit, &pou, &body, header, isInner});
    };
    for (const syntax::Decl* decl : declarations) {
        if (decl->space) collect(decl->space->declarations, out);
        if (!decl->pou || decl->pou->kind == syntax::PouKind::Interface) continue;
        const syntax::Pou& pou = *decl->pou;
        const std::string name(pou.name.text);
        add(name, pou, pou.body, pou.range, false);
        for (const syntax::Pou* method : pou.methods)
            add(name + "." + std::string(method->name.text), *method, method->body, method->range, true);
        const std::function<void(const std::vector<syntax::ActionDecl*>&)> actions =
            [&](const std::vector<syntax::ActionDecl*>& list) {
                for (const syntax::ActionDecl* action : list) {
                    add(name + "." + std::string(action->name.text), pou, action->body, action->range, true);
                    if (action->body.chart) actions(action->body.chart->actions);
                }
            };
        actions(pou.actions);
        if (pou.body.chart) actions(pou.body.chart->actions);
    }
}

std::string blanksBefore(std::string_view text, uint32_t at) {
    while (at > 0 && text[at - 1] != '\n') --at;
    size_t end = at;
    while (end < text.size() && (text[end] == ' ' || text[end] == '\t')) ++end;
    return std::string(text.substr(at, end - at));
}
bool isBlank(std::string_view text) { return text.find_first_not_of(" \t\r") == std::string_view::npos; }

std::string indented(const std::string& lines, const std::string& indent, const std::string& lineEnd) {
    std::string out;
    for (size_t at = 0; at < lines.size();) {
        const size_t end = std::min(lines.find('\n', at), lines.size());
        if (!out.empty()) out += lineEnd;
        if (end > at) out += indent + lines.substr(at, end - at);
        at = end + 1;
    }
    return out;
}

size_t errorsOf(const driver::Checked& checked) {
    return static_cast<size_t>(std::count_if(checked.analysis->diagnostics.begin(), checked.analysis->diagnostics.end(),
                                             [](const auto& d) { return d.severity == diagnostics::Severity::Error; }));
}

/// Where the pragma {language 'IL'} stands that decided the body's language, if one did.
std::optional<diagnostics::TextEdit> languagePragma(const syntax::SyntaxFile& file, std::string_view text,
                                                    const Found& found, TextLanguage to) {
    for (const lex::Token& token : file.tokens.tokens) {
        if (token.kind != lex::TokenKind::Pragma || token.begin > found.body->range.begin) continue;
        const uint32_t from = found.pou && !found.isInner && !found.pou->pragmas.empty()
                                  ? found.pou->pragmas.front().range.begin
                                  : found.header.begin;
        const std::string inside = foldCase(text.substr(token.begin, token.end - token.begin));
        if (token.begin < from || inside.find("language") == std::string::npos) continue;
        return diagnostics::TextEdit{{found.body->range.file, token.begin, token.end},
                                     to == TextLanguage::Il ? "{language 'IL'}" : "{language 'ST'}"};
    }
    return std::nullopt;
}

/// Types of what an instruction list keeps, from a check of the whole project that keeps no more than the text will.
lower::TypeNamer typesOf(const driver::BuildInput& input, size_t file, const Found& found) {
    driver::BuildInput needed = input;
    needed.keepsEveryResult = false;
    const driver::Checked checked = driver::check(needed);
    const std::string owner =
        found.isInner && found.unit.find('.') != std::string::npos && found.pou->kind != syntax::PouKind::Method
            ? found.unit.substr(0, found.unit.find('.'))
            : found.unit;
    std::map<std::pair<uint32_t, uint32_t>, std::vector<std::string>> names;
    for (const sema::Symbol& symbol : checked.analysis->symbols)
        if ((symbol.name.starts_with("__il") || symbol.name.starts_with("__at_")) &&
            symbol.declaration.file == FileId(file) && equalsIgnoringCase(symbol.owner, owner) &&
            symbol.type.isValid() && checked.analysis->program)
            names[{symbol.declaration.begin, symbol.declaration.end}].push_back(
                (*checked.analysis->program->types)[symbol.type].name);
    return [names](SourceRange place, size_t number) {
        const auto it = names.find({place.begin, place.end});
        return it == names.end() || number >= it->second.size() ? std::string() : it->second[number];
    };
}

} // namespace

std::vector<BodyPlace> bodiesOf(std::string_view text) {
    diagnostics::Sink sink;
    const auto file = parse::parseFile(FileId(size_t(0)), text, sink);
    std::vector<Found> all;
    collect(file->declarations, all);
    std::vector<BodyPlace> out;
    for (const Found& found : all)
        out.push_back(
            {found.unit, found.body->language == BodyLanguage::Il ? TextLanguage::Il : TextLanguage::St, found.header});
    std::sort(out.begin(), out.end(),
              [](const BodyPlace& a, const BodyPlace& b) { return a.range.begin < b.range.begin; });
    return out;
}

Result<Conversion> convertBody(const driver::BuildInput& input, std::string_view path, std::string_view unit,
                               TextLanguage to) {
    size_t index = 0;
    while (index < input.files.size() && input.files[index].path != path) ++index;
    if (index == input.files.size()) return Error{errors::NoSuchFileInProject(), std::string(path)};
    const std::string& text = input.files[index].text;
    diagnostics::Sink sink;
    const auto file = parse::parseFile(FileId(index), text, sink);
    std::vector<Found> all;
    collect(file->declarations, all);
    const auto it =
        std::find_if(all.begin(), all.end(), [&](const Found& found) { return equalsIgnoringCase(found.unit, unit); });
    if (it == all.end()) return Error{errors::NoBodyToConvert(), std::string(unit)};
    const Found& found = *it;
    const TextLanguage from = found.body->language == BodyLanguage::Il ? TextLanguage::Il : TextLanguage::St;
    if (from == to) return Error{to == TextLanguage::St ? errors::AlreadySt(unit) : errors::AlreadyIl(unit), ""};
    for (const diagnostics::Diagnostic& d : sink.all())
        if (d.severity == diagnostics::Severity::Error && d.range.begin >= found.header.begin &&
            d.range.begin <= found.header.end)
            return Error{errors::FixTextFirst(d.message), std::string(unit)};

    const Result<lower::ConvertedBody> converted =
        to == TextLanguage::St
            ? lower::instructionListAsSt(*file, *found.pou, *found.body, typesOf(input, index, found), text)
            : lower::stAsInstructionList(*file, *found.body, text);
    if (!converted) return converted.error();

    // The new body in place of the old one, as far in as its unit; its variables behind the unit's last section.
    const std::string lineEnd = text.find("\r\n") != std::string::npos ? "\r\n" : "\n";
    const SourceRange old = found.body->range;
    const std::string outer = blanksBefore(text, found.header.begin);
    const std::string indent = to == TextLanguage::Il ? outer : outer + (found.isInner ? "    " : "");
    uint32_t begin = lineBegin(text, old.begin);
    std::string lines = indented(converted->body, indent, lineEnd);
    if (!isBlank(std::string_view(text).substr(begin, old.begin - begin))) {
        begin = old.begin;
        lines = lineEnd + lines;
    }
    const size_t lineStop = std::min(text.find('\n', old.end), text.size());
    const std::string_view behind = std::string_view(text).substr(old.end, lineStop - old.end);
    if (!isBlank(behind) && !behind.substr(behind.find_first_not_of(" \t")).starts_with("//") &&
        !behind.substr(behind.find_first_not_of(" \t")).starts_with("(*"))
        lines += lineEnd + outer;
    Conversion out;
    out.unit = found.unit;
    if (!converted->declarations.empty()) {
        const std::string block = outer + "VAR" + lineEnd + indented(converted->declarations, outer + "    ", lineEnd) +
                                  lineEnd + outer + "END_VAR" + lineEnd;
        const bool none = found.pou->sections.empty();
        uint32_t at = none ? found.pou->header.end : found.pou->sections.back()->range.end;
        at = static_cast<uint32_t>(std::min(text.find('\n', at), text.size() - 1) + 1);
        if (at > old.begin) at = begin; // all on one line
        if (at == begin)
            lines = block + lines; // one edit: two at one place have no order
        else
            out.edits.push_back({{FileId(index), at, at}, block});
    }
    if (auto pragma = languagePragma(*file, text, found, to)) out.edits.push_back(*pragma);
    out.edits.push_back({{FileId(index), begin, old.end}, lines});
    std::stable_sort(out.edits.begin(), out.edits.end(),
                     [](const auto& a, const auto& b) { return a.range.begin < b.range.begin; });
    const auto apply = [&] {
        out.text = text;
        for (size_t i = out.edits.size(); i-- > 0;)
            out.text.replace(out.edits[i].range.begin, out.edits[i].range.length(), out.edits[i].text);
    };
    apply();
    // A list whose first words could be a statement says what it is.
    const auto languageNow = [&]() -> std::optional<TextLanguage> {
        for (const BodyPlace& place : bodiesOf(out.text))
            if (equalsIgnoringCase(place.unit, found.unit)) return place.language;
        return std::nullopt;
    };
    if (languageNow() != to) {
        out.edits.back().text =
            indent + (to == TextLanguage::Il ? "{language 'IL'}" : "{language 'ST'}") + lineEnd + out.edits.back().text;
        apply();
    }
    // The proof is a check of the whole project: what is no worse than before is offered, everything else is refused
    // with the first error as the reason.
    driver::BuildInput after = input;
    after.files[index].text = out.text;
    const size_t errorsBefore = errorsOf(driver::check(input));
    const driver::Checked checked = driver::check(after);
    if (errorsOf(checked) > errorsBefore)
        for (const diagnostics::Diagnostic& d : checked.analysis->diagnostics)
            if (d.severity == diagnostics::Severity::Error) return Error{errors::NoEquivalent(d.message), found.unit};
    return out;
}

} // namespace plc::analysis
