#include "runtime/inside/scan_text.h"

#include <algorithm>
#include <set>

namespace plc::inside {

using image::WatchKind;
using tree::ExprKind;
using tree::StmtKind;

namespace {

bool isWithin(const SourceRange& range, const TextPart& part) {
    return range.file == part.file && range.begin < part.end && range.end > part.begin && range.length() > 0;
}

/// Every statement of a body and those in it.
template <class Visit> void forEachStatement(const std::vector<tree::Stmt*>& body, const Visit& visit) {
    for (const tree::Stmt* stmt : body) {
        if (!stmt) continue;
        visit(*stmt);
        forEachStatement(stmt->body, visit);
        forEachStatement(stmt->elseBody, visit);
        for (const tree::CaseArm& arm : stmt->arms) forEachStatement(arm.body, visit);
    }
}

bool isLoop(const tree::Stmt& stmt) {
    return stmt.kind == StmtKind::For || stmt.kind == StmtKind::While || stmt.kind == StmtKind::Repeat;
}

class TextReader {
public:
    TextReader(const Look& look, const TextPart& part) : m_look(look), m_part(part) {}

    ScanText read() {
        chooseActivations();
        countPasses();
        readEvents();
        readStatements();
        return std::move(m_text);
    }

private:
    /// Which runs of the functions are shown.
    void chooseActivations() {
        const auto activations = m_look.activations();
        m_shown.assign(activations.size(), true);
        std::map<uint32_t, uint32_t> last; // of functions without a chosen instance
        for (uint32_t i = 0; i < activations.size(); ++i) {
            const std::string& name = m_look.program().functions[activations[i].function].name;
            const auto chosen = m_part.instances.find(name.substr(0, name.find('.')));
            const bool hasChoice = chosen != m_part.instances.end() &&
                                   m_look.tree().functions[activations[i].function].instanceType.isValid();
            if (hasChoice)
                m_shown[i] = m_look.instanceOf(i) == chosen->second;
            else
                last[activations[i].function] = i;
        }
        for (uint32_t i = 0; i < activations.size(); ++i)
            if (const auto found = last.find(activations[i].function); found != last.end())
                m_shown[i] = found->second == i;
    }

    /// A loop that reports itself once begins to run; WHILE does with each pass.
    static bool isRestart(const Event& event) {
        return event.kind == WatchKind::Statement && isLoop(*event.stmt()) && event.stmt()->kind != StmtKind::While;
    }
    std::span<const Event> happened() const {
        return m_look.events().first(std::min<size_t>(m_part.until, m_look.events().size()));
    }

    /// The pass of each loop that is shown: as asked for, else its last one.
    void countPasses() {
        for (const Event& event : happened()) {
            if (!m_shown[event.activation]) continue;
            if (isRestart(event)) m_loops.erase(event.node); // a loop in a loop: its last run counts
            if (event.kind != WatchKind::Pass || !isWithin(event.stmt()->range, m_part)) continue;
            ScanText::Loop& loop = m_loops.try_emplace(event.node).first->second;
            loop.range = event.stmt()->range;
            ++loop.count;
        }
    }

    /// Whether the event lies in the passes that are shown: passes are counted as they are met.
    bool isInShownPass(const SourceRange& range) {
        for (const auto& [node, open] : m_open) {
            const auto asked = m_part.passes.find(open.range.begin);
            if (asked == m_part.passes.end() || !contains(node, range)) continue;
            if (open.pass != asked->second) return false;
        }
        return true;
    }
    bool contains(const void* node, const SourceRange& range) {
        const SourceRange& extent = extentOf(*static_cast<const tree::Stmt*>(node));
        return extent.file == range.file && extent.begin <= range.begin && range.end <= extent.end;
    }
    const SourceRange& extentOf(const tree::Stmt& loop) {
        const auto [known, isNew] = m_extents.try_emplace(&loop, loop.range);
        if (!isNew) return known->second;
        const auto widen = [&](const SourceRange& range) {
            if (range.file == known->second.file) known->second.end = std::max(known->second.end, range.end);
        };
        for (const auto* body : {&loop.body, &loop.elseBody})
            forEachStatement(*body, [&](const tree::Stmt& stmt) { widen(stmt.range); });
        if (loop.a) widen(loop.a->range);
        return known->second;
    }

    void readEvents() {
        for (const Event& event : happened()) {
            if (!m_shown[event.activation]) continue;
            switch (event.kind) {
            case WatchKind::Pass:
                if (isWithin(event.stmt()->range, m_part)) beginPass(event);
                break;
            case WatchKind::Statement:
                if (isRestart(event)) m_open.erase(event.node);
                m_ran.insert(event.stmt());
                break;
            case WatchKind::Value:
            case WatchKind::Text:
                readValue(event);
                break;
            case WatchKind::Write:
                readWrite(event);
                break;
            default:
                break;
            }
        }
    }

    void beginPass(const Event& event) {
        const auto [open, isNew] = m_open.try_emplace(event.node, Open{event.stmt()->range, 0});
        if (!isNew) ++open->second.pass;
    }

