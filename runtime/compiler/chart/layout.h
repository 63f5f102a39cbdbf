// Where a chart's parts stand when it is drawn as IEC does: a grid of columns and rows, computed from the text alone,
// so that the same text gives the same drawing and a small edit moves little. The view gives columns and rows their
// sizes. Values, any thread.
#pragma once
#include "runtime/compiler/chart/chart.h"

namespace plc::chart {

struct Cell {
    int column = 0;
    int row = 0;
    bool operator==(const Cell&) const = default;
};

enum class BarKind : uint8_t {
    AlternativeOpen,   // below a step: one line
    AlternativeClose,  // above a step
    SimultaneousOpen,  // below a transition: two lines
    SimultaneousClose, // above a transition
};
struct Bar {
    BarKind kind;
    int row;
    int firstColumn, lastColumn;
    int trunk;               // the column of the step or transition it belongs to
    StepId step;             // of an alternative
    TransitionId transition; // of a simultaneous one
};
/// Below a transition: an arrow with the name of the step where it goes on.
struct Jump {
    Cell at;
    TransitionId transition;
    StepId target;
};
/// Down one column, from the lower edge of what stands in `fromRow` to the upper edge of what stands in `toRow`.
struct Line {
    int column;
    int fromRow, toRow;
};
/// A step that leads to a join drawn elsewhere: no grid can hold it, the view draws it over the others.
struct Link {
    StepId step;
    TransitionId join;
};

struct Layout {
    int columns = 0;
    int rows = 0;
    std::vector<Cell> steps;       // by StepId
    std::vector<Cell> transitions; // by TransitionId
    std::vector<Bar> bars;
    std::vector<Jump> jumps;
    std::vector<Line> lines;
    std::vector<Link> links;
    std::vector<int> networkColumns; // where each network begins
};

[[nodiscard]] Layout computeLayout(const Chart& chart);

} // namespace plc::chart
