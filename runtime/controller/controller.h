// The controller: runs compiled programs scan by scan on one image (D1, D6, D8). A Controller belongs to one thread,
// the scan thread, which calls its functions; other threads post to the session that drives it
// (projects/session). Time comes from a Clock handed in.
#pragma once
#include "runtime/controller/clock.h"
#include "runtime/controller/event.h"
#include "runtime/controller/fault.h"
#include "runtime/controller/forced.h"
#include "runtime/controller/online_change_report.h"
#include "runtime/controller/task_statistics.h"
#include "runtime/expression/expression.h"
#include "runtime/image/journal.h"
#include "runtime/image/program.h"

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace plc::controller {

enum class State : uint8_t { Stopped, Running, Paused, Halted /* at a breakpoint */, Fault };
enum class ResetKind : uint8_t {
    Warm /* retain kept */,
    Cold /* retain initialised, persistent kept */,
    Origin /* everything, plant too */
};

/// Observer of each finished scan (history, alarms). Called on the scan thread: no locks, no allocation in the steady
/// state.
class ScanObserver {
public:
    virtual ~ScanObserver() = default;
    virtual void scanFinished(std::span<const std::byte> image, uint64_t scan, Nanoseconds time) = 0;
    virtual void programChanged(std::shared_ptr<const image::CompiledProgram> program) = 0;
    virtual void eventHappened(const Event& event) = 0;
    /// Before a scan that something from outside acted on since the one before; seldom, may allocate.
    virtual void outsideActed(const image::Outside&) {}
    /// Before scanFinished of a scan that was written to while it stood at a breakpoint.
    virtual void actedWhileHalted(std::span<const image::OutsideNote>) {}
};

struct Settings {
    Nanoseconds freewheelingInterval{1'000'000};
    Nanoseconds defaultWatchdog{1'000'000'000};
    int64_t loopBudgetPerScan = 200'000'000;           // virtual time: loop passes and calls of one task run
    int64_t calendarStartNs = 946'684'800'000'000'000; // DT#2000-01-01-00:00:00
    Clock* clock = nullptr; // measures tasks and the watchdog of real time; nullptr = the machine's steady clock
};

/// A recorded scan to be made again: what it began from. `image` may be shorter than the program's (no frames).
struct Rerun {
    std::span<const std::byte> image;
    const image::ScanStart* start = nullptr;
    uint64_t scan = 0;
    Nanoseconds instant{};
    int64_t calendarStartNs = 0;
    std::shared_ptr<const image::Code> code; // null: the program's own
    /// `start` says only what does not lie in the image.
    bool startIsPartial = false;
    /// What acted while the scan stood at a breakpoint: carried out when the code comes to its statement for the
    /// `occurrence`-th time (from 0). Needs code with sites.
    std::span<const image::OutsideNote> notes;
    uint32_t occurrence = 0;
    Nanoseconds clockBack{}; // the program sees its clock that much earlier (what if)
};

class Controller {
public:
    explicit Controller(std::shared_ptr<const image::CompiledProgram> program, Settings settings = {});
    ~Controller();

    void addObserver(ScanObserver& observer); // must outlive the controller
    [[nodiscard]] const image::CompiledProgram& program() const;
    [[nodiscard]] std::shared_ptr<const image::CompiledProgram> sharedProgram() const;
    [[nodiscard]] State state() const;
    [[nodiscard]] const std::optional<Fault>& fault() const;
    [[nodiscard]] const std::optional<Fault>& simulationFault() const;
    [[nodiscard]] std::span<const std::byte> image() const;
    /// For observers inside scanFinished: which pages (image::kDirtyPage) may have changed since the scan before; empty
    /// = any.
    [[nodiscard]] std::span<const uint8_t> dirtyPages() const;
    [[nodiscard]] uint64_t nextScan() const;     // number of the scan to come
    [[nodiscard]] Nanoseconds nextDue() const;   // PLC time at which at least one task is due
    [[nodiscard]] Nanoseconds lastTime() const;  // time of the last scan
    [[nodiscard]] uint64_t skippedScans() const; // instants that passed unused because the machine was late
    [[nodiscard]] bool hasSimulation() const;    // scans make sense in Stopped and Fault too

    void start(); // Stopped → Running (initial values were applied at construction or reset)
    void pause(); // Running → Paused; a scan in Paused is a single scan
    void stop();  // outputs go to their initial values (safe state)
    void reset(ResetKind kind);
    /// One scan at nextDue(), or in real time at the last instant up to `at` (nothing when that lies before nextDue();
    /// tasks overdue by more than a period skip, and are counted). In Stopped and Fault only the simulation programs
    /// and forces act. Returns false when the scan faulted.
    bool scan(std::optional<Nanoseconds> at = std::nullopt);

    // Variables, between scans or while halted. Writes are applied at once when called on the scan thread.
    [[nodiscard]] Result<types::Value> read(std::string_view path) const;
    Result<void> write(std::string_view path, const types::Value& value);
    Result<void> write(image::Place place, const types::Value& value);
    /// Of a path whose place is known.
    Result<void> write(std::string_view path, image::Place place, const types::Value& value);
    Result<void> force(std::string_view path, const types::Value& value);
    Result<void> release(std::string_view path);
    void releaseAll();
    [[nodiscard]] const std::vector<Forced>& forces() const;

    /// Exchanges the program at the scan boundary; values move by path and type, references by what they pointed to.
    OnlineChangeReport changeProgram(std::shared_ptr<const image::CompiledProgram> program);
    /// Puts a recorded image of `program` back (time travel): the next scan continues from it.
    void resumeFrom(std::shared_ptr<const image::CompiledProgram> program, std::span<const std::byte> image,
                    uint64_t scan, Nanoseconds time);

    /// Runs one function without parameters on an instance, outside a scan, under the same guards (statements of
    /// tests). False with fault() set when it faulted. `function` indexes CompiledProgram::functions.
    bool runFunction(uint32_t function, uint32_t instance);

    // Retain (controller/retain.h reads and writes the file).
    [[nodiscard]] std::vector<std::pair<std::string, types::Value>> retained(bool persistentOnly = false) const;
    size_t restoreRetained(std::span<const std::pair<std::string, types::Value>> values); // returns how many fitted

    [[nodiscard]] std::vector<TaskStatistics> statistics() const;
    void resetStatistics();
    /// How often each cyclic and freewheeling task of the PLC has run so far; by Task order.
    [[nodiscard]] std::vector<uint64_t> cyclicRuns() const;

    // Debugging (runtime/debug drives these).
    /// Quick code from the next scan boundary on, as long as it is wanted (breakpoints, coverage).
    void useQuickCode(bool wanted);
    [[nodiscard]] std::span<uint8_t> siteFlags();
    using SiteHook = std::function<void(uint32_t site, uint32_t instance, uint32_t frame)>;
    void
    setSiteHook(SiteHook hook); // runs on the scan thread, inside the scan; may block (halted) and may call abandonScan
    [[nodiscard]] image::RuntimeContext& context();
    /// From inside the site hook: the scan is left as soon as the hook returns (reset, stop, going back, closing). It
    /// then counts as not made, and the state is Stopped.
    void abandonScan();
    /// From inside the site hook: state() says Halted until it is called with false.
    void setHalted(bool isHalted);
    /// The calls that are live now (halted or faulted), innermost first; `site` is the statement that is about to run.
    [[nodiscard]] std::vector<FaultFrame> callPath(uint32_t site) const;
    void report(EventKind kind, Message text);
    /// Who the writes and forces that follow come from ("panel Main, button Start"), for the journal.
    void actFor(std::string origin);

    /// Makes a recorded scan again (D13), on a controller that is used for nothing else; false when it faulted.
    bool rerun(const Rerun& rerun);

private:
    struct State_;
    std::unique_ptr<State_> m;
};

/// The three functions generated code calls; hand them to jit::setRuntimeSymbols once at start-up.
[[nodiscard]] image::RuntimeSymbols runtimeSymbols();

} // namespace plc::controller
