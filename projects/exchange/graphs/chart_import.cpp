#include "projects/exchange/graphs/chart_import.h"

#include "projects/exchange/base/assemble.h"
#include "projects/exchange/graphs/macro_steps.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <set>

namespace plc::exchange {

namespace {

using Names = std::vector<std::string>;

constexpr size_t kMostPaths = 4096; // alternatives of one transition: a chart with more is no chart

class ChartReader {
public:
    ChartReader(pugi::xml_node sfc, const XmlFile& file, std::string unit,
                const std::map<std::string, std::string>& conditions, const DiagramNames& names, Report& report)
        : m_sfc(sfc), m_file(file), m_unit(std::move(unit)), m_conditions(conditions), m_report(report),
          m_diagram(sfc, file, m_unit, names, report), m_names(names) {
        for (const pugi::xml_node node : sfc.children())
            if (const std::string id = attribute(node, "localId"); !id.empty()) m_nodes.emplace(id, node);
        for (const pugi::xml_node node : sfc.children())
            if (is(node, "step")) m_steps.emplace(foldCase(attribute(node, "name")), m_steps.size());
    }

    ChartText read() {
        gatherActions();
        gatherTargets();
        for (const pugi::xml_node node : m_sfc.children())
            if (is(node, "transition")) m_conditionOf[attribute(node, "localId")] = conditionText(node);
        callBlocksOfConditions();
        for (const pugi::xml_node node : m_sfc.children()) {
            if (is(node, "step")) writeStep(node);
            if (is(node, "transition")) writeTransition(node);
            if (is(node, "macroStep"))
                m_report.add(place(node), remarks::ElementNotRead("macroStep " + attribute(node, "name")));
        }
        for (auto& each : m_diagram.variables()) m_out.variables.push_back(std::move(each));
        return std::move(m_out);
    }

private:
    std::string place(pugi::xml_node node) const {
        return m_file.place() + ":" + std::to_string(m_file.lineOf(node)) + " (" + m_unit + ")";
    }
    pugi::xml_node find(const std::string& id) const {
        const auto it = m_nodes.find(id);
        return it == m_nodes.end() ? pugi::xml_node() : it->second;
    }
    static std::vector<std::string> sources(pugi::xml_node node) {
        std::vector<std::string> out;
        for (const pugi::xml_node point : node.children())
            if (is(point, "connectionPointIn"))
                for (const pugi::xml_node connection : point.children())
                    if (is(connection, "connection")) out.push_back(attribute(connection, "refLocalId"));
        return out;
    }

    /// The sets of steps that lead to `node`, through divergences and convergences above it.
    std::vector<Names> stepsAbove(pugi::xml_node node, int depth = 0) {
        if (depth > 100) return {};
        if (is(node, "step")) return {{attribute(node, "name")}};
        if (is(node, "simultaneousConvergence")) { // all of them
            std::vector<Names> all = {{}};
            for (const std::string& id : sources(node)) {
                std::vector<Names> next;
                for (const Names& known : all)
                    for (const Names& more : stepsAbove(find(id), depth + 1)) {
                        Names joined = known;
                        joined.insert(joined.end(), more.begin(), more.end());
                        if (next.size() < kMostPaths) next.push_back(std::move(joined));
                    }
                all = std::move(next);
            }
            return all;
        }
        std::vector<Names> any;
        if (is(node, "selectionDivergence") || is(node, "selectionConvergence"))
            for (const std::string& id : sources(node))
                for (Names& each : stepsAbove(find(id), depth + 1)) any.push_back(std::move(each));
        return any;
    }

    /// The transitions that lead to `node`, through convergences and divergences above it.
    void transitionsAbove(pugi::xml_node node, std::vector<std::string>& out, int depth = 0) const {
        if (depth > 100) return;
        for (const std::string& id : sources(node)) {
            const pugi::xml_node above = find(id);
            if (is(above, "transition"))
                out.push_back(id);
            else if (is(above, "selectionConvergence") || is(above, "simultaneousDivergence") ||
                     is(above, "selectionDivergence"))
                transitionsAbove(above, out, depth + 1);
        }
    }

    void gatherTargets() {
        for (const pugi::xml_node node : m_sfc.children()) {
            std::string name;
            if (is(node, "step")) name = attribute(node, "name");
            if (is(node, "jumpStep")) {
                name = attribute(node, "targetName");
                if (!m_steps.count(foldCase(name))) {
                    m_report.add(place(node), remarks::ChartJumpUnknown(name));
                    continue;
                }
            }
            if (name.empty()) continue;
            std::vector<std::string> above;
            transitionsAbove(node, above);
            for (const std::string& id : above) {
                Names& targets = m_targets[id];
                if (std::find(targets.begin(), targets.end(), name) == targets.end()) targets.push_back(name);
            }
        }
        // the branches' order is that of their first steps, however they are drawn
        for (auto& [id, targets] : m_targets)
            std::stable_sort(targets.begin(), targets.end(), [&](const std::string& a, const std::string& b) {
                return m_steps[foldCase(a)] < m_steps[foldCase(b)];
            });
    }

