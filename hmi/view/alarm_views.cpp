#include "hmi/view/alarm_views.h"

#include "hmi/alarms/alarm_book.h"
#include "hmi/texts/system_texts.h"
#include "hmi/view/buttons.h"
#include "hmi/view/panel_scene.h"

namespace plc::hmi {

namespace {

QStringList splitClasses(const QString& text) {
    QStringList out;
    for (const QString& one : text.split(u',', Qt::SkipEmptyParts)) out += one.trimmed();
    return out;
}

/// What the designer shows where no alarm is.
std::vector<AlarmEntry> sampleEntries() {
    std::vector<AlarmEntry> out;
    const struct {
        const char* text;
        int priority;
        AlarmState state;
    } rows[] = {{"Motor 1: overload", 1, AlarmState::Unacknowledged}, {"Tank level high", 2, AlarmState::Acknowledged}, {"Door open", 3, AlarmState::Returned}};
    for (const auto& row : rows) {
        AlarmEntry entry;
        entry.text = QString::fromLatin1(row.text);
        entry.priority = row.priority;
        entry.state = row.state;
        entry.raised.time = std::chrono::seconds(43200 + 61 * static_cast<int>(out.size()));
        out.push_back(entry);
    }
    return out;
}

const AlarmClass* classOf(const AlarmBook* book, const QString& name) {
    if (book)
        for (const AlarmClass& one : book->classes())
            if (one.name == name) return &one;
    return nullptr;
}

QColor colorOf(const AlarmEntry& entry, const AlarmBook* book, const PanelTheme& theme) {
    const AlarmClass* own = classOf(book, entry.className);
    const QColor color = own ? theme.color(own->color) : QColor();
    return color.isValid() ? color : theme.priority(entry.priority);
}

/// A shape per priority, so that colour alone does not tell: square, triangle, circle, bar.
void drawPriority(QPainter& painter, const QRectF& area, int priority, const QColor& color, bool filled) {
    painter.setPen(QPen(color, 2));
    painter.setBrush(filled ? QBrush(color) : QBrush(Qt::NoBrush));
    const QRectF r = area.adjusted(2, 2, -2, -2);
    if (priority == 1) painter.drawRect(r);
    else if (priority == 2) painter.drawPolygon(QPolygonF{QPointF(r.center().x(), r.top()), r.bottomRight(), r.bottomLeft()});
    else if (priority == 3) painter.drawEllipse(r);
    else painter.drawRect(r.adjusted(0, r.height() * 0.3, 0, -r.height() * 0.3));
}

} // namespace

QString alarmTime(const AlarmEntry& entry, const QLocale& locale, qint64 clockAtZero) {
    const qint64 at = clockAtZero + entry.raised.time.count();
    return formatDate(at, locale) + u' ' + formatTime(at, locale, true);
}

QStringList AlarmListView::classes() const { return splitClasses(text("classes")); }

std::vector<AlarmEntry> AlarmListView::entries() const {
    const AlarmBook* book = scene().alarms();
    if (isDesigning() && (!book || book->present({}, AlarmOrder::Priority).empty())) return sampleEntries();
    if (!book) return {};
    if (isHistory()) return book->history(classes(), 500);
    const AlarmOrder order = text("sort") == QStringLiteral("time") ? AlarmOrder::Time : AlarmOrder::Priority;
    return scene().alarmPosition() ? book->presentAt(*scene().alarmPosition(), classes(), order) : book->present(classes(), order);
}

double AlarmListView::rowHeight() const { return std::max(30.0, num("fontSize") * 2.2); }

double AlarmListView::headHeight() const { return num("fontSize") * 2; }

double AlarmListView::footHeight() const { return flag("buttons") && !isHistory() ? std::max(40.0, num("fontSize") * 2.6) : 0; }

QRectF AlarmListView::acknowledgeAllArea() const {
    const double w = std::min(width() * 0.5, num("fontSize") * 13), h = footHeight() - 8;
    return {isRightToLeft(tag()) ? 6.0 : width() - w - 6, height() - h - 4, w, h};
}

QRectF AlarmListView::acknowledgeArea(int row) const {
    const double side = rowHeight() - 6;
    return {isRightToLeft(tag()) ? 6.0 : width() - side - 8, headHeight() + row * rowHeight() + 3, side, side};
}

QRectF AlarmListView::textArea(int row) const {
    const double timeWidth = num("fontSize") * 10.5, mark = rowHeight();
    const double buttons = flag("buttons") && !isHistory() ? rowHeight() + 6 : 6;
    const double top = headHeight() + row * rowHeight();
    if (isRightToLeft(tag())) return {buttons, top, width() - mark - timeWidth - buttons, rowHeight()};
    return {mark + timeWidth, top, width() - mark - timeWidth - buttons, rowHeight()};
}

void AlarmListView::drawRow(QPainter& painter, const AlarmEntry& entry, int row) {
    const double h = rowHeight(), top = headHeight() + row * h, mark = h;
    const bool rtl = isRightToLeft(tag());
    const QColor color = colorOf(entry, scene().alarms(), theme());
    const bool isOpen = entry.state == AlarmState::Unacknowledged;
    if (isOpen && !isHistory()) m_blinking = true;
    const QRectF line(1, top, width() - 2, h);
    if (isOpen && isLit() && !isHistory()) {
        QColor tint = color;
        tint.setAlphaF(theme().kind() == PanelThemeKind::Contrast ? 0.0f : theme().isDark() ? 0.30f : 0.22f);
        painter.fillRect(line, tint);
    }
    painter.setPen(QPen(theme().color("faint"), 1));
    painter.drawLine(line.bottomLeft(), line.bottomRight());
    const double side = std::min(h * 0.55, 20.0);
    const QRectF sign((rtl ? width() - mark : 0) + (mark - side) / 2, top + (h - side) / 2, side, side);
    drawPriority(painter, sign, entry.priority, color, entry.state == AlarmState::Unacknowledged || entry.state == AlarmState::Acknowledged);
    const double size = num("fontSize"), timeWidth = size * 10.5;
    const bool isGone = entry.state == AlarmState::Returned || entry.state == AlarmState::Normal;
    painter.setPen(theme().color("muted"));
    drawText(painter, textBox(alarmTime(entry, locale(), scene().alarms() ? scene().alarms()->clockAtZero() : 0), QRectF(rtl ? width() - mark - timeWidth : mark, top, timeWidth - 6, h), size * 0.92, TextAlign::Start, ""));
    painter.setPen(isGone ? theme().color("muted") : inkColor(theme().color("text")));
    drawText(painter, textBox(AlarmBook::render(entry, scene().texts(), tag()), textArea(row), size, TextAlign::Start, "", isOpen));
    const bool canAcknowledge = !isHistory() && flag("buttons") && (isOpen || entry.state == AlarmState::Returned) && !scene().alarmPosition();
    if (!canAcknowledge) return;
    const QRectF key = acknowledgeArea(row);
    drawKey(painter, key, 4, theme().color("button"), false, theme());
    painter.setPen(QPen(theme().color("text"), 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(QPolygonF{key.topLeft() + QPointF(key.width() * 0.26, key.height() * 0.52), key.topLeft() + QPointF(key.width() * 0.43, key.height() * 0.68), key.topLeft() + QPointF(key.width() * 0.75, key.height() * 0.3)});
}

void AlarmListView::draw(QPainter& painter) {
    const std::vector<AlarmEntry> all = entries();
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1));
    painter.setBrush(theme().color("inset"));
    painter.drawRect(box().adjusted(0.5, 0.5, -0.5, -0.5));
    painter.fillRect(QRectF(1, 1, width() - 2, headHeight() - 1), theme().color("surface"));
    const double size = num("fontSize"), timeWidth = size * 10.5, mark = rowHeight();
    const bool rtl = isRightToLeft(tag());
    painter.setPen(theme().color("muted"));
    const auto head = [&](SystemText which) { return systemText(scene().texts(), which, tag()); };
    drawText(painter, textBox(head(SystemText::Time), QRectF(rtl ? width() - mark - timeWidth : mark, 0, timeWidth, headHeight()), size * 0.9, TextAlign::Start, ""));
    QRectF alarmHead = textArea(0);
    alarmHead.setRect(alarmHead.left(), 0, alarmHead.width(), headHeight());
    drawText(painter, textBox(head(SystemText::Alarm), alarmHead, size * 0.9, TextAlign::Start, ""));
    const int room = std::max(1, static_cast<int>((height() - headHeight() - footHeight()) / rowHeight()));
    m_top = std::clamp(m_top, 0, std::max(0, static_cast<int>(all.size()) - room));
    painter.save();
    painter.setClipRect(QRectF(0, headHeight(), width(), height() - headHeight() - footHeight()), Qt::IntersectClip);
    for (int row = 0; row < room && m_top + row < static_cast<int>(all.size()); ++row) drawRow(painter, all[static_cast<size_t>(m_top + row)], row);
    painter.restore();
    if (all.empty()) {
        painter.setPen(theme().color("muted"));
        drawText(painter, textBox(head(SystemText::NoAlarms), QRectF(0, headHeight(), width(), rowHeight() * 1.6), size, TextAlign::Center, ""));
    }
    if (static_cast<int>(all.size()) > room) {
        const double length = height() - headHeight() - footHeight() - 4, knob = std::max(16.0, length * room / static_cast<double>(all.size()));
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme().color("off"));
        painter.drawRoundedRect(QRectF(rtl ? 2 : width() - 6, headHeight() + 2 + (length - knob) * m_top / std::max(1.0, static_cast<double>(all.size()) - room), 4, knob), 2, 2);
    }
    if (footHeight() <= 0) return;
    painter.setPen(QPen(theme().color("faint"), 1));
    painter.drawLine(QPointF(0, height() - footHeight()), QPointF(width(), height() - footHeight()));
    const QRectF key = acknowledgeAllArea();
    drawKey(painter, key, 5, theme().color("button"), isPressed() && !m_scrolled && key.contains(m_pressedAt), theme());
    painter.setPen(theme().color("text"));
    drawText(painter, textBox(head(SystemText::AcknowledgeAll), key.adjusted(6, 0, -6, 0), size, TextAlign::Center, ""));
}

