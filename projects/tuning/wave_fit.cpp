#include "projects/tuning/wave_fit.h"

#include "projects/tuning/simplex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace plc::tuning {

namespace {

/// From -1 to 1 within the share `rise` of a cycle, and back within the rest: a triangle at 0.5, a sawtooth at 1.
struct Wave {
    double rise = 0.5;
    double phase = 0; // in parts
};

/// Its integral over the turns so far; a whole turn adds nothing.
double integralAt(double turns, double rise) {
    const double within = turns - std::floor(turns);
    if (within < rise) return within * (within / rise - 1);
    const double falling = within - rise;
    return rise < 1 ? falling * (1 - falling / (1 - rise)) : 0;
}

/// What explains the oscillation: a process and a wave at its output or input.
struct Outside {
    LagShape shape;
    double delay = 0; // in parts
    Wave wave;
    bool isAtInput = false;
    double perCycle = 1; // parts
};

/// Squares and products without the straight line that each may have.
class Projection {
public:
    explicit Projection(const Measured& measured)
        : m_first(measured.skip), m_count(measured.values.size() - measured.skip) {
        const auto count = static_cast<double>(m_count);
        m_middle = (count - 1) / 2;
        m_spread = count * (count * count - 1) / 12;
    }
    /// What is left of the values from `skip` on.
    [[nodiscard]] Eigen::VectorXd of(const double* values) const {
        Eigen::VectorXd out = Eigen::Map<const Eigen::VectorXd>(values + m_first, static_cast<Eigen::Index>(m_count));
        const double mean = out.mean();
        double slope = 0;
        for (Eigen::Index i = 0; i < out.size(); ++i) slope += (static_cast<double>(i) - m_middle) * out[i];
        slope /= m_spread;
        for (Eigen::Index i = 0; i < out.size(); ++i) out[i] -= mean + slope * (static_cast<double>(i) - m_middle);
        return out;
    }

private:
    size_t m_first, m_count;
    double m_middle = 0, m_spread = 1;
};

class WaveSearch {
public:
    explicit WaveSearch(const Cycles& cycles)
        : m_cycles(cycles), m_projection(cycles.measured), m_values(m_projection.of(cycles.measured.values.data())),
          m_square(m_values.squaredNorm()) {}
    [[nodiscard]] double search() {
        const double perCycle = refinedPeriod();
        double best = m_values.squaredNorm();
        for (const bool isAtInput : {false, true})
            for (const Tried& tried : coarse(isAtInput, perCycle)) best = std::min(best, polished(refined(tried)));
        return best;
    }

private:
    struct Tried {
        Outside outside;
        double left = 1e300;
    };
    [[nodiscard]] double refinedPeriod() const;
    [[nodiscard]] std::vector<Tried> coarse(bool isAtInput, double perCycle) const;
    [[nodiscard]] Tried refined(Tried best) const;
    [[nodiscard]] double polished(const Tried& found) const;
    [[nodiscard]] double leftBy(const Outside& outside) const;
    struct Part { // of what explains the measured values
        Eigen::VectorXd values;
        double square = 0, product = 0; // with itself, with the measured values
    };
    [[nodiscard]] Part partOf(Eigen::VectorXd values) const;
    [[nodiscard]] double leftBy(const Part& response, const Part& wave) const;
    [[nodiscard]] std::vector<double> waveOf(const Outside& outside, size_t more) const;

    const Cycles& m_cycles;
    Projection m_projection;
    Eigen::VectorXd m_values;
    double m_square; // of the values
};

/// Squares that harmonics of a period leave.
double leftByHarmonics(const Eigen::VectorXd& values, double perCycle) {
    constexpr int kHarmonics = 5;
    Eigen::MatrixXd rows(values.size(), 2 * kHarmonics + 1);
    for (Eigen::Index i = 0; i < values.size(); ++i) {
        rows(i, 2 * kHarmonics) = 1;
        for (int k = 0; k < kHarmonics; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 1) * static_cast<double>(i) / perCycle;
            rows(i, 2 * k) = std::cos(angle);
            rows(i, 2 * k + 1) = std::sin(angle);
        }
    }
    const Eigen::VectorXd right = rows.transpose() * values;
    const Eigen::VectorXd found = (rows.transpose() * rows).ldlt().solve(right);
    return values.squaredNorm() - right.dot(found);
}

