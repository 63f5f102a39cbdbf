#include "projects/exchange/plcopen/chart_export.h"

#include "projects/exchange/base/xml.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <map>

namespace plc::exchange {

namespace {

constexpr int kColumn = 200, kRow = 100; // of the layout, in the units of the format

class ChartWriter {
public:
    ChartWriter(pugi::xml_node sfc, const syntax::SfcBody& body, const nlohmann::ordered_json& positions,
                const XmlWriter& writer)
        : m_sfc(sfc), m_body(body), m_positions(positions), m_writer(writer) {}

    void write() {
        number();
        size_t step = 0, transition = 0; // in order of the text
        while (step < m_body.steps.size() || transition < m_body.transitions.size()) {
            const bool isStep = transition == m_body.transitions.size() ||
                                (step < m_body.steps.size() &&
                                 m_body.steps[step]->range.begin < m_body.transitions[transition]->range.begin);
            if (isStep)
                writeStep(*m_body.steps[step++]);
            else
                writeTransition(*m_body.transitions[transition++]);
        }
    }

private:
    static std::string key(std::string_view name) { return foldCase(name); }
    int next() { return m_next++; }

    /// Ids first: connections name elements that are written later.
    void number() {
        for (const syntax::StepDecl* step : m_body.steps) m_stepIds.emplace(key(step->name.text), next());
        for (const syntax::TransitionDecl* each : m_body.transitions) {
            m_transitionIds[each] = next();
            for (const syntax::Name& from : each->from) ++m_ways[key(from.text)];
            if (each->to.size() > 1) m_divergenceIds[each] = next();
            // the first way into a step is drawn, every other one is a jump
            for (const syntax::Name& to : each->to)
                if (m_stepIds.count(key(to.text)) && !isInitial(to.text) && !m_entries.count(key(to.text)))
                    m_entries[key(to.text)] = each;
        }
        for (const auto& [name, count] : m_ways)
            if (count > 1) m_selectionIds[name] = next();
    }
    bool isInitial(std::string_view name) const {
        return std::any_of(m_body.steps.begin(), m_body.steps.end(), [&](const syntax::StepDecl* step) {
            return step->isInitial && equalsIgnoringCase(step->name.text, name);
        });
    }

    pugi::xml_node element(const char* tag, int id) {
        pugi::xml_node node = m_sfc.append_child(tag);
        node.append_attribute("localId") = id;
        return node;
    }
    static void place(pugi::xml_node node, int x, int y) {
        pugi::xml_node position = node.append_child("position");
        position.append_attribute("x") = x;
        position.append_attribute("y") = y;
    }
    static void size(pugi::xml_node node, int width, int height) {
        node.append_attribute("width") = width;
        node.append_attribute("height") = height;
    }
    static void connect(pugi::xml_node node, int id, const char* pin = nullptr) {
        pugi::xml_node point = node.append_child("connectionPointIn");
        pugi::xml_node connection = point.append_child("connection");
        connection.append_attribute("refLocalId") = id;
        if (pin) connection.append_attribute("formalParameter") = pin;
    }
    static void out(pugi::xml_node node) {
        node.append_child("connectionPointOut").append_attribute("formalParameter") = "sfc";
    }

    /// What a connection from a transition to a step leads through.
    int sourceOf(const syntax::TransitionDecl* transition) const {
        const auto it = m_divergenceIds.find(transition);
        return it != m_divergenceIds.end() ? it->second : m_transitionIds.at(transition);
    }

