#include "runtime/compiler/ladder/layout.h"

#include "runtime/compiler/ladder/sizes.h"

#include <algorithm>

namespace plc::ladder {

namespace {

constexpr int kMargin = 5;  // for the rung's number
constexpr int kIndent = 3;  // of what a frame holds
constexpr int kGlyph = 2;   // between a contact's bars
constexpr int kLineGap = 1; // between the lines of a wrapped rung

/// Draws one rung.
class RungDrawer {
public:
    RungDrawer(const Diagram& diagram, Measurer& sizes, const Rung& rung, const LayoutOptions& options, int number)
        : m_diagram(diagram), m_sizes(sizes), m_rung(rung), m_options(options), m_number(number),
          m_left(kMargin + rung.depth * kIndent) {}

    RungPicture draw(int rail) {
        m_rail = rail;
        nest();
        notes();
        switch (m_rung.kind) {
        case RungKind::Logic:
            number();
            wires("");
            break;
        case RungKind::Head:
            head();
            break;
        case RungKind::Tail:
            heading(m_rung.text);
            if (m_rung.power.isValid()) wires("END_REPEAT");
            break;
        case RungKind::Label:
            heading(m_rung.text + ":");
            break;
        case RungKind::Text:
            number();
            code();
            break;
        case RungKind::Comment:
            break;
        }
        m_picture.height = m_line;
        for (Shape& shape : m_picture.shapes) {
            if (shape.kind == ShapeKind::Nest) shape.h = m_line;
            m_picture.width = std::max(m_picture.width, shape.x + shape.w + 1);
        }
        return std::move(m_picture);
    }

    /// Columns from the left rail that the widest line needs.
    int width() {
        if (m_rung.kind == RungKind::Text || m_rung.kind == RungKind::Comment) return 0;
        int widest = 0;
        for (const Line& line : linesOf()) widest = std::max(widest, line.w);
        return m_left + widest;
    }

private:
    /// What stands beside each other in a rung: the parts of its series, then the outputs.
    struct Item {
        NodeId node; // none: the outputs
        Size size;
    };
    struct Line {
        std::vector<Item> items;
        int w = 0, above = 0, below = 0;
    };

    Shape& add(ShapeKind kind, NodeId node, int x, int y, int w, int h) {
        Shape shape;
        shape.kind = kind;
        shape.node = node;
        shape.x = x;
        shape.y = y;
        shape.w = w;
        shape.h = h;
        m_picture.shapes.push_back(std::move(shape));
        return m_picture.shapes.back();
    }
    void wire(NodeId source, int x, int y, int toX, bool isDouble = false) {
        if (toX != x) add(ShapeKind::Wire, source, std::min(x, toX), y, std::abs(toX - x), 0).isDouble = isDouble;
    }
    void down(NodeId source, int x, int y, int toY, bool isDouble = false) {
        if (toY > y) add(ShapeKind::Wire, source, x, y, 0, toY - y).isDouble = isDouble;
    }
    void text(NodeId node, int x, int y, std::string what, TextRole role, Align align = Align::Left, int w = 0) {
        const int columns = columnsOf(what);
        if (align == Align::Middle) x += (w - columns) / 2;
        if (align == Align::Right) x += w - columns;
        Shape& shape = add(ShapeKind::Text, node, x, y, columns, 0);
        shape.isMarked = node.isValid() && m_diagram[node].isFeedback && role == TextRole::Operand;
        shape.text = std::move(what);
        shape.role = role;
        shape.align = align;
    }
    void hit(NodeId node, int x, int y, int w, int h) { m_picture.hits.push_back({node, x, y, w, h}); }

    void nest() {
        for (int depth = 0; depth < m_rung.depth; ++depth) add(ShapeKind::Nest, {}, kMargin + depth * kIndent, 0, 0, 0);
    }

    void number() {
        if (m_number > 0) text({}, 0, m_line, std::to_string(m_number), TextRole::Number, Align::Right, kMargin - 1);
    }

    void heading(const std::string& what) {
        text({}, m_left, m_line, cut(what, 100), TextRole::Heading);
        ++m_line;
    }

