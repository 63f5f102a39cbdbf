// Random charts: what is written is what the model reads, an edit that changes nothing changes no byte, and every other
// edit changes the chart by just that edit. Each round prints its seed when it fails.
#include "runtime/compiler/chart/chart.h"
#include "runtime/compiler/chart/edits.h"
#include "runtime/compiler/chart/layout.h"
#include "runtime/compiler/parse/parser.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <memory>

using namespace plc;
using namespace plc::chart;

namespace {

class Random {
public:
    explicit Random(uint32_t seed) : m_state(seed * 2654435761u + 1) {}
    size_t operator()(size_t limit) {
        m_state = m_state * 1664525u + 1013904223u;
        return static_cast<size_t>((m_state >> 8) % std::max<size_t>(1, limit));
    }

private:
    uint32_t m_state;
};

/// A chart without its formatting.
struct Spec {
    struct Association {
        std::string action, qualifier, time;
        bool operator==(const Association&) const = default;
    };
    struct Step {
        std::string name;
        bool isInitial = false;
        std::vector<Association> actions;
        std::string minTime;
        bool operator==(const Step&) const = default;
    };
    struct Transition {
        std::string name, priority;
        std::vector<std::string> from, to;
        std::string condition;
        bool operator==(const Transition&) const = default;
    };
    std::vector<Step> steps;
    std::vector<Transition> transitions;
    bool operator==(const Spec&) const = default;

    std::string text() const {
        std::string out;
        for (const Step& s : steps) {
            out += (s.isInitial ? "initial " : "step ") + s.name + " " + s.minTime;
            for (const Association& a : s.actions) out += " [" + a.action + " " + a.qualifier + " " + a.time + "]";
            out += "\n";
        }
        for (const Transition& t : transitions) {
            out += "transition " + t.name + " (" + t.priority + ")";
            for (const auto& f : t.from) out += " " + f;
            out += " ->";
            for (const auto& to : t.to) out += " " + to;
            out += " := " + t.condition + "\n";
        }
        return out;
    }
};

/// The text of a spec, formatted as it comes: comments, blank lines, blanks, one line or several, either end of line.
std::string write(const Spec& spec, Random& random) {
    const std::string end = random(4) == 0 ? "\r\n" : "\n";
    std::string out = "(* before *)" + end + "PROGRAM p" + end + "VAR go, full, lamp, motor : BOOL; END_VAR" + end;
    int note = 0;
    const auto gap = [&] {
        if (random(3) == 0) out += end;
        if (random(3) == 0) out += "// note " + std::to_string(note++) + end;
        if (random(5) == 0) out += "    (* note " + std::to_string(note++) + " *)" + end;
        out += std::string(random(3) * 2, ' ');
    };
    const auto names = [&](const std::vector<std::string>& list) {
        std::string text;
        for (const std::string& name : list) text += (text.empty() ? "" : random(2) ? ", " : ",") + name;
        return list.size() > 1 || random(5) == 0 ? "(" + text + ")" : text;
    };
    const auto tail = [&] { out += (random(4) == 0 ? " // behind" : "") + end; };
    size_t s = 0, t = 0;
    while (s < spec.steps.size() || t < spec.transitions.size()) {
        const bool isStep = t == spec.transitions.size() || (s < spec.steps.size() && (s == 0 || random(2)));
        gap();
        if (isStep) {
            const Spec::Step& step = spec.steps[s++];
            out += (step.isInitial ? "INITIAL_STEP " : "STEP ") + step.name +
                   (step.minTime.empty() ? "" : " {minTime := " + step.minTime + "}") + ":";
            const bool lines = random(2);
            for (const Spec::Association& a : step.actions)
                out += (lines ? end + "    " : " ") + a.action + "(" + a.qualifier +
                       (a.time.empty() ? "" : ", " + a.time) + ");" +
                       (lines && random(4) == 0 ? " (* of " + a.action + " *)" : "");
            out += (lines ? end : std::string(" ")) + "END_STEP";
        } else {
            const Spec::Transition& transition = spec.transitions[t++];
            out += "TRANSITION" + (transition.name.empty() ? "" : " " + transition.name) +
                   (transition.priority.empty() ? "" : " (PRIORITY := " + transition.priority + ")");
            const std::string sep = random(3) == 0 ? end + "    " : std::string(" ");
            out += sep + "FROM " + names(transition.from) + " TO " + names(transition.to) +
                   " := " + transition.condition + ";" + sep + "END_TRANSITION";
        }
        tail();
    }
    return out + "ACTION run: n := n + 1; END_ACTION" + end + "END_PROGRAM" + end + "// the end" + end;
}

struct Opened {
    std::string text;
    std::unique_ptr<syntax::SyntaxFile> file;
    const syntax::Pou* pou = nullptr;
    Chart chart;
    std::string errors;

