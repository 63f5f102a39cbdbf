// Values of a running controller, behind the lines that name the variables.
#include "projects/language_server/server.h"

#include <algorithm>

namespace plc::lsp {

namespace {

constexpr size_t kMostValues = 400; // asked for at a time

bool hasOneInstance(const sema::Symbol& symbol) {
    return symbol.kind == sema::SymbolKind::Variable && symbol.type.isValid() && !symbol.isConstant &&
           !symbol.path.empty() && (symbol.owner.empty() || symbol.path != symbol.name);
}

/// A block or structure has no value of its own.
bool isElementary(const types::Type& type) {
    return type.kind != types::TypeKind::Block && type.kind != types::TypeKind::Struct &&
           type.kind != types::TypeKind::Array;
}

} // namespace

struct Server::LineValues {
    uint32_t line = 0;
    std::vector<const sema::Symbol*> variables; // each once
};

/// What the lines in [from, to) name that the controller holds exactly once.
std::vector<Server::LineValues> Server::valuesIn(const Spot& spot, uint32_t from, uint32_t to) const {
    const Places& places = spot.desk->places(spot.file);
    const types::TypeTable& types = *spot.model().checked().analysis->program->types;
    std::vector<LineValues> out;
    for (const sema::Reference& reference : spot.model().checked().analysis->references) {
        if (reference.range.file != spot.file || reference.range.begin < from || reference.range.end > to) continue;
        if (!reference.symbol.isValid()) continue;
        const sema::Symbol& symbol = spot.model().symbol(reference.symbol);
        if (!hasOneInstance(symbol) || !isElementary(types[symbol.type])) continue;
        if (reference.range.begin > 0 && places.text()[reference.range.begin - 1] == '.') continue; // of something
        const uint32_t line = places.positionOf(reference.range.begin).line;
        if (out.empty() || out.back().line != line) out.push_back({line, {}});
        std::vector<const sema::Symbol*>& known = out.back().variables;
        if (std::find(known.begin(), known.end(), &symbol) == known.end()) known.push_back(&symbol);
    }
    return out;
}

Answer Server::inlayHints(const Json& parameters) {
    const SpotOf found = documentAt(parameters);
    if (const Failure* failure = std::get_if<Failure>(&found)) return *failure;
    const Spot& spot = std::get<Spot>(found);
    const auto start = positionAt(parameters, "range.start"), end = positionAt(parameters, "range.end");
    if (!start || !end) return protocol::wrongParameter("textDocument/inlayHint", "range");
    Json out = Json::array();
    if (!m_settings.values) return out;
    const Places& places = spot.desk->places(spot.file);
    const auto lines = valuesIn(spot, places.offsetOf(*start), places.offsetOf(*end));
    std::vector<std::string> wanted;
    for (const LineValues& line : lines)
        for (const sema::Symbol* symbol : line.variables)
            if (wanted.size() < kMostValues) wanted.push_back(symbol->path);
    m_settings.values->want(std::move(wanted));
    for (const LineValues& line : lines) {
        std::string label;
        for (const sema::Symbol* symbol : line.variables)
            if (const auto value = m_settings.values->valueOf(symbol->path))
                label += (label.empty() ? "" : ", ") + symbol->name + " = " + *value;
        if (label.empty()) continue;
        const Position behind = places.positionOf(places.offsetOf({line.line, UINT32_MAX}));
        out.push_back({{"position", toJson(behind)}, {"label", std::move(label)}, {"paddingLeft", true}});
    }
    return out;
}

/// Values became others: the editor asks for its hints again.
void Server::refreshHints() {
    if (!m_settings.values || !m_refreshesHints || m_isShutDown) return;
    const uint64_t revision = m_settings.values->revision();
    if (std::exchange(m_shownValues, revision) == revision) return;
    m_send({{"jsonrpc", "2.0"},
            {"id", "hints " + std::to_string(++m_refreshes)},
            {"method", "workspace/inlayHint/refresh"}});
}

} // namespace plc::lsp
