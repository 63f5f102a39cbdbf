// Charts as statements (IEC 61131-3 ed. 2, 2.6.4 and 2.6.5): one evolution a scan, all transitions judged before any
// step changes, then the action control blocks, then the actions. The blocks SFC_STEP, SFC_ACTION, SFC_STORED_DELAY and
// SFC_STORED_LIMIT are library text. One chart, one use.
#pragma once
#include "runtime/compiler/lower/builder.h"

#include <map>
#include <set>

namespace plc::lower {

/// What the charts of one unit share.
struct ChartUnit {
    syntax::Pou& pou;
    syntax::VarSection& section;         // where steps and controls are declared
    std::set<std::string> actions;       // folded names of the unit's ACTIONs
    std::set<std::string> steps;         // declared already
    std::vector<std::string> blockTypes; // folded names of the file's function blocks
    int charts = 0;
    int instructionVariables = 0;
};

[[nodiscard]] Block lowerChart(const syntax::SfcBody& chart, SourceRange place, ChartUnit& unit, Builder& builder,
                               diagnostics::Sink& sink);

} // namespace plc::lower
