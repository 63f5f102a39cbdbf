#include "hmi/view/lists/alarm_statistics_view.h"

#include "hmi/alarms/alarm_book.h"
#include "hmi/texts/system_texts.h"
#include "hmi/view/scene/panel_scene.h"

namespace plc::hmi {

namespace {

constexpr SystemText kFigures[] = {SystemText::AlarmsPerHour, SystemText::AlarmFloods, SystemText::StandingAlarms,
                                   SystemText::ChatteringAlarms};
constexpr int kCount = 4;
constexpr qint64 kEvery = 2000; // ms between two looks at the journal

} // namespace

void AlarmStatisticsView::setUp() {
    m_nextRead = 0;
    read();
}

void AlarmStatisticsView::read() {
    if (isDesigning() || !scene().alarms()) {
        m_found = {};
        m_found.perHour = 4.2;
        m_found.mostFrequent = {{QStringLiteral("1"), 12}, {QStringLiteral("2"), 7}, {QStringLiteral("3"), 2}};
        return;
    }
    const auto hours = std::chrono::hours(static_cast<int>(std::max(1.0, num("hours"))));
    m_found = scene().alarms()->statistics(hours);
}

bool AlarmStatisticsView::advance(qint64 milliseconds) {
    if (milliseconds < m_nextRead) return false;
    m_nextRead = milliseconds + kEvery;
    read();
    return true;
}

QString AlarmStatisticsView::figure(int index) const {
    switch (index) {
    case 0:
        return locale().toString(m_found.perHour, 'f', 1);
    case 1:
        return locale().toString(static_cast<int>(m_found.floods.size()));
    case 2:
        return locale().toString(static_cast<int>(m_found.standing.size()));
    default:
        return locale().toString(static_cast<int>(m_found.chattering.size()));
    }
}

TextBox AlarmStatisticsView::label(int index, const QString& forTag) const {
    const double w = width() / kCount;
    const double at = isRightToLeft(forTag) ? (kCount - 1 - index) * w : index * w;
    return textBox(systemText(scene().texts(), kFigures[index], forTag),
                   QRectF(at + 6, num("fontSize") * 2.4, w - 12, num("fontSize") * 2.6), num("fontSize") * 0.85,
                   TextAlign::Center, "statistics", false, forTag);
}

QString AlarmStatisticsView::textOf(const QString& id) const {
    const AlarmBook* book = scene().alarms();
    const int index = book ? book->indexOf(id) : -1;
    if (index < 0) return id;
    AlarmEntry entry;
    entry.text = book->definitions()[static_cast<size_t>(index)].text;
    return AlarmBook::render(entry, scene().texts(), tag());
}

void AlarmStatisticsView::draw(QPainter& painter) {
    painter.setPen(QPen(theme().color("line"), theme().kind() == PanelThemeKind::Contrast ? 2 : 1));
    painter.setBrush(theme().color("inset"));
    painter.drawRect(box().adjusted(0.5, 0.5, -0.5, -0.5));
    const double size = num("fontSize");
    for (int i = 0; i < kCount; ++i) {
        TextBox above = label(i, tag());
        above.rect = QRectF(above.rect.left(), 4, above.rect.width(), size * 2.4);
        above.text = figure(i);
        above.font = font(size * 1.7, true);
        // More than a person can follow (ISA-18.2: a flood, or what is standing for a day) is not grey.
        const bool isMuch = i == 0 ? m_found.perHour > 12 : figure(i) != locale().toString(0);
        painter.setPen(theme().color(isMuch && !isDesigning() ? "high" : "text"));
        drawText(painter, above);
        painter.setPen(theme().color("muted"));
        drawText(painter, label(i, tag()));
    }
    double top = size * 5.2;
    painter.setPen(QPen(theme().color("faint"), 1));
    painter.drawLine(QPointF(8, top), QPointF(width() - 8, top));
    const int most = m_found.mostFrequent.empty() ? 1 : std::max(1, m_found.mostFrequent.front().count);
    for (const AlarmCount& one : m_found.mostFrequent) {
        if (top + rowHeight() > height()) break;
        const bool rtl = isRightToLeft(tag());
        const double number = size * 3.4, share = (width() - 16) * one.count / most;
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme().color("surface"));
        painter.drawRect(QRectF(rtl ? width() - 8 - share : 8, top + 2, share, rowHeight() - 4));
        painter.setPen(theme().color("text"));
        const QRectF words(rtl ? 8 + number : 12, top, width() - number - 20, rowHeight()),
            count(rtl ? 8 : width() - number - 8, top, number - 6, rowHeight());
        drawText(painter, textBox(textOf(one.alarm), words, size, TextAlign::Start, ""));
        drawText(painter, textBox(locale().toString(one.count), count, size, TextAlign::End, ""));
        top += rowHeight();
    }
}

void AlarmStatisticsView::collectTexts(const QString& forTag, std::vector<TextBox>& out) const {
    for (int i = 0; i < kCount; ++i) out.push_back(label(i, forTag));
}

} // namespace plc::hmi
