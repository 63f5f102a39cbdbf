// The open documents: ST files with split view, find bar and declaration table, and whatever other pages the window
// adds (panels, charts, traces). Keeps editors and workspace in step. Owned by the main window; GUI thread.
#pragma once
#include "app/settings.h"
#include "app/st_page.h"
#include "editor/analysis/workspace.h"
#include "editor/debug/computed_scan.h"
#include "editor/debug/run_control.h"
#include "editor/text/st_editor.h"

#include <QTabWidget>

#include <deque>
#include <functional>
#include <map>
#include <set>

namespace plc::app {

class EditorTabs : public QTabWidget {
    Q_OBJECT
public:
    EditorTabs(editor::Workspace& workspace, editor::RunControl& control, Settings& settings,
               QWidget* parent = nullptr);

    StPage* openFile(const QString& file);
    /// A second file at the right of the one in front.
    void openBeside(const QString& file);
    void goTo(const QString& file, uint32_t offset, uint32_t length = 0);
    void goToLine(const QString& file, int line);
    /// Where the walk through a recorded scan stands; none: where the controller stands.
    void showWalk(std::optional<editor::RunControl::TextPlace> place);
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
    [[nodiscard]] QStringList openFiles() const;
    /// Of all open texts.
    [[nodiscard]] std::vector<editor::StEditor*> editors() const { return allEditors(); }
    void addPage(QWidget* page, const QString& title, const QIcon& icon, const QString& key);
    /// A page of another kind has something to save, or no more.
    void markPage(const QString& key, bool modified);
    [[nodiscard]] QWidget* pageByKey(const QString& key) const;
    bool closePage(int index);
    bool closeAll(); // asks for unsaved files; false = cancelled
    /// Asked before a page closes that is no ST file; false keeps it.
    void setMayClose(std::function<bool(QWidget*)> mayClose) { m_mayClose = std::move(mayClose); }
    void saveCurrent();
    void saveAll();
    void applySettings();
    /// Edits of several files at once (rename): open ones through their editor, the others in the workspace. One undo
    /// takes all of them back; what was done `alongside` in panels is told, too (true: back).
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
    [[nodiscard]] std::vector<editor::StEditor*> allEditors() const;
    void connectPage(StPage* page);
    void connectEditor(editor::StEditor* editor);
    void connectGraph(StPage* page, editor::GraphView* graph);
    void connectChart(StPage* page, editor::ChartView* chart);
    void connectLadder(StPage* page, editor::LadderView* ladder);
    void markModified(const QString& file, bool modified);
    bool saveAsking(const QString& file); // a read-only file is asked about
    bool saveModified();
    void makeWritable(const QString& file);
    void showBreakpoints();
    void showExecutedLine();
    void showInstance(StPage& page); // whose values its text shows
    void askForValue(const QString& name, const QString& pou, bool force);
    [[nodiscard]] QString pathOf(const QString& name, const QString& pou) const;
    void rememberPlace();
    void askAboutDiskChange(const QString& file);
    [[nodiscard]] editor::OnlineValues onlineValues();

    /// A change of several files that is taken back as one.
    struct Group {
        struct Texts {
            std::string before, after;
        };
        std::map<QString, Texts> texts;
        std::function<void(bool)> alongside;
        bool isUndone = false;
    };
    void remember(Group group);
    [[nodiscard]] Group* groupAt(bool undone);
    void swapGroup(Group& group);

    unsigned m_frames = 0;
    std::optional<editor::RunControl::TextPlace> m_walk;
    QString m_shownPlace; // where the controller stood when it was shown last
    std::deque<Group> m_groups;
    std::set<QString> m_asked; // about a change outside, the question still stands
    struct Visited {
        QString file;
        uint32_t offset = 0;
    };
    editor::Workspace& m_workspace;
    editor::RunControl& m_control;
    editor::ComputedScan* m_computed = nullptr;
    Settings& m_settings;
    std::deque<Visited> m_back, m_forward;
    bool m_isApplying = false;
    std::function<bool(QWidget*)> m_mayClose;
};

} // namespace plc::app
