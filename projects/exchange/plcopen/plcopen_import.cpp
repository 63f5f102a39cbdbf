#include "projects/exchange/plcopen/plcopen_import.h"

#include "projects/exchange/base/c_code.h"
#include "projects/exchange/base/libraries.h"
#include "projects/exchange/graphs/chart_import.h"
#include "projects/exchange/plcopen/plcopen_configuration.h"
#include "projects/exchange/plcopen/plcopen_export.h"
#include "projects/exchange/plcopen/plcopen_interface.h"
#include "projects/exchange/plcopen/plcopen_types.h"
#include "projects/exchange/plcopen/standard_xml.h"
#include "runtime/base/text.h"
#include "runtime/types/string_code.h"

#include <algorithm>

namespace plc::exchange {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kUnderstoodData[] = {"/method",
                                                "/property",
                                                "/pouinheritance",
                                                "/datatypeinheritance",
                                                "/accessmodifiers",
                                                "/attributes",
                                                "/objectid",
                                                "/pou",
                                                "/datatype",
                                                "/globalvars",
                                                "/interface",
                                                "/libraries",
                                                "/projectstructure",
                                                "/inputassignments",
                                                "/interfaceasplaintext",
                                                "/tasksettings",
                                                "/mixedattrsvarlist",
                                                "/enumvaluedocumentation",
                                                "/application",
                                                "/resource",
                                                "configurations",
                                                "/sfc/element",
                                                "/stcode",
                                                "/fbdelementtype",
                                                "/fbdcalltype",
                                                "/inputparamtypes",
                                                "/outputparamtypes",
                                                "/action",
                                                "/transition",
                                                "/interfaces",
                                                "/actions"};

bool isUnderstood(std::string_view name) {
    return std::any_of(std::begin(kUnderstoodData), std::end(kUnderstoodData),
                       [&](std::string_view ending) { return name.ends_with(ending); });
}

class Importer {
public:
    Importer(const XmlFile& file, Imported& out) : m_file(file), m_out(out) {}

    void run() {
        const pugi::xml_node project = m_file.root();
        readHeader(project);
        readFolders(project);
        gatherResultTypes(project);
        walk(childOf(project, "types"));
        walk(childOf(project, "instances"));
        readData(project, "");
    }

private:
    std::string place(pugi::xml_node node) const { return m_file.place() + ":" + std::to_string(m_file.lineOf(node)); }

    void readHeader(pugi::xml_node project) {
        const pugi::xml_node header = childOf(project, "fileHeader"), content = childOf(project, "contentHeader");
        if (m_out.name.empty()) m_out.name = attribute(content, "name");
        m_product = attribute(header, "productName");
        Json& source = m_out.side["source"];
        const bool isStandard = attribute(project, "xmlns") == kStandardNamespace;
        source["format"] = isStandard               ? "IEC 61131-10"
                           : isEdition0201(project) ? "PLCopen XML 0201"
                                                    : "PLCopen XML 0200";
        // Beremiz and OpenPLC write the name that the project has where others have that of the tool; few write 0201
        if (isEdition0201(project) && !isTool(m_product)) m_product = "Beremiz or OpenPLC,";
        if (!m_product.empty()) source["product"] = m_product + " " + attribute(header, "productVersion");
        if (const std::string company = attribute(header, "companyName"); !company.empty()) source["company"] = company;
    }
    static bool isTool(const std::string& product) {
        const std::string folded = foldCase(product);
        constexpr std::string_view kTools[] = {"stepwise", "codesys", "twincat", "cockpit", "beremiz", "openplc"};
        return std::any_of(std::begin(kTools), std::end(kTools),
                           [&](std::string_view tool) { return folded.find(tool) != std::string::npos; });
    }
    static bool isEdition0201(pugi::xml_node project) {
        return std::string_view(project.attribute("xmlns").value()).ends_with("tc6_0201");
    }

