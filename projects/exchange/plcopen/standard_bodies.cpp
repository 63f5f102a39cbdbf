#include "projects/exchange/plcopen/standard_bodies.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace plc::exchange {

namespace {

constexpr int kScale = 10; // a unit of a diagram there is about a character, here a pixel

class GraphCopy {
public:
    GraphCopy(StandardNodes& nodes, pugi::xml_node graph) : m_nodes(nodes), m_graph(graph) {}

    void addNetworks(pugi::xml_node content) {
        std::vector<pugi::xml_node> networks;
        for (const pugi::xml_node each : content.children())
            if (is(each, "Network") || is(each, "Rung")) networks.push_back(each);
        std::stable_sort(networks.begin(), networks.end(), [](pugi::xml_node a, pugi::xml_node b) {
            return a.attribute("evaluationOrder").as_llong() < b.attribute("evaluationOrder").as_llong();
        });
        for (const pugi::xml_node network : networks) {
            m_top = m_bottom + 10 * kScale;
            ++m_network;
            addLabel(network);
            addObjects(network);
        }
    }
    void addObjects(pugi::xml_node network) {
        m_points.clear();
        std::vector<std::pair<pugi::xml_node, std::string>> objects; // with their ids
        for (const pugi::xml_node object : network.children()) {
            const std::string_view name = localName(object);
            if (!name.ends_with("Object")) continue;
            objects.emplace_back(object, std::to_string(++m_lastId));
            gatherPoints(object, objects.back().second, "");
        }
        for (const auto& [object, id] : objects) addObject(object, id);
    }

private:
    struct Point {
        std::string id, pin, priority;
    };

    /// The points that leave `node`; those of a block are called as their pin.
    void gatherPoints(pugi::xml_node node, const std::string& id, const std::string& pin) {
        for (const pugi::xml_node child : node.children()) {
            const std::string_view name = localName(child);
            if (name == "GraphicalExpression") continue; // a network of its own
            if (const std::string point = attribute(child, "connectionPointOutId"); !point.empty())
                m_points[point] = {id, pin, attribute(child, "priority")};
            const std::string parameter = attribute(child, "parameterName");
            gatherPoints(child, id, name == "Eno" ? "ENO" : parameter.empty() ? pin : parameter);
        }
    }

    void addLabel(pugi::xml_node network) {
        const std::string label = attribute(network, "label");
        if (label.empty()) return;
        const pugi::xml_node node = m_nodes.add(m_graph, "label", network);
        StandardNodes::set(node, "localId", std::to_string(++m_lastId));
        StandardNodes::set(node, "label", label);
        addPosition(node, m_top, 0, network);
    }

    void addPosition(pugi::xml_node node, int y, int x, pugi::xml_node source) {
        const pugi::xml_node position = m_nodes.add(node, "position", source);
        StandardNodes::set(position, "x", std::to_string(x));
        StandardNodes::set(position, "y", std::to_string(y));
        m_bottom = std::max(m_bottom, y);
    }

    /// Begins an element; its place is relative to its network's.
    pugi::xml_node begin(const char* name, pugi::xml_node object, const std::string& id) {
        const pugi::xml_node node = m_nodes.add(m_graph, name, object);
        StandardNodes::set(node, "localId", id);
        const pugi::xml_node size = childOf(object, "Size");
        if (size || std::string_view(name) == "comment") {
            StandardNodes::set(node, "height", std::to_string(scaled(size, "y")));
            StandardNodes::set(node, "width", std::to_string(scaled(size, "x")));
        }
        if (const std::string order = priorityOf(object); !order.empty())
            StandardNodes::set(node, "executionOrderId", order);
        return node;
    }
    void place(pugi::xml_node node, pugi::xml_node object) {
        const pugi::xml_node position = childOf(object, "RelPosition");
        addPosition(node, m_top + scaled(position, "y"), scaled(position, "x"), object);
        m_nodes.addDocumentation(node, object);
    }
    static int scaled(pugi::xml_node value, const char* axis) {
        const double number = value.attribute(axis).as_double();
        return std::abs(number) < 1e6 ? static_cast<int>(std::lround(number * kScale)) : 0;
    }

