// The view of what the alarm journal says: alarms per hour, floods, standing and chattering ones, the most frequent.
// Owned by the scene; main thread.
#pragma once
#include "hmi/alarms/statistics.h"
#include "hmi/view/scene/element_view.h"

namespace plc::hmi {

class AlarmStatisticsView final : public ElementView {
public:
    using ElementView::ElementView;
    void collectTexts(const QString& tag, std::vector<TextBox>& out) const override;
    const AlarmStatistics& statistics() const { return m_found; }

protected:
    void setUp() override;
    void draw(QPainter& painter) override;
    bool advance(qint64 milliseconds) override;

private:
    void read();
    QString figure(int index) const;
    TextBox label(int index, const QString& tag) const;
    QString textOf(const QString& alarm) const;
    double rowHeight() const { return num("fontSize") * 1.9; }
    AlarmStatistics m_found;
    qint64 m_nextRead = 0;
};

} // namespace plc::hmi