    void notes() {
        if (!m_rung.title.empty()) heading(m_rung.title);
        if (!m_options.showsNotes) return;
        std::string_view rest = m_rung.note;
        while (!rest.empty()) {
            const size_t end = std::min(rest.find('\n'), rest.size());
            std::string line(rest.substr(0, end));
            line.erase(std::remove(line.begin(), line.end(), '\r'), line.end());
            text({}, m_left, m_line++, cut(line, m_options.wrapAt - m_left), TextRole::Note);
            rest.remove_prefix(std::min(rest.size(), end + 1));
        }
    }

    void head() {
        heading(m_rung.text);
        if (m_rung.power.isValid()) wires(m_rung.text == "WHILE" ? "DO" : "THEN");
    }

    void code() {
        const int top = m_line;
        int widest = 8;
        std::string_view rest = m_rung.text;
        while (!rest.empty()) {
            const size_t end = std::min(rest.find('\n'), rest.size());
            std::string line;
            for (const char c : rest.substr(0, end)) line += c == '\t' ? "    " : c == '\r' ? "" : std::string(1, c);
            line = cut(line, m_options.wrapAt - m_left);
            widest = std::max(widest, columnsOf(line));
            text({}, m_left + 2, ++m_line, std::move(line), TextRole::Code);
            rest.remove_prefix(std::min(rest.size(), end + 1));
        }
        ++m_line;
        add(ShapeKind::Box, {}, m_left, top, widest + 3, m_line - top);
        ++m_line;
    }

    // ------------------------------------------------------------ wires

    void gatherItems(NodeId id, std::vector<Item>& out) {
        const Node& node = m_diagram[id];
        if (node.kind == NodeKind::Series)
            for (const NodeId child : node.children) gatherItems(child, out);
        else
            out.push_back({id, m_sizes.of(id)});
    }

    Size sizeOfOutputs() {
        if (m_rung.branches.empty()) return {8, 0, 0};
        Size out;
        for (size_t i = 0; i < m_rung.branches.size(); ++i) {
            const Branch& branch = m_rung.branches[i];
            Size size = m_sizes.of(branch.output);
            if (branch.tail.isValid()) {
                const Size tail = m_sizes.of(branch.tail);
                size = {size.w + tail.w, std::max(size.above, tail.above), std::max(size.below, tail.below)};
            }
            out.w = std::max(out.w, size.w);
            if (i == 0)
                out.above = size.above, out.below = size.below;
            else
                out.below += size.height();
        }
        out.w += m_rung.branches.size() > 1 ? 3 : 2;
        return out;
    }

    std::vector<Line> linesOf() {
        std::vector<Item> items;
        if (m_rung.power.isValid()) gatherItems(m_rung.power, items);
        items.push_back({{}, sizeOfOutputs()});
        std::vector<Line> lines(1);
        for (const Item& item : items) {
            if (!lines.back().items.empty() && m_left + lines.back().w + item.size.w > m_options.wrapAt)
                lines.emplace_back();
            Line& line = lines.back();
            line.items.push_back(item);
            line.w += item.size.w;
            line.above = std::max(line.above, item.size.above);
            line.below = std::max(line.below, item.size.below);
        }
        return lines;
    }

    void wires(const std::string& end) {
        const bool isLadder = m_diagram.form == Form::Ladder;
        const std::vector<Line> lines = linesOf();
        const int top = m_line;
        NodeId source;
        for (size_t i = 0; i < lines.size(); ++i) {
            const Line& line = lines[i];
            const int y = m_line + line.above;
            int x = m_left;
            if (i > 0) add(ShapeKind::Arrow, source, x, y, 1, 0).text = "▶", x += 1;
            for (const Item& item : line.items) {
                if (item.node.isValid()) {
                    place(item.node, x, y, source);
                    source = item.node;
                    x += item.size.w;
                } else {
                    outputs(x, y, source, end);
                }
            }
            m_line += line.above + 1 + line.below;
            if (i + 1 < lines.size()) {
                add(ShapeKind::Arrow, source, x, y, 1, 0).text = "▶";
                m_line += kLineGap;
            }
        }
        if (isLadder) add(ShapeKind::Rail, {}, m_left, top, 0, m_line - top);
        if (isLadder && m_reachesRight) add(ShapeKind::Rail, {}, m_rail, top, 0, m_line - top);
    }

