// Coverage by line of text, for margins and reports.
#include "runtime/inside/coverage.h"
#include "runtime/inside/texts.h"

#include <algorithm>

namespace plc::inside {

LineCoverage::State LineCoverage::state() const {
    if (isStatement && count == 0) return State::NotRun;
    if (!missing.empty()) return State::Partly;
    return isStatement ? State::Run : State::None;
}

std::map<uint32_t, LineCoverage> linesOf(const image::CompiledProgram& program, const FunctionCoverage& f) {
    std::map<uint32_t, LineCoverage> lines;
    const auto lineOf = [&](SourceRange range) { return program.sources[range.file].lineColumn(range.begin).line; };
    for (const StatementCoverage& statement : f.statements) {
        LineCoverage& line = lines[lineOf(statement.range)];
        line.count = line.isStatement ? std::min(line.count, statement.count) : statement.count;
        line.isStatement = true;
    }
    for (const BranchCoverage& branch : f.branches) {
        LineCoverage& line = lines[lineOf(branch.statement)];
        ++line.branches;
        if (branch.count > 0)
            ++line.taken;
        else
            line.missing.push_back(texts::NeverBranch(branch.name));
    }
    for (const DecisionCoverage& decision : f.decisions)
        for (const ConditionCoverage& condition : decision.conditions)
            if (!condition.decidedAlone)
                lines[lineOf(condition.range)].missing.push_back(texts::MissingCombination(condition.missing));
    return lines;
}

} // namespace plc::inside
