// Every example runs a while in quick and in optimised code side by side: after each scan the two images must be the same bytes.
#include "projects/storage/project_file.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace plc {
namespace {

std::vector<std::string> examples() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(std::string(STEPWISE_SOURCE_DIR) + "/projects/examples"))
        if (std::filesystem::exists(entry.path() / "project.json")) names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

class BothTiers : public testing::TestWithParam<std::string> {};

TEST_P(BothTiers, LeaveTheSameImageAfterEveryScan) {
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    const auto project = projects::openProject({std::string(STEPWISE_SOURCE_DIR) + "/projects/examples/" + GetParam()});
    ASSERT_TRUE(project) << project.error().text();
    const driver::Built quick = driver::build(project->buildInput());
    ASSERT_TRUE(quick.program) << quick.failure;
    const driver::Built fast = driver::build(project->buildInput());
    const auto done = driver::optimise(fast);
    ASSERT_TRUE(done) << done.error().text();
    controller::Controller a(quick.program), c(fast.program);
    a.useQuickCode(true);
    a.start();
    c.start();
    const image::Layout& layout = quick.program->layout;
    for (int scan = 0; scan < 2000; ++scan) {
        const bool isGood = a.scan();
        ASSERT_EQ(isGood, c.scan());
        if (std::memcmp(a.image().data(), c.image().data(), layout.dataEnd) != 0) {
            uint32_t at = 0;
            while (a.image()[at] == c.image()[at]) ++at;
            FAIL() << "scan " << scan << ": " << layout.pathAt(at) << " differs";
        }
        if (isGood) continue;
        ASSERT_TRUE(a.fault() && c.fault());
        EXPECT_EQ(a.fault()->message, c.fault()->message);
        EXPECT_EQ(a.fault()->range, c.fault()->range);
        break;
    }
}

INSTANTIATE_TEST_SUITE_P(Examples, BothTiers, testing::ValuesIn(examples()), [](const auto& info) { return info.param; });

} // namespace
} // namespace plc
