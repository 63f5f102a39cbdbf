#include "editor/trace/curves/trace_figure.h"

#include "editor/kit/message_text.h"
#include "editor/plot/model/plot_scale.h"
#include "editor/trace/setup/trigger.h"
#include "projects/waveform/runs.h"
#include "projects/waveform/spectrum.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace plc::trace {

namespace {

using waveform::Chart;
using waveform::Curve;

struct FigureText {
    Q_DECLARE_TR_FUNCTIONS(FigureText)
};

std::string named(const FigureChannel& channel) {
    return channel.unit.empty() ? channel.name : channel.name + " [" + channel.unit + "]";
}

Curve curveFor(const FigureChannel& channel, size_t index) {
    Curve out;
    out.name = named(channel);
    out.colour = static_cast<int>(index);
    out.ownColour = channel.colour;
    return out;
}

FigureChannel channelOf(const plot::PlotCurve& curve, int64_t from, int64_t to) {
    FigureChannel out{curve.name.toStdString(), curve.unit.toStdString(), curve.color.name().toStdString(), {}};
    const auto take = [&](const SignalSample& sample) {
        out.samples.time.push_back(static_cast<double>(sample.time) * 1e-9);
        out.samples.value.push_back(curve.shown(sample.value));
    };
    if (from != INT64_MIN)
        if (const auto before = curve.source->inForceAt(from); before && before->time < from)
            take({from, before->value}); // what holds when the stretch starts
    curve.source->visit(from, to == INT64_MAX ? to : to + 1, [&](std::span<const SignalSample> block) {
        for (const SignalSample& sample : block) take(sample);
    });
    return out;
}

/// Where the trigger fired, over everything that is there.
std::vector<double> startsOf(const TriggerSetup& trigger, const plot::SampleSource& source) {
    std::vector<double> out;
    std::optional<bool> before;
    const auto fires = [&](bool was, bool is) {
        switch (trigger.edge) {
        case TriggerEdge::Rising:
        case TriggerEdge::Level:
            return !was && is;
        case TriggerEdge::Falling:
            return was && !is;
        case TriggerEdge::Both:
            return was != is;
        }
        return false;
    };
    source.visit(INT64_MIN, INT64_MAX, [&](std::span<const SignalSample> block) {
        for (const SignalSample& sample : block) {
            if (std::isnan(sample.value)) {
                before.reset();
                continue;
            }
            const bool now = sample.value != 0;
            if (before && fires(*before, now)) out.push_back(static_cast<double>(sample.time) * 1e-9);
            before = now;
        }
    });
    return out;
}

FigureAnswer emptyAnswer(const QString& what) { return {{{}, what}, what}; }

/// The value of `of` in force at each sample of `at`.
std::vector<double> valuesAt(const waveform::Samples& of, const std::vector<double>& at) {
    std::vector<double> out;
    out.reserve(at.size());
    size_t next = 0;
    double held = std::nan("");
    for (const double time : at) {
        for (; next < of.size() && of.time[next] <= time + 1e-12; ++next) held = of.value[next];
        out.push_back(held);
    }
    return out;
}

FigureAnswer xyOf(const FigureJob& job) {
    if (job.channels.size() < 2)
        return emptyAnswer(
            FigureText::tr("An XY plot draws one channel against another: add a second channel to the trace."));
    const FigureChannel& x = job.channels.front();
    Chart chart;
    chart.title = FigureText::tr("XY plot").toStdString();
    chart.xTitle = named(x);
    for (size_t i = 1; i < job.channels.size(); ++i) {
        Curve curve = curveFor(job.channels[i], i);
        curve.x = x.samples.value;
        curve.y = valuesAt(job.channels[i].samples, x.samples.time);
        chart.curves.push_back(std::move(curve));
    }
    return {
        {{std::move(chart)}, FigureText::tr("There are no samples in view: run the program or show another section.")},
        FigureText::tr("%L1 points over %2").arg(x.samples.size()).arg(QString::fromStdString(named(x)))};
}

FigureAnswer spectrumAnswer(const FigureJob& job) {
    if (job.channels.empty())
        return emptyAnswer(FigureText::tr("A spectrum shows the frequencies of the visible channels: add a channel."));
    Chart chart;
    chart.title = FigureText::tr("Spectrum").toStdString();
    chart.xTitle = FigureText::tr("Frequency [Hz]").toStdString();
    chart.yTitle = FigureText::tr("amplitude").toStdString();
    chart.isLogarithmic = chart.isLogarithmicY = job.setup.isLogarithmic;
    QStringList lines;
    for (size_t i = 0; i < job.channels.size(); ++i) {
        const FigureChannel& channel = job.channels[i];
        const QString name = QString::fromStdString(named(channel));
        const auto spectrum =
            waveform::spectrumOf(channel.samples, {static_cast<waveform::Window>(job.setup.window), size_t(1) << 16});
        if (!spectrum) {
            lines << QStringLiteral("%1: %2").arg(name, kit::messageText(spectrum.error().message));
            continue;
        }
        QStringList peaks;
        for (const waveform::Peak& peak : spectrum->peaks(3)) {
            const QString frequency = plot::valueText(peak.frequency, 4) + QStringLiteral(" Hz");
            peaks << QStringLiteral("%1 (%2)").arg(frequency, plot::valueText(peak.amplitude, 3));
            chart.notes.push_back({peak.frequency, peak.amplitude, frequency.toStdString()});
        }
        lines << (peaks.isEmpty()
                      ? FigureText::tr("%1: no peak, RMS %2").arg(name, plot::valueText(spectrum->rms, 3))
                      : FigureText::tr("%1: %2, RMS %3")
                            .arg(name, peaks.join(QStringLiteral(", ")), plot::valueText(spectrum->rms, 3)));
        Curve curve = curveFor(channel, i);
        curve.x = spectrum->frequency;
        curve.y = spectrum->amplitude;
        chart.curves.push_back(std::move(curve));
    }
    if (chart.curves.empty()) return emptyAnswer(lines.join(QLatin1Char('\n')));
    return {{{std::move(chart)}, {}}, lines.join(QLatin1Char('\n'))};
}

FigureAnswer responseAnswer(const FigureJob& job) {
    if (job.channels.size() < 2)
        return emptyAnswer(
            FigureText::tr("A frequency response compares an output with an input: add both as channels, "
                           "and choose the input."));
    Chart gain, phase, coherence;
    gain.title = FigureText::tr("Frequency response").toStdString();
    gain.yTitle = FigureText::tr("gain [dB]").toStdString();
    phase.yTitle = FigureText::tr("phase [°]").toStdString();
    coherence.yTitle = FigureText::tr("coherence").toStdString();
    gain.leastSpan = 6;
    phase.leastSpan = 20;
    coherence.leastSpan = 1;
    for (Chart* chart : {&gain, &phase, &coherence}) {
        chart->xTitle = FigureText::tr("Frequency [Hz]").toStdString();
        chart->isLogarithmic = true;
    }
    QStringList lines;
    for (size_t i = 1; i < job.channels.size(); ++i) {
        const FigureChannel& channel = job.channels[i];
        const auto points = waveform::frequencyResponse(job.channels.front().samples, channel.samples);
        const QString name = QString::fromStdString(named(channel));
        if (!points) {
            lines << QStringLiteral("%1: %2").arg(name, kit::messageText(points.error().message));
            continue;
        }
        Curve g = curveFor(channel, i), p = g, c = g;
        p.name.clear();
        c.name.clear();
        size_t trusted = 0;
        double turns = 0, last = 0;
        for (const waveform::ResponsePoint& point : *points) {
            double degrees = std::arg(point.gain) * 180 / std::numbers::pi;
            // the phase goes on where it would jump by a turn
            if (!p.y.empty() && degrees + turns - last > 180) turns -= 360;
            if (!p.y.empty() && degrees + turns - last < -180) turns += 360;
            degrees += turns;
            last = degrees;
            g.x.push_back(point.frequency);
            g.y.push_back(20 * std::log10(std::max(std::abs(point.gain), 1e-12)));
            p.x.push_back(point.frequency);
            p.y.push_back(degrees);
            c.x.push_back(point.frequency);
            c.y.push_back(point.coherence);
            trusted += point.coherence > 0.8 ? 1 : 0;
        }
        lines << FigureText::tr("%1: %L2 of %L3 frequencies with a coherence above 0.8")
                     .arg(name)
                     .arg(trusted)
                     .arg(points->size());
        gain.curves.push_back(std::move(g));
        phase.curves.push_back(std::move(p));
        coherence.curves.push_back(std::move(c));
    }
    if (gain.curves.empty()) return emptyAnswer(lines.join(QLatin1Char('\n')));
    return {{{std::move(gain), std::move(phase), std::move(coherence)}, {}}, lines.join(QLatin1Char('\n'))};
}

FigureAnswer runsAnswer(const FigureJob& job) {
    if (!job.hasTrigger)
        return emptyAnswer(
            FigureText::tr("Runs are overlaid at their triggers: enter a trigger in the properties of the trace."));
    if (job.starts.empty()) return emptyAnswer(FigureText::tr("The trigger has not fired in this recording yet."));
    if (job.channels.empty())
        return emptyAnswer(FigureText::tr("The runs of the visible channels are overlaid: add a channel."));
    FigureAnswer out;
    QStringList lines{FigureText::tr("%n run(s)", nullptr, static_cast<int>(job.starts.size()))};
    constexpr size_t kBandPoints = 400;
    for (const FigureChannel& channel : job.channels) {
        const std::vector<waveform::Run> runs =
            waveform::alignedRuns(channel.samples, job.starts, job.before, job.after);
        Chart chart;
        chart.title = named(channel);
        chart.xTitle = FigureText::tr("Time since the trigger [s]").toStdString();
        for (size_t i = 0; i < runs.size(); ++i) {
            Curve curve;
            curve.name = FigureText::tr("%1 at %2")
                             .arg(i + 1)
                             .arg(plot::momentText(std::llround(runs[i].start * 1e9)))
                             .toStdString();
            curve.colour = static_cast<int>(i);
            // values hold until the next sample: a stair, as the charts over time draw it
            for (size_t s = 0; s < runs[i].samples.size(); ++s) {
                if (s > 0) {
                    curve.x.push_back(runs[i].samples.time[s]);
                    curve.y.push_back(runs[i].samples.value[s - 1]);
                }
                curve.x.push_back(runs[i].samples.time[s]);
                curve.y.push_back(runs[i].samples.value[s]);
            }
            chart.curves.push_back(std::move(curve));
        }
        const waveform::RunBand band = waveform::bandOf(runs, kBandPoints);
        if (!band.time.empty() && runs.size() > 1)
            lines << FigureText::tr("%1: runs differ most %2 after the trigger, by %3")
                         .arg(QString::fromStdString(channel.name),
                              plot::durationText(std::llround(band.widestAt * 1e9)), plot::valueText(band.widest, 4));
        out.figure.charts.push_back(std::move(chart));
    }
    out.text = lines.join(QLatin1Char('\n'));
    return out;
}

} // namespace

