#include "hmi/view/displays/charts.h"

#include "editor/kit/curve_words.h"
#include "editor/kit/pen_order.h"
#include "editor/plot/model/plot_scale.h"
#include "editor/plot/painting/plot_line.h"
#include "hmi/view/scene/panel_scene.h"

#include <cmath>
#include <limits>

namespace plc::hmi {

namespace {

/// As many digits as the steps need.
QString stepFormat(const std::vector<plot::PlotTick>& steps) {
    if (steps.size() < 2) return QStringLiteral("%.1f");
    const double step = steps[1].value - steps[0].value;
    const int digits = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 6);
    return QStringLiteral("%.%1f").arg(digits);
}

int64_t nanoseconds(double seconds) { return static_cast<int64_t>(std::llround(seconds * 1e9)); }

/// The pieces in the order in which a pen passes their values; one without a value ends the line.
plot::CurveShape shapeOf(const std::vector<CurvePiece>& pieces, double seconds, bool holds) {
    plot::CurveShape shape;
    shape.from = nanoseconds(-seconds);
    shape.to = 0;
    for (const CurvePiece& piece : pieces) {
        if (!piece.hasValue()) {
            shape.samples.push_back({piece.from, std::numeric_limits<double>::quiet_NaN()});
            continue;
        }
        for (const double value : kit::PenOrder(piece.first, piece.minimum, piece.maximum, piece.last))
            shape.samples.push_back({piece.from, value});
    }
    if (holds && !pieces.empty() && pieces.back().hasValue())
        shape.samples.push_back({pieces.back().to, pieces.back().last});
    return shape;
}

} // namespace

