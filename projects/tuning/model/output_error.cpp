#include "projects/tuning/model/output_error.h"

#include <Eigen/Dense>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace plc::tuning {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Shape {
    int lags = 0;  // own time constants
    int equal = 1; // how often each of them is there
    bool oscillates = false, hasZero = false, integrates = false, hasDelay = false;
};

Shape shapeOf(Structure structure) {
    switch (structure) {
    case Structure::Proportional:
        return {0, 1, false, false, false, true};
    case Structure::OneLag:
        return {1};
    case Structure::OneLagDelay:
        return {1, 1, false, false, false, true};
    case Structure::TwoLags:
        return {2};
    case Structure::TwoLagsDelay:
        return {2, 1, false, false, false, true};
    case Structure::TwoEqual:
        return {1, 2};
    case Structure::TwoEqualDelay:
        return {1, 2, false, false, false, true};
    case Structure::Oscillating:
        return {0, 1, true};
    case Structure::OscillatingDelay:
        return {0, 1, true, false, false, true};
    case Structure::OscillatingLag:
        return {1, 1, true};
    case Structure::InverseLag:
        return {2, 1, false, true};
    case Structure::InverseDelay:
        return {2, 1, false, true, false, true};
    case Structure::ThreeEqual:
        return {1, 3};
    case Structure::ThreeEqualZero:
        return {1, 3, false, true};
    case Structure::FourEqual:
        return {1, 4};
    case Structure::FiveEqual:
        return {1, 5};
    case Structure::SixEqual:
        return {1, 6};
    case Structure::SevenEqual:
        return {1, 7};
    case Structure::EightEqual:
        return {1, 8};
    case Structure::ThreeEqualDelay:
        return {1, 3, false, false, false, true};
    case Structure::ThreeLags:
        return {3};
    case Structure::ThreeLagsDelay:
        return {3, 1, false, false, false, true};
    case Structure::FourLags:
        return {4};
    case Structure::Integrating:
        return {0, 1, false, false, true};
    case Structure::IntegratingDelay:
        return {0, 1, false, false, true, true};
    case Structure::IntegratingLag:
        return {1, 1, false, false, true};
    case Structure::IntegratingLagDelay:
        return {1, 1, false, false, true, true};
    case Structure::IntegratingTwoEqual:
        return {1, 2, false, false, true};
    }
    return {};
}

/// The part of the output that is none of the model's: offset, drift of what integrates, what moved before.
MatrixXd nuisance(const ProcessModel& model, const Excerpt& excerpt) {
    const auto count = static_cast<Index>(excerpt.output.size());
    std::vector<VectorXd> columns{VectorXd::Ones(count)};
    if (!excerpt.startsAtRest) {
        if (model.isIntegrating) columns.push_back(VectorXd::LinSpaced(count, -1, 1));
        ProcessModel unit = model;
        unit.gain = 1;
        unit.zero = unit.deadTime = 0;
        SampledProcess process(unit, excerpt.interval);
        const size_t states = std::min<size_t>(process.states() - (model.isIntegrating ? 1 : 0), 2);
        for (size_t state = 0; state < states; ++state) {
            process.startFrom(process.states() - 1 - state);
            VectorXd column(count);
            for (Index i = 0; i < count; ++i) {
                column(i) = process.output();
                process.advance(0);
            }
            columns.push_back(std::move(column));
        }
    }
    MatrixXd out(count, static_cast<Index>(columns.size()));
    for (size_t i = 0; i < columns.size(); ++i) out.col(static_cast<Index>(i)) = columns[i];
    return out;
}

/// The response with gain 1 and its slope, to the input as it differs from its first value.
void respond(const ProcessModel& model, const Excerpt& excerpt, Eigen::Ref<VectorXd> out, Eigen::Ref<VectorXd> slope) {
    ProcessModel unit = model;
    unit.gain = 1;
    unit.zero = 0;
    SampledProcess process(unit, excerpt.interval);
    const bool wantsSlope = slope.size() > 0;
    for (size_t i = 0; i < excerpt.input.size(); ++i) {
        const auto at = static_cast<Index>(i);
        out(at) = process.output();
        if (wantsSlope) slope(at) = process.slope();
        process.advance(excerpt.input[i] - excerpt.input.front());
    }
}

