#include "runtime/compiler/lower/chart.h"

#include "runtime/compiler/lower/instruction_list.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <climits>

namespace plc::lower {

using syntax::ActionAssociation;
using syntax::StepDecl;
using syntax::TransitionDecl;

namespace {

/// Variables of CODESYS that steer or report a chart, where the unit declares them.
class Flags {
public:
    explicit Flags(const syntax::Pou& pou) {
        for (const syntax::VarSection* section : pou.sections)
            for (const syntax::VarDecl* decl : section->declarations)
                for (const Name& name : decl->names)
                    if (name.text.size() > 3 && equalsIgnoringCase(name.text.substr(0, 3), "sfc"))
                        m_names.insert(foldCase(name.text));
    }
    bool has(std::string_view name) const { return !m_names.empty() && m_names.contains(foldCase(name)); }

    /// Their types, and which need another beside them.
    ///   ok:    SFCTip, SFCTipMode : BOOL;    wrong: SFCInit : INT;  (P4012)   SFCTip : BOOL; without SFCTipMode
    ///   (P4013)
    void check(const syntax::Pou& pou, diagnostics::Sink& sink) {
        struct Row {
            std::string_view name;
            bool isText;
            std::string_view partner;
        };
        static constexpr Row kFlags[] = {{"SFCInit", false, ""},
                                         {"SFCReset", false, ""},
                                         {"SFCError", false, ""},
                                         {"SFCEnableLimit", false, "SFCError"},
                                         {"SFCErrorStep", true, ""},
                                         {"SFCErrorPOU", true, "SFCError"},
                                         {"SFCQuitError", false, "SFCError"},
                                         {"SFCPause", false, ""},
                                         {"SFCTrans", false, ""},
                                         {"SFCCurrentStep", true, ""},
                                         {"SFCTip", false, "SFCTipMode"},
                                         {"SFCTipMode", false, "SFCTip"}};
        if (m_names.empty()) return;
        for (const syntax::VarSection* section : pou.sections)
            for (const syntax::VarDecl* decl : section->declarations)
                for (const Name& name : decl->names)
                    for (const Row& row : kFlags) {
                        if (!equalsIgnoringCase(name.text, row.name)) continue;
                        const syntax::TypeSpec* spec = decl->type;
                        const bool named = spec && spec->kind == syntax::TypeSpecKind::Named && spec->path.size() == 1;
                        const bool isBool = named && equalsIgnoringCase(spec->path[0].text, "BOOL");
                        const bool isText = spec && (spec->kind == syntax::TypeSpecKind::String ||
                                                     (named && (equalsIgnoringCase(spec->path[0].text, "STRING") ||
                                                                equalsIgnoringCase(spec->path[0].text, "WSTRING"))));
                        const bool isOther = spec && (isBool || isText || spec->kind != syntax::TypeSpecKind::Named ||
                                                      isElementary(spec->path));
                        if (isOther && !(row.isText ? isText : isBool)) {
                            const Verbatim own(row.isText ? "STRING" : "BOOL");
                            auto& diagnostic = sink.emit(spec->range, findings::ChartFlagType(row.name, own));
                            m_names.erase(foldCase(name.text));
                            diagnostic.fixes.push_back({fixes::Write(own), {{spec->range, own.text}}});
                        } else if (!row.partner.empty() && !has(row.partner)) {
                            sink.emit(name.range, findings::ChartFlagAlone(row.name, row.partner));
                        }
                    }
    }

private:
    static bool isElementary(const syntax::Path& path) {
        static const std::set<std::string> kWords = {"byte", "word",  "dword", "lword", "sint",  "int",  "dint",
                                                     "lint", "usint", "uint",  "udint", "ulint", "real", "lreal",
                                                     "time", "ltime", "date",  "tod",   "dt",    "char", "wchar"};
        return path.size() == 1 && kWords.contains(foldCase(path[0].text));
    }
    std::set<std::string> m_names;
};

/// a OR b OR c as a balanced tree, so that a hundred steps do not nest a hundred deep.
std::string anyOf(const std::vector<std::string>& terms, size_t begin, size_t end) {
    if (begin == end) return "FALSE";
    if (end - begin == 1) return terms[begin];
    const size_t middle = begin + (end - begin) / 2;
    return "(" + anyOf(terms, begin, middle) + " OR " + anyOf(terms, middle, end) + ")";
}
std::string anyOf(const std::vector<std::string>& terms) { return anyOf(terms, 0, terms.size()); }

std::string quoted(std::string_view text) {
    std::string out = "'";
    for (char c : text) {
        if (c == '\'' || c == '$') out += '$';
        out += c;
    }
    return out + "'";
}

int priorityOf(const TransitionDecl& transition) {
    if (!transition.priority || transition.priority->kind != ExprKind::Literal) return INT_MAX;
    int value = 0;
    for (char c : transition.priority->text) {
        if (c == '_') continue;
        if (c < '0' || c > '9' || value > 100000000) return INT_MAX;
        value = value * 10 + (c - '0');
    }
    return value;
}

/// One action and everything that asks for it.
struct Control {
    Name name;
    bool isAction = false;
    std::string variable;                                     // __action_name
    std::vector<std::string> non, stored, reset, entry, exit; // terms of the control block's inputs
    std::vector<Expr*> holes;                                 // the times in the terms
    struct Timed {
        std::string variable, step;
        size_t hole;
    };
    std::vector<Timed> timed; // SD, SL
};

class ChartLowering {
public:
    ChartLowering(const syntax::SfcBody& chart, SourceRange place, ChartUnit& unit, Builder& builder,
                  diagnostics::Sink& sink)
        : m_chart(chart), m_place(place), m_unit(unit), m_builder(builder), m_sink(sink), m_flags(unit.pou),
          m_number(std::to_string(unit.charts++)) {}

