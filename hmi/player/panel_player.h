// Plays panels on a controller: values from the newest snapshot, writes posted to the scan, keypad, language, alarms,
// and what the controller's state means for what is seen. A widget for a dock or full screen, also used for pictures.
// The project and the run must outlive it; main thread.
#pragma once
#include "editor/kit/ask_why.h"
#include "hmi/people/audit_trail.h"
#include "hmi/people/log_in.h"
#include "hmi/player/alarm_evaluator.h"
#include "hmi/player/navigation.h"
#include "hmi/player/panel_project.h"
#include "hmi/player/plc_values.h"
#include "hmi/view/panel_view.h"

#include <QPointer>
#include <QWidget>

namespace plc::hmi {

class Overlay;
struct OverlayLook;
enum class AlarmAction;
class PanelWhy;
class PlayerStatus;
class PopUp;

class PanelPlayer final : public QWidget {
    Q_OBJECT
public:
    PanelPlayer(const PanelProject& project, session::Run* run, QWidget* parent = nullptr);
    ~PanelPlayer() override;

    bool showPanel(const QString& name);
    QString panelName() const { return m_panelName; }
    const PanelPlace& place() const { return m_navigation.current(); }
    /// Where the operator is: the way back, pop-ups.
    Navigation& navigation() { return m_navigation; }
    /// The panels over the present one, the last on top.
    std::vector<PopUp*> popUps() const;
    /// The recipes as they are edited here; saved after each change.
    const RecipeFile& recipes() const { return m_recipes; }
    // People: who operates, and the trail of what they did.
    const LogIn& people() const { return m_logIn; }
    LogIn::Answer logIn(const QString& user, const QString& password);
    void logOut(const QString& why = {});
    /// Who checks passwords in the place of this player: a server, which counts wrong ones of all its browsers.
    using Door = std::function<LogIn::Answer(const QString& user, const QString& password)>;
    void setDoor(Door door) { m_door = std::move(door); }
    /// Somebody operates it, by whatever way: the time until the user is logged out begins again.
    void touch() { m_logIn.touched(std::chrono::steady_clock::now()); }
    /// Goes on with the audit trail in this file.
    Result<void> keepAuditIn(const QString& path) { return m_audit.open(path); }

    /// The panel that is edited, while the designer shows it live.
    void showPanel(const QString& name, const Panel& panel);
    void follow(const Panel& panel, const Touched& touched);
    /// What parameters of the panels shown from now on stand for; the rest have their defaults.
    void setArguments(Arguments arguments) { m_arguments = std::move(arguments); }
    /// Texts, languages or alarms of the project changed.
    void projectChanged();
    void setLanguage(const QString& tag);
    /// Another theme than the panels' own; empty: theirs.
    void setTheme(const QString& name);
    void setReducedMotion(bool reduced);
    QString language() const { return m_view->scene().language(); }
    /// Another controller (after a new build), or none.
    void setRun(session::Run* run);
    session::Run* run() const { return m_run; }
    /// The time slider: a recorded position, or none for the present.
    void setPosition(std::optional<history::Position> position);
    /// A recording from a file in the place of the controller, as its past: nothing can be written. None goes back.
    void setRecording(std::shared_ptr<const session::Run> recording);
    void setFullScreen(bool full);
    /// Shows everything, writes nothing and says that one must log in first (browsers before their login).
    void setLocked(bool locked) { m_isLocked = locked; }
    bool isLocked() const { return m_isLocked; }
    /// Neither follows nor writes the program's language variable: one of several people with a language each.
    void setOwnLanguage(bool own) { m_hasOwnLanguage = own; }
    /// What the strip over the panel says of the controller; empty: all is well.
    QString stateText() const;
    /// Keeps the alarm history in this file from now on; without it, in memory.
    Result<void> keepAlarmsIn(const QString& path) { return m_alarms.openStore(path); }
    /// The same in `.stepwise` of the project's folder, where the studio and `stepwise panel --play` both look.
    Result<void> keepAlarmsInProject();
    static QString alarmStoreOf(const PanelProject& project);
    /// The language that the operator chose last, also in a later run.
    void keepLanguageInProject();

    PanelView& view() { return *m_view; }
    PanelScene& scene() { return m_view->scene(); }
    AlarmBook& alarms() { return m_recording ? m_recordedAlarms : liveAlarms(); } // as the lists show them
    AlarmWatch* alarmWatch() { return m_station ? m_station->alarmWatch() : m_watch.get(); }
    /// Shows and acknowledges the alarms that another player of the same controller keeps; it must outlive this one.
    void shareAlarms(PanelPlayer& station);
    const PanelScene& scene() const { return m_view->scene(); }
    PlcValues* values() { return m_values.get(); }
    /// Frames come from the owner alone, not from a timer.
    void setStepped() { m_timer.stop(); }
    /// One frame now: values, language variable, state, refusals, repaint.
    void frame();
    Overlay* overlay() const;
    /// The history of the controller's alarms and its place, whatever is shown.
    AlarmBook& liveAlarms() { return m_station ? m_station->liveAlarms() : m_alarms; }
    QString lastRefusal() const { return m_refusal; }

