// What a mouse does at heads of tables, tabs, edges, margins and by resting or dragging, done with keys alone: real key
// events on the window, from the command palette where a command has no key of its own.
#include "app/documents/design_pages.h"
#include "app/frame/side_bars.h"
#include "app/pages/merge_dialog.h"
#include "app/pages/st_page.h"
#include "app/project/project_tree.h"
#include "editor/debug/watch_view.h"
#include "editor/graph/chart/chart_view.h"
#include "editor/graph/ladder/ladder_view.h"
#include "editor/kit/inputs/color_popup.h"
#include "hmi/designer/editors/recipe_editor.h"
#include "hmi/designer/editors/text_editor.h"
#include "hmi/designer/panel_designer.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"
#include "tests/support/patience.h"
#include "tests/support/settle.h"

#include <QAction>
#include <QDockWidget>
#include <QGraphicsView>
#include <QHeaderView>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QSplitter>
#include <QTabBar>
#include <QTableView>
#include <QTableWidget>
#include <QToolTip>
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

const char* const kRungs = R"(PROGRAM Rungs
VAR
    first, second, motor : BOOL;
END_VAR
motor := first AND second;
END_PROGRAM
)";

const char* const kPanel =
    R"({"elements": [{"kind": "group", "id": "g", "rect": [20, 20, 300, 200]},
                  {"kind": "text", "id": "a", "rect": [40, 40, 120, 40], "text": "Pump", "parent": "g"},
                  {"kind": "text", "id": "b", "rect": [400, 40, 120, 40], "text": "Valve"}]})";

class KeyboardTest : public StudioTest {
protected:
    void SetUp() override {
        write("src/steps.st", kChart);
        write("src/rungs.st", kRungs);
        write("hmi/overview.panel.json", kPanel);
        write("hmi/texts.csv", "key,comment,en,de\nb,,Zebra,Zebra\na,,Ape,Affe\n");
        StudioTest::SetUp();
        QApplication::setActiveWindow(window.get());
    }
    static void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        ASSERT_NE(QApplication::focusWidget(), nullptr);
        QTest::keyClick(QApplication::focusWidget(), static_cast<Qt::Key>(key), modifiers);
    }
    /// A menu that closes leaves no window active for a moment.
    void giveFocus(QWidget& place) {
        QApplication::setActiveWindow(window.get());
        place.setFocus();
        ASSERT_TRUE(waitFor([&] {
            const QWidget* now = QApplication::focusWidget();
            return now && (now == &place || now == place.focusProxy() || place.isAncestorOf(now));
        }));
    }
    /// By its name in the palette, which every command can be found in.
    void command(const QString& name) {
        QApplication::setActiveWindow(window.get()); // a dialog that closes leaves none
        press(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        ASSERT_NE(QApplication::focusWidget(), nullptr);
        QTest::keyClicks(QApplication::focusWidget(), name);
        press(Qt::Key_Return);
    }
    hmi::PanelDesigner& designer() {
        window->designs().openPanel("overview");
        return *qobject_cast<hmi::PanelDesigner*>(window->tabs().currentWidget());
    }
};

TEST_F(KeyboardTest, TheSetOfARecipeIsRenamed) {
    window->designs().openRecipes();
    auto* recipes = qobject_cast<hmi::RecipeEditor*>(window->tabs().currentWidget());
    ASSERT_NE(recipes, nullptr);
    recipes->addRecipe();
    recipes->addVariable("Main.limit");
    auto* table = recipes->findChild<QTableWidget*>();
    const int set = table->columnCount() - 1;
    table->setFocus();
    table->setCurrentCell(0, set);
    asSoonAs(qApp, &QApplication::activeModalWidget, [](QWidget& dialog) {
        auto* line = dialog.findChild<QLineEdit*>();
        line->selectAll();
        QTest::keyClicks(line, "Rye");
        QTest::keyClick(line, Qt::Key_Return);
    });
    command("Rename Set");
    EXPECT_EQ(table->horizontalHeaderItem(set)->text(), "Rye");
    table->setCurrentCell(0, 0);
    table->setFocus();
    command("Rename Set");
    EXPECT_TRUE(recipes->problems().contains("Select a cell of the set")) << recipes->problems().toStdString();
}