    explicit Opened(std::string source) : text(std::move(source)) {
        diagnostics::Sink sink;
        file = parse::parseFile(FileId(0), text, sink);
        for (const auto& d : sink.all())
            if (d.severity == diagnostics::Severity::Error) errors += d.message.english() + "\n";
        pou = file->declarations.at(0)->pou;
        if (pou->body.chart) chart = build(*pou->body.chart);
    }
    ChartEditor editor() const { return {text, *pou, chart}; }
    std::string slice(SourceRange range) const { return text.substr(range.begin, range.length()); }

    Spec spec() const {
        Spec out;
        for (const Step& s : chart.steps) {
            Spec::Step step{std::string(s.decl->name.text), s.decl->isInitial, {}, {}};
            for (const auto& a : s.decl->actions)
                step.actions.push_back(
                    {std::string(a.action.text), std::string(a.qualifier.text), a.time ? slice(a.time->range) : ""});
            for (const auto& pragma : s.decl->pragmas) step.minTime = std::string(pragma.value);
            out.steps.push_back(step);
        }
        for (const Transition& t : chart.transitions) {
            Spec::Transition transition{std::string(t.decl->name.text),
                                        t.decl->priority ? slice(t.decl->priority->range) : "",
                                        {},
                                        {},
                                        t.decl->condition ? slice(t.decl->condition->range) : ""};
            for (const auto& name : t.decl->from) transition.from.emplace_back(name.text);
            for (const auto& name : t.decl->to) transition.to.emplace_back(name.text);
            out.transitions.push_back(transition);
        }
        return out;
    }
};

const char* const kConditions[] = {"go", "NOT full", "go AND (lamp OR NOT motor)", "S0.T > T#1s", "TRUE"};
const char* const kActions[] = {"lamp", "motor", "run"};
struct Qualified {
    const char *qualifier, *time;
};
constexpr Qualified kQualifiers[] = {{"N", ""},      {"S", ""},         {"R", ""},     {"P", ""},
                                     {"P0", ""},     {"P1", ""},        {"D", "T#2s"}, {"L", "T#1s"},
                                     {"SD", "T#3s"}, {"DS", "T#100ms"}, {"SL", "T#5s"}};

Spec randomSpec(Random& random) {
    Spec spec;
    const size_t count = 2 + random(8);
    for (size_t i = 0; i < count; ++i) {
        Spec::Step step{"S" + std::to_string(i), i == 0, {}, random(6) == 0 ? "T#1s" : ""};
        for (size_t k = random(4); k > 0; --k) {
            const Qualified& q = kQualifiers[random(std::size(kQualifiers))];
            step.actions.push_back({kActions[random(std::size(kActions))], q.qualifier, q.time});
        }
        spec.steps.push_back(step);
    }
    const auto some = [&](size_t most) {
        std::vector<std::string> out;
        for (size_t n = 1 + random(most), first = random(count); n > 0; --n) {
            const std::string name = "S" + std::to_string((first + n) % count);
            if (std::find(out.begin(), out.end(), name) == out.end()) out.push_back(name);
        }
        return out;
    };
    for (size_t i = 0; i < count + random(count); ++i)
        spec.transitions.push_back({random(5) == 0 ? "t" + std::to_string(i) : "",
                                    random(5) == 0 ? std::to_string(1 + random(9)) : "", some(random(4) == 0 ? 3 : 1),
                                    some(random(4) == 0 ? 3 : 1), kConditions[random(std::size(kConditions))]});
    return spec;
}

/// Every line of a comment that stands in a text.
std::vector<std::string> notesIn(const std::string& text) {
    std::vector<std::string> out;
    for (size_t at = 0; (at = text.find("note ", at)) != std::string::npos; ++at)
        out.push_back(text.substr(at, text.find_first_of(" *\r\n", at + 5) - at));
    std::sort(out.begin(), out.end());
    return out;
}

} // namespace

