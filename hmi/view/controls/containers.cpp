#include "hmi/view/controls/containers.h"

#include "hmi/view/scene/panel_scene.h"

#include <QPainterPath>

namespace plc::hmi {

void TabView::setUp() {
    m_selected = bindProperty("selected");
    m_titles.clear();
    const Json& pages = element().at("pages");
    if (pages.is_array())
        for (const Json& page : pages)
            m_titles += page.is_object() && page.contains("title") ? toQString(page["title"]) : QString();
    m_page = std::clamp(m_page, 0, std::max(0, static_cast<int>(m_titles.size()) - 1));
}

bool TabView::update() {
    const Value now = echoed(m_selected);
    if (now.isNone()) return false;
    const int page =
        std::clamp(static_cast<int>(now.toInteger()), 0, std::max(0, static_cast<int>(m_titles.size()) - 1));
    if (page == m_page) return false;
    showPage(page);
    return true;
}

void TabView::showPage(int page) {
    if (page == m_page || page < 0 || page >= m_titles.size()) return;
    m_page = page;
    repaint();
}

double TabView::headHeight() const { return std::max(36.0, num("fontSize") * 2.6); }

QRectF TabView::touchArea() const { return {0, 0, width(), headHeight()}; }

QRectF TabView::headArea(int page) const {
    const auto count = std::max<qsizetype>(1, m_titles.size());
    const double w = std::min(num("fontSize") * 11, width() / static_cast<double>(count));
    return {isRightToLeft(tag()) ? width() - (page + 1) * w : page * w, 0, w, headHeight()};
}

TextBox TabView::label(int page, const QString& forTag) const {
    return textBox(shown(m_titles.value(page), forTag), headArea(page).adjusted(8, 0, -8, 0), num("fontSize"),
                   TextAlign::Center, ("pages[" + QByteArray::number(page) + "].title").constData(), page == m_page,
                   forTag);
}

void TabView::release(QPointF at, bool inside) {
    if (!inside) return;
    for (int page = 0; page < m_titles.size(); ++page) {
        if (!headArea(page).contains(at)) continue;
        if (m_selected.isBound()) {
            write(expression(m_selected), Value::ofInteger(page));
            echo(Value::ofInteger(page));
        } else {
            showPage(page);
        }
        return;
    }
}

void TabView::draw(QPainter& painter) {
    const double head = headHeight();
    const QRectF body(0.5, head, width() - 1, height() - head - 0.5);
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1));
    painter.setBrush(theme().color("surface"));
    painter.drawRect(body);
    for (int page = 0; page < m_titles.size(); ++page) {
        const QRectF area = headArea(page).adjusted(0.5, page == m_page ? 1 : 4, -1, 0);
        QPainterPath path(area.bottomLeft());
        path.lineTo(area.topLeft() + QPointF(0, 6));
        path.quadTo(area.topLeft(), area.topLeft() + QPointF(6, 0));
        path.lineTo(area.topRight() - QPointF(6, 0));
        path.quadTo(area.topRight(), area.topRight() + QPointF(0, 6));
        path.lineTo(area.bottomRight());
        painter.fillPath(path,
                         theme().color(page == m_page ? "surface" : "background").darker(page == m_page ? 100 : 104));
        painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1));
        painter.setBrush(Qt::NoBrush);
        painter.drawPath(path);
        if (page == m_page) {
            painter.fillRect(QRectF(area.left() + 1, head - 1.5, area.width() - 2, 3), theme().color("surface"));
            painter.fillRect(QRectF(area.left() + 8, area.top() + 1, area.width() - 16, 3), theme().color("accent"));
        }
        painter.setPen(page == m_page ? theme().color("text") : theme().color("muted"));
        drawText(painter, label(page, tag()));
    }
}

void TabView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    for (int page = 0; page < m_titles.size(); ++page) out.push_back(label(page, forTag));
}

TextBox GroupView::label(const QString& forTag) const {
    return textBox(shown(text("title"), forTag), QRectF(12, 0, width() - 24, num("fontSize") * 1.9), num("fontSize"),
                   TextAlign::Start, "title", true, forTag);
}

void GroupView::draw(QPainter& painter) {
    const bool hasTitle = !text("title").isEmpty();
    if (!flag("frame") && !hasTitle) {
        if (!isDesigning()) return;
        painter.setPen(QPen(theme().color("faint"), 1, Qt::DashLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(box());
        return;
    }
    painter.setPen(QPen(theme().color("faint"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1.2));
    painter.setBrush(stateColor(theme().color("surface")));
    painter.drawRoundedRect(box().adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    if (!hasTitle) return;
    const double line = num("fontSize") * 1.9;
    painter.drawLine(QPointF(10, line), QPointF(width() - 10, line));
    painter.setPen(inkColor(theme().color("text")));
    drawText(painter, label(tag()));
}

void GroupView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (!text("title").isEmpty()) out.push_back(label(forTag));
}

} // namespace plc::hmi
