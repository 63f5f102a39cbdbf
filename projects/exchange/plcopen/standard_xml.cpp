#include "projects/exchange/plcopen/standard_xml.h"

#include "projects/exchange/plcopen/standard_bodies.h"

#include <algorithm>

namespace plc::exchange {

namespace {

constexpr const char* kPlcopenData =
    "http://www.3s-software.com/plcopenxml/"; // where methods and so on have their place

bool isUnit(pugi::xml_node node) {
    return is(node, "Program") || is(node, "FunctionBlock") || is(node, "Function") || is(node, "Class");
}

/// Sysmac Studio writes Library\Type.
std::string qualifiedName(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '.');
    return trimmed(name);
}

/// A type by its name, or an array or a reference written where it is used.
std::string typeReference(pugi::xml_node holder) {
    if (const pugi::xml_node name = childOf(holder, "TypeName")) return qualifiedName(textOf(name));
    pugi::xml_node spec = childOf(holder, "InstantlyDefinedType");
    if (!spec) spec = holder;
    if (const pugi::xml_node target = childOf(spec, "ReferenceTo")) return "REF_TO " + typeReference(target);
    std::string dimensions;
    for (const pugi::xml_node each : spec.children()) {
        if (!is(each, "DimensionSpec")) continue;
        const pugi::xml_node bounds = childOf(each, "IndexRange");
        dimensions += (dimensions.empty() ? "" : ", ") +
                      (bounds ? attribute(bounds, "lower") + ".." + attribute(bounds, "upper") : std::string("*"));
    }
    const std::string base = typeReference(childOf(spec, "BaseType"));
    return dimensions.empty() ? base : "ARRAY [" + dimensions + "] OF " + base;
}

class StandardReader {
public:
    StandardReader(const XmlFile& from, XmlFile& to, Report& report)
        : m_file(from), m_to(to), m_nodes(from, to, report) {}

    void read() {
        const pugi::xml_node root = m_file.root();
        const pugi::xml_node project = m_to.document().append_child("project");
        StandardNodes::set(project, "xmlns", kStandardNamespace);
        if (isUnit(root)) {
            addUnit(root, m_nodes.add(m_nodes.add(project, "types", root), "pous", root), "");
            return;
        }
        addHeader(project, "FileHeader", "fileHeader");
        addHeader(project, "ContentHeader", "contentHeader");
        const pugi::xml_node types = m_nodes.add(project, "types", root);
        addNamespace(descendantOf(root, "Types/GlobalNamespace"), m_nodes.add(types, "pous", root), "");
        addInstances(childOf(root, "Instances"),
                     m_nodes.add(m_nodes.add(project, "instances", root), "configurations", root));
        addData(childOf(root, "ContentHeader"), project);
    }

private:
    void addHeader(pugi::xml_node project, const char* from, const char* to) {
        const pugi::xml_node header = m_nodes.add(project, to, childOf(m_file.root(), from));
        for (const pugi::xml_attribute each : childOf(m_file.root(), from).attributes())
            StandardNodes::set(header, each.name(), each.value());
    }

    // ------------------------------------------------------------ types and units

    void addNamespace(pugi::xml_node node, pugi::xml_node units, const std::string& space) {
        for (const pugi::xml_node child : node.children()) {
            if (is(child, "NamespaceDecl"))
                addNamespace(child, units, (space.empty() ? "" : space + ".") + attribute(child, "name"));
            else if (is(child, "DataTypeDecl"))
                addDataType(child, units, space);
            else if (isUnit(child) || is(child, "Interface"))
                addUnit(child, units, space);
            else if (child.type() == pugi::node_element && !is(child, "Documentation") && !is(child, "AddData") &&
                     !is(child, "UsingDirective"))
                m_nodes.leaveOut(child, std::string(localName(child)));
        }
    }

    /// Where a unit is declared and whose names it uses.
    void addSpace(pugi::xml_node node, pugi::xml_node source, const std::string& space) {
        if (!space.empty()) StandardNodes::set(node, "namespace", space);
        for (pugi::xml_node owner = source; owner; owner = owner.parent())
            for (const pugi::xml_node each : owner.children())
                if (is(each, "UsingDirective")) m_nodes.addText(node, "using", each, qualifiedName(textOf(each)));
    }

