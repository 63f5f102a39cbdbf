// The running controller as the window sees it: builds in the background, owns the Session, looks at it 30 times a
// second, and decides which image everybody shows: the live one or, while the time slider stands in the past, a
// recorded one. Owned by the main window; GUI thread. Views connect to `refreshed` and read through `value()`; none of
// them reaches into the scan.
#pragma once
#include "editor/debug/breakpoint_list.h"
#include "editor/debug/pou_instances.h"
#include "editor/debug/run_archive.h"
#include "editor/debug/shown_run.h"
#include "editor/workspace/workspace.h"
#include "projects/session/session.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <thread>

namespace plc::editor {

class FaultScan;

class RunControl : public QObject {
    Q_OBJECT
public:
    explicit RunControl(Workspace& workspace, QObject* parent = nullptr);
    ~RunControl() override;

    [[nodiscard]] session::Session* session() { return m_session.get(); } // null: nothing built
    [[nodiscard]] const session::Session* session() const { return m_session.get(); }
    [[nodiscard]] const session::Status& status() const { return m_status; }
    [[nodiscard]] bool isBuilding() const { return m_building != nullptr; }
    [[nodiscard]] bool isOnline() const { return m_session != nullptr; }
    [[nodiscard]] bool isEnding() const { return m_isEnding; }
    [[nodiscard]] bool isRunning() const;

    /// Hears of projects that open and close; again after all of the workspace's connections were cut.
    void followWorkspace();
    /// The runs before this one.
    [[nodiscard]] RunArchive& archive() { return m_archive; }
    [[nodiscard]] FaultScan& faultScan() const { return *m_faultScan; }
    /// Memory for the recording of every scan, of this session and of those to come.
    void setHistoryBudget(size_t bytes);

    /// All views show a recording from a file (nothing can be written then); null: the controller again.
    void showRecorded(std::shared_ptr<const session::RecordedRun> recorded, const QString& name = {});
    [[nodiscard]] bool showsRecorded() const { return recorded() != nullptr; }
    [[nodiscard]] const std::shared_ptr<const session::RecordedRun>& recorded() const { return m_shown.recorded(); }
    [[nodiscard]] QString recordedName() const { return m_shown.recordedName(); }
    /// What is looked at: the controller's, or one from a file; null: none.
    [[nodiscard]] const session::Run* run() const { return m_shown.run(); }
    [[nodiscard]] const history::History* shownHistory() const { return m_shown.history(); }
    /// There are values to show: of a controller or of a recording.
    [[nodiscard]] bool hasValues() const { return isOnline() || showsRecorded(); }

    /// While one is held the session stays: a new one waits. What works on a session's history outside this thread
    /// holds it.
    using Hold = std::shared_ptr<void>;
    [[nodiscard]] Hold hold();

    // commands
    void build(std::function<void(bool)> then = {}); // makes a session, keeps it stopped
    void start();                                    // builds when needed
    void pause();
    void stop();
    void singleScan();
    void resume();
    void step(session::Step kind);
    void runTo(const QString& file, int line);
    void reset(controller::ResetKind kind);
    /// Values that enter with another program; found when it is built.
    using WritesFor = std::function<session::Together(const image::CompiledProgram&)>;
    void onlineChange(WritesFor writes = {}); // the edited program enters the running controller
    void setMode(session::RunMode mode);
    [[nodiscard]] session::RunMode mode() const { return m_mode; }
    void disconnectSession(); // project closes
    /// A session that shows a controller elsewhere takes the place of the present one; null: it is let go.
    void showElsewhere(std::unique_ptr<session::Session> mirror);
    void announce(); // all of its state again, to views that are new

    // breakpoints, kept with the project
    [[nodiscard]] const std::vector<EditorBreakpoint>& breakpoints() const { return m_breakpoints.all(); }
    /// An enabled one at "file:line".
    [[nodiscard]] bool hasBreakpoint(const QString& place) const { return m_breakpoints.has(place); }
    void setBreakpoints(std::vector<EditorBreakpoint> breakpoints);
    void toggleBreakpoint(const QString& file, int line);
    /// The text was edited: what stood at the first line of a pair stands at the second now.
    void moveBreakpoints(const QString& file, const std::map<int, int>& lines);

    using TextPlace = editor::TextPlace;
    /// Where a place of the program that runs is in the text as it is written now.
    [[nodiscard]] std::optional<TextPlace> placeInText(SourceRange range) const;
    /// The same of another version of the program, that of a recorded scan.
    [[nodiscard]] std::optional<TextPlace> placeInText(SourceRange range, const image::CompiledProgram& program) const;
    /// The program in the controller is that of the text as it stands.
    [[nodiscard]] bool isUpToDate() const;

