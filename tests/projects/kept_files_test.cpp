// Checking again and again reads only what changed, and finds exactly what a check of everything finds.
#include "projects/analysis/code_model.h"
#include "tests/support/repeats.h"

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
    for (int step = 0; step < repeats(200); ++step) {
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

/// A file long enough that what is in front of an edit is shared with the reading before; charts and instruction lists
/// at its end, since these are lowered.
std::string longFile() {
    std::string text = "VAR_GLOBAL\n  gTotal : DINT;\nEND_VAR\n";
    for (int i = 0; i < 200; ++i)
        text += "FUNCTION_BLOCK Station" + std::to_string(i) +
                "\nVAR_INPUT level : INT; END_VAR\nVAR k : INT; t : TON; END_VAR\nt(IN := level > 5, PT := T#1s);\n"
                "IF t.Q THEN\n  k := k + 1;\n  gTotal := gTotal + k;\nEND_IF;\nEND_FUNCTION_BLOCK\n\n";
    return text + "PROGRAM List\nVAR a, b : INT; s : Station3; END_VAR\nLD a\nADD 1\nST b\nCAL s(level := b)\n"
                  "END_PROGRAM\n\nPROGRAM Chart\nVAR x : BOOL; END_VAR\nINITIAL_STEP One:\nEND_STEP\n"
                  "TRANSITION FROM One TO Two := x; END_TRANSITION\nSTEP Two:\nEND_STEP\n"
                  "TRANSITION FROM Two TO One := NOT x; END_TRANSITION\nEND_PROGRAM\n\n"
                  "PROGRAM Last\nVAR s : Station7; n : INT; END_VAR\ns(level := n);\nn := n + 1;\nEND_PROGRAM\n";
}

TEST(KeptFiles, EditsOfALongFileFindWhatAFullCheckFinds) {
    std::mt19937 random(20261123);
    driver::BuildInput input = someProject();
    input.files.push_back({"src/long.st", longFile()});
    const std::string clean = input.files.back().text;
    driver::KeptFiles kept;
    std::vector<driver::Checked> earlier; // what others still hold stays whole
    size_t shared = 0;
    const syntax::Decl* front = nullptr;
    for (int step = 0; step < repeats(120); ++step) {
        SCOPED_TRACE("step " + std::to_string(step) + " of seed 20261123");
        std::string& text = input.files.back().text;
        if (step % 5 == 4) text = clean;
        const size_t from = step % 3 == 0 ? text.size() / 2 : text.size() - 700;
        const size_t at = from + random() % (text.size() - from);
        if (random() % 4 == 0)
            text.erase(at, 1 + random() % 4);
        else
            text.insert(at, std::vector<std::string>{" ", "x", ";", "(*", "n := 2;\n", "ST a\n", "END_PROGRAM\n",
                                                     "FUNCTION_BLOCK Q\nEND_FUNCTION_BLOCK\n"}[random() % 8]);
        const driver::Checked now = driver::check(input, kept);
        ASSERT_EQ(findingsOf(now), findingsOf(driver::check(input)));
        const syntax::Decl* first = now.analysis->files[3]->declarations.front();
        shared += first == front;
        front = first;
        if (step % 10 == 0) earlier.push_back(now);
    }
    EXPECT_GT(shared, repeats(40U));
    for (const driver::Checked& each : earlier) EXPECT_FALSE(findingsOf(each).empty());
}

} // namespace
