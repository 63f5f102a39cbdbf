#include "runtime/controller/controller.h"
#include "tests/runtime/hand_made_program.h"

#include <gtest/gtest.h>

namespace plc::controller {
namespace {

using namespace std::chrono_literals;
using image::Area;
using image::FaultCode;
using plc::testing::at;
using plc::testing::HandMade;
using plc::testing::RuntimeContext;
using plc::testing::valueAt;
using types::TypeKind;
using types::TypeTable;
using types::Value;

Value integer(TypeKind kind, int64_t number) { return Value{TypeTable::of(kind), number}; }

/// A clock that moves only when told to; the code under test "runs" by moving it.
struct FakeClock final : Clock {
    int64_t now = 0;
    int64_t nowNs() override { return now; }
};
FakeClock* workClock = nullptr;

struct Recorder final : ScanObserver {
    struct Scan {
        uint64_t number;
        int64_t time;
        std::vector<std::byte> image;
    };
    std::vector<Scan> scans;
    std::vector<Event> events;
    int programs = 0;
    void scanFinished(std::span<const std::byte> image, uint64_t scan, Nanoseconds time) override {
        scans.push_back({scan, time.count(), {image.begin(), image.end()}});
    }
    void programChanged(std::shared_ptr<const image::CompiledProgram>) override { ++programs; }
    void eventHappened(const Event& event) override { events.push_back(event); }
};

// The program of most tests. Globals: count (DINT), order (LINT; each run appends a digit), mode (INT), lamp (%QX0.0).
struct Plain {
    HandMade made;
    uint32_t count, order, mode;
    Plain() {
        count = made.add("count", TypeKind::Dint).offset;
        order = made.add("order", TypeKind::Lint).offset;
        mode = made.add("mode", TypeKind::Int).offset;
        made.locate("lamp", TypeKind::Bool, "%QX0.0", 80, 0, Area::Output);
        made.locate("ready", TypeKind::Bool, "%IX0.0", 64, 0, Area::Input);
    }
};
constexpr uint32_t kCount = 112, kOrder = 120, kMode = 128;

void append(std::byte* image, int digit) {
    at<uint64_t>(image, kOrder) = at<uint64_t>(image, kOrder) * 10 + static_cast<unsigned>(digit);
} // wraps in long runs
void countUp(RuntimeContext*, std::byte* image, uint32_t) {
    ++at<int32_t>(image, kCount);
    image[80] |= std::byte{1};
    append(image, 1);
}
void second(RuntimeContext*, std::byte* image, uint32_t) { append(image, 2); }
void third(RuntimeContext*, std::byte* image, uint32_t) { append(image, 3); }
void divide(RuntimeContext* context, std::byte* image, uint32_t) {
    append(image, 4);
    image[80] |= std::byte{1};
    if (at<int16_t>(image, kMode) == 0) return;
    context->fault = FaultCode::IndexOutOfRange;
    context->faultSite = 1;
    context->faultDetail[0] = 7;
    context->faultDetail[1] = 1;
    context->faultDetail[2] = 5;
    context->calls[context->depth++] = {2, 1, 0, 0};
    runtimeSymbols().fault(context);
}
void endless(RuntimeContext* context, std::byte*, uint32_t) {
    for (;;)
        if (--context->loopBudget < 0) runtimeSymbols().budgetUsedUp(context);
}
void slow(RuntimeContext*, std::byte* image, uint32_t) {
    workClock->now += 3'000'000;
    ++at<int32_t>(image, kCount);
}

TEST(Controller, LayoutOfTheHandMadeProgramIsAsTheFunctionsExpect) {
    Plain plain;
    EXPECT_EQ(plain.count, kCount);
    EXPECT_EQ(plain.order, kOrder);
    EXPECT_EQ(plain.mode, kMode);
}

TEST(Controller, FirstScanIsNumberZeroAtTimeZeroAndEachLaterOneAtADueInstant) {
    Plain plain;
    plain.made.task("fast", plain.made.function("Fast", &countUp), 10ms);
    plain.made.task("slow", plain.made.function("Slow", &second), 25ms, 1);
    Controller controller(plain.made.finish());
    Recorder recorder;
    controller.addObserver(recorder);
    controller.start();
    for (int i = 0; i < 7; ++i) EXPECT_TRUE(controller.scan());
    std::vector<int64_t> times;
    for (const Recorder::Scan& scan : recorder.scans) {
        EXPECT_EQ(scan.number, times.size());
        times.push_back(scan.time / 1'000'000);
        const auto header = valueAt<image::ImageHeader>(scan.image, 0);
        EXPECT_EQ(header.timeNs, scan.time);
        EXPECT_EQ(header.scan, scan.number);
        EXPECT_EQ(header.firstScan, scan.number == 0 ? 1u : 0u);
        EXPECT_EQ(header.calendarNs, 946'684'800'000'000'000 + scan.time);
    }
    EXPECT_EQ(times, (std::vector<int64_t>{0, 10, 20, 25, 30, 40, 50}));
    EXPECT_EQ(controller.read("order")->integer(), 121121112); // both at 0 and at 50
    EXPECT_EQ(controller.nextScan(), 7u);
    EXPECT_EQ(controller.nextDue(), 60ms);
}

TEST(Controller, DueTasksRunByPriorityThenDeclarationAndFreewheelingInEveryScan) {
    Plain plain;
    plain.made.task("a", plain.made.function("A", &countUp), 10ms, 5);
    plain.made.task("b", plain.made.function("B", &second), 10ms, 1);
    image::Task& free = plain.made.task("c", plain.made.function("C", &third), 0ms, 1);
    free.kind = image::TaskKind::Freewheeling;
    Controller controller(plain.made.finish());
    controller.start();
    (void)controller.scan();
    EXPECT_EQ(controller.read("order")->integer(), 231);
    (void)controller.scan();
    EXPECT_EQ(controller.read("order")->integer(), 231231);
    EXPECT_EQ(controller.lastTime(), 10ms);
}

TEST(Controller, AloneAFreewheelingTaskRunsEveryMillisecond) {
    Plain plain;
    plain.made.task("c", plain.made.function("C", &third), 0ms).kind = image::TaskKind::Freewheeling;
    Controller controller(plain.made.finish());
    controller.start();
    for (int i = 0; i < 4; ++i) (void)controller.scan();
    EXPECT_EQ(controller.lastTime(), 3ms);
}

TEST(Controller, EventTaskRunsOncePerRisingEdgeAlsoOfAnEdgeMadeByALessUrgentTask) {
    Plain plain;
    plain.made.task("main", plain.made.function("Main", &countUp), 10ms, 5); // sets the lamp: its rise is the event
    image::Task& event = plain.made.task("event", plain.made.function("Event", &second), 0ms, 1);
    event.kind = image::TaskKind::Event;
    event.trigger = image::Place{TypeTable::of(TypeKind::Bool), 80, 0};
    Controller controller(plain.made.finish());
    controller.start();
    (void)controller.scan();
    EXPECT_EQ(controller.read("order")->integer(), 12); // urgent, but the edge came only by the other task
    (void)controller.scan();
    EXPECT_EQ(controller.read("order")->integer(), 121); // still TRUE: no edge
    EXPECT_TRUE(controller.write("lamp", integer(TypeKind::Bool, 0)));
    (void)controller.scan();
    EXPECT_EQ(controller.read("order")->integer(), 12112);
}

TEST(Controller, AFaultStopsWithPlaceMessageAndCallPathAndMakesOutputsSafe) {
    Plain plain;
    const FileId file = plain.made.program().sources.add("main.st", "x := a[7];\nb();\n");
    const uint32_t inner = plain.made.function("Inner", &divide);
    const uint32_t outer = plain.made.function("Outer", &divide);
    plain.made.site(inner, {file, 0, 10});
    plain.made.site(outer, {file, 11, 15});
    plain.made.task("main", outer, 10ms);
    plain.made.task("after", plain.made.function("After", &second), 10ms, 1);
    Controller controller(plain.made.finish());
    Recorder recorder;
    controller.addObserver(recorder);
    controller.start();
    EXPECT_TRUE(controller.scan());
    EXPECT_TRUE(controller.write("mode", integer(TypeKind::Int, 1)));
    EXPECT_FALSE(controller.scan());
    EXPECT_EQ(controller.state(), State::Fault);
    ASSERT_TRUE(controller.fault());
    const Fault& fault = *controller.fault();
    EXPECT_EQ(fault.code, FaultCode::IndexOutOfRange);
    EXPECT_EQ(fault.message.english(), "index 7 is outside 1..5; use an index in this range or enlarge the array");
    EXPECT_EQ(fault.task, "main");
    EXPECT_EQ(fault.scan, 1u);
    EXPECT_EQ(fault.time, 10ms);
    EXPECT_EQ(fault.range, (SourceRange{file, 0, 10}));
    ASSERT_EQ(fault.calls.size(), 2u);
    EXPECT_EQ(fault.calls[0].function, "Inner");
    EXPECT_EQ(fault.calls[1].function, "Outer");
    EXPECT_EQ(fault.calls[1].range, (SourceRange{file, 11, 15}));
    EXPECT_EQ(controller.read("order")->integer(), 424); // the second task did not run after the fault
    EXPECT_FALSE(controller.read("lamp")->isTrue());
    EXPECT_EQ(recorder.scans.back().number, 1u); // the image at the fault is the last record
    EXPECT_EQ(valueAt<uint8_t>(recorder.scans.back().image, 80) & 1, 1);
    EXPECT_TRUE(controller.scan()); // nothing of the PLC runs
    EXPECT_EQ(controller.read("order")->integer(), 424);
    controller.start();
    EXPECT_EQ(controller.state(), State::Fault);
    controller.reset(ResetKind::Warm);
    controller.start();
    EXPECT_TRUE(controller.scan());
    EXPECT_EQ(controller.read("order")->integer(), 42);
}

TEST(Controller, AnEndlessLoopEndsInVirtualTimeByItsBudgetAndInRealTimeByTheClock) {
    Plain plain;
    image::Task& task = plain.made.task("main", plain.made.function("Main", &endless), 10ms);
    task.watchdog = 2ms;
    struct RunningClock final : Clock {
        int64_t now = 0;
        int64_t nowNs() override { return now += 500'000; }
    } clock;
    Settings settings;
    settings.loopBudgetPerScan = 1000;
    settings.clock = &clock;
    const auto program = plain.made.finish();
    for (const bool isRealTime : {false, true}) {
        Controller controller(program, settings);
        controller.start();
        EXPECT_FALSE(isRealTime ? controller.scan(0ns) : controller.scan());
        ASSERT_TRUE(controller.fault());
        EXPECT_EQ(controller.fault()->code, FaultCode::Watchdog);
        EXPECT_NE(controller.fault()->message.english().find(isRealTime ? "watchdog time of T#2ms"
                                                                        : "more than 1000 units of work"),
                  std::string::npos)
            << controller.fault()->message.english();
    }
}

TEST(Controller, WatchdogSensitivityCountsConsecutiveOverruns) {
    Plain plain;
    FakeClock clock;
    workClock = &clock;
    image::Task& task = plain.made.task("main", plain.made.function("Main", &slow), 10ms);
    task.watchdog = 2ms;
    task.watchdogSensitivity = 3;
    Settings settings;
    settings.clock = &clock;
    Controller controller(plain.made.finish(), settings);
    controller.start();
    EXPECT_TRUE(controller.scan(0ms));
    EXPECT_TRUE(controller.scan(10ms));
    EXPECT_FALSE(controller.scan(20ms));
    const TaskStatistics statistics = controller.statistics().at(0);
    EXPECT_EQ(statistics.lastNs, 3'000'000);
    EXPECT_EQ(statistics.histogram.at(12), 3u); // 2048..4095 µs
}

TEST(Controller, RealTimeSkipsInstantsThatAreOverAndCountsThem) {
    Plain plain;
    plain.made.task("fast", plain.made.function("Fast", &countUp), 10ms);
    Controller controller(plain.made.finish());
    Recorder recorder;
    controller.addObserver(recorder);
    controller.start();
    EXPECT_TRUE(controller.scan(0ms));
    EXPECT_TRUE(controller.scan(7ms)); // nothing due yet
    EXPECT_EQ(recorder.scans.size(), 1u);
    EXPECT_TRUE(controller.scan(12ms));
    EXPECT_EQ(recorder.scans.back().time, 10'000'000);
    EXPECT_TRUE(controller.scan(57ms)); // 20, 30, 40 passed unused
    EXPECT_EQ(recorder.scans.back().time, 50'000'000);
    EXPECT_EQ(controller.statistics().at(0).overruns, 3u);
    EXPECT_EQ(controller.skippedScans(), 3u);
    EXPECT_EQ(controller.statistics().at(0).jitterNs, 7'000'000);
    EXPECT_EQ(controller.nextDue(), 60ms);
}

TEST(Controller, ForcesHoldBeforeAndAfterTasksSurviveResetAndRefuseWrites) {
    Plain plain;
    plain.made.task("main", plain.made.function("Main", &countUp), 10ms);
    Controller controller(plain.made.finish());
    controller.start();
    ASSERT_TRUE(controller.force("count", integer(TypeKind::Int, 40)));
    ASSERT_TRUE(controller.force("%QX0.0", integer(TypeKind::Bool, 0)));
    (void)controller.scan();
    EXPECT_EQ(controller.read("count")->integer(), 40); // 41 inside the scan, forced again behind it
    EXPECT_FALSE(controller.read("lamp")->isTrue());
    const Result<void> refused = controller.write("count", integer(TypeKind::Dint, 1));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().message.english(), "count is forced; release the force before writing");
    EXPECT_FALSE(controller.write("count.3", integer(TypeKind::Bool, 1)));
    controller.reset(ResetKind::Origin);
    EXPECT_EQ(controller.read("count")->integer(), 40);
    EXPECT_EQ(controller.forces().size(), 2u);
    ASSERT_TRUE(controller.release("count"));
    EXPECT_FALSE(controller.release("count"));
    controller.start();
    (void)controller.scan();
    EXPECT_EQ(controller.read("count")->integer(), 41);
    controller.releaseAll();
    (void)controller.scan();
    EXPECT_TRUE(controller.read("lamp")->isTrue());
}

TEST(Controller, WritesThatDoNotFitAreRefusedInWords) {
    Plain plain;
    const types::TypeId range = plain.made.types().subrange(TypeTable::of(TypeKind::Int), 0, 10);
    plain.made.add("small", range);
    plain.made.add("text", plain.made.types().string(5));
    plain.made.add("real", TypeKind::Real);
    plain.made.add("delay", TypeKind::Time);
    plain.made.add("fixed", TypeKind::Int).constant = true;
    Controller controller(plain.made.finish());
    struct Row {
        const char* path;
        Value value;
        const char* message; // "" = good
    };
    const Row rows[] = {
        {"mode", integer(TypeKind::Dint, 70000),
         "70000 does not fit into a variable of type INT; enter a value in its range"},
        {"mode", integer(TypeKind::Dint, -32768), ""},
        {"mode", Value{TypeTable::of(TypeKind::Lreal), 2.5},
         "2.5 does not fit into a variable of type INT; enter a value in its range"},
        {"mode", Value{TypeTable::of(TypeKind::Lreal), 2.0}, ""},
        {"real", integer(TypeKind::Int, 3), ""},
        {"small", integer(TypeKind::Int, 12), "12 is outside 0..10; enter a value in this range"},
        {"text", Value{plain.made.types().string(80), std::string("abcdef")},
         "the text has 6 characters, the maximum is 5; shorten it"},
        {"text", Value{{}, std::string("abc")}, ""},
        {"delay", integer(TypeKind::Time, 5), ""},
        {"delay", integer(TypeKind::Int, 5), "5 does not fit into a variable of type TIME; enter a value in its range"},
        {"lamp", integer(TypeKind::Int, 2), "2 does not fit into a variable of type BOOL; enter a value in its range"},
        {"fixed", integer(TypeKind::Int, 2), "a constant cannot be written; change it in the program"},
        {"moude", integer(TypeKind::Int, 2), "there is no variable 'moude'; did you mean 'mode'?"},
    };
    for (const Row& row : rows) {
        const Result<void> done = controller.write(row.path, row.value);
        EXPECT_EQ(done ? "" : done.error().message.english(), row.message) << row.path;
    }
    EXPECT_EQ(controller.read("text")->data, Value({}, std::string("abc")).data);
    EXPECT_EQ(controller.read("real")->real(), 3.0);
}

// ---------------------------------------------------------------- simulation

void plant(RuntimeContext* context, std::byte* image, uint32_t instance) {
    ++at<int32_t>(image, instance);
    image[64] = std::byte((static_cast<unsigned>(image[80]) & 1)); // ready follows the lamp
    if (at<int32_t>(image, instance) == 1000) {
        context->fault = FaultCode::DivisionByZero;
        context->faultSite = 0;
        runtimeSymbols().fault(context);
    }
}

struct WithPlant : Plain {
    uint32_t plantAt;
    std::shared_ptr<image::CompiledProgram> program;
    WithPlant() {
        const types::TypeId type = made.structure("Plant", {HandMade::field("runs", TypeKind::Dint)}, TypeKind::Block);
        image::Root& root = made.add("plant", type, Area::Program);
        root.isSimulation = true;
        plantAt = root.offset;
        const size_t index = made.layout().roots.size() - 1;
        made.task("main", made.function("Main", &countUp), 10ms);
        image::Task& task = made.task("sim", made.function("Plant", &::plc::controller::plant, type), 0ms, 0, index);
        task.kind = image::TaskKind::Freewheeling;
        task.isSimulation = true;
        program = made.finish();
    }
};

TEST(Controller, ThePlantRunsInTheInputPhaseGoesOnWhenStoppedAndRestartsByOriginOnly) {
    WithPlant with;
    Controller controller(with.program);
    EXPECT_TRUE(controller.hasSimulation());
    (void)controller.scan(); // before the start: only the plant
    EXPECT_EQ(controller.read("plant.runs")->integer(), 1);
    EXPECT_EQ(controller.read("count")->integer(), 0);
    controller.start();
    (void)controller.scan();
    EXPECT_FALSE(controller.read("ready")->isTrue()); // the plant saw the outputs of the scan before
    (void)controller.scan();
    EXPECT_TRUE(controller.read("ready")->isTrue());
    controller.stop();
    EXPECT_FALSE(controller.read("lamp")->isTrue());
    (void)controller.scan();
    EXPECT_FALSE(controller.read("ready")->isTrue());
    EXPECT_EQ(controller.read("plant.runs")->integer(), 4);
    controller.reset(ResetKind::Cold);
    EXPECT_EQ(controller.read("plant.runs")->integer(), 4);
    EXPECT_EQ(controller.read("count")->integer(), 0);
    EXPECT_EQ(controller.nextScan(), 4u);
    controller.reset(ResetKind::Origin);
    EXPECT_EQ(controller.read("plant.runs")->integer(), 0);
    EXPECT_EQ(controller.nextScan(), 0u);
    EXPECT_EQ(controller.nextDue(), 0ms);
}

TEST(Controller, AFaultOfThePlantStopsThePlantAlone) {
    WithPlant with;
    Controller controller(with.program);
    controller.start();
    for (int i = 0; i < 1005; ++i) EXPECT_TRUE(controller.scan());
    EXPECT_EQ(controller.state(), State::Running);
    EXPECT_FALSE(controller.fault());
    ASSERT_TRUE(controller.simulationFault());
    EXPECT_TRUE(controller.simulationFault()->isSimulation);
    EXPECT_EQ(controller.simulationFault()->calls.at(0).instance, "plant");
    EXPECT_EQ(controller.read("plant.runs")->integer(), 1000);
    EXPECT_EQ(controller.read("count")->integer(), 1005);
}

// ---------------------------------------------------------------- reset, first scan, going back

TEST(Controller, ResetsKeepWhatTheirKindKeeps) {
    Plain plain;
    plain.made.add("hours", TypeKind::Dint).retain = true;
    image::Root& recipe = plain.made.add("recipe", TypeKind::Dint);
    recipe.retain = recipe.persistent = true;
    types::Field kept = HandMade::field("kept", TypeKind::Int);
    kept.retain = true;
    const types::TypeId block =
        plain.made.structure("Counter", {HandMade::field("lost", TypeKind::Int), kept}, TypeKind::Block);
    plain.made.add("counters", plain.made.types().array({types::Dimension{1, 2}}, block));
    plain.made.task("main", plain.made.function("Main", &countUp), 10ms);
    Controller controller(plain.made.finish());
    const auto fill = [&] {
        for (const char* path : {"count", "hours", "recipe", "counters[2].lost", "counters[2].kept"})
            EXPECT_TRUE(controller.write(path, integer(TypeKind::Int, 9)));
    };
    const auto values = [&] {
        std::string text;
        for (const char* path : {"count", "hours", "recipe", "counters[2].lost", "counters[2].kept"})
            text += std::to_string(controller.read(path)->integer());
        return text;
    };
    fill();
    EXPECT_EQ(controller.retained().size(), 4u);
    EXPECT_EQ(controller.retained(true).size(), 1u);
    controller.reset(ResetKind::Warm);
    EXPECT_EQ(values(), "09909");
    fill();
    controller.reset(ResetKind::Cold);
    EXPECT_EQ(values(), "00900");
    fill();
    controller.reset(ResetKind::Origin);
    EXPECT_EQ(values(), "00000");
}

TEST(Controller, ResumingFromARecordedScanGivesTheSameImagesAgain) {
    Plain plain;
    plain.made.task("fast", plain.made.function("Fast", &countUp), 10ms);
    plain.made.task("slow", plain.made.function("Slow", &second), 25ms, 1);
    image::Task& event = plain.made.task("event", plain.made.function("Event", &third), 0ms, 2);
    event.kind = image::TaskKind::Event;
    event.trigger = image::Place{TypeTable::of(TypeKind::Bool), kCount, 1}; // bit 1 of count
    Controller controller(plain.made.finish());
    Recorder first, again;
    controller.addObserver(first);
    controller.start();
    for (int i = 0; i < 60; ++i) (void)controller.scan();
    for (size_t from = 0; from < 59; from += 7) {
        Controller other(controller.sharedProgram());
        again.scans.clear();
        other.addObserver(again);
        other.resumeFrom(controller.sharedProgram(), first.scans[from].image, first.scans[from].number,
                         Nanoseconds(first.scans[from].time));
        EXPECT_EQ(other.state(), State::Paused);
        other.start();
        for (size_t i = from + 1; i < 60; ++i) (void)other.scan();
        for (size_t i = from + 1; i < 60; ++i) {
            const Recorder::Scan& a = first.scans[i];
            const Recorder::Scan& b = again.scans[i - from - 1];
            ASSERT_EQ(a.number, b.number);
            ASSERT_EQ(a.time, b.time);
            ASSERT_TRUE(
                std::equal(a.image.begin(), a.image.begin() + controller.program().layout.dataEnd, b.image.begin()))
                << "scan " << i << " after resuming from " << from;
        }
    }
}

TEST(Controller, TwoRunsInVirtualTimeAreEqualBitForBitWhateverTheClockSays) {
    Plain plain;
    FakeClock clock;
    workClock = &clock;
    plain.made.task("main", plain.made.function("Main", &slow), 10ms);
    const auto program = plain.made.finish();
    Settings settings;
    settings.clock = &clock;
    Controller a(program, settings), b(program);
    a.start();
    b.start();
    for (int i = 0; i < 100; ++i) EXPECT_TRUE(a.scan() && b.scan());
    EXPECT_TRUE(std::equal(a.image().begin(), a.image().end(), b.image().begin()));
}

// ---------------------------------------------------------------- the site hook

void withSite(RuntimeContext* context, std::byte* image, uint32_t instance) {
    append(image, 1);
    if (context->siteFlags[1]) runtimeSymbols().atSite(context, 1, instance, 0);
    append(image, 2);
}

TEST(Controller, TheSiteHookMayLeaveTheScan) {
    Plain plain;
    const uint32_t function = plain.made.function("Main", &withSite);
    plain.made.site(function, {});
    plain.made.task("main", function, 10ms);
    Controller controller(plain.made.finish());
    int hooks = 0;
    bool abandon = false;
    controller.setSiteHook([&](uint32_t site, uint32_t, uint32_t) {
        ++hooks;
        EXPECT_EQ(site, 1u);
        controller.setHalted(true);
        EXPECT_EQ(controller.state(), State::Halted);
        EXPECT_EQ(controller.callPath(site).size(), 1u);
        controller.setHalted(false);
        if (abandon) controller.abandonScan();
    });
    controller.start();
    EXPECT_TRUE(controller.scan());
    EXPECT_EQ(hooks, 0);
    controller.siteFlags()[1] = 1;
    EXPECT_TRUE(controller.scan());
    EXPECT_EQ(hooks, 1);
    abandon = true;
    EXPECT_FALSE(controller.scan());
    EXPECT_EQ(controller.state(), State::Stopped);
    EXPECT_FALSE(controller.fault());
    EXPECT_EQ(controller.nextScan(), 2u);
    EXPECT_EQ(controller.nextDue(), 20ms);
    EXPECT_EQ(controller.read("order")->integer(), 12121);
}

} // namespace
} // namespace plc::controller
