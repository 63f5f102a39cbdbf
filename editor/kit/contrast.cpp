#include "editor/kit/contrast.h"

#include "editor/kit/theme.h"

#include <algorithm>
#include <cmath>

namespace plc::kit {

namespace {

constexpr double kLegible = 7; // WCAG 2, level AAA
constexpr double kStep = 0.05;

double linear(double channel) {
    return channel <= 0.04045 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
}

QColor whitened(const QColor& ink, double share) {
    const auto mixed = [share](double part) { return static_cast<float>(part * (1 - share) + share); };
    return QColor::fromRgbF(mixed(ink.redF()), mixed(ink.greenF()), mixed(ink.blueF()), ink.alphaF());
}

} // namespace

double luminance(const QColor& color) {
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

double contrast(const QColor& a, const QColor& b) {
    const auto [low, high] = std::minmax({luminance(a), luminance(b)});
    return (high + 0.05) / (low + 0.05);
}

QColor legible(const QColor& ink) {
    const ThemeColors& theme = colors();
    if (!theme.contrast) return ink;
    QColor out = ink;
    for (double share = 0; contrast(out, theme.base) < kLegible && share < 1; share += kStep)
        out = whitened(ink, share);
    return out;
}

} // namespace plc::kit
