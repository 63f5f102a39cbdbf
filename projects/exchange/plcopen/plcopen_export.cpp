#include "projects/exchange/plcopen/plcopen_export.h"

#include "projects/exchange/base/addresses.h"
#include "projects/exchange/base/imported.h"
#include "projects/exchange/base/xml.h"
#include "projects/exchange/plcopen/chart_export.h"
#include "projects/exchange/plcopen/namespace_export.h"
#include "projects/exchange/plcopen/plcopen_export_parts.h"
#include "projects/storage/project_file.h"
#include "runtime/base/messages.h"
#include "runtime/base/read_json.h"
#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"
#include "runtime/types/string_code.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

namespace plc::exchange {

namespace {

using Json = nlohmann::ordered_json;
using syntax::BodyLanguage;
using syntax::DeclKind;
using syntax::PouKind;
namespace fs = std::filesystem;

constexpr const char* kVendor = "http://www.3s-software.com/plcopenxml/";

Json sideFileOf(const projects::Project& project) {
    if (project.folder.empty()) return Json::object();
    const auto text = projects::readFile(project.folder + "/exchange.json");
    if (!text) return Json::object();
    JsonText<Json> json = readJson<Json>(*text);
    return json.isGood() && json.value.is_object() ? std::move(json.value) : Json::object();
}

const Json& at(const Json& json, const std::string& name) {
    static const Json kNothing = Json::object();
    return json.is_object() && json.contains(name) ? json[name] : kNothing;
}

class Exporter {
public:
    Exporter(const projects::Project& project, const ExportOptions& options)
        : m_project(project), m_options(options), m_side(sideFileOf(project)) {}

    Result<Exported> run() {
        if (auto done = parse(); !done) return done.error();
        writeHeader();
        pugi::xml_node types = m_root.append_child("types");
        m_dataTypes = types.append_child("dataTypes");
        m_pous = types.append_child("pous");
        m_configurations = m_root.append_child("instances").append_child("configurations");
        for (const File& file : m_files) writeFile(file);
        writeGlobals();
        writeProjectData();
        return finish();
    }

private:
    struct File {
        std::string path, folder;
        std::unique_ptr<syntax::SyntaxFile> tree;
        std::unique_ptr<SourceView> view;
    };
    struct Globals {
        const File* file;
        std::string name;
        std::vector<const syntax::GlobalList*> sections;
        SourceRange range;
    };

    Result<void> parse() {
        for (const driver::SourceFile& source : withoutNamespaces(m_project.sources, m_out.report)) {
            const bool isCounted = m_project.addressing == image::Addressing::Words;
            const FileId id = m_sources.add(
                source.path, isCounted ? source.text : addressesInWords(source.text, source.path, m_out.report));
            (void)id;
        }
        for (size_t i = 0; i < m_sources.files.size(); ++i) {
            diagnostics::Sink sink;
            const FileId id(i);
            File file;
            file.path = m_sources[id].path();
            const fs::path path(file.path);
            file.folder = path.parent_path().generic_string();
            if (file.folder.starts_with("src")) file.folder.erase(0, 3);
            while (file.folder.starts_with("/")) file.folder.erase(0, 1);
            file.tree = parse::parseFile(id, m_sources[id].text(), sink);
            file.view = std::make_unique<SourceView>(*file.tree, m_sources[id].text());
            for (const diagnostics::Diagnostic& each : sink.all())
                if (each.severity == diagnostics::Severity::Error)
                    return Error{errors::ExportSyntaxErrors(),
                                 file.path + ":" + std::to_string(m_sources[id].lineColumn(each.range.begin).line)};
            m_files.push_back(std::move(file));
        }
        return {};
    }

    [[nodiscard]] bool isPlain() const { return m_options.edition == Edition::Plain0201; }
    XmlWriter writerOf(const File& file) { return {m_options.edition, *file.view, file.path, m_out.report}; }

