// Random edits of random programs: undo gives the first text back, what was not touched keeps its bytes, the text read
// again draws the same, and the program does what the edit said (beside a reference that edits values, not text).
#include "model.h"
#include "opened.h"
#include "runtime/compiler/ladder/edits.h"
#include "runtime/compiler/ladder/layout.h"
#include "tests/support/repeats.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>
#include <random>

namespace plc::ladder {
namespace {

class Generator {
public:
    explicit Generator(unsigned seed) : m_random(seed) {}
    size_t below(size_t count) { return m_random() % count; }
    bool chance(unsigned percent) { return m_random() % 100 < percent; }

    std::string input() { return std::string(1, static_cast<char>('a' + below(4))); }
    std::string output() { return std::string(1, static_cast<char>('x' + below(3))); }

    std::string expression(int depth) {
        if (depth == 0 || chance(30)) {
            if (chance(12)) return "i > " + std::to_string(below(3));
            if (chance(8)) return output();
            return (chance(30) ? "NOT " : "") + (chance(8) ? "(" + input() + ")" : input());
        }
        const bool isOr = chance(45);
        std::string out;
        for (size_t i = 0, count = 2 + below(2); i < count; ++i) {
            std::string part = expression(depth - 1);
            const bool wraps = part.find(isOr ? "\x01" : " OR ") != std::string::npos || chance(10);
            out += (out.empty()  ? ""
                    : isOr       ? " OR "
                    : chance(10) ? "\n        AND "
                                 : " AND ") +
                   (wraps ? "(" + part + ")" : part);
        }
        return chance(8) ? "NOT (" + out + ")" : out;
    }

    std::string statement() {
        const std::string y = output(), e = expression(2);
        switch (below(10)) {
        case 0:
            return y + " S= " + e + ";";
        case 1:
            return y + " R= " + e + ";";
        case 2:
            return y + " := NOT (" + e + ");";
        case 3:
            return "IF " + e + " THEN " + y + " := " + (chance(50) ? "TRUE" : "FALSE") + "; END_IF";
        case 4:
            return "T1(IN := " + e + ");\n    " + y + " := T1.Q" + (chance(50) ? " AND " + input() : "") + ";";
        case 5: {
            const std::string shared = input() + " AND " + expression(1);
            if (shared.find(" OR ") != std::string::npos) return y + " := TRUE;";
            return y + " := " + shared + ";\n    " + output() + " := " + shared + " AND " + input() + ";";
        }
        default:
            return y + (chance(15) ? " (* to *) := " : " := ") + e + ";";
        }
    }

    std::string file() {
        std::string out;
        for (size_t i = 0, count = 1 + below(5); i < count; ++i) {
            if (chance(40)) out += "    // rung " + std::to_string(i) + "\n";
            out += "    " + statement() + (chance(25) ? " // behind" : "") + "\n";
            if (chance(60)) out += "\n";
        }
        return "PROGRAM Main\nVAR\n    a, b, c, d, e, x, y, z : BOOL; i : INT; T1 : TON;\nEND_VAR\n" + out +
               "END_PROGRAM\n";
    }

private:
    std::mt19937 m_random;
};

struct Edited {
    Result<Edits> edits = Edits{};
    std::string what;
    std::vector<Reference::Step> expected;
};

/// Terms between AND and OR in order of the text: how the n-th contact is found in another statement.
void terms(const syntax::Expr& expr, std::vector<const syntax::Expr*>& out) {
    const bool chain =
        expr.kind == syntax::ExprKind::Binary && (expr.op == lex::TokenKind::And || expr.op == lex::TokenKind::Or);
    const bool inverted = expr.kind == syntax::ExprKind::Unary && expr.base->kind == syntax::ExprKind::Binary &&
                          (expr.base->op == lex::TokenKind::And || expr.base->op == lex::TokenKind::Or);
    if (inverted) {
        out.push_back(&expr); // where it is a contact with its text
        return terms(*expr.base, out);
    }
    if (!chain) {
        out.push_back(&expr);
        return;
    }
    terms(*expr.base, out);
    terms(*expr.right, out);
}

const syntax::Expr* asked(const syntax::Stmt& stmt) {
    if (stmt.kind == syntax::StmtKind::If) return stmt.branches[0].condition;
    const syntax::Expr* value = stmt.value;
    const bool negated = stmt.op == lex::TokenKind::Assign && value->kind == syntax::ExprKind::Unary &&
                         value->base->parenthesised && !value->parenthesised;
    return negated ? value->base : value;
}

class Trial {
public:
    Trial(const std::string& text, Generator& random) : m_opened(text), m_random(random), m_reference(m_opened.text) {}

