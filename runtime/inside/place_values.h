// What one scan computed at each place of one file's text, in one instance: the last value of each expression and how
// often each statement ran. Made from a Look once, then asked for each place that a window shows. Immutable; any
// thread.
#pragma once
#include "runtime/inside/look.h"

namespace plc::inside {

class PlaceValues {
public:
    /// `instance`: a path; empty: any. Events from `end` on do not count: a scan that stands at a breakpoint.
    PlaceValues(std::shared_ptr<const Look> look, FileId file, const std::string& instance, EventIndex end = kNone);

    struct Value {
        types::Value value; // of the last time
        uint32_t times = 0;
    };
    /// Null: an expression with exactly this text was not computed, or is a constant.
    [[nodiscard]] const Value* at(SourceRange range) const;
    [[nodiscard]] uint32_t timesExecuted(SourceRange statement) const;
    [[nodiscard]] bool isExecuted(SourceRange statement) const { return timesExecuted(statement) > 0; }
    /// Nothing of the file ran in this instance.
    [[nodiscard]] bool isEmpty() const { return m_statements.empty(); }
    [[nodiscard]] const Look& look() const { return *m_look; }
    [[nodiscard]] FileId file() const { return m_file; }

private:
    static uint64_t keyOf(SourceRange range) { return uint64_t(range.begin) << 32 | range.end; }

    std::shared_ptr<const Look> m_look;
    FileId m_file;
    std::unordered_map<uint64_t, Value> m_values;
    std::unordered_map<uint64_t, uint32_t> m_statements;
};

} // namespace plc::inside
