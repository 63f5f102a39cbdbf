// Many random programs compiled as one project: compiling, not running, is what a random program costs, and most of
// that is the same for one program and for many. Owned by its test; one thread.
#pragma once
#include "tests/golden/random_runs.h"

#include <string>
#include <vector>

namespace plc::golden {

/// What is compared beside quick code and the expression evaluator.
enum class Depth : uint8_t { Quick, Full /* optimised code, asked at every statement, an online change */ };

struct Difference {
    uint32_t seed = 0;
    std::string what;
};

struct BatchReport {
    size_t finished = 0, faulted = 0;
    size_t dropped = 0;                   // by chance they had an error
    double quickSeconds = 0, seconds = 0; // of the processor: for quick code and evaluator, for all
    std::vector<Difference> differences;
};

/// The programs of `count` seeds, each in a file and an instance of its own.
[[nodiscard]] BatchReport runBatch(uint32_t firstSeed, uint32_t count, Faults faults, Depth depth);

} // namespace plc::golden
