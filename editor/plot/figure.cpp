#include "editor/plot/figure.h"

#include "editor/kit/texts.h"
#include "editor/kit/theme.h"
#include "editor/plot/model/plot_scale.h"
#include "editor/plot/painting/ruler_mark.h"

#include <QApplication>
#include <QPainter>
#include <QPainterPath>
#include <QSaveFile>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace plc::plot {

namespace {

using waveform::Chart;
using waveform::Curve;

constexpr double kPad = 6;

QColor colourOf(const Curve& curve) {
    const QColor own(kit::fromView(curve.ownColour));
    if (own.isValid()) return own;
    return curve.colour < 0 ? kit::colors().muted : kit::colors().curve(curve.colour);
}

double shareOf(double value, const PlotRange& range, bool isLogarithmic) {
    if (isLogarithmic) return std::log(value / range.low) / std::log(range.high / range.low);
    return (value - range.low) / (range.high - range.low);
}

double valueOf(double share, const PlotRange& range, bool isLogarithmic) {
    if (isLogarithmic) return range.low * std::pow(range.high / range.low, share);
    return range.low + share * (range.high - range.low);
}

/// Least and greatest of the curves, with room where there is none.
PlotRange rangeOf(const Chart& chart, std::vector<double> Curve::*values, bool isLogarithmic) {
    double low = 1e300, high = -1e300;
    for (const Curve& curve : chart.curves)
        for (const double value : curve.*values)
            if (std::isfinite(value) && (!isLogarithmic || value > 0))
                low = std::min(low, value), high = std::max(high, value);
    if (low > high) return isLogarithmic ? PlotRange{0.1, 10} : PlotRange{0, 1};
    if (isLogarithmic) return high > low * 1.0001 ? PlotRange{low, high} : PlotRange{low / 3, high * 3};
    if (high - low < 1e-9 * std::max(1.0, std::abs(high))) return {low - 0.5, high + 0.5};
    return {low, high};
}

PlotRange withMargin(PlotRange range, bool isLogarithmic, double share) {
    if (isLogarithmic) {
        const double factor = std::pow(range.high / range.low, share);
        return {range.low / factor, range.high * factor};
    }
    const double margin = (range.high - range.low) * share;
    return {range.low - margin, range.high + margin};
}

/// An amplitude that falls to nothing would flatten the rest.
PlotRange valuesOf(const Chart& chart) {
    PlotRange range = rangeOf(chart, &Curve::y, chart.isLogarithmicY);
    constexpr double kMostDecades = 1e6;
    if (chart.isLogarithmicY)
        range.low = std::max(range.low, range.high / kMostDecades);
    else
        std::tie(range.low, range.high) = waveform::spanOf(range.low, range.high, chart.leastSpan);
    return withMargin(range, chart.isLogarithmicY, 0.06);
}

std::vector<PlotTick> ticksOf(const PlotRange& range, bool isLogarithmic, int most) {
    if (!isLogarithmic || range.high / range.low < 4) return numberTicks(range.low, range.high, most);
    std::vector<PlotTick> out;
    const std::vector<double> all = waveform::logarithmicTicks(range.low, range.high);
    const size_t step =
        (all.size() + static_cast<size_t>(std::max(most, 1)) - 1) / static_cast<size_t>(std::max(most, 1));
    for (size_t i = 0; i < all.size(); i += std::max<size_t>(step, 1)) out.push_back({all[i], valueText(all[i], 3)});
    return out;
}

void drawText(QPainter& painter, const QPointF& at, int flags, const QString& what) {
    // room on both sides of the point, so that every alignment has its place
    constexpr double kRoom = 400;
    double x = at.x() - kRoom, y = at.y() - kRoom;
    if (flags & Qt::AlignLeft) x = at.x();
    if (flags & Qt::AlignRight) x = at.x() - 2 * kRoom;
    if (flags & Qt::AlignTop) y = at.y();
    if (flags & Qt::AlignBottom) y = at.y() - 2 * kRoom;
    painter.drawText(QRectF(x, y, 2 * kRoom, 2 * kRoom), flags, what);
}

void paintAxes(QPainter& painter, const Chart& chart, const FigureFrame& frame, const QFont& font) {
    const kit::ThemeColors& colors = kit::colors();
    const QFontMetricsF metrics(font);
    painter.setRenderHint(QPainter::Antialiasing, false);
    for (const PlotTick& tick : ticksOf(frame.x, frame.isLogarithmicX, std::max(int(frame.area.width()) / 70, 2))) {
        const double x = std::round(frame.xOf(tick.value)) + 0.5;
        painter.setPen(colors.plotGrid);
        painter.drawLine(QPointF(x, frame.area.top()), QPointF(x, frame.area.bottom()));
        painter.setPen(colors.plotAxis);
        drawText(painter, {x, frame.area.bottom() + 3}, Qt::AlignHCenter | Qt::AlignTop, tick.label);
    }
    for (const PlotTick& tick : ticksOf(frame.y, frame.isLogarithmicY, std::max(int(frame.area.height()) / 24, 3))) {
        const double y = std::round(frame.yOf(tick.value)) + 0.5;
        painter.setPen(colors.plotGrid);
        painter.drawLine(QPointF(frame.area.left(), y), QPointF(frame.area.right(), y));
        painter.setPen(colors.plotAxis);
        drawText(painter, {frame.area.left() - 5, y}, Qt::AlignRight | Qt::AlignVCenter, tick.label);
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(colors.border);
    painter.drawRect(frame.area);
    if (!frame.hasTitleX) return;
    painter.setPen(colors.muted);
    drawText(painter, {frame.area.center().x(), frame.area.bottom() + metrics.height() + 3},
             Qt::AlignHCenter | Qt::AlignTop, kit::fromView(chart.xTitle));
}

/// Points that fall onto the pixel of the one before are left out; a gap parts the line.
std::vector<QPolygonF> strokesOf(const Curve& curve, const FigureFrame& frame) {
    std::vector<QPolygonF> out(1);
    const QRectF reach = frame.area.adjusted(-4000, -4000, 4000, 4000);
    const size_t count = std::min(curve.x.size(), curve.y.size());
    for (size_t i = 0; i < count; ++i) {
        const QPointF point(frame.xOf(curve.x[i]), frame.yOf(curve.y[i]));
        if (!std::isfinite(point.x()) || !std::isfinite(point.y())) {
            if (!out.back().isEmpty()) out.emplace_back();
            continue;
        }
        const QPointF near(std::clamp(point.x(), reach.left(), reach.right()),
                           std::clamp(point.y(), reach.top(), reach.bottom()));
        if (!out.back().isEmpty()) {
            const QPointF step = near - out.back().last();
            if (std::abs(step.x()) < 0.5 && std::abs(step.y()) < 0.5) continue;
        }
        out.back() << near;
    }
    return out;
}

void paintCurves(QPainter& painter, const Chart& chart, const FigureFrame& frame) {
    constexpr qsizetype kFine = 20'000; // more than that: without smoothing, which is many times slower
    painter.save();
    painter.setClipRect(frame.area);
    for (const Curve& curve : chart.curves) {
        const bool isDots = curve.style == waveform::CurveStyle::Dots;
        const std::vector<QPolygonF> strokes = strokesOf(curve, frame);
        qsizetype points = 0;
        for (const QPolygonF& stroke : strokes) points += stroke.size();
        painter.setRenderHint(QPainter::Antialiasing, points <= kFine);
        QPen pen(colourOf(curve), isDots ? 3 : points <= kFine ? 1.6 : 1);
        if (curve.style == waveform::CurveStyle::Dashed) pen.setStyle(Qt::DashLine);
        pen.setCapStyle(isDots ? Qt::RoundCap : Qt::FlatCap);
        painter.setPen(pen);
        for (const QPolygonF& stroke : strokes)
            isDots || stroke.size() == 1 ? painter.drawPoints(stroke) : painter.drawPolyline(stroke);
    }
    painter.restore();
}

void paintNotes(QPainter& painter, const Chart& chart, const FigureFrame& frame, const QFont& font) {
    const kit::ThemeColors& colors = kit::colors();
    const QFontMetricsF metrics(font);
    painter.setRenderHint(QPainter::Antialiasing);
    std::vector<QRectF> taken;
    for (const waveform::ChartNote& note : chart.notes) {
        const QPointF at(frame.xOf(note.x), frame.yOf(note.y));
        if (!frame.area.contains(at)) continue;
        painter.setPen(QPen(colors.plotGround, 1.5));
        painter.setBrush(colors.plotTrigger);
        painter.drawEllipse(at, 3.5, 3.5);
        QRectF box(at.x() + 7, at.y() - metrics.height() - 1, metrics.horizontalAdvance(kit::fromView(note.text)) + 6,
                   metrics.height());
        if (box.right() > frame.area.right()) box.moveRight(at.x() - 7);
        if (box.top() < frame.area.top()) box.moveTop(frame.area.top() + 1);
        if (std::any_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(box); }))
            continue;
        taken.push_back(box);
        QColor ground = colors.plotGround;
        ground.setAlphaF(0.85f);
        painter.fillRect(box, ground);
        painter.setPen(colors.text);
        painter.drawText(box, Qt::AlignCenter, kit::fromView(note.text));
    }
}

