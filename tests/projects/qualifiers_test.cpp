// Golden tables of the action qualifiers (IEC 61131-3 ed. 2, 2.6.4.4 and 2.6.4.5): a picture of each scan, # = the
// action is active. A scan takes 10 ms; the step is on for n scans from column 0; times are shorter than that, equal,
// longer; a step that resets comes in between; two steps share an action. Quick and optimised code give the same.
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"

#include <gtest/gtest.h>

#include <map>

namespace plc::session {
namespace {

const char* const kQualifiers[] = {"N", "S", "P", "P1", "P0", "L", "D", "SD", "DS", "SL"};

std::string association(const std::string& qualifier, const std::string& action, int timeMs) {
    const bool timed =
        qualifier == "L" || qualifier == "D" || qualifier == "SD" || qualifier == "DS" || qualifier == "SL";
    return "    " + action + "(" + qualifier + (timed ? ", T#" + std::to_string(timeMs) + "ms" : "") + ");\n";
}

/// Work is on while `go`, Clear (which resets everything) while `wipe`; both charts run side by side.
std::string program(int timeMs) {
    std::string variables, work, clear;
    for (const std::string q : kQualifiers) {
        variables += "    v" + q + " : BOOL;\n";
        work += association(q, "v" + q, timeMs);
        clear += association("R", "v" + q, timeMs);
    }
    return "PROGRAM Main\nVAR\n    go, wipe : BOOL;\n" + variables +
           "END_VAR\nINITIAL_STEP Idle: END_STEP\nTRANSITION FROM Idle TO Work := go; END_TRANSITION\nSTEP Work:\n" +
           work +
           "END_STEP\nTRANSITION FROM Work TO Idle := NOT go; END_TRANSITION\nINITIAL_STEP Quiet: END_STEP\nTRANSITION "
           "FROM Quiet TO Clear := wipe; END_TRANSITION\nSTEP Clear:\n" +
           clear + "END_STEP\nTRANSITION FROM Clear TO Quiet := NOT wipe; END_TRANSITION\nEND_PROGRAM\n";
}

types::Value boolean(bool value) { return types::Value{types::TypeTable::of(types::TypeKind::Bool), int64_t(value)}; }

struct Span {
    const char* input;
    int from, to; // scans in which it is TRUE; column 0 is the first scan of Work
};

/// One line per variable: its value in scans 0 … `columns`.
std::map<std::string, std::string> pictures(const std::string& text, const std::vector<Span>& inputs,
                                            const std::vector<std::string>& names, int columns, bool optimised) {
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    driver::BuildInput input;
    input.files.push_back({"main.st", text});
    driver::Built built = driver::build(input);
    std::map<std::string, std::string> out;
    EXPECT_TRUE(built.program) << text;
    if (!built.program) return out;
    if (optimised) {
        EXPECT_TRUE(driver::optimise(built));
    }
    controller::Controller plc(built.program);
    plc.start();
    plc.scan(); // the initial steps
    for (int column = 0; column < columns; ++column) {
        std::map<std::string, bool> values;
        for (const Span& span : inputs)
            values[span.input] = values[span.input] || (column >= span.from && column < span.to);
        for (const auto& [name, value] : values) EXPECT_TRUE(plc.write("Main." + name, boolean(value)));
        plc.scan();
        for (const std::string& name : names) out[name] += plc.read("Main." + name)->isTrue() ? '#' : '.';
    }
    return out;
}

struct Row {
    const char *qualifier, *shorter, *equal, *longer;
};

void expectTable(const std::vector<Row>& table, const std::vector<Span>& inputs, int columns) {
    std::vector<std::string> names;
    for (const char* q : kQualifiers) names.push_back(std::string("v") + q);
    for (const bool optimised : {false, true})
        for (const auto& [timeMs, expected] :
             {std::pair(20, &Row::shorter), std::pair(50, &Row::equal), std::pair(90, &Row::longer)}) {
            auto got = pictures(program(timeMs), inputs, names, columns, optimised);
            for (const Row& row : table)
                EXPECT_EQ(got[std::string("v") + row.qualifier], row.*expected)
                    << row.qualifier << " with " << timeMs << " ms" << (optimised ? ", optimised" : "");
        }
}

} // namespace

// The pictures stand below each other.
// clang-format off
TEST(Qualifiers, AStepThatIsOnForFiveScans) {
    //                    20 ms           50 ms           90 ms
    expectTable({{"N",  "#####.......", "#####.......", "#####......."},
                 {"S",  "############", "############", "############"},
                 {"P",  "#...........", "#...........", "#..........."},
                 {"P1", "#...........", "#...........", "#..........."},
                 {"P0", ".....#......", ".....#......", ".....#......"},
                 {"L",  "##..........", "#####.......", "#####......."},
                 {"D",  "..###.......", "............", "............"},
                 {"SD", "..##########", ".....#######", ".........###"},
                 {"DS", "..##########", "............", "............"},
                 {"SL", "##..........", "#####.......", "#########..."}},
                {{"go", 0, 5}}, 12);
}

TEST(Qualifiers, AStepThatIsOnForOneScan) {
    expectTable({{"N",  "#.........", "#.........", "#........."},
                 {"S",  "##########", "##########", "##########"},
                 {"P",  "#.........", "#.........", "#........."},
                 {"P1", "#.........", "#.........", "#........."},
                 {"P0", ".#........", ".#........", ".#........"},
                 {"L",  "#.........", "#.........", "#........."},
                 {"D",  "..........", "..........", ".........."},
                 {"SD", "..########", ".....#####", ".........#"},
                 {"DS", "..........", "..........", ".........."},
                 {"SL", "##........", "#####.....", "#########."}},
                {{"go", 0, 1}}, 10);
}

TEST(Qualifiers, AResetInScanFourEndsAndForbidsWhatIsStored) {
    // Work is on for five scans, Clear in scans 4 and 5: R is stronger than everything, and what was stored is gone behind it.
    expectTable({{"N",  "####........", "####........", "####........"},
                 {"S",  "####........", "####........", "####........"},
                 {"P",  "#...........", "#...........", "#..........."},
                 {"L",  "##..........", "####........", "####........"},
                 {"D",  "..##........", "............", "............"},
                 {"SD", "..##........", "............", "............"},
                 {"DS", "..##........", "............", "............"},
                 {"SL", "##..........", "####........", "####........"}},
                {{"go", 0, 5}, {"wipe", 4, 6}}, 12);
}

TEST(Qualifiers, TheStepComesAgainBehindAReset) {
    // on in 0–4, reset in 6, on again in 8–12
    expectTable({{"N",  "#####...#####...", "#####...#####...", "#####...#####..."},
                 {"S",  "######..########", "######..########", "######..########"},
                 {"L",  "##......##......", "#####...#####...", "#####...#####..."},
                 {"D",  "..###.....###...", "................", "................"},
                 {"SD", "..####....######", ".....#.......###", "................"},
                 {"DS", "..####....######", "................", "................"},
                 {"SL", "##......##......", "#####...#####...", "######..########"}},
                {{"go", 0, 5}, {"go", 8, 13}, {"wipe", 6, 7}}, 16);
}
// clang-format on

TEST(Qualifiers, TwoStepsThatShareAnActionHaveOneControl) {
    struct Shared {
        const char *first, *second; // associations of the action x with the steps A (scans 0–4) and B (scans 3–7)
        const char* expected;
    };
    for (const Shared& row : {
             Shared{"N", "N", "########...."},
             {"N", "S", "############"},
             {"N", "R", "###........."},
             {"S", "N", "############"},
             {"S", "R", "###........."},
             {"N", "P", "#####......."},
             {"L, T#20ms", "N", "##.#####...."},
             {"N", "D, T#20ms", "########...."},
             {"D, T#30ms", "L, T#20ms", "...##......."},
             {"S", "P0", "############"},
             {"P1", "P0", "#.......#..."},
             {"SL, T#20ms", "SL, T#20ms", "##.##......."},
             {"SD, T#20ms", "R", "..#........."},
         }) {
        const std::string text = std::string("PROGRAM Main\nVAR goA, goB, x : BOOL; END_VAR\nINITIAL_STEP A0: "
                                             "END_STEP\nTRANSITION FROM A0 TO A := goA; END_TRANSITION\nSTEP A: x(") +
                                 row.first +
                                 "); END_STEP\nTRANSITION FROM A TO A0 := NOT goA; END_TRANSITION\nINITIAL_STEP B0: "
                                 "END_STEP\nTRANSITION FROM B0 TO B := goB; END_TRANSITION\nSTEP B: x(" +
                                 row.second +
                                 "); END_STEP\nTRANSITION FROM B TO B0 := NOT goB; END_TRANSITION\nEND_PROGRAM\n";
        for (const bool optimised : {false, true})
            EXPECT_EQ(pictures(text, {{"goA", 0, 5}, {"goB", 3, 8}}, {"x"}, 12, optimised)["x"], row.expected)
                << row.first << " and " << row.second;
    }
}

} // namespace plc::session
