// Why a value is as it is, asked where it is seen: text, watch, tree, trace and panel; one click on the answer goes to
// the place and to the scan.
#include "app/online/inside_views.h"
#include "app/panels/live_views.h"
#include "app/project/project_tree.h"
#include "editor/debug/watch_view.h"
#include "hmi/player/panel_player.h"
#include "hmi/player/panel_why.h"
#include "projects/storage/project_file.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"
#include "tests/support/settle.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QDockWidget>
#include <QMenu>
#include <QSignalSpy>
#include <QToolButton>
#include <QTreeWidget>

#include <atomic>
#include <thread>

namespace plc::app {
namespace {

const char* const kLatch = R"(VAR_GLOBAL
    start, stop : BOOL;
END_VAR
PROGRAM Main
VAR
    lamp : BOOL;
    n : DINT;
END_VAR
n := n + 1;
IF start AND NOT stop THEN
    lamp := TRUE;
END_IF
END_PROGRAM
)";

const char* const kPanel =
    R"({"elements": [{"kind": "lamp", "id": "Lamp", "rect": [40, 40, 120, 120], "value": "Main.lamp"},
                  {"kind": "button", "id": "Start", "rect": [200, 40, 120, 60], "target": "start"}]})";

class WhyViewTest : public StudioTest {
protected:
    void SetUp() override {
        write("hmi/overview.panel.json", kPanel);
        StudioTest::SetUp();
        QApplication::setActiveWindow(window.get());
        const auto end = static_cast<uint32_t>(editor().utf8().size());
        editor().applyEdits({{{FileId(), 0, end}, kLatch}});
        analysed();
        window->action("file.save")->trigger();
    }
    void TearDown() override {
        if (window) window->workspace().revert("src/main.st");
        StudioTest::TearDown();
    }
    editor::WhyView& why() { return window->inside().whyView(); }
    session::Session& session() { return *window->control().session(); }
    /// The lamp goes on because of a write, some scans after the start.
    void runUntilLamp() {
        window->action("run.start")->trigger();
        ASSERT_TRUE(waitFor([&] { return window->control().value("Main.n").text.toInt() > 5; }));
        ASSERT_TRUE(window->control().write("start", "TRUE"));
        ASSERT_TRUE(waitFor([&] { return window->control().value("Main.lamp").isTrue; }));
        ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 20; }));
    }
    uint32_t at(const char* text) { return static_cast<uint32_t>(editor().utf8().find(text)); }
    /// Triggers the entry of the menu that opens next.
    static void chooseInNextMenu(const char* name) {
        inNextMenu(qApp, [name](QMenu& menu) {
            auto* action = menu.findChild<QAction*>(name);
            menu.close();
            ASSERT_NE(action, nullptr) << name;
            action->trigger();
        });
    }
    /// Where the caret is: a right click moves it to the place clicked.
    QPoint caret() {
        const auto at = editor().SendScintilla(QsciScintilla::SCI_GETCURRENTPOS);
        return {static_cast<int>(editor().SendScintilla(QsciScintilla::SCI_POINTXFROMPOSITION, 0UL, at)),
                static_cast<int>(editor().SendScintilla(QsciScintilla::SCI_POINTYFROMPOSITION, 0UL, at)) + 3};
    }
    static void rightClick(QWidget* widget, QPoint at) {
        QContextMenuEvent event(QContextMenuEvent::Mouse, at, widget->mapToGlobal(at));
        QApplication::sendEvent(widget, &event);
    }
    bool answered() {
        return waitFor([&] { return why().tree().topLevelItemCount() > 0 && !window->inside().desk().isBusy(); });
    }
    QTreeWidgetItem* sentence(const QString& part) {
        QTreeWidgetItemIterator it(&why().tree());
        for (; *it; ++it)
            if ((*it)->text(0).contains(part)) return *it;
        return nullptr;
    }
    std::string answer() { return why().text().toStdString(); }
};

