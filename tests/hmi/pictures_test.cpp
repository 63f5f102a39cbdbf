// Pictures of the designer at work and of the check that finds a text too long, for the documentation
// (docs/pictures/panel.sh): the project with five languages, opened, run and drawn. STEPWISE_PICTURES names the folder.
#include "hmi/designer/canvas/outline.h"
#include "hmi/designer/panel_designer.h"
#include "running.h"
#include "tests/support/paths.h"

#include "editor/kit/theme.h"
#include "projects/storage/project_file.h"
#include "tests/support/settle.h"

#include <QAction>
#include <QApplication>

namespace plc::hmi {
namespace {

struct Opened {
    projects::Project project;
    PanelProject panels;
    driver::Built built;
    std::unique_ptr<DesignContext> context;
    std::unique_ptr<PanelDesigner> designer;

    Opened() {
        kit::Theme::install(*static_cast<QApplication*>(QCoreApplication::instance()), kit::ThemeChoice::Light);
        project = *projects::openProject({plc::sourceDir() + "/tests/hmi/languages"});
        panels = loadPanelProject(project);
        built = driver::build(project.buildInput());
        context = std::make_unique<DesignContext>(panels);
        context->setChecked(built.checked);
        designer = std::make_unique<PanelDesigner>(*context, QStringLiteral("tank"));
        designer->resize(1500, 900);
        designer->show();
        settle();
        designer->canvas().zoomToFit();
    }
    void save(const char* name) {
        settle();
        designer->grab().save(qEnvironmentVariable("STEPWISE_PICTURES") + u'/' + QLatin1String(name));
    }
};

TEST(Pictures, TheDesignerAtWork) {
    Opened opened;
    opened.designer->checkNow();
    for (const Finding& finding : opened.designer->findings()) EXPECT_EQ(finding.text().toStdString(), "");
    opened.designer->selection().set({QStringLiteral("temperature")});
    if (qEnvironmentVariableIsSet("STEPWISE_PICTURES")) opened.save("designer.png");
}

TEST(Pictures, TheCheckFindsATextThatDoesNotFit) {
    Opened opened;
    TextTable table = opened.panels.texts.table();
    table.setText(QStringLiteral("stop"), QStringLiteral("de"), QStringLiteral("Anlage geordnet abschalten"));
    table.setText(QStringLiteral("pump"), QStringLiteral("da"), QStringLiteral("Fødepumpe til råvaretank"));
    table.setText(QStringLiteral("batch"), QStringLiteral("de"), QStringLiteral("Charge Nummer {n:%d} von heute"));
    opened.context->setTable(table);
    opened.context->setLanguage(QStringLiteral("de"));
    opened.designer->checkNow();
    QStringList found;
    for (const Finding& finding : opened.designer->findings()) found += finding.element + u'/' + finding.language;
    EXPECT_TRUE(found.contains(QStringLiteral("pump/da"))) << found.join(u' ').toStdString();
    EXPECT_TRUE(found.contains(QStringLiteral("progress/de"))) << found.join(u' ').toStdString();
    opened.designer->selection().set({QStringLiteral("progress")});
    if (qEnvironmentVariableIsSet("STEPWISE_PICTURES")) opened.save("check.png");
}

} // namespace
} // namespace plc::hmi
