// The panels of the shipped examples: canonical on disk, without findings that are errors, and drawn in every language.
#include "running.h"
#include "tests/support/paths.h"

#include "projects/storage/project_file.h"

#include <QDir>

namespace plc::hmi {
namespace {

QStringList examplesWithPanels() {
    const QDir folder(QString::fromStdString(plc::sourceDir() + "/projects/examples"));
    QStringList out;
    for (const QString& name : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name))
        if (!QDir(folder.filePath(name + QStringLiteral("/hmi"))).entryList({QStringLiteral("*.panel.json")}).isEmpty())
            out += folder.filePath(name);
    return out;
}

TEST(Examples, PanelsTextsAndAlarmsAreCanonicalAndWithoutErrors) {
    for (const QString& path : examplesWithPanels()) {
        const auto project = projects::openProject({path.toStdString()});
        ASSERT_TRUE(project) << project.error().english();
        const PanelProject panels = loadPanelProject(*project);
        if (qEnvironmentVariableIsSet("STEPWISE_FORMAT")) {
            ASSERT_TRUE(formatPanels(panels));
        }
        for (const Error& problem : panels.problems) ADD_FAILURE() << problem.english();
        for (const NamedPanel& panel : panels.panels)
            EXPECT_EQ(panel.panel.write(), *projects::readFile(panels.panelPath(panel.name).toStdString()))
                << path.toStdString();
        if (panels.hasTexts) {
            EXPECT_EQ(panels.texts.table().write(), *projects::readFile(panels.textsPath().toStdString()))
                << path.toStdString();
        }
        if (panels.hasAlarms) {
            EXPECT_EQ(panels.alarms.write(), *projects::readFile(panels.alarmsPath().toStdString()))
                << path.toStdString();
        }
        const driver::Checked checked = driver::check(project->buildInput());
        for (const Finding& finding : checkPanels(panels, checked))
            if (finding.isError || finding.kind == FindingKind::TextTooLong ||
                finding.kind == FindingKind::MissingTranslation || finding.kind >= FindingKind::WrongCheckSetting)
                ADD_FAILURE() << path.toStdString() << ": " << finding.text().toStdString();
    }
}

TEST(Examples, AlarmTextsFollowTheLanguageThatTheProgramChooses) {
    const auto project = projects::openProject({plc::sourceDir() + "/projects/examples/alarm_texts"});
    ASSERT_TRUE(project);
    const PanelProject panels = loadPanelProject(*project);
    driver::Built built = driver::build(project->buildInput());
    ASSERT_TRUE(built.program) << built.failure.english();
    session::Session session(std::move(built));
    const auto runFor = [&](int seconds) {
        const auto until = session.status().time + std::chrono::seconds(seconds);
        session.runHere([&](const controller::Controller& controller) { return controller.lastTime() >= until; });
    };
    const auto write = [&](const char* path, double value) {
        const auto target = session.expression(path);
        ASSERT_TRUE(target);
        ASSERT_TRUE(session.controller().write(path, *toPlc(target->types(), target->type(), Value::ofReal(value))));
    };
    session.controller().start();
    write("Panel.Site", 1); // turned to the visitor and back: the site's language
    runFor(1);
    write("Panel.Site", 0);
    write("Panel.Start", 1);
    runFor(1);
    write("Panel.Start", 0);
    write("Plant.Load", 130);
    runFor(5);
    PanelPlayer player(panels, &session);
    player.show();
    player.alarmWatch()->catchUp();
    player.frame();
    EXPECT_EQ(player.language().toStdString(), "da");
    const std::vector<AlarmEntry> present = player.alarms().present({}, AlarmOrder::Priority);
    ASSERT_EQ(present.size(), 1u);
    EXPECT_EQ(present[0].id.toStdString(), "12004");
    for (const auto& [tag, text] :
         {std::pair{"en-GB", "Motor 1: overload, 130 %"}, std::pair{"da", "Motor 1: overbelastet, 130 %"},
          std::pair{"de", "Motor 1: Überlast, 130 %"}, std::pair{"es", "Motor 1: sobrecarga, 130 %"},
          std::pair{"en-US", "Motor 1: overloaded, 130 %"}})
        EXPECT_EQ(AlarmBook::render(present[0], panels.texts, QLatin1String(tag)).toStdString(), text);
    if (!qEnvironmentVariableIsSet("STEPWISE_PICTURES")) return;
    PictureOptions options;
    options.folder = qEnvironmentVariable("STEPWISE_PICTURES") + QStringLiteral("/alarm_texts");
    EXPECT_TRUE(renderPanels(panels, &session, options));
}

} // namespace
} // namespace plc::hmi