void AlarmListView::press(QPointF at) {
    m_pressedAt = at;
    m_pressedTop = m_top;
    m_scrolled = false;
}

void AlarmListView::move(QPointF at) {
    if (std::abs(at.y() - m_pressedAt.y()) > 10) m_scrolled = true;
    if (!m_scrolled) return;
    m_top = std::max(0, m_pressedTop + static_cast<int>((m_pressedAt.y() - at.y()) / rowHeight()));
    repaint();
}

void AlarmListView::wheel(double steps) {
    m_top = std::max(0, m_top - static_cast<int>(steps * 3));
    repaint();
}

void AlarmListView::release(QPointF at, bool inside) {
    if (!inside || m_scrolled || isHistory() || !flag("buttons") || scene().alarmPosition()) return;
    if (acknowledgeAllArea().contains(at)) return scene().request(AcknowledgeRequest{true, 0, classes()});
    const std::vector<AlarmEntry> all = entries();
    const int row = static_cast<int>((at.y() - headHeight()) / rowHeight());
    if (at.y() < headHeight() || m_top + row >= static_cast<int>(all.size()) || !acknowledgeArea(row).adjusted(-8, -4, 8, 4).contains(at)) return;
    scene().request(AcknowledgeRequest{false, all[static_cast<size_t>(m_top + row)].alarm, {}});
}

