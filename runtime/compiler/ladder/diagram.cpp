#include "runtime/compiler/ladder/diagram.h"

#include "runtime/base/text.h"
#include "runtime/compiler/ladder/projector.h"

#include <algorithm>
#include <functional>

namespace plc::ladder {

namespace {

void gatherNodes(const Diagram& diagram, NodeId id, std::vector<NodeId>& out) {
    if (!id.isValid()) return;
    const Node& node = diagram[id];
    for (const NodeId child : node.children) gatherNodes(diagram, child, out);
    for (const Pin& pin : node.inputs) gatherNodes(diagram, pin.node, out);
    out.push_back(id);
}

std::string foldedLabel(const std::string& label) {
    std::string out;
    for (const char c : label)
        if (c != ' ') out += c;
    return foldCase(out);
}

} // namespace

std::vector<NodeId> Diagram::nodesOf(const Rung& rung) const {
    std::vector<NodeId> out;
    gatherNodes(*this, rung.power, out);
    for (const Branch& branch : rung.branches) {
        gatherNodes(*this, branch.tail, out);
        gatherNodes(*this, branch.output, out);
    }
    return out;
}

NodeId Diagram::nodeAt(uint32_t offset) const {
    const RungId rung = rungAt(offset);
    if (!rung.isValid()) return {};
    NodeId best;
    for (const NodeId id : nodesOf((*this)[rung])) {
        const Node& node = (*this)[id];
        const bool isInside = offset >= node.range.begin && offset <= node.range.end;
        const bool isChain = node.kind == NodeKind::Series || node.kind == NodeKind::Parallel;
        if (!isInside || isChain) continue;
        if (!best.isValid() || node.range.length() < (*this)[best].range.length()) best = id;
    }
    return best;
}

RungId Diagram::rungAt(uint32_t offset) const {
    RungId best;
    for (size_t i = 0; i < rungs.size(); ++i) {
        const Rung& rung = rungs[i];
        const uint32_t begin = rung.comment.end ? rung.comment.begin : rung.range.begin;
        const uint32_t end = rung.trailing.end ? rung.trailing.end : rung.range.end;
        if (offset < begin || offset > end) continue;
        if (!best.isValid() || rung.range.length() <= rungs[best.index()].range.length()) best = RungId(i);
    }
    return best;
}

/// Reads of what is written in the same rung or below show the value of the scan before (IEC 61131-3, 4.1.3).
void Projector::markReads(const std::vector<std::vector<NodeId>>& nodes) {
    std::unordered_map<std::string, size_t> firstWrite;
    for (size_t i = 0; i < nodes.size(); ++i) {
        for (const NodeId id : nodes[i]) {
            const Node& node = m_diagram[id];
            if (node.kind == NodeKind::Coil) firstWrite.emplace(foldedLabel(node.label), i);
            if (!node.instance.empty()) firstWrite.emplace(foldedLabel(node.instance) + ".", i);
            for (const OutputPin& pin : node.outputs)
                if (!pin.target.empty()) firstWrite.emplace(foldedLabel(pin.target), i);
        }
    }
    const auto isWrittenLater = [&](const std::string& label, size_t rung) {
        const std::string folded = foldedLabel(label);
        auto written = firstWrite.find(folded);
        if (written != firstWrite.end()) return written->second >= rung;
        const size_t dot = folded.rfind('.');
        if (dot == std::string::npos) return false;
        written = firstWrite.find(folded.substr(0, dot + 1));
        return written != firstWrite.end() && written->second >= rung;
    };
    for (size_t i = 0; i < nodes.size(); ++i) {
        for (const NodeId id : nodes[i]) {
            Node& node = m_diagram.nodes[id.index()];
            if (node.kind != NodeKind::Contact && node.kind != NodeKind::Operand && node.kind != NodeKind::Compare)
                continue;
            node.isFeedback = isWrittenLater(node.label, i);
            node.isFeedbackBelow = !node.below.empty() && isWrittenLater(node.below, i);
            node.isTemporary = node.operand && node.operand->kind == syntax::ExprKind::NameRef &&
                               m_types.isTemporary(node.operand->name.text, m_scope);
        }
    }
}

/// In order of execution: what feeds a box comes before it.
void Projector::numberBoxes(const std::vector<std::vector<NodeId>>& nodes) {
    int next = 1;
    for (const std::vector<NodeId>& ofRung : nodes)
        for (const NodeId id : ofRung) {
            Node& node = m_diagram.nodes[id.index()];
            if (node.kind == NodeKind::Box && node.order == 0) node.order = next++;
        }
}

// ---------------------------------------------------------------- in words

namespace {

class Describer {
public:
    explicit Describer(const Diagram& diagram) : m_diagram(diagram) {}

