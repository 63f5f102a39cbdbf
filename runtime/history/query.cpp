// Series, samples and searches: each pins one segment at a time, so that a long search never holds up eviction.
#include "runtime/history/history_state.h"
#include "runtime/history/probe.h"

#include <algorithm>
#include <cmath>

namespace plc::history {

namespace {

/// Spreads values over buckets of [from, to).
class BucketFiller {
public:
    BucketFiller(Position from, Position to, size_t buckets) : m_from(from), m_length(to - from) {
        m_buckets.resize(static_cast<size_t>(std::min<uint64_t>(buckets, m_length)));
        for (size_t k = 0; k < m_buckets.size(); ++k) m_buckets[k].begin = begin(k);
    }
    /// `value` at all of [first, last).
    void add(Position first, Position last, double value) {
        while (first < last) {
            while (m_at + 1 < m_buckets.size() && m_buckets[m_at + 1].begin <= first) ++m_at;
            Bucket& bucket = m_buckets[m_at];
            const Position end =
                std::min(last, m_at + 1 < m_buckets.size() ? m_buckets[m_at + 1].begin : m_from + m_length);
            if (bucket.count == 0) bucket.first = bucket.minimum = bucket.maximum = value;
            bucket.minimum = std::fmin(bucket.minimum, value);
            bucket.maximum = std::fmax(bucket.maximum, value);
            bucket.last = value;
            bucket.isNumber |= !std::isnan(value);
            bucket.count += end - first;
            first = end;
        }
    }
    std::vector<Bucket> take() { return std::move(m_buckets); }

private:
    [[nodiscard]] Position begin(size_t k) const {
        return m_from + static_cast<Position>(static_cast<unsigned __int128>(m_length) * k / m_buckets.size());
    }
    Position m_from, m_length;
    std::vector<Bucket> m_buckets;
    size_t m_at = 0;
};

/// Calls visit(segment, from, to) with indices, for the segments of [from, to) that are still there, forwards; each
/// under its own pin.
template <class State, class Visit> void forEachSegment(const State& state, Position from, Position to, Visit&& visit) {
    Position at = from;
    while (at < to) {
        const Epochs::Pin pin = state.epochs.pin();
        const Segment* s = state.containing(at);
        if (!s) {
            const Position oldest = state.oldest();
            if (at < oldest) {
                at = oldest; // evicted
                continue;
            }
            return; // not recorded yet
        }
        const Position end = std::min(to, s->end());
        if (!visit(*s, static_cast<uint32_t>(at - s->first), static_cast<uint32_t>(end - s->first))) return;
        at = end;
    }
}

/// State of the expression after one scan.
template <class State, class Read>
auto valueAt(const State& state, Probes& probes, Position position, Read read)
    -> std::optional<decltype(read(std::declval<const Probe&>(), std::span<const std::byte>()))> {
    const Epochs::Pin pin = state.epochs.pin();
    const Segment* s = state.containing(position);
    if (!s) return std::nullopt;
    const Probe* probe = probes.of(*s);
    if (!probe) return std::nullopt;
    const std::span<std::byte> image = probes.image(*s);
    std::optional<decltype(read(*probe, image))> result;
    const auto index = static_cast<uint32_t>(position - s->first);
    (void)replay(*s, probe->watched(), index, index + 1, image.data(), [&](uint32_t, uint32_t) {
        result = read(*probe, image);
        return false;
    });
    return result;
}

/// The scan before `position` on its branch; none for the first.
std::optional<Position> scanBefore(const std::vector<Branch>& branches, Position position) {
    for (const Branch& branch : branches)
        if (branch.first == position)
            return branch.parent == kNoParent ? std::nullopt : std::optional<Position>(branch.parent);
    return position > 0 ? std::optional<Position>(position - 1) : std::nullopt;
}

/// Walks from scan to scan; `differs(before, now)` says which one is looked for. Value: what `read` gives.
template <class State, class Read, class Differs>
std::optional<Position> search(const State& state, Probes& probes, Position from, History::Direction direction,
                               Read read, Differs differs) {
    using Value = decltype(read(std::declval<const Probe&>(), std::span<const std::byte>()));
    const std::vector<Branch> branches = state.branchList();
    std::optional<Position> found;
    const auto within = [&](const Segment& s, uint32_t first, uint32_t end, bool wantsLast) {
        // Looks at the scans [first, end) of the segment, each against the one before.
        const Probe* probe = probes.of(s);
        std::optional<Value> before;
        if (const std::optional<Position> previous = scanBefore(branches, s.first + first))
            before = valueAt(state, probes, *previous, read);
        bool isKnown = before.has_value() || state.oldest() < s.first + first;
        if (!probe) { // the path does not exist here
            if (isKnown && differs(before, std::optional<Value>())) found = s.first + first;
            return;
        }
        const std::span<std::byte> image = probes.image(s);
        (void)replay(s, probe->watched(), first, end, image.data(), [&](uint32_t begin, uint32_t) {
            std::optional<Value> now = read(*probe, image);
            if (isKnown && differs(before, now)) found = s.first + begin;
            before = std::move(now);
            isKnown = true;
            return wantsLast || !found;
        });
    };
    if (direction == History::Direction::Forward) {
        forEachSegment(state, from + 1, state.end.load(std::memory_order_acquire),
                       [&](const Segment& s, uint32_t first, uint32_t end) {
                           within(s, first, end, false);
                           return !found;
                       });
        return found;
    }
    Position end = std::min(from, state.end.load(std::memory_order_acquire));
    while (end > 0 && !found) {
        const Epochs::Pin pin = state.epochs.pin();
        const Segment* s = state.containing(end - 1);
        if (!s) break;
        within(*s, 0, static_cast<uint32_t>(end - s->first), true);
        end = s->first;
    }
    return found;
}

} // namespace

std::vector<Bucket> History::series(const expression::Expression& expression, const Recompile& recompile, Position from,
                                    Position to, size_t buckets) const {
    if (to <= from || buckets == 0) return {};
    BucketFiller filler(from, to, buckets);
    Probes probes(expression, recompile);
    forEachSegment(*m, from, to, [&](const Segment& s, uint32_t first, uint32_t end) {
        const Probe* probe = probes.of(s);
        if (!probe) return true;
        const std::span<std::byte> image = probes.image(s);
        return replay(s, probe->watched(), first, end, image.data(), [&](uint32_t begin, uint32_t until) {
            if (const std::optional<double> value = probe->number(image))
                filler.add(s.first + begin, s.first + until, *value);
            return true;
        });
    });
    return filler.take();
}

std::vector<Sample> History::samples(const expression::Expression& expression, const Recompile& recompile,
                                     Position from, Position to) const {
    std::vector<Sample> all;
    Probes probes(expression, recompile);
    forEachSegment(*m, from, to, [&](const Segment& s, uint32_t first, uint32_t end) {
        StampCursor stamps(s);
        const Probe* probe = probes.of(s);
        if (!probe) {
            for (uint32_t i = first; i < end; ++i) all.push_back({stamps.at(i), 0, false});
            return true;
        }
        const std::span<std::byte> image = probes.image(s);
        return replay(s, probe->watched(), first, end, image.data(), [&](uint32_t begin, uint32_t until) {
            const std::optional<double> value = probe->number(image);
            const int64_t integer = value ? probe->wide(image).value_or(0) : 0;
            for (uint32_t i = begin; i < until; ++i)
                all.push_back({stamps.at(i), value.value_or(0), value.has_value(), integer});
            return true;
        });
    });
    return all;
}

std::optional<Position> History::find(const expression::Expression& expression, const Recompile& recompile,
                                      Position from, Direction direction) const {
    Probes probes(expression, recompile);
    return search(
        *m, probes, from, direction,
        [](const Probe& probe, std::span<const std::byte> image) { return probe.isTrue(image); },
        [](const std::optional<bool>& before, const std::optional<bool>& now) {
            return now.value_or(false) && !before.value_or(false);
        });
}

std::optional<Position> History::findChange(const expression::Expression& expression, const Recompile& recompile,
                                            Position from, Direction direction) const {
    Probes probes(expression, recompile);
    return search(
        *m, probes, from, direction,
        [](const Probe& probe, std::span<const std::byte> image) { return probe.fingerprint(image); },
        [](const std::optional<std::string>& before, const std::optional<std::string>& now) { return before != now; });
}

} // namespace plc::history