void AlarmListView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (!scene().alarms()) return;
    for (const AlarmDefinition& alarm : scene().alarms()->definitions()) {
        if (!classes().isEmpty() && !classes().contains(alarm.className)) continue;
        AlarmEntry entry;
        entry.text = alarm.text;
        out.push_back(textBox(AlarmBook::render(entry, scene().texts(), forTag), textArea(0), num("fontSize"), TextAlign::Start, ("alarm " + alarm.id.toUtf8()).constData(), true, forTag));
    }
}

QStringList AlarmBannerView::classes() const { return splitClasses(text("classes")); }

QRectF AlarmBannerView::textArea() const { return box().adjusted(isRightToLeft(tag()) ? num("fontSize") * 4 : height(), 2, isRightToLeft(tag()) ? -height() : -num("fontSize") * 4, -2); }

void AlarmBannerView::draw(QPainter& painter) {
    const AlarmBook* book = scene().alarms();
    std::vector<AlarmEntry> all;
    if (book) all = scene().alarmPosition() ? book->presentAt(*scene().alarmPosition(), classes(), AlarmOrder::Priority) : book->present(classes(), AlarmOrder::Priority);
    if (all.empty() && isDesigning()) all = sampleEntries();
    const double edge = theme().kind() == PanelThemeKind::Contrast ? 2 : 1;
    painter.setPen(QPen(all.empty() ? theme().color("faint") : theme().color("line"), edge));
    if (all.empty()) {
        painter.setBrush(theme().color("surface"));
        painter.drawRoundedRect(box().adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
        return;
    }
    const AlarmEntry& first = all.front();
    const QColor color = colorOf(first, book, theme());
    const bool isOpen = first.state == AlarmState::Unacknowledged;
    m_blinking = m_blinking || isOpen;
    const QColor ground = isOpen && isLit() ? color : theme().color("inset");
    painter.setBrush(ground);
    painter.drawRoundedRect(box().adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
    const QColor ink = PanelTheme::inkOn(ground);
    const double side = std::min(height() * 0.5, 24.0);
    const bool rtl = isRightToLeft(tag());
    drawPriority(painter, QRectF(rtl ? width() - height() / 2 - side / 2 : height() / 2 - side / 2, (height() - side) / 2, side, side), first.priority, isOpen && isLit() ? ink : color, first.state != AlarmState::Returned);
    painter.setPen(ink);
    drawText(painter, textBox(AlarmBook::render(first, scene().texts(), tag()), textArea(), num("fontSize"), TextAlign::Start, "", isOpen));
    if (all.size() < 2) return;
    const double w = num("fontSize") * 3;
    const QRectF badge(rtl ? 8 : width() - w - 8, height() * 0.22, w, height() * 0.56);
    painter.setPen(QPen(ink, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(badge, badge.height() / 2, badge.height() / 2);
    drawText(painter, textBox(u'+' + QString::number(all.size() - 1), badge, num("fontSize") * 0.9, TextAlign::Center, ""));
}

void AlarmBannerView::release(QPointF, bool inside) {
    const AlarmBook* book = scene().alarms();
    if (!inside || !book || scene().alarmPosition()) return;
    const std::vector<AlarmEntry> all = book->present(classes(), AlarmOrder::Priority);
    if (!all.empty() && (all.front().state == AlarmState::Unacknowledged || all.front().state == AlarmState::Returned))
        scene().request(AcknowledgeRequest{false, all.front().alarm, {}});
}

void AlarmBannerView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    if (!scene().alarms()) return;
    for (const AlarmDefinition& alarm : scene().alarms()->definitions()) {
        AlarmEntry entry;
        entry.text = alarm.text;
        out.push_back(textBox(AlarmBook::render(entry, scene().texts(), forTag), textArea(), num("fontSize"), TextAlign::Start, ("alarm " + alarm.id.toUtf8()).constData(), true, forTag));
    }
}

} // namespace plc::hmi
