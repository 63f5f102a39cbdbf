// A small chart that stays in its first step until `go` is TRUE: what a scan runs of it, and what it does not. Shared
// by the tests of exact values and of coverage.
#pragma once

namespace plc::app {

inline const char* const kIdleChart = R"(PROGRAM Main
VAR
    go : BOOL;
    n, made : INT;
END_VAR
INITIAL_STEP Idle:
    Count(N);
END_STEP
STEP Work:
    Produce(N);
END_STEP
TRANSITION FROM Idle TO Work := go; END_TRANSITION
TRANSITION FROM Work TO Idle := NOT go; END_TRANSITION
ACTION Count:
    n := n + 1;
END_ACTION
ACTION Produce:
    made := made + 1;
END_ACTION
END_PROGRAM
)";

} // namespace plc::app