size_t FigureJob::samples() const {
    size_t out = 0;
    for (const FigureChannel& channel : channels) out += channel.samples.size();
    return out;
}

FigureJob figureJob(const TraceSetup& setup, const plot::PlotModel& model, const TraceFeed* feed) {
    FigureJob job;
    job.setup = setup.figure;
    if (job.setup.kind == FigureKind::None) return job;
    int64_t from = model.from, to = model.to;
    if (model.cursorA && model.cursorB) std::tie(from, to) = std::minmax(*model.cursorA, *model.cursorB);
    if (job.setup.kind == FigureKind::Runs) {
        from = INT64_MIN;
        to = INT64_MAX;
        job.before = static_cast<double>(setup.trigger.before) * 1e-9;
        job.after = static_cast<double>(setup.trigger.after) * 1e-9;
        const auto source = feed ? feed->triggerSource() : nullptr;
        job.hasTrigger = source != nullptr;
        if (source) job.starts = startsOf(setup.trigger, *source);
    }
    std::optional<size_t> first;
    for (size_t i = 0; i < model.curves.size() && i < setup.channels.size(); ++i)
        if (model.curves[i].source && !setup.figure.x.empty() && setup.channels[i].expression == setup.figure.x)
            first = i;
    const auto take = [&](size_t i) { job.channels.push_back(channelOf(model.curves[i], from, to)); };
    if (first) take(*first);
    for (size_t i = 0; i < model.curves.size(); ++i)
        if (model.curves[i].source && model.curves[i].isVisible && i != first) take(i);
    return job;
}

