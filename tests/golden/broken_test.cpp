// Every golden (and every listing of the corpus, where there is one) cut at each token, with one token left out and
// with two swapped: checking it ends, with messages that lie inside the text; what still compiles also runs.
// STEPWISE_LONG=1 takes every token, otherwise a part of them.
#include "tests/golden/broken_test.h"
#include "tests/support/paths.h"
#include "tests/support/processor_time.h"

#include "runtime/compiler/driver/driver.h"
#include "runtime/compiler/lex/token.h"
#include "runtime/controller/controller.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

namespace plc::golden {
namespace {

constexpr double kMostSeconds = 20; // generous: sanitizers

void checkBroken(const std::string& text, bool runs) {
    driver::BuildInput input;
    input.files.push_back({"broken.st", text});
    const double begin = processorSeconds();
    const driver::Checked checked = driver::check(input);
    EXPECT_LT(processorSeconds() - begin, kMostSeconds) << text;
    for (const auto& diagnostic : checked.analysis->diagnostics) {
        if (!diagnostic.range.file.isValid()) continue; // about the program as a whole
        ASSERT_LE(diagnostic.range.end, (*checked.sources)[diagnostic.range.file].text().size())
            << diagnostic.message.english() << "\n"
            << text;
        ASSERT_LE(diagnostic.range.begin, diagnostic.range.end) << diagnostic.message.english() << "\n" << text;
        ASSERT_FALSE(diagnostics::renderText(*checked.sources, diagnostic, false).empty());
    }
    if (!runs || checked.analysis->hasErrors) return;
    const driver::Built built = driver::build(input);
    EXPECT_EQ(built.failure.english(), "") << text;
    if (!built.program) return;
    controller::Settings settings;
    settings.loopBudgetPerScan = 100'000;
    controller::Controller controller(built.program, settings);
    controller.start();
    for (int i = 0; i < 3 && !controller.fault(); ++i) controller.scan();
}

/// Cut, left out, swapped at every `step`th token from `first` on.
void breakEverywhere(const std::string& text, size_t first, size_t step) {
    diagnostics::Sink sink;
    const auto list = lex::tokenize(FileId(size_t(0)), text, sink);
    for (size_t i = first; i + 1 < list.tokens.size(); i += step) {
        const auto &a = list.tokens[i], &b = list.tokens[i + 1];
        checkBroken(text.substr(0, a.begin), false);
        checkBroken(text.substr(0, a.begin) + text.substr(a.end), i % 16 == 0);
        checkBroken(text.substr(0, a.begin) + text.substr(b.begin, b.end - b.begin) +
                        text.substr(a.end, b.begin - a.end) + text.substr(a.begin, a.end - a.begin) +
                        text.substr(b.end),
                    i % 16 == 8);
        if (testing::Test::HasFatalFailure()) return;
    }
}

class BrokenTest : public testing::Test {
public:
    BrokenTest(std::vector<fs::path> files, size_t share) : m_files(std::move(files)), m_share(share) {}
    void TestBody() override {
        const char* everything = std::getenv("STEPWISE_LONG");
        const size_t step = everything && *everything == '1' ? 1 : m_share;
        size_t turn = 0;
        for (const fs::path& file : m_files) {
            SCOPED_TRACE(file.string());
            std::ifstream in(file, std::ios::binary);
            std::stringstream text;
            text << in.rdbuf();
            breakEverywhere(text.str(), turn++ % step, step);
            if (HasFailure()) return;
        }
    }

private:
    std::vector<fs::path> m_files;
    size_t m_share;
};

std::vector<fs::path> sourcesBelow(const fs::path& folder) {
    std::vector<fs::path> out;
    std::error_code none;
    for (const auto& entry : fs::recursive_directory_iterator(folder, none))
        if (entry.path().extension() == ".st") out.push_back(entry.path());
    std::ranges::sort(out);
    return out;
}

void add(const char* name, std::vector<fs::path> files, size_t share) {
    testing::RegisterTest(
        "Broken", name, nullptr, nullptr, __FILE__, __LINE__,
        [files = std::move(files), share]() -> testing::Test* { return new BrokenTest(files, share); });
}

} // namespace

void registerBroken() {
    add("Goldens", sourcesBelow(fs::path(plc::sourceDir()) / "tests" / "golden"), 41);
    const char* corpus = std::getenv("STEPWISE_CORPUS");
    if (corpus && fs::exists(corpus)) add("Corpus", sourcesBelow(corpus), 97);
}

} // namespace plc::golden
