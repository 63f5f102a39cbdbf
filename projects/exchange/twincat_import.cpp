#include "projects/exchange/twincat_import.h"

#include "projects/exchange/assemble.h"
#include "projects/exchange/libraries.h"
#include "projects/exchange/network_list.h"
#include "projects/exchange/plcopen_configuration.h"
#include "projects/exchange/stored_cfc.h"
#include "projects/exchange/stored_chart.h"
#include "projects/exchange/stored_diagram.h"
#include "runtime/base/text.h"

#include <algorithm>

namespace plc::exchange {

namespace {

class ObjectReader {
public:
    ObjectReader(const XmlFile& file, std::string folder, Imported& out, TwinCatProject& project)
        : m_file(file), m_folder(std::move(folder)), m_out(out), m_project(project) {}

    void read() {
        for (const pugi::xml_node node : m_file.root().children()) {
            if (node.type() != pugi::node_element) continue;
            const std::string_view kind = localName(node);
            if (kind == "POU" || kind == "Itf")
                readUnit(node);
            else if (kind == "DUT")
                readText(node, "TYPE");
            else if (kind == "GVL")
                readText(node, "VAR_GLOBAL");
            else if (kind == "Task")
                readTask(node);
            else
                m_out.report.add(place(node), remarks::ElementNotRead(std::string(kind)));
        }
    }

private:
    std::string place(pugi::xml_node node) const { return m_file.place() + ":" + std::to_string(m_file.lineOf(node)); }
    static std::string declarationOf(pugi::xml_node node) {
        return trimmedLines(exchange::textOf(childOf(node, "Declaration")));
    }

    void readText(pugi::xml_node node, const char* kind) {
        const std::string name = attribute(node, "Name");
        ++m_out.report.units[kind];
        const std::string head = std::string_view(kind) == "VAR_GLOBAL" ? "{gvl " + name + "}\n" : "";
        addFile(m_out, m_folder, name, head + declarationOf(node) + "\n");
    }

    std::string bodyOf(pugi::xml_node node, const std::string& unit, Piece& owner) {
        for (const pugi::xml_node language : childOf(node, "Implementation").children()) {
            if (language.type() != pugi::node_element) continue;
            const std::string name(localName(language));
            std::string text;
            if (name == "ST" || name == "IL") {
                text = trimmedLines(exchange::textOf(language));
                if (text.empty()) continue;
            } else if (readDrawn(language, unit, owner, text)) {
                return text;
            } else {
                m_out.report.add(place(language), remarks::ArchiveBody(unit));
                m_out.side["units"][unit]["archive"] = toXml(language);
            }
            ++m_out.report.bodies[name == "NWL" ? "LD/FBD" : name];
            return text;
        }
        return {};
    }

    static ArchiveBody readArchive(pugi::xml_node archive) {
        if (is(archive, "NWL")) return readNetworkList(archive);
        if (is(archive, "CFC")) return readStoredCfc(archive);
        return is(archive, "SFC") ? readStoredChart(archive) : ArchiveBody();
    }
    /// False: the archive holds nothing that is known.
    bool readDrawn(pugi::xml_node archive, const std::string& unit, Piece& owner, std::string& body) {
        const ArchiveBody drawn = readArchive(archive);
        if (!drawn.body()) return false;
        for (const ArchiveRemark& each : drawn.remarks)
            m_out.report.add(place(each.node) + " (" + unit + ")", each.remark);
        body = is(archive, "SFC") ? chartBody(drawn.body(), m_file, unit, m_transitions, owner, m_out)
                                  : diagramText(drawn.body(), m_file, unit, owner, m_out);
        m_out.side["units"][unit]["archive"] = toXml(archive);
        m_out.report.add(place(archive), remarks::BodyConverted(unit));
        ++m_out.report.bodies[std::string(localName(drawn.body()))];
        return true;
    }

    /// The conditions that have a name: a chart writes them where it uses them.
    void readTransitions(pugi::xml_node unit, const std::string& path) {
        m_transitions.clear();
        for (const pugi::xml_node each : unit.children()) {
            if (!is(each, "Transition")) continue;
            const std::string name = attribute(each, "Name");
            const std::string text = conditionOf(exchange::textOf(childOf(childOf(each, "Implementation"), "ST")));
            if (text.empty() || text.find(';') != std::string::npos)
                m_out.report.add(place(each), remarks::TransitionNoExpression(path + "." + name));
            else
                m_transitions[foldCase(name)] = text;
        }
    }

    void readUnit(pugi::xml_node node) {
        Piece piece;
        piece.name = attribute(node, "Name");
        piece.declaration = declarationOf(node);
        piece.kind = kindOfDeclaration(piece.declaration);
        readTransitions(node, piece.name);
        piece.body = bodyOf(node, piece.name, piece);
        ++m_out.report.units[std::string(keywordOf(piece.kind))];
        for (const pugi::xml_node member : node.children()) readMember(member, piece);
        addFile(m_out, m_folder, piece.name, assemble(piece));
    }