    void writeHeader() {
        pugi::xml_node declaration = m_document.append_child(pugi::node_declaration);
        declaration.append_attribute("version") = "1.0";
        declaration.append_attribute("encoding") = "utf-8";
        m_root = m_document.append_child("project");
        m_root.append_attribute("xmlns") =
            isPlain() ? "http://www.plcopen.org/xml/tc6_0201" : "http://www.plcopen.org/xml/tc6_0200";
        m_root.append_attribute("xmlns:xhtml") = "http://www.w3.org/1999/xhtml"; // diagrams of an import may use it
        if (isPlain()) {
            m_root.append_attribute("xmlns:ns1") = "http://www.plcopen.org/xml/tc6_0201";
            m_root.append_attribute("xmlns:xsd") = "http://www.w3.org/2001/XMLSchema";
        }
        pugi::xml_node file = m_root.append_child("fileHeader");
        file.append_attribute("companyName") = "Stepwise";
        file.append_attribute("productName") = "Stepwise";
        file.append_attribute("productVersion") = "0.1.0";
        file.append_attribute("creationDateTime") = m_options.time.c_str();
        pugi::xml_node content = m_root.append_child("contentHeader");
        content.append_attribute("name") = m_project.name.c_str();
        content.append_attribute("modificationDateTime") = m_options.time.c_str();
        pugi::xml_node info = content.append_child("coordinateInfo");
        for (const char* language : {"fbd", "ld", "sfc"}) {
            pugi::xml_node scaling = info.append_child(language).append_child("scaling");
            scaling.append_attribute("x") = 1;
            scaling.append_attribute("y") = 1;
        }
    }

    // ------------------------------------------------------------ files

    void writeFile(const File& file) {
        const syntax::Decl* before = nullptr;
        for (const syntax::Decl* decl : file.tree->declarations) {
            const bool isSameList = before && before->kind == DeclKind::Globals;
            before = decl;
            switch (decl->kind) {
            case DeclKind::Pou:
                if (decl->pou->kind == PouKind::Interface)
                    writeInterface(file, *decl->pou);
                else
                    writePou(file, *decl->pou);
                break;
            case DeclKind::Type:
                writeType(file, *decl);
                break;
            case DeclKind::Globals:
                gatherGlobals(file, *decl, isSameList);
                break;
            case DeclKind::Configuration:
                writeConfiguration(m_configurations, *decl->configuration, writerOf(file));
                break;
            case DeclKind::Namespace:
                break; // withoutNamespaces has said why
            case DeclKind::Using:
                m_out.report.add(file.path, remarks::UsingNotExported());
                break;
            case DeclKind::Test:
                m_out.report.add(file.path, remarks::TestNotExported(decl->test->title));
                break;
            }
        }
        noteEndComments(file);
    }

    void noteEndComments(const File& file) {
        const auto& tokens = file.tree->tokens.tokens;
        const uint32_t from = tokens.size() > 1 ? file.view->trailingEnd(tokens[tokens.size() - 2].end) : 0;
        const auto size = static_cast<uint32_t>(file.view->all().size());
        if (const std::string text = file.view->commentsBetween(from, size); !text.empty())
            m_out.report.add(file.path, remarks::CommentLost(text.substr(0, text.find('\n'))));
    }

    /// Id, folder and what an earlier import kept of the unit.
    void identify(pugi::xml_node element, const File* file, const std::string& name) {
        ++m_out.report.units[std::string(localNameOf(element))];
        if (isPlain()) return;
        for (const auto& [key, xml] : at(at(at(m_side, "units"), name), "data").items())
            if (xml.is_string()) appendXml(addDataOf(element), xml.get<std::string>());
        pugi::xml_node data = XmlWriter::data(element, (std::string(kVendor) + "objectid").c_str(), "discard");
        data.append_child("ObjectId").text().set(idOf(name).c_str());
        if (file) m_folders[file->folder].push_back(name);
    }
    static std::string_view localNameOf(pugi::xml_node element) { return localName(element); }
    static pugi::xml_node addDataOf(pugi::xml_node element) {
        pugi::xml_node addData = element.child("addData");
        return addData ? addData : element.append_child("addData");
    }
    static void appendXml(pugi::xml_node parent, const std::string& xml) {
        parent.append_buffer(xml.data(), xml.size(), pugi::parse_default, pugi::encoding_utf8);
    }

    // ------------------------------------------------------------ units

    static const char* pouType(PouKind kind) {
        if (kind == PouKind::Function) return "function";
        return kind == PouKind::Program ? "program" : "functionBlock";
    }