    /// Of Bachmann: smaller numbers run earlier; they are unique in a network.
    std::string priorityOf(pugi::xml_node object) const {
        const pugi::xml_node found = vendorNode(object, "EvaluationPriority");
        const std::string number = attribute(found, "priorityInNetwork");
        return number.empty() ? number : std::to_string(m_network * 100000 + std::atoi(number.c_str()) + 1);
    }
    static pugi::xml_node vendorNode(pugi::xml_node object, std::string_view name) {
        for (const pugi::xml_node data : childOf(object, "AddData").children())
            if (const pugi::xml_node found = childOf(data, name)) return found;
        return {};
    }

    void addObject(pugi::xml_node object, const std::string& id) {
        const std::string type = schemaType(object);
        if (type == "Comment") {
            const pugi::xml_node node = begin("comment", object, id);
            place(node, object);
            m_nodes.addText(node, "content", object, textOf(childOf(object, "Content")));
        } else if (type == "Connector" || type == "Continuation") {
            const pugi::xml_node node = begin(type == "Connector" ? "connector" : "continuation", object, id);
            StandardNodes::set(node, "name", attribute(object, "label"));
            place(node, object);
            addPoints(node, object);
        } else if (type == "Block") {
            addBlock(object, id);
        } else if (type == "DataSource" || type == "DataSink") {
            addVariable(object, id, type == "DataSource" ? "inVariable" : "outVariable");
        } else if (type == "Jump" || type == "Return") {
            const pugi::xml_node node = begin(type == "Jump" ? "jump" : "return", object, id);
            if (type == "Jump") StandardNodes::set(node, "label", attribute(object, "targetNetworkLabel"));
            if (isTrue(vendorNode(object, "negated"), "value")) StandardNodes::set(node, "negated", "true");
            place(node, object);
            addPoints(node, object);
        } else if (!addLadderObject(object, id, type) && !addChartObject(object, id, type)) {
            const std::string name = attribute(object, "complexIdentifier");
            m_nodes.leaveOut(object, name.empty() ? type : type + " " + name);
        }
    }

    void addVariable(pugi::xml_node object, const std::string& id, const char* name) {
        const pugi::xml_node node = begin(name, object, id);
        const std::string mode = attribute(vendorNode(object, "StorageMode"), "mode");
        if (mode == "Set" || mode == "Reset") StandardNodes::set(node, "storage", mode == "Set" ? "set" : "reset");
        place(node, object);
        addPoints(node, object);
        m_nodes.addText(node, "expression", object, attribute(object, "identifier"));
    }

    bool addLadderObject(pugi::xml_node object, const std::string& id, const std::string& type) {
        struct Row {
            std::string_view type;
            const char* name;
        };
        static constexpr Row rows[] = {{"LeftPowerRail", "leftPowerRail"},
                                       {"RightPowerRail", "rightPowerRail"},
                                       {"Coil", "coil"},
                                       {"Contact", "contact"},
                                       {"CompareContact", "contact"}};
        const auto* const row =
            std::find_if(std::begin(rows), std::end(rows), [&](const Row& each) { return each.type == type; });
        if (row == std::end(rows)) return false;
        const pugi::xml_node node = begin(row->name, object, id);
        StandardNodes::take(node, "negated", object);
        if (const std::string edge = attribute(object, "edge"); !edge.empty() && edge != "none")
            StandardNodes::set(node, "edge", edge);
        if (const std::string latch = attribute(object, "latch"); !latch.empty() && latch != "none")
            StandardNodes::set(node, "storage", latch);
        place(node, object);
        addPoints(node, object);
        if (type == "CompareContact")
            m_nodes.addText(node, "variable", object,
                            "(" + attribute(object, "operand1") + " " + attribute(object, "compareOperator") + " " +
                                attribute(object, "operand2") + ")");
        else if (type == "Coil" || type == "Contact")
            m_nodes.addText(node, "variable", object, attribute(object, "operand"));
        return true;
    }

