#include "tests/app/all_windows.h"
#include "tests/support/patience.h"

#include "app/documents/design_pages.h"
#include "app/documents/file_commands.h"
#include "app/documents/unit_commands.h"
#include "app/exchange/exchange_dialogs.h"
#include "app/online/devices_view.h"
#include "app/online/inside_views.h"
#include "app/pages/editor_tabs.h"
#include "app/pages/merge_dialog.h"
#include "app/pages/st_page.h"
#include "app/panels/live_views.h"
#include "app/project/explanation_dialog.h"
#include "app/project/new_project.h"
#include "app/project/problems_view.h"
#include "app/project/project_tree.h"
#include "app/settings/settings_dialog.h"
#include "app/start/start_page.h"
#include "app/testing/test_runner.h"
#include "editor/debug/watch_view.h"
#include "editor/graph/chart/chart_view.h"
#include "editor/graph/ladder/ladder_view.h"
#include "editor/kit/command_palette.h"
#include "hmi/designer/canvas/palette.h"
#include "hmi/designer/panel_designer.h"
#include "hmi/designer/sheet/records_dialog.h"
#include "hmi/model/descriptor.h"
#include "hmi/model/panel.h"
#include "tests/support/settle.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QContextMenuEvent>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QFileInfo>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>

#include <gtest/gtest.h>

namespace plc::app {

namespace {

const char* const kMotor = R"(FUNCTION_BLOCK Motor
VAR_INPUT
    run : BOOL;
END_VAR
VAR_OUTPUT
    turns : DINT;
END_VAR
IF run THEN
    turns := turns + 1;
END_IF
END_FUNCTION_BLOCK
)";

const char* const kSteps = R"(PROGRAM Steps
VAR
    go : BOOL;
    drive : Motor;
END_VAR
INITIAL_STEP Ready: END_STEP
TRANSITION FROM Ready TO Work := go; END_TRANSITION
STEP Work:
    Turn(N);
END_STEP
TRANSITION FROM Work TO Ready := NOT go; END_TRANSITION
ACTION Turn:
    drive(run := TRUE);
END_ACTION
END_PROGRAM
)";

const char* const kRungs = R"(PROGRAM Rungs
VAR
    on, off, motor : BOOL;
END_VAR
motor := (on OR motor) AND NOT off;
END_PROGRAM
)";

const char* const kAlarms = R"({"version": 1, "classes": [{"name": "fault", "title": "@fault"}],
  "alarms": [{"id": "1", "condition": "Main.done", "class": "fault", "text": "@hot"}]})";

void write(const QString& path, const std::string& text) {
    QDir().mkpath(QFileInfo(path).path());
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly)) << path.toStdString();
    file.write(QByteArray::fromStdString(text));
}

/// One element of each kind, in rows.
std::string panelOfAllKinds() {
    hmi::Json elements = hmi::Json::array();
    int index = 0;
    for (const hmi::ElementDescriptor& kind : hmi::elementDescriptors()) {
        hmi::Json fields = hmi::newElementFields(kind.kind);
        fields["id"] = "e" + std::to_string(index);
        fields["rect"] = {40 + index % 8 * 120, 40 + index / 8 * 90, 100, 70};
        elements.push_back(std::move(fields));
        ++index;
    }
    return hmi::Json({{"elements", std::move(elements)}}).dump();
}

bool waitFor(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, kPatience); }

/// Looks at what `open` shows, a dialog or a popup of its own loop, and closes it.
void lookAtWhatOpens(const Look& look, const QString& name, QWidget* (*opened)(), const std::function<void()>& open) {
    bool isSeen = false;
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&] {
        QWidget* shown = opened();
        if (!shown) return;
        if (!isSeen) look(*shown, name);
        isSeen = true;
        if (auto* dialog = qobject_cast<QDialog*>(shown))
            dialog->reject();
        else
            shown->close();
    });
    timer.start(20);
    open();
    waitFor([&] { return isSeen; });
    EXPECT_TRUE(isSeen) << name.toStdString() << " did not open";
}

/// The menu of the right button at the middle of a row, or of the widget.
void lookAtMenuOf(const Look& look, const QString& name, QWidget* widget) {
    ASSERT_NE(widget, nullptr) << name.toStdString();
    QPoint at = widget->rect().center();
    auto* view = qobject_cast<QAbstractItemView*>(widget);
    if (view && view->model()->rowCount() > 0) at = view->visualRect(view->model()->index(0, 0)).center();
    QWidget* target = widget;
    if (auto* area = qobject_cast<QAbstractScrollArea*>(widget)) target = area->viewport();
    lookAtWhatOpens(look, name, &QApplication::activePopupWidget, [&] {
        QContextMenuEvent event(QContextMenuEvent::Mouse, at, target->mapToGlobal(at));
        QApplication::sendEvent(target, &event);
    });
}

