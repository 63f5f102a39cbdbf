// What a chart draws: samples over time, asked for in buckets. Pure C++; the source decides how samples are kept.
// A source is owned by whoever fills it and read on the window's thread only.
#pragma once
#include "runtime/base/signal.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace plc::plot {

enum class PlotValueKind : uint8_t { Bool, Integer, Single, Double };

/// A 64-bit integer of either kind: what a double may not hold.
struct WholeNumber {
    uint64_t bits = 0;
    bool isUnsigned = false;
    bool operator==(const WholeNumber&) const = default;
};

class SampleSource {
public:
    using Visitor = std::function<void(std::span<const SignalSample>)>;

    virtual ~SampleSource() = default;
    [[nodiscard]] virtual PlotValueKind valueKind() const { return PlotValueKind::Double; }
    /// First and last sample's time; none while empty.
    [[nodiscard]] virtual std::optional<std::pair<int64_t, int64_t>> timeRange() const = 0;
    /// Samples in [from, to).
    [[nodiscard]] virtual uint64_t countIn(int64_t from, int64_t to) const = 0;
    /// Splits [from, to) into out.size() equal parts.
    virtual void buckets(int64_t from, int64_t to, std::span<SignalBucket> out) const = 0;
    /// Samples in [from, to), in order, in blocks.
    virtual void visit(int64_t from, int64_t to, const Visitor& visitor) const = 0;
    /// The last sample at or before `time`.
    [[nodiscard]] virtual std::optional<SignalSample> inForceAt(int64_t time) const = 0;
    /// The first sample after `time`.
    [[nodiscard]] virtual std::optional<SignalSample> after(int64_t time) const = 0;
    /// The value in force at `time` without rounding, where the source keeps it so.
    [[nodiscard]] virtual std::optional<WholeNumber> integerAt(int64_t) const { return std::nullopt; }
    /// Least and greatest of the samples in [from, to], likewise.
    [[nodiscard]] virtual std::optional<std::pair<WholeNumber, WholeNumber>> integerExtent(int64_t, int64_t) const {
        return std::nullopt;
    }
    [[nodiscard]] virtual std::vector<SignalGap> gaps(int64_t from, int64_t to) const = 0;
    /// Grows whenever samples are added or leave, so that pictures of them can be kept.
    [[nodiscard]] virtual uint64_t revision() const = 0;
};

/// The sample nearest to `time`.
[[nodiscard]] std::optional<SignalSample> nearestSample(const SampleSource& source, int64_t time);

/// Samples in memory without a pyramid: trends of a panel, tests, a few hundred thousand at most.
class SampleList final : public SampleSource {
public:
    explicit SampleList(PlotValueKind kind = PlotValueKind::Double) : m_kind(kind) {}

    /// Times must grow; others are ignored.
    void append(int64_t time, double value);
    void addGap(SignalGap gap);
    void keepNewest(size_t samples);
    void clear();

    PlotValueKind valueKind() const override { return m_kind; }
    std::optional<std::pair<int64_t, int64_t>> timeRange() const override;
    uint64_t countIn(int64_t from, int64_t to) const override;
    void buckets(int64_t from, int64_t to, std::span<SignalBucket> out) const override;
    void visit(int64_t from, int64_t to, const Visitor& visitor) const override;
    std::optional<SignalSample> inForceAt(int64_t time) const override;
    std::optional<SignalSample> after(int64_t time) const override;
    std::vector<SignalGap> gaps(int64_t from, int64_t to) const override;
    uint64_t revision() const override { return m_revision; }

private:
    [[nodiscard]] size_t indexAtOrAfter(int64_t time) const;

    PlotValueKind m_kind;
    std::vector<SignalSample> m_samples;
    std::vector<SignalGap> m_gaps;
    uint64_t m_revision = 0;
};

/// Text that reads back the same, shortest for the value's kind.
[[nodiscard]] std::string exactText(double value, PlotValueKind kind);
/// All digits, the last `decimals` of them behind the point, without trailing zeros there.
[[nodiscard]] std::string exactText(WholeNumber number, int decimals = 0);
/// b - a, likewise.
[[nodiscard]] std::string exactDifference(WholeNumber a, WholeNumber b, int decimals = 0);

} // namespace plc::plot
