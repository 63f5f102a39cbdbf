// Random programs: whatever they compute, quick code, optimised code and quick code that is asked at every statement
// (as by a debugger) leave the same image after each scan and fault at the same place by the same calls; an online
// change to the same statements changes no value; and expressions have the same value for the expression evaluator.
// A few run one by one, scan by scan, and are looked at in every way. Many are compiled together (random_batch.h): all
// are compared with the evaluator, every fiftieth batch in every way. STEPWISE_LONG=1 makes 100,000 of them, from
// STEPWISE_SEED on and STEPWISE_PROGRAMS of each kind; a failure prints its seed and its program.
#include "tests/golden/random_test.h"

#include "tests/golden/random_batch.h"
#include "tests/golden/random_runs.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

namespace plc::golden {
namespace {

struct Tally {
    size_t finished = 0, faulted = 0;
};

Scanned scanned(const driver::Built& built, Run run = Run::Newest) {
    Scanned out;
    controller::Controller controller(built.program, randomSettings());
    if (run == Run::Asked) askAtEveryStatement(controller, out.stops);
    controller.start();
    for (int i = 0; i < kScans && !controller.fault(); ++i) {
        controller.scan();
        out.images.emplace_back(controller.image().begin(), controller.image().begin() + built.program->layout.dataEnd);
    }
    takeFault(controller, out);
    return out;
}

void expectSame(const image::CompiledProgram& program, const Scanned& quick, const Scanned& other,
                const std::string& what) {
    for (const image::Root& root : program.layout.roots)
        ASSERT_EQ(differenceBetween(program, root, quick, other, 0), "") << what;
}

/// The program with a variable more, which moves all others: changed to it half way, every value is as if it had not
/// been.
void changeOnline(const driver::Built& built, const Scanned& expected, const std::string& what) {
    driver::BuildInput input = *built.input;
    std::string& text = input.files[0].text;
    const std::string head = "PROGRAM Main\nVAR\n";
    text.insert(text.find(head) + head.size(), "added : LINT := 7;\n");
    const driver::Built other = driver::build(input);
    ASSERT_TRUE(other.program) << what;
    controller::Controller controller(built.program, randomSettings());
    controller.start();
    for (int i = 0; i < kScans; ++i) {
        if (i == kScans / 2) {
            const auto report = controller.changeProgram(other.program);
            ASSERT_TRUE(report.refusal.isEmpty()) << report.refusal << what;
            ASSERT_TRUE(report.lost.empty()) << report.lost.front() << "\n" << what;
        }
        ASSERT_TRUE(controller.scan()) << what;
    }
    const auto& types = *built.program->layout.types;
    for (const image::Root& root : built.program->layout.roots)
        built.program->layout.forEachLeaf(
            root.name, {root.type, root.offset, root.bit}, [&](const std::string& path, const image::Place& place) {
                if (types.kind(place.type) == types::TypeKind::Interface) return true; // another offset, the same block
                const auto now = controller.read(path);
                EXPECT_TRUE(now) << path;
                if (!now) return false;
                const auto before = types::readValue(
                    types, place.type, std::span(expected.images.back()).subspan(place.offset), place.bit);
                EXPECT_EQ(types::toText(types, before), types::toText(*other.program->layout.types, *now))
                    << path << " after an online change, " << what;
                return !testing::Test::HasFailure();
            });
}

void runRandom(uint32_t seed, Faults faults, Tally& tally) {
    const RandomProgram random = randomProgram(seed, faults, "Main");
    driver::BuildInput input;
    input.files.push_back({"random.st", randomPrelude() + random.text});
    const std::string what = "seed " + std::to_string(seed) + "\n" + input.files[0].text;
    const driver::Built built = driver::build(input);
    ASSERT_EQ(built.failure.english(), "") << what;
    for (const auto& diagnostic : built.checked.analysis->diagnostics) {
        if (isByChance(diagnostic)) return;
        if (diagnostic.severity == diagnostics::Severity::Error)
            FAIL() << "seed " << seed << "\n" << diagnostics::renderText(*built.checked.sources, diagnostic, false);
    }
    ASSERT_TRUE(built.program);
    const Scanned quick = scanned(built);
    const Scanned asked = scanned(built, Run::Asked);
    EXPECT_GT(asked.stops, 0u) << what;
    ASSERT_NO_FATAL_FAILURE(expectSame(*built.program, quick, asked, "asked at every statement, " + what));
    if (quick.fault.empty()) {
        ASSERT_NO_FATAL_FAILURE(changeOnline(built, quick, what));
    }
    ASSERT_TRUE(driver::optimise(built));
    ASSERT_NO_FATAL_FAILURE(expectSame(*built.program, quick, scanned(built), "optimised, " + what));
    ++(quick.fault.empty() ? tally.finished : tally.faulted);
    EXPECT_EQ(evaluatedOtherwise(built, "Main", random, quick, quick.images.back()), "") << what;
}

uint32_t numberFrom(const char* variable, uint32_t otherwise) {
    const char* text = std::getenv(variable);
    return text && *text ? static_cast<uint32_t>(std::strtoul(text, nullptr, 10)) : otherwise;
}
bool isLong() { return numberFrom("STEPWISE_LONG", 0) == 1; }
uint32_t firstSeed() { return numberFrom("STEPWISE_SEED", 1); }

class SingleTest : public testing::Test {
public:
    explicit SingleTest(Faults faults) : m_faults(faults) {}
    void TestBody() override {
        constexpr uint32_t kPrograms = 12;
        Tally tally;
        for (uint32_t seed = firstSeed(); seed < firstSeed() + kPrograms && !HasFailure(); ++seed)
            runRandom(seed, m_faults, tally);
        EXPECT_GT(tally.finished, 0u);
        EXPECT_EQ(tally.faulted > 0, m_faults == Faults::Possible)
            << "faulted " << tally.faulted << " of " << tally.faulted + tally.finished;
    }

private:
    Faults m_faults;
};

class BatchTest : public testing::Test {
public:
    explicit BatchTest(Faults faults) : m_faults(faults) {}
    void TestBody() override {
        constexpr uint32_t kBatch = 50, kShort = 20, kLong = 50'000, kFullEvery = 50;
        const uint32_t count = numberFrom("STEPWISE_PROGRAMS", isLong() ? kLong : kShort);
        // behind those that ran one by one
        const uint32_t first = firstSeed() + 1000, end = first + count;
        uint32_t batch = 0;
        for (uint32_t seed = first; seed < end && !HasFailure(); seed += kBatch)
            take(runBatch(seed, std::min(kBatch, end - seed), m_faults,
                          batch++ % kFullEvery == 0 ? Depth::Full : Depth::Quick));
        std::cout << m_sum.finished << " programs finished, " << m_sum.faulted << " faulted, " << m_sum.dropped
                  << " had an error by chance; seeds " << first << " to " << end - 1 << "; processor time "
                  << m_sum.seconds << " s, without what only every fiftieth batch has " << m_sum.quickSeconds << " s\n";
        EXPECT_GT(m_sum.finished, 0u);
        EXPECT_EQ(m_sum.faulted > 0, m_faults == Faults::Possible);
    }

private:
    /// What differs is run once more by itself, and shown with its text.
    void take(const BatchReport& report) {
        m_sum.finished += report.finished;
        m_sum.faulted += report.faulted;
        m_sum.dropped += report.dropped;
        m_sum.seconds += report.seconds;
        m_sum.quickSeconds += report.quickSeconds;
        for (const Difference& difference : report.differences) {
            ADD_FAILURE() << "seed " << difference.seed << ": " << difference.what << "\n"
                          << randomPrelude() << randomProgram(difference.seed, m_faults, "Main").text;
            Tally alone;
            runRandom(difference.seed, m_faults, alone);
        }
    }
    Faults m_faults;
    BatchReport m_sum;
};

/// What every comparison rests on: one bit in one value of one scan is a difference, and has its name.
TEST(Random, ADifferenceIsFoundAndNamed) {
    driver::BuildInput input;
    input.files.push_back({"random.st", randomPrelude() + randomProgram(1, Faults::None, "Main").text});
    const driver::Built built = driver::build(input);
    ASSERT_TRUE(built.program);
    const image::CompiledProgram& program = *built.program;
    const Scanned one = scanned(built);
    const image::Root& root = program.layout.roots.front();
    const auto place = program.layout.find("Main.v_DINT_2");
    ASSERT_TRUE(place);
    Scanned other = one;
    EXPECT_EQ(differenceBetween(program, root, one, other, 0), "");
    other.images[3][place->offset] ^= std::byte(1);
    EXPECT_NE(differenceBetween(program, root, one, other, 0).find("scan 3, Main.v_DINT_2: "), std::string::npos);
    other = one;
    other.fault = "division by zero";
    EXPECT_NE(differenceBetween(program, root, one, other, 0).find("division by zero"), std::string::npos);
    const RandomProgram wrong{1, "Main", {}, {{"v_DINT_2", "v_DINT_2 + DINT#1"}}};
    EXPECT_NE(evaluatedOtherwise(built, "Main", wrong, one, one.images.back()), "");
}

} // namespace

void registerRandom() {
    const auto add = [](const char* name, auto make) {
        testing::RegisterTest("Random", name, nullptr, nullptr, __FILE__, __LINE__,
                              [make]() -> testing::Test* { return make(); });
    };
    add("ProgramsGiveTheSameInEachTier", [] { return new SingleTest(Faults::Possible); });
    add("ExpressionsGiveTheSameToTheEvaluator", [] { return new SingleTest(Faults::None); });
    add("ManyProgramsFaultAtTheSamePlaces", [] { return new BatchTest(Faults::Possible); });
    add("ManyProgramsGiveTheSameToTheEvaluator", [] { return new BatchTest(Faults::None); });
}

} // namespace plc::golden