    void outputs(int x, int y, NodeId source, const std::string& end) {
        if (m_rung.branches.empty()) { // the condition of a frame
            wire(source, x, y, x + 3);
            text({}, x + 4, y, end, TextRole::Heading);
            return;
        }
        const bool branches = m_rung.branches.size() > 1;
        const int from = branches ? x + 1 : x;
        if (branches) wire(source, x, y, from);
        int line = y;
        for (size_t i = 0; i < m_rung.branches.size(); ++i) {
            const Branch& branch = m_rung.branches[i];
            const Size output = m_sizes.of(branch.output);
            const Size tail = branch.tail.isValid() ? m_sizes.of(branch.tail) : Size();
            const int above = std::max(output.above, tail.above), below = std::max(output.below, tail.below);
            if (i > 0) line += above;
            NodeId at = source;
            if (branch.tail.isValid()) place(branch.tail, from, line, source), at = branch.tail;
            output_(branch.output, from + tail.w, line, at);
            if (branches && i > 0) down(source, from, m_lastBranch, line);
            m_lastBranch = line;
            line += below + 1;
        }
    }

    /// Coils stand at the right rail.
    void output_(NodeId id, int x, int y, NodeId source) {
        const Node& node = m_diagram[id];
        const bool atRail = m_diagram.form == Form::Ladder && node.kind != NodeKind::Box;
        if (!atRail) return place(id, x, y, source);
        const int at = std::max(x, m_rail - m_sizes.of(id).w);
        wire(source, x, y, at);
        place(id, at, y, source);
        if (node.kind == NodeKind::Coil) m_reachesRight = true;
    }

    // ------------------------------------------------------------ parts

    /// From column x to x + width, on line y.
    void place(NodeId id, int x, int y, NodeId source) {
        const Node& node = m_diagram[id];
        const Size size = m_sizes.of(id);
        switch (node.kind) {
        case NodeKind::Contact:
            return contact(id, x, y, size.w, source, node.negated ? "/" : " ");
        case NodeKind::Edge:
            return contact(id, x, y, size.w, source,
                           std::string(node.negated ? "/" : "") + (node.isFalling ? "N" : "P"));
        case NodeKind::Compare:
            return contact(id, x, y, size.w, source, (node.negated ? "/" : "") + node.op);
        case NodeKind::Coil:
            return coil(id, x, y, size.w, source);
        case NodeKind::Operand:
            text(id, x, y, cut(node.label), TextRole::Operand);
            wire(id, x + size.w - 1, y, x + size.w);
            return hit(id, x, y, size.w - 1, 1);
        case NodeKind::Series:
            for (const NodeId child : node.children) {
                place(child, x, y, source);
                x += m_sizes.of(child).w;
                source = child;
            }
            return;
        case NodeKind::Parallel:
            return parallel(id, x, y, size.w, source);
        case NodeKind::Invert: {
            const int w = m_sizes.of(node.children[0]).w;
            hit(id, x + w, y, size.w - w, 1);
            place(node.children[0], x, y, source);
            return glyph(id, x + w, y, size.w - w, node.children[0], "NOT", ShapeKind::Contact);
        }
        case NodeKind::Box:
            return box(id, x, y, source);
        case NodeKind::Jump:
            return control(id, x, y, source, "▶▶" + node.label);
        case NodeKind::Return:
            return control(id, x, y, source, "<RETURN>" + node.label);
        case NodeKind::Exit:
            return control(id, x, y, source, "<EXIT>");
        case NodeKind::Continue:
            return control(id, x, y, source, "<CONTINUE>");
        }
    }