void ChartView::drawGround(QPainter& painter, const QRectF& plot) const {
    painter.setPen(QPen(theme().color("faint"), 1));
    painter.setBrush(theme().color("surface"));
    painter.drawRoundedRect(box().adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    painter.fillRect(plot, theme().color("inset"));
}

void ChartView::drawVerticalAxis(QPainter& painter, const QRectF& plot, const Axis& axis, const QString& format) const {
    const double size = fontSize();
    const std::vector<plot::PlotTick> steps =
        plot::numberTicks(axis.from, axis.to, std::max(1, static_cast<int>(plot.height() / (size * 2.8))));
    const QString pattern = format.isEmpty() ? stepFormat(steps) : format;
    const auto labelOf = [&](double step, double height) {
        TextBox number = textBox(formatValue(Value::ofReal(step), pattern, locale()),
                                 QRectF(0, -size, plot.left() - 5, 2 * size), height, TextAlign::End, "");
        number.rightToLeft = false;
        return number;
    };
    // A value that hardly moves has long numbers: smaller ones, where they would be cut.
    double widest = 0;
    for (const auto& [step, inStudio] : steps) {
        const TextBox number = labelOf(step, size);
        widest = std::max(widest, neededSize(number).width());
    }
    const double room = plot.left() - 7, height = widest > room ? size * room / widest : size;
    for (const auto& [step, inStudio] : steps) {
        const double y = plot.bottom() - axis.share(step) * plot.height();
        painter.setPen(QPen(theme().color("faint"), 1, Qt::SolidLine));
        painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
        painter.setPen(theme().color("muted"));
        TextBox number = labelOf(step, height);
        number.rect.translate(0, y);
        drawText(painter, number);
    }
}

void ChartView::drawHorizontalAxis(QPainter& painter, const QRectF& plot, const Axis& axis, const QString& format,
                                   const QString& unitOfLast) const {
    const double size = fontSize();
    const std::vector<plot::PlotTick> steps =
        plot::numberTicks(axis.from, axis.to, std::max(1, static_cast<int>(plot.width() / (size * 5))));
    const QString pattern = format.isEmpty() ? stepFormat(steps) : format;
    for (const auto& [step, inStudio] : steps) {
        const double x = plot.left() + axis.share(step) * plot.width();
        painter.setPen(QPen(theme().color("faint"), 1));
        painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
        painter.setPen(theme().color("muted"));
        QString words = formatValue(Value::ofReal(step), pattern, locale());
        if (step == steps.back().value && !unitOfLast.isEmpty())
            words = leftToRight(words + QChar(0x00A0) + unitOfLast);
        drawText(painter,
                 textBox(words, QRectF(x - 50, plot.bottom() + 2, 100, size * 1.5), size, TextAlign::Center, ""));
    }
}

TextBox ChartView::titleBox(std::string_view property, const QRectF& area, TextAlign align,
                            const QString& forTag) const {
    TextBox out = textBox(shown(element().text(property), forTag), area, fontSize(), align,
                          std::string(property).c_str(), false, forTag);
    return out;
}

// ---- bar chart

void BarChartView::setUp() {
    m_value = bindProperty("value");
    m_limits = Limits::of(element());
}

bool BarChartView::update() {
    std::vector<double> bars;
    for (const Value& item : value(m_value).items()) bars.push_back(item.toNumber());
    if (bars.empty() && isDesigning()) {
        const double low = num("min"), high = num("max");
        for (const double share : {0.42, 0.68, 0.55, 0.83, 0.61}) bars.push_back(low + (high - low) * share);
    }
    if (bars.size() > 512) bars.resize(512);
    const bool changed = bars != m_bars;
    m_bars = std::move(bars);
    return changed;
}

QRectF BarChartView::plot() const {
    const double size = fontSize(), top = text("title").isEmpty() ? 8 : size * 2;
    return QRectF(size * 3.6, top, width() - size * 3.6 - 8, height() - top - size * 2);
}

QString BarChartView::barText(size_t index, const QString& forTag) const {
    const int number = element().integer("first") + static_cast<int>(index);
    const QString words = scene().texts().listText(text("list"), static_cast<qint64>(index), forTag);
    return words.isEmpty() ? QString::number(number) : words;
}

TextBox BarChartView::label(size_t index, size_t count, const QString& forTag) const {
    const QRectF area = plot();
    const double pitch = area.width() / static_cast<double>(std::max<size_t>(1, count));
    return textBox(barText(index, forTag),
                   QRectF(area.left() + pitch * static_cast<double>(index), area.bottom() + 2, pitch, fontSize() * 1.5),
                   fontSize(), TextAlign::Center, "list", false, forTag);
}

void BarChartView::draw(QPainter& painter) {
    const QRectF area = plot();
    const UnitView view = unit();
    const Axis axis{view.shown(num("min")), view.shown(num("max"))};
    drawGround(painter, area);
    drawVerticalAxis(painter, area, axis, {});
    painter.setPen(theme().color("text"));
    const QString title = shown(text("title"));
    drawText(painter, titleBox("title", QRectF(8, 2, width() - 16, fontSize() * 1.7), TextAlign::Start, tag()));
    if (!view.unit.isEmpty() && !kit::namesUnit(title, view.unit)) {
        painter.setPen(theme().color("muted"));
        drawText(painter, textBox(leftToRight(view.unit), QRectF(8, 2, width() - 16, fontSize() * 1.7), fontSize(),
                                  title.isEmpty() ? TextAlign::Start : TextAlign::End, ""));
    }
    const double pitch = area.width() / static_cast<double>(std::max<size_t>(1, m_bars.size())),
                 thick = std::max(1.0, std::min(pitch * 0.66, 60.0));
    const double zero =
        area.bottom() -
        std::clamp(axis.share(std::clamp(0.0, std::min(axis.from, axis.to), std::max(axis.from, axis.to))), 0.0, 1.0) *
            area.height();
    const bool writes = pitch > fontSize() * 0.9;
    for (size_t i = 0; i < m_bars.size(); ++i) {
        const double x = area.left() + pitch * (static_cast<double>(i) + 0.5);
        const double y = area.bottom() - std::clamp(axis.share(view.shown(m_bars[i])), 0.0, 1.0) * area.height();
        const int priority = m_limits.priorityAt(m_bars[i]);
        painter.fillRect(QRectF(QPointF(x - thick / 2, y), QPointF(x + thick / 2, zero)).normalized(),
                         priority ? theme().priority(priority) : stateColor(color("color")));
        painter.setPen(theme().color("muted"));
        if (writes || i % 5 == 0) drawText(painter, label(i, m_bars.size(), tag()));
    }
    painter.setPen(QPen(theme().color("line"), 1));
    painter.drawLine(QPointF(area.left(), zero), QPointF(area.right(), zero));
    painter.drawLine(area.topLeft(), area.bottomLeft());
}

void BarChartView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (!text("title").isEmpty())
        out.push_back(titleBox("title", QRectF(8, 2, width() - 16, fontSize() * 1.7), TextAlign::Start, forTag));
    const int length = text("list").isEmpty() ? 0 : scene().texts().table().listLength(text("list"));
    for (int i = 0; i < length; ++i)
        out.push_back(
            label(static_cast<size_t>(i), std::max<size_t>(m_bars.size(), static_cast<size_t>(length)), forTag));
}

