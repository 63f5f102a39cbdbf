#include "projects/exchange/twincat/stored_cfc.h"

#include "runtime/base/text.h"

#include <map>

namespace plc::exchange {
namespace {

using namespace archive;

class CfcConverter {
public:
    CfcConverter(ArchiveBody& out, std::string_view unit) : m_out(out) {
        const size_t dot = unit.find('.');
        if (dot != std::string_view::npos) m_prefix = std::string(unit.substr(dot + 1)) + "_";
    }

    /// The order of the list is that of the execution; lines may lead to what comes before.
    void read(pugi::xml_node diagram) {
        m_body = m_out.document.append_child("CFC");
        m_elements = elementsIn(diagram, "Items");
        gatherLines();
        for (const Element& each : m_elements)
            if (each.node) gatherOutputs(each);
        for (const Element& each : m_elements)
            if (each.node) write(each);
    }

private:
    struct Output {
        long long owner = 0;
        std::string pin;
        bool isNegated = false;
    };

    // ------------------------------------------------------------ names and lines

    void gatherLines() {
        for (const Element& each : m_elements)
            if (each.type == "CFCConnection")
                m_from[numberOf(each.node, "DestPinId")] = numberOf(each.node, "SourcePinId");
    }

    static std::vector<std::string> textsOf(pugi::xml_node element) {
        std::vector<std::string> out;
        if (const pugi::xml_node one = memberOf(element, "Text"); localName(one) == "o")
            out.push_back(valueOf(one, "Text"));
        for (const Element& each : elementsIn(element, "Texts")) out.push_back(valueOf(each.node, "Text"));
        return out;
    }
    static std::string textOf(pugi::xml_node element) {
        for (std::string& text : textsOf(element))
            if (!text.empty()) return std::move(text);
        return {};
    }
    /// One pin, or a list of them.
    static std::vector<Element> pinsOf(pugi::xml_node element, const std::string& name) {
        std::vector<Element> out = elementsIn(element, name + "s");
        if (const pugi::xml_node one = memberOf(element, name)) out.push_back({one, attribute(one, "t")});
        return out;
    }

    struct Box {
        std::string type, instance;
        std::vector<Element> inputs, outputs;
        std::vector<std::string> names; // of the inputs, then of the outputs
    };
    /// Its texts are the names of the pins, then the type and, of a block, the instance.
    static Box boxOf(pugi::xml_node element) {
        Box box;
        box.inputs = pinsOf(element, "Input");
        box.outputs = pinsOf(element, "Output");
        const std::vector<std::string> texts = textsOf(element);
        const size_t pins = box.inputs.size() + box.outputs.size();
        const bool isBlock = equalsIgnoringCase(valueOf(element, "KindOfCall"), "FunctionBlock");
        std::vector<std::string> rest;
        const bool areNamed = texts.size() > pins;
        for (size_t i = areNamed ? pins : 0; i < texts.size(); ++i)
            if (!texts[i].empty()) rest.push_back(texts[i]);
        if (!rest.empty()) box.type = rest.front();
        if (isBlock) box.instance = rest.size() > 1 ? rest[1] : box.type;
        for (size_t i = 0; i < pins; ++i) {
            std::string name = areNamed ? texts[i] : "";
            const bool isInput = i < box.inputs.size();
            if (name.empty() && isTrueIn(element, "EnEno") && (i == 0 || i == box.inputs.size()))
                name = isInput ? "EN" : "ENO";
            if (name.empty() && isInput) name = "In" + std::to_string(i + 1);
            box.names.push_back(std::move(name));
        }
        return box;
    }

