#include "projects/tuning/model/find.h"

#include "projects/tuning/model/errors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plc::tuning {

namespace {

double median(std::vector<double>& values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// A change of a signal that is quiet before and after: [start, settled), from one level to the other.
struct Change {
    size_t start = 0, settled = 0;
    double from = 0, to = 0;
};

/// A level, the mean of what stays within a tolerance of it.
class Level {
public:
    void begin(double value) { m_mean = value, m_count = 1; }
    void add(double value) { m_mean += (value - m_mean) / static_cast<double>(++m_count); }
    [[nodiscard]] double mean() const { return m_mean; }
    [[nodiscard]] size_t count() const { return m_count; }

private:
    double m_mean = 0;
    size_t m_count = 0;
};

constexpr size_t kQuiet = 8; // samples that make a level

/// Where the next level begins: so many samples that stay near each other.
size_t nextLevel(const std::vector<double>& values, size_t from, double tolerance, size_t quiet) {
    size_t begin = from;
    double low = values[from], high = values[from];
    for (size_t i = from; i < values.size(); ++i) {
        low = std::min(low, values[i]);
        high = std::max(high, values[i]);
        if (high - low > 2 * tolerance) {
            // start again behind the last sample that is too far from this one
            begin = i;
            low = high = values[i];
            while (begin > from && std::abs(values[begin - 1] - values[i]) <= tolerance) {
                --begin;
                low = std::min(low, values[begin]);
                high = std::max(high, values[begin]);
            }
        }
        if (i - begin + 1 >= quiet) return begin;
    }
    return values.size();
}

/// A ramp with noise on it looks like a stair: steps in the same direction that follow each other at once are one.
std::vector<Change> joined(const std::vector<Change>& changes) {
    std::vector<Change> out;
    for (const Change& change : changes) {
        if (!out.empty()) {
            Change& before = out.back();
            const bool isOnward = (change.to - change.from) * (before.to - before.from) > 0;
            const size_t rest = change.start - std::min(change.start, before.settled);
            if (isOnward && rest <= std::max(2 * kQuiet, before.settled - before.start)) {
                before.settled = change.settled;
                before.to = change.to;
                continue;
            }
        }
        out.push_back(change);
    }
    return out;
}

std::vector<Change> changesOf(const std::vector<double>& values) {
    std::vector<Change> out;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double noise = noiseOf(values);
    if (!(*high - *low > 8 * noise) || *high == *low) return out;
    const double tolerance = std::max(4.5 * noise, 1e-6 * (*high - *low));
    // one stray sample is no step where there is noise
    const size_t needed = noise > 0 ? 3 : 1;
    Level level;
    level.begin(values[0]);
    size_t away = 0;
    for (size_t i = 1; i < values.size(); ++i) {
        if (std::abs(values[i] - level.mean()) <= tolerance) {
            level.add(values[i]);
            away = 0;
            continue;
        }
        if (++away < needed && i + 1 < values.size()) continue;
        const size_t start = i + 1 - away;
        const size_t settled = nextLevel(values, start, tolerance, kQuiet);
        const size_t last = std::min(settled + kQuiet, values.size());
        const double to = settled < values.size()
                              ? std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(settled),
                                                values.begin() + static_cast<std::ptrdiff_t>(last), 0.0) /
                                    static_cast<double>(last - settled)
                              : values.back();
        out.push_back({start, settled, level.mean(), to});
        if (settled >= values.size()) break;
        level.begin(to);
        i = last - 1;
        away = 0;
    }
    return joined(out);
}

bool staysPut(const std::vector<double>& values, size_t begin, size_t end, double tolerance) {
    for (size_t i = begin; i < end; ++i)
        if (std::abs(values[i] - values[begin]) > tolerance) return false;
    return true;
}

struct Context {
    const LoopSeries& series;
    double noise = 0; // of the output
    double inputRange = 0, inputLow = 0, inputHigh = 0;
    double outputLow = 0, outputHigh = 0;
};

/// The output in so many blocks: their means.
std::vector<double> blockMeans(const std::vector<double>& values, size_t begin, size_t end, size_t blocks) {
    std::vector<double> out;
    blocks = std::min(blocks, end - begin);
    for (size_t i = 0; i < blocks; ++i)
        out.push_back(meanOf(values, begin + (end - begin) * i / blocks, begin + (end - begin) * (i + 1) / blocks));
    return out;
}

/// Until where a signal moves, as a share of the samples after the step. Small blocks show it best; where noise hides
/// the movement in them, longer ones are looked at.
double lastMove(const std::vector<double>& values, const FoundStep& step, double noise) {
    const size_t length = step.end - step.step;
    for (const size_t blocks : {200U, 50U, 20U}) {
        const std::vector<double> means = blockMeans(values, step.step, step.end, blocks);
        const double rest = meanOf(means, means.size() * 9 / 10, means.size());
        double greatest = 0;
        for (const double mean : means) greatest = std::max(greatest, std::abs(mean - rest));
        const double perBlock = noise / std::sqrt(static_cast<double>(length) / static_cast<double>(blocks));
        constexpr double kClear = 6, kMoved = 4; // deviations of a block's mean
        const double tolerance = std::max(0.01 * greatest, kMoved * perBlock);
        if (greatest < kClear * perBlock) continue;
        for (size_t i = means.size(); i > 0; --i)
            if (std::abs(means[i - 1] - rest) > tolerance)
                return static_cast<double>(i + 1) / static_cast<double>(means.size());
    }
    return 0;
}

/// Cuts off what comes after everything has come to rest; twice, for the first look is coarse.
void cutRest(const Context& context, FoundStep& step) {
    for (int pass = 0; pass < 3; ++pass) {
        const size_t length = step.end - step.step;
        if (length < 200) return;
        double last = lastMove(context.series.output, step, context.noise);
        if (step.moved == Moved::SetPoint)
            last = std::max(last, lastMove(context.series.input, step, noiseOf(context.series.input)));
        const size_t wanted = std::max<size_t>(static_cast<size_t>(static_cast<double>(length) * last * 1.6), 60);
        if (wanted * 10 > length * 9) return;
        step.end = step.step + std::max(wanted, step.settled - step.step + 30);
        if (step.end - step.step >= length) {
            step.end = step.step + length;
            return;
        }
    }
}

/// Scans that a busy machine left out, or a stretch that was not recorded; a table that has only the changes has none.
bool hasGap(const LoopSeries& series, const FoundStep& step, double noise) {
    constexpr double kMost = 5; // usual intervals
    const double longest = kMost * usualInterval(series);
    for (size_t i = step.begin + 1; i < step.end; ++i)
        if (series.time[i] - series.time[i - 1] > longest &&
            std::abs(series.output[i] - series.output[i - 1]) > std::max(0.02 * step.outputChange, 5 * noise))
            return true;
    return false;
}

/// Share of the samples in per cent at which a sensor is at the end of its range: the measured value rises, stops all
/// at once and stays exactly there, at the greatest or least value of the whole recording.
size_t cutOff(const Context& context, const FoundStep& step) {
    const std::vector<double>& values = context.series.output;
    const size_t length = step.end - step.step, window = std::max<size_t>(length / 50, 3);
    if (step.settled > step.step + 3 || length < 10 * window) return 0; // behind a ramp much stops all at once
    for (const double limit : {context.outputLow, context.outputHigh}) {
        const auto begin = values.begin() + static_cast<std::ptrdiff_t>(step.step);
        const auto end = values.begin() + static_cast<std::ptrdiff_t>(step.end);
        const auto count = static_cast<size_t>(std::count(begin, end, limit));
        const auto reached = static_cast<size_t>(std::find(begin, end, limit) - begin);
        if (count * 10 < length || reached < 3 * window || count * 10 < (length - reached) * 2) continue;
        const auto moved = [&](size_t at) {
            return std::abs(meanOf(values, step.step + at - 1, step.step + at + 1) -
                            meanOf(values, step.step + at - window - 1, step.step + at - window + 1));
        };
        double quickest = 0;
        for (size_t at = window + 1; at < reached; ++at) quickest = std::max(quickest, moved(at));
        if (moved(reached) > std::max(0.3 * quickest, 6 * context.noise)) return count * 100 / length;
    }
    return 0;
}

/// Share of the samples in per cent at which the controller's output is at a limit; the recording's own extremes where
/// no limit is known.
size_t atLimit(const Context& context, const FoundStep& step) {
    if (!(context.inputRange > 0)) return 0;
    const double near = 1e-6 * context.inputRange;
    const double low = context.series.low.value_or(context.inputLow) + near;
    const double high = context.series.high.value_or(context.inputHigh) - near;
    size_t limited = 0;
    for (size_t i = step.step; i < step.end; ++i)
        limited += context.series.input[i] <= low || context.series.input[i] >= high;
    return limited * 100 / std::max<size_t>(step.end - step.step, 1);
}

/// By hand to where the valve cannot go further: what was meant may have been more.
bool isPutToLimit(const LoopSeries& series, const FoundStep& step) {
    return step.moved == Moved::Input &&
           ((series.low && step.to <= *series.low) || (series.high && step.to >= *series.high));
}

/// The greatest movement of the output, and what noise alone would make of it.
struct Answer {
    double change = 0, deviation = 0;
};

/// In blocks of the length in which it stands out most from the noise: a small step is seen in a long mean.
Answer answerOf(const Context& context, const FoundStep& step, double before) {
    const size_t after = step.end - step.step;
    const double ofBefore = 1 / static_cast<double>(std::max<size_t>(step.step - step.begin, 1));
    Answer out;
    for (const size_t most : {60U, 15U, 4U}) {
        const size_t blocks = std::min(after, size_t{most});
        Answer found;
        for (const double mean : blockMeans(context.series.output, step.step, step.end, blocks))
            found.change = std::max(found.change, std::abs(mean - before));
        const double ofBlock = static_cast<double>(blocks) / static_cast<double>(after);
        found.deviation = context.noise * std::sqrt(ofBlock + (most < 60 ? ofBefore : 0));
        if (out.change == 0 || found.change * out.deviation > out.change * found.deviation) out = found;
        constexpr double kClear = 6; // then the shortest shows best how far it goes
        if (out.change > kClear * out.deviation) break;
    }
    return out;
}

void judge(const Context& context, FoundStep& step) {
    const LoopSeries& series = context.series;
    const size_t after = step.end - step.step;
    const double before = meanOf(series.output, step.begin, std::max(step.step, step.begin + 1));
    const Answer answer = answerOf(context, step, before);
    step.outputChange = answer.change;
    step.signalToNoise = context.noise > 0 ? answer.change / context.noise : answer.change > 0 ? 1e6 : 0;
    const auto say = [&](Verdict verdict, Message reason) {
        step.verdict = verdict;
        step.reason = std::move(reason);
    };
    constexpr size_t kLeast = 15;
    if (after < kLeast) return say(Verdict::TooShort, errors::StepTooShort(after));
    if (hasGap(series, step, context.noise)) return say(Verdict::Disturbed, errors::StepHasGap());
    constexpr size_t kOften = 60;
    if (const size_t share = step.moved == Moved::SetPoint ? atLimit(context, step) : 0; share > kOften)
        return say(Verdict::Saturated, errors::StepSaturated(share));
    if (const size_t share = cutOff(context, step); share > 0)
        return say(Verdict::Saturated, errors::StepCutOff(share));
    if (answer.change <= std::max(5 * answer.deviation, 0.5 * context.noise) || answer.change <= 0)
        return say(Verdict::Noisy, errors::StepNoisy(std::round(step.signalToNoise * 10) / 10));
    // at rest: the two halves of what was before agree
    const size_t half = step.begin + (step.step - step.begin) / 2;
    const double drift = std::abs(meanOf(series.output, step.begin, half) - meanOf(series.output, half, step.step));
    const double ofHalf = context.noise / std::sqrt(static_cast<double>(std::max<size_t>(half - step.begin, 1)));
    step.startsAtRest = half > step.begin && drift <= std::max(0.001 * answer.change, 4 * ofHalf);
    say(Verdict::Usable, !step.startsAtRest           ? errors::StepNotAtRest()
                         : isPutToLimit(series, step) ? errors::StepAtLimit()
                                                      : errors::StepUsable());
}

/// What a whole number of a converter moves by at least; 0 where the values never repeat.
double quantumOf(const std::vector<double>& values, size_t begin, size_t end) {
    double quantum = 0;
    bool repeats = false;
    for (size_t i = begin + 1; i < end; ++i) {
        const double moved = std::abs(values[i] - values[i - 1]);
        if (moved == 0) repeats = true;
        if (moved > 0 && (quantum == 0 || moved < quantum)) quantum = moved;
    }
    return repeats ? quantum : 0;
}

/// From one level straight to the next, as a ramp goes; a controller does not.
bool isStraight(const std::vector<double>& values, const Change& change) {
    const double height = change.to - change.from;
    const auto length = static_cast<double>(change.settled - change.start + 1);
    const double tolerance = std::max(0.002 * std::abs(height), 0.6 * quantumOf(values, change.start, change.settled));
    for (size_t i = change.start; i < change.settled; ++i) {
        const double share = static_cast<double>(i - change.start + 1) / length;
        if (std::abs(values[i] - change.from - share * height) > tolerance) return false;
    }
    return true;
}

/// Steps of the input count where it is put by hand: it keeps one value before and another after. Where no set point is
/// known, each counts.
bool isByHand(const LoopSeries& series, const Change& change, double range) {
    constexpr size_t kHeld = 12;
    if (series.setPoint.empty()) return true;
    if (std::abs(change.to - change.from) < 0.02 * range) return false;
    if (change.settled > change.start + 3 && !isStraight(series.input, change)) return false;
    const size_t before = change.start > kHeld ? change.start - kHeld : 0;
    const size_t after = std::min(change.settled + kHeld, series.size());
    const double tolerance = 1e-9 * range;
    return staysPut(series.input, before, change.start, tolerance) &&
           staysPut(series.input, change.settled, after, tolerance);
}

} // namespace

