// A panel of 1,000 bound elements: what a frame costs when everything changes, what share of a core that is at 30
// frames a second, and how long opening takes. Figures to hold against: under half a core, under 500 ms.
#include "hmi/player/panel_player.h"
#include "hmi/web/web_panel.h"
#include "projects/session/session.h"

#include <QApplication>
#include <benchmark/benchmark.h>
#include <cmath>

namespace plc::hmi {
namespace {

constexpr int kElements = 1000;

struct Kind {
    ElementKind kind;
    const char* property;
    bool isBool;
};
constexpr Kind kKinds[] = {{ElementKind::NumericDisplay, "value", false},
                           {ElementKind::Lamp, "value", true},
                           {ElementKind::Bar, "value", false},
                           {ElementKind::NumericDisplay, "value", false},
                           {ElementKind::Symbol, "state", true},
                           {ElementKind::Progress, "value", false},
                           {ElementKind::Switch, "target", true},
                           {ElementKind::MultiState, "value", false},
                           {ElementKind::NumericEntry, "target", false},
                           {ElementKind::TankLevel, "value", false}};

/// 40 columns of 25 small elements on 1920 × 1080.
Panel bigPanel() {
    Panel panel;
    panel.set("size", Json::array({1920, 1080}));
    for (int i = 0; i < kElements; ++i) {
        const Kind& kind = kKinds[i % std::size(kKinds)];
        Element element =
            Element::make(kind.kind, QStringLiteral("e%1").arg(i), QRectF(4 + i % 40 * 48, 4 + i / 40 * 43, 44, 39));
        element.set(kind.property,
                    kind.isBool ? "Main.b[" + std::to_string(i) + "]" : "Main.r[" + std::to_string(i) + "]");
        if (element.descriptor().property("fontSize")) element.set("fontSize", 11);
        if (element.descriptor().property("showValue")) element.set("showValue", false);
        panel.elements().push_back(std::move(element));
    }
    return panel;
}

/// Seconds of work per second at 30 frames: the rate's inverse times 30.
void showShare(benchmark::State& state) {
    state.counters["core_at_30_per_s"] =
        benchmark::Counter(1 / 30.0, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// `every`: each n-th element changes from frame to frame.
void BM_Frame(benchmark::State& state) {
    HeldValues values;
    PanelView view;
    view.scene().setValues(&values);
    view.scene().setPanel(bigPanel());
    view.resize(1920, 1080);
    view.show();
    QApplication::processEvents();
    const int every = static_cast<int>(state.range(0));
    int frame = 0;
    for ([[maybe_unused]] auto _ : state) {
        ++frame;
        for (int i = frame % every; i < kElements; i += every) {
            values.set(QStringLiteral("Main.b[%1]").arg(i), Value::ofBool((frame / every + i) % 2));
            values.set(QStringLiteral("Main.r[%1]").arg(i), Value::ofReal(50 + 45 * std::sin(frame * 0.3 + i)));
        }
        view.frame();
        QApplication::processEvents();
    }
    showShare(state);
}
BENCHMARK(BM_Frame)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond)->UseRealTime();

driver::Built bigProgram() {
    driver::BuildInput input;
    input.files.push_back(
        {"main.st", "PROGRAM Main VAR b : ARRAY[0..999] OF BOOL; r : ARRAY[0..999] OF REAL; i, n : DINT; END_VAR\n"
                    "n := n + 1; FOR i := 0 TO 999 DO r[i] := 50.0 + 45.0 * SIN(DINT_TO_REAL(n) * 0.3 + "
                    "DINT_TO_REAL(i)); b[i] := (n + i) MOD 2 = 0; END_FOR;\nEND_PROGRAM\n"});
    return driver::build(input);
}

void BM_FrameOnController(benchmark::State& state) {
    driver::Built built = bigProgram();
    if (!built.program) return state.SkipWithError("the program has errors");
    PanelProject project;
    project.panels.push_back({QStringLiteral("big"), bigPanel()});
    project.startPanel = QStringLiteral("big");
    session::Session session(std::move(built));
    PanelPlayer player(project, &session);
    player.resize(1920, 1080);
    player.show();
    QApplication::processEvents();
    uint64_t scans = 0;
    for ([[maybe_unused]] auto _ : state) {
        state.PauseTiming();
        ++scans;
        session.runHere([&](const controller::Controller& controller) { return controller.nextScan() >= scans; });
        state.ResumeTiming();
        player.frame();
        QApplication::processEvents();
    }
    showShare(state);
}
BENCHMARK(BM_FrameOnController)->Unit(benchmark::kMillisecond);

/// What serving browsers costs: one frame of all of them, in which all elements change.
void BM_Browsers(benchmark::State& state) {
    driver::Built built = bigProgram();
    if (!built.program) return state.SkipWithError("the program has errors");
    PanelProject project;
    project.panels.push_back({QStringLiteral("big"), bigPanel()});
    project.startPanel = QStringLiteral("big");
    session::Session session(std::move(built));
    OperatorStation keeper(project, &session);
    web::PaintStore store;
    std::vector<std::unique_ptr<web::WebPanel>> browsers;
    for (int i = 0; i < state.range(0); ++i) {
        browsers.push_back(std::make_unique<web::WebPanel>(project, session, store, keeper));
        web::ClientMessage hello;
        hello.word = web::ClientWord::Hello;
        hello.number = 1;
        (void)browsers.back()->take(hello);
    }
    uint64_t scans = 0;
    qsizetype bytes = 0;
    for ([[maybe_unused]] auto _ : state) {
        state.PauseTiming();
        ++scans;
        session.runHere([&](const controller::Controller& controller) { return controller.nextScan() >= scans; });
        state.ResumeTiming();
        for (const auto& browser : browsers) bytes += browser->next(static_cast<qint64>(scans) * 33).frame.size();
    }
    state.counters["kB_a_frame"] =
        static_cast<double>(bytes) / 1000 / static_cast<double>(state.iterations() * state.range(0));
    showShare(state);
}
BENCHMARK(BM_Browsers)->Arg(1)->Arg(10)->Unit(benchmark::kMillisecond);

/// From the file's bytes to the first picture, with all expressions compiled.
void BM_Open(benchmark::State& state) {
    driver::Built built = bigProgram();
    if (!built.program) return state.SkipWithError("the program has errors");
    const std::string bytes = bigPanel().write();
    for ([[maybe_unused]] auto _ : state) {
        state.PauseTiming();
        auto session = std::make_unique<session::Session>(built); // with no expression compiled yet
        state.ResumeTiming();
        {
            PanelProject project;
            project.panels.push_back({QStringLiteral("big"), *Panel::parse(bytes, QStringLiteral("big"))});
            project.startPanel = QStringLiteral("big");
            PanelPlayer player(project, session.get());
            player.resize(1920, 1080);
            player.show();
            player.frame();
            QApplication::processEvents();
        }
        state.PauseTiming();
        session.reset();
        state.ResumeTiming();
    }
}
BENCHMARK(BM_Open)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace plc::hmi

int main(int argc, char** argv) {
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