    void writePou(const File& file, const syntax::Pou& pou) {
        const XmlWriter writer = writerOf(file);
        const std::string name(pou.name.text);
        const UnitText text = file.view->textOf(pou);
        pugi::xml_node node = m_pous.append_child("pou");
        node.append_attribute("name") = name.c_str();
        node.append_attribute("pouType") = pouType(pou.kind);
        writeSignature(node.append_child("interface"), pou, writer);
        writeActions(node, pou, file);
        writeBody(node, pou.body, text.body, name, writer);
        if (isPlain()) {
            for (const syntax::Pou* method : pou.methods)
                writer.lose(remarks::MethodNotInEdition(name + "." + std::string(method->name.text)));
            for (const syntax::Property* property : pou.properties)
                writer.lose(remarks::PropertyNotInEdition(name + "." + std::string(property->name.text)));
            if (!pou.extends.empty() || !pou.implements.empty()) writer.lose(remarks::InheritanceNotInEdition(name));
            writer.documentation(node, pou.comment);
            return identify(node, &file, name);
        }
        for (const syntax::Pou* method : pou.methods) writeMethod(node, *method, name, file);
        for (const syntax::Property* property : pou.properties) writeProperty(node, *property, name, file);
        writer.plainText(node, text.declaration);
        identify(node, &file, name);
    }

    void writeSignature(pugi::xml_node interface, const syntax::Pou& pou, const XmlWriter& writer) {
        if (pou.result && pou.kind != syntax::PouKind::FunctionBlock)
            writer.type(interface.append_child("returnType"), *pou.result);
        for (const syntax::VarSection* section : pou.sections) writer.section(interface, *section);
        if (isPlain()) return;
        if (pou.extends.empty() && pou.implements.empty()) return;
        pugi::xml_node list =
            XmlWriter::data(interface, (std::string(kVendor) + "pouinheritance").c_str()).append_child("Inheritance");
        const auto paths = [&](const std::vector<syntax::Path>& all, const char* tag) {
            for (const syntax::Path& path : all) {
                std::string text;
                for (const syntax::Name& part : path) text += (text.empty() ? "" : ".") + std::string(part.text);
                list.append_child(tag).text().set(text.c_str());
            }
        };
        paths(pou.extends, "Extends");
        paths(pou.implements, "Implements");
    }

    void writeActions(pugi::xml_node node, const syntax::Pou& pou, const File& file) {
        std::vector<const syntax::ActionDecl*> all(pou.actions.begin(), pou.actions.end());
        if (pou.body.chart) all.insert(all.end(), pou.body.chart->actions.begin(), pou.body.chart->actions.end());
        if (all.empty()) return;
        std::sort(all.begin(), all.end(), [](const auto* a, const auto* b) { return a->range.begin < b->range.begin; });
        const XmlWriter writer = writerOf(file);
        pugi::xml_node actions = node.append_child("actions");
        for (const syntax::ActionDecl* each : all) {
            pugi::xml_node action = actions.append_child("action");
            action.append_attribute("name") = std::string(each->name.text).c_str();
            writeBody(action, each->body, file.view->textOf(*each).body,
                      std::string(pou.name.text) + "." + std::string(each->name.text), writer);
        }
    }

    void writeBody(pugi::xml_node node, const syntax::Body& body, const std::string& text, const std::string& unit,
                   const XmlWriter& writer) {
        pugi::xml_node holder = node.append_child("body");
        const Json& kept = at(at(at(m_side, "units"), unit), "body");
        if (kept.is_object() && kept.value("text", "") == hashOf(text)) {
            ++m_out.report.bodies[kept.value("language", "")];
            return appendXml(holder, kept.value("xml", ""));
        }
        switch (body.language) {
        case BodyLanguage::Sfc:
            ++m_out.report.bodies["SFC"];
            noteCommentsOutside(*body.chart, writer, unit);
            return writeChart(holder.append_child("SFC"), *body.chart, at(at(at(m_side, "units"), unit), "positions"),
                              writer);
        case BodyLanguage::Il:
            ++m_out.report.bodies["IL"];
            return writer.text(holder.append_child("IL"), text);
        case BodyLanguage::St:
        case BodyLanguage::None:
            if (!text.empty()) ++m_out.report.bodies["ST"];
            return writer.text(holder.append_child("ST"), text);
        }
    }

    pugi::xml_node memberData(pugi::xml_node node, const char* kind, const char* tag, const std::string& path) {
        pugi::xml_node out = XmlWriter::data(node, (std::string(kVendor) + kind).c_str()).append_child(tag);
        out.append_attribute("name") = path.substr(path.rfind('.') + 1).c_str();
        out.append_attribute("ObjectId") = idOf(path).c_str();
        return out;
    }

    void writeMethod(pugi::xml_node node, const syntax::Pou& method, const std::string& unit, const File& file) {
        const std::string path = unit + "." + std::string(method.name.text);
        fillMethod(memberData(node, "method", "Method", path), method, path, file);
    }
    void fillMethod(pugi::xml_node node, const syntax::Pou& method, const std::string& path, const File& file) {
        const XmlWriter writer = writerOf(file);
        const UnitText text = file.view->textOf(method);
        writeSignature(node.append_child("interface"), method, writer);
        writeBody(node, method.body, text.body, path, writer);
        writer.plainText(node, text.declaration);
    }

