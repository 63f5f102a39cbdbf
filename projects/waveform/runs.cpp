#include "projects/waveform/runs.h"

#include <algorithm>
#include <cmath>

namespace plc::waveform {

std::vector<Run> alignedRuns(const Samples& samples, const std::vector<double>& starts, double before, double after) {
    std::vector<Run> out;
    for (const double start : starts) {
        auto first = std::lower_bound(samples.time.begin(), samples.time.end(), start - before);
        const auto end = std::upper_bound(first, samples.time.end(), start + after);
        if (first != samples.time.begin() && (first == samples.time.end() || *first > start - before))
            --first; // its value holds at the beginning of the run
        if (first == end) continue;
        Run run{start, {}};
        for (auto at = first; at != end; ++at) {
            run.samples.time.push_back(std::max(*at - start, -before));
            run.samples.value.push_back(samples.value[static_cast<size_t>(at - samples.time.begin())]);
        }
        out.push_back(std::move(run));
    }
    return out;
}

RunBand bandOf(const std::vector<Run>& runs, size_t points) {
    RunBand out;
    if (runs.empty() || points < 2) return out;
    double from = -1e300, to = 1e300; // where all of them are
    for (const Run& run : runs) {
        from = std::max(from, run.samples.time.front());
        to = std::min(to, run.samples.time.back());
    }
    if (!(to > from)) return out;
    const double step = (to - from) / static_cast<double>(points - 1);
    std::vector<std::vector<double>> values;
    for (const Run& run : runs) values.push_back(heldAt(run.samples, from, step, points));
    for (size_t i = 0; i < points; ++i) {
        double low = values[0][i], high = low, sum = 0;
        for (const auto& run : values) {
            low = std::min(low, run[i]);
            high = std::max(high, run[i]);
            sum += run[i];
        }
        const double at = from + step * static_cast<double>(i);
        out.time.push_back(at);
        out.least.push_back(low);
        out.greatest.push_back(high);
        out.mean.push_back(sum / static_cast<double>(values.size()));
        if (high - low > out.widest) out.widest = high - low, out.widestAt = at;
    }
    return out;
}

} // namespace plc::waveform
