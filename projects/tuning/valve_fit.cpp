#include "projects/tuning/valve_fit.h"

#include "projects/tuning/model/find.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace plc::tuning {

namespace {

constexpr size_t kPerCycle = 48, kMostCycles = 10;
constexpr double kLeastCycles = 4;

/// A stretch of the recording in even parts; `stride` samples make one.
struct Stretch {
    size_t begin = 0, stride = 1, parts = 0;
};

std::vector<double> averaged(const std::vector<double>& values, size_t begin, const Stretch& stretch) {
    std::vector<double> out(stretch.parts);
    for (size_t i = 0; i < stretch.parts; ++i)
        out[i] = meanOf(values, begin + i * stretch.stride, begin + (i + 1) * stretch.stride);
    return out;
}

/// How a valve with friction moves: it rests until the controller's output has moved by `stick` away; then it jumps to
/// within `slide` of it and rests again, or follows it that far behind until it turns round.
struct Friction {
    double stick = 0, slide = 0;
    bool follows = false;
};

class StickingValve {
public:
    /// `pull`: by how much the output is away from where the valve went last.
    StickingValve(const Friction& friction, double input, double pull)
        : m_friction(friction), m_at(input - pull), m_input(input), m_pull(pull) {}
    double next(double input) {
        const double moved = input - m_input;
        m_input = input;
        if (m_direction * moved < 0) m_direction = 0;
        if (m_direction != 0) return m_at += moved;
        m_pull += moved;
        if (std::abs(m_pull) > m_friction.stick) {
            const double left = std::copysign(m_friction.slide, m_pull);
            m_at += m_pull - left;
            m_pull = left;
            if (m_friction.follows) m_direction = std::copysign(1, left);
        }
        return m_at;
    }

private:
    Friction m_friction;
    double m_at, m_input, m_pull, m_direction = 0;
};

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

/// What was measured, with the sums over it that every fit needs.
struct Measured {
    std::vector<double> values; // less set point, in parts
    size_t skip = 0;            // parts at the start that have not forgotten where they came from
    double sign = 1;            // of the process's gain
    Eigen::Matrix2d base;       // products of offset and slope
    Eigen::Vector2d right;      // with the values
    double total = 0;           // squares
};

void sumUp(Measured& measured) {
    measured.base.setZero();
    measured.right.setZero();
    for (size_t i = measured.skip; i < measured.values.size(); ++i) {
        const double time = static_cast<double>(i) / static_cast<double>(measured.values.size());
        const Eigen::Vector2d row(1, time);
        measured.base += row * row.transpose();
        measured.right += row * measured.values[i];
        measured.total += measured.values[i] * measured.values[i];
    }
}

/// Squares that gain, offset and slope leave, the gain of the sign that the controller's says.
double leftBy(const std::vector<double>& response, size_t delay, const Measured& measured) {
    const double step = 1 / static_cast<double>(measured.values.size());
    double square = 0, sum = 0, slope = 0, product = 0;
    for (size_t i = measured.skip; i < measured.values.size(); ++i) {
        const double value = response[i - delay];
        square += value * value;
        sum += value;
        slope += value * static_cast<double>(i);
        product += value * measured.values[i];
    }
    const Eigen::Vector2d across(sum, slope * step);
    const Eigen::Matrix2d inverse = measured.base.inverse();
    const double left = measured.total - measured.right.dot(inverse * measured.right);
    const double own = square - across.dot(inverse * across), shared = product - across.dot(inverse * measured.right);
    if (!(own > 0) || shared * measured.sign <= 0) return std::max(left, 0.0);
    return std::max(left - shared * shared / own, 0.0);
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
    Measured measured;
    double perCycle = kPerCycle;
};

/// A process behind a valve, and the squares that it leaves.
struct ProcessFit {
    LagShape shape;
    size_t delay = 0;
    double left = 1e300;
};

void look(const Setting& setting, const std::vector<double>& drive, const LagShape& shape,
          const std::vector<size_t>& delays, ProcessFit& best) {
    const std::vector<double> response = responseOf(drive, shape);
    for (const size_t delay : delays)
        if (const double left = leftBy(response, delay, setting.measured); left < best.left)
            best = {shape, delay, left};
}

/// The best of a grid of shapes.
ProcessFit coarseFit(const Setting& setting, const std::vector<double>& drive) {
    constexpr std::array kLags = {0.02, 0.06, 0.15, 0.35, 0.8, 2.0};
    constexpr std::array kDelays = {0.0, 0.03, 0.06, 0.1, 0.15, 0.22, 0.3, 0.4};
    std::vector<size_t> delays;
    for (const double delay : kDelays) delays.push_back(static_cast<size_t>(std::lround(delay * setting.perCycle)));
    ProcessFit best;
    for (const double lag : kLags)
        for (const int lags : {1, 2}) look(setting, drive, {lags, lag * setting.perCycle, false}, delays, best);
    look(setting, drive, {0, 1, true}, delays, best);
    return best;
}

/// Nearer about one that nearly fits.
ProcessFit nearFit(const Setting& setting, const std::vector<double>& drive, const ProcessFit& about,
                   std::initializer_list<double> factors) {
    ProcessFit best{about.shape, about.delay};
    for (const double factor : factors) {
        const ProcessFit now = best;
        std::vector<size_t> delays;
        for (size_t delay = now.delay - std::min<size_t>(now.delay, 2); delay <= now.delay + 2; ++delay)
            if (delay <= setting.measured.skip) delays.push_back(delay);
        look(setting, drive, now.shape, delays, best);
        if (now.shape.isIntegrating) continue;
        for (const double lag : {now.shape.lag / factor, now.shape.lag * factor})
            look(setting, drive, {now.shape.lags, lag, false}, delays, best);
    }
    return best;
}

/// A valve to try: stick is a share of the output's range, slide of stick. Where the valve is at first is not known: it
/// moves back when the output has come down by `turn` of its range.
struct TriedValve {
    Friction friction;
    double turn = 0.9;
};

class Valves {
public:
    Valves(const LoopSeries& series, const Setting& setting, double range)
        : m_series(series), m_setting(setting), m_range(range) {
        const auto begin = series.input.begin() + static_cast<std::ptrdiff_t>(setting.stretch.begin);
        const auto cycle =
            static_cast<std::ptrdiff_t>(setting.perCycle) * static_cast<std::ptrdiff_t>(setting.stretch.stride);
        m_top = static_cast<size_t>(std::max_element(begin, begin + cycle) - begin);
    }
    /// Of each way to move the best, then the better of the two.
    ValveFit search() {
        Tried best;
        for (const bool follows : {false, true})
            if (const Tried found = refined(coarse(follows)); found.process.left < best.process.left) best = found;
        ValveFit out;
        out.with = best.process.left / m_setting.measured.total;
        out.band = best.valve.friction.stick * m_range;
        return out;
    }

private:
    struct Tried {
        TriedValve valve;
        ProcessFit process;
    };
    [[nodiscard]] Tried coarse(bool follows) const {
        Tried best;
        for (const double stick : {0.12, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9})
            for (const double slide : {0.0, 0.35, 0.7, 0.95})
                for (const double turn : {0.8, 0.9, 0.97}) {
                    if (slide > 0 && stick > 0.52) continue;       // it would never turn
                    if (turn > 2 * stick && turn < 0.97) continue; // it turns before
                    const TriedValve valve{{stick, slide, follows}, turn};
                    take(valve, coarseFit(m_setting, behind(valve)), best);
                }
        return best;
    }
    [[nodiscard]] Tried refined(Tried best) const {
        constexpr double kSmallest = 0.1, kWorthIt = 0.98;
        for (double step = 1; step > kSmallest;) {
            const Tried about = best;
            for (const double move : {-step, step}) {
                const Friction& friction = about.valve.friction;
                near({{friction.stick + 0.05 * move, friction.slide, friction.follows}, about.valve.turn}, best);
                near({{friction.stick, friction.slide + 0.15 * move, friction.follows}, about.valve.turn}, best);
                near({friction, about.valve.turn + 0.03 * move}, best);
            }
            take(best.valve, nearFit(m_setting, behind(best.valve), best.process, {1.5, 1.2, 1.1}), best);
            if (best.process.left >= kWorthIt * about.process.left) step /= 2;
        }
        return best;
    }
    void near(const TriedValve& valve, Tried& best) const {
        const Friction& friction = valve.friction;
        if (friction.stick < 0.05 || friction.slide < 0 || friction.slide >= 1) return;
        take(valve, nearFit(m_setting, behind(valve), best.process, {1.15}), best);
    }
    static void take(const TriedValve& valve, const ProcessFit& process, Tried& best) {
        if (process.left < best.process.left) best = {valve, process};
    }
    [[nodiscard]] std::vector<double> behind(const TriedValve& tried) const {
        const Stretch& stretch = m_setting.stretch;
        const Friction& friction = tried.friction;
        const double band = friction.stick * m_range;
        const double pull = std::clamp(tried.turn * m_range - band, -band, band);
        const double* input = m_series.input.data() + stretch.begin;
        StickingValve valve({band, friction.slide * band, friction.follows}, input[m_top], pull);
        std::vector<double> at(stretch.parts * stretch.stride, input[m_top] - pull);
        for (size_t i = m_top; i < at.size(); ++i) at[i] = valve.next(input[i]);
        return averaged(at, 0, stretch);
    }
    const LoopSeries& m_series;
    const Setting& m_setting;
    double m_range;
    size_t m_top = 0; // from where on the valve is followed
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
    Measured& measured = setting.measured;
    measured.values = averaged(series.output, stretch.begin, stretch);
    if (!series.setPoint.empty()) {
        const std::vector<double> wantedValue = averaged(series.setPoint, stretch.begin, stretch);
        for (size_t i = 0; i < stretch.parts; ++i) measured.values[i] -= wantedValue[i];
    }
    const double mean = meanOf(measured.values, 0, stretch.parts);
    for (double& value : measured.values) value -= mean;
    measured.skip = static_cast<size_t>(2 * setting.perCycle);
    std::vector<double> error = measured.values;
    for (double& value : error) value = -value;
    const std::vector<double> input = averaged(series.input, stretch.begin, stretch);
    measured.sign = processSign(input, error);
    sumUp(measured);
    const auto [low, high] = std::minmax_element(input.begin(), input.end());
    if (!(*high > *low) || !(measured.total > 0)) return std::nullopt;
    ValveFit out = Valves(series, setting, *high - *low).search();
    const double noise = noiseOf(series.output) / std::sqrt(static_cast<double>(stretch.stride));
    out.noise = noise * noise * static_cast<double>(stretch.parts - measured.skip) / measured.total;
    out.without = nearFit(setting, input, coarseFit(setting, input), {1.5, 1.2, 1.1}).left / measured.total;
    return out;
}

} // namespace plc::tuning
