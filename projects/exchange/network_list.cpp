#include "projects/exchange/network_list.h"

#include "runtime/base/text.h"

#include <map>

namespace plc::exchange {
namespace {

/// The archive writes objects as <o t="Type">, their members by n="…": <v> values (texts in quotation marks), <l2>
/// lists whose cet is the type of elements that say none, <n/> nothing.
pugi::xml_node memberOf(pugi::xml_node object, std::string_view name) {
    for (const pugi::xml_node child : object.children())
        if (name == child.attribute("n").value() && localName(child) != "n") return child;
    return {};
}

std::string valueOf(pugi::xml_node object, std::string_view name) {
    std::string text = trimmed(exchange::textOf(memberOf(object, name)));
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    return text;
}

bool isTrueIn(pugi::xml_node object, std::string_view name) {
    return equalsIgnoringCase(valueOf(object, name), "true");
}

struct Element {
    pugi::xml_node node; // none: <n/>
    std::string type;
};

std::vector<Element> elementsOf(pugi::xml_node list) {
    std::vector<Element> out;
    const std::string common = attribute(list, "cet");
    for (const pugi::xml_node child : list.children()) {
        if (child.type() != pugi::node_element) continue;
        const std::string own = attribute(child, "t");
        out.push_back({localName(child) == "n" ? pugi::xml_node() : child, own.empty() ? common : own});
    }
    return out;
}

std::vector<std::string> namesOf(pugi::xml_node box, std::string_view parameters) {
    std::vector<std::string> out;
    for (const pugi::xml_node each : memberOf(memberOf(box, parameters), "Names").children()) {
        std::string text = trimmed(exchange::textOf(each));
        if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
        out.push_back(std::move(text));
    }
    return out;
}

/// Marks of operands, inputs and boxes.
struct Marks {
    bool isNegated = false, isSet = false, jumps = false, returns = false, rises = false, falls = false;
};

Marks marksOf(pugi::xml_node holder) {
    const unsigned bits = static_cast<unsigned>(std::atoi(valueOf(memberOf(holder, "Flags"), "Flags").c_str()));
    return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0, (bits & 16) != 0, (bits & 32) != 0};
}

/// What a connection comes from; no id: nothing.
struct Wire {
    std::string id, pin;
    [[nodiscard]] bool isConnected() const { return !id.empty(); }
};

class Converter {
public:
    explicit Converter(NetworkList& out) : m_out(out) {}

    void read(pugi::xml_node list) {
        const bool isLadder = equalsIgnoringCase(valueOf(list, "DefaultViewMode"), "Ld");
        m_isLadder = isLadder;
        m_body = m_out.document.append_child(isLadder ? "LD" : "FBD");
        for (const Element& network : elementsOf(memberOf(list, "NetworkList")))
            if (network.node) readNetwork(network.node);
    }

private:
    void readNetwork(pugi::xml_node network) {
        m_wires.clear();
        if (const std::string label = valueOf(network, "Label"); !label.empty())
            add("label").append_attribute("label") = label.c_str();
        std::string comment = valueOf(network, "Title");
        if (const std::string text = valueOf(network, "Comment"); !text.empty())
            comment += (comment.empty() ? "" : "\n") + text;
        if (!comment.empty()) setText(add("comment").append_child("content").append_child("xhtml"), comment);
        if (isTrueIn(network, "OutCommented")) {
            m_out.remarks.push_back({network, remarks::NetworkCommentedOut(comment.empty() ? "?" : comment)});
            return;
        }
        for (const Element& item : elementsOf(memberOf(network, "NetworkItems")))
            if (item.node) (void)read(item, 0);
    }

    // ------------------------------------------------------------ the nodes of the diagram

    pugi::xml_node add(const char* kind) {
        pugi::xml_node node = m_body.append_child(kind);
        node.append_attribute("localId") = ++m_last;
        pugi::xml_node position = node.append_child("position");
        position.append_attribute("x") = 0;
        position.append_attribute("y") = 0;
        return node;
    }
    static std::string idOf(pugi::xml_node node) { return attribute(node, "localId"); }
    static void setText(pugi::xml_node node, const std::string& text) {
        node.append_child(pugi::node_pcdata).set_value(text.c_str());
    }
    static void connect(pugi::xml_node holder, const Wire& wire) {
        pugi::xml_node point = holder.append_child("connectionPointIn");
        if (!wire.isConnected()) return;
        pugi::xml_node connection = point.append_child("connection");
        connection.append_attribute("refLocalId") = wire.id.c_str();
        if (!wire.pin.empty()) connection.append_attribute("formalParameter") = wire.pin.c_str();
    }
    static void mark(pugi::xml_node node, const Marks& marks) {
        if (marks.isNegated) node.append_attribute("negated") = "true";
        if (marks.rises || marks.falls) node.append_attribute("edge") = marks.rises ? "rising" : "falling";
    }
    Wire rail() { return {idOf(add("leftPowerRail")), ""}; }

