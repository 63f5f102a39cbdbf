// While a text is being written: completion, help with parameters, layout, fixes.
#include "projects/language_server/server.h"
#include "projects/protocol/errors.h"
#include "runtime/base/text.h"
#include "runtime/compiler/format/format.h"

#include <algorithm>

namespace plc::lsp {

using analysis::CompletionItem;
using analysis::ItemKind;
using diagnostics::Diagnostic;
using diagnostics::TextEdit;

// ---------------------------------------------------------------- completion

namespace {

/// CompletionItemKind of the protocol.
int kindNumber(ItemKind kind) {
    switch (kind) {
    case ItemKind::Keyword:
        return 14;
    case ItemKind::Snippet:
        return 15;
    case ItemKind::Variable:
        return 6;
    case ItemKind::Constant:
        return 21;
    case ItemKind::EnumValue:
        return 20;
    case ItemKind::Type:
        return 22;
    case ItemKind::Function:
        return 3;
    case ItemKind::Block:
        return 7;
    case ItemKind::Program:
        return 9;
    case ItemKind::Method:
        return 2;
    case ItemKind::Property:
        return 10;
    case ItemKind::Parameter:
        return 5;
    case ItemKind::Namespace:
        return 9;
    }
    return 1;
}

/// "IF | THEN" → "IF $0 THEN", what means something to a snippet escaped.
std::string snippetOf(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '|') {
            out += "$0";
            continue;
        }
        if (c == '$' || c == '}' || c == '\\') out += '\\';
        out += c;
    }
    return out;
}

std::string labelOf(const CompletionItem& item) {
    std::string label = item.text.substr(0, item.text.find('\n'));
    std::erase(label, '|');
    return label;
}

std::string rankText(size_t index) {
    std::string digits = std::to_string(index);
    return std::string(6 - std::min<size_t>(digits.size(), 6), '0') + digits;
}

} // namespace

Answer Server::completion(const Json& parameters) {
    const SpotOf found = spotAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const Spot& spot = std::get<Spot>(found);
    const Places& places = *spot.document->places;
    analysis::Completion completion = spot.model().complete(spot.file, places.text(), spot.offset);
    const Json range = places.range(completion.replaceBegin, std::max(completion.replaceEnd, spot.offset));
    ++m_offer;
    Json items = Json::array();
    for (size_t i = 0; i < completion.items.size(); ++i) {
        const CompletionItem& item = completion.items[i];
        const bool isSnippet = item.kind == ItemKind::Snippet && item.text.find('|') != std::string::npos;
        std::string text = item.text;
        if (isSnippet && m_takesSnippets)
            text = snippetOf(text);
        else if (isSnippet)
            std::erase(text, '|');
        Json out{{"label", labelOf(item)}, {"kind", kindNumber(item.kind)}, {"sortText", rankText(i)}};
        if (!item.detail.empty()) out["detail"] = item.detail;
        if (isSnippet && m_takesSnippets) out["insertTextFormat"] = 2;
        out["textEdit"] = {{"range", range}, {"newText", std::move(text)}};
        out["data"] = {{"list", m_offer}, {"item", i}};
        items.push_back(std::move(out));
    }
    m_offered = std::move(completion.items);
    return Json{{"isIncomplete", false}, {"items", std::move(items)}};
}

Answer Server::resolveCompletion(const Json& parameters) {
    if (!parameters.is_object()) return protocol::wrongParameter("completionItem/resolve", "label");
    Json item = parameters;
    const auto list = protocol::integerAt(parameters, "data.list"),
               index = protocol::integerAt(parameters, "data.item");
    if (!list || !index || *list != static_cast<int64_t>(m_offer) || *index < 0 ||
        static_cast<size_t>(*index) >= m_offered.size())
        return item; // of a list that is gone
    const std::string& comment = m_offered[static_cast<size_t>(*index)].comment;
    if (!comment.empty()) item["documentation"] = {{"kind", "markdown"}, {"value", comment}};
    return item;
}

