// Makes the pictures of charts: every shipped example that has one, idle and running, in the theme that is asked for.
// The charts are the studio's own views; the controller runs in virtual time, so that the same picture comes out again.
// Run by docs/pictures/chart.sh. usage: chart_pictures FOLDER light|dark
#include "editor/graph/chart/chart_view.h"
#include "editor/kit/theme.h"
#include "projects/session/session.h"
#include "projects/storage/project_file.h"
#include "runtime/compiler/jit/jit.h"
#include "tests/pictures/online_value.h"
#include "tests/support/paths.h"

#include <QApplication>
#include <QDir>

#include <cstdio>

using namespace plc;

namespace {

struct Press {
    const char* path;
    bool value;
    int atMs;
};
struct Shot {
    const char* project;
    const char* file;
    const char* unit;
    const char* instance;
    const char* name;
    std::vector<Press> presses;
    const char* until; // and the time after which the picture is taken all the same
    int forMs, moreMs;
};

const Shot kShots[] = {
    {"mix_2_brix",
     "src/mixer.st",
     "MixTwoBricks",
     "Main.mixer",
     "mix_2_brix",
     {{"Plant.Start", true, 0}, {"Plant.Start", false, 200}},
     "Main.mixer.WeighB.X",
     20000,
     600},
    {"gravel",
     "src/main.st",
     "Main",
     "Main",
     "gravel",
     {{"Plant.On", true, 0}, {"Plant.On", false, 200}, {"Plant.Fill", true, 300}},
     "Main.FillBin.X",
     8000,
     2500},
    {"agv",
     "src/main.st",
     "Main",
     "Main",
     "agv",
     {{"Plant.Single", true, 0}, {"Plant.Single", false, 300}},
     "Main.Reverse.X",
     12000,
     900},
    {"tank_heating",
     "src/main.st",
     "Chart",
     "Chart",
     "tank_heating",
     {{"Plant.Start", true, 0}},
     "Chart.Heating.X",
     900000,
     800},
    {"conveyor_sequence",
     "src/chart.st",
     "Chart",
     "Chart",
     "conveyor_sequence",
     {{"Plant.Start", true, 0}, {"Plant.Start", false, 200}},
     "Chart.Resting.X",
     12000,
     700},
    {"traffic_light", "src/chart.st", "Chart", "Chart", "traffic_light", {}, "Chart.Prepare.X", 60000, 900},
};

void save(editor::ChartView& view, const QString& folder, const Shot& shot, const char* state) {
    const QString path =
        QString("%1/chart_%2_%3_%4.png").arg(folder, shot.name, state, kit::colors().dark ? "dark" : "light");
    if (view.canvas().exportPng(path, 1.25))
        std::printf("%s\n", qPrintable(path));
    else
        std::fprintf(stderr, "%s cannot be written\n", qPrintable(path));
}

bool take(const Shot& shot, const QString& folder) {
    const auto project = projects::openProject({plc::sourceDir() + "/projects/examples/" + shot.project});
    if (!project) return std::fprintf(stderr, "%s\n", project.error().english().c_str()), false;
    driver::Built built = driver::build(project->buildInput());
    if (!built.program) return std::fprintf(stderr, "%s has errors\n", shot.project), false;
    std::string text;
    for (const driver::SourceFile& file : project->sources)
        if (file.path == shot.file) text = file.text;
    editor::ChartView view;
    view.setUnit(shot.unit);
    view.resize(6000, 4000);
    view.show();
    view.setText(text);
    QApplication::processEvents();
    view.canvas().setZoom(1);
    save(view, folder, shot, "idle");

    session::Session session(std::move(built));
    view.setValues(
        [&](const QString& expression) { return pictures::onlineValue(session, expression, shot.instance); });
    const auto until = session.expression(shot.until);
    if (!until) return std::fprintf(stderr, "%s: %s\n", shot.until, until.error().english().c_str()), false;
    view.setPast(true); // the last path by the time of the plant, not of the clock on the wall
    size_t pressed = 0;
    int64_t reached = -1;
    session.runHere([&](const controller::Controller& c) {
        const int64_t ms = c.lastTime().count() / 1'000'000;
        for (; pressed < shot.presses.size() && shot.presses[pressed].atMs <= ms; ++pressed)
            (void)session.controller().write(
                shot.presses[pressed].path,
                types::Value{types::TypeTable::of(types::TypeKind::Bool), int64_t(shot.presses[pressed].value)});
        if (reached < 0 && until->evaluate(c.image()).value.isTrue()) reached = ms;
        view.refreshOnline(); // every scan: the last path is what was taken
        return ms > shot.forMs || (reached >= 0 && ms >= reached + shot.moreMs);
    });
    if (reached < 0) std::fprintf(stderr, "%s: %s never came\n", shot.project, shot.until);
    save(view, folder, shot, "running");
    return true;
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    const QString folder = argc > 1 ? argv[1] : "docs/pictures";
    kit::Theme::install(application,
                        argc > 2 && QString(argv[2]) == "dark" ? kit::ThemeChoice::Dark : kit::ThemeChoice::Light);
    QDir().mkpath(folder);
    bool good = true;
    for (const Shot& shot : kShots) good = take(shot, folder) && good;
    return good ? 0 : 1;
}
