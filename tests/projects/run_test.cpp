// A run, live or from a file, as everybody looks at it: image, values, expressions of any version, and what a write
// goes to after the program has changed.
#include "projects/session/recorded_run.h"
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <unistd.h>

namespace plc::session {
namespace {

driver::Built build(const std::string& text) {
    static const bool once = (jit::setRuntimeSymbols(controller::runtimeSymbols()), true);
    (void)once;
    driver::BuildInput input;
    input.files.push_back({"main.st", text});
    driver::Built built = driver::build(input);
    EXPECT_TRUE(built.program) << built.failure.english();
    return built;
}

const char* const kCounter = "PROGRAM Main VAR n : DINT; END_VAR n := n + 1; END_PROGRAM";
const char* const kMoved = "PROGRAM Main VAR first : LREAL; other : DINT; n : DINT; END_VAR n := n + 1; END_PROGRAM";

/// Gone with the test.
struct File {
    std::string path =
        (std::filesystem::temp_directory_path() / ("stepwise-run-" + std::to_string(::getpid()) + ".rec")).string();
    ~File() { std::filesystem::remove(path); }
};

void scan(Session& session, int count) {
    session.controller().start();
    for (int i = 0; i < count; ++i) ASSERT_TRUE(session.controller().scan());
}

/// Of the newest image of whichever run it is.
std::string valueOf(const Run& run, const std::string& text) {
    Snapshot newest;
    run.latest(newest);
    if (!newest.program) return "no program";
    const auto expression = run.expression(text, {}, *newest.program);
    if (!expression) return expression.error().message.english();
    const expression::Outcome outcome = expression->evaluate(newest.image);
    return outcome.hasValue() ? types::toText(expression->types(), outcome.value) : outcome.reason.english();
}

TEST(Run, ARecordingShowsWhatTheControllerShowed) {
    const File file;
    Session session(build(kCounter));
    scan(session, 20);
    ASSERT_TRUE(session.history().save(file.path));
    const auto recorded = RecordedRun::open(file.path);
    ASSERT_TRUE(recorded) << recorded.error().english();
    for (const session::Run* run :
         {static_cast<const session::Run*>(&session), static_cast<const session::Run*>(recorded->get())}) {
        EXPECT_EQ(valueOf(*run, "Main.n * 2"), "40") << (run->isLive() ? "live" : "recorded");
        EXPECT_FALSE(run->expression("Main.nothing"));
        EXPECT_EQ(run->history().statistics().scans, 20u);
    }
    EXPECT_TRUE(session.isLive());
    EXPECT_FALSE((*recorded)->isLive());
    EXPECT_TRUE((*recorded)->forces().empty());
    EXPECT_EQ((*recorded)->status().position, 19u);
}

TEST(Run, ARecordingOverAnOnlineChangeHasTheExpressionsOfEachVersion) {
    const File file;
    Session session(build(kCounter));
    scan(session, 5);
    session.changeProgram(build(kMoved), {});
    scan(session, 5);
    ASSERT_TRUE(session.history().save(file.path));
    const auto recorded = RecordedRun::open(file.path);
    ASSERT_TRUE(recorded) << recorded.error().english();
    for (const session::Run* run :
         {static_cast<const session::Run*>(&session), static_cast<const session::Run*>(recorded->get())}) {
        std::shared_ptr<const image::CompiledProgram> before;
        const std::vector<std::byte> image = run->history().seek(2, &before);
        ASSERT_TRUE(before);
        const auto n = run->expression("Main.n", {}, *before);
        ASSERT_TRUE(n);
        EXPECT_EQ(n->evaluate(image).value.integer(), 3);
        EXPECT_FALSE(run->expression("Main.first", {}, *before)) << "it came later";
        EXPECT_TRUE(run->expression("Main.first"));
        EXPECT_EQ(valueOf(*run, "Main.n"), "10");
    }
}

TEST(Run, AWriteWhosePlaceWasFoundInAnOlderProgramGoesToTheVariableOfThatName) {
    Session session(build(kCounter));
    scan(session, 1);
    const auto target = session.target("Main.n");
    ASSERT_TRUE(target);
    EXPECT_EQ(target->program, session.program());
    session.changeProgram(build(kMoved), {});
    session.write(*target, types::Value{types::TypeTable::of(types::TypeKind::Dint), int64_t(77)});
    EXPECT_EQ(session.controller().read("Main.n")->integer(), 77);
    EXPECT_EQ(session.controller().read("Main.other")->integer(), 0);
    EXPECT_TRUE(session.takeRefusals().empty());
    session.changeProgram(build("PROGRAM Main VAR m : DINT; END_VAR m := m + 1; END_PROGRAM"), {});
    session.write(*target, types::Value{types::TypeTable::of(types::TypeKind::Dint), int64_t(78)});
    const std::vector<Error> refusals = session.takeRefusals();
    ASSERT_EQ(refusals.size(), 1u) << "there is no such variable any more";
    EXPECT_EQ(refusals.front().place, "Main.n");
}

TEST(Run, ATargetOfNothingSaysSo) {
    Session session(build(kCounter));
    EXPECT_FALSE(session.target("Main.nothing"));
    EXPECT_FALSE(RecordedRun::open("/nowhere/at.all"));
}

} // namespace
} // namespace plc::session