TEST_F(WhyViewTest, TheTextsMenuAnswersWhyAndAClickGoesToPlaceAndScan) {
    runUntilLamp();
    editor().goTo(at("lamp := TRUE") + 1);
    chooseInNextMenu("askWhy");
    rightClick(editor().viewport(), caret());
    ASSERT_TRUE(answered()) << answer();
    EXPECT_TRUE(window->dock("why")->isVisible());
    EXPECT_NE(answer().find("lamp is TRUE"), std::string::npos) << answer();
    EXPECT_NE(answer().find("start became TRUE, written from the studio"), std::string::npos) << answer();
    EXPECT_NE(answer().find("stop was FALSE"), std::string::npos) << answer();
    QTreeWidgetItem* set = sentence("It was set by");
    ASSERT_NE(set, nullptr) << answer();
    editor().goTo(0);
    why().tree().scrollToItem(set);
    QTest::mouseClick(why().tree().viewport(), Qt::LeftButton, Qt::NoModifier,
                      why().tree().visualItemRect(set).center());
    ASSERT_TRUE(window->control().viewed());
    EXPECT_TRUE(window->control().value("Main.lamp").isTrue);
    window->control().stepView(-1);
    EXPECT_FALSE(window->control().value("Main.lamp").isTrue) << "the click went to the scan of the change";
    EXPECT_EQ(editor().selectedText(), "lamp := TRUE;");
}

TEST_F(WhyViewTest, TheKeyAsksAboutTheSelection) {
    runUntilLamp();
    editor().goTo(at("start AND NOT stop"), 18);
    QTest::keyClick(editor().viewport(), Qt::Key_W, Qt::ControlModifier | Qt::AltModifier);
    ASSERT_TRUE(answered());
    EXPECT_NE(answer().find("start AND NOT stop is TRUE"), std::string::npos) << answer();
}

TEST_F(WhyViewTest, WhyNotNamesTheChangesThatWouldMakeIt) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().value("Main.n").text.toInt() > 5; }));
    window->showDock("watch");
    window->watch().setExpressions({"Main.lamp"});
    QTreeWidget& tree = window->watch().tree();
    chooseInNextMenu("askWhyNot");
    rightClick(tree.viewport(), tree.visualItemRect(tree.topLevelItem(0)).center());
    ASSERT_TRUE(answered());
    EXPECT_NE(answer().find("start were TRUE"), std::string::npos) << answer();
}

TEST_F(WhyViewTest, AQuestionMayOutliveTheWindow) {
    runUntilLamp();
    // A thread that nobody waits for any more lets go of the session after the window is gone.
    editor::RunControl::Hold held = window->control().hold();
    window->control().disconnectSession();
    window.reset();
    std::thread([&held] { held.reset(); }).join();
    QTest::qWait(10); // a duration: what was posted to the control that is gone would come now
}

TEST_F(WhyViewTest, AQuestionCanBeCancelledAndANewOneReplacesIt) {
    runUntilLamp();
    // The desk is busy with something long, so that the questions wait; it looks whether anybody still does.
    std::atomic<bool> isAt{false}, mayEnd{false};
    ASSERT_TRUE(window->inside().desk().ask("long", [&](editor::InsideDesk::Bench&) -> editor::InsideDesk::Finish {
        isAt = true;
        while (!mayEnd) std::this_thread::yield();
        return {};
    }));
    ASSERT_TRUE(waitFor([&] { return isAt.load(); }));
    auto* cancel = why().findChild<QToolButton*>("whyCancel");
    ASSERT_NE(cancel, nullptr);
    window->inside().ask(kit::AskWhy::Why, "Main.lamp");
    EXPECT_TRUE(cancel->isVisible());
    QTest::keyClick(&why().tree(), Qt::Key_Escape);
    EXPECT_FALSE(cancel->isVisible());
    window->inside().ask(kit::AskWhy::Why, "Main.n");
    window->inside().ask(kit::AskWhy::Who, "start");
    mayEnd = true;
    ASSERT_TRUE(answered());
    EXPECT_FALSE(cancel->isVisible());
    EXPECT_EQ(answer().find("Main.n is"), std::string::npos) << answer();
    EXPECT_EQ(answer().find("Main.lamp is"), std::string::npos) << answer();
    EXPECT_NE(answer().find("start"), std::string::npos) << answer();
}

