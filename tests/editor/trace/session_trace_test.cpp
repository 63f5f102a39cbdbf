// The trace over real programs: every sample is the value at that scan's end, the window may be late, going back, an
// online change and files keep the story straight; names complete from the compiled program.
#include "editor/plot/plot_view.h"
#include "editor/trace/curves/trace_feed.h"
#include "editor/trace/curves/trace_picture.h"
#include "editor/trace/recording/run_recording.h"
#include "editor/trace/setup/program_variables.h"
#include "editor/trace/trace_view.h"
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"
#include "tests/support/eventually.h"
#include "tests/support/patience.h"

#include <QApplication>
#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>

#include <gtest/gtest.h>

using namespace plc;
using namespace plc::trace;

namespace {

driver::Built build(const std::string& text) {
    static const bool once = (jit::setRuntimeSymbols(controller::runtimeSymbols()), true);
    (void)once;
    driver::BuildInput input;
    input.files.push_back({"main.st", text});
    driver::Built built = driver::build(input);
    std::string messages;
    for (const auto& d : built.checked.analysis->diagnostics) messages += d.message.english() + "\n";
    EXPECT_TRUE(built.program) << messages << built.failure.english();
    return built;
}

// Logs itself: what the trace shows must be what the program wrote down.
const char* const Logger = R"(
TYPE Phase : (Waiting, Filling, Emptying := 7); END_TYPE
PROGRAM Main
VAR
  n : DINT := -1;
  level : REAL;       // filling level [mm]
  phase : Phase;
  pulse : BOOL;
  elapsed : TIME;
  logLevel : ARRAY[0..1999] OF REAL;
  logPulse : ARRAY[0..1999] OF BOOL;
  logPhase : ARRAY[0..1999] OF DINT;
END_VAR
n := n + 1;
level := level + INT_TO_REAL(DINT_TO_INT(n MOD 7)) * 0.1 - 0.3;
pulse := n MOD 13 < 4;
elapsed := elapsed + T#1ms500us;
IF n MOD 30 < 10 THEN phase := Phase.Waiting; ELSIF n MOD 30 < 20 THEN phase := Phase.Filling; ELSE phase := Phase.Emptying; END_IF
IF n < 2000 THEN
  logLevel[n] := level;
  logPulse[n] := pulse;
  logPhase[n] := phase;
END_IF
END_PROGRAM
CONFIGURATION Plc
  RESOURCE Cpu ON Pc
    TASK Fast(INTERVAL := T#2ms, PRIORITY := 1);
    PROGRAM Main WITH Fast : Main;
  END_RESOURCE
END_CONFIGURATION
)";

void runScans(session::Session& session, int count) {
    controller::Controller& controller = session.controller();
    if (controller.state() != controller::State::Running) controller.start();
    for (int i = 0; i < count; ++i) ASSERT_TRUE(controller.scan());
}

std::vector<SignalSample> samplesOf(const TraceFeed& feed, const std::string& expression) {
    std::vector<SignalSample> out;
    const auto source = feed.source(expression);
    EXPECT_TRUE(source) << expression << ": " << feed.problem(expression);
    if (source)
        source->visit(INT64_MIN, INT64_MAX,
                      [&](std::span<const SignalSample> block) { out.insert(out.end(), block.begin(), block.end()); });
    return out;
}

double logged(session::Session& session, const std::string& name, size_t i) {
    const auto value = session.controller().read("Main." + name + "[" + std::to_string(i) + "]");
    EXPECT_TRUE(value);
    if (std::holds_alternative<double>(value->data)) return value->real();
    return static_cast<double>(value->integer());
}

} // namespace

