// Finds the chart of a unit, or of one of its actions, in a syntax tree, and names what the compiler made of it. Pure
// functions.
#pragma once
#include "runtime/compiler/parse/syntax.h"

#include <string>
#include <string_view>
#include <vector>

namespace plc::editor {

struct ChartPlace {
    const syntax::Pou* pou = nullptr;
    const syntax::SfcBody* chart = nullptr;
    SourceRange range; // of the unit or action
    int number = 0;    // among the unit's charts, as the compiler counts them
    [[nodiscard]] explicit operator bool() const { return chart != nullptr; }
};
/// "Main", or "Main.Fill" for the chart in an action, however deep it lies.
[[nodiscard]] ChartPlace findChart(const syntax::SyntaxFile& file, std::string_view unit);
/// The unit is there, whatever its body.
[[nodiscard]] const syntax::Pou* findUnit(const syntax::SyntaxFile& file, std::string_view unit);
/// The innermost chart around a place, as "Main" or "Main.Fill"; empty outside.
[[nodiscard]] std::string chartAt(const syntax::SyntaxFile& file, uint32_t offset);

/// The compiler's variables (see runtime/compiler/lower/lower.h).
[[nodiscard]] std::string firedVariable(int chart, size_t transition);
[[nodiscard]] std::string controlVariable(int chart, std::string_view action);

} // namespace plc::editor
