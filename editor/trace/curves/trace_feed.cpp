#include "editor/trace/curves/trace_feed.h"

#include <algorithm>
#include <cmath>

namespace plc::trace {

namespace {
constexpr Position Slice = 8192;
using history::Column;
} // namespace

std::optional<std::pair<int64_t, int64_t>> ColumnSource::timeRange() const {
    const Column& c = column();
    if (c.isEmpty()) return std::nullopt;
    return std::pair(c.firstTime(), c.lastTime());
}

void ColumnSource::buckets(int64_t from, int64_t to, std::span<SignalBucket> out) const {
    column().buckets(from, to, out);
}

void ColumnSource::visit(int64_t from, int64_t to, const Visitor& visitor) const {
    const Column& c = column();
    c.visit(c.rowAtOrAfter(from), c.rowAtOrAfter(to), visitor);
}

std::optional<SignalSample> ColumnSource::inForceAt(int64_t time) const {
    const auto row = column().rowInForceAt(time);
    if (!row) return std::nullopt;
    return column().row(*row);
}

std::optional<SignalSample> ColumnSource::after(int64_t time) const {
    const Column& c = column();
    if (time == std::numeric_limits<int64_t>::max()) return std::nullopt;
    const uint64_t row = c.rowAtOrAfter(time + 1);
    if (row == c.endRow()) return std::nullopt;
    return c.row(row);
}

std::optional<plot::WholeNumber> ColumnSource::integerAt(int64_t time) const {
    const Column& c = column();
    if (c.kind() != history::ColumnKind::Int64 && c.kind() != history::ColumnKind::Uint64) return std::nullopt;
    const auto row = c.rowInForceAt(time);
    if (!row) return std::nullopt;
    return plot::WholeNumber{static_cast<uint64_t>(c.integer(*row)), c.kind() == history::ColumnKind::Uint64};
}

std::optional<std::pair<plot::WholeNumber, plot::WholeNumber>> ColumnSource::integerExtent(int64_t from,
                                                                                           int64_t to) const {
    const Column& c = column();
    const bool isUnsigned = c.kind() == history::ColumnKind::Uint64;
    if ((c.kind() != history::ColumnKind::Int64 && !isUnsigned) || to < from) return std::nullopt;
    const uint64_t first = c.rowInForceAt(from).value_or(c.rowAtOrAfter(from)), end = c.rowAtOrAfter(to + 1);
    if (first >= end) return std::nullopt;
    int64_t low = c.integer(first), high = low;
    const auto less = [&](int64_t a, int64_t b) {
        return isUnsigned ? static_cast<uint64_t>(a) < static_cast<uint64_t>(b) : a < b;
    };
    for (uint64_t row = first + 1; row < end; ++row) {
        const int64_t value = c.integer(row);
        if (less(value, low)) low = value;
        if (less(high, value)) high = value;
    }
    return std::pair(plot::WholeNumber{static_cast<uint64_t>(low), isUnsigned},
                     plot::WholeNumber{static_cast<uint64_t>(high), isUnsigned});
}

std::vector<SignalGap> ColumnSource::gaps(int64_t from, int64_t to) const {
    std::vector<SignalGap> result;
    for (const SignalGap& gap : column().gaps())
        if (gap.from < to && gap.to > from) result.push_back(gap);
    return result;
}

struct TraceFeed::Channel {
    std::string expression;
    waveform::Derivation derivation;          // what of it a scan gives, and what is computed from that
    std::optional<waveform::Deriver> deriver; // none: the plain value
    bool isTrigger = false;                   // every scan
    ChannelType type;
    Message problem;
    std::shared_ptr<ColumnSource> source; // null while there is a problem
    bool hasStarted = false;
    Position last = 0;                     // newest position read
    int64_t lastTime = 0;                  // and its time
    bool hasLost = false;                  // scans behind it left the recording before they were read
    std::optional<SignalGap::Reason> open; // since openFrom there has been no value, for this reason
    int64_t openFrom = 0;
};

Result<ChannelType> channelTypeOf(const Recording& recording, const std::string& text,
                                  waveform::Derivation* derivation) {
    auto parsed = waveform::parseDerivation(text);
    if (!parsed) return parsed.error();
    if (derivation) *derivation = *parsed;
    // what is no number gives none of its derivatives either: the expression's own problem says so
    auto type = recording.typeOf(parsed->expression);
    if (!type || parsed->isPlain()) return type;
    return ChannelType{.kind = history::ColumnKind::Double, .name = "LREAL"};
}

TraceFeed::TraceFeed(const Recording& recording, std::shared_ptr<history::ColumnStore> store)
    : m_recording(recording), m_store(std::move(store)) {}

TraceFeed::~TraceFeed() {
    for (auto& channel : m_channels)
        if (channel->source) m_store->remove(channel->source->id());
}

void TraceFeed::restart(Channel& channel) {
    channel.hasStarted = channel.hasLost = false;
    channel.lastTime = 0;
    channel.open.reset();
    if (channel.deriver) channel.deriver->restart();
    if (!channel.source) return;
    channel.source->column().clear();
    channel.source->changed();
}

void TraceFeed::setSettings(const FeedSettings& settings) {
    if (settings == m_settings) return;
    m_settings = settings;
    for (auto& channel : m_channels)
        if (!channel->isTrigger) restart(*channel);
}

void TraceFeed::setExpressions(const std::vector<std::string>& expressions, const std::string& trigger) {
    std::vector<std::unique_ptr<Channel>> channels;
    const auto keep = [&](const std::string& expression, bool isTrigger) {
        auto same = [&](const std::unique_ptr<Channel>& c) {
            return c && c->expression == expression && c->isTrigger == isTrigger;
        };
        if (std::any_of(channels.begin(), channels.end(), same)) return;
        if (const auto old = std::find_if(m_channels.begin(), m_channels.end(), same); old != m_channels.end()) {
            channels.push_back(std::move(*old));
            return;
        }
        auto channel = std::make_unique<Channel>();
        channel->expression = expression;
        channel->isTrigger = isTrigger;
        channels.push_back(std::move(channel));
    };
    for (const std::string& expression : expressions) keep(expression, false);
    if (!trigger.empty()) keep(trigger, true);
    for (auto& gone : m_channels)
        if (gone && gone->source) m_store->remove(gone->source->id());
    m_channels = std::move(channels);
    retryProblems();
}

void TraceFeed::retryProblems() {
    for (auto& channel : m_channels) {
        if (channel->source) continue;
        const auto type = channelTypeOf(m_recording, channel->expression, &channel->derivation);
        channel->problem = type ? Message() : type.error().message;
        if (!type) continue;
        channel->type = *type;
        channel->deriver.reset();
        if (!channel->derivation.isPlain()) channel->deriver.emplace(channel->derivation);
        const auto kind = type->isBool      ? plot::PlotValueKind::Bool
                          : type->isInteger ? plot::PlotValueKind::Integer
                          : type->isSingle  ? plot::PlotValueKind::Single
                                            : plot::PlotValueKind::Double;
        channel->source = std::make_shared<ColumnSource>(m_store, m_store->add(type->kind), kind);
        restart(*channel);
    }
}

std::shared_ptr<const ColumnSource> TraceFeed::source(const std::string& expression) const {
    for (const auto& channel : m_channels)
        if (channel->expression == expression && !channel->isTrigger) return channel->source;
    return nullptr;
}

std::shared_ptr<const ColumnSource> TraceFeed::triggerSource() const {
    for (const auto& channel : m_channels)
        if (channel->isTrigger) return channel->source;
    return nullptr;
}

const ChannelType* TraceFeed::type(const std::string& expression) const {
    for (const auto& channel : m_channels)
        if (channel->expression == expression && channel->source) return &channel->type;
    return nullptr;
}

Message TraceFeed::problem(const std::string& expression) const {
    for (const auto& channel : m_channels)
        if (channel->expression == expression) return channel->problem;
    return {};
}

void TraceFeed::refreshChain() {
    const std::vector<history::Branch> branches = m_recording.branches();
    const Position end = m_recording.extent().second;
    m_chain = history::chainTo(branches, end);
    if (branches.size() == m_branches) return;
    // The controller went back: what was recorded after the scan it continues from is no longer the past of the
    // present.
    m_branches = branches.size();
    for (auto& channel : m_channels) {
        if (!channel->source || !channel->hasStarted) continue;
        const bool stillThere = std::any_of(m_chain.begin(), m_chain.end(), [&](const PositionRange& r) {
            return channel->last >= r.begin && channel->last < r.end;
        });
        if (stillThere) continue;
        const auto kept = [&]() -> std::optional<Position> { // the newest position read that is still on the chain
            for (size_t i = m_chain.size(); i-- > 0;)
                if (m_chain[i].begin <= channel->last) return std::min(channel->last, m_chain[i].end - 1);
            return std::nullopt;
        }();
        const auto stamp = kept ? m_recording.stamp(*kept) : std::nullopt;
        if (!stamp || channel->deriver) { // what is computed from samples before needs them again
            restart(*channel);
            continue;
        }
        channel->last = *kept;
        channel->lastTime = stamp->time.count();
        channel->source->column().truncateAfter(channel->lastTime);
        if (channel->open && channel->openFrom >= channel->lastTime) channel->open.reset();
        channel->source->changed();
    }
}

/// `asked`: which scans; those that are not among the samples left the recording meanwhile.
void TraceFeed::append(Channel& channel, PositionRange asked, const std::vector<history::Sample>& samples,
                       const std::vector<history::Sample>& condition) {
    Column& column = channel.source->column();
    size_t c = 0;
    Position expected = asked.begin;
    for (const history::Sample& sample : samples) {
        const int64_t time = sample.at.time.count();
        channel.hasLost = channel.hasLost || sample.at.position != expected;
        expected = sample.at.position + 1;
        if (std::exchange(channel.hasLost, false)) column.appendGap(channel.lastTime, time, SignalGap::Reason::Evicted);
        std::optional<SignalGap::Reason> missing;
        if (!sample.hasValue) missing = SignalGap::Reason::NoPath;
        if (!channel.isTrigger && (!condition.empty() || !m_settings.condition.empty())) {
            while (c < condition.size() && condition[c].at.position < sample.at.position) ++c;
            const bool holds = c < condition.size() && condition[c].at.position == sample.at.position &&
                               condition[c].hasValue && condition[c].value != 0;
            if (!holds) missing = SignalGap::Reason::NotRecorded;
        }
        const double value = channel.deriver ? channel.deriver->next(static_cast<double>(time) * 1e-9,
                                                                     sample.hasValue ? sample.value : std::nan(""))
                                             : sample.value;
        const bool skipped = !channel.isTrigger && m_settings.every > 1 && sample.at.scan % m_settings.every != 0;
        if (missing) {
            if (!channel.open || *channel.open != *missing) {
                const int64_t from =
                    column.isEmpty() ? time
                                     : std::max(column.lastTime(), channel.open ? channel.lastTime : column.lastTime());
                if (channel.open) column.appendGap(channel.openFrom, time, *channel.open);
                channel.open = missing;
                channel.openFrom = channel.open && !column.isEmpty() ? from : time;
            }
        } else if (!skipped) {
            if (channel.open) {
                column.appendGap(channel.openFrom, time, *channel.open);
                channel.open.reset();
            }
            const bool isWide =
                column.kind() == history::ColumnKind::Int64 || column.kind() == history::ColumnKind::Uint64;
            isWide ? column.appendInteger(time, sample.integer) : column.append(time, value);
        }
        channel.last = sample.at.position;
        channel.lastTime = time;
    }
    channel.hasLost = channel.hasLost || expected != asked.end;
    channel.source->changed();
}

bool TraceFeed::readSlice(Channel& channel) {
    const Position oldest = m_recording.extent().first;
    std::optional<Position> from;
    if (!channel.hasStarted) {
        for (const PositionRange& range : m_chain)
            if (oldest < range.end && range.begin < range.end) {
                from = std::max(oldest, range.begin);
                break;
            }
        channel.hasLost = from && *from > 0;
    } else {
        from = nextOnChain(m_chain, channel.last);
    }
    if (!from) return true;
    if (*from < oldest) { // left the history before we came to read it
        for (const PositionRange& range : m_chain)
            if (oldest < range.end) {
                from = std::max(oldest, range.begin);
                break;
            }
        channel.hasLost = true;
    }
    const auto range = std::find_if(m_chain.begin(), m_chain.end(),
                                    [&](const PositionRange& r) { return *from >= r.begin && *from < r.end; });
    if (range == m_chain.end()) return true;
    const Position to = std::min(range->end, *from + Slice);
    const auto samples = m_recording.samples(channel.derivation.expression, *from, to);
    const auto condition = m_settings.condition.empty() ? std::vector<history::Sample>()
                                                        : m_recording.samples(m_settings.condition, *from, to);
    channel.hasStarted = true;
    append(channel, {*from, to}, samples, condition);
    channel.last = to - 1; // also when the slice was evicted meanwhile
    return !nextOnChain(m_chain, channel.last);
}

bool TraceFeed::pump(std::chrono::steady_clock::duration budget) {
    const auto until = std::chrono::steady_clock::now() + budget;
    refreshChain();
    bool done = false;
    while (!done) {
        done = true;
        for (auto& channel : m_channels) {
            if (!channel->source) continue;
            done = readSlice(*channel) && done;
            if (std::chrono::steady_clock::now() >= until) {
                m_store->enforceBudget();
                return false;
            }
        }
    }
    m_store->enforceBudget();
    return true;
}

void TraceFeed::pumpAll() {
    while (!pump(std::chrono::hours(1))) {
    }
}

} // namespace plc::trace
