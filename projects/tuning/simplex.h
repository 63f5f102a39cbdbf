// The search of Nelder and Mead for the least value of a function without slopes. Values and functions, any thread.
#pragma once
#include <functional>
#include <vector>

namespace plc::tuning {

struct Lowest {
    std::vector<double> point;
    double value = 0;
};

/// From `start`, with a first step along each axis; `evaluations` at most. What is not possible has a great value.
[[nodiscard]] Lowest leastOf(const std::function<double(const std::vector<double>&)>& function,
                             const std::vector<double>& start, const std::vector<double>& steps, size_t evaluations);

} // namespace plc::tuning