    void readFolders(pugi::xml_node project) {
        gatherFolders(childOf(dataOf(project, "/projectstructure"), "ProjectStructure"), "");
    }
    void gatherFolders(pugi::xml_node node, const std::string& folder) {
        for (const pugi::xml_node child : node.children()) {
            if (is(child, "Folder"))
                gatherFolders(child, (folder.empty() ? "" : folder + "/") + fileNameOf(attribute(child, "Name")));
            if (!is(child, "Object")) continue;
            m_folders[attribute(child, "ObjectId")] = folder;
            m_foldersByName.emplace(foldCase(attribute(child, "Name")), folder);
            for (const pugi::xml_node inner : child.children()) // an application holds folders and objects
                if (is(inner, "Folder")) {
                    gatherFolders(child, folder);
                    break;
                }
        }
    }
    std::string folderOf(pugi::xml_node element, const std::string& name) const {
        std::string id = attribute(element, "ObjectId");
        if (id.empty()) id = trimmed(exchange::textOf(childOf(dataOf(element, "/objectid"), "ObjectId")));
        if (const auto it = m_folders.find(id); !id.empty() && it != m_folders.end()) return it->second;
        const auto it = m_foldersByName.find(foldCase(name));
        return it == m_foldersByName.end() ? std::string() : it->second;
    }

    /// Functions of the project with their types, for the temporaries of diagrams.
    void gatherResultTypes(pugi::xml_node node) {
        for (const pugi::xml_node child : node.children()) {
            if (child.type() != pugi::node_element) continue;
            if (is(child, "pou")) {
                if (attribute(child, "pouType") == "function")
                    m_resultTypes[foldCase(attribute(child, "name"))] =
                        typeText(descendantOf(child, "interface/returnType"));
                continue;
            }
            if (is(child, "types") || is(child, "pous") || is(child, "instances") || is(child, "configurations") ||
                is(child, "configuration") || is(child, "resource") || is(child, "addData") || is(child, "data"))
                gatherResultTypes(child);
        }
    }

    /// Everything of a kind that we know, wherever the file puts it.
    void walk(pugi::xml_node node) {
        for (const pugi::xml_node child : node.children()) {
            if (child.type() != pugi::node_element) continue;
            const std::string_view name = localName(child);
            if (name == "pou")
                readPou(child);
            else if (name == "dataType")
                readDataType(child);
            else if (name == "Interface")
                readInterface(child);
            else if (name == "globalVars")
                readGlobals(child);
            else if (name == "configuration")
                readConfiguration(child);
            else if (name == "dataTypes" || name == "pous" || name == "configurations" || name == "resource")
                walk(child);
            else if (name == "addData")
                readData(node, "");
        }
    }

    void readData(pugi::xml_node owner, const std::string& unit) {
        for (const pugi::xml_node data : childOf(owner, "addData").children()) {
            if (!is(data, "data")) continue;
            const std::string name = attribute(data, "name");
            if (name.ends_with("/libraries")) {
                readLibraries(data);
            } else if (name == "Device" || name.ends_with("/device") || name.ends_with("/deviceconfiguration")) {
                m_out.report.add(place(data), remarks::DevicesNotRead());
            } else if (name == kStringEncodingData) {
                if (const auto code =
                        types::stringCodeNamed(trimmed(exchange::textOf(childOf(data, "StringEncoding")))))
                    m_out.strings = *code;
            } else if (!isUnderstood(name)) {
                keepData(unit, name, data);
            } else if (unit.empty()) {
                walk(data);
            }
        }
    }
    void keepData(const std::string& unit, const std::string& name, pugi::xml_node data) {
        m_out.side[unit.empty() ? "project" : "units"][unit.empty() ? "data" : unit][unit.empty() ? name : "data"] =
            nullptr;
        Json& data_ = unit.empty() ? m_out.side["project"]["data"] : m_out.side["units"][unit]["data"];
        data_[name] = toXml(data);
        m_out.report.add(place(data) + (unit.empty() ? "" : " (" + unit + ")"), remarks::VendorDataKept(name));
    }

