// The project tree with real events: variables that are dragged, files that are renamed and deleted with what refers to
// them.
#include "app/panels/live_views.h"
#include "app/project/project_tree.h"
#include "app/project/rename_dialog.h"
#include "app/project/search_view.h"
#include "editor/debug/watch_view.h"
#include "editor/kit/inputs/variable_picker.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"

#include <QAbstractButton>
#include <QAction>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QInputDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QMimeData>
#include <QTimer>

namespace plc::app {
namespace {

class ProjectTreeTest : public StudioTest {
protected:
    void SetUp() override {
        write("src/motor.st", "FUNCTION_BLOCK Motor\nVAR_INPUT run : BOOL; END_VAR\nVAR_OUTPUT turns : DINT; "
                              "END_VAR\nIF run THEN turns := turns + 1; END_IF\nEND_FUNCTION_BLOCK\n");
        write("hmi/overview.panel.json",
              "{\n  \"version\": 1,\n  \"elements\": [\n    {\n      \"id\": \"b\",\n      \"kind\": \"button\",\n     "
              " \"rect\": [10, 10, 100, 40],\n      \"panel\": \"details\"\n    }\n  ]\n}\n");
        write("hmi/details.panel.json", "{\n  \"version\": 1,\n  \"elements\": []\n}\n");
        write("traces/start.trace.json", "{}\n");
        StudioTest::SetUp();
        ASSERT_TRUE(waitFor([&] { return item("Motor") != nullptr; }));
    }
    QTreeWidget& tree() { return window->projectTree().tree(); }
    QTreeWidgetItem* item(const QString& name) {
        const auto found = tree().findItems(name, Qt::MatchExactly | Qt::MatchRecursive);
        return found.isEmpty() ? nullptr : found.first();
    }
    void select(const QString& name) {
        QTreeWidgetItem* found = item(name);
        ASSERT_NE(found, nullptr) << name.toStdString();
        tree().setCurrentItem(found);
        tree().setFocus();
    }
    QByteArray content(const QString& file) {
        QFile f(folder.path() + "/" + file);
        return f.open(QIODevice::ReadOnly) ? f.readAll() : QByteArray();
    }
};

TEST_F(ProjectTreeTest, AVariableIsDraggedIntoTheWatch) {
    QTreeWidgetItem* counter = item("counter");
    ASSERT_NE(counter, nullptr);
    const std::unique_ptr<QMimeData> mime(tree().model()->mimeData(
        {tree()
             .model()
             ->match(tree().model()->index(0, 0), Qt::DisplayRole, "counter", 1, Qt::MatchExactly | Qt::MatchRecursive)
             .first()}));
    ASSERT_NE(mime, nullptr);
    EXPECT_EQ(kit::variablesOf(mime.get()), QStringList{"Main.counter"});
    EXPECT_EQ(mime->text(), "counter") << "the text takes the name";
    QDragEnterEvent enter(QPoint(30, 60), Qt::CopyAction, mime.get(), Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window->watch(), &enter);
    EXPECT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(30, 60), Qt::CopyAction, mime.get(), Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&window->watch(), &drop);
    EXPECT_TRUE(window->watch().expressions().contains("Main.counter"));
}

TEST_F(ProjectTreeTest, ABlockIsDeletedAndItsUsesCommentedOut) {
    const auto at = static_cast<uint32_t>(editor().utf8().find("    pulse : TON;"));
    editor().applyEdits({{{FileId(), at, at}, "    drive : Motor;\n"}});
    analysed();
    ASSERT_TRUE(waitFor([&] { return item("drive") != nullptr; }));
    select("Motor");
    pressInNext(window.get(), "Delete and Comment Out the Uses");
    QTest::keyClick(&tree(), Qt::Key_Delete);
    EXPECT_NE(editor().utf8().find("    // drive : Motor;"), std::string::npos) << editor().utf8();
    EXPECT_FALSE(window->workspace().files().contains("src/motor.st")) << "the file held nothing else";
    EXPECT_EQ(window->search().results().topLevelItemCount(), 2) << "declaration and use are listed";
}

TEST_F(ProjectTreeTest, APanelIsRenamedWithTheButtonsThatLeadToIt) {
    select("details");
    typeIntoNext(window.get(), "motor");
    QTest::keyClick(&tree(), Qt::Key_F2);
    EXPECT_TRUE(waitFor([&] { return item("motor") != nullptr; }));
    EXPECT_TRUE(content("hmi/overview.panel.json").contains("\"panel\": \"motor\""))
        << content("hmi/overview.panel.json").toStdString();
    EXPECT_FALSE(QFile::exists(folder.path() + "/hmi/details.panel.json"));
    EXPECT_NE(window->live().panels().find("motor"), nullptr);
}

TEST_F(ProjectTreeTest, ATraceIsMadeRenamedAndDeleted) {
    typeIntoNext(window.get(), "second");
    window->action("file.newTrace")->trigger();
    EXPECT_TRUE(waitFor([&] { return item("second") != nullptr; }));
    select("second");
    typeIntoNext(window.get(), "third");
    QTest::keyClick(&tree(), Qt::Key_F2);
    EXPECT_TRUE(waitFor([&] { return item("third") != nullptr && item("second") == nullptr; }));
    select("third");
    pressInNext(window.get(), "Yes");
    QTest::keyClick(&tree(), Qt::Key_Delete);
    EXPECT_TRUE(waitFor([&] { return item("third") == nullptr; }));
    EXPECT_FALSE(QFile::exists(folder.path() + "/traces/third.trace.json"));
}

TEST_F(ProjectTreeTest, AVariableIsRenamedFromTheTree) {
    select("counter");
    QTimer names; // the dialog shows what changes
    QObject::connect(&names, &QTimer::timeout, qApp, [] {
        auto* dialog = qobject_cast<RenameDialog*>(QApplication::activeModalWidget());
        if (!dialog) return;
        dialog->findChild<QLineEdit*>()->setText("ticks");
        dialog->accept();
    });
    names.start(20);
    QTest::keyClick(&tree(), Qt::Key_F2);
    EXPECT_EQ(editor().utf8().find("counter"), std::string::npos);
}

} // namespace
} // namespace plc::app
