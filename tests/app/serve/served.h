// A project that is built, runs and is served, for the server's tests. Main thread.
#pragma once
#include "app/serve/server.h"
#include "chromium.h"
#include "hmi/player/panel_commands.h"
#include "projects/storage/project_file.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

namespace plc::serve {

inline constexpr const char* kCode = "correct horse";

/// Takes any free port.
struct Served {
    hmi::PanelProject panels;
    std::unique_ptr<session::Session> machine;
    std::unique_ptr<Server> server;

    void open(const std::string& folder, ServerSettings settings = {}) {
        const auto project = projects::openProject({folder});
        ASSERT_TRUE(project) << project.error().english();
        panels = hmi::loadPanelProject(*project);
        build(project->buildInput(), std::move(settings));
    }
    void build(const driver::BuildInput& input, ServerSettings settings = {}) {
        driver::Built built = driver::build(input);
        ASSERT_TRUE(built.program) << built.failure.english();
        machine = std::make_unique<session::Session>(std::move(built));
        settings.port = 0;
        server = std::make_unique<Server>(panels, *machine, byAccessCode(kCode), std::move(settings));
        const auto started = server->start();
        ASSERT_TRUE(started) << started.error().english();
    }
    QString url(const QString& path) const { return server->url() + path; }
    double number(const std::string& path) const {
        const auto expression = machine->expression(path);
        EXPECT_TRUE(expression) << path;
        const std::vector<std::byte> image = machine->snapshot();
        if (!expression || image.empty()) return 0;
        const types::Value value = expression->evaluate(image).value;
        const int64_t* whole = std::get_if<int64_t>(&value.data);
        return whole ? static_cast<double>(*whole) : value.real();
    }
};

/// A server's clock that jumps when a test says so: the machine had other work, or was suspended.
struct SleepingClock {
    QElapsedTimer clock;
    qint64 asleep = 0;
    int asked = 0;
    explicit SleepingClock(ServerSettings& settings) {
        clock.start();
        settings.clock = [this] {
            ++asked;
            return clock.elapsed() + asleep;
        };
    }
    /// Until some frames after it.
    bool sleep(qint64 milliseconds) {
        asleep += milliseconds;
        asked = 0;
        return waitUntil([this] { return asked > 2; });
    }
};

inline std::string exampleFolder(const std::string& name) { return sourceDir() + "/projects/examples/" + name; }

} // namespace plc::serve
