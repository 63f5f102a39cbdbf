// File > Import and File > Export from the menu, by mouse and keys, in the branches in which nothing is to happen:
// cancelled, nothing chosen, a wrong encoding, a file that is there already or cannot be written.
#include "app/exchange/exchange_dialogs.h"
#include "projects/storage/project_file.h"
#include "tests/app/studio_fixture.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTimer>
#include <QTreeWidget>

namespace plc::app {
namespace {

class ExchangeWindow : public StudioTest {
protected:
    /// Opens a dialog and hands it to `use` as soon as it is in front; whoever uses it closes it.
    template <class Dialog> int opened(const std::function<void()>& open, const std::function<void(Dialog&)>& use) {
        int count = 0;
        QTimer timer;
        QObject::connect(&timer, &QTimer::timeout, [&] {
            auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
            if (!dialog || !dialog->isVisible()) return;
            timer.stop();
            ++count;
            use(*dialog);
            if (dialog->isVisible()) dialog->reject();
        });
        timer.start(5);
        open();
        return count;
    }
    static QPushButton& buttonNamed(QWidget& dialog, const QString& text) {
        for (QPushButton* each : dialog.findChildren<QPushButton*>())
            if (each->text().remove('&') == text) return *each;
        ADD_FAILURE() << "no button " << text.toStdString();
        static QPushButton none;
        return none;
    }
    static QPushButton& cancelOf(QWidget& dialog) {
        return *dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel);
    }
    static QString complaintOf(QWidget& dialog) { return dialog.findChild<QLabel*>("complaint")->text(); }
};

TEST_F(ExchangeWindow, ACancelledImportLeavesTheProjectThatIsOpen) {
    const QString before = window->workspace().folder();
    const int count = opened<ImportDialog>([&] { window->action("file.import")->trigger(); },
                                           [&](ImportDialog& dialog) {
                                               QTest::mouseClick(&cancelOf(dialog), Qt::LeftButton);
                                               EXPECT_FALSE(dialog.isVisible());
                                           });
    EXPECT_EQ(count, 1);
    EXPECT_EQ(window->workspace().folder(), before);
    EXPECT_EQ(opened<ImportDialog>([&] { window->action("file.import")->trigger(); },
                                   [&](ImportDialog& dialog) {
                                       QTest::keyClick(&dialog, Qt::Key_Escape);
                                       EXPECT_FALSE(dialog.isVisible());
                                   }),
              1);
    EXPECT_EQ(window->workspace().folder(), before);
}

TEST_F(ExchangeWindow, WithoutAChoiceTheImportShowsWhatItShowedBefore) {
    write("foreign/a.st", "PROGRAM A\nEND_PROGRAM\n");
    ImportDialog dialog(folder.path() + "/projects", window.get());
    dialog.show();
    const auto chooseNothing = [&] {
        for (const char* button : {"File…", "Folder…"})
            EXPECT_EQ(opened<QFileDialog>(
                          [&] { QTest::mouseClick(&buttonNamed(dialog, QString::fromUtf8(button)), Qt::LeftButton); },
                          [](QFileDialog& files) { QTest::keyClick(&files, Qt::Key_Escape); }),
                      1)
                << button;
    };
    chooseNothing();
    EXPECT_FALSE(dialog.findChild<QPushButton*>("import")->isEnabled());
    dialog.preview(folder.path() + "/foreign/a.st");
    ASSERT_EQ(dialog.findChild<QTreeWidget*>("files")->topLevelItemCount(), 1);
    chooseNothing();
    EXPECT_EQ(dialog.findChild<QTreeWidget*>("files")->topLevelItemCount(), 1);
    EXPECT_TRUE(dialog.findChild<QPushButton*>("import")->isEnabled());
}

TEST_F(ExchangeWindow, AnotherEncodingIsChosenByKeysAndTheTargetStays) {
    const QString polish = QString::fromUtf8("zażółć");
    const auto bytes = projects::encodeText("PROGRAM A\n// " + polish.toStdString() + "\nEND_PROGRAM\n",
                                            projects::Encoding::Windows1250);
    ASSERT_TRUE(bytes);
    write("foreign/a.st", QByteArray::fromStdString(*bytes));
    ImportDialog dialog(folder.path() + "/projects", window.get());
    dialog.show();
    dialog.preview(folder.path() + "/foreign/a.st");
    const auto* text = dialog.findChild<QPlainTextEdit*>();
    EXPECT_FALSE(text->toPlainText().contains(polish));
    ASSERT_EQ(dialog.findChild<QTreeWidget*>("notes")->topLevelItemCount(), 1);
    auto* target = dialog.findChild<QLineEdit*>("target");
    target->setFocus();
    QTest::keyClick(target, Qt::Key_A, Qt::ControlModifier);
    const QString chosen = folder.path() + "/projects/mine";
    QTest::keyClicks(target, chosen);
    auto* encoding = dialog.findChild<QComboBox*>("encoding");
    encoding->setFocus();
    while (encoding->currentText() != "Windows-1250" && encoding->currentIndex() + 1 < encoding->count())
        QTest::keyClick(encoding, Qt::Key_Down);
    ASSERT_EQ(encoding->currentText(), "Windows-1250");
    EXPECT_TRUE(waitFor([&] { return text->toPlainText().contains(polish); }));
    EXPECT_EQ(target->text(), chosen);
    QTest::mouseClick(dialog.findChild<QPushButton*>("import"), Qt::LeftButton);
    EXPECT_FALSE(dialog.isVisible());
    QFile written(chosen + "/src/a.st");
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    EXPECT_TRUE(QString::fromUtf8(written.readAll()).contains(polish));
}

TEST_F(ExchangeWindow, EveryCodePageIsShownAndImported) {
    std::string bytes = "PROGRAM A // ";
    for (int byte = 0xA1; byte <= 0xFF; ++byte) bytes += static_cast<char>(byte);
    bytes += "\nEND_PROGRAM\n";
    write("foreign/a.st", QByteArray::fromStdString(bytes));
    for (const std::string& page : projects::codePageNames()) {
        const std::string text = projects::decodeText(bytes, projects::encodingNamed(page)).text;
        ImportDialog dialog(folder.path() + "/projects", window.get());
        dialog.show();
        dialog.preview(folder.path() + "/foreign/a.st");
        auto* encoding = dialog.findChild<QComboBox*>("encoding");
        encoding->setFocus();
        QTest::keyClick(encoding, Qt::Key_Home);
        while (encoding->currentText() != QString::fromStdString(page) &&
               encoding->currentIndex() + 1 < encoding->count())
            QTest::keyClick(encoding, Qt::Key_Down);
        ASSERT_EQ(encoding->currentText().toStdString(), page);
        const QString letters = QString::fromStdString(text).section('\n', 0, 0);
        const auto* preview = dialog.findChild<QPlainTextEdit*>();
        EXPECT_TRUE(waitFor([&] { return preview->toPlainText().startsWith(letters.left(20)); })) << page;
        auto* target = dialog.findChild<QLineEdit*>("target");
        target->setText(folder.path() + "/projects/" + QString::fromStdString(page));
        QTest::mouseClick(dialog.findChild<QPushButton*>("import"), Qt::LeftButton);
        QFile written(folder.path() + "/projects/" + QString::fromStdString(page) + "/src/a.st");
        ASSERT_TRUE(written.open(QIODevice::ReadOnly)) << page;
        EXPECT_EQ(written.readAll().toStdString(), text) << page;
    }
}

TEST_F(ExchangeWindow, ACancelledExportWritesNothing) {
    const QString target = folder.path() + "/out.xml";
    EXPECT_EQ(opened<ExportDialog>([&] { window->action("file.export")->trigger(); },
                                   [&](ExportDialog& dialog) {
                                       dialog.setTarget(target);
                                       QTest::mouseClick(&cancelOf(dialog), Qt::LeftButton);
                                   }),
              1);
    EXPECT_FALSE(QFile::exists(target));
}

TEST_F(ExchangeWindow, AnExportSaysThatItReplacesAFileAndStaysWhereItCannotWrite) {
    write("out.xml", "old");
    const QString target = folder.path() + "/out.xml";
    EXPECT_EQ(opened<ExportDialog>([&] { window->action("file.export")->trigger(); },
                                   [&](ExportDialog& dialog) {
                                       QPushButton& button = buttonNamed(dialog, "Export");
                                       dialog.setTarget(folder.path() + "/no/such/folder/out.xml");
                                       QTest::mouseClick(&button, Qt::LeftButton);
                                       EXPECT_TRUE(dialog.isVisible());
                                       EXPECT_FALSE(complaintOf(dialog).isEmpty());
                                       dialog.setTarget(folder.path()); // a folder
                                       EXPECT_FALSE(button.isEnabled());
                                       dialog.setTarget("");
                                       EXPECT_FALSE(button.isEnabled());
                                       dialog.setTarget(target);
                                       EXPECT_TRUE(complaintOf(dialog).contains("will be replaced"));
                                       QTest::mouseClick(&button, Qt::LeftButton);
                                       EXPECT_FALSE(dialog.isVisible());
                                   }),
              1);
    QFile file(target);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    EXPECT_TRUE(file.readAll().contains("tc6_0200"));
}

TEST_F(ExchangeWindow, AProgramWithErrorsOfSyntaxIsNotExported) {
    write("src/main.st", "PROGRAM Main\nIF THEN\nEND_PROGRAM\n");
    const auto project = projects::openProject({folder.path().toStdString()});
    ASSERT_TRUE(project);
    ExportDialog dialog(*project, window.get());
    dialog.show();
    EXPECT_FALSE(buttonNamed(dialog, "Export").isEnabled());
    EXPECT_FALSE(complaintOf(dialog).isEmpty());
    QTest::mouseClick(&buttonNamed(dialog, "Export"), Qt::LeftButton);
    EXPECT_TRUE(dialog.isVisible());
}

} // namespace
} // namespace plc::app
