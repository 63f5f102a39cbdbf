// What can be done with one alarm: its help, the panel that shows its place, acknowledging, shelving, taking out of
// service, putting back. Over the player, which owns it; main thread.
#pragma once
#include "hmi/player/keypad.h"
#include "hmi/station/operator_station.h"

namespace plc::hmi {

class AlarmSheet final : public Overlay {
    Q_OBJECT
public:
    /// `canExplain`: the answer to "Why?" can be shown here.
    AlarmSheet(const AlarmBook& book, size_t alarm, const OverlayLook& look, bool canExplain, QWidget* parent);
    /// The key of an action, or null where it makes no sense for this alarm.
    QPushButton* keyOf(AlarmAction action) const { return m_keys.value(static_cast<int>(action)); }
    /// That of "Why?", or null.
    QPushButton* whyKey() const { return m_why; }

signals:
    void chosen(plc::hmi::AlarmAction action, const QString& alarm);
    void whyAsked(const QString& condition);

private:
    void addKey(AlarmAction action, const QString& text, QGridLayout* grid);
    void addWhy(const QString& condition, const QString& language, QGridLayout* grid);
    QString m_alarm;
    QMap<int, QPushButton*> m_keys;
    QPushButton* m_why = nullptr;
};

} // namespace plc::hmi