/// The period counted from half waves is a little wrong, which shifts the jumps of a sawtooth in the last cycle.
double WaveSearch::refinedPeriod() const {
    double best = m_cycles.perCycle, left = leftByHarmonics(m_values, best);
    constexpr double kFirst = 0.004, kLast = 0.0002;
    constexpr int kSteps = 7;
    for (double step = kFirst; step > kLast; step /= 4) {
        const double middle = best;
        for (int i = -kSteps; i <= kSteps; ++i) {
            const double tried = middle * (1 + step * i);
            if (const double now = leftByHarmonics(m_values, tried); now < left) left = now, best = tried;
        }
    }
    return best;
}

/// The wave in parts, `more` beyond the measured ones, as the process shows it; from long before, so that its start is
/// forgotten.
std::vector<double> WaveSearch::waveOf(const Outside& outside, size_t more) const {
    constexpr size_t kBefore = 8;
    const auto before =
        outside.isAtInput ? static_cast<size_t>(static_cast<double>(kBefore) * std::ceil(outside.perCycle)) : size_t{0};
    const size_t parts = m_cycles.stretch.parts + more;
    std::vector<double> out(before + parts);
    const double first = outside.wave.phase - static_cast<double>(before), rise = outside.wave.rise;
    double last = integralAt(first / outside.perCycle, rise);
    for (size_t i = 0; i < out.size(); ++i) { // the mean over each part
        const double next = integralAt((first + static_cast<double>(i + 1)) / outside.perCycle, rise);
        out[i] = (next - last) * outside.perCycle;
        last = next;
    }
    if (outside.isAtInput) out = responseOf(out, outside.shape);
    out.erase(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(before));
    return out;
}

WaveSearch::Part WaveSearch::partOf(Eigen::VectorXd values) const {
    const double square = values.squaredNorm(), product = values.dot(m_values);
    return {std::move(values), square, product};
}

/// Squares that the best gain, of the sign that the controller's says, and the best height of the wave leave.
double WaveSearch::leftBy(const Part& response, const Part& wave) const {
    const double rr = response.square, ww = wave.square, rw = response.values.dot(wave.values);
    const double ry = response.product, wy = wave.product, yy = m_square;
    const double size = rr * ww - rw * rw;
    if (size > 1e-9 * rr * ww) {
        const double gain = (ry * ww - wy * rw) / size, height = (wy * rr - ry * rw) / size;
        if (gain * m_cycles.measured.sign > 0) return std::max(yy - gain * ry - height * wy, 0.0);
    }
    return ww > 0 ? std::max(yy - wy * wy / ww, 0.0) : yy;
}

double WaveSearch::leftBy(const Outside& outside) const {
    constexpr double kImpossible = 1e300;
    const double rise = outside.wave.rise, most = static_cast<double>(m_cycles.measured.skip) - 1;
    if (outside.delay < 0 || outside.delay > most || rise < 0.5 || rise > 1) return kImpossible;
    if (!isPossible(outside.shape)) return kImpossible;
    const std::vector<double> response = delayed(responseOf(m_cycles.input, outside.shape), outside.delay);
    return leftBy(partOf(m_projection.of(response.data())), partOf(m_projection.of(waveOf(outside, 0).data())));
}

