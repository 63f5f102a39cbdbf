#include "editor/plot/painting/ruler_mark.h"

#include "editor/kit/theme.h"

#include <QFont>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace plc::plot {

QRectF tagRect(const QPointF& anchor, const QSizeF& size, const QRectF& area) {
    QRectF tag(QPointF(anchor.x() + 12, anchor.y() - size.height() - 14), size);
    if (tag.right() > area.right() - 2) tag.moveRight(std::max(anchor.x() - 12, area.left() + size.width()));
    if (tag.top() < area.top() + 2) tag.moveTop(anchor.y() + 14);
    if (tag.bottom() > area.bottom() - 2) tag.moveBottom(area.bottom() - 2);
    return tag;
}

void paintRulerMark(QPainter& painter, const QPointF& from, const QPointF& to, const QString& text, const QRectF& area,
                    const QFont& font) {
    const kit::ThemeColors& colors = kit::colors();
    painter.save();
    painter.setClipRect(area);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colors.plotCursor, 1, Qt::DotLine));
    painter.drawPolyline(QPolygonF({from, QPointF(to.x(), from.y()), to}));
    painter.setPen(QPen(colors.plotCursor, 1.6));
    painter.drawLine(from, to);
    painter.setBrush(colors.plotCursor);
    painter.drawEllipse(from, 3, 3);
    painter.drawEllipse(to, 3, 3);
    const QFontMetricsF metrics(font);
    QString shown = text;
    if (metrics.horizontalAdvance(text) + 18 > area.width()) // one figure below the other
        shown.replace(QStringLiteral("   "), QStringLiteral("\n"));
    const QSizeF size = metrics.size(0, shown);
    const QRectF tag = tagRect(to, {size.width() + 14, size.height() + 4}, area);
    painter.setPen(Qt::NoPen);
    painter.drawRoundedRect(tag, 3, 3);
    painter.setPen(colors.plotGround);
    painter.setFont(font);
    painter.drawText(tag, Qt::AlignCenter, shown);
    painter.restore();
}

} // namespace plc::plot
