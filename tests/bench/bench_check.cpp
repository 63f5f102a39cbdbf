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
void typeOneLetter(driver::BuildInput& input, int step) {
    std::string& text = input.files[input.files.size() / 2].text;
    const size_t at = text.rfind("level > 2000");
    if (at != std::string::npos) text[at + 11] = static_cast<char>('0' + step % 10);
}

/// A letter more, so that everything below it moves.
void insertOneLetter(driver::BuildInput& input) {
    std::string& text = input.files[input.files.size() / 2].text;
    const size_t at = text.find("level > 2000");
    if (at != std::string::npos) text.insert(at, " ");
}

/// Files of about `lines` lines; a file ends where a unit does.
std::vector<driver::SourceFile> inFiles(const std::string& text, size_t lines) {
    std::vector<driver::SourceFile> files;
    size_t begin = 0, count = 0;
    for (size_t at = 0; at < text.size();) {
        const size_t end = std::min(text.find('\n', at), text.size() - 1) + 1;
        const std::string_view line = std::string_view(text).substr(at, end - at);
        ++count;
        at = end;
        const bool endsUnit = line.starts_with("END_FUNCTION") || line.starts_with("END_PROGRAM");
        if (at < text.size() && (count < lines || !endsUnit)) continue;
        files.push_back({"src/plant" + std::to_string(files.size()) + ".st", text.substr(begin, at - begin)});
        begin = at;
        count = 0;
    }
    return files;
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
    std::printf(
        "| lines | files | first check | keystroke to diagnostics, median of 20 | slowest | below it all moves | "
        "of it reading | checking | bodies checked |\n|---|---|---|---|---|---|---|---|---|\n");
    for (const size_t size : sizes) {
        const std::string text = bench::generateProgram(size);
        const auto lines = std::count(text.begin(), text.end(), '\n');
        for (const size_t perFile : {size * 2, size_t(1000)}) {
            driver::BuildInput input;
            input.libraries = {"toolbox", "util"};
            input.files = inFiles(text, perFile);
            driver::KeptFiles kept;
            std::shared_ptr<const analysis::CodeModel> model;
            const auto make = [&] { model = analysis::CodeModel::make(input, 0, kept); };
            const double first = milliseconds(make);
            if (model->checked().analysis->hasErrors) return 1;
            std::vector<double> times, moving, reading, checking;
            for (int step = 0; step < 20; ++step) {
                typeOneLetter(input, step);
                times.push_back(milliseconds(make));
            }
            const size_t bodies = kept.checkedLast();
            for (int step = 0; step < 20; ++step) {
                insertOneLetter(input);
                moving.push_back(milliseconds(make));
            }
            for (int step = 0; step < 20; ++step) {
                typeOneLetter(input, step);
                reading.push_back(milliseconds([&] { (void)kept.read(input); }));
                checking.push_back(milliseconds([&] { (void)driver::check(input, kept); }));
            }
            std::printf("| %ld | %zu | %.1f ms | %.1f ms | %.1f ms | %.1f ms | %.1f ms | %.1f ms | %zu |\n",
                        static_cast<long>(lines), input.files.size(), first, median(times),
                        *std::max_element(times.begin(), times.end()), median(moving), median(reading),
                        median(checking), bodies);
        }
    }
    return 0;
}