    Block run() {
        declareSteps();
        if (m_number == "0") m_flags.check(m_unit.pou, m_sink);
        if (m_steps.empty()) return {};
        checkStepTimes();
        started();
        collectControls();
        // The order of edition 2, 2.6.5: times first, since conditions read them; then all transitions against the
        // steps as they were; then the steps change together; then actions, which see the steps as they are now.
        Block work;
        append(work, update());
        append(work, evolution());
        append(work, stepCalls());
        append(work, supervision());
        append(work, controlCalls());
        append(work, actionCalls());
        Block out;
        // SFCInit holds the chart at its initial steps; SFCReset (below) goes there and lets the actions run on.
        if (m_flags.has("SFCInit")) {
            Block first = reset("SFCInit");
            append(out, m_builder.statements("IF SFCInit THEN ELSE END_IF", m_place));
            out[0]->branches[0].body = std::move(first);
            out[0]->branches[1].body = std::move(work);
        } else {
            out = std::move(work);
        }
        return paused(std::move(out));
    }

private:
    void append(Block& to, Block from) { to.insert(to.end(), from.begin(), from.end()); }
    std::string chartVariable() const { return "__chart" + m_number; }
    std::string firedVariable() const { return "__fired" + m_number; }
    /// The variable of a step. One that takes the name of a variable has a hidden one, so that the clash is reported
    /// once.
    std::string step(const StepDecl& s) const {
        return m_clashing.contains(&s) ? "__step_" + identifierFrom(s.name.text) + "_" + m_number
                                       : spelled(s.name.text);
    }

    void declareSteps() {
        for (const StepDecl* s : m_chart.steps) {
            const std::string key = foldCase(s->name.text);
            if (!s->name.isValid() || !m_unit.steps.insert(key).second) continue; // reported by the chart's checks
            m_steps.push_back(s);
            m_known[key] = s;
            if (const Name* other = variableNamed(s->name)) {
                auto& diagnostic = m_sink.emit(s->name.range, findings::DuplicateName(s->name.text));
                diagnostic.related.push_back({other->range, notes::FirstDeclaredHere()});
                m_clashing.insert(s);
            }
            syntax::VarDecl* decl = m_builder.declare(
                m_unit.section, m_clashing.contains(s) ? m_builder.name(step(*s), s->name.range) : s->name, "SFC_STEP");
            decl->range = s->range;
        }
    }
    const Name* variableNamed(const Name& step) const {
        for (const syntax::VarSection* section : m_unit.pou.sections) {
            if (section == &m_unit.section) continue;
            for (const syntax::VarDecl* decl : section->declarations)
                for (const Name& name : decl->names)
                    if (equalsIgnoringCase(name.text, step.text)) return &name;
        }
        return nullptr;
    }
    const StepDecl* find(const Name& name) const {
        const auto it = m_known.find(foldCase(name.text));
        return it == m_known.end() ? nullptr : it->second;
    }

