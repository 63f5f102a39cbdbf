#include "editor/plot/painting/plot_curves.h"

#include "editor/kit/pen_order.h"
#include "editor/kit/theme.h"
#include "editor/plot/model/plot_scale.h"
#include "editor/plot/painting/plot_line.h"
#include "editor/plot/painting/plot_raster.h"
#include "editor/plot/painting/plot_text.h"

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>
#include <QPainterPath>

#include <cmath>

namespace plc::plot {

namespace {

bool isBroken(const std::vector<SignalGap>& gaps, int64_t from, int64_t to) {
    for (const SignalGap& gap : gaps)
        if (gap.from >= from && gap.to <= to && gap.to > gap.from) return true;
    return false;
}

std::optional<int64_t> gapStart(const std::vector<SignalGap>& gaps, int64_t from, int64_t to) {
    for (const SignalGap& gap : gaps)
        if (gap.from >= from && gap.to <= to && gap.to > gap.from) return gap.from;
    return std::nullopt;
}

/// Width of a held curve: whole device pixels.
double heldWidth(const PlotCurve& curve, const PlotMapping& mapping) {
    return mapping.ratio > 0 ? std::max(1.0, std::round(curve.width * mapping.ratio)) / mapping.ratio : curve.width;
}

/// Level and upright lines look sharp when their edges lie between pixels.
double onPixel(double at, const PlotCurve& curve, const PlotMapping& mapping) {
    if (mapping.ratio <= 0 || std::abs(at) > 1e6) return at;
    const double half = heldWidth(curve, mapping) * mapping.ratio / 2;
    return (std::round(at * mapping.ratio - half) + half) / mapping.ratio;
}

/// Collects polylines from samples; a held value goes right before it goes up.
class LineMaker {
public:
    LineMaker(const CurveShape& shape, const PlotCurve& curve, const PlotMapping& mapping)
        : m_shape(shape), m_curve(curve), m_mapping(mapping) {}