TEST_F(KeyboardTest, ALanguageIsTakenOutOfTheTexts) {
    window->designs().openTexts();
    auto* texts = qobject_cast<hmi::TextEditor*>(window->tabs().currentWidget());
    ASSERT_NE(texts, nullptr);
    texts->view().setFocus();
    texts->view().setCurrentIndex(texts->view().model()->index(0, hmi::TextModel::Key));
    command("Remove the language");
    EXPECT_EQ(texts->model().table().tags(), (QStringList{"en", "de"})) << "the key is no language";
    texts->view().setFocus();
    texts->view().setCurrentIndex(texts->view().model()->index(0, hmi::TextModel::FirstLanguage + 1));
    command("Remove the language");
    EXPECT_EQ(texts->model().table().tags(), QStringList("en"));
    texts->view().setFocus();
    texts->view().setCurrentIndex(texts->view().model()->index(0, hmi::TextModel::FirstLanguage));
    command("Remove the language");
    EXPECT_EQ(texts->model().table().tags(), QStringList("en")) << "the last one stays";
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(texts->model().table().tags(), (QStringList{"en", "de"}));
    texts->undoStack().clear();
}

TEST_F(KeyboardTest, ColumnsAreSortedAndSizedFromAMenu) {
    window->designs().openTexts();
    auto* texts = qobject_cast<hmi::TextEditor*>(window->tabs().currentWidget());
    texts->view().setFocus();
    texts->view().setCurrentIndex(texts->view().model()->index(0, hmi::TextModel::FirstLanguage));
    EXPECT_EQ(texts->shownKeys(), (QStringList{"b", "a"}));
    const auto choose = [&](const QString& entry) {
        texts->view().setFocus();
        command("Columns");
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        ASSERT_NE(menu, nullptr);
        ASSERT_NE(menu->activeAction(), nullptr) << "that of the current cell";
        EXPECT_EQ(QString(menu->activeAction()->text()).remove('&'), "English (en)");
        const QMenu* below = menu->activeAction()->menu();
        ASSERT_NE(below, nullptr);
        for (QAction* each : below->actions())
            if (QString(each->text()).remove('&') == entry) each->trigger();
        menu->close();
    };
    choose("Sort Ascending");
    EXPECT_EQ(texts->shownKeys(), (QStringList{"a", "b"}));
    const QHeaderView* head = texts->view().horizontalHeader();
    const int before = head->sectionSize(hmi::TextModel::FirstLanguage);
    choose("Wider");
    EXPECT_GT(head->sectionSize(hmi::TextModel::FirstLanguage), before);
    choose("Narrower");
    EXPECT_EQ(head->sectionSize(hmi::TextModel::FirstLanguage), before);
    choose("Fit to Contents");
    EXPECT_LT(head->sectionSize(hmi::TextModel::FirstLanguage), before);
}