    void started() {
        m_builder.declare(m_unit.section, m_builder.name(chartVariable(), m_place), "BOOL");
        for (const TransitionDecl* t : m_chart.transitions) m_transitions.push_back(t);
        if (m_transitions.empty()) return;
        auto* decl = m_builder.declare(m_unit.section, m_builder.name(firedVariable(), m_place), "BOOL");
        auto* array = m_builder.make<syntax::TypeSpec>();
        array->kind = syntax::TypeSpecKind::Array;
        array->range = m_place;
        array->element = decl->type;
        // An array and not one flag each: whoever shows a recording looks up a transition by its number in the text.
        const auto number = [&](size_t value) {
            auto* e = m_builder.make<Expr>();
            e->kind = ExprKind::Literal;
            e->op = TokenKind::IntegerLiteral;
            e->text = m_builder.keep(std::to_string(value));
            e->range = m_place;
            return e;
        };
        array->bounds.push_back({number(0), number(m_transitions.size() - 1)});
        decl->type = array;
    }

    /// T of the active steps, at this scan's time: conditions read it.
    Block update() {
        Block out;
        for (const StepDecl* s : m_steps) append(out, m_builder.statements(step(*s) + ".update();", s->name.range));
        return out;
    }

    Block evolution() {
        std::string clear;
        if (m_flags.has("SFCTrans") && m_number == "0") clear = "SFCTrans := FALSE;";
        for (size_t i = 0; i < m_transitions.size(); ++i)
            clear += firedVariable() + "[" + std::to_string(i) + "] := FALSE;";
        Block out = m_builder.statements(clear, m_place);
        std::string begin = chartVariable() + " := TRUE;";
        for (const StepDecl* s : m_steps)
            if (s->isInitial) begin += step(*s) + ".enter := TRUE;";
        Block transitions = transitionStatements();
        Block choice = m_builder.statements("IF NOT " + chartVariable() + " THEN " + begin + " ELSE END_IF", m_place);
        choice[0]->branches[1].body = std::move(transitions);
        if (m_flags.has("SFCReset")) {
            Block resetting = reset("SFCReset");
            Block outer = m_builder.statements("IF SFCReset THEN ELSE END_IF", m_place);
            append(resetting, m_builder.statements(begin, m_place));
            outer[0]->branches[0].body = std::move(resetting);
            outer[0]->branches[1].body = std::move(choice);
            choice = std::move(outer);
        }
        append(out, std::move(choice));
        return out;
    }

