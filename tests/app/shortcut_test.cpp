// Every shortcut does what the menu says, wherever the focus is: one of the place itself wins over the window's, both
// over what a widget would do with the key.
#include "app/documents/design_pages.h"
#include "app/panels/live_views.h"
#include "app/project/problems_view.h"
#include "app/project/project_tree.h"
#include "app/project/search_view.h"
#include "editor/debug/debug_views.h"
#include "editor/debug/watch_view.h"
#include "hmi/designer/canvas/outline.h"
#include "hmi/designer/editors/alarm_editor.h"
#include "hmi/designer/editors/text_editor.h"
#include "hmi/designer/panel_designer.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QDockWidget>
#include <QHeaderView>
#include <QLineEdit>
#include <QTreeWidget>

namespace plc::app {
namespace {

const char* const kChart = R"(PROGRAM Steps
VAR
    go : BOOL;
END_VAR
INITIAL_STEP Ready: END_STEP
TRANSITION FROM Ready TO Work := go; END_TRANSITION
STEP Work: END_STEP
TRANSITION FROM Work TO Ready := NOT go; END_TRANSITION
END_PROGRAM
)";

const char* const kPanel =
    R"({"elements": [{"kind": "number", "id": "a", "rect": [40, 40, 120, 40], "value": "Main.counter"},
                  {"kind": "number", "id": "b", "rect": [40, 140, 120, 40], "value": "Main.limit"}]})";

class ShortcutTest : public StudioTest {
protected:
    void SetUp() override {
        write("src/steps.st", kChart);
        write("hmi/overview.panel.json", kPanel);
        StudioTest::SetUp();
        QApplication::setActiveWindow(window.get());
    }
    struct Place {
        QString name;
        std::function<QWidget*()> widget; // in sight, takes the focus
    };
    QWidget* inDock(const QString& name, QWidget* widget) {
        window->showDock(name);
        return widget;
    }
    editor::ChartView* chart() {
        window->tabs().showChart("src/steps.st", "Steps");
        return window->tabs().currentPage()->chart();
    }
    hmi::PanelDesigner* designer() {
        window->designs().openPanel("overview");
        return qobject_cast<hmi::PanelDesigner*>(window->tabs().currentWidget());
    }
    std::vector<Place> places() {
        const auto tree = [this](const QString& dock) {
            return [this, dock] { return inDock(dock, window->dock(dock)->findChild<QTreeView*>()); };
        };
        const auto text = [this] { return &window->tabs().openFile("src/main.st")->first(); };
        return {
            {"text", text},
            {"find bar",
             [=, this] {
                 text(), window->tabs().currentPage()->findBar().open(true);
                 return window->tabs().currentPage()->findBar().findChild<QLineEdit*>();
             }},
            {"table",
             [=, this] {
                 text();
                 auto* page = window->tabs().currentPage();
                 if (!page->table().isVisible()) page->toggleTable();
                 return page->table().findChild<QAbstractItemView*>();
             }},
            {"graph", [this] { return chart()->findChild<QGraphicsView*>(); }},
            {"designer", [this] { return &designer()->canvas(); }},
            {"designer's outline", [this] { return designer()->findChild<hmi::Outline*>(); }},
            {"texts",
             [this] {
                 window->designs().openTexts();
                 return window->tabs().currentWidget()->findChild<QAbstractItemView*>();
             }},
            {"alarms",
             [this] {
                 window->designs().openAlarms();
                 return window->tabs().currentWidget()->findChild<QAbstractItemView*>();
             }},
            {"project", tree("project")},
            {"watch", tree("watch")},
            {"forces", tree("forces")},
            {"call path", tree("callPath")},
            {"breakpoints", tree("breakpoints")},
            {"problems", tree("problems")},
            {"search", [this] { return inDock("search", window->dock("search")->findChild<QLineEdit*>()); }},
            {"log", tree("log")},
            {"trace", [this] { return inDock("trace", window->live().traceView().findChild<plot::PlotView*>()); }},
            {"time", [this] { return static_cast<QWidget*>(&window->live().slider()); }},
        };
    }
    /// Whose key it is there: the innermost place with an action of it.
    static QAction* ownerOf(QWidget* place, const QKeySequence& keys) {
        for (QWidget* each = place; each; each = each->parentWidget())
            for (QAction* action : each->actions())
                if (action->shortcutContext() != Qt::WidgetShortcut && action->shortcuts().contains(keys))
                    return action;
        return nullptr;
    }
    static std::set<QKeySequence> keysAround(QWidget* place) {
        std::set<QKeySequence> out;
        for (QWidget* each = place; each; each = each->parentWidget())
            for (QAction* action : each->actions())
                if (action->shortcutContext() != Qt::WidgetShortcut)
                    for (const QKeySequence& keys : action->shortcuts()) out.insert(keys);
        return out;
    }
};