TEST(RandomCharts, AreReadAsTheyWereWrittenAndKeepEveryByteOfAnEditThatChangesNothing) {
    for (uint32_t seed = 1; seed <= 150; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Spec spec = randomSpec(random);
        const Opened o(write(spec, random));
        ASSERT_EQ(o.errors, "") << o.text;
        ASSERT_EQ(o.spec().text(), spec.text()) << o.text;
        const auto same = [&](const Result<Edits>& edits) {
            ASSERT_TRUE(edits) << edits.error().english();
            EXPECT_EQ(applyEdits(o.text, *edits), o.text);
        };
        for (size_t i = 0; i < spec.transitions.size(); ++i) {
            const TransitionId id(i);
            same(o.editor().setCondition(id, spec.transitions[i].condition));
            same(o.editor().setPriority(
                id, spec.transitions[i].priority.empty() ? 0 : std::stoi(spec.transitions[i].priority)));
            same(o.editor().moveTransition(id, Place::Before, id));
        }
        for (size_t i = 0; i < spec.steps.size(); ++i) {
            const StepId id(i);
            same(o.editor().renameStep(id, spec.steps[i].name));
            if (!spec.steps[i].minTime.empty()) same(o.editor().setStepTime(id, "minTime", spec.steps[i].minTime));
            for (size_t k = 0; k < spec.steps[i].actions.size(); ++k)
                same(o.editor().changeAction(id, k, spec.steps[i].actions[k].action, spec.steps[i].actions[k].qualifier,
                                             spec.steps[i].actions[k].time));
        }
        // the parts, put together again in the order of the text, are the text
        std::vector<SourceRange> parts;
        for (const Step& s : o.chart.steps) parts.push_back(s.decl->extent);
        for (const Transition& t : o.chart.transitions) parts.push_back(t.decl->extent);
        std::sort(parts.begin(), parts.end(), [](SourceRange a, SourceRange b) { return a.begin < b.begin; });
        std::string whole;
        uint32_t at = 0;
        for (const SourceRange& part : parts) {
            ASSERT_GE(part.begin, at) << "two parts share " << o.slice(part);
            whole += o.text.substr(at, part.begin - at) + o.slice(part);
            at = part.end;
        }
        EXPECT_EQ(whole + o.text.substr(at), o.text);
    }
}