constexpr double kLegendSample = 30; // the line before a name, and the space between

void paintHead(QPainter& painter, const Chart& chart, const FigureFrame& frame, const QFont& font) {
    const QRectF& rect = frame.place;
    const kit::ThemeColors& colors = kit::colors();
    const QFontMetricsF metrics(font);
    const double base = frame.area.top() - 5 - metrics.descent();
    const std::vector<FigureName> names = legendOf(chart, frame, font);
    double right = frame.area.right();
    for (auto name = names.rbegin(); name != names.rend(); ++name) {
        const double width = metrics.horizontalAdvance(name->text);
        painter.setPen(colors.text);
        painter.drawText(QPointF(right - width, base), name->text);
        painter.setPen(QPen(colourOf(chart.curves[name->curve]), 2));
        const double middle = base - metrics.ascent() / 2 + 1;
        painter.drawLine(QPointF(right - width - 18, middle), QPointF(right - width - 5, middle));
        right -= width + kLegendSample;
    }
    QFont bold = font;
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(colors.text);
    QString title = kit::fromView(chart.title);
    if (!chart.yTitle.empty())
        title += title.isEmpty() ? kit::fromView(chart.yTitle) : QStringLiteral("  ·  ") + kit::fromView(chart.yTitle);
    const double room = std::max(right - rect.left() - kPad - 8, 40.0);
    painter.drawText(QPointF(rect.left() + kPad, base), QFontMetricsF(bold).elidedText(title, Qt::ElideRight, room));
    painter.setFont(font);
}