    void writeProperty(pugi::xml_node node, const syntax::Property& property, const std::string& unit,
                       const File& file) {
        const std::string path = unit + "." + std::string(property.name.text);
        const XmlWriter writer = writerOf(file);
        pugi::xml_node out = memberData(node, "property", "Property", path);
        if (property.type) writer.type(out.append_child("interface").append_child("returnType"), *property.type);
        if (property.get) writeAccessor(out.append_child("GetAccessor"), *property.get, path + ".Get", file);
        if (property.set) writeAccessor(out.append_child("SetAccessor"), *property.set, path + ".Set", file);
        writer.plainText(out, file.view->declarationOf(property));
    }
    void writeAccessor(pugi::xml_node node, const syntax::Pou& accessor, const std::string& path, const File& file) {
        const XmlWriter writer = writerOf(file);
        UnitText text = file.view->textOf(accessor);
        writeSignature(node.append_child("interface"), accessor, writer);
        writeBody(node, accessor.body, text.body, path, writer);
        // without the word GET or SET, as the format has it
        const size_t word = text.declaration.find(std::string(accessor.name.text));
        if (word != std::string::npos) text.declaration.erase(word, accessor.name.text.size());
        if (const std::string rest = trimmedLines(text.declaration); !rest.empty()) writer.plainText(node, rest);
    }

    void writeInterface(const File& file, const syntax::Pou& pou) {
        const std::string name(pou.name.text);
        const XmlWriter writer = writerOf(file);
        if (isPlain()) return writer.lose(remarks::InterfaceNotInEdition(name));
        pugi::xml_node node =
            XmlWriter::data(m_root, (std::string(kVendor) + "interface").c_str()).append_child("Interface");
        node.append_attribute("name") = name.c_str();
        node.append_attribute("ObjectId") = idOf(name).c_str();
        pugi::xml_node methods = node.append_child("Methods");
        for (const syntax::Pou* method : pou.methods) {
            pugi::xml_node each = methods.append_child("Method");
            each.append_attribute("name") = std::string(method->name.text).c_str();
            each.append_attribute("ObjectId") = idOf(name + "." + std::string(method->name.text)).c_str();
            writeSignature(each.append_child("interface"), *method, writer);
            writer.plainText(each, file.view->textOf(*method).declaration);
        }
        for (const syntax::Property* property : pou.properties) writeProperty(node, *property, name, file);
        writer.plainText(node, file.view->textOf(pou).declaration);
        identify(node, &file, name);
    }

    void writeType(const File& file, const syntax::Decl& decl) {
        const XmlWriter writer = writerOf(file);
        const syntax::TypeDecl& type = *decl.type;
        const std::string name(type.name.text);
        if (isPlain() && type.spec && type.spec->kind == syntax::TypeSpecKind::Union)
            return writer.lose(remarks::UnionNotInEdition(name));
        pugi::xml_node node = m_dataTypes.append_child("dataType");
        node.append_attribute("name") = name.c_str();
        pugi::xml_node base = node.append_child("baseType");
        if (type.spec) writer.type(base, *type.spec);
        if (type.initial) writer.value(node.append_child("initialValue"), *type.initial);
        if (isPlain()) {
            if (type.spec && type.spec->extends) writer.lose(remarks::InheritanceNotInEdition(name));
            identify(node, &file, name);
            return writer.documentation(node, type.comment);
        }
        writer.plainText(node, textOfType(*file.tree, *file.view, type));
        identify(node, &file, name);
    }

    // ------------------------------------------------------------ globals

    void gatherGlobals(const File& file, const syntax::Decl& decl, bool followsList) {
        std::string name(decl.globals->name);
        if (name.empty()) name = fs::path(file.path).stem().string(); // as the checker names it
        if (followsList && !m_globals.empty() && m_globals.back().file == &file && m_globals.back().name == name) {
            m_globals.back().sections.push_back(decl.globals);
            m_globals.back().range = joined(m_globals.back().range, decl.range);
            return;
        }
        m_globals.push_back({&file, name, {decl.globals}, decl.range});
    }

