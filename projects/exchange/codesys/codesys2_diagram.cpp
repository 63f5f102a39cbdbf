#include "projects/exchange/codesys/codesys2_diagram.h"

#include "projects/exchange/graphs/diagram_builder.h"
#include "runtime/base/text.h"
#include "runtime/compiler/lex/token.h"
#include "runtime/diagnostics/diagnostic.h"

namespace plc::exchange {
namespace {

struct Unknown {}; // stops the reading: nothing is converted half

/// The lines of the export, one word or name each; expressions stand in prefix order, their sign behind them.
class DiagramReader {
public:
    DiagramReader(std::string_view text, const PinsOfType& pinsOf, pugi::xml_document& document)
        : m_pinsOf(pinsOf), m_document(document) {
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
        if (!at("_COMMENT") && !at("_LD_ASSIGN") && !at("_ASSIGN") && !isAtBox()) { // name: of a jump's target
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

    [[nodiscard]] bool isAtBox() const { return at("_FUNCTIONBLOCK") || at("_FUNCTION") || at("_OPERATOR"); }

    void readItem() {
        if (isAtBox()) { // nothing takes its result
            (void)box({}, 0);
            if (m_at < m_lines.size() && m_lines[m_at].starts_with("_OUTPUTS")) skipEmptyOutputs();
            return;
        }
        const bool isLadder = take("_LD_ASSIGN");
        if (!isLadder) expect("_ASSIGN");
        Wire wire = isLadder ? ladder({}, 0) : box({}, 0);
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
        const Target target = readTarget();
        m_builder->target(target.name, wire, target.marks);
    }

    struct Target {
        std::string name; // empty: nothing takes it
        PinMarks marks;
    };
    Target readTarget() {
        Target target;
        expect("_OUTPUT");
        target.marks.isNegated = sign();
        target.marks.isSet = take("_SET");
        target.marks.isReset = !target.marks.isSet && take("_RESET");
        if (!target.marks.isSet && !target.marks.isReset) expect("_NO_SET");
        if (target.marks.isSet && target.marks.isNegated) target.marks = {false, false, true, false, false};
        target.name = next();
        if (target.name == "_EMPTY" || target.name == "???") target.name.clear();
        return target;
    }
    void skipEmptyOutputs() {
        for (int outputs = count("_OUTPUTS"); outputs > 0; --outputs)
            if (!readTarget().name.empty()) throw Unknown();
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
        if (isAtBox()) return box(before.isConnected() ? before : m_builder->rail(), depth + 1);
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

    /// `before` is what comes from the left in a ladder: its place is the first operand, which says _EMPTY.
    Wire box(const Wire& before, int depth) {
        if (depth > kDeepest) throw Unknown();
        if (take("_EMPTY")) return before;
        if (take("_OPERAND")) {
            PinMarks marks;
            marks.isNegated = isNegated();
            const std::string text = next();
            return text == "???" ? Wire{} : m_builder->operand(text, marks);
        }
        if (take("_FUNCTIONBLOCK")) return blockBox(before, depth);
        if (!take("_OPERATOR")) expect("_FUNCTION");
        std::vector<BoxInput> inputs = readInputs(before, depth);
        if (before.isConnected() && !inputs.empty()) { // power enables it
            inputs.front().name = "EN";
            for (size_t i = 1; i < inputs.size(); ++i) inputs[i].name = "In" + std::to_string(i);
        }
        const bool negated = isNegated();
        const std::string type = next();
        return m_builder->box(type, "", inputs, {}, 0, negated);
    }
    std::vector<BoxInput> readInputs(const Wire& before, int depth) {
        std::vector<BoxInput> inputs;
        for (int operands = count("_BOX_EXPR"); operands > 0; --operands)
            inputs.push_back({"In" + std::to_string(inputs.size() + 1), box(before, depth + 1), {}});
        return inputs;
    }

    /// The first output is the box's value; the others are written with their targets behind it.
    Wire blockBox(const Wire& before, int depth) {
        const std::string instance = next();
        std::vector<BoxInput> inputs = readInputs(before, depth);
        const bool negated = isNegated();
        const std::string type = next();
        const std::optional<BlockPins> pins = m_pinsOf(type);
        if (!pins || pins->outputs.empty()) throw Unknown();
        nameInputs(inputs, pins->inputs);
        std::vector<Target> targets;
        if (m_at < m_lines.size() && m_lines[m_at].starts_with("_OUTPUTS"))
            for (int outputs = count("_OUTPUTS"); outputs > 0; --outputs) targets.push_back(readTarget());
        if (targets.size() > pins->outputs.size()) throw Unknown();
        const Wire wire = m_builder->box(type, instance, inputs, pins->outputs, 0, negated);
        const size_t first = targets.size() == pins->outputs.size() ? 0 : 1;
        for (size_t i = 0; i < targets.size(); ++i)
            if (!targets[i].name.empty())
                m_builder->target(targets[i].name, {wire.id, pins->outputs[first + i]}, targets[i].marks);
        return wire;
    }
    static void nameInputs(std::vector<BoxInput>& inputs, const std::vector<std::string>& names) {
        const size_t enables = inputs.size() == names.size() + 1 ? 1 : 0; // EN is in front of them
        if (inputs.size() > names.size() + enables) throw Unknown();
        for (size_t i = 0; i < inputs.size(); ++i) inputs[i].name = i < enables ? "EN" : names[i - enables];
    }

    static constexpr int kDeepest = 100;
    const PinsOfType& m_pinsOf;
    pugi::xml_document& m_document;
    std::optional<DiagramBuilder> m_builder;
    std::vector<std::string> m_lines;
    size_t m_at = 0;
};

using lex::TokenKind;

struct StandardBlock {
    std::string_view type;
    BlockPins pins;
};

/// The section that a token opens: where its variables go, nothing for those that are no pins.
std::vector<std::string>* sectionOf(TokenKind kind, BlockPins& pins, std::vector<std::string>& inOuts) {
    if (kind == TokenKind::VarInput) return &pins.inputs;
    if (kind == TokenKind::VarOutput) return &pins.outputs;
    return kind == TokenKind::VarInOut ? &inOuts : nullptr;
}

/// The pins that the sections from `at` on declare; `at` ends behind the last section.
BlockPins pinsIn(const lex::TokenList& list, std::string_view text, size_t& at) {
    BlockPins pins;
    std::vector<std::string> inOuts, waiting;
    std::vector<std::string>* section = nullptr;
    for (; at < list.tokens.size(); ++at) {
        const lex::Token& token = list.tokens[at];
        if (token.kind == TokenKind::EndFunctionBlock || token.kind == TokenKind::EndOfFile) break;
        if (token.kind == TokenKind::EndVar) section = nullptr;
        if (std::vector<std::string>* opened = sectionOf(token.kind, pins, inOuts)) section = opened;
        if (!section) continue;
        if (token.kind == TokenKind::Identifier && at + 1 < list.tokens.size() &&
            (list.tokens[at + 1].kind == TokenKind::Colon || list.tokens[at + 1].kind == TokenKind::Comma))
            waiting.emplace_back(text.substr(token.begin, token.end - token.begin));
        else if (token.kind == TokenKind::Colon)
            section->insert(section->end(), waiting.begin(), waiting.end()), waiting.clear();
        else if (token.kind != TokenKind::Comma)
            waiting.clear();
    }
    pins.inputs.insert(pins.inputs.end(), inOuts.begin(), inOuts.end());
    return pins;
}

} // namespace

std::optional<BlockPins> standardPins(const std::string& type) {
    static const StandardBlock blocks[] = {
        {"TON", {{"IN", "PT"}, {"Q", "ET"}}},
        {"TOF", {{"IN", "PT"}, {"Q", "ET"}}},
        {"TP", {{"IN", "PT"}, {"Q", "ET"}}},
        {"CTU", {{"CU", "R", "PV"}, {"Q", "CV"}}},
        {"CTD", {{"CD", "LD", "PV"}, {"Q", "CV"}}},
        {"CTUD", {{"CU", "CD", "R", "LD", "PV"}, {"QU", "QD", "CV"}}},
        {"SR", {{"S1", "R"}, {"Q1"}}},
        {"RS", {{"S", "R1"}, {"Q1"}}},
        {"R_TRIG", {{"CLK"}, {"Q"}}},
        {"F_TRIG", {{"CLK"}, {"Q"}}},
    };
    for (const StandardBlock& each : blocks)
        if (equalsIgnoringCase(each.type, type)) return each.pins;
    return std::nullopt;
}

void gatherBlockPins(std::string_view text, std::map<std::string, BlockPins>& out) {
    diagnostics::Sink ignored;
    const lex::TokenList list = lex::tokenize(FileId(0), text, ignored);
    for (size_t at = 0; at + 1 < list.tokens.size(); ++at) {
        if (list.tokens[at].kind != TokenKind::FunctionBlock) continue;
        const lex::Token& name = list.tokens[++at];
        if (name.kind != TokenKind::Identifier) continue;
        const std::string type = foldCase(text.substr(name.begin, name.end - name.begin));
        BlockPins pins = pinsIn(list, text, at);
        if (!pins.outputs.empty()) out[type] = std::move(pins);
    }
}

bool readCodesys2Diagram(std::string_view text, const PinsOfType& pinsOf, pugi::xml_document& document) {
    try {
        DiagramReader(text, pinsOf, document).read();
        return true;
    } catch (const Unknown&) {
        document.reset();
        return false;
    }
}

} // namespace plc::exchange
