#include "runtime/compiler/chart/layout.h"

#include <algorithm>
#include <unordered_set>

namespace plc::chart {

namespace {

constexpr uint32_t kNoNode = 0xffffffffu;

/// Nodes are steps, then transitions.
class LayoutBuilder {
public:
    explicit LayoutBuilder(const Chart& chart)
        : m_chart(chart), m_steps(static_cast<uint32_t>(chart.steps.size())),
          m_count(m_steps + static_cast<uint32_t>(chart.transitions.size())) {
        m_next.resize(m_count);
        for (uint32_t i = 0; i < m_steps; ++i)
            for (TransitionId t : chart.steps[i].out) m_next[i].push_back(m_steps + t.value);
        for (uint32_t i = 0; i < chart.transitions.size(); ++i)
            for (StepId s : chart.transitions[i].to) m_next[m_steps + i].push_back(s.value);
        m_placed.assign(m_count, false);
        m_isStop.assign(m_count, 0);
        m_order.assign(m_count, 0);
        m_mark.assign(m_count, 0);
        m_owner.assign(m_count, 0);
        m_layout.steps.resize(m_steps);
        m_layout.transitions.resize(chart.transitions.size());
    }

    Layout run() {
        sortForward();
        int column = 0;
        for (uint32_t n = 0; n < m_chart.networks; ++n) {
            m_layout.networkColumns.push_back(column);
            for (uint32_t root : roots(n)) {
                if (m_placed[root]) continue;
                std::vector<Exit> exits;
                const Region region = sequence(root, column, 0, exits, -1);
                column += region.width;
                m_layout.rows = std::max(m_layout.rows, region.bottom);
            }
        }
        // transitions of no known step
        for (uint32_t node = m_steps; node < m_count; ++node) {
            if (m_placed[node]) continue;
            std::vector<Exit> exits;
            const Region region = sequence(node, column, 0, exits, -1);
            column += region.width;
            m_layout.rows = std::max(m_layout.rows, region.bottom);
        }
        m_layout.columns = column;
        joinExits();
        return std::move(m_layout);
    }

private:
    struct Region {
        int width = 1;
        int bottom = 0; // first free row
    };
    struct Exit {
        uint32_t node; // the stop it leads to
        int column, row;
        uint32_t from; // what leads there
    };
    /// From a branch down to the bar that closes it.
    struct Join {
        Exit exit;
        size_t bar;
    };

    std::vector<uint32_t> roots(uint32_t network) const {
        std::vector<uint32_t> initial, heads, others;
        for (uint32_t i = 0; i < m_steps; ++i) {
            const Step& step = m_chart.steps[i];
            if (step.network != network) continue;
            (step.decl->isInitial ? initial : step.in.empty() ? heads : others).push_back(i);
        }
        initial.insert(initial.end(), heads.begin(), heads.end());
        initial.insert(initial.end(), others.begin(), others.end());
        return initial;
    }

    /// A topological order without the edges that lead back, from the roots in order of the text.
    void sortForward() {
        std::vector<uint8_t> state(m_count, 0);
        std::vector<uint32_t> finished;
        const auto visit = [&](uint32_t root) {
            std::vector<std::pair<uint32_t, size_t>> stack;
            if (state[root] != 0) return;
            stack.emplace_back(root, 0);
            state[root] = 1;
            while (!stack.empty()) {
                auto& [node, at] = stack.back();
                if (at == m_next[node].size()) {
                    state[node] = 2;
                    finished.push_back(node);
                    stack.pop_back();
                    continue;
                }
                const uint32_t next = m_next[node][at++];
                if (state[next] == 1)
                    m_back.insert(key(node, next));
                else if (state[next] == 0) {
                    state[next] = 1;
                    stack.emplace_back(next, 0);
                }
            }
        };
        for (uint32_t n = 0; n < m_chart.networks; ++n)
            for (uint32_t root : roots(n)) visit(root);
        for (uint32_t node = 0; node < m_count; ++node) visit(node);
        for (uint32_t i = 0; i < finished.size(); ++i) m_order[finished[finished.size() - 1 - i]] = i;
    }
    static uint64_t key(uint32_t from, uint32_t to) { return (static_cast<uint64_t>(from) << 32) | to; }
    bool isBack(uint32_t from, uint32_t to) const { return m_back.contains(key(from, to)); }

