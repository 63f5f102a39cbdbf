// Plays panels on a controller: values from the newest snapshot, writes posted to the scan, keypad, language, alarms,
// and what the controller's state means for what is seen. A widget for a dock or full screen, also used for pictures.
// The project and the session must outlive it; main thread.
#pragma once
#include "editor/kit/ask_why.h"
#include "hmi/player/alarm_evaluator.h"
#include "hmi/player/panel_project.h"
#include "hmi/player/plc_values.h"
#include "hmi/view/panel_view.h"

#include <QPointer>
#include <QWidget>

namespace plc::hmi {

class Overlay;
class PanelWhy;
class PlayerStatus;

class PanelPlayer final : public QWidget {
    Q_OBJECT
public:
    PanelPlayer(const PanelProject& project, session::Session* session, QWidget* parent = nullptr);
    ~PanelPlayer() override;

    bool showPanel(const QString& name);
    QString panelName() const { return m_panelName; }
    /// The panel that is edited, while the designer shows it live.
    void showPanel(const QString& name, const Panel& panel);
    void follow(const Panel& panel, const Touched& touched);
    /// Texts, languages or alarms of the project changed.
    void projectChanged();
    void setLanguage(const QString& tag);
    QString language() const { return m_view->scene().language(); }
    /// Another controller (after a new build), or none.
    void setSession(session::Session* session);
    session::Session* session() const { return m_session; }
    /// The time slider: a recorded position, or none for the present.
    void setPosition(std::optional<history::Position> position);
    /// A recording from a file in the place of the controller, as its past: nothing can be written. None goes back.
    void setRecording(std::optional<PanelRecording> recording);
    void setFullScreen(bool full);
    /// Keeps the alarm history in this file from now on; without it, in memory.
    Result<void> keepAlarmsIn(const QString& path) { return m_alarms.openStore(path); }
    /// The same in `.stepwise` of the project's folder, where the studio and `stepwise panel --play` both look.
    Result<void> keepAlarmsInProject();

    PanelView& view() { return *m_view; }
    PanelScene& scene() { return m_view->scene(); }
    AlarmBook& alarms() { return m_recording ? m_recordedAlarms : m_alarms; } // as the lists show them
    AlarmWatch* alarmWatch() { return m_watch.get(); }
    PlcValues* values() { return m_values.get(); }
    /// One frame now: values, language variable, state, refusals, repaint.
    void frame();
    Overlay* overlay() const;
    /// The history of the controller's alarms and its place, whatever is shown.
    AlarmBook& liveAlarms() { return m_alarms; }
    QString lastRefusal() const { return m_refusal; }

    /// Answers over the panel, in its language, where nobody else is asked.
    void askWhy(kit::AskWhy question, const QString& expression);
    [[nodiscard]] PanelWhy* answer() const; // null: none is shown
    /// Posts a write as a press on the panel would; the answer says why it was refused, or nothing.
    QString post(const WriteRequest& write);

signals:
    void languageChanged(const QString& tag);
    void panelChanged(const QString& name);
    void writeRefused(const QString& reason);
    /// Of an expression that an element shows or writes.
    void whyRequested(plc::kit::AskWhy question, const QString& expression);

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void connectScene();
    void requestLanguage(const QString& tag);
    void followLanguageVariable();
    void updateStatus();
    void placeView(); // below the strip that tells the state: it covers nothing
    void evaluateRecorded();
    QString whyNot(const ValueFacts& facts, const Value& value, const QString& reason) const;
    void refuse(const QString& reason);
    struct Look;
    const PanelProject& m_project;
    session::Session* m_session;
    std::string m_alarmFile; // what the watch was made of
    std::unique_ptr<PlcValues> m_values;
    AlarmBook m_alarms;
    std::unique_ptr<AlarmWatch> m_watch;
    void closeAnswer();
    QPointer<PanelWhy> m_why;
    std::optional<PanelRecording> m_recording;
    AlarmBook m_recordedAlarms; // those of the recording
    std::unique_ptr<AlarmEvaluator> m_recordedEvaluator;
    PanelView* m_view;
    PlayerStatus* m_status;
    QTimer m_timer;
    QString m_panelName, m_refusal;
    BindingId m_languageBinding;
    Value m_languageValue;
    QString m_languageAsked;
    QMap<QString, Value> m_pressed; // momentary buttons that are down: target → value to release to
    QElapsedTimer m_refusalAge;
    bool m_isInDock = false; // while it fills the screen: comes back into its place
};

} // namespace plc::hmi