    void gatherActions() {
        for (const pugi::xml_node block : m_sfc.children()) {
            if (!is(block, "actionBlock")) continue;
            for (const std::string& id : sources(block)) {
                const pugi::xml_node step = find(id);
                if (!is(step, "step")) continue;
                std::string& lines = m_actions[attribute(step, "name")];
                for (const pugi::xml_node action : block.children())
                    if (is(action, "action")) lines += association(action, attribute(step, "name"));
            }
        }
    }

    std::string association(pugi::xml_node action, const std::string& step) {
        std::string name = attribute(childOf(action, "reference"), "name");
        if (name.empty()) name = inlineAction(childOf(action, "inline"), step);
        if (name.empty()) {
            m_report.add(place(action), remarks::ElementNotRead(Verbatim("action")));
            return {};
        }
        std::string qualifier = attribute(action, "qualifier");
        const std::string duration = trimmed(attribute(action, "duration"));
        std::string out = "    " + name + "(" + (qualifier.empty() ? "N" : qualifier);
        if (!duration.empty()) out += ", " + duration;
        if (const std::string indicator = trimmed(attribute(action, "indicator")); !indicator.empty())
            out += ", " + indicator;
        return out + ");\n";
    }

    std::string inlineAction(pugi::xml_node inlined, const std::string& step) {
        if (!inlined) return {};
        for (const char* language : {"ST", "IL"})
            if (const pugi::xml_node body = childOf(inlined, language)) {
                std::string text = trimmedLines(textOf(body));
                // a single name is a BOOL variable or an action
                if (isName(text)) return text;
                std::string name = step + "_Action" + std::to_string(++m_inlineCount[step]);
                m_out.actions.emplace_back(name, std::move(text));
                return name;
            }
        for (const char* language : {"LD", "FBD"})
            if (const pugi::xml_node body = childOf(inlined, language)) {
                Diagram diagram(body, m_file, m_unit, {}, m_report);
                DiagramText text = diagram.statements();
                std::string name = step + "_Action" + std::to_string(++m_inlineCount[step]);
                m_out.actions.emplace_back(name, std::move(text.statements));
                for (auto& variable : text.variables) m_out.variables.push_back(std::move(variable));
                return name;
            }
        return {};
    }

    static bool isName(std::string_view text) {
        return !text.empty() && !(text[0] >= '0' && text[0] <= '9') &&
               std::all_of(text.begin(), text.end(),
                           [](unsigned char c) { return std::isalnum(c) || c == '_' || c >= 0x80; });
    }

    /// What CODESYS keeps of a step: the names of its entry, main and exit actions.
    std::string ownActions(pugi::xml_node step) const {
        struct Row {
            std::string_view ending, qualifier;
        };
        static constexpr Row rows[] = {{"_entry", "P1"}, {"_active", "N"}, {"_exit", "P0"}};
        std::string out;
        const std::string stem = foldCase(attribute(step, "name"));
        for (const pugi::xml_node each : childOf(dataOf(step, "/sfc/element"), "attributes").children()) {
            const std::string value = trimmed(textOf(each));
            const std::string folded = foldCase(value);
            for (const Row& row : rows)
                if (isName(value) && folded.ends_with(foldCase(row.ending)) && folded.find(stem) != std::string::npos)
                    out += "    " + value + "(" + std::string(row.qualifier) + ");\n";
        }
        return out;
    }

    /// {minTime := T#1s}
    static std::string pragmas(pugi::xml_node step) {
        std::string out;
        for (const pugi::xml_node each : childOf(dataOf(step, "/attributes"), "Attributes").children())
            if (is(each, "Attribute")) out += " {" + attribute(each, "Name") + " := " + attribute(each, "Value") + "}";
        return out;
    }

    void writeStep(pugi::xml_node step) {
        const std::string name = attribute(step, "name");
        m_out.text += commentLines(textOf(childOf(step, "documentation")), "");
        m_out.text += isTrue(step, "initialStep") ? "INITIAL_STEP " : "STEP ";
        m_out.text += name + pragmas(step) + ":\n" + ownActions(step) + m_actions[name] + "END_STEP\n";
        if (const pugi::xml_node position = childOf(step, "position"))
            m_out.positions[name] = {std::atoi(position.attribute("x").value()),
                                     std::atoi(position.attribute("y").value())};
    }

