#include "projects/exchange/graphs/diagram.h"

#include "projects/exchange/base/assemble.h"
#include "projects/exchange/graphs/diagram_graph.h"
#include "projects/exchange/graphs/diagram_types.h"
#include "projects/exchange/graphs/flow.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <optional>
#include <set>

namespace plc::exchange {

namespace {

constexpr size_t kLongest = 20000; // characters of one expression: a diagram with more repeats itself

/// The names that a text begins with or mentions, folded: "a.b[i]" mentions a and i.
std::set<std::string> namesIn(std::string_view text) {
    std::set<std::string> out;
    for (size_t at = 0; at < text.size();) {
        const auto isWord = [&](size_t i) {
            return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) || text[i] == '_' ||
                                       static_cast<unsigned char>(text[i]) >= 0x80);
        };
        if (!isWord(at)) {
            ++at;
            continue;
        }
        const size_t begin = at;
        while (isWord(at)) ++at;
        if (begin == 0 || text[begin - 1] != '.') out.insert(foldCase(text.substr(begin, at - begin)));
    }
    return out;
}

std::string firstName(std::string_view target) { return foldCase(target.substr(0, target.find_first_of(".[^ "))); }

bool isEmptyOperand(const std::string& text) { return text.empty() || text.find("???") != std::string::npos; }

enum class Storage : uint8_t { None, Set, Reset };
Storage storageOf(pugi::xml_node node) {
    const std::string text = attribute(node, "storage");
    return text == "set" ? Storage::Set : text == "reset" ? Storage::Reset : Storage::None;
}

bool endsExecution(std::string_view name) { return name == "jump" || name == "return"; }

} // namespace

struct Diagram::State : DiagramGraph {
    State(pugi::xml_node body, const XmlFile& file, std::string unitName, const DiagramNames& known, Report& sink)
        : DiagramGraph(body), file(file), unit(std::move(unitName)), names(known), report(sink),
          types(*this, names.variableTypes, names.resultTypes) {}

    struct Statement {
        std::string text;
        std::set<std::string> writes; // folded names
    };
    struct Known {
        Flow flow;
        size_t at = 0; // statements that ran before it was computed
        std::string temporary;
    };

    const XmlFile& file;
    std::string unit;
    const DiagramNames names;
    Report& report;
    const DiagramTypes types;
    std::map<std::string, Known> known;
    std::set<std::string> emitted, inProgress;
    int order = 0; // of the element that is written
    std::vector<Statement> statements;
    std::vector<std::pair<std::string, std::string>> variables;

    std::string place(pugi::xml_node node) const {
        const int line = file.lineOf(node); // none: the diagram was made of another form
        return file.place() + (line > 0 ? ":" + std::to_string(line) : "") + " (" + unit + ")";
    }
    std::string shown(pugi::xml_node node) const {
        std::string name = attribute(node, "instanceName");
        if (name.empty()) name = attribute(node, "typeName");
        if (name.empty()) name = trimmed(exchange::textOf(childOf(node, "variable")));
        if (name.empty()) name = trimmed(exchange::textOf(childOf(node, "expression")));
        return name.empty() ? std::string(localName(node)) + " " + idOf(node) : name;
    }
    // ------------------------------------------------------------ values

    void write(std::string text, std::set<std::string> writes = {}) {
        statements.push_back({std::move(text), std::move(writes)});
    }
    /// Declares a variable of the diagram; one that an earlier import declared is used again.
    std::string declare(const std::string& stem, const std::string& id, const std::string& type) {
        const size_t dot = unit.find('.');
        std::string name = (dot == std::string::npos ? "" : unit.substr(dot + 1) + "_") + stem + "_" + id;
        for (char& c : name)
            if (!std::isalnum(static_cast<unsigned char>(c)) && static_cast<unsigned char>(c) < 0x80) c = '_';
        for (;; name += "_") {
            const auto it = names.variableTypes.find(foldCase(name));
            if (it != names.variableTypes.end() && !equalsIgnoringCase(it->second, type)) continue;
            const auto mine = std::find_if(variables.begin(), variables.end(), [&](const auto& variable) {
                return equalsIgnoringCase(variable.first, name);
            });
            if (mine != variables.end()) {
                if (equalsIgnoringCase(mine->second, type)) return name;
                continue;
            }
            if (it == names.variableTypes.end()) variables.emplace_back(name, type);
            return name;
        }
    }

