// Scan time of generated code beside the same kernels in C++ -O2, with the same guards and the same results.
#include "tests/bench/bench_image.h"
#include "tests/bench/bench_table.h"
#include "tests/bench/kernels.h"
#include "tests/support/paths.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace plc::bench {
namespace {

const char* const kKernels[] = {"integer", "real", "array", "matrix",   "blocks", "strings",
                                "machine", "pid",  "calls", "checksum", "timers"};

struct Loaded {
    std::string name;
    driver::Built built;
    std::unique_ptr<BenchImage> quick, optimised;
    std::unique_ptr<Kernel> kernel;
    Guards guards;
};

std::string readFile(const std::string& path) {
    std::ifstream in(path);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Three scans of each: the results must be the same bits.
void compareResults(Loaded& loaded) {
    for (int scan = 0; scan < 3; ++scan) {
        loaded.quick->scan(*loaded.built.program->quick);
        loaded.optimised->scan(*loaded.built.program->optimised.load());
        loaded.kernel->scan(loaded.guards);
        const double wanted = loaded.kernel->check(), quick = loaded.quick->number("Main.check"),
                     optimised = loaded.optimised->number("Main.check");
        if (quick == wanted && optimised == wanted) continue;
        std::fprintf(stderr, "%s: C++ gives %.9g, quick code %.9g, optimised code %.9g\n", loaded.name.c_str(), wanted,
                     quick, optimised);
        std::exit(1);
    }
}

std::unique_ptr<Loaded> loadKernel(const char* name) {
    auto loaded = std::make_unique<Loaded>();
    loaded->name = name;
    loaded->built =
        buildOrDie(std::string(name) + ".st", readFile(plc::sourceDir() + "/tests/bench/kernels/" + name + ".st"));
    if (const auto done = driver::optimise(loaded->built); !done) {
        std::fprintf(stderr, "%s\n", done.error().english().c_str());
        std::exit(1);
    }
    loaded->quick = std::make_unique<BenchImage>(*loaded->built.program);
    loaded->optimised = std::make_unique<BenchImage>(*loaded->built.program);
    loaded->kernel = makeKernel(name);
    compareResults(*loaded);
    return loaded;
}

} // namespace
} // namespace plc::bench

int main(int argc, char** argv) {
    using namespace plc::bench;
    registerBenchSymbols();
    const char* only = std::getenv("STEPWISE_KERNEL");
    std::vector<std::unique_ptr<Loaded>> all;
    for (const char* name : kKernels)
        if (!only || std::string(name) == only) all.push_back(loadKernel(name));
    for (const auto& each : all) {
        Loaded* loaded = each.get();
        const auto configure = [](benchmark::internal::Benchmark* b) { b->MinTime(0.05)->Repetitions(5); };
        configure(benchmark::RegisterBenchmark((loaded->name + ":cpp").c_str(), [loaded](benchmark::State& state) {
            for (auto _ : state) loaded->kernel->scan(loaded->guards);
        }));
        configure(
            benchmark::RegisterBenchmark((loaded->name + ":optimised").c_str(), [loaded](benchmark::State& state) {
                const auto* code = loaded->built.program->optimised.load();
                for (auto _ : state) loaded->optimised->scan(*code);
            }));
        configure(benchmark::RegisterBenchmark((loaded->name + ":quick").c_str(), [loaded](benchmark::State& state) {
            for (auto _ : state) loaded->quick->scan(*loaded->built.program->quick);
        }));
    }
    BestTimes times;
    if (!runBenchmarks(argc, argv, times)) return 2;
    std::printf("\n| kernel | C++ -O2 | optimised | ratio | quick | ratio |\n|---|---|---|---|---|---|\n");
    for (const auto& loaded : all) {
        const double cpp = times.best(loaded->name + ":cpp"), optimised = times.best(loaded->name + ":optimised"),
                     quick = times.best(loaded->name + ":quick");
        if (cpp == 0) continue;
        std::printf("| %s | %.1f µs | %.1f µs | %.2f | %.1f µs | %.1f |\n", loaded->name.c_str(), cpp / 1000,
                    optimised / 1000, optimised / cpp, quick / 1000, quick / cpp);
    }
    return 0;
}