    void readValue(const Event& event) {
        const tree::Expr& expr = *event.expr();
        if (!isWithin(expr.range, m_part) || !isInShownPass(expr.range)) return;
        if (event.kind == WatchKind::Value) m_results[keyOf(expr.range)] = event.bits != 0;
        if (expr.kind == ExprKind::Load) put({expr.range, m_look.valueOf(event), false});
        if (m_part.results.empty()) return;
        for (const uint32_t at : {expr.range.begin, expr.range.end - 1})
            if (m_part.results.contains(at)) m_text.results[at] = m_look.valueOf(event);
    }

    void readWrite(const Event& event) {
        if (!event.node || event.stmt()->kind != StmtKind::Assign || !event.stmt()->place) return;
        const SourceRange range = event.stmt()->place->range;
        if (!isWithin(range, m_part) || !isInShownPass(range)) return;
        put({range, m_look.valueOf(event), true});
    }

    /// A place that ran again counts with its last run.
    void put(ScanText::Value value) {
        if (!value.value.hasValue()) return;
        const auto key = std::tuple(value.range.begin, value.range.end, value.isWritten);
        if (const auto known = m_byPlace.find(key); known != m_byPlace.end())
            m_text.values[known->second].value = std::move(value.value);
        else {
            m_byPlace.emplace(key, m_text.values.size());
            m_text.values.push_back(std::move(value));
        }
    }

    void readStatements() {
        for (const uint32_t f : functionsIn(m_look.tree(), m_part.file, m_part.begin, m_part.end))
            forEachStatement(m_look.tree().functions[f].body, [&](const tree::Stmt& stmt) { readStatement(stmt); });
        const auto byPlace = [](const auto& a, const auto& b) { return a.range.begin < b.range.begin; };
        for (auto& [node, loop] : m_loops) {
            const auto asked = m_part.passes.find(loop.range.begin);
            loop.pass = asked != m_part.passes.end() ? std::min(asked->second, loop.count - 1) : loop.count - 1;
            m_text.loops.push_back(loop);
        }
        std::sort(m_text.loops.begin(), m_text.loops.end(), byPlace);
        std::sort(m_text.conditions.begin(), m_text.conditions.end(), byPlace);
        std::sort(m_text.notRun.begin(), m_text.notRun.end(),
                  [](const SourceRange& a, const SourceRange& b) { return a.begin < b.begin; });
        m_text.notRun.erase(std::unique(m_text.notRun.begin(), m_text.notRun.end()), m_text.notRun.end());
    }

    void readStatement(const tree::Stmt& stmt) {
        if (!isWithin(stmt.range, m_part) || stmt.kind == StmtKind::Block || stmt.kind == StmtKind::Label) return;
        if (!m_ran.contains(&stmt)) {
            if (!stmt.isHidden) didNotRun(stmt.range);
            return;
        }
        didRun(stmt.range);
        const bool decides = stmt.kind == StmtKind::If || stmt.kind == StmtKind::While || stmt.kind == StmtKind::Repeat;
        if (!decides || !stmt.a) return;
        if (const auto result = m_results.find(keyOf(stmt.a->range)); result != m_results.end())
            m_text.conditions.push_back({stmt.a->range, result->second});
    }
    /// One text may be several statements (the call of a block): it ran when one of them did.
    void didNotRun(const SourceRange& range) {
        if (!m_ranTexts.contains(keyOf(range))) m_text.notRun.push_back(range);
    }
    void didRun(const SourceRange& range) {
        m_ranTexts.insert(keyOf(range));
        std::erase(m_text.notRun, range);
    }
    static std::pair<uint32_t, uint32_t> keyOf(const SourceRange& range) { return {range.begin, range.end}; }

    struct Open {
        SourceRange range;
        uint64_t pass = 0;
    };
    const Look& m_look;
    const TextPart& m_part;
    ScanText m_text;
    std::vector<bool> m_shown; // by activation
    std::map<const void*, ScanText::Loop> m_loops;
    std::map<const void*, Open> m_open; // the pass that each loop is in
    std::map<const tree::Stmt*, SourceRange> m_extents;
    std::map<std::tuple<uint32_t, uint32_t, bool>, size_t> m_byPlace;
    std::map<std::pair<uint32_t, uint32_t>, bool> m_results;
    std::set<std::pair<uint32_t, uint32_t>> m_ranTexts;
    std::set<const tree::Stmt*> m_ran;
};

} // namespace

ScanText textOf(const Look& look, const TextPart& part) { return TextReader(look, part).read(); }

std::vector<uint32_t> functionsIn(const tree::Program& tree, FileId file, uint32_t begin, uint32_t end) {
    std::vector<uint32_t> all;
    for (uint32_t f = 1; f < tree.functions.size(); ++f) {
        bool lies = false;
        forEachStatement(tree.functions[f].body, [&](const tree::Stmt& stmt) {
            lies = lies || (stmt.range.file == file && stmt.range.begin < end && stmt.range.end > begin);
        });
        if (lies) all.push_back(f);
    }
    return all;
}

} // namespace plc::inside