    void writeStep(const syntax::StepDecl& step) {
        const std::string name(step.name.text);
        const int id = m_stepIds.at(key(name));
        pugi::xml_node node = element("step", id);
        if (step.isInitial) node.append_attribute("initialStep") = true;
        node.append_attribute("name") = name.c_str();
        size(node, 60, 30);
        int x = kColumn, y = kRow * (1 + m_line++);
        if (m_positions.contains(name) && m_positions[name].is_array() && m_positions[name].size() == 2 &&
            m_positions[name][0].is_number_integer() && m_positions[name][1].is_number_integer()) {
            x = m_positions[name][0].get<int>();
            y = m_positions[name][1].get<int>();
        }
        m_x = x, m_y = y;
        place(node, x, y);
        if (const auto entry = m_entries.find(key(name)); entry != m_entries.end())
            connect(node, sourceOf(entry->second), "sfc");
        else
            node.append_child("connectionPointIn");
        out(node);
        if (!step.actions.empty())
            node.append_child("connectionPointOutAction").append_attribute("formalParameter") = "x";
        writePragmas(node, step);
        m_writer.documentation(node, commentAbove(step.extent, step.range));
        writeActions(step, id);
        if (const auto it = m_selectionIds.find(key(name)); it != m_selectionIds.end()) {
            pugi::xml_node selection = element("selectionDivergence", it->second);
            size(selection, kColumn, 1);
            place(selection, x, y + 40);
            connect(selection, id, "sfc");
            for (int i = 0; i < m_ways[key(name)]; ++i) out(selection);
        }
    }

    /// {minTime := T#1s} as an attribute of the step.
    void writePragmas(pugi::xml_node node, const syntax::StepDecl& step) {
        if (step.pragmas.empty()) return;
        if (m_writer.isPlain()) return m_writer.lose(remarks::PragmaNotInEdition(step.pragmas.front().text));
        pugi::xml_node list =
            XmlWriter::data(node, "http://www.3s-software.com/plcopenxml/attributes").append_child("Attributes");
        for (const syntax::Pragma& pragma : step.pragmas) {
            pugi::xml_node each = list.append_child("Attribute");
            each.append_attribute("Name") = std::string(pragma.key).c_str();
            each.append_attribute("Value") = std::string(pragma.value).c_str();
        }
    }

    std::string commentAbove(SourceRange extent, SourceRange range) const {
        std::string out;
        const std::string_view above = m_writer.source().all().substr(extent.begin, range.begin - extent.begin);
        for (size_t at = 0; at < above.size();) {
            const size_t end = std::min(above.find('\n', at), above.size());
            std::string line = trimmed(above.substr(at, end - at));
            while (line.starts_with("/")) line.erase(0, 1);
            if (line.starts_with("(*")) line = line.substr(2);
            if (line.ends_with("*)")) line.resize(line.size() - 2);
            if (line = trimmed(line); !line.empty()) out += (out.empty() ? "" : "\n") + line;
            at = end + 1;
        }
        return out;
    }

    void writeActions(const syntax::StepDecl& step, int stepId) {
        if (step.actions.empty()) return;
        pugi::xml_node block = element("actionBlock", next());
        size(block, 120, 30 * static_cast<int>(step.actions.size()));
        place(block, m_x + 80, m_y);
        connect(block, stepId, "x");
        for (const syntax::ActionAssociation& each : step.actions) {
            pugi::xml_node action = block.append_child("action");
            action.append_attribute("localId") = next();
            action.append_attribute("qualifier") =
                each.qualifier.isValid() ? std::string(each.qualifier.text).c_str() : "N";
            if (each.time) action.append_attribute("duration") = m_writer.source().text(each.time).c_str();
            if (!each.indicators.empty())
                action.append_attribute("indicator") = std::string(each.indicators.front().text).c_str();
            if (each.indicators.size() > 1) m_writer.lose(remarks::IndicatorNotExported(each.indicators[1].text));
            pugi::xml_node position = action.append_child("relPosition");
            position.append_attribute("x") = 0;
            position.append_attribute("y") = 0;
            action.append_child("reference").append_attribute("name") = std::string(each.action.text).c_str();
            action.append_child("connectionPointOut");
        }
    }

    /// The element that a transition hangs below: a step, its divergence, or a convergence of several steps.
    int sourceBefore(const syntax::TransitionDecl& transition) {
        const auto outOf = [&](const syntax::Name& step) {
            const auto selection = m_selectionIds.find(key(step.text));
            if (selection != m_selectionIds.end()) return selection->second;
            const auto it = m_stepIds.find(key(step.text));
            return it == m_stepIds.end() ? -1 : it->second;
        };
        if (transition.from.size() == 1) return outOf(transition.from.front());
        pugi::xml_node convergence = element("simultaneousConvergence", next());
        const int id = convergence.attribute("localId").as_int();
        size(convergence, kColumn, 1);
        place(convergence, m_x, m_y + 50);
        for (const syntax::Name& step : transition.from)
            if (const int source = outOf(step); source >= 0) connect(convergence, source, "sfc");
        convergence.append_child("connectionPointOut"); // without a name in either schema
        return id;
    }

