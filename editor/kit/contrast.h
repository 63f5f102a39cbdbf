// How far two colours are apart, and inks that can be read in the high-contrast theme. Pure functions but for the theme
// of the moment; GUI thread for `legible`, any for the others.
#pragma once
#include <QColor>

namespace plc::kit {

/// Relative luminance, 0 black … 1 white (WCAG 2).
double luminance(const QColor& color);
/// 1 … 21.
double contrast(const QColor& a, const QColor& b);
/// In the high-contrast theme the ink with so much white that it has 7:1 on its ground; else as it is.
QColor legible(const QColor& ink);

} // namespace plc::kit
