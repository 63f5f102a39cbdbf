// File > Project Settings: the form writes what was changed and nothing else, and what another program writes into
// project.json while the project is open is taken over and never written over.
#include "app/panels/live_views.h"
#include "app/project/project_settings_dialog.h"
#include "editor/kit/message_text.h"
#include "editor/kit/mnemonics.h"
#include "hmi/player/panel_player.h"
#include "projects/storage/project_file.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/answer.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

namespace plc::app {
namespace {

using Json = nlohmann::ordered_json;

class ProjectSettingsTest : public StudioTest {
protected:
    void SetUp() override {
        for (const char* panel : {"first", "second"})
            write(QStringLiteral("hmi/%1.panel.json").arg(panel), "{\n  \"elements\": []\n}\n");
        StudioTest::SetUp();
    }
    /// Opens the form by its command, does something in it and presses the key.
    void inForm(const std::function<void(ProjectSettingsDialog&)>& work, Qt::Key key) {
        bool wasThere = false;
        inNext<ProjectSettingsDialog>(window.get(), [&](ProjectSettingsDialog& dialog) {
            wasThere = true;
            work(dialog);
            QTest::keyClick(&dialog, key);
            if (dialog.isVisible()) dialog.reject();
        });
        window->action("file.projectSettings")->trigger();
        EXPECT_TRUE(wasThere);
    }
    Json onDisk() {
        const auto json = projects::readProjectJson(folder.path().toStdString());
        return json ? *json : Json();
    }
    static void type(QWidget& edit, const QString& text) {
        QTest::keyClick(&edit, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(&edit, text);
    }
    /// The field behind a label of the form.
    template <class Field> static Field& field(ProjectSettingsDialog& dialog, const QString& title) {
        for (QLabel* label : dialog.findChildren<QLabel*>())
            if (kit::withoutMnemonic(label->text()) == title && qobject_cast<Field*>(label->buddy()))
                return *qobject_cast<Field*>(label->buddy());
        ADD_FAILURE() << title.toStdString();
        static Field none;
        return none;
    }
};

TEST_F(ProjectSettingsTest, WhatIsEnteredIsWrittenAndTheRestStays) {
    write("project.json",
          "{\n  \"name\": \"Test\",\n  \"ours\": [1, 2],\n  \"hmi\": {\"languages\": [\"en\"], \"font\": \"Noto "
          "Sans\"}\n}\n");
    ASSERT_TRUE(waitFor([&] { return window->workspace().project().json.contains("ours"); }));
    inForm(
        [&](ProjectSettingsDialog& dialog) {
            type(field<QLineEdit>(dialog, "Name"), "Line 4");
            QComboBox& addresses = field<QComboBox>(dialog, "Addressing");
            QTest::keyClick(&addresses, Qt::Key_Down);
            type(field<QLineEdit>(dialog, "Defined symbols"), "Simulation, Version=2");
            type(field<QSpinBox>(dialog, "Memory for __NEW"), "4096");
            QTest::keyClicks(&field<QComboBox>(dialog, "Start panel"), "second");
        },
        Qt::Key_Return);
    EXPECT_EQ(onDisk(), Json::parse(R"({"name": "Line 4", "ours": [1, 2],
        "hmi": {"languages": ["en"], "font": "Noto Sans", "startPanel": "second"},
        "addressing": "word", "defines": ["Simulation", "Version=2"], "memoryForNew": 4096})"));
    const projects::Project& project = window->workspace().project();
    EXPECT_EQ(project.name, "Line 4");
    EXPECT_EQ(project.addressing, image::Addressing::Words);
    EXPECT_EQ(window->live().panels().startPanel, "second");
    // back to what is so without a field: the field goes
    inForm([&](ProjectSettingsDialog& dialog) { type(field<QSpinBox>(dialog, "Memory for __NEW"), "0"); },
           Qt::Key_Return);
    EXPECT_FALSE(onDisk().contains("memoryForNew"));
}

TEST_F(ProjectSettingsTest, ConditionsAreReadAgainWithTheNewSymbols) {
    const std::string before = onDisk().dump();
    window->workspace().setText("src/main.st", std::string("{IF defined (Simulation)}\nnonsense\n{END_IF}\n") + kMain);
    analysed();
    EXPECT_FALSE(window->workspace().model()->checked().analysis->hasErrors);
    inForm([&](ProjectSettingsDialog& dialog) { type(field<QLineEdit>(dialog, "Defined symbols"), "Simulation"); },
           Qt::Key_Escape);
    EXPECT_EQ(onDisk().dump(), before) << "cancelled";
    inForm([&](ProjectSettingsDialog& dialog) { type(field<QLineEdit>(dialog, "Defined symbols"), "Simulation"); },
           Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return window->workspace().model()->checked().analysis->hasErrors; }));
}

TEST_F(ProjectSettingsTest, WhatCannotBeUsedIsNotTaken) {
    inForm(
        [&](ProjectSettingsDialog& dialog) {
            QPushButton* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
            QLabel* complaint = dialog.findChild<QLabel*>("complaint");
            EXPECT_TRUE(ok->isEnabled());
            type(field<QLineEdit>(dialog, "Date and time of the first scan"), "tomorrow");
            EXPECT_FALSE(ok->isEnabled());
            EXPECT_TRUE(complaint->text().contains("tomorrow")) << complaint->text().toStdString();
            type(field<QLineEdit>(dialog, "Date and time of the first scan"), "DT#2026-01-31-08:00:00");
            EXPECT_TRUE(ok->isEnabled());
            type(field<QLineEdit>(dialog, "Name"), " ");
            EXPECT_FALSE(ok->isEnabled());
        },
        Qt::Key_Escape);
}

TEST_F(ProjectSettingsTest, WhatAnotherProgramWritesIsTakenOverAndKept) {
    write("project.json", "{\n  \"name\": \"Test\",\n  \"libraries\": [\"analog\"],\n  \"theirs\": true\n}\n");
    ASSERT_TRUE(waitFor([&] { return window->workspace().project().libraries.size() == 1; }));
    // while the form is open, another program writes once more
    inForm(
        [&](ProjectSettingsDialog& dialog) {
            write("project.json", "{\n  \"name\": \"Test\",\n  \"libraries\": [\"analog\", \"toolbox\"]\n}\n");
            type(field<QLineEdit>(dialog, "Name"), "Ours");
        },
        Qt::Key_Return);
    EXPECT_EQ(onDisk(), Json::parse(R"({"name": "Ours", "libraries": ["analog", "toolbox"]})"));
    // half a file is nobody's settings, and it is not written over
    write("project.json", "{\n  \"name\": \"Te");
    inForm([&](ProjectSettingsDialog& dialog) { type(field<QLineEdit>(dialog, "Name"), "Lost"); }, Qt::Key_Return);
    QFile file(folder.path() + "/project.json");
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_EQ(file.readAll(), "{\n  \"name\": \"Te");
    EXPECT_EQ(window->workspace().project().name, "Ours");
}

TEST_F(ProjectSettingsTest, AFileThatIsGoneIsWrittenWhole) {
    ASSERT_TRUE(QFile::remove(folder.path() + "/project.json"));
    inForm([&](ProjectSettingsDialog& dialog) { type(field<QLineEdit>(dialog, "Name"), "Again"); }, Qt::Key_Return);
    EXPECT_EQ(onDisk(), Json::parse(R"({"name": "Again", "libraries": []})"));
}

TEST_F(ProjectSettingsTest, ASingleFileHasNone) {
    write("alone/one.st", kMain);
    ASSERT_TRUE(window->openProject(folder.path() + "/alone/one.st"));
    const auto saved = window->workspace().saveProjectFile(Json::parse(R"({"name": "x"})"));
    ASSERT_FALSE(saved);
    EXPECT_TRUE(kit::messageText(saved.error()).contains("project.json"));
}

} // namespace
} // namespace plc::app
