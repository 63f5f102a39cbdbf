#include "editor/plot/painting/plot_raster.h"

#include <algorithm>
#include <cmath>

namespace plc::plot {

namespace {

/// source over destination, both premultiplied, source scaled by alpha/255.
uint32_t blend(uint32_t source, uint32_t destination, uint32_t alpha) {
    auto scaled = [](uint32_t pixel, uint32_t by) {
        // Two channels in one multiplication: they are 16 bits apart, so that products do not meet.
        const uint32_t low = ((pixel & 0xff00ff) * by + 0x800080) >> 8 & 0xff00ff;
        const uint32_t high = ((pixel >> 8 & 0xff00ff) * by + 0x800080) & 0xff00ff00;
        return low | high;
    };
    // 255 stands for the whole: x + (x >> 7) maps it to 256, which a shift divides by.
    const uint32_t top = scaled(source, alpha + (alpha >> 7));
    return top + scaled(destination, 256 - ((top >> 24) + (top >> 31)));
}

} // namespace

void fillColumns(QImage& image, const QRect& area, std::span<const ColumnSpan> spans, float width,
                 const QColor& color) {
    const QRect room = area.intersected(image.rect());
    if (room != area) return; // laid out for this picture, or not at all
    const int columns = std::min<int>(area.width(), static_cast<int>(spans.size())), rows = area.height();
    const uint32_t ink = qPremultiply(color.rgba());
    const bool isOpaque = qAlpha(ink) == 255;
    const float half = std::max(0.5f, width / 2);
    const qsizetype stride = image.bytesPerLine() / 4;
    uint32_t* const origin = reinterpret_cast<uint32_t*>(image.bits()) + area.top() * stride + area.left();
    const auto height = static_cast<float>(rows);
    auto blendRows = [&](int x, float top, float bottom, float strength) {
        top = std::max(top, 0.0f);
        bottom = std::min(bottom, height);
        if (!(top < bottom)) return;
        const int first = static_cast<int>(top), last = std::min(rows - 1, static_cast<int>(std::ceil(bottom)) - 1);
        uint32_t* pixel = origin + first * stride + x;
        const bool isSolid = isOpaque && strength >= 1;
        auto soft = [&](float cover) {
            *pixel = blend(ink, *pixel, static_cast<uint32_t>(cover * strength * 255.0f + 0.5f));
        };
        if (first == last) {
            soft(bottom - top);
            return;
        }
        soft(static_cast<float>(first + 1) - top);
        pixel += stride;
        for (int y = first + 1; y < last; ++y, pixel += stride) {
            if (isSolid)
                *pixel = ink;
            else
                soft(1);
        }
        soft(bottom - static_cast<float>(last));
    };
    // Column by column: the rows of sixteen neighbouring columns share cache lines, which stay near.
    const float side = std::clamp((width - 1) / 2, 0.0f, 1.0f);
    for (int x = 0; x < columns; ++x) {
        const ColumnSpan& span = spans[static_cast<size_t>(x)];
        if (!span.isEmpty()) blendRows(x, span.top - half, span.bottom + half, 1);
        if (side < 0.05f) continue;
        for (int n : {x - 1, x + 1}) {
            if (n < 0 || n >= columns || spans[static_cast<size_t>(n)].isEmpty()) continue;
            const ColumnSpan& other = spans[static_cast<size_t>(n)];
            const float top = other.top - half, bottom = other.bottom + half;
            if (span.isEmpty()) {
                blendRows(x, top, bottom, side);
                continue;
            }
            if (top < span.top - half) blendRows(x, top, std::min(bottom, span.top - half), side);
            if (bottom > span.bottom + half) blendRows(x, std::max(top, span.bottom + half), bottom, side);
        }
    }
}

} // namespace plc::plot