    /// The first node that two of the branches reach going forward.
    uint32_t meeting(const std::vector<uint32_t>& branches) {
        uint32_t best = kNoNode;
        ++m_round;
        for (uint32_t b = 0; b < branches.size(); ++b) {
            if (m_placed[branches[b]] || m_isStop[branches[b]] > 0) continue;
            std::vector<uint32_t> open{branches[b]};
            std::vector<uint32_t> seen{branches[b]};
            const auto visit = [&](uint32_t node) {
                if (m_mark[node] == m_round && m_owner[node] != b && !m_placed[node] &&
                    (best == kNoNode || m_order[node] < m_order[best]))
                    best = node;
                if (m_mark[node] == m_round && m_owner[node] == b) return false;
                const bool shared = m_mark[node] == m_round;
                m_mark[node] = m_round;
                m_owner[node] = b;
                return !shared; // what lies behind a shared node is shared too
            };
            visit(branches[b]);
            while (!open.empty()) {
                const uint32_t node = open.back();
                open.pop_back();
                for (uint32_t next : m_next[node])
                    if (!isBack(node, next) && !m_placed[next] && m_isStop[next] == 0 && visit(next))
                        open.push_back(next); // a stop closes a bar further out
            }
        }
        return best;
    }

    void line(int column, int fromRow, int toRow) {
        if (fromRow >= 0) m_layout.lines.push_back({column, fromRow, toRow});
    }

    /// Lays out from `node` downwards. `above` is the row it hangs from, -1 for none.
    Region sequence(uint32_t node, int column, int row, std::vector<Exit>& exits, int above) {
        Region region{1, row};
        for (;;) {
            if (m_placed[node]) return region;
            m_placed[node] = true;
            const Cell cell{column, row};
            (node < m_steps ? m_layout.steps[node] : m_layout.transitions[node - m_steps]) = cell;
            line(column, above, row);
            above = row++;
            region.bottom = std::max(region.bottom, row);
            const std::vector<uint32_t>& next = m_next[node];
            if (next.empty()) return region;
            if (next.size() == 1) {
                const uint32_t target = next[0];
                if (!follow(node, target, column, above, row, exits, region)) return region;
                node = target;
                continue;
            }
            const uint32_t meet = branch(node, column, above, row, exits, region);
            if (meet == kNoNode) return region;
            node = meet;
            above = row - 1; // the closing bar
        }
    }

    /// True when `target` comes directly below; else an exit, a jump or a link was noted.
    bool follow(uint32_t node, uint32_t target, int column, int above, int row, std::vector<Exit>& exits,
                Region& region) {
        if (m_isStop[target] > 0 && !isBack(node, target)) {
            exits.push_back({target, column, above, node});
            return false;
        }
        if (!m_placed[target] && !isBack(node, target)) return true;
        if (node < m_steps) {
            m_layout.links.push_back({StepId(node), TransitionId(target - m_steps)});
        } else {
            m_layout.jumps.push_back({{column, row}, TransitionId(node - m_steps), StepId(target)});
            line(column, above, row);
            region.bottom = std::max(region.bottom, row + 1);
        }
        return false;
    }

    /// The branches below `node`, side by side; the node where they meet again, when that is ours to place.
    uint32_t branch(uint32_t node, int column, int above, int& row, std::vector<Exit>& exits, Region& region) {
        if (m_depth > kMaxDepth) return kNoNode; // what is below gets columns of its own
        ++m_depth;
        const std::vector<uint32_t> next = m_next[node];
        const bool alternative = node < m_steps;
        uint32_t meet = meeting(next);
        const bool mine = meet != kNoNode && m_isStop[meet] == 0;
        if (mine) ++m_isStop[meet];
        const int barRow = row;
        line(column, above, barRow);
        std::vector<Exit> inner;
        int at = column;
        int bottom = barRow + 1;
        int lastTrunk = column;
        for (uint32_t first : next) {
            Region part{1, barRow + 1};
            lastTrunk = at;
            // a branch without anything of its own: straight to the meeting, back, or to what stands elsewhere
            if (follow(node, first, at, barRow, barRow + 1, inner, part))
                part = sequence(first, at, barRow + 1, inner, barRow);
            else if (node >= m_steps && !m_layout.jumps.empty() && m_layout.jumps.back().at == Cell{at, barRow + 1})
                part.bottom = barRow + 2;
            at += part.width;
            bottom = std::max(bottom, part.bottom);
        }
        Bar open{alternative ? BarKind::AlternativeOpen : BarKind::SimultaneousOpen,
                 barRow,
                 column,
                 lastTrunk,
                 column,
                 {},
                 {}};
        if (alternative)
            open.step = StepId(node);
        else
            open.transition = TransitionId(node - m_steps);
        m_layout.bars.push_back(open);
        --m_depth;
        region.width = std::max(region.width, at - column);
        region.bottom = std::max(region.bottom, bottom);
        if (mine) --m_isStop[meet];
        std::vector<Exit> toMeet;
        for (const Exit& exit : inner) {
            if (mine && exit.node == meet)
                toMeet.push_back(exit);
            else
                exits.push_back(exit);
        }
        if (!mine || toMeet.empty() || m_placed[meet]) return kNoNode;
        const int closeRow = bottom;
        Bar close{meet < m_steps ? BarKind::AlternativeClose : BarKind::SimultaneousClose,
                  closeRow,
                  column,
                  column,
                  column,
                  {},
                  {}};
        for (const Exit& exit : toMeet) {
            close.lastColumn = std::max(close.lastColumn, exit.column);
            m_joins.push_back({exit, m_layout.bars.size()});
        }
        if (meet < m_steps)
            close.step = StepId(meet);
        else
            close.transition = TransitionId(meet - m_steps);
        m_layout.bars.push_back(close);
        row = closeRow + 1;
        region.bottom = std::max(region.bottom, row);
        return meet;
    }