/// Takes out of each column what the nuisance explains.
void project(const MatrixXd& nuisance, Eigen::Ref<MatrixXd> columns) {
    if (nuisance.cols() == 1) {
        columns.rowwise() -= columns.colwise().mean();
        return;
    }
    const Eigen::ColPivHouseholderQR<MatrixXd> qr(nuisance);
    // Only the columns that are needed: all of them are as many as there are samples.
    const MatrixXd basis = qr.householderQ() * MatrixXd::Identity(nuisance.rows(), qr.rank());
    columns -= basis * (basis.transpose() * columns);
}

Index samplesOf(const std::vector<Excerpt>& excerpts) {
    size_t count = 0;
    for (const Excerpt& excerpt : excerpts) count += excerpt.output.size();
    return static_cast<Index>(count);
}

/// Response, slope and measured output of all excerpts, one below the other, without offsets.
struct Columns {
    MatrixXd regressors;
    VectorXd measured;
};

Columns columnsOf(const ProcessModel& model, const std::vector<Excerpt>& excerpts, bool hasZero) {
    const Index total = samplesOf(excerpts), width = hasZero ? 2 : 1;
    Columns out{MatrixXd(total, width), VectorXd(total)};
    Index row = 0;
    for (const Excerpt& excerpt : excerpts) {
        const auto count = static_cast<Index>(excerpt.output.size());
        MatrixXd block(count, width + 1);
        VectorXd slope(hasZero ? count : 0);
        respond(model, excerpt, block.col(0), slope);
        if (hasZero) block.col(1) = slope;
        block.col(width) = Eigen::Map<const VectorXd>(excerpt.output.data(), count);
        project(nuisance(model, excerpt), block);
        out.regressors.middleRows(row, count) = block.leftCols(width);
        out.measured.segment(row, count) = block.col(width);
        row += count;
    }
    return out;
}

/// Time constants as logarithms, the dead time as a share of the longest it may be.
class Problem {
public:
    using Scalar = double;
    using InputType = VectorXd;
    using ValueType = VectorXd;
    using JacobianType = MatrixXd;
    enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

    Problem(const std::vector<Excerpt>& excerpts, Shape shape) : m_excerpts(excerpts), m_shape(shape) {
        for (const Excerpt& excerpt : excerpts)
            m_longest = std::max(m_longest, excerpt.interval * static_cast<double>(excerpt.output.size()));
        m_shortest = excerpts.front().interval;
    }
    [[nodiscard]] int inputs() const {
        return m_shape.lags + (m_shape.oscillates ? 2 : 0) + (m_shape.hasDelay ? 1 : 0);
    }
    [[nodiscard]] int values() const { return static_cast<int>(samplesOf(m_excerpts)); }
    [[nodiscard]] double longest() const { return m_longest; }
    [[nodiscard]] double shortest() const { return m_shortest; }

