#include "projects/tuning/valve_fit.h"

#include "projects/tuning/cycles.h"
#include "projects/tuning/model/find.h"
#include "projects/tuning/simplex.h"
#include "projects/tuning/wave_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plc::tuning {

namespace {

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

/// A process behind a valve, and the squares that it leaves.
struct ProcessFit {
    LagShape shape;
    size_t delay = 0;
    double left = 1e300;
};

void look(const Cycles& cycles, const std::vector<double>& drive, const LagShape& shape,
          const std::vector<size_t>& delays, ProcessFit& best) {
    const std::vector<double> response = responseOf(drive, shape);
    for (const size_t delay : delays)
        if (const double left = leftBy(response, delay, cycles.measured); left < best.left) best = {shape, delay, left};
}

/// The best of a grid of shapes.
ProcessFit coarseFit(const Cycles& cycles, const std::vector<double>& drive) {
    constexpr std::array kLags = {0.02, 0.06, 0.15, 0.35, 0.8, 2.0};
    constexpr std::array kDelays = {0.0, 0.03, 0.06, 0.1, 0.15, 0.22, 0.3, 0.4};
    std::vector<size_t> delays;
    for (const double delay : kDelays) delays.push_back(static_cast<size_t>(std::lround(delay * cycles.perCycle)));
    ProcessFit best;
    for (const double lag : kLags)
        for (const double second : {0.0, 1.0}) look(cycles, drive, {lag * cycles.perCycle, second}, delays, best);
    look(cycles, drive, {1, 0, 0, true}, delays, best);
    return best;
}

/// Nearer about one that nearly fits.
ProcessFit nearFit(const Cycles& cycles, const std::vector<double>& drive, const ProcessFit& about,
                   std::initializer_list<double> factors) {
    ProcessFit best{about.shape, about.delay};
    for (const double factor : factors) {
        const ProcessFit now = best;
        std::vector<size_t> delays;
        for (size_t delay = now.delay - std::min<size_t>(now.delay, 2); delay <= now.delay + 2; ++delay)
            if (delay <= cycles.measured.skip) delays.push_back(delay);
        look(cycles, drive, now.shape, delays, best);
        if (now.shape.isIntegrating) continue;
        for (const double lag : {now.shape.lag / factor, now.shape.lag * factor})
            look(cycles, drive, {lag, now.shape.second}, delays, best);
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
    Valves(const LoopSeries& series, const Cycles& cycles) : m_series(series), m_cycles(cycles), m_range(cycles.range) {
        const auto begin = series.input.begin() + static_cast<std::ptrdiff_t>(cycles.stretch.begin);
        const auto cycle =
            static_cast<std::ptrdiff_t>(cycles.perCycle) * static_cast<std::ptrdiff_t>(cycles.stretch.stride);
        m_top = static_cast<size_t>(std::max_element(begin, begin + cycle) - begin);
    }
    /// Of each way to move the best, then the better of the two.
    ValveFit search() {
        ValveFit out;
        std::vector<Tried> found;
        for (const bool follows : {false, true}) {
            const std::vector<Tried> all = coarse(follows);
            found.insert(found.end(), all.begin(), all.end());
        }
        std::sort(found.begin(), found.end(),
                  [](const Tried& a, const Tried& b) { return a.process.left < b.process.left; });
        constexpr size_t kTried = 4;
        found.resize(std::min(found.size(), kTried));
        double best = 1e300;
        for (const Tried& tried : found)
            if (const double left = polished(refined(tried)); left < best)
                best = left, out.band = tried.valve.friction.stick * m_range;
        out.with = best / m_cycles.measured.total;
        return out;
    }

private:
    struct Tried {
        TriedValve valve;
        ProcessFit process;
    };
    /// The best for each slide.
    [[nodiscard]] std::vector<Tried> coarse(bool follows) const {
        std::vector<Tried> out;
        for (const double slide : {0.0, 0.35, 0.7, 0.95}) {
            Tried best;
            for (const double stick : {0.12, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9})
                for (const double turn : {0.8, 0.9, 0.97}) {
                    if (slide > 0 && stick > 0.52) continue;       // it would never turn
                    if (turn > 2 * stick && turn < 0.97) continue; // it turns before
                    const TriedValve valve{{stick, slide, follows}, turn};
                    take(valve, coarseFit(m_cycles, behind(valve)), best);
                }
            out.push_back(best);
        }
        return out;
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
            take(best.valve, nearFit(m_cycles, behind(best.valve), best.process, {1.5, 1.2, 1.1}), best);
            if (best.process.left >= kWorthIt * about.process.left) step /= 2;
        }
        return best;
    }
    void near(const TriedValve& valve, Tried& best) const {
        const Friction& friction = valve.friction;
        if (friction.stick < 0.05 || friction.slide < 0 || friction.slide >= 1) return;
        take(valve, nearFit(m_cycles, behind(valve), best.process, {1.15}), best);
    }
    static void take(const TriedValve& valve, const ProcessFit& process, Tried& best) {
        if (process.left < best.process.left) best = {valve, process};
    }
    /// With parts of a part and up to three lags: the squares that are left.
    [[nodiscard]] double polished(const Tried& found) const {
        const Friction& friction = found.valve.friction;
        const bool isIntegrating = found.process.shape.isIntegrating, follows = friction.follows;
        const double turn = found.valve.turn;
        const auto left = [&](const std::vector<double>& at) {
            const LagShape shape{std::exp(at[2]), at[4], at[5], isIntegrating};
            const double most = static_cast<double>(m_cycles.measured.skip) - 1;
            if (at[0] < 0.05 || at[1] < 0 || at[1] >= 1 || at[3] < 0 || at[3] > most || !isPossible(shape))
                return 1e300;
            const std::vector<double> drive = behind({{at[0], at[1], follows}, turn});
            return leftBy(delayed(responseOf(drive, shape), at[3]), 0, m_cycles.measured);
        };
        std::vector<double> best{friction.stick,
                                 friction.slide,
                                 std::log(found.process.shape.lag),
                                 static_cast<double>(found.process.delay),
                                 found.process.shape.second,
                                 found.process.shape.third};
        double least = found.process.left;
        constexpr size_t kEvaluations = 160;
        for (const double size : {1.0, -0.5, 0.25}) {
            std::vector<double> steps{0.04 * size, 0.1 * size, 0.3 * size, 1.5 * size, 0.3, 0.1};
            if (best[4] > 0.5) steps[4] = -0.3;
            if (best[1] + steps[1] < 0 || best[1] + steps[1] >= 1) steps[1] = -steps[1];
            const Lowest lowest = leastOf(left, best, steps, kEvaluations);
            if (lowest.value < least) least = lowest.value, best = lowest.point;
        }
        return least;
    }
    [[nodiscard]] std::vector<double> behind(const TriedValve& tried) const {
        const Stretch& stretch = m_cycles.stretch;
        const Friction& friction = tried.friction;
        const double band = friction.stick * m_range;
        const double pull = std::clamp(tried.turn * m_range - band, -band, band);
        const double* input = m_series.input.data() + stretch.begin;
        StickingValve valve({band, friction.slide * band, friction.follows}, input[m_top], pull);
        std::vector<double> out(stretch.parts);
        size_t i = 0;
        for (double& mean : out) {
            double sum = 0;
            for (const size_t end = i + stretch.stride; i < end; ++i)
                sum += i < m_top ? input[m_top] - pull : valve.next(input[i]);
            mean = sum / static_cast<double>(stretch.stride);
        }
        return out;
    }
    const LoopSeries& m_series;
    const Cycles& m_cycles;
    double m_range;
    size_t m_top = 0; // from where on the valve is followed
};

} // namespace

std::optional<ValveFit> fitValve(const LoopSeries& series, size_t begin, size_t end, double period) {
    const auto cycles = cyclesOf(series, begin, end, period);
    if (!cycles) return std::nullopt;
    const Stretch& stretch = cycles->stretch;
    const Measured& measured = cycles->measured;
    ValveFit out = Valves(series, *cycles).search();
    const double noise = noiseOf(series.output) / std::sqrt(static_cast<double>(stretch.stride));
    out.noise = noise * noise * static_cast<double>(stretch.parts - measured.skip) / measured.total;
    out.without =
        nearFit(*cycles, cycles->input, coarseFit(*cycles, cycles->input), {1.5, 1.2, 1.1}).left / measured.total;
    constexpr double kWorthIt = 1.5; // where friction explains nothing, neither has to be told from the other
    if (out.gain() > kWorthIt) out.wave = fitWave(*cycles);
    return out;
}

} // namespace plc::tuning
