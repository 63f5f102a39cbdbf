// From a keystroke to its diagnostics, without the pause in typing: one letter changes in a project of many lines, in
// one file and in files of 1,000 lines; what the editor's worker then does, and its parts. bench_check [LINES…]
#include "projects/analysis/code_model.h"
#include "tests/bench/program_generator.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>

namespace {
using namespace plc;

/// Of the processor, so that what else runs on the machine does not count.
double milliseconds(const std::function<void()>& work) {
    timespec begin{}, end{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &begin);
    work();
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &end);
    return static_cast<double>(end.tv_sec - begin.tv_sec) * 1e3 +
           static_cast<double>(end.tv_nsec - begin.tv_nsec) * 1e-6;
}

/// One digit of a station's limit, another each time.
void typeOneLetter(std::string& text, int step) {
    const size_t at = text.rfind("level > 2000");
    if (at != std::string::npos) text[at + 11] = static_cast<char>('0' + step % 10);
}

double median(std::vector<double> all) {
    std::sort(all.begin(), all.end());
    return all[all.size() / 2];
}
} // namespace

int main(int argc, char** argv) {
    std::vector<size_t> sizes{10'000, 100'000};
    if (argc > 1) {
        sizes.clear();
        for (int i = 1; i < argc; ++i) sizes.push_back(static_cast<size_t>(std::atol(argv[i])));
    }
    std::printf("| lines | first check | keystroke to diagnostics, median of 20 | slowest | of it reading | checking "
                "|\n|---|---|---|---|---|---|\n");
    for (const size_t size : sizes) {
        driver::BuildInput input;
        input.libraries = {"toolbox", "util"};
        input.files.push_back({"src/plant.st", bench::generateProgram(size)});
        const auto lines = std::count(input.files[0].text.begin(), input.files[0].text.end(), '\n');
        driver::KeptFiles kept;
        std::shared_ptr<const analysis::CodeModel> model;
        const double first = milliseconds([&] { model = analysis::CodeModel::make(input, 0, kept); });
        if (model->checked().analysis->hasErrors) return 1;
        std::vector<double> times, reading, checking;
        for (int step = 0; step < 20; ++step) {
            typeOneLetter(input.files[0].text, step);
            times.push_back(milliseconds([&] { model = analysis::CodeModel::make(input, 0, kept); }));
        }
        for (int step = 0; step < 20; ++step) {
            typeOneLetter(input.files[0].text, step);
            reading.push_back(milliseconds([&] { (void)kept.read(input); }));
            checking.push_back(milliseconds([&] { (void)driver::check(input, kept); }));
        }
        std::printf("| %ld | %.1f ms | %.1f ms | %.1f ms | %.1f ms | %.1f ms |\n", static_cast<long>(lines), first,
                    median(times), *std::max_element(times.begin(), times.end()), median(reading), median(checking));
    }
    return 0;
}