    [[nodiscard]] ProcessModel modelOf(const VectorXd& at) const {
        ProcessModel model;
        Index next = 0;
        const auto time = [&](double logarithm) {
            return std::exp(std::clamp(logarithm, std::log(m_shortest * 1e-2), std::log(m_longest * 1e2)));
        };
        for (int i = 0; i < m_shape.lags; ++i, ++next)
            for (int k = 0; k < m_shape.equal; ++k) model.lags.push_back(time(at(next)));
        std::sort(model.lags.rbegin(), model.lags.rend());
        if (m_shape.oscillates) {
            model.oscillation = Oscillation{1 / time(at(next)), std::exp(std::clamp(at(next + 1), -7.0, 3.0))};
            next += 2;
        }
        if (m_shape.hasDelay) model.deadTime = std::min(std::abs(at(next)), 0.9) * m_longest;
        model.isIntegrating = m_shape.integrates;
        return model;
    }
    /// With gain and zero.
    [[nodiscard]] std::pair<ProcessModel, VectorXd> solved(const VectorXd& at) const {
        ProcessModel model = modelOf(at);
        const Columns columns = columnsOf(model, m_excerpts, m_shape.hasZero);
        const VectorXd linear = columns.regressors.colPivHouseholderQr().solve(columns.measured);
        model.gain = linear(0);
        if (m_shape.hasZero && linear(0) != 0) model.zero = linear(1) / linear(0);
        return {model, columns.measured - columns.regressors * linear};
    }
    int operator()(const VectorXd& at, VectorXd& residual) const {
        residual = solved(at).second;
        if (!residual.allFinite()) residual.setConstant(1e150);
        return 0;
    }

private:
    const std::vector<Excerpt>& m_excerpts;
    Shape m_shape;
    double m_longest = 0, m_shortest = 1;
};

/// Where to start: every lag and dead time of a coarse grid, from quick to slow.
std::vector<VectorXd> starts(const Problem& problem, const Shape& shape) {
    std::vector<VectorXd> out;
    const double low = problem.shortest() * 2, high = problem.longest();
    constexpr int kTimes = 8;
    const std::vector<double> dead =
        shape.hasDelay ? std::vector<double>{0.003, 0.02, 0.06, 0.15, 0.35} : std::vector<double>{0.0};
    const std::vector<double> dampings =
        shape.oscillates ? std::vector<double>{0.1, 0.4, 0.9} : std::vector<double>{0.0};
    const std::vector<double> shares = shape.lags > 1 ? std::vector<double>{0.15, 0.6} : std::vector<double>{1.0};
    for (int i = 0; i < kTimes; ++i)
        for (const double delay : dead)
            for (const double damping : dampings)
                for (const double share : shares) {
                    if (problem.inputs() == 0 || (i > 0 && problem.inputs() == 1 && shape.hasDelay)) continue;
                    const double time = low * std::pow(high / low, i / (kTimes - 1.0)) / shape.equal;
                    VectorXd at(problem.inputs());
                    Index next = 0;
                    for (int k = 0; k < shape.lags; ++k) at(next++) = std::log(time * std::pow(share, k));
                    if (shape.oscillates) {
                        at(next++) = std::log(time);
                        at(next++) = std::log(damping);
                    }
                    if (shape.hasDelay) at(next++) = delay;
                    out.push_back(std::move(at));
                }
    return out;
}

struct Local {
    VectorXd at;
    double squares = 0;
};

Local improve(Problem& problem, VectorXd at, int evaluations) {
    VectorXd residual;
    if (problem.inputs() > 0) {
        Eigen::NumericalDiff<Problem> differentiated(problem);
        Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Problem>> solver(differentiated);
        solver.parameters.maxfev = evaluations;
        solver.parameters.ftol = solver.parameters.xtol = 1e-12;
        solver.minimize(at);
    }
    problem(at, residual);
    return {at, residual.squaredNorm()};
}

/// The best of the grid, improved a little, and of those the best to the end.
std::optional<VectorXd> search(Problem& problem, const Shape& shape) {
    if (problem.inputs() == 0) return VectorXd(0);
    std::vector<Local> all;
    VectorXd residual;
    for (VectorXd& at : starts(problem, shape)) {
        problem(at, residual);
        all.push_back({std::move(at), residual.squaredNorm()});
    }
    const auto byResidual = [](const Local& a, const Local& b) { return a.squares < b.squares; };
    std::sort(all.begin(), all.end(), byResidual);
    all.resize(std::min<size_t>(all.size(), 3));
    for (Local& one : all) one = improve(problem, one.at, 40);
    std::sort(all.begin(), all.end(), byResidual);
    const Local best = improve(problem, all.front().at, 300);
    if (!std::isfinite(best.squares)) return std::nullopt;
    return best.squares <= all.front().squares ? best.at : all.front().at;
}

