// What a Session keeps, for the files that implement it. Three kinds of members: constant or thread-safe, the scan
// thread's own, and `shared`, copies of what seldom changes behind a mutex that the scan thread only ever tries.
#pragma once
#include "projects/session/mirror.h"
#include "projects/session/session.h"
#include "projects/session/versions.h"
#include "projects/session/worker.h"
#include "projects/session/write_queue.h"
#include "runtime/base/mpsc_queue.h"
#include "runtime/base/published.h"
#include "runtime/debug/debugger.h"
#include "runtime/platform/wake_up.h"

#include <atomic>

namespace plc::session {

/// How a command gets along with a scan that stands at a breakpoint.
enum class When : uint8_t {
    Now,      // served while halted
    Boundary, // waits for the end of the scan
    Leave,    // abandons the halted scan, then runs
};
struct Command {
    When when = When::Now;
    std::function<void()> run;
};

struct Session::State final : controller::ScanObserver {
    State(driver::Built first, Settings s, std::shared_ptr<Versions> v);
    ~State() override;

    Settings settings;
    std::shared_ptr<Outlet> outlet;                     // of a mirror: nothing runs here
    std::shared_ptr<Versions> versions;                 // the run's
    std::atomic<const driver::Built*> current{nullptr}; // kept alive by `versions`
    history::History history;

    // --- posting
    MpscQueue<Command> commands;
    platform::WakeUp wakeUp;
    std::atomic<bool> isQueueing{false}; // a thread drains the commands; else they run where they are posted
    std::atomic<bool> isQuitting{false};
    std::thread thread;
    std::unique_ptr<Worker> worker;

    // --- published
    Published<Snapshot> published;
    std::atomic<controller::State> state{controller::State::Stopped};
    std::atomic<uint64_t> scans{0}, skipped{0}, halts{0};
    std::atomic<int64_t> time{0}, lastScanNs{0};
    std::atomic<double> load{0};
    std::atomic<bool> wantsRetainSaved{false};
    struct FaultImage {
        std::vector<std::byte> image;
        std::shared_ptr<const image::CompiledProgram> program;
    };
    struct Shared {
        std::optional<controller::Fault> fault, simulationFault;
        std::vector<controller::Forced> forces;
        std::vector<controller::TaskStatistics> tasks;
        ScanTimes times;
        std::deque<controller::Event> events; // the newest
        size_t firstEvent = 0;                // how many older ones are gone
        std::vector<Error> refusals;
        std::vector<controller::FaultFrame> frames; // while halted, innermost first
        Message haltProblem, retainProblem;
        std::shared_ptr<const FaultImage> faultImage; // while there is a fault
    };
    mutable std::mutex mutex;
    Shared shared;
    std::shared_ptr<Progress> optimising; // behind the mutex; null between jobs

    // --- the scan thread
    controller::Controller controller;
    std::vector<debug::Breakpoint> breakpoints; // as last set
    std::unique_ptr<debug::Debugger> debugger;
    WriteQueue writes;
    ScanTimes times;
    std::deque<Command> deferred; // posted while halted or in a long scan, for the boundary
    int64_t leaveAskedAt = 0;     // in a long scan: since when a stop is waiting; 0 = none is
    RunMode mode;
    int64_t wallAnchor = 0, plcAnchor = 0; // real time: this wall time is that PLC time
    double anchoredFactor = 0;
    bool needsAnchor = true;
    int64_t haltedNs = 0; // how long the scan that runs has stood at breakpoints
    bool isHalted = false, goesOn = false, leavesScan = false, pausesAfterScan = false;
    bool savesRetain = false;  // once the snapshot that shall be saved is published
    bool sharedIsStale = true; // something below or in the controller has to get into `shared`
    std::vector<controller::Event> newEvents;
    std::vector<Error> newRefusals;
    std::vector<controller::FaultFrame> haltFrames;
    Message haltProblem;
    std::shared_ptr<const FaultImage> faultImage;
    controller::State publishedState = controller::State::Stopped; // to which the newest publication belongs
    int64_t lastPublish = 0, lastShare = 0, busyNs = 0, loadSince = 0;
    uint64_t skippedReported = 0;
    int64_t skippedReportedAt = 0;

    void post(When when, std::function<void()> run);
    /// Of a mirror, the order goes to the controller that it shows.
    [[nodiscard]] bool sendsElsewhere(Order order);
    void adopt(std::shared_ptr<const driver::Built> built);
    void writeNow(const Together& together);
    void optimise(std::shared_ptr<const driver::Built> built);

    void run();
    void drain();
    /// Asked in the middle of a long scan: whether a stop, reset or the end has waited long enough for its end.
    [[nodiscard]] bool leavesLongScan();
    void scanInRealTime(int64_t now, double factor);
    void scanFast();
    void afterScans(int64_t begin, int64_t end);
    void reportSkipped(int64_t now);
    /// The locals lie in the image only until the plant runs the next time.
    void keepFaultImage();
    void anchor(int64_t now);
    [[nodiscard]] bool scansAreWanted() const;
    debug::Going serveHalt(const debug::Halt& halt);
    /// False when it was left out (see Published).
    bool publish();
    [[nodiscard]] controller::State stateNow() const;
    /// Whoever sees a state reads the values that belong to it: they are published first.
    void showState();
    /// Brings `shared` up to date; `mayWait` when no scan is due.
    void share(bool mayWait);
    void putShared();

    void loadRetained();
    [[nodiscard]] Result<void> saveRetained(const image::Layout& layout, std::span<const std::byte> image) const;
    void tick(); // worker

    // ScanObserver, scan thread
    void scanFinished(std::span<const std::byte> image, uint64_t scan, Nanoseconds time) override;
    void programChanged(std::shared_ptr<const image::CompiledProgram> program) override;
    void eventHappened(const controller::Event& event) override;
    void outsideActed(const image::Outside& outside) override;
    void actedWhileHalted(std::span<const image::OutsideNote> notes) override;

    int64_t lastRetainSave = 0; // worker
    uint64_t lastRetainScan = 0;
};

[[nodiscard]] int64_t wallNow();

} // namespace plc::session
