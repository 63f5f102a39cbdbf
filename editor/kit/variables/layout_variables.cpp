#include "editor/kit/variables/layout_variables.h"

#include "editor/kit/fuzzy.h"
#include "editor/kit/texts.h"

#include <algorithm>

namespace plc::kit {

namespace {

using image::VariableKind;

Icon iconOf(VariableKind kind) {
    switch (kind) {
    case VariableKind::Program:
        return Icon::Program;
    case VariableKind::List:
        return Icon::Globals;
    case VariableKind::Block:
        return Icon::Block;
    case VariableKind::Structure:
        return Icon::Structure;
    case VariableKind::Enumeration:
        return Icon::Enumeration;
    case VariableKind::Input:
        return Icon::Input;
    case VariableKind::Output:
        return Icon::Output;
    case VariableKind::Constant:
        return Icon::Constant;
    case VariableKind::Variable:
        return Icon::Variable;
    }
    return Icon::Variable;
}

} // namespace

VariableNode shownVariable(const image::VariableNode& node, const image::Layout& layout, const QString& prefix) {
    return {fromView(node.name),
            prefix + fromView(node.path),
            node.isGroup() ? QString() : fromView((*layout.types)[node.type].name),
            fromView(node.comment),
            iconOf(node.kind),
            node.hasMembers,
            !node.isGroup()};
}

std::vector<ScoredVariable> matchingVariables(const image::Layout& layout,
                                              const std::vector<image::VariableNode>& roots, bool elements,
                                              const QString& wanted, const QString& prefix) {
    using Next = image::VariableTree::Next;
    constexpr size_t MostVisited = 20'000;
    constexpr int Deepest = 6;
    std::vector<ScoredVariable> hits;
    size_t visited = 0;
    image::VariableTree(layout).visit(
        roots,
        [&](const image::VariableNode& node, int depth) {
            if (++visited > MostVisited) return Next::Stop;
            if (!node.isGroup())
                if (const auto match = fuzzyMatch(wanted, prefix + fromView(node.path)))
                    hits.push_back({match->score - depth, shownVariable(node, layout, prefix)});
            return depth > Deepest ? Next::Over : Next::Into;
        },
        elements);
    return hits;
}

std::vector<VariableNode> bestOf(std::vector<ScoredVariable> hits, int limit) {
    std::stable_sort(hits.begin(), hits.end(),
                     [](const ScoredVariable& a, const ScoredVariable& b) { return a.score > b.score; });
    std::vector<VariableNode> out;
    for (ScoredVariable& hit : hits) {
        if (static_cast<int>(out.size()) >= limit) break;
        out.push_back(std::move(hit.node));
    }
    return out;
}

} // namespace plc::kit