/// A coarser copy for the search; the last steps use all samples.
std::vector<Excerpt> thinned(const std::vector<Excerpt>& excerpts, size_t most) {
    std::vector<Excerpt> out;
    for (const Excerpt& excerpt : excerpts) {
        const size_t factor = std::max<size_t>(excerpt.output.size() / most, 1);
        Excerpt thin{excerpt.interval * static_cast<double>(factor), {}, {}, excerpt.startsAtRest};
        for (size_t i = 0; i + factor <= excerpt.output.size(); i += factor) {
            double input = 0;
            for (size_t k = 0; k < factor; ++k) input += excerpt.input[i + k] / static_cast<double>(factor);
            thin.input.push_back(factor == 1 ? excerpt.input[i] : input);
            thin.output.push_back(excerpt.output[i]);
        }
        out.push_back(std::move(thin));
    }
    return out;
}

/// What has become nothing, or cancels, or of which only the start was recorded (an integrator, as far as anybody can
/// say) belongs to a simpler structure.
bool isDegenerate(const ProcessModel& model, double least, double longest, const Shape& shape) {
    constexpr double kTooLong = 25; // times the recording
    for (const double lag : model.lags)
        if (lag < least || lag > kTooLong * longest || (shape.hasZero && std::abs(model.zero - lag) < 1e-2 * lag))
            return true;
    // above damping 1 it is two lags
    if (const auto& o = model.oscillation; o && (1 / o->frequency < least || o->damping > 1)) return true;
    if (shape.hasZero && std::abs(model.zero) < least) return true;
    return shape.hasDelay && model.deadTime < least;
}

} // namespace

std::optional<OutputErrorFit> fitOutputError(const std::vector<Excerpt>& excerpts, Structure structure) {
    if (excerpts.empty() || samplesOf(excerpts) < 8) return std::nullopt;
    const Shape shape = shapeOf(structure);
    const std::vector<Excerpt> coarse = thinned(excerpts, 120);
    Problem rough(coarse, shape), problem(excerpts, shape);
    auto at = search(rough, shape);
    if (!at) return std::nullopt;
    // the share of the dead time speaks of the longest excerpt, which thinning may have cut
    if (shape.hasDelay) (*at)(at->size() - 1) *= rough.longest() / problem.longest();
    *at = improve(problem, *at, 200).at;
    OutputErrorFit fit;
    fit.model = problem.solved(*at).first;
    fit.parameters = static_cast<size_t>(problem.inputs()) + 1 + (shape.hasZero ? 1 : 0);
    const double least = excerpts.front().interval * 0.02;
    double longest = 0;
    for (const Excerpt& excerpt : excerpts)
        longest = std::max(longest, excerpt.interval * static_cast<double>(excerpt.output.size()));
    if (isDegenerate(fit.model, least, longest, shape)) return std::nullopt;
    if (!std::isfinite(fit.model.gain) || fit.model.gain == 0) return std::nullopt;
    fit.simulated = simulate(fit.model, excerpts);
    return fit;
}

std::vector<std::vector<double>> simulate(const ProcessModel& model, const std::vector<Excerpt>& excerpts) {
    std::vector<std::vector<double>> out;
    for (const Excerpt& excerpt : excerpts) {
        const auto count = static_cast<Index>(excerpt.output.size());
        VectorXd response(count), slope(model.zero != 0 ? count : 0);
        respond(model, excerpt, response, slope);
        if (model.zero != 0) response += model.zero * slope;
        response *= model.gain;
        const MatrixXd rest = nuisance(model, excerpt);
        const VectorXd missing = Eigen::Map<const VectorXd>(excerpt.output.data(), count) - response;
        response += rest * rest.colPivHouseholderQr().solve(missing);
        out.emplace_back(response.data(), response.data() + count);
    }
    return out;
}

