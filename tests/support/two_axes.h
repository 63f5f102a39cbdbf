// Two axes that move by what they are given, a sum in a loop, a branch that never runs: the program on which the tests
// of what a scan computed look. A value, any thread.
#pragma once

namespace plc::testing {

inline constexpr const char* kTwoAxes = R"(FUNCTION_BLOCK Axis
VAR_INPUT
    step : INT;
END_VAR
VAR
    pos : INT;
END_VAR
IF step > 1 THEN
    pos := pos + step;
ELSE
    pos := pos - 1;
END_IF
END_FUNCTION_BLOCK

PROGRAM Main
VAR
    a, b : Axis;
    n, i, sum : INT;
END_VAR
n := n + 1;
n := n + 10;
a(step := 1);
b(step := 2);
sum := 0;
FOR i := 1 TO 3 DO
    sum := sum + i;
END_FOR
IF n < 0 THEN
    n := 0;
END_IF
END_PROGRAM
)";

} // namespace plc::testing
