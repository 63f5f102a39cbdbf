#include "editor/kit/plot_raster.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plc::kit {

namespace {

constexpr int Block = 16; // columns that share cache lines

/// source over destination, both premultiplied, source scaled by alpha/255.
uint32_t blend(uint32_t source, uint32_t destination, uint32_t alpha) {
    auto scaled = [](uint32_t pixel, uint32_t by) {
        const uint32_t low = ((pixel & 0xff00ff) * by + 0x800080) >> 8 & 0xff00ff;
        const uint32_t high = ((pixel >> 8 & 0xff00ff) * by + 0x800080) & 0xff00ff00;
        return low | high;
    };
    const uint32_t top = scaled(source, alpha + (alpha >> 7));
    return top + scaled(destination, 256 - ((top >> 24) + (top >> 31)));
}

} // namespace

void fillColumns(QImage& image, std::span<const ColumnSpan> spans, float width, const QColor& color) {
    const int columns = std::min<int>(image.width(), static_cast<int>(spans.size())), rows = image.height();
    const uint32_t ink = qPremultiply(color.rgba());
    const float half = std::max(0.5f, width / 2);
    for (int x0 = 0; x0 < columns; x0 += Block) {
        const int count = std::min(Block, columns - x0);
        std::array<float, Block> top{}, bottom{};
        int first = rows, last = -1;
        for (int i = 0; i < count; ++i) {
            const ColumnSpan& span = spans[static_cast<size_t>(x0 + i)];
            if (span.isEmpty() || !(span.bottom + half > 0) || !(span.top - half < static_cast<float>(rows))) {
                top[static_cast<size_t>(i)] = 1e9f;
                bottom[static_cast<size_t>(i)] = -1e9f;
                continue;
            }
            const float a = std::max(span.top - half, -4.0f), b = std::min(span.bottom + half, static_cast<float>(rows) + 4.0f);
            top[static_cast<size_t>(i)] = a;
            bottom[static_cast<size_t>(i)] = b;
            first = std::min(first, std::max(0, static_cast<int>(std::floor(a))));
            last = std::max(last, std::min(rows - 1, static_cast<int>(std::ceil(b)) - 1));
        }
        for (int y = first; y <= last; ++y) {
            auto* pixels = reinterpret_cast<uint32_t*>(image.scanLine(y)) + x0;
            const auto above = static_cast<float>(y), below = static_cast<float>(y + 1);
            for (int i = 0; i < count; ++i) {
                const float a = top[static_cast<size_t>(i)], b = bottom[static_cast<size_t>(i)];
                if (a >= below || b <= above) continue;
                const float cover = std::min(b, below) - std::max(a, above);
                pixels[i] = blend(ink, pixels[i], static_cast<uint32_t>(cover * 255.0f + 0.5f));
            }
        }
    }
}

} // namespace plc::kit
