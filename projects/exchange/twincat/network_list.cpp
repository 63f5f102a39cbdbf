#include "projects/exchange/twincat/network_list.h"

#include "projects/exchange/graphs/diagram_builder.h"
#include "runtime/base/text.h"

#include <map>
#include <optional>

namespace plc::exchange {
namespace {

using namespace archive;

std::vector<std::string> namesOf(pugi::xml_node box, std::string_view parameters) {
    std::vector<std::string> out;
    for (const pugi::xml_node each : memberOf(memberOf(box, parameters), "Names").children()) {
        std::string text = trimmed(exchange::textOf(each));
        if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
        out.push_back(std::move(text));
    }
    return out;
}

/// Of operands, inputs and items; a coil that resets is marked as set and negated.
struct Marks {
    PinMarks pin;
    bool jumps = false, returns = false;
};

Marks marksOf(pugi::xml_node holder) {
    const unsigned bits = static_cast<unsigned>(std::atoi(valueOf(memberOf(holder, "Flags"), "Flags").c_str()));
    const bool negates = (bits & 1) != 0, sets = (bits & 2) != 0;
    return {{negates && !sets, sets && !negates, sets && negates, (bits & 16) != 0, (bits & 32) != 0},
            (bits & 4) != 0,
            (bits & 8) != 0};
}

class Converter {
public:
    explicit Converter(ArchiveBody& out) : m_out(out) {}

    void read(pugi::xml_node list) {
        m_isLadder = equalsIgnoringCase(valueOf(list, "DefaultViewMode"), "Ld");
        m_builder.emplace(m_out.document, m_isLadder);
        for (const Element& network : elementsOf(memberOf(list, "NetworkList")))
            if (network.node) readNetwork(network.node);
    }

private:
    void readNetwork(pugi::xml_node network) {
        m_wires.clear();
        if (const std::string label = valueOf(network, "Label"); !label.empty()) m_builder->label(label);
        std::string comment = valueOf(network, "Title");
        if (const std::string text = valueOf(network, "Comment"); !text.empty())
            comment += (comment.empty() ? "" : "\n") + text;
        if (!comment.empty()) m_builder->comment(comment);
        if (isTrueIn(network, "OutCommented")) {
            m_out.remarks.push_back({network, remarks::NetworkCommentedOut(comment.empty() ? "?" : comment)});
            return;
        }
        for (const Element& item : elementsOf(memberOf(network, "NetworkItems")))
            if (item.node) (void)read(item, 0);
    }

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
            return input.node ? read(input, depth + 1) : m_builder->rail();
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
        PinMarks marks = marksOf(operand).pin;
        const PinMarks own = marksOf(tree).pin;
        marks.isNegated = marks.isNegated != own.isNegated;
        marks.rises = marks.rises || own.rises;
        marks.falls = marks.falls || own.falls;
        return m_builder->operand(valueOf(operand, "Operand"), marks);
    }

    Wire readBox(pugi::xml_node box, int depth) {
        const std::vector<Element> trees = elementsOf(memberOf(box, "InputItems")),
                                   flags = elementsOf(memberOf(box, "InputFlags")),
                                   targets = elementsOf(memberOf(memberOf(box, "OutputItems"), "OutputItems"));
        const std::vector<std::string> names = namesOf(box, "InputParam");
        std::vector<BoxInput> inputs;
        for (size_t i = 0; i < trees.size(); ++i) {
            const bool isNamed = i < names.size() && !names[i].empty();
            inputs.push_back({isNamed ? names[i] : "In" + std::to_string(i + 1), read(trees[i], depth + 1),
                              i < flags.size() && flags[i].node ? pinMarks(flags[i].node) : PinMarks{}});
        }
        std::vector<std::string> outputs = namesOf(box, "OutputParam");
        while (outputs.size() < targets.size())
            outputs.push_back(outputs.empty() ? "" : "Out" + std::to_string(outputs.size() + 1));
        const size_t main = static_cast<size_t>(std::max(0, std::atoi(valueOf(box, "MainOutputIndex").c_str())));
        const auto [type, instance] = nameOf(box);
        const Wire wire = m_builder->box(type, instance, inputs, outputs, main, marksOf(box).pin.isNegated);
        for (size_t i = 0; i < targets.size(); ++i)
            if (targets[i].node) addTarget(targets[i].node, {wire.id, outputs[i]}, {});
        return wire;
    }
    /// A list of flags holds the numbers themselves or objects around them.
    static PinMarks pinMarks(pugi::xml_node flag) {
        if (memberOf(flag, "Flags") && !memberOf(memberOf(flag, "Flags"), "Flags")) {
            pugi::xml_document holder;
            holder.append_child("o").append_copy(flag).append_attribute("n") = "Flags";
            return marksOf(holder.first_child()).pin;
        }
        return marksOf(flag).pin;
    }