// ---- xy chart

void XyChartView::setUp() {
    m_x = bindProperty("x");
    m_y = bindProperty("y");
    m_pointX = bindProperty("pointX");
    m_pointY = bindProperty("pointY");
}

bool XyChartView::update() {
    std::vector<QPointF> curve;
    const std::vector<Value>&xs = value(m_x).items(), &ys = value(m_y).items();
    for (size_t i = 0; i < std::min(xs.size(), ys.size()); ++i) curve.emplace_back(xs[i].toNumber(), ys[i].toNumber());
    // Without x the places of the array are spread over the axis.
    if (xs.empty() && ys.size() > 1)
        for (size_t i = 0; i < ys.size(); ++i)
            curve.emplace_back(num("minX") + (num("maxX") - num("minX")) * static_cast<double>(i) /
                                                 static_cast<double>(ys.size() - 1),
                               ys[i].toNumber());
    const std::optional<double> px = number(m_pointX, num("minX") + (num("maxX") - num("minX")) * 0.55),
                                py = number(m_pointY, num("minY") + (num("maxY") - num("minY")) * 0.42);
    if (curve.empty() && isDesigning())
        for (int i = 0; i <= 20; ++i) {
            const double share = i / 20.0;
            curve.emplace_back(num("minX") + (num("maxX") - num("minX")) * share,
                               num("minY") +
                                   (num("maxY") - num("minY")) * (0.08 + 0.85 * share * share * (1.6 - 0.6 * share)));
        }
    const std::optional<QPointF> point = px && py ? std::optional(QPointF(*px, *py)) : std::nullopt;
    const bool changed = curve != m_curve || point != m_point;
    m_curve = std::move(curve);
    m_point = point;
    return changed;
}

QRectF XyChartView::plot() const {
    const double size = fontSize(), top = text("titleY").isEmpty() ? 8 : size * 2,
                 bottom = size * 1.9 + (text("titleX").isEmpty() ? 0 : size * 1.4);
    return QRectF(size * 3.8, top, width() - size * 3.8 - 12, height() - top - bottom);
}

TextBox XyChartView::xTitle(const QString& forTag) const {
    return titleBox("titleX", QRectF(plot().left(), height() - fontSize() * 1.7, plot().width(), fontSize() * 1.5),
                    TextAlign::End, forTag);
}

TextBox XyChartView::yTitle(const QString& forTag) const {
    return titleBox("titleY", QRectF(8, 2, width() - 16, fontSize() * 1.7), TextAlign::Start, forTag);
}

