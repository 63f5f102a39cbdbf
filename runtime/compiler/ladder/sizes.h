// How much room each part of a diagram takes, in columns and lines. Used by the layout alone; one thread.
#pragma once
#include "runtime/base/text.h"
#include "runtime/compiler/ladder/layout.h"

#include <algorithm>

namespace plc::ladder {

inline constexpr int kLeastContact = 6; // columns of a contact with its wires
inline constexpr int kLongest = 44;     // characters of a label; what is longer is cut, the tip shows all
inline constexpr int kLongestComment = 22;
inline constexpr int kValueColumns = 6; // left of a variable at a pin, for its value

inline std::string cut(const std::string& text, int longest = kLongest) {
    if (columnsOf(text) <= longest) return text;
    size_t at = 0;
    for (int i = 0; i < longest - 1; ++i) decodeUtf8(text, at);
    return text.substr(0, at) + "…";
}

struct Size {
    int w = 0;
    int above = 0, below = 0; // of the line on which the wire runs
    [[nodiscard]] int height() const { return above + 1 + below; }
};

/// A box with EN has ENO beside it; what it writes stands below.
inline bool hasEnable(const Node& box) { return !box.inputs.empty() && box.inputs.front().name == "EN"; }

/// Where the pins of a box stand, from the line of its first one.
struct BoxPlan {
    std::vector<int> inputs, outputs; // lines
    int left = 0, box = 0, right = 0; // columns: what feeds it, the frame, what it writes
    int bottom = 0;                   // line of the lower edge
};

/// What is written above a contact or coil, from top to bottom.
struct Caption {
    std::string text;
    TextRole role;
};
inline std::vector<Caption> captionsOf(const Node& node, const LayoutOptions& options) {
    std::vector<Caption> out;
    if (options.showsComments && !node.comment.empty())
        out.push_back({cut(node.comment, kLongestComment), TextRole::Comment});
    const bool isAddressed = !node.address.empty() && options.naming != Naming::Symbols;
    if (!isAddressed || options.naming == Naming::Both) out.push_back({cut(node.label), TextRole::Operand});
    if (isAddressed && options.naming == Naming::Both) out.push_back({cut(node.address), TextRole::Address});
    if (isAddressed && options.naming == Naming::Addresses) out.push_back({cut(node.address), TextRole::Operand});
    return out;
}

class Measurer {
public:
    Measurer(const Diagram& diagram, const LayoutOptions& options)
        : m_diagram(diagram), m_options(options), m_sizes(diagram.nodes.size()), m_known(diagram.nodes.size()) {}

    const Size& of(NodeId id) {
        if (!m_known[id.index()]) {
            m_sizes[id.index()] = measure(m_diagram[id]);
            m_known[id.index()] = true;
        }
        return m_sizes[id.index()];
    }

    BoxPlan plan(const Node& box) {
        BoxPlan plan;
        int line = 0, before = 0, leftNames = 0, rightNames = 0;
        for (size_t i = 0; i < box.inputs.size(); ++i) {
            const Pin& pin = box.inputs[i];
            const Size size = pin.node.isValid() ? of(pin.node) : Size();
            if (i > 0) line += before + 1 + size.above;
            before = size.below;
            plan.inputs.push_back(line);
            leftNames = std::max(leftNames, columnsOf(pin.name));
            if (pin.node.isValid()) plan.left = std::max(plan.left, size.w + (pin.negated ? 1 : 0) + valueOf(pin));
        }
        for (size_t i = 0; i < box.outputs.size(); ++i) {
            const OutputPin& pin = box.outputs[i];
            plan.outputs.push_back(static_cast<int>(i) + (hasEnable(box) ? 1 : 0));
            rightNames = std::max(rightNames, columnsOf(pin.name));
            const int target = pin.target.empty() ? 1 : columnsOf(cut(pin.target)) + 3;
            plan.right = std::max(plan.right, target + (pin.negated || box.negated ? 1 : 0));
        }
        if (hasEnable(box)) rightNames = std::max(rightNames, 3);
        const int names = leftNames + rightNames + (leftNames && rightNames ? 2 : 1);
        const int order = m_diagram.form == Form::Blocks ? columnsOf(std::to_string(box.order)) + 1 : 0;
        plan.box = std::max({4, columnsOf(cut(box.label)) + 1 + order, names, columnsOf(cut(box.instance)) - 1}) + 1;
        if (m_diagram.form == Form::Ladder) ++plan.left; // clear of the rail
        if (plan.left == 0) plan.left = 1;
        if (plan.right == 0) plan.right = 1;
        const int pins =
            std::max(plan.inputs.empty() ? 0 : plan.inputs.back(), plan.outputs.empty() ? 0 : plan.outputs.back());
        plan.bottom = pins + 1;
        return plan;
    }

private:
    /// A box straight at the rail leaves room for the values of what it reads.
    [[nodiscard]] int valueOf(const Pin& pin) const {
        const Node& node = m_diagram[pin.node];
        const bool isShown = m_diagram.form == Form::Ladder && node.kind == NodeKind::Operand && node.operand &&
                             node.operand->kind != syntax::ExprKind::Literal;
        return isShown ? kValueColumns : 0;
    }

