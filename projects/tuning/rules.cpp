#include "projects/tuning/rules.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plc::tuning {

std::string_view word(Rule rule) {
    switch (rule) {
#define PLC_TUNING_RULE(Name, Word, Title)                                                                             \
    case Rule::Name:                                                                                                   \
        return Word;
#include "projects/tuning/rules.def"
    }
    return {};
}

std::string_view title(Rule rule) {
    switch (rule) {
#define PLC_TUNING_RULE(Name, Word, Title)                                                                             \
    case Rule::Name:                                                                                                   \
        return Title;
#include "projects/tuning/rules.def"
    }
    return {};
}

std::vector<Rule> allRules() {
    return {
#define PLC_TUNING_RULE(Name, Word, Title) Rule::Name,
#include "projects/tuning/rules.def"
    };
}

std::optional<Rule> parseRule(std::string_view text) {
    for (const Rule rule : allRules())
        if (word(rule) == text) return rule;
    return std::nullopt;
}

double sensitivityOf(double briskness) {
    const double at = std::clamp(briskness, 0.0, 1.0);
    return at < 0.5 ? 1.2 + (1.59 - 1.2) * at * 2 : 1.59 + (2.0 - 1.59) * (at * 2 - 1);
}

FirstOrder halfRule(const ProcessModel& process, bool keepsSecond) {
    std::vector<double> lags = process.lags;
    if (const auto& o = process.oscillation) { // damped: its two lags; else both as long as the period says
        const double d = o->damping, w = o->frequency;
        const double root = d > 1 ? std::sqrt(d * d - 1) : 0;
        lags.push_back((d + root) / w);
        lags.push_back((d - root > 0 && d > 1 ? d - root : d) / w);
    }
    std::sort(lags.rbegin(), lags.rend());
    FirstOrder out{process.gain, 0, 0, process.deadTime + std::max(-process.zero, 0.0), process.isIntegrating};
    size_t next = 0;
    if (!process.isIntegrating && !lags.empty()) out.lag = lags[next++];
    if (keepsSecond && next < lags.size()) out.secondLag = lags[next++];
    if (next < lags.size()) {
        double& last =
            keepsSecond ? (next > 0 ? (out.secondLag > 0 ? out.secondLag : out.lag) : out.secondLag) : out.lag;
        const double half = lags[next] / 2;
        if (process.isIntegrating && next == 0)
            out.deadTime += lags[next]; // an integrator has no lag that could take a half
        else {
            last += half;
            out.deadTime += half;
        }
        ++next;
    }
    for (; next < lags.size(); ++next) out.deadTime += lags[next];
    return out;
}

FirstOrder byStepResponse(const ProcessModel& process) {
    FirstOrder out{process.gain, 0, 0, process.deadTime, process.isIntegrating};
    ProcessModel unit = process;
    unit.gain = 1;
    unit.deadTime = 0;
    unit.isIntegrating = false;
    if (process.isIntegrating) { // the ramp is late by all lags
        out.deadTime += std::max(process.lagSum(), 0.0);
        return out;
    }
    const double scale = unit.timeScale(), step = scale / 400;
    SampledProcess sampled(unit, step);
    double at28 = -1, at63 = -1;
    for (int i = 0; i < 40'000 && at63 < 0; ++i) {
        const double before = sampled.output();
        sampled.advance(1);
        const double now = sampled.output();
        const auto cross = [&](double level) { return step * (i + (level - before) / (now - before)); };
        if (at28 < 0 && now >= 0.2834687) at28 = cross(0.2834687);
        if (now >= 0.6321206) at63 = cross(0.6321206);
    }
    out.lag = std::max(1.5 * (at63 - at28), 0.0);
    out.deadTime += std::max(at63 - out.lag, 0.0);
    return out;
}

