#include "projects/exchange/twincat/twincat_import.h"

#include "projects/exchange/base/assemble.h"
#include "projects/exchange/base/durations.h"
#include "projects/exchange/base/libraries.h"
#include "projects/exchange/graphs/stored_diagram.h"
#include "projects/exchange/twincat/network_list.h"
#include "projects/exchange/twincat/stored_cfc.h"
#include "projects/exchange/twincat/stored_chart.h"
#include "projects/exchange/twincat/stored_ladder.h"
#include "runtime/base/text.h"

#include <algorithm>

namespace plc::exchange {

namespace {

class ObjectReader {
public:
    ObjectReader(const XmlFile& file, std::string folder, Imported& out, ForeignTasks& tasks)
        : m_file(file), m_folder(std::move(folder)), m_out(out), m_tasks(tasks) {}

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

    static ArchiveBody readArchive(pugi::xml_node archive, const std::string& unit) {
        if (is(archive, "NWL")) return readNetworkList(archive);
        if (is(archive, "CFC")) return readStoredCfc(archive, unit);
        if (is(archive, "LADDER")) return readStoredLadder(archive);
        return is(archive, "SFC") ? readStoredChart(archive) : ArchiveBody();
    }
    /// False: the archive holds nothing that is known.
    bool readDrawn(pugi::xml_node archive, const std::string& unit, Piece& owner, std::string& body) {
        const ArchiveBody drawn = readArchive(archive, unit);
        if (!drawn.body()) return false;
        for (const ArchiveRemark& each : drawn.remarks)
            m_out.report.add(place(each.node) + " (" + unit + ")", each.remark);
        declareIn(owner, drawn.variables);
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
        ForeignTask task;
        task.name = attribute(node, "Name");
        task.interval = durationText(trimmed(exchange::textOf(childOf(node, "CycleTime"))), "us");
        task.priority = trimmed(exchange::textOf(childOf(node, "Priority")));
        for (const pugi::xml_node call : node.children())
            if (is(call, "PouCall"))
                if (std::string name = trimmed(exchange::textOf(childOf(call, "Name"))); !name.empty())
                    task.programs.push_back(std::move(name));
        m_tasks.push_back(std::move(task));
    }

    const XmlFile& m_file;
    std::string m_folder;
    Imported& m_out;
    ForeignTasks& m_tasks;
    std::map<std::string, std::string> m_transitions; // of the unit, folded name → condition
};

} // namespace

bool isTwinCat(const XmlFile& file) { return is(file.root(), "TcPlcObject"); }

void importTwinCat(const XmlFile& file, const std::string& folder, Imported& imported, ForeignTasks& tasks) {
    imported.side["source"]["format"] = "TwinCAT";
    ObjectReader(file, folder, imported, tasks).read();
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

} // namespace plc::exchange
