// A signal as it was recorded, times and values beside each other, and the same on an even grid. Values and functions,
// any thread.
#pragma once
#include <cstddef>
#include <vector>

namespace plc::waveform {

/// A value holds until the next one; what is not a number is a gap.
struct Samples {
    std::vector<double> time, value; // [s], rising
    [[nodiscard]] size_t size() const { return time.size(); }
};

/// The usual distance of two samples [s]; 0: fewer than two.
[[nodiscard]] double usualInterval(const std::vector<double>& time);
/// The value in force at each of `count` instants from `from` on; before the first sample the first.
[[nodiscard]] std::vector<double> heldAt(const Samples& samples, double from, double interval, size_t count);

} // namespace plc::waveform
