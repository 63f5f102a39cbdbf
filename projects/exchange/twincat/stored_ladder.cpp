#include "projects/exchange/twincat/stored_ladder.h"

#include "runtime/base/read_json.h"

#include <nlohmann/json.hpp>

namespace plc::exchange {
namespace {

using namespace archive;
using Json = nlohmann::json;

constexpr int kDeepest = 100; // branches and boxes inside each other

/// Where a wire comes from; several are an OR.
struct Wire {
    long long id = 0;
    std::string pin;
};
using Wires = std::vector<Wire>;

class LadderConverter {
public:
    LadderConverter(pugi::xml_node model, ArchiveBody& out) : m_model(model), m_out(out) {}

    void read(const Json& ladder) {
        m_body = m_out.document.append_child("LD");
        for (const Json& network : listOf(ladder, "Networks")) readNetwork(network);
    }

private:
    static std::string textIn(const Json& object, const char* name) {
        const auto it = object.find(name);
        return it != object.end() && it->is_string() ? it->get<std::string>() : std::string();
    }
    static bool isTrueAt(const Json& object, const char* name) {
        const auto it = object.find(name);
        return it != object.end() && it->is_boolean() && it->get<bool>();
    }
    static const Json& objectIn(const Json& object, const char* name) {
        static const Json none = Json::object();
        const auto it = object.find(name);
        return it != object.end() && it->is_object() ? *it : none;
    }
    static std::vector<Json> listOf(const Json& object, const char* name) {
        std::vector<Json> out;
        const auto it = object.find(name);
        if (it != object.end() && it->is_array())
            for (const Json& each : *it)
                if (each.is_object()) out.push_back(each);
        return out;
    }

    void readNetwork(const Json& network) {
        std::string text = textIn(network, "Title");
        if (const std::string comment = textIn(network, "Comment"); !comment.empty())
            text += (text.empty() ? "" : "\n") + comment;
        if (!trimmed(text).empty()) setLadderText(add("comment").append_child("content"), text);
        if (const std::string label = textIn(network, "Label"); !label.empty())
            add("label").append_attribute("label") = label.c_str();
        const pugi::xml_node rail = add("leftPowerRail");
        m_rail = {{rail.attribute("localId").as_llong(), ""}};
        (void)sequence(objectIn(network, "Sequence"), m_rail, 0);
    }

    // ------------------------------------------------------------ elements

    pugi::xml_node add(const char* kind) {
        pugi::xml_node node = m_body.append_child(kind);
        node.append_attribute("localId") = ++m_lastId;
        node.append_attribute("executionOrderId") = m_lastId;
        return node;
    }
    static void setLadderText(pugi::xml_node node, const std::string& text) {
        node.append_child(pugi::node_pcdata).set_value(text.c_str());
    }
    static void connectTo(pugi::xml_node node, const Wires& wires) {
        pugi::xml_node point = node.append_child("connectionPointIn");
        for (const Wire& wire : wires) {
            pugi::xml_node connection = point.append_child("connection");
            connection.append_attribute("refLocalId") = wire.id;
            if (!wire.pin.empty()) connection.append_attribute("formalParameter") = wire.pin.c_str();
        }
    }
    static Wires after(pugi::xml_node node) { return {{node.attribute("localId").as_llong(), ""}}; }

    /// What lies one behind the other; what it ends with.
    Wires sequence(const Json& row, Wires wires, int depth) {
        if (depth > kDeepest) return wires;
        for (const Json& each : listOf(row, "Elements")) wires = element(each, wires, depth + 1);
        return wires;
    }

