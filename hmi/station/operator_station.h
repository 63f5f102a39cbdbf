// What an operator does on panels and what the controller answers, without any widget: who operates, where they are,
// the language, what is written and why it is refused, alarms, recipes, the trail. The Qt player and a browser's panel
// each own one and draw it. The project and the run must outlive it; main thread.
#pragma once
#include "hmi/people/audit_trail.h"
#include "hmi/people/log_in.h"
#include "hmi/station/alarm_evaluator.h"
#include "hmi/station/navigation.h"
#include "hmi/station/panel_project.h"
#include "hmi/station/plc_values.h"
#include "hmi/texts/system_texts.h"

namespace plc::hmi {

enum class AlarmAction { Acknowledge, Show, ShelveShort, ShelveLong, OutOfService, PutBack };

/// Quiet: nothing is wrong, nothing runs yet. Notice: values are real, not of now. Bad: those of a controller that does
/// not run.
enum class StateWeight { Quiet, Notice, Bad };

/// What is said of the controller over the panel; an empty text: all is well.
struct StationState {
    QString text;
    StateWeight weight = StateWeight::Notice;
};

class OperatorStation final : public QObject {
    Q_OBJECT
public:
    OperatorStation(const PanelProject& project, session::Run* run, QObject* parent = nullptr);
    ~OperatorStation() override;

    const PanelProject& project() const { return m_project; }
    /// A system text in the operator's language.
    QString say(SystemText text) const { return systemText(m_project.texts, text, m_language); }

    // Where the operator is.
    Navigation& navigation() { return m_navigation; }
    const Navigation& navigation() const { return m_navigation; }
    /// The panel that is in sight, for the trail; false: it was already.
    bool setPanelName(const QString& name);
    const QString& panelName() const { return m_panelName; }
    /// What a screen shows of the present place: the panel for its shape, and the frame around it.
    struct Shown {
        QString name;
        const Panel* panel = nullptr;
        const NamedPanel* frame = nullptr;
    };
    Shown shown(bool isPortrait) const;

    // The controller.
    /// Another controller (after a new build), or none.
    void setRun(session::Run* run);
    session::Run* run() const { return m_run; }
    /// A recording from a file in the place of the controller, as its past: nothing can be written. None goes back.
    void setRecording(std::shared_ptr<const session::Run> recording);
    bool isRecording() const { return m_recording != nullptr; }
    /// What is looked at: the recording, else the controller.
    const session::Run* shownRun() const { return m_recording ? m_recording.get() : m_run; }
    /// The time slider: a recorded position, or none for the present.
    void setPosition(std::optional<history::Position> position);
    /// The position that alarm lists show.
    std::optional<quint64> alarmPosition() const { return m_alarmPosition; }
    PlcValues* values() { return m_values.get(); }
    StationState state() const;
    /// New values, and what they and the time bring about: language, alarms, log-out, refusals that are over.
    void frame(Moment now);

    // Writing.
    /// The roles that an element is kept for and that refuse it to who operates; empty: it may be operated.
    using Rights = std::function<QString(const ElementId& element)>;
    void setRights(Rights rights) { m_rights = std::move(rights); }
    /// Posts a write as a press on the panel would; the answer says why it was refused, or nothing.
    QString post(const WriteRequest& write, const QString& comment = {});
    /// After a question was answered with yes: a momentary press is up again at once.
    void confirmed(const WriteRequest& write, const QString& comment);
    /// The password of who is logged in is the signature under a critical write.
    void sign(const WriteRequest& write, const QString& password, Moment now);
    QString questionFor(const ConfirmRequest& request) const;
    void refuse(const QString& reason);
    const QString& refusal() const { return m_refusal; }
    /// Shows everything, writes nothing and says that one must log in first (browsers before their login).
    void setLocked(bool locked) { m_isLocked = locked; }
    bool isLocked() const { return m_isLocked; }
    bool refusesLocked();

    // The language.
    const QString& language() const { return m_language; }
    void setLanguage(const QString& tag);
    /// By the operator: remembered, and written to the program's variable.
    void requestLanguage(const QString& tag);
    /// Neither follows nor writes the program's language variable: one of several people with a language each.
    void setOwnLanguage(bool own) { m_hasOwnLanguage = own; }
    /// The language that the operator chose last, also in a later run. `instead`: one to begin with this time.
    void keepLanguageInProject(const QString& instead = {});