    const Opened& opened() const { return m_opened; }

    Edited edit() {
        const Diagram& diagram = m_opened.diagram;
        if (diagram.rungs.empty()) return {};
        const RungId rung(m_random.below(diagram.rungs.size()));
        Edited out;
        for (const syntax::Stmt* stmt : m_opened.unit.body->statements)
            out.expected.push_back(m_reference.stepOf(*stmt));
        switch (m_random.below(10)) {
        case 0:
        case 1:
            return onContact(rung, std::move(out));
        case 2:
            return onContact(rung, std::move(out));
        case 3:
            return coil(rung, std::move(out));
        case 4:
            return addCoil(rung, std::move(out));
        case 5:
            return insertRung(rung, std::move(out));
        case 6:
            return removeRung(rung, std::move(out));
        case 7:
            return moveRung(rung, std::move(out));
        case 8:
            return moveContact(rung, std::move(out));
        default:
            out.what = "comment";
            out.edits = editor().setComment(rung, m_random.chance(30) ? "" : "two\nlines");
            return out;
        }
    }

private:
    LadderEditor editor() const {
        return {m_opened.text, *m_opened.file, m_opened.unit, m_opened.diagram, *m_opened.types};
    }
    const Rung& at(RungId id) const { return m_opened.diagram[id]; }

    /// The same contact in every statement that shares it.
    std::vector<const syntax::Expr*> shared(const Rung& rung, NodeId id) const {
        const syntax::Expr* expr = m_opened.diagram[id].expr;
        std::vector<const syntax::Expr*> out{expr};
        Rung before;
        before.power = rung.power;
        const std::vector<NodeId> nodes = m_opened.diagram.nodesOf(before);
        if (rung.branches.size() < 2 || std::find(nodes.begin(), nodes.end(), id) == nodes.end()) return out;
        std::vector<const syntax::Stmt*> statements;
        for (const syntax::Stmt* stmt : rung.statements)
            if (stmt->kind != syntax::StmtKind::Call) statements.push_back(stmt);
        std::vector<const syntax::Expr*> own;
        terms(*asked(*statements[0]), own);
        const auto index = std::find(own.begin(), own.end(), expr) - own.begin();
        for (size_t i = 1; i < statements.size(); ++i) {
            std::vector<const syntax::Expr*> others;
            terms(*asked(*statements[i]), others);
            if (index < static_cast<std::ptrdiff_t>(others.size())) out.push_back(others[static_cast<size_t>(index)]);
        }
        return out;
    }