    // ------------------------------------------------------------ wires

    void addPoints(pugi::xml_node node, pugi::xml_node object) {
        for (const pugi::xml_node point : object.children()) {
            if (is(point, "ConnectionPointIn")) addPointIn(node, point);
            if (is(point, "ConnectionPointOut")) (void)m_nodes.add(node, "connectionPointOut", point);
        }
    }
    void addPointIn(pugi::xml_node node, pugi::xml_node point) {
        const pugi::xml_node in = m_nodes.add(node, "connectionPointIn", point);
        for (const pugi::xml_node each : point.children()) {
            if (!is(each, "Connection") && !is(each, "FeedbackConnection")) continue;
            const auto from = m_points.find(attribute(each, "refConnectionPointOutId"));
            if (from == m_points.end()) {
                m_nodes.leaveOut(each, "Connection " + attribute(each, "refConnectionPointOutId"));
                continue;
            }
            const pugi::xml_node connection = m_nodes.add(in, "connection", each);
            StandardNodes::set(connection, "refLocalId", from->second.id);
            if (!from->second.pin.empty()) StandardNodes::set(connection, "formalParameter", from->second.pin);
        }
    }

    void addBlock(pugi::xml_node object, const std::string& id) {
        const pugi::xml_node node = begin("block", object, id);
        StandardNodes::take(node, "typeName", object);
        StandardNodes::take(node, "instanceName", object);
        place(node, object);
        struct List {
            const char *from, *to;
            std::string_view en;
        };
        static constexpr List lists[] = {{"InputVariables", "inputVariables", "En"},
                                         {"InOutVariables", "inOutVariables", ""},
                                         {"OutputVariables", "outputVariables", "Eno"}};
        const pugi::xml_node control = vendorNode(object, "ExecutionControl");
        for (const List& list : lists) {
            const pugi::xml_node variables = m_nodes.add(node, list.to, object);
            if (const pugi::xml_node pin = list.en.empty() ? pugi::xml_node() : childOf(control, list.en))
                addPin(variables, pin, list.en == "En" ? "EN" : "ENO");
            for (const pugi::xml_node variable : childOf(object, list.from).children())
                if (variable.type() == pugi::node_element && attribute(variable, "parameterName") != "")
                    addPin(variables, variable, attribute(variable, "parameterName"));
        }
    }
    void addPin(pugi::xml_node variables, pugi::xml_node source, const std::string& name) {
        const pugi::xml_node variable = m_nodes.add(variables, "variable", source);
        StandardNodes::set(variable, "formalParameter", name);
        StandardNodes::take(variable, "negated", source);
        if (const std::string edge = attribute(source, "edge"); !edge.empty() && edge != "none")
            StandardNodes::set(variable, "edge", edge);
        addPoints(variable, source);
    }

    // ------------------------------------------------------------ charts

    bool addChartObject(pugi::xml_node object, const std::string& id, const std::string& type) {
        if (type == "Step") {
            const pugi::xml_node node = begin("step", object, id);
            StandardNodes::take(node, "name", object);
            StandardNodes::take(node, "initialStep", object);
            place(node, object);
            addPoints(node, object);
        } else if (type == "Transition") {
            addTransition(object, id);
        } else if (type == "ActionBlocks") {
            addActions(object, id);
        } else if (type.ends_with("Divergence") || type.ends_with("Convergence")) {
            const bool isSelection = type.starts_with("Selection");
            const bool divides = type.ends_with("Divergence");
            const pugi::xml_node node =
                begin(isSelection ? (divides ? "selectionDivergence" : "selectionConvergence")
                                  : (divides ? "simultaneousDivergence" : "simultaneousConvergence"),
                      object, id);
            place(node, object);
            addPoints(node, object);
        } else {
            return false;
        }
        return true;
    }