Answer Server::signatureHelp(const Json& parameters) {
    const SpotOf found = spotAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const Spot& spot = std::get<Spot>(found);
    const auto help = spot.model().parameterHelp(spot.file, spot.document->places->text(), spot.offset);
    if (!help) return Json(nullptr);
    std::string label = help->callee + "(";
    Json all = Json::array();
    for (const analysis::ParameterHelp::Parameter& each : help->parameters) {
        if (label.back() != '(') label += ", ";
        const size_t begin = utf8ToUtf16(label).size();
        label += each.name + (each.type.empty() ? "" : " : " + each.type);
        Json parameter{{"label", {begin, utf8ToUtf16(label).size()}}};
        if (!each.comment.empty()) parameter["documentation"] = each.comment;
        all.push_back(std::move(parameter));
    }
    Json signature{{"label", label + ")"}, {"parameters", std::move(all)}};
    return Json{{"signatures", Json::array({std::move(signature)})},
                {"activeSignature", 0},
                {"activeParameter", help->current}};
}

// ---------------------------------------------------------------- layout

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

size_t behindBlanks(std::string_view text, size_t at) {
    while (at < text.size() && isBlank(text[at])) ++at;
    return at;
}

/// Words that differ in nothing but case.
size_t behindSame(std::string_view before, size_t at, std::string_view after, size_t to, bool areEqual) {
    size_t count = 0;
    while (at + count < before.size() && to + count < after.size() && !isBlank(before[at + count]) &&
           std::tolower(static_cast<unsigned char>(before[at + count])) ==
               std::tolower(static_cast<unsigned char>(after[to + count])) &&
           (before[at + count] == after[to + count]) == areEqual)
        ++count;
    return count;
}

TextEdit editOf(size_t begin, size_t end, std::string_view text) {
    return {{FileId(size_t(0)), static_cast<uint32_t>(begin), static_cast<uint32_t>(end)}, std::string(text)};
}

} // namespace

std::vector<TextEdit> formattingEdits(std::string_view before, std::string_view after) {
    std::vector<TextEdit> edits;
    size_t at = 0, to = 0;
    while (at < before.size() || to < after.size()) {
        const size_t atEnd = behindBlanks(before, at), toEnd = behindBlanks(after, to);
        const std::string_view blanks = before.substr(at, atEnd - at), wanted = after.substr(to, toEnd - to);
        if (blanks != wanted) edits.push_back(editOf(at, atEnd, wanted));
        at = atEnd;
        to = toEnd;
        const size_t same = behindSame(before, at, after, to, true);
        at += same;
        to += same;
        const size_t other = behindSame(before, at, after, to, false);
        if (other > 0) edits.push_back(editOf(at, at + other, after.substr(to, other)));
        at += other;
        to += other;
        const bool isOver = at >= before.size() && to >= after.size();
        if (!isOver && atEnd == at && toEnd == to && blanks.empty() && wanted.empty())
            return {editOf(0, before.size(), after)}; // more than blanks and case
    }
    return edits;
}

Answer Server::formatting(const Json& parameters) {
    const SpotOf found = documentAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const Spot& spot = std::get<Spot>(found);
    const Places& places = *spot.document->places;
    uint32_t from = 0, to = UINT32_MAX;
    if (protocol::find(parameters, "range")) {
        const auto start = positionAt(parameters, "range.start"), end = positionAt(parameters, "range.end");
        if (!start || !end) return protocol::wrongParameter("textDocument/rangeFormatting", "range");
        from = places.offsetOf({start->line, 0});
        to = places.offsetOf(*end);
    }
    format::FormatOptions options;
    options.indentWidth =
        static_cast<int>(std::clamp<int64_t>(protocol::integerAt(parameters, "options.tabSize").value_or(4), 1, 16));
    options.useTabs = !protocol::flagAt(parameters, "options.insertSpaces", true);
    Json out = Json::array();
    for (const TextEdit& edit : formattingEdits(places.text(), format::format(places.text(), options)))
        if (edit.range.end >= from && edit.range.begin <= to)
            out.push_back({{"range", places.range(edit.range.begin, edit.range.end)}, {"newText", edit.text}});
    return out;
}