    Edited onContact(RungId rungId, Edited out) {
        std::vector<NodeId> contacts;
        for (const NodeId id : m_opened.diagram.nodesOf(at(rungId))) {
            const NodeKind kind = m_opened.diagram[id].kind;
            if (kind == NodeKind::Contact || kind == NodeKind::Compare) contacts.push_back(id);
        }
        if (contacts.empty()) return {};
        const NodeId id = contacts[m_random.below(contacts.size())];
        const Node& node = m_opened.diagram[id];
        const auto same = shared(at(rungId), id);
        const std::string name = m_random.chance(50) ? "e" : "NOT e";
        const bool isNegated = name != "e";
        const auto other = [isNegated](const State& state) { return (state.at("e") != 0) != isNegated; };
        std::function<int(int, const State&)> change;
        switch (m_random.below(4)) {
        case 0:
            out.what = "series beside " + node.label;
            out.edits = editor().insertContact(id, m_random.chance(50) ? Place::Before : Place::After, name);
            change = [other](int v, const State& s) { return v && other(s); };
            break;
        case 1:
            out.what = "parallel with " + node.label;
            out.edits = editor().insertParallel(id, name);
            change = [other](int v, const State& s) { return v || other(s); };
            break;
        case 2:
            out.what = "negate " + node.label;
            out.edits = editor().negate(id);
            change = [](int v, const State&) { return !v; };
            break;
        default: {
            out.what = "operand of " + node.label;
            const bool both = m_random.chance(30);
            out.edits = editor().setOperand(id, both ? "e OR d" : "e");
            const bool keepsNot = node.negated;
            change = [both, keepsNot](int, const State& s) {
                const bool v = s.at("e") || (both && s.at("d"));
                return keepsNot ? !v : v;
            };
        }
        }
        for (const syntax::Expr* expr : same) m_reference.changes[expr] = change;
        return out;
    }

    /// What is taken out of a series was TRUE there, out of a parallel FALSE; where it comes it decides with the other.
    Edited moveContact(RungId from, Edited out) {
        const auto contactsOf = [&](RungId rung) {
            std::vector<NodeId> all;
            for (const NodeId id : m_opened.diagram.nodesOf(at(rung))) {
                const NodeKind kind = m_opened.diagram[id].kind;
                if (kind == NodeKind::Contact || kind == NodeKind::Compare) all.push_back(id);
            }
            return all;
        };
        const RungId to(m_random.below(m_opened.diagram.rungs.size()));
        const std::vector<NodeId> mine = contactsOf(from), others = contactsOf(to);
        if (mine.empty() || others.empty()) return {};
        const NodeId id = mine[m_random.below(mine.size())], beside = others[m_random.below(others.size())];
        if (id == beside) return {};
        const Node& node = m_opened.diagram[id];
        out.what = "move " + node.label + " beside " + m_opened.diagram[beside].label;
        out.edits = editor().moveContact(id, beside, m_random.chance(50) ? Place::Before : Place::After);
        bool isParallel = false;
        for (const Node& parent : m_opened.diagram.nodes)
            isParallel |= parent.kind == NodeKind::Parallel &&
                          std::find(parent.children.begin(), parent.children.end(), id) != parent.children.end();
        for (const syntax::Expr* expr : shared(at(from), id))
            m_reference.changes[expr] = [isParallel](int, const State&) { return isParallel ? 0 : 1; };
        const auto plain = std::make_shared<Reference>(m_opened.text);
        const auto moved = [plain, expr = node.expr](int v, const State& state) {
            return v && plain->value(*expr, state) ? 1 : 0;
        };
        for (const syntax::Expr* expr : shared(at(to), beside)) m_reference.changes[expr] = moved;
        return out;
    }

    Edited coil(RungId rungId, Edited out) {
        const Rung& rung = at(rungId);
        if (rung.branches.empty()) return {};
        const NodeId id = rung.branches[m_random.below(rung.branches.size())].output;
        const Node& node = m_opened.diagram[id];
        if (node.kind != NodeKind::Coil) return {};
        const auto kind = static_cast<CoilKind>(m_random.below(4));
        out.what = "coil " + node.label + " " + std::to_string(static_cast<int>(kind));
        out.edits = editor().setCoil(id, kind);
        if (!out.edits) return out;
        if (!node.isConditional) {
            m_reference.coils[node.stmt] = kind;
            return out;
        }
        const bool set = kind == CoilKind::Set, reset = kind == CoilKind::Reset;
        for (size_t i = 0; i < m_opened.unit.body->statements.size(); ++i) {
            const syntax::Stmt* stmt = m_opened.unit.body->statements[i];
            if (stmt->kind != syntax::StmtKind::If || stmt->branches[0].body[0] != node.stmt) continue;
            const std::string target = node.label;
            out.expected[i] = [this, stmt, target, set, reset, kind](State& state) {
                const int power = m_reference.value(*stmt->branches[0].condition, state);
                if (set || reset) {
                    if (power) state[target] = set;
                } else {
                    state[target] = kind == CoilKind::Normal ? power : !power;
                }
            };
        }
        return out;
    }

