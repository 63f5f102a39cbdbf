// A studio window on a throw-away copy of a small project. One per test.
#pragma once
#include "app/main_window.h"
#include "app/pages/editor_tabs.h"
#include "app/project/search_view.h"
#include "app/settings/settings.h"
#include "tests/support/patience.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <functional>

namespace plc::app {

inline const char* const kMain = R"(PROGRAM Main
VAR
    counter : INT;
    limit : INT := 1000;
    done : BOOL;
    pulse : TON;
END_VAR
counter := counter + 1;
IF counter >= limit THEN
    counter := 0;
    done := NOT done;
END_IF
pulse(IN := NOT pulse.Q, PT := T#100ms);
END_PROGRAM
)";

class StudioTest : public ::testing::Test {
protected:
    void SetUp() override {
        QSettings("Stepwise", "Stepwise").clear();
        Settings().setSawTour();
        write("project.json", "{\n  \"name\": \"Test\",\n  \"libraries\": []\n}\n");
        write("src/main.st", kMain);
        window = std::make_unique<MainWindow>();
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        ASSERT_TRUE(window->openProject(folder.path()));
        ASSERT_TRUE(waitFor([&] { return window->workspace().model() != nullptr; }));
    }
    void TearDown() override {
        if (window) window->control().disconnectSession();
        window.reset();
    }
    void write(const QString& path, const QByteArray& text) {
        QFile file(folder.path() + "/" + path);
        QDir().mkpath(QFileInfo(file).path());
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    static bool waitFor(const std::function<bool()>& condition, int ms = kPatience) {
        QElapsedTimer timer;
        timer.start();
        while (timer.elapsed() < ms) {
            if (condition()) return true;
            QTest::qWait(10); // a duration: how often it is asked
        }
        return condition();
    }
    /// The next analysis of the present text.
    void analysed() {
        QTest::qWait(30); // a duration: of the pause in typing, after which a check starts
        ASSERT_TRUE(waitFor([&] {
            const auto model = window->workspace().model();
            const auto file = model ? model->fileOf("src/main.st") : std::nullopt;
            return file && std::string(model->sources()[*file].text()) == window->workspace().text("src/main.st");
        }));
    }
    editor::StEditor& editor() { return *window->tabs().currentEditor(); }
    void typeAtEnd(const QString& text) {
        const auto at = editor().utf8().find("END_PROGRAM");
        editor().applyEdits({{{FileId(), static_cast<uint32_t>(at), static_cast<uint32_t>(at)}, "\n"}});
        editor().goTo(static_cast<uint32_t>(at));
        QTest::keyClicks(editor().viewport(), text);
    }

    QTemporaryDir folder;
    std::unique_ptr<MainWindow> window;
};

} // namespace plc::app