TEST(SessionTrace, EverySampleIsWhatTheProgramWroteDown) {
    session::Session session(build(Logger));
    const RunRecording recording(session);
    TraceFeed feed(recording, std::make_shared<history::ColumnStore>());
    feed.setExpressions({"Main.level", "Main.pulse", "Main.phase", "Main.level * 2.0 + 1.0"});
    for (int i = 0; i < 20; ++i) { // the window comes now and then
        runScans(session, 100);
        feed.pump(std::chrono::milliseconds(2));
    }
    feed.pumpAll();
    const auto level = samplesOf(feed, "Main.level"), pulse = samplesOf(feed, "Main.pulse"),
               phase = samplesOf(feed, "Main.phase");
    const auto twice = samplesOf(feed, "Main.level * 2.0 + 1.0");
    ASSERT_EQ(level.size(), 2000u);
    ASSERT_EQ(twice.size(), 2000u);
    for (size_t i = 0; i < 2000; ++i) {
        ASSERT_EQ(level[i].time, static_cast<int64_t>(i) * 2'000'000);
        ASSERT_EQ(level[i].value, logged(session, "logLevel", i)) << i;
        ASSERT_EQ(pulse[i].value, logged(session, "logPulse", i)) << i;
        ASSERT_EQ(phase[i].value, logged(session, "logPhase", i)) << i;
        ASSERT_EQ(static_cast<float>(twice[i].value), static_cast<float>(level[i].value) * 2.0f + 1.0f) << i;
    }
    const ChannelType* type = feed.type("Main.phase");
    ASSERT_TRUE(type);
    EXPECT_EQ(type->valueNames, (std::map<int64_t, std::string>{{0, "Waiting"}, {1, "Filling"}, {7, "Emptying"}}));
    EXPECT_TRUE(feed.type("Main.pulse")->isBool);
    EXPECT_TRUE(feed.type("Main.level")->isSingle);
}

TEST(SessionTrace, ARunningPlcLosesNoScanWhileTheWindowIsBusy) {
    session::Session session(build(Logger));
    const RunRecording recording(session);
    TraceView view;
    view.resize(900, 500);
    view.setRecording(&recording);
    view.addChannel("Main.level");
    view.addChannel("Main.n");
    session.startThread({session::Pace::Factor, 4});
    view.show();
    for (int i = 0; i < 6; ++i) {
        const uint64_t before = session.status().scans;
        ASSERT_TRUE(QTest::qWaitFor([&] { return session.status().scans > before + 5; }, kPatience));
        ASSERT_TRUE(eventually([&] { return session.status().scans > before + 25; })); // busy with something else
        view.tick();
    }
    session.pause();
    ASSERT_TRUE(eventually([&] { return session.status().state != controller::State::Running; }));
    const uint64_t scans = session.status().scans;
    for (int i = 0; i < 50 && view.plot()->model().curves[1].source->countIn(0, INT64_MAX) < scans; ++i) view.tick();
    const auto source = view.plot()->model().curves[1].source;
    ASSERT_EQ(source->countIn(0, INT64_MAX), scans);
    double expected = 0;
    source->visit(INT64_MIN, INT64_MAX, [&](std::span<const SignalSample> block) {
        for (const SignalSample& s : block) ASSERT_EQ(s.value, expected++);
    });
    view.setRecording(nullptr);
}

namespace {

// Counts its scans; one scan takes far longer than the interval.
const char* const Late = R"(
PROGRAM Main
VAR n : DINT := -1; i : DINT; x : LREAL; burn : BOOL; END_VAR
n := n + 1;
IF burn THEN
  burn := FALSE;
  FOR i := 1 TO 3000000 DO x := SIN(x + 1.0); END_FOR
END_IF
END_PROGRAM
CONFIGURATION Plc
  RESOURCE Cpu ON Pc
    TASK Fast(INTERVAL := T#1ms, PRIORITY := 1);
    PROGRAM Main WITH Fast : Main;
  END_RESOURCE
END_CONFIGURATION
)";

} // namespace

