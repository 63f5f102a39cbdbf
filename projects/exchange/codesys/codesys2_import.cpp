#include "projects/exchange/codesys/codesys2_import.h"

#include "projects/exchange/base/assemble.h"
#include "projects/exchange/base/xml.h"
#include "projects/exchange/codesys/codesys2_cfc.h"
#include "projects/exchange/codesys/codesys2_sections.h"
#include "projects/exchange/graphs/stored_diagram.h"
#include "runtime/base/text.h"
#include "runtime/library/sources.h"

#include <algorithm>

namespace plc::exchange {

namespace {

/// One line's first word, upper case.
std::string firstWord(std::string_view line) {
    const size_t begin = line.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    size_t end = begin;
    while (end < line.size() && (std::isalnum(static_cast<unsigned char>(line[end])) || line[end] == '_')) ++end;
    std::string word(line.substr(begin, end - begin));
    for (char& c : word) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return word;
}

/// (* @KEY := 'value' *) of a line; empty key when it is none.
std::pair<std::string, std::string> mark(std::string_view line) {
    const std::string text = trimmed(line);
    if (!text.starts_with("(* @") || !text.ends_with("*)")) return {};
    std::string inner = trimmed(std::string_view(text).substr(4, text.size() - 6));
    const size_t assign = inner.find(":=");
    std::string key = trimmed(inner.substr(0, assign));
    std::string value = assign == std::string::npos ? "" : trimmed(inner.substr(assign + 2));
    if (value.size() >= 2 && value.front() == '\'' && value.back() == '\'') value = value.substr(1, value.size() - 2);
    return {key, value};
}

std::string folderOf(std::string path) {
    std::string out;
    for (size_t at = 0; at < path.size(); ++at) {
        if (path[at] == '\\') continue; // \/ stands between folders
        out += path[at];
    }
    while (!out.empty() && out.front() == '/') out.erase(0, 1);
    std::string folder;
    for (size_t at = 0; at < out.size();) {
        const size_t end = std::min(out.find('/', at), out.size());
        if (end > at) folder += (folder.empty() ? "" : "/") + fileNameOf(out.substr(at, end - at));
        at = end + 1;
    }
    return folder;
}

/// Some controllers call a REAL's address %IR3.0: an address has a size, not a type.
void sizeAddresses(std::string& text) {
    for (const char* written : {"%IR", "%QR", "%MR"})
        for (size_t at = text.find(written); at != std::string::npos; at = text.find(written, at + 3))
            if (at + 3 < text.size() && std::isdigit(static_cast<unsigned char>(text[at + 3]))) text[at + 2] = 'D';
}

bool endsUnit(const std::string& word) {
    return word == "END_FUNCTION_BLOCK" || word == "END_FUNCTION" || word == "END_PROGRAM" || word == "END_TYPE" ||
           word == "END_ACTION";
}

class Codesys2Reader {
public:
    Codesys2Reader(const std::string& text, std::string place, Imported& out, ForeignTasks& tasks)
        : m_text(text), m_place(std::move(place)), m_out(out), m_tasks(tasks) {}

    void read() {
        if (m_text.find("_FUNCTIONBLOCK") != std::string::npos || m_text.find("_CFC_BODY") != std::string::npos)
            gatherBlockPins(m_text, m_pins);
        for (size_t at = 0; at < m_text.size();) {
            const size_t end = std::min(m_text.find('\n', at), m_text.size());
            readLine(std::string_view(m_text).substr(at, end - at));
            ++m_line;
            at = end + 1;
        }
        finish();
    }

private:
    void readLine(std::string_view line) {
        const auto [key, value] = mark(line);
        const std::string word = firstWord(line);
        if (!m_sectionEnd.empty()) return readInSection(line, word);
        if (!key.empty()) return readMark(key, value);
        if (std::string end = endOfSection(word); !end.empty() && !isInUnit()) {
            m_section = word;
            m_sectionEnd = std::move(end);
            m_sectionLine = m_line;
            return;
        }
        if (m_current.empty() && trimmed(line).empty()) return;
        if (word.starts_with("_") && word.ends_with("_BODY")) m_isDrawn = true;
        if (m_isDrawn && !endsUnit(word)) {
            m_drawn += std::string(line) + "\n";
            return;
        }
        if (word == "FUNCTIONBLOCK") // as some versions write it
            m_current +=
                "FUNCTION_BLOCK" + std::string(line.substr(line.find_first_not_of(" \t") + word.size())) + "\n";
        else
            m_current += std::string(line) + "\n";
        const bool isInside = word == "END_ACTION" && kindOfDeclaration(m_current) != PieceKind::Action;
        if (endsUnit(word) && !isInside) finish(); // an action of a chart stands before the end of its unit
    }