    void readLibraries(pugi::xml_node data) {
        for (const pugi::xml_node each : childOf(data, "Libraries").children()) {
            if (!is(each, "Library")) continue;
            std::string name = attribute(each, "Namespace");
            if (name.empty()) name = attribute(each, "Name");
            useLibrary(m_out, name, isTrue(each, "SystemLibrary"), place(each));
            m_out.side["project"]["libraries"].push_back(toXml(each));
        }
    }

    // ------------------------------------------------------------ units

    void count(std::string_view keyword) { ++m_out.report.units[std::string(keyword)]; }

    /// Of IEC 61131-10.
    static std::string inNamespace(pugi::xml_node unit, std::string text) {
        std::string before, after;
        if (const std::string space = attribute(unit, "namespace"); !space.empty()) {
            before = "NAMESPACE " + space + "\n";
            after = "END_NAMESPACE\n";
        }
        for (const pugi::xml_node each : unit.children())
            if (is(each, "using")) before += "USING " + textOf(each) + ";\n";
        return before + std::move(text) + after;
    }

    void readDataType(pugi::xml_node node) {
        const std::string name = attribute(node, "name");
        const std::string plain = plainInterface(node);
        count("TYPE");
        addFile(m_out, folderOf(node, name), name,
                inNamespace(node, plain.empty() ? typeDeclaration(node) : plain + "\n"));
        readData(node, name);
    }

    void readGlobals(pugi::xml_node node) {
        std::string name = attribute(node, "name");
        if (name.empty()) name = "Globals";
        count("VAR_GLOBAL");
        addFile(m_out, folderOf(node, name), name, "{gvl " + name + "}\n" + globalsText(node));
        readData(node, name);
    }

    static PieceKind kindOf(const std::string& pouType) {
        if (pouType == "function") return PieceKind::Function;
        return pouType == "program" ? PieceKind::Program : PieceKind::FunctionBlock;
    }

    void readPou(pugi::xml_node pou) {
        const std::string name = attribute(pou, "name");
        Piece piece;
        piece.kind = kindOf(attribute(pou, "pouType"));
        piece.name = name;
        piece.declaration = declarationOf(pou, piece.kind, name);
        count(keywordOf(piece.kind));
        readMembers(pou, piece, name);
        readBodies(pou, piece, name);
        addFile(m_out, folderOf(pou, name), name, inNamespace(pou, assemble(piece)));
        readData(pou, name);
    }

    void readInterface(pugi::xml_node node) {
        Piece piece;
        piece.kind = PieceKind::Interface;
        piece.name = attribute(node, "name");
        piece.declaration = declarationOf(node, piece.kind, piece.name);
        count("INTERFACE");
        for (const char* list : {"Methods", "Properties"})
            for (const pugi::xml_node member : childOf(node, list).children()) readMember(member, piece, piece.name);
        readMembers(node, piece, piece.name);
        addFile(m_out, folderOf(node, piece.name), piece.name, inNamespace(node, assemble(piece)));
    }

    void readMembers(pugi::xml_node pou, Piece& piece, const std::string& unit) {
        for (const pugi::xml_node data : childOf(pou, "addData").children())
            for (const pugi::xml_node member : data.children()) readMember(member, piece, unit);
        for (const pugi::xml_node action : childOf(pou, "actions").children())
            if (is(action, "action")) readAction(action, pou, piece, unit);
    }

    void readMember(pugi::xml_node member, Piece& owner, const std::string& unit) {
        const bool isProperty = is(member, "Property");
        if (!is(member, "Method") && !isProperty) return;
        Piece piece;
        piece.kind = isProperty ? PieceKind::Property : PieceKind::Method;
        piece.name = attribute(member, "name");
        const std::string path = unit + "." + piece.name;
        piece.declaration = declarationOf(member, piece.kind, piece.name);
        if (isProperty) {
            readAccessor(member, {"GetAccessor", "Get"}, PieceKind::PropertyGet, piece, path);
            readAccessor(member, {"SetAccessor", "Set"}, PieceKind::PropertySet, piece, path);
        } else {
            readBodies(member, piece, path);
        }
        readData(member, path);
        count(keywordOf(piece.kind));
        owner.members.push_back(std::move(piece));
    }