TEST(SessionTrace, EveryExecutedScanOfOneMillisecondIsThereAndSkippedOnesAreCountedAndMarked) {
    session::Session session(build(Late));
    const RunRecording recording(session);
    TraceView view;
    view.resize(900, 500);
    view.setRecording(&recording);
    view.addChannel("Main.n");
    view.addChannel("Main.x");
    session.startThread({session::Pace::Real, 1});
    view.show();
    for (int i = 0; i < 8; ++i) {
        const uint64_t before = session.status().scans;
        ASSERT_TRUE(QTest::qWaitFor([&] { return session.status().scans > before + 5; }, kPatience));
        const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(80); // the window is busy
        double work = 0;
        while (std::chrono::steady_clock::now() < until) work = std::sin(work + 1);
        ASSERT_TRUE(std::isfinite(work));
        if (i == 3) session.write("Main.burn", types::Value{session.expression("Main.burn")->type(), int64_t(1)});
        view.tick();
    }
    session.pause();
    ASSERT_TRUE(eventually([&] { return session.status().state != controller::State::Running; }));
    const session::Status status = session.status();
    ASSERT_GT(status.scans, 200u);
    EXPECT_TRUE(QTest::qWaitFor([&] { return recording.statistics().scans == status.scans; }, kPatience));
    for (int i = 0; i < 100 && view.plot()->model().curves[0].source->countIn(0, INT64_MAX) < status.scans; ++i)
        view.tick();
    const auto source = view.plot()->model().curves[0].source;
    ASSERT_EQ(source->countIn(0, INT64_MAX), status.scans) << "every executed scan";
    double expected = 0;
    source->visit(INT64_MIN, INT64_MAX, [&](std::span<const SignalSample> block) {
        for (const SignalSample& s : block) ASSERT_EQ(s.value, expected++);
    });
    // What was executed and what was skipped fill the time, none is lost from sight.
    ASSERT_GT(status.skippedScans, 10u);
    EXPECT_EQ(status.scans + status.skippedScans, static_cast<uint64_t>(source->timeRange()->second / 1'000'000) + 1);
    uint64_t marked = 0;
    for (const history::Mark& mark : recording.marks())
        if (mark.kind == static_cast<int>(controller::EventKind::SkippedScans))
            marked += std::stoull(mark.text.english());
    EXPECT_EQ(marked, status.skippedScans);
    bool shown = false;
    for (const plot::PlotMarker& marker : view.plot()->model().markers)
        shown = shown || (marker.kind == plot::MarkerKind::SkippedScans && marker.text.contains("skipped"));
    EXPECT_TRUE(shown);
    view.setRecording(nullptr);
}

