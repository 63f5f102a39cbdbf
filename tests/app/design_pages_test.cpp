// Panels in the studio's window: opened from the tree, drawn, undone, live, saved, and what is wrong with them in the
// list of problems.
#include "app/panels/live_views.h"
#include "app/project/problems_view.h"
#include "app/project/project_tree.h"
#include "hmi/designer/panel_designer.h"
#include "hmi/player/panel_player.h"
#include "tests/app/studio_fixture.h"

#include <QAbstractButton>
#include <QAction>
#include <QDropEvent>
#include <QElapsedTimer>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QRegularExpression>
#include <QStatusBar>

#include "editor/kit/inputs/variable_picker.h"
#include "hmi/designer/editors/recipe_editor.h"
#include "tests/support/answer.h"
#include "tests/support/settle.h"

namespace plc::app {
namespace {

class DesignPagesTest : public StudioTest {
protected:
    void SetUp() override {
        write("hmi/overview.panel.json",
              "{\n  \"elements\": [\n    {\n      \"kind\": \"number\",\n      \"id\": \"count\",\n      \"rect\": "
              "[40, 40, 120, 40],\n      \"value\": \"Main.counter\"\n    }\n  ]\n}\n");
        StudioTest::SetUp();
    }
    void TearDown() override {
        if (window && window->workspace().isOpen())
            pressInNext(window.get(), QMessageBox::Discard), window->closeProject();
        StudioTest::TearDown();
    }
    hmi::PanelDesigner* openFromTree(const QString& name) {
        QTreeWidget& tree = window->projectTree().tree();
        if (!waitFor([&] { return !tree.findItems(name, Qt::MatchExactly | Qt::MatchRecursive).isEmpty(); }))
            return nullptr;
        QTreeWidgetItem* item = tree.findItems(name, Qt::MatchExactly | Qt::MatchRecursive).first();
        tree.scrollToItem(item);
        QTest::mouseClick(tree.viewport(), Qt::LeftButton, Qt::NoModifier, tree.visualItemRect(item).center());
        return qobject_cast<hmi::PanelDesigner*>(window->tabs().currentWidget());
    }
    static void drop(hmi::PanelDesigner& designer, const QString& variable, QPointF at) {
        const QPointF point = designer.canvas().toViewport(at);
        std::unique_ptr<QMimeData> mime(kit::makeVariableMime({variable}));
        QDragEnterEvent enter(point.toPoint(), Qt::CopyAction, mime.get(), Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(designer.canvas().viewport(), &enter);
        QDropEvent event(point, Qt::CopyAction, mime.get(), Qt::LeftButton, Qt::NoModifier);
        QApplication::sendEvent(designer.canvas().viewport(), &event);
    }
    [[nodiscard]] QStringList problemPlaces() const {
        QStringList out;
        for (int i = 0; i < window->problems().list().topLevelItemCount(); ++i)
            out << window->problems().list().topLevelItem(i)->text(2) + ": " +
                       window->problems().list().topLevelItem(i)->text(0);
        return out;
    }
};

TEST_F(DesignPagesTest, AClosedDesignerOutlivesItsProjectByAMoment) {
    ASSERT_NE(openFromTree("overview"), nullptr);
    const QString folder = window->workspace().folder();
    window->closeProject();
    ASSERT_TRUE(window->openProject(folder));
    QElapsedTimer time;
    // a duration: of a question, inside of which timers run, and what is to be deleted later waits
    for (time.start(); time.elapsed() < 700;) QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
    EXPECT_NE(openFromTree("overview"), nullptr);
}

TEST_F(DesignPagesTest, ThePlaceOfTheCursorIsShownOnlyForATextInFront) {
    const auto place = [&] {
        const QRegularExpression form(QStringLiteral("^\\d+ : \\d+$"));
        for (const QLabel* label : window->statusBar()->findChildren<QLabel*>())
            if (form.match(label->text()).hasMatch()) return label->text();
        return QString();
    };
    window->tabs().openFile("src/main.st");
    ASSERT_NE(window->tabs().currentEditor(), nullptr);
    const int text = window->tabs().currentIndex();
    window->tabs().currentEditor()->setCursorPosition(1, 0);
    EXPECT_TRUE(waitFor([&] { return place() == "2 : 1"; })) << place().toStdString();
    ASSERT_NE(openFromTree("overview"), nullptr);
    EXPECT_TRUE(waitFor([&] { return place().isEmpty(); })) << place().toStdString();
    window->tabs().setCurrentIndex(text);
    EXPECT_TRUE(waitFor([&] { return place() == "2 : 1"; })) << place().toStdString();
}

TEST_F(DesignPagesTest, IsOpenedFromTheTreeEditedUndoneAndSeenLive) {
    hmi::PanelDesigner* designer = openFromTree("overview");
    ASSERT_NE(designer, nullptr);
    const size_t before = designer->document().panel().elements().size();
    drop(*designer, "Main.done", {300, 200});
    EXPECT_EQ(designer->document().panel().elements().size(), before + 1);
    EXPECT_TRUE(designer->isModified());
    QTest::keyClick(designer->canvas().viewport(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(designer->document().panel().elements().size(), before);
    EXPECT_FALSE(designer->isModified());
    QTest::keyClick(designer->canvas().viewport(), Qt::Key_Y, Qt::ControlModifier);
    EXPECT_EQ(designer->document().panel().elements().size(), before + 1);

    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 3; }));
    designer->setLive(true);
    ASSERT_NE(designer->preview(), nullptr);
    EXPECT_TRUE(designer->preview()->isVisible());
    designer->setLive(false);

