// Views of alarms: the list with acknowledgement and history, and the banner with the most urgent one.
#pragma once
#include "hmi/view/element_view.h"

namespace plc::hmi {

struct AlarmEntry;

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
    double rowHeight() const;
    double headHeight() const;
    double footHeight() const;
    QRectF acknowledgeAllArea() const;
    QRectF acknowledgeArea(int visibleRow) const;
    QRectF textArea(int visibleRow) const;
    void drawRow(QPainter& painter, const AlarmEntry& entry, int visibleRow);
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
