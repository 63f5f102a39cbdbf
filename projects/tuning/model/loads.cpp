#include "projects/tuning/model/errors.h"
#include "projects/tuning/model/find.h"

#include <algorithm>
#include <cmath>

namespace plc::tuning {

namespace {

constexpr size_t kAverage = 9;  // samples of a moving mean, where there is noise
constexpr size_t kCalm = 60;    // samples near the set point that are rest
constexpr size_t kLeast = 15;   // samples of a disturbance
constexpr double kShare = 0.01; // of the output's range: less is nothing
constexpr double kSigmas = 4;   // of the output's noise, for the moving mean

/// Measured less set point, averaged where there is noise.
std::vector<double> errorOf(const LoopSeries& series, double noise) {
    const size_t count = series.size();
    std::vector<double> out(count);
    for (size_t i = 0; i < count; ++i) out[i] = series.output[i] - series.setPoint[i];
    if (noise <= 0 || count < kAverage) return out;
    std::vector<double> mean(count);
    double sum = 0;
    constexpr size_t kHalf = kAverage / 2;
    for (size_t i = 0; i < count + kHalf; ++i) {
        if (i < count) sum += out[i];
        if (i >= kAverage) sum -= out[i - kAverage];
        if (i >= kHalf)
            mean[i - kHalf] = sum / static_cast<double>(std::min(i + 1, kAverage) - (i >= count ? i + 1 - count : 0));
    }
    return mean;
}

/// Walks along the recording: at rest, moved by a change that is known, moved by something else.
class LoadFinder {
public:
    LoadFinder(const LoopSeries& series, const std::vector<FoundStep>& steps)
        : m_series(series), m_steps(steps), m_noise(noiseOf(series.output)), m_error(errorOf(series, m_noise)) {
        const auto range = [](const std::vector<double>& values) {
            return std::minmax_element(values.begin(), values.end());
        };
        const auto [low, high] = range(series.output);
        m_threshold = std::max(kSigmas * m_noise, kShare * (*high - *low));
        const auto [least, greatest] = range(series.input);
        m_inputLow = *least, m_inputHigh = *greatest;
    }
    [[nodiscard]] std::vector<FoundStep> find();

private:
    /// In shares of the threshold; rest is a narrower band than what a disturbance has to leave.
    [[nodiscard]] bool isWithin(size_t i, double share) const {
        return std::abs(m_error[i] - m_level) <= share * m_threshold;
    }
    void rest(size_t i);
    void knownChange(const FoundStep& step);
    [[nodiscard]] size_t onset(size_t i) const;
    void close(size_t settled, bool isOver);
    void judge(FoundStep& load, bool isOver) const;
    [[nodiscard]] bool hasGap(const FoundStep& load) const;

