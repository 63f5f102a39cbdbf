#include "projects/exchange/codesys/codesys3_export.h"

#include "projects/exchange/base/assemble.h"
#include "runtime/base/text.h"

namespace plc::exchange {

namespace {

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

bool isCodesysExport(const XmlFile& file) { return is(file.root(), "ExportFile"); }

void importCodesysExport(const XmlFile& file, Imported& imported) {
    imported.side["source"]["format"] = "CODESYS V3 export";
    imported.side["source"]["product"] = "CODESYS";
    ExportReader(file, imported).read();
}

} // namespace plc::exchange
