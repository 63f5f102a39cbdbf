// What the player does with one alarm: setting it aside and back, with the trail of who did it.
#include "hmi/player/panel_player.h"

#include "editor/kit/message_text.h"
#include "editor/kit/post.h"
#include "hmi/player/alarm_sheet.h"

namespace plc::hmi {

namespace {
constexpr int kShort = 30 * 60, kLong = 8 * 3600; // seconds
}

void PanelPlayer::answerAlarm(const AlarmDetailRequest& request) {
    if (m_recording || refusesLocked() || request.alarm >= liveAlarms().definitions().size()) return;
    auto* sheet = new AlarmSheet(liveAlarms(), request.alarm, look(), this);
    connect(sheet, &AlarmSheet::chosen, this, [this](AlarmAction action, const QString& alarm) {
        kit::post(this, [this, action, alarm] { act(action, alarm); });
    });
}

void PanelPlayer::act(AlarmAction action, const QString& alarm) {
    const int index = liveAlarms().indexOf(alarm);
    if (index < 0) return;
    const QString user = m_logIn.user();
    const QDateTime now = QDateTime::currentDateTimeUtc();
    const auto set = [&](const QString& name, const std::function<Result<void>(AlarmSuppression&)>& how) {
        if (const auto done = liveAlarms().change(how); !done) refuse(kit::messageText(done.error(), language()));
        record(name, alarm, {}, {}, m_panelName);
    };
    const auto shelve = [&](int seconds) {
        set(QStringLiteral("alarm shelved"),
            [&](AlarmSuppression& aside) { return aside.shelve(alarm, seconds, user, {}, now); });
    };
    switch (action) {
    case AlarmAction::Acknowledge:
        record(QStringLiteral("acknowledge"), alarm, {}, {}, m_panelName);
        if (AlarmWatch* const watch = alarmWatch()) watch->acknowledge(static_cast<size_t>(index), user);
        return;
    case AlarmAction::Show:
        m_navigation.open({liveAlarms().definitions()[static_cast<size_t>(index)].show, {}});
        return;
    case AlarmAction::ShelveShort:
        return shelve(kShort);
    case AlarmAction::ShelveLong:
        return shelve(kLong);
    case AlarmAction::OutOfService:
        return set(QStringLiteral("alarm out of service"),
                   [&](AlarmSuppression& aside) { return aside.takeOutOfService(alarm, user, {}, now); });
    case AlarmAction::PutBack:
        return set(QStringLiteral("alarm back"), [&](AlarmSuppression& aside) { return aside.putBack(alarm); });
    }
}

} // namespace plc::hmi
