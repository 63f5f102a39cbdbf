#include "tests/golden/corpus_test.h"

#include "runtime/compiler/driver/driver.h"
#include "runtime/controller/controller.h"
#include "runtime/types/conversion.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>

namespace fs = std::filesystem;

namespace plc::golden {
namespace {

using nlohmann::json;

struct Corpus {
    fs::path folder;
    std::map<std::string, json> listings;
    [[nodiscard]] std::string read(const json& listing, const char* file) const {
        if (!listing["files"].contains(file)) return {};
        std::ifstream in(folder / listing["files"][file].get<std::string>(), std::ios::binary);
        std::stringstream text;
        text << in.rdbuf();
        return text.str();
    }
};

/// Where the index does not say what this project decided: 047 divides REAL by zero, which gives INF and is no fault
/// here (D11); the harness of 235 gives CYCLE 100 ms where its vector counts 10 ms.
std::string harnessText(const Corpus& corpus, const json& listing) {
    std::string text = corpus.read(listing, "harness");
    if (listing["id"] == "235")
        if (const size_t at = text.find("T#100ms"); at != std::string::npos) text.replace(at, 7, "T#10ms");
    return text;
}

/// The text of a listing that is meant to compile: the corrected one where the printed one has a slip.
std::string unitText(const Corpus& corpus, const json& listing, bool asPrinted) {
    std::string text =
        !asPrinted && listing["files"].contains("fixed") ? corpus.read(listing, "fixed") : corpus.read(listing, "st");
    if (listing["assemble"] == "body") text = corpus.read(listing, "decl") + "\n" + text + "\nEND_PROGRAM\n";
    return text;
}

driver::BuildInput inputFor(const Corpus& corpus, const json& listing, bool asPrinted) {
    driver::BuildInput input;
    for (const auto& required : listing["requires"]) {
        const auto found = corpus.listings.find(required.get<std::string>());
        if (found != corpus.listings.end())
            input.files.push_back({found->first + ".st", unitText(corpus, found->second, false)});
    }
    input.files.push_back({listing["id"].get<std::string>() + ".st", unitText(corpus, listing, asPrinted)});
    const std::string harness = harnessText(corpus, listing);
    if (!harness.empty()) input.files.push_back({"harness.st", harness});
    return input;
}

bool hasConfiguration(const driver::BuildInput& input) {
    for (const auto& file : input.files)
        if (file.text.find("END_CONFIGURATION") != std::string::npos) return true;
    return false;
}

std::string errorsOf(const driver::Checked& checked) {
    std::string text;
    for (const auto& diagnostic : checked.analysis->diagnostics) {
        using diagnostics::Kind;
        if (diagnostic.severity != diagnostics::Severity::Error || diagnostic.kind == Kind::NoProgram ||
            diagnostic.kind == Kind::SeveralPrograms)
            continue;
        text += diagnostics::renderText(*checked.sources, diagnostic, false) + "\n";
    }
    return text;
}

/// One vector: a program, set inputs, scans, expected values.
class VectorRun {
public:
    VectorRun(const driver::Built& built, std::string instance)
        : m_built(built), m_instance(std::move(instance)), m_controller(built.program) {
        m_controller.start();
    }

    void perform(const json& vector) {
        for (const json& step : vector["steps"]) {
            if (step.contains("set"))
                for (const auto& [name, value] : step["set"].items()) set(name, value);
            if (step.contains("pulse")) pulse(step);
            if (step.contains("scans")) scan(step["scans"].get<int>());
            if (step.contains("expect"))
                for (const auto& [name, value] : step["expect"].items()) expect(name, value);
            ASSERT_FALSE(m_controller.fault()) << m_controller.fault()->message.english() << " at line "
                                               << m_built.program->sources[m_controller.fault()->range.file]
                                                      .lineColumn(m_controller.fault()->range.begin)
                                                      .line;
        }
    }

private:
    void scan(int count) {
        for (int i = 0; i < count && !m_controller.fault(); ++i) m_controller.scan();
    }

    void pulse(const json& step) {
        for (int i = step["times"].get<int>(); i > 0; --i) {
            set(step["pulse"].get<std::string>(), true);
            scan(1);
            set(step["pulse"].get<std::string>(), false);
            scan(1);
        }
    }

    /// The variable of the program, else the global of that name.
    std::string pathOf(const std::string& name) const {
        const std::string local = m_instance + "." + name;
        return m_built.program->layout.find(local) ? local : name;
    }

    void set(const std::string& name, const json& value) {
        const auto place = m_built.program->layout.find(pathOf(name));
        ASSERT_TRUE(place) << name << ": " << place.error().english();
        const auto& types = *m_built.program->layout.types;
        std::string text = value.is_string() ? value.get<std::string>() : value.dump();
        if (types.isText(place->type)) text = "'" + text + "'";
        const auto parsed = types::parseValue(types, place->type, text);
        ASSERT_TRUE(parsed) << name << " := " << text;
        const auto written = m_controller.write(pathOf(name), *parsed);
        EXPECT_TRUE(written) << name;
    }