    size_t indexOf(const syntax::Stmt* stmt) const {
        const auto& all = m_opened.unit.body->statements;
        return static_cast<size_t>(std::find(all.begin(), all.end(), stmt) - all.begin());
    }

    Edited addCoil(RungId rungId, Edited out) {
        const Rung& rung = at(rungId);
        if (rung.kind != RungKind::Logic) return {};
        out.what = "add coil";
        out.edits = editor().addCoil(rungId, "e");
        // It gets the power that the first output had, before anything of the rung was written.
        const syntax::Stmt* first = nullptr;
        for (const syntax::Stmt* stmt : rung.statements)
            if (!first && stmt->kind != syntax::StmtKind::Call) first = stmt;
        if (!first) return {};
        const std::vector<NodeId> children =
            rung.power.isValid() && m_opened.diagram[rung.power].kind == NodeKind::Series
                ? m_opened.diagram[rung.power].children
                : std::vector<NodeId>{};
        if (rung.branches.size() > 1 && rung.branches[0].tail.isValid()) return {}; // only part of its contacts
        auto power = std::make_shared<int>(0);
        const size_t at = indexOf(first), last = indexOf(rung.statements.back());
        const Reference::Step plain = out.expected[at];
        out.expected[at] = [this, first, power, plain](State& state) {
            *power = m_reference.value(*asked(*first), state);
            plain(state);
        };
        out.expected.insert(out.expected.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                            [power](State& state) { state["e"] = *power; });
        return out;
    }

    Edited insertRung(RungId rungId, Edited out) {
        const bool before = m_random.chance(50);
        out.what = "insert rung";
        out.edits = editor().insertRung(rungId, before ? Place::Before : Place::After, "e := x AND NOT b;");
        const Rung& rung = at(rungId);
        if (rung.statements.empty()) return {};
        const size_t index = before ? indexOf(rung.statements.front()) : indexOf(rung.statements.back()) + 1;
        out.expected.insert(out.expected.begin() + static_cast<std::ptrdiff_t>(index),
                            [](State& state) { state["e"] = state["x"] && !state["b"]; });
        return out;
    }

    Edited removeRung(RungId rungId, Edited out) {
        const Rung& rung = at(rungId);
        if (rung.statements.empty()) return {};
        out.what = "remove rung";
        out.edits = editor().removeRung(rungId);
        const auto from = out.expected.begin() + static_cast<std::ptrdiff_t>(indexOf(rung.statements.front()));
        out.expected.erase(from, from + static_cast<std::ptrdiff_t>(rung.statements.size()));
        return out;
    }

    Edited moveRung(RungId rungId, Edited out) {
        const RungId anchor(m_random.below(m_opened.diagram.rungs.size()));
        const bool before = m_random.chance(50);
        const Rung &rung = at(rungId), &other = at(anchor);
        if (rung.statements.empty() || other.statements.empty() || rungId == anchor) return {};
        out.what = "move rung";
        out.edits = editor().moveRung(rungId, before ? Place::Before : Place::After, anchor);
        const size_t from = indexOf(rung.statements.front()), count = rung.statements.size();
        size_t to = before ? indexOf(other.statements.front()) : indexOf(other.statements.back()) + 1;
        std::vector<Reference::Step> moved(out.expected.begin() + static_cast<std::ptrdiff_t>(from),
                                           out.expected.begin() + static_cast<std::ptrdiff_t>(from + count));
        if (to > from) to -= count;
        out.expected.erase(out.expected.begin() + static_cast<std::ptrdiff_t>(from),
                           out.expected.begin() + static_cast<std::ptrdiff_t>(from + count));
        out.expected.insert(out.expected.begin() + static_cast<std::ptrdiff_t>(to), moved.begin(), moved.end());
        return out;
    }