    void addDataType(pugi::xml_node source, pugi::xml_node units, const std::string& space) {
        const pugi::xml_node node = m_nodes.add(units, "dataType", source);
        StandardNodes::take(node, "name", source);
        addSpace(node, source, space);
        m_nodes.addDocumentation(node, source);
        const pugi::xml_node spec = childOf(source, "UserDefinedTypeSpec");
        const pugi::xml_node base = m_nodes.add(node, "baseType", spec);
        const std::string kind = schemaType(spec);
        if (kind == "StructTypeSpec")
            addStructure(spec, base);
        else if (kind.starts_with("EnumType"))
            addEnumeration(spec, base);
        else if (kind == "SubrangeTypeSpec")
            addTypeText(base, spec,
                        typeReference(childOf(spec, "BaseType")) + " (" + attribute(childOf(spec, "Range"), "lower") +
                            ".." + attribute(childOf(spec, "Range"), "upper") + ")");
        else
            addTypeText(base, spec, typeReference(spec));
        if (const pugi::xml_node value = childOf(spec, "InitialValue")) addValue(node, value);
        addData(source, node);
    }
    void addTypeText(pugi::xml_node holder, pugi::xml_node source, const std::string& text) {
        StandardNodes::set(m_nodes.add(holder, "derived", source), "name", text);
    }
    void addEnumeration(pugi::xml_node spec, pugi::xml_node base) {
        const pugi::xml_node node = m_nodes.add(base, "enum", spec);
        const pugi::xml_node values = m_nodes.add(node, "values", spec);
        for (const pugi::xml_node each : spec.children()) {
            if (!is(each, "Enumerator")) continue;
            const pugi::xml_node value = m_nodes.add(values, "value", each);
            StandardNodes::take(value, "name", each);
            StandardNodes::take(value, "value", each);
            m_nodes.addDocumentation(value, each);
        }
        if (const pugi::xml_node type = childOf(spec, "BaseType"))
            addTypeText(m_nodes.add(node, "baseType", type), type, trimmed(textOf(type)));
    }
    /// OVERLAP without addresses is a union.
    void addStructure(pugi::xml_node spec, pugi::xml_node base) {
        bool isPlaced = false;
        for (const pugi::xml_node each : spec.children()) isPlaced |= is(each, "Member") && childOf(each, "Address");
        const pugi::xml_node node = m_nodes.add(base, isTrue(spec, "overlap") && !isPlaced ? "union" : "struct", spec);
        for (const pugi::xml_node each : spec.children())
            if (is(each, "Member")) addVariable(node, each);
    }

    void addUnit(pugi::xml_node source, pugi::xml_node units, const std::string& space) {
        const bool isInterface = is(source, "Interface");
        const pugi::xml_node node = m_nodes.add(units, isInterface ? "Interface" : "pou", source);
        StandardNodes::take(node, "name", source);
        if (!isInterface)
            StandardNodes::set(node, "pouType",
                               is(source, "Program")    ? "program"
                               : is(source, "Function") ? "function"
                                                        : "functionBlock");
        addSpace(node, source, space);
        addInterface(source, node);
        addTextDeclaration(source, node);
        addMethods(source, node, isInterface);
        addBodies(m_nodes, childOf(source, "MainBody"), node);
        const pugi::xml_node actions = m_nodes.add(node, "actions", source);
        const pugi::xml_node transitions = m_nodes.add(node, "transitions", source);
        for (const pugi::xml_node each : source.children()) {
            if (is(each, "Action")) {
                const pugi::xml_node action = m_nodes.add(actions, "action", each);
                StandardNodes::take(action, "name", each);
                addBodies(m_nodes, childOf(each, "Body"), action);
            } else if (is(each, "Transition")) {
                const pugi::xml_node transition = m_nodes.add(transitions, "transition", each);
                StandardNodes::take(transition, "name", each);
                addBodyContent(m_nodes, descendantOf(each, "Condition/PredicateContent"),
                               m_nodes.add(transition, "body", each));
            }
        }
        addData(source, node);
    }

    // ------------------------------------------------------------ interface