    void control(NodeId id, int x, int y, NodeId source, const std::string& what) {
        wire(source, x, y, x + 1);
        text(id, x + 2, y, what, TextRole::Title);
        hit(id, x + 2, y, columnsOf(what), 1);
    }

    void glyph(NodeId id, int x, int y, int w, NodeId source, const std::string& inner, ShapeKind kind) {
        const int span = std::max(kGlyph, columnsOf(inner) + 1);
        const int at = x + (w - span) / 2;
        wire(source, x, y, at);
        add(kind, id, at, y, span, 0).text = inner;
        wire(id, at + span, y, x + w);
    }

    void contact(NodeId id, int x, int y, int w, NodeId source, const std::string& inner) {
        const Node& node = m_diagram[id];
        const int above = captions(id, x, y, w);
        glyph(id, x, y, w, source, inner, ShapeKind::Contact);
        const bool isCompare = node.kind == NodeKind::Compare;
        if (isCompare) {
            text(id, x, y + 1, cut(node.below), TextRole::Operand, Align::Middle, w + 1);
            m_picture.shapes.back().isMarked = node.isFeedbackBelow;
        }
        hit(id, x + 1, y - above, w - 1, above + (isCompare ? 2 : 1));
    }

    /// Returns how many lines they take.
    int captions(NodeId id, int x, int y, int w) {
        const std::vector<Caption> all = captionsOf(m_diagram[id], m_options);
        const int count = static_cast<int>(all.size());
        for (int i = 0; i < count; ++i)
            text(id, x, y - count + i, all[static_cast<size_t>(i)].text, all[static_cast<size_t>(i)].role,
                 Align::Middle, w + 1);
        return count;
    }

    void coil(NodeId id, int x, int y, int w, NodeId source) {
        static constexpr const char* letters[] = {" ", "/", "S", "R"};
        const Node& node = m_diagram[id];
        const std::string letter = letters[static_cast<size_t>(node.coil)];
        if (m_diagram.form == Form::Blocks) {
            const int at = node.coil == CoilKind::Normal ? x + 1 : x + 5;
            wire(source, x, y, node.coil == CoilKind::Normal ? x + 1 : x + 2);
            if (node.coil != CoilKind::Normal) {
                add(ShapeKind::Coil, id, x + 2, y, kGlyph, 0).text = letter;
                wire(id, x + 4, y, x + 5);
            }
            text(id, at + 2, y, cut(node.label), TextRole::Operand);
            return hit(id, x + 1, y, w, 1);
        }
        const int above = captions(id, x, y, w);
        glyph(id, x, y, w, source, letter, ShapeKind::Coil);
        hit(id, x + 1, y - above, w - 1, above + 1);
    }

    void parallel(NodeId id, int x, int y, int w, NodeId source) {
        const Node& node = m_diagram[id];
        wire(source, x, y, x + 1, node.isShort);
        const int end = x + w - 1;
        int line = y, above = y;
        for (size_t i = 0; i < node.children.size(); ++i) {
            const NodeId child = node.children[i];
            const Size size = m_sizes.of(child);
            if (i > 0) {
                line += size.above;
                down(source, x + 1, above, line, node.isShort);
                down(id, end, above, line, node.isShort);
            }
            place(child, x + 1, line, source);
            wire(child, x + 1 + size.w, line, end);
            above = line;
            line += size.below + 1;
        }
        wire(id, end, y, x + w, node.isShort);
    }

    void box(NodeId id, int x, int y, NodeId source) {
        const Node& node = m_diagram[id];
        const BoxPlan plan = m_sizes.plan(node);
        const int left = x + plan.left, right = left + plan.box;
        hit(id, left, y - 1, plan.box + 1, plan.bottom + 2);
        add(ShapeKind::Box, id, left, y - 1, plan.box, plan.bottom + 1).isDouble = node.isShort;
        text(id, left + 1, y - 1, cut(node.label), TextRole::Title, Align::Middle,
             plan.box - 1 - (m_diagram.form == Form::Blocks ? 2 : 0));
        if (m_diagram.form == Form::Blocks) {
            const std::string order = std::to_string(node.order);
            text(id, right - columnsOf(order), y - 1, order, TextRole::Order);
        }
        if (!node.instance.empty())
            text(id, left, y - 2, cut(node.instance), TextRole::Instance, Align::Middle, plan.box + 1);
        for (size_t i = 0; i < node.inputs.size(); ++i) input(id, node.inputs[i], left, x, y + plan.inputs[i], source);
        if (hasEnable(node)) text(id, right - 3, y, "ENO", TextRole::Pin);
        for (size_t i = 0; i < node.outputs.size(); ++i)
            output(id, i, right, x + plan.left + plan.box + plan.right, y + plan.outputs[i]);
    }