namespace {

/// Of an integer that comes and goes by one: most differences are 0, and so is their median.
double noiseOfSteps(const std::vector<double>& seconds) {
    double quantum = 0;
    size_t moved = 0;
    const double rounding = seconds.empty() ? 0 : 1e-6 * *std::max_element(seconds.begin(), seconds.end());
    for (const double second : seconds) {
        if (second <= rounding) continue;
        ++moved;
        if (quantum == 0 || second < quantum) quantum = second;
    }
    constexpr size_t kRare = 50; // of so many one: somebody moves it
    if (moved * kRare < seconds.size()) return 0;
    double sum = 0;
    for (const double second : seconds) sum += std::pow(std::min(second, 2 * quantum), 2);
    return std::sqrt(sum / static_cast<double>(seconds.size()) / 6);
}

} // namespace

double noiseOf(const std::vector<double>& values) {
    if (values.size() < 8) return 0;
    constexpr size_t kMost = 20'000;
    const size_t stride = std::max<size_t>((values.size() - 2) / kMost, 1);
    std::vector<double> seconds;
    for (size_t i = 1; i + 1 < values.size(); i += stride)
        seconds.push_back(std::abs(values[i - 1] - 2 * values[i] + values[i + 1]));
    const double ofSteps = noiseOfSteps(seconds);
    return std::max(median(seconds) / (0.6745 * std::sqrt(6.0)), ofSteps);
}

