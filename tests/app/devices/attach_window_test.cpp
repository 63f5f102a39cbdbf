// The studio at a controller that another process serves: its values, writes, the time slider, the line that is cut.
#include "app/online/attach_dialog.h"
#include "app/online/attachment.h"
#include "app/window_commands.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/paths.h"
#include "tests/support/patience.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QStandardPaths>
#include <QToolButton>
#include <QUrl>

namespace plc::app {
namespace {

using controller::State;

class AttachedWindow : public StudioTest {
protected:
    void SetUp() override {
        QStandardPaths::setTestModeEnabled(true);
        StudioTest::SetUp();
        serve("0");
    }
    void TearDown() override {
        StudioTest::TearDown();
        service.kill();
        service.waitForFinished(kPatience);
    }
    void serve(const QString& port) {
        service.start(QString::fromStdString(binaryDir() + "/bin/stepwise"),
                      {"serve", folder.path(), "--port", port, "--state", folder.filePath("state")});
        ASSERT_TRUE(waitFor([&] { return service.canReadLine() || service.state() == QProcess::NotRunning; }));
        url = QString::fromUtf8(service.readLine()).section(u' ', -1).trimmed();
        ASSERT_TRUE(url.startsWith("http")) << service.readAllStandardError().toStdString();
    }
    QString code() {
        QFile file(folder.filePath("state/attach-code"));
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()).trimmed() : QString();
    }
    Attachment& attachment() { return attachmentOf(*window); }
    void attach() {
        ASSERT_TRUE(attachment().attach({QUrl(url), code(), {}, {}}));
        ASSERT_TRUE(waitFor([&] { return attachment().isAttached(); }));
    }
    QString value(const char* path) { return window->control().value(path).text; }
    QProcess service;
    QString url;
};

TEST_F(AttachedWindow, ShowsWritesForcesAndLooksBack) {
    attach();
    editor::RunControl& control = window->control();
    ASSERT_NE(control.session(), nullptr);
    EXPECT_TRUE(control.session()->isMirror());
    EXPECT_TRUE(control.isUpToDate()) << "the same text";
    ASSERT_TRUE(waitFor([&] { return control.status().state == State::Running && !value("Main.counter").isEmpty(); }));
    const QString before = value("Main.counter");
    EXPECT_TRUE(waitFor([&] { return value("Main.counter") != before; }));
    EXPECT_TRUE(attachment().button()->isVisible());
    EXPECT_TRUE(attachment().button()->text().contains("127.0.0.1")) << attachment().button()->text().toStdString();
    ASSERT_TRUE(control.write("Main.limit", "31000"));
    EXPECT_TRUE(waitFor([&] { return value("Main.limit") == "31000"; }));
    ASSERT_TRUE(control.force("Main.done", "TRUE"));
    EXPECT_TRUE(waitFor([&] { return control.value("Main.done").isForced; }));
    window->action("run.releaseAll")->trigger();
    EXPECT_TRUE(waitFor([&] { return !control.value("Main.done").isForced; }));
    // The past, scan by scan, while the controller goes on.
    ASSERT_TRUE(waitFor([&] { return control.shownHistory()->statistics().scans > 30; }));
    const auto end = control.shownHistory()->statistics().end;
    control.view(end - 10);
    const int then = value("Main.counter").toInt();
    control.view(end - 11);
    EXPECT_EQ(value("Main.counter").toInt(), then - 1);
    EXPECT_FALSE(control.resumeFromView()) << "a served controller is not put back";
    control.view(std::nullopt);
    window->action("run.stop")->trigger();
    EXPECT_TRUE(waitFor([&] { return control.status().state == State::Stopped; }));
    window->action("run.start")->trigger();
    EXPECT_TRUE(waitFor([&] { return control.status().state == State::Running; }));
    EXPECT_TRUE(control.session()->isMirror()) << "Run starts the one there";
    window->action("run.detach")->trigger();
    EXPECT_FALSE(control.isOnline());
    EXPECT_FALSE(attachment().button()->isVisible());
    EXPECT_EQ(service.state(), QProcess::Running) << "the controller goes on";
}

TEST_F(AttachedWindow, AnOnlineChangeGoesToTheControllerThere) {
    attach();
    ASSERT_TRUE(waitFor([&] { return window->action("run.change")->isEnabled(); })) << "the controller there runs";
    typeAtEnd("limit := 77;");
    analysed();
    EXPECT_TRUE(waitFor([&] { return !window->control().isUpToDate(); }));
    ASSERT_TRUE(window->action("run.change")->isEnabled());
    window->action("run.change")->trigger();
    EXPECT_TRUE(waitFor([&] { return value("Main.limit") == "77"; }));
    EXPECT_TRUE(waitFor([&] { return window->control().isUpToDate(); }));
}

TEST_F(AttachedWindow, SaysThatTheLineIsLostAndComesBack) {
    attach();
    const QString port = QString::number(QUrl(url).port());
    service.kill();
    ASSERT_TRUE(service.waitForFinished(kPatience));
    EXPECT_TRUE(waitFor([&] { return attachment().button()->text().contains("lost"); }));
    EXPECT_TRUE(window->control().session()->isMirror()) << "what came stays";
    serve(port);
    using Remote = editor::RemoteController::State;
    EXPECT_TRUE(waitFor([&] { return attachment().controller().state() == Remote::Attached; }));
    const auto recorded = window->control().shownHistory()->statistics().end;
    EXPECT_TRUE(waitFor([&] { return window->control().shownHistory()->statistics().end > recorded + 5; }));
}

TEST_F(AttachedWindow, TheDialogSaysWhatIsWrongAndClosesWhenItIsAttached) {
    AttachDialog dialog(attachment(), window.get());
    dialog.show();
    auto* problem = dialog.findChild<QLabel*>("problem");
    dialog.findChild<QComboBox*>("address")->setEditText("http://192.0.2.1/");
    dialog.accept();
    EXPECT_TRUE(problem->text().contains("https")) << problem->text().toStdString();
    dialog.findChild<QComboBox*>("address")->setEditText(url);
    dialog.findChild<QLineEdit*>("code")->setText("wrong code");
    dialog.accept();
    EXPECT_TRUE(waitFor([&] { return problem->text().contains("attach-code"); })) << problem->text().toStdString();
    EXPECT_TRUE(dialog.isVisible());
    dialog.findChild<QLineEdit*>("code")->setText(code());
    dialog.accept();
    EXPECT_TRUE(waitFor([&] { return !dialog.isVisible(); }));
    EXPECT_TRUE(attachment().isAttached());
    ASSERT_FALSE(Attachment::recent().isEmpty());
    EXPECT_EQ(Attachment::recent().front().first, url);
}

TEST_F(AttachedWindow, WithoutAProjectTheTextOfTheProgramThereIsFetched) {
    window->closeProject();
    ASSERT_FALSE(window->workspace().isOpen());
    attach();
    EXPECT_TRUE(window->workspace().isOpen());
    EXPECT_EQ(window->workspace().text("src/main.st"), kMain);
    EXPECT_TRUE(waitFor([&] { return window->control().isUpToDate(); }));
    EXPECT_TRUE(waitFor([&] { return !value("Main.counter").isEmpty(); }));
}

} // namespace
} // namespace plc::app
