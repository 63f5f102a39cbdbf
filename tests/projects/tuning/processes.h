// The families of processes that tuning rules are usually tried on, and recordings made from them. For tests.
#pragma once
#include "projects/tuning/model/identify.h"

#include <cmath>
#include <random>

namespace plc::tuning {

inline ProcessModel lags(std::vector<double> all, double deadTime = 0, double gain = 1) {
    ProcessModel model;
    model.gain = gain;
    model.lags = std::move(all);
    model.deadTime = deadTime;
    return model;
}
inline ProcessModel equalLags(int count, double lag = 1, double deadTime = 0, double gain = 1) {
    return lags(std::vector<double>(static_cast<size_t>(count), lag), deadTime, gain);
}

/// A step of the input after a tenth of the time; noise as a share of the output's greatest deviation.
inline Excerpt stepOf(const ProcessModel& model, double duration, double noise = 0, unsigned seed = 1,
                      double height = 1, size_t samples = 500) {
    Excerpt out{duration / static_cast<double>(samples), {}, {}, true};
    SampledProcess process(model, out.interval);
    for (size_t i = 0; i < samples; ++i) {
        out.input.push_back(i < samples / 10 ? 2.0 : 2.0 + height);
        out.output.push_back(process.output() + 7);
        process.advance(out.input.back() - 2.0);
    }
    double largest = 0;
    for (const double value : out.output) largest = std::max(largest, std::abs(value - 7));
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0, 1);
    if (noise > 0)
        for (double& value : out.output) value += noise * largest * normal(random);
    return out;
}

} // namespace plc::tuning
