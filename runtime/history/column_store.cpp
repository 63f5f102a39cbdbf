#include "runtime/history/column_store.h"

#include "runtime/base/assert.h"

#include <array>
#include <cmath>
#include <deque>
#include <limits>
#include <type_traits>

namespace plc::history {

namespace {

constexpr size_t FanOut = 16;
constexpr size_t ChunkRows = FanOut * FanOut * FanOut;

/// Where part i of [from, to) begins, exact and without overflow.
int64_t partBegin(int64_t from, int64_t to, size_t i, size_t parts) {
    const uint64_t span = static_cast<uint64_t>(to) - static_cast<uint64_t>(from), whole = span / parts,
                   rest = span % parts;
    return static_cast<int64_t>(static_cast<uint64_t>(from) + whole * i + rest * i / parts);
}

template <class T> struct Extent {
    T low, high;
    void reset() {
        if constexpr (std::is_floating_point_v<T>)
            low = std::numeric_limits<T>::infinity(), high = -std::numeric_limits<T>::infinity();
        else
            low = std::numeric_limits<T>::max(), high = std::numeric_limits<T>::lowest();
    }
    void add(T value) { // not a number: both comparisons are false
        if (value < low) low = value;
        if (value > high) high = value;
    }
    void add(const Extent& other) {
        if (other.low < low) low = other.low;
        if (other.high > high) high = other.high;
    }
    [[nodiscard]] bool isEmpty() const { return !(low <= high); }
};

/// 4096 rows. Times at one distance, the usual case, need no memory.
template <class T> struct Chunk {
    int64_t start = 0, step = 0;
    std::vector<int64_t> times; // empty: start + i * step
    std::vector<T> values;
    std::array<Extent<T>, ChunkRows / FanOut> fine;
    std::array<Extent<T>, ChunkRows / FanOut / FanOut> coarse;
    Extent<T> whole;

    Chunk() { clearExtents(); }

    void clearExtents() {
        for (Extent<T>& e : fine) e.reset();
        for (Extent<T>& e : coarse) e.reset();
        whole.reset();
    }
    [[nodiscard]] size_t size() const { return values.size(); }
    [[nodiscard]] int64_t timeAt(size_t i) const {
        return times.empty() ? start + static_cast<int64_t>(i) * step : times[i];
    }
    [[nodiscard]] int64_t lastTime() const { return timeAt(size() - 1); }

    void addExtent(size_t i) {
        fine[i / FanOut].add(values[i]);
        coarse[i / FanOut / FanOut].add(values[i]);
        whole.add(values[i]);
    }
    void append(int64_t time, T value) {
        const size_t i = size();
        if (i == 0)
            start = time;
        else if (i == 1 && times.empty())
            step = time - start;
        else if (times.empty() && time != start + static_cast<int64_t>(i) * step)
            spellTimesOut();
        if (!times.empty()) times.push_back(time);
        values.push_back(value);
        addExtent(i);
    }
    void spellTimesOut() {
        times.reserve(ChunkRows);
        for (size_t i = 0; i < size(); ++i) times.push_back(start + static_cast<int64_t>(i) * step);
    }
    void truncate(size_t rows) {
        values.resize(rows);
        if (!times.empty()) times.resize(rows);
        clearExtents();
        for (size_t i = 0; i < rows; ++i) addExtent(i);
    }
    /// First index whose time is at or after `time`.
    [[nodiscard]] size_t lowerBound(int64_t time) const {
        if (!times.empty())
            return static_cast<size_t>(std::lower_bound(times.begin(), times.end(), time) - times.begin());
        if (time <= start) return 0;
        if (time > lastTime()) return size();
        if (step <= 0) return 0;
        return static_cast<size_t>((time - start + step - 1) / step);
    }
    /// Extent of rows [from, to): whole blocks from the pyramid, ragged ends row by row.
    [[nodiscard]] Extent<T> extent(size_t from, size_t to) const {
        if (from == 0 && to == size()) return whole;
        Extent<T> e;
        e.reset();
        size_t i = from;
        while (i < to) {
            if (i % (FanOut * FanOut) == 0 && i + FanOut * FanOut <= to) {
                e.add(coarse[i / FanOut / FanOut]);
                i += FanOut * FanOut;
            } else if (i % FanOut == 0 && i + FanOut <= to) {
                e.add(fine[i / FanOut]);
                i += FanOut;
            } else {
                e.add(values[i++]);
            }
        }
        return e;
    }
    [[nodiscard]] size_t bytes() const {
        return sizeof(*this) + values.capacity() * sizeof(T) + times.capacity() * sizeof(int64_t);
    }
};

template <class T> T narrowed(double value) {
    if constexpr (std::is_floating_point_v<T>) {
        return static_cast<T>(value);
    } else {
        if (!(value == value)) return 0;
        const auto rounded = std::nearbyint(value);
        if (rounded >= static_cast<double>(std::numeric_limits<T>::max())) return std::numeric_limits<T>::max();
        if (rounded <= static_cast<double>(std::numeric_limits<T>::lowest())) return std::numeric_limits<T>::lowest();
        return static_cast<T>(rounded);
    }
}

template <class T, ColumnKind Kind> class TypedColumn final : public Column {
public:
    ColumnKind kind() const override { return Kind; }

    bool append(int64_t time, double value) override {
        if constexpr (Kind == ColumnKind::Bit)
            return put(time, value != 0 ? T(1) : T(0));
        else
            return put(time, narrowed<T>(value));
    }
    bool appendInteger(int64_t time, int64_t value) override {
        if constexpr (Kind == ColumnKind::Int64 || Kind == ColumnKind::Uint64)
            return put(time, static_cast<T>(value));
        else
            return append(time, static_cast<double>(value));
    }

    uint64_t endRow() const override {
        return m_chunks.empty() ? m_firstRow : m_firstRow + (m_chunks.size() - 1) * ChunkRows + m_chunks.back()->size();
    }
    SignalSample row(uint64_t row) const override {
        PLC_ASSERT(row >= m_firstRow && row < endRow(), return {});
        const Chunk<T>& chunk = *m_chunks[(row - m_firstRow) / ChunkRows];
        const size_t i = (row - m_firstRow) % ChunkRows;
        return {chunk.timeAt(i), static_cast<double>(chunk.values[i])};
    }
    int64_t integer(uint64_t row) const override {
        PLC_ASSERT(row >= m_firstRow && row < endRow(), return 0);
        return static_cast<int64_t>(m_chunks[(row - m_firstRow) / ChunkRows]->values[(row - m_firstRow) % ChunkRows]);
    }
    uint64_t rowAtOrAfter(int64_t time) const override {
        const auto it = std::partition_point(m_chunks.begin(), m_chunks.end(),
                                             [time](const auto& chunk) { return chunk->lastTime() < time; });
        if (it == m_chunks.end()) return endRow();
        return m_firstRow + static_cast<uint64_t>(it - m_chunks.begin()) * ChunkRows + (*it)->lowerBound(time);
    }

    void buckets(int64_t from, int64_t to, std::span<SignalBucket> out) const override {
        uint64_t begin = out.empty() ? 0 : rowAtOrAfter(from);
        for (size_t i = 0; i < out.size(); ++i) {
            const uint64_t end = rowAtOrAfterFrom(begin, partBegin(from, to, i + 1, out.size()));
            out[i] = bucketOf(begin, end);
            begin = end;
        }
    }

    std::optional<uint64_t> nextChange(uint64_t row) const override {
        for (uint64_t i = std::max(row + 1, m_firstRow + 1); i < endRow();) {
            // A block whose extent is one value, the value before it, holds no change.
            const Chunk<T>& chunk = *m_chunks[(i - m_firstRow) / ChunkRows];
            const size_t at = (i - m_firstRow) % ChunkRows;
            const T before = valueAt(i - 1);
            if (at == 0 && chunk.whole.low == before && chunk.whole.high == before && isPlain(before))
                i += chunk.size();
            else if (at % FanOut == 0 && at + FanOut <= chunk.size() && chunk.fine[at / FanOut].low == before &&
                     chunk.fine[at / FanOut].high == before && isPlain(before))
                i += FanOut;
            else if (!same(chunk.values[at], before))
                return i;
            else
                ++i;
        }
        return std::nullopt;
    }
    std::optional<uint64_t> previousChange(uint64_t row) const override {
        for (uint64_t i = std::min(row, endRow()); i > m_firstRow + 1;) {
            --i;
            if (!same(valueAt(i), valueAt(i - 1))) return i;
        }
        return std::nullopt;
    }

    size_t bytes() const override { return m_bytes + (m_chunks.empty() ? 0 : m_chunks.back()->bytes()); }
    std::optional<int64_t> oldestEvictable() const override {
        if (m_chunks.size() < 2) return std::nullopt;
        return m_chunks.front()->lastTime();
    }

protected:
    void readRows(uint64_t first, std::span<SignalSample> out) const override {
        for (size_t done = 0; done < out.size();) {
            const uint64_t row = first + done - m_firstRow;
            const Chunk<T>& chunk = *m_chunks[row / ChunkRows];
            size_t i = row % ChunkRows;
            for (; i < chunk.size() && done < out.size(); ++i, ++done)
                out[done] = {chunk.timeAt(i), static_cast<double>(chunk.values[i])};
        }
    }
    void dropRowsAfter(int64_t time) override {
        while (!m_chunks.empty() && m_chunks.back()->start > time) {
            m_chunks.pop_back();
            if (!m_chunks.empty()) m_bytes -= m_chunks.back()->bytes();
        }
        if (m_chunks.empty()) return;
        Chunk<T>& chunk = *m_chunks.back();
        const size_t kept = time == std::numeric_limits<int64_t>::max() ? chunk.size() : chunk.lowerBound(time + 1);
        if (kept < chunk.size()) chunk.truncate(kept);
    }
    void dropAll() override {
        m_firstRow = endRow();
        m_chunks.clear();
        m_bytes = 0;
    }
    uint64_t dropOldestChunk() override {
        if (m_chunks.size() < 2) return 0;
        m_bytes -= m_chunks.front()->bytes();
        m_chunks.pop_front();
        return ChunkRows;
    }

private:
    static bool same(T a, T b) {
        if constexpr (std::is_floating_point_v<T>)
            return a == b || (a != a && b != b);
        else
            return a == b;
    }
    static bool isPlain(T v) { return v == v; }
    T valueAt(uint64_t row) const {
        return m_chunks[(row - m_firstRow) / ChunkRows]->values[(row - m_firstRow) % ChunkRows];
    }

    bool put(int64_t time, T value) {
        if (!m_chunks.empty() && m_chunks.back()->lastTime() >= time) return false;
        if (m_chunks.empty() || m_chunks.back()->size() == ChunkRows) {
            if (!m_chunks.empty()) {
                m_chunks.back()->values.shrink_to_fit();
                m_bytes += m_chunks.back()->bytes();
            }
            m_chunks.push_back(std::make_unique<Chunk<T>>());
        }
        m_chunks.back()->append(time, value);
        return true;
    }
    /// As rowAtOrAfter, searching near `row` first: buckets follow one another.
    uint64_t rowAtOrAfterFrom(uint64_t row, int64_t time) const {
        const size_t at = (row - m_firstRow) / ChunkRows;
        if (at < m_chunks.size() && m_chunks[at]->lastTime() >= time)
            return m_firstRow + at * ChunkRows + m_chunks[at]->lowerBound(time);
        return rowAtOrAfter(time);
    }
    SignalBucket bucketOf(uint64_t begin, uint64_t end) const {
        SignalBucket bucket;
        if (begin >= end) return bucket;
        bucket.count = end - begin;
        bucket.first = static_cast<double>(valueAt(begin));
        bucket.last = static_cast<double>(valueAt(end - 1));
        Extent<T> extent;
        extent.reset();
        for (uint64_t i = begin - m_firstRow, stop = end - m_firstRow; i < stop;) {
            const size_t chunk = i / ChunkRows, from = i % ChunkRows;
            const size_t to = std::min<uint64_t>(ChunkRows, from + (stop - i));
            extent.add(m_chunks[chunk]->extent(from, to));
            i += to - from;
        }
        bucket.isNumber = !extent.isEmpty();
        if (bucket.isNumber)
            bucket.minimum = static_cast<double>(extent.low), bucket.maximum = static_cast<double>(extent.high);
        return bucket;
    }

    std::deque<std::unique_ptr<Chunk<T>>> m_chunks; // all but the last are full
    size_t m_bytes = 0;                             // of all but the last
};

} // namespace

std::unique_ptr<Column> Column::make(ColumnKind kind) {
    switch (kind) {
    case ColumnKind::Bit:
        return std::make_unique<TypedColumn<int8_t, ColumnKind::Bit>>();
    case ColumnKind::Int16:
        return std::make_unique<TypedColumn<int16_t, ColumnKind::Int16>>();
    case ColumnKind::Int32:
        return std::make_unique<TypedColumn<int32_t, ColumnKind::Int32>>();
    case ColumnKind::Int64:
        return std::make_unique<TypedColumn<int64_t, ColumnKind::Int64>>();
    case ColumnKind::Uint64:
        return std::make_unique<TypedColumn<uint64_t, ColumnKind::Uint64>>();
    case ColumnKind::Float:
        return std::make_unique<TypedColumn<float, ColumnKind::Float>>();
    case ColumnKind::Double:
        return std::make_unique<TypedColumn<double, ColumnKind::Double>>();
    }
    return nullptr;
}

void Column::appendGap(int64_t from, int64_t to, SignalGap::Reason reason) {
    if (to <= from) return;
    if (!m_gaps.empty() && m_gaps.back().reason == reason && m_gaps.back().to >= from)
        m_gaps.back().to = std::max(m_gaps.back().to, to);
    else
        m_gaps.push_back({from, to, reason});
}

void Column::truncateAfter(int64_t time) {
    dropRowsAfter(time);
    while (!m_gaps.empty() && m_gaps.back().from >= time) m_gaps.pop_back();
    if (!m_gaps.empty()) m_gaps.back().to = std::min(m_gaps.back().to, time);
}

void Column::clear() {
    dropAll();
    m_gaps.clear();
}

std::optional<uint64_t> Column::rowInForceAt(int64_t time) const {
    const uint64_t next = time == std::numeric_limits<int64_t>::max() ? endRow() : rowAtOrAfter(time + 1);
    if (next == m_firstRow) return std::nullopt;
    return next - 1;
}

void Column::visit(uint64_t first, uint64_t end, const Visitor& visitor) const {
    first = std::max(first, m_firstRow);
    end = std::min(end, endRow());
    std::array<SignalSample, 1024> block;
    while (first < end) {
        const size_t count = std::min<uint64_t>(block.size(), end - first);
        readRows(first, std::span(block.data(), count));
        visitor(std::span<const SignalSample>(block.data(), count));
        first += count;
    }
}

void Column::evictOldest() {
    if (isEmpty()) return;
    const bool hasEvicted = !m_gaps.empty() && m_gaps.front().reason == SignalGap::Reason::Evicted &&
                            m_gaps.front().to <= firstTime(); // else it has values before it
    const int64_t from = hasEvicted ? m_gaps.front().from : firstTime();
    const uint64_t dropped = dropOldestChunk();
    if (dropped == 0) return;
    m_firstRow += dropped;
    std::erase_if(m_gaps, [this](const SignalGap& gap) { return gap.to <= firstTime(); });
    m_gaps.insert(m_gaps.begin(), {from, firstTime(), SignalGap::Reason::Evicted});
}

ColumnStore::ColumnStore(size_t budgetBytes) : m_budget(budgetBytes) {}

ColumnId ColumnStore::add(ColumnKind kind) {
    m_columns.push_back(Column::make(kind));
    return static_cast<ColumnId>(m_columns.size() - 1);
}

void ColumnStore::remove(ColumnId id) {
    PLC_ASSERT(id < m_columns.size(), return );
    m_columns[id].reset();
}

Column& ColumnStore::column(ColumnId id) { return *m_columns[id]; }
const Column& ColumnStore::column(ColumnId id) const { return *m_columns[id]; }

size_t ColumnStore::bytes() const {
    size_t sum = 0;
    for (const auto& column : m_columns)
        if (column) sum += column->bytes();
    return sum;
}

void ColumnStore::setBudget(size_t bytes) {
    m_budget = bytes;
    enforceBudget();
}

void ColumnStore::enforceBudget() {
    size_t used = bytes();
    while (used > m_budget) {
        Column* oldest = nullptr;
        int64_t oldestTime = std::numeric_limits<int64_t>::max();
        for (const auto& column : m_columns) {
            if (!column) continue;
            const auto time = column->oldestEvictable();
            if (time && *time <= oldestTime) oldest = column.get(), oldestTime = *time;
        }
        if (!oldest) return;
        const size_t before = oldest->bytes();
        oldest->evictOldest();
        used -= before - oldest->bytes();
    }
}

} // namespace plc::history
