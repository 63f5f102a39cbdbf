// A linear model of a process, as control engineers write it: gain, lags, oscillation, zero, dead time; its frequency
// response and its exact response to an input that is held between samples. Values and functions, any thread.
#pragma once
#include "projects/waveform/chart.h"

#include <complex>
#include <optional>
#include <string>
#include <vector>

namespace plc::tuning {

using Complex = std::complex<double>;

struct Oscillation {
    double frequency = 1; // natural, undamped [rad/s]
    double damping = 1;
};

/// gain (1 + zero s) e^(-deadTime s) / (product of (lag s + 1), oscillation and, where it integrates, s).
struct ProcessModel {
    double gain = 1;          // of an integrating process: slope of the output per unit of the input [1/s]
    std::vector<double> lags; // [s], greatest first
    std::optional<Oscillation> oscillation;
    double zero = 0; // [s]; below 0 the response starts in the wrong direction
    double deadTime = 0;
    bool isIntegrating = false;

    [[nodiscard]] Complex at(double omega) const;
    /// Sum of the lags without the dead time: where the response has its centre.
    [[nodiscard]] double lagSum() const;
    /// Dead time and lags together, never 0: what a time axis is scaled by.
    [[nodiscard]] double timeScale() const;
    [[nodiscard]] size_t order() const { return lags.size() + (oscillation ? 2 : 0) + (isIntegrating ? 1 : 0); }
};

/// "2 e^(-0.5 s) / (3 s + 1)".
[[nodiscard]] std::string formula(const ProcessModel& model);
using waveform::numberText;

/// The process between two sampling instants, exact for an input that is held; the dead time may be any.
class SampledProcess {
public:
    SampledProcess(const ProcessModel& model, double interval);
    /// The output before the next input acts; the part that passes at once is not in it.
    [[nodiscard]] double output() const;
    /// One interval with this input.
    void advance(double input);
    /// As if this input had always been there (a process that integrates stays where it is).
    void settle(double input);
    /// The slope of the output without the zero: what a zero adds, per second of it.
    [[nodiscard]] double slope() const;
    [[nodiscard]] size_t states() const { return m_size; }
    /// Only the natural response: starts from one state, input 0.
    void startFrom(size_t state);
    /// How long the input takes to act, in samples.
    [[nodiscard]] size_t delaySamples() const { return m_delay; }

private:
    [[nodiscard]] double delayed(size_t samples) const;
    size_t m_size = 0, m_delay = 0, m_newest = 0;
    double m_gain = 1, m_zero = 0;
    double m_direct = 0;                     // of the last delayed input, for a process without lags
    double m_slopeDirect = 0;                // of the input in the slope
    std::vector<double> m_phi, m_old, m_new; // row by row; share of the older and of the newer input
    std::vector<double> m_out, m_slope;      // rows
    std::vector<double> m_state, m_next;
    std::vector<double> m_inputs; // ring
};

} // namespace plc::tuning
