#include "runtime/compiler/facts/sites.h"

#include "runtime/compiler/facts/walk.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace plc::facts {

using tree::Stmt;
using tree::StmtKind;

namespace {
bool isPlaced(const Stmt& stmt) { return stmt.range.file.isValid(); }

using RangeKey = std::tuple<uint32_t, uint32_t, uint32_t>;
RangeKey keyOf(const SourceRange& range) { return {range.file.value, range.begin, range.end}; }

class SiteCollector : public Walker {
public:
    struct Found {
        const Stmt* stmt;
        bool stops;
    };
    std::vector<Found> visible;
    std::vector<const Stmt*> hidden;

protected:
    void onStmt(const Stmt& stmt) override {
        const Stmt* const before = m_before; // the sibling in front
        m_before = nullptr;
        const bool isInsideItself = m_around.count(keyOf(stmt.range)) != 0;
        if (!stmt.isHidden) ++m_around[keyOf(stmt.range)];
        if (!isPlaced(stmt) || stmt.kind == StmtKind::Label) return;
        if (stmt.isHidden) {
            hidden.push_back(&stmt);
            return;
        }
        if (stmt.kind == StmtKind::Block && !standsForOne(stmt)) return;
        const bool isRepeated = before && before->range == stmt.range && !before->isHidden;
        visible.push_back({&stmt, !isRepeated && !isInsideItself});
    }
    void afterStmt(const Stmt& stmt) override {
        if (!stmt.isHidden) {
            const auto around = m_around.find(keyOf(stmt.range));
            if (--around->second == 0) m_around.erase(around);
        }
        m_before = &stmt;
    }

private:
    static bool standsForOne(const Stmt& block) {
        return std::any_of(block.body.begin(), block.body.end(),
                           [&](const Stmt* s) { return s && !s->isHidden && s->range == block.range; });
    }
    std::map<RangeKey, uint32_t> m_around; // statements that hold this one, by their text
    const Stmt* m_before = nullptr;
};
} // namespace

SiteTable::SiteTable(const tree::Program& program) : sites(1) {
    for (uint32_t f = 1; f < program.functions.size(); ++f) {
        SiteCollector collector;
        collector.walkFunction(program.functions[f]);
        std::map<RangeKey, uint32_t> byRange;
        const auto siteFor = [&](const Stmt& stmt) {
            const auto [it, isNew] = byRange.emplace(keyOf(stmt.range), static_cast<uint32_t>(sites.size()));
            if (isNew) sites.push_back({f, stmt.range});
            return it->second;
        };
        for (const SiteCollector::Found& found : collector.visible)
            m_places[found.stmt] = {siteFor(*found.stmt), found.stops};
        // Made statements belong to the text they stand for, or else to the narrowest statement around: faults in them
        // are shown there.
        for (const Stmt* stmt : collector.hidden) {
            uint32_t best = 0;
            if (const auto it = byRange.find(keyOf(stmt->range)); it != byRange.end()) {
                best = it->second;
            } else {
                for (auto around = byRange.upper_bound({stmt->range.file.value, stmt->range.begin, UINT32_MAX});
                     around != byRange.begin();) {
                    --around;
                    const auto [file, begin, end] = around->first;
                    if (file != stmt->range.file.value) break;
                    if (end < stmt->range.end) continue;
                    best = around->second; // the last to begin in front of it and hold it
                    break;
                }
            }
            m_places[stmt] = {best != 0 ? best : siteFor(*stmt), false};
        }
    }
}

SiteTable::Place SiteTable::at(const Stmt& stmt) const {
    const auto it = m_places.find(&stmt);
    return it == m_places.end() ? Place{} : it->second;
}

} // namespace plc::facts