    /// With `more` columns for the wires beside what is written above.
    Size captioned(const Node& node, int least, int more) {
        Size size{least, 0, 0};
        for (const Caption& caption : captionsOf(node, m_options)) {
            size.w = std::max(size.w, columnsOf(caption.text) + more);
            ++size.above;
        }
        return size;
    }

    Size measure(const Node& node) {
        const int label = columnsOf(cut(node.label));
        switch (node.kind) {
        case NodeKind::Contact:
        case NodeKind::Edge:
            return captioned(node, kLeastContact, 3);
        case NodeKind::Coil:
            return m_diagram.form == Form::Blocks ? Size{label + (node.coil == CoilKind::Normal ? 4 : 8), 0, 0}
                                                  : captioned(node, kLeastContact, 2);
        case NodeKind::Compare: {
            Size size = captioned(node, kLeastContact + columnsOf(node.op), 3);
            size.w = std::max(size.w, columnsOf(cut(node.below)) + 3);
            size.below = 1;
            return size;
        }
        case NodeKind::Operand:
            return {label + 2, 0, 0};
        case NodeKind::Invert: {
            const Size inner = of(node.children[0]);
            return {inner.w + kLeastContact + 2, std::max(1, inner.above), inner.below};
        }
        case NodeKind::Series:
            return series(node);
        case NodeKind::Parallel:
            return parallel(node);
        case NodeKind::Box:
            return box(node);
        case NodeKind::Jump:
            return {label + 4, 0, 0};
        case NodeKind::Return:
            return {label + 10, 0, 0};
        case NodeKind::Exit:
            return {8, 0, 0};
        case NodeKind::Continue:
            return {12, 0, 0};
        }
        return {};
    }

    Size series(const Node& node) {
        Size out;
        for (const NodeId child : node.children) {
            const Size size = of(child);
            out = {out.w + size.w, std::max(out.above, size.above), std::max(out.below, size.below)};
        }
        return out;
    }

    Size parallel(const Node& node) {
        Size out;
        for (size_t i = 0; i < node.children.size(); ++i) {
            const Size size = of(node.children[i]);
            out.w = std::max(out.w, size.w);
            if (i == 0)
                out.above = size.above, out.below = size.below;
            else
                out.below += size.height();
        }
        out.w += 2;
        return out;
    }

    Size box(const Node& node) {
        const BoxPlan plan = this->plan(node);
        Size out{plan.left + plan.box + plan.right, node.instance.empty() ? 1 : 2, plan.bottom};
        for (size_t i = 0; i < node.inputs.size(); ++i) {
            if (!node.inputs[i].node.isValid()) continue;
            const Size size = of(node.inputs[i].node);
            if (i == 0) out.above = std::max(out.above, size.above);
            out.below = std::max(out.below, plan.inputs[i] + size.below);
        }
        return out;
    }

    const Diagram& m_diagram;
    const LayoutOptions& m_options;
    std::vector<Size> m_sizes;
    std::vector<bool> m_known;
};

} // namespace plc::ladder
