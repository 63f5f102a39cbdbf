// The controller makes scans on whatever thread calls it, always the same one at a time; it starts no thread and takes
// no lock. The image is its alone while a scan runs. Everything that others want (writes, forces, halts, a new program)
// waits until the session calls it between two scans.
#include "runtime/controller/controller.h"

#include "runtime/base/assert.h"
#include "runtime/base/messages.h"
#include "runtime/controller/controller_state.h"
#include "runtime/controller/fault_report.h"
#include "runtime/controller/fitting.h"
#include "runtime/controller/online_change.h"
#include "runtime/controller/retained_places.h"

namespace plc::controller {

Controller::Controller(std::shared_ptr<const image::CompiledProgram> program, Settings settings)
    : m(std::make_unique<State_>(settings)) {
    State_* state = m.get();
    m->exit.self = state;
    // Plain functions and a pointer: generated code calls them through C, and a fault leaves them by longjmp.
    m->exit.refill = [](void* self) { return static_cast<State_*>(self)->refill(); };
    m->exit.atSite = [](void* self, uint32_t site, uint32_t instance, uint32_t frame) {
        auto& s = *static_cast<State_*>(self);
        if (!s.hook) return true;
        const int64_t begin = s.clock->nowNs();
        s.siteNow = site;
        s.instanceNow = instance;
        s.hook(site, instance, frame);
        s.taskStart += s.clock->nowNs() - begin; // standing at a breakpoint is not the task's time
        return !s.wantsAbandon;
    };
    m->context->owner = &m->exit;
    m->setProgram(std::move(program));
    if (!m->initialise(m->image.span())) {
        m->state = State::Fault;
        m->fault = m->describeFault(false);
    }
    m->keepSafeOutputs();
    m->schedule.restoreTriggers(m->image.get());
}

Controller::~Controller() = default;

void Controller::addObserver(ScanObserver& observer) {
    m->observers.push_back(&observer);
    // Whoever comes late begins with the program that runs.
    observer.programChanged(m->program);
}
const image::CompiledProgram& Controller::program() const { return *m->program; }
std::shared_ptr<const image::CompiledProgram> Controller::sharedProgram() const { return m->program; }
State Controller::state() const { return m->isHalted ? State::Halted : m->state; }
const std::optional<Fault>& Controller::fault() const { return m->fault; }
const std::optional<Fault>& Controller::simulationFault() const { return m->simulationFault; }
std::span<const std::byte> Controller::image() const { return m->image.span(); }
std::span<const uint8_t> Controller::dirtyPages() const {
    return m->isAllDirty ? std::span<const uint8_t>() : std::span<const uint8_t>(m->dirtyPages);
}
uint64_t Controller::nextScan() const { return m->scan; }
Nanoseconds Controller::nextDue() const { return Nanoseconds(m->schedule.nextDue()); }
Nanoseconds Controller::lastTime() const { return Nanoseconds(std::max<int64_t>(0, m->time)); }
uint64_t Controller::skippedScans() const { return m->skipped; }
bool Controller::hasSimulation() const { return m->schedule.hasSimulation(); }
image::RuntimeContext& Controller::context() { return *m->context; }
std::span<uint8_t> Controller::siteFlags() { return m->siteFlags; }
void Controller::setSiteHook(SiteHook hook) { m->hook = std::move(hook); }
void Controller::useQuickCode(bool wanted) { m->wantsQuick = wanted; }
void Controller::abandonScan() { m->wantsAbandon = true; }
void Controller::setHalted(bool isHalted) { m->isHalted = isHalted; }
void Controller::report(EventKind kind, Message text) { m->report(kind, std::move(text)); }
std::vector<FaultFrame> Controller::callPath(uint32_t site) const {
    return callPathOf(*m->program, *m->context, site, m->entry);
}

// ---------------------------------------------------------------- program and image

void Controller::State_::setProgram(std::shared_ptr<const image::CompiledProgram> next) {
    program = std::move(next);
    // A program without any variable still has a header.
    image.resize(std::max<size_t>(program->layout.imageSize, sizeof(image::ImageHeader)));
    // Sites count from 1; flags are forgotten with the program, and the debugger sets its own again.
    siteFlags.assign(program->sites.size() + 1, 0);
    dirtyPages.assign(image::dirtyPageCount(static_cast<uint32_t>(image.span().size())) + 1, 0);
    // The history compares pages that are marked; after a change of the whole image all of them are.
    isAllDirty = true;
    schedule.setTasks(program->tasks, settings.freewheelingInterval);
    schedule.rebase(time);
    prepareContext(image.get(), settings.loopBudgetPerScan);
}

void Controller::State_::prepareContext(std::byte* bytes, int64_t units) {
    context->image = bytes;
    context->dataBegin = sizeof(image::ImageHeader);
    context->dataEnd = program->layout.dataEnd;
    context->frameTop = program->layout.frameBegin;
    context->imageSize = program->layout.imageSize;
    context->siteFlags = siteFlags.data();
    context->dirtyPages = dirtyPages.data();
    context->depth = 0;
    context->currentSite = 0;
    context->fault = image::FaultCode::None;
    context->faultSite = 0;
    // Portions are added below: the code counts them down and asks for more at zero.
    context->loopBudget = 0;
    budget = budgetLeft = units;
    takePortion();
}

void Controller::State_::takePortion() {
    constexpr int64_t kPortion = 100'000; // some milliseconds at most
    // In real time the number of portions is not limited: refill looks at the clock instead.
    const int64_t portion = isRealTime ? kPortion : std::min(kPortion, budgetLeft);
    budgetLeft -= portion;
    context->loopBudget += portion;
}

/// In virtual time all portions together are the budget, so that the watchdog comes at the same place on each machine;
/// in real time the clock decides.
FaultExit::Refill Controller::State_::refill() {
    // Asked here because only here does a loop that never ends come by.
    if (exit.wantsToLeave && exit.wantsToLeave()) {
        wantsAbandon = true;
        return FaultExit::Refill::Leave;
    }
    if (isRealTime) {
        // taskStart is moved on while a breakpoint holds the scan.
        if (clock->nowNs() - taskStart > watchdogNs() * std::max<uint32_t>(1, task ? task->watchdogSensitivity : 1))
            return FaultExit::Refill::UsedUp;
        context->loopBudget = 0;
        takePortion();
        return FaultExit::Refill::GoOn;
    }
    while (context->loopBudget < 0 && budgetLeft > 0) takePortion();
    return context->loopBudget < 0 ? FaultExit::Refill::UsedUp : FaultExit::Refill::GoOn;
}

const image::Code* Controller::State_::currentCode() const {
    if (rerunCode) return rerunCode.get();
    // Optimised code appears while the program runs, at the border of a scan; quick code stays for the debugger.
    if (!wantsQuick || !program->quick)
        if (const image::Code* optimised = program->optimised.load(std::memory_order_acquire)) return optimised;
    return program->quick.get();
}

namespace {

/// Units of work for initial values: less than a scan has, because they are computed where nobody can stop them.
constexpr int64_t kInitialBudget = 20'000'000;

struct InitialiserCall {
    image::RuntimeContext* context;
    image::Entry entry;
    uint32_t instance = 0;
};
void callInitialiser(void* argument) {
    const auto& call = *static_cast<InitialiserCall*>(argument);
    call.entry(call.context, call.context->image, call.instance);
}

struct TaskCall {
    image::RuntimeContext* context;
    const image::Code* code;
    const image::CompiledProgram* program;
    const image::Task* task;
    image::CallRecord* entry;
};
void callEntry(const TaskCall& call, uint32_t function, uint32_t instance) {
    if (function == 0 || function >= call.code->entries.size() || !call.code->entries[function]) return;
    call.entry->function = function;
    // Each entry begins with an empty call path, also behind one that was left by a fault.
    call.context->depth = 0;
    call.context->frameTop = call.program->layout.frameBegin;
    call.code->entries[function](call.context, call.context->image, instance);
}
/// Runs under FaultExit: nothing in here may own anything.
void callTask(void* argument) {
    const auto& call = *static_cast<TaskCall*>(argument);
    for (const image::TaskProgram& part : call.task->programs) {
        const uint32_t instance = call.program->layout.roots[part.root].offset;
        *call.entry = image::CallRecord{0, part.function, instance, call.program->layout.frameBegin};
        // Inputs, body, outputs of one instance before the next one: the order of the task's list (2.7.2).
        callEntry(call, part.connectIn, instance);
        callEntry(call, part.function, instance);
        callEntry(call, part.connectOut, instance);
    }
}

} // namespace

bool Controller::State_::initialise(std::span<std::byte> bytes) {
    isAllDirty = true;
    const std::vector<std::byte>& initial = program->initialImage;
    // The initial image ends with the data; frames and padding are zeros.
    const size_t known = std::min(initial.size(), bytes.size());
    std::memcpy(bytes.data(), initial.data(), known);
    std::memset(bytes.data() + known, 0, bytes.size() - known);
    const image::Code* start = currentCode();
    if (!program->initializer || !start || program->initializer >= start->entries.size() ||
        !start->entries[program->initializer])
        return true;
    // Initial values are computed on nobody's clock: a fixed amount of work, the same on each machine.
    isRealTime = false;
    task = nullptr;
    prepareContext(bytes.data(), std::min(kInitialBudget, settings.loopBudgetPerScan));
    entry = image::CallRecord{0, program->initializer, 0, program->layout.frameBegin};
    InitialiserCall call{context, start->entries[program->initializer]};
    const bool good = exit.run(&callInitialiser, &call);
    // `bytes` may be another buffer, that of a program which is only about to run.
    context->image = image.get();
    return good;
}

void Controller::State_::keepSafeOutputs() {
    const image::AreaRange& outputs = layout().outputs;
    safeOutputs.assign(image.get() + outputs.begin, image.get() + outputs.begin + outputs.size);
}

void Controller::State_::makeOutputsSafe() {
    isAllDirty = true;
    // Forces are put over it: whoever forces an output wants it also now.
    if (!safeOutputs.empty()) std::memcpy(image.get() + layout().outputs.begin, safeOutputs.data(), safeOutputs.size());
    applyForces();
}

bool Controller::runFunction(uint32_t function, uint32_t instance) {
    // Optimised code has entries for what tasks call only; the quick code has one for each function without parameters.
    const auto has = [&](const image::Code* code) {
        return code && function != 0 && function < code->entries.size() && code->entries[function];
    };
    const image::Code* code = m->currentCode();
    if (!has(code)) code = m->program->quick.get();
    if (!has(code)) return false;
    m->isRealTime = false;
    m->task = nullptr;
    m->isAllDirty = true;
    m->touch(image::OutsideKind::Function, m->program->functions[function].name);
    m->prepareContext(m->image.get(), m->settings.loopBudgetPerScan);
    m->entry = image::CallRecord{0, function, instance, m->layout().frameBegin};
    InitialiserCall call{m->context, code->entries[function], instance};
    if (m->exit.run(&callInitialiser, &call)) return true;
    m->enterFault(false);
    return false;
}

// ---------------------------------------------------------------- states

void Controller::start() {
    if (m->state == State::Fault || m->state == State::Running) return;
    // The program can ask whether a scan is its first after a stop.
    if (m->state == State::Stopped) m->firstPending = true;
    if (!m->plcRuns()) m->touch(image::OutsideKind::Started);
    m->state = State::Running;
    m->report(EventKind::Started, {});
}

void Controller::pause() {
    if (m->state != State::Running) return;
    m->state = State::Paused;
    m->report(EventKind::Paused, {});
}

void Controller::stop() {
    if (m->state == State::Stopped || m->state == State::Fault) return;
    m->state = State::Stopped;
    m->touch(image::OutsideKind::Stopped);
    m->makeOutputsSafe();
    m->report(EventKind::Stopped, {});
}

void Controller::reset(ResetKind kind) {
    // All of it is kept, because what survives depends on the kind of reset and on the new initial values.
    ImageBuffer before;
    before.resize(m->image.span().size());
    std::memcpy(before.get(), m->image.get(), m->image.span().size());
    const image::ImageHeader header = m->header();
    m->fault.reset();
    m->state = State::Stopped;
    if (!m->initialise(m->image.span())) {
        m->state = State::Fault;
        m->fault = m->describeFault(false);
    }
    m->keepSafeOutputs();
    const types::TypeTable& types = *m->layout().types;
    const auto keep = [&](const image::Place& place) {
        if (place.bit < 0)
            std::memcpy(m->image.get() + place.offset, before.get() + place.offset, types[place.type].size);
        else
            types::writeValue(types, place.type,
                              types::readValue(types, place.type, before.span().subspan(place.offset), place.bit),
                              m->image.span().subspan(place.offset), place.bit);
    };
    if (kind != ResetKind::Origin) {
        forEachRetained(m->layout(), kind == ResetKind::Cold,
                        [&](const std::string&, const image::Place& place) { keep(place); });
        for (const image::Root& root : m->layout().roots)
            if (root.isSimulation) keep({root.type, root.offset, root.bit});
        const image::AreaRange& inputs = m->layout().inputs;
        std::memcpy(m->image.get() + inputs.begin, before.get() + inputs.begin, inputs.size);
        // Only a reset to the origin begins the count of scans again.
        m->header() = header; // the clock goes on: the plant may be timing something
    } else {
        m->simulationFault.reset();
        m->simulationFirstPending = true;
        m->scan = 0;
        m->time = -1;
    }
    m->firstPending = true;
    m->applyForces();
    // Tasks are due from now on, not from when they last ran.
    m->schedule.rebase(m->time);
    m->schedule.restoreTriggers(m->image.get());
    m->schedule.skip(false);
    m->isAllDirty = true;
    m->touch(image::OutsideKind::Reset, kind == ResetKind::Warm ? "warm" : kind == ResetKind::Cold ? "cold" : "origin");
    m->report(EventKind::Reset, kind == ResetKind::Warm   ? errors::Warm()
                                : kind == ResetKind::Cold ? errors::Cold()
                                                          : errors::Origin());
}

// ---------------------------------------------------------------- the scan

bool Controller::scan(std::optional<Nanoseconds> at) {
    State_& s = *m;
    s.isRealTime = at.has_value();
    int64_t instant = s.schedule.nextDue();
    if (at) {
        // Called too early: nothing is due yet.
        if (at->count() < instant) return true;
        // Late by several intervals: one scan is made for the last of them and the others count as skipped.
        instant = s.schedule.lastInstant(at->count());
    }
    return s.scanAt(instant, at ? at->count() : instant);
}

bool Controller::State_::scanAt(int64_t instant, int64_t at) {
    code = currentCode();
    if (!code) return true;
    if (exit.edge && !letDevicesIn()) [[unlikely]]
        return false;
    // What somebody changed since the last scan is noted first, so that the journal has it before the scan that sees
    // it.
    if (isTouched) [[unlikely]]
        tellOutside();
    isScanning = true;
    wantsAbandon = false;
    // Quick code does not mark pages.
    isAllDirty = isAllDirty || !code->marksWrites;
    const bool isRunning = plcRuns();
    const bool isFirst = firstPending && isRunning;
    const uint64_t skipped = schedule.begin(instant, at, isFirst);
    if (isRunning && !isFirst) this->skipped += skipped;

    image::ImageHeader& head = header();
    head.timeNs = instant - clockBack;
    head.calendarNs = settings.calendarStartNs + instant - clockBack;
    head.scan = scan;

    if (schedule.hasEvents()) schedule.sampleTriggers(image.get(), isRunning);
    if (schedule.hasSimulation() && !simulationFault) {
        head.firstScan = simulationFirstPending ? 1 : 0;
        simulationFirstPending = false;
        if (!runTasks(true)) {
            if (wantsAbandon) return finishScan(-1), false;
            enterFault(true);
        }
    } else if (schedule.hasSimulation()) {
        schedule.skip(true);
    }
    applyForces();
    bool good = true;
    if (isRunning) {
        head.firstScan = firstPending ? 1 : 0;
        firstPending = false;
        if (schedule.hasEvents()) schedule.sampleTriggers(image.get(), isRunning);
        good = runTasks(false);
        if (!good && wantsAbandon) return finishScan(-1), false;
        if (good) applyForces();
    } else {
        schedule.skip(false);
    }
    if (schedule.hasEvents()) schedule.sampleTriggers(image.get(), isRunning);
    finishScan(instant);
    if (!good) enterFault(false);
    return good;
}

/// Records the scan; instant < 0: it was abandoned and does not count.
void Controller::State_::finishScan(int64_t instant) {
    isScanning = false;
    if (instant < 0) {
        state = State::Stopped;
        isHalted = false;
        schedule.rebase(time);
        notesWhileHalted.clear(); // with the scan
        touch(image::OutsideKind::Stopped, "in the middle of a scan");
        makeOutputsSafe();
        report(EventKind::Stopped, errors::InTheMiddleOfAScan());
        return;
    }
    image::ImageHeader& h = header();
    if (schedule.hasEvents()) schedule.storePending(h);
    h.reserved[2] = (firstPending ? kFirstScanPending : 0) | (simulationFirstPending ? kSimulationFirstPending : 0);
    const uint64_t number = scan++;
    time = instant;
    const std::span<const std::byte> bytes = image.span();
    if (!notesWhileHalted.empty()) {
        for (ScanObserver* observer : observers) observer->actedWhileHalted(notesWhileHalted);
        notesWhileHalted.clear();
    }
    for (ScanObserver* observer : observers) observer->scanFinished(bytes, number, Nanoseconds(instant));
    std::fill(dirtyPages.begin(), dirtyPages.end(), uint8_t(0));
    isAllDirty = false;
}

bool Controller::State_::runTasks(bool isSimulation) {
    int64_t now = -1;
    while (TaskRun* run = schedule.next(isSimulation)) {
        taskStart = now >= 0 ? now : clock->nowNs();
        if (!runTask(*run)) return false;
        now = clock->nowNs();
        const int64_t elapsed = now - taskStart;
        addRun(*run, elapsed);
        if (schedule.hasEvents()) schedule.sampleTriggers(image.get(), plcRuns());
        if (!isRealTime) continue;
        run->watchdogStreak = elapsed > watchdogNs() ? run->watchdogStreak + 1 : 0;
        if (run->watchdogStreak < std::max<uint32_t>(1, run->task->watchdogSensitivity)) continue;
        run->watchdogStreak = 0;
        context->fault = image::FaultCode::Watchdog;
        context->faultSite = 0;
        context->depth = 0;
        return false;
    }
    return true;
}

bool Controller::State_::runTask(TaskRun& run) {
    task = run.task;
    header().taskPeriodNs = static_cast<uint64_t>(run.interval);
    prepareContext(image.get(), settings.loopBudgetPerScan);
    TaskCall call{context, code, program.get(), task, &entry};
    return exit.run(&callTask, &call);
}

Fault Controller::State_::describeFault(bool isSimulation) const {
    Fault f;
    f.code = context->fault;
    f.message = faultMessage(*context);
    if (f.code == image::FaultCode::Watchdog) {
        if (isRealTime)
            f.message = errors::TaskOverWatchdog(types::durationText(watchdogNs()));
        else
            f.message = errors::LoopBudgetExceeded(budget);
    }
    f.task = task ? task->name : std::string();
    f.calls = callPathOf(*program, *context, context->faultSite, entry);
    if (!f.calls.empty()) f.range = f.calls.front().range;
    f.scan = scan;
    f.time = Nanoseconds(header().timeNs);
    f.isSimulation = isSimulation;
    return f;
}

void Controller::State_::enterFault(bool isSimulation) {
    Fault f = describeFault(isSimulation);
    if (!isSimulation) f.scan = scan - 1; // it was recorded as the last scan
    Message text = isSimulation ? errors::InSimulation(f.message) : f.message;
    touch(image::OutsideKind::Fault, isSimulation ? "simulation" : "");
    if (isSimulation) {
        simulationFault = std::move(f);
    } else {
        fault = std::move(f);
        state = State::Fault;
        makeOutputsSafe();
    }
    report(EventKind::Fault, std::move(text));
}

void Controller::State_::report(EventKind kind, Message text) {
    if (observers.empty()) return;
    const Event event{kind, scan, Nanoseconds(std::max<int64_t>(0, time)), std::move(text)};
    for (ScanObserver* observer : observers) observer->eventHappened(event);
}

std::vector<TaskStatistics> Controller::statistics() const {
    std::vector<TaskStatistics> all;
    for (const TaskRun& run : m->schedule.runs()) all.push_back(run.statistics);
    return all;
}

std::vector<uint64_t> Controller::cyclicRuns() const {
    std::vector<uint64_t> runs;
    for (const TaskRun& run : m->schedule.runs())
        if (run.task->kind != image::TaskKind::Event && !run.task->isSimulation) runs.push_back(run.runs);
    return runs;
}

void Controller::resetStatistics() {
    for (TaskRun& run : m->schedule.runs()) {
        TaskStatistics fresh;
        fresh.name = std::move(run.statistics.name);
        fresh.histogram.resize(run.statistics.histogram.size());
        run.statistics = std::move(fresh);
    }
}

} // namespace plc::controller
