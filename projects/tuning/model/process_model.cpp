#include "projects/tuning/model/process_model.h"

#include <Eigen/Dense>
#include <unsupported/Eigen/MatrixFunctions>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

namespace plc::tuning {

Complex ProcessModel::at(double omega) const {
    const Complex s(0, omega);
    Complex value = gain * (1.0 + zero * s) * std::exp(-deadTime * s);
    for (const double lag : lags) value /= lag * s + 1.0;
    if (oscillation) {
        const Complex q = s / oscillation->frequency;
        value /= q * q + 2.0 * oscillation->damping * q + 1.0;
    }
    return isIntegrating ? value / s : value;
}

double ProcessModel::lagSum() const {
    const double sum = std::accumulate(lags.begin(), lags.end(), 0.0);
    return sum + (oscillation ? 2 * oscillation->damping / oscillation->frequency : 0.0) - zero;
}

double ProcessModel::timeScale() const {
    double scale = std::accumulate(lags.begin(), lags.end(), deadTime) + std::abs(zero);
    if (oscillation) scale += 1 / oscillation->frequency;
    return scale > 0 ? scale : 1;
}

std::string formula(const ProcessModel& model) {
    std::string out = numberText(model.gain);
    if (model.zero != 0)
        out += std::string(" (1 ") + (model.zero < 0 ? "- " : "+ ") + numberText(std::abs(model.zero)) + " s)";
    if (model.deadTime > 0) out += " e^(-" + numberText(model.deadTime) + " s)";
    std::string below;
    if (model.isIntegrating) below = "s";
    for (size_t i = 0; i < model.lags.size();) {
        size_t same = i;
        while (same < model.lags.size() && model.lags[same] == model.lags[i]) ++same;
        below += (below.empty() ? "(" : " (") + numberText(model.lags[i]) + " s + 1)";
        if (same - i > 1) below += "^" + std::to_string(same - i);
        i = same;
    }
    if (const auto& o = model.oscillation)
        below += std::string(below.empty() ? "" : " ") + "(" + numberText(1 / (o->frequency * o->frequency)) +
                 " s^2 + " + numberText(2 * o->damping / o->frequency) + " s + 1)";
    if (below.empty()) return out;
    const bool hasSeveral = below.find(' ') != std::string::npos && below.find(") ") != std::string::npos;
    return out + " / " + (hasSeveral || model.isIntegrating ? "(" + below + ")" : below);
}

namespace {

/// The process with gain 1 and no dead time as x' = A x + B u, one block behind the other; the last state is the
/// output.
struct StateSpace {
    Eigen::MatrixXd a;
    Eigen::VectorXd b;
    Eigen::RowVectorXd out, slope;
    double slopeOfInput = 0;
};

StateSpace stateSpace(const ProcessModel& model) {
    const auto size = static_cast<Eigen::Index>(model.order());
    StateSpace space{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size), Eigen::RowVectorXd::Zero(size),
                     Eigen::RowVectorXd::Zero(size)};
    Eigen::Index at = 0, source = -1; // -1: the input
    const auto feed = [&](Eigen::Index state, double factor) {
        if (source < 0)
            space.b(state) += factor;
        else
            space.a(state, source) += factor;
    };
    for (const double lag : model.lags) {
        space.a(at, at) = -1 / lag;
        feed(at, 1 / lag);
        source = at++;
    }
    if (const auto& o = model.oscillation) {
        const double w = o->frequency;
        space.a(at, at + 1) = 1;
        space.a(at + 1, at) = -w * w;
        space.a(at + 1, at + 1) = -2 * o->damping * w;
        feed(at + 1, w * w);
        source = at;
        at += 2;
    }
    if (model.isIntegrating) {
        feed(at, 1);
        source = at++;
    }
    if (size == 0) return space;
    space.out(source) = 1;
    space.slope = space.a.row(source);
    space.slopeOfInput = space.b(source);
    return space;
}

/// e^(A t) and its integral times B.
std::pair<Eigen::MatrixXd, Eigen::VectorXd> held(const StateSpace& space, double time) {
    const Eigen::Index size = space.b.size();
    Eigen::MatrixXd block = Eigen::MatrixXd::Zero(size + 1, size + 1);
    block.topLeftCorner(size, size) = space.a * time;
    block.topRightCorner(size, 1) = space.b * time;
    const Eigen::MatrixXd all = block.exp();
    return {all.topLeftCorner(size, size), all.topRightCorner(size, 1)};
}

} // namespace

