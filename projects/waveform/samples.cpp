#include "projects/waveform/samples.h"

#include <algorithm>
#include <cmath>

namespace plc::waveform {

double usualInterval(const std::vector<double>& time) {
    if (time.size() < 2) return 0;
    std::vector<double> steps;
    const size_t count = std::min<size_t>(time.size() - 1, 2000);
    for (size_t i = 0; i < count; ++i) steps.push_back(time[i + 1] - time[i]);
    std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(count / 2), steps.end());
    return steps[count / 2];
}

std::vector<double> heldAt(const Samples& samples, double from, double interval, size_t count) {
    std::vector<double> out;
    out.reserve(count);
    double held = 0;
    for (const double value : samples.value)
        if (std::isfinite(value)) {
            held = value;
            break;
        }
    size_t next = 0;
    for (size_t i = 0; i < count; ++i) {
        // half a step of tolerance: times of scans are not multiples of it to the last bit
        const double until = from + interval * (static_cast<double>(i) + 0.5);
        for (; next < samples.size() && samples.time[next] < until; ++next)
            if (std::isfinite(samples.value[next])) held = samples.value[next];
        out.push_back(held);
    }
    return out;
}

} // namespace plc::waveform