    void writeCondition(pugi::xml_node transition, const syntax::TransitionDecl& decl, int variableId) {
        pugi::xml_node condition = transition.append_child("condition");
        if (variableId >= 0) {
            connect(condition, variableId);
            return;
        }
        pugi::xml_node inlined = condition.append_child("inline");
        inlined.append_attribute("name") = "";
        const bool isList = !decl.condition;
        m_writer.text(inlined.append_child(isList ? "IL" : "ST"),
                      isList ? instructions(decl) : m_writer.source().text(decl.condition));
    }
    std::string instructions(const syntax::TransitionDecl& decl) const {
        if (decl.ilCondition.empty()) return {};
        return std::string(
            m_writer.source().slice(joined(decl.ilCondition.front()->range, decl.ilCondition.back()->range)));
    }

    void writeTransition(const syntax::TransitionDecl& decl) {
        const int source = decl.from.empty() ? -1 : sourceBefore(decl);
        if (decl.name.isValid()) m_writer.lose(remarks::TransitionNameNotExported(decl.name.text));
        int variable = -1;
        if (!m_writer.isPlain() && decl.condition) { // as CODESYS writes it
            variable = next();
            pugi::xml_node node = element("inVariable", variable);
            size(node, 60, 20);
            place(node, m_x - 80, m_y + 60);
            node.append_child("connectionPointOut");
            node.append_child("expression").text().set(m_writer.source().text(decl.condition).c_str());
        }
        pugi::xml_node node = element("transition", m_transitionIds.at(&decl));
        if (decl.priority) node.append_attribute("priority") = m_writer.source().text(decl.priority).c_str();
        size(node, 20, 2);
        place(node, m_x, m_y + 60);
        if (source >= 0) connect(node, source, "sfc");
        node.append_child("connectionPointOut");
        writeCondition(node, decl, variable);
        m_writer.documentation(node, commentAbove(decl.extent, decl.range));
        writeTargets(decl);
    }

    void writeTargets(const syntax::TransitionDecl& decl) {
        if (const auto it = m_divergenceIds.find(&decl); it != m_divergenceIds.end()) {
            pugi::xml_node divergence = element("simultaneousDivergence", it->second);
            size(divergence, kColumn, 1);
            place(divergence, m_x, m_y + 70);
            connect(divergence, m_transitionIds.at(&decl));
            for (size_t i = 0; i < decl.to.size(); ++i) out(divergence);
        }
        for (const syntax::Name& to : decl.to) {
            const auto entry = m_entries.find(key(to.text));
            if (entry != m_entries.end() && entry->second == &decl) continue;
            pugi::xml_node jump = element("jumpStep", next());
            jump.append_attribute("targetName") = std::string(to.text).c_str();
            size(jump, 12, 13);
            place(jump, m_x, m_y + 80);
            connect(jump, sourceOf(&decl), "sfc");
        }
    }

    pugi::xml_node m_sfc;
    const syntax::SfcBody& m_body;
    const nlohmann::ordered_json& m_positions;
    const XmlWriter& m_writer;
    int m_next = 1, m_line = 0, m_x = 0, m_y = 0;
    std::map<std::string, int> m_stepIds, m_selectionIds, m_ways;
    std::map<const syntax::TransitionDecl*, int> m_transitionIds, m_divergenceIds;
    std::map<std::string, const syntax::TransitionDecl*> m_entries;
};

} // namespace

void writeChart(pugi::xml_node sfc, const syntax::SfcBody& body, const nlohmann::ordered_json& positions,
                const XmlWriter& writer) {
    ChartWriter(sfc, body, positions, writer).write();
}

} // namespace plc::exchange
