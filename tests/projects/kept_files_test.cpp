// Checking again and again reads only what changed, and finds exactly what a check of everything finds.
#include "projects/analysis/code_model.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace {
using namespace plc;

std::string findingsOf(const driver::Checked& checked) {
    std::string out;
    for (const diagnostics::Diagnostic& each : checked.analysis->diagnostics)
        out += diagnostics::renderText(*checked.sources, each, false) + "\n";
    for (const sema::Reference& each : checked.analysis->references)
        out += std::to_string(each.range.file.index()) + ":" + std::to_string(each.range.begin) + " " +
               checked.analysis->symbols[each.symbol.index()].name + "\n";
    return out;
}

driver::BuildInput someProject() {
    driver::BuildInput input;
    input.libraries = {"toolbox"};
    input.files = {{"src/a.st", "PROGRAM A\nVAR n : INT; END_VAR\nn := n + Scale(2);\nEND_PROGRAM\n"},
                   {"src/b.st", "FUNCTION Scale : INT\nVAR_INPUT x : INT; END_VAR\nScale := 3 * x;\nEND_FUNCTION\n"},
                   {"src/c.st", "PROGRAM C\nVAR t : TON; END_VAR\nt(IN := TRUE, PT := T#1s);\nEND_PROGRAM\n"}};
    return input;
}

TEST(KeptFiles, AKeystrokeReadsTheFileItIsIn) {
    driver::BuildInput input = someProject();
    driver::KeptFiles kept;
    (void)driver::check(input, kept);
    EXPECT_GT(kept.readLast(), 3u) << "the libraries too";
    (void)driver::check(input, kept);
    EXPECT_EQ(kept.readLast(), 0u);
    input.files[1].text += " ";
    (void)driver::check(input, kept);
    EXPECT_EQ(kept.readLast(), 1u);
}

TEST(KeptFiles, WhatWasMadeBeforeStaysWhole) {
    driver::BuildInput input = someProject();
    driver::KeptFiles kept;
    const auto first = analysis::CodeModel::make(input, 1, kept);
    const std::string before = findingsOf(first->checked());
    for (int i = 0; i < 5; ++i) {
        input.files[0].text += "(* " + std::to_string(i) + " *)\n";
        (void)analysis::CodeModel::make(input, 2, kept);
    }
    input.files.clear();
    (void)driver::check(input, kept);
    EXPECT_EQ(findingsOf(first->checked()), before);
}

TEST(KeptFiles, ConditionsThatAskOtherFilesAreReadAgain) {
    driver::BuildInput input;
    input.files = {{"a.st", "{IF defined (variable: gWide)}\nPROGRAM Wide\nEND_PROGRAM\n{ELSE}\nPROGRAM Narrow\n"
                            "END_PROGRAM\n{END_IF}\n"},
                   {"b.st", "VAR_GLOBAL\n  gSmall : INT;\nEND_VAR\n"}};
    driver::KeptFiles kept;
    const auto hasProgram = [&](const char* name) {
        const driver::Checked checked = driver::check(input, kept);
        for (const sema::Symbol& each : checked.analysis->symbols)
            if (each.kind == sema::SymbolKind::Program && each.name == name) return true;
        return false;
    };
    EXPECT_TRUE(hasProgram("Narrow"));
    input.files[1].text = "VAR_GLOBAL\n  gWide : INT;\nEND_VAR\n";
    EXPECT_TRUE(hasProgram("Wide"));
    EXPECT_FALSE(hasProgram("Narrow"));
}

TEST(KeptFiles, OtherDefinesReadEverythingAgain) {
    driver::BuildInput input;
    input.files = {{"a.st", "{IF defined (Simulation)}\nPROGRAM Simulated\nEND_PROGRAM\n{END_IF}\nPROGRAM P\n"
                            "END_PROGRAM\n"}};
    driver::KeptFiles kept;
    const size_t without = driver::check(input, kept).analysis->symbols.size();
    input.defines = {"Simulation"};
    EXPECT_GT(driver::check(input, kept).analysis->symbols.size(), without);
}

/// Letters come and go at random places of random files, files appear and vanish.
TEST(KeptFiles, RandomEditsFindWhatAFullCheckFinds) {
    std::mt19937 random(20261122);
    driver::BuildInput input = someProject();
    driver::KeptFiles kept;
    for (int step = 0; step < 200; ++step) {
        SCOPED_TRACE("step " + std::to_string(step) + " of seed 20261122");
        const size_t file = random() % input.files.size();
        std::string& text = input.files[file].text;
        switch (random() % 6) {
        case 0:
            input.files.push_back({"src/new" + std::to_string(step) + ".st",
                                   "TYPE T" + std::to_string(step) + " : STRUCT a : INT; END_STRUCT; END_TYPE\n"});
            break;
        case 1:
            if (input.files.size() > 2) input.files.erase(input.files.begin() + static_cast<long>(file));
            break;
        case 2:
            std::swap(input.files[file], input.files[random() % input.files.size()]);
            break;
        case 3:
            if (!text.empty()) text.erase(random() % text.size(), 1);
            break;
        default:
            text.insert(random() % (text.size() + 1), 1, " ;(x1\n:"[random() % 7]);
            break;
        }
        ASSERT_EQ(findingsOf(driver::check(input, kept)), findingsOf(driver::check(input)));
    }
}

} // namespace
