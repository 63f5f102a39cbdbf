#include "tests/bench/program_generator.h"

#include <algorithm>

namespace plc::bench {

namespace {

size_t countLines(const std::string& text) { return static_cast<size_t>(std::count(text.begin(), text.end(), '\n')); }

std::string commonTypes() {
    return R"(TYPE
    Mode : (Idle, Filling, Heating, Stirring, Draining, Failed) := Idle;
    Reading : STRUCT
        raw : INT;
        value : REAL;
        low, high : REAL;
        valid : BOOL;
    END_STRUCT;
    Recipe : STRUCT
        name : STRING(20) := 'standard';
        temperature : REAL := 65.0;
        duration : TIME := T#20s;
        speeds : ARRAY[1..8] OF REAL;
    END_STRUCT;
END_TYPE

VAR_GLOBAL
    plantRunning : BOOL;
    alarmCount : DINT;
    recipes : ARRAY[1..10] OF Recipe;
END_VAR

FUNCTION ScaleReading : REAL
VAR_INPUT
    raw : INT;
    low, high : REAL;
END_VAR
VAR
    share : REAL;
END_VAR
share := INT_TO_REAL(raw) / 27648.0;
IF share > 1.0 THEN
    share := 1.0;
ELSIF share < 0.0 THEN
    share := 0.0;
END_IF
ScaleReading := low + share * (high - low);
END_FUNCTION

)";
}

/// One station: its block of about 90 lines.
std::string station(size_t number) {
    const std::string n = std::to_string(number);
    const std::string k = std::to_string(number % 7 + 2);
    return "(* Station " + n + ": fills, heats, stirs and drains a vessel. *)\nFUNCTION_BLOCK Station" + n + R"(
VAR_INPUT
    start, stop : BOOL;
    level, temperature : INT;
    recipe : INT := 1;
END_VAR
VAR_OUTPUT
    mode : Mode;
    valve, heater, motor, drain : BOOL;
    done : BOOL;
    message : STRING(40);
END_VAR
VAR
    readings : ARRAY[0..7] OF Reading;
    next : INT;
    i : INT;
    fillTime, heatTime, stirTime : TON;
    batches : CTU;
    edge : R_TRIG;
    sum, mean, setpoint : REAL;
    faults : WORD;
END_VAR
edge(CLK := start);
IF edge.Q AND NOT stop THEN
    mode := Mode.Filling;
    sum := 0.0;
END_IF
next := (next + 1) MOD 8;
readings[next].raw := temperature;
readings[next].value := ScaleReading(raw := temperature, low := 0.0, high := 150.0);
readings[next].valid := readings[next].value > 1.0 AND readings[next].value < 149.0;
sum := 0.0;
FOR i := 0 TO 7 DO
    IF readings[i].valid THEN
        sum := sum + readings[i].value;
    END_IF
END_FOR
mean := sum / 8.0;
setpoint := recipes[LIMIT(1, recipe, 10)].temperature + )" +
           k + R"(.5;
fillTime(IN := mode = Mode.Filling, PT := T#)" +
           k + R"(s);
heatTime(IN := mode = Mode.Heating, PT := T#90s);
stirTime(IN := mode = Mode.Stirring, PT := recipes[1].duration);
CASE mode OF
    Mode.Idle:
        valve := FALSE;
        heater := FALSE;
        motor := FALSE;
        message := 'idle';
    Mode.Filling:
        valve := TRUE;
        IF level > 20000 THEN
            mode := Mode.Heating;
        ELSIF fillTime.Q THEN
            faults := faults OR 16#0001;
            mode := Mode.Failed;
        END_IF
        message := CONCAT('filling ', INT_TO_STRING(level / 277));
    Mode.Heating:
        valve := FALSE;
        heater := mean < setpoint;
        IF mean >= setpoint THEN
            mode := Mode.Stirring;
        ELSIF heatTime.Q THEN
            faults := faults OR 16#0002;
            mode := Mode.Failed;
        END_IF
    Mode.Stirring:
        motor := TRUE;
        heater := mean < setpoint - 2.0;
        IF stirTime.Q THEN
            mode := Mode.Draining;
        END_IF
    Mode.Draining:
        motor := FALSE;
        heater := FALSE;
        drain := level > 100;
        IF NOT drain THEN
            mode := Mode.Idle;
        END_IF
ELSE
    valve := FALSE;
    heater := FALSE;
    message := 'failed';
END_CASE
done := mode = Mode.Idle AND faults = 0;
batches(CU := done, R := stop, PV := )" +
           k + R"(0);
IF stop THEN
    mode := Mode.Idle;
    faults := 0;
ELSIF faults <> 0 THEN
    alarmCount := alarmCount + 1;
END_IF
END_FUNCTION_BLOCK

)";
}

} // namespace

std::string generateProgram(size_t lines) {
    std::string text = commonTypes();
    const size_t perStation = countLines(station(1)) + 3;
    const size_t common = countLines(text) + 20;
    const size_t stations = std::max<size_t>(1, (lines > common ? lines - common : 0) / perStation);
    std::string declarations, calls;
    for (size_t i = 1; i <= stations; ++i) {
        const std::string n = std::to_string(i);
        text += station(i);
        declarations += "    station" + n + " : Station" + n + ";\n";
        calls += "station" + n + "(start := plantRunning AND tick MOD 50 = " + std::to_string(i % 50) +
                 ", level := level, temperature := level / 2,\n    recipe := " + std::to_string(i % 10 + 1) + ");\n";
    }
    text += "PROGRAM Main\nVAR\n" + declarations +
            "    tick : DINT;\n    level : INT;\nEND_VAR\ntick := tick + 1;\nplantRunning := TRUE;\nlevel := level + "
            "100;\n" +
            "IF level > 25000 THEN\n    level := 0;\nEND_IF\n" + calls + "END_PROGRAM\n";
    return text;
}

} // namespace plc::bench
