#include "editor/plot/painting/plot_table.h"

#include "editor/kit/curve_words.h"
#include "editor/kit/theme.h"
#include "editor/plot/model/plot_scale.h"
#include "editor/plot/painting/plot_text.h"

#include <QFontMetricsF>
#include <QPainter>

#include <cmath>

namespace plc::plot {

namespace {

const QString Dash = QStringLiteral("–");

QString minusOf(const std::string& number) {
    QString text = QString::fromStdString(number);
    if (text.startsWith(QLatin1Char('-'))) text.replace(0, 1, QStringLiteral("−"));
    return text;
}

/// Integers in full, others to six digits.
QString numberText(const PlotCurve& curve, double shown) {
    const bool isPlainInteger =
        curve.source && curve.source->valueKind() == PlotValueKind::Integer && curve.decimals() == 0;
    return isPlainInteger ? minusOf(exactText(shown, PlotValueKind::Integer)) : valueText(shown, 6);
}

QStringList cellsOf(const PlotModel& model, const PlotCurve& curve) {
    QStringList cells{kit::withUnit(curve.name, curve.unit)};
    const auto at = [&](std::optional<int64_t> time) {
        return time && curve.source ? curve.source->inForceAt(*time) : std::nullopt;
    };
    const auto a = at(model.cursorA), b = at(model.cursorB);
    cells += a ? curveTextAt(curve, *model.cursorA, 6, false) : Dash;
    cells += b ? curveTextAt(curve, *model.cursorB, 6, false) : Dash;
    const bool isNumber = curve.valueNames.empty() && curve.source && curve.source->valueKind() != PlotValueKind::Bool;
    // Whole numbers keep every digit: also where a double does not hold them.
    const auto decimals = isNumber ? curve.decimals() : std::nullopt;
    const int behind = decimals.value_or(0);
    const auto wholeA = a && decimals ? curve.source->integerAt(*model.cursorA) : std::nullopt,
               wholeB = b && decimals ? curve.source->integerAt(*model.cursorB) : std::nullopt;
    if (wholeA && wholeB)
        cells += minusOf(exactDifference(*wholeA, *wholeB, behind));
    else
        cells += a && b && isNumber ? numberText(curve, curve.shown(b->value) - curve.shown(a->value)) : Dash;
    if (!model.cursorA || !model.cursorB || !curve.source || !isNumber) {
        while (cells.size() < 11) cells += Dash;
        return cells;
    }
    MeasureOptions options;
    options.isHeld = curve.style != CurveStyle::Line;
    const Measurement m = measure(*curve.source, *model.cursorA, *model.cursorB, options);
    auto shown = [&](double raw) { return m.count > 0 ? valueText(curve.shown(raw), 6) : Dash; };
    const bool flipped = curve.scale < 0;
    const auto whole = decimals ? curve.source->integerExtent(std::min(*model.cursorA, *model.cursorB),
                                                              std::max(*model.cursorA, *model.cursorB))
                                : std::nullopt;
    if (whole && m.count > 0) {
        cells += curve.integerText ? curve.integerText(static_cast<int64_t>(whole->first.bits))
                                   : minusOf(exactText(whole->first, behind));
        cells += curve.integerText ? curve.integerText(static_cast<int64_t>(whole->second.bits))
                                   : minusOf(exactText(whole->second, behind));
    } else {
        cells += m.count > 0 ? numberText(curve, curve.shown(flipped ? m.maximum : m.minimum)) : Dash;
        cells += m.count > 0 ? numberText(curve, curve.shown(flipped ? m.minimum : m.maximum)) : Dash;
    }
    cells += shown(m.mean);
    // RMS of scaled values: from the mean of squares, with the offset worked in.
    cells += m.count == 0 ? Dash
                          : valueText(std::sqrt(std::max(0.0, curve.scale * curve.scale * m.rms * m.rms +
                                                                  2 * curve.scale * curve.offset * m.mean +
                                                                  curve.offset * curve.offset)),
                                      6);
    cells += m.riseTime ? durationText(*m.riseTime) : Dash;
    cells += m.overshoot ? valueText(*m.overshoot, 3) + QStringLiteral(" %") : Dash;
    cells += m.settlingTime ? durationText(*m.settlingTime) : Dash;
    return cells;
}

} // namespace

MeasureTable measureTable(const PlotModel& model, bool everyColumn) {
    MeasureTable table;
    QStringList head;
    if (model.cursorA) head += QStringLiteral("A = %1").arg(momentText(*model.cursorA - model.origin));
    if (model.cursorB) head += QStringLiteral("B = %1").arg(momentText(*model.cursorB - model.origin));
    if (model.cursorA && model.cursorB) {
        const int64_t width = *model.cursorB - *model.cursorA;
        head += QStringLiteral("Δt = %1").arg(durationText(width));
        head += QStringLiteral("1/Δt = %1").arg(frequencyText(width));
    }
    table.headline = head.join(QStringLiteral("     "));
    table.headers = {PlotText::tr("Channel"),   PlotText::tr("At A"),    PlotText::tr("At B"),
                     QStringLiteral("Δy"),      PlotText::tr("Min"),     PlotText::tr("Max"),
                     PlotText::tr("Mean"),      PlotText::tr("RMS"),     PlotText::tr("Rise time"),
                     PlotText::tr("Overshoot"), PlotText::tr("Settling")};
    for (size_t i = 0; i < model.curves.size(); ++i) {
        const PlotCurve& curve = model.curves[i];
        if (curve.isVisible) table.rows.push_back({static_cast<int>(i), curve.color, cellsOf(model, curve)});
    }
    if (everyColumn) return table;
    for (qsizetype column = table.headers.size() - 1; column > 0; --column) {
        bool used = false;
        for (const MeasureTable::Row& row : table.rows) used = used || row.cells[column] != Dash;
        if (used) continue;
        table.headers.removeAt(column);
        for (MeasureTable::Row& row : table.rows) row.cells.removeAt(column);
    }
    return table;
}

double measureTableHeight(const PlotModel& model, const QFont& font) {
    const double row = QFontMetricsF(font).height() + 5;
    size_t rows = 0;
    for (const PlotCurve& curve : model.curves) rows += curve.isVisible;
    return row * static_cast<double>(rows + 2) + 6;
}

void paintMeasureTable(QPainter& painter, const QRectF& rect, const PlotModel& model, const QFont& font) {
    const kit::ThemeColors& c = kit::colors();
    const MeasureTable table = measureTable(model);
    const double row = QFontMetricsF(font).height() + 5;
    QFont bold = font;
    bold.setWeight(QFont::DemiBold);
    // Narrow paper: the letters shrink before anything is cut.
    QFont cellFont = font;
    auto widths = [&](const QFont& f) {
        const QFontMetricsF metrics(f);
        QFont strong = f;
        strong.setWeight(QFont::DemiBold);
        const QFontMetricsF strongMetrics(strong);
        std::vector<double> result;
        for (qsizetype column = 0; column < table.headers.size(); ++column) {
            double wide = strongMetrics.horizontalAdvance(table.headers[column]);
            for (const MeasureTable::Row& r : table.rows)
                wide = std::max(wide, metrics.horizontalAdvance(r.cells[column]) + (column == 0 ? 16 : 0));
            result.push_back(wide + 16);
        }
        return result;
    };
    auto sum = [](const std::vector<double>& v) {
        double total = 0;
        for (double w : v) total += w;
        return total;
    };
    std::vector<double> wide = widths(cellFont);
    while (sum(wide) > rect.width() && cellFont.pointSizeF() > 6) {
        cellFont.setPointSizeF(cellFont.pointSizeF() - 0.5);
        wide = widths(cellFont);
    }
    if (sum(wide) > rect.width()) wide[0] = std::max(60.0, wide[0] - (sum(wide) - rect.width()));
    const double spare = std::max(0.0, rect.width() - sum(wide));
    for (double& w : wide) w += std::min(spare / static_cast<double>(wide.size()), 24.0);

    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setFont(bold);
    painter.setPen(c.text);
    painter.drawText(QRectF(rect.left(), rect.top(), rect.width(), row), Qt::AlignVCenter | Qt::AlignLeft,
                     table.headline);
    QFont strong = cellFont;
    strong.setWeight(QFont::DemiBold);
    double y = rect.top() + row + 4;
    painter.setPen(QPen(c.divider, 1));
    painter.drawLine(QPointF(rect.left(), y + row), QPointF(rect.left() + sum(wide), y + row));
    auto line = [&](const QStringList& cells, double at, bool isHeader) {
        double x = rect.left();
        for (qsizetype column = 0; column < cells.size(); ++column) {
            const double w = wide[static_cast<size_t>(column)];
            const QRectF cell(x + (column == 0 ? (isHeader ? 0 : 16) : 4), at, w - (column == 0 ? 18 : 8), row);
            const QString text = QFontMetricsF(isHeader ? strong : cellFont)
                                     .elidedText(cells[column], Qt::ElideMiddle, cell.width() + 1);
            painter.drawText(cell, Qt::AlignVCenter | (column == 0 ? Qt::AlignLeft : Qt::AlignRight), text);
            x += w;
        }
    };
    painter.setFont(strong);
    painter.setPen(c.muted);
    line(table.headers, y, true);
    painter.setFont(cellFont);
    for (const MeasureTable::Row& r : table.rows) {
        y += row;
        painter.fillRect(QRectF(rect.left() + 1, y + row / 2 - 4, 9, 9), r.color);
        painter.setPen(c.text);
        line(r.cells, y, false);
    }
}

} // namespace plc::plot
