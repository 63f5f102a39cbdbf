#include "projects/waveform/spectrum.h"

#include "projects/waveform/errors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <unsupported/Eigen/FFT>

namespace plc::waveform {

namespace {

using Complex = std::complex<double>;
constexpr size_t kLeast = 16;

std::vector<double> weightsOf(Window window, size_t count) {
    std::vector<double> out(count);
    for (size_t i = 0; i < count; ++i) {
        const double at = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        switch (window) {
        case Window::Hann:
            out[i] = 0.5 - 0.5 * std::cos(at);
            break;
        case Window::FlatTop: // ISO 18431-1: amplitudes right to 0.1 %, at the price of resolution
            out[i] = 1 - 1.933 * std::cos(at) + 1.286 * std::cos(2 * at) - 0.388 * std::cos(3 * at) +
                     0.0322 * std::cos(4 * at);
            break;
        case Window::Rectangular:
            out[i] = 1;
            break;
        }
    }
    return out;
}

/// The greatest power of two that fits.
size_t windowLength(size_t samples, size_t most) {
    size_t length = kLeast;
    while (length * 2 <= std::min(samples, most)) length *= 2;
    return length;
}

double meanOf(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// Where windows of that length start: half over each other, the last one at the end.
std::vector<size_t> startsOf(size_t samples, size_t length) {
    std::vector<size_t> out;
    for (size_t at = 0; at + length <= samples; at += length / 2) out.push_back(at);
    if (out.back() + length < samples) out.push_back(samples - length);
    return out;
}

/// Takes windows of a signal to frequencies, one after the other.
class Transform {
public:
    Transform(Window window, size_t length) : m_weights(weightsOf(window, length)), m_piece(length) {}
    const std::vector<Complex>& operator()(const std::vector<double>& values, size_t at, double mean) {
        for (size_t i = 0; i < m_piece.size(); ++i) m_piece[i] = (values[at + i] - mean) * m_weights[i];
        m_fft.fwd(m_out, m_piece);
        return m_out;
    }
    [[nodiscard]] double sum() const {
        double out = 0;
        for (const double weight : m_weights) out += weight;
        return out;
    }

private:
    Eigen::FFT<double> m_fft;
    std::vector<double> m_weights, m_piece;
    std::vector<Complex> m_out;
};

size_t evenCount(const Samples& samples, double interval) {
    return static_cast<size_t>((samples.time.back() - samples.time.front()) / interval + 0.5) + 1;
}

/// An even grid that a broken time column cannot make endless.
double evenInterval(const Samples& samples) {
    constexpr double kMost = 1 << 26;
    return std::max(usualInterval(samples.time), (samples.time.back() - samples.time.front()) / kMost);
}

} // namespace

std::vector<Peak> Spectrum::peaks(size_t most) const {
    std::vector<Peak> out;
    double highest = 0;
    for (const double value : amplitude) highest = std::max(highest, value);
    for (size_t i = 1; i + 1 < amplitude.size(); ++i) {
        const double left = amplitude[i - 1], middle = amplitude[i], right = amplitude[i + 1];
        if (middle <= left || middle < right || middle < highest / 20) continue;
        // A parabola through the three logarithms: a Hann window's top to a hundredth of a line.
        double shift = 0, height = middle;
        if (left > 0 && right > 0) {
            const double a = std::log(left), b = std::log(middle), c = std::log(right), bend = a - 2 * b + c;
            if (bend < 0) {
                shift = std::clamp(0.5 * (a - c) / bend, -0.5, 0.5);
                height = std::exp(b - 0.25 * (a - c) * shift);
            }
        }
        out.push_back({frequency[i] + shift * (frequency[1] - frequency[0]), height});
    }
    std::sort(out.begin(), out.end(), [](const Peak& a, const Peak& b) { return a.amplitude > b.amplitude; });
    if (out.size() > most) out.resize(most);
    return out;
}

Result<Spectrum> spectrumOf(const Samples& samples, const SpectrumOptions& options) {
    const double interval = samples.size() < kLeast ? 0 : evenInterval(samples);
    if (!(interval > 0)) return Error{errors::SpectrumTooShort(static_cast<int64_t>(samples.size())), ""};
    const std::vector<double> values = heldAt(samples, samples.time.front(), interval, evenCount(samples, interval));
    if (values.size() < kLeast) return Error{errors::SpectrumTooShort(static_cast<int64_t>(values.size())), ""};
    Spectrum out;
    out.interval = interval;
    out.mean = meanOf(values);
    for (const double value : values) out.rms += (value - out.mean) * (value - out.mean);
    out.rms = std::sqrt(out.rms / static_cast<double>(values.size()));
    const size_t length = windowLength(values.size(), std::max(options.mostPoints, kLeast));
    Transform transform(options.window, length);
    std::vector<double> power(length / 2, 0);
    const std::vector<size_t> starts = startsOf(values.size(), length);
    for (const size_t at : starts) {
        const std::vector<Complex>& lines = transform(values, at, out.mean);
        for (size_t i = 0; i < power.size(); ++i) power[i] += std::norm(lines[i + 1]);
    }
    out.windows = starts.size();
    const double scale = 2 / transform.sum();
    for (size_t i = 0; i < power.size(); ++i) {
        out.frequency.push_back(static_cast<double>(i + 1) / (static_cast<double>(length) * interval));
        // the line at half the sampling rate is there once, not twice
        const double half = i + 1 == power.size() ? 0.5 : 1;
        out.amplitude.push_back(half * scale * std::sqrt(power[i] / static_cast<double>(starts.size())));
    }
    return out;
}

Result<std::vector<ResponsePoint>> frequencyResponse(const Samples& input, const Samples& output) {
    constexpr size_t kAtLeast = 64;
    const size_t least = std::min(input.size(), output.size());
    const double interval = least < kAtLeast ? 0 : std::max(evenInterval(input), evenInterval(output));
    if (!(interval > 0)) return Error{errors::ResponseTooShort(static_cast<int64_t>(least)), ""};
    const double from = std::max(input.time.front(), output.time.front());
    const double to = std::min(input.time.back(), output.time.back());
    const auto count = to > from ? static_cast<size_t>((to - from) / interval + 0.5) + 1 : 0;
    if (count < kAtLeast) return Error{errors::ResponseTooShort(static_cast<int64_t>(count)), ""};
    const std::vector<double> u = heldAt(input, from, interval, count), y = heldAt(output, from, interval, count);
    // Some windows at least, or every coherence would be 1.
    const size_t length = windowLength(count / 4, 1 << 14);
    Transform ofInput(Window::Hann, length), ofOutput(Window::Hann, length);
    const double uMean = meanOf(u), yMean = meanOf(y);
    std::vector<double> uu(length / 2), yy(length / 2);
    std::vector<Complex> uy(length / 2);
    for (const size_t at : startsOf(count, length)) {
        const std::vector<Complex>&a = ofInput(u, at, uMean), &b = ofOutput(y, at, yMean);
        for (size_t i = 0; i < uu.size(); ++i) {
            uu[i] += std::norm(a[i + 1]);
            yy[i] += std::norm(b[i + 1]);
            uy[i] += std::conj(a[i + 1]) * b[i + 1];
        }
    }
    const double most = *std::max_element(uu.begin(), uu.end());
    if (!(most > 0)) return Error{errors::ResponseInputStill(), ""};
    std::vector<ResponsePoint> out;
    for (size_t i = 0; i < uu.size(); ++i) {
        if (uu[i] < most * 1e-8) continue; // less than rounding of single precision leaves
        const double coherence = yy[i] > 0 ? std::norm(uy[i]) / (uu[i] * yy[i]) : 0;
        out.push_back(
            {static_cast<double>(i + 1) / (static_cast<double>(length) * interval), uy[i] / uu[i], coherence});
    }
    return out;
}

} // namespace plc::waveform
