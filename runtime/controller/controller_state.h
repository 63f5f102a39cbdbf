// What a Controller keeps, for the files that implement it. Scan thread only.
#pragma once
#include "runtime/controller/controller.h"
#include "runtime/controller/fault_exit.h"
#include "runtime/controller/forces.h"
#include "runtime/controller/scan_edge.h"
#include "runtime/controller/schedule.h"
#include "runtime/image/watch.h"

#include <cstdlib>
#include <cstring>

namespace plc::controller {

/// The image's bytes, at a cache line's border.
class ImageBuffer {
public:
    void resize(size_t size) {
        m_size = size;
        m_bytes.reset(static_cast<std::byte*>(std::aligned_alloc(64, std::max<size_t>(64, (size + 63) / 64 * 64))));
        std::memset(m_bytes.get(), 0, std::max<size_t>(64, (size + 63) / 64 * 64));
    }
    [[nodiscard]] std::byte* get() const { return m_bytes.get(); }
    [[nodiscard]] std::span<std::byte> span() const { return {m_bytes.get(), m_size}; }

private:
    struct Free {
        void operator()(std::byte* bytes) const { std::free(bytes); }
    };
    std::unique_ptr<std::byte, Free> m_bytes;
    size_t m_size = 0;
};

struct Controller::State_ {
    explicit State_(Settings s) : settings(s), clock(s.clock ? s.clock : &steadyClock) {}

    Settings settings;
    SteadyClock steadyClock;
    Clock* clock;
    std::shared_ptr<const image::CompiledProgram> program;
    ImageBuffer image;
    std::vector<std::byte> safeOutputs;
    image::WatchedContext watchedContext; // watched code finds its report behind the context
    image::RuntimeContext* context = &watchedContext.base;
    FaultExit exit;
    std::vector<uint8_t> siteFlags;
    std::vector<uint8_t> dirtyPages; // of the image, and one behind
    bool isAllDirty = true;          // something wrote without marking
    SiteHook hook;
    Schedule schedule;
    Forces forces;
    std::vector<ScanObserver*> observers;

    State state = State::Stopped;
    bool isHalted = false;
    std::optional<Fault> fault, simulationFault;
    uint64_t scan = 0; // number of the next scan
    int64_t time = -1; // of the last scan; -1 = none yet
    uint64_t skipped = 0;
    bool firstPending = true; // the next scan of the PLC is the first after a start or reset
    bool simulationFirstPending = true;
    bool wantsQuick = false;
    bool wantsAbandon = false;
    bool isRealTime = false; // of this scan

    // The journal: what acted from outside since the scan before.
    bool isTouched = true;
    bool isScanning = false;
    uint32_t siteNow = 0, instanceNow = 0; // where the scan stands
    std::string origin;
    std::vector<image::OutsideNote> notes, notesWhileHalted;
    std::shared_ptr<const image::Code> rerunCode;
    int64_t clockBack = 0; // of a scan that is made again

    // The task part that runs now.
    const image::Code* code = nullptr;
    const image::Task* task = nullptr;
    image::CallRecord entry;
    int64_t taskStart = 0;
    int64_t budget = 0, budgetLeft = 0; // units of work of this run, and behind the portion that generated code has

    [[nodiscard]] image::ImageHeader& header() const { return *reinterpret_cast<image::ImageHeader*>(image.get()); }
    [[nodiscard]] const image::Layout& layout() const { return program->layout; }
    [[nodiscard]] bool plcRuns() const { return state == State::Running || state == State::Paused; }

    void setProgram(std::shared_ptr<const image::CompiledProgram> next);
    void prepareContext(std::byte* bytes, int64_t units);
    void takePortion();
    /// Gives the task its next portion of work.
    [[nodiscard]] FaultExit::Refill refill();
    /// Initial values into `bytes`; false when their code faulted (`fault` then says where).
    [[nodiscard]] bool initialise(std::span<std::byte> bytes);
    void keepSafeOutputs();
    void makeOutputsSafe();
    [[nodiscard]] const image::Code* currentCode() const;
    [[nodiscard]] Fault describeFault(bool isSimulation) const;

    /// Runs the due tasks of plant or PLC; false when one faulted.
    [[nodiscard]] bool runTasks(bool isSimulation);
    [[nodiscard]] bool runTask(TaskRun& run);
    /// One scan at `instant`; `at`: what the clock says.
    bool scanAt(int64_t instant, int64_t at);
    void finishScan(int64_t instant);
    void enterFault(bool isSimulation);
    void enterFaultFromOutside(Message why);
    /// The devices put their inputs into the image; false when one of them stops the PLC.
    bool letDevicesIn();
    class Edge;
    void report(EventKind kind, Message text);
    /// Something from outside acts now.
    /// The value as it was fitted to the place.
    [[nodiscard]] Result<types::Value> write(image::Place place, const types::Value& value);
    void touch(image::OutsideKind kind, std::string text = {});
    void touch(image::OutsideKind kind, const image::Place& place, std::string text = {});
    /// Tells the observers what the scan to come begins from.
    void tellOutside();
    [[nodiscard]] image::ScanStart scanStart() const;
    void actAtSites(const Rerun& wanted);
    void act(const image::OutsideNote& note);
    void applyForces() { forces.apply(image.get(), dirtyPages); }

    [[nodiscard]] int64_t watchdogNs() const {
        return task && task->watchdog.count() > 0 ? task->watchdog.count() : settings.defaultWatchdog.count();
    }
};

/// The flags of reserved[2] in the image's header: what a recorded image must know to be continued.
inline constexpr uint32_t kFirstScanPending = 1, kSimulationFirstPending = 2;

} // namespace plc::controller
