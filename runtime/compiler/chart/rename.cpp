#include "runtime/base/messages.h"
#include "runtime/compiler/chart/edits.h"

#include "runtime/base/text.h"

#include <algorithm>

namespace plc::chart {

using syntax::Expr;
using syntax::ExprKind;
using syntax::Name;
using syntax::Stmt;

namespace {

/// Every place of a unit where a name stands for a step or an action.
class NameFinder {
public:
    NameFinder(std::string_view name, bool wantsSteps) : m_key(foldCase(name)), m_wantsSteps(wantsSteps) {}

    void unit(const syntax::Pou& pou) {
        body(pou.body);
        for (const syntax::ActionDecl* action : pou.actions) this->action(*action);
    }
    std::vector<SourceRange> places;

private:
    void name(const Name& n) {
        if (n.text.size() == m_key.size() && foldCase(n.text) == m_key) places.push_back(n.range);
    }
    void action(const syntax::ActionDecl& a) {
        if (!m_wantsSteps) name(a.name);
        body(a.body);
    }
    void body(const syntax::Body& b) {
        block(b.statements);
        if (!b.chart) return;
        for (const syntax::StepDecl* step : b.chart->steps) {
            if (m_wantsSteps) name(step->name);
            for (const syntax::ActionAssociation& a : step->actions) {
                if (!m_wantsSteps) name(a.action);
                expr(a.time);
            }
        }
        for (const syntax::TransitionDecl* t : b.chart->transitions) {
            if (m_wantsSteps)
                for (const auto* list : {&t->from, &t->to})
                    for (const Name& n : *list) name(n);
            expr(t->condition);
            block(t->ilCondition);
        }
        for (const syntax::ActionDecl* a : b.chart->actions) action(*a);
    }
    void block(const syntax::Block& list) {
        for (const Stmt* s : list) statement(*s);
    }
    void statement(const Stmt& s) {
        for (const Expr* e : {s.target, s.value, s.from, s.to, s.by}) expr(e);
        block(s.body);
        block(s.elseBody);
        for (const syntax::IfBranch& branch : s.branches) {
            expr(branch.condition);
            block(branch.body);
        }
        for (const syntax::CaseArm& arm : s.arms) {
            for (const syntax::CaseLabel& label : arm.labels) {
                expr(label.low);
                expr(label.high);
            }
            block(arm.body);
        }
        if (s.il) {
            expr(s.il->operand);
            for (const syntax::Argument& a : s.il->arguments) expr(a.value);
            block(s.il->body);
        }
    }
    /// A step is `name.X` or a value alone; an action is called.
    void expr(const Expr* e) {
        if (!e) return;
        if (e->kind == ExprKind::NameRef) name(e->name);
        expr(e->base);
        expr(e->right);
        for (const syntax::Argument& a : e->arguments) expr(a.value);
    }

    std::string m_key;
    bool m_wantsSteps;
};

} // namespace

Result<Edits> ChartEditor::renameStep(StepId step, std::string_view wanted) const {
    const std::string old = nameOf(step);
    if (old == wanted) return Edits{};
    if (!equalsIgnoringCase(old, wanted)) {
        auto checked = checkedName(std::string(wanted));
        if (!checked) return checked.error();
    }
    NameFinder finder(old, true);
    finder.unit(m_pou);
    Edits edits;
    for (SourceRange range : finder.places) edits.push_back({range, std::string(wanted)});
    std::sort(edits.begin(), edits.end(),
              [](const TextEdit& a, const TextEdit& b) { return a.range.begin < b.range.begin; });
    edits.erase(std::unique(edits.begin(), edits.end(),
                            [](const TextEdit& a, const TextEdit& b) { return a.range == b.range; }),
                edits.end());
    return finish(std::move(edits));
}

Result<Edits> ChartEditor::renameAction(std::string_view action, std::string_view wanted) const {
    if (action == wanted) return Edits{};
    NameFinder finder(action, false);
    finder.unit(m_pou);
    if (finder.places.empty()) return Error{errors::NoActionNamed(action), {}};
    Edits edits;
    for (SourceRange range : finder.places) edits.push_back({range, std::string(wanted)});
    std::sort(edits.begin(), edits.end(),
              [](const TextEdit& a, const TextEdit& b) { return a.range.begin < b.range.begin; });
    edits.erase(std::unique(edits.begin(), edits.end(),
                            [](const TextEdit& a, const TextEdit& b) { return a.range == b.range; }),
                edits.end());
    return finish(std::move(edits));
}

} // namespace plc::chart
