// Files of the operator side that other programs change: taken when nothing is unsaved here, asked about when something
// is, never written over unknowingly; new ones appear; what cannot be read opens as text and is a problem.
#include "app/documents/design_pages.h"
#include "app/pages/disk_change.h"
#include "app/pages/merge_dialog.h"
#include "app/panels/live_views.h"
#include "app/panels/panel_files.h"
#include "app/panels/text_page.h"
#include "app/project/problems_view.h"
#include "app/project/project_tree.h"
#include "hmi/designer/canvas/design_canvas.h"
#include "hmi/designer/panel_designer.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"

#include <QAbstractButton>
#include <QAction>
#include <QLabel>
#include <QMessageBox>
#include <QStatusBar>
#include <QTreeWidget>
#include <Qsci/qsciscintilla.h>

namespace plc::app {
namespace {

QByteArray panelWith(const QByteArray& text) {
    return "{\n  \"elements\": [\n    {\"kind\": \"text\", \"id\": \"a\", \"rect\": [40, 40, 120, 40], \"text\": \"" +
           text + "\"}\n  ]\n}\n";
}
const QByteArray kTexts = "key,comment,en,de\r\nstart,,Start,Start\r\nstop,,Stop,Halt\r\n";

class DiskChangeTest : public StudioTest {
protected:
    void SetUp() override {
        write("hmi/overview.panel.json", panelWith("first"));
        write("hmi/texts.csv", kTexts);
        StudioTest::SetUp();
    }
    void TearDown() override {
        for (const QString& key : window->panelFiles().changed()) window->panelFiles().discard(key);
        StudioTest::TearDown();
    }
    QByteArray onDisk(const QString& path) {
        QFile file(folder.path() + "/" + path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    QString shownText() {
        const auto* panel = window->live().panels().find("overview");
        return panel && panel->panel.find("a") ? panel->panel.find("a")->text("text") : QString();
    }
    void edit(const char* text) {
        window->designs().openPanel("overview");
        auto* designer = qobject_cast<hmi::PanelDesigner*>(window->tabs().currentWidget());
        ASSERT_NE(designer, nullptr);
        designer->document().perform("text",
                                     hmi::setProperty(designer->document().panel(), "a", "text", hmi::Json(text)));
        ASSERT_TRUE(window->panelFiles().isChanged("panel:overview"));
    }
    void setText(const QString& key, const QString& text) {
        hmi::TextTable table = window->live().panels().texts.table();
        table.setText(key, "de", text);
        window->live().design()->setTable(table);
    }
    /// The next question is answered with the button of that name.
    static void answerNext(const char* button) {
        asSoonAs(
            qApp,
            [button]() -> QAbstractButton* {
                const QWidget* box = QApplication::activeModalWidget();
                return box ? box->findChild<QAbstractButton*>(button) : nullptr;
            },
            [](QAbstractButton& found) { found.click(); });
    }
    QString tabTitle(const QString& key) {
        return window->tabs().tabText(window->tabs().indexOf(window->tabs().pageByKey(key)));
    }
    QStringList problemPlaces() {
        QStringList out;
        for (int i = 0; i < window->problems().list().topLevelItemCount(); ++i)
            out << window->problems().list().topLevelItem(i)->text(2);
        return out;
    }
};

TEST_F(DiskChangeTest, WhatIsCleanHereIsTakenFromDisk) {
    window->designs().openPanel("overview");
    write("hmi/overview.panel.json", panelWith("second"));
    EXPECT_TRUE(waitFor([&] { return shownText() == "second"; }));
    auto* designer = qobject_cast<hmi::PanelDesigner*>(window->tabs().pageByKey("panel:overview"));
    EXPECT_EQ(designer->document().panel().find("a")->text("text"), "second") << "also where it is drawn";
    write("hmi/texts.csv", QByteArray(kTexts).replace("Halt", "Stopp"));
    EXPECT_TRUE(waitFor([&] { return window->live().panels().texts.table().text("stop", "de") == "Stopp"; }));
    write("hmi/alarms.json", "{\"alarms\": [{\"id\": \"hot\", \"condition\": \"Main.done\"}]}");
    EXPECT_TRUE(waitFor([&] { return window->live().panels().alarms.rows().size() == 1; }));
}

TEST_F(DiskChangeTest, AThemeWrittenElsewhereIsShownAndWhatIsWrongWithItIsAFinding) {
    write("hmi/overview.panel.json",
          panelWith("first").replace("{\n  \"elements\"", "{\"theme\": \"fog\", \"elements\""));
    window->designs().openPanel("overview");
    auto* canvas = window->tabs().currentWidget()->findChild<hmi::DesignCanvas*>();
    ASSERT_NE(canvas, nullptr);
    const auto isShown = [&](const char* color) {
        const QColor wanted{QLatin1String(color)};
        return waitFor([&] {
            return canvas->scene().theme().color("background") == wanted && window->live().player() &&
                   window->live().player()->scene().theme().color("background") == wanted;
        });
    };
    ASSERT_TRUE(QDir(folder.path()).mkpath("hmi/themes"));
    write("hmi/themes/fog.json", "{\"base\": \"dark\", \"colors\": {\"background\": \"#102030\"}}");
    EXPECT_TRUE(isShown("#102030")) << "the file is new";
    write("hmi/themes/fog.json", "{\"base\": \"dark\", \"colors\": {\"background\": \"#203040\"}}");
    EXPECT_TRUE(isShown("#203040")) << "the file is another";
    write("hmi/themes/fog.json", "{\"base\": \"dark\",\n \"colors\": {\n  \"backgrond\": \"#304050\"}}");
    EXPECT_TRUE(waitFor([&] { return problemPlaces().contains("hmi/themes/fog.json:3"); }))
        << problemPlaces().join(" | ").toStdString();
    EXPECT_TRUE(isShown("#203040")) << "what was understood last stays";
    write("hmi/themes/fog.json", "{\"base\": \"dark\", \"colors\": {\"background\": \"#304050\"}}");
    EXPECT_TRUE(isShown("#304050"));
    EXPECT_TRUE(waitFor([&] { return problemPlaces().filter("hmi/themes/").isEmpty(); }))
        << problemPlaces().join(" | ").toStdString();
    ASSERT_TRUE(QFile::remove(folder.path() + "/hmi/themes/fog.json"));
    EXPECT_TRUE(waitFor([&] { return window->live().panels().themes.own().empty(); })) << "the file is gone";
}

TEST_F(DiskChangeTest, TextsChangedOnDiskAreNotOverwrittenUnknowingly) {
    setText("start", "Anfahren");
    answerNext("loadFromDisk");
    write("hmi/texts.csv", QByteArray(kTexts).replace("Halt", "Stopp"));
    ASSERT_TRUE(waitFor([&] { return window->live().panels().texts.table().text("stop", "de") == "Stopp"; }));
    EXPECT_FALSE(window->panelFiles().isChanged("texts"));
    EXPECT_EQ(window->live().panels().texts.table().text("start", "de"), "Start");
}

TEST_F(DiskChangeTest, WhatTheOperatorSavesIsAskedAboutWhereTheRecipeEditorHasChanges) {
    write("hmi/recipes.json", R"({"recipes": [{"name": "dough", "variables": [{"variable": "Main.limit"}],
                               "sets": [{"name": "rye", "values": {"Main.limit": "5"}}]}]})");
    ASSERT_TRUE(waitFor([&] { return window->live().panels().recipes.find("dough") != nullptr; }));
    ASSERT_NE(window->live().player(), nullptr);
    ASSERT_TRUE(waitFor([&] { return window->live().player()->recipes().find("dough") != nullptr; }));
    hmi::RecipeFile mine = window->live().panels().recipes;
    mine.find("dough")->title = "mine";
    window->live().design()->setRecipes(mine);
    ASSERT_TRUE(window->panelFiles().isChanged("recipes"));
    answerNext("loadFromDisk");
    window->live().player()->scene().request(
        hmi::RecipeRequest{{}, hmi::RecipeRequestKind::Add, "dough", "rye", {}}); // a key of the operator's list
    ASSERT_TRUE(waitFor([&] { return window->live().panels().recipes.find("dough")->sets.size() == 2; }));
    EXPECT_FALSE(window->panelFiles().isChanged("recipes"));
}

TEST_F(DiskChangeTest, SavingAsksFirstWhenTheFileIsNewer) {
    edit("here");
    answerNext("keepMine");
    write("hmi/overview.panel.json", panelWith("there"));
    window->action("file.save")->trigger(); // before the watcher has said anything
    EXPECT_TRUE(waitFor([&] { return onDisk("hmi/overview.panel.json").contains("here"); })) << "kept knowingly";
    EXPECT_FALSE(window->panelFiles().isChanged("panel:overview"));
}

TEST_F(DiskChangeTest, NothingIsWrittenOverAFileThatNobodyHasRead) {
    hmi::PanelProject& panels = window->live().panels();
    write("hmi/overview.panel.json", panelWith("there"));
    const auto saved = hmi::savePanel(panels, *panels.find("overview"));
    EXPECT_FALSE(saved);
    EXPECT_TRUE(onDisk("hmi/overview.panel.json").contains("there"));
}

TEST_F(DiskChangeTest, ChangedDocumentsHaveAMarkAndSaveAllSavesThem) {
    window->designs().openTexts();
    EXPECT_FALSE(tabTitle("texts").contains("●"));
    setText("start", "Anfahren");
    edit("here");
    EXPECT_TRUE(tabTitle("texts").contains("●"));
    EXPECT_TRUE(tabTitle("panel:overview").contains("●"));
    window->action("file.saveAll")->trigger();
    EXPECT_TRUE(onDisk("hmi/texts.csv").contains("Anfahren"));
    EXPECT_TRUE(onDisk("hmi/overview.panel.json").contains("here"));
    EXPECT_FALSE(tabTitle("texts").contains("●"));
    EXPECT_FALSE(tabTitle("panel:overview").contains("●"));
}

TEST_F(DiskChangeTest, NewPanelsAppearAndThoseThatAreGoneLeave) {
    write("hmi/second.panel.json", panelWith("new"));
    const auto isInTree = [&](const QString& name) {
        return !window->projectTree().tree().findItems(name, Qt::MatchExactly | Qt::MatchRecursive).isEmpty();
    };
    EXPECT_TRUE(waitFor([&] { return window->live().panels().find("second") && isInTree("second"); }));
    window->designs().openPanel("second");
    ASSERT_NE(window->tabs().pageByKey("panel:second"), nullptr);
    QFile::remove(folder.path() + "/hmi/second.panel.json");
    EXPECT_TRUE(waitFor([&] { return !window->live().panels().find("second") && !isInTree("second"); }));
    EXPECT_EQ(window->tabs().pageByKey("panel:second"), nullptr);
    write("traces/speed.trace.json", "{}");
    EXPECT_TRUE(waitFor([&] { return isInTree("speed"); }));
}

TEST_F(DiskChangeTest, AProgramFileThatIsNewerIsNotOverwritten) {
    typeAtEnd("done := FALSE;");
    const QByteArray there = QByteArray(kMain).replace(":= 1000", ":= 500");
    answerNext("keepMine");
    write("src/main.st", there);
    EXPECT_FALSE(window->workspace().save("src/main.st"));
    EXPECT_EQ(onDisk("src/main.st"), there);
    EXPECT_TRUE(window->workspace().save("src/main.st")) << "now it is known what goes";
    EXPECT_TRUE(onDisk("src/main.st").contains("done := FALSE;"));
}

TEST_F(DiskChangeTest, OneBadLineOfTheTextsCostsOnlyItself) {
    write("hmi/texts.csv",
          kTexts + "start,,again,noch einmal\r\nmore,,a,b,c,d\r\n\"broken\" x,,y,z\r\nlast,,Last,Letzter\r\n");
    ASSERT_TRUE(waitFor([&] { return window->live().panels().texts.table().contains("last"); }));
    const hmi::TextTable& table = window->live().panels().texts.table();
    EXPECT_EQ(table.rows().size(), 3U);
    EXPECT_EQ(table.text("stop", "de"), "Halt");
    for (const char* place :
         {"hmi/texts.csv:4", "hmi/texts.csv:5", "hmi/texts.csv:6"}) // the others are texts nobody uses
        EXPECT_TRUE(waitFor([&] { return problemPlaces().count(place) == 1; }))
            << problemPlaces().join(" | ").toStdString();
    setText("last", "Zuletzt");
    ASSERT_TRUE(window->panelFiles().save("texts"));
    const QByteArray written = onDisk("hmi/texts.csv");
    for (const char* kept : {"start,,again,noch einmal", "more,,a,b,c,d", "\"broken\" x,,y,z", "last,,Last,Zuletzt"})
        EXPECT_TRUE(written.contains(kept)) << kept << " in " << written.toStdString();
}

TEST_F(DiskChangeTest, ADuplicateIdCostsNoPanel) {
    write("hmi/overview.panel.json",
          "{\"elements\": [{\"kind\": \"text\", \"id\": \"a\", \"rect\": [1, 1, 9, 9], \"text\": \"one\"},"
          "{\"kind\": \"text\", \"id\": \"a\", \"rect\": [1, 20, 9, 9], \"text\": \"two\"}, 7]}");
    ASSERT_TRUE(waitFor([&] { return shownText() == "one"; }));
    const hmi::Panel& panel = window->live().panels().find("overview")->panel;
    ASSERT_EQ(panel.elements().size(), 2U);
    EXPECT_EQ(panel.elements()[1].text("text"), "two");
    EXPECT_NE(panel.elements()[1].id(), "a");
    EXPECT_TRUE(waitFor([&] { return problemPlaces().filter("hmi/overview.panel.json").size() >= 2; }));
    EXPECT_NE(panel.write().find("7"), std::string::npos) << "what is no element stays in the file";
}

TEST_F(DiskChangeTest, ABrokenPanelOpensAsTextWithItsErrorAndComesBackWhenItIsPutRight) {
    write("hmi/broken.panel.json", "{\n  \"elements\": [\n    oops\n  ]\n}\n");
    ASSERT_TRUE(waitFor([&] { return !problemPlaces().filter("hmi/broken.panel.json:3").isEmpty(); }))
        << problemPlaces().join(" | ").toStdString();
    window->designs().openPanel("broken");
    auto* page = qobject_cast<TextPage*>(window->tabs().currentWidget());
    ASSERT_NE(page, nullptr);
    EXPECT_TRUE(page->shownProblem().contains("3")) << page->shownProblem().toStdString();
    page->text().setText(QString::fromUtf8(panelWith("good")));
    EXPECT_TRUE(tabTitle("text:panel:broken").contains("●"));
    window->action("file.save")->trigger();
    ASSERT_NE(window->live().panels().find("broken"), nullptr);
    EXPECT_NE(qobject_cast<hmi::PanelDesigner*>(window->tabs().currentWidget()), nullptr) << "drawn from now on";
    EXPECT_TRUE(waitFor([&] { return problemPlaces().filter("hmi/broken.panel.json:").isEmpty(); }));
}

TEST_F(DiskChangeTest, TheDockSaysThatAPanelCannotBeReadAndNotThatThereIsNone) {
    window->closeProject();
    write("hmi/overview.panel.json", "{\n  \"elements\": [\n    oops\n");
    ASSERT_TRUE(window->openProject(folder.path()));
    const auto* place = window->findChild<QLabel*>("noPanel");
    ASSERT_NE(place, nullptr);
    EXPECT_FALSE(place->isHidden());
    EXPECT_TRUE(place->text().contains("overview")) << place->text().toStdString();
    EXPECT_FALSE(place->text().contains("no panel yet")) << place->text().toStdString();
    ASSERT_TRUE(waitFor([&] { return !problemPlaces().filter("hmi/overview.panel.json:3").isEmpty(); }))
        << problemPlaces().join(" | ").toStdString();
    EXPECT_TRUE(problemPlaces().filter("hmi/texts.csv:2").isEmpty()) << problemPlaces().join(" | ").toStdString();
    write("hmi/overview.panel.json", panelWith("again"));
    ASSERT_TRUE(waitFor([&] { return window->live().panels().find("overview") != nullptr; }));
    EXPECT_TRUE(place->isHidden());
}

TEST_F(DiskChangeTest, ATableThatCouldNotBeReadIsNotWrittenOver) {
    write("hmi/texts.csv", "what is this\r\n");
    EXPECT_TRUE(waitFor([&] { return !problemPlaces().filter("hmi/texts.csv:1").isEmpty(); }));
    window->designs().openTexts();
    EXPECT_NE(qobject_cast<TextPage*>(window->tabs().currentWidget()), nullptr);
    setText("start", "Anfahren");
    answerNext("keepMine"); // asked what is to become of the file
    (void)window->panelFiles().save("texts");
    EXPECT_FALSE(onDisk("hmi/texts.csv").isEmpty());
}

TEST_F(DiskChangeTest, AProjectThatIsRemovedWhileOpenStaysInTheWindowAndSaveAllWritesItAgain) {
    ASSERT_TRUE(QDir(folder.path()).removeRecursively());
    ASSERT_TRUE(waitFor([&] { return window->workspace().isModified("src/main.st"); }));
    ASSERT_TRUE(waitFor([&] { return window->statusBar()->currentMessage().contains("Save All"); }))
        << window->statusBar()->currentMessage().toStdString();
    EXPECT_EQ(window->workspace().text("src/main.st"), kMain);
    ASSERT_NE(window->tabs().currentEditor(), nullptr);
    EXPECT_EQ(editor().file(), "src/main.st");
    EXPECT_EQ(shownText(), "first");
    window->action("file.saveAll")->trigger();
    EXPECT_EQ(onDisk("src/main.st"), kMain);
    EXPECT_FALSE(window->workspace().isModified("src/main.st"));
    EXPECT_TRUE(onDisk("project.json").contains("\"Test\""));
    EXPECT_TRUE(onDisk("hmi/overview.panel.json").contains("first"));
    EXPECT_TRUE(onDisk("hmi/texts.csv").contains("Halt"));
    write("hmi/another.panel.json", panelWith("later")); // looked at again from now on
    EXPECT_TRUE(waitFor([&] { return window->live().panels().find("another") != nullptr; }));
    EXPECT_EQ(shownText(), "first");
}

TEST_F(DiskChangeTest, MergingTakesWhatIsWantedOfBoth) {
    const std::string here = "a\nb here\nc\nd\ne\nf here\ng\n", there = "a\nb there\nc\nd\nnew\ne\nf there\ng\n";
    MergeDialog merge("src/x.st", here, there, window.get());
    ASSERT_EQ(merge.hunks().size(), 3U);
    EXPECT_EQ(merge.currentHunk(), 0);
    merge.goToHunk(1);
    merge.takeOver();
    EXPECT_EQ(merge.merged(), "a\nb here\nc\nd\nnew\ne\nf here\ng\n");
    EXPECT_EQ(merge.hunks().size(), 2U);
    EXPECT_EQ(merge.currentHunk(), 1) << "the next one";
    merge.takeAll();
    EXPECT_EQ(merge.merged(), there);
    EXPECT_TRUE(merge.hunks().empty());
}

/// The ground of a line, right of its text.
QRgb groundOf(QsciScintilla& side, int line) {
    const int height = static_cast<int>(side.SendScintilla(QsciScintilla::SCI_TEXTHEIGHT, 0UL));
    const QImage picture = side.viewport()->grab().toImage();
    return picture.pixel(side.viewport()->width() * 3 / 4, line * height + height / 2);
}

TEST_F(DiskChangeTest, TheDifferencesOfBothSidesAreColoured) {
    const std::string here = "a\nb here\nc\nd\ne\nf here\ng\n", there = "a\nb there\nc\nd\nnew\ne\nf there\ng\n";
    for (const kit::ThemeChoice theme : {kit::ThemeChoice::Light, kit::ThemeChoice::Dark}) {
        window->changeTheme(theme);
        MergeDialog merge("src/x.st", here, there, window.get());
        merge.show();
        const QList<QsciScintilla*> sides = merge.findChildren<QsciScintilla*>();
        ASSERT_EQ(sides.size(), 2);
        for (QsciScintilla* side : sides) {
            const bool isHere = !side->isReadOnly();
            const QRgb plain = groundOf(*side, 2), current = groundOf(*side, 1),
                       other = groundOf(*side, isHere ? 5 : 6);
            EXPECT_NE(current, plain);
            EXPECT_NE(other, plain);
            EXPECT_NE(current, other) << "the one that Take Over takes";
            EXPECT_EQ(groundOf(*side, 4) == other, !isHere) << "a line that only the disk has";
        }
    }
    window->changeTheme(kit::ThemeChoice::Light);
}

TEST_F(DiskChangeTest, TheLineOfAFaultAndTheLineOfAnErrorAreColoured) {
    editor().setFaultLine(2);
    EXPECT_NE(groundOf(editor(), 1), groundOf(editor(), 2));
    write("hmi/texts.csv", "what is this\r\n");
    EXPECT_TRUE(waitFor([&] { return !problemPlaces().filter("hmi/texts.csv:1").isEmpty(); }));
    window->designs().openTexts();
    auto* page = qobject_cast<TextPage*>(window->tabs().currentWidget());
    ASSERT_NE(page, nullptr);
    page->showProblem("what is wrong with it", 1);
    auto* text = page->findChild<QsciScintilla*>();
    ASSERT_NE(text, nullptr);
    text->append("\r\nmore\r\n");
    EXPECT_NE(groundOf(*text, 0), groundOf(*text, 1));
    text->setModified(false);
}

TEST_F(DiskChangeTest, AComparisonIsOfferedAndItsTextGoesOn) {
    typeAtEnd("done := FALSE;");
    answerNext("compare");
    inNext<MergeDialog>(window.get(), [](MergeDialog& merge) {
        ASSERT_EQ(merge.hunks().size(), 2U);
        merge.goToHunk(0);
        merge.takeOver();
        merge.accept();
    });
    write("src/main.st", QByteArray(kMain).replace(":= 1000", ":= 500"));
    EXPECT_TRUE(waitFor([&] { return editor().utf8().find(":= 500") != std::string::npos; }));
    EXPECT_NE(editor().utf8().find("done := FALSE;"), std::string::npos) << "mine, in the same text";
    EXPECT_TRUE(window->workspace().isModified("src/main.st"));
    window->workspace().revert("src/main.st");
}

} // namespace
} // namespace plc::app