void paintRuler(QPainter& painter, const FigureRuler& ruler, const std::vector<FigureFrame>& frames,
                const QFont& font) {
    if (ruler.from.chart >= frames.size()) return;
    const FigureFrame& frame = frames[ruler.from.chart];
    paintRulerMark(painter, {frame.xOf(ruler.from.x), frame.yOf(ruler.from.y)},
                   {frame.xOf(ruler.to.x), frame.yOf(ruler.to.y)}, rulerText(ruler), frame.area, font);
}

} // namespace

bool Figure::isEmpty() const {
    for (const Chart& chart : charts)
        for (const Curve& curve : chart.curves)
            if (!curve.x.empty()) return false;
    return true;
}

std::vector<FigureName> legendOf(const Chart& chart, const FigureFrame& frame, const QFont& font) {
    constexpr size_t kMostNames = 12;
    constexpr double kLeastWidth = 36, kTitle = 0.35; // of a name; share of the width that the title keeps
    const QFontMetricsF metrics(font);
    std::vector<FigureName> out;
    for (size_t i = 0; i < chart.curves.size() && out.size() < kMostNames; ++i)
        if (!chart.curves[i].name.empty()) out.push_back({i, kit::fromView(chart.curves[i].name)});
    const double room = frame.area.right() - frame.place.left() - frame.place.width() * kTitle;
    const auto widthWith = [&](double most) {
        double width = 0;
        for (const FigureName& name : out)
            width += std::min(metrics.horizontalAdvance(name.text), most) + kLegendSample;
        return width;
    };
    while (!out.empty() && widthWith(kLeastWidth) > room) out.pop_back();
    // the long names give way, so that one of them does not hide the others
    double most = room;
    while (most > kLeastWidth && widthWith(most) > room) most = std::max(most - 4, kLeastWidth);
    for (FigureName& name : out) name.text = metrics.elidedText(name.text, Qt::ElideMiddle, most);
    return out;
}

