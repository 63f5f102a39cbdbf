// The running controller as the window sees it: builds in the background, owns the Session, looks at it 30 times a
// second, and decides which image everybody shows: the live one or, while the time slider stands in the past, a
// recorded one. Owned by the main window; GUI thread. Views connect to `refreshed` and read through `value()`; none of
// them reaches into the scan.
#pragma once
#include "editor/analysis/workspace.h"
#include "editor/debug/line_map.h"
#include "editor/debug/run_archive.h"
#include "projects/session/session.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <set>
#include <thread>

namespace plc::editor {

struct EditorBreakpoint {
    QString file;
    int line = 1; // 1-based
    QString condition;
    int hitCount = 0;
    QString instance;
    bool isEnabled = true;
    bool hasCode = true; // false: the program that runs has none at the line or below it
    bool operator==(const EditorBreakpoint&) const = default;
};

/// A recording from a file, looked at in the place of the running controller.
struct RecordedRun {
    QString name;
    const history::History* history = nullptr;
    std::function<Result<expression::Expression>(const std::string& text, const std::string& scope,
                                                 const image::CompiledProgram& program)>
        compile;
    std::shared_ptr<const void> owner; // keeps the history alive
};

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
    /// Memory for the recording of every scan, of this session and of those to come.
    void setHistoryBudget(size_t bytes);

    /// All views show a recording from a file (nothing can be written then); nothing: the controller again.
    void showRecorded(std::optional<RecordedRun> recorded);
    [[nodiscard]] bool showsRecorded() const { return m_recorded.has_value(); }
    [[nodiscard]] const RecordedRun* recorded() const { return m_recorded ? &*m_recorded : nullptr; }
    [[nodiscard]] QString recordedName() const { return m_recorded ? m_recorded->name : QString(); }
    /// The recording that is looked at: of the controller, or from a file; null: none.
    [[nodiscard]] const history::History* shownHistory() const;
    [[nodiscard]] std::shared_ptr<const void> recordedOwner() const {
        return m_recorded ? m_recorded->owner : nullptr; // keeps the one from a file alive
    }
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
    void onlineChange(); // the edited program enters the running controller
    void setMode(session::RunMode mode);
    [[nodiscard]] session::RunMode mode() const { return m_mode; }
    void disconnectSession(); // project closes
    void announce();          // all of its state again, to views that are new

    // breakpoints, kept with the project
    [[nodiscard]] const std::vector<EditorBreakpoint>& breakpoints() const { return m_breakpoints; }
    /// An enabled one at "file:line".
    [[nodiscard]] bool hasBreakpoint(const QString& place) const;
    void setBreakpoints(std::vector<EditorBreakpoint> breakpoints);
    void toggleBreakpoint(const QString& file, int line);
    /// The text was edited: what stood at the first line of a pair stands at the second now.
    void moveBreakpoints(const QString& file, const std::map<int, int>& lines);

    /// Where a place of the program that runs is in the text as it stands now.
    struct TextPlace {
        QString file;
        int line = 0;        // from 1
        uint32_t offset = 0; // of the place, or of the line when the text there was edited
        uint32_t length = 0;
    };
    [[nodiscard]] std::optional<TextPlace> placeInText(SourceRange range) const;
    /// The same of another version of the program, that of a recorded scan.
    [[nodiscard]] std::optional<TextPlace> placeInText(SourceRange range, const image::CompiledProgram& program) const;
    /// The program in the controller is that of the text as it stands.
    [[nodiscard]] bool isUpToDate() const;

    // values
    struct Shown {
        QString text; // "" = no value
        QString reason;
        types::Value value;
        types::TypeId type;
        bool isBool = false, isTrue = false, isForced = false;
    };
    [[nodiscard]] Shown value(const QString& expression, const QString& scope = {},
                              types::NumberFormat format = types::NumberFormat::Decimal) const;
    /// Live value of a name as written inside a POU: its halted frame, else its only instance.
    [[nodiscard]] Shown valueIn(const QString& name, const QString& pou) const;
    /// The scan that whoever looks inside the running controller looks at, so that all of them show the same one;
    /// another one ten times a second. Stopped, the newest. Only where something is recorded.
    [[nodiscard]] history::Position sampled() const;
    /// An image to show in the place of the one that everybody is shown.
    struct Moment {
        std::vector<std::byte> image;
        std::shared_ptr<const image::CompiledProgram> program;
    };
    /// While `read` runs, values are those of the moment.
    void atMoment(Moment& moment, const std::function<void()>& read);
    [[nodiscard]] std::vector<QString> instancesOf(const QString& pou) const;
    void setPreferredInstance(const QString& pou, const QString& instance);
    [[nodiscard]] QString preferredInstance(const QString& pou) const;
    Result<void> write(const QString& path, const QString& text);
    Result<void> force(const QString& path, const QString& text);
    void unforce(const QString& path);
    [[nodiscard]] Result<types::Value> parse(const QString& path, const QString& text) const;

    // time
    /// None: live.
    [[nodiscard]] std::optional<history::Position> viewed() const { return m_viewed; }
    void view(std::optional<history::Position> position);
    void stepView(int scans);
    Result<void> resumeFromView();
    [[nodiscard]] const std::vector<std::byte>& image() const { return m_image; }
    [[nodiscard]] const image::CompiledProgram* imageProgram() const { return m_imageProgram.get(); }
    [[nodiscard]] std::shared_ptr<const image::CompiledProgram> sharedImageProgram() const { return m_imageProgram; }

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
    void takeSample();
    /// Builds on a thread of its own; `then` comes back to this one, unless it was cancelled.
    void buildAside(std::function<void(std::shared_ptr<driver::Built>)> then);
    void watchOptimising(std::shared_ptr<Progress> now);
    void adopt(std::shared_ptr<driver::Built> built, bool changeRunning);
    void postBreakpoints();
    /// As the program knows them; moves those on lines without code to where they halt.
    std::vector<session::Breakpoint> breakpointsFor(const image::CompiledProgram& program);
    void startThen(bool paused, std::function<void()> then);
    [[nodiscard]] std::string textOf(const QString& file, const SourceText& built) const;
    void refreshImage();
    void endSession();
    void leaveRecorded();
    [[nodiscard]] QString retainFile() const;

    Workspace& m_workspace;
    RunArchive m_archive;
    size_t m_historyBudget = size_t(256) << 20;
    std::unique_ptr<session::Session> m_session;
    session::Status m_status;
    session::RunMode m_mode{session::Pace::Real, 1.0};
    std::vector<EditorBreakpoint> m_breakpoints;
    std::vector<session::FaultFrame> m_frames;
    uint64_t m_haltsSeen = 0;
    std::map<QString, QString> m_preferredInstance;              // POU → instance path
    mutable std::map<QString, std::vector<QString>> m_instances; // found, by POU, of m_instancesOf
    mutable std::shared_ptr<const image::CompiledProgram> m_instancesOf;
    std::optional<history::Position> m_viewed;
    std::optional<RecordedRun> m_recorded;
    mutable std::map<std::string, expression::Expression> m_recordedExpressions; // by scope, text and version
    std::vector<std::byte> m_image;
    std::shared_ptr<const image::CompiledProgram> m_imageProgram;
    std::set<std::string> m_forced; // folded paths
    history::Position m_sampled = 0;
    QElapsedTimer m_sinceSample;
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
