// What the parts of the designer share: the project's operator side, the checked program, completion, the language that
// is shown. It also gives typed texts their keys. Owned by the application; main thread.
#pragma once
#include "editor/kit/inputs/expression_edit.h"
#include "editor/kit/inputs/variable_picker.h"
#include "hmi/model/document.h"
#include "hmi/player/panel_commands.h"
#include "hmi/station/plc_values.h"

#include <QObject>

#include <functional>
#include <map>
#include <set>

namespace plc::hmi {

class DesignContext final : public QObject {
    Q_OBJECT
public:
    explicit DesignContext(PanelProject& project, QObject* parent = nullptr);

    PanelProject& project() { return m_project; }
    const PanelProject& project() const { return m_project; }
    const driver::Checked& checked() const { return m_checked; }
    /// After each build; findings and facts follow.
    void setChecked(driver::Checked checked);
    session::Run* run() const { return m_run; }
    void setRun(session::Run* run);
    /// What previews show: the controller now or at a recorded scan, or a recording from a file in its place.
    void setRecording(std::shared_ptr<const session::Run> recording);
    void setPosition(std::optional<history::Position> position);
    const std::shared_ptr<const session::Run>& recording() const { return m_recording; }
    const std::optional<history::Position>& position() const { return m_position; }
    void setCompletions(kit::CompletionSource completions) { m_completions = std::move(completions); }
    const kit::CompletionSource& completions() const { return m_completions; }
    /// The variables to choose from and to drag onto a panel; asked again each time, the object must stay.
    using Variables = std::function<const kit::VariableProvider&()>;
    void setVariables(Variables variables) { m_variables = std::move(variables); }
    const Variables& variables() const { return m_variables; }
    void setPicker(std::function<std::optional<QString>(const QString&)> picker) { m_picker = std::move(picker); }
    const std::function<std::optional<QString>(const QString&)>& picker() const { return m_picker; }

    const QString& language() const { return m_language; }
    void setLanguage(const QString& tag);

    // Texts
    QString shownText(const QString& reference) const;
    /// What a typed text is stored as: the key it has, a new key, or (beginning with @) the key that was typed. Changes
    /// of the table are pushed on `undo`, inside the macro that the caller has begun.
    QString storeText(const QString& present, const QString& typed, const QString& panel, QUndoStack& undo);
    void setTable(TextTable table);
    void setAlarms(AlarmFile alarms);
    void setRecipes(RecipeFile recipes);
    void setPeople(PeopleFile people);
    bool areRecipesChanged() const { return m_recipesChanged; }
    bool arePeopleChanged() const { return m_peopleChanged; }
    bool areTextsChanged() const { return m_textsChanged; }
    bool areAlarmsChanged() const { return m_alarmsChanged; }
    /// Writes texts, alarms, recipes, people and closed panels where they changed.
    Result<void> save();
    Result<void> savePanel(const QString& name);
    /// Another panel in the place of the one of that name, not saved yet.
    void setPanel(const QString& name, const Panel& panel);
    /// What another program has written takes the place of what is here; undo of what was here ends.
    void panelReplaced(const QString& name);
    void textsReplaced();
    void alarmsReplaced();
    void recipesReplaced();
    void peopleReplaced();
    /// The folder of the themes is read again.
    void themesReplaced();
    /// The panels that are shown in the project's theme of that name, or have a button that changes to it.
    QStringList panelsWithTheme(const QString& name) const;
    /// Themes have new names (before, after): the panels that name them follow.
    void renameThemes(const std::map<QString, QString>& names);
    /// It has changes that are not saved.
    bool isPanelChanged(const QString& name) const;