std::string firstMoving(const TraceSetup& setup, const plot::PlotModel& model) {
    for (size_t i = 0; i < model.curves.size() && i < setup.channels.size(); ++i) {
        if (!model.curves[i].source || !model.curves[i].isVisible) continue;
        const std::vector<double> values = channelOf(model.curves[i], model.from, model.to).samples.value;
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        if (!values.empty() && *low < *high) return i == 0 ? std::string() : setup.channels[i].expression;
    }
    return {};
}

FigureAnswer figureOf(const FigureJob& job) {
    switch (job.setup.kind) {
    case FigureKind::None:
        return {};
    case FigureKind::Xy:
        return xyOf(job);
    case FigureKind::Spectrum:
        return spectrumAnswer(job);
    case FigureKind::Response:
        return responseAnswer(job);
    case FigureKind::Runs:
        return runsAnswer(job);
    }
    return {};
}

QString titleOf(FigureKind kind) {
    switch (kind) {
    case FigureKind::None:
        return FigureText::tr("Charts over Time Only");
    case FigureKind::Xy:
        return FigureText::tr("XY Plot");
    case FigureKind::Spectrum:
        return FigureText::tr("Spectrum");
    case FigureKind::Response:
        return FigureText::tr("Frequency Response (Bode)");
    case FigureKind::Runs:
        return FigureText::tr("Runs over Each Other");
    }
    return {};
}

} // namespace plc::trace
