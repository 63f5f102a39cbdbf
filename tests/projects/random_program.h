// Small random ST programs from a seed, for properties that must hold for any program. They never fault.
#pragma once
#include <random>
#include <string>
#include <vector>

namespace plc::testing {

class RandomProgram {
public:
    explicit RandomProgram(unsigned seed) : m_dice(seed) {}

    std::string text() {
        std::string text = "FUNCTION_BLOCK Mix\nVAR_INPUT a : DINT; b : REAL; END_VAR\nVAR_OUTPUT o : DINT; r : REAL; "
                           "END_VAR\nVAR t : TON; hits : ULINT; f : R_TRIG; END_VAR\n"
                           "  t(IN := a MOD 5 > 1, PT := T#40ms); f(CLK := t.Q);\n  IF f.Q THEN hits := hits + 1; "
                           "END_IF\n  o := a + ULINT_TO_DINT(hits); r := r * 0.9 + b;\nEND_FUNCTION_BLOCK\n"
                           "VAR_GLOBAL shared : ARRAY[0..7] OF DINT; raise AT %QX0.0 : BOOL; input : INT; END_VAR\n";
        const int programs = 1 + pick(3);
        for (int p = 0; p < programs; ++p) text += program("P" + std::to_string(p));
        text += "CONFIGURATION C\nRESOURCE R ON PLC\n";
        for (int p = 0; p < programs; ++p) {
            const std::string task = "T" + std::to_string(p);
            if (p > 0 && pick(4) == 0)
                text += "TASK " + task + " (SINGLE := raise, PRIORITY := " + std::to_string(pick(3)) + ");\n";
            else
                text += "TASK " + task + " (INTERVAL := T#" + std::to_string(1 + pick(30)) +
                        "ms, PRIORITY := " + std::to_string(pick(3)) + ");\n";
            text +=
                "PROGRAM P" + std::to_string(p) + " WITH T" + std::to_string(p) + " : P" + std::to_string(p) + ";\n";
        }
        return text + "END_RESOURCE\nEND_CONFIGURATION\n";
    }

private:
    int pick(int count) { return static_cast<int>(m_dice() % static_cast<unsigned>(count)); }
    std::string integer(int depth) {
        const std::vector<std::string> leaves{"i0",
                                              "i1",
                                              "shared[n MOD 8]",
                                              "mix.o",
                                              "INT_TO_DINT(input)",
                                              std::to_string(pick(100)),
                                              "REAL_TO_DINT(r1)",
                                              "LEN(s)"};
        if (depth == 0) return leaves[static_cast<size_t>(pick(static_cast<int>(leaves.size())))];
        const char* operators[] = {" + ", " - ", " * "};
        if (pick(5) == 0) return "(" + integer(depth - 1) + " / " + std::to_string(1 + pick(9)) + ")";
        return "(" + integer(depth - 1) + operators[pick(3)] + integer(depth - 1) + ")";
    }
    std::string condition() {
        return "(" + integer(1) + (pick(2) ? " > " : " < ") + integer(1) + (pick(3) == 0 ? ") AND b0" : ")");
    }
    std::string statement(int depth) {
        switch (pick(depth > 0 ? 11 : 8)) {
        case 0:
            return "i0 := " + integer(2) + ";\n";
        case 1:
            return "i1 := " + integer(2) + ";\n";
        case 2:
            return "shared[n MOD 8] := " + integer(1) + ";\n";
        case 3:
            return "r1 := r1 * 0.5 + DINT_TO_REAL(i0 MOD 1000) / 7.0;\n";
        case 4:
            return "mix(a := " + integer(1) + ", b := r1);\n";
        case 5:
            return "raise := " + condition() + ";\n";
        case 6:
            return "s := CONCAT(LEFT(s, 5), DINT_TO_STRING(i1 MOD 100));\n";
        case 7:
            return "b0 := NOT b0;\n";
        case 8:
            return "IF " + condition() + " THEN\n" + statement(depth - 1) + "ELSE\n" + statement(depth - 1) +
                   "END_IF\n";
        case 9:
            return "FOR k := 0 TO " + std::to_string(pick(6)) + " DO\n" + statement(0) + "END_FOR\n";
        default:
            return "p := REF(shared[n MOD 8]); p^ := p^ + 1;\n";
        }
    }
    std::string program(const std::string& name) {
        std::string text = "PROGRAM " + name +
                           "\nVAR n : UDINT; i0, i1 : DINT; k : DINT; r1 : REAL; b0 : BOOL; s : STRING(12); mix : Mix; "
                           "p : REF_TO DINT; ran : ULINT; END_VAR\n"
                           "VAR_EXTERNAL shared : ARRAY[0..7] OF DINT; raise : BOOL; input : INT; END_VAR\n  n := n + "
                           "1; ran := ran + 1;\n";
        for (int i = 0; i < 4 + pick(8); ++i) text += statement(2);
        return text + "END_PROGRAM\n";
    }
    std::mt19937 m_dice;
};

} // namespace plc::testing