    /// Left to right, explicit priorities first: who comes first takes the steps from those behind (2.6.5, rules 4 and
    /// 5).
    Block transitionStatements() {
        std::vector<size_t> order(m_transitions.size());
        for (size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
            return priorityOf(*m_transitions[a]) < priorityOf(*m_transitions[b]);
        });
        Block out;
        std::string tip;
        if (m_flags.has("SFCTipMode") && m_flags.has("SFCTip")) {
            tip = "__tip" + m_number;
            m_builder.declare(m_unit.section, m_builder.name(tip, m_place), "BOOL");
        }
        for (size_t index : order) {
            const TransitionDecl& t = *m_transitions[index];
            const bool known = !t.from.empty() &&
                               std::all_of(t.from.begin(), t.from.end(), [&](const Name& n) { return find(n); }) &&
                               std::all_of(t.to.begin(), t.to.end(), [&](const Name& n) { return find(n); });
            if (!known) continue;
            std::string guard, effect;
            std::vector<Expr*> holes;
            for (const Name& from : t.from) {
                const StepDecl& s = *find(from);
                // A step that an earlier transition took is active until the end of the scan, but nobody can take it
                // twice.
                guard += (guard.empty() ? "" : " AND ") + step(s) + ".X AND NOT " + step(s) + ".leave";
                effect += step(s) + ".leave := TRUE;";
                if (Expr* least = stepTime(s, "minTime")) {
                    guard += " AND " + step(s) + ".T >= __hole" + std::to_string(holes.size());
                    holes.push_back(least);
                }
            }
            for (const Name& to : t.to) effect += step(*find(to)) + ".enter := TRUE;";
            effect += firedVariable() + "[" + std::to_string(index) + "] := TRUE;";
            if (m_flags.has("SFCTrans")) effect += "SFCTrans := TRUE;";
            // The instructions of a condition in IL are in front of the test and inside of the guard: they run only
            // while the steps before the transition are active.
            Block before;
            Expr* condition = t.condition;
            if (!condition) {
                LoweredList list = lowerInstructions(t.ilCondition,
                                                     {m_builder, m_unit.pou.sections, m_unit.blockTypes, m_unit.section,
                                                      m_unit.instructionVariables, m_sink, Keep::Every},
                                                     true);
                before = std::move(list.statements);
                condition = list.result;
            }
            if (!condition) continue;
            const std::string hole = "__hole" + std::to_string(holes.size());
            std::string test = hole;
            // One step on for each rising edge of SFCTip; the condition itself does not count in that mode.
            if (!tip.empty()) test = "SFCTipMode AND SFCTip AND NOT " + tip + " OR NOT SFCTipMode AND " + hole;
            holes.push_back(condition);
            Block whole = m_builder.statements(
                "IF " + guard + " THEN IF " + test + " THEN " + effect + " END_IF END_IF", t.range, holes);
            if (!before.empty()) {
                Block& inner = whole[0]->branches[0].body;
                inner.insert(inner.begin(), before.begin(), before.end());
            }
            // where a breakpoint at the transition stops: only when it is taken
            whole[0]->branches[0].body.back()->branches[0].body[0]->range.end =
                std::min(t.range.end, t.range.begin + static_cast<uint32_t>(std::string_view("TRANSITION").size()));
            append(out, std::move(whole));
        }
        if (!tip.empty()) append(out, m_builder.statements(tip + " := SFCTip;", m_place));
        return out;
    }

    Block stepCalls() {
        Block out;
        for (const StepDecl* s : m_steps) append(out, m_builder.statements(step(*s) + "();", s->name.range));
        // where a breakpoint at the step stops: only when it became active; the statement changes nothing
        for (const StepDecl* s : m_steps) {
            Block activated = m_builder.statements(
                "IF " + step(*s) + ".on THEN " + step(*s) + ".enter := FALSE; END_IF", s->name.range);
            activated[0]->branches[0].body[0]->range = {s->range.file, s->range.begin, s->name.range.end};
            append(out, std::move(activated));
        }
        return out;
    }

    static bool isStepTime(const syntax::Pragma& pragma, std::string_view key) {
        return !pragma.isAttribute && equalsIgnoringCase(pragma.key, key);
    }
    void checkStepTimes() {
        for (const StepDecl* s : m_steps)
            for (const syntax::Pragma& pragma : s->pragmas)
                for (const std::string_view key : {"minTime", "maxTime"})
                    if (isStepTime(pragma, key) && !m_builder.expression(pragma.value, pragma.range))
                        m_sink.emit(pragma.range, findings::StepTime(Verbatim(std::string(key))));
    }
    /// {maxTime := T#5s}: a copy of the pragma's expression; any duration will do, a name included.
    Expr* stepTime(const StepDecl& s, std::string_view key) {
        for (const syntax::Pragma& pragma : s.pragmas)
            if (isStepTime(pragma, key)) return duration(m_builder.expression(pragma.value, pragma.range));
        return nullptr;
    }

    Block supervision() {
        Block out;
        const bool error = m_flags.has("SFCError"), name = m_flags.has("SFCErrorStep");
        if (error || name)
            for (const StepDecl* s : m_steps) {
                Expr* most = stepTime(*s, "maxTime");
                if (!most) continue;
                std::string text = "IF " + std::string(m_flags.has("SFCEnableLimit") ? "SFCEnableLimit AND " : "") +
                                   (error ? "NOT SFCError AND " : "") + step(*s) + ".X AND " + step(*s) +
                                   ".T > __hole0 THEN ";
                if (error) text += "SFCError := TRUE;";
                if (name) text += "SFCErrorStep := " + quoted(s->name.text) + ";";
                if (m_flags.has("SFCErrorPOU")) text += "SFCErrorPOU := " + quoted(m_unit.pou.name.text) + ";";
                append(out, m_builder.statements(text + " END_IF", s->name.range, {most}));
            }
        if (m_flags.has("SFCCurrentStep"))
            for (const StepDecl* s : m_steps)
                append(out, m_builder.statements("IF " + step(*s) +
                                                     ".X THEN SFCCurrentStep := " + quoted(s->name.text) + "; END_IF",
                                                 s->name.range));
        return out;
    }

