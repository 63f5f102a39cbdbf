// A scan that stands at a breakpoint is shown as far as it came, also when somebody wrote or forced just before it.
#include "runtime/inside/standing.h"

#include "runtime/inside/place_values.h"
#include "tests/runtime/inside/recorded.h"
#include "tests/support/eventually.h"

#include <chrono>
#include <thread>

using namespace plc;
using namespace plc::inside;
using plc::testing::buildText;
using plc::testing::integerFor;
using plc::testing::rangeOf;

namespace {

const char* const kText = R"(PROGRAM Main
VAR a, b : BOOL; n, i, sum : INT; step : INT := 1; s : STRING; END_VAR
n := n + step;
a := n MOD 2 = 0;
b := a OR b;
s := CONCAT('scan number ', INT_TO_STRING(n));
FOR i := 1 TO 4 DO
    sum := sum + i * n;
END_FOR
a := NOT a;
n := n + 0;
END_PROGRAM)";

class StandingScan : public ::testing::Test {
protected:
    void haltAt(uint32_t line) {
        session.setBreakpoints({{FileId(0), line, {}, 0, {}, true}});
        session.startThread({session::Pace::Real, 1});
        ASSERT_TRUE(eventually([&] { return session.status().halts == 1; }));
    }
    std::optional<StandingLook> look() {
        session::Snapshot now;
        session.latest(now);
        EXPECT_TRUE(now.isHalted);
        Insight insight(session.history());
        return lookAtStanding(insight, {now.program, now.image, session.haltFrames().front()});
    }
    std::string shown(const StandingLook& found, std::string_view part, std::string_view after = {}) {
        const PlaceValues values(found.look, FileId(0), "Main", found.end);
        const auto* value = values.at(rangeOf(*session.program(), part, after));
        return value ? types::toText(*session.program()->layout.types, value->value) : "";
    }
    session::Session session{buildText(kText)};
};

} // namespace

TEST_F(StandingScan, ShowsWhatWasComputedUntilThere) {
    haltAt(10);
    const auto found = look();
    ASSERT_TRUE(found);
    EXPECT_EQ(shown(*found, "n + step"), "1");
    EXPECT_EQ(shown(*found, "n MOD 2 = 0"), "FALSE");
    EXPECT_EQ(shown(*found, "NOT a"), "");
    const PlaceValues values(found->look, FileId(0), "Main", found->end);
    EXPECT_TRUE(values.isExecuted(rangeOf(*session.program(), "b := a OR b;")));
    EXPECT_FALSE(values.isExecuted(rangeOf(*session.program(), "a := NOT a;")));
}

TEST_F(StandingScan, ComesToTheRightPassOfALoop) {
    haltAt(8);
    for (uint64_t pass = 1; pass <= 3; ++pass) {
        const auto found = look();
        ASSERT_TRUE(found);
        EXPECT_EQ(shown(*found, "i * n"), pass == 1 ? "" : std::to_string(pass - 1));
        session.resume();
        ASSERT_TRUE(eventually([&] { return session.status().halts == pass + 1; }));
    }
}

/// In the scan before the one it stands in, halted in its middle, a value is written.
class WrittenBefore : public StandingScan {
protected:
    std::optional<StandingLook> lookAfterWriting(const char* path, int64_t value) {
        haltAt(4);
        session.setBreakpoints({{FileId(0), 10, {}, 0, {}, true}});
        session.pause();
        session.resume();
        EXPECT_TRUE(eventually([&] { return session.status().halts == 2; }));
        session.resume();
        EXPECT_TRUE(eventually([&] { return session.status().state == controller::State::Paused; }));
        session.write(path, integerFor(*session.program(), path, value));
        session.start();
        EXPECT_TRUE(eventually([&] { return session.status().halts == 3; }));
        return look();
    }
};

TEST_F(WrittenBefore, AValueThatTheProgramReadsIsKnown) {
    const auto found = lookAfterWriting("Main.step", 50);
    ASSERT_TRUE(found);
    EXPECT_EQ(shown(*found, "n + step"), "51");
}

TEST_F(WrittenBefore, NothingIsSaidWhereItIsOverwrittenAlready) { EXPECT_FALSE(lookAfterWriting("Main.n", 100)); }