TEST_F(KeyboardTest, DocumentsAreMovedAndAllButOneClosed) {
    window->tabs().openFile("src/main.st");
    window->tabs().openFile("src/steps.st");
    window->tabs().openFile("src/rungs.st");
    editor().setFocus();
    ASSERT_EQ(window->tabs().currentIndex(), 2);
    press(Qt::Key_PageUp, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(window->tabs().currentIndex(), 1);
    EXPECT_EQ(window->tabs().currentPage()->file(), "src/rungs.st");
    press(Qt::Key_PageDown, Qt::ControlModifier | Qt::ShiftModifier);
    press(Qt::Key_PageDown, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(window->tabs().currentIndex(), 2) << "and not beyond the end";
    command("Close Other Documents");
    ASSERT_EQ(window->tabs().count(), 1);
    EXPECT_EQ(window->tabs().currentPage()->file(), "src/rungs.st");
}

TEST_F(KeyboardTest, TheFocusGoesFromPaneToPaneAndBack) {
    window->tabs().openFile("src/main.st");
    editor().setFocus();
    settle();
    QSet<QString> visited;
    for (int i = 0; i < 12; ++i) {
        press(Qt::Key_F6, Qt::ControlModifier);
        for (QWidget* at = QApplication::focusWidget(); at; at = at->parentWidget())
            if (auto* dock = qobject_cast<QDockWidget*>(at)) visited << dock->objectName();
        if (editor().hasFocus()) break;
    }
    EXPECT_TRUE(editor().hasFocus()) << "around the end";
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
        const bool isInSight = dock->isVisible() && !dock->visibleRegion().isEmpty();
        EXPECT_TRUE(!isInSight || visited.contains(dock->objectName())) << dock->objectName().toStdString();
    }
    press(Qt::Key_F6, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_FALSE(editor().hasFocus());
    press(Qt::Key_F6, Qt::ControlModifier);
    EXPECT_TRUE(editor().hasFocus());
}

TEST_F(KeyboardTest, PanesGetLargerAndSmaller) {
    const Qt::KeyboardModifiers both = Qt::ControlModifier | Qt::AltModifier;
    window->showDock("project");
    QDockWidget& dock = *window->dock("project");
    window->projectTree().tree().setFocus();
    settle();
    const int width = dock.width();
    press(Qt::Key_X, both);
    EXPECT_TRUE(waitFor([&] { return dock.width() > width; }));
    press(Qt::Key_X, both | Qt::ShiftModifier);
    EXPECT_TRUE(waitFor([&] { return dock.width() == width; }));
    // The documents have no edge of their own: what is below them gives way.
    StPage* page = window->tabs().openFile("src/main.st");
    editor().setFocus();
    settle();
    const int height = page->height();
    press(Qt::Key_Y, both);
    EXPECT_TRUE(waitFor([&] { return page->height() > height; }));
    // Inside of a document a splitter is nearer.
    page->toggleSplit();
    settle();
    page->first().setFocus();
    const int upper = page->first().height(), whole = page->height();
    press(Qt::Key_Y, both);
    EXPECT_TRUE(waitFor([&] { return page->first().height() > upper; }));
    EXPECT_EQ(page->height(), whole);
}

TEST_F(KeyboardTest, TheSidesOfADialogGetLargerToo) {
    MergeDialog dialog("src/main.st", "a := 1;\n", "a := 2;\n", window.get());
    dialog.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog, kPatience));
    dialog.activateWindow();
    auto* splitter = dialog.findChild<QSplitter*>();
    ASSERT_NE(splitter, nullptr);
    splitter->widget(0)->findChild<QsciScintilla*>()->setFocus();
    ASSERT_NE(QApplication::focusWidget(), nullptr);
    const int width = splitter->sizes().front();
    press(Qt::Key_X, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_GT(splitter->sizes().front(), width);
}

TEST_F(KeyboardTest, DocksGoToAnotherSideAndFloat) {
    window->showDock("watch");
    QDockWidget& dock = *window->dock("watch");
    window->watch().tree().setFocus();
    ASSERT_EQ(window->dockWidgetArea(&dock), Qt::RightDockWidgetArea);
    const Qt::KeyboardModifiers all = Qt::ControlModifier | Qt::AltModifier | Qt::ShiftModifier;
    for (const Qt::DockWidgetArea side : {Qt::LeftDockWidgetArea, Qt::BottomDockWidgetArea, Qt::RightDockWidgetArea}) {
        press(Qt::Key_D, all);
        EXPECT_EQ(window->dockWidgetArea(&dock), side);
        EXPECT_TRUE(window->watch().tree().hasFocus());
    }
    command("Float or Dock Again");
    EXPECT_TRUE(dock.isFloating());
    QApplication::setActiveWindow(&dock);
    window->watch().tree().setFocus();
    window->action("view.floatDock")->trigger();
    EXPECT_FALSE(dock.isFloating());
}

TEST_F(KeyboardTest, BlocksAreFolded) {
    window->tabs().openFile("src/main.st");
    editor().setFocus();
    const auto isShown = [&](const char* text) {
        const auto at = static_cast<unsigned long>(editor().utf8().find(text));
        const long line = editor().SendScintilla(QsciScintillaBase::SCI_LINEFROMPOSITION, at);
        return editor().SendScintilla(QsciScintillaBase::SCI_GETLINEVISIBLE, static_cast<unsigned long>(line)) != 0;
    };
    editor().goTo(static_cast<uint32_t>(editor().utf8().find("done := NOT")));
    ASSERT_TRUE(isShown("done := NOT"));
    press(Qt::Key_F, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_FALSE(isShown("done := NOT"));
    EXPECT_TRUE(isShown("IF counter"));
    EXPECT_TRUE(isShown("pulse(IN"));
    press(Qt::Key_F, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_TRUE(isShown("done := NOT"));
    command("Fold or Unfold All");
    EXPECT_FALSE(isShown("counter : INT"));
    EXPECT_TRUE(isShown("PROGRAM Main"));
    editor().setFocus();
    command("Fold or Unfold All");
    EXPECT_TRUE(isShown("counter : INT"));
}

TEST_F(KeyboardTest, WhatRestsUnderThePointerIsShownAtTheCursor) {
    window->tabs().openFile("src/main.st");
    editor().setFocus();
    editor().goTo(static_cast<uint32_t>(editor().utf8().find("limit THEN") + 2));
    press(Qt::Key_I, Qt::ControlModifier);
    EXPECT_TRUE(waitFor([] { return QToolTip::text().contains("limit"); })) << QToolTip::text().toStdString();
    EXPECT_TRUE(QToolTip::text().contains("INT"));
    editor().goTo(static_cast<uint32_t>(editor().utf8().find(":= counter + 1") - 1)); // behind the word
    press(Qt::Key_I, Qt::ControlModifier);
    EXPECT_TRUE(waitFor([] { return QToolTip::text().contains("counter"); })) << QToolTip::text().toStdString();
    QToolTip::hideText();
}

TEST_F(KeyboardTest, TheContextMenuIsAboutWhatIsSelected) {
    const auto menuOf = [&](QWidget* place) {
        giveFocus(*place);
        QStringList entries;
        asSoonAs(qApp, &QApplication::activePopupWidget, [&](QWidget& shown) {
            for (const QAction* action : shown.actions()) entries << QString(action->text()).remove('&');
            QTest::keyClick(&shown, Qt::Key_Escape);
        });
        press(Qt::Key_F10, Qt::AltModifier | Qt::ShiftModifier);
        EXPECT_FALSE(entries.isEmpty()) << place->metaObject()->className();
        return entries;
    };
    EXPECT_TRUE(menuOf(&window->tabs().openFile("src/main.st")->first()).contains("Select All"));
    window->showDock("project");
    window->projectTree().tree().setCurrentItem(window->projectTree().tree().topLevelItem(0));
    menuOf(&window->projectTree().tree());
    window->showDock("watch");
    window->watch().setExpressions({"Main.counter"});
    window->watch().tree().setCurrentItem(window->watch().tree().topLevelItem(0));
    menuOf(&window->watch().tree());
    window->tabs().showChart("src/steps.st", "Steps");
    auto* chart = window->tabs().currentPage()->chart()->findChild<QGraphicsView*>();
    giveFocus(*chart);
    press(Qt::Key_Down);
    EXPECT_TRUE(menuOf(chart).filter("Breakpoint").size() == 1) << "a step or a transition is selected";
    auto* ladder = window->tabs().openFile("src/rungs.st")->showLadder("Rungs")->findChild<QGraphicsView*>();
    giveFocus(*ladder);
    press(Qt::Key_Down);
    press(Qt::Key_Right);
    EXPECT_TRUE(menuOf(ladder).contains("Negate")) << "a contact is selected";
    hmi::PanelDesigner& panel = designer();
    panel.selection().set({"b"});
    menuOf(&panel.canvas());
    EXPECT_EQ(panel.selection().ids(), hmi::ElementIds{"b"});
}

TEST_F(KeyboardTest, AContactMovesPastItsNeighbour) {
    editor::LadderView* view = window->tabs().openFile("src/rungs.st")->showLadder("Rungs");
    view->findChild<QGraphicsView*>()->setFocus();
    press(Qt::Key_Down);
    press(Qt::Key_Right); // the first contact
    press(Qt::Key_Right, Qt::ControlModifier);
    EXPECT_NE(window->workspace().text("src/rungs.st").find("motor := second AND first"), std::string::npos)
        << window->workspace().text("src/rungs.st");
    press(Qt::Key_Z, Qt::ControlModifier);
    EXPECT_NE(window->workspace().text("src/rungs.st").find("motor := first AND second"), std::string::npos);
    window->workspace().revert("src/rungs.st");
}

TEST_F(KeyboardTest, ReturnGoesIntoAGroupAndToTheTextOfAnElement) {
    hmi::PanelDesigner& panel = designer();
    panel.canvas().setFocus();
    panel.selection().set({"g"});
    press(Qt::Key_Return);
    EXPECT_EQ(panel.selection().ids(), hmi::ElementIds{"a"});
    press(Qt::Key_Escape);
    EXPECT_EQ(panel.selection().ids(), hmi::ElementIds{"g"});
    panel.selection().set({"b"});
    panel.canvas().setFocus();
    press(Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return panel.sheet().isAncestorOf(QApplication::focusWidget()); }));
    auto* line = qobject_cast<QLineEdit*>(QApplication::focusWidget());
    ASSERT_NE(line, nullptr);
    EXPECT_EQ(line->text(), "Valve");
    press(Qt::Key_Escape);
}

TEST_F(KeyboardTest, AColourIsChosenWithTheArrows) {
    const std::vector<QColor>& all = kit::ColorPopup::swatches();
    QColor chosen, seen;
    auto* popup = new kit::ColorPopup(all[3], true, window.get());
    QObject::connect(popup, &kit::ColorPopup::chosen, popup, [&](const QColor& color) { chosen = color; });
    QObject::connect(popup, &kit::ColorPopup::hovered, popup, [&](const QColor& color) { seen = color; });
    popup->openBelow(QRect(window->mapToGlobal(QPoint(200, 200)), QSize(80, 20)));
    QTest::keyClick(popup, Qt::Key_Right);
    EXPECT_EQ(seen, all[4]) << "shown before it is taken";
    QTest::keyClick(popup, Qt::Key_Down);
    QTest::keyClick(popup, Qt::Key_Left);
    QTest::keyClick(popup, Qt::Key_Return);
    EXPECT_EQ(chosen, all[13]);
}

} // namespace
} // namespace plc::app
