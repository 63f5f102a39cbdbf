#include "editor/plot/model/plot_sample.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace plc::plot {

std::optional<SignalSample> nearestSample(const SampleSource& source, int64_t time) {
    const auto before = source.inForceAt(time), after = source.after(time);
    if (!before) return after;
    if (!after) return before;
    return time - before->time <= after->time - time ? before : after;
}

void SampleList::append(int64_t time, double value) {
    if (!m_samples.empty() && m_samples.back().time >= time) return;
    m_samples.push_back({time, value});
    ++m_revision;
}

void SampleList::addGap(SignalGap gap) {
    m_gaps.push_back(gap);
    ++m_revision;
}

void SampleList::keepNewest(size_t samples) {
    if (m_samples.size() <= samples) return;
    m_samples.erase(m_samples.begin(), m_samples.end() - static_cast<ptrdiff_t>(samples));
    ++m_revision;
}

void SampleList::clear() {
    m_samples.clear();
    m_gaps.clear();
    ++m_revision;
}

size_t SampleList::indexAtOrAfter(int64_t time) const {
    const auto it = std::lower_bound(m_samples.begin(), m_samples.end(), time,
                                     [](const SignalSample& s, int64_t t) { return s.time < t; });
    return static_cast<size_t>(it - m_samples.begin());
}

std::optional<std::pair<int64_t, int64_t>> SampleList::timeRange() const {
    if (m_samples.empty()) return std::nullopt;
    return std::pair(m_samples.front().time, m_samples.back().time);
}

uint64_t SampleList::countIn(int64_t from, int64_t to) const { return indexAtOrAfter(to) - indexAtOrAfter(from); }

void SampleList::buckets(int64_t from, int64_t to, std::span<SignalBucket> out) const {
    size_t at = indexAtOrAfter(from);
    const double part = (static_cast<double>(to) - static_cast<double>(from)) / static_cast<double>(out.size());
    for (size_t i = 0; i < out.size(); ++i) {
        const int64_t end = i + 1 == out.size() ? to : from + static_cast<int64_t>(part * static_cast<double>(i + 1));
        SignalBucket& bucket = out[i] = {};
        for (; at < m_samples.size() && m_samples[at].time < end; ++at) {
            const double value = m_samples[at].value;
            if (bucket.count++ == 0) bucket.first = value;
            bucket.last = value;
            if (std::isnan(value)) continue;
            bucket.minimum = bucket.isNumber ? std::min(bucket.minimum, value) : value;
            bucket.maximum = bucket.isNumber ? std::max(bucket.maximum, value) : value;
            bucket.isNumber = true;
        }
    }
}

void SampleList::visit(int64_t from, int64_t to, const Visitor& visitor) const {
    const size_t begin = indexAtOrAfter(from), end = indexAtOrAfter(to);
    if (begin < end) visitor(std::span(m_samples.data() + begin, end - begin));
}

std::optional<SignalSample> SampleList::inForceAt(int64_t time) const {
    const size_t next = time == std::numeric_limits<int64_t>::max() ? m_samples.size() : indexAtOrAfter(time + 1);
    if (next == 0) return std::nullopt;
    return m_samples[next - 1];
}

std::optional<SignalSample> SampleList::after(int64_t time) const {
    if (time == std::numeric_limits<int64_t>::max()) return std::nullopt;
    const size_t next = indexAtOrAfter(time + 1);
    if (next == m_samples.size()) return std::nullopt;
    return m_samples[next];
}

std::vector<SignalGap> SampleList::gaps(int64_t from, int64_t to) const {
    std::vector<SignalGap> result;
    for (const SignalGap& gap : m_gaps)
        if (gap.from < to && gap.to > from) result.push_back(gap);
    return result;
}

std::string exactText(double value, PlotValueKind kind) {
    if (std::isnan(value)) return {};
    if (std::isinf(value)) return value > 0 ? "INF" : "-INF";
    if (kind == PlotValueKind::Bool) return value != 0 ? "1" : "0";
    char buffer[64];
    std::to_chars_result end{};
    if (kind == PlotValueKind::Integer && std::abs(value) < 9.2e18)
        end = std::to_chars(buffer, buffer + sizeof buffer, static_cast<int64_t>(value));
    else if (kind == PlotValueKind::Single)
        end = std::to_chars(buffer, buffer + sizeof buffer, static_cast<float>(value));
    else
        end = std::to_chars(buffer, buffer + sizeof buffer, value);
    return {buffer, end.ptr};
}

namespace {

using Wide = __int128;

Wide wide(WholeNumber number) {
    return number.isUnsigned ? Wide(number.bits) : Wide(static_cast<int64_t>(number.bits));
}

std::string wideText(Wide number, int decimals) {
    std::string digits;
    for (Wide rest = number < 0 ? -number : number; rest > 0; rest /= 10)
        digits.insert(digits.begin(), static_cast<char>('0' + static_cast<int>(rest % 10)));
    const auto behind = static_cast<size_t>(decimals);
    if (digits.size() <= behind) digits.insert(0, behind + 1 - digits.size(), '0');
    if (behind > 0) {
        digits.insert(digits.size() - behind, 1, '.');
        digits.erase(digits.find_last_not_of('0') + 1);
        if (digits.back() == '.') digits.pop_back();
    }
    return number < 0 ? '-' + digits : digits;
}

} // namespace

std::string exactText(WholeNumber number, int decimals) { return wideText(wide(number), decimals); }

std::string exactDifference(WholeNumber a, WholeNumber b, int decimals) {
    return wideText(wide(b) - wide(a), decimals);
}

} // namespace plc::plot
