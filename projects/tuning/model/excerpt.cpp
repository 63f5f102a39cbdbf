#include "projects/tuning/model/find.h"

#include <algorithm>
#include <cmath>

namespace plc::tuning {

namespace {

/// Cuts of the excerpt on the recording's own time.
struct Grid {
    double interval = 1;
    size_t before = 0, after = 0; // whole intervals on both sides of the step
    size_t stride = 0;            // samples in an interval; 0: the samples are uneven
};

/// One sample a scan. The times themselves may be rounded, to whole milliseconds for example, so that their distances
/// differ; counted in samples, nothing is shifted.
bool isEven(const LoopSeries& series, const FoundStep& step, double mean) {
    for (size_t i = step.begin + 1; i < step.end; ++i) {
        const double distance = series.time[i] - series.time[i - 1];
        const double ideal = series.time[step.begin] + mean * static_cast<double>(i - step.begin);
        if (std::abs(distance - mean) > 0.6 * mean || std::abs(series.time[i] - ideal) > 0.6 * mean) return false;
    }
    return true;
}

Grid gridOf(const LoopSeries& series, const FoundStep& step, size_t points) {
    const size_t samples = step.end - step.begin;
    const double from = series.time[step.begin], to = series.time[step.end - 1], at = series.time[step.step];
    const double mean = samples > 1 ? (to - from) / static_cast<double>(samples - 1) : 1;
    Grid grid;
    if (isEven(series, step, mean)) {
        grid.stride = std::max<size_t>((samples - 1) / points, 1);
        grid.interval = static_cast<double>(grid.stride) * mean;
        grid.before = (step.step - step.begin) / grid.stride;
        grid.after = (step.end - 1 - step.step) / grid.stride;
        return grid;
    }
    const double usual = usualInterval(series);
    grid.interval = std::max(std::floor((to - from) / static_cast<double>(points) / usual), 1.0) * usual;
    grid.before = static_cast<size_t>((at - from) / grid.interval + 1e-6);
    grid.after = static_cast<size_t>((to - at) / grid.interval + 1e-6);
    return grid;
}

/// The same number of samples on both sides of each instant, which delays nothing.
Excerpt evenExcerpt(const LoopSeries& series, const FoundStep& step, const Grid& grid, bool isNoisy) {
    Excerpt out{grid.interval, {}, {}, step.startsAtRest};
    const size_t beside = isNoisy ? (grid.stride - 1) / 2 : 0;
    for (size_t i = 0; i <= grid.before + grid.after; ++i) {
        const size_t at = step.step - grid.before * grid.stride + i * grid.stride;
        const size_t around = std::min({beside, at, series.size() - 1 - at});
        out.input.push_back(meanOf(series.input, at, std::min(at + grid.stride, series.size())));
        out.output.push_back(meanOf(series.output, at - around, at + around + 1));
    }
    return out;
}

/// Uneven samples: the input acts from its sample to the next, the output moves in a straight line between two that are
/// near each other, and stays where the next one is far away (a table that has only the changes).
class Uneven {
public:
    Uneven(const LoopSeries& series, const Grid& grid, size_t first)
        : m_series(series), m_interval(grid.interval), m_usual(usualInterval(series)), m_at(first) {}
    void moveTo(double time) {
        m_begin = time;
        const double little = 1e-6 * m_interval;
        while (m_at + 1 < m_series.size() && m_series.time[m_at + 1] <= time + little) ++m_at;
    }
    [[nodiscard]] double input() const {
        double sum = 0, covered = 0;
        const double end = m_begin + m_interval;
        for (size_t k = m_at; k < m_series.size() && m_series.time[k] < end - 1e-6 * m_interval; ++k) {
            const double from = std::max(m_series.time[k], m_begin);
            const double to = std::min(k + 1 < m_series.size() ? m_series.time[k + 1] : end, end);
            sum += m_series.input[k] * std::max(to - from, 0.0);
            covered += std::max(to - from, 0.0);
        }
        return covered > 0 ? sum / covered : m_series.input[m_at];
    }
    [[nodiscard]] double output(bool isNoisy) const {
        if (isNoisy && m_interval > 1.5 * m_usual) {
            size_t first = m_at, last = m_at;
            while (first > 0 && m_series.time[first - 1] > m_begin - m_interval / 2) --first;
            while (last + 1 < m_series.size() && m_series.time[last + 1] < m_begin + m_interval / 2) ++last;
            return meanOf(m_series.output, first, last + 1);
        }
        const double value = m_series.output[m_at];
        if (m_at + 1 >= m_series.size()) return value;
        const double distance = m_series.time[m_at + 1] - m_series.time[m_at];
        const double share = (m_begin - m_series.time[m_at]) / distance;
        if (distance > 3 * m_usual || share <= 0) return value;
        return value + share * (m_series.output[m_at + 1] - value);
    }

private:
    const LoopSeries& m_series;
    double m_interval, m_usual, m_begin = 0;
    size_t m_at;
};

Excerpt unevenExcerpt(const LoopSeries& series, const FoundStep& step, const Grid& grid, bool isNoisy) {
    Excerpt out{grid.interval, {}, {}, step.startsAtRest};
    Uneven uneven(series, grid, step.begin);
    const double begin = series.time[step.step] - static_cast<double>(grid.before) * grid.interval;
    for (size_t i = 0; i <= grid.before + grid.after; ++i) {
        uneven.moveTo(begin + static_cast<double>(i) * grid.interval);
        out.input.push_back(uneven.input());
        out.output.push_back(uneven.output(isNoisy));
    }
    return out;
}

} // namespace

Excerpt excerptOf(const LoopSeries& series, const FoundStep& step, size_t points) {
    const Grid grid = gridOf(series, step, points);
    const bool isNoisy = noiseOf(series.output) > 1e-4 * step.outputChange;
    return grid.stride > 0 ? evenExcerpt(series, step, grid, isNoisy) : unevenExcerpt(series, step, grid, isNoisy);
}

std::vector<double> timesOf(const LoopSeries& series, const FoundStep& step, const Excerpt& excerpt) {
    const double from = series.time[step.begin], at = series.time[step.step];
    const double before = std::floor((at - from) / excerpt.interval + 1e-3);
    std::vector<double> out;
    for (size_t i = 0; i < excerpt.output.size(); ++i)
        out.push_back(at + (static_cast<double>(i) - before) * excerpt.interval);
    return out;
}

} // namespace plc::tuning
