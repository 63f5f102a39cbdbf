// Instruction lists shown as ST and ST as instruction lists: the text that comes out gives the same results, scan by
// scan, for random inputs.
#include "projects/analysis/code_model.h"
#include "projects/analysis/conversion.h"
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"
#include "tests/support/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>
#include <sstream>

namespace plc::analysis {
namespace {

std::string fileText(const std::string& path) {
    std::ifstream in(plc::sourceDir() + "/" + path);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

driver::BuildInput inputOf(const std::string& text) {
    driver::BuildInput input;
    input.files.push_back({"main.st", text});
    return input;
}

/// The values of `names` after each scan.
std::vector<std::string> traceOf(const std::string& text, const std::vector<std::string>& names, int scans) {
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    std::vector<std::string> out;
    const driver::Built built = driver::build(inputOf(text));
    if (!built.program) {
        out.push_back(built.failure.english());
        for (const auto& d : built.checked.analysis->diagnostics) out.push_back(d.message.english());
        return out;
    }
    session::Session session(built);
    std::vector<expression::Expression> values;
    for (const std::string& name : names) {
        auto value = session.expression("Main." + name);
        if (!value) return {value.error().english()};
        values.push_back(*value);
    }
    session.runHere([&](const controller::Controller& c) {
        std::string line;
        for (const expression::Expression& value : values)
            line += types::toText(value.types(), value.evaluate(c.image()).value) + " ";
        out.push_back(line);
        return static_cast<int>(out.size()) == scans;
    });
    return out;
}

std::string converted(const std::string& text, const std::string& unit, TextLanguage to) {
    const auto out = convertBody(inputOf(text), "main.st", unit, to);
    EXPECT_TRUE(out) << unit << ": " << (out ? "" : out.error().english());
    return out ? out->text : text;
}

TextLanguage languageOf(const std::string& text, const std::string& unit) {
    for (const BodyPlace& place : bodiesOf(text))
        if (place.unit == unit) return place.language;
    ADD_FAILURE() << unit << " is not in\n" << text;
    return TextLanguage::St;
}

} // namespace

TEST(Conversion, TheFourUnitsGiveTheSameInEitherLanguage) {
    const std::string text = fileText("tests/golden/il/same_as_st.st");
    const std::vector<std::string> names = {"net1",          "net2",          "monitorSt.alarm", "monitorIl.alarm",
                                            "bothSt.klaxon", "bothIl.klaxon", "bothIl.forward",  "pileSt.top",
                                            "pileIl.top",    "pileIl.full",   "differences",     "pushed",
                                            "clashes"};
    const auto wanted = traceOf(text, names, 3000);
    ASSERT_EQ(wanted.size(), 3000u) << wanted.back();
    std::string asSt = text;
    for (const char* unit : {"NetIl", "MonitorIl", "BothWaysIl", "PileIl"}) {
        asSt = converted(asSt, unit, TextLanguage::St);
        EXPECT_EQ(languageOf(asSt, unit), TextLanguage::St);
    }
    EXPECT_EQ(traceOf(asSt, names, 3000), wanted);
    std::string asIl = text;
    for (const char* unit : {"NetSt", "MonitorSt", "BothWaysSt", "PileSt"}) {
        asIl = converted(asIl, unit, TextLanguage::Il);
        EXPECT_EQ(languageOf(asIl, unit), TextLanguage::Il);
    }
    EXPECT_EQ(traceOf(asIl, names, 3000), wanted);
    // and back: the lists that were made become statements again
    for (const char* unit : {"NetSt", "MonitorSt", "BothWaysSt", "PileSt"})
        asIl = converted(asIl, unit, TextLanguage::St);
    EXPECT_EQ(traceOf(asIl, names, 3000), wanted);
}

TEST(Conversion, EveryOperatorGivesTheSameAsSt) {
    const std::string text = fileText("tests/golden/il/operators.st");
    const std::vector<std::string> names = {"a", "b", "c", "d", "e", "f",     "g",         "i",  "j",
                                            "k", "m", "n", "o", "q", "loops", "adder.sum", "t.Q"};
    const auto wanted = traceOf(text, names, 20);
    ASSERT_EQ(wanted.size(), 20u) << wanted.back();
    std::string asSt = text;
    for (const char* unit : {"Twice", "Up", "Main"}) asSt = converted(asSt, unit, TextLanguage::St);
    EXPECT_EQ(traceOf(asSt, names, 20), wanted) << asSt;
}

/// Random statements in ST become a list, and the list statements again; all three give the same values in every scan.
TEST(Conversion, RandomProgramsGiveTheSameThereAndBack) {
    for (uint32_t seed = 1; seed <= 24; ++seed) {
        uint32_t state = seed;
        const auto random = [&](uint32_t limit) {
            state = state * 1664525u + 1013904223u;
            return (state >> 8) % limit;
        };
        const std::function<std::string(int)> number = [&](int depth) -> std::string {
            static const char* const names[] = {"i", "j", "k", "arr[2]"};
            switch (depth <= 0 ? random(2) : random(7)) {
            case 0:
                return names[random(4)];
            case 1:
                return std::to_string(random(20));
            case 2:
                return "(" + number(depth - 1) + " + " + number(depth - 1) + ")";
            case 3:
                return "(" + number(depth - 1) + " - " + number(depth - 1) + ")";
            case 4:
                return "(" + number(depth - 1) + " * " + std::to_string(1 + random(5)) + ")";
            case 5:
                return "(" + number(depth - 1) + " MOD " + std::to_string(2 + random(5)) + ")";
            default:
                return "LIMIT(" + number(depth - 1) + ", 3, 40)";
            }
        };
        const std::function<std::string(int)> truth = [&](int depth) -> std::string {
            static const char* const names[] = {"a", "b", "c", "t.Q"};
            switch (depth <= 0 ? 0 : random(6)) {
            case 0:
                return names[random(4)];
            case 1:
                return "(" + truth(depth - 1) + " AND " + truth(depth - 1) + ")";
            case 2:
                return "(" + truth(depth - 1) + " OR NOT " + truth(depth - 1) + ")";
            case 3:
                return "(" + truth(depth - 1) + " XOR " + truth(depth - 1) + ")";
            case 4:
                return "(" + number(depth - 1) + " >= " + number(depth - 1) + ")";
            default:
                return "NOT " + truth(depth - 1);
            }
        };
        const std::function<std::string(int)> statement = [&](int depth) -> std::string {
            static const char* const numbers[] = {"i", "j", "k", "arr[1]"};
            static const char* const truths[] = {"a", "b", "c"};
            switch (depth <= 0 ? random(3) : random(8)) {
            case 0:
                return std::string(numbers[random(4)]) + " := " + number(2) + ";\n";
            case 1:
                return std::string(truths[random(3)]) + " := " + truth(2) + ";\n";
            case 2:
                return std::string(truths[random(3)]) + (random(2) ? " S= " : " R= ") + truth(1) + ";\n";
            case 3:
                return "IF " + truth(2) + " THEN\n" + statement(depth - 1) + "ELSIF " + truth(1) + " THEN\n" +
                       statement(depth - 1) + "ELSE\n" + statement(depth - 1) + "END_IF\n";
            case 4:
                return "FOR n := " + std::to_string(random(3)) + " TO " + std::to_string(2 + random(5)) + " DO\n" +
                       statement(depth - 2) + statement(depth - 2) + "END_FOR\n";
            case 5:
                return "CASE i OF\n1, 3: " + statement(depth - 1) + "5..9: " + statement(depth - 1) + "ELSE " +
                       statement(depth - 1) + "END_CASE\n";
            case 6:
                return "t(IN := " + truth(1) + ", PT := T#20ms);\n";
            default:
                return "n := 0;\nWHILE n < 3 DO\nn := n + 1;\nIF " + truth(1) + " THEN EXIT; END_IF\n" + statement(0) +
                       "END_WHILE\n";
            }
        };
        std::string body;
        for (int line = 0; line < 8; ++line) body += statement(2);
        const std::string text =
            "FUNCTION_BLOCK Work\nVAR_INPUT a, b : BOOL; i : INT; END_VAR\nVAR_OUTPUT c : BOOL; j, k : INT; "
            "END_VAR\nVAR arr : ARRAY[0..3] OF INT; n : INT; t : TON; END_VAR\n// what it does\n" +
            body + "END_FUNCTION_BLOCK\nPROGRAM Main\nVAR w : Work; seed : UDINT := " + std::to_string(seed) +
            "; END_VAR\nseed := seed * 1664525 + 1013904223;\nw(a := UDINT_TO_DWORD(seed).9, b := "
            "UDINT_TO_DWORD(seed).12, i := UDINT_TO_INT(SHR(seed, 10) MOD 50));\nEND_PROGRAM\n";
        const std::vector<std::string> names = {"w.a", "w.b", "w.c", "w.j", "w.k", "w.n", "w.arr[1]"};
        const auto wanted = traceOf(text, names, 300);
        ASSERT_EQ(wanted.size(), 300u) << "seed " << seed << "\n" << wanted.back() << "\n" << text;
        const std::string list = converted(text, "Work", TextLanguage::Il);
        ASSERT_EQ(languageOf(list, "Work"), TextLanguage::Il);
        EXPECT_NE(list.find("// what it does"), std::string::npos);
        ASSERT_EQ(traceOf(list, names, 300), wanted) << "seed " << seed << "\n" << text << list;
        const std::string back = converted(list, "Work", TextLanguage::St);
        ASSERT_EQ(traceOf(back, names, 300), wanted) << "seed " << seed << "\n" << list << back;
    }
}

TEST(Conversion, CommentsPragmasAndTakenNamesAreMinded) {
    const std::string text =
        "{attribute 'x'}\nPROGRAM Main\nVAR\n    result1 : INT; // taken\n    i, j : INT;\nEND_VAR\n        LD      i "
        "(* one *)\n        ADD     1\n        ST      i // two\n        GT      3\n        JMPC    out\n        ST    "
        "  result1\nout:    RET // last\nEND_PROGRAM\n";
    std::string good = text;
    good.replace(good.find("        ST      result1\n"), 24, "        LD      5\n        ST      result1\n");
    const auto out = convertBody(inputOf(good), "main.st", "Main", TextLanguage::St);
    ASSERT_TRUE(out) << out.error().english();
    EXPECT_EQ(out->text,
              "{attribute 'x'}\nPROGRAM Main\nVAR\n    result1 : INT; // taken\n    i, j : INT;\nEND_VAR\nVAR\n    "
              "result2 : INT;\nEND_VAR\n(* one *)\n// two\nresult2 := i + 1;\ni := result2;\nIF result2 > 3 THEN\n    "
              "JMP out;\nEND_IF\nresult1 := 5;\nout:\nRETURN; // last\nEND_PROGRAM\n");
    const auto none = convertBody(
        inputOf("PROGRAM Main\nVAR i, j : INT; END_VAR\nFOR i := 1 TO j DO j := j - 1; END_FOR\nEND_PROGRAM\n"),
        "main.st", "Main", TextLanguage::Il);
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().english().find("has no equivalent in an instruction list"), std::string::npos);
    EXPECT_FALSE(convertBody(inputOf(good), "main.st", "Main", TextLanguage::Il)); // is one already
    EXPECT_FALSE(convertBody(inputOf(good), "main.st", "None", TextLanguage::St));
    EXPECT_FALSE(convertBody(inputOf(good), "other.st", "Main", TextLanguage::St));
    const auto pragma =
        convertBody(inputOf("{language 'IL'}\nPROGRAM Main\nVAR i : INT; END_VAR\nLD 1\nST i\nEND_PROGRAM\n"),
                    "main.st", "Main", TextLanguage::St);
    ASSERT_TRUE(pragma) << pragma.error().english();
    EXPECT_EQ(pragma->text, "{language 'ST'}\nPROGRAM Main\nVAR i : INT; END_VAR\ni := 1;\nEND_PROGRAM\n");
}

TEST(InstructionListEditing, CompletesOperatorsOperandsLabelsAndInstances) {
    const std::string text =
        "PROGRAM Main\nVAR ready : BOOL; count : INT; pulse : TON; END_VAR\n        LD      ready\n        JMPC    "
        "done\n        CAL     pulse(IN := ready)\n        ST      ready\ndone:   RET\nEND_PROGRAM\n";
    const auto model = CodeModel::make(inputOf(text));
    const auto offered = [&](const std::string& line, const std::string& wanted) {
        std::string typed = text;
        const size_t at = typed.find("        ST      ready\n");
        typed.insert(at, line + "\n");
        const Completion found =
            model->complete(*model->fileOf("main.st"), typed, static_cast<uint32_t>(at + line.size()));
        return std::any_of(found.items.begin(), found.items.end(),
                           [&](const CompletionItem& item) { return item.text == wanted; });
    };
    EXPECT_TRUE(offered("        L", "LD"));
    EXPECT_TRUE(offered("        J", "JMPC"));
    EXPECT_TRUE(offered("again:  AN", "ANDN("));
    EXPECT_FALSE(offered("        r", "ready"));
    EXPECT_TRUE(offered("        LD r", "ready"));
    EXPECT_FALSE(offered("        LD R", "RETURN"));
    EXPECT_TRUE(offered("        JMP d", "done"));
    EXPECT_FALSE(offered("        JMP r", "ready"));
    EXPECT_TRUE(offered("        CAL p", "pulse"));
    EXPECT_FALSE(offered("        CAL r", "ready"));
    EXPECT_TRUE(offered("        IN p", "pulse"));
}

TEST(InstructionListEditing, KnowsWhereTheResultOfEachLineIs) {
    const std::string text =
        "PROGRAM Main\nVAR a, b, c : BOOL; END_VAR\nLD a\nAND( b\nOR c\n)\nST c\nLD 5\nEND_PROGRAM\n";
    const auto model = CodeModel::make(inputOf(text));
    const auto places = model->accumulators(*model->fileOf("main.st"));
    std::string lines;
    for (const AccumulatorPlace& place : places)
        lines += text.substr(place.at, text.find('\n', place.at) - place.at) + "=" + place.expression + ";";
    EXPECT_EQ(lines, "LD a=__il0;OR c=__il1;)=__il2;ST c=__il2;LD 5=5;");
}

} // namespace plc::analysis
