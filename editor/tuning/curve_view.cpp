#include "editor/tuning/curve_view.h"

#include "editor/kit/theme.h"
#include "editor/plot/plot_scale.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace plc::editor {

namespace {
QString text(const std::string& s) { return QString::fromStdString(s); }

/// Least and greatest of the curves, with room where there is none.
std::pair<double, double> rangeOf(const signals::Chart& chart, std::vector<double> signals::Curve::*values) {
    double low = 1e300, high = -1e300;
    for (const signals::Curve& curve : chart.curves)
        for (const double value : curve.*values)
            if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
    if (low > high) return {0, 1};
    if (high - low < 1e-9 * std::max(1.0, std::abs(high))) return {low - 0.5, high + 0.5};
    return {low, high};
}
} // namespace

struct CurveView::Frame {
    QRectF area;
    double xLow = 0, xHigh = 1, yLow = 0, yHigh = 1;
    bool isLogarithmic = false;
    [[nodiscard]] double x(double value) const {
        const double at =
            isLogarithmic ? std::log(value / xLow) / std::log(xHigh / xLow) : (value - xLow) / (xHigh - xLow);
        return area.left() + at * area.width();
    }
    [[nodiscard]] double y(double value) const {
        return area.bottom() - (value - yLow) / (yHigh - yLow) * area.height();
    }
    [[nodiscard]] double valueAt(double pixel) const {
        const double at = (pixel - area.left()) / area.width();
        return isLogarithmic ? xLow * std::pow(xHigh / xLow, at) : xLow + at * (xHigh - xLow);
    }
};

CurveView::CurveView(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&kit::Theme::current(), &kit::Theme::changed, this, qOverload<>(&QWidget::update));
}

void CurveView::setChart(signals::Chart chart) {
    m_chart = std::move(chart);
    setAccessibleName(text(m_chart.title));
    update();
}

CurveView::Frame CurveView::frame() const {
    const QFontMetrics metrics(font());
    Frame out;
    std::tie(out.xLow, out.xHigh) = rangeOf(m_chart, &signals::Curve::x);
    std::tie(out.yLow, out.yHigh) = rangeOf(m_chart, &signals::Curve::y);
    const double margin = (out.yHigh - out.yLow) * 0.06;
    out.yLow -= margin;
    out.yHigh += margin;
    out.isLogarithmic = m_chart.isLogarithmic && out.xLow > 0;
    const int left = metrics.horizontalAdvance(QStringLiteral("-00000")) + 6;
    out.area = QRectF(left, metrics.height() + 8, width() - left - 8, height() - 3 * metrics.height() - 14);
    return out;
}

void CurveView::paintAxes(QPainter& painter, const Frame& frame) const {
    const kit::ThemeColors& colors = kit::Theme::current().colors();
    const QFontMetrics metrics(font());
    const auto label = [&](double x, double y, int flags, const QString& what) {
        painter.setPen(colors.plotAxis);
        painter.drawText(QRectF(x - 100, y - 100, 200, 200), flags, what);
    };
    const auto grid = [&](const QPointF& from, const QPointF& to) {
        painter.setPen(colors.plotGrid);
        painter.drawLine(from, to);
    };
    std::vector<plot::PlotTick> across;
    if (frame.isLogarithmic) {
        for (double at = std::pow(10, std::ceil(std::log10(frame.xLow))); at <= frame.xHigh; at *= 10)
            across.push_back({at, plot::valueText(at, 3)});
    } else {
        across = plot::numberTicks(frame.xLow, frame.xHigh, std::max(static_cast<int>(frame.area.width()) / 70, 2));
    }
    for (const plot::PlotTick& tick : across) {
        const double x = frame.x(tick.value);
        grid({x, frame.area.top()}, {x, frame.area.bottom()});
        label(x, frame.area.bottom() + 2 + 100, Qt::AlignHCenter | Qt::AlignTop, tick.label);
    }
    for (const plot::PlotTick& tick :
         plot::numberTicks(frame.yLow, frame.yHigh, std::max(static_cast<int>(frame.area.height()) / 32, 2))) {
        const double y = frame.y(tick.value);
        grid({frame.area.left(), y}, {frame.area.right(), y});
        label(frame.area.left() - 4 - 100, y, Qt::AlignRight | Qt::AlignVCenter, tick.label);
    }
    painter.setPen(colors.border);
    painter.drawRect(frame.area);
    label(frame.area.center().x(), frame.area.bottom() + metrics.height() + 2 + 100, Qt::AlignHCenter | Qt::AlignTop,
          text(m_chart.xTitle));
}