    template <class Use> void run(Use&& use) const {
        QPolygonF line;
        const bool hold = m_curve.style != CurveStyle::Line;
        const SignalSample* before = nullptr;
        for (const SignalSample& s : m_shape.samples) {
            // A gap is a fact of the recording: samples that are far apart belong together unless one lies between
            // them, since a value that does not change may be recorded rarely.
            const bool broken = std::isnan(s.value) || (before && isBroken(m_shape.gaps, before->time, s.time));
            if (broken && !line.isEmpty()) {
                // A held value was known up to where the gap begins, so its line goes on until there.
                if (hold && before) {
                    const int64_t end = gapStart(m_shape.gaps, before->time, s.time).value_or(s.time);
                    line << QPointF(m_mapping.xOf(end), line.back().y());
                }
                use(line);
                line.clear();
            }
            if (std::isnan(s.value)) {
                before = nullptr;
                continue;
            }
            QPointF point(m_mapping.xOf(s.time), m_mapping.yOf(m_curve.shown(s.value)));
            if (hold) point = QPointF(onPixel(point.x(), m_curve, m_mapping), onPixel(point.y(), m_curve, m_mapping));
            if (hold && !line.isEmpty() && line.back().y() != point.y()) line << QPointF(point.x(), line.back().y());
            line << point;
            before = &s;
        }
        if (!line.isEmpty()) use(line);
    }

private:
    const CurveShape& m_shape;
    const PlotCurve& m_curve;
    const PlotMapping& m_mapping;
};

// Painters of PDF and SVG lose precision or drop the line when a zoomed curve reaches millions of pixels beyond the
// paper.
/// The same line with everything far outside the area cut off, so that no painter meets coordinates of millions.
QPolygonF clipped(const QPolygonF& line, const QRectF& area) {
    const QRectF room = area.adjusted(-64, -64, 64, 64);
    bool inside = true;
    for (const QPointF& p : line) inside = inside && room.contains(p);
    if (inside) return line;
    auto clamped = [&](const QPointF& p) {
        return QPointF(std::clamp(p.x(), room.left(), room.right()), std::clamp(p.y(), room.top(), room.bottom()));
    };
    QPolygonF result;
    for (qsizetype i = 0; i < line.size(); ++i) {
        if (i > 0) { // the points where the segment crosses an edge keep its slope
            const QPointF a = line[i - 1], d = line[i] - a;
            std::vector<double> crossings;
            auto cross = [&](double from, double way, double edge) {
                if (way != 0 && (edge - from) / way > 0 && (edge - from) / way < 1)
                    crossings.push_back((edge - from) / way);
            };
            cross(a.x(), d.x(), room.left());
            cross(a.x(), d.x(), room.right());
            cross(a.y(), d.y(), room.top());
            cross(a.y(), d.y(), room.bottom());
            std::sort(crossings.begin(), crossings.end());
            for (double t : crossings) result << clamped(a + d * t);
        }
        result << clamped(line[i]);
    }
    return result;
}

/// Spans of a polyline in device columns; vertical parts cover one column.
void addLine(std::vector<ColumnSpan>& spans, const QPolygonF& line) {
    const auto columns = static_cast<double>(spans.size());
    if (line.size() == 1 && line[0].x() >= 0 && line[0].x() < columns)
        spans[static_cast<size_t>(line[0].x())].add(static_cast<float>(line[0].y()));
    for (qsizetype i = 1; i < line.size(); ++i) {
        const QPointF a = line[i - 1], b = line[i];
        if (b.x() < 0 || a.x() >= columns) continue;
        const double slope = b.x() > a.x() ? (b.y() - a.y()) / (b.x() - a.x()) : 0;
        const auto first = static_cast<size_t>(std::max(0.0, std::floor(a.x()))),
                   last = static_cast<size_t>(std::min(columns - 1, std::floor(b.x())));
        for (size_t c = first; c <= last && c < spans.size(); ++c) {
            const double from = std::max(a.x(), static_cast<double>(c)),
                         to = std::min(b.x(), static_cast<double>(c + 1));
            spans[c].add(static_cast<float>(b.x() > a.x() ? a.y() + slope * (from - a.x()) : a.y()));
            spans[c].add(static_cast<float>(b.x() > a.x() ? a.y() + slope * (to - a.x()) : b.y()));
        }
    }
}

/// Which columns begin behind a gap.
std::vector<bool> breaksBefore(const CurveShape& shape) {
    std::vector<bool> breaks(static_cast<size_t>(shape.columns) + 1, false);
    for (const SignalGap& gap : shape.gaps) {
        const double at =
            static_cast<double>(gap.to - shape.from) / static_cast<double>(shape.to - shape.from) * shape.columns;
        if (at >= 0 && at <= shape.columns) breaks[static_cast<size_t>(at)] = true;
    }
    return breaks;
}

/// Walks over the buckets with a number: column, bucket, whether joined to the one before.
template <class Use> void walkBuckets(const CurveShape& shape, Use&& use) {
    const std::vector<bool> breaks = breaksBefore(shape);
    bool broken = false;
    for (int c = 0; c < shape.columns; ++c) {
        broken = broken || breaks[static_cast<size_t>(c)];
        const SignalBucket& bucket = shape.buckets[static_cast<size_t>(c)];
        // An empty bucket joins its neighbours (there was no sample in so short a time); one with nothing but NaN does
        // not.
        if (bucket.count > 0 && !bucket.isNumber) broken = true;
        if (!bucket.isNumber) continue;
        use(c, bucket, !broken);
        broken = false;
    }
}

void addBuckets(std::vector<ColumnSpan>& spans, const CurveShape& shape, const PlotCurve& curve,
                const PlotMapping& device) {
    auto y = [&](double raw) { return static_cast<float>(device.yOf(curve.shown(raw))); };
    int previous = -1;
    float previousY = 0;
    bool hasPrevious = false;
    if (shape.before && !std::isnan(shape.before->value)) previousY = y(shape.before->value), hasPrevious = true;
    walkBuckets(shape, [&](int c, const SignalBucket& bucket, bool joined) {
        ColumnSpan& span = spans[static_cast<size_t>(c)];
        const float firstY = y(std::isnan(bucket.first) ? bucket.minimum : bucket.first);
        if (joined && hasPrevious) {
            if (curve.style == CurveStyle::Line) {
                const int steps = c - previous;
                for (int k = 1; k < steps; ++k)
                    spans[static_cast<size_t>(previous + k)].add(
                        previousY + (firstY - previousY) * static_cast<float>(k) / static_cast<float>(steps));
                const float middle = (previousY + firstY) / 2;
                // Both columns get the middle of the jump, or the line would have a hole at each steep edge.
                if (previous >= 0 && steps == 1) spans[static_cast<size_t>(previous)].add(middle);
                span.add(steps == 1 ? middle : firstY);
            } else {
                for (int k = previous + 1; k < c; ++k) spans[static_cast<size_t>(k)].add(previousY);
                span.add(previousY);
            }
        }
        span.add(y(bucket.minimum));
        span.add(y(bucket.maximum));
        previous = c;
        previousY = y(std::isnan(bucket.last) ? bucket.maximum : bucket.last);
        hasPrevious = true;
    });
    // A held value reaches the right edge only when a later sample shows that it went on.
    if (previous >= 0 && shape.after && previous < shape.columns - 1 && curve.style != CurveStyle::Line)
        for (int k = previous + 1; k < shape.columns; ++k) spans[static_cast<size_t>(k)].add(previousY);
}

/// Vector paper: first, minimum, maximum, last of each column as points.
void pathOfBuckets(const CurveShape& shape, const PlotCurve& curve, const PlotMapping& mapping,
                   std::vector<QPolygonF>& lines) {
    QPolygonF line;
    const double step = mapping.area.width() / shape.columns;
    walkBuckets(shape, [&](int c, const SignalBucket& bucket, bool joined) {
        if (!joined && !line.isEmpty()) {
            lines.push_back(line);
            line.clear();
        }
        const double x = mapping.area.left() + (c + 0.5) * step;
        auto y = [&](double raw) { return mapping.yOf(curve.shown(raw)); };
        if (curve.style != CurveStyle::Line && !line.isEmpty()) line << QPointF(x, line.back().y());
        const auto number = [&](double value) { return std::isnan(value) ? bucket.minimum : value; };
        for (const double value :
             kit::PenOrder(number(bucket.first), bucket.minimum, bucket.maximum, number(bucket.last)))
            line << QPointF(x, y(value));
    });
    if (!line.isEmpty()) lines.push_back(line);
}

void drawDots(QPainter& painter, const CurveShape& shape, const PlotCurve& curve, const PlotMapping& mapping,
              const QColor& color) {
    // A dot marks a sample; closer together they would only make the line thicker.
    if (shape.samples.size() < 1 || mapping.area.width() / static_cast<double>(shape.samples.size()) < 14) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    const double radius = curve.width * 0.7 + 1.2;
    for (const SignalSample& s : shape.samples)
        if (!std::isnan(s.value))
            painter.drawEllipse(QPointF(mapping.xOf(s.time), mapping.yOf(curve.shown(s.value))), radius, radius);
}

} // namespace

bool isDrawnByPainter(const CurveShape& shape, const PlotPixels& pixels) {
    return !pixels.image || (shape.isExact && shape.samples.size() <= pixels.finely);
}

std::optional<PlotRange> CurveShape::extent() const {
    std::optional<PlotRange> range;
    auto add = [&](double low, double high) {
        // An axis cannot reach infinity: one such sample would hide all others.
        if (std::isnan(low) || std::isnan(high) || std::isinf(low) || std::isinf(high)) return;
        if (!range) range = PlotRange{low, high};
        range->low = std::min(range->low, low);
        range->high = std::max(range->high, high);
    };
    if (isExact)
        for (const SignalSample& s : samples) add(s.value, s.value);
    else
        for (const SignalBucket& b : buckets)
            if (b.isNumber) add(b.minimum, b.maximum);
    return range;
}

CurveShape shapeOf(const SampleSource& source, int64_t from, int64_t to, int columns, int64_t shift) {
    CurveShape shape;
    shape.from = from;
    shape.to = std::max(to, from + 1);
    shape.columns = std::max(1, columns);
    // `shift` moves another recording under this one; it is asked in its own time.
    const int64_t a = shape.from - shift, b = shape.to - shift;
    shape.gaps = source.gaps(a, b);
    const auto known = source.timeRange();
    for (SignalGap& gap : shape.gaps) {
        // nothing older is left either: it is shaded from the edge on
        if (gap.reason == SignalGap::Reason::Evicted && (!known || known->first >= gap.to)) gap.from = a;
        gap.from += shift;
        gap.to += shift;
    }
    shape.before = source.inForceAt(a - 1);
    shape.after = source.after(b - 1);
    if (shape.before) shape.before->time += shift;
    if (shape.after) shape.after->time += shift;
    const uint64_t count = source.countIn(a, b);
    // Up to two samples a column a pyramid would save nothing, and exact samples keep their slopes when zoomed.
    shape.isExact = count <= 2 * static_cast<uint64_t>(shape.columns);
    if (!shape.isExact) {
        shape.buckets.resize(static_cast<size_t>(shape.columns));
        source.buckets(a, b, shape.buckets);
        return shape;
    }
    shape.samples.reserve(count + 2);
    if (shape.before) shape.samples.push_back(*shape.before);
    source.visit(a, b, [&](std::span<const SignalSample> block) {
        for (SignalSample s : block) {
            s.time += shift;
            shape.samples.push_back(s);
        }
    });
    if (shape.after) shape.samples.push_back(*shape.after);
    return shape;
}

void drawCurve(QPainter& painter, const CurveShape& shape, const PlotCurve& curve, const PlotMapping& mapping,
               const QColor& color, const PlotPixels& pixels) {
    if (!isDrawnByPainter(shape, pixels)) {
        PlotMapping device = mapping;
        device.area = QRectF(0, 0, pixels.area.width(), pixels.area.height());
        device.ratio = 1;
        std::vector<ColumnSpan> spans(static_cast<size_t>(pixels.area.width()));
        if (shape.isExact)
            LineMaker(shape, curve, device).run([&](const QPolygonF& line) { addLine(spans, line); });
        else
            addBuckets(spans, shape, curve, device);
        const double ratio = pixels.area.width() / mapping.area.width();
        PlotCurve scaled;
        scaled.width = curve.width * ratio;
        const auto width =
            static_cast<float>(curve.style == CurveStyle::Line ? scaled.width : heldWidth(scaled, device));
        fillColumns(*pixels.image, pixels.area, spans, width, color);
        return;
    }
    drawLine(painter, shape, curve, mapping, color);
    if (!shape.isExact) return;
    painter.save();
    painter.setClipRect(mapping.area, Qt::IntersectClip);
    drawDots(painter, shape, curve, mapping, color);
    painter.restore();
}

void drawLine(QPainter& painter, const CurveShape& shape, const PlotCurve& curve, const PlotMapping& mapping,
              const QColor& color) {
    std::vector<QPolygonF> lines;
    if (shape.isExact)
        LineMaker(shape, curve, mapping).run([&](const QPolygonF& line) { lines.push_back(line); });
    else
        pathOfBuckets(shape, curve, mapping, lines);
    painter.save();
    painter.setClipRect(mapping.area, Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    const double width = curve.style == CurveStyle::Line ? curve.width : heldWidth(curve, mapping);
    painter.setPen(QPen(color, width, Qt::SolidLine, Qt::FlatCap,
                        curve.style == CurveStyle::Line ? Qt::RoundJoin : Qt::MiterJoin));
    for (const QPolygonF& line : lines) {
        if (line.size() == 1)
            painter.drawPoint(line[0]);
        else
            painter.drawPolyline(clipped(line, mapping.area));
    }
    painter.restore();
}

namespace {

/// A stretch of one value in a lane; busy: it changed faster than pixels can show.
struct LaneRun {
    double from = 0, to = 0;
    double value = 0;
    bool isBusy = false;
};

std::vector<LaneRun> laneRuns(const CurveShape& shape, const PlotMapping& mapping) {
    std::vector<LaneRun> runs;
    auto add = [&](double from, double to, double value, bool busy) {
        from = std::max(from, mapping.area.left());
        to = std::min(to, mapping.area.right());
        if (to <= from) return;
        if (!runs.empty() && std::abs(runs.back().to - from) < 0.01 && runs.back().isBusy == busy &&
            (busy || runs.back().value == value))
            runs.back().to = to;
        else
            runs.push_back({from, to, value, busy});
    };
    if (shape.isExact) {
        for (size_t i = 0; i < shape.samples.size(); ++i) {
            const SignalSample& s = shape.samples[i];
            if (std::isnan(s.value)) continue;
            const bool last = i + 1 == shape.samples.size();
            int64_t end = last ? s.time : shape.samples[i + 1].time;
            if (!last)
                if (const auto gap = gapStart(shape.gaps, s.time, end)) end = *gap;
            add(mapping.xOf(s.time), last ? mapping.xOf(end) + 1 : mapping.xOf(end), s.value, false);
        }
        return runs;
    }
    const double step = mapping.area.width() / shape.columns;
    double previous = shape.before ? shape.before->value : 0, reached = mapping.area.left();
    bool hasPrevious = shape.before.has_value();
    walkBuckets(shape, [&](int c, const SignalBucket& bucket, bool joined) {
        const double from = mapping.area.left() + c * step;
        if (joined && hasPrevious && from > reached) add(reached, from, previous, false);
        const bool busy = bucket.minimum != bucket.maximum;
        add(from, from + step, bucket.last, busy);
        previous = bucket.last;
        reached = from + step;
        hasPrevious = true;
    });
    return runs;
}

void drawBoolLane(QPainter& painter, const std::vector<LaneRun>& runs, const PlotCurve& curve,
                  const PlotMapping& mapping, const QColor& color) {
    const QRectF lane = mapping.area;
    const double high = onPixel(lane.top() + lane.height() * 0.18, curve, mapping),
                 low = onPixel(lane.bottom() - lane.height() * 0.18, curve, mapping);
    QColor fill = color;
    fill.setAlphaF(0.20f);
    QColor busy = color;
    busy.setAlphaF(0.65f);
    const QPen pen(color, heldWidth(curve, mapping), Qt::SolidLine, Qt::SquareCap);
    painter.setPen(pen);
    const LaneRun* before = nullptr;
    for (const LaneRun& run : runs) {
        const bool touches = before && std::abs(before->to - run.from) < 0.01;
        if (run.isBusy) {
            painter.fillRect(QRectF(QPointF(run.from, high), QPointF(std::max(run.to, run.from + 1), low)), busy);
        } else {
            const double y = run.value != 0 ? high : low, from = onPixel(run.from, curve, mapping);
            if (run.value != 0) painter.fillRect(QRectF(QPointF(run.from, high), QPointF(run.to, low)), fill);
            painter.drawLine(QPointF(from, y), QPointF(onPixel(run.to, curve, mapping), y));
            if (touches && !before->isBusy && before->value != run.value)
                painter.drawLine(QPointF(from, high), QPointF(from, low));
        }
        before = &run;
    }
}

void drawValueLane(QPainter& painter, const std::vector<LaneRun>& runs, const PlotCurve& curve, const QRectF& lane,
                   const QColor& color, const QFont& font) {
    const double top = lane.top() + lane.height() * 0.14, bottom = lane.bottom() - lane.height() * 0.14,
                 middle = (top + bottom) / 2;
    QColor fill = color;
    fill.setAlphaF(0.14f);
    QColor busy = color;
    busy.setAlphaF(0.5f);
    painter.setFont(font);
    const QFontMetricsF metrics(font);
    for (const LaneRun& run : runs) {
        if (run.isBusy || run.to - run.from < 3) {
            painter.fillRect(QRectF(QPointF(run.from, top), QPointF(std::max(run.to, run.from + 1), bottom)), busy);
            continue;
        }
        const double slant = std::min(4.0, (run.to - run.from) / 2);
        const bool openLeft = run.from <= lane.left() + 0.01, openRight = run.to >= lane.right() - 0.01;
        QPolygonF box;
        if (openLeft)
            box << QPointF(run.from, bottom) << QPointF(run.from, top);
        else
            box << QPointF(run.from + slant, bottom) << QPointF(run.from, middle) << QPointF(run.from + slant, top);
        if (openRight)
            box << QPointF(run.to, top) << QPointF(run.to, bottom);
        else
            box << QPointF(run.to - slant, top) << QPointF(run.to, middle) << QPointF(run.to - slant, bottom);
        painter.setPen(QPen(color, 1.2));
        painter.setBrush(fill);
        painter.drawPolygon(box);
        const QString text = curveValueText(curve, run.value, 6, false);
        const double room = run.to - run.from - 2 * slant - 2;
        QString shown = metrics.horizontalAdvance(text) <= room ? text : metrics.elidedText(text, Qt::ElideRight, room);
        if (shown.size() < 2 && shown != text) continue;
        if (shown != text) { // smaller letters before torn words
            QFont small = font;
            small.setPointSizeF(font.pointSizeF() * 0.82);
            if (QFontMetricsF(small).horizontalAdvance(text) <= room) {
                painter.setFont(small);
                shown = text;
            }
        }
        painter.setPen(kit::colors().text);
        painter.drawText(QRectF(run.from + slant, lane.top(), run.to - run.from - 2 * slant, lane.height()),
                         Qt::AlignCenter, shown);
        painter.setFont(font);
    }
}

} // namespace

void drawLane(QPainter& painter, const CurveShape& shape, const PlotCurve& curve, const PlotMapping& mapping,
              const QColor& color, const QFont& font) {
    const std::vector<LaneRun> runs = laneRuns(shape, mapping);
    painter.save();
    painter.setClipRect(mapping.area);
    const bool isBool = curve.valueNames.empty() && curve.source && curve.source->valueKind() == PlotValueKind::Bool;
    painter.setRenderHint(QPainter::Antialiasing, !isBool);
    if (isBool)
        drawBoolLane(painter, runs, curve, mapping, color);
    else
        drawValueLane(painter, runs, curve, mapping.area, color, font);
    painter.restore();
}

void drawGaps(QPainter& painter, const std::vector<SignalGap>& gaps, const PlotMapping& mapping, const QFont& font) {
    painter.save();
    painter.setClipRect(mapping.area);
    const QFontMetricsF metrics(font);
    painter.setFont(font);
    for (const SignalGap& gap : gaps) {
        double from = mapping.xOf(std::max(gap.from, mapping.from)), to = mapping.xOf(std::min(gap.to, mapping.to));
        if (to - from < 1) to = from + 1;
        const QRectF rect(QPointF(from, mapping.area.top()), QPointF(to, mapping.area.bottom()));
        painter.fillRect(rect, kit::colors().plotGap);
        painter.fillRect(rect, QBrush(kit::colors().plotGrid, Qt::BDiagPattern));
        QString text;
        switch (gap.reason) {
        case SignalGap::Reason::Evicted:
            text = PlotText::tr("no longer kept");
            break;
        case SignalGap::Reason::NoPath:
            text = PlotText::tr("did not exist");
            break;
        case SignalGap::Reason::SkippedScans:
            text = PlotText::tr("scans skipped");
            break;
        case SignalGap::Reason::NotRecorded:
            text = PlotText::tr("not recorded");
            break;
        }
        if (metrics.horizontalAdvance(text) + 12 > rect.width()) continue;
        painter.setPen(kit::colors().muted);
        painter.drawText(rect.adjusted(6, 6, -6, -6), Qt::AlignHCenter | Qt::AlignTop, text);
    }
    painter.restore();
}

} // namespace plc::plot
