#include "runtime/compiler/chart/edits.h"
#include "runtime/base/messages.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <set>

namespace plc::chart {

using syntax::Name;

namespace {

std::vector<std::string> texts(const std::vector<Name>& names) {
    std::vector<std::string> out;
    for (const Name& name : names) out.emplace_back(name.text);
    return out;
}

/// Names as a FROM or TO writes them.
std::string listed(const std::vector<std::string>& names) {
    if (names.size() == 1) return names[0];
    std::string out = "(";
    for (const std::string& name : names) out += (out.size() > 1 ? ", " : "") + name;
    return out + ")";
}

bool same(std::string_view a, std::string_view b) { return equalsIgnoringCase(a, b); }

std::vector<std::string> replaced(std::vector<std::string> names, const std::string& name,
                                  const std::vector<std::string>& by) {
    std::vector<std::string> out;
    const auto add = [&](const std::string& n) {
        if (std::none_of(out.begin(), out.end(), [&](const std::string& have) { return same(have, n); }))
            out.push_back(n);
    };
    for (const std::string& n : names) {
        if (!same(n, name))
            add(n);
        else
            for (const std::string& b : by) add(b);
    }
    return out;
}

} // namespace

ChartEditor::ChartEditor(std::string_view text, const syntax::Pou& pou, const Chart& chart)
    : m_text(text), m_pou(pou), m_chart(chart) {}

std::string ChartEditor::lineEnd() const {
    const size_t at = m_text.find('\n');
    return at != std::string_view::npos && at > 0 && m_text[at - 1] == '\r' ? "\r\n" : "\n";
}

std::string ChartEditor::indentOf(uint32_t at) const {
    uint32_t begin = at;
    while (begin > 0 && m_text[begin - 1] != '\n') --begin;
    uint32_t end = begin;
    while (end < at && (m_text[end] == ' ' || m_text[end] == '\t')) ++end;
    return end == at ? std::string(m_text.substr(begin, end - begin)) : std::string();
}

uint32_t ChartEditor::lineBehind(uint32_t at) const {
    const size_t newline = m_text.find('\n', at);
    return static_cast<uint32_t>(newline == std::string_view::npos ? m_text.size() : newline + 1);
}

std::string ChartEditor::stepText(const std::string& indent, const std::string& name) const {
    return indent + "STEP " + name + ":" + lineEnd() + indent + "END_STEP" + lineEnd();
}

std::string ChartEditor::transitionText(const std::string& indent, const std::string& from, const std::string& to,
                                        std::string_view condition) const {
    return indent + "TRANSITION FROM " + from + " TO " + to + " := " + std::string(condition) + "; END_TRANSITION" +
           lineEnd();
}

std::string ChartEditor::freeStepName() const {
    for (int i = 1;; ++i) {
        const std::string name = "Step" + std::to_string(i);
        const bool variable =
            std::any_of(m_pou.sections.begin(), m_pou.sections.end(), [&](const syntax::VarSection* s) {
                return std::any_of(s->declarations.begin(), s->declarations.end(), [&](const syntax::VarDecl* d) {
                    return std::any_of(d->names.begin(), d->names.end(),
                                       [&](const Name& n) { return same(n.text, name); });
                });
            });
        if (!variable && !m_chart.find(name).isValid()) return name;
    }
}

Result<std::string> ChartEditor::checkedName(std::string name) const {
    if (name.empty()) return freeStepName();
    size_t at = 0;
    bool good = !(name[0] >= '0' && name[0] <= '9');
    while (good && at < name.size()) {
        const size_t before = at;
        const char32_t c = decodeUtf8(name, at);
        good = isNameLetter(c) || name[before] == '_' || (name[before] >= '0' && name[before] <= '9');
    }
    if (!good) return Error{errors::NotAChartName(name), {}};
    if (m_chart.find(name).isValid()) return Error{errors::StepExists(name), {}};
    return name;
}

/// Behind an element, on a line of its own: its extent may end in the middle of a line.
TextEdit ChartEditor::insertBehind(SourceRange extent, std::string text) const {
    const bool lineEnds = extent.end == 0 || m_text[extent.end - 1] == '\n';
    if (!lineEnds) {
        const std::string end = lineEnd();
        const bool textFollows =
            m_text.substr(extent.end, lineBehind(extent.end) - extent.end).find_first_not_of(" \t\r\n") !=
            std::string_view::npos;
        text = end + text;
        if (!textFollows && text.ends_with(end)) text.resize(text.size() - end.size());
    }
    return {{extent.file, extent.end, extent.end}, std::move(text)};
}

/// An element with its comments; on a line shared with others, with one of the blanks around.
TextEdit ChartEditor::eraseExtent(SourceRange extent) const {
    const bool wholeLines =
        (extent.begin == 0 || m_text[extent.begin - 1] == '\n') && extent.end > 0 && m_text[extent.end - 1] == '\n';
    if (!wholeLines && extent.end < m_text.size() && m_text[extent.end] == ' ') ++extent.end;
    return {extent, {}};
}

/// The names between FROM and TO, or behind TO: with their parentheses, as little as changes.
TextEdit ChartEditor::setNames(const std::vector<Name>& list, const std::vector<std::string>& names) const {
    SourceRange range = joined(list.front().range, list.back().range);
    const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; };
    const auto open = [&] {
        uint32_t at = range.begin;
        while (at > 0 && isBlank(m_text[at - 1])) --at;
        return at > 0 && m_text[at - 1] == '(' ? at - 1 : range.begin;
    }();
    const auto close = [&] {
        uint32_t at = range.end;
        while (at < m_text.size() && isBlank(m_text[at])) ++at;
        return at < m_text.size() && m_text[at] == ')' ? at + 1 : range.end;
    }();
    const bool parentheses = open != range.begin && close != range.end;
    if (list.size() == names.size()) {
        // one name for another: the rest stays as it is
        size_t differ = list.size(), count = 0;
        for (size_t i = 0; i < list.size(); ++i)
            if (list[i].text != names[i]) {
                differ = i;
                ++count;
            }
        if (count == 1) return {list[differ].range, names[differ]};
    }
    if (parentheses) {
        range.begin = open;
        range.end = close;
    }
    return {range, listed(names)};
}