    void readAccessor(pugi::xml_node property, std::initializer_list<std::string_view> names, PieceKind kind,
                      Piece& owner, const std::string& path) {
        for (const std::string_view name : names) {
            const pugi::xml_node node = childOf(property, name);
            if (!node) continue;
            Piece piece;
            piece.kind = kind;
            piece.declaration = declarationOf(node, kind, "");
            readBodies(node, piece, path + "." + std::string(name.substr(0, 3)));
            owner.members.push_back(std::move(piece));
            return;
        }
    }

    void readAction(pugi::xml_node action, pugi::xml_node pou, Piece& owner, const std::string& unit) {
        Piece piece;
        piece.kind = PieceKind::Action;
        piece.name = attribute(action, "name");
        Piece holder; // the variables of a diagram belong to the unit
        holder.kind = PieceKind::Action;
        m_namesOf = pou;
        readBodies(action, holder, unit + "." + piece.name);
        m_namesOf = {};
        piece.body = holder.body;
        owner.declaration = joinedLines(owner.declaration, holder.declaration);
        owner.members.push_back(std::move(piece));
    }

    static std::string joinedLines(std::string a, const std::string& b) {
        if (b.empty()) return a;
        if (!a.empty() && !a.ends_with('\n')) a += '\n';
        return a + b;
    }

    // ------------------------------------------------------------ bodies

    DiagramNames namesOf(pugi::xml_node element) const {
        DiagramNames names;
        names.resultTypes = m_resultTypes;
        names.isFunction = attribute(element, "pouType") == "function" || is(element, "Method");
        for (const pugi::xml_node owner : {m_namesOf ? m_namesOf : element, element})
            for (const pugi::xml_node section : childOf(owner, "interface").children())
                for (const pugi::xml_node variable : section.children())
                    if (is(variable, "variable"))
                        names.variableTypes[foldCase(attribute(variable, "name"))] =
                            typeText(childOf(variable, "type"));
        return names;
    }

    void readBodies(pugi::xml_node element, Piece& piece, const std::string& path) {
        for (const pugi::xml_node child : element.children()) {
            if (!is(child, "body")) continue;
            const pugi::xml_node language = languageOf(child);
            if (!language) continue;
            const std::string name(localName(language));
            std::string text;
            if (name == "ST" || name == "IL") {
                text = trimmedLines(exchange::textOf(language));
                if (isEdition0201(m_file.root()) && commentOutC(text))
                    m_out.report.add(place(language), remarks::CodeSkipped());
            } else if (name == "SFC")
                text = readChart(language, element, piece, path);
            else
                text = readDiagram(language, element, piece, path);
            if (name != "ST" || !text.empty()) ++m_out.report.bodies[name];
            piece.body = joinedLines(std::move(piece.body), text);
        }
    }

    /// CFC is in addData, beside an ST without a text.
    static pugi::xml_node functionChartOf(pugi::xml_node body) {
        for (const pugi::xml_node data : childOf(body, "addData").children())
            for (const pugi::xml_node child : data.children())
                if (is(child, "CFC")) return child;
        return {};
    }
    /// ST, IL, SFC, LD, FBD, CFC.
    static pugi::xml_node languageOf(pugi::xml_node body) {
        const pugi::xml_node chart = functionChartOf(body);
        for (const pugi::xml_node child : body.children())
            for (const char* language : {"ST", "IL", "SFC", "LD", "FBD"})
                if (is(child, language) && (!chart || !trimmed(textOf(child)).empty())) return child;
        return chart;
    }

