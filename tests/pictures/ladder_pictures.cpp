// Draws the ladder and function block diagrams of docs/ladder.md with the studio's own view, idle and running.
// usage: ladder_pictures FOLDER light|dark
#include "editor/graph/ladder/ladder_view.h"
#include "editor/kit/theme.h"
#include "projects/session/session.h"
#include "projects/storage/project_file.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"
#include "runtime/inside/place_values.h"
#include "tests/pictures/online_value.h"
#include "tests/support/paths.h"

#include <QApplication>

#include <cstdio>

using namespace plc;

namespace {

struct Shot {
    const char* project;
    const char* file;
    const char* unit;
    const char* instance;
    const char* name;
    std::vector<const char*> pressed; // written once, before the first scan
    int64_t ms;                       // how long it runs
    bool isBlocks = false;
    int look = 0; // editor::LadderLook::bits
};

constexpr int kCircuit = 1, kComments = 2, kBoth = 2 << 3, kContrast = 32;

const Shot kShots[] = {
    {"workbook", "src/ladder.st", "LadderRungs", "LadderRungs", "rungs", {"LadderRungs.S1", "LadderRungs.S3"}, 2000},
    {"command_monitor", "src/ladder.st", "CmdMonitorLadder", "Main.drawn.FWD_MON", "monitor", {"Plant.Open"}, 4000},
    {"command_monitor", "src/ladder.st", "FwdRevMonBlocks", "Main.drawn", "blocks", {"Plant.Open"}, 4000, true},
    {"stack", "src/ladder.st", "StackLadder", "Main.drawn", "stack", {"Plant.Play"}, 1530},
    {"command_monitor",
     "src/ladder.st",
     "CmdMonitorLadder",
     "Main.drawn.FWD_MON",
     "circuit",
     {"Plant.Open"},
     4000,
     false,
     kCircuit | kComments | kBoth},
    {"command_monitor",
     "src/ladder.st",
     "CmdMonitorLadder",
     "Main.drawn.FWD_MON",
     "contrast",
     {"Plant.Open"},
     4000,
     false,
     kContrast},
};

/// What the last scan computed.
class LastScan final : public editor::ComputedValues {
public:
    LastScan(const session::Session& session, const std::string& file, const std::string& instance) {
        inside::Insight insight(session.history());
        const auto look = insight.look(session.history().statistics().end - 1);
        const auto& files = session.program()->sources.files;
        for (size_t i = 0; look && i < files.size(); ++i)
            if (files[i].path() == file) m_values = std::make_unique<inside::PlaceValues>(*look, FileId(i), instance);
    }
    [[nodiscard]] bool covers(SourceRange range) const override { return m_values && range.length() > 0; }
    [[nodiscard]] bool isExecuted(SourceRange range) const override { return m_values->isExecuted(range); }
    [[nodiscard]] std::optional<editor::GraphValue> at(SourceRange range) const override {
        const auto* found = m_values->at(range);
        if (!found) return std::nullopt;
        const types::TypeTable& types = *m_values->look().program().layout.types;
        editor::GraphValue value;
        value.text = QString::fromStdString(types::toText(types, found->value));
        value.isTrue = types.storageKind(found->value.type) == types::TypeKind::Bool && found->value.isTrue();
        return value;
    }

private:
    std::unique_ptr<inside::PlaceValues> m_values;
};

void save(editor::LadderView& view, const QString& folder, const Shot& shot, const char* state) {
    const QString path =
        QString("%1/ladder_%2_%3_%4.png").arg(folder, shot.name, state, kit::colors().dark ? "dark" : "light");
    const bool good = view.canvas().exportPng(path, 1.25);
    std::fprintf(good ? stdout : stderr, good ? "%s\n" : "%s cannot be written\n", qPrintable(path));
}

bool take(const Shot& shot, const QString& folder) {
    const auto project = projects::openProject({plc::sourceDir() + "/projects/examples/" + shot.project});
    if (!project) return std::fprintf(stderr, "%s\n", project.error().english().c_str()), false;
    driver::Built built = driver::build(project->buildInput());
    if (!built.program) return std::fprintf(stderr, "%s has errors\n", shot.project), false;
    std::string text;
    for (const driver::SourceFile& file : project->sources)
        if (file.path == shot.file) text = file.text;
    editor::LadderView view;
    view.setModel(analysis::CodeModel::make(project->buildInput()), shot.file);
    view.setUnit(shot.unit);
    view.setForm(shot.isBlocks ? ladder::Form::Blocks : ladder::Form::Ladder);
    view.setLook(editor::LadderLook::fromBits(shot.look));
    view.resize(3000, 6000);
    view.show();
    view.setText(text);
    QApplication::processEvents();
    view.canvas().setZoom(1);
    save(view, folder, shot, "idle");

    session::Session session(std::move(built));
    view.setValues(
        [&](const QString& expression) { return pictures::onlineValue(session, expression, shot.instance); });
    for (const char* path : shot.pressed)
        (void)session.controller().write(path, types::Value{types::TypeTable::of(types::TypeKind::Bool), int64_t(1)});
    session.runHere([&](const controller::Controller& c) { return c.lastTime().count() / 1'000'000 >= shot.ms; });
    const auto computed = std::make_shared<LastScan>(session, shot.file, shot.instance);
    view.setComputed([&] { return computed; });
    view.refreshOnline();
    save(view, folder, shot, "running");
    return true;
}

} // namespace

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    const QString folder = argc > 1 ? argv[1] : ".";
    const bool isDark = argc > 2 && QString(argv[2]) == "dark";
    kit::Theme::install(application, isDark ? kit::ThemeChoice::Dark : kit::ThemeChoice::Light);
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    bool good = true;
    for (const Shot& shot : kShots) good = take(shot, folder) && good;
    return good ? 0 : 1;
}
