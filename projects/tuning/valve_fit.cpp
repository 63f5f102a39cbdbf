#include "projects/tuning/valve_fit.h"

#include "projects/tuning/model/find.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace plc::tuning {

namespace {

constexpr size_t kPerCycle = 48, kMostCycles = 14;
constexpr double kLeastCycles = 3;

/// A stretch of the recording in even parts; `stride` samples make one.
struct Stretch {
    size_t begin = 0, stride = 1, parts = 0;
    double interval = 1; // of the parts [s]
};

std::vector<double> averaged(const std::vector<double>& values, size_t begin, const Stretch& stretch) {
    std::vector<double> out(stretch.parts);
    for (size_t i = 0; i < stretch.parts; ++i)
        out[i] = meanOf(values, begin + i * stretch.stride, begin + (i + 1) * stretch.stride);
    return out;
}

/// Where a valve with friction is for each sample of the controller's output: at rest until the output has moved by
/// `stick` away, then it follows up to `slide` of it.
std::vector<double> valveBehind(const std::vector<double>& input, size_t begin, size_t end, double stick,
                                double slide) {
    std::vector<double> out;
    out.reserve(end - begin);
    double at = input[begin], pull = 0;
    for (size_t i = begin; i < end; ++i) {
        if (i > begin) pull += input[i] - input[i - 1];
        if (std::abs(pull) > stick) {
            const double left = std::copysign(slide, pull);
            at += pull - left;
            pull = left;
        }
        out.push_back(at);
    }
    return out;
}

/// The process: equal lags or none and an integrator, with a dead time in parts.
struct LagShape {
    int lags = 1;
    double lag = 1; // in parts
    bool isIntegrating = false;
};

std::vector<double> responseOf(const std::vector<double>& drive, const LagShape& shape) {
    const double mean = meanOf(drive, 0, drive.size());
    std::vector<double> out(drive.size());
    double first = 0, second = 0;
    const double share = shape.lags > 0 ? 1 - std::exp(-1 / shape.lag) : 1;
    for (size_t i = 0; i < drive.size(); ++i) {
        if (shape.isIntegrating)
            out[i] = first += drive[i] - mean;
        else {
            first += share * (drive[i] - mean - first);
            second += share * (first - second);
            out[i] = shape.lags == 1 ? first : second;
        }
    }
    return out;
}

/// Squares that gain, offset and slope leave, the gain of the sign that the controller's says; `skip` parts at the
/// start have not forgotten where they came from.
double leftBy(const std::vector<double>& response, size_t delay, const std::vector<double>& measured, size_t skip,
              double sign) {
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double total = 0;
    const auto count = static_cast<double>(measured.size());
    for (size_t i = skip; i < measured.size(); ++i) {
        const Eigen::Vector3d row(response[i - delay], 1, static_cast<double>(i) / count);
        products.noalias() += row * row.transpose();
        right += row * measured[i];
        total += measured[i] * measured[i];
    }
    const auto solved = [&](Eigen::Index first) {
        const Eigen::Index size = 3 - first;
        const Eigen::VectorXd x = products.bottomRightCorner(size, size).ldlt().solve(right.tail(size));
        return std::pair(x(0), std::max(total - x.dot(right.tail(size)), 0.0));
    };
    const auto [gain, left] = solved(0);
    return gain * sign > 0 ? left : solved(1).second;
}

/// Of the process's gain: against that of the controller, which the movements of output and error say.
double processSign(const std::vector<double>& input, const std::vector<double>& error) {
    double ee = 0, ed = 0, dd = 0, eu = 0, du = 0;
    for (size_t i = 1; i < input.size(); ++i) {
        const double moved = input[i] - input[i - 1], change = error[i] - error[i - 1];
        ee += error[i] * error[i], ed += error[i] * change, dd += change * change;
        eu += error[i] * moved, du += change * moved;
    }
    const double size = ee * dd - ed * ed;
    if (!(size > 0)) return 1;
    const double integral = (eu * dd - du * ed) / size, gain = (du * ee - eu * ed) / size;
    // both have the controller's sign; the clearer one decides
    return integral * std::sqrt(ee) + gain * std::sqrt(dd) >= 0 ? 1 : -1;
}

struct Setting {
    Stretch stretch;
    std::vector<double> measured; // less set point, in parts
    size_t skip = 0;
    double sign = 1, perCycle = kPerCycle;
};

/// The process that leaves least behind a valve: a grid of shapes, then nearer about the best of them.
double leastLeft(const Setting& setting, const std::vector<double>& drive) {
    constexpr std::array kLags = {0.02, 0.06, 0.15, 0.35, 0.8, 2.0};
    constexpr std::array kDelays = {0.0, 0.03, 0.06, 0.1, 0.15, 0.22, 0.3, 0.4};
    double least = 1e300;
    LagShape best;
    size_t bestDelay = 0;
    const auto look = [&](const LagShape& shape, const auto& delays) {
        const std::vector<double> response = responseOf(drive, shape);
        for (const size_t delay : delays) {
            const double left = leftBy(response, delay, setting.measured, setting.skip, setting.sign);
            if (left < least) least = left, best = shape, bestDelay = delay;
        }
    };
    std::vector<size_t> delays;
    for (const double delay : kDelays) delays.push_back(static_cast<size_t>(std::lround(delay * setting.perCycle)));
    for (const double lag : kLags)
        for (const int lags : {1, 2}) look({lags, lag * setting.perCycle, false}, delays);
    look({0, 1, true}, delays);
    for (const double factor : {1.5, 1.2}) {
        const LagShape about = best;
        delays.clear();
        for (size_t delay = bestDelay - std::min<size_t>(bestDelay, 2); delay <= bestDelay + 2; ++delay)
            if (delay <= setting.skip) delays.push_back(delay);
        look(about, delays);
        if (about.isIntegrating) break;
        for (const double lag : {about.lag / factor, about.lag * factor}) look({about.lags, lag, false}, delays);
    }
    return least;
}

/// Tries valves of different friction.
class Valves {
public:
    Valves(const LoopSeries& series, const Setting& setting, double range, double total)
        : m_series(series), m_setting(setting), m_range(range), m_total(total) {}
    void look(double stick, double slide, ValveFit& best) {
        const Stretch& stretch = m_setting.stretch;
        const double band = stick * m_range;
        const std::vector<double> valve = valveBehind(
            m_series.input, stretch.begin, stretch.begin + stretch.parts * stretch.stride, band, slide * band);
        const double left = leastLeft(m_setting, averaged(valve, 0, stretch)) / m_total;
        if (!(left < best.with)) return;
        best.with = left;
        best.band = band;
        m_stick = stick, m_slide = slide;
    }
    void search(ValveFit& best) {
        for (const double stick : {0.12, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9})
            for (const double slide : {0.0, 0.35, 0.7, 0.95})
                if (slide == 0 || stick < 0.55) look(stick, slide, best); // else it would never turn
        for (const double step : {0.5, 0.25})
            for (const double toStick : {-0.1, 0.0, 0.1})
                for (const double toSlide : {-0.3, 0.0, 0.3})
                    if (const double stick = m_stick + step * toStick, slide = m_slide + step * toSlide;
                        stick > 0.05 && slide >= 0 && slide < 1)
                        look(stick, slide, best);
    }

private:
    const LoopSeries& m_series;
    const Setting& m_setting;
    double m_range, m_total, m_stick = 0.3, m_slide = 0;
};

} // namespace

