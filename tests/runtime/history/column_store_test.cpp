// The column store against a plain vector: buckets, searches, eviction and truncation give what a slow reading gives.
#include "runtime/history/column_store.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace plc::history;

namespace {

using Rows = std::vector<plc::SignalSample>;

plc::SignalBucket slowBucket(const Rows& rows, int64_t from, int64_t to) {
    plc::SignalBucket b;
    for (const plc::SignalSample& row : rows) {
        if (row.time < from || row.time >= to) continue;
        if (b.count++ == 0) b.first = row.value;
        b.last = row.value;
        if (std::isnan(row.value)) continue;
        b.minimum = b.isNumber ? std::min(b.minimum, row.value) : row.value;
        b.maximum = b.isNumber ? std::max(b.maximum, row.value) : row.value;
        b.isNumber = true;
    }
    return b;
}

void expectSame(const Column& column, const Rows& rows, int64_t from, int64_t to, size_t parts) {
    std::vector<plc::SignalBucket> buckets(parts);
    column.buckets(from, to, buckets);
    for (size_t i = 0; i < parts; ++i) {
        const int64_t a = from + static_cast<int64_t>((to - from) / parts * i + (to - from) % parts * i / parts);
        const int64_t b =
            from + static_cast<int64_t>((to - from) / parts * (i + 1) + (to - from) % parts * (i + 1) / parts);
        const plc::SignalBucket want = slowBucket(rows, a, b);
        ASSERT_EQ(buckets[i].count, want.count) << "part " << i << " of " << parts << " over " << from << ".." << to;
        ASSERT_EQ(buckets[i].isNumber, want.isNumber);
        if (want.count == 0) continue;
        if (!std::isnan(want.first)) {
            ASSERT_EQ(buckets[i].first, want.first);
        }
        if (!std::isnan(want.last)) {
            ASSERT_EQ(buckets[i].last, want.last);
        }
        if (!want.isNumber) continue;
        ASSERT_EQ(buckets[i].minimum, want.minimum);
        ASSERT_EQ(buckets[i].maximum, want.maximum);
    }
}

} // namespace

struct Shape {
    const char* name;
    ColumnKind kind;
    bool isUneven, hasHoles;
};

class ColumnAgainstVector : public ::testing::TestWithParam<Shape> {};

