// How colours are seen: brightness, contrast, how loud one is, which belong to alarms. For the theme and the check of
// panels. Pure functions, any thread.
#pragma once
#include "editor/kit/contrast.h"

#include <QColor>

namespace plc::hmi {

using kit::contrast, kit::luminance;
/// A colour that draws the eye: the name of a role, or "#rrggbb".
bool isLoud(const QString& color);
/// One that is kept for alarms.
bool isAlarmColour(const QString& color);

} // namespace plc::hmi
