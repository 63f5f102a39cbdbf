#include "hmi/view/paint/colour_sight.h"

#include <QStringList>

#include <algorithm>

namespace plc::hmi {

namespace {

/// 0 grey … 1 pure.
double chroma(const QColor& color) {
    const auto [low, high] = std::minmax({color.redF(), color.greenF(), color.blueF()});
    return high - low;
}

bool isOneOf(const QString& color, std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(), [&](const char* name) { return color == QLatin1String(name); });
}

} // namespace

bool isAlarmColour(const QString& color) {
    if (!color.startsWith(u'#')) return isOneOf(color, {"alarm", "high", "warning", "red", "orange", "yellow"});
    const QColor seen(color);
    // Earth and wood have these hues, too, but are neither pure nor bright.
    constexpr double Pure = 0.62;
    const int hue = seen.hsvHue();
    return seen.isValid() && chroma(seen) > Pure && (hue <= 60 || hue >= 345);
}

bool isLoud(const QString& color) {
    if (!color.startsWith(u'#')) return isAlarmColour(color) || isOneOf(color, {"green", "blue", "low"});
    const QColor seen(color);
    constexpr double Quiet = 0.6; // the themes' quiet roles and the colours of wood and earth are below
    return seen.isValid() && chroma(seen) > Quiet;
}

} // namespace plc::hmi
