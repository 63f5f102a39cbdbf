// The dialog of the project's themes: made, coloured, renamed, deleted, with undo, and on disk.
#include "design_studio.h"
#include "editor/kit/inputs/color_popup.h"
#include "hmi/designer/editors/theme_dialog.h"
#include "tests/support/answer.h"

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QPushButton>
#include <QTemporaryDir>

namespace plc::hmi {

namespace {

constexpr const char* kButton =
    R"({"id": "night", "kind": "button", "rect": [10, 10, 80, 40], "action": "theme", "theme": "night"})";

class ThemeDialogTest : public ::testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(folder.isValid());
        studio.project.folder = folder.path();
    }
    void write(const QString& name, const QByteArray& text) {
        QDir(folder.path()).mkpath("hmi/themes");
        QFile file(pathOf(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    QString pathOf(const QString& name) const { return folder.path() + "/hmi/themes/" + name + ".json"; }
    QByteArray read(const QString& name) const {
        QFile file(pathOf(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void haveNight() {
        write("night", R"({"base": "dark", "colors": {"background": "#102030"}})");
        studio.context->themesReplaced();
    }
    ThemeDialog& open(const QString& theme = {}) {
        dialog = std::make_unique<ThemeDialog>(*studio.context, "main", theme);
        dialog->show();
        return *dialog;
    }
    void commit(const QString& id, const QVariant& value) { emit dialog->grid().committed(id, value); }
    QColor shown(const char* role) const { return dialog->preview().scene().theme().color(role); }

    QTemporaryDir folder;
    Studio studio{kButton};
    std::unique_ptr<ThemeDialog> dialog;
};

} // namespace

TEST_F(ThemeDialogTest, ANewThemeBeginsWithThePanelsColoursAndIsWrittenAtTheEnd) {
    studio.designer->sheet().commit(QStringLiteral("theme"), QStringLiteral("dark"));
    open();
    EXPECT_FALSE(dialog->grid().isEnabled()) << "the project has none";
    EXPECT_NE(dialog->weaknesses(), QString()) << "and how to make one is said";
    EXPECT_EQ(dialog->add("fog"), QString());
    EXPECT_TRUE(dialog->grid().isEnabled());
    EXPECT_EQ(dialog->grid().value("base"), "dark");
    EXPECT_EQ(dialog->grid().value("text").value<QColor>(), PanelTheme::of(PanelThemeKind::Dark).color("text"));
    commit("background", QColor("#102030"));
    commit("accent", QColor("#40C0D0"));
    EXPECT_EQ(shown("background"), QColor("#102030"));
    EXPECT_FALSE(QFile::exists(pathOf("fog"))) << "not before OK";
    dialog->accept();
    EXPECT_FALSE(dialog->isVisible());
    EXPECT_EQ(read("fog"), "{\n  \"base\": \"dark\",\n  \"colors\": {\n    \"background\": \"#102030\",\n"
                           "    \"accent\": \"#40C0D0\"\n  }\n}\n");
    ASSERT_TRUE(studio.project.themes.has("fog"));
    studio.designer->sheet().commit(QStringLiteral("theme"), QStringLiteral("fog"));
    EXPECT_EQ(studio.designer->canvas().scene().theme().color("background"), QColor("#102030"));
}

TEST_F(ThemeDialogTest, AnotherBaseChangesWhatTheThemeLeavesToIt) {
    haveNight();
    open("night");
    EXPECT_EQ(dialog->choice().currentText(), "night");
    commit("base", "light");
    EXPECT_EQ(shown("background"), QColor("#102030"));
    EXPECT_EQ(shown("text"), PanelTheme::of(PanelThemeKind::Light).color("text"));
    emit dialog->grid().resetRequested("background");
    EXPECT_EQ(shown("background"), PanelTheme::of(PanelThemeKind::Light).color("background"));
    EXPECT_EQ(dialog->grid().value("background").value<QColor>(), shown("background"));
}

TEST_F(ThemeDialogTest, StepsAreTakenBackAndCancelWritesNothing) {
    haveNight();
    open();
    commit("text", QColor("#FFEEDD"));
    EXPECT_EQ(dialog->add("fog"), QString());
    EXPECT_EQ(dialog->names(), QStringList({"fog", "night"}));
    dialog->undoStack().undo();
    EXPECT_EQ(dialog->names(), QStringList("night"));
    EXPECT_EQ(shown("text"), QColor("#FFEEDD"));
    dialog->undoStack().undo();
    EXPECT_EQ(shown("text"), PanelTheme::of(PanelThemeKind::Dark).color("text"));
    dialog->undoStack().redo();
    const QByteArray before = read("night");
    bool wasAsked = false;
    inNext<QMessageBox>(dialog.get(), [&](QMessageBox& question) {
        wasAsked = true;
        question.button(QMessageBox::Discard)->click();
    });
    dialog->reject();
    EXPECT_TRUE(wasAsked) << "what was done is not thrown away in silence";
    EXPECT_FALSE(dialog->isVisible());
    EXPECT_EQ(read("night"), before);
}

TEST_F(ThemeDialogTest, AColourIsSeenBeforeItIsChosen) {
    haveNight();
    open();
    dialog->grid().editProperty("background");
    auto* colours = dialog->grid().findChild<kit::ColorPopup*>();
    ASSERT_NE(colours, nullptr);
    for (const QPushButton* button : colours->findChildren<QPushButton*>())
        EXPECT_FALSE(button->text().startsWith("No ")) << "a role has a colour";
    delete colours;
    emit dialog->grid().previewed("background", QColor("#405060"));
    EXPECT_EQ(shown("background"), QColor("#405060"));
    emit dialog->grid().previewWithdrawn("background");
    EXPECT_EQ(shown("background"), QColor("#102030"));
    EXPECT_EQ(dialog->undoStack().count(), 0);
}

TEST_F(ThemeDialogTest, PanelsAndButtonsFollowANewName) {
    haveNight();
    studio.designer->sheet().commit(QStringLiteral("theme"), QStringLiteral("night"));
    open();
    EXPECT_EQ(dialog->rename("late shift"), QString());
    EXPECT_EQ(studio.panel().text("theme"), "night") << "not before OK";
    dialog->accept();
    EXPECT_FALSE(QFile::exists(pathOf("night")));
    EXPECT_TRUE(QFile::exists(pathOf("late shift")));
    EXPECT_EQ(studio.panel().text("theme"), "late shift");
    EXPECT_EQ(studio.panel().find("night")->text("theme"), "late shift");
    EXPECT_EQ(studio.designer->canvas().scene().theme().color("background"), QColor("#102030"));
}

TEST_F(ThemeDialogTest, AThemeInUseIsNotDeleted) {
    haveNight();
    open();
    dialog->removeShown();
    EXPECT_EQ(dialog->names(), QStringList("night"));
    EXPECT_TRUE(dialog->complaint().contains("main")) << dialog->complaint().toStdString();
    studio.designer->document().perform("theme", setProperty(studio.panel(), "night", "theme", "dark"));
    dialog->removeShown();
    EXPECT_TRUE(dialog->names().isEmpty());
    EXPECT_EQ(dialog->complaint(), QString());
    dialog->accept();
    EXPECT_FALSE(QFile::exists(pathOf("night")));
    EXPECT_FALSE(studio.project.themes.has("night"));
}

TEST_F(ThemeDialogTest, NamesThatCannotBeAreRefusedWithTheReason) {
    haveNight();
    write("broken", "{");
    studio.context->themesReplaced();
    open();
    for (const char* name : {"", "a/b", "..", "dark", "Night", "NIGHT", "broken", "a:b"})
        EXPECT_NE(dialog->add(name), QString()) << name;
    EXPECT_EQ(dialog->names(), QStringList("night"));
    EXPECT_EQ(dialog->add("nuit d'été"), QString());
}

TEST_F(ThemeDialogTest, WhatCanHardlyBeReadIsSaid) {
    haveNight();
    open();
    EXPECT_EQ(dialog->weaknesses(), QString()) << dialog->weaknesses().toStdString();
    commit("text", QColor("#304050"));
    EXPECT_TRUE(dialog->weaknesses().contains("4.5")) << dialog->weaknesses().toStdString();
    EXPECT_LE(dialog->weaknesses().count('\n'), 3);
}

TEST_F(ThemeDialogTest, WhatIsWrittenElsewhereMeanwhileIsTakenOrSaid) {
    haveNight();
    write("fog", R"({"base": "light"})");
    studio.context->themesReplaced();
    open("night");
    commit("text", QColor("#FFEEDD"));
    write("fog", R"({"base": "contrast"})");
    studio.context->themesReplaced();
    EXPECT_EQ(dialog->complaint(), QString());
    EXPECT_EQ(dialog->choice().currentText(), "night");
    EXPECT_EQ(shown("text"), QColor("#FFEEDD")) << "and what is done here stays";
    write("night", R"({"base": "dark", "colors": {"background": "#203040"}})");
    studio.context->themesReplaced();
    EXPECT_TRUE(dialog->complaint().contains("night")) << dialog->complaint().toStdString();
    ASSERT_TRUE(QFile::remove(pathOf("fog")));
    studio.context->themesReplaced();
    EXPECT_EQ(dialog->names(), QStringList("night"));
    dialog->accept();
    EXPECT_TRUE(read("night").contains("#FFEEDD"));
    EXPECT_FALSE(QFile::exists(pathOf("fog")));
}

TEST_F(ThemeDialogTest, AFolderThatCannotBeWrittenIsSaidAndNothingIsLost) {
    QDir(folder.path()).mkpath("hmi");
    QFile inTheWay(folder.path() + "/hmi/themes"); // root may write everywhere
    ASSERT_TRUE(inTheWay.open(QIODevice::WriteOnly));
    inTheWay.close();
    open();
    EXPECT_EQ(dialog->add("fog"), QString());
    dialog->accept();
    EXPECT_TRUE(dialog->isVisible());
    EXPECT_NE(dialog->complaint(), QString());
    EXPECT_EQ(dialog->names(), QStringList("fog"));
    ASSERT_TRUE(inTheWay.remove());
    dialog->accept();
    EXPECT_FALSE(dialog->isVisible());
    EXPECT_TRUE(QFile::exists(pathOf("fog")));
}

} // namespace plc::hmi
