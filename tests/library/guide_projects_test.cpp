// The projects of the guide's usage examples: their own tests, and their trace set-ups.
#include "tests/library/bench.h"
#include "tests/support/paths.h"

#include "projects/storage/project_file.h"
#include "projects/testing/test_run.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace plc::test {
namespace {

TEST(GuideProjects, HaveTraceSetUpsWhoseChannelsExist) {
    int channels = 0;
    for (const char* name : {"pid_pt1", "pt1_filter", "pwm", "hour_meter"}) {
        const std::string folder = plc::sourceDir() + "/projects/examples/" + name;
        const auto project = projects::openProject({folder});
        ASSERT_TRUE(project) << project.error().english();
        const driver::Checked checked = driver::check(project->buildInput());
        ASSERT_FALSE(checked.analysis->hasErrors) << name;
        EXPECT_FALSE(project->traces.empty()) << name;
        for (const std::string& trace : project->traces) {
            const auto text = projects::readFile(folder + "/traces/" + trace);
            ASSERT_TRUE(text) << text.error().english();
            const nlohmann::json setup = nlohmann::json::parse(*text);
            for (const auto& channel : setup["channels"]) {
                const auto expression = driver::compileExpression(checked, channel["expression"].get<std::string>());
                EXPECT_TRUE(expression) << name << ": " << channel["expression"]
                                        << (expression ? "" : expression.error().english());
                ++channels;
            }
        }
    }
    EXPECT_GE(channels, 14);
}

TEST(GuideProjects, PassTheirOwnTests) {
    for (const char* name : {"pid_pt1", "pt1_filter", "pwm", "hour_meter"}) {
        const auto project = projects::openProject({plc::sourceDir() + "/projects/examples/" + name});
        ASSERT_TRUE(project) << project.error().english();
        jit::setRuntimeSymbols(controller::runtimeSymbols());
        const auto report = testing::runTests(*project, {});
        ASSERT_TRUE(report) << report.error().english();
        EXPECT_FALSE(report->hasErrors) << (report->diagnostics.empty() ? "" : report->diagnostics[0]);
        EXPECT_FALSE(report->results.empty());
        for (const testing::TestResult& result : report->results)
            for (const testing::Failure& failure : result.failures)
                ADD_FAILURE() << name << ": " << result.title << ": " << failure.message.english() << ' '
                              << failure.detail.english() << " at " << failure.time.count() / 1000000 << " ms";
    }
}

} // namespace
} // namespace plc::test