    /// Answers over the panel, in its language, where nobody else is asked.
    void askWhy(kit::AskWhy question, const QString& expression);
    [[nodiscard]] PanelWhy* answer() const; // null: none is shown
    /// Posts a write as a press on the panel would; the answer says why it was refused, or nothing.
    QString post(const WriteRequest& write, const QString& comment = {});

signals:
    void languageChanged(const QString& tag);
    void themeChanged(const QString& name);
    void panelChanged(const QString& name);
    void writeRefused(const QString& reason);
    /// Logged in or out; empty: nobody is.
    void userChanged(const QString& name);
    /// Changed and saved by the operator: recipes().
    void recipesSaved();
    /// Of an expression that an element shows or writes.
    void whyRequested(plc::kit::AskWhy question, const QString& expression);

protected:
    void contextMenuEvent(QContextMenuEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void connectScene(PanelScene& scene);
    OverlayLook look();
    void showCurrent();
    QString onThisScreen(const QString& panel) const;
    void syncPopUps();
    /// A write that a person has asked for: questions first where the element is critical.
    void submit(const WriteRequest& write);
    void confirm(const ConfirmRequest& request);
    void confirmed(const WriteRequest& write, const QString& comment);
    void askForSignature(const WriteRequest& write);
    void answerAccess(const AccessRequest& request);
    void answerAlarm(const AlarmDetailRequest& request);
    void act(AlarmAction action, const QString& alarm);
    void answerRecipe(const RecipeRequest& request, PanelScene& scene);
    void chooseSet(const RecipeRequest& request, PanelScene& scene);
    void editValue(const RecipeRequest& request);
    void writeSet(const RecipeRequest& request);
    void readSet(const RecipeRequest& request);
    void changeSets(const RecipeRequest& request, PanelScene& scene);
    /// Saves; a change that cannot be saved is taken back.
    bool keepRecipes(RecipeFile changed);
    void askForPassword(const QString& user);
    void watchPeople();
    void showUser();
    QString passwordRefusal(LogIn::Answer answer) const;
    QString titlesOf(const QString& roles) const;
    const ElementView* viewOf(const ElementId& element, const PanelScene** scene = nullptr) const;
    void record(const QString& action, const QString& what, const QString& from, const QString& to,
                const QString& place, const QString& comment = {});
    void requestLanguage(const QString& tag);
    void rememberLanguage(const QString& tag) const;
    bool m_remembersLanguage = false;
    void followLanguageVariable();
    void updateStatus();
    void placeView(); // below the strip that tells the state: it covers nothing
    void evaluateRecorded();
    QString whyNot(const ValueFacts& facts, const Value& value, const QString& reason) const;
    void refuse(const QString& reason);
    bool refusesLocked();
    Arguments argumentsFor(const Panel& panel) const;
    std::string shownState() const;
    struct Look;
    const PanelProject& m_project;
    session::Run* m_run;
    Navigation m_navigation;
    LogIn m_logIn;
    AuditTrail m_audit;
    Door m_door;
    RecipeFile m_recipes;
    Arguments m_arguments;
    bool m_isPortrait = false, m_showsFrame = false;
    std::string m_shown;
    std::string m_alarmFile; // what the watch was made of
    std::unique_ptr<PlcValues> m_values;
    AlarmBook m_alarms;
    std::unique_ptr<AlarmWatch> m_watch;
    void closeAnswer();
    QPointer<PanelWhy> m_why;
    std::shared_ptr<const session::Run> m_recording;
    AlarmBook m_recordedAlarms; // those of the recording
    std::unique_ptr<AlarmEvaluator> m_recordedEvaluator;
    PanelPlayer* m_station = nullptr; // keeps the alarms; null: this one does
    PanelView* m_view;
    PlayerStatus* m_status;
    QTimer m_timer;
    QString m_panelName, m_refusal;
    BindingId m_languageBinding;
    Value m_languageValue;
    QString m_languageAsked;
    QMap<QString, Value> m_pressed; // momentary buttons that are down: target → value to release to
    QElapsedTimer m_refusalAge;
    bool m_isLocked = false, m_hasOwnLanguage = false;
    bool m_isInDock = false; // while it fills the screen: comes back into its place
};

} // namespace plc::hmi
