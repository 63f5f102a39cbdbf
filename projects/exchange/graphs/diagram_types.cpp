#include "projects/exchange/graphs/diagram_types.h"

#include "projects/exchange/graphs/flow.h"
#include "runtime/base/text.h"

#include <algorithm>

namespace plc::exchange {

namespace {

constexpr Operator kOperators[] = {
    {"AND", "AND", Flow::kAnd},
    {"OR", "OR", Flow::kOr},
    {"XOR", "XOR", Flow::kXor},
    {"ADD", "+", Flow::kSum},
    {"SUB", "-", Flow::kSum},
    {"MUL", "*", Flow::kProduct},
    {"DIV", "/", Flow::kProduct},
    {"MOD", "MOD", Flow::kProduct},
    {"EQ", "=", Flow::kEqual},
    {"NE", "<>", Flow::kEqual},
    {"GT", ">", Flow::kLess},
    {"GE", ">=", Flow::kLess},
    {"LT", "<", Flow::kLess},
    {"LE", "<=", Flow::kLess},
    // CFC boxes may have the sign as their name
    {"=", "=", Flow::kEqual},
    {"<>", "<>", Flow::kEqual},
    {">", ">", Flow::kLess},
    {">=", ">=", Flow::kLess},
    {"<", "<", Flow::kLess},
    {"<=", "<=", Flow::kLess},
    {"+", "+", Flow::kSum},
    {"-", "-", Flow::kSum},
    {"*", "*", Flow::kProduct},
    {"/", "/", Flow::kProduct},
    {"&", "AND", Flow::kAnd},
};

bool isDate(const std::string& type) {
    return isOneOf(type, {"DT", "DATE_AND_TIME", "LDT", "DATE", "LDATE", "D", "TOD", "TIME_OF_DAY", "LTOD"});
}

/// Two dates are a time apart; a time before or behind a date is one.
std::string typeOfDates(const std::vector<std::string>& types) {
    if (types.size() != 2 || types[1].empty()) return {};
    if (isDate(types[1])) return types[1].front() == 'L' ? "LTIME" : "TIME";
    return types[0];
}

} // namespace

const Operator* operatorOf(std::string_view function) {
    for (const Operator& each : kOperators)
        if (equalsIgnoringCase(each.function, function)) return &each;
    return nullptr;
}

std::string functionOf(const Operator& op) {
    for (const Operator& each : kOperators) // the names come first
        if (each.word == op.word) return std::string(each.function);
    return std::string(op.function);
}

bool isComparison(const Operator& op) { return op.level == Flow::kEqual || op.level == Flow::kLess; }

std::string DiagramTypes::atPoint(pugi::xml_node point, int depth) const {
    const pugi::xml_node connection = childOf(point, "connection");
    return connection ? of(m_graph.find(attribute(connection, "refLocalId")), attribute(connection, "formalParameter"),
                           depth + 1)
                      : std::string();
}

std::string DiagramTypes::of(pugi::xml_node node, const std::string& pinName, int depth) const {
    if (!node || depth > 400) return {};
    const std::string_view kind = localName(node);
    if (kind == "contact" || kind == "leftPowerRail" || kind == "coil") return "BOOL";
    if (equalsIgnoringCase(pinName, "ENO")) return "BOOL";
    if (kind == "inVariable" || kind == "inOutVariable") return ofText(trimmed(textOf(childOf(node, "expression"))));
    if (kind == "continuation")
        return atPoint(childOf(m_graph.connectorNamed(attribute(node, "name")), "connectionPointIn"), depth);
    if (kind != "block") return {};
    const std::string key = DiagramGraph::idOf(node) + ":" + pinName; // boxes may share what is before them
    if (const auto known = m_known.find(key); known != m_known.end()) return known->second;
    m_known.emplace(key, std::string()); // a loop has no type of its own
    return m_known[key] = ofBlock(node, pinName, depth);
}

std::string DiagramTypes::ofBlock(pugi::xml_node node, const std::string& pinName, int depth) const {
    if (DiagramGraph::isBlockInstance(node)) {
        if (isOneOf(pinName, {"Q", "Q1", "QU", "QD"})) return "BOOL";
        if (isOneOf(pinName, {"ET"})) return "TIME";
        if (isOneOf(pinName, {"CDT"})) return "DT";
        if (isOneOf(pinName, {"CV"}) && isOneOf(attribute(node, "typeName"), {"CTU", "CTD", "CTUD"})) return "INT";
        return {};
    }
    return ofFunction(node, depth);
}

std::string DiagramTypes::ofFunction(pugi::xml_node block, int depth) const {
    const std::string type = attribute(block, "typeName");
    if (const auto it = m_results.find(foldCase(type)); it != m_results.end()) return it->second;
    if (const Operator* op = operatorOf(type); op && isComparison(*op)) return "BOOL";
    const std::string upper = [&] {
        std::string text = type;
        for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        return text;
    }();
    if (const size_t to = upper.find("_TO_"); to != std::string::npos) return upper.substr(to + 4);
    if (upper.starts_with("TO_")) return upper.substr(3);
    if (isOneOf(upper, {"LEN", "FIND"})) return "INT";
    if (isOneOf(upper, {"TRUNC"})) return "DINT";
    if (isOneOf(upper, {"CONCAT", "LEFT", "RIGHT", "MID", "INSERT", "DELETE", "REPLACE"})) return "STRING";
    const bool isSelection = isOneOf(upper, {"SEL", "MUX"});
    if (!isSelection && !operatorOf(upper) &&
        !isOneOf(upper, {"MOVE", "NOT",  "ABS",  "SQRT", "LN",  "LOG",   "EXP", "SIN", "COS", "TAN", "ASIN",
                         "ACOS", "ATAN", "EXPT", "MAX",  "MIN", "LIMIT", "SHL", "SHR", "ROL", "ROR"}))
        return {};
    std::vector<std::string> types; // of the operands, "" where it is not known
    for (const pugi::xml_node variable : childOf(block, "inputVariables").children())
        if (!equalsIgnoringCase(attribute(variable, "formalParameter"), "EN"))
            types.push_back(atPoint(childOf(variable, "connectionPointIn"), depth));
    if (isSelection && !types.empty()) types.erase(types.begin());
    if (isOneOf(upper, {"SUB", "ADD"}) && std::any_of(types.begin(), types.end(), isDate)) return typeOfDates(types);
    for (std::string& each : types)
        if (!each.empty()) return std::move(each);
    return {};
}

std::string DiagramTypes::ofText(const std::string& text) const {
    if (isOneOf(text, {"TRUE", "FALSE"})) return "BOOL";
    if (const size_t hash = text.find('#');
        hash != std::string::npos && std::isalpha(static_cast<unsigned char>(text[0]))) {
        const std::string prefix = foldCase(text.substr(0, hash));
        return prefix == "t" ? "TIME" : prefix == "lt" ? "LTIME" : text.substr(0, hash);
    }
    const auto it = m_variables.find(foldCase(text));
    return it == m_variables.end() ? std::string() : it->second;
}

} // namespace plc::exchange
