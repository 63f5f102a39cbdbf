// What the canvas of the panel designer draws: the panel, grid, selection, guides, findings, the drop, rulers.
#include "hmi/designer/canvas/design_canvas.h"

#include "hmi/model/property_literals.h"

#include "editor/kit/theme.h"

#include <cmath>

namespace plc::hmi {

void DesignCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(viewport());
    const kit::ThemeColors& colors = kit::colors();
    painter.fillRect(viewport()->rect(), colors.window.darker(colors.dark ? 115 : 104));
    m_scene.refresh(0);
    const QRectF area = toViewport(QRectF(QPointF(), m_scene.size()));
    painter.save();
    painter.setClipRect(QRectF(kRuler, kRuler, viewport()->width() - kRuler, viewport()->height() - kRuler));
    painter.fillRect(area.adjusted(3, 3, 4, 4), QColor(0, 0, 0, 60));
    painter.save();
    painter.translate(area.topLeft());
    painter.scale(m_zoom, m_zoom);
    m_scene.paint(painter, QRectF(QPointF(), m_scene.size()));
    painter.restore();
    painter.setRenderHint(QPainter::Antialiasing, false);
    drawFindings(painter);
    drawSelection(painter);
    drawGuides(painter);
    drawDrop(painter);
    if (m_drag.mode == Mode::Band) {
        QColor fill = colors.accent;
        fill.setAlphaF(0.12f);
        painter.setPen(QPen(colors.accent, 1));
        painter.setBrush(fill);
        painter.drawRect(toViewport(m_band));
    }
    painter.restore();
    drawRulers(painter);
}

void DesignCanvas::drawGrid(QPainter& painter) {
    const double step = std::max(1.0, m_document.panel().number("grid"_number)) * m_zoom;
    if (!m_gridShown || step < 5) return;
    QColor dot = PanelTheme::inkOn(m_scene.theme().color("background"));
    dot.setAlphaF(0.16f);
    painter.setPen(dot);
    const QRectF area = toViewport(QRectF(QPointF(), m_scene.size())) & QRectF(viewport()->rect());
    const QPointF first = origin();
    QList<QPointF> dots;
    for (double y = first.y() + std::ceil((area.top() - first.y()) / step) * step; y < area.bottom(); y += step)
        for (double x = first.x() + std::ceil((area.left() - first.x()) / step) * step; x < area.right(); x += step)
            dots += QPointF(std::floor(x), std::floor(y));
    painter.drawPoints(dots.constData(), static_cast<int>(dots.size()));
}

