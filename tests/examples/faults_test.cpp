// Whoever teaches with an example breaks it: each fault that its plant knows can be switched on from a panel, and what
// the plant counts is shown there and has a reset.
#include "tests/examples/example_names.h"
#include "tests/examples/text_of.h"

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <regex>

namespace plc {
namespace {

/// All files of a folder one after the other, those whose names end so.
std::string textsOf(const std::string& folder, const std::string& ending) {
    std::string out;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
        if (entry.path().string().ends_with(ending)) out += textOf(entry.path()) + "\n";
    return out;
}

struct Plant {
    std::string name;
    std::string declarations;
};

/// The simulation programs of an example with the variables that they declare.
std::vector<Plant> plantsOf(const std::string& folder) {
    const std::string sources = textsOf(folder + "/src", ".st");
    const std::regex head(R"(\{attribute 'simulation'\}\s*PROGRAM (\w+))");
    std::vector<Plant> out;
    for (std::sregex_iterator at(sources.begin(), sources.end(), head), end; at != end; ++at) {
        const size_t begin = static_cast<size_t>(at->position() + at->length());
        const size_t body = sources.find("\nEND_PROGRAM", begin);
        const size_t last = sources.rfind("END_VAR", body);
        out.push_back({(*at)[1], sources.substr(begin, last - begin)});
    }
    return out;
}

class Faults : public ::testing::TestWithParam<std::string> {
protected:
    void SetUp() override { panels = textsOf(folder + "/hmi", ".panel.json"); }
    bool isOnPanel(const Plant& plant, const std::string& variable) const {
        const std::string path = plant.name + "." + variable;
        for (size_t at = panels.find(path); at != std::string::npos; at = panels.find(path, at + 1)) {
            const char next = panels[at + path.size()];
            if (next != '_' && !std::isalnum(static_cast<unsigned char>(next))) return true;
        }
        return false;
    }
    const std::string folder = exampleFolder(GetParam());
    const std::vector<Plant> plants = plantsOf(folder);
    std::string panels;
};

/// The variables of a plant that are declared as such a type, or as an array of it, and whose names are like that.
std::vector<std::string> variablesOf(const Plant& plant, const std::string& type, const std::string& names) {
    const std::regex declaration(R"(\n\s+(\w+(?:, \w+)*) : (?:ARRAY\[[^\]]*\] OF )?()" + type + R"()\b)");
    const std::regex word(R"(\w+)"), wanted(names);
    std::vector<std::string> out;
    for (std::sregex_iterator at(plant.declarations.begin(), plant.declarations.end(), declaration), end; at != end;
         ++at) {
        const std::string declared = (*at)[1];
        for (std::sregex_iterator name(declared.begin(), declared.end(), word); name != end; ++name)
            if (std::regex_match(name->str(), wanted)) out.push_back(name->str());
    }
    return out;
}

TEST_P(Faults, CanBeSwitchedOnFromAPanel) {
    const std::string names = "[A-Z]\\w*(Cut|Broken|Jam|Jammed|Hangs|Stuck|Blocked|Shut|Noisy|Welded|Fails|Torn|Blind)"
                              "(\\d|M\\d|[XY])?|(Cut|Jam)\\w*|Blocked\\d|Noisy|ResetCounts";
    for (const Plant& plant : plants)
        for (const std::string& fault : variablesOf(plant, "BOOL", names))
            EXPECT_TRUE(isOnPanel(plant, fault)) << plant.name << "." << fault;
}

TEST_P(Faults, AreCountedWhereAnOperatorSeesThemAndSetsThemBack) {
    const std::string names =
        "Overflows?|DryRuns?|Overheats|Burnt|Boils|Stalls|Strains|Shorts|HotRuns|Overdoses|Empties|"
        "Crashes|EndHits|ArmHits|Scratches|NoCar|Falls|Wrong\\w*|Spilled|Overfilled|RedRuns|Mixed|"
        "HotMixers|Scalds|BadOut|Collisions";
    for (const Plant& plant : plants)
        for (const std::string& count : variablesOf(plant, "UDINT|UINT|INT", names)) {
            EXPECT_TRUE(isOnPanel(plant, count)) << plant.name << "." << count;
            EXPECT_TRUE(isOnPanel(plant, "ResetCounts")) << plant.name << " counts " << count;
        }
}

INSTANTIATE_TEST_SUITE_P(Examples, Faults, ::testing::ValuesIn(exampleNames()),
                         [](const auto& info) { return info.param; });

} // namespace
} // namespace plc