TEST(SessionTrace, LargeIntegersAndTimesAreExactInTableAndCsv) {
    session::Session session(build(R"(
PROGRAM Main
VAR big : LINT := 9007199254740993; top : ULINT := 18446744073709551614; long : LTIME := LTIME#200d0h0m0s0ms0us1ns; day : DT := DT#2026-01-02-03:04:05; small : DINT := 2000000001; END_VAR
big := big + 2; top := top + 1; long := long + LTIME#1ns; small := small + 1;
END_PROGRAM
)"));
    const RunRecording recording(session);
    runScans(session, 1);
    QTemporaryDir folder;
    TraceOutput out;
    out.setup = setupOf({"Main.big", "Main.top", "Main.long", "Main.small", "Main.day"});
    out.csv = folder.filePath("a.csv");
    out.wantsStatistics = true;
    runScans(session, 2);
    const auto text = renderTrace(recording, out);
    ASSERT_TRUE(text) << text.error().message.english();
    for (const char* exact : {"9007199254740995", "9007199254740999", "18446744073709551615", "17280000000.000002",
                              "2000000002", "2026-01-02-03:04:05"})
        EXPECT_NE(text->find(exact), std::string::npos) << exact << "\n" << *text;
    EXPECT_NE(text->find("−18446744073709551614"), std::string::npos) << "the difference over the turn\n" << *text;
    QFile csv(out.csv);
    ASSERT_TRUE(csv.open(QIODevice::ReadOnly));
    const QList<QByteArray> lines = csv.readAll().split('\n');
    ASSERT_GE(lines.size(), 4);
    EXPECT_TRUE(lines[1].contains(",9007199254740995,18446744073709551615,17280000000.000002,2000000002,"))
        << lines[1].constData();
    EXPECT_TRUE(lines[3].contains(",9007199254740999,1,17280000000.000004,2000000004,")) << lines[3].constData();
}

TEST(SessionTrace, TheTriggerSeesEveryScanHoweverFewAreDrawn) {
    session::Session session(build(Logger));
    const RunRecording recording(session);
    runScans(session, 100);
    TraceOutput out;
    out.setup = setupOf({"Main.level"});
    out.setup.every = 50;
    out.setup.trigger = {"Main.n = 33", TriggerEdge::Rising, TriggerMode::Single, 10'000'000, 10'000'000, {}};
    const auto text = renderTrace(recording, out);
    ASSERT_TRUE(text) << text.error().message.english();
    EXPECT_NE(text->find("Triggered at 0.066 s"), std::string::npos) << *text;
}

TEST(SessionTrace, GoingBackShowsTheNewBranch) {
    session::Session session(build(Logger));
    const RunRecording recording(session);
    TraceFeed feed(recording, std::make_shared<history::ColumnStore>());
    feed.setExpressions({"Main.n"});
    runScans(session, 300);
    feed.pumpAll();
    ASSERT_TRUE(session.resumeFrom(99));
    ASSERT_TRUE(session.controller().write(
        "Main.n", types::Value{session.program()->layout.find("Main.n")->type, int64_t(5000)}));
    runScans(session, 50);
    feed.pumpAll();
    const auto n = samplesOf(feed, "Main.n");
    ASSERT_EQ(n.size(), 150u);
    EXPECT_EQ(n[99].value, 99);
    EXPECT_EQ(n[100].value, 5001);
    EXPECT_EQ(n[100].time, n[99].time + 2'000'000);
    EXPECT_EQ(n.back().value, 5050);
}

TEST(SessionTrace, AnOnlineChangeLeavesAGapWhereThePathDidNotExist) {
    const std::string before = "PROGRAM Main VAR a : INT; END_VAR a := a + 1; END_PROGRAM";
    const std::string after = "PROGRAM Main VAR a : INT; b : INT; END_VAR a := a + 1; b := a * 2; END_PROGRAM";
    session::Session session(build(before));
    const RunRecording recording(session);
    TraceFeed feed(recording, std::make_shared<history::ColumnStore>());
    runScans(session, 100);
    feed.setExpressions({"Main.a", "Main.b"});
    feed.pumpAll();
    EXPECT_FALSE(feed.source("Main.b"));
    session.changeProgram(build(after), [](const controller::OnlineChangeReport&) {});
    runScans(session, 100);
    feed.retryProblems();
    feed.pumpAll();
    const auto a = samplesOf(feed, "Main.a"), b = samplesOf(feed, "Main.b");
    ASSERT_EQ(a.size(), 200u);
    EXPECT_EQ(a.back().value, 200) << "the variable went on counting";
    ASSERT_FALSE(b.empty());
    EXPECT_LE(b.size(), 101u);
    EXPECT_GE(b.front().time, a[99].time);
    const auto gaps = feed.source("Main.b")->gaps(INT64_MIN, INT64_MAX);
    ASSERT_EQ(gaps.size(), 1u);
    EXPECT_EQ(gaps[0].reason, SignalGap::Reason::NoPath);
}

TEST(SessionTrace, ASavedRecordingDrawsTheSame) {
    QTemporaryDir folder;
    const std::string file = folder.filePath("run.rec").toStdString();
    session::Session session(build(Logger));
    runScans(session, 500);
    ASSERT_TRUE(session.history().save(file));
    const auto opened = RunRecording::open(file);
    ASSERT_TRUE(opened) << opened.error().english();
    const RunRecording live(session);
    TraceFeed a(live, std::make_shared<history::ColumnStore>()), b(**opened, std::make_shared<history::ColumnStore>());
    for (TraceFeed* feed : {&a, &b}) {
        feed->setExpressions({"Main.level", "Main.phase", "Main.pulse AND Main.n > 100"});
        feed->pumpAll();
    }
    for (const char* expression : {"Main.level", "Main.phase", "Main.pulse AND Main.n > 100"})
        EXPECT_EQ(samplesOf(a, expression), samplesOf(b, expression)) << expression;
    EXPECT_EQ(live.find("Main.n = 123", 0, history::History::Direction::Forward),
              (*opened)->find("Main.n = 123", 0, history::History::Direction::Forward));
    EXPECT_FALSE((*opened)->typeOf("Main.nothing"));
    EXPECT_FALSE(RunRecording::open(folder.filePath("missing.rec").toStdString()));

    TraceOutput out;
    out.setup = setupOf({"Main.level", "Main.pulse", "Main.phase"});
    out.beneath = opened->get();
    out.picture = folder.filePath("a.png");
    const auto text = renderTrace(live, out);
    ASSERT_TRUE(text) << text.error().english();
    EXPECT_FALSE(QImage(out.picture).isNull());
}

TEST(SessionTrace, TheViewOpensSavesAndComparesRecordings) {
    QTemporaryDir folder;
    QDir(folder.path()).mkdir("traces");
    session::Session session(build(Logger));
    runScans(session, 300);
    const RunRecording live(session);
    ASSERT_TRUE(live.save(folder.filePath("old.rec").toStdString()));
    runScans(session, 300);
    TraceView view;
    view.setFolder(folder.filePath("traces"));
    view.setRecording(&live);
    view.addChannel("Main.n");
    auto count = [&] { return view.plot()->model().curves[0].source->countIn(0, INT64_MAX); };
    for (int i = 0; i < 20; ++i) view.tick();
    EXPECT_EQ(count(), 600u);

    ASSERT_TRUE(view.compareWith(folder.filePath("old.rec")));
    ASSERT_EQ(view.plot()->model().curves[0].beneath.size(), 1u);
    EXPECT_EQ(view.setup().compareWith, "old.rec") << "relative to the project";
    view.undoStack()->undo();
    EXPECT_TRUE(view.plot()->model().curves[0].beneath.empty());
    view.undoStack()->redo();
    EXPECT_EQ(view.plot()->model().curves[0].beneath.size(), 1u);

    ASSERT_TRUE(view.openRecording(folder.filePath("old.rec")));
    EXPECT_TRUE(view.showsFile());
    EXPECT_EQ(count(), 300u);
    view.setRecording(nullptr); // the PLC stops meanwhile
    EXPECT_EQ(count(), 300u);
    view.setRecording(&live);
    view.closeRecording();
    for (int i = 0; i < 20; ++i) view.tick();
    EXPECT_EQ(count(), 600u);
    EXPECT_FALSE(view.openRecording(folder.filePath("missing.rec")));
    EXPECT_FALSE(view.showsFile());
    view.setRecording(nullptr);
}

TEST(SessionTrace, ARangeInACommentIsNoUnit) {
    session::Session session(
        build("PROGRAM Main\nVAR\n a : REAL; // valve [0..100 %]\n b : INT; // depth [1..128]\n"
              " c : REAL; // [-10.5..+10.5 V]\n d : REAL; // [±3.4e38]\n e : REAL; // [m3/h]\n"
              " f : REAL; // [0..1000 mm]\nEND_VAR\nEND_PROGRAM\nCONFIGURATION Plc\nRESOURCE Cpu ON Pc\n"
              "TASK Fast(INTERVAL := T#10ms, PRIORITY := 1);\nPROGRAM Main WITH Fast : Main;\n"
              "END_RESOURCE\nEND_CONFIGURATION\n"));
    ProgramVariables variables;
    variables.setProgram(session.program());
    const std::pair<const char*, const char*> rows[] = {{"Main.a", "%"}, {"Main.b", ""},     {"Main.c", "V"},
                                                        {"Main.d", ""},  {"Main.e", "m3/h"}, {"Main.f", "mm"}};
    for (const auto& [path, unit] : rows) EXPECT_EQ(variables.unitOf(path).toStdString(), unit) << path;
}

TEST(SessionTrace, NamesCompleteAndUnitsComeFromComments) {
    session::Session session(build(Logger));
    ProgramVariables variables;
    variables.setProgram(session.program());
    EXPECT_EQ(variables.unitOf("Main.level"), "mm");
    EXPECT_EQ(variables.unitOf("main.LEVEL"), "mm");
    EXPECT_EQ(variables.unitOf("Main.pulse"), "");
    auto names = [&](const QString& text) {
        QStringList out;
        for (const kit::Completion& c : variables.complete(text, static_cast<int>(text.size()))) out += c.text;
        return out;
    };
    EXPECT_EQ(names("2.0 * Main.lev").value(0), "level");
    EXPECT_TRUE(names("Main.").contains("pulse"));
    EXPECT_EQ(names("Ma").value(0), "Main");
    EXPECT_EQ(names("elaps").value(0), "Main.elapsed") << "members are found by their own name";
    const auto found = variables.search("mlevel", 10);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].path, "Main.level");
    EXPECT_EQ(variables.children("Main.logLevel").size(), 1000u) << "long arrays are cut";
    EXPECT_EQ(variables.children("Main.logLevel")[3].path, "Main.logLevel[3]");
}