/// A place's own use of a key of the window, known and meant.
bool isMeant(const QString& place, const QKeySequence& keys) {
    static const std::set<std::pair<QString, QString>> kMeant = {
        {"graph", "F2"}, // the name of the step, not of what the cursor in the text is at
        {"graph", "Ctrl+F2"}, {"graph", "Ctrl+Shift+F2"}, // bookmarks of rungs
        {"project", "F2"},                                // the selected unit
        {"find bar", "F3"},   {"find bar", "Shift+F3"},   {"find bar", "Ctrl+Z"}, {"search", "Ctrl+Z"},
    };
    return kMeant.contains({place, keys.toString(QKeySequence::PortableText)});
}

TEST_F(ShortcutTest, EachDoesInEachPlaceWhatTheMenuSays) {
    for (const Place& place : places()) {
        QWidget* widget = place.widget();
        ASSERT_NE(widget, nullptr) << place.name.toStdString();
        const std::string textBefore = window->workspace().text("src/main.st");
        for (const QKeySequence& keys : keysAround(widget)) {
            if (keys.isEmpty() || isMeant(place.name, keys)) continue;
            widget->setFocus();
            ASSERT_NE(QApplication::focusWidget(), nullptr);
            QAction* owner = ownerOf(widget, keys);
            int triggered = 0; // whether it comes is the question here; what it does has its own tests
            owner->disconnect(SIGNAL(triggered(bool)));
            const auto counted = QObject::connect(owner, &QAction::triggered, owner, [&] { ++triggered; });
            owner->setEnabled(true);
            QTest::keyClick(QApplication::focusWidget(), keys[0].key(), keys[0].keyboardModifiers());
            QObject::disconnect(counted);
            EXPECT_EQ(triggered, 1) << keys.toString().toStdString() << " in " << place.name.toStdString() << " ("
                                    << owner->objectName().toStdString() << ")";
        }
        EXPECT_EQ(window->workspace().text("src/main.st"), textBefore) << place.name.toStdString();
    }
}

TEST_F(ShortcutTest, AKeyWhoseCommandIsDisabledChangesNoText) {
    window->tabs().openFile("src/main.st");
    const std::string before = editor().utf8();
    editor().goTo(40);
    for (const char* id : {"run.tests", "view.split"}) {
        QAction* action = window->action(id);
        action->setEnabled(false);
        QTest::keyClick(editor().viewport(), action->shortcut()[0].key(), action->shortcut()[0].keyboardModifiers());
    }
    EXPECT_EQ(editor().utf8(), before);
    EXPECT_EQ(editor().cursorOffset(), 40U);
}

TEST_F(ShortcutTest, GroupingAndDuplicatingWorkInTheDesigner) {
    hmi::PanelDesigner* design = designer();
    design->selection().set({"a", "b"});
    design->canvas().setFocus();
    QTest::keyClick(&design->canvas(), Qt::Key_G, Qt::ControlModifier);
    EXPECT_EQ(design->document().panel().elements().size(), 3U) << "the group and its two";
    QTest::keyClick(&design->canvas(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(design->document().panel().elements().size(), 2U);
    const double zoom = design->canvas().zoom();
    QTest::keyClick(&design->canvas(), Qt::Key_Plus, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_GT(design->canvas().zoom(), zoom);
    design->selection().set({"a"});
    QTest::keyClick(&design->canvas(), Qt::Key_D, Qt::ControlModifier);
    EXPECT_EQ(design->document().panel().elements().size(), 3U);
    window->action("edit.undo")->trigger(); // the menu means what has the focus
    EXPECT_EQ(design->document().panel().elements().size(), 2U);
    design->document().undoStack().setClean();
}

TEST_F(ShortcutTest, UndoInTheGraphTakesBackWhatWasDrawn) {
    editor::ChartView* graph = chart();
    const std::string before = window->workspace().text("src/steps.st");
    graph->findChild<QGraphicsView*>()->setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Down);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Insert);
    ASSERT_NE(window->workspace().text("src/steps.st"), before);
    QTest::keyClick(graph->findChild<QGraphicsView*>(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(window->workspace().text("src/steps.st"), before);
    QTest::keyClick(graph->findChild<QGraphicsView*>(), Qt::Key_Y, Qt::ControlModifier);
    EXPECT_NE(window->workspace().text("src/steps.st"), before);
    window->workspace().revert("src/steps.st");
}

} // namespace
} // namespace plc::app
