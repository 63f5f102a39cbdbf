// The open documents: ST files with split view, find bar and declaration table, and whatever other pages the window
// adds (panels, charts, traces). Keeps editors and workspace in step. Owned by the main window; GUI thread.
#pragma once
#include "app/pages/st_page.h"
#include "app/pages/visited_places.h"
#include "app/settings/settings.h"
#include "editor/debug/run_control.h"
#include "editor/text/st_editor.h"
#include "editor/workspace/workspace.h"

#include <QTabWidget>

#include <functional>
#include <map>
#include <memory>
#include <set>

namespace plc::app {

class FileChanges;
class GraphPages;
class OnlineMarks;

class EditorTabs : public QTabWidget {
    Q_OBJECT
public:
    EditorTabs(editor::Workspace& workspace, editor::RunControl& control, Settings& settings,
               QWidget* parent = nullptr);
    ~EditorTabs() override;

    StPage* openFile(const QString& file);
    /// A second file at the right of the one in front.
    void openBeside(const QString& file);
    void goTo(const QString& file, uint32_t offset, uint32_t length = 0);
    void goToLine(const QString& file, int line);
    [[nodiscard]] OnlineMarks& marks() { return *m_marks; }
    void showChart(const QString& file, const QString& unit);
    /// In the text in front: the next one, 1, or the one before, -1.
    void goToBookmark(int direction);
    void goBack();
    void goForward();
    [[nodiscard]] StPage* currentPage() const { return qobject_cast<StPage*>(currentWidget()); }
    /// The text in front: of the project, or of a library (read-only).
    [[nodiscard]] editor::StEditor* currentEditor() const { return currentPage() ? &currentPage()->active() : nullptr; }
    /// The text of a file of the project or of a library; null when there is none of that name.
    editor::StEditor* openSource(const QString& file);
    [[nodiscard]] StPage* pageOf(const QString& file) const;
    [[nodiscard]] std::vector<StPage*> pages() const; // with a text
    [[nodiscard]] QStringList openFiles() const;
    /// Of all open texts.
    [[nodiscard]] std::vector<editor::StEditor*> editors() const;
    void addPage(QWidget* page, const QString& title, const QIcon& icon, const QString& key);
    /// A page of another kind has something to save, or no more.
    void markPage(const QString& key, bool modified);
    [[nodiscard]] QWidget* pageByKey(const QString& key) const;
    bool closePage(int index);
    void closeOthers(int index); // as long as nobody cancels
    /// The tab in front, among the others.
    void moveCurrent(int by);
    bool closeAll(); // asks for unsaved files; false = cancelled
    /// Asked before a page closes that is no ST file; false keeps it.
    void setMayClose(std::function<bool(QWidget*)> mayClose) { m_mayClose = std::move(mayClose); }
    void saveCurrent();
    void saveAll();
    void applySettings();
    /// Edits of several files at once (rename): open ones through their editor, the others in the workspace. One undo
    /// takes all of them back; `alongside` changes the panels with them, forward (false) and back (true).
    void applyEdits(const std::map<QString, std::vector<diagnostics::TextEdit>>& edits,
                    std::function<void(bool)> alongside = {});
    void applyEdits(const std::vector<analysis::FileEdits>& edits, const SourceSet& sources);
    /// New texts of several files at once (replace in all files); undone together likewise.
    void applyTexts(const std::map<QString, std::string>& texts);
    void undo();
    void redo();

signals:
    void editorMade(plc::editor::StEditor* editor);
    void message(const QString& text, bool isError);
    void saved();
    void cursorMoved(const QString& file, int line, int column);
    /// A name was changed in the table of declarations.
    void renameRequested(const QString& file, uint32_t offset, const QString& name);

private:
    void connectPage(StPage* page);
    void connectEditor(editor::StEditor* editor);
    void markModified(const QString& file, bool modified);
    bool saveAsking(const QString& file); // a read-only file is asked about
    bool saveModified();
    void makeWritable(const QString& file);
    void rememberPlace();
    [[nodiscard]] std::optional<VisitedPlaces::Place> visitedNow() const;
    void askAboutDiskChange(const QString& file);

    std::set<QString> m_asked; // about a change outside, the question still stands
    editor::Workspace& m_workspace;
    editor::RunControl& m_control;
    Settings& m_settings;
    VisitedPlaces m_visited;
    std::unique_ptr<FileChanges> m_changes;
    OnlineMarks* m_marks;
    GraphPages* m_graphs;
    bool m_isApplying = false;
    std::function<bool(QWidget*)> m_mayClose;
};

} // namespace plc::app