    Wires element(const Json& each, const Wires& wires, int depth) {
        const std::string type = textIn(each, "$type");
        const Json& operand = objectIn(each, "Operand");
        if (type == "Contact" || type == "Coil") {
            const pugi::xml_node node = add(type == "Contact" ? "contact" : "coil");
            modify(node, operand);
            connectTo(node, wires);
            setLadderText(pugi::xml_node(node).append_child("variable"), textIn(operand, "Expression"));
            return after(node);
        }
        if (type == "InVariable" || type == "OutVariable") {
            const pugi::xml_node node = add(type == "InVariable" ? "inVariable" : "outVariable");
            modify(node, operand);
            if (type == "OutVariable") connectTo(node, wires);
            setLadderText(pugi::xml_node(node).append_child("expression"), textIn(operand, "Expression"));
            return type == "InVariable" ? after(node) : wires;
        }
        if (type == "ParallelOpen") {
            Wires all;
            for (const Json& branch : listOf(each, "Branches"))
                for (Wire& wire : sequence(branch, wires, depth)) all.push_back(std::move(wire));
            return all;
        }
        if (type == "Block") return block(each, wires, depth);
        if (type == "Jump" || type == "Return") {
            const pugi::xml_node node = add(type == "Jump" ? "jump" : "return");
            if (type == "Jump") pugi::xml_node(node).append_attribute("label") = textIn(operand, "Expression").c_str();
            connectTo(node, wires);
            return wires;
        }
        m_out.remarks.push_back({m_model, remarks::ElementNotRead(type.empty() ? "Element" : type)});
        return wires;
    }
    static void modify(pugi::xml_node node, const Json& operand) {
        const Json& modifier = objectIn(operand, "Modifier");
        if (isTrueAt(modifier, "Negation")) node.append_attribute("negated") = "true";
        const auto storage = modifier.find("Storage");
        if (storage != modifier.end() && storage->is_number_integer() && *storage != 0)
            node.append_attribute("storage") = *storage == 1 ? "set" : "reset";
    }

    /// The wire of the rung enters the first input that nothing is drawn at, EN of most boxes, and leaves by ENO or,
    /// without it, by the result.
    Wires block(const Json& each, const Wires& wires, int depth) {
        struct In {
            std::string name;
            Wires from;
        };
        std::vector<In> inputs;
        bool isEntered = false;
        for (const Json& input : listOf(each, "Inputs")) {
            In in{textIn(objectIn(input, "Pin"), "Name"), {}};
            if (in.name.empty()) in.name = "In" + std::to_string(inputs.size() + 1);
            const Json& row = objectIn(input, "Sequence");
            if (!listOf(row, "Elements").empty()) {
                in.from = sequence(row, m_rail, depth);
            } else if (!isEntered) {
                isEntered = true;
                in.from = wires;
            }
            inputs.push_back(std::move(in));
        }
        const pugi::xml_node node = add("block");
        pugi::xml_node(node).append_attribute("typeName") = textIn(each, "BlockType").c_str();
        const std::string instance = textIn(objectIn(each, "Instance"), "Expression");
        if (!instance.empty()) pugi::xml_node(node).append_attribute("instanceName") = instance.c_str();
        pugi::xml_node pins = pugi::xml_node(node).append_child("inputVariables");
        for (const In& in : inputs) {
            pugi::xml_node pin = pins.append_child("variable");
            pin.append_attribute("formalParameter") = in.name.c_str();
            connectTo(pin, in.from);
        }
        pugi::xml_node(node).append_child("inOutVariables");
        return outputs(each, node);
    }
    Wires outputs(const Json& each, pugi::xml_node node) {
        const long long id = node.attribute("localId").as_llong();
        pugi::xml_node pins = node.append_child("outputVariables");
        Wires first;
        for (const Json& output : listOf(each, "Outputs")) {
            const std::string name = textIn(objectIn(output, "Pin"), "Name");
            pugi::xml_node pin = pins.append_child("variable");
            pin.append_attribute("formalParameter") = name.c_str();
            pin.append_child("connectionPointOut");
            if (first.empty()) first = {{id, name}};
            const Json& operand = objectIn(objectIn(output, "OutVariable"), "Operand");
            if (textIn(operand, "Expression").empty()) continue;
            const pugi::xml_node target = add("outVariable");
            modify(target, operand);
            connectTo(target, {{id, name}});
            setLadderText(pugi::xml_node(target).append_child("expression"), textIn(operand, "Expression"));
        }
        return first;
    }

    pugi::xml_node m_model;
    ArchiveBody& m_out;
    pugi::xml_node m_body;
    Wires m_rail;
    long long m_lastId = 0;
};

} // namespace

ArchiveBody readStoredLadder(pugi::xml_node stored) {
    ArchiveBody out;
    const pugi::xml_node model = memberOf(objectOf(stored, "LadderImplementationObject"), "ModelJson");
    std::string text = trimmed(textOf(model));
    if (text.size() < 2 || text.front() != '"' || text.back() != '"') return out;
    const JsonText<Json> json = readJson<Json>(text.substr(1, text.size() - 2));
    if (json.isGood() && json.value.is_object()) LadderConverter(model, out).read(json.value);
    return out;
}

} // namespace plc::exchange
