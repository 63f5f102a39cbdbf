#include "editor/graph/chart/chart_unit.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <functional>

namespace plc::editor {

namespace {

void eachUnit(const std::vector<syntax::Decl*>& declarations, const std::function<void(const syntax::Pou&)>& visit) {
    for (const syntax::Decl* decl : declarations) {
        if (decl->pou) visit(*decl->pou);
        if (decl->space) eachUnit(decl->space->declarations, visit);
    }
}

/// The unit's actions in the order in which the compiler lowers them: its own, then those inside charts.
std::vector<const syntax::ActionDecl*> actionsOf(const syntax::Pou& pou) {
    std::vector<const syntax::ActionDecl*> all(pou.actions.begin(), pou.actions.end());
    const auto gather = [&](const syntax::Body& body) {
        if (body.chart) all.insert(all.end(), body.chart->actions.begin(), body.chart->actions.end());
    };
    gather(pou.body);
    for (size_t i = 0; i < all.size(); ++i) gather(all[i]->body);
    return all;
}

bool isSame(std::string_view a, std::string_view b) { return a.size() == b.size() && equalsIgnoringCase(a, b); }

} // namespace

const syntax::Pou* findUnit(const syntax::SyntaxFile& file, std::string_view unit) {
    const std::string_view name = unit.substr(0, unit.find('.'));
    const syntax::Pou* found = nullptr;
    eachUnit(file.declarations, [&](const syntax::Pou& pou) {
        if (isSame(pou.name.text, name)) found = &pou;
    });
    return found;
}

ChartPlace findChart(const syntax::SyntaxFile& file, std::string_view unit) {
    ChartPlace place;
    place.pou = findUnit(file, unit);
    if (!place.pou) return place;
    place.range = place.pou->range;
    const size_t dot = unit.find('.');
    if (dot == std::string_view::npos) {
        place.chart = place.pou->body.chart;
        return place;
    }
    int number = place.pou->body.chart ? 1 : 0;
    for (const syntax::ActionDecl* action : actionsOf(*place.pou)) {
        if (isSame(action->name.text, unit.substr(dot + 1))) {
            place.chart = action->body.chart;
            place.range = action->range;
            place.number = number;
            return place;
        }
        if (action->body.chart) ++number;
    }
    return place;
}

std::string chartAt(const syntax::SyntaxFile& file, uint32_t offset) {
    std::string found;
    uint32_t length = UINT32_MAX;
    const auto look = [&](const std::string& name, const syntax::Body& body, SourceRange range) {
        if (!body.chart || offset < range.begin || offset > range.end || range.length() >= length) return;
        found = name;
        length = range.length();
    };
    eachUnit(file.declarations, [&](const syntax::Pou& pou) {
        look(std::string(pou.name.text), pou.body, pou.range);
        for (const syntax::ActionDecl* action : actionsOf(pou))
            look(std::string(pou.name.text) + "." + std::string(action->name.text), action->body, action->range);
    });
    return found;
}

std::string firedVariable(int chart, size_t transition) {
    return "__fired" + std::to_string(chart) + "[" + std::to_string(transition) + "]";
}

std::string controlVariable(int chart, std::string_view action) {
    std::string name = "__action_";
    for (const char c : action)
        name += (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                        static_cast<unsigned char>(c) >= 0x80
                    ? c
                    : '_';
    return chart == 0 ? name : name + "_" + std::to_string(chart);
}

} // namespace plc::editor
