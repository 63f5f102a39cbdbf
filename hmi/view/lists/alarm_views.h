// Views of alarms: the list with acknowledgement and history, and the banner with the most urgent one.
#pragma once
#include "hmi/view/scene/element_view.h"

namespace plc::hmi {

struct AlarmClass;
struct AlarmEntry;
enum class AlarmOrder;

class AlarmListView final : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return true; }
    void press(QPointF at) override;
    void move(QPointF at) override;
    void release(QPointF at, bool inside) override;
    void wheel(double steps) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override {}
    void draw(QPainter& painter) override;

private:
    std::vector<AlarmEntry> entries() const;
    QStringList classes() const;
    bool isHistory() const { return text("shows") == QStringLiteral("history"); }
    bool isAside() const { return text("shows") == QStringLiteral("aside"); }
    /// Keys to acknowledge, to sort and to filter by.
    bool hasKeys() const { return flag("buttons"); }
    AlarmOrder order() const;
    std::vector<const AlarmClass*> shownClasses() const;
    const AlarmClass* filteredClass() const;
    QString classTitle(const AlarmClass& one) const;
    QString filterText() const;
    QString stateText(const AlarmEntry& entry) const;
    QString historyText(const AlarmEntry& entry, const QString& state) const;
    double rowHeight() const;
    double headHeight() const;
    double timeWidth() const;
    double markWidth() const;
    QRectF mirrored(const QRectF& area) const;
    QRectF acknowledgeAllArea() const;
    QRectF filterArea() const;
    QRectF timeHead() const;
    QRectF alarmHead() const;
    QRectF acknowledgeArea(int visibleRow) const;
    QRectF textArea(int visibleRow) const;
    void drawRow(QPainter& painter, const AlarmEntry& entry, int visibleRow);
    void drawHead(QPainter& painter);
    void collectHead(const QString& tag, std::vector<TextBox>& out) const;
    std::optional<AlarmOrder> m_order; // once the operator has touched a heading
    int m_filter = 0;                  // 0 all, 1 not acknowledged, from 2 on the classes
    int m_top = 0, m_pressedTop = 0;
    QPointF m_pressedAt;
    bool m_scrolled = false;
};

class AlarmBannerView final : public ElementView {
public:
    using ElementView::ElementView;
    bool isInteractive() const override { return true; }
    void release(QPointF at, bool inside) override;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;

protected:
    void setUp() override {}
    void draw(QPainter& painter) override;

private:
    QStringList classes() const;
    QRectF textArea() const;
};

/// Time of a scan as lists show it: date and time of the controller's clock.
QString alarmTime(const AlarmEntry& entry, const QLocale& locale, qint64 clockAtZero);

} // namespace plc::hmi
