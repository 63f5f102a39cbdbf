// How long a piece of a window's work takes, and a table's row of such times. For the benchmarks of views; the thread
// of the window.
#pragma once
#include <functional>
#include <vector>

namespace plc::bench {

[[nodiscard]] double milliseconds(const std::function<void()>& work);
/// | what | median | worst | goal |
void printRow(const char* what, std::vector<double> times, double goal);

} // namespace plc::bench
