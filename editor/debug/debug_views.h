// The smaller views on a running controller: forces, call path with each frame's values, breakpoints, tasks with
// histograms, and the log of events. Each is owned by its dock; GUI thread; all read through RunControl.
#pragma once
#include "editor/debug/run_control.h"

#include <QTreeWidget>
#include <QWidget>

class QAction;
class QLabel;
class QLineEdit;

namespace plc::editor {

class ForceView : public QWidget {
    Q_OBJECT
public:
    explicit ForceView(RunControl& control, QWidget* parent = nullptr);
    void refresh();

private:
    RunControl& m_control;
    QTreeWidget* m_tree;
};

class CallPathView : public QWidget {
    Q_OBJECT
public:
    explicit CallPathView(RunControl& control, QWidget* parent = nullptr);
    void refresh();

signals:
    void placeRequested(const QString& file, uint32_t offset);
    void instanceChosen(const QString& pou, const QString& instance); // of the frame

private:
    void showValues();
    /// The scan that is looked at ended in the fault whose call stack is at hand, or nothing but now is looked at.
    [[nodiscard]] bool showsItsMoment() const;
    [[nodiscard]] int frameOf(QTreeWidgetItem* item) const;

    RunControl& m_control;
    QTreeWidget* m_frames;
    QTreeWidget* m_values;
    QLabel* m_none;                    // why there is no call stack
    std::vector<SourceRange> m_ranges; // of the frames, in the program
    controller::State m_shownState = controller::State::Stopped;
};

class BreakpointView : public QWidget {
    Q_OBJECT
public:
    explicit BreakpointView(RunControl& control, QWidget* parent = nullptr);

signals:
    void lineRequested(const QString& file, int line);

private:
    void reload();
    void takeEdits(QTreeWidgetItem* item);

    RunControl& m_control;
    QTreeWidget* m_tree;
};

class TaskMonitor : public QWidget {
    Q_OBJECT
public:
    explicit TaskMonitor(RunControl& control, QWidget* parent = nullptr);
    void refresh();

private:
    class Histogram;
    RunControl& m_control;
    QTreeWidget* m_tree;
    Histogram* m_histogram;
};

class EventLog : public QWidget {
    Q_OBJECT
public:
    explicit EventLog(RunControl& control, QWidget* parent = nullptr);
    void addMessage(const QString& text, bool isError);
    [[nodiscard]] int count() const { return m_tree->topLevelItemCount(); }
    /// Everything it holds, for the log of another window on the same controller.
    struct Kept {
        std::vector<QTreeWidgetItem*> rows; // owned by who takes them
        size_t seen = 0;
    };
    [[nodiscard]] Kept release();
    void restore(Kept kept);
    /// The selected rows, else all that are shown: a line each, columns apart by tabs.
    [[nodiscard]] QString shownText() const;

signals:
    void lineRequested(const QString& file, int line);

protected:
    void showEvent(QShowEvent* event) override;

private:
    [[nodiscard]] QString placeOf(const controller::Event& event) const;
    void refresh();
    void add(const QStringList& columns, int icon, bool isProblem);
    void filter(QTreeWidgetItem* item);
    void filterAll();
    void copy();

    RunControl& m_control;
    QTreeWidget* m_tree;
    QLineEdit* m_filter;
    QAction* m_problemsOnly;
    size_t m_seen = 0;
    bool m_follows = true; // the end; who has scrolled up is left there
};

} // namespace plc::editor