    Opened m_opened;
    Generator& m_random;
    Reference m_reference;
};

State randomState(Generator& random) {
    State state{{"i", static_cast<int>(random.below(4))}, {"t1.q", 0}};
    for (const char* name : {"a", "b", "c", "d", "e", "x", "y", "z"}) state[name] = static_cast<int>(random.below(2));
    return state;
}

/// Lines that no replacement reaches into are in both texts, as they were and in their order.
bool keepsOtherLines(const std::string& before, const std::string& after, const Edits& edits) {
    size_t at = 0;
    for (size_t begin = 0; begin < before.size();) {
        const size_t end = std::min(before.find('\n', begin), before.size() - 1) + 1;
        const bool touched = std::any_of(edits.begin(), edits.end(), [&](const TextEdit& edit) {
            return edit.range.begin <= end && edit.range.end >= begin;
        });
        if (!touched) {
            const size_t found = after.find(before.substr(begin, end - begin), at);
            if (found == std::string::npos) return false;
            at = found;
        }
        begin = end;
    }
    return true;
}

TEST(LadderEdits, TenThousandRandomOnesMeanWhatTheySay) {
    const char* given = std::getenv("STEPWISE_SEED");
    const unsigned seed = given ? static_cast<unsigned>(std::strtoul(given, nullptr, 10)) : 20251122u;
    std::printf("seed %u (STEPWISE_SEED sets another)\n", seed);
    Generator random(seed);
    int done = 0, refused = 0;
    std::map<std::string, int> refusals;
    while (done < repeats(10000) && !::testing::Test::HasFailure()) {
        std::string text = random.file();
        for (int step = 0; step < 8 && done < repeats(10000); ++step) {
            Trial trial(text, random);
            ASSERT_EQ(trial.opened().errors, "") << text;
            Edited edited = trial.edit();
            if (edited.what.empty()) continue;
            if (!edited.edits) {
                ++refused;
                ++refusals[edited.edits.error().message.english()];
                ASSERT_FALSE(edited.edits.error().message.isEmpty());
                continue;
            }
            ++done;
            const std::string next = applyEdits(text, *edited.edits);
            ASSERT_EQ(applyEdits(next, inverseOf(text, *edited.edits)), text);
            ASSERT_TRUE(keepsOtherLines(text, next, *edited.edits)) << edited.what << "\n" << text << "---\n" << next;
            const Opened again(next);
            ASSERT_EQ(again.errors, "") << edited.what << "\n" << text << "---\n" << next;
            ASSERT_EQ(again.words(), Opened(next).words());
            ASSERT_EQ(again.diagram.share.text, 0u) << edited.what << "\n" << next;
            ASSERT_EQ(computeLayout(again.diagram).rungs.size(), again.diagram.rungs.size());
            Reference reference(again.text);
            for (int run = 0; run < 12; ++run) {
                const State begin = randomState(random);
                State expected = begin, found = begin;
                for (const Reference::Step& each : edited.expected) each(expected);
                for (const syntax::Stmt* stmt : again.unit.body->statements) reference.run(*stmt, found);
                ASSERT_EQ(found, expected) << edited.what << "\n" << text << "---\n" << next;
            }
            text = next;
        }
    }
    std::printf("%d edits, %d refused\n", done, refused);
    for (const auto& [message, count] : refusals) std::printf("  %d: %s\n", count, message.c_str());
    EXPECT_EQ(done, repeats(10000));
    EXPECT_LT(refused, done / 4);
}

} // namespace
} // namespace plc::ladder