std::optional<ValveFit> fitValve(const LoopSeries& series, size_t begin, size_t end, double period) {
    if (end <= begin + 1) return std::nullopt;
    const double interval = (series.time[end - 1] - series.time[begin]) / static_cast<double>(end - 1 - begin);
    const double samples = period / interval; // of a cycle
    if (static_cast<double>(end - begin) < kLeastCycles * samples || samples < 8) return std::nullopt;
    Setting setting;
    Stretch& stretch = setting.stretch;
    stretch.stride = std::max<size_t>(static_cast<size_t>(samples / kPerCycle), 1);
    setting.perCycle = samples / static_cast<double>(stretch.stride);
    const size_t wanted = static_cast<size_t>(static_cast<double>(kMostCycles) * setting.perCycle);
    stretch.parts = std::min((end - begin) / stretch.stride, wanted);
    stretch.begin = end - stretch.parts * stretch.stride; // the last cycles: an oscillation grows at first
    setting.measured = averaged(series.output, stretch.begin, stretch);
    if (!series.setPoint.empty()) {
        const std::vector<double> wantedValue = averaged(series.setPoint, stretch.begin, stretch);
        for (size_t i = 0; i < stretch.parts; ++i) setting.measured[i] -= wantedValue[i];
    }
    const double mean = meanOf(setting.measured, 0, stretch.parts);
    for (double& value : setting.measured) value -= mean;
    setting.skip = static_cast<size_t>(1.5 * setting.perCycle);
    std::vector<double> error = setting.measured;
    for (double& value : error) value = -value;
    const std::vector<double> input = averaged(series.input, stretch.begin, stretch);
    setting.sign = processSign(input, error);
    const auto [low, high] = std::minmax_element(input.begin(), input.end());
    if (!(*high > *low)) return std::nullopt;
    double total = 0;
    for (size_t i = setting.skip; i < setting.measured.size(); ++i) total += setting.measured[i] * setting.measured[i];
    if (!(total > 0)) return std::nullopt;
    ValveFit out;
    const double noise = noiseOf(series.output) / std::sqrt(static_cast<double>(stretch.stride));
    out.noise = noise * noise * static_cast<double>(setting.measured.size() - setting.skip) / total;
    out.without = leastLeft(setting, input) / total;
    Valves(series, setting, *high - *low, total).search(out);
    return out;
}

} // namespace plc::tuning
