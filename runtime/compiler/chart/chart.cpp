#include "runtime/compiler/chart/chart.h"

#include "runtime/base/text.h"

#include <numeric>
#include <unordered_map>

namespace plc::chart {

StepId Chart::find(std::string_view name) const {
    const std::string key = foldCase(name);
    for (size_t i = 0; i < steps.size(); ++i)
        if (foldCase(steps[i].decl->name.text) == key) return StepId(i);
    return {};
}

Chart build(const syntax::SfcBody& body) {
    Chart chart;
    chart.body = &body;
    std::unordered_map<std::string, StepId> names;
    for (const syntax::StepDecl* decl : body.steps) {
        if (decl->name.isValid()) names.emplace(foldCase(decl->name.text), StepId(chart.steps.size()));
        chart.steps.push_back({.decl = decl});
    }
    // networks by union of what transitions connect
    std::vector<uint32_t> parent(chart.steps.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](uint32_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    };
    for (const syntax::TransitionDecl* decl : body.transitions) {
        const TransitionId id(chart.transitions.size());
        Transition transition{.decl = decl};
        uint32_t first = StepId::kNone;
        const auto connect = [&](const std::vector<syntax::Name>& list, std::vector<StepId>& ids, bool leaves) {
            for (const syntax::Name& name : list) {
                const auto it = names.find(foldCase(name.text));
                if (it == names.end()) continue;
                ids.push_back(it->second);
                Step& step = chart.steps[it->second.index()];
                (leaves ? step.out : step.in).push_back(id);
                if (first == StepId::kNone)
                    first = it->second.value;
                else
                    parent[root(it->second.value)] = root(first);
            }
        };
        connect(decl->from, transition.from, true);
        connect(decl->to, transition.to, false);
        chart.transitions.push_back(std::move(transition));
    }
    std::unordered_map<uint32_t, uint32_t> numbers;
    for (uint32_t i = 0; i < chart.steps.size(); ++i) {
        const auto [it, isNew] = numbers.emplace(root(i), chart.networks);
        if (isNew) ++chart.networks;
        chart.steps[i].network = it->second;
    }
    for (Transition& transition : chart.transitions) {
        if (!transition.from.empty())
            transition.network = chart[transition.from[0]].network;
        else if (!transition.to.empty())
            transition.network = chart[transition.to[0]].network;
    }
    return chart;
}

} // namespace plc::chart
