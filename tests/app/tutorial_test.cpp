// docs/tutorial.md, step by step: the program and the test are read from the page itself, so that it cannot go stale.
#include "tests/app/studio_fixture.h"
#include "tests/support/paths.h"
#include "tests/support/patience.h"

#include "app/documents/design_pages.h"
#include "app/panels/live_views.h"
#include "app/project/new_project.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/inputs/expression_edit.h"
#include "hmi/designer/canvas/palette.h"
#include "hmi/designer/editors/text_editor.h"
#include "hmi/designer/panel_designer.h"
#include "hmi/player/panel_player.h"
#include "projects/storage/project_file.h"
#include "projects/testing/test_run.h"

#include <QAction>
#include <QSignalSpy>
#include <QTreeWidget>

namespace plc::app {
namespace {

/// The n-th block of ST on the page.
std::string listing(int n) {
    const auto page = projects::readFile(plc::sourceDir() + "/docs/tutorial.md");
    size_t at = 0;
    for (int i = 0; i <= n; ++i) at = page->find("```iecst\n", at) + 9;
    return page->substr(at, page->find("```", at) - at);
}

TEST(Tutorial, ItsStepsWork) {
    QSettings("Stepwise", "Stepwise").clear();
    Settings().setSawTour();
    QTemporaryDir folder;
    const QString project = folder.path() + "/my_motor";
    ASSERT_TRUE(createProject(project.toStdString(), "My motor", "empty"));
    const auto waitFor = [](const std::function<bool()>& condition) { return QTest::qWaitFor(condition, kPatience); };
    MainWindow window;
    window.show();
    ASSERT_TRUE(window.openProject(project));
    ASSERT_TRUE(waitFor([&] { return window.workspace().model() != nullptr; }));

    // 2: the program
    editor::StEditor& editor = *window.tabs().currentEditor();
    const std::string old = editor.utf8();
    const auto end = static_cast<uint32_t>(old.find("END_PROGRAM\n") + 12);
    editor.applyEdits({{{FileId(), 0, end}, listing(0)}});

    // 3: run, write, watch, by the keys and the mouse as the page says
    QTest::keyClick(&window, Qt::Key_F5);
    ASSERT_TRUE(waitFor([&] { return window.control().status().scans > 3; }));
    window.showDock("watch");
    auto* entry = window.watch().findChild<kit::ExpressionEdit*>();
    ASSERT_NE(entry, nullptr);
    for (const char* name : {"Main.Start", "Main.Stop", "Main.Motor", "Main.RunTime"}) {
        QTest::keyClicks(entry, name);
        QTest::keyClick(entry, Qt::Key_Return);
    }
    ASSERT_EQ(window.watch().expressions().size(), 4);
    QTreeWidget& rows = window.watch().tree();
    int prepared = 0;
    while (prepared < rows.columnCount() && rows.headerItem()->text(prepared) != "Prepared") ++prepared;
    const auto writeOther = [&](int row) { // the other value of a BOOL
        const QPoint at = rows.visualRect(rows.model()->index(row, prepared)).center();
        QTest::mouseClick(rows.viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(rows.viewport(), Qt::LeftButton, {}, at);
        QTest::keyClick(&window, Qt::Key_F7, Qt::ControlModifier);
    };
    ASSERT_TRUE(waitFor([&] { return rows.topLevelItem(0)->text(1) == "FALSE"; }));
    writeOther(0);
    ASSERT_TRUE(waitFor([&] { return window.control().value("Main.Motor").isTrue; }));
    ASSERT_TRUE(waitFor([&] { return rows.topLevelItem(0)->text(1) == "TRUE"; }));
    writeOther(0);
    ASSERT_TRUE(waitFor([&] { return window.control().value("NOT Main.Start").isTrue; }));
    const uint64_t released = window.control().status().scans;
    ASSERT_TRUE(waitFor([&] { return window.control().status().scans > released + 5; }));
    EXPECT_TRUE(window.control().value("Main.Motor").isTrue) << "it holds itself";
    writeOther(1);
    ASSERT_TRUE(waitFor([&] { return !window.control().value("Main.Motor").isTrue; }));
    ASSERT_TRUE(waitFor([&] { return rows.topLevelItem(1)->text(1) == "FALSE"; }));
    writeOther(1); // as a released button would
    ASSERT_TRUE(waitFor([&] { return window.control().value("Main.Stop").isTrue; }));

    // 6: a panel in two languages
    ASSERT_TRUE(window.live().addPanel("overview"));
    window.designs().openTexts();
    auto* texts = qobject_cast<hmi::TextEditor*>(window.tabs().pageByKey("texts"));
    ASSERT_NE(texts, nullptr);
    texts->addLanguage("de");
    window.designs().openPanel("overview");
    auto* designer = qobject_cast<hmi::PanelDesigner*>(window.tabs().pageByKey("panel:overview"));
    ASSERT_NE(designer, nullptr);
    hmi::DesignContext& design = *window.live().design();
    const auto typed = [&](const char* text) {
        return design.storeText({}, text, "overview", designer->document().undoStack()).toStdString();
    };
    const auto draw = [&](hmi::ElementKind kind, QRectF place,
                          const std::vector<std::pair<std::string, std::string>>& properties) {
        hmi::Json fields = hmi::newElementFields(kind);
        for (const auto& [key, value] : properties) fields[key] = value;
        fields["rect"] = {place.x(), place.y(), place.width(), place.height()};
        designer->canvas().insertElements(hmi::Json::array({fields}), place.center());
    };
    const std::string start = typed("Start"), stop = typed("Stop contact"), runs = typed("Motor runs");
    draw(hmi::ElementKind::Switch, {100, 80, 220, 48},
         {{"onText", start}, {"offText", start}, {"target", "Main.Start"}});
    draw(hmi::ElementKind::Switch, {100, 160, 220, 48}, {{"onText", stop}, {"offText", stop}, {"target", "Main.Stop"}});
    draw(hmi::ElementKind::Lamp, {440, 100, 140, 80}, {{"label", runs}, {"value", "Main.Motor"}});
    draw(hmi::ElementKind::LanguageSelector, {700, 20, 260, 44}, {});
    for (const auto& [key, german] : std::vector<std::pair<std::string, QString>>{
             {start, "Start"}, {stop, "Stoppkontakt"}, {runs, "Motor läuft"}}) {
        const int row = design.project().texts.table().rowOf(QString::fromStdString(key.substr(1)));
        ASSERT_GE(row, 0) << key;
        ASSERT_TRUE(
            texts->model().setData(texts->model().index(row, hmi::TextModel::FirstLanguage + 1), german, Qt::EditRole));
    }
    window.designs().save();
    const auto drawn = projects::openProject({project.toStdString()});
    ASSERT_TRUE(drawn);
    EXPECT_EQ(drawn->languages, (std::vector<std::string>{"en", "de"}));
    EXPECT_EQ(drawn->panels.size(), 1u);
    for (const hmi::Finding& finding : hmi::checkPanels(hmi::loadPanelProject(*drawn), design.checked()))
        ADD_FAILURE() << finding.text().toStdString();
    hmi::PanelPlayer* player = window.live().player();
    ASSERT_NE(player, nullptr);
    ASSERT_TRUE(player->showPanel("overview"));
    player->setLanguage("de");
    EXPECT_EQ(player->scene().texts().text(QString::fromStdString(runs), player->language()), "Motor läuft");
    ASSERT_TRUE(window.control().write("Main.Stop", "FALSE"));
    ASSERT_TRUE(waitFor([&] { return !window.control().value("Main.Motor").isTrue; }));
    EXPECT_EQ(player->post({{}, "Main.Stop", hmi::WriteKind::Write, hmi::Value::ofBool(true), {}}), "");
    EXPECT_EQ(player->post({{}, "Main.Start", hmi::WriteKind::Write, hmi::Value::ofBool(true), {}}), "");
    ASSERT_TRUE(waitFor([&] { return window.control().value("Main.Motor").isTrue; }));
    ASSERT_TRUE(window.control().write("Main.Start", "FALSE"));
    window.tabs().setCurrentIndex(0);

    // 7: change it while it runs
    QSignalSpy changed(&window.control(), &editor::RunControl::onlineChangeFinished);
    const auto at = static_cast<uint32_t>(editor.utf8().find("RunTime + T#10ms") + 12); // at 10ms
    editor.applyEdits({{{FileId(), at, at + 4}, "20ms"}});
    window.action("file.save")->trigger();
    ASSERT_TRUE(waitFor([&] { return changed.count() == 1; }));
    EXPECT_TRUE(window.control().value("Main.Motor").isTrue);
    ASSERT_TRUE(window.control().write("Main.Stop", "FALSE"));
    EXPECT_TRUE(waitFor([&] { return !window.control().value("Main.Motor").isTrue; }));
    window.control().disconnectSession();

    // 5: the test, on the program as the page has it
    ASSERT_TRUE(projects::writeFileAtomically(project.toStdString() + "/tests/motor.st", listing(1)));
    const auto opened = projects::openProject({project.toStdString()});
    ASSERT_TRUE(opened);
    const auto report = testing::runTests(*opened, {});
    ASSERT_TRUE(report);
    EXPECT_FALSE(report->hasErrors) << (report->diagnostics.empty() ? "" : report->diagnostics.front());
    ASSERT_EQ(report->results.size(), 1u);
    EXPECT_TRUE(report->results[0].passed())
        << (report->results[0].failures.empty() ? "" : report->results[0].failures[0].message.english());
}

} // namespace
} // namespace plc::app