    Flow edge(pugi::xml_node owner, const std::string& suffix, const std::string& kind, const Flow& signal) {
        if (names.isFunction) {
            report.add(place(owner), remarks::DiagramEdgeInFunction());
            return signal;
        }
        const std::string name = declare("edge", idOf(owner) + suffix, kind == "rising" ? "R_TRIG" : "F_TRIG");
        write(name + "(CLK := " + signal.text() + ");", {foldCase(name)});
        return {name + ".Q", Flow::kPrimary};
    }
    /// Negation and edge of a pin, contact or coil.
    Flow modified(pugi::xml_node holder, pugi::xml_node owner, const std::string& suffix, Flow flow) {
        if (const std::string kind = attribute(holder, "edge"); kind == "rising" || kind == "falling")
            flow = edge(owner, suffix, kind, flow);
        return isTrue(holder, "negated") ? flow.negated() : flow;
    }

    std::optional<Flow> atPoint(pugi::xml_node point) {
        std::vector<Flow> all;
        for (const pugi::xml_node connection : point.children()) {
            if (!is(connection, "connection")) continue;
            if (auto flow = output(find(attribute(connection, "refLocalId")), attribute(connection, "formalParameter")))
                all.push_back(std::move(*flow));
        }
        if (!all.empty()) return Flow::any(all);
        // 0201: an expression beside the point
        if (const std::string text = trimmed(exchange::textOf(childOf(point, "expression"))); !text.empty())
            return Flow::ofUser(text);
        return std::nullopt;
    }
    std::optional<Flow> input(pugi::xml_node holder) { return atPoint(childOf(holder, "connectionPointIn")); }

    bool wasWrittenSince(const Known& value) const {
        const std::set<std::string> reads = namesIn(value.flow.text());
        for (size_t i = value.at; i < statements.size(); ++i)
            for (const std::string& name : statements[i].writes)
                if (reads.count(name)) return true;
        return false;
    }
    /// The value again, although something it reads was written in between: it is stored where it was computed.
    Flow again(pugi::xml_node node, const std::string& pinName, Known& value) {
        if (!value.temporary.empty()) return {value.temporary, Flow::kPrimary};
        if (!wasWrittenSince(value)) return value.flow;
        const std::string type = types.of(node, pinName);
        if (type.empty()) {
            report.add(place(node), remarks::DiagramResultRepeated(shown(node)));
            return value.flow;
        }
        const size_t at = value.at;
        value.temporary = declare("flow", idOf(node), type);
        statements.insert(statements.begin() + static_cast<std::ptrdiff_t>(at),
                          {value.temporary + " := " + value.flow.text() + ";", {}});
        for (auto& [key, each] : known)
            if (each.at > at || &each == &value) ++each.at;
        return {value.temporary, Flow::kPrimary};
    }

    std::optional<Flow> output(pugi::xml_node node, const std::string& pinName) {
        if (!node) return std::nullopt;
        const std::string_view kind = localName(node);
        if (kind == "leftPowerRail") return Flow::yes();
        if (kind == "inVariable" || kind == "inOutVariable") return variableValue(node);
        if (kind == "continuation") {
            const pugi::xml_node connector = connectorNamed(attribute(node, "name"));
            return connector ? guarded(connector, pinName) : std::nullopt;
        }
        if (kind == "block" && isBlockInstance(node)) return instanceOutput(node, pinName); // it stores its outputs
        const std::string key = idOf(node) + ":" + foldCase(pinName);
        if (const auto it = known.find(key); it != known.end()) return again(node, pinName, it->second);
        std::optional<Flow> flow = guarded(node, pinName);
        if (flow && !flow->isEmpty()) {
            if (flow->text().size() > kLongest) throw TooLong();
            known[key] = {*flow, statements.size(), {}};
        }
        return flow;
    }
    struct TooLong {};

    /// Stops a loop that no block breaks.
    std::optional<Flow> guarded(pugi::xml_node node, const std::string& pinName) {
        const std::string id = idOf(node);
        if (!inProgress.insert(id).second) {
            report.add(place(node), remarks::DiagramLoop(shown(node)));
            return Flow("FALSE", Flow::kPrimary);
        }
        std::optional<Flow> flow;
        if (is(node, "contact"))
            flow = contactFlow(node);
        else if (is(node, "coil") || is(node, "connector") || is(node, "rightPowerRail"))
            flow = input(node);
        else if (is(node, "block"))
            flow = functionOutput(node, pinName);
        inProgress.erase(id);
        return flow;
    }

    std::optional<Flow> variableValue(pugi::xml_node node) {
        const std::string text = trimmed(exchange::textOf(childOf(node, "expression")));
        if (isEmptyOperand(text)) return std::nullopt;
        Flow flow = Flow::ofUser(text);
        return isTrue(node, "negated") || isTrue(node, "negatedOut") ? flow.negated() : flow;
    }