    // values
    using Shown = ShownRun::Value;
    [[nodiscard]] Shown value(const QString& expression, const QString& scope = {},
                              types::NumberFormat format = types::NumberFormat::Decimal) const {
        return m_shown.value(expression, scope, format);
    }
    /// Live value of a name as written inside a POU: its halted frame, else its only instance.
    [[nodiscard]] Shown valueIn(const QString& name, const QString& pou) const;
    /// The scan that whoever looks inside the running controller looks at, so that all of them show the same one.
    [[nodiscard]] history::Position sampled() const { return m_shown.sampled(); }
    using Moment = ShownRun::Moment;
    /// While `read` runs, values are those of the moment.
    void atMoment(Moment& moment, const std::function<void()>& read) { m_shown.atMoment(moment, read); }
    [[nodiscard]] std::vector<QString> instancesOf(const QString& pou) const {
        return m_instances.of(pou, m_shown.program());
    }
    [[nodiscard]] std::pair<QString, QString> instanceAt(const QString& expression) const {
        return PouInstances::at(expression, m_shown.program());
    }
    void setPreferredInstance(const QString& pou, const QString& instance);
    [[nodiscard]] QString preferredInstance(const QString& pou) const {
        return m_instances.preferred(pou, m_shown.program());
    }
    Result<void> write(const QString& path, const QString& text);
    Result<void> force(const QString& path, const QString& text);
    void unforce(const QString& path);
    [[nodiscard]] Result<types::Value> parse(const QString& path, const QString& text) const;

    // time
    /// None: live.
    [[nodiscard]] std::optional<history::Position> viewed() const { return m_shown.viewed(); }
    void view(std::optional<history::Position> position);
    void stepView(int scans);
    Result<void> resumeFromView();
    [[nodiscard]] const std::vector<std::byte>& image() const { return m_shown.image(); }
    [[nodiscard]] const image::CompiledProgram* imageProgram() const { return m_shown.program().get(); }
    [[nodiscard]] std::shared_ptr<const image::CompiledProgram> sharedImageProgram() const { return m_shown.program(); }

signals:
    void buildStarted();
    void buildFinished(bool good, const QString& message);
    void buildCancelled(); // everything is as it was before
    /// What may take long, for the status line; `work` cancels it.
    void workBegan(const QString& label, const std::shared_ptr<plc::Progress>& work);
    void workEnded(const std::shared_ptr<plc::Progress>& work);
    void sessionChanged();    // another Session, or none
    void sessionAboutToEnd(); // views let go of it now
    void statusChanged();
    void refreshed(); // 30 times a second while something may have changed
    void viewedChanged();
    void halted();
    void recordedMustClose(); // a command to the controller came while a recording is shown
    void breakpointsChanged();
    void messageAdded(const QString& text, bool isError);
    void onlineChangeFinished(const QString& summary);

private:
    void tick();
    /// Builds on a thread of its own; `then` comes back to this one, unless it was cancelled.
    void buildAside(std::function<void(std::shared_ptr<driver::Built>)> then);
    void watchOptimising(std::shared_ptr<Progress> now);
    void adopt(std::shared_ptr<driver::Built> built);
    void change(const driver::Built& built, const WritesFor& writes);
    void postBreakpoints();
    std::vector<session::Breakpoint> breakpointsFor(const image::CompiledProgram& program);
    void startThen(bool paused, std::function<void()> then);
    [[nodiscard]] TextNow textNow() const;
    struct Entry {
        session::Target target;
        types::Value value;
    };
    /// A value as it was typed, and what it goes to.
    [[nodiscard]] Result<Entry> entry(const QString& path, const QString& text) const;
    [[nodiscard]] std::optional<Shown> localOf(size_t frame, const QString& name) const;
    void tellChange(const session::Status& before);
    void tellHalt();
    void endSession();
    void leaveRecorded();
    [[nodiscard]] QString retainFile() const;

    Workspace& m_workspace;
    RunArchive m_archive;
    size_t m_historyBudget = size_t(256) << 20;
    std::unique_ptr<session::Session> m_session;
    std::unique_ptr<FaultScan> m_faultScan; // of that session
    session::Status m_status;
    session::RunMode m_mode{session::Pace::Real, 1.0};
    BreakpointList m_breakpoints;
    PouInstances m_instances;
    ShownRun m_shown;
    std::vector<session::FaultFrame> m_frames;
    uint64_t m_haltsSeen = 0;
    QTimer m_timer;
    std::shared_ptr<Progress> m_building, m_optimising; // null: nothing of the kind goes on
    std::weak_ptr<void> m_hold;
    std::vector<std::function<void()>> m_afterHold;
    bool m_isEnding = false;
    bool m_pausedToLook = false; // it ran until one looked back
    std::thread m_builder;
    std::shared_ptr<driver::KeptFiles> m_built; // of the builder: Run checks what changed since the last Run
};

} // namespace plc::editor
