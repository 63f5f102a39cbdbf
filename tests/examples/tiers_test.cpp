// Every example runs a while in quick and in optimised code side by side: after each scan the two images must be the
// same bytes.
#include "tests/examples/example_names.h"

#include "projects/storage/project_file.h"
#include "runtime/controller/controller.h"

#include <gtest/gtest.h>

#include <cstring>

namespace plc {
namespace {

class BothTiers : public ::testing::TestWithParam<std::string> {};

TEST_P(BothTiers, LeaveTheSameImageAfterEveryScan) {
    const auto project = projects::openProject({exampleFolder(GetParam())});
    ASSERT_TRUE(project) << project.error().english();
    const driver::Built quick = driver::build(project->buildInput());
    ASSERT_TRUE(quick.program) << quick.failure.english();
    const driver::Built fast = driver::build(project->buildInput());
    const auto done = driver::optimise(fast);
    ASSERT_TRUE(done) << done.error().english();
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
        EXPECT_EQ(a.fault()->message.english(), c.fault()->message.english());
        EXPECT_EQ(a.fault()->range, c.fault()->range);
        break;
    }
}

INSTANTIATE_TEST_SUITE_P(Examples, BothTiers, ::testing::ValuesIn(exampleNames()),
                         [](const auto& info) { return info.param; });

} // namespace
} // namespace plc