std::vector<FoundStep> findSteps(const LoopSeries& series) {
    std::vector<FoundStep> out;
    const auto add = [&](const Change& change, Moved moved) {
        FoundStep step;
        step.step = change.start;
        step.settled = change.settled;
        step.moved = moved;
        step.from = change.from;
        step.to = change.to;
        out.push_back(std::move(step));
    };
    if (!series.setPoint.empty())
        for (const Change& change : changesOf(series.setPoint)) add(change, Moved::SetPoint);
    Context context{series};
    context.noise = noiseOf(series.output);
    const auto [low, high] = std::minmax_element(series.input.begin(), series.input.end());
    context.inputLow = *low, context.inputHigh = *high, context.inputRange = *high - *low;
    const auto [least, greatest] = std::minmax_element(series.output.begin(), series.output.end());
    context.outputLow = *least, context.outputHigh = *greatest;
    for (const Change& change : changesOf(series.input))
        if (isByHand(series, change, context.inputRange)) add(change, Moved::Input);
    std::stable_sort(out.begin(), out.end(), [](const FoundStep& a, const FoundStep& b) { return a.step < b.step; });
    // what the set point does at once in the input is the same step
    constexpr size_t kTogether = 4;
    for (size_t i = 1; i < out.size();)
        if (out[i].moved == Moved::Input && out[i - 1].moved == Moved::SetPoint &&
            out[i].step <= out[i - 1].step + kTogether)
            out.erase(out.begin() + static_cast<std::ptrdiff_t>(i));
        else
            ++i;
    const std::vector<FoundStep> loads = findLoads(series, out);
    for (size_t i = 0; i < out.size(); ++i) {
        FoundStep& step = out[i];
        step.end = i + 1 < out.size() ? out[i + 1].step : series.size();
        for (const FoundStep& load : loads)
            if (load.step > step.step) step.end = std::min(step.end, load.step);
        cutRest(context, step);
        const size_t floor = i > 0 ? out[i - 1].settled : 0;
        const size_t wanted = std::max<size_t>((step.end - step.step) / 8, 10);
        step.begin = std::max(floor, step.step > wanted ? step.step - wanted : 0);
        step.begin = std::min(step.begin, step.step);
        judge(context, step);
        if (const size_t longer = (step.end - step.step) / 2; step.verdict == Verdict::Noisy && longer > wanted) {
            step.begin = std::max(floor, step.step - std::min(step.step, longer)); // a longer mean has less noise
            judge(context, step);
        }
        // the change before may still be at work where it left little time
        if (i > 0 && (step.step - floor) * 4 < step.end - step.step && step.isUsable()) {
            step.startsAtRest = false;
            step.reason = errors::StepNotAtRest();
        }
    }
    out.insert(out.end(), loads.begin(), loads.end());
    std::stable_sort(out.begin(), out.end(), [](const FoundStep& a, const FoundStep& b) { return a.step < b.step; });
    return out;
}

} // namespace plc::tuning
