#include "projects/exchange/plcopen/plcopen_export_parts.h"

#include "projects/exchange/base/imported.h"
#include "projects/exchange/base/xml.h"
#include "runtime/base/text.h"

#include <algorithm>

namespace plc::exchange {

namespace {

void writeInstance(pugi::xml_node parent, const syntax::ProgramInstance& program, const XmlWriter& writer) {
    pugi::xml_node node = parent.append_child("pouInstance");
    node.append_attribute("name") = std::string(program.name.text).c_str();
    std::string type;
    for (const syntax::Name& part : program.type) type += (type.empty() ? "" : ".") + std::string(part.text);
    node.append_attribute("typeName") = type.c_str();
    if (writer.isPlain() && !(program.connections.empty() && program.blockTasks.empty()))
        writer.lose(remarks::ConnectionsNotInEdition(program.name.text));
}

pugi::xml_node writeTask(pugi::xml_node resource, const syntax::TaskDecl& task, const XmlWriter& writer) {
    pugi::xml_node node = resource.append_child("task");
    node.append_attribute("name") = std::string(task.name.text).c_str();
    const SourceView& view = writer.source();
    if (task.single) node.append_attribute("single") = view.text(task.single).c_str();
    if (task.interval) node.append_attribute("interval") = view.text(task.interval).c_str();
    node.append_attribute("priority") = task.priority ? view.text(task.priority).c_str() : "0";
    if (writer.isPlain() && !task.others.empty())
        writer.lose(remarks::TaskSettingNotInEdition(task.others.front().name.text));
    return node;
}

void writeResource(pugi::xml_node configuration, const syntax::ResourceDecl& decl, const XmlWriter& writer) {
    pugi::xml_node node = configuration.append_child("resource");
    node.append_attribute("name") = decl.name.isValid() ? std::string(decl.name.text).c_str() : "Resource1";
    for (const syntax::TaskDecl* task : decl.tasks) {
        pugi::xml_node each = writeTask(node, *task, writer);
        for (const syntax::ProgramInstance* program : decl.programs)
            if (equalsIgnoringCase(program->task.text, task->name.text)) writeInstance(each, *program, writer);
    }
    for (const syntax::VarSection* section : decl.sections) writer.section(node, *section);
    for (const syntax::ProgramInstance* program : decl.programs)
        if (!program->task.isValid()) writeInstance(node, *program, writer);
}

} // namespace

std::string idOf(const std::string& name) {
    const std::string a = hashOf(name), b = hashOf("stepwise " + name);
    return a.substr(0, 8) + "-" + a.substr(8, 4) + "-" + a.substr(12, 4) + "-" + b.substr(0, 4) + "-" + b.substr(4, 12);
}

void writeConfiguration(pugi::xml_node configurations, const syntax::ConfigurationDecl& decl, const XmlWriter& writer) {
    pugi::xml_node node = configurations.append_child("configuration");
    node.append_attribute("name") = std::string(decl.name.text).c_str();
    for (const syntax::ResourceDecl* resource : decl.resources) writeResource(node, *resource, writer);
    for (const syntax::VarSection* section : decl.sections) writer.section(node, *section);
    const SourceView& view = writer.source();
    const uint32_t begin = view.leadingBegin(decl.range.begin);
    writer.plainText(node, trimmedLines(view.all().substr(begin, decl.range.end - begin)));
}

void addFolder(pugi::xml_node structure, const std::string& folder, const std::vector<std::string>& units) {
    pugi::xml_node node = structure;
    for (size_t at = 0; at < folder.size();) {
        const size_t end = std::min(folder.find('/', at), folder.size());
        const std::string name = folder.substr(at, end - at);
        pugi::xml_node next = node.find_child_by_attribute("Folder", "Name", name.c_str());
        if (!next) {
            next = node.append_child("Folder");
            next.append_attribute("Name") = name.c_str();
        }
        node = next;
        at = end + 1;
    }
    for (const std::string& unit : units) {
        pugi::xml_node object = node.append_child("Object");
        object.append_attribute("Name") = unit.c_str();
        object.append_attribute("ObjectId") = idOf(unit).c_str();
    }
}

std::string textOfType(const syntax::SyntaxFile& tree, const SourceView& view, const syntax::TypeDecl& type) {
    const auto& tokens = tree.tokens.tokens;
    auto first = std::lower_bound(tokens.begin(), tokens.end(), type.range.begin,
                                  [](const lex::Token& token, uint32_t at) { return token.begin < at; });
    while (first != tokens.begin() && (first - 1)->kind == lex::TokenKind::Pragma) --first;
    std::string above;
    uint32_t begin = view.leadingBegin(type.range.begin);
    std::string word = "TYPE";
    auto opening = first; // TYPE, TYPE PUBLIC
    while (opening != tokens.begin() && (opening - 1)->kind == lex::TokenKind::Identifier) --opening;
    if (opening != tokens.begin() && (opening - 1)->kind == lex::TokenKind::TypeWord) {
        --opening;
        const uint32_t top = view.leadingBegin(opening->begin);
        above = std::string(view.all().substr(top, opening->begin - top));
        word = trimmed(view.all().substr(opening->begin, begin - opening->begin));
        if (word.empty()) word = "TYPE";
    }
    auto behind = std::lower_bound(tokens.begin(), tokens.end(), type.range.end,
                                   [](const lex::Token& token, uint32_t at) { return token.begin < at; });
    uint32_t end = view.trailingEnd(type.range.end);
    if (behind != tokens.end() && behind->kind == lex::TokenKind::EndType) end = std::max(end, behind->begin);
    const bool sameLine =
        view.all().substr(opening->begin, begin - opening->begin).find('\n') == std::string_view::npos;
    std::string body = trimmedLines(view.all().substr(begin, end - begin));
    return above + word + (sameLine ? " " + trimmed(body) : "\n" + body) + "\nEND_TYPE";
}

std::string withoutListName(std::string text) {
    const size_t at = text.find("{gvl");
    if (at == std::string::npos) return text;
    const size_t end = text.find('}', at);
    if (end == std::string::npos || text.find("VAR_GLOBAL") < at) return text;
    text.erase(at, end + 1 - at);
    return trimmedLines(text);
}

void noteCommentsOutside(const syntax::SfcBody& chart, const XmlWriter& writer, const std::string& unit) {
    std::vector<SourceRange> kept;
    for (const syntax::StepDecl* each : chart.steps)
        kept.push_back({each->range.file, each->extent.begin, each->range.begin});
    for (const syntax::TransitionDecl* each : chart.transitions) {
        kept.push_back({each->range.file, each->extent.begin, each->range.begin});
        if (each->condition) kept.push_back(each->condition->range);
    }
    for (const syntax::ActionDecl* each : chart.actions) kept.push_back(each->extent);
    for (const lex::Comment& comment : writer.source().comments()) {
        if (comment.begin < chart.range.begin || comment.end > chart.range.end) continue;
        const bool isKept = std::any_of(kept.begin(), kept.end(), [&](SourceRange range) {
            return comment.begin >= range.begin && comment.end <= range.end;
        });
        if (isKept) continue;
        const std::string text(writer.source().all().substr(comment.begin, comment.end - comment.begin));
        writer.lose(remarks::CommentLost(unit + ": " + text.substr(0, text.find('\n'))));
    }
}

} // namespace plc::exchange
