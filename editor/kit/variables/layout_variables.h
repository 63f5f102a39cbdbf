// The variables of a layout as pickers, completion and searches show them. Functions, GUI thread.
#pragma once
#include "editor/kit/inputs/variable_picker.h"
#include "runtime/image/variable_tree.h"

namespace plc::kit {

/// `prefix` stands in front of the path: "$" for what belongs to a parameter.
VariableNode shownVariable(const image::VariableNode& node, const image::Layout& layout, const QString& prefix = {});

struct ScoredVariable {
    int score = 0;
    VariableNode node;
};
/// Of `roots` and what lies below them, those whose path matches; what is deeper counts a little less. `elements`: of
/// arrays too.
std::vector<ScoredVariable> matchingVariables(const image::Layout& layout,
                                              const std::vector<image::VariableNode>& roots, bool elements,
                                              const QString& wanted, const QString& prefix = {});
/// The best first; of equals, as they came.
std::vector<VariableNode> bestOf(std::vector<ScoredVariable> hits, int limit);

} // namespace plc::kit
