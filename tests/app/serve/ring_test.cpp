// The recording on disk: complete at every moment, bounded in size, oldest first.
#include "app/serve/recording_ring.h"
#include "chromium.h"
#include "served.h"
#include "tests/support/patience.h"

#include <QTemporaryDir>

#include <fstream>
#include <iostream>

namespace plc::serve {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCounter = R"(
PROGRAM Main
VAR n : DINT; values : ARRAY[0..63] OF DINT; i : INT; END_VAR
n := n + 1;
FOR i := 0 TO 63 DO values[i] := n * (i + 7919); END_FOR;
END_PROGRAM
CONFIGURATION C RESOURCE R ON PLC
    TASK T(INTERVAL := T#1ms, PRIORITY := 1);
    PROGRAM Main WITH T : Main;
END_RESOURCE END_CONFIGURATION
)";

driver::Built builtCounter() {
    driver::BuildInput input;
    input.files.push_back({"main.st", kCounter});
    return driver::build(input);
}

uint64_t sizeOf(const QString& folder) {
    uint64_t bytes = 0;
    for (const auto& entry : fs::directory_iterator(folder.toStdString()))
        if (entry.is_regular_file()) bytes += entry.file_size();
    return bytes;
}

std::vector<fs::path> recordings(const QString& folder) {
    std::vector<fs::path> out;
    for (const auto& entry : fs::directory_iterator(folder.toStdString()))
        if (entry.path().extension() == ".rec") out.push_back(entry.path());
    std::sort(out.begin(), out.end());
    return out;
}

/// The recorded scans of a file, in order; the program is built from what the file holds.
std::pair<history::Position, history::Position> scansOf(const fs::path& file) {
    driver::Built built;
    const auto loaded = history::History::load(file.string(), [&](const history::History::Sources& sources) {
        driver::BuildInput input;
        for (const auto& [name, text] : sources.files) input.files.push_back({name, text});
        built = driver::build(input);
        return built.program;
    });
    EXPECT_TRUE(loaded) << (loaded ? "" : loaded.error().english());
    if (!loaded) return {};
    const history::Statistics statistics = (*loaded)->statistics();
    return {statistics.first, statistics.end};
}

TEST(RecordingRing, FilesFollowOneAnotherWithoutGapAndStayWithinTheirSize) {
    const QTemporaryDir folder;
    session::Settings settings;
    settings.historyBudget = size_t(8) << 20;
    session::Session session(builtCounter(), settings);
    const uint64_t limit = uint64_t(2) << 20;
    {
        RecordingRing ring(session,
                           {folder.path().toStdString(), limit, uint64_t(128) << 10, std::chrono::milliseconds(20)});
        session.startThread({session::Pace::Factor, 3});
        ASSERT_TRUE(
            waitUntil([&] { return recordings(folder.path()).size() > 3 && ring.figures().bytes > limit / 2; }));
        const history::Position before = session.history().statistics().end;
        ASSERT_TRUE(waitUntil([&] { return session.history().statistics().end > before + 9'000; }));
        EXPECT_TRUE(ring.figures().problem.empty()) << ring.figures().problem;
        session.end();
    }
    const auto files = recordings(folder.path());
    ASSERT_FALSE(files.empty()); // a busy machine makes fewer and longer ones
    EXPECT_LE(sizeOf(folder.path()), limit + (uint64_t(1) << 20));
    history::Position end = 0;
    for (const fs::path& file : files) {
        const auto [first, last] = scansOf(file);
        EXPECT_LT(first, last) << file;
        EXPECT_TRUE(end == 0 || first <= end) << file << ": a gap";
        end = last;
    }
    EXPECT_EQ(end, session.history().statistics().end) << "the last scan is there";
}

/// What the process holds in memory.
uint64_t residentBytes() {
    uint64_t all = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> all >> resident;
    return resident * 4096;
}

/// A day of scans of 10 ms as fast as the machine makes them: memory and disk stay within what they may take, whatever
/// is on disk opens, the newest scan is there.
TEST(RecordingRing, ADayInTestTimeStaysWithinItsLimits) {
    const QTemporaryDir folder;
    driver::BuildInput input;
    input.files.push_back({"main.st",
                           "PROGRAM Main VAR RETAIN n : DINT; END_VAR n := n + 1; END_PROGRAM CONFIGURATION C "
                           "RESOURCE R ON PLC TASK T(INTERVAL := T#10ms, PRIORITY := 1); PROGRAM Main WITH T "
                           ": Main; END_RESOURCE END_CONFIGURATION"});
    session::Settings settings;
    settings.historyBudget = size_t(8) << 20;
    settings.retainFile = (folder.path() + "/retained").toStdString();
    const uint64_t limit = uint64_t(4) << 20;
    const QString recording = folder.path() + "/recording";
    fs::create_directories(recording.toStdString());
    session::Session session(driver::build(input), settings);
    constexpr uint64_t kDay = 24 * 3600 * 100;
    {
        RecordingRing ring(session, {recording.toStdString(), limit, limit / 8, std::chrono::milliseconds(50)});
        session.startThread({session::Pace::Fastest});
        ASSERT_TRUE(waitUntil([&] { return session.status().scans >= kDay / 4; }, 10 * kPatience));
        const uint64_t before = residentBytes();
        ASSERT_TRUE(waitUntil([&] { return session.status().scans >= kDay; }, 10 * kPatience));
        const uint64_t after = residentBytes();
        std::cout << "resident after six hours " << (before >> 10) << " kB, after the day " << (after >> 10) << " kB\n";
        EXPECT_LE(after, before + (uint64_t(16) << 20)) << "memory grows";
        EXPECT_LE(session.history().statistics().bytes, settings.historyBudget * 5 / 4);
        EXPECT_TRUE(ring.figures().problem.empty()) << ring.figures().problem;
        session.end();
    }
    EXPECT_LE(sizeOf(recording), limit + (uint64_t(8) << 20)) << "the file that is written may be one whole memory";
    history::Position end = 0;
    for (const fs::path& file : recordings(recording)) end = std::max(end, scansOf(file).second);
    EXPECT_EQ(end, session.history().statistics().end);
    settings.record = false;
    session::Session after(driver::build(input), settings);
    const auto n = after.controller().read("Main.n");
    ASSERT_TRUE(n);
    EXPECT_EQ(static_cast<uint64_t>(std::get<int64_t>(n->data)), session.status().scans);
}

TEST(RecordingRing, ANewStartGoesOnWithTheNextNumber) {
    const QTemporaryDir folder;
    for (int start = 0; start < 2; ++start) {
        session::Session session(builtCounter());
        RecordingRing ring(session, {folder.path().toStdString()});
        session.runHere([](const controller::Controller& c) { return c.lastTime() >= std::chrono::milliseconds(50); });
    }
    EXPECT_EQ(recordings(folder.path()).size(), 2u);
}

TEST(RecordingRing, TheWorstScansOfEarlierStartsGoWhenThereAreTooMany) {
    const QTemporaryDir folder;
    const fs::path worst = fs::path(folder.path().toStdString()) / "worst";
    fs::create_directories(worst);
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(100);
    const auto nameOf = [&](int i) { return worst / ("1-scan-" + std::to_string(1000 + i) + ".rec"); };
    for (int i = 0; i < 40; ++i) {
        std::ofstream(nameOf(i)) << "old";
        fs::last_write_time(nameOf(i), old + std::chrono::minutes(i));
    }
    std::ofstream(worst / "notes.txt") << "of a person";
    std::ofstream(fs::path(folder.path().toStdString()) / "00000001.rec") << "an earlier start";
    session::Session session(builtCounter());
    session.startThread({session::Pace::Real});
    RecordingRing ring(session, {folder.path().toStdString(), 1 << 20, 1 << 16, std::chrono::milliseconds(20), 30});
    ASSERT_TRUE(waitUntil([&] { return recordings(QString::fromStdString(worst.string())).size() <= 30; }));
    EXPECT_FALSE(fs::exists(nameOf(0))) << "the oldest first";
    EXPECT_TRUE(fs::exists(nameOf(39)));
    EXPECT_TRUE(fs::exists(worst / "notes.txt"));
    EXPECT_TRUE(waitUntil([&] {
        const auto kept = recordings(QString::fromStdString(worst.string()));
        return std::any_of(kept.begin(), kept.end(),
                           [](const fs::path& each) { return each.filename().string().starts_with("2-scan-"); });
    }));
}

TEST(RecordingRing, AFullDiskIsReportedAndCostsNoScan) {
    session::Session session(builtCounter());
    session.startThread({session::Pace::Real});
    RecordingRing ring(session, {"/proc/no such folder", 1 << 20, 1 << 16, std::chrono::milliseconds(20)});
    EXPECT_TRUE(waitUntil([&] { return !ring.figures().problem.empty(); }));
    const uint64_t scans = session.status().scans;
    EXPECT_TRUE(waitUntil([&] { return session.status().scans > scans + 100; }));
}

} // namespace
} // namespace plc::serve
