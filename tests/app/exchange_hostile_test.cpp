// File > Import by mouse and keys, with what a bad day brings: archives named .xml, entities, depth, other encodings,
// nothing at all, folders that are taken, a source that is gone, a cancelled reading or writing. The dialog says what
// is wrong, and nothing is written.
#include "app/exchange/exchange_dialogs.h"
#include "editor/kit/long_task.h"
#include "projects/storage/project_file.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/patience.h"
#include "tests/support/repeats.h"

#include <QLabel>
#include <QLineEdit>
#include <QProgressDialog>
#include <QPushButton>
#include <QTimer>
#include <QTreeWidget>

namespace plc::app {
namespace {

class HostileImport : public StudioTest {
protected:
    void SetUp() override {
        StudioTest::SetUp();
        dialog = std::make_unique<ImportDialog>(folder.path() + "/projects", window.get());
        dialog->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog.get(), kPatience));
    }
    void TearDown() override {
        kit::LongTask::setPatience(500);
        dialog.reset();
        StudioTest::TearDown();
    }
    QString shown(const QString& name, const QByteArray& bytes) {
        write(name, bytes);
        dialog->preview(folder.path() + "/" + name);
        return complaint();
    }
    [[nodiscard]] QString complaint() const { return dialog->findChild<QLabel*>("complaint")->text(); }
    [[nodiscard]] QPushButton& import() const { return *dialog->findChild<QPushButton*>("import"); }
    [[nodiscard]] QTreeWidget& files() const { return *dialog->findChild<QTreeWidget*>("files"); }
    [[nodiscard]] QTreeWidget& notes() const { return *dialog->findChild<QTreeWidget*>("notes"); }
    void type(const QString& target) {
        auto* edit = dialog->findChild<QLineEdit*>("target");
        edit->setFocus();
        QTest::keyClick(edit, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(edit, target);
    }
    void press() { QTest::mouseClick(&import(), Qt::LeftButton); }
    /// Nothing was written, and the button does nothing.
    void expectNothing(const char* kind) {
        EXPECT_FALSE(import().isEnabled()) << kind;
        press();
        EXPECT_TRUE(dialog->isVisible()) << kind;
        EXPECT_FALSE(QFile::exists(folder.path() + "/projects")) << kind;
        EXPECT_EQ(files().topLevelItemCount(), 0) << kind;
    }
    static QByteArray unit(const QByteArray& name, const QByteArray& body) {
        return "<?xml version=\"1.0\"?><TcPlcObject><POU Name=\"" + name + "\"><Declaration><![CDATA[PROGRAM " + name +
               "\nVAR\n n : INT;\nEND_VAR\n]]></Declaration><Implementation><ST><![CDATA[" + body +
               "]]></ST></Implementation></POU></TcPlcObject>";
    }
    static QByteArray inUtf16(const QString& text) {
        const std::u16string units = text.toStdU16String();
        return QByteArray("\xFF\xFE", 2) +
               QByteArray(reinterpret_cast<const char*>(units.data()), static_cast<int>(units.size() * 2));
    }
    std::unique_ptr<ImportDialog> dialog;
};

TEST_F(HostileImport, FilesThatAreNotWhatTheySayAreComplaints) {
    QByteArray deep = "<TcPlcObject>";
    for (int i = 0; i < 5000; ++i) deep += "<a>";
    const std::tuple<const char*, QByteArray, const char*> rows[] = {
        {"zip.xml", QByteArray("PK\x03\x04\x14\x00\x00\x00", 8), "ZIP archive"},
        {"bomb.xml", "<!DOCTYPE p [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;\">]><project>&b;</project>", "document type"},
        {"deep.xml", deep, "nested too deeply"},
        {"empty.xml", "", "empty"},
        {"half.xml", "<?xml version=\"1.0\"?><project><types>", "half.xml"},
        {"page.xml", "<html><body/></html>", "neither PLCopen XML"},
        {"photo.TcPOU", QByteArray("\x89PNG\r\n\x1a\n\0\0", 10), "cannot be imported"},
        {"notes.doc", "some words", "cannot be imported"},
    };
    for (const auto& [name, bytes, text] : rows) {
        const QString said = shown(name, bytes);
        EXPECT_TRUE(said.contains(text)) << name << ": " << said.toStdString();
        expectNothing(name);
    }
    dialog->preview(folder.path() + "/gone.xml");
    EXPECT_FALSE(complaint().isEmpty());
    expectNothing("a file that is not there");
    QDir().mkpath(folder.path() + "/nothing/in/it");
    dialog->preview(folder.path() + "/nothing");
    EXPECT_TRUE(complaint().contains("nothing that can be imported")) << complaint().toStdString();
    expectNothing("an empty folder");
}

TEST_F(HostileImport, AFileWithoutReadingRightsIsAComplaintAndALineOfAFolder) {
    write("tree/A.TcPOU", unit("A", "n := 1;"));
    QDir().mkpath(folder.path() + "/tree/B.TcPOU"); // a folder by the name of a file
    QFile::link(folder.path() + "/tree/nowhere", folder.path() + "/tree/C.TcPOU");
    QFile::link(folder.path() + "/tree", folder.path() + "/tree/again"); // round in circles
    write("tree/D.TcPOU", "PK\x03\x04");
    dialog->preview(folder.path() + "/tree");
    EXPECT_EQ(files().topLevelItemCount(), 1);
    ASSERT_EQ(notes().topLevelItemCount(), 1);
    EXPECT_TRUE(notes().topLevelItem(0)->text(1).contains("ZIP")) << notes().topLevelItem(0)->text(1).toStdString();
    EXPECT_TRUE(import().isEnabled());
}

TEST_F(HostileImport, Utf16IsReadWithItsLine) {
    EXPECT_EQ(shown("u.TcPOU", inUtf16(QString::fromUtf8(unit("A", "n := 1; // \xC3\xA9"))
                                           .replace("version=\"1.0\"", "version=\"1.0\" encoding=\"utf-16\""))),
              QString());
    EXPECT_EQ(files().topLevelItemCount(), 1);
    ASSERT_EQ(notes().topLevelItemCount(), 1);
    EXPECT_TRUE(notes().topLevelItem(0)->text(1).contains("UTF-16"));
    press();
    EXPECT_FALSE(dialog->isVisible());
    EXPECT_TRUE(window->openProject(dialog->folder()));
}

TEST_F(HostileImport, AWrongFileAfterAGoodOneLeavesNothingToImport) {
    shown("A.TcPOU", unit("A", "n := 1;"));
    EXPECT_TRUE(import().isEnabled());
    shown("zip.xml", "PK\x03\x04");
    expectNothing("after a good file");
}

TEST_F(HostileImport, TargetsThatAreTakenOrCannotBeAreRefusedAndStayAsTheyAre) {
    shown("A.TcPOU", unit("A", "n := 1;"));
    write("taken/mine.txt", "mine");
    type(folder.path() + "/taken");
    EXPECT_FALSE(import().isEnabled());
    EXPECT_TRUE(complaint().contains("not empty")) << complaint().toStdString();
    type(folder.path() + "/taken/mine.txt/project"); // below a file
    EXPECT_TRUE(import().isEnabled());
    press();
    EXPECT_TRUE(dialog->isVisible());
    EXPECT_FALSE(complaint().isEmpty());
    type(folder.path() + "/late");
    write("late/mine.txt", "mine"); // while the dialog is open
    press();
    EXPECT_TRUE(dialog->isVisible());
    EXPECT_TRUE(complaint().contains("not empty")) << complaint().toStdString();
    EXPECT_EQ(QDir(folder.path() + "/late").entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
              QStringList("mine.txt"));
    type(folder.path() + "/good");
    QFile::remove(folder.path() + "/A.TcPOU"); // what was read stays
    press();
    EXPECT_FALSE(dialog->isVisible());
    EXPECT_TRUE(QFile::exists(folder.path() + "/good/src/A.st"));
}

TEST_F(HostileImport, CancelledHalfWayNothingIsReadAndNothingWritten) {
    for (int i = 0; i < 400; ++i)
        write(QString("tree/F%1.TcPOU").arg(i),
              unit("F" + QByteArray::number(i),
                   QByteArray("n := n + 1;\n").repeated(repeats(1000)))); // longer than until the button is there
    kit::LongTask::setPatience(0);
    int clicks = 0;
    QTimer clicker;
    QObject::connect(&clicker, &QTimer::timeout, [&] {
        for (QWidget* each : QApplication::topLevelWidgets())
            if (auto* progress = qobject_cast<QProgressDialog*>(each); progress && progress->isVisible())
                if (auto* button = progress->findChild<QPushButton*>())
                    QTest::mouseClick(button, Qt::LeftButton), ++clicks;
    });
    clicker.start(0);
    dialog->preview(folder.path() + "/tree");
    EXPECT_EQ(clicks, 1);
    EXPECT_EQ(complaint(), "cancelled");
    expectNothing("cancelled reading");
    clicker.stop();
    dialog->preview(folder.path() + "/tree");
    EXPECT_EQ(files().topLevelItemCount(), 400);
    EXPECT_TRUE(import().isEnabled());
}

TEST_F(HostileImport, ProjectsThatShareNamesAreChosenInThePreview) {
    const auto plcproj = [](const QByteArray& name) {
        return "<?xml version=\"1.0\"?><Project xmlns=\"http://schemas.microsoft.com/developer/msbuild/2003\">"
               "<PropertyGroup><Name>" +
               name + "</Name></PropertyGroup><ItemGroup><Compile Include=\"MAIN.TcPOU\"/></ItemGroup></Project>";
    };
    for (const char* name : {"Mill", "Oven", "Press"}) {
        write(QString("line/%1/%1.plcproj").arg(name), plcproj(name));
        write(QString("line/%1/MAIN.TcPOU").arg(name), unit("MAIN", "n := 1;"));
    }
    dialog->preview(folder.path() + "/line");
    ASSERT_EQ(files().topLevelItemCount(), 3);
    EXPECT_EQ(notes().topLevelItemCount(), 1);
    const auto untick = [&](int row) {
        files().setFocus();
        files().setCurrentItem(files().topLevelItem(row));
        QTest::keyClick(&files(), Qt::Key_Space);
    };
    for (int row : {0, 1, 2}) untick(row);
    EXPECT_FALSE(import().isEnabled());
    untick(1);
    untick(2);
    EXPECT_TRUE(import().isEnabled());
    press();
    EXPECT_FALSE(dialog->isVisible());
    EXPECT_EQ(QDir(folder.path() + "/projects/line").entryList(QDir::Dirs | QDir::NoDotAndDotDot),
              QStringList({"Oven", "Press"}));
    EXPECT_TRUE(dialog->folder().endsWith("/line/Oven"));
    EXPECT_TRUE(window->openProject(dialog->folder()));
}

} // namespace
} // namespace plc::app