    // ------------------------------------------------------------ actions

    void collectControls() {
        std::map<std::string, size_t> index;
        for (const StepDecl* s : m_steps)
            for (const ActionAssociation& a : s->actions) {
                if (!a.action.isValid()) continue;
                const std::string key = foldCase(a.action.text);
                const auto [it, isNew] = index.emplace(key, m_controls.size());
                if (isNew) {
                    Control control;
                    control.name = a.action;
                    // Otherwise it is a variable, or an action of a base, which is not known here.
                    control.isAction = m_unit.actions.contains(key);
                    control.variable =
                        "__action_" + identifierFrom(a.action.text) + (m_number == "0" ? "" : "_" + m_number);
                    m_controls.push_back(std::move(control));
                }
                associate(m_controls[it->second], *s, a);
            }
        for (Control& control : m_controls) {
            m_builder.declare(m_unit.section, m_builder.name(control.variable, control.name.range), "SFC_ACTION");
        }
    }
    static Expr* duration(Expr* e) {
        if (e) e->isDuration = true;
        return e;
    }
    /// The inputs of the action control block (2.6.4.5, figures 14 and 15). L, D and DS need no timer: the step has
    /// one.
    void associate(Control& control, const StepDecl& s, const ActionAssociation& a) {
        const std::string q = foldCase(a.qualifier.text);
        const std::string active = step(s) + ".X";
        const auto hole = [&] {
            control.holes.push_back(duration(m_builder.clone(a.time)));
            return "__hole" + std::to_string(control.holes.size() - 1);
        };
        const bool timed = q == "l" || q == "d" || q == "ds" || q == "sd" || q == "sl";
        if (timed && !a.time) return; // reported by the chart's checks
        if (q.empty() || q == "n")
            control.non.push_back(active);
        else if (q == "s")
            control.stored.push_back(active);
        else if (q == "r")
            control.reset.push_back(active);
        else if (q == "p")
            control.non.push_back(step(s) + ".on");
        else if (q == "p1")
            control.entry.push_back(step(s) + ".on");
        else if (q == "p0")
            control.exit.push_back(step(s) + ".off");
        else if (q == "l")
            control.non.push_back("(" + active + " AND " + step(s) + ".T < " + hole() + ")");
        else if (q == "d")
            control.non.push_back("(" + active + " AND " + step(s) + ".T >= " + hole() + ")");
        else if (q == "ds")
            control.stored.push_back("(" + active + " AND " + step(s) + ".T >= " + hole() + ")");
        // These go on when the step has been left, so the step's own time does not do.
        else if (q == "sd" || q == "sl") {
            const std::string variable =
                "__timed_" + identifierFrom(a.action.text) + "_" + m_number + "_" + std::to_string(m_timed++);
            m_builder.declare(m_unit.section, m_builder.name(variable, a.range),
                              q == "sd" ? "SFC_STORED_DELAY" : "SFC_STORED_LIMIT");
            control.holes.push_back(duration(m_builder.clone(a.time)));
            control.timed.push_back({variable, active, control.holes.size() - 1});
            control.non.push_back(variable + ".Q");
        }
    }

    Block controlCalls() {
        Block out;
        for (Control& control : m_controls) {
            const std::string reset = anyOf(control.reset);
            for (const Control::Timed& t : control.timed)
                append(out, m_builder.statements(t.variable + "(X := " + t.step + ", R := " + reset + ", PT := __hole" +
                                                     std::to_string(t.hole) + ");",
                                                 control.name.range, control.holes));
            append(out, m_builder.statements(control.variable + "(N := " + anyOf(control.non) +
                                                 ", S := " + anyOf(control.stored) + ", R := " + reset + ", P1 := " +
                                                 anyOf(control.entry) + ", P0 := " + anyOf(control.exit) + ");",
                                             control.name.range, control.holes));
        }
        return out;
    }