    void expect(const std::string& name, const json& expected) {
        if (expected.is_string() && isRelation(expected.get<std::string>()))
            return expectRelation(name, expected.get<std::string>());
        auto expression = driver::compileExpression(m_built.checked, m_instance + "." + name);
        if (!expression) expression = driver::compileExpression(m_built.checked, name);
        ASSERT_TRUE(expression) << name << ": " << expression.error().message.english();
        const auto outcome = expression->evaluate(m_controller.image());
        ASSERT_TRUE(outcome.hasValue()) << name << ": " << outcome.reason.english();
        const auto& types = expression->types();
        const std::string shown = name + " = " + types::toText(types, outcome.value) + ", expected " + expected.dump();
        if (expected.is_boolean()) {
            EXPECT_EQ(outcome.value.isTrue(), expected.get<bool>()) << shown;
        } else if (expected.is_string()) {
            const auto parsed =
                types::parseValue(types, outcome.value.type,
                                  types.isText(outcome.value.type) ? "'" + expected.get<std::string>() + "'"
                                                                   : expected.get<std::string>());
            ASSERT_TRUE(parsed) << shown;
            EXPECT_EQ(types::toText(types, outcome.value), types::toText(types, *parsed)) << name;
        } else if (const auto* real = std::get_if<double>(&outcome.value.data)) {
            const double wanted = expected.get<double>();
            EXPECT_NEAR(*real, wanted, 2e-4 * std::max(1.0, std::fabs(wanted))) << shown;
        } else {
            ASSERT_TRUE(std::holds_alternative<int64_t>(outcome.value.data)) << shown;
            EXPECT_EQ(static_cast<double>(outcome.value.integer()), expected.get<double>()) << shown;
        }
    }

    static bool isRelation(const std::string& text) { return text.starts_with("<") || text.starts_with(">"); }
    void expectRelation(const std::string& name, const std::string& relation) {
        const auto expression = driver::compileExpression(m_built.checked, m_instance + "." + name + " " + relation);
        ASSERT_TRUE(expression) << expression.error().message.english();
        EXPECT_TRUE(expression->isTrue(m_controller.image())) << name << " " << relation;
    }

    const driver::Built& m_built;
    std::string m_instance;
    controller::Controller m_controller;
};

int64_t cycleOf(const json& vector) {
    for (const json& step : vector["steps"])
        if (step.contains("cycle_ms")) return step["cycle_ms"].get<int64_t>();
    return 10;
}

void runVector(driver::BuildInput input, const json& vector) {
    std::string instance = vector["program"].get<std::string>();
    if (!hasConfiguration(input)) {
        input.files.push_back(
            {"configuration.st", "CONFIGURATION Bench\nRESOURCE Cpu ON Pc\nTASK Cycle(INTERVAL := T#" +
                                     std::to_string(cycleOf(vector)) +
                                     "ms, PRIORITY := 1);\nPROGRAM BenchInstance WITH Cycle : " + instance +
                                     ";\nEND_RESOURCE\nEND_CONFIGURATION\n"});
        instance = "BenchInstance";
    }
    const driver::Built built = driver::build(input);
    ASSERT_EQ(built.failure.english(), "");
    ASSERT_TRUE(built.program) << errorsOf(built.checked);
    VectorRun(built, instance).perform(vector);
    ASSERT_TRUE(driver::optimise(built));
    VectorRun(built, instance).perform(vector);
}

class ListingTest : public testing::Test {
public:
    ListingTest(std::shared_ptr<const Corpus> corpus, std::string id)
        : m_corpus(std::move(corpus)), m_id(std::move(id)) {}
    void TestBody() override {
        const json& listing = m_corpus->listings.at(m_id);
        if (listing["assemble"] == "none") return;
        const driver::BuildInput input = inputFor(*m_corpus, listing, false);
        const driver::Checked checked = driver::check(input);
        EXPECT_EQ(errorsOf(checked), "");
        if (listing["parses_as_printed"] == false) {
            const driver::Checked printed = driver::check(inputFor(*m_corpus, listing, true));
            EXPECT_NE(printed.analysis->diagnostics.size(), 0u) << "the slip in the printed text was not found";
        }
        if (HasFailure()) return;
        for (size_t i = 0; i < listing["vectors"].size(); ++i) {
            SCOPED_TRACE("vector " + std::to_string(i));
            runVector(input, listing["vectors"][i]);
        }
    }

private:
    std::shared_ptr<const Corpus> m_corpus;
    std::string m_id;
};

class NotRunTest : public testing::Test {
public:
    void TestBody() override { GTEST_SKIP() << "STEPWISE_CORPUS does not name a corpus"; }
};

} // namespace

void registerCorpus() {
    const char* folder = std::getenv("STEPWISE_CORPUS");
    if (!folder || !fs::exists(fs::path(folder) / "index.json")) {
        testing::RegisterTest("Corpus", "Listings", nullptr, nullptr, __FILE__, __LINE__,
                              []() -> testing::Test* { return new NotRunTest; });
        return;
    }
    auto corpus = std::make_shared<Corpus>();
    corpus->folder = folder;
    std::ifstream in(corpus->folder / "index.json");
    json index = json::parse(in);
    for (json& listing : index["listings"]) {
        const std::string id = listing["id"].get<std::string>();
        corpus->listings.emplace(id, std::move(listing));
    }
    for (const auto& [id, listing] : corpus->listings) {
        const std::string name = "Listing" + id;
        testing::RegisterTest("Corpus", name.c_str(), nullptr, nullptr, __FILE__, __LINE__,
                              [corpus = std::shared_ptr<const Corpus>(corpus), id = id]() -> testing::Test* {
                                  return new ListingTest(corpus, id);
                              });
    }
}

} // namespace plc::golden