    // People, and the trail of what they did.
    const LogIn& people() const { return m_logIn; }
    LogIn::Answer logIn(const QString& user, const QString& password, Moment now);
    void logOut(const QString& why = {});
    /// Who checks passwords in the place of this station: a server, which counts wrong ones of all its browsers.
    using Door = std::function<LogIn::Answer(const QString& user, const QString& password)>;
    void setDoor(Door door) { m_door = std::move(door); }
    /// Somebody operates it, by whatever way: the time until the user is logged out starts again.
    void touch(Moment now) { m_logIn.touched(now); }
    /// Who can log in here.
    QStringList users() const;
    /// Roles as the project titles them, in the operator's language.
    QString titlesOf(const QString& roles) const;
    /// Goes on with the audit trail in this file.
    Result<void> keepAuditIn(const QString& path) { return m_audit.open(path); }
    void record(const QString& action, const QString& what, const QString& from, const QString& to,
                const QString& place, const QString& comment = {});

    // Alarms.
    AlarmBook& alarms() { return m_recording ? m_recordedAlarms : liveAlarms(); } // as the lists show them
    /// The history of the controller's alarms and its place, whatever is shown.
    AlarmBook& liveAlarms() { return m_keeper ? m_keeper->liveAlarms() : m_alarms; }
    AlarmWatch* alarmWatch() { return m_keeper ? m_keeper->alarmWatch() : m_watch.get(); }
    /// Shows and acknowledges the alarms that another station of the same controller keeps; it must outlive this one.
    void shareAlarms(OperatorStation& keeper);
    Result<void> keepAlarmsIn(const QString& path) { return m_alarms.openStore(path); }
    Result<void> keepAlarmsInProject();
    static QString alarmStoreOf(const PanelProject& project);
    void acknowledge(const AcknowledgeRequest& request);
    /// Whether more of this alarm may be shown and done.
    bool mayAnswer(const AlarmDetailRequest& request);
    void act(AlarmAction action, const QString& alarm);

    // Recipes: a change is in the file before it is seen.
    const RecipeFile& recipes() const { return m_recipes; }
    /// The sets to choose from; none: there is no such recipe.
    std::optional<ChoiceRequest> setsOf(const RecipeRequest& request) const;
    /// What is typed for a value of a set; none: nothing can be typed.
    std::optional<EntryRequest> entryFor(const RecipeRequest& request);
    void enterValue(const RecipeRequest& request, const EntryRequest& asked, const Value& value);
    void writeSet(const RecipeRequest& request);
    void readSet(const RecipeRequest& request);
    /// Adds or removes a set; the answer is the set to show then, empty: nothing was changed.
    QString changeSets(const RecipeRequest& request);

    /// Texts, languages, people, recipes or alarms of the project changed.
    void projectChanged();

signals:
    /// values() is about to be another object: nobody may hold it on.
    void sourcesAboutToChange();
    void sourcesChanged();
    void languageChanged(const QString& tag);
    void writeRefused(const QString& reason);
    void refusalOver();
    /// Logged in or out; empty: nobody is.
    void userChanged(const QString& name);
    void recipesChanged();
    /// Changed and saved by the operator.
    void recipesSaved();

private:
    QString refusalBefore(const WriteRequest& write) const;
    QString whyNot(const ValueFacts& facts, const Value& value, const QString& reason) const;
    QString originOf(const QString& place) const;
    void bindLanguage();
    void followLanguageVariable();
    void rememberLanguage() const;
    void watchAlarms();
    void evaluateRecorded();
    QString passwordRefusal(LogIn::Answer answer) const;
    void openTrail();
    bool keepRecipes(RecipeFile changed);

    const PanelProject& m_project;
    session::Run* m_run = nullptr;
    std::shared_ptr<const session::Run> m_recording;
    Navigation m_navigation;
    QString m_panelName;
    LogIn m_logIn;
    Door m_door;
    Rights m_rights;
    AuditTrail m_audit;
    RecipeFile m_recipes;
    std::unique_ptr<PlcValues> m_values;
    std::string m_alarmFile; // what the watch was made of
    AlarmBook m_alarms;
    std::unique_ptr<AlarmWatch> m_watch;
    AlarmBook m_recordedAlarms; // those of the recording
    std::unique_ptr<AlarmEvaluator> m_recordedEvaluator;
    OperatorStation* m_keeper = nullptr; // keeps the alarms; null: this one does
    std::optional<quint64> m_alarmPosition;
    QString m_language, m_languageAsked;
    BindingId m_languageBinding;
    Value m_languageValue;
    QMap<QString, Value> m_pressed; // momentary buttons that are down: target → value to release to
    QString m_refusal;
    std::optional<Moment> m_refusedAt; // none: not seen by a frame yet
    bool m_isLocked = false, m_hasOwnLanguage = false, m_remembersLanguage = false;
};

} // namespace plc::hmi