    /// A unit's own words may be those of a section: a step RESOURCE, a block LIBRARY.
    [[nodiscard]] bool isInUnit() const {
        const PieceKind kind = kindOfDeclaration(m_current);
        return kind != PieceKind::Globals && kind != PieceKind::Unknown;
    }
    void readInSection(std::string_view line, const std::string& word) {
        if (word != m_sectionEnd) {
            m_sectionText += std::string(line) + "\n";
            return;
        }
        readCodesys2Section(m_section, m_sectionText, m_place + ":" + std::to_string(m_sectionLine), m_out, m_tasks);
        m_sectionEnd.clear();
        m_sectionText.clear();
    }

    void readMark(const std::string& key, const std::string& value) {
        if (key == "PATH") m_path = value;
        if (key == "GLOBAL_VARIABLE_LIST") m_list = value;
        if (key == "OBJECT_END") finish();
        if (key == "NESTEDCOMMENTS" && !m_current.empty() && kindOfDeclaration(m_current) == PieceKind::Globals)
            finish();
    }

    void finish() {
        std::string text = trimmedLines(m_current);
        m_current.clear();
        sizeAddresses(text);
        if (text.empty()) return;
        const PieceKind kind = kindOfDeclaration(text);
        std::string name = nameInDeclaration(text);
        if (kind == PieceKind::Unknown && text.find_first_not_of(" \t\n;") == std::string::npos) return;
        if (kind == PieceKind::Unknown && text.starts_with("(* @CONNECTIONS")) return; // to files of the tool
        if (foldCase(text).starts_with("var_config")) return finishMapping(text);
        if (kind == PieceKind::Globals) {
            name = m_list.empty() ? "Globals" : m_list;
            text = "{gvl " + name + "}\n" + text;
            m_list.clear();
        }
        const bool isOfUnit = kind == PieceKind::Action && !m_out.files.empty(); // of the one before it
        const std::string path = isOfUnit ? m_out.files.back().name + "." + name : name;
        if (m_isDrawn && readDrawn(kind, path, text)) {
            ++m_out.report.bodies[languageDrawn()];
        } else if (m_isDrawn) {
            m_out.report.add(m_place, m_unknownBlock.empty() ? remarks::DrawnBodyNotRead(path)
                                                             : remarks::DrawnBlockUnknown(path, m_unknownBlock));
            m_out.side["units"][path]["archive"] = m_drawn;
            ++m_out.report.bodies[languageDrawn()];
        } else if (kind != PieceKind::Globals && kind != PieceKind::Type) {
            ++m_out.report.bodies["ST/IL"];
        }
        m_isDrawn = false;
        m_drawn.clear();
        if (isOfUnit) {
            m_out.files.back().text += "\n" + text + "\n";
            return;
        }
        ++m_out.report.units[kind == PieceKind::Unknown ? "text" : std::string(keywordOf(kind))];
        addFile(m_out, folderOf(m_path), name.empty() ? "unit" : name, text + "\n");
    }

    /// VAR_CONFIG: addresses for instances; without any there is nothing to say.
    void finishMapping(const std::string& text) {
        m_list.clear();
        if (text.find(" AT ") != std::string::npos)
            m_out.report.add(m_place, remarks::ElementNotRead(std::string("VAR_CONFIG")));
    }