void XyChartView::draw(QPainter& painter) {
    const QRectF area = plot();
    const Axis x{num("minX"), num("maxX")}, y{num("minY"), num("maxY")};
    drawGround(painter, area);
    drawVerticalAxis(painter, area, y, {});
    drawHorizontalAxis(painter, area, x, {});
    painter.setPen(theme().color("text"));
    drawText(painter, xTitle(tag()));
    drawText(painter, yTitle(tag()));
    painter.setPen(QPen(theme().color("line"), 1));
    painter.drawLine(area.topLeft(), area.bottomLeft());
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    const auto at = [&](QPointF point) {
        return QPointF(area.left() + x.share(point.x()) * area.width(),
                       area.bottom() - y.share(point.y()) * area.height());
    };
    painter.save();
    painter.setClipRect(area, Qt::IntersectClip);
    QPolygonF line;
    for (const QPointF& point : m_curve) line << at(point);
    painter.setPen(QPen(stateColor(color("color")), 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(line);
    painter.restore();
    if (!m_point) return;
    const QPointF place = at(*m_point);
    if (!area.adjusted(-6, -6, 6, 6).contains(place)) return;
    painter.setPen(QPen(theme().color("text"), 1, Qt::DashLine));
    painter.drawLine(QPointF(place.x(), area.bottom()), place);
    painter.drawLine(QPointF(area.left(), place.y()), place);
    painter.setPen(QPen(theme().color("inset"), 2));
    painter.setBrush(theme().color("text"));
    painter.drawEllipse(place, 6, 6);
}

void XyChartView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (!text("titleX").isEmpty()) out.push_back(xTitle(forTag));
    if (!text("titleY").isEmpty()) out.push_back(yTitle(forTag));
}

// ---- trend

/// The colour of the lamp that shows the same, else one that the name says, else the next of the theme: a curve must
/// not contradict what stands beside it.
QColor TrendChartView::standardColor(const Properties& series, int index) const {
    const QString expression = series.text("value").trimmed();
    for (const Element& other : scene().panel().elements())
        if (other.kind() == ElementKind::Lamp && !expression.isEmpty() &&
            other.text("value").trimmed().compare(expression, Qt::CaseInsensitive) == 0)
            if (const QColor lamp = theme().color(other.text("onColor")); lamp.isValid()) return lamp;
    const QString title = scene().texts().text(series.text("title"), scene().language());
    for (const QString& name : {title, expression})
        if (const QColor named = theme().color(kit::colorNamed(name)); named.isValid()) return named;
    return theme().series(index);
}

void TrendChartView::setUp() {
    m_series.clear();
    const Json& rows = element().at("series");
    if (rows.is_array())
        for (const Json& row : rows) {
            if (!row.is_object()) continue;
            const Properties series(descriptorOf(ElementKind::Unknown), row);
            const int index = static_cast<int>(m_series.size());
            m_series.push_back({bindExpression(series.text("value")),
                                series.text("title"),
                                colorOr(series.text("color"), standardColor(series, index)),
                                !series.has("hold") || series.isSet("hold"),
                                {}});
        }
    m_nextRead = 0;
}

void TrendChartView::read() {
    const double seconds = std::max(0.001, num("seconds"));
    const int buckets = std::max(16, static_cast<int>(plot().width()));
    for (Series& series : m_series)
        if (scene().values() && series.value.isBound())
            series.pieces = scene().values()->curve(binding(series.value), seconds, buckets);
    if (!isDesigning()) return;
    if (m_series.empty()) m_series.push_back({{}, {}, theme().series(0), false, {}});
    int index = 0;
    for (Series& series : m_series) {
        if (!series.pieces.empty()) continue;
        for (int i = 0; i < 120; ++i) {
            const double at = -seconds + seconds * i / 120.0,
                         level = 50 + 30 * std::sin(i * 0.09 + index) * std::exp(-i * 0.012);
            series.pieces.push_back(
                {{level, level, level, level, 1, true}, nanoseconds(at), nanoseconds(at + seconds / 120)});
        }
        ++index;
    }
}

bool TrendChartView::update() {
    read();
    return true;
}

bool TrendChartView::advance(qint64 milliseconds) {
    // Ten times a second is enough for a trend, and only when something was recorded.
    if (milliseconds < m_nextRead) return false;
    m_nextRead = milliseconds + 100;
    const quint64 revision = scene().values() ? scene().values()->revision() : 0;
    if (revision == m_revision) return false;
    m_revision = revision;
    read();
    return true;
}

QRectF TrendChartView::plot() const {
    const double size = fontSize(), top = text("title").isEmpty() && text("unit").isEmpty() ? 8 : size * 2;
    const double bottom = size * 1.9 + (flag("legend") ? size * 1.7 : 0);
    return QRectF(size * 3.8, top, width() - size * 3.8 - 18, height() - top - bottom);
}

TextBox TrendChartView::legend(size_t index, const QString& forTag) const {
    const double pitch = plot().width() / static_cast<double>(std::max<size_t>(1, m_series.size()));
    const QRectF area(plot().left() + pitch * static_cast<double>(index) + 22, height() - fontSize() * 1.8, pitch - 28,
                      fontSize() * 1.6);
    const Series& series = m_series[index];
    TextBox out =
        textBox(series.title.isEmpty() ? expression(series.value) : shown(series.title, forTag), area, fontSize(),
                TextAlign::Start, ("series[" + QByteArray::number(static_cast<int>(index)) + "].title").constData(),
                false, forTag);
    out.rightToLeft = false;
    return out;
}

/// Nothing where the title or every name in the legend has the unit already.
QString TrendChartView::shownUnit() const {
    const QString own = text("unit");
    if (own.isEmpty() || kit::namesUnit(shown(text("title")), own)) return {};
    const bool allNameIt = flag("legend") && !m_series.empty() &&
                           std::all_of(m_series.begin(), m_series.end(),
                                       [&](const Series& one) { return kit::namesUnit(shown(one.title), own); });
    return allNameIt ? QString() : own;
}

void TrendChartView::draw(QPainter& painter) {
    const QRectF area = plot();
    Axis y{num("min"), num("max")};
    if (!element().optionalNumber("min") || !element().optionalNumber("max")) {
        double low = 1e300, high = -1e300;
        for (const Series& series : m_series)
            for (const CurvePiece& piece : series.pieces)
                if (piece.hasValue()) low = std::min(low, piece.minimum), high = std::max(high, piece.maximum);
        if (low > high) low = 0, high = 1;
        const double margin = std::max((high - low) * 0.08, std::max(std::abs(high), 1e-6) * 1e-6);
        if (high - low < 1e-12) low -= 0.5, high += 0.5;
        if (!element().optionalNumber("min")) y.from = low - margin;
        if (!element().optionalNumber("max")) y.to = high + margin;
    }
    if (y.to == y.from) y.to = y.from + 1;
    const double seconds = std::max(0.001, num("seconds"));
    const double factor = seconds > 7200 ? 1 / 3600.0 : seconds > 180 ? 1 / 60.0 : 1;
    const Axis shownX{-seconds * factor, 0};
    drawGround(painter, area);
    drawVerticalAxis(painter, area, y, {});
    drawHorizontalAxis(painter, area, shownX, {},
                       factor == 1      ? QStringLiteral("s")
                       : factor < 0.001 ? QStringLiteral("h")
                                        : QStringLiteral("min"));
    painter.setPen(theme().color("text"));
    drawText(painter, titleBox("title", QRectF(8, 2, width() - 16, fontSize() * 1.7), TextAlign::Start, tag()));
    painter.setPen(theme().color("muted"));
    const QString unitText = shownUnit();
    if (!unitText.isEmpty())
        drawText(painter, textBox(leftToRight(unitText), QRectF(8, 2, width() - 16, fontSize() * 1.7), fontSize(),
                                  text("title").isEmpty() ? TextAlign::Start : TextAlign::End, ""));
    plot::PlotCurve look;
    look.width = 1.8;
    for (const Series& series : m_series) {
        const plot::CurveShape shape = shapeOf(series.pieces, seconds, series.holds);
        look.style = series.holds ? plot::CurveStyle::Hold : plot::CurveStyle::Line;
        plot::drawLine(painter, shape, look, {area, shape.from, shape.to, {y.from, y.to}}, series.color);
    }
    painter.setPen(QPen(theme().color("line"), 1));
    painter.drawLine(area.topLeft(), area.bottomLeft());
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    if (!flag("legend")) return;
    for (size_t i = 0; i < m_series.size(); ++i) {
        const TextBox words = legend(i, tag());
        if (words.text.isEmpty()) continue;
        painter.setPen(QPen(m_series[i].color, 3));
        painter.drawLine(QPointF(words.rect.left() - 20, words.rect.center().y()),
                         QPointF(words.rect.left() - 5, words.rect.center().y()));
        painter.setPen(theme().color("text"));
        drawText(painter, words);
    }
}

void TrendChartView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (!text("title").isEmpty())
        out.push_back(titleBox("title", QRectF(8, 2, width() - 16, fontSize() * 1.7), TextAlign::Start, forTag));
    for (size_t i = 0; flag("legend") && i < m_series.size(); ++i)
        if (!m_series[i].title.isEmpty()) out.push_back(legend(i, forTag));
}

} // namespace plc::hmi
