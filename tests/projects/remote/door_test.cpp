// What an attached studio may ask of a controller, and the session that mirrors it, without a socket between them.
#include "projects/remote/door.h"

#include "projects/remote/errors.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"
#include "runtime/inside/rerun.h"
#include "tests/support/eventually.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <thread>

namespace plc::remote {
namespace {

constexpr const char* kPlant = R"(PROGRAM Main
VAR RETAIN n : DINT; END_VAR
VAR speed : REAL := 1.5; lamp : BOOL; text : STRING(20) := 'idle'; END_VAR
n := n + 1;
lamp := n MOD 2 = 0;
END_PROGRAM
CONFIGURATION C RESOURCE R ON PLC
    TASK T(INTERVAL := T#5ms, PRIORITY := 1);
    PROGRAM Main WITH T : Main;
END_RESOURCE END_CONFIGURATION
)";

struct Sink final : session::Outlet {
    std::vector<session::Order> all;
    void post(session::Order order) override { all.push_back(std::move(order)); }
    Error whyNotBack() const override { return {errors::NotPutBack(), {}}; }
};

/// As it comes out of the wire.
Json sent(const Json& json) { return Json::parse(json.dump()); }

/// Of braces alone nlohmann::json would make an object.
Json pairs(const std::vector<std::array<const char*, 2>>& all) {
    Json out = Json::array();
    for (const auto& [path, text] : all) out.push_back(Json::array({path, text}));
    return out;
}

class DoorTest : public ::testing::Test {
protected:
    static void SetUpTestSuite() { jit::setRuntimeSymbols(controller::runtimeSymbols()); }
    void SetUp() override { open({.mayHalt = true}); }
    void open(Rights rights) {
        driver::BuildInput input;
        input.files.push_back({"main.st", kPlant});
        door.reset();
        plant = std::make_unique<session::Session>(driver::build(input));
        plant->startThread({session::Pace::Real});
        door = std::make_unique<Door>(*plant, "test", rights);
    }
    /// The answer, at once or later; news are kept.
    Json ask(Json request) {
        request["id"] = 5u;
        if (const auto answer = door->answer(sent(request))) return sent(*answer);
        Json out;
        EXPECT_TRUE(eventually([&] {
            for (Json& each : door->due()) {
                if (each.contains("id"))
                    out = sent(each);
                else
                    news.push_back(sent(each));
            }
            return !out.is_null();
        })) << request.dump();
        return out;
    }
    bool isGood(const Json& request) { return ask(request)["ok"] == true; }
    /// Builds the mirror and follows.
    void mirrorIt() {
        const Json program = ask({{"do", "program"}});
        driver::Built built = driver::build(readSources(program["sources"]));
        ASSERT_TRUE(built.program);
        ASSERT_EQ(layoutSum(*built.program), numberAt(program, "layout"));
        version = numberAt(program, "version");
        if (mirror)
            session::Mirror(*mirror).programChanged(std::move(built));
        else
            mirror = session::Mirror::open(std::move(built), {}, sink);
        reader = ScanReader(mirror->program());
        ASSERT_TRUE(isGood({{"do", "follow"}}));
    }
    /// What has come since, into the mirror.
    void feed(size_t most = 1 << 18) {
        session::Mirror into(*mirror);
        for (const Json& each : door->due()) news.push_back(sent(each));
        for (const Json& each : std::exchange(news, {})) {
            if (textAt(each, "event") == "state") into.told(readState(each["state"], mirror->built()));
            if (textAt(each, "event") == "happened") into.happened(readEvent(each["what"]));
        }
        const std::string bytes = door->bytes(most);
        if (bytes.empty()) return;
        std::string_view view = std::string_view(bytes).substr(1);
        uint64_t of = 0, isHalted = 0;
        ASSERT_TRUE(takeNumber(view, of));
        if (of != version) return;
        if (static_cast<Piece>(bytes[0]) == Piece::Standing) {
            ASSERT_TRUE(takeNumber(view, isHalted));
            return into.stands(std::as_bytes(std::span(view)), isHalted != 0);
        }
        ASSERT_TRUE(reader.read(
            view, [&](const StreamedScan& scan) { into.scanned(scan.image, scan.scan, scan.time, scan.outside); }));
    }
    bool fedUntil(const std::function<bool()>& condition) {
        return eventually([&] {
            feed();
            return condition();
        });
    }
    double mirrored(const char* path) {
        session::Snapshot now;
        mirror->latest(now);
        const auto expression = mirror->expression(path);
        if (!expression || now.image.empty()) return 0;
        const expression::Outcome outcome = expression->evaluate(now.image);
        return outcome.hasValue() ? outcome.value.real() : 0;
    }
    std::unique_ptr<session::Session> plant, mirror;
    std::unique_ptr<Door> door;
    std::shared_ptr<Sink> sink = std::make_shared<Sink>();
    std::vector<Json> news;
    ScanReader reader;
    uint64_t version = 0;
};

TEST_F(DoorTest, ReadsWritesForcesAndReleases) {
    EXPECT_EQ(ask({{"do", "list"}, {"filter", "SPEED"}})["variables"].dump(), R"([["Main.speed","REAL"]])");
    EXPECT_TRUE(isGood({{"do", "write"}, {"values", pairs({{"Main.speed", "2.25"}, {"Main.text", "'on'"}})}}));
    const Json values = ask({{"do", "read"}, {"watch", {"Main.speed * 2", "Main.text", "Main.none"}}})["values"];
    EXPECT_EQ(values[0]["value"], "4.5");
    EXPECT_EQ(values[1]["value"], "'on'");
    EXPECT_TRUE(values[2].contains("reason"));
    EXPECT_TRUE(isGood({{"do", "force"}, {"values", pairs({{"Main.lamp", "TRUE"}})}}));
    EXPECT_TRUE(eventually([&] { return plant->forces().size() == 1; }));
    EXPECT_NE(ask({{"do", "write"}, {"values", pairs({{"Main.lamp", "FALSE"}})}})["error"].dump().find("is forced"),
              std::string::npos);
    EXPECT_TRUE(isGood({{"do", "unforce"}, {"path", "main.LAMP"}}));
    EXPECT_TRUE(eventually([&] { return plant->forces().empty(); }));
}

TEST_F(DoorTest, WhatIsWrongIsAnsweredAndChangesNothing) {
    for (const Json& wrong :
         {Json{{"do", "write"}, {"values", pairs({{"Main.speed", "many"}})}},
          Json{{"do", "write"}, {"values", pairs({{"Main.none", "1"}})}}, Json{{"do", "write"}},
          Json{{"do", "force"}, {"values", 7}}, Json{{"do", "press"}, {"values", Json::array()}},
          Json{{"do", "unforce"}, {"path", "Main.speed"}}, Json{{"do", "reset"}, {"kind", "sideways"}},
          Json{{"do", "breakpoints"}, {"places", Json::array({Json{{"file", "none.st"}}})}}, Json{{"do", "dance"}},
          Json{{"do", 7}}, Json::object()}) {
        const Json answer = ask(wrong);
        EXPECT_EQ(answer["ok"], false) << wrong.dump();
        EXPECT_FALSE(textAt(answer, "error").empty()) << wrong.dump();
    }
    EXPECT_TRUE(plant->forces().empty());
    EXPECT_EQ(plant->status().state, controller::State::Running);
}

TEST_F(DoorTest, TheMirrorRecordsTheSameScansBitForBit) {
    mirrorIt();
    ASSERT_TRUE(fedUntil([&] { return mirror->history().statistics().scans > 100; }));
    const history::Statistics here = mirror->history().statistics();
    for (history::Position at = here.first; at < here.end; ++at) {
        const auto stamp = mirror->history().stamp(at);
        const auto there = plant->history().positionOfScan(stamp->scan);
        ASSERT_TRUE(there);
        EXPECT_EQ(plant->history().seek(*there), mirror->history().seek(at)) << "scan " << stamp->scan;
        EXPECT_EQ(plant->history().stamp(*there)->time, stamp->time);
    }
    EXPECT_EQ(mirror->status().state, controller::State::Running);
    EXPECT_FALSE(mirror->taskStatistics().empty());
}

/// Every scan of the mirror can be made again there, with the same notes of who acted as the controller has.
void expectTheSameJournal(const history::History& mirror, const history::History& plant) {
    inside::Rerunner again(mirror);
    const history::Statistics here = mirror.statistics();
    for (history::Position at = here.first; at < here.end; ++at) {
        const auto rerun = again.run(at);
        ASSERT_TRUE(rerun) << at << ": " << rerun.error().english();
        const uint64_t scan = rerun->input.stamp.scan;
        EXPECT_TRUE(rerun->input.hasJournal) << "scan " << scan;
        ASSERT_TRUE(rerun->isExact()) << "scan " << scan << " at " << rerun->differences[0].path;
        const auto there = plant.positionOfScan(scan);
        ASSERT_TRUE(there);
        const auto original = plant.inputOf(*there);
        ASSERT_TRUE(original) << original.error().english();
        EXPECT_EQ(original->notes, rerun->input.notes) << "scan " << scan;
        EXPECT_EQ(original->start.forces, rerun->input.start.forces) << "scan " << scan;
    }
}

TEST_F(DoorTest, TheMirrorKnowsWhatActedOnEachScan) {
    EXPECT_TRUE(isGood({{"do", "force"}, {"values", pairs({{"Main.lamp", "TRUE"}})}})) << "before anybody follows";
    mirrorIt();
    const auto more = [&](history::Position scans) {
        const history::Position end = mirror->history().statistics().end + scans;
        ASSERT_TRUE(fedUntil([&] { return mirror->history().statistics().end >= end; }));
    };
    more(20);
    const auto seen = [&] {
        std::set<image::OutsideKind> kinds;
        std::set<std::string> origins;
        mirror->history().forEachJournal(0, mirror->history().statistics().end,
                                         [&](history::Position, const history::JournalEntry& entry) {
                                             for (const image::OutsideNote& note : entry.notes)
                                                 origins.insert(note.origin), kinds.insert(note.kind);
                                             return true;
                                         });
        EXPECT_TRUE(origins.empty() || origins.contains("test")) << "who it was";
        return kinds;
    };
    using enum image::OutsideKind;
    // Where a machine takes a second until the mirror reads, what acted meanwhile is left out: done again then.
    for (int tries = 0; tries < 20 && !std::ranges::includes(seen(), std::set{Write, Force, Release, Stopped, Started});
         ++tries) {
        EXPECT_TRUE(isGood({{"do", "write"}, {"values", pairs({{"Main.speed", "9"}})}}));
        EXPECT_TRUE(isGood({{"do", "force"}, {"values", pairs({{"Main.lamp", "TRUE"}})}}));
        EXPECT_TRUE(isGood({{"do", "force"}, {"values", pairs({{"Main.text", "'held'"}})}}));
        EXPECT_TRUE(isGood({{"do", "unforce"}, {"path", "Main.lamp"}}));
        more(20);
        EXPECT_TRUE(isGood({{"do", "stop"}}));
        EXPECT_TRUE(isGood({{"do", "write"}, {"values", pairs({{"Main.n", "5"}})}}));
        EXPECT_TRUE(isGood({{"do", "start"}}));
        more(20);
    }
    for (const auto kind : {Write, Force, Release, Stopped, Started})
        EXPECT_TRUE(seen().contains(kind)) << static_cast<int>(kind);
    // Somebody reads too slowly: scans are left out, with what acted on them.
    const uint64_t late = plant->status().scans + 400;
    EXPECT_TRUE(isGood({{"do", "write"}, {"values", pairs({{"Main.speed", "11"}})}}));
    ASSERT_TRUE(eventually([&] { return plant->status().scans > late; }));
    const uint64_t before = mirror->status().scans;
    feed(40); // one scan, the others are too old by then
    feed();
    EXPECT_GT(mirror->status().scans, before + 2);
    more(20);
    expectTheSameJournal(mirror->history(), plant->history());
}

TEST_F(DoorTest, TheMirrorKnowsWhatActedAtABreakpoint) {
    mirrorIt();
    EXPECT_TRUE(isGood({{"do", "breakpoints"}, {"places", Json::array({Json{{"file", "main.st"}, {"line", 5u}}})}}));
    ASSERT_TRUE(fedUntil([&] { return mirror->status().state == controller::State::Halted; }));
    EXPECT_TRUE(isGood({{"do", "write"}, {"values", pairs({{"Main.n", "1000"}})}}));
    EXPECT_TRUE(isGood({{"do", "breakpoints"}, {"places", Json::array()}}));
    EXPECT_TRUE(isGood({{"do", "go"}, {"how", "on"}}));
    const history::Position end = mirror->history().statistics().end + 20;
    ASSERT_TRUE(fedUntil([&] { return mirror->history().statistics().end >= end; }));
    EXPECT_GT(mirrored("DINT_TO_REAL(Main.n)"), 1000);
    expectTheSameJournal(mirror->history(), plant->history());
}

TEST_F(DoorTest, WhatIsWrittenWhileItStandsIsSeen) {
    mirrorIt();
    EXPECT_TRUE(isGood({{"do", "stop"}}));
    EXPECT_TRUE(fedUntil([&] { return mirror->status().state == controller::State::Stopped; }));
    EXPECT_TRUE(isGood({{"do", "write"}, {"values", pairs({{"Main.speed", "9"}})}}));
    EXPECT_TRUE(fedUntil([&] { return mirrored("Main.speed") == 9; }));
    EXPECT_TRUE(isGood({{"do", "start"}}));
    EXPECT_TRUE(fedUntil([&] { return mirror->status().state == controller::State::Running; }));
}

TEST_F(DoorTest, BreakpointsShowFramesAndLocalsAndNeverOutliveTheDoor) {
    mirrorIt();
    EXPECT_TRUE(isGood({{"do", "breakpoints"}, {"places", Json::array({Json{{"file", "main.st"}, {"line", 4u}}})}}));
    ASSERT_TRUE(fedUntil([&] { return mirror->status().state == controller::State::Halted; }));
    ASSERT_TRUE(fedUntil([&] { return !mirror->haltFrames().empty(); }));
    EXPECT_EQ(mirror->haltFrames().front().function, "Main");
    EXPECT_TRUE(fedUntil([&] { return !mirror->frameVariables(0).empty(); })) << "the image with its frames came";
    EXPECT_TRUE(isGood({{"do", "go"}, {"how", "over"}}));
    EXPECT_TRUE(fedUntil([&] { return mirror->status().halts >= 2; }));
    door.reset(); // the line is cut
    const uint64_t scans = plant->status().scans;
    EXPECT_TRUE(eventually([&] { return plant->status().scans > scans + 20; })) << "no breakpoint is left";
}

TEST_F(DoorTest, BreakpointsAreRefusedWhereTheyAreNotAllowed) {
    open({.mayHalt = false});
    for (const Json& request :
         {Json{{"do", "breakpoints"}, {"places", Json::array()}}, Json{{"do", "go"}, {"how", "in"}}})
        EXPECT_NE(textAt(ask(request), "error").find("--allow-breakpoints"), std::string::npos);
}

TEST_F(DoorTest, AnotherProgramEntersAndTheMirrorFollows) {
    mirrorIt();
    driver::BuildInput next = *mirror->built().input;
    const size_t at = next.files[0].text.find("n := n + 1;");
    next.files[0].text.replace(at, 11, "n := n + 1000;");
    const Json changed = ask({{"do", "change"}, {"sources", sourcesJson(next)}});
    EXPECT_EQ(changed["ok"], true) << changed.dump();
    EXPECT_GT(numberAt(changed, "kept"), 0u);
    next.files[0].text += "nonsense";
    EXPECT_NE(textAt(ask({{"do", "change"}, {"sources", sourcesJson(next)}}), "error").find("1 error"),
              std::string::npos);
    EXPECT_NE(plant->program()->version, version);
    mirrorIt();
    const history::Position end = mirror->history().statistics().end;
    EXPECT_TRUE(fedUntil([&] { return mirror->history().statistics().end > end + 20; }));
}

TEST_F(DoorTest, ValuesEnterWithAnotherProgramBeforeItsFirstScan) {
    driver::BuildInput next = *plant->built().input;
    const size_t at = next.files[0].text.find("n := n + 1;");
    next.files[0].text.replace(at, 11, "n := n + 1; IF first < 0.0 THEN first := speed; END_IF");
    next.files[0].text.replace(next.files[0].text.find("VAR speed"), 3, "VAR first : REAL := -1.0;");
    EXPECT_NE(textAt(ask({{"do", "change"}, {"sources", sourcesJson(next)}, {"values", pairs({{"Main.gone", "1"}})}}),
                     "error"),
              "");
    const Json request{{"do", "change"}, {"sources", sourcesJson(next)}, {"values", pairs({{"Main.speed", "7.25"}})}};
    EXPECT_EQ(ask(request)["ok"], true);
    const auto first = [&] { return ask({{"do", "read"}, {"watch", {"Main.first"}}}).dump(); };
    EXPECT_TRUE(eventually([&] { return first().find("-1.0") == std::string::npos; }));
    EXPECT_NE(first().find("7.25"), std::string::npos) << first();
}

TEST_F(DoorTest, OrdersToTheMirrorGoOutAndNothingRunsHere) {
    mirrorIt();
    EXPECT_TRUE(mirror->isMirror());
    mirror->write("Main.speed", types::Value{}, "x");
    mirror->stop();
    mirror->unforceAll();
    mirror->startThread({session::Pace::Real});
    ASSERT_EQ(sink->all.size(), 4u);
    EXPECT_EQ(sink->all[0].kind, session::OrderKind::Write);
    EXPECT_EQ(sink->all[1].kind, session::OrderKind::Stop);
    EXPECT_EQ(sink->all[3].kind, session::OrderKind::Start);
    EXPECT_FALSE(mirror->resumeFrom(0)) << "a plant is not put back in time";
}

TEST_F(DoorTest, TheRecordingComesInPiecesAndWhole) {
    const uint64_t size = numberAt(ask({{"do", "recording"}}), "bytes");
    ASSERT_GT(size, 0u);
    uint64_t got = 0;
    while (got < size) {
        const std::string piece = door->bytes(1000);
        ASSERT_FALSE(piece.empty());
        EXPECT_EQ(static_cast<Piece>(piece[0]), Piece::Recording);
        got += piece.size() - 1;
    }
    EXPECT_EQ(got, size);
}

std::shared_ptr<const image::CompiledProgram> programOf(uint32_t size) {
    auto program = std::make_shared<image::CompiledProgram>();
    program->layout.dataEnd = program->layout.imageSize = size;
    program->initialImage.resize(size);
    return program;
}

/// A journal entry with one of everything.
history::JournalEntry someEntry() {
    history::JournalEntry entry;
    entry.start.emplace();
    entry.start->forces.push_back({40, 2, -1, "Main.x", {std::byte(1), std::byte(2)}});
    image::OutsideNote note;
    note.offset = 96;
    note.size = 4;
    note.site = 3;
    note.bytes.resize(4);
    note.origin = "studio";
    entry.notes.push_back(note);
    entry.patch.push_back({990, std::vector<std::byte>(10)});
    return entry;
}

/// Whether a scan with that entry is read.
bool isRead(const history::JournalEntry& entry) {
    std::vector<std::byte> image(1000);
    std::string bytes;
    ScanWriter().write(bytes, {1, {}, image}, history::toBytes(entry));
    bool acted = false;
    return ScanReader(programOf(1000)).read(bytes, [&](const StreamedScan& scan) { acted = scan.outside; }) && acted;
}

TEST(ScanStream, AJournalThatReachesOutOfTheImageIsRefused) {
    EXPECT_TRUE(isRead(someEntry()));
    for (const auto& spoil : std::vector<std::function<void(history::JournalEntry&)>>{
             [](auto& entry) { entry.patch[0].offset = 991; }, [](auto& entry) { entry.patch[0].offset = ~0u; },
             [](auto& entry) { entry.start->forces[0].offset = 999; },
             [](auto& entry) { entry.start->forces[0].bit = 9; },
             [](auto& entry) { entry.start->forces[0].bytes = {}; }, [](auto& entry) { entry.notes[0].offset = 997; },
             [](auto& entry) { entry.notes[0].size = 8; }, [](auto& entry) { entry.notes[0].bit = -2; },
             [](auto& entry) { entry.start.reset(); }}) {
        history::JournalEntry entry = someEntry();
        spoil(entry);
        EXPECT_FALSE(isRead(entry));
    }
}

TEST(ScanStream, WhatIsWrittenIsReadAndNonsenseIsRefused) {
    std::mt19937 random(7);
    const auto program = programOf(1000);
    std::vector<std::byte> image(1000);
    ScanWriter writer;
    std::vector<std::vector<std::byte>> all;
    std::string bytes;
    for (uint64_t scan = 0; scan < 200; ++scan) {
        for (int i = 0; i < 5; ++i) image[random() % image.size()] = std::byte(random());
        all.push_back(image);
        const bool acts = scan % 3 == 1;
        writer.write(bytes, {scan, std::chrono::nanoseconds(scan * 1000), image},
                     acts ? history::toBytes(someEntry()) : std::vector<std::byte>());
    }
    ScanReader reader(program);
    size_t count = 0;
    EXPECT_TRUE(reader.read(bytes, [&](const StreamedScan& scan) {
        EXPECT_EQ(scan.scan, count);
        EXPECT_EQ(scan.outside != nullptr, count % 3 == 1);
        EXPECT_TRUE(std::equal(scan.image.begin(), scan.image.end(), all[count].begin(), all[count].end()));
        ++count;
    }));
    EXPECT_EQ(count, all.size());
    for (int round = 0; round < 20'000; ++round) { // no byte outside is touched: the sanitizers watch
        std::string bad = bytes.substr(0, random() % 400);
        for (int i = 0; i < 4 && !bad.empty(); ++i) bad[random() % bad.size()] = static_cast<char>(random());
        ScanReader other(program);
        (void)other.read(bad, [](const StreamedScan&) {});
    }
    ScanReader smaller(programOf(100));
    EXPECT_FALSE(smaller.read(bytes, [](const StreamedScan&) {}));
}

} // namespace
} // namespace plc::remote
