#include "runtime/inside/place_values.h"

#include <algorithm>

namespace plc::inside {

using image::WatchKind;

namespace {

struct Last {
    EventIndex event = kNone;
    uint32_t times = 0;
};

} // namespace

PlaceValues::PlaceValues(std::shared_ptr<const Look> look, FileId file, const std::string& instance, EventIndex end)
    : m_look(std::move(look)), m_file(file) {
    const std::span<const Event> events = m_look->events();
    const std::vector<bool> counts = m_look->activationsIn(instance);
    std::unordered_map<uint64_t, Last> last;
    for (EventIndex i = 0; i < std::min<size_t>(end, events.size()); ++i) {
        const Event& event = events[i];
        if (event.activation >= counts.size() || !counts[event.activation]) continue;
        if (event.kind == WatchKind::Statement) {
            if (event.stmt()->range.file == file) ++m_statements[keyOf(event.stmt()->range)];
            continue;
        }
        if (event.kind != WatchKind::Value && event.kind != WatchKind::Text && event.kind != WatchKind::Bytes) continue;
        const tree::Expr& expr = *event.expr();
        if (!(expr.range.file == file)) continue;
        Last& known = last[keyOf(expr.range)];
        // A conversion that the compiler made has the text of what it converts: that one is meant.
        const bool isSame = known.event != kNone && expr.kind == tree::ExprKind::Convert &&
                            events[known.event].activation == event.activation &&
                            events[known.event].passes == event.passes;
        if (isSame) continue;
        known.event = i;
        ++known.times;
    }
    m_values.reserve(last.size());
    for (const auto& [key, found] : last)
        m_values.emplace(key, Value{m_look->valueOf(events[found.event]), found.times});
}

const PlaceValues::Value* PlaceValues::at(SourceRange range) const {
    const auto found = m_values.find(keyOf(range));
    return found == m_values.end() ? nullptr : &found->second;
}

uint32_t PlaceValues::timesExecuted(SourceRange statement) const {
    const auto found = m_statements.find(keyOf(statement));
    return found == m_statements.end() ? 0 : found->second;
}

} // namespace plc::inside
