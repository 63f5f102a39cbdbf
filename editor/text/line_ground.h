// The ground of a marked line: a colour laid over the paper, mixed by us, because QScintilla as packaged paints no
// translucent ground of a line. Pure function.
#pragma once
#include <QColor>

namespace plc::editor {

/// `share` of the colour (0 to 1) over the paper; opaque.
[[nodiscard]] inline QColor lineGround(const QColor& paper, const QColor& colour, double share) {
    const auto mixed = [share](int below, int above) { return qRound(below * (1 - share) + above * share); };
    return {mixed(paper.red(), colour.red()), mixed(paper.green(), colour.green()), mixed(paper.blue(), colour.blue())};
}

} // namespace plc::editor