    std::string conditionText(pugi::xml_node transition) {
        const pugi::xml_node condition = childOf(transition, "condition");
        std::string text;
        if (const pugi::xml_node reference = childOf(condition, "reference")) {
            const auto it = m_conditions.find(foldCase(attribute(reference, "name")));
            text = it != m_conditions.end() ? it->second : attribute(reference, "name");
        } else if (const pugi::xml_node inlined = childOf(condition, "inline")) {
            if (childOf(inlined, "ST"))
                text = conditionOf(textOf(childOf(inlined, "ST")));
            else if (childOf(inlined, "IL"))
                return ":\n" + trimmedLines(textOf(childOf(inlined, "IL")));
        } else if (const pugi::xml_node point = childOf(condition, "connectionPointIn")) {
            text = m_diagram.expressionAt(point);
            // CODESYS draws a named transition as a variable of that name
            const auto it = m_conditions.find(foldCase(text));
            if (it != m_conditions.end()) text = it->second;
        }
        if (isTrue(condition, "negated") && !text.empty()) text = "NOT (" + text + ")";
        return text;
    }

    /// A condition calls nothing: an action that is stored from the initial step on calls what conditions are drawn
    /// with.
    void callBlocksOfConditions() {
        std::string statements = m_diagram.pendingStatements();
        if (statements.empty()) return;
        std::string name = "CallBlocks";
        const auto isTaken = [&] {
            return m_steps.count(foldCase(name)) > 0 || m_names.variableTypes.count(foldCase(name)) > 0;
        };
        while (isTaken()) name += '_';
        for (const pugi::xml_node step : m_sfc.children())
            if (is(step, "step") && isTrue(step, "initialStep"))
                m_actions[attribute(step, "name")] += "    " + name + "(S);\n";
        m_out.actions.emplace_back(name, std::move(statements));
        m_report.add(place(m_sfc), remarks::ConditionWithBlock(m_unit, name));
    }

    static std::string listOf(const Names& names) {
        if (names.size() == 1) return names.front();
        std::string out;
        for (const std::string& name : names) out += (out.empty() ? "(" : ", ") + name;
        return out + ")";
    }

    void writeTransition(pugi::xml_node transition) {
        std::vector<Names> from;
        for (const std::string& id : sources(transition))
            for (Names& each : stepsAbove(find(id))) from.push_back(std::move(each));
        const auto to = m_targets.find(attribute(transition, "localId"));
        if (from.empty() || to == m_targets.end()) {
            m_report.add(place(transition),
                         remarks::ChartNotConnected("transition " + attribute(transition, "localId")));
            return;
        }
        std::string condition = m_conditionOf[attribute(transition, "localId")];
        if (condition.empty()) {
            m_report.add(place(transition), remarks::ConditionMissing(listOf(from.front())));
            condition = "FALSE";
        }
        const std::string priority = attribute(transition, "priority");
        for (const Names& names : from) {
            if (names.empty()) continue;
            m_out.text += commentLines(textOf(childOf(transition, "documentation")), "");
            m_out.text += "TRANSITION ";
            if (!priority.empty() && priority != "0") m_out.text += "(PRIORITY := " + priority + ") ";
            m_out.text += "FROM " + listOf(names) + " TO " + listOf(to->second);
            m_out.text += condition.starts_with(":") ? condition : " := " + condition + ";";
            m_out.text += condition.find('\n') == std::string::npos ? " END_TRANSITION\n" : "\nEND_TRANSITION\n";
        }
    }

    pugi::xml_node m_sfc;
    const XmlFile& m_file;
    std::string m_unit;
    const std::map<std::string, std::string>& m_conditions;
    Report& m_report;
    Diagram m_diagram;
    std::map<std::string, pugi::xml_node> m_nodes;
    std::map<std::string, size_t> m_steps; // folded name → place in the file
    std::map<std::string, std::string> m_actions;
    std::map<std::string, Names> m_targets; // of a transition's id
    std::map<std::string, int> m_inlineCount;
    std::map<std::string, std::string> m_conditionOf; // a transition's id
    const DiagramNames& m_names;
    ChartText m_out;
};

} // namespace

std::string conditionOf(const std::string& statements) {
    std::string text = trimmed(statements);
    while (text.ends_with(';')) text = trimmed(text.substr(0, text.size() - 1));
    const size_t assign = text.find(":=");
    if (assign == std::string::npos) return text;
    const std::string before = trimmed(text.substr(0, assign));
    // "Name := …" and ":= …"; an argument of a call is deeper
    return before.find_first_of("(\n ") == std::string::npos ? trimmed(text.substr(assign + 2)) : text;
}

ChartText chartText(pugi::xml_node sfc, const XmlFile& file, const std::string& unit,
                    const std::map<std::string, std::string>& transitions, const DiagramNames& names, Report& report) {
    expandMacroSteps(sfc, file, unit, report);
    return ChartReader(sfc, file, unit, transitions, names, report).read();
}

} // namespace plc::exchange