double gainOf(const ProcessModel& model, const std::vector<Excerpt>& excerpts) {
    const Columns columns = columnsOf(model, excerpts, model.zero != 0);
    VectorXd response = columns.regressors.col(0);
    if (model.zero != 0) response += model.zero * columns.regressors.col(1);
    return response.dot(columns.measured) / response.squaredNorm();
}

namespace {

struct Parameter {
    std::string name;
    double value;
    void (*set)(ProcessModel&, size_t, double);
    size_t index;
};

std::vector<Parameter> parametersOf(const ProcessModel& model) {
    std::vector<Parameter> out{{"gain", model.gain, [](ProcessModel& m, size_t, double v) { m.gain = v; }, 0}};
    for (size_t i = 0; i < model.lags.size();) { // equal ones are one parameter
        size_t same = i;
        while (same < model.lags.size() && model.lags[same] == model.lags[i]) ++same;
        const std::string name = same == model.lags.size() && i == 0 ? "lag" : "lag " + std::to_string(i + 1);
        out.push_back({name, model.lags[i],
                       [](ProcessModel& m, size_t at, double v) {
                           const double old = m.lags[at];
                           for (double& lag : m.lags)
                               if (lag == old) lag = v;
                       },
                       i});
        i = same;
    }
    if (const auto& o = model.oscillation) {
        out.push_back(
            {"frequency", o->frequency, [](ProcessModel& m, size_t, double v) { m.oscillation->frequency = v; }, 0});
        out.push_back(
            {"damping", o->damping, [](ProcessModel& m, size_t, double v) { m.oscillation->damping = v; }, 0});
    }
    if (model.zero != 0) out.push_back({"zero", model.zero, [](ProcessModel& m, size_t, double v) { m.zero = v; }, 0});
    if (model.deadTime > 0)
        out.push_back({"dead time", model.deadTime, [](ProcessModel& m, size_t, double v) { m.deadTime = v; }, 0});
    return out;
}

VectorXd modelOutput(const ProcessModel& model, const std::vector<Excerpt>& excerpts) {
    const Columns columns = columnsOf(model, excerpts, model.zero != 0);
    VectorXd out = columns.regressors.col(0);
    if (model.zero != 0) out += model.zero * columns.regressors.col(1);
    return model.gain * out;
}

} // namespace

std::vector<Bound> confidence(const ProcessModel& model, const std::vector<Excerpt>& excerpts) {
    const std::vector<Parameter> parameters = parametersOf(model);
    const VectorXd middle = modelOutput(model, excerpts);
    const VectorXd residual = columnsOf(model, excerpts, false).measured - middle;
    const auto width = static_cast<Index>(parameters.size());
    MatrixXd jacobian(middle.size(), width);
    for (Index i = 0; i < width; ++i) {
        const Parameter& parameter = parameters[static_cast<size_t>(i)];
        const double step = 1e-4 * std::abs(parameter.value);
        ProcessModel moved = model;
        parameter.set(moved, parameter.index, parameter.value + step);
        jacobian.col(i) = (modelOutput(moved, excerpts) - middle) / step;
    }
    const Index free = std::max<Index>(middle.size() - width, 1);
    double variance = residual.squaredNorm() / static_cast<double>(free);
    // neighbours that resemble each other are worth fewer samples
    const Index last = residual.size() - 1;
    const double likeness =
        residual.squaredNorm() > 0 ? residual.head(last).dot(residual.tail(last)) / residual.squaredNorm() : 0;
    const double alike = std::clamp(likeness, 0.0, 0.98);
    variance *= (1 + alike) / (1 - alike);
    const MatrixXd covariance =
        (jacobian.transpose() * jacobian).completeOrthogonalDecomposition().pseudoInverse() * variance;
    std::vector<Bound> out;
    for (Index i = 0; i < width; ++i)
        out.push_back({parameters[static_cast<size_t>(i)].name, parameters[static_cast<size_t>(i)].value,
                       1.96 * std::sqrt(std::max(covariance(i, i), 0.0))});
    return out;
}

} // namespace plc::tuning
