// Programs whose one scan takes longer than anybody waits, each where no loop of the user's is to blame: calls that
// double 59 times, copies of 60 MB, a slow search in a long text. Their task has an hour. Values.
#pragma once
#include <string>
#include <vector>

namespace plc {

struct LongScan {
    const char* name;
    std::string text;     // of the whole program
    std::string variable; // one of Main
};

inline const std::string kAnHourForMain =
    "CONFIGURATION C\nRESOURCE R ON Soft\nTASK T (INTERVAL := T#10ms, PRIORITY := 1, WATCHDOG := T#1h);\n"
    "PROGRAM Main WITH T : Main;\nEND_RESOURCE\nEND_CONFIGURATION\n";

inline std::vector<LongScan> longScans() {
    std::string calls = "FUNCTION F0 : INT\nVAR_INPUT q : INT; END_VAR\nF0 := q;\nEND_FUNCTION\n";
    for (int i = 1; i < 60; ++i) {
        const std::string before = "F" + std::to_string(i - 1), name = "F" + std::to_string(i);
        calls += "FUNCTION " + name + " : INT\nVAR_INPUT q : INT; END_VAR\n" + name + " := " + before + "(q) + " +
                 before + "(q + 1) MOD 7;\nEND_FUNCTION\n";
    }
    return {{"Calls", calls + "PROGRAM Main\nVAR a : INT; END_VAR\na := F59(a);\nEND_PROGRAM\n" + kAnHourForMain, "a"},
            {"Copies",
             "PROGRAM Main\nVAR a, b : ARRAY[0..60000000] OF BYTE; i : DINT; END_VAR\n"
             "FOR i := 0 TO 100000000 DO a[i MOD 1000] := b[5]; b := a; END_FOR\nEND_PROGRAM\n" +
                 kAnHourForMain,
             "i"},
            {"Search",
             "PROGRAM Main\nVAR i : LINT; k : INT; s, n : STRING(65000); END_VAR\n"
             "s := 'a'; FOR i := 1 TO 15 DO s := CONCAT(s, s); END_FOR\n"
             "n := CONCAT(LEFT(s, 16000), 'b'); FOR i := 0 TO 1000000000 DO k := FIND(s, n); END_FOR\n"
             "END_PROGRAM\n" +
                 kAnHourForMain,
             "k"}};
}

} // namespace plc
