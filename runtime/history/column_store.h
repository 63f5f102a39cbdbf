// Columns of (time, value) rows with a pyramid of minima and maxima: what a chart reads, so that ten million samples
// pan as quickly as a thousand. Filled from the history (or a file) by whoever shows the chart, who also owns it; one
// thread.
#pragma once
#include "runtime/base/signal.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace plc::history {

/// How a column keeps its values; the narrowest that holds the channel's type exactly is the right one.
enum class ColumnKind : uint8_t { Bit, Int16, Int32, Int64, Uint64, Float, Double };

class Column {
public:
    virtual ~Column() = default;

    static std::unique_ptr<Column> make(ColumnKind kind);
    [[nodiscard]] virtual ColumnKind kind() const = 0;

    /// Times must grow; a row at or before the last one is refused (false).
    virtual bool append(int64_t time, double value) = 0;
    /// The same for 64-bit integers that a double cannot hold; of Uint64 the bits.
    virtual bool appendInteger(int64_t time, int64_t value) = 0;
    /// Notes that nothing is known between the last row and the next.
    void appendGap(int64_t from, int64_t to, SignalGap::Reason reason);
    /// Going back in time: rows and gaps after `time` leave.
    void truncateAfter(int64_t time);
    void clear();

    /// Rows are numbered from the first ever appended; eviction takes the lowest numbers away.
    [[nodiscard]] uint64_t firstRow() const { return m_firstRow; }
    [[nodiscard]] virtual uint64_t endRow() const = 0;
    [[nodiscard]] bool isEmpty() const { return endRow() == firstRow(); }
    [[nodiscard]] virtual SignalSample row(uint64_t row) const = 0;
    /// 64-bit integers without rounding; of Uint64 the bits.
    [[nodiscard]] virtual int64_t integer(uint64_t row) const = 0;
    /// Number of the first row at or after `time`; endRow() when there is none.
    [[nodiscard]] virtual uint64_t rowAtOrAfter(int64_t time) const = 0;
    /// The row in force at `time`: the last one at or before it.
    [[nodiscard]] std::optional<uint64_t> rowInForceAt(int64_t time) const;
    [[nodiscard]] uint64_t countIn(int64_t from, int64_t to) const { return rowAtOrAfter(to) - rowAtOrAfter(from); }
    [[nodiscard]] int64_t firstTime() const { return row(firstRow()).time; } // not empty
    [[nodiscard]] int64_t lastTime() const { return row(endRow() - 1).time; }

    /// Splits [from, to) into out.size() equal parts.
    virtual void buckets(int64_t from, int64_t to, std::span<SignalBucket> out) const = 0;
    /// Hands the rows of [first, end) out in blocks.
    using Visitor = std::function<void(std::span<const SignalSample>)>;
    void visit(uint64_t first, uint64_t end, const Visitor& visitor) const;
    /// Next row after (before) `row` whose value differs from the one before it.
    [[nodiscard]] virtual std::optional<uint64_t> nextChange(uint64_t row) const = 0;
    [[nodiscard]] virtual std::optional<uint64_t> previousChange(uint64_t row) const = 0;

    [[nodiscard]] const std::vector<SignalGap>& gaps() const { return m_gaps; }
    [[nodiscard]] virtual size_t bytes() const = 0;
    /// Time of the last row of the oldest chunk that may leave; none while only the newest chunk is left.
    [[nodiscard]] virtual std::optional<int64_t> oldestEvictable() const = 0;
    void evictOldest();

protected:
    virtual void readRows(uint64_t first, std::span<SignalSample> out) const = 0;
    virtual void dropRowsAfter(int64_t time) = 0;
    virtual void dropAll() = 0;
    virtual uint64_t dropOldestChunk() = 0; // rows dropped

    uint64_t m_firstRow = 0;

private:
    std::vector<SignalGap> m_gaps; // ascending
};

using ColumnId = uint32_t;

/// Columns under one memory budget: the oldest chunk of all leaves first.
class ColumnStore {
public:
    explicit ColumnStore(size_t budgetBytes = size_t(512) << 20);

    ColumnId add(ColumnKind kind);
    void remove(ColumnId id);
    [[nodiscard]] Column& column(ColumnId id);
    [[nodiscard]] const Column& column(ColumnId id) const;

    [[nodiscard]] size_t bytes() const;
    [[nodiscard]] size_t budget() const { return m_budget; }
    void setBudget(size_t bytes);
    /// Call after appending a batch; cheap when nothing must leave.
    void enforceBudget();

private:
    size_t m_budget;
    std::vector<std::unique_ptr<Column>> m_columns; // by id; null after remove
};

} // namespace plc::history