double FigureFrame::xOf(double value) const { return area.left() + shareOf(value, x, isLogarithmicX) * area.width(); }
double FigureFrame::yOf(double value) const {
    return area.bottom() - shareOf(value, y, isLogarithmicY) * area.height();
}
double FigureFrame::xAt(double pixel) const { return valueOf((pixel - area.left()) / area.width(), x, isLogarithmicX); }
double FigureFrame::yAt(double pixel) const {
    return valueOf((area.bottom() - pixel) / area.height(), y, isLogarithmicY);
}

namespace {

/// How the charts share the place: one above the other, or side by side where that is low and wide. Where there is room
/// for neither, the last ones are not shown.
struct Sharing {
    size_t count = 1; // of those that are shown
    double each = 0;  // height of a chart
    bool isBeside = false;
};

/// Charts one above the other share the title of their axis.
bool hasTitle(const Figure& figure, size_t i, size_t count) {
    return i + 1 == count || figure.charts[i].xTitle != figure.charts[i + 1].xTitle;
}

Sharing sharingOf(const Figure& figure, const QRectF& rect, double head, double ticks, double title) {
    constexpr double kLeastHeight = 36, kLeastWidth = 120;
    for (size_t count = figure.charts.size(); count > 1; --count) {
        double titles = 0;
        for (size_t i = 0; i < count; ++i) titles += hasTitle(figure, i, count) ? title : 0;
        const double each = (rect.height() - titles) / static_cast<double>(count) - head - ticks;
        if (each >= kLeastHeight) return {count, each, false};
        const double beside = rect.height() - head - ticks - title;
        if (beside >= kLeastHeight && rect.width() / static_cast<double>(count) >= kLeastWidth)
            return {count, beside, true};
    }
    return {1, rect.height() - head - ticks - title, false};
}

} // namespace

std::vector<FigureFrame> framesOf(const Figure& figure, const QRectF& rect, const QFont& font, const FigureZoom& zoom) {
    std::vector<FigureFrame> out;
    const QFontMetricsF metrics(font);
    const double head = metrics.height() + 10, ticks = metrics.height() + 6, title = metrics.height() + 2;
    const auto [count, each, isBeside] = sharingOf(figure, rect, head, ticks, title);
    double top = rect.top();
    const double wide = isBeside ? rect.width() / static_cast<double>(count) : rect.width();
    std::vector<double> widest;
    for (size_t i = 0; i < figure.charts.size(); ++i) {
        const Chart& chart = figure.charts[i];
        FigureFrame frame;
        frame.x = rangeOf(chart, &Curve::x, chart.isLogarithmic);
        frame.isLogarithmicX = chart.isLogarithmic && frame.x.low > 0;
        frame.y = valuesOf(chart);
        frame.isLogarithmicY = chart.isLogarithmicY && frame.y.low > 0;
        if (zoom.x) frame.x = *zoom.x;
        if (i < zoom.y.size() && zoom.y[i]) frame.y = *zoom.y[i];
        frame.hasTitleX = isBeside || hasTitle(figure, i, count);
        frame.place = QRectF(rect.left() + (isBeside ? wide * static_cast<double>(i) : 0), top, wide, 0);
        frame.area = QRectF(frame.place.left(), top + head, wide, std::max(each, 1.0));
        if (i >= count) frame.place = frame.area = QRectF(rect.left(), rect.bottom(), 0, 0);
        if (!isBeside) top += head + each + ticks + (frame.hasTitleX ? title : 0);
        widest.push_back(0);
        for (const PlotTick& tick : ticksOf(frame.y, frame.isLogarithmicY, std::max(int(frame.area.height()) / 24, 3)))
            widest.back() = std::max(widest.back(), metrics.horizontalAdvance(tick.label));
        out.push_back(frame);
    }
    if (!isBeside && count > 0 && !widest.empty()) // their left edges in line
        widest.assign(widest.size(), *std::max_element(widest.begin(), widest.end()));
    for (size_t i = 0; i < std::min(count, out.size()); ++i) {
        FigureFrame& frame = out[i];
        frame.area.setLeft(std::round(frame.place.left() + widest[i] + 2 * kPad));
        frame.area.setRight(std::max(frame.place.right() - 2 * kPad, frame.area.left() + 1));
    }
    return out;
}

