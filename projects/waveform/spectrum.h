// What frequencies a signal is made of, and how a process answers to them, from recordings. Averages over overlapping
// windows, so that an hour of scans is worked on in pieces. Functions, any thread.
#pragma once
#include "projects/waveform/samples.h"
#include "runtime/base/result.h"

#include <complex>

namespace plc::waveform {

enum class Window : uint8_t { Hann, FlatTop, Rectangular };

struct SpectrumOptions {
    Window window = Window::Hann;
    size_t mostPoints = 1 << 16; // of one window: finer resolution, less averaging
};

struct Peak {
    double frequency = 0, amplitude = 0; // [Hz]
};

struct Spectrum {
    std::vector<double> frequency; // [Hz], from above 0 to half the sampling rate
    std::vector<double> amplitude; // of a sine of that frequency
    double mean = 0, rms = 0;      // rms: of the deviation from the mean
    double interval = 0;           // [s]
    size_t windows = 0;            // averaged
    /// The highest first; none under a twentieth of the highest.
    [[nodiscard]] std::vector<Peak> peaks(size_t most) const;
};

[[nodiscard]] Result<Spectrum> spectrumOf(const Samples& samples, const SpectrumOptions& options = {});

/// Output over input at a frequency, as far as the recording has it.
struct ResponsePoint {
    double frequency = 0; // [Hz]
    std::complex<double> gain;
    double coherence = 0; // 0…1: the share of the output that the input explains
};
/// Rising frequencies, only those that the input moved at.
[[nodiscard]] Result<std::vector<ResponsePoint>> frequencyResponse(const Samples& input, const Samples& output);

} // namespace plc::waveform