    void readMember(pugi::xml_node node, Piece& owner) {
        const std::string_view kind = localName(node);
        Piece piece;
        piece.name = attribute(node, "Name");
        piece.declaration = declarationOf(node);
        const std::string path = owner.name + "." + piece.name;
        if (kind == "Method") {
            piece.kind = PieceKind::Method;
            piece.body = bodyOf(node, path, piece);
        } else if (kind == "Action") {
            piece.kind = PieceKind::Action;
            piece.declaration.clear();
            piece.body = bodyOf(node, path, owner); // its variables are those of the unit
        } else if (kind == "Property") {
            piece.kind = PieceKind::Property;
            readAccessor(childOf(node, "Get"), PieceKind::PropertyGet, piece, path);
            readAccessor(childOf(node, "Set"), PieceKind::PropertySet, piece, path);
        } else {
            return;
        }
        ++m_out.report.units[std::string(keywordOf(piece.kind))];
        owner.members.push_back(std::move(piece));
    }

    void readAccessor(pugi::xml_node node, PieceKind kind, Piece& owner, const std::string& path) {
        if (!node) return;
        Piece piece;
        piece.kind = kind;
        piece.declaration = declarationOf(node);
        piece.body = bodyOf(node, path, piece);
        owner.members.push_back(std::move(piece));
    }

    void readTask(pugi::xml_node node) {
        TwinCatTask task;
        task.name = attribute(node, "Name");
        task.interval = durationText(trimmed(exchange::textOf(childOf(node, "CycleTime"))), "us");
        task.priority = trimmed(exchange::textOf(childOf(node, "Priority")));
        for (const pugi::xml_node call : node.children())
            if (is(call, "PouCall"))
                if (std::string name = trimmed(exchange::textOf(childOf(call, "Name"))); !name.empty())
                    task.programs.push_back(std::move(name));
        m_project.tasks.push_back(std::move(task));
    }

    const XmlFile& m_file;
    std::string m_folder;
    Imported& m_out;
    TwinCatProject& m_project;
    std::map<std::string, std::string> m_transitions; // of the unit, folded name → condition
};

// ---------------------------------------------------------------- CODESYS V3 native

pugi::xml_node named(pugi::xml_node node, std::string_view name) {
    for (const pugi::xml_node child : node.children())
        if (child.attribute("Name").value() == name) return child;
    return {};
}

std::string documentText(pugi::xml_node holder) {
    const pugi::xml_node document = named(holder, "TextDocument");
    if (const pugi::xml_node blob = named(document, "TextBlobForSerialisation")) return withUnixLines(textOf(blob));
    std::string out;
    for (const pugi::xml_node line : named(document, "TextLines").children())
        if (const pugi::xml_node text = named(line, "Text")) out += textOf(text) + "\n";
    return out;
}

struct Entry {
    std::string name, guid, parent;
    pugi::xml_node object;
};

void gatherEntries(pugi::xml_node node, std::vector<Entry>& out, int depth = 0) {
    if (depth > 8) return;
    for (const pugi::xml_node child : node.children()) {
        if (child.type() != pugi::node_element) continue;
        const pugi::xml_node meta = named(child, "MetaObject"), object = named(child, "Object");
        if (meta && object)
            out.push_back(
                {textOf(named(meta, "Name")), textOf(named(meta, "Guid")), textOf(named(meta, "ParentGuid")), object});
        else
            gatherEntries(child, out, depth + 1);
    }
}

class ExportReader {
public:
    ExportReader(const XmlFile& file, Imported& out) : m_file(file), m_out(out) {
        gatherEntries(file.root(), m_entries);
    }

