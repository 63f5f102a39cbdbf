// What stays: shortcuts, texts after a crash and after a change from outside, and the whole arrangement of a project
// that is opened again.
#include "app/documents/design_pages.h"
#include "app/settings/settings_dialog.h"
#include "editor/debug/watch_view.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"

#include <QAbstractButton>
#include <QAction>
#include <QDialogButtonBox>
#include <QKeySequenceEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>

namespace plc::app {
namespace {

class KeptStateTest : public StudioTest {
protected:
    void breakAt(const char* text) {
        editor().goTo(static_cast<uint32_t>(editor().utf8().find(text)));
        window->action("run.breakpoint")->trigger();
    }
};

TEST_F(KeptStateTest, AProjectThatCannotBeOpenedLeavesTheOneThatIsOpenAndRuns) {
    QTemporaryDir broken;
    QFile file(broken.path() + "/project.json");
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\"name\": \"Broken\"");
    file.close();
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 3; }));
    const auto wasAsked = pressInNext(qApp, QMessageBox::Ok);
    EXPECT_FALSE(window->openProject(broken.path()));
    EXPECT_TRUE(*wasAsked) << "why is said";
    EXPECT_EQ(window->workspace().folder().toStdString(), folder.path().toStdString());
    EXPECT_EQ(window->control().status().state, controller::State::Running);
}

TEST_F(KeptStateTest, ShortcutsAreSetInTheSettingsAndStay) {
    inNext<SettingsDialog>(window.get(), [&](SettingsDialog& dialog) {
        auto* table = dialog.findChild<QTableWidget*>();
        ASSERT_NE(table, nullptr);
        for (int row = 0; row < table->rowCount(); ++row)
            if (table->item(row, 0)->text() == window->action("run.speed")->text())
                static_cast<QKeySequenceEdit*>(table->cellWidget(row, 1))->setKeySequence(QKeySequence("Ctrl+Alt+S"));
        dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
    });
    window->action("file.settings")->trigger();
    EXPECT_EQ(window->action("run.speed")->shortcut(), QKeySequence("Ctrl+Alt+S"));
    const MainWindow another;
    EXPECT_EQ(another.action("run.speed")->shortcut(), QKeySequence("Ctrl+Alt+S"));
}

TEST_F(KeptStateTest, WhatACrashLeftIsOfferedAndRestored) {
    window->closeProject();
    write("src/.main.st.autosave", QByteArray(kMain).replace(":= 1000", ":= 4321"));
    pressInNext(qApp, QMessageBox::Yes);
    ASSERT_TRUE(window->openProject(folder.path()));
    EXPECT_NE(editor().utf8().find("4321"), std::string::npos);
    EXPECT_TRUE(window->workspace().isModified("src/main.st"));
    pressInNext(qApp, QMessageBox::Discard);
    window->closeProject();
}

TEST_F(KeptStateTest, AChangeOutsideAndHereAsksAndKeepsWhatIsHere) {
    typeAtEnd("done := FALSE;");
    const auto wasAsked = pressInNext(qApp, QMessageBox::No);
    write("src/main.st", QByteArray(kMain).replace(":= 1000", ":= 500"));
    ASSERT_TRUE(waitFor([&] { return *wasAsked; }));
    EXPECT_NE(editor().utf8().find("done := FALSE;"), std::string::npos);
    EXPECT_NE(editor().utf8().find(":= 1000"), std::string::npos);
    pressInNext(qApp, QMessageBox::Discard);
    window->closeProject();
}

TEST_F(KeptStateTest, TheNextMorningEverythingIsWhereItWas) {
    write("hmi/overview.panel.json", "{\n  \"version\": 1,\n  \"elements\": []\n}\n");
    window->closeProject();
    ASSERT_TRUE(window->openProject(folder.path()));
    window->designs().openPanel("overview");
    window->designs().openTexts();
    window->tabs().openFile("src/main.st");
    const auto place = static_cast<uint32_t>(editor().utf8().find("done := NOT"));
    editor().goTo(place);
    breakAt("done := NOT");
    window->watch().setExpressions({"Main.done"});
    window->closeProject();
    window = std::make_unique<MainWindow>();
    window->show();
    ASSERT_TRUE(window->openProject(folder.path()));
    EXPECT_NE(window->tabs().pageByKey("panel:overview"), nullptr);
    EXPECT_NE(window->tabs().pageByKey("texts"), nullptr);
    ASSERT_NE(window->tabs().currentPage(), nullptr);
    EXPECT_EQ(editor().cursorOffset(), place);
    EXPECT_EQ(window->control().breakpoints().size(), 1u);
    EXPECT_EQ(window->watch().expressions(), QStringList{"Main.done"});
}

} // namespace
} // namespace plc::app
