#include "projects/exchange/plcopen/plcopen_types.h"

#include "runtime/base/text.h"

namespace plc::exchange {

namespace {

std::string range(pugi::xml_node node) { return attribute(node, "lower") + ".." + attribute(node, "upper"); }

std::string arrayText(pugi::xml_node node, const std::string& indent) {
    std::string dimensions;
    for (const pugi::xml_node child : node.children()) {
        if (!is(child, "dimension")) continue;
        const std::string lower = attribute(child, "lower"), upper = attribute(child, "upper");
        dimensions += (dimensions.empty() ? "" : ", ") + (lower == "*" || upper == "*" ? "*" : range(child));
    }
    return "ARRAY [" + dimensions + "] OF " + typeText(childOf(node, "baseType"), indent);
}

std::string enumText(pugi::xml_node node, const std::string& indent) {
    std::string out = "(";
    bool first = true;
    for (const pugi::xml_node value : childOf(node, "values").children()) {
        if (!is(value, "value")) continue;
        out += first ? "\n" : ",\n";
        first = false;
        out += commentLines(textOf(childOf(value, "documentation")), indent + "    ");
        out += indent + "    " + attribute(value, "name");
        if (const std::string number = attribute(value, "value"); !number.empty()) out += " := " + number;
    }
    out += "\n" + indent + ")";
    if (const pugi::xml_node base = childOf(node, "baseType")) out += " " + typeText(base);
    return out;
}

std::string structText(pugi::xml_node node, const std::string& indent, const char* word) {
    std::string out = std::string(word) + "\n";
    for (const pugi::xml_node child : node.children())
        if (is(child, "variable")) out += variableText(child, indent + "    ");
    return out + indent + "END_" + word;
}

std::string stringText(pugi::xml_node node, const char* word) {
    const std::string length = attribute(node, "length");
    return length.empty() ? word : std::string(word) + "[" + length + "]";
}

std::string textOfType(pugi::xml_node node, const std::string& indent) {
    const std::string_view name = localName(node);
    if (name == "derived") return attribute(node, "name");
    if (name == "array") return arrayText(node, indent);
    if (name == "string") return stringText(node, "STRING");
    if (name == "wstring") return stringText(node, "WSTRING");
    if (name == "pointer") return "POINTER TO " + typeText(childOf(node, "baseType"), indent);
    if (name == "reference") return "REFERENCE TO " + typeText(childOf(node, "baseType"), indent);
    if (name == "enum") return enumText(node, indent);
    if (name == "struct") return structText(node, indent, "STRUCT");
    if (name == "union") return structText(node, indent, "UNION");
    if (name == "subrangeSigned" || name == "subrangeUnsigned")
        return typeText(childOf(node, "baseType")) + " (" + range(childOf(node, "range")) + ")";
    return std::string(name); // BOOL, INT, …, ANY_NUM
}

std::string arrayValueText(pugi::xml_node node) {
    std::string out = "[";
    for (const pugi::xml_node value : node.children()) {
        if (!is(value, "value")) continue;
        if (out.size() > 1) out += ", ";
        const std::string repeat = attribute(value, "repetitionValue");
        const std::string text = valueText(value);
        out += repeat.empty() || repeat == "1" ? text : repeat + "(" + text + ")";
    }
    return out + "]";
}

std::string structValueText(pugi::xml_node node) {
    std::string out = "(";
    for (const pugi::xml_node value : node.children()) {
        if (!is(value, "value")) continue;
        if (out.size() > 1) out += ", ";
        out += attribute(value, "member") + " := " + valueText(value);
    }
    return out + ")";
}

/// CODESYS: fb : Motor(speed := 5)
std::string constructorText(pugi::xml_node variable) {
    const pugi::xml_node data = dataOf(variable, "/inputassignments");
    std::string out;
    for (const pugi::xml_node each : childOf(data, "InputAssignments").children()) {
        if (!is(each, "InputAssignment")) continue;
        const std::string name = textOf(childOf(each, "Name")), value = textOf(childOf(each, "Value"));
        out += (out.empty() ? "" : ", ") + (name.empty() ? value : name + " := " + value);
    }
    return out.empty() ? out : "(" + out + ")";
}

/// {attribute 'x'} of an enumeration's or structure's own attributes.
std::string extendsText(pugi::xml_node dataType) {
    const std::string base = textOf(descendantOf(dataOf(dataType, "/datatypeinheritance"), "Inheritance/Extends"));
    return base.empty() ? base : " EXTENDS " + trimmed(base);
}

} // namespace

std::string attributeLines(pugi::xml_node element, const std::string& indent) {
    std::string out;
    for (const pugi::xml_node each : childOf(dataOf(element, "/attributes"), "Attributes").children()) {
        if (!is(each, "Attribute")) continue;
        const std::string value = attribute(each, "Value");
        out += indent + "{attribute '" + attribute(each, "Name") + "'" + (value.empty() ? "" : " := '" + value + "'") +
               "}\n";
    }
    return out;
}

std::string typeText(pugi::xml_node holder, const std::string& indent) {
    for (const pugi::xml_node child : holder.children())
        if (child.type() == pugi::node_element && !is(child, "addData") && !is(child, "documentation"))
            return textOfType(child, indent);
    return {};
}

std::string valueText(pugi::xml_node holder) {
    for (const pugi::xml_node child : holder.children()) {
        if (is(child, "simpleValue")) return attribute(child, "value");
        if (is(child, "arrayValue")) return arrayValueText(child);
        if (is(child, "structValue")) return structValueText(child);
    }
    return {};
}

namespace {

/// Of a STRING, Beremiz writes the text without quotation marks: "1234" is six characters, and 12 is no number.
std::string initialText(pugi::xml_node variable) {
    std::string value = valueText(childOf(variable, "initialValue"));
    if (value.empty() || !childOf(childOf(variable, "type"), "string")) return value;
    const auto first = static_cast<unsigned char>(value.front());
    const bool isOneWord = value.find_first_of(" \t") == std::string::npos;
    if (first == '\'' || (first != '"' && !std::isdigit(first) && isOneWord)) return value; // or a constant's name
    std::string text = "'";
    for (const char c : value) {
        if (c == '\'') text += '$';
        text += c;
    }
    return text + "'";
}

} // namespace

std::string variableText(pugi::xml_node variable, const std::string& indent) {
    const std::string comment = trimmed(textOf(childOf(variable, "documentation")));
    const bool isLong = comment.find('\n') != std::string::npos;
    std::string out = isLong ? commentLines(comment, indent) : std::string();
    out += attributeLines(variable, indent);
    out += indent + attribute(variable, "name");
    if (const std::string address = attribute(variable, "address"); !address.empty()) out += " AT " + address;
    out += " : " + typeText(childOf(variable, "type"), indent) + constructorText(variable);
    if (const std::string value = initialText(variable); !value.empty()) out += " := " + value;
    out += ";";
    if (!comment.empty() && !isLong) out += " // " + comment;
    return out + "\n";
}

std::string typeDeclaration(pugi::xml_node dataType) {
    std::string out = commentLines(textOf(childOf(dataType, "documentation")), "");
    out += attributeLines(dataType, "");
    out += "TYPE " + attribute(dataType, "name") + extendsText(dataType) + " :";
    const std::string type = typeText(childOf(dataType, "baseType"));
    const bool isBlock = type.starts_with("STRUCT") || type.starts_with("UNION");
    out += (isBlock ? "\n" : " ") + type;
    if (const std::string value = valueText(childOf(dataType, "initialValue")); !value.empty()) out += " := " + value;
    return out + (isBlock ? "\n" : ";\n") + "END_TYPE\n";
}

} // namespace plc::exchange