    /// An edit in every panel: as an undo step in those that are open, directly in the others. True if any changed.
    bool rewritePanels(const QString& title, const std::function<Edit(const Panel&)>& edit);
    /// A place in a panel that names a recipe or roles.
    struct NameInPanel {
        QString panel;
        ElementId element;
        std::string key; // of the property
        QString before, after;
    };
    using NamesInPanels = std::vector<NameInPanel>;
    /// Where elements of all panels have a text under that key that `renamed` makes another.
    NamesInPanels namesToRename(std::string_view key, const std::function<QString(const QString&)>& renamed) const;
    /// A step of an editor of recipes or people, and the panels' names that follow in it. Whoever pushes it owns it.
    QUndoCommand* newEdit(const QString& title, std::function<void()> forward, std::function<void()> back,
                          const NamesInPanels& names);
    /// Where panels and alarms name a variable.
    struct VariableUse {
        QString file; // "hmi/main.panel.json"
        ElementId element;
        QString property, expression;
        bool isWrite = false;
    };
    /// How panels, alarms and recipes name a variable of the code: by its path from the top, or as a member behind the
    /// paths of instances and of parameters of faceplates.
    struct NamedVariable {
        QString path;                               // "Main.start"; empty: it has none
        QString name;                               // "speed"
        std::map<QString, std::set<QString>> bases; // by panel, "" of alarms and recipes: "Main.m1", "$motor"
    };
    /// `owner`: the block, structure or program that declares it; `elsewhere`: expressions beside those of panels,
    /// alarms and recipes, which renamed() is asked about. Asks the program that is checked now.
    NamedVariable namedVariable(const QString& path, const QString& owner, const QString& name,
                                const QStringList& elsewhere = {}) const;
    /// An expression from elsewhere with the new name of the variable.
    static QString renamed(const NamedVariable& variable, const QString& newName, const QString& expression);
    /// It was renamed in the code, and everything that names it follows. True if anything did.
    bool rename(const NamedVariable& variable, const QString& newName);
    std::vector<VariableUse> usesOf(const NamedVariable& variable) const;
    void openDocument(const QString& panel, PanelDocument* document);
    void closeDocument(const PanelDocument* document);
    /// With what is edited in an open designer; null: there is none of that name.
    const Panel* panelNow(const QString& name) const;
    /// A panel is another now: those who place it as a faceplate show it.
    void reportPanelEdited(const QString& name) { emit panelEdited(name); }

    /// Facts of a variable in the checked program; nothing when it is unknown.
    std::optional<ValueFacts> factsOf(const QString& path) const;
    /// The path of the variable that a word means: a path itself, else what one program or list of globals calls so.
    std::optional<QString> variableNamed(const QString& words) const;
    QString checkBinding(const QString& expression, std::string_view wanted, bool isTarget) const;
    CheckInput checkInput() const;
    /// Panels, alarms and elements that use a key: "main: button1.text".
    QStringList usersOf(const QString& key) const;

signals:
    void textsChanged();
    void alarmsChanged();
    void recipesChanged();
    void peopleChanged();
    void recipesTaken(); // from disk
    void peopleTaken();  // from disk
    void textsTaken();   // from disk
    void alarmsTaken();  // from disk
    void themesTaken();  // from disk
    void saved();
    void languageChanged();
    void programChanged();
    void panelEdited(const QString& name);
    void recordingChanged();
    void positionChanged();

private:
    /// An expression of a panel, or of alarms and recipes where that is empty, as it is after a rename.
    using Renamed = std::function<QString(const QString& panel, const QString& expression)>;
    static Renamed renamer(const NamedVariable& variable, const QString& newPath, const QString& newName);
    bool renameExpressions(const QString& title, const Renamed& renamed);
    std::vector<VariableUse> expressionsThat(const Renamed& renames) const;
    QStringList typesOfBase(const NamedPanel* panel, const QString& base) const;
    enum class Names { Before, After };
    /// Puts them in: as an undo step in panels that are open. Places that have gone are left out.
    void putNames(const QString& title, const NamesInPanels& names, Names which);
    /// With what is edited in an open designer.
    const Panel& latest(const NamedPanel& panel) const;
    void rewritePanel(NamedPanel& panel, const QString& title, const Edit& change);
    PanelProject& m_project;
    driver::Checked m_checked;
    session::Run* m_run = nullptr;
    std::shared_ptr<const session::Run> m_recording;
    std::optional<history::Position> m_position;
    kit::CompletionSource m_completions;
    Variables m_variables;
    std::function<std::optional<QString>(const QString&)> m_picker;
    QString m_language;
    bool m_textsChanged = false, m_alarmsChanged = false, m_recipesChanged = false, m_peopleChanged = false;
    QMap<QString, PanelDocument*> m_documents; // of open designers
    QStringList m_changedPanels;               // closed panels that a rename has touched
};

} // namespace plc::hmi
