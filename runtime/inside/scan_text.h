// What one scan did in a part of the text: each value that was read or written at its place, the conditions with their
// results, the statements that did not run, the passes of the loops. Made of a Look; values, any thread.
#pragma once
#include "runtime/inside/look.h"

#include <map>
#include <set>

namespace plc::inside {

/// What is asked: a part of a file, as it ran on these instances.
struct TextPart {
    FileId file;
    uint32_t begin = 0, end = 0;
    /// The instance whose run is shown, by function ("Motor" → "Main.pump"); for others their last run.
    std::map<std::string, std::string> instances;
    /// The pass that is shown, by the start of the loop's text; for others the last one.
    std::map<uint32_t, uint64_t> passes;
    /// Where instructions of a list begin, or their parentheses end: what they came to is asked for.
    std::set<uint32_t> results;
    /// What came before this event is all that has happened (the scan is walked through).
    EventIndex until = kNone;
};

struct ScanText {
    struct Value {
        SourceRange range; // of the variable in the text
        types::Value value;
        bool isWritten = false; // by the statement there
        bool operator==(const Value&) const = default;
    };
    struct Condition {
        SourceRange range; // of IF, ELSIF, WHILE, UNTIL
        bool isTrue = false;
        bool operator==(const Condition&) const = default;
    };
    struct Loop {
        SourceRange range;
        uint64_t pass = 0, count = 0; // the one that is shown, from 0; how many there were
        bool operator==(const Loop&) const = default;
    };
    std::vector<Value> values;                // in order of time; a place that ran again counts with its last run
    std::vector<Condition> conditions;        // by place
    std::vector<SourceRange> notRun;          // statements that did not run, by place
    std::vector<Loop> loops;                  // by place
    std::map<uint32_t, types::Value> results; // as asked for
    bool operator==(const ScanText&) const = default;
};

[[nodiscard]] ScanText textOf(const Look& look, const TextPart& part);

/// The functions whose statements lie in a part of a file: to be watched.
[[nodiscard]] std::vector<uint32_t> functionsIn(const tree::Program& tree, FileId file, uint32_t begin, uint32_t end);

} // namespace plc::inside
