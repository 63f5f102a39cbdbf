// Build time against program size: text → checked → quick code → first scan, and the optimised code that follows.
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"
#include "tests/bench/bench_image.h"
#include "tests/bench/bench_table.h"
#include "tests/bench/program_generator.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace {
double secondsSince(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// One station of the text gets another constant: edit → checked → quick code → in the running controller.
double editTime(const plc::driver::Built& built, std::string text) {
    plc::jit::setRuntimeSymbols(plc::controller::runtimeSymbols());
    plc::controller::Controller controller(built.program);
    controller.start();
    for (int i = 0; i < 10; ++i) controller.scan();
    const size_t at = text.rfind("level > 20000");
    if (at != std::string::npos) text.replace(at, 13, "level > 20001");
    const auto begin = std::chrono::steady_clock::now();
    const plc::driver::Built edited = plc::bench::buildOrDie("plant.st", text);
    controller.changeProgram(edited.program);
    controller.scan();
    const double time = secondsSince(begin);
    plc::bench::registerBenchSymbols();
    return time;
}
} // namespace

int main(int argc, char** argv) {
    using namespace plc;
    using namespace plc::bench;
    registerBenchSymbols();
    std::vector<size_t> sizes{1'000, 10'000, 100'000};
    if (argc > 1) {
        sizes.clear();
        for (int i = 1; i < argc; ++i) sizes.push_back(static_cast<size_t>(std::atol(argv[i])));
    }
    (void)buildOrDie("warm.st", generateProgram(100)); // the first use of the code generator pays for its tables
    std::printf("| lines | check | quick code | text to first scan | edit to running | optimised | scan, quick | scan, "
                "optimised |\n|---|---|---|---|---|---|---|---|\n");
    for (const size_t size : sizes) {
        const std::string text = generateProgram(size);
        const auto lines = static_cast<long>(std::count(text.begin(), text.end(), '\n'));
        const auto begin = std::chrono::steady_clock::now();
        driver::Built built = buildOrDie("plant.st", text);
        BenchImage image(*built.program);
        image.scan(*built.program->quick);
        const double first = secondsSince(begin);
        if (std::getenv("STEPWISE_BENCH_QUICK")) { // for a profile of the quick code alone
            std::printf("| %ld | %.0f ms | %.0f ms | %.2f s |\n", lines, built.checkMs, built.codeMs, first);
            continue;
        }
        const auto optimising = std::chrono::steady_clock::now();
        if (const auto done = driver::optimise(built); !done) {
            std::fprintf(stderr, "%s\n", done.error().english().c_str());
            return 1;
        }
        const double optimise = secondsSince(optimising);
        const double edit = editTime(built, text);
        const auto scanTime = [&](const image::Code& code) {
            double best = 1e9;
            for (int i = 0; i < 200; ++i) {
                const auto from = std::chrono::steady_clock::now();
                image.scan(code);
                best = std::min(best, secondsSince(from));
            }
            return best * 1e6;
        };
        const double quick = scanTime(*built.program->quick), optimised = scanTime(*built.program->optimised.load());
        std::printf("| %ld | %.0f ms | %.0f ms | %.2f s | %.2f s | %.2f s | %.1f µs | %.1f µs |\n", lines,
                    built.checkMs, built.codeMs, first, edit, optimise, quick, optimised);
        std::fflush(stdout);
    }
    return 0;
}