    void gatherOutputs(const Element& element) {
        const long long owner = numberOf(element.node, "Id");
        if (element.type == "CFCInputElement")
            for (const Element& pin : pinsOf(element.node, "Output"))
                m_outputs[numberOf(pin.node, "Id")] = {owner, "", isTrueIn(pin.node, "Negated")};
        if (element.type == "CFCComposerElement")
            for (const Element& pin : pinsOf(element.node, "Output"))
                m_outputs[numberOf(pin.node, "Id")] = {owner, "", isTrueIn(pin.node, "Negated")};
        if (element.type == "CFCSelectorElement")
            for (const Element& pin : pinsOf(element.node, "Output"))
                m_outputs[numberOf(pin.node, "Id")] = {numberOf(pin.node, "Id"), "", isTrueIn(pin.node, "Negated")};
        if (element.type != "CFCBoxElement") return;
        const Box box = boxOf(element.node);
        for (size_t i = 0; i < box.outputs.size(); ++i)
            m_outputs[numberOf(box.outputs[i].node, "Id")] = {owner, box.names[box.inputs.size() + i],
                                                              isTrueIn(box.outputs[i].node, "Negated")};
        for (size_t i = 0; i < box.inputs.size(); ++i) // a VAR_IN_OUT goes on to the next block
            if (box.inputs[i].type == "CFCInOutPin")
                m_outputs[numberOf(box.inputs[i].node, "Id")] = {owner, box.names[i], false};
    }

    // ------------------------------------------------------------ the diagram

    pugi::xml_node add(const char* kind, pugi::xml_node element) {
        pugi::xml_node node = m_body.append_child(kind);
        node.append_attribute("localId") = numberOf(element, "Id");
        if (std::string_view(kind) != "inVariable") node.append_attribute("executionOrderId") = ++m_order;
        return node;
    }
    static void setText(pugi::xml_node node, const std::string& text) {
        node.append_child(pugi::node_pcdata).set_value(text.c_str());
    }
    /// A negation at the pin that a line comes from is one at the pin it leads to.
    void connect(pugi::xml_node node, pugi::xml_node pin) {
        bool isNegated = isTrueIn(pin, "Negated");
        pugi::xml_node point = node.append_child("connectionPointIn");
        const auto line = m_from.find(numberOf(pin, "Id"));
        if (line != m_from.end()) {
            const auto output = m_outputs.find(line->second);
            if (output == m_outputs.end()) {
                m_out.remarks.push_back({pin, remarks::DiagramNotConnected(std::to_string(line->second))});
            } else {
                pugi::xml_node connection = point.append_child("connection");
                connection.append_attribute("refLocalId") = output->second.owner;
                if (!output->second.pin.empty())
                    connection.append_attribute("formalParameter") = output->second.pin.c_str();
                isNegated = isNegated != output->second.isNegated;
            }
        }
        if (isNegated) node.append_attribute("negated") = "true";
    }

    void write(const Element& element) {
        const pugi::xml_node node = element.node;
        if (element.type == "CFCConnection") return;
        if (element.type == "CFCInputElement")
            return setText(add("inVariable", node).append_child("expression"), textOf(node));
        if (element.type == "CFCOutputElement") return writeTarget(node);
        if (element.type == "CFCBoxElement") return writeBox(node);
        if (element.type == "CFCComposerElement") return writeComposer(node);
        if (element.type == "CFCSelectorElement") return writeSelector(node);
        if (element.type == "CFCJumpElement") return writeJump(node, "jump");
        if (element.type == "CFCReturnElement") return writeJump(node, "return");
        if (element.type == "CFCLabelElement") {
            add("label", node).append_attribute("label") = textOf(node).c_str();
            return;
        }
        if (element.type == "CFCCommentElement")
            return setText(add("comment", node).append_child("content").append_child("xhtml"), textOf(node));
        m_out.remarks.push_back({node, remarks::ElementNotRead(element.type)});
    }

