#include "runtime/compiler/ladder/units.h"

#include "runtime/base/text.h"

namespace plc::ladder {

namespace {

class Collector {
public:
    std::vector<Unit> units;

    void collect(const std::vector<syntax::Decl*>& declarations) {
        for (const syntax::Decl* decl : declarations) {
            if (decl->space) collect(decl->space->declarations);
            if (decl->pou && decl->pou->kind != syntax::PouKind::Interface) add(*decl->pou);
        }
    }

private:
    void push(std::string name, const syntax::Pou& pou, const syntax::Pou* owner, const syntax::Body& body,
              SourceRange range, const std::vector<syntax::Pragma>& pragmas) {
        Unit unit{std::move(name), &pou, owner, &body, range, pou.header, {}, {}};
        for (const syntax::Pragma& pragma : pragmas)
            if (pragma.isAttribute && equalsIgnoringCase(pragma.key, "view")) {
                unit.view = pragma.value;
                unit.viewRange = pragma.range;
            }
        units.push_back(std::move(unit));
    }

    void add(const syntax::Pou& pou) {
        const std::string name(pou.name.text);
        push(name, pou, nullptr, pou.body, pou.range, pou.pragmas);
        addActions(name, pou, pou.actions);
        if (pou.body.chart) addActions(name, pou, pou.body.chart->actions);
        for (const syntax::Pou* method : pou.methods)
            push(name + "." + std::string(method->name.text), *method, &pou, method->body, method->range,
                 method->pragmas);
        for (const syntax::Property* property : pou.properties)
            for (const syntax::Pou* accessor : {property->get, property->set})
                if (accessor)
                    push(name + "." + std::string(property->name.text) + (accessor == property->get ? ".Get" : ".Set"),
                         *accessor, &pou, accessor->body, accessor->range, property->pragmas);
    }

    void addActions(const std::string& name, const syntax::Pou& pou, const std::vector<syntax::ActionDecl*>& actions) {
        for (const syntax::ActionDecl* action : actions) {
            push(name + "." + std::string(action->name.text), pou, nullptr, action->body, action->range, {});
            if (action->body.chart) addActions(name, pou, action->body.chart->actions);
        }
    }
};

} // namespace

std::vector<Unit> unitsOf(const syntax::SyntaxFile& file) {
    Collector collector;
    collector.collect(file.declarations);
    return std::move(collector.units);
}

Unit findUnit(const syntax::SyntaxFile& file, std::string_view name) {
    for (Unit& unit : unitsOf(file))
        if (name.empty() || equalsIgnoringCase(unit.name, name)) return std::move(unit);
    return {};
}

Unit unitAt(const syntax::SyntaxFile& file, uint32_t offset) {
    Unit found;
    for (Unit& unit : unitsOf(file))
        if (offset >= unit.range.begin && offset <= unit.range.end &&
            (!found.body || unit.range.length() < found.range.length()))
            found = std::move(unit);
    return found;
}

diagnostics::Edits preferView(std::string_view text, const Unit& unit, std::string_view view) {
    if (!unit.pou || unit.range.begin != unit.pou->range.begin) return {};
    const std::string pragma = "{attribute 'view' := '" + std::string(view) + "'}";
    if (unit.viewRange.end == 0) {
        if (view.empty()) return {};
        uint32_t line = unit.range.begin;
        while (line > 0 && text[line - 1] != '\n') --line;
        const std::string_view before = text.substr(line, unit.range.begin - line);
        const std::string_view end = text.find("\r\n") == std::string_view::npos ? "\n" : "\r\n";
        const bool ownLine = before.find_first_not_of(" \t") == std::string_view::npos;
        return {{{unit.range.file, unit.range.begin, unit.range.begin},
                 pragma + (ownLine ? std::string(end) + std::string(before) : std::string(" "))}};
    }
    if (equalsIgnoringCase(unit.view, view)) return {};
    if (!view.empty()) return {{unit.viewRange, pragma}};
    SourceRange gone = unit.viewRange; // with its line when nothing else is on it
    while (gone.begin > 0 && (text[gone.begin - 1] == ' ' || text[gone.begin - 1] == '\t')) --gone.begin;
    uint32_t end = gone.end;
    while (end < text.size() && (text[end] == ' ' || text[end] == '\t' || text[end] == '\r')) ++end;
    const bool ownLine = (gone.begin == 0 || text[gone.begin - 1] == '\n') && end < text.size() && text[end] == '\n';
    return {{ownLine ? SourceRange{gone.file, gone.begin, end + 1} : unit.viewRange, {}}};
}

} // namespace plc::ladder
