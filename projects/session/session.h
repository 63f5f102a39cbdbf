// A project that is built and can run: controller, history and debugger together, on a scan thread of their own or
// stepped by the caller. Command line, `stepwise test`, panel player and studio all use this (D9). The functions may be
// called from any thread unless they say otherwise; they post to the scan thread and read published snapshots (D8).
#pragma once
#include "projects/session/run.h"
#include "projects/session/scan_times.h"
#include "runtime/compiler/driver/driver.h"
#include "runtime/debug/breakpoint.h"

#include <functional>
#include <memory>
#include <string>

namespace plc::session {

using controller::FaultFrame;
using debug::Breakpoint;
using debug::Step;

enum class Pace : uint8_t { Real, Factor, Fastest };
struct RunMode {
    Pace pace = Pace::Fastest; // Fastest: virtual time
    double factor = 1.0;       // Factor: PLC seconds per second
};

struct Settings {
    controller::Settings controller;
    size_t historyBudget = size_t(256) << 20;
    std::string retainFile; // empty: no retain on disk
    Nanoseconds retainInterval{60'000'000'000};
    bool record = true;
};

class Mirror;

class Session final : public Run {
public:
    explicit Session(driver::Built built, Settings settings = {});
    ~Session() override; // ends it
    /// Stops the scan thread and writes what is retained; what was recorded can still be read. It cannot run again.
    void end();
    /// The controller runs elsewhere (mirror.h): what is asked of it goes there, what is shown comes from there.
    [[nodiscard]] bool isMirror() const;

    [[nodiscard]] const driver::Built& built() const;
    [[nodiscard]] std::shared_ptr<const image::CompiledProgram> program() const override;
    [[nodiscard]] history::History& history();
    [[nodiscard]] const history::History& history() const override;
    [[nodiscard]] Status status() const override;
    [[nodiscard]] bool isLive() const override { return true; }

    // --- caller-stepped (command line, tests): no scan thread
    [[nodiscard]] controller::Controller& controller(); // only while no scan thread runs
    /// Writes the retain file named in the settings (also done by the scan thread at stop and at the interval).
    Result<void> saveRetained() const;
    /// Runs scans in the calling thread until `stop` returns true (asked after each scan) or the state leaves Running.
    void runHere(const std::function<bool(const controller::Controller&)>& stop);

    // --- scan thread (studio, panel)
    /// start() included; `paused`: it waits before the first scan.
    void startThread(RunMode mode, bool paused = false);
    void setMode(RunMode mode);
    void start();
    void pause();
    void singleScan();
    void stop();
    void reset(controller::ResetKind kind);
    void write(Target target, types::Value value, std::string origin = {}) override;
    void writeTogether(std::vector<Assignment> values, std::string origin = {}) override;
    void press(Target target, types::Value pressed, types::Value released, std::string origin = {}) override;
    void release(Target target) override;
    void force(std::string path, types::Value value, std::string origin = {}) override;
    void unforce(std::string path) override;
    void unforceAll() override;
    [[nodiscard]] std::vector<controller::Forced> forces() const override;
    [[nodiscard]] std::vector<controller::TaskStatistics> taskStatistics() const;
    /// Of the scans in real time since the start or resetStatistics().
    [[nodiscard]] ScanTimes scanTimes() const;
    void resetTaskStatistics();
    void resetStatistics();
    /// Index counts from the first event of the session; of very many only the newest are kept.
    [[nodiscard]] std::vector<controller::Event> eventsSince(size_t index) const;
    [[nodiscard]] std::vector<Error> takeRefusals() override;
    /// The work on the optimised code, while it goes on; cancelled, the quick code stays. Else null.
    [[nodiscard]] std::shared_ptr<Progress> optimising() const;
    /// Of the newest finished scan (a copy of what is published); at a breakpoint the image as it is now.
    void latest(Snapshot& into) const override;
    /// Takes effect at the next scan boundary; `done` runs on the scan thread. `breakpoints`: those of the new program,
    /// in the place of the present ones. `together`: written before the new program's first scan.
    void changeProgram(driver::Built built, std::function<void(const controller::OnlineChangeReport&)> done,
                       std::optional<std::vector<Breakpoint>> breakpoints = std::nullopt, Together together = {});
    /// Continue from a recorded scan on a new branch (state Paused until start()).
    Result<void> resumeFrom(history::Position position);

    // --- debugging
    void setBreakpoints(std::vector<Breakpoint> breakpoints);
    void resume();
    void step(Step kind);
    void runTo(FileId file, uint32_t line);
    [[nodiscard]] std::vector<FaultFrame> haltFrames() const;
    /// Why it stands: a condition that cannot be evaluated, else empty.
    [[nodiscard]] Message haltProblem() const;
    /// Name and value of the locals of a frame of haltFrames(); after a fault, of the fault's call path as it was then.
    [[nodiscard]] std::vector<std::pair<std::string, types::Value>> frameVariables(size_t frame) const;

private:
    friend class Mirror;
    struct State;
    std::unique_ptr<State> m;
};

} // namespace plc::session
