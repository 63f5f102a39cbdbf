// What a text is made of: symbols, folds, colours, and the names whose values a debugger shows beside the lines.
#include "projects/analysis/block_structure.h"
#include "projects/language_server/server.h"
#include "runtime/base/text.h"

#include <algorithm>

namespace plc::lsp {

using analysis::OutlineItem;
using analysis::TokenClass;

namespace {

/// SymbolKind of the protocol.
int kindNumber(const OutlineItem& item) {
    if (item.isTest) return 24;
    switch (item.kind) {
    case sema::SymbolKind::Program:
        return 2;
    case sema::SymbolKind::FunctionBlock:
        return 5;
    case sema::SymbolKind::Function:
    case sema::SymbolKind::StandardFunction:
        return 12;
    case sema::SymbolKind::Method:
    case sema::SymbolKind::Action:
        return 6;
    case sema::SymbolKind::Property:
        return 7;
    case sema::SymbolKind::Interface:
        return 11;
    case sema::SymbolKind::Type:
        return 23;
    case sema::SymbolKind::Namespace:
    case sema::SymbolKind::GlobalList:
        return 3;
    case sema::SymbolKind::Step:
    case sema::SymbolKind::Label:
        return 20;
    case sema::SymbolKind::Task:
        return 24;
    case sema::SymbolKind::Enumerator:
        return 22;
    case sema::SymbolKind::Constant:
        return 14;
    case sema::SymbolKind::Variable:
        break;
    }
    return 13;
}

Json toSymbols(const Places& places, const std::vector<OutlineItem>& items) {
    Json out = Json::array();
    for (const OutlineItem& item : items) {
        if (item.name.empty()) continue; // is being written
        SourceRange name = item.nameRange;
        if (name.begin < item.range.begin || name.end > item.range.end) name = item.range;
        Json symbol{{"name", item.name},
                    {"kind", kindNumber(item)},
                    {"range", places.range(item.range.begin, item.range.end)},
                    {"selectionRange", places.range(name.begin, name.end)}};
        if (!item.detail.empty()) symbol["detail"] = item.detail;
        if (!item.children.empty()) symbol["children"] = toSymbols(places, item.children);
        out.push_back(std::move(symbol));
    }
    return out;
}

/// The letters of the query in their order, as editors search.
bool matches(std::string_view name, std::string_view folded) {
    const std::string text = foldCase(name);
    size_t at = 0;
    for (const char c : folded) {
        at = text.find(c, at);
        if (at == std::string::npos) return false;
        ++at;
    }
    return true;
}

} // namespace

Answer Server::documentSymbols(const Json& parameters) {
    const SpotOf found = documentAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const Spot& spot = std::get<Spot>(found);
    return toSymbols(spot.desk->places(spot.file), spot.model().outline(spot.file));
}

Answer Server::workspaceSymbols(const Json& parameters) {
    constexpr size_t kMost = 500;
    const std::string query = foldCase(protocol::textAt(parameters, "query").value_or(""));
    Json out = Json::array();
    for (const auto& [name, desk] : m_desks) {
        const auto add = [&, &desk = desk](auto&& self, const std::vector<OutlineItem>& items,
                                           const std::string& container) -> void {
            for (const OutlineItem& item : items) {
                if (!item.name.empty() && matches(item.name, query) && out.size() < kMost) {
                    Json symbol{{"name", item.name}, {"kind", kindNumber(item)}};
                    symbol["location"] = desk->location(item.nameRange);
                    if (!container.empty()) symbol["containerName"] = container;
                    out.push_back(std::move(symbol));
                }
                self(self, item.children, item.name);
            }
        };
        for (const FileId file : desk->ownFiles()) add(add, desk->model().outline(file), "");
    }
    return out;
}

Answer Server::foldingRanges(const Json& parameters) {
    const SpotOf found = documentAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const std::vector<analysis::FoldLine> lines = analysis::foldLines(std::get<Spot>(found).document->places->text());
    Json out = Json::array();
    for (size_t begin = 0; begin < lines.size(); ++begin) {
        if (!lines[begin].isHeader) continue;
        size_t end = begin + 1;
        while (end < lines.size() && lines[end].level > lines[begin].level) ++end;
        if (end - 1 > begin) out.push_back({{"startLine", begin}, {"endLine", end - 1}});
    }
    return out;
}

// ---------------------------------------------------------------- colours

namespace {

constexpr std::array<const char*, 16> kTypes = {"keyword",  "type",       "number",    "string",   "comment",  "macro",
                                                "operator", "enumMember", "parameter", "variable", "property", "class",
                                                "function", "label",      "namespace", "event"};

struct Token {
    const char* type; // null: plain text
    uint32_t modifiers;
};
constexpr uint32_t kReadOnly = 1, kGlobal = 2;

Token tokenOf(TokenClass kind) {
    switch (kind) {
    case TokenClass::Keyword:
        return {"keyword", 0};
    case TokenClass::Type:
        return {"type", 0};
    case TokenClass::Number:
        return {"number", 0};
    case TokenClass::Text:
        return {"string", 0};
    case TokenClass::Comment:
        return {"comment", 0};
    case TokenClass::Pragma:
        return {"macro", 0};
    case TokenClass::Operator:
        return {"operator", 0};
    case TokenClass::Constant:
        return {"variable", kReadOnly};
    case TokenClass::EnumValue:
        return {"enumMember", 0};
    case TokenClass::Input:
    case TokenClass::Output:
    case TokenClass::InOut:
        return {"parameter", 0};
    case TokenClass::Local:
        return {"variable", 0};
    case TokenClass::Global:
    case TokenClass::Address:
        return {"variable", kGlobal};
    case TokenClass::Instance:
        return {"property", 0};
    case TokenClass::Function:
        return {"function", 0};
    case TokenClass::Label:
        return {"label", 0};
    case TokenClass::Step:
        return {"event", 0};
    case TokenClass::Plain:
    case TokenClass::Error:
        break;
    }
    return {nullptr, 0};
}

/// Line, column, length, type, modifiers, each against the token before; a token of several lines is one on each.
class TokenWriter {
public:
    explicit TokenWriter(const Places& places) : m_places(places) {}
    void add(uint32_t begin, uint32_t end, Token token) {
        while (begin < end) {
            const Position from = m_places.positionOf(begin);
            const uint32_t lineEnd = std::min(end, m_places.offsetOf({from.line, UINT32_MAX}));
            const uint32_t length = m_places.positionOf(lineEnd).character - from.character;
            if (length > 0) put(from, length, token);
            if (from.line + 1 >= m_places.lineCount()) return;
            begin = m_places.offsetOf({from.line + 1, 0});
        }
    }
    Json take() { return std::move(m_data); }

private:
    void put(Position at, uint32_t length, Token token) {
        const auto type = std::find_if(kTypes.begin(), kTypes.end(),
                                       [&](const char* each) { return std::string_view(each) == token.type; });
        const bool isSameLine = at.line == m_last.line;
        m_data.push_back(at.line - m_last.line);
        m_data.push_back(isSameLine ? at.character - m_last.character : at.character);
        m_data.push_back(length);
        m_data.push_back(type - kTypes.begin());
        m_data.push_back(token.modifiers);
        m_last = at;
    }
    const Places& m_places;
    Json m_data = Json::array();
    Position m_last;
};

} // namespace

Json semanticLegend() { return {{"tokenTypes", kTypes}, {"tokenModifiers", {"readonly", "static"}}}; }

Answer Server::semanticTokens(const Json& parameters) {
    const SpotOf found = documentAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const Spot& spot = std::get<Spot>(found);
    TokenWriter writer(spot.desk->places(spot.file));
    for (const analysis::ColouredToken& each : spot.model().colours(spot.file))
        if (const Token token = tokenOf(each.kind); token.type) writer.add(each.begin, each.end, token);
    return Json{{"data", writer.take()}};
}

/// The debugger is asked for the values (a stopped `stepwise dap`); here is what it is to be asked for.
Answer Server::inlineValues(const Json& parameters) {
    const SpotOf found = documentAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const Spot& spot = std::get<Spot>(found);
    const auto start = positionAt(parameters, "range.start"), end = positionAt(parameters, "range.end");
    if (!start || !end) return protocol::wrongParameter("textDocument/inlineValue", "range");
    const Places& places = spot.desk->places(spot.file);
    const auto stopped = positionAt(parameters, "context.stoppedLocation.end").value_or(*end);
    const uint32_t from = places.offsetOf(*start);
    const uint32_t to = std::min(places.offsetOf(*end), places.offsetOf({stopped.line, UINT32_MAX}));
    Json out = Json::array();
    for (const sema::Reference& reference : spot.model().checked().analysis->references) {
        if (reference.range.file != spot.file || reference.range.begin < from || reference.range.end > to) continue;
        if (!reference.symbol.isValid()) continue;
        const sema::Symbol& symbol = spot.model().symbol(reference.symbol);
        if (symbol.kind != sema::SymbolKind::Variable || symbol.type == types::TypeId()) continue;
        if (reference.range.begin > 0 && places.text()[reference.range.begin - 1] == '.') continue; // of something
        out.push_back({{"range", places.range(reference.range.begin, reference.range.end)},
                       {"expression", symbol.owner.empty() && !symbol.path.empty() ? symbol.path : symbol.name}});
    }
    return out;
}

} // namespace plc::lsp