    std::optional<Flow> contactFlow(pugi::xml_node node) {
        const std::string text = trimmed(exchange::textOf(childOf(node, "variable")));
        const std::optional<Flow> before = input(node);
        if (isEmptyOperand(text)) return before;
        return Flow::both(before.value_or(Flow::yes()), modified(node, node, "", Flow::ofUser(text)));
    }

    // ------------------------------------------------------------ blocks

    /// The condition on which a box works; TRUE without EN.
    Flow enable(pugi::xml_node block) {
        const pugi::xml_node en = pin(block, "inputVariables", "EN");
        if (!en) return Flow::yes();
        const std::string key = idOf(block) + ":en";
        if (const auto it = known.find(key); it != known.end()) return again(block, "ENO", it->second);
        if (!inProgress.insert(key).second) { // EN depends on this box's own ENO
            report.add(place(block), remarks::DiagramLoop(shown(block)));
            return {"FALSE", Flow::kPrimary};
        }
        const std::optional<Flow> flow = input(en);
        inProgress.erase(key);
        if (!flow) return Flow::yes();
        const Flow out = modified(en, block, "en", *flow);
        known[key] = {out, statements.size(), {}};
        return out;
    }

    std::string argumentsOf(pugi::xml_node block, bool named) {
        std::string out;
        for (const char* list : {"inputVariables", "inOutVariables"})
            for (const pugi::xml_node variable : childOf(block, list).children()) {
                const std::string name = attribute(variable, "formalParameter");
                if (!is(variable, "variable") || equalsIgnoringCase(name, "EN")) continue;
                const std::optional<Flow> flow = input(variable);
                if (!flow) continue;
                const std::string text = modified(variable, block, name, *flow).text();
                out += (out.empty() ? "" : ", ") + (named && !name.empty() ? name + " := " + text : text);
            }
        return out;
    }

    static std::string guardedStatement(const Flow& enable, const std::string& statement) {
        if (enable.isTrue()) return statement;
        std::string out = "IF " + enable.text() + " THEN\n";
        for (size_t at = 0; at < statement.size();) {
            const size_t end = std::min(statement.find('\n', at), statement.size());
            out += "    " + statement.substr(at, end - at) + "\n";
            at = end + 1;
        }
        return out + "END_IF";
    }

    void callInstance(pugi::xml_node block) {
        if (!emitted.insert(idOf(block)).second) return;
        const std::string name = attribute(block, "instanceName");
        const Flow condition = enable(block);
        const std::string arguments = argumentsOf(block, true);
        std::set<std::string> writes = {firstName(name)};
        for (const pugi::xml_node variable : childOf(block, "inOutVariables").children())
            if (const auto flow = input(variable)) writes.insert(firstName(flow->text()));
        write(guardedStatement(condition, name + "(" + arguments + ");"), std::move(writes));
    }

    /// Where the order is written down, a box that comes later is read as it is: the value of the last call.
    static int orderOf(pugi::xml_node node) { return std::atoi(attribute(node, "executionOrderId").c_str()); }
    bool isLater(pugi::xml_node block) const { return order > 0 && orderOf(block) > order; }
    /// Its result must be computed in its turn: later it would be another one.
    bool readsLater(pugi::xml_node block) const {
        for (const char* list : {"inputVariables", "inOutVariables"})
            for (const pugi::xml_node variable : childOf(block, list).children()) {
                const pugi::xml_node from =
                    find(attribute(childOf(childOf(variable, "connectionPointIn"), "connection"), "refLocalId"));
                if (is(from, "block") && orderOf(block) > 0 && orderOf(from) > orderOf(block)) return true;
            }
        return false;
    }

    Flow instanceOutput(pugi::xml_node block, std::string pinName) {
        if (!isLater(block)) callInstance(block);
        if (equalsIgnoringCase(pinName, "ENO")) return enable(block);
        if (pinName.empty())
            for (const pugi::xml_node variable : childOf(block, "outputVariables").children())
                if (pinName.empty() && !equalsIgnoringCase(attribute(variable, "formalParameter"), "ENO"))
                    pinName = attribute(variable, "formalParameter");
        Flow flow(attribute(block, "instanceName") + "." + pinName, Flow::kPrimary);
        return isTrue(pin(block, "outputVariables", pinName), "negated") ? flow.negated() : flow;
    }

    static bool isExecuteBox(pugi::xml_node block) { return isOneOf(attribute(block, "typeName"), {"EXECUTE"}); }

