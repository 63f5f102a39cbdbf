#include "hmi/view/controls/navigation_views.h"

#include "hmi/view/controls/buttons.h"
#include "hmi/view/scene/panel_scene.h"

namespace plc::hmi {

QString PanelAreaView::panelName() const { return scene().areaPanel(); }

void NavigationBarView::setUp() {
    m_entries.clear();
    const Json& rows = element().at("entries");
    if (!rows.is_array()) return;
    for (const Json& row : rows) {
        if (!row.is_object()) continue;
        const Properties entry(descriptorOf(ElementKind::Unknown), row);
        m_entries.push_back({entry.text("panel"), entry.text("text")});
    }
}

QRectF NavigationBarView::keyArea(size_t index) const {
    constexpr double kGap = 4;
    const double count = static_cast<double>(std::max<size_t>(1, m_entries.size()));
    double at = static_cast<double>(index);
    if (isVertical()) {
        const double step = (height() + kGap) / count;
        return {0, at * step, width(), step - kGap};
    }
    if (isRightToLeft(tag())) at = count - 1 - at;
    const double step = (width() + kGap) / count;
    return {at * step, 0, step - kGap, height()};
}

std::optional<size_t> NavigationBarView::keyAt(QPointF at) const {
    for (size_t i = 0; i < m_entries.size(); ++i)
        if (keyArea(i).contains(at)) return i;
    return {};
}

TextBox NavigationBarView::label(size_t index, const QString& forTag) const {
    const Entry& entry = m_entries[index];
    const QString words = entry.text.isEmpty() ? entry.panel : shown(entry.text, forTag);
    return textBox(words, keyArea(index).adjusted(6, 2, -6, -2), num("fontSize"), TextAlign::Center,
                   ("entries[" + QByteArray::number(static_cast<int>(index)) + "].text").constData(), false, forTag);
}

void NavigationBarView::press(QPointF at) {
    m_down = keyAt(at);
    repaint();
}

void NavigationBarView::release(QPointF at, bool inside) {
    const std::optional<size_t> down = std::exchange(m_down, std::nullopt);
    repaint();
    if (inside && down && keyAt(at) == down)
        scene().request(NavigationRequest{NavigationKind::Open, m_entries[*down].panel, {}});
}

void NavigationBarView::draw(QPainter& painter) {
    for (size_t i = 0; i < m_entries.size(); ++i) {
        const bool isCurrent = !m_entries[i].panel.isEmpty() && m_entries[i].panel == scene().currentPanel();
        const QColor ground = isCurrent ? theme().color("accent") : stateColor(theme().color("button"));
        drawKey(painter, keyArea(i), 6, ground, m_down == i, theme());
        painter.setPen(PanelTheme::inkOn(ground));
        drawText(painter, label(i, tag()));
        // Not by colour alone: the current one has a bar at its edge.
        if (!isCurrent) continue;
        const QRectF area = keyArea(i);
        painter.fillRect(isVertical() ? QRectF(area.left() + 3, area.top() + 8, 4, area.height() - 16)
                                      : QRectF(area.left() + 8, area.bottom() - 7, area.width() - 16, 4),
                         PanelTheme::inkOn(ground));
    }
}

void NavigationBarView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    for (size_t i = 0; i < m_entries.size(); ++i) out.push_back(label(i, forTag));
}

} // namespace plc::hmi
