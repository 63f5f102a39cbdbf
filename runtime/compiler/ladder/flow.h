// Power flow: which wires of a diagram carried power, from the values that the program computed. Whoever calls it says
// where the values come from: a live image, a recorded scan, a scan run again. Pure functions; any thread.
#pragma once
#include "runtime/compiler/ladder/diagram.h"

#include <functional>

namespace plc::ladder {

enum class Power : uint8_t { Unknown, Off, On };

/// What the value of a node is asked by: `text` as an expression of the unit, `range` where it is read.
struct Question {
    std::string text;
    SourceRange range;
    const syntax::Expr* expr = nullptr; // null: an output of a block, from which a wire goes on
};
using Answers = std::function<Power(const Question&)>;
/// Whether a statement ran in the scan; by reportedRange().
using Executed = std::function<bool(SourceRange statement)>;

/// Of a contact, what it watches (without NOT); of a box, the output from which its wire goes on. Empty text: none.
[[nodiscard]] Question questionOf(std::string_view text, const Diagram& diagram, NodeId node);

/// The text by which a checked program knows a statement: of IF, WHILE and FOR only their head.
[[nodiscard]] SourceRange reportedRange(const syntax::Stmt& stmt);

/// Whether the contacts of a rung were looked at; true when nobody knows.
[[nodiscard]] bool isRungExecuted(const Diagram& diagram, const Rung& rung, const Executed& isExecuted);

/// The power behind each node of a rung, by NodeId; `power` has the diagram's size. What was not executed is unknown,
/// and so is what AND_THEN and OR_ELSE did not look at; no question is asked about either.
void computeFlow(std::string_view text, const Diagram& diagram, const Rung& rung, const Answers& answers,
                 std::vector<Power>& power, const Executed& isExecuted = {});

} // namespace plc::ladder