    static void declare(Piece& piece, const std::vector<std::pair<std::string, std::string>>& variables) {
        if (variables.empty()) return;
        std::string section = "VAR\n";
        for (const auto& [name, type] : variables) section += "    " + name + " : " + type + ";\n";
        piece.declaration = joinedLines(piece.declaration, section + "END_VAR\n");
    }

    std::string readDiagram(pugi::xml_node language, pugi::xml_node element, Piece& piece, const std::string& path) {
        Diagram diagram(language, m_file, path, namesOf(element), m_out.report);
        const DiagramText text = diagram.statements();
        declare(piece, text.variables);
        const bool isLadder = is(language, "LD");
        const std::string view = std::string("{attribute 'view' := '") + (isLadder ? "ladder" : "fbd") + "'}\n";
        if (piece.kind != PieceKind::Action && piece.declaration.find("{attribute 'view'") == std::string::npos)
            piece.declaration = view + piece.declaration;
        std::string body = trimmedLines(text.statements);
        Json& kept = m_out.side["units"][path]["body"];
        kept["language"] = localName(language);
        kept["text"] = hashOf(body);
        kept["xml"] = toXml(language);
        m_out.report.add(place(language), remarks::BodyConverted(path));
        return body;
    }

    std::map<std::string, std::string> transitionsOf(pugi::xml_node pou, const std::string& unit) {
        std::map<std::string, std::string> out;
        for (const pugi::xml_node each : childOf(pou, "transitions").children()) {
            if (!is(each, "transition")) continue;
            const std::string name = attribute(each, "name");
            Piece holder;
            m_namesOf = pou;
            readBodies(each, holder, unit + "." + name);
            m_namesOf = {};
            std::string condition = conditionOf(holder.body);
            if (condition.empty() || condition.find(";") != std::string::npos)
                m_out.report.add(place(each), remarks::TransitionNoExpression(unit + "." + name));
            else
                out[foldCase(name)] = std::move(condition);
        }
        return out;
    }

    std::string readChart(pugi::xml_node sfc, pugi::xml_node pou, Piece& piece, const std::string& unit) {
        const ChartText chart = chartText(sfc, m_file, unit, transitionsOf(pou, unit), namesOf(pou), m_out.report);
        declare(piece, chart.variables);
        for (const auto& [name, body] : chart.actions) {
            Piece action;
            action.kind = PieceKind::Action;
            action.name = name;
            action.body = body;
            piece.members.push_back(std::move(action));
        }
        if (!chart.positions.empty()) m_out.side["units"][unit]["positions"] = chart.positions;
        return chart.text;
    }

    // ------------------------------------------------------------ configuration

    void readConfiguration(pugi::xml_node configuration) {
        ConfigurationText text = configurationText(configuration, m_file, m_out.report);
        if (std::string plain = plainInterface(configuration); !plain.empty()) {
            text.text = plain + "\n";
            text.isEmpty = false;
        }
        if (!text.isEmpty) {
            count("CONFIGURATION");
            addFile(m_out, "", "configuration", std::move(text.text));
        }
        for (const pugi::xml_node globals : text.lists) readGlobals(globals);
        for (const pugi::xml_node resource : configuration.children())
            if (is(resource, "resource")) readData(resource, "");
        readData(configuration, "");
    }

    const XmlFile& m_file;
    Imported& m_out;
    std::string m_product;
    pugi::xml_node m_namesOf; // the unit whose variables an action's body uses
    std::map<std::string, std::string> m_folders, m_foldersByName, m_resultTypes;
};

} // namespace

bool isPlcopen(const XmlFile& file) {
    if (!is(file.root(), "project")) return false;
    for (const pugi::xml_attribute each : file.root().attributes())
        if (std::string_view(each.value()).find("plcopen.org/xml/tc6") != std::string_view::npos) return true;
    return childOf(file.root(), "types") && childOf(file.root(), "instances");
}

void importPlcopen(const XmlFile& file, Imported& imported) { Importer(file, imported).run(); }

} // namespace plc::exchange
