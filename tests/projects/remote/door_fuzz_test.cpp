// What nobody of ours would send to a door, by the thousand: requests with words, members and values of any kind,
// answers and states as a mirror would read them from a hostile server. Nothing may crash or hang. Ten million with
// STEPWISE_LONG; STEPWISE_SEED repeats a run.
#include "projects/remote/door.h"

#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <random>

namespace plc::remote {
namespace {

constexpr const char* kPlant = R"(PROGRAM Main
VAR RETAIN n : DINT; END_VAR
VAR speed : REAL; lamp : BOOL; text : STRING(20); list : ARRAY[1..4] OF INT; END_VAR
n := n + 1;
END_PROGRAM
)";

constexpr const char* kWishes[] = {
    "state",   "list",        "read",  "follow", "write", "write_together", "press", "release",          "force",
    "unforce", "unforce_all", "start", "pause",  "scan",  "stop",           "reset", "reset_statistics", "breakpoints",
    "go",      "nonsense",    ""};
constexpr const char* kMembers[] = {"id",   "path", "paths", "value", "values", "text",        "pressed", "released",
                                    "kind", "how",  "file",  "line",  "all",    "breakpoints", "which",   "do"};
constexpr const char* kTexts[] = {
    "Main.n", "Main.list[2]", "Main.list[9]", "main.SPEED", "TRUE",       "1.5",  "'x'",  "",
    "warm",   "origin",       "over",         "main.st",    "Main.n > 3", "((((", "\xff", "99999999999999"};

template <size_t N> const char* pick(std::mt19937_64& roll, const char* const (&from)[N]) { return from[roll() % N]; }

Json anything(std::mt19937_64& roll, int depth) {
    switch (roll() % (depth > 3 ? 6 : 8)) {
    case 0:
        return nullptr;
    case 1:
        return roll() % 2 == 0;
    case 2:
        return roll();
    case 3:
        return -static_cast<int64_t>(roll() % 1000);
    case 4:
        return 1e300 * static_cast<double>(roll());
    case 6: {
        Json out = Json::array();
        for (size_t i = roll() % 4; i > 0; --i) out.push_back(anything(roll, depth + 1));
        return out;
    }
    case 7: {
        Json out = Json::object();
        for (size_t i = roll() % 4; i > 0; --i) out[pick(roll, kMembers)] = anything(roll, depth + 1);
        return out;
    }
    default:
        return pick(roll, kTexts);
    }
}

std::mt19937_64 dice() {
    const char* const text = std::getenv("STEPWISE_SEED");
    const uint64_t seed = text ? std::strtoull(text, nullptr, 10) : std::random_device()();
    std::cout << "seed " << seed << "\n";
    return std::mt19937_64(seed);
}

size_t rounds(size_t usual, size_t atLength) { return std::getenv("STEPWISE_LONG") ? atLength : usual; }

driver::Built builtPlant() {
    driver::BuildInput input;
    input.files.push_back({"main.st", kPlant});
    return driver::build(input);
}

TEST(DoorFuzz, AnyRequestIsAnsweredOrRefused) {
    std::mt19937_64 roll = dice();
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    session::Session plant(builtPlant());
    plant.startThread({session::Pace::Real});
    Door door(plant, "stranger", {.mayHalt = true});
    const size_t count = rounds(10'000, 10'000'000);
    size_t answered = 0, good = 0, bytes = 0;
    for (size_t i = 0; i < count; ++i) {
        Json request = roll() % 16 == 0 ? anything(roll, 0) : Json::object();
        if (request.is_object()) {
            request["do"] = pick(roll, kWishes);
            if (roll() % 8 != 0) request["id"] = i;
            for (size_t members = roll() % 4; members > 0; --members) request[pick(roll, kMembers)] = anything(roll, 0);
        }
        if (const auto answer = door.answer(request)) {
            ++answered;
            good += answer->contains("ok") && (*answer)["ok"] == true;
        }
        if (i % 64 != 0) continue;
        answered += door.due().size();
        bytes += door.bytes(1 << 16).size();
    }
    std::cout << count << " requests, " << answered << " answers and news, " << good << " of them good, " << bytes
              << " bytes of scans\n";
    EXPECT_GT(answered, count / 4);
    EXPECT_GT(good, 0u);
    // It still does what it is for.
    plant.reset(controller::ResetKind::Warm);
    const auto state = door.answer({{"do", "state"}, {"id", 1}});
    ASSERT_TRUE(state);
    EXPECT_EQ((*state)["ok"], true) << state->dump();
}

TEST(DoorFuzz, AnyStateAndAnyScansAreReadOrRefused) {
    std::mt19937_64 roll = dice();
    const driver::Built built = builtPlant();
    const std::string sound = R"({"state": "running", "scans": 7, "time": 1000, "load": 0.5, "tasks": [{"name": "T"}],
        "forces": [["Main.n", "3"]], "fault": {"code": 1, "task": "T", "frames": [{"path": "Main", "line": 3}]}})";
    std::string stream;
    ScanWriter writer;
    std::vector<std::byte> image(built.program->layout.imageSize);
    for (uint64_t scan = 0; scan < 4; ++scan) {
        image[scan % image.size()] = std::byte(scan + 1);
        writer.write(stream, {scan, std::chrono::milliseconds(scan), image, nullptr});
    }
    const size_t count = rounds(20'000, 2'000'000);
    size_t scans = 0;
    for (size_t i = 0; i < count; ++i) {
        std::string text = sound, bytes = stream;
        for (size_t edits = roll() % 5; edits > 0; --edits) {
            text[roll() % text.size()] = "{}[],:\"0123456789.-e"[roll() % 19];
            bytes[roll() % std::min<size_t>(bytes.size(), 64)] = static_cast<char>(roll());
        }
        if (roll() % 4 == 0) bytes.resize(roll() % bytes.size());
        const Json json = Json::parse(text, nullptr, false);
        if (!json.is_discarded()) (void)readState(json, built);
        (void)readState(anything(roll, 0), built);
        (void)readEvent(anything(roll, 0));
        (void)readSources(anything(roll, 0));
        ScanReader reader(built.program);
        (void)reader.read(bytes, [&](const StreamedScan& scan) {
            ++scans;
            EXPECT_LE(scan.image.size(), image.size());
        });
    }
    EXPECT_GT(scans, count / 10);
}

} // namespace
} // namespace plc::remote