Result<Edits> ChartEditor::finish(Edits edits) const {
    std::erase_if(edits, [](const TextEdit& e) { return e.range.length() == 0 && e.text.empty(); });
    std::stable_sort(edits.begin(), edits.end(),
                     [](const TextEdit& a, const TextEdit& b) { return a.range.begin < b.range.begin; });
    Edits out;
    for (TextEdit& edit : edits) {
        if (!out.empty() && out.back().range.end > edit.range.begin) {
            if (out.back().text.empty() && edit.text.empty()) { // two removals that touch
                out.back().range.end = std::max(out.back().range.end, edit.range.end);
                continue;
            }
            return Error{errors::EditsOverlap(), {}};
        }
        out.push_back(std::move(edit));
    }
    return out;
}

// ---------------------------------------------------------------- steps

Result<Edits> ChartEditor::insertStepAfter(StepId step, std::string wanted) const {
    auto name = checkedName(std::move(wanted));
    if (!name) return name.error();
    const Step& s = m_chart[step];
    const std::string indent = indentOf(s.decl->range.begin);
    Edits edits;
    for (TransitionId t : s.out) {
        const auto& from = m_chart[t].decl->from;
        edits.push_back(setNames(from, replaced(texts(from), nameOf(step), {*name})));
    }
    edits.push_back(
        insertBehind(s.decl->extent, transitionText(indent, nameOf(step), *name, "TRUE") + stepText(indent, *name)));
    return finish(std::move(edits));
}