    pugi::xml_node dataNamed(pugi::xml_node holder, const std::string& name, pugi::xml_node source) {
        pugi::xml_node list = childOf(holder, "addData");
        if (!list) list = m_nodes.add(holder, "addData", source);
        const pugi::xml_node data = m_nodes.add(list, "data", source);
        StandardNodes::set(data, "name", kPlcopenData + name);
        return data;
    }

    void addInterface(pugi::xml_node source, pugi::xml_node node) {
        const pugi::xml_node interface = m_nodes.add(node, "interface", source);
        m_nodes.addDocumentation(interface, source);
        if (const pugi::xml_node result = childOf(source, "ResultType"))
            addTypeText(m_nodes.add(interface, "returnType", result), result, typeReference(result));
        for (const pugi::xml_node list : childOf(source, "Parameters").children()) addSection(interface, list);
        for (const pugi::xml_node list : source.children()) addSection(interface, list);
        addInheritance(source, interface);
        addModifiers(source, interface);
    }
    void addInheritance(pugi::xml_node source, pugi::xml_node interface) {
        pugi::xml_node inheritance;
        for (const pugi::xml_node each : source.children()) {
            if (!is(each, "Extends") && !is(each, "Implements")) continue;
            if (!inheritance)
                inheritance = m_nodes.add(dataNamed(interface, "pouinheritance", each), "Inheritance", each);
            m_nodes.addText(inheritance, is(each, "Extends") ? "Extends" : "Implements", each, typeReference(each));
        }
    }
    void addModifiers(pugi::xml_node source, pugi::xml_node interface) {
        pugi::xml_node modifiers;
        const auto add = [&](const char* word) {
            if (!modifiers)
                modifiers = m_nodes.add(dataNamed(interface, "accessmodifiers", source), "AccessModifiers", source);
            StandardNodes::set(modifiers, word, "true");
        };
        struct Row {
            const char *from, *to;
        };
        for (const Row& row : {Row{"abstract", "Abstract"}, Row{"final", "Final"}, Row{"override", "Override"}})
            if (isTrue(source, row.from)) add(row.to);
        for (const Row& row : {Row{"private", "Private"}, Row{"protected", "Protected"}, Row{"internal", "Internal"}})
            if (attribute(source, "accessSpecifier") == row.from) add(row.to);
    }
    /// The declaration as text is the whole of it, with its comments.
    void addTextDeclaration(pugi::xml_node source, pugi::xml_node node) {
        for (const pugi::xml_node data : childOf(source, "AddData").children())
            for (const pugi::xml_node each : data.children()) {
                if (!is(each, "textDeclaration") && !is(each, "TextDeclaration")) continue;
                m_nodes.addText(dataNamed(node, "interfaceasplaintext", each), "InterfaceAsPlainText", each,
                                textOf(each));
            }
    }
    void addMethods(pugi::xml_node source, pugi::xml_node node, bool isPrototype) {
        for (const pugi::xml_node each : source.children()) {
            if (!is(each, "Method")) continue;
            const pugi::xml_node method = m_nodes.add(dataNamed(node, "method", each), "Method", each);
            StandardNodes::take(method, "name", each);
            addInterface(each, method);
            if (!isPrototype) addBodies(m_nodes, childOf(each, "Body"), method);
        }
    }