    void runExecuteBox(pugi::xml_node block) {
        if (!emitted.insert(idOf(block)).second) return;
        const std::string code = trimmedLines(exchange::textOf(childOf(dataOf(block, "/stcode"), "STCode")));
        const Flow condition = enable(block);
        if (!code.empty()) write(guardedStatement(condition, code), namesIn(code));
    }

    bool isProjectFunction(const std::string& type) const { return names.resultTypes.count(foldCase(type)) != 0; }

    /// The expression that a function box computes.
    Flow functionValue(pugi::xml_node block) {
        const std::string type = attribute(block, "typeName");
        std::vector<Flow> operands;
        bool isComplete = true;
        for (const pugi::xml_node variable : childOf(block, "inputVariables").children()) {
            const std::string name = attribute(variable, "formalParameter");
            if (!is(variable, "variable") || equalsIgnoringCase(name, "EN")) continue;
            std::optional<Flow> flow = input(variable);
            isComplete &= flow.has_value();
            if (flow) operands.push_back(modified(variable, block, name, std::move(*flow)));
        }
        if (const Operator* op = operatorOf(type);
            op && operands.size() >= 2 && (!isComparison(*op) || operands.size() == 2)) {
            std::string text;
            for (const Flow& each : operands)
                text += (text.empty() ? "" : " " + std::string(op->word) + " ") +
                        each.operand(text.empty() ? op->level : op->level + 1);
            return {text, op->level};
        }
        if (isOneOf(type, {"MOVE"}) && operands.size() == 1) return operands.front();
        if (isOneOf(type, {"NOT"}) && operands.size() == 1) return operands.front().negated();
        if ((isOneOf(type, {"AND", "OR"})) && operands.size() == 1) return operands.front();
        std::string function = type;
        if (const Operator* op = operatorOf(type); op && !isProjectFunction(type)) {
            if (operands.size() < 2) report.add(place(block), remarks::DiagramInputMissing(type));
            function = functionOf(*op); // = is no name that could be called
            isComplete = true;          // nor have its operands names
        }
        return {function + "(" + argumentsOf(block, isProjectFunction(function) || !isComplete) + ")", Flow::kPrimary};
    }

    Flow functionOutput(pugi::xml_node block, const std::string& pinName) {
        if (isExecuteBox(block)) {
            runExecuteBox(block);
            return enable(block);
        }
        if (equalsIgnoringCase(pinName, "ENO")) {
            runFunction(block);
            return enable(block);
        }
        const Flow condition = enable(block);
        Flow value;
        if (const bool isStored = !condition.isTrue() || isUsedTwice(block, pinName) || readsLater(block); isStored) {
            const std::string type = types.of(block, pinName);
            if (!type.empty()) {
                const std::string name = declare("result", idOf(block), type);
                if (emitted.insert(idOf(block)).second)
                    write(guardedStatement(condition, name + " := " + functionValue(block).text() + ";"),
                          {foldCase(name)});
                value = Flow(name, Flow::kPrimary);
            } else {
                report.add(place(block), readsLater(block) ? remarks::DiagramLoop(attribute(block, "typeName"))
                                         : condition.isTrue()
                                             ? remarks::DiagramResultRepeated(attribute(block, "typeName"))
                                             : remarks::DiagramEnableDropped(attribute(block, "typeName")));
            }
        }
        if (value.isEmpty()) value = functionValue(block);
        pugi::xml_node out = pin(block, "outputVariables", pinName);
        return isTrue(out, "negated") ? value.negated() : value;
    }
    /// A box whose result goes straight into one variable: IF en THEN y := f(x); END_IF.
    bool runIntoVariable(pugi::xml_node sink) {
        const pugi::xml_node connection = childOf(childOf(sink, "connectionPointIn"), "connection");
        const pugi::xml_node block = find(attribute(connection, "refLocalId"));
        const std::string pinName = attribute(connection, "formalParameter");
        if (!is(block, "block") || isBlockInstance(block) || isExecuteBox(block) ||
            equalsIgnoringCase(pinName, "ENO") || isUsedTwice(block, pinName) || !pin(block, "inputVariables", "EN"))
            return false;
        const Flow condition = enable(block);
        if (condition.isTrue() || storageOf(sink) != Storage::None) return false;
        if (!emitted.insert(idOf(block)).second) return false;
        Flow value = functionValue(block);
        if (isTrue(pin(block, "outputVariables", pinName), "negated") != isTrue(sink, "negated"))
            value = value.negated();
        const std::string target = trimmed(exchange::textOf(childOf(sink, "expression")));
        write(guardedStatement(condition, target + " := " + value.text() + ";"), {firstName(target)});
        return true;
    }

