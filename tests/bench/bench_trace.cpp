// Charts of 8 channels with 10 million samples each: memory, first picture, and a frame of pan and zoom at 1920 × 1080.
// The figure to reach is 16 ms a frame. Runs without a display. STEPWISE_TRACE_SAMPLES changes the number of samples.
#include "editor/kit/theme.h"
#include "editor/plot/painting/plot_renderer.h"
#include "editor/trace/curves/trace_feed.h"
#include "editor/trace/curves/trace_plot.h"
#include "tests/bench/bench_table.h"

#include <QApplication>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace plc;

namespace {

constexpr int64_t Ms = 1'000'000;
constexpr int Channels = 8;

int64_t sampleCount() {
    const char* wanted = std::getenv("STEPWISE_TRACE_SAMPLES");
    return wanted ? std::atoll(wanted) : 10'000'000;
}

struct Data {
    std::shared_ptr<history::ColumnStore> store = std::make_shared<history::ColumnStore>(size_t(4) << 30);
    plot::PlotModel model;

    Data() {
        const int64_t count = sampleCount();
        model.charts.resize(2);
        for (int c = 0; c < Channels; ++c) {
            const bool isBool = c == 7;
            const history::ColumnId id = store->add(isBool ? history::ColumnKind::Bit : history::ColumnKind::Float);
            history::Column& column = store->column(id);
            uint64_t noise = 88172645463325252ull + static_cast<uint64_t>(c);
            for (int64_t i = 0; i < count; ++i) {
                noise ^= noise << 13, noise ^= noise >> 7, noise ^= noise << 17;
                const double t = static_cast<double>(i) * 1e-3, grain = static_cast<double>(noise % 1000) * 1e-3;
                column.append(i * Ms, isBool ? (i / 700) % 2
                                             : std::sin(t * (0.01 + 0.05 * c)) * 10 + std::sin(t * 40) + grain + c);
            }
            plot::PlotCurve curve;
            curve.id = curve.name = QStringLiteral("Main.channel%1").arg(c + 1);
            curve.color = kit::lightColors().curve(c);
            curve.style = isBool ? plot::CurveStyle::Digital : c % 2 ? plot::CurveStyle::Hold : plot::CurveStyle::Line;
            curve.chart = c < 4 ? 0 : 1;
            curve.source = std::make_shared<trace::ColumnSource>(
                store, id, isBool ? plot::PlotValueKind::Bool : plot::PlotValueKind::Single);
            model.curves.push_back(std::move(curve));
        }
        model.from = 0;
        model.to = count * Ms;
    }
};

Data& data() {
    static Data all;
    return all;
}

constexpr QSize Screen(1920, 1080);

void frame(plot::PlotRenderer& renderer, QImage& image) {
    QPainter painter(&image);
    renderer.paint(painter, data().model, QRectF(QPointF(), QSizeF(Screen)));
}

void setCounters(benchmark::State& state) {
    state.counters["samples"] = static_cast<double>(sampleCount() * Channels);
    state.counters["MB"] = static_cast<double>(data().store->bytes()) / 1048576.0;
}

void firstPicture(benchmark::State& state) {
    data().model.from = 0;
    data().model.to = sampleCount() * Ms;
    for (auto _ : state) {
        plot::PlotRenderer renderer;
        renderer.setFont(QApplication::font());
        QImage image(Screen, QImage::Format_ARGB32_Premultiplied);
        frame(renderer, image);
    }
    setCounters(state);
}

/// `part`: how much of the recording is in view, in millionths.
void pan(benchmark::State& state, int64_t part) {
    plot::PlotRenderer renderer;
    renderer.setFont(QApplication::font());
    QImage image(Screen, QImage::Format_ARGB32_Premultiplied);
    const int64_t whole = sampleCount() * Ms, span = std::max<int64_t>(whole / 1'000'000 * part, 1000);
    int64_t at = 0;
    data().model.to = span;
    data().model.from = 0;
    frame(renderer, image);
    for (auto _ : state) {
        at = (at + span / 40) % std::max<int64_t>(1, whole - span + 1);
        data().model.from = at;
        data().model.to = at + span;
        frame(renderer, image);
    }
    setCounters(state);
}

void zoom(benchmark::State& state) {
    plot::PlotRenderer renderer;
    renderer.setFont(QApplication::font());
    QImage image(Screen, QImage::Format_ARGB32_Premultiplied);
    const int64_t whole = sampleCount() * Ms;
    double span = static_cast<double>(whole);
    for (auto _ : state) {
        span *= 0.8;
        if (span < 50.0 * Ms) span = static_cast<double>(whole);
        data().model.from = static_cast<int64_t>((static_cast<double>(whole) - span) * 0.37);
        data().model.to = data().model.from + static_cast<int64_t>(span);
        frame(renderer, image);
    }
    setCounters(state);
}

/// What of a frame is reading the columns.
void buckets(benchmark::State& state) {
    std::vector<SignalBucket> out(1800);
    const int64_t whole = sampleCount() * Ms;
    int64_t at = 0;
    for (auto _ : state) {
        at = (at + whole / 1000) % (whole / 10);
        for (const plot::PlotCurve& curve : data().model.curves) curve.source->buckets(at, at + whole * 9 / 10, out);
        benchmark::DoNotOptimize(out.data());
    }
    setCounters(state);
}

BENCHMARK(buckets)->Unit(benchmark::kMillisecond);
BENCHMARK(firstPicture)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pan, most, 900'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pan, tenth, 100'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pan, hundredth, 10'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pan, thousand_samples, 100)->Unit(benchmark::kMillisecond);
BENCHMARK(zoom)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    data(); // filled before the clock runs
    bench::BestTimes times;
    if (!bench::runBenchmarks(argc, argv, times)) return 1;
    std::printf(
        "\n%d channels of %lld samples, %.0f MB; a frame of 1920 x 1080 beside the 16 ms of 60 frames a second:\n",
        Channels, static_cast<long long>(sampleCount()), static_cast<double>(data().store->bytes()) / 1048576.0);
    for (const char* name :
         {"buckets", "firstPicture", "pan/most", "pan/tenth", "pan/hundredth", "pan/thousand_samples", "zoom"})
        if (const double best = times.best(name); best > 0)
            std::printf("  %-22s %7.2f ms  %5.2f of a frame\n", name, best / 1e6, best / 16e6);
    return 0;
}
