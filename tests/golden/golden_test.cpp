// Every `.st` file below tests/golden with its `.expected` or `.diagnostics` is one test (see golden_script.h).
#include "tests/golden/agreement_test.h"
#include "tests/golden/broken_test.h"
#include "tests/golden/corpus_test.h"
#include "tests/golden/golden_script.h"
#include "tests/golden/random_test.h"
#include "tests/support/paths.h"

#include "runtime/compiler/driver/driver.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/controller/controller.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;
using namespace plc;
using namespace plc::golden;

namespace {

bool updates = false;

std::string readText(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

void writeText(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

fs::path withExtension(fs::path path, const char* extension) { return path.replace_extension(extension); }

driver::BuildInput inputFor(const fs::path& source, const std::vector<Line>& script) {
    driver::BuildInput input;
    input.files.push_back({source.filename().string(), readText(source)});
    for (const Line& line : script) {
        if (line.kind == LineKind::With) input.files.push_back({line.left, readText(source.parent_path() / line.left)});
        if (line.kind == LineKind::Library) input.libraries.push_back(line.left);
        if (line.kind == LineKind::Setting) driver::setRecordedSettings(input, {line.left});
    }
    return input;
}

std::string shown(const SourceSet& sources, const diagnostics::Diagnostic& diagnostic) {
    if (!diagnostic.range.file.isValid())
        return std::string(diagnostics::codeOf(diagnostic.kind)) + ": " + diagnostic.message.english();
    const auto& file = sources[diagnostic.range.file];
    const auto begin = file.lineColumn(diagnostic.range.begin), end = file.lineColumn(diagnostic.range.end);
    const std::string place = diagnostic.range.file.index() == 0 ? "" : file.path() + ":";
    return place + std::to_string(begin.line) + ":" + std::to_string(begin.column) + "-" +
           (end.line == begin.line ? "" : std::to_string(end.line) + ":") + std::to_string(end.column) + " " +
           std::string(diagnostics::codeOf(diagnostic.kind)) + ": " + diagnostic.message.english();
}

/// One run of a script on one tier. Lines of `script` are rewritten to what came out.
class Run {
public:
    Run(const driver::Built& built, const char* tier) : m_built(built), m_tier(tier), m_controller(built.program) {
        m_controller.start();
    }

    void perform(std::vector<Line>& script) {
        for (Line& line : script) perform(line);
    }

private:
    void perform(Line& line) {
        switch (line.kind) {
        case LineKind::Comment:
        case LineKind::Library:
        case LineKind::Setting:
        case LineKind::With:
            return;
        case LineKind::Scans:
            for (int i = std::stoi(line.left); i > 0 && !m_controller.fault(); --i) m_controller.scan();
            return;
        case LineKind::Write:
        case LineKind::Force:
            return write(line);
        case LineKind::Release:
            return expectDone(line, m_controller.release(line.left));
        case LineKind::Reset:
            m_controller.reset(line.left == "warm"   ? controller::ResetKind::Warm
                               : line.left == "cold" ? controller::ResetKind::Cold
                                                     : controller::ResetKind::Origin);
            m_controller.start();
            return;
        case LineKind::Expect:
            return expect(line);
        case LineKind::Fault:
            return expectFault(line);
        case LineKind::Unknown:
            ADD_FAILURE() << m_tier << ": not understood: " << line.text;
        }
    }

    void expectDone(const Line& line, const Result<void>& result) {
        if (!result) ADD_FAILURE() << m_tier << ": " << line.text << ": " << result.error().english();
    }

    void write(const Line& line) {
        const auto place = m_built.program->layout.find(line.left);
        if (!place) {
            ADD_FAILURE() << m_tier << ": " << place.error().english();
            return;
        }
        const auto value = types::parseValue(*m_built.program->layout.types, place->type, line.right);
        if (!value) {
            ADD_FAILURE() << m_tier << ": " << line.right << " is no value of " << line.left;
            return;
        }
        expectDone(line, line.kind == LineKind::Force ? m_controller.force(line.left, *value)
                                                      : m_controller.write(line.left, *value));
    }

    void expect(Line& line) {
        const auto expression = driver::compileExpression(m_built.checked, line.left);
        if (!expression) {
            ADD_FAILURE() << m_tier << ": " << line.left << ": " << expression.error().message.english();
            return;
        }
        const expression::Outcome outcome = expression->evaluate(m_controller.image());
        settle(line,
               outcome.hasValue() ? types::toText(expression->types(), outcome.value)
                                  : "(" + outcome.reason.english() + ")",
               line.left + " = ", line.right);
    }

    void expectFault(Line& line) {
        const auto& fault = m_controller.fault();
        std::string actual = "none";
        if (fault) {
            const auto& file = m_built.program->sources[fault->range.file];
            actual = std::string(controller::name(fault->code)) + " at " +
                     std::to_string(file.lineColumn(fault->range.begin).line);
        }
        settle(line, actual, "fault ", line.left + (line.right.empty() ? "" : " at " + line.right));
    }

    void settle(Line& line, const std::string& actual, const std::string& begin, const std::string& expected) {
        if (actual == expected) return;
        if (!updates) ADD_FAILURE() << m_tier << ": " << begin << actual << ", expected " << expected;
        line.text = begin + actual;
        line.right = actual;
    }

    const driver::Built& m_built;
    const char* m_tier;
    controller::Controller m_controller;
};

void expectNoErrors(const driver::Checked& checked) {
    for (const auto& diagnostic : checked.analysis->diagnostics)
        if (diagnostic.severity == diagnostics::Severity::Error)
            ADD_FAILURE() << diagnostics::renderText(*checked.sources, diagnostic, false);
}

void runGolden(const fs::path& source) {
    const fs::path expectedFile = withExtension(source, ".expected");
    std::vector<Line> script = parseScript(readText(expectedFile));
    const driver::Built built = driver::build(inputFor(source, script));
    ASSERT_EQ(built.failure.english(), "");
    if (!built.program) return expectNoErrors(built.checked);
    std::vector<Line> quick = script;
    Run(built, "quick").perform(quick);
    const auto optimised = driver::optimise(built);
    ASSERT_TRUE(optimised) << optimised.error().english();
    Run(built, "optimised").perform(script);
    for (size_t i = 0; i < script.size(); ++i)
        EXPECT_EQ(quick[i].text, script[i].text) << "quick and optimised code differ";
    if (!updates) return;
    std::string text;
    for (const Line& line : script) text += line.text + "\n";
    writeText(expectedFile, text);
}

void checkGolden(const fs::path& source) {
    const fs::path expectedFile = withExtension(source, ".diagnostics");
    const std::string expected = readText(expectedFile);
    const std::vector<Line> script = parseScript(expected);
    const driver::Checked checked = driver::check(inputFor(source, script));
    std::string actual;
    for (const Line& line : script)
        if (line.kind == LineKind::Comment || line.kind == LineKind::With || line.kind == LineKind::Library ||
            line.kind == LineKind::Setting)
            actual += line.text + "\n";
    for (const auto& diagnostic : checked.analysis->diagnostics) actual += shown(*checked.sources, diagnostic) + "\n";
    if (updates) return writeText(expectedFile, actual);
    EXPECT_EQ(actual, expected);
}

class GoldenTest : public testing::Test {
public:
    explicit GoldenTest(fs::path source) : m_source(std::move(source)) {}
    void TestBody() override {
        const bool hasRun = fs::exists(withExtension(m_source, ".expected")),
                   hasCheck = fs::exists(withExtension(m_source, ".diagnostics"));
        if (hasRun) runGolden(m_source);
        if (hasCheck) checkGolden(m_source);
    }

private:
    fs::path m_source;
};

std::string nameOf(std::string text) {
    for (char& c : text)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return text;
}

void registerGoldens() {
    const fs::path root = fs::path(plc::sourceDir()) / "tests" / "golden";
    std::vector<fs::path> sources;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
        if (entry.path().extension() != ".st") continue;
        if (fs::exists(withExtension(entry.path(), ".expected")) ||
            fs::exists(withExtension(entry.path(), ".diagnostics")))
            sources.push_back(entry.path());
    }
    std::ranges::sort(sources);
    for (const fs::path& source : sources) {
        const std::string suite = "Golden_" + nameOf(fs::relative(source.parent_path(), root).string());
        testing::RegisterTest(suite.c_str(), nameOf(source.stem().string()).c_str(), nullptr, nullptr, __FILE__,
                              __LINE__, [source]() -> testing::Test* { return new GoldenTest(source); });
    }
}

} // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    updates = argc > 1 && std::string_view(argv[1]) == "--update";
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    registerGoldens();
    registerAgreement();
    registerBroken();
    registerRandom();
    registerCorpus();
    return RUN_ALL_TESTS();
}
