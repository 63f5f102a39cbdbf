// What a build leaves behind when its program is gone: nothing. A studio builds at each F5 and each online change.
#include "runtime/compiler/driver/driver.h"

#include <gtest/gtest.h>

namespace plc {
namespace {

driver::Built builtOf(const char* text) {
    driver::BuildInput input;
    input.files.push_back({"main.st", text});
    return driver::build(input);
}

TEST(Lifetime, TheAnalysisGoesWithItsProgram) {
    driver::Built built = builtOf("PROGRAM Main VAR x : INT; p : POINTER TO INT; END_VAR p := ADR(x); x := x + 1; "
                                  "END_PROGRAM");
    ASSERT_TRUE(built.program);
    const std::weak_ptr<const sema::Analysis> analysis = built.checked.analysis;
    const std::weak_ptr<const image::CompiledProgram> program = built.program;
    built = {};
    EXPECT_TRUE(program.expired());
    EXPECT_TRUE(analysis.expired());
}

TEST(Lifetime, TheProgramAloneKeepsItsAnalysis) {
    driver::Built built = builtOf("PROGRAM Main VAR x : INT; END_VAR x := x + 1; END_PROGRAM");
    const std::weak_ptr<const sema::Analysis> analysis = built.checked.analysis;
    const std::shared_ptr<const image::CompiledProgram> program = built.program;
    built = {};
    EXPECT_FALSE(analysis.expired());
    EXPECT_NE(driver::treeOf(program), nullptr);
}

} // namespace
} // namespace plc