    /// A function box of its own: nothing reads its result.
    void runFunction(pugi::xml_node block) {
        if (readsLater(block))
            for (const pugi::xml_node variable : childOf(block, "outputVariables").children())
                if (const std::string name = attribute(variable, "formalParameter");
                    is(variable, "variable") && !equalsIgnoringCase(name, "ENO"))
                    (void)functionOutput(block, name);
        if (hasUsedOutput(block) || !emitted.insert(idOf(block)).second) return;
        const Flow value = functionValue(block);
        if (value.level() == Flow::kPrimary && value.text().ends_with(")"))
            write(guardedStatement(enable(block), value.text() + ";"));
    }

    // ------------------------------------------------------------ statements

    void emitSink(pugi::xml_node node) {
        order = orderOf(node);
        const std::string_view kind = localName(node);
        if (kind == "block") return emitBlock(node);
        if (kind == "outVariable" || kind == "inOutVariable") return emitVariable(node);
        if (kind == "coil") return emitCoil(node);
        if (kind == "label") return write(attribute(node, "label") + ":");
        if (kind == "comment") return emitComment(node);
        if (!endsExecution(kind)) return;
        Flow condition = input(node).value_or(Flow::yes());
        if (isTrue(node, "negated")) condition = condition.negated();
        write(guardedStatement(condition, kind == "jump" ? "JMP " + attribute(node, "label") + ";" : "RETURN;"));
    }
    void emitComment(pugi::xml_node node) {
        std::string text = commentLines(exchange::textOf(childOf(node, "content")), "");
        if (!text.empty() && text.back() == '\n') text.pop_back();
        if (!text.empty()) write(std::move(text));
    }
    void emitBlock(pugi::xml_node block) {
        if (isBlockInstance(block)) return callInstance(block);
        if (isExecuteBox(block)) return runExecuteBox(block);
        runFunction(block);
    }

    void assign(pugi::xml_node node, const std::string& target, Flow value) {
        value = modified(node, node, "", std::move(value));
        const Storage storage = storageOf(node);
        const char* op = storage == Storage::Set ? " S= " : storage == Storage::Reset ? " R= " : " := ";
        write(target + op + value.text() + ";", {firstName(target)});
    }
    void emitVariable(pugi::xml_node node) {
        if (!isConnected(node) && is(node, "inOutVariable")) return;
        if (runIntoVariable(node)) return;
        const std::string target = trimmed(exchange::textOf(childOf(node, "expression")));
        const std::optional<Flow> value = input(node);
        if (isEmptyOperand(target)) return;
        if (!value) return report.add(place(node), remarks::DiagramNotConnected(target));
        assign(node, target, isTrue(node, "negatedIn") ? value->negated() : *value);
    }
    void emitCoil(pugi::xml_node node) {
        const std::string target = trimmed(exchange::textOf(childOf(node, "variable")));
        const std::optional<Flow> value = input(node);
        if (isEmptyOperand(target)) return;
        if (!value) return report.add(place(node), remarks::DiagramNotConnected(target));
        assign(node, target, *value);
    }
};

Diagram::Diagram(pugi::xml_node body, const XmlFile& file, std::string unit, const DiagramNames& names, Report& report)
    : m_state(std::make_unique<State>(body, file, std::move(unit), names, report)) {}
Diagram::~Diagram() = default;

DiagramText Diagram::statements() {
    DiagramText out;
    try {
        for (const pugi::xml_node node : m_state->inOrder()) m_state->emitSink(node);
    } catch (const State::TooLong&) {
        m_state->report.add(m_state->place(m_state->body), remarks::DiagramTooLarge(m_state->unit));
        return out;
    }
    out.statements = pendingStatements();
    out.variables = m_state->variables;
    return out;
}

std::string Diagram::pendingStatements() const {
    std::string out;
    for (const State::Statement& each : m_state->statements) {
        out += each.text;
        if (each.text.ends_with("END_IF")) out += ";";
        out += '\n';
    }
    return out;
}

std::string Diagram::expressionAt(pugi::xml_node connectionPointIn) {
    try {
        const std::optional<Flow> flow = m_state->atPoint(connectionPointIn);
        return flow ? flow->text() : std::string();
    } catch (const State::TooLong&) {
        return {};
    }
}

std::vector<std::pair<std::string, std::string>> Diagram::variables() const { return m_state->variables; }

} // namespace plc::exchange