    void addSection(pugi::xml_node owner, pugi::xml_node list) {
        struct Row {
            std::string_view from;
            const char* to;
        };
        static constexpr Row rows[] = {
            {"InputVars", "inputVars"},       {"OutputVars", "outputVars"}, {"InoutVars", "inOutVars"},
            {"InOutVars", "inOutVars"},       {"Vars", "localVars"},        {"TempVars", "tempVars"},
            {"ExternalVars", "externalVars"}, {"GlobalVars", "globalVars"}, {"AccessVars", "accessVars"},
            {"ConfigVars", "configVars"}};
        const auto* const row =
            std::find_if(std::begin(rows), std::end(rows), [&](const Row& each) { return is(list, each.from); });
        if (row == std::end(rows)) return;
        const pugi::xml_node section = m_nodes.add(owner, row->to, list);
        if (owner.attribute("listName")) StandardNodes::set(section, "name", attribute(owner, "listName"));
        StandardNodes::take(section, "constant", list);
        StandardNodes::take(section, "retain", list);
        if (isTrue(list, "non_retain")) StandardNodes::set(section, "nonretain", "true");
        if (attribute(list, "accessSpecifier") == "public") StandardNodes::set(section, "access", "PUBLIC");
        m_nodes.addDocumentation(section, list);
        for (const pugi::xml_node each : list.children()) {
            if (is(each, "Variable")) addVariable(section, each);
            if (is(each, "AccessVariable")) addPathVariable(section, each, "accessVariable");
            if (is(each, "ConfigVariable")) addPathVariable(section, each, "configVariable");
        }
        reportData(list);
    }
    void addVariable(pugi::xml_node section, pugi::xml_node source) {
        const pugi::xml_node node = m_nodes.add(section, "variable", source);
        StandardNodes::take(node, "name", source);
        addAddress(node, source);
        const std::string edge = attribute(source, "edgeDetection");
        addTypeText(m_nodes.add(node, "type", source), source,
                    typeReference(childOf(source, "Type")) + (edge == "rising"    ? " R_EDGE"
                                                              : edge == "falling" ? " F_EDGE"
                                                                                  : ""));
        if (const pugi::xml_node value = childOf(source, "InitialValue")) addValue(node, value);
        m_nodes.addDocumentation(node, source);
        reportData(source);
    }
    void addPathVariable(pugi::xml_node section, pugi::xml_node source, const char* name) {
        const pugi::xml_node node = m_nodes.add(section, name, source);
        for (const char* each : {"alias", "instancePathAndName", "direction"}) StandardNodes::take(node, each, source);
        addAddress(node, source);
        addTypeText(m_nodes.add(node, "type", source), source, typeReference(childOf(source, "Type")));
        if (const pugi::xml_node value = childOf(source, "InitialValue")) addValue(node, value);
    }
    /// In parts or as one text; devices of a vendor (X0, %d0.0) are no addresses of the standard.
    void addAddress(pugi::xml_node node, pugi::xml_node source) {
        const pugi::xml_node address = childOf(source, "Address");
        if (!address) return;
        std::string text = trimmed(attribute(address, "address"));
        if (const std::string location = attribute(address, "location"); !location.empty())
            text = "%" + location + attribute(address, "size") + (isTrue(address, "notYetFixed") ? "*" : text);
        const bool isMember = is(source, "Member") && text.size() > 1;
        if (text.size() > 2 && text[0] == '%' &&
            (isMember || std::string_view("IQMiqm").find(text[1]) != std::string_view::npos))
            StandardNodes::set(node, "address", text);
        else if (!text.empty())
            m_nodes.leaveOut(address, "Address " + text);
    }
    /// Values are built as in PLCopen XML, with capitals.
    void addValue(pugi::xml_node holder, pugi::xml_node source) {
        if (!childOf(source, "SimpleValue") && !childOf(source, "ArrayValue") && !childOf(source, "StructValue")) {
            const pugi::xml_node value =
                m_nodes.add(m_nodes.add(holder, "initialValue", source), "simpleValue", source);
            StandardNodes::set(value, "value", trimmed(textOf(source)));
            return;
        }
        copyValue(m_nodes.add(holder, "initialValue", source), source);
    }
    void copyValue(pugi::xml_node to, pugi::xml_node source) {
        for (const pugi::xml_node each : source.children()) {
            if (each.type() != pugi::node_element) continue;
            std::string name(localName(each));
            name[0] = static_cast<char>(name[0] | 0x20);
            const pugi::xml_node node = m_nodes.add(to, name.c_str(), each);
            for (const char* attributeName : {"value", "repetitionValue", "member"})
                StandardNodes::take(node, attributeName, each);
            copyValue(node, each);
        }
    }

    // ------------------------------------------------------------ configurations

