#include "projects/exchange/graphs/diagram_builder.h"

namespace plc::exchange {
namespace {

std::string idOf(pugi::xml_node node) { return attribute(node, "localId"); }

void setText(pugi::xml_node node, const std::string& text) {
    node.append_child(pugi::node_pcdata).set_value(text.c_str());
}

void connect(pugi::xml_node holder, const Wire& wire) {
    pugi::xml_node point = holder.append_child("connectionPointIn");
    if (!wire.isConnected()) return;
    pugi::xml_node connection = point.append_child("connection");
    connection.append_attribute("refLocalId") = wire.id.c_str();
    if (!wire.pin.empty()) connection.append_attribute("formalParameter") = wire.pin.c_str();
}

void mark(pugi::xml_node node, const PinMarks& marks) {
    if (marks.isNegated) node.append_attribute("negated") = "true";
    if (marks.rises || marks.falls) node.append_attribute("edge") = marks.rises ? "rising" : "falling";
    if (marks.isSet || marks.isReset) node.append_attribute("storage") = marks.isSet ? "set" : "reset";
}

} // namespace

DiagramBuilder::DiagramBuilder(pugi::xml_document& document, bool isLadder)
    : m_body(document.append_child(isLadder ? "LD" : "FBD")), m_isLadder(isLadder) {}

pugi::xml_node DiagramBuilder::add(const char* kind) {
    pugi::xml_node node = m_body.append_child(kind);
    node.append_attribute("localId") = ++m_last;
    pugi::xml_node position = node.append_child("position");
    position.append_attribute("x") = 0;
    position.append_attribute("y") = 0;
    return node;
}

void DiagramBuilder::label(const std::string& name) { add("label").append_attribute("label") = name.c_str(); }

void DiagramBuilder::comment(const std::string& text) {
    setText(add("comment").append_child("content").append_child("xhtml"), text);
}

Wire DiagramBuilder::rail() { return {idOf(add("leftPowerRail")), ""}; }

Wire DiagramBuilder::operand(const std::string& text, const PinMarks& marks) {
    if (text.empty()) return {};
    if (marks.rises || marks.falls) return contact(text, marks, {});
    pugi::xml_node node = add("inVariable");
    mark(node, marks);
    setText(node.append_child("expression"), text);
    return {idOf(node), ""};
}

Wire DiagramBuilder::contact(const std::string& text, const PinMarks& marks, const Wire& before) {
    const Wire from = before.isConnected() ? before : rail();
    pugi::xml_node node = add("contact");
    mark(node, marks);
    connect(node, from);
    setText(node.append_child("variable"), text);
    return {idOf(node), ""};
}

Wire DiagramBuilder::box(const std::string& type, const std::string& instance, const std::vector<BoxInput>& inputs,
                         const std::vector<std::string>& outputs, size_t main, bool isNegated) {
    pugi::xml_node block = add("block");
    block.append_attribute("typeName") = type.c_str();
    if (!instance.empty()) block.append_attribute("instanceName") = instance.c_str();
    pugi::xml_node pins = block.append_child("inputVariables");
    for (const BoxInput& input : inputs) {
        pugi::xml_node pin = pins.append_child("variable");
        pin.append_attribute("formalParameter") = input.name.c_str();
        mark(pin, input.marks);
        connect(pin, input.wire);
    }
    block.append_child("inOutVariables");
    pins = block.append_child("outputVariables");
    for (size_t i = 0; i < std::max<size_t>(1, outputs.size()); ++i) {
        pugi::xml_node pin = pins.append_child("variable");
        pin.append_attribute("formalParameter") = i < outputs.size() ? outputs[i].c_str() : "";
        if (i == main && isNegated) pin.append_attribute("negated") = "true";
        pin.append_child("connectionPointOut");
    }
    return {idOf(block), main < outputs.size() ? outputs[main] : ""};
}

Wire DiagramBuilder::joined(const char* type, const std::vector<Wire>& wires) {
    if (wires.size() < 2) return wires.empty() ? Wire{} : wires.front();
    std::vector<BoxInput> inputs;
    for (const Wire& wire : wires) inputs.push_back({"In" + std::to_string(inputs.size() + 1), wire, {}});
    return box(type, "", inputs, {});
}

void DiagramBuilder::target(const std::string& text, const Wire& from, const PinMarks& marks) {
    if (text.empty()) return;
    pugi::xml_node node = add(m_isLadder ? "coil" : "outVariable");
    mark(node, marks);
    connect(node, from);
    setText(node.append_child(m_isLadder ? "variable" : "expression"), text);
}

void DiagramBuilder::jump(const std::string& label, const Wire& from, bool isNegated) {
    pugi::xml_node node = add(label.empty() ? "return" : "jump");
    if (!label.empty()) node.append_attribute("label") = label.c_str();
    if (isNegated) node.append_attribute("negated") = "true";
    connect(node, from);
}

} // namespace plc::exchange