Result<Edits> ChartEditor::insertStepAfter(TransitionId transition, std::string wanted) const {
    auto name = checkedName(std::move(wanted));
    if (!name) return name.error();
    const Transition& t = m_chart[transition];
    if (t.decl->to.empty()) return Error{errors::TransitionLeadsNowhere(), {}};
    const std::string indent = indentOf(t.decl->range.begin);
    std::vector<std::string> to = texts(t.decl->to);
    const std::string target = to[0];
    to[0] = *name;
    Edits edits;
    edits.push_back(setNames(t.decl->to, to));
    edits.push_back(
        insertBehind(t.decl->extent, stepText(indent, *name) + transitionText(indent, *name, target, "TRUE")));
    return finish(std::move(edits));
}

Result<Edits> ChartEditor::deleteStep(StepId step) const {
    const Step& s = m_chart[step];
    if (s.decl->isInitial) return Error{errors::InitialStepNotDeleted(), {}};
    if (s.out.size() > 1) return Error{errors::StepHasBranches(), {}};
    Edits edits;
    edits.push_back(eraseExtent(s.decl->extent));
    std::vector<std::string> next; // where those that led here lead on
    bool outStays = false;
    if (s.out.size() == 1) {
        const Transition& out = m_chart[s.out[0]];
        if (out.decl->from.size() > 1) { // a branch of a simultaneous part: the others still join
            outStays = true;
            edits.push_back(setNames(out.decl->from, replaced(texts(out.decl->from), nameOf(step), {})));
        } else {
            next = replaced(texts(out.decl->to), nameOf(step), {});
            edits.push_back(eraseExtent(out.decl->extent));
        }
    }
    for (TransitionId id : s.in) {
        if (!s.out.empty() && id == s.out[0]) continue;
        const Transition& in = m_chart[id];
        const std::vector<std::string> to = replaced(texts(in.decl->to), nameOf(step), next);
        if (!to.empty())
            edits.push_back(setNames(in.decl->to, to));
        else if (outStays)
            return Error{errors::JoinWouldBeLost(), {}};
        else
            edits.push_back(eraseExtent(in.decl->extent));
    }
    return finish(std::move(edits));
}

Result<Edits> ChartEditor::moveStep(StepId step, TransitionId behind) const {
    const Step& s = m_chart[step];
    const Transition& target = m_chart[behind];
    if (s.decl->isInitial) return Error{errors::InitialStepStays(), {}};
    if (s.out.size() != 1 || m_chart[s.out[0]].decl->from.size() != 1) return Error{errors::StepNotMovable(), {}};
    if (s.out[0] == behind) return Error{errors::StepAlreadyThere(), {}};
    if (target.decl->to.size() != 1) return Error{errors::NoPlaceForStep(), {}};
    if (std::find(s.in.begin(), s.in.end(), behind) != s.in.end()) return Error{errors::StepAlreadyThere(), {}};
    const Transition& out = m_chart[s.out[0]];
    const std::vector<std::string> next = replaced(texts(out.decl->to), nameOf(step), {});
    if (next.empty()) return Error{errors::StepLeadsToItself(), {}};
    Edits edits;
    for (TransitionId id : s.in) {
        if (id == s.out[0]) continue;
        edits.push_back(setNames(m_chart[id].decl->to, replaced(texts(m_chart[id].decl->to), nameOf(step), next)));
    }
    edits.push_back(setNames(target.decl->to, {nameOf(step)}));
    edits.push_back(setNames(out.decl->to, texts(target.decl->to)));
    return finish(std::move(edits));
}

// ---------------------------------------------------------------- transitions and branches

Result<Edits> ChartEditor::insertTransition(StepId from, StepId to, std::string_view condition) const {
    const Step& s = m_chart[from];
    const std::string indent = indentOf(s.decl->range.begin);
    const SourceRange anchor = s.out.empty() ? s.decl->extent : m_chart[s.out.back()].decl->extent;
    return finish({insertBehind(anchor, transitionText(indent, nameOf(from), nameOf(to), condition))});
}

Result<Edits> ChartEditor::deleteTransition(TransitionId transition) const {
    return finish({eraseExtent(m_chart[transition].decl->extent)});
}