    void read() {
        for (const Entry& entry : m_entries) {
            const std::string declaration = documentText(named(entry.object, "Interface"));
            const PieceKind kind = kindOfDeclaration(declaration);
            switch (kind) {
            case PieceKind::Type:
            case PieceKind::Globals:
                ++m_out.report.units[std::string(keywordOf(kind))];
                addFile(m_out, "", entry.name,
                        (kind == PieceKind::Globals ? "{gvl " + entry.name + "}\n" : "") + trimmedLines(declaration) +
                            "\n");
                break;
            case PieceKind::Program:
            case PieceKind::Function:
            case PieceKind::FunctionBlock:
            case PieceKind::Interface:
                addFile(m_out, "", entry.name, assemble(pieceOf(entry, declaration, kind)));
                break;
            case PieceKind::Method:
            case PieceKind::Property:
            case PieceKind::PropertyGet:
            case PieceKind::PropertySet:
            case PieceKind::Action:
            case PieceKind::Unknown:
                break; // part of its unit, or no source
            }
        }
    }

private:
    Piece pieceOf(const Entry& entry, const std::string& declaration, PieceKind kind) {
        Piece piece;
        piece.kind = kind;
        piece.name = entry.name;
        piece.declaration = declaration;
        const pugi::xml_node implementation = named(entry.object, "Implementation");
        piece.body = documentText(implementation);
        ++m_out.report.units[std::string(keywordOf(kind))];
        if (!trimmed(piece.body).empty())
            ++m_out.report.bodies["ST"];
        else if (implementation && !named(implementation, "TextDocument") && implementation.first_child())
            m_out.report.add(m_file.place() + ":" + std::to_string(m_file.lineOf(implementation)),
                             remarks::ArchiveBody(entry.name));
        for (const Entry& each : m_entries) {
            if (each.parent != entry.guid || each.guid == entry.guid) continue;
            const std::string text = documentText(named(each.object, "Interface"));
            PieceKind member = kindOfDeclaration(text);
            if (kind == PieceKind::Property)
                member = equalsIgnoringCase(each.name, "Set") ? PieceKind::PropertySet : PieceKind::PropertyGet;
            else if (member == PieceKind::Unknown)
                member = named(each.object, "Implementation") ? PieceKind::Action : PieceKind::Unknown;
            if (member != PieceKind::Unknown) piece.members.push_back(pieceOf(each, text, member));
        }
        return piece;
    }

    const XmlFile& m_file;
    Imported& m_out;
    std::vector<Entry> m_entries;
};

} // namespace

bool isTwinCat(const XmlFile& file) { return is(file.root(), "TcPlcObject"); }

void importTwinCat(const XmlFile& file, const std::string& folder, Imported& imported, TwinCatProject& project) {
    imported.side["source"]["format"] = "TwinCAT";
    ObjectReader(file, folder, imported, project).read();
}

void addConfiguration(const TwinCatProject& project, Imported& imported) {
    if (project.tasks.empty()) return;
    std::string tasks, instances;
    std::set<std::string> names; // a program may run in one task only
    for (const TwinCatTask& task : project.tasks) {
        if (!names.insert("task " + foldCase(task.name)).second) continue;
        tasks += "        TASK " + task.name + "(";
        if (!task.interval.empty()) tasks += "INTERVAL := " + task.interval + ", ";
        tasks += "PRIORITY := " + (task.priority.empty() ? "0" : task.priority) + ");\n";
        for (const std::string& program : task.programs)
            if (names.insert(foldCase(program)).second)
                instances += "        PROGRAM " + program + " WITH " + task.name + " : " + program + ";\n";
    }
    ++imported.report.units["CONFIGURATION"];
    addFile(imported, "", "configuration",
            "CONFIGURATION Plc\n    RESOURCE Resource1 ON PLC\n" + tasks + instances +
                "    END_RESOURCE\nEND_CONFIGURATION\n");
}

bool isTwinCatProject(const XmlFile& file) {
    return is(file.root(), "Project") &&
           std::string_view(file.root().attribute("xmlns").value()).find("msbuild") != std::string_view::npos;
}

void readTwinCatProject(const XmlFile& file, Imported& imported) {
    for (const pugi::xml_node group : file.root().children()) {
        if (const std::string name = trimmed(textOf(childOf(group, "Name")));
            is(group, "PropertyGroup") && !name.empty() && imported.name.empty())
            imported.name = name;
        std::string space = trimmed(textOf(childOf(group, "DefaultNamespace")));
        if (space.empty()) space = trimmed(textOf(childOf(group, "Name")));
        if (is(group, "PropertyGroup") && !space.empty()) imported.namespaces.insert(space);
        if (is(group, "PropertyGroup")) imported.projectNames.insert(foldCase(trimmed(textOf(childOf(group, "Name")))));
        for (const pugi::xml_node item : group.children())
            if (is(item, "PlaceholderReference") || is(item, "LibraryReference")) {
                useLibrary(imported, attribute(item, "Include"), false,
                           file.place() + ":" + std::to_string(file.lineOf(item)));
                imported.side["project"]["libraries"].push_back(toXml(item));
                const std::string library = attribute(item, "Include");
                if (std::string alias = trimmed(textOf(childOf(item, "Namespace"))); !alias.empty())
                    imported.aliases.emplace(std::move(alias), trimmed(library.substr(0, library.find(','))));
            }
    }
}

bool isCodesysExport(const XmlFile& file) { return is(file.root(), "ExportFile"); }

void importCodesysExport(const XmlFile& file, Imported& imported) {
    imported.side["source"]["format"] = "CODESYS V3 export";
    imported.side["source"]["product"] = "CODESYS";
    ExportReader(file, imported).read();
}

} // namespace plc::exchange
