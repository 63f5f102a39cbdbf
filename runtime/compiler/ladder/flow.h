// Power flow: which wires of a diagram carried power, from the values that the program computed. Whoever calls it says
// where the values come from: a live image, a recorded scan, a scan run again. Pure functions; any thread.
#pragma once
#include "runtime/compiler/ladder/diagram.h"

#include <functional>

namespace plc::ladder {

enum class Power : uint8_t { Unknown, Off, On };

/// What the value of a node is asked by: `text` as an expression of the unit, `range` its place when it has one.
struct Question {
    std::string text;
    SourceRange range;
    const syntax::Expr* expr = nullptr; // null: an output of a block, which only `text` names
};
using Answers = std::function<Power(const Question&)>;

/// Of a contact, what it watches (without NOT); of a box, the output from which its wire goes on. Empty text: none.
[[nodiscard]] Question questionOf(std::string_view text, const Diagram& diagram, NodeId node);

/// The power behind each node of a rung, by NodeId; `power` has the diagram's size.
void computeFlow(std::string_view text, const Diagram& diagram, const Rung& rung, const Answers& answers,
                 std::vector<Power>& power);

} // namespace plc::ladder
