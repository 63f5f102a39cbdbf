// Settings tried on a recording: with the parameters that were in force the blocks do what they did, bit for bit, in
// the shipped examples too; with others the loop answers as the model says.
#include "projects/loops/trial.h"
#include "projects/session/session.h"
#include "projects/storage/project_file.h"
#include "projects/tuning/model/find.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

using namespace plc;
using namespace plc::loops;

namespace {

/// A shipped example, run for so many scans with these writes at their scans.
class Example {
public:
    struct Write {
        uint64_t scan;
        std::string path;
        double value;
    };
    Example(const std::string& name, uint64_t scans, std::vector<Write> writes = {}) {
        const auto project = projects::openProject({sourceDir() + "/projects/examples/" + name});
        EXPECT_TRUE(project) << name;
        m_built = driver::build(project->buildInput());
        EXPECT_TRUE(m_built.program) << name;
        session = std::make_unique<session::Session>(m_built);
        session->controller().start();
        while (session->controller().nextScan() < scans) {
            for (const Write& write : writes) {
                if (write.scan != session->controller().nextScan()) continue;
                const auto value = valueFor(*m_built.program, write.path, write.value);
                EXPECT_TRUE(value && session->controller().write(write.path, *value)) << write.path;
            }
            session->controller().scan();
        }
    }
    [[nodiscard]] const history::History& history() const { return session->history(); }
    [[nodiscard]] ProgramPointer program() const { return m_built.program; }
    std::unique_ptr<session::Session> session;

private:
    driver::Built m_built;
};

void expectSameBits(const Example& example, const std::string& name, history::Position from, history::Position to) {
    const auto loop = findLoop(*example.program(), name);
    ASSERT_TRUE(loop) << loop.error().english();
    const auto plan = planFor(*loop, example.history(), from, to);
    ASSERT_TRUE(plan) << plan.error().english();
    for (const bool hasModel : {false, true}) {
        tuning::ProcessModel model;
        model.lags = {1};
        const auto run = tryOut(example.history(), *plan, hasModel ? std::optional(model) : std::nullopt);
        ASSERT_TRUE(run) << run.error().english();
        EXPECT_EQ(run->scans, to - from - 1);
        EXPECT_FALSE(run->firstDifference) << name << ", scan " << run->firstDifference.value_or(0);
        EXPECT_EQ(run->series.output, run->before.output);
    }
}

} // namespace

TEST(Trial, ThePidOfPidPt1RepeatsItsRecordingBitForBit) {
    const Example example("pid_pt1", 2000, {{0, "Main.Period", 8}, {700, "Main.Kp", 3}});
    expectSameBits(example, "Main.pid", 0, 699);
    expectSameBits(example, "Main.pid", 710, 2000);
}

TEST(Trial, BothLoopsOfTheCascadeRepeatTheirRecordingBitForBit) {
    const Example example("cascade", 4000, {{1500, "Main.SetPoint", 24}, {2500, "Plant.WindowOpen", 1}});
    expectSameBits(example, "Main.controller.PI", 0, 4000);
    expectSameBits(example, "Main.controller.PID", 0, 4000);
}

TEST(Trial, TheControllerOfLoopTuningRepeatsItsRecordingBitForBit) {
    const Example example("loop_tuning", 3000, {{600, "Main.SetPoint", 45}, {1800, "Plant.MoreFlow", 1}});
    expectSameBits(example, "Main.controller", 0, 3000);
}

TEST(Trial, TheTankHeatingRepeatsItsRecordingBitForBit) {
    // no controller block: the sequence's outputs, from the sensors that were recorded
    const Example example("tank_heating", 6000, {{20, "Plant.Start", 1}, {30, "Plant.Start", 0}});
    for (const char* output : {"IO.V1", "IO.V2", "IO.V3", "IO.M1"}) {
        const TrialPlan plan{0, 6000, output, "IO.TT1", {"IO.PT1", "IO.S1", "IO.S2"}, {}};
        const auto run = tryOut(example.history(), plan, std::nullopt);
        ASSERT_TRUE(run) << run.error().english();
        EXPECT_EQ(run->scans, 5999U);
        EXPECT_FALSE(run->firstDifference) << output << ", scan " << run->firstDifference.value_or(0);
    }
}

TEST(Trial, OtherSettingsDoWhatTheControllerThenDoes) {
    // the model is exactly the plant: what was tried is what the controller does when the settings are written
    const uint64_t change = 400, end = 1200;
    const Example before("pid_pt1", end, {{0, "Main.Period", 8}});
    const Example after("pid_pt1", end, {{0, "Main.Period", 8}, {change, "Main.Kp", 2.0}, {change, "Main.Tn", 300.0}});
    const auto loop = findLoop(*before.program(), "Main.pid");
    auto plan = planFor(*loop, before.history(), change - 1, end);
    ASSERT_TRUE(plan);
    plan->writes = {{"Main.Kp", 2.0}, {"Main.Tn", 300.0}};
    tuning::ProcessModel plant;
    plant.lags = {0.5};
    const auto run = tryOut(before.history(), *plan, plant);
    ASSERT_TRUE(run) << run.error().english();
    ASSERT_TRUE(run->firstDifference);
    const auto really = seriesOf(after.history(), signalsOf(*loop));
    ASSERT_TRUE(really);
    ASSERT_EQ(run->series.size(), end - change);
    for (size_t i = 0; i < run->series.size(); ++i)
        EXPECT_NEAR(run->series.output[i], really->series.output[change + i], 0.02) << "scan " << change + i;
}

TEST(Trial, RefusesWhatItCannotTry) {
    const Example example("pid_pt1", 100);
    const TrialPlan unknown{0, 100, "Main.nothing", "IO.Measured", {}, {}};
    EXPECT_FALSE(tryOut(example.history(), unknown, std::nullopt));
    TrialPlan wrong{0, 100, "IO.Drive", "IO.Measured", {}, {{"Main.nothing", 1}}};
    EXPECT_FALSE(tryOut(example.history(), wrong, std::nullopt));
    wrong.writes = {};
    wrong.from = 5000;
    EXPECT_FALSE(tryOut(example.history(), wrong, std::nullopt));
}

TEST(Trial, OfAStretchThatIsForgottenMeanwhileSaysSo) {
    const auto project = projects::openProject({sourceDir() + "/projects/examples/cascade"});
    ASSERT_TRUE(project);
    const driver::Built built = driver::build(project->buildInput());
    ASSERT_TRUE(built.program);
    session::Settings settings;
    settings.historyBudget = size_t(1) << 20;
    session::Session session(built, settings);
    session.startThread({session::Pace::Fastest, 1.0});
    const history::History& history = session.history();
    while (history.statistics().first == 0) std::this_thread::yield();
    const auto loop = findLoop(*built.program, "Main.controller.PID");
    ASSERT_TRUE(loop);
    int refused = 0;
    for (int i = 0; i < 2000 && refused < 20; ++i) {
        const history::Statistics there = history.statistics();
        const history::Position from = there.first + static_cast<history::Position>(i) % 16 * 100;
        const auto plan = planFor(*loop, history, from, from + 300);
        const auto run = plan ? tryOut(history, *plan, std::nullopt) : Result<TrialRun>(plan.error());
        if (!run) {
            ++refused;
            continue;
        }
        EXPECT_EQ(run->scans, 299U);
        EXPECT_FALSE(run->firstDifference) << "scan " << run->firstDifference.value_or(0);
    }
    EXPECT_GT(refused, 0) << "nothing was forgotten: nothing is tested";
}