TEST_P(ColumnAgainstVector, BucketsAndSearchesAgree) {
    const Shape shape = GetParam();
    std::mt19937_64 random(7);
    auto column = Column::make(shape.kind);
    Rows rows;
    int64_t time = 1'000;
    for (int i = 0; i < 20'000; ++i) {
        double value = static_cast<double>(static_cast<int64_t>(random() % 2001) - 1000);
        if (shape.kind == ColumnKind::Bit) value = random() % 2;
        if (shape.hasHoles && random() % 7 == 0) value = std::numeric_limits<double>::quiet_NaN();
        ASSERT_TRUE(column->append(time, value));
        rows.push_back({time, value});
        time += shape.isUneven ? 1 + static_cast<int64_t>(random() % 50) : 10;
    }
    EXPECT_EQ(column->endRow() - column->firstRow(), rows.size());
    for (int round = 0; round < 60; ++round) {
        const int64_t from = static_cast<int64_t>(random() % static_cast<uint64_t>(time)) - 500;
        const int64_t to = from + 1 + static_cast<int64_t>(random() % static_cast<uint64_t>(time));
        expectSame(*column, rows, from, to, 1 + random() % 40);
        const auto it = std::lower_bound(rows.begin(), rows.end(), from,
                                         [](const plc::SignalSample& row, int64_t t) { return row.time < t; });
        EXPECT_EQ(column->rowAtOrAfter(from), static_cast<uint64_t>(it - rows.begin()));
    }
    expectSame(*column, rows, 1'000, time, 1);
    expectSame(*column, rows, 1'000, time, 5'000);
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, ColumnAgainstVector,
    ::testing::Values(Shape{"Bit", ColumnKind::Bit, false, false}, Shape{"Int16", ColumnKind::Int16, true, false},
                      Shape{"Int32", ColumnKind::Int32, false, false}, Shape{"Int64", ColumnKind::Int64, true, false},
                      Shape{"Float", ColumnKind::Float, true, true}, Shape{"Double", ColumnKind::Double, false, true}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(Column, RefusesTimesThatDoNotGrow) {
    auto column = Column::make(ColumnKind::Double);
    EXPECT_TRUE(column->append(10, 1));
    EXPECT_FALSE(column->append(10, 2));
    EXPECT_FALSE(column->append(9, 2));
    EXPECT_TRUE(column->append(11, 2));
    EXPECT_EQ(column->endRow(), 2u);
}

TEST(Column, GivesTheRowInForceAtAnyTime) {
    auto column = Column::make(ColumnKind::Int32);
    for (int i = 0; i < 10; ++i) column->append(100 + i * 10, i);
    struct Row {
        int64_t at;
        std::optional<uint64_t> row;
    };
    for (const Row& row : {Row{99, std::nullopt}, Row{100, 0}, Row{109, 0}, Row{110, 1}, Row{190, 9}, Row{100'000, 9},
                           Row{std::numeric_limits<int64_t>::max(), 9}})
        EXPECT_EQ(column->rowInForceAt(row.at), row.row) << row.at;
}

TEST(Column, KeepsAll64BitsOfAnInteger) {
    auto column = Column::make(ColumnKind::Int64);
    const int64_t odd = (int64_t(1) << 60) + 1;
    column->appendInteger(1, odd);
    column->appendInteger(2, std::numeric_limits<int64_t>::min());
    EXPECT_EQ(column->integer(0), odd);
    EXPECT_EQ(column->integer(1), std::numeric_limits<int64_t>::min());
}

TEST(Column, UnsignedIntegersKeepTheirBitsAndTheirOrder) {
    auto column = Column::make(ColumnKind::Uint64);
    const uint64_t values[] = {5, 0xFFFFFFFFFFFFFFFF, 0x8000000000000001};
    for (int i = 0; i < 3; ++i) column->appendInteger(i, static_cast<int64_t>(values[i]));
    for (uint64_t i = 0; i < 3; ++i) EXPECT_EQ(static_cast<uint64_t>(column->integer(i)), values[i]);
    plc::SignalBucket bucket;
    column->buckets(0, 3, std::span(&bucket, 1));
    EXPECT_EQ(bucket.minimum, 5);
    EXPECT_EQ(bucket.maximum, 18446744073709551615.0);
}

TEST(Column, TruncatesForABranchAndGoesOn) {
    auto column = Column::make(ColumnKind::Float);
    Rows rows;
    for (int i = 0; i < 10'000; ++i) column->append(i * 10, i), rows.push_back({i * 10, double(i)});
    column->appendGap(99'990, 120'000, plc::SignalGap::Reason::SkippedScans);
    column->truncateAfter(50'005);
    rows.resize(5'001);
    EXPECT_TRUE(column->gaps().empty());
    EXPECT_EQ(column->lastTime(), 50'000);
    EXPECT_FALSE(column->append(50'000, -1));
    for (int i = 1; i <= 4'000; ++i) {
        ASSERT_TRUE(column->append(50'000 + i * 7, -i));
        rows.push_back({50'000 + i * 7, double(-i)});
    }
    for (size_t parts : {1, 3, 17, 256, 1000}) expectSame(*column, rows, 0, 80'000, parts);
    column->truncateAfter(-1);
    EXPECT_TRUE(column->isEmpty());
    EXPECT_TRUE(column->append(5, 1));
    EXPECT_EQ(column->bytes() > 0, true);
}

TEST(Column, FindsChangesBothWays) {
    auto column = Column::make(ColumnKind::Bit);
    for (int i = 0; i < 30'000; ++i) column->append(i, i >= 100 && i < 20'005);
    EXPECT_EQ(column->nextChange(0), 100u);
    EXPECT_EQ(column->nextChange(99), 100u);
    EXPECT_EQ(column->nextChange(100), 20'005u);
    EXPECT_EQ(column->nextChange(20'005), std::nullopt);
    EXPECT_EQ(column->previousChange(29'999), 20'005u);
    EXPECT_EQ(column->previousChange(20'005), 100u);
    EXPECT_EQ(column->previousChange(100), std::nullopt);
}

TEST(Column, VisitsEveryRowOnceInOrder) {
    auto column = Column::make(ColumnKind::Int32);
    for (int i = 0; i < 10'000; ++i) column->append(i * 3, i);
    uint64_t expected = 17;
    column->visit(17, 9'001, [&](std::span<const plc::SignalSample> block) {
        for (const plc::SignalSample& row : block) {
            ASSERT_EQ(row.value, static_cast<double>(expected));
            ASSERT_EQ(row.time, static_cast<int64_t>(expected * 3));
            ++expected;
        }
    });
    EXPECT_EQ(expected, 9'001u);
}

TEST(ColumnStore, EvictsTheOldestOfAllColumnsAndSaysSo) {
    ColumnStore store(size_t(400) << 10);
    const ColumnId a = store.add(ColumnKind::Float), b = store.add(ColumnKind::Double);
    for (int i = 0; i < 100'000; ++i) {
        store.column(a).append(i, i);
        store.column(b).append(i, -i);
        if (i % 1000 == 0) store.enforceBudget();
    }
    store.enforceBudget();
    EXPECT_LE(store.bytes(), store.budget());
    EXPECT_GT(store.bytes(), store.budget() / 2) << "evicts no more than it must";
    for (ColumnId id : {a, b}) {
        const Column& column = store.column(id);
        ASSERT_EQ(column.gaps().size(), 1u);
        EXPECT_EQ(column.gaps()[0], (plc::SignalGap{0, column.firstTime(), plc::SignalGap::Reason::Evicted}));
        EXPECT_EQ(column.lastTime(), 99'999);
        EXPECT_EQ(column.row(column.firstRow()).time, static_cast<int64_t>(column.firstRow()));
    }
    // Both give up the same span of time, give or take a chunk.
    EXPECT_NEAR(static_cast<double>(store.column(a).firstTime()), static_cast<double>(store.column(b).firstTime()),
                4097);
    const size_t before = store.bytes();
    store.remove(b);
    EXPECT_LT(store.bytes(), before);
}

TEST(ColumnStore, EvictionKeepsTheGapsBehindIt) {
    // scans that nobody read are a gap for as long as there are values on both sides
    ColumnStore store;
    Column& column = store.column(store.add(ColumnKind::Float));
    for (int i = 0; i < 20'000; ++i)
        if (i < 9'000 || i >= 9'500) column.append(i, i);
    column.appendGap(8'999, 9'500, plc::SignalGap::Reason::Evicted);
    const plc::SignalGap middle{8'999, 9'500, plc::SignalGap::Reason::Evicted};
    store.setBudget(store.bytes() - 1000); // a chunk
    ASSERT_GT(column.firstTime(), 0);
    ASSERT_LT(column.firstTime(), 8'999);
    ASSERT_EQ(column.gaps().size(), 2u);
    EXPECT_EQ(column.gaps()[0], (plc::SignalGap{0, column.firstTime(), plc::SignalGap::Reason::Evicted}));
    EXPECT_EQ(column.gaps()[1], middle);
    store.setBudget(store.bytes() / 3); // the one in the middle, too: all of it is no longer kept
    ASSERT_GT(column.firstTime(), 9'500);
    ASSERT_EQ(column.gaps().size(), 1u);
    EXPECT_EQ(column.gaps()[0], (plc::SignalGap{0, column.firstTime(), plc::SignalGap::Reason::Evicted}));
}

TEST(ColumnStore, UniformTimesCostNoMemory) {
    ColumnStore store;
    const ColumnId even = store.add(ColumnKind::Float), uneven = store.add(ColumnKind::Float);
    for (int i = 0; i < 40'960; ++i) {
        store.column(even).append(int64_t(i) * 1'000'000, i);
        store.column(uneven).append(int64_t(i) * 1'000'000 + (i % 3), i);
    }
    EXPECT_LT(store.column(even).bytes(), 40'960 * 6u);
    EXPECT_GT(store.column(uneven).bytes(), 40'960 * 12u);
}