    /// What ends runs once more before what begins, so that the last word has who is active. Variables follow their
    /// control.
    static Block associated(Block block) {
        for (Stmt* stmt : block) stmt->isAssociation = true;
        return block;
    }
    /// The name may be an action of a base, which only the analysis knows: then the association runs what it holds.
    Block inherited(const Control& control, Block call) {
        Block out = associated(
            m_builder.statements(spelled(control.name.text) + " := " + control.variable + ".B;", control.name.range));
        out[0]->branches.emplace_back();
        out[0]->branches[0].body = std::move(call);
        return out;
    }
    Block actionCalls() {
        Block out;
        const auto calls = [&](const char* when) {
            for (const Control& control : m_controls)
                // A unit that extends another may name an action of it; inherited() leaves the choice to the checker.
                if (control.isAction || !m_unit.pou.extends.empty()) {
                    Block call = m_builder.statements("IF " + control.variable + "." + when + " THEN " +
                                                          spelled(control.name.text) + "(); END_IF",
                                                      control.name.range);
                    append(out, control.isAction ? std::move(call) : inherited(control, std::move(call)));
                }
        };
        for (const Control& control : m_controls)
            if (!control.isAction)
                append(out, associated(m_builder.statements(
                                spelled(control.name.text) + " := " + control.variable + ".B;", control.name.range)));
        // In this order: whoever ends writes its last, whoever begins comes behind it.
        calls("last");
        calls("entry");
        calls("Q");
        return out;
    }

    // ------------------------------------------------------------ CODESYS flags

    Block reset(std::string_view) {
        Block out;
        std::string text;
        for (const StepDecl* s : m_steps) text += step(*s) + ".reset();";
        for (const Control& control : m_controls) {
            text += control.variable + ".reset();";
            for (const Control::Timed& t : control.timed) text += t.variable + ".reset();";
            if (!control.isAction)
                append(out,
                       associated(m_builder.statements(spelled(control.name.text) + " := FALSE;", control.name.range)));
        }
        if (m_flags.has("SFCError")) text += "SFCError := FALSE;";
        if (m_flags.has("SFCErrorStep")) text += "SFCErrorStep := '';";
        text += chartVariable() + " := FALSE;";
        for (const StepDecl* s : m_steps)
            if (s->isInitial) text += step(*s) + ".enter := TRUE;" + step(*s) + "();";
        append(out, m_builder.statements(text, m_place));
        return out;
    }

    Block paused(Block work) {
        std::vector<std::string> stops;
        if (m_flags.has("SFCPause")) stops.push_back("SFCPause");
        if (m_flags.has("SFCQuitError") && m_flags.has("SFCError")) stops.push_back("SFCQuitError");
        if (stops.empty()) return work;
        Block out;
        // The times of the steps begin again, or the limit that was exceeded would be exceeded at once.
        if (stops.back() == "SFCQuitError") {
            std::string text = "IF SFCQuitError THEN SFCError := FALSE;";
            for (const StepDecl* s : m_steps) text += step(*s) + ".restart();";
            append(out, m_builder.statements(text + " END_IF", m_place));
        }
        Block guard = m_builder.statements("IF NOT " + anyOf(stops) + " THEN END_IF", m_place);
        guard[0]->branches[0].body = std::move(work);
        append(out, std::move(guard));
        return out;
    }

    const syntax::SfcBody& m_chart;
    SourceRange m_place;
    ChartUnit& m_unit;
    Builder& m_builder;
    diagnostics::Sink& m_sink;
    Flags m_flags;
    std::string m_number;
    std::vector<const StepDecl*> m_steps;
    std::map<std::string, const StepDecl*> m_known;
    std::set<const StepDecl*> m_clashing;
    std::vector<const TransitionDecl*> m_transitions;
    std::vector<Control> m_controls;
    int m_timed = 0;
};

} // namespace

Block lowerChart(const syntax::SfcBody& chart, SourceRange place, ChartUnit& unit, Builder& builder,
                 diagnostics::Sink& sink) {
    return ChartLowering(chart, place, unit, builder, sink).run();
}

} // namespace plc::lower
