// The studio's language changes while the controller runs: the window is another one, everything in it goes on.
#include "app/documents/design_pages.h"
#include "app/frame/kept_size.h"
#include "app/panels/live_views.h"
#include "app/settings/translation.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "hmi/designer/panel_designer.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"
#include "tests/support/patience.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QMenuBar>
#include <QPushButton>

namespace plc::app {
namespace {

class LanguageSwitchTest : public StudioTest {
protected:
    void SetUp() override {
        installTranslation(*qApp, "en");
        StudioTest::SetUp();
    }
    void TearDown() override {
        StudioTest::TearDown();
        installTranslation(*qApp, "en");
    }
    /// As the user does it: in the settings, with OK.
    void choose(const QString& name) {
        bool asked = false;
        QObject::connect(window.get(), &MainWindow::rebuildRequested, [&] { asked = true; });
        inNext<QDialog>(window.get(), [&](QDialog& dialog) {
            for (auto* box : dialog.findChildren<QComboBox*>())
                if (const int at = box->findText(name); at >= 0) {
                    box->setFocus();
                    while (box->currentIndex() < at) QTest::keyClick(box, Qt::Key_Down);
                    while (box->currentIndex() > at) QTest::keyClick(box, Qt::Key_Up);
                }
            QTest::mouseClick(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        });
        window->action("file.settings")->trigger();
        ASSERT_TRUE(asked) << "nobody is asked whether the controller may stop";
        window = inOtherLanguage(std::move(window), *qApp, Settings().language());
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get(), kPatience));
    }
    QString firstMenu() { return window->menuBar()->actions().front()->text().remove('&'); }
};

TEST_F(LanguageSwitchTest, TheWindowKeepsItsSize) {
    window->closeProject(); // as on the start page: the docks are not there yet
    const QSize size(1300, 800);
    window->resize(size);
    ASSERT_TRUE(waitFor([&] { return window->size() == size; }));
    choose("Deutsch");
    ASSERT_TRUE(waitFor([&] { return !window->findChild<KeptSize*>(); })) << "the layout does not rest";
    EXPECT_EQ(window->size(), size) << window->width() << " x " << window->height();
}

TEST_F(LanguageSwitchTest, TheControllerGoesOnAndNothingIsLost) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 5; }));
    ASSERT_TRUE(window->control().force("Main.done", "TRUE"));
    window->control().setBreakpoints({{"src/main.st", 10, "counter > 20000", 0, "", true}});
    window->watch().setExpressions({"Main.counter", "Main.limit"});
    window->watch().tree().topLevelItem(1)->setText(3, "500");
    typeAtEnd("limit := limit;");
    const std::string typed = window->workspace().text("src/main.st");
    ASSERT_NE(typed, kMain);
    window->dock("tasks")->hide();
    window->say("a message of before");
    const int logged = window->log().count();
    const uint32_t cursor = editor().cursorOffset();
    const session::Session* session = window->control().session();
    const uint64_t scans = window->control().status().scans;
    EXPECT_EQ(firstMenu(), "File");

    choose("Deutsch");
    EXPECT_EQ(firstMenu(), "Datei");
    EXPECT_TRUE(waitFor([&] { return window->control().status().scans > scans + 5; }));
    EXPECT_EQ(window->control().session(), session) << "the same controller";
    EXPECT_EQ(window->control().status().state, controller::State::Running);
    EXPECT_EQ(window->workspace().text("src/main.st"), typed);
    EXPECT_EQ(editor().utf8(), typed);
    EXPECT_EQ(editor().cursorOffset(), cursor);
    EXPECT_TRUE(window->workspace().isModified("src/main.st"));
    EXPECT_EQ(window->workspace().savedText("src/main.st"), kMain);
    EXPECT_EQ(window->control().breakpoints().size(), 1u);
    EXPECT_EQ(window->watch().expressions(), (QStringList{"Main.counter", "Main.limit"}));
    EXPECT_EQ(window->watch().tree().topLevelItem(1)->text(3), "500");
    EXPECT_TRUE(waitFor([&] { return window->control().value("Main.done").isForced; }));
    EXPECT_GE(window->log().count(), logged);
    EXPECT_FALSE(window->dock("tasks")->isVisible());
    EXPECT_TRUE(window->dock("watch")->isVisible());
    EXPECT_EQ(window->dock("watch")->windowTitle(), MainWindow::tr("Watch"));
    EXPECT_TRUE(waitFor([&] { return window->live().traceView().recording() != nullptr; }));

    // It is a window like any other: undo knows what was typed, the controller obeys, the trace and the analysis go on.
    QTest::keyClick(editor().viewport(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_NE(editor().utf8(), typed);
    analysed();
    window->action("run.pause")->trigger();
    EXPECT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    choose("English");
    EXPECT_EQ(firstMenu(), "File");
    EXPECT_EQ(window->control().status().state, controller::State::Paused);
    EXPECT_EQ(window->control().session(), session);
    window->action("run.start")->trigger();
    EXPECT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Running; }));
}

TEST_F(LanguageSwitchTest, AnUnsavedPanelStaysUnsaved) {
    ASSERT_TRUE(window->live().addPanel("overview"));
    window->designs().openPanel("overview");
    const auto designer = [&] { return qobject_cast<hmi::PanelDesigner*>(window->tabs().pageByKey("panel:overview")); };
    ASSERT_NE(designer(), nullptr);
    designer()->canvas().insertElements(hmi::Json::array({{{"type", "lamp"}}}), {50, 50});
    ASSERT_TRUE(designer()->isModified());
    const size_t drawn = designer()->document().panel().elements().size();
    auto* player = window->live().player();
    choose("Dansk");
    ASSERT_NE(designer(), nullptr);
    EXPECT_TRUE(designer()->isModified());
    EXPECT_EQ(designer()->document().panel().elements().size(), drawn);
    EXPECT_EQ(window->live().player(), player) << "pressed buttons and alarms are the player's";
    EXPECT_TRUE(player->isVisible());
    ASSERT_TRUE(designer()->save());
    EXPECT_FALSE(designer()->isModified());
}

TEST_F(LanguageSwitchTest, AnOpenedRecordingStaysOpen) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.counter").text.toInt() > 8; }));
    const QString path = folder.path() + "/before.rec";
    ASSERT_TRUE(window->live().saveRecording(path));
    ASSERT_TRUE(window->live().openRecording(path));
    window->live().slider().stepScans(-3);
    const QString shown = window->control().value("Main.counter").text;
    choose("Deutsch");
    EXPECT_TRUE(window->control().showsRecorded());
    EXPECT_EQ(window->control().recordedName(), "before.rec");
    EXPECT_EQ(window->control().value("Main.counter").text, shown);
    window->backToLive();
    EXPECT_FALSE(window->control().showsRecorded());
}

TEST_F(LanguageSwitchTest, TheStartPageChangesToo) {
    window->closeProject();
    choose("Deutsch");
    EXPECT_EQ(firstMenu(), "Datei");
    EXPECT_FALSE(window->workspace().isOpen());
    EXPECT_TRUE(window->openProject(folder.path()));
}

} // namespace
} // namespace plc::app
