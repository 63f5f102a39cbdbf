// What tests or a recording have covered of one line of the text, as a graph view draws it at what stands there: filled
// by the page that shows the graph, from the margin of its text. Values; GUI thread.
#pragma once
#include <QHash>
#include <QString>

#include <cstdint>
#include <functional>
#include <optional>

namespace plc::editor {

struct CoverageMark {
    enum class State : uint8_t { Run, Partly, NotRun };
    State state = State::Run;
    QString text; // what is missing, or how often it ran
    bool operator==(const CoverageMark&) const = default;
};
/// Of a line from 1; none: nothing to cover there, or not asked for.
using CoverageSource = std::function<std::optional<CoverageMark>(int line)>;

/// Of a chart, by index; of actions by step and place.
struct ChartCoverage {
    QHash<int, CoverageMark> steps, transitions;
    QHash<QPair<int, int>, CoverageMark> actions;
    bool operator==(const ChartCoverage&) const = default;
};

} // namespace plc::editor