    // ------------------------------------------------------------ the trees of the list

    Wire read(const Element& tree, int depth) {
        constexpr int kDeepest = 100;
        if (!tree.node || depth > kDeepest) return {};
        if (tree.type == "BoxTreeOperand") return readOperand(tree.node);
        if (tree.type == "BoxTreeBox") return readBox(tree.node, depth);
        if (tree.type == "BoxTreeAssign") return readAssign(tree.node, depth);
        if (tree.type == "BoxTreeDemux") return readBranch(tree.node, depth);
        if (tree.type == "BoxTreeParallel") return readParallel(tree.node, depth);
        if (tree.type == "BoxTreeTerminator") { // the end of a branch, or a wire without anything
            const Element input = elementIn(tree.node, "Input");
            return input.node ? read(input, depth + 1) : rail();
        }
        m_out.remarks.push_back({tree.node, remarks::ElementNotRead(tree.type)});
        return {};
    }
    static Element elementIn(pugi::xml_node object, std::string_view name) {
        const pugi::xml_node node = memberOf(object, name);
        return {node, attribute(node, "t")};
    }

    Wire readOperand(pugi::xml_node tree) {
        const pugi::xml_node operand = memberOf(tree, "Operand");
        const std::string text = valueOf(operand, "Operand");
        if (text.empty()) return {};
        Marks marks = marksOf(operand);
        const Marks own = marksOf(tree);
        marks.isNegated = marks.isNegated != own.isNegated;
        marks.rises = marks.rises || own.rises;
        marks.falls = marks.falls || own.falls;
        const bool isContact = marks.rises || marks.falls;
        pugi::xml_node node = add(isContact ? "contact" : "inVariable");
        mark(node, marks);
        if (isContact) connect(node, rail());
        setText(node.append_child(isContact ? "variable" : "expression"), text);
        return {idOf(node), ""};
    }

    Wire readBox(pugi::xml_node box, int depth) {
        const std::vector<Element> inputs = elementsOf(memberOf(box, "InputItems")),
                                   flags = elementsOf(memberOf(box, "InputFlags"));
        std::vector<Wire> wires;
        wires.reserve(inputs.size());
        for (const Element& input : inputs) wires.push_back(read(input, depth + 1));
        pugi::xml_node block = add("block");
        nameBox(box, block);
        const std::vector<std::string> names = namesOf(box, "InputParam"), outputs = namesOf(box, "OutputParam");
        pugi::xml_node pins = block.append_child("inputVariables");
        for (size_t i = 0; i < wires.size(); ++i) {
            pugi::xml_node pin = pins.append_child("variable");
            const bool isNamed = i < names.size() && !names[i].empty();
            pin.append_attribute("formalParameter") = (isNamed ? names[i] : "In" + std::to_string(i + 1)).c_str();
            if (i < flags.size() && flags[i].node) mark(pin, pinMarks(flags[i].node));
            connect(pin, wires[i]);
        }
        block.append_child("inOutVariables");
        pins = block.append_child("outputVariables");
        const size_t main = static_cast<size_t>(std::max(0, std::atoi(valueOf(box, "MainOutputIndex").c_str())));
        const std::vector<Element> targets = elementsOf(memberOf(memberOf(box, "OutputItems"), "OutputItems"));
        const size_t count = std::max({outputs.size(), targets.size(), size_t(1)});
        for (size_t i = 0; i < count; ++i) {
            pugi::xml_node pin = pins.append_child("variable");
            pin.append_attribute("formalParameter") = pinName(outputs, i).c_str();
            if (i == main && marksOf(box).isNegated) pin.append_attribute("negated") = "true";
            pin.append_child("connectionPointOut");
        }
        for (size_t i = 0; i < targets.size(); ++i)
            if (targets[i].node) addTarget(targets[i].node, {idOf(block), pinName(outputs, i)}, {});
        return {idOf(block), pinName(outputs, main)};
    }
    static std::string pinName(const std::vector<std::string>& names, size_t index) {
        return index < names.size() ? names[index] : index == 0 ? "" : "Out" + std::to_string(index + 1);
    }
    /// A list of flags holds the numbers themselves or objects around them.
    static Marks pinMarks(pugi::xml_node flag) {
        if (memberOf(flag, "Flags") && !memberOf(memberOf(flag, "Flags"), "Flags")) {
            pugi::xml_document holder;
            holder.append_child("o").append_copy(flag).append_attribute("n") = "Flags";
            return marksOf(holder.first_child());
        }
        return marksOf(flag);
    }

