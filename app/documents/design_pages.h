// The pages on which panels, texts, alarms, recipes and users are edited: opened, asked about before they close, saved.
// What cannot be read opens as text. Owned by the main window; GUI thread.
#pragma once
#include "app/pages/editor_tabs.h"
#include "app/panels/design_findings.h"
#include "app/panels/live_views.h"
#include "app/panels/panel_files.h"
#include "editor/workspace/workspace.h"

#include <QObject>

#include <functional>

namespace plc::app {

class DesignPages : public QObject {
    Q_OBJECT
public:
    using Key = PanelFiles::Key; // "panel:overview", "texts", "alarms", "recipes", "people"

    struct Parts {
        QWidget& window; // of questions
        editor::Workspace& workspace;
        EditorTabs& tabs;
        LiveViews& live;
        PanelFiles& files;
        DesignFindings& findings;
    };
    DesignPages(Parts parts, QObject* parent);

    /// A page that works on the panels and what belongs to them.
    [[nodiscard]] static bool isKey(const Key& key);
    void open(const Key& key);
    void openPanel(const QString& panel) { open("panel:" + panel); }
    void openTexts() { open("texts"); }
    void openAlarms() { open("alarms"); }
    void openRecipes() { open("recipes"); }
    void openPeople() { open("people"); }
    /// The dialog of the project's themes, at that one; as text where it cannot be read.
    void editThemes(const QString& theme = {});
    /// The place of a finding: an element of a panel, or one of the other files that belong to panels.
    void openPlace(const QString& file, const QString& element);
    /// Asks for a name and opens the new panel.
    void newPanel();

    /// All of them; false when one wants to stay.
    bool closeAll();
    /// Without a question: the panels are read again.
    void drop();
    /// Asks for what the page has not saved; false: it stays.
    bool mayClose(QWidget* page);
    /// Closes every page, of programs too, and asks for what is unsaved without a page; false keeps the project.
    bool mayLeave();
    /// What is in front, a program too.
    void save();
    void saveAll();

signals:
    void message(const QString& text, bool isError = false);
    void littleRoom(); // a panel was opened where hardly anything of it can be seen

private:
    bool mayForget(const Key& key);
    bool asksToSave(const QString& title, const std::function<Result<void>()>& save,
                    const std::function<void()>& discard);
    /// The file is there, and what it holds could not be understood.
    [[nodiscard]] bool isUnread(const Key& key) const;
    void addPage(QWidget* page, const QString& title, kit::Icon icon, const Key& key);
    void addDesigner(const Key& key);
    void openAsText(const Key& key);
    void report(const Result<void>& result);
    /// Languages that were added in the texts, to project.json.
    void saveLanguages();

    Parts m_parts;
};

} // namespace plc::app