    /// What stands in a column, and the bars that cross it.
    bool isFree(int column, int fromRow, int toRow) const {
        const auto inside = [&](int row) { return row > fromRow && row < toRow; };
        const auto stands = [&](const Cell& cell) { return cell.column == column && inside(cell.row); };
        return std::none_of(m_layout.steps.begin(), m_layout.steps.end(), stands) &&
               std::none_of(m_layout.transitions.begin(), m_layout.transitions.end(), stands) &&
               std::none_of(m_layout.jumps.begin(), m_layout.jumps.end(),
                            [&](const Jump& jump) { return stands(jump.at); }) &&
               std::none_of(m_layout.bars.begin(), m_layout.bars.end(), [&](const Bar& bar) {
                   return inside(bar.row) && column >= bar.firstColumn && column <= bar.lastColumn;
               });
    }

    /// A way to a bar further out goes down its column where nothing else stands there; else it becomes a jump (or a
    /// link to a join).
    void joinExits() {
        std::vector<Exit> jumps;
        std::vector<std::vector<int>> kept(m_layout.bars.size());
        std::vector<bool> isClosing(m_layout.bars.size(), false);
        for (const Join& join : m_joins) {
            isClosing[join.bar] = true;
            const int row = m_layout.bars[join.bar].row;
            if (isFree(join.exit.column, join.exit.row, row)) {
                line(join.exit.column, join.exit.row, row);
                kept[join.bar].push_back(join.exit.column);
            } else {
                jumps.push_back(join.exit);
            }
        }
        if (jumps.empty()) return;
        for (size_t i = 0; i < m_layout.bars.size(); ++i) {
            Bar& bar = m_layout.bars[i];
            if (!isClosing[i]) continue;
            bar.firstColumn = bar.lastColumn = bar.trunk;
            for (const int column : kept[i]) {
                bar.firstColumn = std::min(bar.firstColumn, column);
                bar.lastColumn = std::max(bar.lastColumn, column);
            }
            if (kept[i].empty())
                std::erase_if(m_layout.lines,
                              [&](const Line& l) { return l.column == bar.trunk && l.fromRow == bar.row; });
        }
        size_t next = 0;
        std::erase_if(m_layout.bars, [&](const Bar&) {
            const size_t i = next++;
            return isClosing[i] && kept[i].empty();
        });
        // Each arrow gets a row of its own below what it comes from.
        std::vector<int> rows;
        for (const Exit& exit : jumps)
            if (exit.from >= m_steps) rows.push_back(exit.row);
        std::sort(rows.begin(), rows.end());
        rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
        const auto moved = [&](int row) {
            return row + static_cast<int>(std::lower_bound(rows.begin(), rows.end(), row) - rows.begin());
        };
        for (Cell& cell : m_layout.steps) cell.row = moved(cell.row);
        for (Cell& cell : m_layout.transitions) cell.row = moved(cell.row);
        for (Jump& jump : m_layout.jumps) jump.at.row = moved(jump.at.row);
        for (Bar& bar : m_layout.bars) bar.row = moved(bar.row);
        for (Line& l : m_layout.lines) l.fromRow = moved(l.fromRow), l.toRow = moved(l.toRow);
        for (const Exit& exit : jumps) {
            if (exit.from < m_steps) {
                m_layout.links.push_back({StepId(exit.from), TransitionId(exit.node - m_steps)});
                continue;
            }
            const int row = moved(exit.row) + 1;
            m_layout.jumps.push_back({{exit.column, row}, TransitionId(exit.from - m_steps), StepId(exit.node)});
            line(exit.column, row - 1, row);
        }
        m_layout.rows += static_cast<int>(rows.size());
    }

    const Chart& m_chart;
    uint32_t m_steps, m_count;
    std::vector<Join> m_joins;
    std::vector<std::vector<uint32_t>> m_next;
    std::vector<bool> m_placed;
    std::vector<int> m_isStop;
    std::vector<uint32_t> m_order;
    std::vector<uint32_t> m_mark, m_owner;
    uint32_t m_round = 0;
    static constexpr int kMaxDepth = 300;
    int m_depth = 0;
    std::unordered_set<uint64_t> m_back;
    Layout m_layout;
};

} // namespace

Layout computeLayout(const Chart& chart) { return LayoutBuilder(chart).run(); }

} // namespace plc::chart
