// The project's TESTs as a tree: passed or failed, how long each took, one or the failed ones run again, and from a
// failure to its line and its recording. Owned by its dock; GUI thread.
#pragma once
#include "app/testing/test_runner.h"

#include <QTreeWidget>
#include <QWidget>

#include <map>

class QAction;
class QLabel;

namespace plc::app {

class TestView : public QWidget {
    Q_OBJECT
public:
    TestView(editor::Workspace& workspace, TestRunner& runner, QWidget* parent = nullptr);
    [[nodiscard]] QTreeWidget& tree() { return *m_tree; }
    void runAll();
    void runFailed();
    void runSelected();
    /// "3 passed, 1 failed", as the last run of each says.
    [[nodiscard]] QString summary() const;

signals:
    void placeRequested(const QString& file, int line);
    void recordingRequested(const QString& path);

private:
    enum Column { Title, State, Time, Count };
    using Known = std::shared_ptr<const testing::TestResult>; // null: not run yet
    void reload();
    void take(const Known& result);
    void showResult(QTreeWidgetItem* item, const Known& result);
    void showMenu(const QPoint& position);
    void updateActions();
    [[nodiscard]] std::vector<std::string> failedTitles() const;

    editor::Workspace& m_workspace;
    TestRunner& m_runner;
    QTreeWidget* m_tree;
    QLabel* m_summary;
    QAction *m_runAll, *m_runSelected, *m_runFailed;
    std::map<std::string, Known> m_results; // by title
    std::map<std::string, QTreeWidgetItem*> m_items;
    QString m_shape; // of what the tree shows
};

} // namespace plc::app
