// The bodies, included once per program. Broken promises abort: libFuzzer and the test runner both see that.
#pragma once
#include "tests/fuzz/inputs.h"
#include "tests/fuzz/promise.h"

#include "editor/trace/recording/run_recording.h"
#include "editor/trace/setup/trace_setup.h"
#include "hmi/alarms/alarm_file.h"
#include "hmi/check/panel_check.h"
#include "hmi/people/people_file.h"
#include "hmi/recipes/recipe_file.h"
#include "hmi/texts/text_table.h"
#include "hmi/texts/xliff.h"
#include "hmi/view/element_factory.h"
#include "hmi/view/scene/panel_scene.h"
#include "projects/devices/configuration/device_check.h"
#include "projects/exchange/import.h"
#include "projects/exchange/plcopen/plcopen_export.h"
#include "projects/storage/project_file.h"
#include "projects/waveform/table.h"
#include "runtime/base/messages.h"
#include "runtime/controller/retain.h"

#include <QImage>
#include <QPainter>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace plc::fuzz {

/// A folder of this process, removed at its end; in memory where there is such a place.
class Scratch {
public:
    Scratch()
        : m_folder((std::filesystem::exists("/dev/shm") ? std::filesystem::path("/dev/shm")
                                                        : std::filesystem::temp_directory_path()) /
                   ("stepwise_inputs_" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(m_folder / "src");
        write("src/main.st", "PROGRAM Main VAR x : INT; END_VAR x := x + 1; END_PROGRAM\n");
    }
    ~Scratch() {
        std::error_code none;
        std::filesystem::remove_all(m_folder, none);
    }
    std::string write(const char* name, const std::string& bytes) const {
        std::ofstream(m_folder / name, std::ios::binary | std::ios::trunc)
            .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return (m_folder / name).string();
    }
    std::string path() const { return m_folder.string(); }

private:
    std::filesystem::path m_folder;
};

inline const Scratch& scratch() {
    static const Scratch folder;
    return folder;
}

void readPanel(const std::string& bytes) {
    const auto panel = hmi::Panel::parse(bytes, QStringLiteral("p"));
    if (!panel) return;
    const std::string written = panel->write();
    const auto again = hmi::Panel::parse(written, QStringLiteral("p"));
    promise(bool(again) && again->write() == written);
    for (const hmi::Element& element : panel->elements()) {
        (void)panel->withDescendants(element.id());
        (void)panel->childrenOf(element.id());
        (void)element.rect();
    }
    hmi::PanelScene scene{hmi::makeElementView};
    hmi::HeldValues values;
    scene.setValues(&values);
    scene.setPanel(*panel);
    scene.refresh(0);
    scene.refresh(500);
    QImage image(320, 240, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::white);
    QPainter painter(&image);
    scene.paint(painter, QRectF(image.rect()));
    painter.end();
    for (const QPointF at : {QPointF(20, 20), QPointF(160, 120)}) {
        scene.press(at);
        scene.move(at + QPointF(5, 5));
        scene.release(at);
    }
    hmi::CheckInput input;
    input.panels.push_back({QStringLiteral("p"), *panel});
    (void)hmi::checkPanels(input);
}

void readTexts(const std::string& bytes) {
    const auto table = hmi::TextTable::parse(bytes, QStringLiteral("texts.csv"));
    if (!table) return;
    const std::string written = table->write();
    const auto again = hmi::TextTable::parse(written, QStringLiteral("texts.csv"));
    promise(bool(again) && again->write() == written);
    (void)table->listPrefixes();
}

void readAlarms(const std::string& bytes) {
    const auto file = hmi::AlarmFile::parse(bytes, QStringLiteral("alarms.json"));
    if (!file) return;
    (void)file->definitions();
    (void)file->classes();
    const std::string written = file->write();
    const auto again = hmi::AlarmFile::parse(written, QStringLiteral("alarms.json"));
    promise(bool(again) && again->write() == written);
}

void readTraceSetup(const std::string& bytes) {
    const auto setup = trace::readSetup(bytes, "t");
    if (!setup) return;
    const std::string written = trace::writeSetup(*setup);
    const auto again = trace::readSetup(written, "t");
    promise(bool(again) && trace::writeSetup(*again) == written);
}

void readProjectFile(const std::string& bytes) {
    scratch().write("project.json", bytes);
    const auto project = projects::openProject({scratch().path()});
    if (!project) return;
    scratch().write("project.json", project->json.dump(2));
    promise(bool(projects::openProject({scratch().path()})));
}

void readRecording(const std::string& bytes) {
    const auto recording = trace::RunRecording::open(scratch().write("a.stwrec", bytes));
    if (!recording) return;
    const auto [first, end] = (*recording)->extent();
    (void)(*recording)->samples("Main.x", first, std::min(end, first + 1000));
    (void)(*recording)->recordedRun()->history().seek(first);
    (void)(*recording)->stamp(end);
    (void)(*recording)->marks();
}

void readRetainFile(const std::string& bytes) { (void)controller::loadRetain(scratch().write("a.retain", bytes)); }

void readRecipes(const std::string& bytes) {
    auto file = hmi::RecipeFile::parse(bytes, QStringLiteral("recipes.json"));
    if (!file) return;
    const std::string written = file->write();
    const auto again = hmi::RecipeFile::parse(written, QStringLiteral("recipes.json"));
    promise(bool(again) && again->write() == written);
    for (hmi::Recipe& recipe : file->recipes()) {
        (void)hmi::recipeFromCsv(recipe, bytes, QStringLiteral("recipe.csv"));
        (void)hmi::recipeFromCsv(recipe, hmi::recipeToCsv(recipe), QStringLiteral("recipe.csv"));
    }
}

void readPeople(const std::string& bytes) {
    const auto file = hmi::PeopleFile::parse(bytes, QStringLiteral("people.json"));
    if (!file) return;
    const std::string written = file->write();
    const auto again = hmi::PeopleFile::parse(written, QStringLiteral("people.json"));
    promise(bool(again) && again->write() == written);
}

void readTranslations(const std::string& bytes) {
    const auto file = hmi::readXliff(bytes, QStringLiteral("texts.xlf"));
    if (!file) return;
    auto table = hmi::TextTable::parse("key,comment,en,de\na,,Start,\nb,,Level %d,\n", QStringLiteral("texts.csv"));
    promise(bool(table));
    (void)hmi::takeXliff(*table, *file, QStringLiteral("texts.xlf"));
    (void)hmi::TextTable::parse(table->write(), QStringLiteral("texts.csv"));
}

void readDevices(const std::string& bytes) {
    devices::DeviceFile file = devices::DeviceFile::parse(bytes);
    (void)devices::checkDevices(file, nullptr, {});
    promise(devices::DeviceFile::parse(file.text()).devices() == file.devices());
}

void readForeignTrace(const std::string& bytes) { (void)waveform::parseTable(bytes); }

void readForeignProject(const std::string& bytes) {
    if (bytes.empty()) return;
    constexpr const char* kNames[] = {"a.xml", "a.TcPOU", "a.EXP", "a.TcTTO"};
    const auto imported = exchange::importFrom(
        scratch().write(kNames[static_cast<unsigned char>(bytes[0]) % std::size(kNames)], bytes.substr(1)));
    if (!imported) return;
    const projects::Project project = exchange::toProject(*imported);
    for (const exchange::Edition edition : {exchange::Edition::Codesys0200, exchange::Edition::Plain0201})
        if (const auto exported = exchange::exportPlcopen(project, {edition, "2000-01-01T00:00:00"})) {
            const auto back = exchange::importFrom(scratch().write("b.xml", exported->text));
            // a text without a unit is a project, but none that can be exported
            promise(back || back.error().message.form() == errors::ImportNothing().form());
        }
}

} // namespace plc::fuzz
