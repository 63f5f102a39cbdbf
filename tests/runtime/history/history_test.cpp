#include "runtime/base/messages.h"
#include "runtime/expression/code.h"
#include "runtime/history/history.h"
#include "tests/runtime/hand_made_program.h"
#include "tests/support/repeats.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

namespace plc::history {
namespace {

using namespace std::chrono_literals;
using plc::testing::HandMade;
using types::TypeKind;
using types::TypeTable;

unsigned seed() {
    const char* given = std::getenv("STEPWISE_SEED");
    return given ? static_cast<unsigned>(std::atoi(given)) : std::random_device()();
}

/// A program with an INT array `data` of the given count and a DINT `extra`, 64 + … bytes.
std::shared_ptr<image::CompiledProgram> makeProgram(uint32_t words, bool hasExtra = true) {
    HandMade made;
    made.add("data", made.types().array({{0, int64_t(words) - 1}}, TypeTable::of(TypeKind::Dint)));
    if (hasExtra) made.add("extra", TypeKind::Lreal);
    return made.finish();
}

struct Stored {
    std::vector<std::byte> image; // data part
    uint64_t scan;
    int64_t time;
    std::shared_ptr<const image::CompiledProgram> program;
};

/// Makes images as a controller would: header, then random changes.
class Source {
public:
    Source(History& history, unsigned seedValue) : random(seedValue), m_history(history) {}
    void useProgram(std::shared_ptr<const image::CompiledProgram> program) {
        m_program = std::move(program);
        m_history.beginProgram(m_program);
        m_image.assign(m_program->layout.imageSize, std::byte{});
    }
    void goBackTo(Position position) {
        const Stored& stored = all.at(position);
        m_program = stored.program;
        m_history.beginProgram(m_program);
        m_history.beginBranch(position);
        m_image.assign(m_program->layout.imageSize, std::byte{});
        std::memcpy(m_image.data(), stored.image.data(), stored.image.size());
        m_time = stored.time + 1;
        m_scan = stored.scan + 1;
    }
    void scan(int changes, int64_t step) {
        m_time += step;
        for (int i = 0; i < changes; ++i) {
            const uint32_t at = 112 + static_cast<uint32_t>(random() % (m_program->layout.dataEnd - 112));
            m_image[at] = static_cast<std::byte>(random());
        }
        append();
    }
    void append() {
        image::ImageHeader header;
        header.timeNs = m_time;
        header.calendarNs = m_time + 1000;
        header.scan = m_scan;
        header.taskPeriodNs = m_scan % 3;
        header.firstScan = m_scan == 0;
        std::memcpy(m_image.data(), &header, sizeof header);
        m_image[m_program->layout.dataEnd] = std::byte(7); // the frame area is not recorded
        m_history.append(m_image, m_scan, Nanoseconds(m_time));
        const auto* begin = m_image.data();
        all.push_back({{begin, begin + m_program->layout.dataEnd}, m_scan, m_time, m_program});
        ++m_scan;
    }
    /// Something is written before the next scan.
    void actFromOutside(size_t bytes) {
        image::OutsideNote note;
        note.offset = 112;
        note.size = static_cast<uint32_t>(bytes);
        note.bytes.resize(bytes, std::byte(1));
        note.origin = std::to_string(m_scan);
        const image::ScanStart start;
        m_history.outsideActed({m_image, {}, start, {&note, 1}});
    }
    std::byte* data() { return m_image.data(); }
    std::mt19937 random;
    std::vector<Stored> all; // by position

private:
    History& m_history;
    std::shared_ptr<const image::CompiledProgram> m_program;
    std::vector<std::byte> m_image;
    int64_t m_time = -1'000'000;
    uint64_t m_scan = 0;
};

void expectSame(const History& history, const std::vector<Stored>& all, Position position) {
    std::shared_ptr<const image::CompiledProgram> program;
    const std::vector<std::byte> image = history.seek(position, &program);
    const Stored& stored = all.at(position);
    ASSERT_EQ(image.size(), stored.program->layout.imageSize) << "position " << position;
    ASSERT_TRUE(std::equal(stored.image.begin(), stored.image.end(), image.begin())) << "position " << position;
    ASSERT_EQ(program, stored.program);
    for (size_t i = stored.image.size(); i < image.size(); ++i) ASSERT_EQ(image[i], std::byte{}) << "frame area";
    const std::optional<ScanStamp> stamp = history.stamp(position);
    ASSERT_TRUE(stamp);
    ASSERT_EQ(stamp->scan, stored.scan);
    ASSERT_EQ(stamp->time.count(), stored.time);
}

TEST(History, SeekGivesBackEveryImageOfRandomRuns) {
    const unsigned start = seed();
    for (unsigned run = 0; run < 12; ++run) {
        SCOPED_TRACE("seed " + std::to_string(start) + " run " + std::to_string(run) + " (STEPWISE_SEED sets it)");
        std::mt19937 dice(start + run);
        History history(run % 3 == 0 ? size_t(1) << 20 : size_t(64) << 20);
        Source source(history, start + run);
        source.useProgram(makeProgram(1 + dice() % (run % 2 ? 40 : 4000)));
        for (int i = 0; i < 3000; ++i) {
            if (dice() % 700 == 0) source.useProgram(makeProgram(1 + dice() % 300));
            if (dice() % 700 == 0 && i > 0 && source.all.size() > 10)
                source.goBackTo(source.all.size() - 1 - dice() % 10);
            const int changes = dice() % 4 == 0 ? 0 : static_cast<int>(dice() % (dice() % 20 == 0 ? 3000 : 10));
            source.scan(changes, 1'000'000 + (dice() % 50 == 0 ? 500'000 : 0));
        }
        const Statistics statistics = history.statistics();
        EXPECT_EQ(statistics.end, 3000u);
        EXPECT_GT(statistics.scans, 0u);
        if (statistics.first > 0) {
            EXPECT_TRUE(history.seek(statistics.first - 1).empty());
        }
        EXPECT_TRUE(history.seek(statistics.end).empty());
        for (Position p = statistics.first; p < statistics.end; p += 1 + dice() % 5) expectSame(history, source.all, p);
        expectSame(history, source.all, statistics.end - 1);
    }
}

TEST(History, StaysWithinItsBudgetAndEvictsTheOldestFirst) {
    History history(size_t(2) << 20);
    Source source(history, 1);
    source.useProgram(makeProgram(1000));
    size_t most = 0;
    for (int i = 0; i < 20'000; ++i) {
        source.scan(60, 1'000'000);
        most = std::max(most, history.statistics().bytes);
        if (source.all.size() > 4000) source.all[source.all.size() - 4000].image.clear();
    }
    const Statistics statistics = history.statistics();
    EXPECT_GT(statistics.first, 0u);
    EXPECT_LT(most, (size_t(2) << 20) + (size_t(1) << 18));
    EXPECT_GT(statistics.bytes, size_t(1) << 20);
    history.setBudget(size_t(1) << 20);
    source.scan(60, 1'000'000);
    EXPECT_LE(history.statistics().bytes, size_t(1) << 20);
    expectSame(history, source.all, history.statistics().end - 1);
}

TEST(History, WhatDoesNotChangeCostsNothing) {
    History history;
    Source source(history, 1);
    source.useProgram(makeProgram(1000));
    source.scan(1, 1'000'000);
    source.all.reserve(200'000);
    for (int i = 0; i < 60'000; ++i) {
        source.scan(0, 1'000'000);
        source.all.pop_back();
    }
    EXPECT_LT(history.statistics().bytes, size_t(1200) << 10); // the task period in the header changes
    EXPECT_EQ(history.stamp(50'000)->time, 50'000ms);
}

TEST(History, FindsPositionsOfTimesAndScansOnTheNewestBranch) {
    History history;
    Source source(history, 1);
    source.useProgram(makeProgram(10));
    for (int i = 0; i < 100; ++i) source.scan(2, i % 3 ? 10'000'000 : 5'000'000); // irregular
    source.goBackTo(49);
    for (int i = 0; i < 20; ++i) source.scan(2, 1'000'000);
    const int64_t split = source.all[49].time;
    EXPECT_EQ(history.positionAt(Nanoseconds(split)), 49u);
    EXPECT_EQ(history.positionAt(Nanoseconds(split - 1)), 48u);
    EXPECT_EQ(history.positionAt(Nanoseconds(source.all[100].time)), 100u); // first of the branch
    EXPECT_EQ(history.positionAt(Nanoseconds(INT64_MAX)), 119u);
    EXPECT_EQ(history.positionAt(Nanoseconds(source.all[0].time - 1)), std::nullopt);
    for (Position p = 0; p < 50; ++p) EXPECT_EQ(history.positionOfScan(source.all[p].scan), p);
    for (Position p = 100; p < 120; ++p) EXPECT_EQ(history.positionOfScan(source.all[p].scan), p);
    EXPECT_EQ(history.positionOfScan(5000), std::nullopt);
    ASSERT_EQ(history.branches().size(), 1u);
    EXPECT_EQ(history.branches()[0].first, 100u);
    EXPECT_EQ(history.branches()[0].parent, 49u);
}

TEST(History, AClockThatWentBackBeginsABranchWithoutParent) {
    History history;
    Source source(history, 1);
    source.useProgram(makeProgram(10));
    for (int i = 0; i < 10; ++i) source.scan(1, 1'000'000);
    source.scan(1, -5'000'000);
    ASSERT_EQ(history.branches().size(), 1u);
    EXPECT_EQ(history.branches()[0].parent, kNoParent);
    EXPECT_EQ(history.positionAt(0ns), std::nullopt);
}

// ---------------------------------------------------------------- queries, held against the stored images

expression::Expression variable(const image::CompiledProgram& program, const std::string& path) {
    const Result<image::Place> place = program.layout.find(path);
    if (!place) return {};
    expression::CodeBuilder builder;
    builder.load(*program.layout.types, *place);
    builder.setPlace(*place);
    return {path, program.layout.types, builder.finish(), place->type};
}
/// `path > limit`, or `path > limit` as one that could read anything.
expression::Expression above(const image::CompiledProgram& program, const std::string& path, int64_t limit,
                             bool readsAnything = false) {
    const Result<image::Place> place = program.layout.find(path);
    if (!place) return {};
    expression::CodeBuilder builder;
    builder.load(*program.layout.types, *place);
    builder.constant(*program.layout.types, types::Value{place->type, limit});
    builder.binary(*program.layout.types, library::BinaryOp::Greater, place->type);
    if (readsAnything) builder.readsAnything();
    return {path + ">", program.layout.types, builder.finish(), TypeTable::of(TypeKind::Bool)};
}

class Queries : public ::testing::Test {
protected:
    Queries() : history(size_t(3) << 19), source(history, start) {
        SCOPED_TRACE(start);
        a = makeProgram(200);
        b = makeProgram(64, false);
        source.useProgram(a);
        for (int i = 0; i < 6000; ++i) step(30);
        source.useProgram(b); // data[100] is gone, data[3] stays
        for (int i = 0; i < 200; ++i) step(5);
        source.useProgram(a);
        for (int i = 0; i < 300; ++i) step(30);
        source.goBackTo(6400);
        for (int i = 0; i < 300; ++i) step(30);
    }
    void step(int changes) {
        auto* data = reinterpret_cast<int32_t*>(source.data() + 112);
        if (source.random() % 3 == 0) data[3] = static_cast<int32_t>(source.random() % 100);
        if (source.random() % 40 == 0 && (source.all.empty() || source.all.back().program == a))
            data[150] = static_cast<int32_t>(source.random() % 100);
        source.scan(changes, 1'000'000);
        data[3] %= 100; // random bytes fell on it
    }
    std::optional<double> stored(Position p, const std::string& path) const {
        if (p < history.statistics().first) return std::nullopt;
        const Result<image::Place> place = source.all[p].program->layout.find(path);
        if (!place) return std::nullopt;
        return plc::testing::valueAt<int32_t>(source.all[p].image, place->offset);
    }
    std::optional<Position> before(Position p) const {
        if (p == 6500) return 6400;
        return p > history.statistics().first ? std::optional<Position>(p - 1) : std::nullopt;
    }
    const unsigned start = seed();
    History history;
    Source source;
    std::shared_ptr<image::CompiledProgram> a, b;
};

TEST_F(Queries, SeriesOfOneScanPerBucketIsExactAlsoOverAnOnlineChange) {
    const Statistics statistics = history.statistics();
    ASSERT_GT(statistics.first, 0u);
    for (const char* path : {"data[3]", "data[100]"}) {
        const Recompile recompile = [&](const image::CompiledProgram& program) { return variable(program, path); };
        const std::vector<Bucket> buckets = history.series(variable(*a, path), recompile, 0, statistics.end, 1'000'000);
        ASSERT_EQ(buckets.size(), statistics.end);
        const std::vector<Sample> samples = history.samples(variable(*a, path), recompile, 0, statistics.end);
        ASSERT_EQ(samples.size(), statistics.scans);
        for (Position p = 0; p < statistics.end; ++p) {
            const std::optional<double> expected = stored(p, path);
            ASSERT_EQ(buckets[p].begin, p);
            ASSERT_EQ(buckets[p].count, expected ? 1u : 0u) << path << " at " << p << " seed " << start;
            if (expected) {
                ASSERT_EQ(buckets[p].first, *expected) << path << " at " << p << " seed " << start;
            }
            if (p < statistics.first) continue;
            const Sample& sample = samples[p - statistics.first];
            ASSERT_EQ(sample.at.position, p);
            ASSERT_EQ(sample.at.time.count(), source.all[p].time);
            ASSERT_EQ(sample.hasValue, expected.has_value());
            if (expected) {
                ASSERT_EQ(sample.value, *expected);
            }
        }
    }
}

TEST_F(Queries, BucketsHoldFirstLeastGreatestAndLast) {
    const Position from = history.statistics().first + 11;
    const Position to = history.statistics().end - 5;
    const std::vector<Bucket> buckets = history.series(
        variable(*a, "data[3]"), [&](const image::CompiledProgram& p) { return variable(p, "data[3]"); }, from, to, 97);
    ASSERT_EQ(buckets.size(), 97u);
    for (size_t k = 0; k < buckets.size(); ++k) {
        const Position end = k + 1 < buckets.size() ? buckets[k + 1].begin : to;
        double low = 1e300, high = -1e300;
        for (Position p = buckets[k].begin; p < end; ++p) {
            low = std::min(low, *stored(p, "data[3]"));
            high = std::max(high, *stored(p, "data[3]"));
        }
        EXPECT_EQ(buckets[k].count, end - buckets[k].begin);
        EXPECT_EQ(buckets[k].first, *stored(buckets[k].begin, "data[3]"));
        EXPECT_EQ(buckets[k].last, *stored(end - 1, "data[3]"));
        EXPECT_TRUE(buckets[k].isNumber);
        EXPECT_EQ(buckets[k].minimum, low);
        EXPECT_EQ(buckets[k].maximum, high);
    }
}

TEST_F(Queries, FindGivesTheNextScanAtWhichAnExpressionBecomesTrueBothWays) {
    const Statistics statistics = history.statistics();
    for (const bool readsAnything : {false, true}) {
        for (const char* path : {"data[3]", "data[100]", "data[150]"}) {
            const auto isAbove = [&](Position p) { return stored(p, path).value_or(-1) > 50; };
            const auto rises = [&](Position p) {
                const std::optional<Position> previous = before(p);
                return previous && isAbove(p) && !isAbove(*previous);
            };
            const Recompile recompile = [&](const image::CompiledProgram& program) {
                return above(program, path, 50, readsAnything);
            };
            const expression::Expression expression = above(*a, path, 50, readsAnything);
            for (Position from = statistics.first; from < statistics.end; from += readsAnything ? 331 : 29) {
                std::optional<Position> next, previous;
                for (Position p = from + 1; p < statistics.end && !next; ++p)
                    if (rises(p)) next = p;
                for (Position p = from; p-- > statistics.first && !previous;)
                    if (rises(p)) previous = p;
                ASSERT_EQ(history.find(expression, recompile, from, History::Direction::Forward), next)
                    << path << " from " << from << " seed " << start;
                ASSERT_EQ(history.find(expression, recompile, from, History::Direction::Backward), previous)
                    << path << " from " << from << " seed " << start;
            }
        }
    }
}

TEST_F(Queries, FindChangeStopsWhereTheValueDiffersFromTheScanBefore) {
    const Statistics statistics = history.statistics();
    const char* path = "data[150]";
    const Recompile recompile = [&](const image::CompiledProgram& program) { return variable(program, path); };
    const auto changes = [&](Position p) {
        const std::optional<Position> previous = before(p);
        return previous && stored(p, path) != stored(*previous, path);
    };
    for (Position from = statistics.first; from < statistics.end; from += 53) {
        std::optional<Position> next, previous;
        for (Position p = from + 1; p < statistics.end && !next; ++p)
            if (changes(p)) next = p;
        for (Position p = from; p-- > statistics.first && !previous;)
            if (changes(p)) previous = p;
        ASSERT_EQ(history.findChange(variable(*a, path), recompile, from, History::Direction::Forward), next)
            << "from " << from << " seed " << start;
        ASSERT_EQ(history.findChange(variable(*a, path), recompile, from, History::Direction::Backward), previous)
            << "from " << from << " seed " << start;
    }
}

// ---------------------------------------------------------------- the file

class RecordingFile : public Queries {
protected:
    RecordingFile()
        : path((std::filesystem::temp_directory_path() / ("recording_" + std::to_string(::getpid()) + ".stwrec"))
                   .string()) {
        history.describeProgram(a, {{"main.st", "a"}}, {"toolbox"}, {{"toolbox/valves.st", "text"}});
        history.describeProgram(b, {{"main.st", "b"}}, {});
        history.mark(3, errors::Plainly(Verbatim("here")), 5ms);
    }
    ~RecordingFile() override { std::filesystem::remove(path); }
    std::shared_ptr<const image::CompiledProgram>
    rebuild(const std::vector<std::pair<std::string, std::string>>& sources) {
        return sources.at(0).second == "a" ? a : b;
    }
    Result<std::unique_ptr<History>> load() {
        return History::load(path, [&](const History::Sources& sources) {
            EXPECT_EQ(sources.libraries.size(), sources.files.at(0).second == "a" ? 1u : 0u);
            EXPECT_EQ(sources.libraryTexts.size(), sources.libraries.size());
            return rebuild(sources.files);
        });
    }
    std::string path;
};

TEST_F(RecordingFile, AnswersAsTheRecordingItWasSavedFrom) {
    ASSERT_TRUE(history.save(path));
    Result<std::unique_ptr<History>> loaded = load();
    ASSERT_TRUE(loaded) << loaded.error().english();
    const History& copy = **loaded;
    EXPECT_EQ(copy.statistics().first, history.statistics().first);
    EXPECT_EQ(copy.statistics().end, history.statistics().end);
    EXPECT_EQ(copy.branches().size(), 1u);
    ASSERT_EQ(copy.marks().size(), 1u);
    EXPECT_EQ(copy.marks()[0].text, errors::Plainly(Verbatim("here")));
    for (Position p = copy.statistics().first; p < copy.statistics().end; p += 3) expectSame(copy, source.all, p);
    // and can be continued
    source.useProgram(a);
    Source more(**loaded, 5);
    more.useProgram(a);
    more.scan(3, 1'000'000);
    EXPECT_EQ((*loaded)->statistics().end, copy.statistics().end);
    EXPECT_FALSE((*loaded)->seek(history.statistics().end).empty());
}

TEST_F(RecordingFile, ADamagedFileIsRefusedWithoutHarm) {
    ASSERT_TRUE(history.save(path));
    std::ifstream in(path, std::ios::binary);
    const std::string good((std::istreambuf_iterator<char>(in)), {});
    std::mt19937 random(start);
    for (int i = 0; i < 60; ++i) {
        std::string bad = good;
        if (i % 3 == 0)
            bad.resize(random() % bad.size());
        else
            bad[i % 3 == 1 ? random() % std::min<size_t>(bad.size(), 400) : random() % bad.size()] ^=
                static_cast<char>(1 + random() % 255);
        std::ofstream(path, std::ios::binary | std::ios::trunc) << bad;
        const Result<std::unique_ptr<History>> loaded =
            History::load(path, [&](const History::Sources& sources) -> std::shared_ptr<const image::CompiledProgram> {
                return sources.files.empty() ? nullptr : sources.files[0].second == "a" ? a : b;
            });
        EXPECT_FALSE(loaded) << "seed " << start << " step " << i;
    }
    EXPECT_FALSE(History::load("/nonexistent/file", [](const auto&) { return nullptr; }));
    EXPECT_FALSE(history.save("/nonexistent/file"));
}

// A note that takes the last page of a segment leaves room for its scan.
TEST(History, EveryScanIsRecordedWithWhatActedFromOutside) {
    const unsigned start = seed();
    for (unsigned run = 0; run < 4; ++run) {
        SCOPED_TRACE("seed " + std::to_string(start) + " run " + std::to_string(run) + " (STEPWISE_SEED sets it)");
        std::mt19937 dice(start + run);
        History history(size_t(64) << 20);
        Source source(history, start + run);
        source.useProgram(makeProgram(1 + dice() % (run % 2 ? 40 : 400)));
        const unsigned longest = run % 4 == 0 ? 9000 : 300;
        std::vector<bool> isActedOn;
        const unsigned scans = repeats(3000U);
        for (unsigned i = 0; i < scans; ++i) {
            isActedOn.push_back(i == 0 || dice() % 2 == 0); // what a scan began with is known from its first note on
            if (isActedOn.back()) source.actFromOutside(1 + dice() % longest);
            source.scan(static_cast<int>(dice() % 20), 1'000'000);
        }
        for (Position p = 0; p < scans; ++p) {
            ASSERT_NO_FATAL_FAILURE(expectSame(history, source.all, p));
            const Result<ScanInput> input = history.inputOf(p);
            ASSERT_TRUE(input) << "position " << p;
            ASSERT_EQ(input->notes.size(), isActedOn[p] ? 1 : 0) << "position " << p;
            if (isActedOn[p]) {
                ASSERT_EQ(input->notes.front().origin, std::to_string(p));
            }
        }
    }
}

// Whatever changes together asks for longer chunks in the same scan.
TEST(History, ScansInWhichEverythingChangesAreRecorded) {
    for (int words = 16; words <= 4096; words += words < 1200 ? 40 : 512) {
        SCOPED_TRACE(std::to_string(words) + " words");
        History history(size_t(64) << 20);
        Source source(history, static_cast<unsigned>(words));
        source.useProgram(makeProgram(words));
        for (unsigned i = 0; i < 130; ++i) {
            if (i % 7 == 0) source.actFromOutside(100);
            std::fill_n(source.data() + 112, words * 4, std::byte(i + 1));
            source.scan(0, 1'000'000);
        }
        for (Position p = 0; p < 130; ++p) ASSERT_NO_FATAL_FAILURE(expectSame(history, source.all, p));
    }
}

// ---------------------------------------------------------------- threads

TEST(History, ReadersSeeWholeScansWhileTheScanThreadAppendsAndEvicts) {
    History history(size_t(1) << 20);
    const auto program = makeProgram(500);
    std::atomic<bool> isDone{false};
    std::thread scanThread([&] {
        history.beginProgram(program);
        std::vector<std::byte> image(program->layout.imageSize);
        for (uint32_t scan = 0; scan < 20'000; ++scan) {
            image::ImageHeader header;
            header.timeNs = int64_t(scan) * 1000;
            header.scan = scan;
            std::memcpy(image.data(), &header, sizeof header);
            for (uint32_t word = 0; word < 500; word += 50)
                std::memcpy(image.data() + 112 + word * 4, &scan, 4); // all alike in one scan
            history.append(image, scan, Nanoseconds(header.timeNs));
            if (scan % 5000 == 4999) history.mark(1, errors::Plainly(Verbatim("mark")), Nanoseconds(header.timeNs));
        }
        isDone = true;
    });
    std::atomic<uint64_t> checked{0};
    const auto read = [&](unsigned seedValue) {
        std::mt19937 random(seedValue);
        const expression::Expression expression = variable(*program, "data[50]");
        while (!isDone || checked < 50) {
            const Statistics statistics = history.statistics();
            if (statistics.end == 0) continue;
            ASSERT_LT(statistics.first, statistics.end); // never looks empty between
            const Position position = statistics.first + random() % (statistics.end - statistics.first);
            const std::vector<std::byte> image = history.seek(position);
            if (!image.empty()) {
                for (uint32_t word = 0; word < 500; word += 50)
                    ASSERT_EQ(plc::testing::valueAt<uint32_t>(image, 112 + word * 4), position);
                ++checked;
            }
            const Position from = statistics.end > 300 ? statistics.end - 300 : 0;
            const std::vector<Bucket> buckets = history.series(expression, {}, from, statistics.end, 1000);
            for (const Bucket& bucket : buckets)
                if (bucket.count) {
                    ASSERT_EQ(bucket.first, static_cast<double>(bucket.begin));
                }
            (void)history.positionAt(Nanoseconds(static_cast<int64_t>(position) * 1000));
            (void)history.marks();
        }
    };
    std::thread a(read, 1), b(read, 2);
    scanThread.join();
    a.join();
    b.join();
    EXPECT_GE(checked, 50u);
    EXPECT_GT(history.statistics().first, 0u);
}

} // namespace
} // namespace plc::history