// ---------------------------------------------------------------- fixes

namespace {

struct Choice {
    Message title;
    std::vector<TextEdit> edits;
};

/// "x : INT" of the lines that are put in.
std::string declaredIn(std::string_view text) {
    text = text.substr(0, text.find(';'));
    const size_t line = text.rfind('\n');
    if (line != std::string_view::npos) text.remove_prefix(line + 1);
    const size_t begin = text.find_first_not_of(" \t\r");
    return begin == std::string_view::npos ? std::string() : std::string(text.substr(begin));
}

void addDeclarations(const analysis::CodeModel& model, FileId file, const Diagnostic& diagnostic,
                     std::vector<Choice>& choices) {
    using diagnostics::Kind;
    using syntax::SectionKind;
    namespace errors = protocol::errors;
    const std::string_view name = diagnostic.message.name(0);
    if (name.empty()) return;
    const uint32_t at = diagnostic.range.begin;
    if (diagnostic.kind == Kind::UndeclaredName) {
        const std::pair<SectionKind, const messages::TypedForm<messages::Name>*> sections[] = {
            {SectionKind::Var, &errors::DeclareName},
            {SectionKind::Input, &errors::DeclareInput},
            {SectionKind::Output, &errors::DeclareOutput},
            {SectionKind::Global, &errors::DeclareGlobal}};
        for (const auto& [section, title] : sections)
            if (const auto edit = model.autoDeclare(file, at, name, section))
                choices.push_back({(*title)(declaredIn(edit->text)), {*edit}});
    }
    if (diagnostic.kind == Kind::UnknownMember || diagnostic.kind == Kind::UnknownParameter)
        if (const auto edit = model.declareMember(file, at, name, diagnostic.message.name(1)))
            choices.push_back({errors::DeclareMember(declaredIn(edit->text), name), {*edit}});
}

std::vector<analysis::FileEdits> byFile(std::vector<TextEdit> edits, FileId home) {
    std::vector<analysis::FileEdits> out;
    for (TextEdit& edit : edits) {
        const FileId file = edit.range.file.isValid() ? edit.range.file : home;
        auto it = std::find_if(out.begin(), out.end(), [&](const auto& each) { return each.file == file; });
        if (it == out.end()) it = out.insert(it, {file, {}});
        it->edits.push_back(std::move(edit));
    }
    return out;
}

} // namespace

Answer Server::codeActions(const Json& parameters) {
    const SpotOf found = documentAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const Spot& spot = std::get<Spot>(found);
    const auto start = positionAt(parameters, "range.start"), end = positionAt(parameters, "range.end");
    if (!start || !end) return protocol::wrongParameter("textDocument/codeAction", "range");
    const Places& places = spot.desk->places(spot.file);
    const uint32_t from = places.offsetOf(*start), to = places.offsetOf(*end);
    Json out = Json::array();
    for (const Diagnostic& diagnostic : spot.model().diagnostics()) {
        if (diagnostic.range.file != spot.file || diagnostic.range.begin > to || diagnostic.range.end < from) continue;
        std::vector<Choice> choices;
        for (const diagnostics::Fix& fix : diagnostic.fixes) choices.push_back({fix.title, fix.edits});
        addDeclarations(spot.model(), spot.file, diagnostic, choices);
        for (Choice& choice : choices)
            out.push_back({{"title", choice.title.english()},
                           {"kind", "quickfix"},
                           {"edit", workspaceEdit(*spot.desk, byFile(std::move(choice.edits), spot.file))}});
    }
    return out;
}

} // namespace plc::lsp