    /// The diagram of a unit as its text. False: it has something that is not known here.
    bool readDrawn(PieceKind kind, const std::string& name, std::string& text) {
        m_unknownBlock.clear();
        const bool isAction = kind == PieceKind::Action && !m_out.files.empty();
        if (!isAction && kind != PieceKind::Program && kind != PieceKind::Function && kind != PieceKind::FunctionBlock)
            return false;
        pugi::xml_document diagram;
        const auto pins = [this](const std::string& type) {
            auto known = pinsOf(type);
            if (!known) m_unknownBlock = type;
            return known;
        };
        if (m_drawn.starts_with("_CFC") ? !readCodesys2Cfc(m_drawn, pins, diagram)
                                        : !readCodesys2Diagram(m_drawn, pins, diagram))
            return false;
        const auto lines = XmlFile::parse("<export/>", m_place); // only the place of remarks
        if (!lines) return false;
        Piece piece;
        piece.kind = kind;
        piece.name = name.substr(name.rfind('.') + 1);
        if (isAction) {
            piece.body = actionText(diagram.document_element(), *lines, name);
        } else {
            piece.declaration = text.substr(0, text.rfind('\n') + 1); // without END_…
            piece.body = diagramText(diagram.document_element(), *lines, name, piece, m_out);
        }
        text = trimmedLines(assemble(piece));
        m_out.side["units"][name]["archive"] = m_drawn;
        m_out.report.add(m_place, remarks::BodyConverted(name));
        return true;
    }

    /// The statements of an action; the variables that they need are declared with those of its unit.
    std::string actionText(pugi::xml_node diagram, const XmlFile& lines, const std::string& name) {
        std::string& unit = m_out.files.back().text;
        size_t end = 0; // of the declarations: behind the last END_VAR line
        for (size_t at = 0; at < unit.size();) {
            const size_t next = std::min(unit.find('\n', at), unit.size() - 1) + 1;
            const std::string word = firstWord(std::string_view(unit).substr(at, next - at));
            if (word == "END_VAR") end = next;
            if (end == 0 && endsUnit(word)) break;
            at = next;
        }
        if (end == 0) end = unit.find('\n') + 1; // behind the line with its name
        Piece owner;
        owner.kind = kindOfDeclaration(unit);
        owner.name = m_out.files.back().name;
        owner.declaration = unit.substr(0, end);
        std::string statements = diagramText(diagram, lines, name, owner, m_out);
        unit.replace(0, end, owner.declaration);
        return statements;
    }

    /// Of the standard, of this file, or of the files before it.
    std::optional<BlockPins> pinsOf(const std::string& type) const {
        if (const auto own = m_pins.find(foldCase(type)); own != m_pins.end()) return own->second;
        if (auto known = standardPins(type)) return known;
        static const std::map<std::string, BlockPins> util = pinsOfUtil();
        std::map<std::string, BlockPins> others;
        for (const ImportedFile& file : m_out.files)
            if (foldCase(file.text).find(foldCase(type)) != std::string::npos) gatherBlockPins(file.text, others);
        const auto other = others.find(foldCase(type));
        if (other != others.end()) return other->second;
        const auto known = util.find(foldCase(type));
        return known == util.end() ? std::nullopt : std::optional(known->second);
    }
    static std::map<std::string, BlockPins> pinsOfUtil() {
        std::map<std::string, BlockPins> out;
        for (const library::Source& source : library::sourcesOf("util")) gatherBlockPins(source.text, out);
        return out;
    }

    [[nodiscard]] const char* languageDrawn() const {
        if (m_drawn.starts_with("_CFC")) return "CFC";
        if (m_drawn.starts_with("_SFC")) return "SFC";
        return m_drawn.starts_with("_LD") ? "LD" : "FBD";
    }

    const std::string& m_text;
    std::string m_place;
    Imported& m_out;
    ForeignTasks& m_tasks;
    std::map<std::string, BlockPins> m_pins; // of the blocks of this file
    int m_line = 1, m_sectionLine = 0;
    std::string m_current, m_path, m_list, m_drawn;
    std::string m_unknownBlock;                         // what the last diagram failed at
    std::string m_section, m_sectionEnd, m_sectionText; // that is being read: its word, the one that ends it, its lines
    bool m_isDrawn = false;
};

} // namespace

bool isCodesys2Text(std::string_view text) {
    return text.find("(* @NESTEDCOMMENTS") != std::string_view::npos ||
           text.find("(* @END_DECLARATION") != std::string_view::npos ||
           text.find("(* @PATH :=") != std::string_view::npos;
}

void importCodesys2Text(const std::string& text, const std::string& place, Imported& imported, ForeignTasks& tasks) {
    imported.side["source"]["format"] = "CODESYS 2.3";
    imported.side["source"]["product"] = "CODESYS 2.3";
    Codesys2Reader(text, place, imported, tasks).read();
}

} // namespace plc::exchange