TEST_F(WhyViewTest, WorkThatNobodyWaitsForHearsOfIt) {
    runUntilLamp();
    std::atomic<bool> isAt{false}, hasHeard{false}, isFinished{false};
    const auto longOne = [&](editor::InsideDesk::Bench& bench) -> editor::InsideDesk::Finish {
        isAt = true;
        while (!bench.insight.isCancelled()) std::this_thread::yield();
        hasHeard = true;
        return [&] { isFinished = true; };
    };
    ASSERT_TRUE(window->inside().desk().ask("long", longOne));
    ASSERT_TRUE(waitFor([&] { return isAt.load(); }));
    window->inside().desk().cancel("long");
    ASSERT_TRUE(waitFor([&] { return hasHeard && !window->inside().desk().isBusy(); }));
    EXPECT_FALSE(isFinished) << "its answer is not wanted";
    isAt = hasHeard = false;
    ASSERT_TRUE(window->inside().desk().ask("long", longOne));
    ASSERT_TRUE(waitFor([&] { return isAt.load(); }));
    bool isAnswered = false;
    ASSERT_TRUE(window->inside().desk().ask(
        "long", [&](auto&) -> editor::InsideDesk::Finish { return [&] { isAnswered = true; }; }));
    EXPECT_TRUE(waitFor([&] { return isAnswered; }));
    EXPECT_TRUE(hasHeard) << "the new question took its place";
    isAt = false;
    ASSERT_TRUE(window->inside().desk().ask("long", longOne));
    ASSERT_TRUE(waitFor([&] { return isAt.load(); }));
    window->control().disconnectSession(); // does not wait for what nobody will hear
}

TEST_F(WhyViewTest, TheWatchListsAllChangesWithTheirWriters) {
    runUntilLamp();
    window->showDock("watch");
    window->watch().setExpressions({"Main.lamp", "Main.n"});
    QTreeWidget& tree = window->watch().tree();
    tree.setCurrentItem(tree.topLevelItem(0));
    tree.setFocus();
    window->action("time.who")->trigger();
    ASSERT_TRUE(answered());
    ASSERT_EQ(why().tree().topLevelItemCount(), 2) << answer();
    EXPECT_NE(answer().find("Main.lamp from FALSE to TRUE, set by lamp := TRUE;"), std::string::npos) << answer();
    EXPECT_NE(answer().find("its initial value"), std::string::npos) << answer();
    tree.setCurrentItem(tree.topLevelItem(1));
    tree.setFocus();
    window->action("time.who")->trigger();
    ASSERT_TRUE(waitFor([&] { return sentence("n := n + 1") && !window->inside().desk().isBusy(); }));
    const int first = why().tree().topLevelItemCount();
    if (QTreeWidgetItem* more = sentence("Earlier changes")) {
        why().tree().scrollToItem(more);
        QTest::mouseClick(why().tree().viewport(), Qt::LeftButton, Qt::NoModifier,
                          why().tree().visualItemRect(more).center());
        EXPECT_TRUE(waitFor([&] { return why().tree().topLevelItemCount() > first; }));
    }
}

TEST_F(WhyViewTest, ThePanelsElementAndTheTreeAskToo) {
    window->showDock("panel");
    runUntilLamp();
    hmi::PanelPlayer& player = *window->live().player();
    ASSERT_TRUE(waitFor([&] { return player.view().isVisible() && player.view().width() > 100; }));
    hmi::PanelView& view = player.view();
    chooseInNextMenu("askWhy");
    rightClick(&view, view.toWidget({40, 40, 120, 120}).center().toPoint());
    ASSERT_TRUE(answered());
    EXPECT_NE(answer().find("Main.lamp is TRUE"), std::string::npos) << answer();
    emit window->projectTree().whyRequested(kit::AskWhy::Who, "stop");
    ASSERT_TRUE(waitFor([&] { return sentence("stop") && !window->inside().desk().isBusy(); }));
    EXPECT_NE(answer().find("its initial value"), std::string::npos) << answer();
}

TEST_F(WhyViewTest, APlayerWithoutAStudioAnswersOverThePanel) {
    runUntilLamp();
    hmi::PanelPlayer player(window->live().panels(), window->control().session());
    player.showPanel("overview");
    player.resize(800, 600);
    player.show();
    player.askWhy(kit::AskWhy::Why, "Main.lamp");
    ASSERT_NE(player.answer(), nullptr);
    ASSERT_TRUE(waitFor([&] { return player.answer()->isAnswered(); }));
    EXPECT_TRUE(player.answer()->text().contains("start became TRUE")) << player.answer()->text().toStdString();
    player.askWhy(kit::AskWhy::WhyNot, "Main.n");
    ASSERT_TRUE(waitFor([&] { return player.answer()->isAnswered(); }));
    EXPECT_TRUE(player.answer()->text().contains("condition")) << player.answer()->text().toStdString();
    QTest::keyClick(player.answer(), Qt::Key_Escape);
    EXPECT_TRUE(waitFor([&] { return !player.answer(); }));
}