/// The best of a grid for each form of the wave. The wave's own dead time is part of its phase.
std::vector<WaveSearch::Tried> WaveSearch::coarse(bool isAtInput, double perCycle) const {
    constexpr std::array kLags = {0.02, 0.06, 0.15, 0.35, 0.8, 2.0};
    constexpr std::array kDelays = {0.0, 0.03, 0.06, 0.1, 0.15, 0.22, 0.3, 0.4};
    constexpr std::array kRises = {0.5, 0.65, 0.8, 0.9, 1.0};
    constexpr size_t kPhases = 24;
    std::vector<LagShape> shapes{{1, 0, 0, true}};
    for (const double lag : kLags)
        for (const double second : {0.0, 1.0}) shapes.push_back({lag * perCycle, second});
    std::vector<Tried> best(kRises.size());
    std::vector<std::pair<Wave, Part>> waves;
    const auto makeWaves = [&](const LagShape& shape) {
        waves.clear();
        const auto more = static_cast<size_t>(std::ceil(perCycle));
        for (const double rise : kRises) {
            const std::vector<double> all = waveOf({shape, 0, {rise, 0}, isAtInput, perCycle}, more);
            for (size_t i = 0; i < kPhases; ++i) {
                const size_t phase = more * i / kPhases;
                waves.emplace_back(Wave{rise, static_cast<double>(phase)}, partOf(m_projection.of(all.data() + phase)));
            }
        }
    };
    if (!isAtInput) makeWaves({});
    for (const LagShape& shape : shapes) {
        if (isAtInput) makeWaves(shape);
        const std::vector<double> response = responseOf(m_cycles.input, shape);
        for (const double delay : kDelays) {
            const double parts = std::round(delay * perCycle);
            const Part moved = partOf(m_projection.of(delayed(response, parts).data()));
            for (size_t i = 0; i < waves.size(); ++i)
                if (const double now = leftBy(moved, waves[i].second); now < best[i / kPhases].left)
                    best[i / kPhases] = {{shape, parts, waves[i].first, isAtInput, perCycle}, now};
        }
    }
    std::sort(best.begin(), best.end(), [](const Tried& a, const Tried& b) { return a.left < b.left; });
    constexpr size_t kTried = 3;
    best.resize(kTried);
    return best;
}

/// Nearer and nearer about the best of the grid, one number after the other.
WaveSearch::Tried WaveSearch::refined(Tried best) const {
    constexpr double kSmallest = 0.1, kWorthIt = 0.95;
    for (double step = 1; step > kSmallest;) {
        const double before = best.left;
        for (const double move : {-step, step}) {
            const auto with = [&](auto change) {
                Outside tried = best.outside;
                change(tried);
                if (const double now = leftBy(tried); now < best.left) best = {tried, now};
            };
            with([&](Outside& o) { o.shape.lag *= std::exp(0.4 * move); });
            with([&](Outside& o) { o.delay += 2 * move; });
            with([&](Outside& o) { o.wave.rise += 0.08 * move; });
            with([&](Outside& o) { o.wave.phase += move; });
            with([&](Outside& o) { o.perCycle *= 1 + 0.002 * move; });
            with([&](Outside& o) { o.shape.second += 0.3 * move; });
        }
        if (best.left >= kWorthIt * before) step /= 2;
    }
    return best;
}

/// Nearer about one of the grid: the squares that are left.
double WaveSearch::polished(const Tried& found) const {
    const Outside& about = found.outside;
    const auto value = [&](const std::vector<double>& at) {
        const LagShape shape{std::exp(at[0]), at[1], at[2], about.shape.isIntegrating};
        return leftBy({shape, at[3], {at[4], at[5]}, about.isAtInput, about.perCycle * (1 + at[6])});
    };
    std::vector<double> best{std::log(about.shape.lag),
                             about.shape.second,
                             about.shape.third,
                             about.delay,
                             about.wave.rise,
                             about.wave.phase,
                             0};
    double least = found.left;
    constexpr size_t kEvaluations = 160;
    for (const double size : {1.0, -0.5, 0.25}) {
        std::vector<double> steps{0.3 * size, 0.3, 0.1, 1.5 * size, 0.07, 0.7 * size, 0.001 * size};
        if (best[1] > 0.5) steps[1] = -0.3;
        if (best[4] > 0.9) steps[4] = -0.07;
        if (best[3] + steps[3] < 0) steps[3] = -steps[3];
        const Lowest lowest = leastOf(value, best, steps, kEvaluations);
        if (lowest.value < least) least = lowest.value, best = lowest.point;
    }
    return least;
}

} // namespace

double fitWave(const Cycles& cycles) { return WaveSearch(cycles).search() / cycles.measured.total; }

} // namespace plc::tuning