    std::string all() {
        for (const Rung& rung : m_diagram.rungs) describeRung(rung);
        return std::move(m_out);
    }

private:
    void describeRung(const Rung& rung) {
        m_out.append(static_cast<size_t>(rung.depth) * 2, ' ');
        if (!rung.title.empty()) m_out += "'" + rung.title + "' ";
        if (!rung.note.empty()) {
            std::string note = rung.note;
            std::replace(note.begin(), note.end(), '\n', ' ');
            m_out += "# " + note + " # ";
        }
        if (!rung.text.empty()) m_out += "<" + rung.text + "> ";
        if (rung.power.isValid()) m_out += describeNode(rung.power);
        if (!rung.branches.empty()) m_out += rung.power.isValid() ? " -> " : "-> ";
        bool isFirst = true;
        for (const Branch& branch : rung.branches) {
            if (!isFirst) m_out += " | ";
            isFirst = false;
            if (branch.tail.isValid()) m_out += describeNode(branch.tail) + " ";
            m_out += describeNode(branch.output);
        }
        m_out += "\n";
    }

    std::string listed(const std::vector<NodeId>& ids, const std::string& between) const {
        std::string out;
        for (const NodeId id : ids) out += (out.empty() ? "" : between) + describeNode(id);
        return out;
    }

    std::string describeBox(const Node& node) const {
        std::string out = node.label;
        if (!node.instance.empty()) out += ":" + node.instance;
        out += "[";
        for (const Pin& pin : node.inputs) {
            if (out.back() != '[') out += " ";
            if (!pin.name.empty()) out += pin.name + "=";
            out += pin.isPower ? "~" : pin.node.isValid() ? describeNode(pin.node) : "";
        }
        out += "]";
        for (const OutputPin& pin : node.outputs) {
            if (pin.isFlow && pin.name.empty()) continue;
            out += (pin.isFlow ? ">" : "") + (pin.name.empty() ? "" : "." + pin.name);
            if (!pin.target.empty()) out += "=>" + pin.target;
        }
        return out;
    }

    std::string describeNode(NodeId id) const {
        const Node& node = m_diagram[id];
        const std::string sign = node.negated ? "/" : "";
        const std::string mark =
            std::string(node.isFeedback || node.isFeedbackBelow ? "^" : "") + (node.isTemporary ? "~" : "");
        switch (node.kind) {
        case NodeKind::Contact:
            return sign + node.label + mark;
        case NodeKind::Compare:
            return sign + "{" + node.label + " " + node.op + " " + node.below + "}" + mark;
        case NodeKind::Edge:
            return sign + (node.isFalling ? "N:" : "P:") + node.label;
        case NodeKind::Series:
            return listed(node.children, node.isShort ? " && " : " ");
        case NodeKind::Parallel:
            return "(" + listed(node.children, node.isShort ? " || " : " + ") + ")";
        case NodeKind::Invert:
            return "(" + listed(node.children, " ") + ") NOT";
        case NodeKind::Box:
            return sign + describeBox(node);
        case NodeKind::Operand:
            return sign + node.label + mark;
        case NodeKind::Coil: {
            static constexpr const char* glyphs[] = {"()", "(/)", "(S)", "(R)"};
            return glyphs[static_cast<size_t>(node.coil)] + node.label;
        }
        case NodeKind::Jump:
            return ">>" + node.label;
        case NodeKind::Return:
            return "<RETURN>" + node.label;
        case NodeKind::Exit:
            return "<EXIT>";
        case NodeKind::Continue:
            return "<CONTINUE>";
        }
        return {};
    }

    const Diagram& m_diagram;
    std::string m_out;
};

} // namespace

std::string describe(const Diagram& diagram) { return Describer(diagram).all(); }

} // namespace plc::ladder
