// What the editor knows of instruction lists: where the current result of each line lies, which words are operators,
// and what may stand where the cursor is while a list is being typed. Pure functions over immutable trees and texts;
// any thread.
#pragma once
#include "runtime/compiler/parse/syntax.h"

#include <optional>
#include <string>
#include <vector>

namespace plc::analysis {

/// The current result behind an instruction.
struct AccumulatorPlace {
    uint32_t at = 0;        // in the instruction's last line
    std::string expression; // a hidden variable of the unit, or a constant
};
/// In order of place, of every list of a lowered file: bodies, actions, methods, conditions of transitions.
[[nodiscard]] std::vector<AccumulatorPlace> accumulatorPlaces(const syntax::SyntaxFile& file);

/// Begins of the words that are operators (LD, ANDN, S1…), in order of place.
[[nodiscard]] std::vector<uint32_t> operatorPlaces(const syntax::SyntaxFile& file);

/// Operators with their modifiers, and what each does.
struct ListOperator {
    std::string_view name, summary;
};
[[nodiscard]] const std::vector<ListOperator>& listOperators();
[[nodiscard]] bool isListOperator(std::string_view word);

/// What stands at a place of a list.
enum class ListPlace : uint8_t { Operator, Operand, Label, Instance };
struct ListContext {
    ListPlace place = ListPlace::Operator;
    std::vector<std::string> labels; // of the body
};
/// None: not in an instruction list. `text` need not be without errors.
[[nodiscard]] std::optional<ListContext> listContextAt(std::string_view text, uint32_t wordBegin);

} // namespace plc::analysis