    std::string structureOf(pugi::xml_node element, const std::string& type) {
        std::string name = m_prefix + "composed_" + std::to_string(numberOf(element, "Id"));
        m_out.variables.emplace_back(name, type);
        return name;
    }
    /// Its inputs are the members of a structure, whose type is its last text.
    void writeComposer(pugi::xml_node element) {
        const std::vector<std::string> texts = textsOf(element);
        const std::vector<Element> inputs = pinsOf(element, "Input");
        if (texts.size() <= inputs.size()) {
            m_out.remarks.push_back({element, remarks::ElementNotRead(Verbatim("CFCComposerElement"))});
            return;
        }
        const std::string name = structureOf(element, texts.back());
        for (size_t i = 0; i < inputs.size(); ++i) {
            if (!m_from.count(numberOf(inputs[i].node, "Id"))) continue;
            const pugi::xml_node node = add("outVariable", inputs[i].node);
            connect(node, inputs[i].node);
            setText(pugi::xml_node(node).append_child("expression"), name + "." + texts[i]);
        }
        setText(add("inVariable", element).append_child("expression"), name);
    }
    /// Its outputs are the members of a structure, whose type is its first text.
    void writeSelector(pugi::xml_node element) {
        const std::vector<std::string> texts = textsOf(element);
        const std::vector<Element> outputs = pinsOf(element, "Output");
        if (texts.size() <= outputs.size()) {
            m_out.remarks.push_back({element, remarks::ElementNotRead(Verbatim("CFCSelectorElement"))});
            return;
        }
        const std::string name = structureOf(element, texts.front());
        pugi::xml_node node = add("outVariable", element);
        for (const Element& pin : pinsOf(element, "Input")) connect(node, pin.node);
        setText(node.append_child("expression"), name);
        for (size_t i = 0; i < outputs.size(); ++i)
            setText(add("inVariable", outputs[i].node).append_child("expression"), name + "." + texts[i + 1]);
    }

    void writeTarget(pugi::xml_node element) {
        pugi::xml_node node = add("outVariable", element);
        for (const Element& pin : pinsOf(element, "Input")) {
            connect(node, pin.node);
            const std::string storage = foldCase(valueOf(pin.node, "SetReset"));
            if (storage == "set" || storage == "reset")
                node.append_attribute("storage") = storage.c_str();
            else if (!storage.empty() && storage != "none")
                m_out.remarks.push_back({pin.node, remarks::ElementNotRead(storage)});
            break;
        }
        setText(node.append_child("expression"), textOf(element));
    }

    void writeJump(pugi::xml_node element, const char* kind) {
        pugi::xml_node node = add(kind, element);
        if (std::string_view(kind) == "jump") node.append_attribute("label") = textOf(element).c_str();
        for (const Element& pin : pinsOf(element, "Input")) return connect(node, pin.node);
        connect(node, {});
    }

    void writeBox(pugi::xml_node element) {
        const Box box = boxOf(element);
        pugi::xml_node block = add("block", element);
        block.append_attribute("typeName") = box.type.c_str();
        if (!box.instance.empty()) block.append_attribute("instanceName") = box.instance.c_str();
        pugi::xml_node pins = block.append_child("inputVariables");
        for (size_t i = 0; i < box.inputs.size(); ++i) {
            pugi::xml_node pin = pins.append_child("variable");
            pin.append_attribute("formalParameter") = box.names[i].c_str();
            connect(pin, box.inputs[i].node);
        }
        block.append_child("inOutVariables");
        pins = block.append_child("outputVariables");
        for (size_t i = 0; i < box.outputs.size(); ++i) {
            pugi::xml_node pin = pins.append_child("variable");
            pin.append_attribute("formalParameter") = box.names[box.inputs.size() + i].c_str();
            pin.append_child("connectionPointOut");
        }
    }

    ArchiveBody& m_out;
    pugi::xml_node m_body;
    std::vector<Element> m_elements;
    std::map<long long, long long> m_from; // pin → the pin its line comes from
    std::map<long long, Output> m_outputs; // by pin
    std::string m_prefix;                  // of variables, for the diagram of an action
    int m_order = 0;
};

} // namespace

ArchiveBody readStoredCfc(pugi::xml_node stored, std::string_view unit) {
    ArchiveBody out;
    if (!childOf(stored, "XmlArchive")) { // of the first versions: as PLCopen XML has it
        out.document.append_copy(stored);
        return out;
    }
    if (const pugi::xml_node diagram = objectOf(stored, "CFCImplementationObject"))
        CfcConverter(out, unit).read(diagram);
    return out;
}

} // namespace plc::exchange
