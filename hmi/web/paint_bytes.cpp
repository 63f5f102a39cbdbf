#include "hmi/web/paint_bytes.h"

namespace plc::hmi::web {

namespace {
struct PathStep {
    enum : uint8_t { End, Move, Line, Curve, Close };
};
} // namespace

void PaintBytes::path(const QPainterPath& path) {
    byte(path.fillRule() == Qt::OddEvenFill ? 0 : 1);
    // Ways are between rounded points: rounding errors do not add up along a long path.
    const auto rounded = [](QPointF at) { return QPointF(std::round(at.x() * 64) / 64, std::round(at.y() * 64) / 64); };
    QPointF at, first;
    const auto go = [&](QPointF to) {
        const QPointF there = rounded(to);
        point(there - at);
        at = there;
    };
    const int size = path.elementCount();
    for (int i = 0; i < size; ++i) {
        const QPainterPath::Element element = path.elementAt(i);
        const bool isLast = i + 1 == size || path.elementAt(i + 1).isMoveTo();
        if (element.isMoveTo()) {
            byte(PathStep::Move);
            first = rounded(element);
            go(element);
            continue;
        }
        if (element.isLineTo()) {
            if (isLast && rounded(element) == first) {
                byte(PathStep::Close);
                at = first;
                continue;
            }
            byte(PathStep::Line);
            go(element);
            continue;
        }
        if (i + 2 >= size) break;
        byte(PathStep::Curve);
        go(element);
        go(path.elementAt(i + 1));
        go(path.elementAt(i + 2));
        i += 2;
        if ((i + 1 == size || path.elementAt(i + 1).isMoveTo()) && at == first) byte(PathStep::Close);
    }
    byte(PathStep::End);
}

} // namespace plc::hmi::web
