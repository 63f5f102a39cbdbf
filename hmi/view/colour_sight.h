// How colours are seen: brightness, contrast, how loud one is, which belong to alarms. For the theme and the check of
// panels. Pure functions, any thread.
#pragma once
#include <QColor>

namespace plc::hmi {

/// Relative luminance, 0 black … 1 white (WCAG 2).
double luminance(const QColor& color);
/// 1 … 21.
double contrast(const QColor& a, const QColor& b);
/// A colour that draws the eye: the name of a role, or "#rrggbb".
bool isLoud(const QString& color);
/// One that is kept for alarms.
bool isAlarmColour(const QString& color);

} // namespace plc::hmi