Result<Edits> ChartEditor::moveTransition(TransitionId transition, Place place, TransitionId anchor) const {
    if (transition == anchor) return Edits{};
    const SourceRange what = m_chart[transition].decl->extent;
    const SourceRange where = m_chart[anchor].decl->extent;
    std::string text = slice(what);
    const std::string end = lineEnd();
    if (!text.ends_with('\n')) text += end;
    Edits edits{eraseExtent(what)};
    if (place == Place::After) {
        edits.push_back(insertBehind(where, text));
    } else {
        const bool lineBegins = where.begin == 0 || m_text[where.begin - 1] == '\n';
        edits.push_back({{where.file, where.begin, where.begin}, lineBegins ? text : end + text});
    }
    return finish(std::move(edits));
}

Result<Edits> ChartEditor::moveParallel(TransitionId transition, size_t from, size_t to) const {
    const auto& list = m_chart[transition].decl->to;
    if (from >= list.size() || to >= list.size()) return Error{errors::NoBranchHere(), {}};
    std::vector<std::string> names = texts(list);
    const std::string name = names[from];
    names.erase(names.begin() + static_cast<std::ptrdiff_t>(from));
    names.insert(names.begin() + static_cast<std::ptrdiff_t>(to), name);
    return finish({setNames(list, names)});
}

Result<Edits> ChartEditor::setCondition(TransitionId transition, std::string_view condition) const {
    const syntax::TransitionDecl& t = *m_chart[transition].decl;
    if (condition.find_first_not_of(" \t\r\n") == std::string_view::npos) return Error{errors::ConditionNeeded(), {}};
    if (t.condition) {
        const SourceRange range = t.condition->range;
        return finish({{range, std::string(condition)}});
    }
    if (t.ilCondition.empty()) return Error{errors::ConditionUnreadable(), {}};
    // instructions become an expression: with the colon before them
    SourceRange range = joined(t.ilCondition.front()->range, t.ilCondition.back()->range);
    while (range.begin > 0 && m_text[range.begin] != ':') --range.begin;
    return finish({{range, ":= " + std::string(condition) + ";"}});
}

Result<Edits> ChartEditor::setPriority(TransitionId transition, int priority) const {
    const syntax::TransitionDecl& t = *m_chart[transition].decl;
    if (priority < 0) return Error{errors::PriorityNotPositive(), {}};
    if (t.priority && priority > 0) return finish({{t.priority->range, std::to_string(priority)}});
    if (t.priority) {
        SourceRange range = t.priority->range;
        while (range.begin > t.range.begin && m_text[range.begin] != '(') --range.begin;
        while (range.end < t.range.end && m_text[range.end] != ')') ++range.end;
        ++range.end;
        if (range.end < t.range.end && m_text[range.end] == ' ') ++range.end;
        return finish({{range, {}}});
    }
    if (priority == 0) return Edits{};
    const uint32_t at = t.name.isValid() ? t.name.range.end
                                         : t.range.begin + static_cast<uint32_t>(std::string_view("TRANSITION").size());
    return finish({{{t.range.file, at, at}, " (PRIORITY := " + std::to_string(priority) + ")"}});
}

Result<Edits> ChartEditor::setTarget(TransitionId transition, StepId from, StepId to) const {
    const auto& list = m_chart[transition].decl->to;
    return finish({setNames(list, replaced(texts(list), nameOf(from), {nameOf(to)}))});
}

