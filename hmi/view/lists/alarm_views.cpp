#include "hmi/view/lists/alarm_views.h"

#include "hmi/alarms/alarm_book.h"
#include "hmi/texts/system_texts.h"
#include "hmi/view/controls/buttons.h"
#include "hmi/view/scene/panel_scene.h"

namespace plc::hmi {

namespace {

QStringList splitClasses(const QString& text) {
    QStringList out;
    for (const QString& one : text.split(u',', Qt::SkipEmptyParts)) out += one.trimmed();
    return out;
}

constexpr qint64 kSampleClock = 1704067200000000000; // 2024-01-01

/// What the designer shows where no alarm is: the first ones of the project, else examples.
std::vector<AlarmEntry> sampleEntries(const AlarmBook* book, const QStringList& classes) {
    constexpr AlarmState kStates[] = {AlarmState::Unacknowledged, AlarmState::Acknowledged, AlarmState::Returned};
    std::vector<AlarmEntry> out;
    const auto add = [&](AlarmEntry entry) {
        entry.state = kStates[out.size()];
        entry.raised.time = std::chrono::seconds(43200 + 61 * static_cast<int>(out.size()));
        out.push_back(std::move(entry));
    };
    if (book)
        for (const AlarmDefinition& alarm : book->definitions()) {
            if (out.size() == std::size(kStates) || (!classes.isEmpty() && !classes.contains(alarm.className)))
                continue;
            AlarmEntry entry;
            entry.text = alarm.text;
            entry.className = alarm.className;
            entry.priority = alarm.priority;
            add(entry);
        }
    if (!out.empty()) return out;
    for (const auto& [text, priority] :
         {std::pair{"Motor 1: overload", 1}, std::pair{"Tank level high", 2}, std::pair{"Door open", 3}}) {
        AlarmEntry entry;
        entry.text = QString::fromLatin1(text);
        entry.priority = priority;
        add(entry);
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
    if (priority == 1)
        painter.drawRect(r);
    else if (priority == 2)
        painter.drawPolygon(QPolygonF{QPointF(r.center().x(), r.top()), r.bottomRight(), r.bottomLeft()});
    else if (priority == 3)
        painter.drawEllipse(r);
    else
        painter.drawRect(r.adjusted(0, r.height() * 0.3, 0, -r.height() * 0.3));
}

} // namespace

QString alarmTime(const AlarmEntry& entry, const QLocale& locale, qint64 clockAtZero) {
    const qint64 at = entry.raisedClock != 0 ? entry.raisedClock : clockAtZero + entry.raised.time.count();
    return formatDate(at, locale) + u' ' + formatTime(at, locale, true);
}

QStringList AlarmListView::classes() const { return splitClasses(text("classes")); }

std::vector<AlarmEntry> AlarmListView::entries() const {
    const AlarmBook* book = scene().alarms();
    if (isDesigning() && (!book || book->present({}, AlarmOrder::Priority).empty()))
        return sampleEntries(book, classes());
    if (!book) return {};
    std::vector<AlarmEntry> all;
    if (isHistory())
        all = book->history(classes(), 500);
    else if (isAside())
        all = book->aside(classes());
    else
        all = scene().alarmPosition() ? book->presentAt(*scene().alarmPosition(), classes(), order())
                                      : book->present(classes(), order());
    if (isHistory() && order() == AlarmOrder::Priority)
        std::stable_sort(all.begin(), all.end(),
                         [](const AlarmEntry& a, const AlarmEntry& b) { return a.priority < b.priority; });
    if (m_filter == 1)
        std::erase_if(all, [](const AlarmEntry& entry) {
            return entry.state != AlarmState::Unacknowledged && entry.state != AlarmState::Returned;
        });
    if (const AlarmClass* only = filteredClass())
        std::erase_if(all, [&](const AlarmEntry& entry) { return entry.className != only->name; });
    return all;
}

AlarmOrder AlarmListView::order() const {
    if (m_order) return *m_order;
    return isHistory() || text("sort") == QStringLiteral("time") ? AlarmOrder::Time : AlarmOrder::Priority;
}

// ---- what the operator chooses by: all, what is not acknowledged, each class

std::vector<const AlarmClass*> AlarmListView::shownClasses() const {
    std::vector<const AlarmClass*> out;
    if (scene().alarms())
        for (const AlarmClass& one : scene().alarms()->classes())
            if (classes().isEmpty() || classes().contains(one.name)) out.push_back(&one);
    if (out.size() < 2) out.clear();
    return out;
}

const AlarmClass* AlarmListView::filteredClass() const {
    const std::vector<const AlarmClass*> all = shownClasses();
    return m_filter >= 2 && static_cast<size_t>(m_filter) < all.size() + 2 ? all[static_cast<size_t>(m_filter) - 2]
                                                                           : nullptr;
}

QString AlarmListView::classTitle(const AlarmClass& one) const {
    const QString title = shown(one.title);
    return title.isEmpty() ? one.name : title;
}

QString AlarmListView::filterText() const {
    if (const AlarmClass* only = filteredClass()) return classTitle(*only);
    return systemText(scene().texts(), m_filter == 1 ? SystemText::Unacknowledged : SystemText::All, tag());
}

QString AlarmListView::stateText(const AlarmEntry& entry) const {
    SystemText which = SystemText::Gone;
    switch (entry.state) {
    case AlarmState::Unacknowledged:
        which = SystemText::Unacknowledged;
        break;
    case AlarmState::Acknowledged:
        which = SystemText::Acknowledged;
        break;
    case AlarmState::Returned:
        which = SystemText::Returned;
        break;
    case AlarmState::Normal:
        break;
    }
    const bool isLeft = entry.isOfEarlierRun && entry.state == AlarmState::Unacknowledged;
    QString state = systemText(scene().texts(), isLeft ? SystemText::UntilRestart : which, tag());
    if (isHistory()) state = historyText(entry, state);
    const AlarmClass* own = classOf(scene().alarms(), entry.className);
    return own ? classTitle(*own) + QStringLiteral(" · ") + state : state;
}

/// When it went and when it was acknowledged; what it is now where neither has happened.
QString AlarmListView::historyText(const AlarmEntry& entry, const QString& state) const {
    QStringList parts;
    const auto add = [&](SystemText which, const std::optional<qint64>& clock) {
        if (clock)
            parts += systemText(scene().texts(), which, tag()) + u' ' + leftToRight(formatTime(*clock, locale(), true));
    };
    add(SystemText::Gone, entry.returnedClock);
    add(SystemText::Acknowledged, entry.acknowledgedClock);
    if (entry.state == AlarmState::Returned || parts.isEmpty()) parts += state;
    return parts.join(QStringLiteral(" · "));
}

// ---- places; keys and rows are high enough for a finger

double AlarmListView::rowHeight() const {
    return hasKeys() ? std::max(46.0, num("fontSize") * 3) : std::max(30.0, num("fontSize") * 2.2);
}

double AlarmListView::headHeight() const {
    return hasKeys() ? std::max(50.0, num("fontSize") * 2.6) : num("fontSize") * 2;
}

double AlarmListView::timeWidth() const { return num("fontSize") * 10.5; }

double AlarmListView::markWidth() const { return std::max(30.0, num("fontSize") * 2.2); }

QRectF AlarmListView::mirrored(const QRectF& area) const {
    return isRightToLeft(tag()) ? QRectF(width() - area.right(), area.top(), area.width(), area.height()) : area;
}

QRectF AlarmListView::acknowledgeAllArea() const {
    if (!hasKeys() || isHistory() || isAside()) return {};
    const double w = std::min(width() * 0.36, num("fontSize") * 11);
    return mirrored({width() - w - 4, 3, w, headHeight() - 6});
}

QRectF AlarmListView::filterArea() const {
    if (!hasKeys() || width() < num("fontSize") * 42) return {}; // the head of the texts comes first
    const double w = std::min(width() * 0.28, num("fontSize") * 11),
                 taken = isHistory() ? 0 : acknowledgeAllArea().width() + 4;
    return mirrored({width() - taken - w - 4, 3, w, headHeight() - 6});
}

QRectF AlarmListView::timeHead() const { return mirrored({markWidth(), 0, timeWidth() - 6, headHeight()}); }

QRectF AlarmListView::alarmHead() const {
    const double from = markWidth() + timeWidth();
    double to = width() - 6;
    if (hasKeys() && !isHistory()) to -= acknowledgeAllArea().width() + 4;
    to -= filterArea().width();
    return mirrored({from, 0, std::max(0.0, to - from), headHeight()});
}

QRectF AlarmListView::acknowledgeArea(int row) const {
    const double side = std::min(rowHeight() - 4, 44.0);
    return mirrored({width() - side - 6, headHeight() + row * rowHeight() + (rowHeight() - side) / 2, side, side});
}

QRectF AlarmListView::textArea(int row) const {
    const double from = markWidth() + timeWidth(),
                 key = hasKeys() && !isHistory() ? acknowledgeArea(0).width() + 14 : 6;
    const double top = headHeight() + row * rowHeight();
    // Rows with keys are high enough for two lines: what is wrong, and below it the class and the state.
    return mirrored(
        {from, hasKeys() ? top + 3 : top, width() - from - key, hasKeys() ? rowHeight() * 0.56 : rowHeight()});
}

void AlarmListView::drawRow(QPainter& painter, const AlarmEntry& entry, int row) {
    const double h = rowHeight(), top = headHeight() + row * h, size = num("fontSize");
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
    const double side = std::min(h * 0.5, 20.0);
    const QRectF mark = mirrored({(markWidth() - side) / 2, top + (h - side) / 2, side, side});
    drawPriority(painter, mark, entry.priority, color,
                 entry.state == AlarmState::Unacknowledged || entry.state == AlarmState::Acknowledged);
    if (entry.isFirstOut) { // which of them all came first
        painter.setPen(PanelTheme::inkOn(color));
        drawText(painter, textBox(QStringLiteral("1"), mark, size * 0.8, TextAlign::Center, "", true));
    }
    const bool isGone = entry.state == AlarmState::Returned || entry.state == AlarmState::Normal;
    const QRectF words = textArea(row);
    painter.setPen(theme().color("muted"));
    drawText(painter,
             textBox(alarmTime(entry, locale(),
                               scene().alarms() && !isDesigning() ? scene().alarms()->clockAtZero() : kSampleClock),
                     mirrored({markWidth(), words.top(), timeWidth() - 6, words.height()}), size * 0.92,
                     TextAlign::Start, ""));
    if (hasKeys())
        drawText(painter, textBox(stateText(entry),
                                  QRectF(words.left(), words.bottom() - 1, words.width(), h - words.height() - 5),
                                  size * 0.8, TextAlign::Start, ""));
    painter.setPen(isGone ? theme().color("muted") : inkColor(theme().color("text")));
    drawText(painter,
             textBox(AlarmBook::render(entry, scene().texts(), tag()), words, size, TextAlign::Start, "", isOpen));
    const bool canAcknowledge = !isHistory() && !isAside() && hasKeys() &&
                                (isOpen || entry.state == AlarmState::Returned) && !scene().alarmPosition();
    if (!canAcknowledge) return;
    const QRectF key = acknowledgeArea(row).adjusted(2, 2, -2, -2);
    drawKey(painter, key, 4, theme().color("button"),
            isPressed() && !m_scrolled && acknowledgeArea(row).contains(m_pressedAt), theme());
    painter.setPen(QPen(theme().color("text"), 2.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(QPolygonF{key.topLeft() + QPointF(key.width() * 0.28, key.height() * 0.52),
                                   key.topLeft() + QPointF(key.width() * 0.43, key.height() * 0.67),
                                   key.topLeft() + QPointF(key.width() * 0.73, key.height() * 0.33)});
}

void AlarmListView::drawHead(QPainter& painter) {
    painter.fillRect(QRectF(1, 1, width() - 2, headHeight() - 1), theme().color("surface"));
    painter.setPen(QPen(theme().color("faint"), 1));
    painter.drawLine(QPointF(0, headHeight()), QPointF(width(), headHeight()));
    const double size = num("fontSize");
    const auto title = [&](const QRectF& area, SystemText which, AlarmOrder sorts) {
        const TextBox words = textBox(systemText(scene().texts(), which, tag()), area, size * 0.9, TextAlign::Start, "",
                                      order() == sorts);
        painter.setPen(theme().color(order() == sorts ? "text" : "muted"));
        drawText(painter, words);
        const double end = neededSize(words).width() + 10;
        if (order() != sorts || end > area.width() - 8) return;
        const double x = isRightToLeft(tag()) ? area.right() - end : area.left() + end, y = area.center().y();
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme().color("text"));
        painter.drawPolygon(QPolygonF{QPointF(x - 4, y - 2), QPointF(x + 4, y - 2), QPointF(x, y + 3)});
    };
    title(timeHead(), SystemText::Time, AlarmOrder::Time);
    title(alarmHead(), SystemText::Alarm, AlarmOrder::Priority);
    if (const QRectF all = acknowledgeAllArea(); !all.isEmpty()) {
        drawKey(painter, all, 5, theme().color("button"), isPressed() && !m_scrolled && all.contains(m_pressedAt),
                theme());
        painter.setPen(PanelTheme::inkOn(theme().color("button")));
        drawText(painter, textBox(systemText(scene().texts(), SystemText::AcknowledgeAll, tag()),
                                  all.adjusted(8, 0, -8, 0), size, TextAlign::Center, ""));
    }
    const QRectF filter = filterArea();
    if (filter.isEmpty()) return;
    const QColor ground = theme().color(m_filter ? "accent" : "button");
    drawKey(painter, filter, 5, ground, isPressed() && !m_scrolled && filter.contains(m_pressedAt), theme());
    // A funnel says what the words choose.
    const QRectF sign = isRightToLeft(tag()) ? QRectF(filter.right() - 26, filter.center().y() - 7, 14, 14)
                                             : QRectF(filter.left() + 12, filter.center().y() - 7, 14, 14);
    painter.setPen(Qt::NoPen);
    painter.setBrush(PanelTheme::inkOn(ground));
    painter.drawPolygon(QPolygonF{sign.topLeft(), sign.topRight(), QPointF(sign.center().x() + 2, sign.center().y()),
                                  QPointF(sign.center().x() + 2, sign.bottom() - 2),
                                  QPointF(sign.center().x() - 2, sign.bottom()),
                                  QPointF(sign.center().x() - 2, sign.center().y())});
    painter.setPen(PanelTheme::inkOn(ground));
    const QRectF words = isRightToLeft(tag()) ? filter.adjusted(8, 0, -32, 0) : filter.adjusted(32, 0, -8, 0);
    drawText(painter, textBox(filterText(), words, size, TextAlign::Start, ""));
}

void AlarmListView::draw(QPainter& painter) {
    const std::vector<AlarmEntry> all = entries();
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1));
    painter.setBrush(theme().color("inset"));
    painter.drawRect(box().adjusted(0.5, 0.5, -0.5, -0.5));
    drawHead(painter);
    const double below = height() - headHeight();
    const int room = std::max(1, static_cast<int>(below / rowHeight() + 0.06));
    m_top = std::clamp(m_top, 0, std::max(0, static_cast<int>(all.size()) - room));
    painter.save();
    painter.setClipRect(QRectF(0, headHeight(), width(), below), Qt::IntersectClip);
    // A row that is cut at the lower edge tells that there is more.
    for (int row = 0; row <= room && m_top + row < static_cast<int>(all.size()); ++row)
        drawRow(painter, all[static_cast<size_t>(m_top + row)], row);
    painter.restore();
    if (all.empty()) {
        painter.setPen(theme().color("muted"));
        drawText(painter, textBox(systemText(scene().texts(), SystemText::NoAlarms, tag()),
                                  QRectF(0, headHeight(), width(), std::min(below, rowHeight() * 1.6)), num("fontSize"),
                                  TextAlign::Center, ""));
    }
    if (static_cast<int>(all.size()) <= room) return;
    const double length = below - 4, knob = std::max(16.0, length * room / static_cast<double>(all.size()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().color("off"));
    painter.drawRoundedRect(
        mirrored({width() - 6,
                  headHeight() + 2 + (length - knob) * m_top / std::max(1.0, static_cast<double>(all.size()) - room), 4,
                  knob}),
        2, 2);
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
    if (!inside || m_scrolled) return;
    if (hasKeys() && at.y() < headHeight()) {
        if (filterArea().contains(at))
            m_filter = (m_filter + 1) % (2 + static_cast<int>(shownClasses().size()));
        else if (timeHead().contains(at))
            m_order = AlarmOrder::Time;
        else if (alarmHead().contains(at))
            m_order = AlarmOrder::Priority;
        else if (acknowledgeAllArea().contains(at) && !scene().alarmPosition())
            return scene().request(
                AcknowledgeRequest{true, 0, filteredClass() ? QStringList{filteredClass()->name} : classes()});
        m_top = 0;
        return repaint();
    }
    if (isHistory() || !hasKeys() || scene().alarmPosition()) return;
    const std::vector<AlarmEntry> all = entries();
    const int row = static_cast<int>((at.y() - headHeight()) / rowHeight());
    if (at.y() < headHeight() || m_top + row >= static_cast<int>(all.size())) return;
    const AlarmEntry& entry = all[static_cast<size_t>(m_top + row)];
    if (isAside() || !acknowledgeArea(row).adjusted(-8, -2, 8, 2).contains(at))
        return scene().request(AlarmDetailRequest{element().id(), entry.alarm});
    if (entry.state == AlarmState::Unacknowledged || entry.state == AlarmState::Returned)
        scene().request(AcknowledgeRequest{false, entry.alarm, {}});
}

/// The words of the head, which a list that is too narrow cuts.
void AlarmListView::collectHead(const QString& forTag, std::vector<TextBox>& out) const {
    const auto add = [&](const QRectF& area, SystemText which, double size, bool bold) {
        if (!area.isEmpty())
            out.push_back(textBox(systemText(scene().texts(), which, forTag), area, size, TextAlign::Start, "rect",
                                  bold, forTag));
    };
    const double size = num("fontSize");
    add(timeHead(), SystemText::Time, size * 0.9, true);
    QRectF words = alarmHead();
    if (words.isEmpty()) words = QRectF(0, 0, 1, headHeight()); // no room at all is a cut as well
    add(words, SystemText::Alarm, size * 0.9, true);
    const QRectF keys = acknowledgeAllArea();
    add(keys.isEmpty() ? keys : keys.adjusted(8, 0, -8, 0), SystemText::AcknowledgeAll, size, false);
}

void AlarmListView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    collectHead(forTag, out);
    if (!scene().alarms()) return;
    for (const AlarmDefinition& alarm : scene().alarms()->definitions()) {
        if (!classes().isEmpty() && !classes().contains(alarm.className)) continue;
        AlarmEntry entry;
        entry.text = alarm.text;
        out.push_back(textBox(AlarmBook::render(entry, scene().texts(), forTag), textArea(0), num("fontSize"),
                              TextAlign::Start, ("alarm " + alarm.id.toUtf8()).constData(), true, forTag));
    }
}

QStringList AlarmBannerView::classes() const { return splitClasses(text("classes")); }

QRectF AlarmBannerView::textArea() const {
    return box().adjusted(isRightToLeft(tag()) ? num("fontSize") * 4 : height(), 2,
                          isRightToLeft(tag()) ? -height() : -num("fontSize") * 4, -2);
}

void AlarmBannerView::draw(QPainter& painter) {
    const AlarmBook* book = scene().alarms();
    std::vector<AlarmEntry> all;
    if (book)
        all = scene().alarmPosition() ? book->presentAt(*scene().alarmPosition(), classes(), AlarmOrder::Priority)
                                      : book->present(classes(), AlarmOrder::Priority);
    if (all.empty() && isDesigning()) all = sampleEntries(book, classes());
    const double edge = theme().kind() == PanelThemeKind::Contrast ? 2 : 1;
    painter.setPen(QPen(all.empty() ? theme().color("faint") : theme().color("line"), edge));
    if (all.empty()) {
        painter.setBrush(theme().color("surface"));
        painter.drawRoundedRect(box().adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
        painter.setPen(theme().color("muted"));
        drawText(painter, textBox(systemText(scene().texts(), SystemText::NoAlarms, tag()),
                                  box().adjusted(12, 2, -12, -2), num("fontSize") * 0.9, TextAlign::Start, ""));
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
    drawPriority(
        painter,
        QRectF(rtl ? width() - height() / 2 - side / 2 : height() / 2 - side / 2, (height() - side) / 2, side, side),
        first.priority, isOpen && isLit() ? ink : color, first.state != AlarmState::Returned);
    painter.setPen(ink);
    drawText(painter, textBox(AlarmBook::render(first, scene().texts(), tag()), textArea(), num("fontSize"),
                              TextAlign::Start, "", isOpen));
    if (all.size() < 2) return;
    const double w = num("fontSize") * 3;
    const QRectF badge(rtl ? 8 : width() - w - 8, height() * 0.22, w, height() * 0.56);
    painter.setPen(QPen(ink, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(badge, badge.height() / 2, badge.height() / 2);
    drawText(painter,
             textBox(u'+' + QString::number(all.size() - 1), badge, num("fontSize") * 0.9, TextAlign::Center, ""));
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
        out.push_back(textBox(AlarmBook::render(entry, scene().texts(), forTag), textArea(), num("fontSize"),
                              TextAlign::Start, ("alarm " + alarm.id.toUtf8()).constData(), true, forTag));
    }
}

} // namespace plc::hmi
