// The trace view: charts of a recording, live or past, with channels, trigger, cursors and set-ups. It reads the
// recording 30 times a second while it can be seen; the recording may come and go. Owned by its dock; GUI thread.
#pragma once

#include "editor/kit/ask_why.h"
#include "editor/plot/plot_view.h"
#include "editor/trace/curves/other_recordings.h"
#include "editor/trace/curves/trace_plot.h"
#include "editor/trace/setup/program_variables.h"
#include "editor/trace/setup/trigger.h"

#include <QTimer>
#include <QUndoStack>

class QLabel;
class QMenu;
class QSplitter;
class QTableWidget;
class QToolBar;

namespace plc::trace {

class ChannelPanel;
class FigurePane;
class RunRecording;

class TraceView : public QWidget {
    Q_OBJECT
public:
    explicit TraceView(QWidget* parent = nullptr);
    ~TraceView() override;

    /// The running recording; null while there is none. It must outlive its stay here.
    void setRecording(const Recording* recording);
    /// Shows a recording from a file instead of the running one, until it is closed.
    Result<void> openRecording(const QString& path);
    void closeRecording();
    /// What is drawn, live or from a file, to a file; cancelled, there is none.
    Result<void> saveRecording(const QString& path);
    /// The samples in view as CSV; it can be cancelled, then the file stays as it was.
    void exportSamples(const QString& path);
    bool showsFile() const { return m_opened != nullptr; }
    std::shared_ptr<const RunRecording> openedRecording() const { return m_opened; }
    const QString& openedName() const { return m_openedName; }
    /// The recording that is drawn: the opened file's, else the running one.
    const Recording* recording() const { return m_recording; }
    [[nodiscard]] const Recording* beneath() const { return m_beneath.get(); }
    /// The program has changed: names and completion follow, expressions are tried again.
    void programChanged();
    /// Draws an older recording beneath; null takes it away.
    void setBeneath(std::shared_ptr<const Recording> recording);

    const TraceSetup& setup() const { return m_setup; }
    void setSetup(TraceSetup setup); // forgets undo
    bool isModified() const { return !m_undo.isClean(); }
    Result<void> openSetup(const QString& path);
    Result<void> storeSetup(const QString& path);
    QString setupPath() const { return m_path; }
    QUndoStack* undoStack() { return &m_undo; }

    void addChannel(const QString& expression, int chart = 0);
    /// A variable has another name in the program: the set-up follows, in one step that can be taken back.
    void renameExpressions(const std::function<QString(const QString& expression)>& renamed);
    /// A channel of another recording or table, drawn beside those of the one that is shown.
    void addChannelOf(const QString& file, const QString& expression);
    /// What is drawn beside the charts: an XY plot, a spectrum…
    void showFigure(FigureKind kind);
    FigurePane* figurePane() const { return m_figure; }
    void addNote(int64_t time, std::optional<double> value, int chart, const QString& text);
    void removeNote(size_t note);
    void askWhy(kit::AskWhy question, int channel);
    /// The scan that the other windows show; nothing: the newest.
    void showPosition(std::optional<Position> position);
    /// Moves the view so that a time is in it.
    void showTime(int64_t time);
    /// Reads what is new and draws it; the timer does this, tests call it.
    void tick();
    /// Memory for the columns of open traces.
    void setColumnBudget(size_t bytes);

    plot::PlotView* plot() const { return m_plot; }
    ChannelPanel* channels() const { return m_channels; }
    TriggerState triggerState() const { return m_trigger.state(); }
    void armTrigger();
    bool findTrigger(history::History::Direction direction);
    QString statusText() const;
    /// Folder that file dialogs begin in: the project's traces.
    void setFolder(const QString& folder);
    /// Loads an older recording beneath and notes it in the set-up; an empty path takes it away.
    Result<void> compareWith(const QString& path);