    void addTransition(pugi::xml_node object, const std::string& id) {
        const pugi::xml_node node = begin("transition", object, id);
        for (const pugi::xml_node connection : childOf(object, "ConnectionPointIn").children())
            if (const auto from = m_points.find(attribute(connection, "refConnectionPointOutId"));
                from != m_points.end() && !from->second.priority.empty())
                StandardNodes::set(node, "priority", from->second.priority);
        place(node, object);
        addPoints(node, object);
        const pugi::xml_node source = childOf(object, "Condition");
        if (!source) return;
        const pugi::xml_node condition = m_nodes.add(node, "condition", source);
        if (const pugi::xml_node reference = childOf(source, "Reference")) {
            StandardNodes::take(m_nodes.add(condition, "reference", reference), "name", reference);
        } else if (const pugi::xml_node text = childOf(source, "TextualPredicate")) {
            addBodyContent(m_nodes, childOf(text, "PredicateContent"), m_nodes.add(condition, "inline", text));
        } else if (const pugi::xml_node drawn = childOf(source, "GraphicalPredicate")) {
            std::map<std::string, Point> outer = m_points;
            addObjects(childOf(drawn, "GraphicalExpression"));
            addPointIn(condition, childOf(drawn, "ConnectionPointIn"));
            m_points = std::move(outer);
        }
    }

    void addActions(pugi::xml_node object, const std::string& id) {
        const pugi::xml_node node = begin("actionBlock", object, id);
        place(node, object);
        addPoints(node, object);
        for (const pugi::xml_node block : object.children()) {
            if (!is(block, "ActionBlock")) continue;
            const pugi::xml_node action = m_nodes.add(node, "action", block);
            StandardNodes::set(action, "localId", std::to_string(++m_lastId));
            const pugi::xml_node qualifier = childOf(block, "ActionQualifier");
            StandardNodes::take(action, "qualifier", qualifier);
            StandardNodes::take(action, "duration", qualifier);
            StandardNodes::take(action, "indicator", block);
            for (const char* reference : {"ReferenceName", "ComplexOperand"})
                if (const pugi::xml_node name = childOf(block, reference))
                    StandardNodes::set(m_nodes.add(action, "reference", name), "name", trimmed(textOf(name)));
            if (const pugi::xml_node body = childOf(block, "Inline"))
                addBodyContent(m_nodes, childOf(body, "BodyContent"), m_nodes.add(action, "inline", body));
        }
    }

    StandardNodes& m_nodes;
    pugi::xml_node m_graph;
    std::map<std::string, Point> m_points; // of the network that is copied
    int m_lastId = 0, m_network = 0, m_top = 0, m_bottom = -10 * kScale;
};

bool holdsOneOf(pugi::xml_node content, std::initializer_list<std::string_view> names) {
    for (const pugi::xml_node child : content.children())
        for (const std::string_view name : names)
            if (is(child, name)) return true;
    return false;
}

} // namespace

void addBodyContent(StandardNodes& nodes, pugi::xml_node content, pugi::xml_node parent) {
    // vendors derive types of their own: what is inside says what it is
    for (const char* language : {"ST", "IL"})
        if (const pugi::xml_node text = childOf(content, language))
            return nodes.addText(parent, language, text, textOf(text));
    const std::string type = schemaType(content);
    const auto addGraph = [&](const char* language) { return nodes.add(parent, language, content); };
    if (type == "SFC" || holdsOneOf(content, {"SfcObject"}))
        GraphCopy(nodes, addGraph("SFC")).addObjects(content);
    else if (type == "LD" || holdsOneOf(content, {"Rung"}))
        GraphCopy(nodes, addGraph("LD")).addNetworks(content);
    else if (type == "FBD" || holdsOneOf(content, {"Network"}))
        GraphCopy(nodes, addGraph("FBD")).addNetworks(content);
    else if (content)
        nodes.leaveOut(content, type.empty() ? "BodyContent" : type);
}

void addBodies(StandardNodes& nodes, pugi::xml_node holder, pugi::xml_node element) {
    for (const pugi::xml_node content : holder.children())
        if (is(content, "BodyContent")) addBodyContent(nodes, content, nodes.add(element, "body", content));
}

} // namespace plc::exchange
