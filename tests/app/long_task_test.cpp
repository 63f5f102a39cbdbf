// What takes long shows how far it got and can be cancelled: search and replace in all files, export of samples, both
// builds, recordings, the tests.
#include "app/panels/live_views.h"
#include "app/project/search_view.h"
#include "editor/kit/long_task.h"
#include "editor/plot/plot_export.h"
#include "tests/app/studio_fixture.h"

#include <QLabel>
#include <QLineEdit>
#include <QProgressDialog>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>

namespace plc::app {
namespace {

class LongTaskTest : public StudioTest {
protected:
    void SetUp() override {
        for (int i = 0; i < 20; ++i) {
            QByteArray text = "FUNCTION F" + QByteArray::number(i) + " : INT\nVAR\n    needle : INT;\nEND_VAR\n";
            for (int line = 0; line < 50; ++line) text += "needle := needle + 1;\n";
            write(QString("src/f%1.st").arg(i, 2, 10, QChar('0')), text + "END_FUNCTION\n");
        }
        StudioTest::SetUp();
        kit::LongTask::setPatience(0);
        clicker.setInterval(0);
        QObject::connect(&clicker, &QTimer::timeout, [this] {
            for (QWidget* each : QApplication::topLevelWidgets())
                if (auto* dialog = qobject_cast<QProgressDialog*>(each);
                    dialog && dialog->isVisible() && dialog->value() >= cancelAt)
                    if (auto* button = dialog->findChild<QPushButton*>())
                        QTest::mouseClick(button, Qt::LeftButton), ++clicks;
        });
    }
    void TearDown() override {
        clicker.stop();
        kit::LongTask::setPatience(500);
        StudioTest::TearDown();
    }
    QTimer clicker;
    int cancelAt = 300, clicks = 0; // of 1000
};

constexpr int kAll = 20 * 101;

TEST_F(LongTaskTest, ASearchIsCancelledAndKeepsWhatItFound) {
    window->search().openSearch("needle");
    window->search().search();
    EXPECT_EQ(window->search().results().topLevelItemCount(), kAll) << "nobody cancelled";
    clicker.start();
    window->search().search();
    EXPECT_EQ(clicks, 1);
    EXPECT_GT(window->search().results().topLevelItemCount(), 0);
    EXPECT_LT(window->search().results().topLevelItemCount(), kAll);
    bool said = false;
    for (QLabel* label : window->search().findChildren<QLabel*>()) said |= label->text().startsWith("Cancelled");
    EXPECT_TRUE(said);
}

TEST_F(LongTaskTest, ACancelledReplaceChangesNothing) {
    window->search().openSearch("needle");
    window->search().findChildren<QLineEdit*>()[1]->setText("thread");
    clicker.start();
    EXPECT_EQ(window->search().replaceAll(), 0);
    clicker.stop();
    EXPECT_EQ(clicks, 1);
    for (const QString& file : window->workspace().files())
        EXPECT_EQ(window->workspace().text(file).find("thread"), std::string::npos) << file.toStdString();
    EXPECT_EQ(window->search().replaceAll(), kAll);
    EXPECT_NE(window->workspace().text("src/f19.st").find("thread := thread + 1"), std::string::npos);
}

TEST_F(LongTaskTest, ACancelledExportLeavesTheFileAsItWas) {
    plot::PlotModel model;
    auto samples = std::make_shared<plot::SampleList>();
    for (int i = 0; i < 100'000; ++i) samples->append(i * 1'000'000LL, i);
    plot::PlotCurve curve;
    curve.name = "a";
    curve.source = samples;
    model.curves = {curve};
    write("out.csv", "before");
    const QString path = folder.path() + "/out.csv";
    const auto size = [&] { return QFileInfo(path).size(); };
    const auto save = [&] {
        kit::LongTask task("Saving", window.get());
        return plot::exportCsv(model, 0, 100'000'000'000LL, path, [&](double share) { return task.reached(share); })
            .
            operator bool();
    };
    clicker.start();
    EXPECT_TRUE(save());
    clicker.stop();
    EXPECT_EQ(clicks, 1);
    EXPECT_EQ(size(), 6);
    EXPECT_TRUE(save());
    EXPECT_GT(size(), 700'000);
}

// ------------------------------------------------------------------ the builds

class LongBuildTest : public LongTaskTest {
protected:
    /// Enough functions that optimising them takes its time.
    void SetUp() override {
        QByteArray text;
        for (int i = 0; i < 250; ++i) {
            const QByteArray n = QByteArray::number(i);
            text += "FUNCTION_BLOCK Block" + n + "\nVAR\n    a : ARRAY[0..20] OF DINT;\n    i, s : DINT;\nEND_VAR\n";
            for (int line = 0; line < 12; ++line)
                text += "FOR i := 0 TO 20 DO\n    a[i] := a[i] * 3 + s;\n    s := s + a[20 - i] MOD 7;\nEND_FOR\n";
            text += "END_FUNCTION_BLOCK\n";
        }
        text += "PROGRAM Plant\nVAR\n    scans : DINT;\n";
        for (int i = 0; i < 250; ++i)
            text += "    b" + QByteArray::number(i) + " : Block" + QByteArray::number(i) + ";\n";
        text += "END_VAR\nscans := scans + 1;\nIF scans < 0 THEN\n";
        for (int i = 0; i < 250; ++i) text += "    b" + QByteArray::number(i) + "();\n";
        text += "END_IF\nEND_PROGRAM\nCONFIGURATION Cell\nRESOURCE Cpu ON PLC\n"
                "    TASK T (INTERVAL := T#10ms, PRIORITY := 1);\n    PROGRAM Main WITH T : Main;\n"
                "    PROGRAM Plant WITH T : Plant;\nEND_RESOURCE\nEND_CONFIGURATION\n";
        write("src/plant.st", text);
        LongTaskTest::SetUp();
    }
    QToolButton* cancel() { return window->findChild<QToolButton*>("cancelWork"); }
    bool clickCancelOf(const QString& work) {
        return waitFor([&] { return cancel()->isVisible() && cancel()->accessibleName().contains(work); }) &&
               (QTest::mouseClick(cancel(), Qt::LeftButton), true);
    }
    bool runs() {
        return waitFor([&] { return window->control().value("Plant.scans").text.toInt() > 5; });
    }
};

TEST_F(LongBuildTest, ACancelledBuildMakesNoController) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(clickCancelOf("Building"));
    ASSERT_TRUE(waitFor([&] { return !window->control().isBuilding(); }));
    EXPECT_FALSE(window->control().isOnline());
    EXPECT_FALSE(cancel()->isVisible());
    window->action("run.start")->trigger();
    EXPECT_TRUE(runs()) << "the next build is not cancelled";
}

TEST_F(LongBuildTest, ACancelledOnlineChangeLeavesTheRunningProgram) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(runs());
    const auto program = window->control().session()->program();
    window->workspace().setText("src/main.st", std::string(kMain) + "\n");
    window->action("run.change")->trigger();
    ASSERT_TRUE(clickCancelOf("Building"));
    ASSERT_TRUE(waitFor([&] { return !window->control().isBuilding(); }));
    const auto scans = window->control().status().scans;
    EXPECT_TRUE(waitFor([&] { return window->control().status().scans > scans + 5; }));
    EXPECT_EQ(window->control().session()->program(), program);
    EXPECT_EQ(window->control().status().state, controller::State::Running);
}

TEST_F(LongBuildTest, CancelledOptimisingLeavesTheQuickCode) {
    window->action("run.start")->trigger();
    ASSERT_TRUE(runs());
    ASSERT_TRUE(clickCancelOf("Optimising")) << "too fast to be seen";
    ASSERT_TRUE(waitFor([&] { return window->control().session()->optimising() == nullptr; }));
    EXPECT_EQ(window->control().session()->program()->optimised.load(), nullptr);
    const auto scans = window->control().status().scans;
    EXPECT_TRUE(waitFor([&] { return window->control().status().scans > scans + 5; }));
    EXPECT_TRUE(waitFor([&] { return !cancel()->isVisible(); }));
}

// ------------------------------------------------------------------ recordings, tests

TEST_F(LongTaskTest, ACancelledRecordingLeavesNoHalfFile) {
    window->control().setMode({session::Pace::Fastest, 1.0});
    window->action("run.start")->trigger();
    const auto recorded = [&] {
        const session::Session* session = window->control().session();
        return session ? session->history().statistics().bytes : 0;
    };
    // Enough that saving it can be cancelled; however slow the machine, it only has to grow.
    for (size_t before = 0; recorded() <= 60'000'000; before = recorded())
        ASSERT_TRUE(waitFor([&] { return recorded() > before; })) << recorded() << " bytes";
    window->action("run.pause")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Paused; }));
    write("run.rec", "before");
    const QString path = folder.path() + "/run.rec";
    cancelAt = 0;
    clicker.start();
    const auto cancelled = window->live().saveRecording(path);
    clicker.stop();
    ASSERT_TRUE(cancelled);
    EXPECT_EQ(clicks, 1);
    EXPECT_FALSE(*cancelled);
    EXPECT_EQ(QFileInfo(path).size(), 6);
    EXPECT_FALSE(QFile::exists(path + ".new"));
    const auto saved = window->live().saveRecording(path);
    EXPECT_TRUE(saved && *saved);
    EXPECT_GT(QFileInfo(path).size(), 1'000'000);

    clicker.start();
    EXPECT_TRUE(window->live().openRecording(path));
    clicker.stop();
    EXPECT_EQ(clicks, 2);
    EXPECT_FALSE(window->control().showsRecorded());
    EXPECT_TRUE(window->live().openRecording(path));
    EXPECT_TRUE(window->control().showsRecorded());
}

TEST_F(LongTaskTest, CancelledTestsEndBetweenTwoScans) {
    write("tests/long.st", "TEST 'takes an hour'\nRUN 1000000000 SCANS;\nEND_TEST\n");
    ASSERT_TRUE(window->openProject(folder.path()));
    window->action("run.tests")->trigger();
    auto* cancel = window->findChild<QToolButton*>("cancelWork");
    ASSERT_TRUE(waitFor([&] { return cancel->isVisible(); }));
    QTest::qWait(300); // a duration: nothing tells from outside that the build is over and scans run
    QTest::mouseClick(cancel, Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] { return !cancel->isVisible(); }));
}

} // namespace
} // namespace plc::app
