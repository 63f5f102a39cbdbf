// docs/tutorial.md, step by step: the program and the test are read from the page itself, so that it can not go stale.
#include "tests/app/studio_fixture.h"

#include "app/new_project.h"
#include "editor/debug/watch_view.h"
#include "projects/storage/project_file.h"
#include "projects/testing/test_run.h"

#include <QAction>
#include <QSignalSpy>

namespace plc::app {
namespace {

/// The n-th block of ST on the page.
std::string listing(int n) {
    const auto page = projects::readFile(std::string(STEPWISE_SOURCE_DIR) + "/docs/tutorial.md");
    size_t at = 0;
    for (int i = 0; i <= n; ++i) at = page->find("```iecst\n", at) + 9;
    return page->substr(at, page->find("```", at) - at);
}

TEST(Tutorial, ItsStepsWork) {
    QSettings("Stepwise", "Stepwise").clear();
    Settings().setSawTour();
    QTemporaryDir folder;
    const QString project = folder.path() + "/my_motor";
    ASSERT_TRUE(createProject(project.toStdString(), "My motor", "empty"));
    const auto waitFor = [](const std::function<bool()>& condition) {
        QElapsedTimer timer;
        timer.start();
        while (timer.elapsed() < 8000 && !condition()) QTest::qWait(10);
        return condition();
    };
    MainWindow window;
    window.show();
    ASSERT_TRUE(window.openProject(project));
    ASSERT_TRUE(waitFor([&] { return window.workspace().model() != nullptr; }));

    // 2: the program
    editor::StEditor& editor = *window.tabs().currentEditor();
    const std::string old = editor.utf8();
    const auto end = static_cast<uint32_t>(old.find("END_PROGRAM\n") + 12);
    editor.applyEdits({{{FileId(), 0, end}, listing(0)}});

    // 3: run, write, watch
    window.action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window.control().status().scans > 3; }));
    ASSERT_TRUE(window.control().write("Main.Start", "TRUE"));
    ASSERT_TRUE(waitFor([&] { return window.control().value("Main.Motor").isTrue; }));
    ASSERT_TRUE(window.control().write("Main.Start", "FALSE"));
    QTest::qWait(100);
    EXPECT_TRUE(window.control().value("Main.Motor").isTrue) << "it holds itself";

    // 6: change it while it runs
    QSignalSpy changed(&window.control(), &editor::RunControl::onlineChangeFinished);
    const auto at = static_cast<uint32_t>(editor.utf8().find("RunTime + T#10ms") + 12); // at 10ms
    editor.applyEdits({{{FileId(), at, at + 4}, "20ms"}});
    window.action("file.save")->trigger();
    ASSERT_TRUE(waitFor([&] { return changed.count() == 1; }));
    EXPECT_TRUE(window.control().value("Main.Motor").isTrue);
    ASSERT_TRUE(window.control().write("Main.Stop", "FALSE"));
    EXPECT_TRUE(waitFor([&] { return !window.control().value("Main.Motor").isTrue; }));
    window.control().disconnectSession();

    // 5: the test, on the program as the page has it
    ASSERT_TRUE(projects::writeFileAtomically(project.toStdString() + "/tests/motor.st", listing(1)));
    const auto opened = projects::openProject({project.toStdString()});
    ASSERT_TRUE(opened);
    const auto report = testing::runTests(*opened, {});
    ASSERT_TRUE(report);
    EXPECT_FALSE(report->hasErrors) << (report->diagnostics.empty() ? "" : report->diagnostics.front());
    ASSERT_EQ(report->results.size(), 1u);
    EXPECT_TRUE(report->results[0].passed()) << (report->results[0].failures.empty() ? "" : report->results[0].failures[0].message);
}

} // namespace
} // namespace plc::app
