#include "projects/exchange/codesys2_diagram.h"

#include "projects/exchange/diagram_builder.h"

#include <optional>

namespace plc::exchange {
namespace {

struct Unknown {}; // stops the reading: nothing is converted half

/// The lines of the export, one word or name each; expressions stand in prefix order, their sign behind them.
class Reader {
public:
    Reader(std::string_view text, pugi::xml_document& document) : m_document(document) {
        for (size_t at = 0; at < text.size();) {
            const size_t end = std::min(text.find('\n', at), text.size());
            if (std::string line = trimmed(text.substr(at, end - at)); !line.empty())
                m_lines.push_back(std::move(line));
            at = end + 1;
        }
    }

    void read() {
        const bool isLadder = at("_LD_BODY");
        if (!isLadder && !at("_FBD_BODY")) throw Unknown();
        ++m_at;
        m_builder.emplace(m_document, isLadder);
        for (int networks = count("_NETWORKS"); networks > 0; --networks) readNetwork();
        if (m_at != m_lines.size()) throw Unknown();
    }

private:
    [[nodiscard]] bool at(std::string_view word) const { return m_at < m_lines.size() && m_lines[m_at] == word; }
    const std::string& next() {
        if (m_at == m_lines.size()) throw Unknown();
        return m_lines[m_at++];
    }
    bool take(std::string_view word) {
        if (!at(word)) return false;
        ++m_at;
        return true;
    }
    void expect(std::string_view word) {
        if (!take(word)) throw Unknown();
    }
    /// _NETWORKS : 2
    int count(std::string_view word) {
        const std::string& line = next();
        if (!line.starts_with(word)) throw Unknown();
        const std::string rest = trimmed(std::string_view(line).substr(word.size()));
        if (rest.empty() || rest.front() != ':') throw Unknown();
        return std::atoi(trimmed(std::string_view(rest).substr(1)).c_str());
    }
    /// _EXPRESSION _POSITIV
    bool isNegated() {
        expect("_EXPRESSION");
        return sign();
    }
    bool sign() {
        if (take("_NEGATIV")) return true;
        expect("_POSITIV");
        return false;
    }

    void readNetwork() {
        expect("_NETWORK");
        if (!at("_COMMENT") && !at("_LD_ASSIGN") && !at("_ASSIGN")) { // name: of a jump's target
            std::string label = next();
            if (label.ends_with(':')) label.pop_back();
            if (label.empty() || label.front() == '_') throw Unknown();
            m_builder->label(trimmed(label));
        }
        if (take("_COMMENT")) readComment();
        while (m_at < m_lines.size() && !at("_NETWORK")) readItem();
    }
    void readComment() {
        std::string text;
        while (!at("_END_COMMENT")) text += (text.empty() ? "" : "\n") + next();
        ++m_at;
        if (text.size() >= 2 && text.front() == '\'' && text.back() == '\'') text = text.substr(1, text.size() - 2);
        if (!trimmed(text).empty()) m_builder->comment(text);
    }

    void readItem() {
        const bool isLadder = take("_LD_ASSIGN");
        if (!isLadder) expect("_ASSIGN");
        Wire wire = isLadder ? ladder({}, 0) : box(0);
        if (isLadder && !wire.isConnected()) wire = m_builder->rail();
        if (take("_EXPRESSION") && sign()) wire = m_builder->box("NOT", "", {{"In1", wire, {}}}, {});
        if (at("ENABLELIST : 0")) {
            ++m_at;
            expect("ENABLELIST_END");
        }
        for (int outputs = count("_OUTPUTS"); outputs > 0; --outputs) readOutput(wire);
    }
    void readOutput(const Wire& wire) {
        if (take("_JUMP")) {
            const bool negated = sign();
            return m_builder->jump(next(), wire, negated);
        }
        if (take("_RETURN")) return m_builder->jump("", wire, sign());
        expect("_OUTPUT");
        PinMarks marks;
        marks.isNegated = sign();
        marks.isSet = take("_SET");
        marks.isReset = !marks.isSet && take("_RESET");
        if (!marks.isSet && !marks.isReset) expect("_NO_SET");
        m_builder->target(next(), wire, marks);
    }

    /// Contacts in series are behind each other; the branches of a parallel circuit begin where it does.
    Wire ladder(Wire before, int depth) {
        if (depth > kDeepest) throw Unknown();
        if (take("_EMPTY")) return before;
        if (take("_LD_CONTACT")) {
            const std::string name = next();
            PinMarks marks;
            marks.isNegated = isNegated();
            return m_builder->contact(name, marks, before);
        }
        const bool isSeries = take("_LD_AND");
        if (!isSeries) expect("_LD_OR");
        std::vector<Wire> branches;
        Wire last = before;
        for (int operands = count("_LD_OPERATOR"); operands > 0; --operands) {
            const Wire wire = ladder(isSeries ? last : before, depth + 1);
            if (isSeries)
                last = wire;
            else
                branches.push_back(wire.isConnected() ? wire : m_builder->rail());
        }
        if (isNegated()) throw Unknown(); // a circuit has no sign
        return isSeries ? last : m_builder->joined("OR", branches);
    }

    Wire box(int depth) {
        if (depth > kDeepest) throw Unknown();
        if (take("_EMPTY")) return {};
        if (take("_OPERAND")) {
            PinMarks marks;
            marks.isNegated = isNegated();
            return m_builder->operand(next(), marks);
        }
        std::string instance;
        if (take("_FUNCTIONBLOCK"))
            instance = next();
        else if (!take("_OPERATOR"))
            expect("_FUNCTION");
        std::vector<BoxInput> inputs;
        for (int operands = count("_BOX_EXPR"); operands > 0; --operands)
            inputs.push_back({"In" + std::to_string(inputs.size() + 1), box(depth + 1), {}});
        const bool negated = isNegated();
        const std::string type = next();
        if (!instance.empty()) throw Unknown(); // the names of its pins are not in the export
        return m_builder->box(type, instance, inputs, {}, 0, negated);
    }

    static constexpr int kDeepest = 100;
    pugi::xml_document& m_document;
    std::optional<DiagramBuilder> m_builder;
    std::vector<std::string> m_lines;
    size_t m_at = 0;
};

} // namespace

bool readCodesys2Diagram(std::string_view text, pugi::xml_document& document) {
    try {
        Reader(text, document).read();
        return true;
    } catch (const Unknown&) {
        document.reset();
        return false;
    }
}

} // namespace plc::exchange