    /// What the user made of it, for the trace of another window on the same controller.
    struct Kept {
        TraceSetup setup;
        QString path, openedName;
        bool isModified = false, isFollowing = true;
        int64_t from = 0, to = 0; // the times in view
        std::shared_ptr<const RunRecording> opened;
        std::shared_ptr<const Recording> beneath;
        QString compared; // path of what lies beneath
    };
    [[nodiscard]] Kept kept() const;
    void restore(Kept kept);
    /// What it gives is kept while the running recording is read outside this thread.
    void setHold(std::function<std::shared_ptr<void>()> hold) { m_hold = std::move(hold); }

signals:
    void setupChanged();
    void positionActivated(quint64 position); // double click on a chart
    /// Of a channel, at the cursor where cursors are shown, else at the scan the windows show.
    void whyRequested(plc::kit::AskWhy question, const QString& expression, std::optional<plc::trace::Position> at);
    void failed(const QString& message);
    void noted(const QString& message); // of a file that was opened all the same
    void recordingShown();              // another one is drawn: a file's, or the running one again

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void makeActions(QToolBar* bar);
    void addViewActions(QToolBar* bar);
    void addToolActions(QToolBar* bar);
    void addTriggerActions(QToolBar* bar);
    void addChartActions(QToolBar* bar);
    void fillFileMenu(QMenu* files);
    void fillExportMenu(QMenu* exports);
    void change(const QString& text, const std::function<void(TraceSetup&)>& change, int mergeId = -1);
    TraceSetup applyEdit(const TraceSetup& next);
    void setupTaken();
    void rebuildModel();
    void runTrigger();
    void showShot(int64_t time);
    void showTable();
    void showStatus();
    void plotMenu(const QPoint& global, int chart, const QString& curve);
    void exportTo(const QString& suffix);
    void addFigureActions(QMenu& menu);
    void drawFigure();
    void followFigure();
    [[nodiscard]] std::vector<uint64_t> figureStamp() const;
    void addNoteActions(QMenu& menu, const QPoint& global);
    void askNote(const QPoint& global);
    void editNote(size_t note);
    void askChannelsFrom();
    Result<void> addChannelsFrom(const QString& path);
    void followOthers();
    [[nodiscard]] QAction* toolAction(plot::PlotTool tool) const;
    void report(const Result<void>& result);
    void showRecording(const Recording* recording);
    void followCompareWith();
    [[nodiscard]] Result<std::shared_ptr<RunRecording>> readFile(const QString& path);
    QString inProject(const QString& path) const;

    const Recording* m_recording = nullptr; // drawn
    const Recording* m_live = nullptr;
    std::shared_ptr<const RunRecording> m_opened;
    QString m_openedName, m_compared; // compared: path of what lies beneath
    std::shared_ptr<const Recording> m_beneath;
    std::shared_ptr<history::ColumnStore> m_store;
    std::unique_ptr<TraceFeed> m_feed, m_olderFeed;
    OtherRecordings m_others;
    std::vector<uint64_t> m_figureShown;
    ProgramVariables m_variables;
    TraceSetup m_setup;
    QString m_path, m_folder;
    QSplitter* m_sides = nullptr;  // channels, plot
    QSplitter* m_charts = nullptr; // plot, figure
    std::function<std::shared_ptr<void>()> m_hold;
    QUndoStack m_undo;
    TriggerMachine m_trigger;
    int64_t m_triggerRead = INT64_MIN;
    uint64_t m_shots = 0;
    size_t m_marks = SIZE_MAX;
    QTimer m_timer;
    int m_ticks = 0;

    plot::PlotView* m_plot;
    ChannelPanel* m_channels;
    FigurePane* m_figure;
    QTableWidget* m_table;
    QLabel* m_state;
    QLabel* m_memory;
    QAction* m_follow = nullptr;
    QAction* m_cursors = nullptr;
    QAction* m_tableShown = nullptr;
    QAction* m_zoomTool = nullptr;
    QAction* m_panTool = nullptr;
    QAction* m_rulerTool = nullptr;
    QAction* m_arm = nullptr;
};

} // namespace plc::trace