Result<Edits> ChartEditor::insertAlternativeBranch(StepId step, std::string wanted) const {
    auto name = checkedName(std::move(wanted));
    if (!name) return name.error();
    const Step& s = m_chart[step];
    if (s.out.empty()) return Error{errors::NothingFollowsStep(), {}};
    // where the last branch leads: along steps with one way on
    TransitionId last = s.out.back();
    std::set<uint32_t> seen;
    while (m_chart[last].to.size() == 1 && seen.insert(last.value).second) {
        const Step& next = m_chart[m_chart[last].to[0]];
        if (next.decl->isInitial || next.in.size() > 1 || next.out.size() != 1 ||
            m_chart[next.out[0]].decl->from.size() > 1)
            break;
        last = next.out[0];
    }
    if (m_chart[last].to.empty()) return Error{errors::LastBranchLeadsNowhere(), {}};
    const std::string target = nameOf(m_chart[last].to[0]);
    const std::string indent = indentOf(s.decl->range.begin);
    const SourceRange anchor = m_chart[s.out.back()].decl->extent;
    return finish({insertBehind(anchor, transitionText(indent, nameOf(step), *name, "TRUE") + stepText(indent, *name) +
                                            transitionText(indent, *name, target, "TRUE"))});
}

Result<Edits> ChartEditor::insertSimultaneousBranch(TransitionId transition, std::string wanted) const {
    auto name = checkedName(std::move(wanted));
    if (!name) return name.error();
    const Transition& t = m_chart[transition];
    if (t.to.empty()) return Error{errors::TransitionLeadsNowhere(), {}};
    // the join of the branches there are, or of the one that becomes the first of two
    std::string indent = indentOf(t.decl->range.begin);
    std::set<uint32_t> seen;
    std::vector<StepId> open{t.to[0]};
    TransitionId join;
    while (!open.empty() && !join.isValid()) {
        const StepId at = open.back();
        open.pop_back();
        if (!seen.insert(at.value).second) continue;
        for (TransitionId out : m_chart[at].out) {
            if (m_chart[out].from.size() > 1)
                join = out;
            else
                for (StepId to : m_chart[out].to) open.push_back(to);
        }
    }
    Edits edits;
    std::vector<std::string> to = texts(t.decl->to);
    to.push_back(*name);
    edits.push_back(setNames(t.decl->to, to));
    if (join.isValid()) {
        std::vector<std::string> from = texts(m_chart[join].decl->from);
        from.push_back(*name);
        edits.push_back(setNames(m_chart[join].decl->from, from));
    } else {
        // one step so far: its way on becomes the join
        const Step& only = m_chart[t.to[0]];
        if (t.to.size() != 1 || only.out.size() != 1) return Error{errors::BranchesDoNotJoin(), {}};
        join = only.out[0];
        std::vector<std::string> from = texts(m_chart[join].decl->from);
        from.push_back(*name);
        edits.push_back(setNames(m_chart[join].decl->from, from));
    }
    edits.push_back(insertBehind(t.decl->extent, stepText(indent, *name)));
    return finish(std::move(edits));
}

Result<Edits> ChartEditor::deleteBranch(TransitionId first) const {
    // what an initial step still reaches without this transition stays
    std::vector<bool> stepStays(m_chart.steps.size(), false);
    std::vector<uint32_t> open;
    for (uint32_t i = 0; i < m_chart.steps.size(); ++i)
        if (m_chart.steps[i].decl->isInitial || (m_chart.steps[i].in.empty())) {
            stepStays[i] = true;
            open.push_back(i);
        }
    while (!open.empty()) {
        const uint32_t at = open.back();
        open.pop_back();
        for (TransitionId t : m_chart.steps[at].out) {
            if (t == first) continue;
            for (StepId to : m_chart[t].to)
                if (!stepStays[to.index()]) {
                    stepStays[to.index()] = true;
                    open.push_back(to.value);
                }
        }
    }
    std::vector<bool> reached(m_chart.steps.size(), false);
    for (StepId to : m_chart[first].to)
        if (!reached[to.index()]) {
            reached[to.index()] = true;
            open.push_back(to.value);
        }
    while (!open.empty()) {
        const uint32_t at = open.back();
        open.pop_back();
        for (TransitionId t : m_chart.steps[at].out)
            for (StepId to : m_chart[t].to)
                if (!reached[to.index()]) {
                    reached[to.index()] = true;
                    open.push_back(to.value);
                }
    }
    Edits edits{eraseExtent(m_chart[first].decl->extent)};
    std::set<uint32_t> gone{first.value};
    for (uint32_t i = 0; i < m_chart.steps.size(); ++i) {
        if (stepStays[i] || !reached[i]) continue;
        edits.push_back(eraseExtent(m_chart.steps[i].decl->extent));
        for (TransitionId t : m_chart.steps[i].out) {
            if (!gone.insert(t.value).second) continue;
            edits.push_back(eraseExtent(m_chart[t].decl->extent));
        }
    }
    return finish(std::move(edits));
}

