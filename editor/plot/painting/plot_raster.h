// Draws a curve as one vertical span per pixel column, with soft ends, straight into an image: ten million samples cost
// as much as there are columns. Pure picture work, any thread.
#pragma once

#include <QColor>
#include <QImage>
#include <QRect>

#include <span>

namespace plc::plot {

/// Rows covered in one pixel column, fractions count; top > bottom: nothing.
struct ColumnSpan {
    float top = 1, bottom = 0;

    [[nodiscard]] bool isEmpty() const { return top > bottom; }
    void add(float y) {
        if (isEmpty())
            top = bottom = y;
        else if (y < top)
            top = y;
        else if (y > bottom)
            bottom = y;
    }
};

/// `image` is 32 bits a pixel, premultiplied or opaque; span i lies in column i of `area`, rows count from its top, and
/// is widened by half of `width` at both ends. What the width has beyond one pixel sideways falls softly into the
/// neighbouring columns, so that steep lines are not thinner than level ones. Nothing is drawn outside the area.
void fillColumns(QImage& image, const QRect& area, std::span<const ColumnSpan> spans, float width, const QColor& color);

} // namespace plc::plot
