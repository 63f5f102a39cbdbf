#include "projects/exchange/plcopen/plcopen_interface.h"

#include "projects/exchange/plcopen/plcopen_types.h"

namespace plc::exchange {

namespace {

struct SectionRow {
    std::string_view element, word;
};
constexpr SectionRow kSections[] = {
    {"inputVars", "VAR_INPUT"},   {"outputVars", "VAR_OUTPUT"}, {"inOutVars", "VAR_IN_OUT"},
    {"localVars", "VAR"},         {"tempVars", "VAR_TEMP"},     {"externalVars", "VAR_EXTERNAL"},
    {"globalVars", "VAR_GLOBAL"}, {"statVars", "VAR_STAT"},     {"instVars", "VAR_INST"},
};

std::string_view sectionWord(std::string_view element) {
    for (const SectionRow& row : kSections)
        if (row.element == element) return row.word;
    return {};
}

std::string qualifiers(pugi::xml_node section) {
    std::string out;
    if (const std::string access = attribute(section, "access"); !access.empty()) out += " " + access;
    if (isTrue(section, "constant")) out += " CONSTANT";
    if (isTrue(section, "retain")) out += " RETAIN";
    if (isTrue(section, "nonretain")) out += " NON_RETAIN";
    if (isTrue(section, "persistent")) out += " PERSISTENT";
    return out;
}

std::string accessSection(pugi::xml_node section, const std::string& indent) {
    std::string out = indent + "VAR_ACCESS\n";
    for (const pugi::xml_node each : section.children()) {
        if (!is(each, "accessVariable")) continue;
        out += indent + "    " + attribute(each, "alias") + " : " + attribute(each, "instancePathAndName") + " : " +
               typeText(childOf(each, "type"));
        if (const std::string direction = attribute(each, "direction"); direction == "readOnly")
            out += " READ_ONLY";
        else if (direction == "readWrite")
            out += " READ_WRITE";
        out += ";\n";
    }
    return out + indent + "END_VAR\n";
}

std::string configSection(pugi::xml_node section, const std::string& indent) {
    std::string out = indent + "VAR_CONFIG\n";
    for (const pugi::xml_node each : section.children()) {
        if (!is(each, "configVariable")) continue;
        out += indent + "    " + attribute(each, "instancePathAndName");
        if (const std::string address = attribute(each, "address"); !address.empty()) out += " AT " + address;
        out += " : " + typeText(childOf(each, "type"));
        if (const std::string value = valueText(childOf(each, "initialValue")); !value.empty()) out += " := " + value;
        out += ";\n";
    }
    return out + indent + "END_VAR\n";
}

std::string modifiers(pugi::xml_node interface) {
    const pugi::xml_node data = childOf(dataOf(interface, "/accessmodifiers"), "AccessModifiers");
    std::string out;
    for (const char* word : {"Private", "Protected", "Internal", "Public", "Abstract", "Final", "Override"})
        if (isTrue(data, word)) {
            std::string upper(word);
            for (char& c : upper) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
            out += upper + " ";
        }
    return out;
}

std::string inheritance(pugi::xml_node interface) {
    pugi::xml_node data = childOf(dataOf(interface, "/pouinheritance"), "Inheritance");
    if (!data) data = childOf(interface, "Inheritance"); // of an interface
    std::string extends, implements;
    for (const pugi::xml_node each : data.children()) {
        const std::string name = trimmed(textOf(each));
        if (is(each, "Extends")) extends += (extends.empty() ? " EXTENDS " : ", ") + name;
        if (is(each, "Implements")) implements += (implements.empty() ? " IMPLEMENTS " : ", ") + name;
    }
    return extends + implements;
}

std::string resultText(pugi::xml_node element, pugi::xml_node interface, PieceKind kind) {
    std::string type = typeText(childOf(interface, "returnType"));
    if (type.empty() && kind == PieceKind::Property) type = typeText(childOf(element, "type"));
    return type.empty() ? type : " : " + type;
}

} // namespace

std::string plainInterface(pugi::xml_node element) {
    for (const pugi::xml_node holder : {element, childOf(element, "interface")}) {
        const pugi::xml_node plain = childOf(dataOf(holder, "/interfaceasplaintext"), "InterfaceAsPlainText");
        if (plain) return trimmedLines(textOf(plain));
    }
    return {};
}

std::string sectionText(pugi::xml_node section, const std::string& indent) {
    if (is(section, "accessVars")) return accessSection(section, indent);
    if (is(section, "configVars")) return configSection(section, indent);
    const std::string_view word = sectionWord(localName(section));
    if (word.empty()) return {};
    std::string out = attributeLines(section, indent) + indent + std::string(word) + qualifiers(section) + "\n";
    for (const pugi::xml_node variable : section.children())
        if (is(variable, "variable")) out += variableText(variable, indent + "    ");
    return out + indent + "END_VAR\n";
}

std::string declarationOf(pugi::xml_node element, PieceKind kind, const std::string& name) {
    if (std::string plain = plainInterface(element); !plain.empty()) return plain;
    const pugi::xml_node interface = childOf(element, "interface");
    std::string comment = textOf(childOf(interface, "documentation"));
    if (trimmed(comment).empty()) comment = textOf(childOf(element, "documentation"));
    std::string out;
    if (kind != PieceKind::PropertyGet && kind != PieceKind::PropertySet) {
        out = commentLines(comment, "") + attributeLines(interface, "") + attributeLines(element, "") +
              std::string(keywordOf(kind)) + " " + modifiers(interface) + name + inheritance(interface) +
              inheritance(element) + resultText(element, interface, kind) + "\n";
    }
    for (const pugi::xml_node section : interface.children()) out += sectionText(section, "");
    return out;
}

std::string globalsText(pugi::xml_node globalVars, const std::string& indent) {
    if (std::string plain = plainInterface(globalVars); !plain.empty()) return plain + "\n";
    const pugi::xml_node mixed = childOf(dataOf(globalVars, "/mixedattrsvarlist"), "MixedAttrsVarList");
    if (!mixed)
        return commentLines(textOf(childOf(globalVars, "documentation")), indent) + sectionText(globalVars, indent);
    std::string out = commentLines(textOf(childOf(globalVars, "documentation")), indent);
    const std::string attributes = attributeLines(globalVars, indent);
    for (const pugi::xml_node part : mixed.children())
        if (is(part, "globalVars")) out += attributes + sectionText(part, indent);
    return out;
}

} // namespace plc::exchange