    /// A method is called on what stands as its instance; a block's instance has the name.
    static void nameBox(pugi::xml_node box, pugi::xml_node block) {
        const std::string type = valueOf(box, "BoxType"), instance = valueOf(memberOf(box, "Instance"), "Operand");
        const std::string call = valueOf(box, "CallType");
        const bool isMethod = equalsIgnoringCase(call, "Method");
        const bool isWhole = instance.empty() || type.find('.') != std::string::npos;
        block.append_attribute("typeName") = (isMethod && !isWhole ? instance + "." + type : type).c_str();
        if (!isMethod && !instance.empty()) block.append_attribute("instanceName") = instance.c_str();
    }

    Wire readAssign(pugi::xml_node assign, int depth) {
        const Element value = elementIn(assign, "RValue");
        Wire wire = read(value, depth + 1);
        if (!wire.isConnected() && m_isLadder) wire = rail(); // a coil at the rail
        const Marks own = marksOf(assign);
        const std::vector<Element> targets = elementsOf(memberOf(memberOf(assign, "OutputItems"), "OutputItems"));
        for (const Element& target : targets)
            if (target.node) addTarget(target.node, wire, own);
        return wire;
    }

    /// A variable, coil, jump or return that takes what arrives. A coil that resets is marked as set and negated.
    void addTarget(pugi::xml_node operand, const Wire& wire, const Marks& around) {
        const std::string text = valueOf(operand, "Operand");
        Marks marks = marksOf(operand);
        if (marks.returns || around.returns || marks.jumps || around.jumps) {
            const bool returns = marks.returns || around.returns;
            pugi::xml_node node = add(returns ? "return" : "jump");
            if (!returns) node.append_attribute("label") = text.c_str();
            if (marks.isNegated) node.append_attribute("negated") = "true";
            connect(node, wire);
            return;
        }
        if (text.empty()) return;
        pugi::xml_node node = add(m_isLadder ? "coil" : "outVariable");
        if (marks.isSet) {
            node.append_attribute("storage") = marks.isNegated ? "reset" : "set";
            marks.isNegated = false;
        }
        mark(node, marks);
        connect(node, wire);
        setText(node.append_child(m_isLadder ? "variable" : "expression"), text);
    }

    /// With an input it makes a wire that later ones of its number continue.
    Wire readBranch(pugi::xml_node branch, int depth) {
        const std::string number = valueOf(branch, "VarId");
        const Element input = elementIn(branch, "Input");
        if (!input.node) {
            const auto known = m_wires.find(number);
            return known == m_wires.end() ? rail() : known->second;
        }
        Wire wire = read(input, depth + 1);
        if (!wire.isConnected()) wire = rail();
        return m_wires[number] = wire;
    }

    Wire readParallel(pugi::xml_node parallel, int depth) {
        std::vector<Wire> branches;
        const Element input = elementIn(parallel, "Input");
        const Wire before = input.node ? read(input, depth + 1) : Wire{};
        for (const Element& tree : elementsOf(memberOf(parallel, "Trees")))
            if (const Wire wire = read(tree, depth + 1); wire.isConnected()) branches.push_back(wire);
        const bool isAnd = equalsIgnoringCase(valueOf(parallel, "Mode"), "And");
        const Wire all = joined(isAnd ? "AND" : "OR", branches);
        if (!before.isConnected()) return all;
        return all.isConnected() ? joined("AND", {before, all}) : before;
    }
    Wire joined(const char* type, const std::vector<Wire>& wires) {
        if (wires.size() < 2) return wires.empty() ? Wire{} : wires.front();
        pugi::xml_node block = add("block");
        block.append_attribute("typeName") = type;
        pugi::xml_node pins = block.append_child("inputVariables");
        for (size_t i = 0; i < wires.size(); ++i) {
            pugi::xml_node pin = pins.append_child("variable");
            pin.append_attribute("formalParameter") = ("In" + std::to_string(i + 1)).c_str();
            connect(pin, wires[i]);
        }
        block.append_child("inOutVariables");
        pins = block.append_child("outputVariables").append_child("variable");
        pins.append_attribute("formalParameter") = "";
        pins.append_child("connectionPointOut");
        return {idOf(block), ""};
    }

    NetworkList& m_out;
    pugi::xml_node m_body;
    std::map<std::string, Wire> m_wires; // of the network, by number
    int m_last = 0;
    bool m_isLadder = false;
};

pugi::xml_node listIn(pugi::xml_node node, int depth) {
    if (std::string_view(node.attribute("t").value()) == "NWLImplementationObject") return node;
    if (depth > 10) return {};
    for (const pugi::xml_node child : node.children())
        if (const pugi::xml_node found = listIn(child, depth + 1)) return found;
    return {};
}

} // namespace

NetworkList readNetworkList(pugi::xml_node archive) {
    NetworkList out;
    if (const pugi::xml_node list = listIn(archive, 0)) Converter(out).read(list);
    return out;
}

} // namespace plc::exchange
