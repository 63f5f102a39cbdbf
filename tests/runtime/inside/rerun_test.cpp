#include "runtime/inside/rerun.h"

#include "projects/session/session.h"
#include "projects/session/versions.h"
#include "runtime/base/messages.h"
#include "tests/projects/random_program.h"
#include "tests/runtime/inside/recorded.h"
#include "tests/support/repeats.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace plc;
using namespace std::chrono_literals;

using plc::testing::buildText;

namespace {

types::Value integer(const image::Layout& layout, const std::string& path, int64_t value) {
    const auto place = layout.find(path);
    EXPECT_TRUE(place) << path;
    types::Value v;
    v.type = place ? place->type : types::TypeId();
    v.data = value;
    return v;
}

/// Something from outside between two scans.
void disturb(session::Session& session, std::mt19937& dice) {
    controller::Controller& controller = session.controller();
    const image::Layout& layout = controller.program().layout;
    const auto value = static_cast<int64_t>(dice() % 200);
    switch (dice() % 24) {
    case 0:
    case 1:
    case 2:
        (void)controller.write("input", integer(layout, "input", value));
        break;
    case 3:
        (void)controller.write("shared[3]", integer(layout, "shared[3]", value * 1000));
        break;
    case 4:
        (void)controller.write("raise", integer(layout, "raise", value % 2));
        break;
    case 5:
        (void)controller.force("shared[1]", integer(layout, "shared[1]", value));
        break;
    case 6:
        (void)controller.force("input", integer(layout, "input", value));
        break;
    case 7:
        (void)controller.release("shared[1]");
        break;
    case 8:
        controller.releaseAll();
        break;
    case 9:
        if (dice() % 3 == 0) controller.reset(static_cast<controller::ResetKind>(dice() % 3));
        controller.start();
        break;
    case 10:
        controller.stop();
        controller.start();
        break;
    case 11:
        controller.pause();
        break;
    case 12: {
        const history::Statistics all = session.history().statistics();
        if (dice() % 3 == 0 && all.scans > 3) (void)session.resumeFrom(all.first + dice() % all.scans);
        controller.start();
        break;
    }
    default:
        break;
    }
}

/// Every scan of the recording that can be run again comes out as it was recorded.
void expectEveryScanAgain(const history::History& history, const std::string& what) {
    inside::Rerunner again(history);
    const history::Statistics all = history.statistics();
    size_t unknown = 0;
    for (history::Position at = all.first; at < all.end; ++at) {
        const auto rerun = again.run(at);
        if (!rerun) {
            EXPECT_EQ(at, all.first) << what << rerun.error().english(); // what it went on from is evicted
            ++unknown;
            continue;
        }
        ASSERT_TRUE(rerun->isExact()) << what << " position " << at << " of " << all.end << " at "
                                      << rerun->differences[0].path << " (" << rerun->differences.size() << ")";
        ASSERT_TRUE(rerun->input.hasJournal);
    }
    EXPECT_LE(unknown, 1u);
}

} // namespace

TEST(RunAgain, EveryScanOfRandomProgramsWithInfluenceFromOutside) {
    const unsigned seed = 4711;
    const unsigned count = std::getenv("STEPWISE_LONG") ? 1000 : repeats(25U);
    for (unsigned run = 0; run < count; ++run) {
        const std::string text = plc::testing::RandomProgram(seed + run).text();
        std::mt19937 dice(seed + run);
        session::Session session(buildText(text));
        session.controller().start();
        for (int i = 0; i < 120; ++i) {
            disturb(session, dice);
            if (session.controller().state() == controller::State::Paused) {
                session.controller().scan();
                session.controller().start();
            }
            session.controller().scan();
            if (i == 70 && run % 3 == 0) {
                const std::string next = plc::testing::RandomProgram(seed + run + 7000).text();
                session.changeProgram(buildText(next), nullptr);
            }
        }
        expectEveryScanAgain(session.history(), "seed " + std::to_string(seed + run));
        if (run % 5 != 0) continue;
        const std::string file =
            (std::filesystem::temp_directory_path() / ("again" + std::to_string(::getpid()) + ".rec")).string();
        ASSERT_TRUE(session.history().save(file));
        const auto loaded = history::History::load(file, [](const history::History::Sources& sources) {
            return driver::build(session::recordedInput(sources)).program;
        });
        ASSERT_TRUE(loaded) << loaded.error().english();
        expectEveryScanAgain(**loaded, "file of seed " + std::to_string(seed + run));
        std::filesystem::remove(file);
    }
}

