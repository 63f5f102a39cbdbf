// Plays panels on a controller: draws what an operator station holds, with keypad, questions and pop-ups over it. A
// widget for a dock or full screen, also used for pictures. The project and the run must outlive it; main thread.
#pragma once
#include "editor/kit/ask_why.h"
#include "hmi/station/operator_station.h"
#include "hmi/view/panel_view.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

namespace plc::hmi {

class Overlay;
struct OverlayLook;
class PanelWhy;
class PlayerStatus;
class PopUp;

class PanelPlayer final : public QWidget {
    Q_OBJECT
public:
    PanelPlayer(const PanelProject& project, session::Run* run, QWidget* parent = nullptr);
    ~PanelPlayer() override;

    /// Who operates here, where, in which language, and all that they do: nothing of it needs a widget.
    OperatorStation& station() { return m_station; }
    const OperatorStation& station() const { return m_station; }

    bool showPanel(const QString& name);
    QString panelName() const { return m_station.panelName(); }
    const PanelPlace& place() const { return m_station.navigation().current(); }
    Navigation& navigation() { return m_station.navigation(); }
    /// The panels over the present one, the last on top.
    std::vector<PopUp*> popUps() const;
    const RecipeFile& recipes() const { return m_station.recipes(); }
    const LogIn& people() const { return m_station.people(); }
    LogIn::Answer logIn(const QString& user, const QString& password);
    void logOut() { m_station.logOut(); }
    Result<void> keepAuditIn(const QString& path) { return m_station.keepAuditIn(path); }

    /// The panel that is edited, while the designer shows it live.
    void showPanel(const QString& name, const Panel& panel);
    void follow(const Panel& panel, const Touched& touched);
    /// What parameters of the panels shown from now on stand for; the rest have their defaults.
    void setArguments(Arguments arguments) { m_arguments = std::move(arguments); }
    /// Texts, languages or alarms of the project changed.
    void projectChanged();
    void setLanguage(const QString& tag) { m_station.setLanguage(tag); }
    /// Another theme than the panels' own; empty: theirs.
    void setTheme(const QString& name);
    void setReducedMotion(bool reduced);
    QString language() const { return m_station.language(); }
    void setRun(session::Run* run) { m_station.setRun(run); }
    session::Run* run() const { return m_station.run(); }
    void setPosition(std::optional<history::Position> position);
    void setRecording(std::shared_ptr<const session::Run> recording);
    void setFullScreen(bool full);
    /// What the strip over the panel says of the controller; empty: all is well.
    QString stateText() const;
    /// The alarm history in `.stepwise` of the project's folder, where the studio and `stepwise panel --play` both
    /// look.
    Result<void> keepAlarmsInProject() { return m_station.keepAlarmsInProject(); }
    Result<void> keepAlarmsIn(const QString& path) { return m_station.keepAlarmsIn(path); }
    void keepLanguageInProject(const QString& instead = {}) { m_station.keepLanguageInProject(instead); }

    PanelView& view() { return *m_view; }
    PanelScene& scene() { return m_view->scene(); }
    const PanelScene& scene() const { return m_view->scene(); }
    AlarmBook& alarms() { return m_station.alarms(); }
    AlarmBook& liveAlarms() { return m_station.liveAlarms(); }
    AlarmWatch* alarmWatch() { return m_station.alarmWatch(); }
    PlcValues* values() { return m_station.values(); }
    /// Frames come from the owner alone, not from a timer.
    void setStepped() { m_timer.stop(); }
    /// One frame now: values, language variable, state, refusals, repaint.
    void frame();
    Overlay* overlay() const;
    QString lastRefusal() const { return m_station.refusal(); }

    /// Answers over the panel, in its language, where nobody else is asked.
    void askWhy(kit::AskWhy question, const QString& expression);
    [[nodiscard]] PanelWhy* answer() const; // null: none is shown
    /// Posts a write as a press on the panel would; the answer says why it was refused, or nothing.
    QString post(const WriteRequest& write) { return m_station.post(write); }

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
    void connectStation();
    void connectScene(PanelScene& scene);
    /// Runs `act` on the panel and on what is open over it.
    void onEachScene(const std::function<void(PanelScene&)>& act);
    void setUpScene(PanelScene& scene);
    OverlayLook look();
    void showCurrent();
    void syncPopUps();
    void showSources();
    void showLanguage();
    void showUser(const QString& name);
    void releasePress();
    /// A write that a person has asked for: questions first where the element is critical.
    void submit(const WriteRequest& write);
    void confirm(const ConfirmRequest& request);
    void askForSignature(const WriteRequest& write);
    void answerAccess(const AccessRequest& request);
    void answerAlarm(const AlarmDetailRequest& request);
    void answerRecipe(const RecipeRequest& request, PanelScene& scene);
    void chooseSet(const RecipeRequest& request, PanelScene& scene);
    void editValue(const RecipeRequest& request);
    void readSet(const RecipeRequest& request);
    void changeSets(const RecipeRequest& request, PanelScene& scene);
    void askForPassword(const QString& user);
    void watchTouches();
    QString refusedRoles(const ElementId& element) const;
    const ElementView* viewOf(const ElementId& element, const PanelScene** scene = nullptr) const;
    void updateStatus();
    void placeView(); // below the strip that tells the state: it covers nothing
    Arguments argumentsFor(const Panel& panel) const;
    std::string shownState() const;
    void closeAnswer();

    const PanelProject& m_project;
    OperatorStation m_station;
    Arguments m_arguments;
    bool m_isPortrait = false, m_showsFrame = false;
    std::string m_shown;
    QPointer<PanelWhy> m_why;
    PanelView* m_view = nullptr;
    PlayerStatus* m_status = nullptr;
    QTimer m_timer;
    bool m_isInDock = false; // while it fills the screen: comes back into its place
};

} // namespace plc::hmi
