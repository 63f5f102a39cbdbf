// The SFC model over the text: steps and transitions with their links, networks, structural checks. A projection of a
// syntax tree, which must outlive it; built by one thread, then immutable. Ids index the chart's own vectors, in order
// of the text.
#pragma once
#include "runtime/base/ids.h"
#include "runtime/compiler/parse/syntax.h"

namespace plc::chart {

using StepId = Id<struct StepTag>;
using TransitionId = Id<struct TransitionTag>;

struct Step {
    const syntax::StepDecl* decl = nullptr;
    std::vector<TransitionId> in, out; // in order of the text
    uint32_t network = 0;
};
struct Transition {
    const syntax::TransitionDecl* decl = nullptr;
    std::vector<StepId> from, to; // unknown names are left out
    uint32_t network = 0;
};

struct Chart {
    const syntax::SfcBody* body = nullptr;
    std::vector<Step> steps;
    std::vector<Transition> transitions;
    uint32_t networks = 0; // parts that nothing connects, numbered by their first step in the text

    [[nodiscard]] const Step& operator[](StepId id) const { return steps[id.index()]; }
    [[nodiscard]] const Transition& operator[](TransitionId id) const { return transitions[id.index()]; }
    /// None for an unknown name; the first of two with the same name.
    [[nodiscard]] StepId find(std::string_view name) const;
};

[[nodiscard]] Chart build(const syntax::SfcBody& body);

/// Structural rules (P40xx): initial steps, unknown and double names, reachability, tokens that multiply or never join,
/// transitions that are always true, qualifiers.
void check(const Chart& chart, diagnostics::Sink& sink);

} // namespace plc::chart