// ---------------------------------------------------------------- actions

std::string ChartEditor::associationText(std::string_view action, std::string_view qualifier,
                                         std::string_view time) const {
    std::string out = std::string(action) + "(" + std::string(qualifier.empty() ? "N" : qualifier);
    if (!time.empty()) out += ", " + std::string(time);
    return out + ");";
}

Result<Edits> ChartEditor::insertAction(StepId step, size_t index, std::string_view action, std::string_view qualifier,
                                        std::string_view time) const {
    const syntax::StepDecl& s = *m_chart[step].decl;
    const std::string text = associationText(action, qualifier, time);
    const auto behindSemicolon = [&](uint32_t at) {
        while (at < s.range.end && (m_text[at] == ' ' || m_text[at] == '\t')) ++at;
        return at < s.range.end && m_text[at] == ';' ? at + 1 : at;
    };
    if (!s.actions.empty()) {
        if (index >= s.actions.size()) {
            const SourceRange last = s.actions.back().range;
            const std::string indent = indentOf(last.begin);
            const uint32_t at = behindSemicolon(last.end);
            return finish({{{last.file, at, at}, indent.empty() ? " " + text : lineEnd() + indent + text}});
        }
        const SourceRange before = s.actions[index].range;
        const std::string indent = indentOf(before.begin);
        return finish(
            {{{before.file, before.begin, before.begin}, text + (indent.empty() ? " " : lineEnd() + indent)}});
    }
    // behind the colon
    uint32_t at = s.name.range.end;
    while (at < s.range.end && m_text[at] != ':')
        at = m_text[at] == '{' ? static_cast<uint32_t>(std::min(m_text.find('}', at), static_cast<size_t>(s.range.end)))
                               : at + 1;
    at = std::min(at + 1, s.range.end);
    const bool oneLine = m_text.substr(s.range.begin, s.range.length()).find('\n') == std::string_view::npos;
    if (oneLine) return finish({{{s.range.file, at, at}, " " + text}});
    return finish({{{s.range.file, at, at}, lineEnd() + indentOf(s.range.begin) + "    " + text}});
}

Result<Edits> ChartEditor::deleteAction(StepId step, size_t index) const {
    const syntax::StepDecl& s = *m_chart[step].decl;
    if (index >= s.actions.size()) return Error{errors::NoSuchAction(), {}};
    SourceRange range = s.actions[index].range;
    while (range.end < s.range.end && (m_text[range.end] == ' ' || m_text[range.end] == '\t')) ++range.end;
    if (range.end < s.range.end && m_text[range.end] == ';') ++range.end;
    // a line of its own goes with it
    uint32_t begin = range.begin;
    while (begin > 0 && (m_text[begin - 1] == ' ' || m_text[begin - 1] == '\t')) --begin;
    const uint32_t behind = lineBehind(range.end);
    const bool ownLine =
        (begin == 0 || m_text[begin - 1] == '\n') &&
        m_text.substr(range.end, behind - range.end).find_first_not_of(" \t\r\n") == std::string_view::npos;
    if (ownLine)
        range = {range.file, begin, behind};
    else if (begin < range.begin)
        --range.begin;
    return finish({{range, {}}});
}