    /// The type and the instance of a box; a method is called on what stands as its instance.
    static std::pair<std::string, std::string> nameOf(pugi::xml_node box) {
        const std::string type = valueOf(box, "BoxType"), instance = valueOf(memberOf(box, "Instance"), "Operand");
        if (!equalsIgnoringCase(valueOf(box, "CallType"), "Method")) return {type, instance};
        const bool isWhole = instance.empty() || type.find('.') != std::string::npos;
        return {isWhole ? type : instance + "." + type, ""};
    }

    Wire readAssign(pugi::xml_node assign, int depth) {
        const Element value = elementIn(assign, "RValue");
        Wire wire = read(value, depth + 1);
        if (!wire.isConnected() && m_isLadder) wire = m_builder->rail(); // a coil at the rail
        const Marks own = marksOf(assign);
        const std::vector<Element> targets = elementsOf(memberOf(memberOf(assign, "OutputItems"), "OutputItems"));
        for (const Element& target : targets)
            if (target.node) addTarget(target.node, wire, own);
        return wire;
    }

    void addTarget(pugi::xml_node operand, const Wire& wire, const Marks& around) {
        const std::string text = valueOf(operand, "Operand");
        const Marks marks = marksOf(operand);
        const bool leaves = marks.returns || around.returns || marks.jumps || around.jumps;
        if (leaves && !wire.isConnected()) return addTarget(operand, m_builder->rail(), around); // always
        if (marks.returns || around.returns) return m_builder->jump("", wire, marks.pin.isNegated);
        if (marks.jumps || around.jumps) return m_builder->jump(text, wire, marks.pin.isNegated);
        m_builder->target(text, wire, marks.pin);
    }

    /// With an input it makes a wire that later ones of its number continue.
    Wire readBranch(pugi::xml_node branch, int depth) {
        const std::string number = valueOf(branch, "VarId");
        const Element input = elementIn(branch, "Input");
        if (!input.node) {
            const auto known = m_wires.find(number);
            return known == m_wires.end() ? m_builder->rail() : known->second;
        }
        Wire wire = read(input, depth + 1);
        if (!wire.isConnected()) wire = m_builder->rail();
        return m_wires[number] = wire;
    }

    Wire readParallel(pugi::xml_node parallel, int depth) {
        std::vector<Wire> branches;
        const Element input = elementIn(parallel, "Input");
        const Wire before = input.node ? read(input, depth + 1) : Wire{};
        for (const Element& tree : elementsOf(memberOf(parallel, "Trees")))
            if (const Wire wire = read(tree, depth + 1); wire.isConnected()) branches.push_back(wire);
        const bool isAnd = equalsIgnoringCase(valueOf(parallel, "Mode"), "And");
        const Wire all = m_builder->joined(isAnd ? "AND" : "OR", branches);
        if (!before.isConnected()) return all;
        return all.isConnected() ? m_builder->joined("AND", {before, all}) : before;
    }
    ArchiveBody& m_out;
    std::optional<DiagramBuilder> m_builder;
    std::map<std::string, Wire> m_wires; // of the network, by number
    bool m_isLadder = false;
};

} // namespace

ArchiveBody readNetworkList(pugi::xml_node stored) {
    ArchiveBody out;
    if (const pugi::xml_node list = objectOf(stored, "NWLImplementationObject")) Converter(out).read(list);
    return out;
}

} // namespace plc::exchange
