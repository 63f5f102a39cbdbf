// What # means in the expressions of an element that shows an array. A function; any thread.
#pragma once
#include <QString>

namespace plc::hmi {

/// Puts an index into an expression: `#` within brackets, there also `#r` and `#c` for row and column. A `#` of a
/// literal (T#10s, 16#FF, Mode#Auto), of a name (#local) or of a text is left alone.
QString withIndex(QString expression, int index, int row = 0, int column = 0);

} // namespace plc::hmi