TEST(RunAgain, SurvivesEviction) {
    session::Settings settings;
    settings.historyBudget = size_t(1) << 19;
    session::Session session(buildText(plc::testing::RandomProgram(5).text()), settings);
    std::mt19937 dice(5);
    session.controller().start();
    (void)session.controller().force("input", integer(session.program()->layout, "input", 12));
    while (session.history().statistics().first < 300) {
        if (dice() % 40 == 0)
            (void)session.controller().write("shared[3]", integer(session.program()->layout, "shared[3]", 7));
        session.controller().scan();
    }
    inside::Rerunner again(session.history());
    const history::Statistics all = session.history().statistics();
    EXPECT_FALSE(again.run(all.first)); // what it went on from is gone
    EXPECT_FALSE(again.run(all.first - 1));
    for (history::Position at = all.first + 1; at < all.end; at += 1 + (all.end - all.first) / 200) {
        const auto rerun = again.run(at);
        ASSERT_TRUE(rerun) << rerun.error().english();
        ASSERT_TRUE(rerun->isExact()) << at;
        EXPECT_EQ(rerun->input.start.forces.size(), 1u);
    }
}

TEST(RunAgain, TheJournalSaysWhoWrote) {
    session::Session session(buildText("VAR_GLOBAL a, b : INT; END_VAR\nPROGRAM Main b := a; END_PROGRAM"));
    controller::Controller& controller = session.controller();
    controller.start();
    controller.scan();
    controller.actFor("panel Main, button Start");
    ASSERT_TRUE(controller.write("a", integer(session.program()->layout, "a", 5)));
    controller.scan();
    controller.scan();
    size_t seen = 0;
    session.history().forEachJournal(0, 10, [&](history::Position at, const history::JournalEntry& entry) {
        for (const image::OutsideNote& note : entry.notes) {
            if (note.kind != image::OutsideKind::Write) continue;
            ++seen;
            EXPECT_EQ(at, 1u);
            EXPECT_EQ(note.origin, "panel Main, button Start");
            EXPECT_EQ(note.offset, session.program()->layout.find("a")->offset);
        }
        return true;
    });
    EXPECT_EQ(seen, 1u);
}

TEST(RunAgain, AFaultedScanAndThePlantBehindIt) {
    session::Session session(
        buildText("VAR_GLOBAL n : INT := 3; q : INT; out AT %QW0 : INT; END_VAR\n"
                  "PROGRAM Main n := n - 1; out := n; q := 10 / n; END_PROGRAM\n"
                  "{attribute 'simulation'} PROGRAM Plant VAR s : INT; END_VAR s := s + out; END_PROGRAM"));
    session.controller().start();
    for (int i = 0; i < 8; ++i) session.controller().scan();
    EXPECT_EQ(session.controller().state(), controller::State::Fault);
    expectEveryScanAgain(session.history(), "fault");
}

TEST(RunAgain, OfAScanThatIsForgottenMeanwhileSaysSo) {
    session::Settings settings;
    settings.historyBudget = size_t(1) << 18;
    session::Session session(buildText("PROGRAM Main VAR count : UDINT; END_VAR count := count + 1; END_PROGRAM"),
                             settings);
    session.controller().start();
    while (session.controller().nextScan() < 100) ASSERT_TRUE(session.controller().scan());
    inside::Rerunner rerunner(session.history());
    ASSERT_TRUE(rerunner.run(50));
    inside::Rerunner::How how;
    how.prepare = [&](image::RuntimeContext&) { // the controller goes on while the scan is run again
        while (session.history().statistics().first <= 50) (void)session.controller().scan();
    };
    const auto forgotten = rerunner.run(50, how);
    ASSERT_FALSE(forgotten) << "it was not compared with anything";
    EXPECT_EQ(forgotten.error().message, errors::ScanNoLongerRecorded());
}