const char* const kDevices = R"({"devices": [
  {"name": "Line", "protocol": "modbus-tcp", "host": "127.0.0.1", "port": 1502,
   "channels": [{"name": "Count", "variable": "Main.counter", "table": "input", "address": 0}]},
  {"name": "Broker", "protocol": "mqtt", "host": "127.0.0.1",
   "channels": [{"name": "Done", "variable": "Main.done", "topic": "plant/done", "direction": "out"}]}]}
)";

/// Each one in front of those that share its place.
void lookAtAllDocks(MainWindow& window, const Look& look) {
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) {
        window.showDock(dock->objectName());
        settle();
        look(window, dock->objectName());
    }
    window.showDock("devices");
    auto* devices = window.findChild<DevicesView*>()->findChild<QTreeWidget*>();
    ASSERT_NE(devices, nullptr);
    ASSERT_GT(devices->topLevelItemCount(), 1);
    for (int row = 0; row < devices->topLevelItemCount(); ++row)
        for (QTreeWidgetItem* item : {devices->topLevelItem(row), devices->topLevelItem(row)->child(0)}) {
            devices->setCurrentItem(item);
            settle();
            look(window, "devices: " + (item ? item->text(0) : QString()));
        }
}

} // namespace

void lookAtDialog(const Look& look, const QString& name, const std::function<void()>& open) {
    lookAtWhatOpens(look, name, &QApplication::activeModalWidget, open);
}

std::vector<QWidget*> widgetsOf(QWidget& window) {
    std::vector<QWidget*> out{&window};
    for (QWidget* each : window.findChildren<QWidget*>()) out.push_back(each);
    return out;
}

void writeProjectOfAllKinds(const QString& folder) {
    write(folder + "/src/motor.st", kMotor);
    write(folder + "/src/steps.st", kSteps);
    write(folder + "/src/rungs.st", kRungs);
    write(folder + "/devices.json", kDevices);
    write(folder + "/tests/first.st", "TEST 'turns'\nRUN T#20ms;\nASSERT Main.counter > 0;\nEND_TEST\n");
    write(folder + "/hmi/all.panel.json", panelOfAllKinds());
    write(folder + "/hmi/alarms.json", kAlarms);
    write(folder + "/hmi/texts.csv", "key,comment,en\nfault,,Fault\nhot,,Hot\nState.0,,Off\n");
}

/// As it is seen without a project.
static void lookAtStartPage(MainWindow& window, const Look& look) {
    StartPage page(window.settings());
    page.resize(1000, 660);
    page.show();
    settle();
    look(page, "start page");
}

void lookAtAllDocuments(MainWindow& window, const Look& look) {
    lookAtStartPage(window, look);
    window.action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window.control().status().scans > 20; }));
    window.watch().setExpressions({"Main.counter", "Main.done", "Main.pulse"});
    (void)window.control().force("Main.limit", "900");
    for (QDockWidget* dock : window.findChildren<QDockWidget*>()) window.showDock(dock->objectName());
    window.runTests();
    const auto* tests = window.findChild<TestRunner*>();
    ASSERT_TRUE(tests && waitFor([&] { return !tests->isRunning(); }));
    settle();
    look(window, "main window");
    lookAtAllDocks(window, look);
    StPage* page = window.tabs().openFile("src/main.st");
    page->findBar().open(true);
    page->toggleTable();
    look(window, "text, table and find bar");
    page = window.tabs().openFile("src/steps.st");
    ASSERT_NE(page->showChart("Steps"), nullptr);
    look(window, "chart");
    page = window.tabs().openFile("src/rungs.st");
    ASSERT_NE(page->showLadder("Rungs"), nullptr);
    look(window, "ladder");
    window.designs().openTexts();
    look(window, "texts");
    window.designs().openAlarms();
    look(window, "alarms");
    window.designs().openRecipes();
    look(window, "recipes");
    window.designs().openPeople();
    look(window, "users");
    window.designs().openPanel("all");
    auto* designer = qobject_cast<hmi::PanelDesigner*>(window.tabs().currentWidget());
    ASSERT_NE(designer, nullptr);
    designer->selection().clear();
    look(*designer, "designer");
    for (const hmi::Element& element : designer->document().panel().elements()) {
        designer->selection().set({element.id()});
        settle();
        look(*designer, "designer: " + element.id());
    }
    window.startTour();
    settle();
    look(window, "tour");
    window.openPalette();
    look(window, "palette");
    window.findChild<kit::CommandPalette*>()->hide();
}