    window->action("file.save")->trigger();
    EXPECT_FALSE(designer->isModified());
    QFile file(folder.path() + "/hmi/overview.panel.json");
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().contains("Main.done"));
}

TEST_F(DesignPagesTest, AClosedTabAsksForWhatWasDrawn) {
    hmi::PanelDesigner* designer = openFromTree("overview");
    ASSERT_NE(designer, nullptr);
    drop(*designer, "Main.done", {300, 200});
    pressInNext(window.get(), QMessageBox::Cancel);
    window->action("file.closeTab")->trigger();
    EXPECT_EQ(window->tabs().currentWidget(), designer) << "cancelled: it stays";
    pressInNext(window.get(), QMessageBox::Save);
    window->action("file.closeTab")->trigger();
    EXPECT_EQ(window->tabs().pageByKey("panel:overview"), nullptr);
    QFile file(folder.path() + "/hmi/overview.panel.json");
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().contains("Main.done"));
}

TEST_F(DesignPagesTest, ABindingThatBreaksInTheCodeIsAProblemThatLeadsToTheElement) {
    ASSERT_TRUE(waitFor([&] { return window->live().design() != nullptr; }));
    ASSERT_TRUE(waitFor([&] { return window->live().design()->checked().analysis != nullptr; }));
    EXPECT_TRUE(problemPlaces().filter("overview.panel.json").isEmpty()) << problemPlaces().join('\n').toStdString();
    // The variable gets another name in the code alone, as by hand.
    std::string text = editor().utf8();
    for (size_t at = 0; (at = text.find("counter", at)) != std::string::npos; at += 5) text.replace(at, 7, "ticks");
    editor().applyEdits({{{FileId(), 0, static_cast<uint32_t>(editor().utf8().size())}, text}});
    ASSERT_TRUE(waitFor([&] { return !problemPlaces().filter("overview.panel.json").isEmpty(); }))
        << problemPlaces().join('\n').toStdString();
    QTreeWidget& list = window->problems().list();
    window->showDock("problems");
    for (int i = 0; i < list.topLevelItemCount(); ++i)
        if (list.topLevelItem(i)->text(2).contains("overview.panel.json")) {
            settle();
            list.scrollToItem(list.topLevelItem(i));
            QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier,
                              list.visualItemRect(list.topLevelItem(i)).center());
            break;
        }
    auto* designer = qobject_cast<hmi::PanelDesigner*>(window->tabs().currentWidget());
    ASSERT_NE(designer, nullptr);
    EXPECT_TRUE(designer->selection().contains("count"));
}

TEST_F(DesignPagesTest, ARecipeThatNamesNoVariableIsAProblemThatLeadsToTheRecipes) {
    ASSERT_TRUE(waitFor([&] { return window->live().design() && window->live().design()->checked().analysis; }));
    const auto recipeOf = [&](const QByteArray& variable) {
        write("hmi/recipes.json", R"({"recipes": [{"name": "dough", "variables": [{"variable": ")" + variable +
                                      R"("}], "sets": [{"name": "rye", "values": {")" + variable + R"(": "5"}}]}]})");
    };
    const auto found = [&] { return problemPlaces().filter("hmi/recipes.json"); };
    recipeOf("Main.nowhere");
    ASSERT_TRUE(waitFor([&] { return found().size() == 1; })) << problemPlaces().join('\n').toStdString();
    EXPECT_TRUE(found().front().contains("has no member nowhere")) << found().front().toStdString();
    QTreeWidget& list = window->problems().list();
    window->showDock("problems");
    settle();
    for (int i = 0; i < list.topLevelItemCount(); ++i)
        if (list.topLevelItem(i)->text(2).contains("recipes.json")) emit list.itemActivated(list.topLevelItem(i), 0);
    EXPECT_NE(qobject_cast<hmi::RecipeEditor*>(window->tabs().currentWidget()), nullptr);
    recipeOf("Main.limit");
    EXPECT_TRUE(waitFor([&] { return found().isEmpty(); })) << problemPlaces().join('\n').toStdString();
    window->tabs().openFile("src/main.st");
    QString text = QString::fromStdString(editor().utf8());
    const auto size = static_cast<uint32_t>(editor().utf8().size());
    editor().applyEdits({{{FileId(), 0, size}, text.replace("limit", "bound").toStdString()}});
    EXPECT_TRUE(waitFor([&] { return found().size() == 1; })) << "by hand in the code alone";
}

} // namespace
} // namespace plc::app