SampledProcess::SampledProcess(const ProcessModel& model, double interval)
    : m_size(model.order()), m_gain(model.gain), m_zero(model.zero) {
    const double samples = std::max(model.deadTime, 0.0) / interval;
    m_delay = static_cast<size_t>(samples + 1e-9);
    const double rest = std::max(samples - static_cast<double>(m_delay), 0.0) * interval;
    m_inputs.assign(m_delay + 2, 0.0);
    m_state.assign(m_size, 0.0);
    m_next = m_state;
    if (m_size == 0) {
        m_direct = 1;
        return;
    }
    const StateSpace space = stateSpace(model);
    const auto [phi, whole] = held(space, interval);
    Eigen::VectorXd older = Eigen::VectorXd::Zero(space.b.size()), newer = whole;
    if (rest > 0) {
        const auto [phiNew, ofNew] = held(space, interval - rest);
        older = phiNew * held(space, rest).second;
        newer = ofNew;
    }
    m_phi.resize(m_size * m_size);
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(m_phi.data(), phi.rows(),
                                                                                       phi.cols()) = phi;
    m_old.assign(older.data(), older.data() + older.size());
    m_new.assign(newer.data(), newer.data() + newer.size());
    m_out.assign(space.out.data(), space.out.data() + space.out.size());
    m_slope.assign(space.slope.data(), space.slope.data() + space.slope.size());
    m_slopeDirect = space.slopeOfInput;
}

double SampledProcess::delayed(size_t samples) const {
    const size_t count = m_inputs.size();
    return m_inputs[(m_newest + count - samples % count) % count];
}

double SampledProcess::output() const {
    if (m_size == 0) return m_gain * m_direct * delayed(m_delay);
    double value = 0;
    for (size_t i = 0; i < m_size; ++i) value += m_out[i] * m_state[i];
    return m_gain * (value + (m_zero != 0 ? m_zero * slope() : 0.0));
}

double SampledProcess::slope() const {
    double value = m_slopeDirect * delayed(m_delay);
    for (size_t i = 0; i < m_size; ++i) value += m_slope[i] * m_state[i];
    return value;
}

void SampledProcess::advance(double input) {
    m_newest = (m_newest + 1) % m_inputs.size();
    m_inputs[m_newest] = input;
    const double newer = delayed(m_delay), older = delayed(m_delay + 1);
    for (size_t i = 0; i < m_size; ++i) {
        double value = m_old[i] * older + m_new[i] * newer;
        const double* row = m_phi.data() + i * m_size;
        for (size_t k = 0; k < m_size; ++k) value += row[k] * m_state[k];
        m_next[i] = value;
    }
    m_state.swap(m_next);
}

void SampledProcess::settle(double input) {
    std::fill(m_inputs.begin(), m_inputs.end(), input);
    if (m_size == 0) return;
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto size = static_cast<Eigen::Index>(m_size);
    const Eigen::MatrixXd rest = Eigen::MatrixXd::Identity(size, size) - Eigen::Map<Matrix>(m_phi.data(), size, size);
    const Eigen::VectorXd drive =
        (Eigen::Map<Eigen::VectorXd>(m_old.data(), size) + Eigen::Map<Eigen::VectorXd>(m_new.data(), size)) * input;
    const Eigen::VectorXd state = rest.completeOrthogonalDecomposition().solve(drive);
    std::copy(state.data(), state.data() + size, m_state.begin());
}

void SampledProcess::startFrom(size_t state) {
    std::fill(m_inputs.begin(), m_inputs.end(), 0.0);
    std::fill(m_state.begin(), m_state.end(), 0.0);
    m_state[state] = 1;
}

} // namespace plc::tuning