    void input(NodeId id, const Pin& pin, int left, int x, int y, NodeId source) {
        text(id, left + 1, y, pin.name, TextRole::Pin);
        if (pin.negated) add(ShapeKind::Circle, id, left - 1, y, 0, 0);
        const int end = pin.negated ? left - 1 : left;
        if (pin.isPower) return wire(source, x, y, end);
        if (!pin.node.isValid()) return;
        const Node& node = m_diagram[pin.node];
        const Size size = m_sizes.of(pin.node);
        const int from = end - size.w;
        if (node.kind == NodeKind::Operand && node.negated) {
            text(pin.node, from, y, cut(node.label), TextRole::Operand);
            wire(pin.node, end - 1, y, end);
            add(ShapeKind::Circle, pin.node, end - 1, y, 0, 0);
            return hit(pin.node, from, y, size.w - 1, 1);
        }
        place(pin.node, from, y, {});
        const bool isLogic =
            m_diagram.form == Form::Ladder && node.kind != NodeKind::Operand && node.kind != NodeKind::Box;
        if (isLogic) add(ShapeKind::Rail, {}, from, y - size.above, 0, size.height());
    }

    void output(NodeId id, size_t number, int right, int end, int y) {
        const OutputPin& pin = m_diagram[id].outputs[number];
        const int name = columnsOf(pin.name);
        text(id, right - name, y, pin.name, TextRole::Pin);
        const bool negated = pin.negated || (pin.isFlow && m_diagram[id].negated);
        int from = right;
        if (negated) add(ShapeKind::Circle, id, ++from, y, 0, 0);
        if (!pin.target.empty()) {
            wire(id, from, y, from + 1);
            text(id, from + 2, y, cut(pin.target), TextRole::Operand);
            m_picture.shapes.back().pin = static_cast<int>(number);
        } else if (pin.isFlow) {
            wire(id, from, y, end);
        }
    }

    const Diagram& m_diagram;
    Measurer& m_sizes;
    const Rung& m_rung;
    const LayoutOptions& m_options;
    int m_number;
    int m_left;
    int m_rail = 0;
    int m_line = 0;
    int m_lastBranch = 0;
    bool m_reachesRight = false;
    RungPicture m_picture;
};

} // namespace

int columnsOf(std::string_view utf8) {
    int columns = 0;
    for (const char c : utf8)
        if ((static_cast<unsigned char>(c) & 0xc0) != 0x80) ++columns;
    return columns;
}

Layout computeLayout(const Diagram& diagram, const LayoutOptions& options) {
    Layout layout;
    Measurer sizes(diagram, options);
    std::vector<RungDrawer> drawers;
    drawers.reserve(diagram.rungs.size());
    int rail = kMargin + options.leastWidth, number = 0;
    for (const Rung& rung : diagram.rungs) {
        const bool isCounted = rung.kind == RungKind::Logic || rung.kind == RungKind::Text;
        drawers.emplace_back(diagram, sizes, rung, options, isCounted ? ++number : 0);
        rail = std::max(rail, drawers.back().width());
    }
    for (RungDrawer& drawer : drawers) {
        layout.rungs.push_back(drawer.draw(rail));
        RungPicture& picture = layout.rungs.back();
        picture.top = layout.height;
        layout.height += picture.height + 1;
        layout.width = std::max(layout.width, picture.width);
    }
    return layout;
}

} // namespace plc::ladder