void DesignCanvas::drawSelection(QPainter& painter) {
    const kit::ThemeColors& colors = kit::colors();
    painter.setBrush(Qt::NoBrush);
    for (const ElementId& id : m_selection.ids()) {
        const Element* element = m_document.panel().find(id);
        if (!element) continue;
        painter.setPen(QPen(colors.accent, 1, element->isSet("locked"_flag) ? Qt::DotLine : Qt::SolidLine));
        painter.drawRect(toViewport(element->rect()).adjusted(-1, -1, 0, 0));
    }
    if (!m_entered.isEmpty())
        if (const Element* group = m_document.panel().find(m_entered)) {
            painter.setPen(QPen(colors.warning, 1, Qt::DashLine));
            painter.drawRect(toViewport(group->rect()).adjusted(-3, -3, 2, 2));
        }
    if (movable().empty() || m_drag.mode == Mode::Move) return;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colors.accent, 1.2));
    painter.setBrush(Qt::white);
    for (int i = 0; i < 8; ++i) {
        const QPointF at = handle(i);
        painter.drawRect(QRectF(at - QPointF(kHandle - 0.5, kHandle - 0.5), QSizeF(2 * kHandle - 1, 2 * kHandle - 1)));
    }
    if (hasPoints()) {
        painter.setBrush(colors.accent);
        for (int i = 0; i < m_document.panel().find(m_selection.ids().front())->points("points"_field).size(); ++i)
            painter.drawEllipse(pointPlace(i), kHandle, kHandle);
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void DesignCanvas::drawGuides(QPainter& painter) {
    for (const Guide& guide : m_guides) {
        const QLineF line(toViewport(guide.line.p1()), toViewport(guide.line.p2()));
        painter.setPen(QPen(guide.isGap ? QColor(0xE0, 0x2E, 0x9A) : QColor(0xFF, 0x4D, 0x4D), 1));
        painter.drawLine(line);
        if (!guide.isGap) continue;
        const bool flat = std::abs(line.dy()) < 0.5;
        const QPointF tick = flat ? QPointF(0, 4) : QPointF(4, 0);
        for (const QPointF end : {line.p1(), line.p2()}) painter.drawLine(end - tick, end + tick);
        const QString length = QString::number(guide.line.length(), 'f', 0);
        painter.drawText(line.center() + (flat ? QPointF(-8, -5) : QPointF(6, 4)), length);
    }
    if (m_drag.mode != Mode::Move && m_drag.mode != Mode::Resize) return;
    const QRectF bounds = boundsOf(m_document.panel(), m_selection.ids());
    const QString text = m_drag.mode == Mode::Move ? QStringLiteral("%1, %2").arg(bounds.x()).arg(bounds.y())
                                                   : QStringLiteral("%1 × %2").arg(bounds.width()).arg(bounds.height());
    const QRectF shown = toViewport(bounds);
    QRectF label(shown.center().x() - 44, shown.bottom() + 8, 88, 20);
    painter.fillRect(label, kit::colors().accent);
    painter.setPen(kit::colors().onAccent);
    painter.drawText(label, Qt::AlignCenter, text);
}

void DesignCanvas::drawFindings(QPainter& painter) {
    painter.setRenderHint(QPainter::Antialiasing);
    for (auto it = m_findings.cbegin(); it != m_findings.cend(); ++it) {
        const Element* element = m_document.panel().find(it.key());
        const ElementView* view = m_scene.view(it.key());
        if (!element || !view || !m_scene.isShown(*view)) continue;
        const QRectF shown = toViewport(element->rect());
        painter.setPen(QPen(kit::colors().warning, 1.5, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(shown);
        const QRectF mark(shown.right() - 8, shown.top() - 8, 16, 16);
        painter.setPen(Qt::NoPen);
        painter.setBrush(kit::colors().warning);
        painter.drawEllipse(mark);
        painter.setPen(QPen(Qt::white, 2));
        painter.drawLine(QPointF(mark.center().x(), mark.top() + 4), QPointF(mark.center().x(), mark.top() + 9));
        painter.drawPoint(QPointF(mark.center().x(), mark.bottom() - 3.5));
    }
    painter.setRenderHint(QPainter::Antialiasing, false);
}

void DesignCanvas::drawDrop(QPainter& painter) {
    if (!m_dropRect) return;
    QColor fill = kit::colors().accent;
    painter.setPen(QPen(fill, 1, Qt::DashLine));
    fill.setAlphaF(0.15f);
    painter.setBrush(fill);
    painter.drawRect(toViewport(*m_dropRect));
}

void DesignCanvas::drawRulers(QPainter& painter) {
    const kit::ThemeColors& colors = kit::colors();
    const QRect top(0, 0, viewport()->width(), kRuler), left(0, 0, kRuler, viewport()->height());
    painter.fillRect(top, colors.raised);
    painter.fillRect(left, colors.raised);
    const QRectF selected = boundsOf(m_document.panel(), m_selection.ids());
    if (!selected.isNull()) {
        const QRectF shown = toViewport(selected);
        painter.fillRect(QRectF(shown.left(), 0, shown.width(), kRuler - 1) & QRectF(kRuler, 0, 1e6, kRuler),
                         colors.selection);
        painter.fillRect(QRectF(0, shown.top(), kRuler - 1, shown.height()) & QRectF(0, kRuler, kRuler, 1e6),
                         colors.selection);
    }
    double step = 100;
    for (const double candidate : {10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0})
        if (candidate * m_zoom >= 52) {
            step = candidate;
            break;
        }
    QFont small = font();
    small.setPixelSize(10);
    painter.setFont(small);
    for (const bool flat : {true, false}) {
        painter.save();
        painter.setClipRect(flat ? QRect(kRuler, 0, viewport()->width(), kRuler)
                                 : QRect(0, kRuler, kRuler, viewport()->height()));
        const double from = flat ? toPanel(QPointF(kRuler, 0)).x() : toPanel(QPointF(0, kRuler)).y(),
                     to = flat ? toPanel(QPointF(viewport()->width(), 0)).x()
                               : toPanel(QPointF(0, viewport()->height())).y();
        for (double at = std::floor(from / step) * step; at <= to; at += step / 5) {
            const double place = flat ? toViewport(QPointF(at, 0)).x() : toViewport(QPointF(0, at)).y();
            const bool isMain = std::abs(std::remainder(at, step)) < step * 0.01;
            painter.setPen(isMain ? colors.muted : colors.border);
            const double length = isMain ? 10 : 5;
            painter.drawLine(flat ? QLineF(place, kRuler - length, place, kRuler)
                                  : QLineF(kRuler - length, place, kRuler, place));
            if (!isMain) continue;
            const QString number = QString::number(std::llround(at));
            painter.setPen(colors.muted);
            if (flat) {
                painter.drawText(QPointF(place + 3, 10), number);
            } else {
                painter.save();
                painter.translate(10, place - 3);
                painter.rotate(-90);
                painter.drawText(QPointF(0, 0), number);
                painter.restore();
            }
        }
        painter.setPen(QPen(colors.accent, 1));
        const QPointF pointer = toViewport(m_pointer);
        painter.drawLine(flat ? QLineF(pointer.x(), 0, pointer.x(), kRuler)
                              : QLineF(0, pointer.y(), kRuler, pointer.y()));
        painter.restore();
    }
    painter.setPen(colors.border);
    painter.drawLine(kRuler - 1, kRuler - 1, viewport()->width(), kRuler - 1);
    painter.drawLine(kRuler - 1, kRuler - 1, kRuler - 1, viewport()->height());
    painter.fillRect(QRect(0, 0, kRuler - 1, kRuler - 1), colors.raised);
}

} // namespace plc::hmi
