// Panels of any shape operated by chance: the scripts of tests/fuzz/panels, and what changes make of them.
// STEPWISE_SEED repeats a run, STEPWISE_LONG=1 takes many more rounds.
#include "tests/fuzz/panels_impl.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

namespace plc::fuzz {
namespace {

std::vector<std::string> panelScripts() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(plc::sourceDir() + "/tests/fuzz/panels"))
        paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    std::vector<std::string> out;
    for (const auto& path : paths) {
        std::ostringstream text;
        text << std::ifstream(path).rdbuf();
        out.push_back(text.str());
    }
    return out;
}

TEST(PanelScripts, AreOperatedAsTheyAreAndChanged) {
    const char* given = std::getenv("STEPWISE_SEED");
    const unsigned seed = given ? static_cast<unsigned>(std::atoi(given)) : std::random_device()();
    std::printf("STEPWISE_SEED=%u\n", seed);
    std::fflush(stdout); // seen also when a script ends the process
    const std::vector<std::string> scripts = panelScripts();
    ASSERT_FALSE(scripts.empty());
    for (const std::string& script : scripts) operatePanels(script);
    Damage damage(seed);
    Lent lent;
    const int rounds = std::getenv("STEPWISE_LONG") ? 1'000 : 20;
    for (int i = 0; i < rounds; ++i) {
        std::string script = scripts[damage.pick(scripts.size())];
        for (size_t changes = 1 + damage.pick(3); changes > 0; --changes) script = changedScript(script, lent, damage);
        operatePanels(script);
    }
}

} // namespace
} // namespace plc::fuzz