void CurveView::paintCurves(QPainter& painter, const Frame& frame) const {
    const kit::ThemeColors& colors = kit::Theme::current().colors();
    painter.setClipRect(frame.area);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const signals::Curve& curve : m_chart.curves) {
        const size_t count = std::min(curve.x.size(), curve.y.size());
        // no more points than the chart has columns for
        const size_t stride = std::max<size_t>(count / static_cast<size_t>(std::max(frame.area.width() * 2, 1.0)), 1);
        QPolygonF points;
        for (size_t i = 0; i < count; i += stride)
            if (std::isfinite(curve.y[i])) points << QPointF(frame.x(curve.x[i]), frame.y(curve.y[i]));
        QPen pen(colors.curve(curve.colour), curve.style == signals::CurveStyle::Dots ? 3 : 1.6);
        if (curve.style == signals::CurveStyle::Dashed) pen.setStyle(Qt::DashLine);
        if (curve.style == signals::CurveStyle::Dots) pen.setCapStyle(Qt::RoundCap);
        painter.setPen(pen);
        if (curve.style == signals::CurveStyle::Dots)
            painter.drawPoints(points);
        else
            painter.drawPolyline(points);
    }
    painter.setClipping(false);
}

void CurveView::paintLegend(QPainter& painter, const Frame& frame) const {
    const kit::ThemeColors& colors = kit::Theme::current().colors();
    const QFontMetrics metrics(font());
    double right = frame.area.right();
    for (auto curve = m_chart.curves.rbegin(); curve != m_chart.curves.rend(); ++curve) {
        if (curve->name.empty()) continue;
        const QString name = text(curve->name);
        const int width = metrics.horizontalAdvance(name);
        painter.setPen(colors.text);
        painter.drawText(QPointF(right - width, metrics.ascent() + 3), name);
        painter.setPen(QPen(colors.curve(curve->colour), 2));
        painter.drawLine(QPointF(right - width - 18, metrics.height() / 2.0 + 3),
                         QPointF(right - width - 5, metrics.height() / 2.0 + 3));
        right -= width + 30;
    }
    painter.setPen(colors.text);
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    painter.drawText(QRectF(4, 3, std::max(right - 8, 40.0), metrics.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetrics(bold).elidedText(text(m_chart.title), Qt::ElideRight,
                                                   static_cast<int>(std::max(right - 8, 40.0))));
}

void CurveView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), kit::Theme::current().colors().plotGround);
    const Frame shown = frame();
    if (shown.area.width() < 20 || shown.area.height() < 20) return;
    if (!m_chart.curves.empty()) {
        paintAxes(painter, shown);
        paintCurves(painter, shown);
    }
    paintLegend(painter, shown);
}

void CurveView::mouseMoveEvent(QMouseEvent* event) {
    const Frame shown = frame();
    if (m_chart.curves.empty() || !shown.area.contains(event->position())) return QToolTip::hideText();
    const double at = shown.valueAt(event->position().x());
    QStringList lines{QString("%1: %2").arg(text(m_chart.xTitle), plot::valueText(at, 5))};
    for (const signals::Curve& curve : m_chart.curves) {
        if (curve.name.empty() || curve.x.empty()) continue;
        auto next = std::lower_bound(curve.x.begin(), curve.x.end(), at);
        if (next == curve.x.end()) --next;
        const auto index = static_cast<size_t>(next - curve.x.begin());
        if (index < curve.y.size())
            lines << QString("%1: %2").arg(text(curve.name), plot::valueText(curve.y[index], 5));
    }
    QToolTip::showText(event->globalPosition().toPoint(), lines.join('\n'), this);
}

} // namespace plc::editor
