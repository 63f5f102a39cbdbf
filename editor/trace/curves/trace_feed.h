// Carries channels from a recording into the column store, a slice at a time, so that the window never waits: new scans
// first come first, long pasts are filled in over many calls. Follows branches after going back. Owned by the trace
// view; its thread.
#pragma once

#include "editor/plot/model/plot_sample.h"
#include "editor/trace/recording/recording.h"
#include "projects/waveform/derivation.h"

#include <chrono>

namespace plc::trace {

struct FeedSettings {
    uint32_t every = 1;    // every n-th scan
    std::string condition; // only while this holds
    bool operator==(const FeedSettings&) const = default;
};

/// A column as a chart reads it.
class ColumnSource final : public plot::SampleSource {
public:
    ColumnSource(std::shared_ptr<history::ColumnStore> store, history::ColumnId id, plot::PlotValueKind kind)
        : m_store(std::move(store)), m_id(id), m_kind(kind) {}

    plot::PlotValueKind valueKind() const override { return m_kind; }
    std::optional<std::pair<int64_t, int64_t>> timeRange() const override;
    uint64_t countIn(int64_t from, int64_t to) const override { return column().countIn(from, to); }
    void buckets(int64_t from, int64_t to, std::span<SignalBucket> out) const override;
    void visit(int64_t from, int64_t to, const Visitor& visitor) const override;
    std::optional<SignalSample> inForceAt(int64_t time) const override;
    std::optional<SignalSample> after(int64_t time) const override;
    std::optional<plot::WholeNumber> integerAt(int64_t time) const override;
    std::optional<std::pair<plot::WholeNumber, plot::WholeNumber>> integerExtent(int64_t from,
                                                                                 int64_t to) const override;
    std::vector<SignalGap> gaps(int64_t from, int64_t to) const override;
    uint64_t revision() const override { return m_revision; }
    void changed() { ++m_revision; }

    const history::Column& column() const { return m_store->column(m_id); }
    history::Column& column() { return m_store->column(m_id); }
    history::ColumnId id() const { return m_id; }

private:
    std::shared_ptr<history::ColumnStore> m_store;
    history::ColumnId m_id;
    plot::PlotValueKind m_kind;
    uint64_t m_revision = 0;
};

/// Of a channel's text: an expression, or DERIVATIVE, INTEGRAL, FILTER around one.
[[nodiscard]] Result<ChannelType> channelTypeOf(const Recording& recording, const std::string& text,
                                                waveform::Derivation* derivation = nullptr);

class TraceFeed {
public:
    TraceFeed(const Recording& recording, std::shared_ptr<history::ColumnStore> store);
    ~TraceFeed();

    void setSettings(const FeedSettings& settings); // reads everything again
    /// Keeps columns for exactly these expressions; those already there stay.
    /// `trigger` looks at every scan, whatever the settings leave out.
    void setExpressions(const std::vector<std::string>& expressions, const std::string& trigger = {});
    [[nodiscard]] std::shared_ptr<const ColumnSource> triggerSource() const;
    /// Null when the expression is not among them; its problem then says why.
    [[nodiscard]] std::shared_ptr<const ColumnSource> source(const std::string& expression) const;
    [[nodiscard]] const ChannelType* type(const std::string& expression) const;
    [[nodiscard]] Message problem(const std::string& expression) const;
    /// After an online change: expressions that were bad may be good now.
    void retryProblems();

    /// Reads for at most `budget`; true when everything recorded so far has been read.
    bool pump(std::chrono::steady_clock::duration budget);
    /// Reads everything that is recorded now.
    void pumpAll();
    [[nodiscard]] const std::vector<PositionRange>& chain() const { return m_chain; }
    [[nodiscard]] history::ColumnStore& store() { return *m_store; }

private:
    struct Channel;
    void refreshChain();
    bool readSlice(Channel& channel);
    void append(Channel& channel, PositionRange asked, const std::vector<history::Sample>& samples,
                const std::vector<history::Sample>& condition);
    void restart(Channel& channel);

    const Recording& m_recording;
    std::shared_ptr<history::ColumnStore> m_store;
    FeedSettings m_settings;
    std::vector<std::unique_ptr<Channel>> m_channels;
    std::vector<PositionRange> m_chain;
    size_t m_branches = 0;
};

} // namespace plc::trace
