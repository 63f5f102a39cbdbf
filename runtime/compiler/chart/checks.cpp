#include "runtime/compiler/chart/chart.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <deque>
#include <map>
#include <set>
#include <unordered_set>

namespace plc::chart {

using diagnostics::Sink;
using syntax::Expr;
using syntax::ExprKind;

namespace {

/// Names: each step once, and only steps that exist between FROM and TO.
///   ok:    STEP a … STEP b …  TRANSITION FROM a TO b
///   wrong: STEP a … STEP a …  (P4011)    TRANSITION FROM a TO c  (P4003)
void checkNames(const Chart& chart, Sink& sink) {
    std::map<std::string, const syntax::StepDecl*> first;
    std::vector<std::string> names;
    for (const Step& step : chart.steps) {
        if (!step.decl->name.isValid()) continue;
        const auto [it, isNew] = first.emplace(foldCase(step.decl->name.text), step.decl);
        if (!isNew) {
            auto& d = sink.emit(step.decl->name.range, findings::DuplicateStep(step.decl->name.text));
            d.related.push_back({it->second->name.range, notes::FirstDeclaredHere()});
        }
        names.emplace_back(step.decl->name.text);
    }
    for (const Transition& transition : chart.transitions)
        for (const auto* list : {&transition.decl->from, &transition.decl->to})
            for (const syntax::Name& name : *list) {
                if (!name.isValid() || first.contains(foldCase(name.text))) continue;
                auto& d = sink.emit(name.range, findings::UnknownStep(name.text));
                if (const auto near = nearestName(name.text, names))
                    d.fixes.push_back({fixes::Write(*near), {{name.range, *near}}});
            }
}

/// Each network begins in exactly one step (2.6.2).
///   ok:    INITIAL_STEP a … STEP b …
///   wrong: STEP a … STEP b …  (P4001)   INITIAL_STEP a … INITIAL_STEP b … in one network (P4002)
void checkInitialSteps(const Chart& chart, Sink& sink) {
    std::vector<const syntax::StepDecl*> initial(chart.networks, nullptr);
    std::vector<const syntax::StepDecl*> any(chart.networks, nullptr);
    std::vector<bool> connected(chart.networks, false);
    std::vector<StepId> firstOf(chart.networks);
    for (const Step& step : chart.steps) {
        if (!any[step.network]) {
            any[step.network] = step.decl;
            firstOf[step.network] = StepId(static_cast<size_t>(&step - chart.steps.data()));
        }
        if (!step.in.empty() || !step.out.empty()) connected[step.network] = true;
        if (!step.decl->isInitial) continue;
        const syntax::StepDecl*& have = initial[step.network];
        if (!have) {
            have = step.decl;
            continue;
        }
        auto& d =
            sink.emit(step.decl->name.range, findings::SeveralInitialSteps(have->name.text, step.decl->name.text));
        d.related.push_back({have->name.range, notes::TheFirstOne()});
    }
    for (uint32_t n = 0; n < chart.networks; ++n) {
        if (initial[n]) continue;
        if (connected[n] || chart.networks == 1) {
            auto& d = sink.emit(any[n]->name.range, findings::NoInitialStep());
            const SourceRange word{any[n]->range.file, any[n]->range.begin, any[n]->range.begin + 4};
            d.fixes.push_back({fixes::MakeInitial(any[n]->name.text), {{word, "INITIAL_STEP"}}});
        } else {
            if (chart.find(any[n]->name.text) == firstOf[n])
                sink.emit(any[n]->name.range, findings::UnreachableStep(any[n]->name.text));
        }
    }
}

bool isTrue(const Expr* e) {
    if (!e) return false;
    if (e->kind == ExprKind::Literal)
        return e->op == lex::TokenKind::True || (e->op == lex::TokenKind::IntegerLiteral && e->text == "1");
    if (e->kind == ExprKind::Unary && e->op == lex::TokenKind::Not)
        return e->base->kind == ExprKind::Literal &&
               (e->base->op == lex::TokenKind::False ||
                (e->base->op == lex::TokenKind::IntegerLiteral && e->base->text == "0"));
    return false;
}

/// A transition that is always true lasts one scan: seldom meant.
///   ok:    TRANSITION FROM a TO b := ready;      wrong: TRANSITION FROM a TO b := TRUE;  (P4007)
void checkConditions(const Chart& chart, Sink& sink) {
    for (const Transition& transition : chart.transitions) {
        if (!isTrue(transition.decl->condition)) continue;
        // behind a step that waits by its time it is meant
        const bool waits = std::any_of(transition.from.begin(), transition.from.end(), [&](StepId id) {
            return std::any_of(chart[id].decl->pragmas.begin(), chart[id].decl->pragmas.end(),
                               [](const syntax::Pragma& p) { return equalsIgnoringCase(p.key, "minTime"); });
        });
        if (!waits) sink.emit(transition.decl->condition->range, findings::AlwaysTrueTransition());
    }
}

/// Qualifiers of table 45, with a time where they need one.
///   ok:    a(N); b(D, T#2s);      wrong: a(X);  (P4009)   b(D);  (P4008)
void checkQualifiers(const Chart& chart, Sink& sink) {
    for (const Step& step : chart.steps)
        for (const syntax::ActionAssociation& a : step.decl->actions) {
            const std::string q = foldCase(a.qualifier.text);
            const bool timed = q == "l" || q == "d" || q == "sd" || q == "ds" || q == "sl";
            const bool known =
                timed || q.empty() || q == "n" || q == "r" || q == "s" || q == "p" || q == "p0" || q == "p1";
            if (!known)
                sink.emit(a.qualifier.range, findings::UnknownQualifier(a.qualifier.text));
            else if (timed && !a.time)
                sink.emit(a.qualifier.range, findings::QualifierNeedsTime(a.qualifier.text));
        }
}

/// The same action twice in a step: the second adds nothing.
///   ok:    a(P1); a(P0);      wrong: a(N); a;  (P4016)
void checkDoubles(const Chart& chart, Sink& sink) {
    for (const Step& step : chart.steps) {
        std::map<std::string, const syntax::ActionAssociation*> first;
        for (const syntax::ActionAssociation& a : step.decl->actions) {
            if (!a.action.isValid()) continue;
            const std::string qualifier = a.qualifier.isValid() ? std::string(a.qualifier.text) : "N";
            const auto [it, isNew] = first.emplace(foldCase(a.action.text) + " " + foldCase(qualifier), &a);
            if (isNew) continue;
            auto& d = sink.emit(a.range, findings::AssociatedTwice(a.action.text, qualifier));
            d.related.push_back({it->second->range, notes::TheFirstOne()});
        }
    }
}

/// A step that is never left: the end of the chart, or a forgotten transition.
///   ok:    STEP a … TRANSITION FROM a TO b …      advice: STEP a … and no FROM a  (P4015)
void checkFinalSteps(const Chart& chart, Sink& sink) {
    for (uint32_t i = 0; i < chart.steps.size(); ++i) {
        const Step& step = chart.steps[i];
        // else told as not reached; alone beside other networks it is always active on purpose
        const bool stands = !step.in.empty() || (step.decl->isInitial && chart.networks == 1);
        if (step.out.empty() && stands && step.decl->name.isValid() && chart.find(step.decl->name.text) == StepId(i))
            sink.emit(step.decl->name.range, findings::FinalStep(step.decl->name.text));
    }
}

bool hasUnknownNames(const Chart& chart) {
    return std::any_of(chart.transitions.begin(), chart.transitions.end(), [](const Transition& t) {
        return t.from.size() != t.decl->from.size() || t.to.size() != t.decl->to.size() || t.decl->from.empty() ||
               t.decl->to.empty();
    });
}

// ---------------------------------------------------------------- tokens

/// A network as a net of places and transitions, made small before its states are explored: a step between one
/// transition and the next adds nothing to what can be active together.
struct Net {
    struct Move {
        TransitionId id;
        std::vector<uint32_t> from, to;
        bool alive = true;
    };
    std::vector<Move> moves;
    std::vector<uint32_t> initial;
};

Net netOf(const Chart& chart, uint32_t network) {
    Net net;
    for (uint32_t i = 0; i < chart.steps.size(); ++i)
        if (chart.steps[i].network == network && chart.steps[i].decl->isInitial && net.initial.empty())
            net.initial.push_back(i);
    for (uint32_t i = 0; i < chart.transitions.size(); ++i) {
        const Transition& t = chart.transitions[i];
        if (t.network != network || t.from.empty()) continue;
        Net::Move move{.id = TransitionId(i)};
        for (StepId id : t.from) move.from.push_back(id.value);
        for (StepId id : t.to) move.to.push_back(id.value);
        net.moves.push_back(std::move(move));
    }
    return net;
}

void reduce(Net& net, size_t steps) {
    std::vector<std::vector<uint32_t>> into(steps), outOf(steps);
    for (uint32_t m = 0; m < net.moves.size(); ++m) {
        for (uint32_t s : net.moves[m].from) outOf[s].push_back(m);
        for (uint32_t s : net.moves[m].to) into[s].push_back(m);
    }
    std::vector<bool> isInitial(steps, false);
    for (uint32_t s : net.initial) isInitial[s] = true;
    for (uint32_t s = 0; s < steps; ++s) {
        if (isInitial[s] || into[s].size() != 1 || outOf[s].size() != 1 || into[s][0] == outOf[s][0]) continue;
        Net::Move& before = net.moves[into[s][0]];
        Net::Move& after = net.moves[outOf[s][0]];
        if (!before.alive || !after.alive || after.from.size() != 1) continue;
        if (std::count(before.to.begin(), before.to.end(), s) != 1) continue;
        before.to.erase(std::find(before.to.begin(), before.to.end(), s));
        for (uint32_t t : after.to) {
            before.to.push_back(t);
            std::replace(into[t].begin(), into[t].end(), outOf[s][0], into[s][0]);
        }
        after.alive = false;
    }
}

/// Follows the tokens: a step that gets a second one (P4005), a join whose steps are never active together (P4006).
void exploreNetwork(const Chart& chart, uint32_t network, Sink& sink) {
    Net net = netOf(chart, network);
    if (net.initial.empty()) return; // told already
    std::vector<bool> joinSeen(chart.transitions.size(), false);
    bool parallel = false;
    for (const Net::Move& move : net.moves) parallel |= move.from.size() > 1 || move.to.size() > 1;
    if (!parallel) return;
    reduce(net, chart.steps.size());
    constexpr size_t kMaxStates = 20000;
    using State = std::vector<uint32_t>; // sorted
    std::set<State> seen;
    std::deque<State> open;
    std::unordered_set<uint32_t> unsafe;
    const auto add = [&](State state) {
        if (seen.insert(state).second) open.push_back(std::move(state));
    };
    add(net.initial);
    while (!open.empty() && seen.size() < kMaxStates) {
        const State state = std::move(open.front());
        open.pop_front();
        for (const Net::Move& move : net.moves) {
            if (!move.alive || !std::all_of(move.from.begin(), move.from.end(), [&](uint32_t s) {
                    return std::binary_search(state.begin(), state.end(), s);
                }))
                continue;
            joinSeen[move.id.index()] = true;
            State next;
            for (uint32_t s : state)
                if (std::find(move.from.begin(), move.from.end(), s) == move.from.end()) next.push_back(s);
            bool safe = true;
            for (uint32_t s : move.to) {
                if (std::find(next.begin(), next.end(), s) == next.end()) {
                    next.push_back(s);
                    continue;
                }
                safe = false;
                if (!unsafe.insert(s).second) continue;
                const syntax::StepDecl& decl = *chart.steps[s].decl;
                auto& d = sink.emit(decl.name.range, findings::UnsafeChart(decl.name.text));
                d.related.push_back({chart[move.id].decl->range, notes::ByThisTransition()});
            }
            if (!safe) continue;
            std::sort(next.begin(), next.end());
            add(std::move(next));
        }
    }
    if (!open.empty() || !unsafe.empty()) return; // not all states known
    for (const Net::Move& move : net.moves) {
        if (!move.alive || move.from.size() < 2 || joinSeen[move.id.index()]) continue;
        const auto& decl = *chart[move.id].decl;
        sink.emit(joined(decl.from.front().range, decl.from.back().range), findings::UnreachableJoin());
    }
}

/// Steps that no path from an initial step reaches.
void checkReachability(const Chart& chart, Sink& sink) {
    std::vector<bool> reached(chart.steps.size(), false), hasInitial(chart.networks, false);
    std::vector<uint32_t> open;
    for (uint32_t i = 0; i < chart.steps.size(); ++i)
        if (chart.steps[i].decl->isInitial) {
            reached[i] = true;
            hasInitial[chart.steps[i].network] = true;
            open.push_back(i);
        }
    while (!open.empty()) {
        const uint32_t at = open.back();
        open.pop_back();
        for (TransitionId t : chart.steps[at].out)
            for (StepId to : chart[t].to)
                if (!reached[to.index()]) {
                    reached[to.index()] = true;
                    open.push_back(to.value);
                }
    }
    for (uint32_t i = 0; i < chart.steps.size(); ++i)
        if (!reached[i] && hasInitial[chart.steps[i].network] && chart.steps[i].decl->name.isValid() &&
            chart.find(chart.steps[i].decl->name.text) == StepId(i)) // a doubled name is told as that
            sink.emit(chart.steps[i].decl->name.range, findings::UnreachableStep(chart.steps[i].decl->name.text));
}

} // namespace

void check(const Chart& chart, Sink& sink) {
    if (chart.steps.empty()) {
        if (!chart.transitions.empty()) sink.emit(chart.transitions[0].decl->range, findings::NoInitialStep());
        return;
    }
    checkNames(chart, sink);
    checkInitialSteps(chart, sink);
    if (!hasUnknownNames(chart)) { // else what is told there is the cause
        checkReachability(chart, sink);
        checkFinalSteps(chart, sink);
    }
    checkConditions(chart, sink);
    checkQualifiers(chart, sink);
    checkDoubles(chart, sink);
    for (uint32_t n = 0; n < chart.networks; ++n) exploreNetwork(chart, n, sink);
}

} // namespace plc::chart