    const LoopSeries& m_series;
    const std::vector<FoundStep>& m_steps;
    double m_noise = 0;
    std::vector<double> m_error;
    double m_threshold = 0, m_inputLow = 0, m_inputHigh = 0;
    double m_level = 0; // of the error at rest
    size_t m_calm = 0;  // samples in a row
    double m_calmSum = 0;
    size_t m_since = 0; // of what moves the process
    size_t m_floor = 0; // where it was at rest again
    size_t m_until = 0; // the end of a ramp
    bool m_isAtRest = false, m_mustMove = false;
    std::optional<size_t> m_load; // its onset
    std::vector<FoundStep> m_out;
};

/// A step by hand acts after a dead time: that it is calm at first means nothing.
void LoadFinder::knownChange(const FoundStep& step) {
    // the mean reaches ahead of what is known
    if (m_load && step.step - *m_load <= kAverage) m_load.reset();
    if (m_load) close(step.step, false);
    m_isAtRest = false;
    m_mustMove = step.moved == Moved::Input;
    m_calm = 0;
    m_since = step.step;
    m_until = step.settled < m_series.size() ? step.settled : step.step;
}

/// At rest after a while near the set point: longer after what took longer.
void LoadFinder::rest(size_t i) {
    if (++m_calm == 1) m_calmSum = 0;
    m_calmSum += m_error[i];
    if (m_calm < std::max(kCalm, (i - m_since) / 4) || m_mustMove) return;
    if (m_load) close(i, true);
    m_isAtRest = true;
    m_floor = i + 1 - m_calm;
    m_level = m_calmSum / static_cast<double>(m_calm);
}

size_t LoadFinder::onset(size_t i) const {
    while (i > m_floor && !isWithin(i, 0.25)) --i;
    return i;
}

bool LoadFinder::hasGap(const FoundStep& load) const {
    constexpr double kMost = 5; // usual intervals
    const double longest = kMost * usualInterval(m_series);
    for (size_t i = load.begin + 1; i < load.end; ++i)
        if (m_series.time[i] - m_series.time[i - 1] > longest &&
            std::abs(m_series.output[i] - m_series.output[i - 1]) > m_threshold)
            return true;
    return false;
}

void LoadFinder::judge(FoundStep& load, bool isOver) const {
    const auto say = [&](Verdict verdict, Message reason) {
        load.verdict = verdict;
        load.reason = std::move(reason);
    };
    const size_t length = load.end - load.step;
    if (length < kLeast) return say(Verdict::TooShort, errors::StepTooShort(length));
    if (hasGap(load)) return say(Verdict::Disturbed, errors::StepHasGap());
    if (!isOver) return say(Verdict::TooShort, errors::LoadNotOver());
    const auto begin = m_series.input.begin();
    const auto [low, high] = std::minmax_element(begin + static_cast<std::ptrdiff_t>(load.step),
                                                 begin + static_cast<std::ptrdiff_t>(load.end));
    if (*high - *low <= 1e-9 * (m_inputHigh - m_inputLow)) return say(Verdict::Unanswered, errors::LoadUnanswered());
    const double near = 1e-6 * (m_inputHigh - m_inputLow);
    size_t limited = 0;
    for (size_t i = load.step; i < load.settled; ++i) // what follows is rest
        limited += m_series.input[i] <= m_inputLow + near || m_series.input[i] >= m_inputHigh - near;
    const size_t moving = std::max<size_t>(load.settled - load.step, 1);
    if (limited * 10 > moving * 6) return say(Verdict::Saturated, errors::StepSaturated(limited * 100 / moving));
    constexpr double kClear = 1.5; // times what counts as calm
    if (m_noise > 0 && load.outputChange < kClear * kSigmas * m_noise)
        return say(Verdict::Noisy, errors::StepNoisy(std::round(load.signalToNoise * 10) / 10));
    say(Verdict::Usable, errors::StepUsable());
}

void LoadFinder::close(size_t settled, bool isOver) {
    FoundStep load;
    load.moved = Moved::Load;
    load.step = *m_load;
    load.settled = isOver ? settled + 1 - m_calm : settled;
    load.end = settled;
    const size_t before = std::max<size_t>((load.end - load.step) / 8, 10);
    load.begin = std::max(m_floor, load.step > before ? load.step - before : 0);
    for (size_t i = load.step; i < load.end; ++i)
        load.outputChange = std::max(load.outputChange, std::abs(m_error[i] - m_level));
    load.signalToNoise = m_noise > 0 ? load.outputChange / m_noise : 1e6;
    load.from = meanOf(m_series.input, load.begin, std::max(load.step, load.begin + 1));
    load.to = meanOf(m_series.input, std::min(load.settled, load.end - 1), load.end);
    judge(load, isOver);
    m_out.push_back(std::move(load));
    m_load.reset();
}

std::vector<FoundStep> LoadFinder::find() {
    auto next = m_steps.begin();
    for (size_t i = 0; i < m_error.size(); ++i) {
        for (; next != m_steps.end() && next->step <= i; ++next) knownChange(*next);
        if (i < m_until) continue;
        constexpr double kNarrow = 0.5;
        if (isWithin(i, kNarrow)) {
            rest(i);
            continue;
        }
        m_calm = 0;
        if (isWithin(i, 1)) continue;
        m_mustMove = false;
        if (!m_isAtRest) continue;
        m_isAtRest = false;
        m_load = onset(i);
        m_since = *m_load;
    }
    if (m_load && *m_load + 1 < m_series.size()) close(m_series.size(), false);
    return std::move(m_out);
}

} // namespace

std::vector<FoundStep> findLoads(const LoopSeries& series, const std::vector<FoundStep>& steps) {
    if (series.setPoint.empty() || series.size() < kCalm) return {};
    return LoadFinder(series, steps).find();
}

} // namespace plc::tuning
