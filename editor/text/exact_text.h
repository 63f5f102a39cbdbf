// What a recorded scan did in the text of an editor: the values at their places, the conditions, what did not run, the
// passes of loops. Offsets are of the text that the scan's program was built from. Values.
#pragma once
#include <QString>

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace plc::editor {

struct ExactText {
    struct Value {
        uint32_t begin = 0, end = 0; // of the variable
        QString text;
        bool isBool = false, isTrue = false;
        bool operator==(const Value&) const = default;
    };
    struct Condition {
        uint32_t begin = 0, end = 0;
        bool isTrue = false;
        bool operator==(const Condition&) const = default;
    };
    struct Loop {
        uint32_t begin = 0;
        uint64_t pass = 0, count = 0; // shown, from 0; how many there were
        bool operator==(const Loop&) const = default;
    };
    std::vector<Value> values; // in order of time
    std::vector<Condition> conditions;
    std::vector<std::pair<uint32_t, uint32_t>> notRun;
    std::vector<Loop> loops;
    std::map<uint32_t, Value> results; // of instructions of a list, by AccumulatorPlace::at
    bool operator==(const ExactText&) const = default;
};

/// What tests or a recording have covered of a line.
struct LineCoverage {
    enum class State : uint8_t { Run, Partly, NotRun };
    State state = State::Run;
    QString text; // what is missing, or how often it ran
    bool operator==(const LineCoverage&) const = default;
};

} // namespace plc::editor
