#include "projects/exchange/plcopen/xml_writer.h"

#include "projects/exchange/base/xml.h"
#include "runtime/base/text.h"

#include <algorithm>

namespace plc::exchange {

namespace {

using syntax::ExprKind;
using syntax::SectionKind;
using syntax::TypeSpecKind;

constexpr std::string_view kElementary[] = {
    "BOOL",  "BYTE",  "WORD", "DWORD",   "LWORD",   "SINT",     "INT",     "DINT",       "LINT",    "USINT", "UINT",
    "UDINT", "ULINT", "REAL", "LREAL",   "TIME",    "LTIME",    "DATE",    "DT",         "TOD",     "LDATE", "LDT",
    "LTOD",  "BIT",   "ANY",  "ANY_NUM", "ANY_INT", "ANY_REAL", "ANY_BIT", "ANY_STRING", "ANY_DATE"};

/// The tag of an elementary type; empty for a derived one.
std::string elementaryTag(const std::string& name) {
    struct Row {
        std::string_view word, tag;
    };
    static constexpr Row others[] = {{"TIME_OF_DAY", "TOD"}, {"DATE_AND_TIME", "DT"}};
    for (const std::string_view each : kElementary)
        if (equalsIgnoringCase(each, name)) return std::string(each);
    for (const Row& row : others)
        if (equalsIgnoringCase(row.word, name)) return std::string(row.tag);
    return {};
}

const char* sectionTag(SectionKind kind) {
    switch (kind) {
    case SectionKind::Input:
        return "inputVars";
    case SectionKind::Output:
        return "outputVars";
    case SectionKind::InOut:
        return "inOutVars";
    case SectionKind::Temp:
        return "tempVars";
    case SectionKind::External:
        return "externalVars";
    case SectionKind::Global:
        return "globalVars";
    case SectionKind::Access:
        return "accessVars";
    case SectionKind::Config:
        return "configVars";
    case SectionKind::Var:
    case SectionKind::Stat:
    case SectionKind::Inst:
        return "localVars";
    }
    return "localVars";
}

} // namespace

void XmlWriter::text(pugi::xml_node parent, std::string_view text) const {
    if (isPlain()) {
        pugi::xml_node paragraph = parent.append_child("xhtml:p");
        // a CDATA section cannot hold its own end
        for (size_t at = 0; at <= text.size();) {
            const size_t end = text.find("]]>", at);
            const std::string part(text.substr(at, end == std::string_view::npos ? end : end + 2 - at));
            paragraph.append_child(pugi::node_cdata).set_value(part.c_str());
            if (end == std::string_view::npos) break;
            at = end + 2;
        }
        return;
    }
    pugi::xml_node xhtml = parent.append_child("xhtml");
    xhtml.append_attribute("xmlns") = "http://www.w3.org/1999/xhtml";
    xhtml.text().set(std::string(text).c_str());
}

void XmlWriter::documentation(pugi::xml_node parent, std::string_view words) const {
    if (!words.empty()) text(parent.append_child("documentation"), words);
}

pugi::xml_node XmlWriter::data(pugi::xml_node element, const char* name, const char* handle) {
    pugi::xml_node addData = element.child("addData");
    if (!addData) addData = element.append_child("addData");
    pugi::xml_node out = addData.append_child("data");
    out.append_attribute("name") = name;
    out.append_attribute("handleUnknown") = handle;
    return out;
}

void XmlWriter::plainText(pugi::xml_node element, const std::string& declaration) const {
    if (isPlain()) return;
    pugi::xml_node holder = data(element, "http://www.3s-software.com/plcopenxml/interfaceasplaintext");
    text(holder.append_child("InterfaceAsPlainText"), declaration + "\n");
}

std::string XmlWriter::pathText(const syntax::Path& path) const {
    std::string out;
    for (const syntax::Name& name : path) out += (out.empty() ? "" : ".") + std::string(name.text);
    return out;
}

void XmlWriter::namedType(pugi::xml_node holder, const syntax::TypeSpec& spec) const {
    const std::string name = pathText(spec.path);
    if (const std::string tag = spec.path.size() == 1 ? elementaryTag(name) : std::string(); !tag.empty())
        holder.append_child(tag.c_str());
    else
        holder.append_child("derived").append_attribute("name") = name.c_str();
}

void XmlWriter::arrayType(pugi::xml_node holder, const syntax::TypeSpec& spec) const {
    pugi::xml_node array = holder.append_child("array");
    for (const syntax::Bounds& bounds : spec.bounds) {
        pugi::xml_node dimension = array.append_child("dimension");
        const bool isOpen = spec.kind == TypeSpecKind::OpenArray;
        dimension.append_attribute("lower") = isOpen ? "*" : m_source.text(bounds.low).c_str();
        dimension.append_attribute("upper") = isOpen ? "*" : m_source.text(bounds.high).c_str();
    }
    if (spec.element) type(array.append_child("baseType"), *spec.element);
}

void XmlWriter::enumType(pugi::xml_node holder, const syntax::TypeSpec& spec) const {
    pugi::xml_node node = holder.append_child("enum");
    pugi::xml_node values = node.append_child("values");
    for (const syntax::EnumeratorDecl& each : spec.enumerators) {
        pugi::xml_node value = values.append_child("value");
        value.append_attribute("name") = std::string(each.name.text).c_str();
        if (each.value) value.append_attribute("value") = m_source.text(each.value).c_str();
    }
    if (spec.element) type(node.append_child("baseType"), *spec.element);
}

void XmlWriter::type(pugi::xml_node holder, const syntax::TypeSpec& spec) const {
    switch (spec.kind) {
    case TypeSpecKind::Named:
        return namedType(holder, spec);
    case TypeSpecKind::String: {
        const bool isWide = !spec.path.empty() && equalsIgnoringCase(spec.path.front().text, "WSTRING");
        pugi::xml_node node = holder.append_child(isWide ? "wstring" : "string");
        if (spec.length) node.append_attribute("length") = m_source.text(spec.length).c_str();
        return;
    }
    case TypeSpecKind::Array:
    case TypeSpecKind::OpenArray:
        return arrayType(holder, spec);
    case TypeSpecKind::Pointer:
        if (spec.element) type(holder.append_child("pointer").append_child("baseType"), *spec.element);
        return;
    case TypeSpecKind::Enum:
        return enumType(holder, spec);
    case TypeSpecKind::Struct:
        return variables(holder.append_child("struct"), spec.fields);
    case TypeSpecKind::Subrange: {
        const std::string base = pathText(spec.path);
        const bool isUnsigned = !base.empty() && (base[0] == 'U' || base[0] == 'u');
        pugi::xml_node node = holder.append_child(isUnsigned ? "subrangeUnsigned" : "subrangeSigned");
        pugi::xml_node range = node.append_child("range");
        if (!spec.bounds.empty()) {
            range.append_attribute("lower") = m_source.text(spec.bounds.front().low).c_str();
            range.append_attribute("upper") = m_source.text(spec.bounds.front().high).c_str();
        }
        return namedType(node.append_child("baseType"), spec);
    }
    case TypeSpecKind::Union:
    case TypeSpecKind::RefTo:
    case TypeSpecKind::Reference: {
        std::string words(m_source.slice(spec.range));
        if (isPlain()) lose(remarks::TypeNotInEdition(words.substr(0, words.find('\n'))));
        holder.append_child("derived").append_attribute("name") = words.c_str();
        return;
    }
    case TypeSpecKind::Error:
    case TypeSpecKind::Inferred:
        return;
    }
}

void XmlWriter::value(pugi::xml_node holder, const syntax::Expr& expr) const {
    if (expr.kind == ExprKind::ArrayInit) {
        pugi::xml_node array = holder.append_child("arrayValue");
        for (const syntax::Argument& each : expr.arguments) {
            if (!each.value) continue;
            const bool repeats = each.value->kind == ExprKind::Repeat && each.value->arguments.size() == 1 &&
                                 each.value->arguments[0].value;
            pugi::xml_node node = array.append_child("value");
            if (repeats) node.append_attribute("repetitionValue") = m_source.text(each.value->base).c_str();
            value(node, repeats ? *each.value->arguments[0].value : *each.value);
        }
        return;
    }
    if (expr.kind == ExprKind::StructInit) {
        pugi::xml_node structure = holder.append_child("structValue");
        for (const syntax::Argument& each : expr.arguments) {
            if (!each.value) continue;
            pugi::xml_node node = structure.append_child("value");
            node.append_attribute("member") = std::string(each.name.text).c_str();
            value(node, *each.value);
        }
        return;
    }
    holder.append_child("simpleValue").append_attribute("value") = m_source.text(&expr).c_str();
}

/// Version 0201 has no constructors; named arguments are also the initial values of members.
void XmlWriter::membersOfConstructor(pugi::xml_node variable, const syntax::TypeSpec& spec) const {
    const syntax::TypeSpec* inner = &spec;
    while (inner->kind == syntax::TypeSpecKind::Array && inner->element) inner = inner->element;
    if (inner->constructor.empty() && inner->constructors.empty()) return;
    const bool isNamed = std::all_of(inner->constructor.begin(), inner->constructor.end(),
                                     [](const syntax::Argument& each) { return each.name.isValid() && each.value; });
    pugi::xml_node initial = variable.child("initialValue");
    if (inner != &spec || !isNamed || !inner->constructors.empty() || (initial && !initial.child("structValue")))
        return lose(remarks::ConstructorNotInEdition(std::string(variable.attribute("name").value())));
    if (!initial) initial = variable.append_child("initialValue");
    pugi::xml_node structure = initial.child("structValue");
    if (!structure) structure = initial.append_child("structValue");
    for (const syntax::Argument& each : inner->constructor) {
        pugi::xml_node node = structure.append_child("value");
        node.append_attribute("member") = std::string(each.name.text).c_str();
        value(node, *each.value);
    }
}

/// fb : Motor(speed := 5)
void XmlWriter::constructor(pugi::xml_node variable, const syntax::TypeSpec& spec) const {
    if (isPlain()) return membersOfConstructor(variable, spec);
    if (spec.constructor.empty()) return;
    pugi::xml_node list =
        data(variable, "http://www.3s-software.com/plcopenxml/inputassignments").append_child("InputAssignments");
    for (const syntax::Argument& each : spec.constructor) {
        pugi::xml_node node = list.append_child("InputAssignment");
        if (each.name.isValid()) node.append_child("Name").text().set(std::string(each.name.text).c_str());
        node.append_child("Value").text().set(m_source.text(each.value).c_str());
    }
}

void XmlWriter::variables(pugi::xml_node section, const std::vector<syntax::VarDecl*>& declarations) const {
    for (const syntax::VarDecl* each : declarations)
        for (const syntax::Name& name : each->names) {
            pugi::xml_node variable = section.append_child("variable");
            variable.append_attribute("name") = std::string(name.text).c_str();
            if (!each->address.empty() && &name == &each->names.front())
                variable.append_attribute("address") = std::string(each->address).c_str();
            pugi::xml_node holder = variable.append_child("type");
            if (each->type) type(holder, *each->type);
            if (each->initial) value(variable.append_child("initialValue"), *each->initial);
            if (each->type) constructor(variable, *each->type);
            documentation(variable, each->comment);
        }
}

void XmlWriter::section(pugi::xml_node interface, const syntax::VarSection& section) const {
    pugi::xml_node node = interface.append_child(sectionTag(section.kind));
    if (section.constant) node.append_attribute("constant") = true;
    if (section.retain) node.append_attribute("retain") = true;
    if (section.nonRetain) node.append_attribute("nonretain") = true;
    if (section.persistent) node.append_attribute("persistent") = true;
    if (section.kind == SectionKind::Access || section.kind == SectionKind::Config) {
        const bool isAccess = section.kind == SectionKind::Access;
        for (const syntax::VarDecl* each : section.declarations) {
            pugi::xml_node variable = node.append_child(isAccess ? "accessVariable" : "configVariable");
            if (isAccess && !each->names.empty())
                variable.append_attribute("alias") = std::string(each->names.front().text).c_str();
            variable.append_attribute("instancePathAndName") = pathText(each->configPath).c_str();
            if (isAccess) variable.append_attribute("direction") = each->isReadOnly ? "readOnly" : "readWrite";
            if (!isAccess && !each->address.empty())
                variable.append_attribute("address") = std::string(each->address).c_str();
            if (each->type) type(variable.append_child("type"), *each->type);
            if (each->initial) value(variable.append_child("initialValue"), *each->initial);
        }
        return;
    }
    variables(node, section.declarations);
}

} // namespace plc::exchange