/// The page of a problem, a window beside the studio's.
static void lookAtExplanation(MainWindow& window, const Look& look) {
    StPage* page = window.tabs().openFile("src/main.st");
    const std::string before = page->active().utf8();
    const auto end = static_cast<uint32_t>(before.find("END_PROGRAM"));
    page->active().applyEdits({{{FileId(), end, end}, "missing := 1;\n"}});
    ASSERT_TRUE(waitFor([&] { return window.problems().errorCount() > 0; }));
    page->active().goTo(end + 2);
    page->active().setFocus();
    ExplanationDialog* dialog = nullptr;
    ASSERT_TRUE(waitFor([&] { // the problem is known
        window.action("help.explain")->trigger();
        dialog = window.findChild<ExplanationDialog*>();
        return dialog && dialog->isVisible();
    }));
    look(*dialog, "explanation");
    dialog->close();
    window.workspace().revert("src/main.st");
}

void lookAtAllDialogs(MainWindow& window, const Look& look) {
    lookAtDialog(look, "new project", [&] { window.newProject(); });
    lookAtDialog(look, "new unit", [&] { window.units().newUnit(); });
    lookAtDialog(look, "settings", [&] { window.openSettings(); });
    lookAtDialog(look, "speed", [&] { window.setSpeed(); });
    lookAtDialog(look, "memory", [&] { window.setHistoryBudget(); });
    lookAtDialog(look, "new panel", [&] { window.designs().newPanel(); });
    lookAtDialog(look, "new trace", [&] { window.projectFiles().newTrace(); });
    lookAtDialog(look, "libraries", [&] { window.chooseLibraries(); });
    lookAtDialog(look, "project settings", [&] { window.openProjectSettings(); });
    lookAtDialog(look, "about", [&] { window.about(); });
    lookAtDialog(look, "attach", [&] { window.action("run.attach")->trigger(); });
    lookAtDialog(look, "native program", [&] { window.action("run.native")->trigger(); });
    lookAtDialog(look, "import", [&] { window.action("file.import")->trigger(); });
    lookAtDialog(look, "export", [&] { window.action("file.export")->trigger(); });
    StPage* page = window.tabs().openFile("src/main.st");
    page->active().goTo(static_cast<uint32_t>(page->active().utf8().find("counter :=")));
    lookAtDialog(look, "go to line", [&] { window.units().goToLine(); });
    lookAtDialog(look, "rename", [&] { window.units().renameAtCursor(); });
    lookAtDialog(look, "conversion", [&] { window.units().showConverted(analysis::TextLanguage::Il); });
    lookAtDialog(look, "delete a unit", [&] { window.units().deleteUnit("src/motor.st", 0, 20, "Motor"); });
    lookAtDialog(look, "delete a panel", [&] { window.projectFiles().remove("panel", "all"); });
    window.action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window.control().status().state == controller::State::Paused; }));
    window.control().view(5);
    lookAtDialog(look, "what if", [&] { window.action("time.whatIf")->trigger(); });
    window.action("time.walk")->trigger();
    ASSERT_TRUE(waitFor([&] { return window.inside().slowScan().isOpen(); }));
    settle();
    look(window, "walk through a scan");
    window.backToLive();
    lookAtExplanation(window, look);
    lookAtDialog(look, "differences", [&] {
        MergeDialog dialog("src/main.st", "a := 1;\n", "a := 2;\n", &window);
        dialog.exec();
    });
    window.designs().openPanel("all");
    if (auto* designer = qobject_cast<hmi::PanelDesigner*>(window.tabs().currentWidget())) {
        designer->selection().set({designer->document().panel().elements().front().id()});
        lookAtDialog(look, "array", [&] { designer->duplicateAsArray(); });
    }
    lookAtDesignDialogs(window, look);
}

void lookAtAllMenus(MainWindow& window, const Look& look) {
    for (QMenu* menu : window.menuBar()->findChildren<QMenu*>()) {
        emit menu->aboutToShow();
        look(*menu, "menu " + menu->title());
    }
    look(*window.menuBar(), "menu bar");
    window.showDock("project");
    lookAtMenuOf(look, "menu of the project tree", &window.projectTree().tree());
    window.showDock("watch");
    window.watch().setExpressions({"Main.counter"});
    lookAtMenuOf(look, "menu of the watch", &window.watch().tree());
    StPage* page = window.tabs().openFile("src/main.st");
    page->active().goTo(static_cast<uint32_t>(page->active().utf8().find("counter :=")));
    lookAtMenuOf(look, "menu of the text", &page->active());
    page = window.tabs().openFile("src/steps.st");
    lookAtMenuOf(look, "menu of the chart", page->showChart("Steps"));
    page = window.tabs().openFile("src/rungs.st");
    lookAtMenuOf(look, "menu of the ladder", page->showLadder("Rungs"));
    window.designs().openPanel("all");
    if (auto* designer = qobject_cast<hmi::PanelDesigner*>(window.tabs().currentWidget()))
        lookAtMenuOf(look, "menu of the designer", &designer->canvas());
}

} // namespace plc::app