    void writeGlobals() {
        for (const Globals& list : m_globals) {
            const XmlWriter writer = writerOf(*list.file);
            pugi::xml_node node =
                isPlain() ? plainGlobals() : XmlWriter::data(m_root, (std::string(kVendor) + "globalvars").c_str());
            node = node.append_child("globalVars");
            node.append_attribute("name") = list.name.c_str();
            for (const syntax::GlobalList* each : list.sections) writeList(node, *each->section, writer);
            if (isPlain()) {
                identify(node, list.file, list.name);
                continue;
            }
            const SourceView& view = *list.file->view;
            const uint32_t begin = view.leadingBegin(list.range.begin);
            std::string text = trimmedLines(view.all().substr(begin, view.trailingEnd(list.range.end) - begin));
            writer.plainText(node, withoutListName(std::move(text)));
            identify(node, list.file, list.name);
        }
    }
    static void writeList(pugi::xml_node node, const syntax::VarSection& section, const XmlWriter& writer) {
        if (section.constant && !node.attribute("constant")) node.append_attribute("constant") = true;
        if (section.retain && !node.attribute("retain")) node.append_attribute("retain") = true;
        if (section.persistent && !node.attribute("persistent")) node.append_attribute("persistent") = true;
        writer.variables(node, section.declarations);
    }
    /// 0201 has globals in configurations and resources only.
    pugi::xml_node plainGlobals() {
        pugi::xml_node configuration = m_configurations.child("configuration");
        if (!configuration) {
            configuration = m_configurations.append_child("configuration");
            configuration.append_attribute("name") = "Plc";
            configuration.append_child("resource").append_attribute("name") = "Resource1";
        }
        return configuration;
    }

    // ------------------------------------------------------------ the project

    /// A STRING has other bytes than its tool would choose: our own import reads it.
    void writeStringEncoding() {
        if (m_project.strings == types::StringCode::Latin1) return;
        pugi::xml_node node = XmlWriter::data(m_root, kStringEncodingData, "discard").append_child("StringEncoding");
        node.text().set(std::string(types::nameOf(m_project.strings)).c_str());
    }

    void writeProjectData() {
        if (!m_project.panels.empty()) m_out.report.add("hmi", remarks::PanelsNotExported());
        if (!m_project.traces.empty()) m_out.report.add("traces", remarks::TracesNotExported());
        if (!m_project.tests.empty()) m_out.report.add("tests", remarks::TestsNotExported());
        writeStringEncoding();
        if (isPlain()) {
            for (const std::string& library : m_project.libraries)
                m_out.report.add("project.json", remarks::LibraryNotInEdition(library));
            return;
        }
        writeLibraries();
        for (const auto& [key, xml] : at(at(m_side, "project"), "data").items())
            if (xml.is_string()) appendXml(addDataOf(m_root), xml.get<std::string>());
        pugi::xml_node structure =
            XmlWriter::data(m_root, (std::string(kVendor) + "projectstructure").c_str(), "discard")
                .append_child("ProjectStructure");
        for (const auto& [folder, units] : m_folders) addFolder(structure, folder, units);
    }

    void writeLibraries() {
        const Json& kept = at(at(m_side, "project"), "libraries");
        if (m_project.libraries.empty() && kept.empty()) return;
        pugi::xml_node list =
            XmlWriter::data(m_root, (std::string(kVendor) + "libraries").c_str()).append_child("Libraries");
        std::string known;
        for (const Json& each : kept)
            if (each.is_string()) {
                known += foldCase(each.get<std::string>());
                appendXml(list, each.get<std::string>());
            }
        for (const std::string& library : m_project.libraries) {
            if (known.find("\"" + library + "\"") != std::string::npos ||
                known.find("\"#" + library + "\"") != std::string::npos)
                continue;
            pugi::xml_node node = list.append_child("Library");
            node.append_attribute("Name") = library.c_str();
            node.append_attribute("Namespace") = library.c_str();
        }
    }

    Result<Exported> finish() {
        std::ostringstream out;
        m_document.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
        m_out.text = out.str();
        m_out.report.filesRead = static_cast<int>(m_files.size());
        return std::move(m_out);
    }

    const projects::Project& m_project;
    ExportOptions m_options;
    Json m_side;
    SourceSet m_sources;
    std::vector<File> m_files;
    std::vector<Globals> m_globals;
    std::map<std::string, std::vector<std::string>> m_folders;
    pugi::xml_document m_document;
    pugi::xml_node m_root, m_dataTypes, m_pous, m_configurations;
    Exported m_out;
};

} // namespace

Result<Exported> exportPlcopen(const projects::Project& project, const ExportOptions& options) {
    return Exporter(project, options).run();
}

} // namespace plc::exchange