    void addInstances(pugi::xml_node instances, pugi::xml_node configurations) {
        for (const pugi::xml_node each : instances.children()) {
            if (!is(each, "Configuration")) continue;
            const pugi::xml_node node = m_nodes.add(configurations, "configuration", each);
            StandardNodes::take(node, "name", each);
            // a configuration that runs nothing only holds its variables
            const bool isList = !descendantOf(each, "Resource/ProgramInstance");
            if (isList) StandardNodes::set(node, "listName", "Globals");
            for (const pugi::xml_node child : each.children()) {
                addSection(node, child);
                if (is(child, "Resource") && isList)
                    for (const pugi::xml_node list : child.children()) addSection(node, list);
                if (is(child, "Resource")) addResource(node, child, isList);
            }
            addData(each, node);
        }
    }
    void addResource(pugi::xml_node configuration, pugi::xml_node source, bool isList) {
        const pugi::xml_node node = m_nodes.add(configuration, "resource", source);
        StandardNodes::take(node, "name", source);
        if (!isList)
            for (const pugi::xml_node each : source.children()) addSection(node, each);
        for (const pugi::xml_node each : source.children()) {
            if (is(each, "Task")) {
                const pugi::xml_node task = m_nodes.add(node, "task", each);
                for (const char* name : {"name", "single", "interval", "priority"})
                    StandardNodes::take(task, name, each);
                m_nodes.addDocumentation(task, each);
            }
            if (!is(each, "ProgramInstance")) continue;
            pugi::xml_node owner = node;
            for (const pugi::xml_node task : node.children())
                if (is(task, "task") && attribute(task, "name") == attribute(each, "associatedTaskName")) owner = task;
            addInstance(owner, each);
        }
    }
    void addInstance(pugi::xml_node owner, pugi::xml_node source) {
        const pugi::xml_node node = m_nodes.add(owner, "pouInstance", source);
        StandardNodes::take(node, "name", source);
        StandardNodes::set(node, "typeName", qualifiedName(attribute(source, "typeName")));
        std::string connections;
        const auto add = [&](const std::string& text) { connections += (connections.empty() ? "" : ", ") + text; };
        for (const pugi::xml_node each : source.children()) {
            if (is(each, "FbInstTaskAssociation"))
                add(attribute(each, "fbInstanceName") + " WITH " + attribute(each, "associatedTaskName"));
            else if (localName(each).ends_with("Assignment"))
                add(attribute(each, "formalParameter") + (is(each, "OutputAssignment") ? " => " : " := ") +
                    attribute(each, "actualValue"));
        }
        if (!connections.empty()) StandardNodes::set(node, "connections", connections);
    }

    // ------------------------------------------------------------ vendors' data

    /// Of units it is kept as in PLCopen XML.
    void addData(pugi::xml_node source, pugi::xml_node node) {
        for (const pugi::xml_node data : childOf(source, "AddData").children()) {
            pugi::xml_node inner = data.first_child();
            if (!is(data, "Data") || is(inner, "textDeclaration") || is(inner, "TextDeclaration")) continue;
            pugi::xml_node list = childOf(node, "addData");
            if (!list) list = m_nodes.add(node, "addData", data);
            pugi::xml_node copy = m_nodes.add(list, "data", data);
            StandardNodes::take(copy, "name", data);
            for (; inner; inner = inner.next_sibling()) copy.append_copy(inner);
        }
    }
    /// Elsewhere it is not kept.
    void reportData(pugi::xml_node source) {
        for (const pugi::xml_node data : childOf(source, "AddData").children())
            for (const pugi::xml_node each : data.children())
                if (each.type() == pugi::node_element) m_nodes.leaveOut(each, std::string(localName(each)));
    }

    const XmlFile& m_file;
    XmlFile& m_to;
    StandardNodes m_nodes;
};

} // namespace

bool isStandardXml(const XmlFile& file) {
    const pugi::xml_node root = file.root();
    if (!is(root, "Project") && !isUnit(root)) return false;
    return std::any_of(root.attributes().begin(), root.attributes().end(), [](const pugi::xml_attribute& each) {
        return std::string_view(each.name()).starts_with("xmlns") &&
               std::string_view(each.value()) == kStandardNamespace;
    });
}

XmlFile asPlcopen(const XmlFile& file, Report& report) {
    XmlFile out = XmlFile::madeFrom(file);
    StandardReader(file, out, report).read();
    return out;
}

} // namespace plc::exchange