TEST(RandomCharts, DifferByTheEditOnly) {
    int done = 0;
    std::vector<int> perKind(12);
    for (uint32_t seed = 1; seed <= 120; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed * 7919);
        std::string text = write(randomSpec(random), random);
        for (int round = 0; round < 8; ++round) {
            const Opened o(text);
            ASSERT_EQ(o.errors, "") << text;
            if (o.chart.steps.empty() || o.chart.transitions.empty()) break;
            Spec wanted = o.spec();
            const size_t s = random(o.chart.steps.size()), t = random(o.chart.transitions.size()),
                         u = random(o.chart.transitions.size()), other = random(o.chart.steps.size());
            const StepId step(s);
            const TransitionId transition(t), anchor(u);
            const size_t kind = random(perKind.size());
            const ChartEditor editor = o.editor();
            Result<Edits> edits = Error{};
            bool keepsNotes = true;
            switch (kind) {
            case 0:
                edits = editor.setCondition(transition, "full AND lamp");
                wanted.transitions[t].condition = "full AND lamp";
                break;
            case 1:
                edits = editor.setPriority(transition, 4);
                wanted.transitions[t].priority = "4";
                break;
            case 2:
                edits = editor.setPriority(transition, 0);
                wanted.transitions[t].priority = "";
                break;
            case 3: {
                const std::string name = "New" + std::to_string(done);
                edits = editor.renameStep(step, name);
                const std::string old = wanted.steps[s].name;
                wanted.steps[s].name = name;
                for (auto& each : wanted.transitions) {
                    std::replace(each.from.begin(), each.from.end(), old, name);
                    std::replace(each.to.begin(), each.to.end(), old, name);
                    if (old == "S0" && each.condition == "S0.T > T#1s") each.condition = name + ".T > T#1s";
                }
                break;
            }
            case 4:
                edits = editor.insertAction(step, wanted.steps[s].actions.size(), "lamp", "D", "T#7s");
                wanted.steps[s].actions.push_back({"lamp", "D", "T#7s"});
                break;
            case 5: {
                if (wanted.steps[s].actions.empty()) continue;
                const size_t k = random(wanted.steps[s].actions.size());
                edits = editor.deleteAction(step, k);
                wanted.steps[s].actions.erase(wanted.steps[s].actions.begin() + static_cast<std::ptrdiff_t>(k));
                break;
            }
            case 6: {
                if (wanted.steps[s].actions.empty()) continue;
                const size_t k = random(wanted.steps[s].actions.size());
                edits = editor.changeAction(step, k, "motor", "SL", "T#9s");
                wanted.steps[s].actions[k] = {"motor", "SL", "T#9s"};
                break;
            }
            case 7: {
                if (wanted.steps[s].actions.size() < 2) continue;
                const size_t from = random(wanted.steps[s].actions.size()), to = random(wanted.steps[s].actions.size());
                edits = editor.moveAction(step, from, to);
                auto& list = wanted.steps[s].actions;
                const Spec::Association moved = list[from];
                list.erase(list.begin() + static_cast<std::ptrdiff_t>(from));
                list.insert(list.begin() + static_cast<std::ptrdiff_t>(to), moved);
                break;
            }
            case 8: {
                if (t == u) continue;
                const bool before = random(2);
                edits = editor.moveTransition(transition, before ? Place::Before : Place::After, anchor);
                auto& list = wanted.transitions;
                const Spec::Transition moved = list[t];
                list.erase(list.begin() + static_cast<std::ptrdiff_t>(t));
                const size_t at = (u > t ? u - 1 : u) + (before ? 0 : 1);
                list.insert(list.begin() + static_cast<std::ptrdiff_t>(at), moved);
                break;
            }
            case 9:
                edits = editor.deleteTransition(transition);
                wanted.transitions.erase(wanted.transitions.begin() + static_cast<std::ptrdiff_t>(t));
                keepsNotes = false; // those of the transition go with it
                break;
            case 10: {
                if (wanted.transitions[t].to.size() < 2) continue;
                edits = editor.moveParallel(transition, 0, 1);
                std::swap(wanted.transitions[t].to[0], wanted.transitions[t].to[1]);
                break;
            }
            default: {
                if (wanted.transitions[t].to.size() != 1) continue;
                edits = editor.setTarget(transition, o.chart.find(wanted.transitions[t].to[0]), StepId(other));
                wanted.transitions[t].to = {wanted.steps[other].name};
            }
            }
            if (!edits) continue;
            const std::string next = applyEdits(text, *edits);
            ASSERT_EQ(applyEdits(next, inverseOf(text, *edits)), text);
            const Opened after(next);
            ASSERT_EQ(after.errors, "") << "edit " << kind << "\n" << text << "\n----\n" << next;
            ASSERT_EQ(after.spec().text(), wanted.text()) << "edit " << kind << "\n" << text << "\n----\n" << next;
            if (keepsNotes) {
                ASSERT_EQ(notesIn(next), notesIn(text)) << "edit " << kind << "\n" << text << "\n----\n" << next;
            }
            (void)computeLayout(after.chart);
            text = next;
            ++done;
            ++perKind[kind];
        }
    }
    for (size_t kind = 0; kind < perKind.size(); ++kind)
        EXPECT_GT(perKind[kind], 5) << "edit " << kind << " was hardly tried";
    EXPECT_GT(done, 500);
}