Result<Edits> ChartEditor::moveAction(StepId step, size_t from, size_t to) const {
    const syntax::StepDecl& s = *m_chart[step].decl;
    if (from >= s.actions.size() || to >= s.actions.size()) return Error{errors::NoSuchAction(), {}};
    if (from == to) return Edits{};
    // the texts change places, what stands between them stays
    std::vector<size_t> order(s.actions.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = i;
    order.erase(order.begin() + static_cast<std::ptrdiff_t>(from));
    order.insert(order.begin() + static_cast<std::ptrdiff_t>(to), from);
    Edits edits;
    for (size_t i = 0; i < order.size(); ++i)
        if (order[i] != i) edits.push_back({s.actions[i].range, slice(s.actions[order[i]].range)});
    return finish(std::move(edits));
}

Result<Edits> ChartEditor::changeAction(StepId step, size_t index, std::string_view action, std::string_view qualifier,
                                        std::string_view time) const {
    const syntax::StepDecl& s = *m_chart[step].decl;
    if (index >= s.actions.size()) return Error{errors::NoSuchAction(), {}};
    const syntax::ActionAssociation& a = s.actions[index];
    std::string text = associationText(action, qualifier, time);
    text.pop_back();
    if (!a.indicators.empty()) {
        text.pop_back();
        for (const Name& name : a.indicators) text += ", " + std::string(name.text);
        text += ")";
    }
    return finish({{a.range, text}});
}

Result<Edits> ChartEditor::declareAction(std::string_view name) const {
    if (!m_chart.body || m_chart.steps.empty()) return Error{errors::NoChartYet(), {}};
    uint32_t end = 0;
    for (const Step& s : m_chart.steps) end = std::max(end, s.decl->extent.end);
    for (const Transition& t : m_chart.transitions) end = std::max(end, t.decl->extent.end);
    for (const syntax::ActionDecl* a : m_chart.body->actions) end = std::max(end, a->extent.end);
    const std::string indent = indentOf(m_chart.steps[0].decl->range.begin);
    const SourceRange place{m_chart.steps[0].decl->range.file, end, end};
    return finish({insertBehind(place, indent + "ACTION " + std::string(name) + ":" + lineEnd() + indent +
                                           "END_ACTION" + lineEnd())});
}

// ---------------------------------------------------------------- steps' own properties

Result<Edits> ChartEditor::setInitial(StepId step) const {
    Edits edits;
    const auto word = [&](const syntax::StepDecl& s) {
        uint32_t end = s.range.begin;
        while (end < s.range.end && m_text[end] != ' ' && m_text[end] != '\t' && m_text[end] != '\r' &&
               m_text[end] != '\n')
            ++end;
        return SourceRange{s.range.file, s.range.begin, end};
    };
    for (const Step& s : m_chart.steps)
        if (s.network == m_chart[step].network && s.decl->isInitial && s.decl != m_chart[step].decl)
            edits.push_back({word(*s.decl), "STEP"});
    if (!m_chart[step].decl->isInitial) edits.push_back({word(*m_chart[step].decl), "INITIAL_STEP"});
    return finish(std::move(edits));
}

Result<Edits> ChartEditor::setStepTime(StepId step, std::string_view key, std::string_view time) const {
    const syntax::StepDecl& s = *m_chart[step].decl;
    const std::string text = "{" + std::string(key) + " := " + std::string(time) + "}";
    for (const syntax::Pragma& pragma : s.pragmas) {
        if (!same(pragma.key, key)) continue;
        if (!time.empty()) return finish({{pragma.range, text}});
        SourceRange range = pragma.range;
        if (range.begin > 0 && m_text[range.begin - 1] == ' ') --range.begin;
        return finish({{range, {}}});
    }
    if (time.empty()) return Edits{};
    const uint32_t at = s.pragmas.empty() ? s.name.range.end : s.pragmas.back().range.end;
    return finish({{{s.range.file, at, at}, " " + text}});
}

std::string emptyChart(std::string_view indent, std::string_view lineEnd) {
    const std::string i(indent), e(lineEnd);
    return i + "INITIAL_STEP Init:" + e + i + "END_STEP" + e + i +
           "TRANSITION FROM Init TO Init := FALSE; END_TRANSITION" + e;
}

} // namespace plc::chart
