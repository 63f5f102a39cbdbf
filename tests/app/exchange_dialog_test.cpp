// File > Import and File > Export: the preview shows files and report before anything is written, refusals stay in the
// dialog, and what was imported opens.
#include "app/exchange/exchange_dialogs.h"
#include "projects/storage/project_file.h"
#include "tests/app/studio_fixture.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>

namespace plc::app {
namespace {

class ExchangeDialogs : public StudioTest {
protected:
    QString unit() {
        write("foreign/MAIN.TcPOU",
              "<?xml version=\"1.0\"?><TcPlcObject><POU Name=\"MAIN\"><Declaration><![CDATA[PROGRAM MAIN\nVAR\n n : "
              "INT;\nEND_VAR\n]]></Declaration><Implementation><ST><![CDATA[n := n + 1;]]></ST></Implementation></POU>"
              "<POU Name=\"Drawn\"><Declaration><![CDATA[PROGRAM Drawn\nVAR\nEND_VAR\n]]></Declaration><Implementation>"
              "<NWL/></Implementation></POU></TcPlcObject>");
        return folder.path() + "/foreign/MAIN.TcPOU";
    }
};

TEST_F(ExchangeDialogs, ImportShowsFilesAndReportAndWritesAProject) {
    ImportDialog dialog(folder.path() + "/projects", window.get());
    auto* import = dialog.findChild<QPushButton*>("import");
    ASSERT_TRUE(import);
    EXPECT_FALSE(import->isEnabled());
    dialog.preview(unit());
    EXPECT_EQ(dialog.findChild<QTreeWidget*>("files")->topLevelItemCount(), 2);
    EXPECT_EQ(dialog.findChild<QTreeWidget*>("notes")->topLevelItemCount(), 1);
    EXPECT_TRUE(import->isEnabled());
    EXPECT_FALSE(QFile::exists(dialog.folder()));
    ASSERT_TRUE(dialog.write());
    EXPECT_TRUE(window->openProject(dialog.folder()));
    // the folder is taken now
    dialog.findChild<QLineEdit*>("target")->setText(folder.path());
    EXPECT_FALSE(import->isEnabled());
    EXPECT_FALSE(dialog.findChild<QLabel*>("complaint")->text().isEmpty());
}

TEST_F(ExchangeDialogs, WhatCannotBeReadStaysAComplaint) {
    write("foreign/bad.xml", "<html/>");
    ImportDialog dialog(folder.path(), window.get());
    dialog.preview(folder.path() + "/foreign/bad.xml");
    EXPECT_FALSE(dialog.findChild<QPushButton*>("import")->isEnabled());
    EXPECT_FALSE(dialog.findChild<QLabel*>("complaint")->text().isEmpty());
    EXPECT_FALSE(dialog.write());
    dialog.show();
    dialog.accept(); // nothing is chosen
    EXPECT_TRUE(dialog.isVisible());
}

TEST_F(ExchangeDialogs, ExportShowsItsReportInBothVersionsAndWrites) {
    write("src/m.st", "FUNCTION_BLOCK F\nMETHOD M : INT\nM := 1;\nEND_METHOD\nEND_FUNCTION_BLOCK\n");
    const auto project = projects::openProject({folder.path().toStdString()});
    ASSERT_TRUE(project);
    ExportDialog dialog(*project, window.get());
    auto* notes = dialog.findChild<QTreeWidget*>("notes");
    const int before = notes->topLevelItemCount();
    dialog.findChild<QComboBox*>("version")->setCurrentIndex(1);
    EXPECT_GT(notes->topLevelItemCount(), before); // the method
    dialog.setTarget(folder.path() + "/out.xml");
    ASSERT_TRUE(dialog.write());
    QFile file(folder.path() + "/out.xml");
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().contains("tc6_0201"));
}

} // namespace
} // namespace plc::app