namespace {

/// What no rule can do without: some dead time, or any gain would do.
FirstOrder withLeastDeadTime(FirstOrder process, double delay) {
    process.deadTime += delay;
    process.deadTime = std::max(process.deadTime, 1e-3 * std::max(process.lag, 1e-9));
    return process;
}

std::optional<ControllerGains> simc(const ProcessModel& model, const Wish& wish) {
    const bool hasSecond = wish.kind == ControllerKind::Pid;
    const FirstOrder p = withLeastDeadTime(halfRule(model, hasSecond), wish.delay);
    // closed-loop time constant: the dead time; calm four times that, brisk half of it
    const double closed = p.deadTime * (wish.briskness < 0.5 ? std::pow(4, 1 - wish.briskness * 2)
                                                             : std::pow(0.5, wish.briskness * 2 - 1));
    const double sum = closed + p.deadTime;
    // the integral time: all of the lag for set points, less of it where disturbances count
    const double share = 4 * (wish.setPoint < 0.5 ? 0.5 + wish.setPoint : 1.0);
    const double lag = std::max(p.lag, 1e-9);
    double gain = p.isIntegrating ? 1 / (p.gain * sum) : lag / (p.gain * sum);
    double integral = p.isIntegrating ? share * sum : std::min(lag, share * sum);
    if (wish.kind == ControllerKind::P) return ControllerGains{gain, 0, 0, 0};
    if (!hasSecond || p.secondLag <= 0) return ControllerGains{gain, integral, 0, 0};
    // from the serial form to the standard one
    const double factor = 1 + p.secondLag / integral;
    return ControllerGains{gain * factor, integral * factor, p.secondLag / factor, p.secondLag / factor * 0.1};
}

/// Calm and brisk scale the gain of a rule that knows no such wish.
double gainFactor(const Wish& wish) { return std::pow(2, 2 * wish.briskness - 1); }

std::optional<ControllerGains> amigo(const ProcessModel& model, const Wish& wish) {
    const FirstOrder p = withLeastDeadTime(byStepResponse(model), wish.delay);
    const double k = p.gain, l = p.deadTime, t = p.lag;
    ControllerGains out;
    if (wish.kind == ControllerKind::Pid) {
        if (p.isIntegrating)
            out = {0.45 / (k * l), 8 * l, 0.5 * l, 0};
        else
            out = {(0.2 + 0.45 * t / l) / k, l * (0.4 * l + 0.8 * t) / (l + 0.1 * t), 0.5 * l * t / (0.3 * l + t), 0};
        out.filterTime = out.derivativeTime * 0.1;
    } else if (p.isIntegrating) {
        out = {0.35 / (k * l), 13.4 * l, 0, 0};
    } else {
        out = {0.15 / k + (0.35 - l * t / ((l + t) * (l + t))) * t / (k * l),
               0.35 * l + 13 * l * t * t / (t * t + 12 * l * t + 7 * l * l), 0, 0};
    }
    out.gain *= gainFactor(wish);
    if (wish.kind == ControllerKind::P) out.integralTime = 0;
    return out;
}

struct ChrRow {
    double gain, integral, derivative; // of the dead time, of the lag where `ofLag`
    bool ofLag;
};

/// Rows: 0 or 20 % overshoot; disturbance or set point; P, PI, PID.
std::optional<ControllerGains> chienHronesReswick(const ProcessModel& model, const Wish& wish) {
    const FirstOrder p = withLeastDeadTime(byStepResponse(model), wish.delay);
    if (p.isIntegrating) return std::nullopt;
    constexpr ChrRow kRows[2][2][3] = {{{{0.3, 0, 0, false}, {0.6, 4.0, 0, false}, {0.95, 2.4, 0.42, false}},
                                        {{0.3, 0, 0, false}, {0.35, 1.2, 0, true}, {0.6, 1.0, 0.5, true}}},
                                       {{{0.7, 0, 0, false}, {0.7, 2.3, 0, false}, {1.2, 2.0, 0.42, false}},
                                        {{0.7, 0, 0, false}, {0.6, 1.0, 0, true}, {0.95, 1.4, 0.47, true}}}};
    const ChrRow& row = kRows[wish.briskness > 0.5][wish.setPoint > 0.5][static_cast<size_t>(wish.kind)];
    const double factor = p.lag / (p.gain * p.deadTime);
    const double derivative = row.derivative * p.deadTime;
    return ControllerGains{row.gain * factor, row.integral * (row.ofLag ? p.lag : p.deadTime), derivative,
                           derivative * 0.1};
}

std::optional<ControllerGains> zieglerNichols(const ProcessModel& model, const Wish& wish) {
    const FirstOrder p = withLeastDeadTime(byStepResponse(model), wish.delay);
    const double slope = p.isIntegrating ? p.gain : p.gain / std::max(p.lag, 1e-9);
    const double unit = 1 / (slope * p.deadTime);
    switch (wish.kind) {
    case ControllerKind::P:
        return ControllerGains{unit, 0, 0, 0};
    case ControllerKind::Pi:
        return ControllerGains{0.9 * unit, p.deadTime / 0.3, 0, 0};
    case ControllerKind::Pid:
        return ControllerGains{1.2 * unit, 2 * p.deadTime, 0.5 * p.deadTime, 0.05 * p.deadTime};
    }
    return std::nullopt;
}

/// The optimum, and for set points an integral that is never quicker than the process.
std::optional<ControllerGains> best(const ProcessModel& model, const Wish& wish) {
    auto out = optimum(model, wish.kind, sensitivityOf(wish.briskness), wish.delay);
    if (!out || wish.setPoint <= 0.5 || out->integralTime <= 0) return out;
    const double share = wish.setPoint * 2 - 1;
    const double longest = std::max(out->integralTime, halfRule(model, false).lag);
    out->integralTime = out->integralTime * (1 - share) + longest * share;
    return out;
}

} // namespace

std::optional<ControllerGains> tune(const ProcessModel& process, Rule rule, const Wish& wish) {
    if (process.gain == 0) return std::nullopt;
    std::optional<ControllerGains> out;
    switch (rule) {
    case Rule::Simc:
        out = simc(process, wish);
        break;
    case Rule::Amigo:
        out = amigo(process, wish);
        break;
    case Rule::Optimum:
        out = best(process, wish);
        break;
    case Rule::ChienHronesReswick:
        out = chienHronesReswick(process, wish);
        break;
    case Rule::ZieglerNichols:
        out = zieglerNichols(process, wish);
        break;
    }
    if (!out || !std::isfinite(out->gain) || out->gain == 0 || !std::isfinite(out->integralTime)) return std::nullopt;
    return out;
}

} // namespace plc::tuning