TEST_F(WhyViewTest, APlayerAnswersInTheOperatorsWords) {
    runUntilLamp();
    const auto write = [](const QString& path, const QByteArray& bytes) {
        QFile file(path);
        return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
    };
    ASSERT_TRUE(write(folder.filePath("hmi/overview.panel.json"),
                      R"({"elements": [
  {"kind": "lamp", "id": "Lamp", "rect": [40, 40, 120, 120], "value": "Main.lamp", "label": "@lamp"},
  {"kind": "button", "id": "Start", "rect": [200, 40, 120, 60], "target": "start", "text": "@start"}]})"));
    ASSERT_TRUE(write(folder.filePath("hmi/texts.csv"), "key,comment,en,de\r\nlamp,,Pump runs,Pumpe läuft\r\n"
                                                        "start,,Start pump,Pumpe starten\r\n"));
    ASSERT_TRUE(write(folder.filePath("project.json"),
                      "{\"name\": \"Test\", \"libraries\": [], \"languages\": [\"en\", \"de\"]}"));
    const auto project = projects::openProject({folder.path().toStdString()});
    ASSERT_TRUE(project) << project.error().english();
    const hmi::PanelProject panels = hmi::loadPanelProject(*project);
    hmi::PanelPlayer player(panels, window->control().session());
    player.showPanel("overview");
    player.resize(800, 600);
    player.show();
    const auto ask = [&](const char* language) {
        player.setLanguage(language);
        player.askWhy(kit::AskWhy::Why, "Main.lamp");
        EXPECT_TRUE(waitFor([&] { return player.answer() && player.answer()->isAnswered(); }));
        return player.answer()->text().toStdString();
    };
    const std::string english = ask("en");
    EXPECT_NE(english.find("“Start pump” became TRUE"), std::string::npos) << english;
    EXPECT_EQ(english.find("start became"), std::string::npos) << english;
    const std::string german = ask("de");
    EXPECT_NE(german.find("“Pumpe starten”"), std::string::npos) << german;
    EXPECT_EQ(german.find("became"), std::string::npos) << "the sentences, too: " << german;
    player.askWhy(kit::AskWhy::Who, "Main.n"); // closed at once: nothing waits for the answer
    QTest::keyClick(player.answer(), Qt::Key_Escape);
    EXPECT_TRUE(waitFor([&] { return !player.answer(); }));
}

TEST_F(WhyViewTest, TheTraceAsksAtItsCursor) {
    runUntilLamp();
    window->showDock("trace");
    trace::TraceView& trace = window->live().traceView();
    trace.addChannel("Main.lamp");
    trace.tick();
    trace.plot()->setCursorsShown(true);
    trace.plot()->setCursor(0, 0); // before the lamp went on
    QSignalSpy asked(&trace, &trace::TraceView::whyRequested);
    trace.askWhy(kit::AskWhy::Why, 0);
    ASSERT_EQ(asked.count(), 1);
    ASSERT_TRUE(answered());
    EXPECT_NE(answer().find("Main.lamp is FALSE"), std::string::npos) << answer();
}

TEST_F(WhyViewTest, WhatCannotBeAnsweredIsSaid) {
    window->inside().ask(kit::AskWhy::Why, "Main.lamp");
    EXPECT_EQ(why().tree().topLevelItemCount(), 0);
    runUntilLamp();
    window->inside().ask(kit::AskWhy::Why, "Main.nothing");
    QSignalSpy spy(&why(), &editor::WhyView::answered);
    ASSERT_TRUE(waitFor([&] { return spy.count() > 0; }));
    EXPECT_EQ(why().tree().topLevelItemCount(), 0);
    window->inside().ask(kit::AskWhy::WhyNot, "Main.n");
    ASSERT_TRUE(waitFor([&] { return spy.count() > 1; }));
    EXPECT_EQ(why().tree().topLevelItemCount(), 0);
    // The session ends while a question is open: nothing hangs, nothing of it is shown.
    window->inside().ask(kit::AskWhy::Who, "Main.n");
    window->control().disconnectSession();
    EXPECT_FALSE(window->inside().desk().isBusy());
    settle();
    EXPECT_EQ(why().tree().topLevelItemCount(), 0);
}

TEST_F(WhyViewTest, ARecordingFromAFileAnswersTheSame) {
    runUntilLamp();
    const QString path = folder.path() + "/lamp.rec";
    ASSERT_TRUE(window->live().saveRecording(path));
    window->control().disconnectSession();
    ASSERT_TRUE(window->live().openRecording(path));
    window->inside().ask(kit::AskWhy::Why, "Main.lamp");
    ASSERT_TRUE(answered());
    EXPECT_NE(answer().find("start became TRUE, written from the studio"), std::string::npos) << answer();
    window->live().closeRecording();
}

} // namespace
} // namespace plc::app
