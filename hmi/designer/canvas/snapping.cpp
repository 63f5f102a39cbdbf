#include "hmi/designer/canvas/snapping.h"

#include <algorithm>
#include <cmath>

namespace plc::hmi {

namespace {

/// One direction of a rectangle: its begin and end, and across it, for the length of a guide.
struct Span {
    double begin, end, acrossBegin, acrossEnd;
    double center() const { return (begin + end) / 2; }
};

Span spanOf(const QRectF& rect, bool flat) {
    return flat ? Span{rect.left(), rect.right(), rect.top(), rect.bottom()}
                : Span{rect.top(), rect.bottom(), rect.left(), rect.right()};
}

QLineF lineAt(double at, double from, double to, bool flat) {
    return flat ? QLineF(at, from, at, to) : QLineF(from, at, to, at);
}

struct Best {
    double distance = 1e9, offset = 0;
    bool isFound = false;
    std::vector<Guide> guides;
    void offer(double by, double reach, const std::vector<Guide>& lines) {
        const double distance = std::abs(by);
        if (distance > reach || distance > distance_() + 1e-6) return;
        if (distance < distance_() - 1e-6) guides.clear();
        this->distance = distance;
        offset = by;
        isFound = true;
        guides.insert(guides.end(), lines.begin(), lines.end());
    }
    double distance_() const { return distance; }
};

void offerLines(Best& best, const Span& moving, const std::vector<double>& edges, const Span& other, bool flat,
                double reach) {
    for (const double target : {other.begin, other.center(), other.end})
        for (const double edge : edges) {
            const double from = std::min(moving.acrossBegin, other.acrossBegin),
                         to = std::max(moving.acrossEnd, other.acrossEnd);
            best.offer(target - edge, reach, {{lineAt(target, from - 6, to + 6, flat), false}});
        }
}

/// Equal gaps: between two neighbours, or continuing the gap of the two on one side.
void offerGaps(Best& best, const Span& moving, const std::vector<Span>& others, bool flat, double reach) {
    std::vector<Span> row;
    for (const Span& other : others)
        if (other.acrossEnd > moving.acrossBegin && other.acrossBegin < moving.acrossEnd) row.push_back(other);
    std::sort(row.begin(), row.end(), [](const Span& a, const Span& b) { return a.begin < b.begin; });
    const double length = moving.end - moving.begin, middle = (moving.acrossBegin + moving.acrossEnd) / 2;
    const auto gapLine = [&](double from, double to) {
        return Guide{flat ? QLineF(from, middle, to, middle) : QLineF(middle, from, middle, to), true};
    };
    for (size_t i = 0; i + 1 < row.size(); ++i) {
        const Span &a = row[i], &b = row[i + 1];
        const double gap = b.begin - a.end;
        if (gap <= 0.5) continue;
        if (gap > length) { // in the middle between two
            const double begin = a.end + (gap - length) / 2;
            best.offer(begin - moving.begin, reach, {gapLine(a.end, begin), gapLine(begin + length, b.begin)});
        }
        best.offer(b.end + gap - moving.begin, reach, {gapLine(a.end, b.begin), gapLine(b.end, b.end + gap)});
        best.offer(a.begin - gap - length - moving.begin, reach,
                   {gapLine(a.begin - gap, a.begin), gapLine(a.end, b.begin)});
    }
}

double gridOffset(double value, double grid) { return grid > 0 ? std::round(value / grid) * grid - value : 0; }

} // namespace

Snapped snapMove(const QRectF& rect, const SnapField& field) {
    Snapped out;
    for (const bool flat : {true, false}) {
        const Span moving = spanOf(rect, flat);
        const std::vector<double> edges{moving.begin, moving.center(), moving.end};
        Best best;
        std::vector<Span> others;
        for (const QRectF& other : field.others) others.push_back(spanOf(other, flat));
        for (const Span& other : others) offerLines(best, moving, edges, other, flat, field.reach);
        offerLines(best, moving, edges, spanOf(field.panel, flat), flat, field.reach);
        offerGaps(best, moving, others, flat, field.reach);
        const double by = best.isFound ? best.offset : gridOffset(moving.begin, field.grid);
        (flat ? out.offset.rx() : out.offset.ry()) = by;
        out.guides.insert(out.guides.end(), best.guides.begin(), best.guides.end());
    }
    return out;
}

Snapped snapResize(const QRectF& rect, DraggedEdges edges, const SnapField& field) {
    Snapped out;
    for (const bool flat : {true, false}) {
        const bool begin = flat ? edges.left : edges.top, end = flat ? edges.right : edges.bottom;
        if (!begin && !end) continue;
        const Span moving = spanOf(rect, flat);
        const double edge = begin ? moving.begin : moving.end;
        Best best;
        for (const QRectF& other : field.others)
            offerLines(best, moving, {edge}, spanOf(other, flat), flat, field.reach);
        offerLines(best, moving, {edge}, spanOf(field.panel, flat), flat, field.reach);
        // As wide or high as another one.
        for (const QRectF& other : field.others) {
            const Span span = spanOf(other, flat);
            const double wanted = begin ? moving.end - (span.end - span.begin) : moving.begin + (span.end - span.begin);
            best.offer(wanted - edge, field.reach / 2, {});
        }
        (flat ? out.offset.rx() : out.offset.ry()) = best.isFound ? best.offset : gridOffset(edge, field.grid);
        out.guides.insert(out.guides.end(), best.guides.begin(), best.guides.end());
    }
    return out;
}

} // namespace plc::hmi
