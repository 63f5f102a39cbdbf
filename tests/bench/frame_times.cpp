#include "tests/bench/frame_times.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cstdio>

namespace plc::bench {

double milliseconds(const std::function<void()>& work) {
    QElapsedTimer timer;
    timer.start();
    work();
    return static_cast<double>(timer.nsecsElapsed()) / 1e6;
}

void printRow(const char* what, std::vector<double> times, double goal) {
    std::sort(times.begin(), times.end());
    std::printf("| %s | %.1f ms | %.1f ms | %.0f ms |\n", what, times[times.size() / 2], times.back(), goal);
}

} // namespace plc::bench