void paintFigure(QPainter& painter, const Figure& figure, const QRectF& rect, const QFont& font, const FigureZoom& zoom,
                 const std::optional<FigureRuler>& ruler) {
    painter.save();
    painter.fillRect(rect, kit::colors().plotGround);
    painter.setFont(font);
    const std::vector<FigureFrame> frames = framesOf(figure, rect, font, zoom);
    if (figure.isEmpty() && !figure.empty.isEmpty()) {
        painter.setPen(kit::colors().muted);
        painter.drawText(rect.adjusted(24, 8, -24, -8), Qt::AlignCenter | Qt::TextWordWrap, figure.empty);
    } else {
        for (size_t i = 0; i < frames.size(); ++i) {
            if (frames[i].area.width() < 20 || frames[i].area.height() < 12) continue;
            if (!figure.charts[i].curves.empty()) paintAxes(painter, figure.charts[i], frames[i], font);
            paintCurves(painter, figure.charts[i], frames[i]);
            paintNotes(painter, figure.charts[i], frames[i], font);
            paintHead(painter, figure.charts[i], frames[i], font);
        }
        if (ruler) paintRuler(painter, *ruler, frames, font);
    }
    painter.restore();
}

std::optional<FigurePoint> nearestPoint(const Figure& figure, const std::vector<FigureFrame>& frames,
                                        const QPointF& place, double reach) {
    std::optional<FigurePoint> out;
    double nearest = reach * reach;
    for (size_t c = 0; c < frames.size(); ++c) {
        if (!frames[c].area.contains(place)) continue;
        for (const Curve& curve : figure.charts[c].curves)
            for (size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
                const QPointF away = QPointF(frames[c].xOf(curve.x[i]), frames[c].yOf(curve.y[i])) - place;
                const double distance = QPointF::dotProduct(away, away);
                if (!(distance < nearest)) continue;
                nearest = distance;
                out = FigurePoint{c, curve.x[i], curve.y[i]};
            }
    }
    return out;
}

QString rulerText(const FigureRuler& ruler) {
    const double across = ruler.to.x - ruler.from.x, up = ruler.to.y - ruler.from.y;
    QString out = QStringLiteral("Δx %1   Δy %2").arg(valueText(across, 5), valueText(up, 5));
    if (across != 0) out += QStringLiteral("   Δy/Δx %1").arg(valueText(up / across, 5));
    return out;
}

QImage figurePicture(const Figure& figure, const PictureOptions& options, const FigureZoom& zoom) {
    return paintedImage(options, [&](QPainter& painter, const QRectF& rect) {
        paintFigure(painter, figure, rect, QApplication::font(), zoom);
    });
}

Result<void> exportFigure(const Figure& figure, const QString& path, const PictureOptions& options,
                          const FigureZoom& zoom) {
    const QString title = figure.charts.empty() ? QString() : kit::fromView(figure.charts.front().title);
    return exportPainted(title, path, options, [&](QPainter& painter, const QRectF& rect) {
        paintFigure(painter, figure, rect, QApplication::font(), zoom);
    });
}

Result<void> exportFigureCsv(const Figure& figure, const QString& path) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly)) return cannotWrite(path, file.errorString());
    file.write("chart,curve,x,y\n");
    for (const Chart& chart : figure.charts)
        for (const Curve& curve : chart.curves)
            for (size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
                const QByteArray line = csvQuoted(kit::fromView(chart.title)) + ',' +
                                        csvQuoted(kit::fromView(curve.name)) + ',' +
                                        QByteArray::fromStdString(exactText(curve.x[i], PlotValueKind::Double)) + ',' +
                                        QByteArray::fromStdString(exactText(curve.y[i], PlotValueKind::Double)) + '\n';
                file.write(line);
            }
    if (!file.commit()) return cannotWrite(path, file.errorString());
    return {};
}

} // namespace plc::plot
