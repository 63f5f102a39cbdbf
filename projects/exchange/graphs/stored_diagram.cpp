#include "projects/exchange/graphs/stored_diagram.h"

#include "runtime/base/text.h"
#include "runtime/compiler/lex/token.h"
#include "runtime/diagnostics/diagnostic.h"

namespace plc::exchange {

using lex::TokenKind;

std::map<std::string, std::string> variableTypesIn(std::string_view declaration) {
    std::map<std::string, std::string> out;
    diagnostics::Sink sink;
    const lex::TokenList list = lex::tokenize(FileId(0), declaration, sink);
    std::vector<std::string> names;
    for (size_t i = 0; i + 1 < list.tokens.size(); ++i) {
        const lex::Token& token = list.tokens[i];
        const TokenKind next = list.tokens[i + 1].kind;
        if (token.kind == TokenKind::Identifier && (next == TokenKind::Comma || next == TokenKind::Colon))
            names.push_back(foldCase(declaration.substr(token.begin, token.end - token.begin)));
        if (token.kind != TokenKind::Colon) {
            if (token.kind != TokenKind::Comma && token.kind != TokenKind::Identifier) names.clear();
            continue;
        }
        const size_t first = i + 1;
        while (i + 1 < list.tokens.size() && list.tokens[i + 1].kind != TokenKind::Semicolon &&
               list.tokens[i + 1].kind != TokenKind::Assign && list.tokens[i + 1].kind != TokenKind::EndVar)
            ++i;
        if (i < first) continue;
        const std::string type =
            trimmed(declaration.substr(list.tokens[first].begin, list.tokens[i].end - list.tokens[first].begin));
        for (const std::string& name : names) out.emplace(name, type);
        names.clear();
    }
    return out;
}

void declareIn(Piece& owner, const std::vector<std::pair<std::string, std::string>>& variables) {
    if (variables.empty()) return;
    if (!owner.declaration.empty() && !owner.declaration.ends_with('\n')) owner.declaration += '\n';
    owner.declaration += "VAR\n";
    for (const auto& [name, type] : variables) owner.declaration += "    " + name + " : " + type + ";\n";
    owner.declaration += "END_VAR\n";
}

namespace {

DiagramNames namesOf(const Piece& owner) {
    DiagramNames names;
    names.variableTypes = variableTypesIn(owner.declaration);
    names.isFunction = owner.kind == PieceKind::Function || owner.kind == PieceKind::Method;
    return names;
}

} // namespace

std::string diagramText(pugi::xml_node diagram, const XmlFile& file, const std::string& unit, Piece& owner,
                        Imported& out) {
    const DiagramText text = Diagram(diagram, file, unit, namesOf(owner), out.report).statements();
    declareIn(owner, text.variables);
    const bool isOwnBody = unit.find('.') == std::string::npos || owner.kind == PieceKind::Method;
    if (isOwnBody && owner.declaration.find("{attribute 'view'") == std::string::npos)
        owner.declaration =
            std::string("{attribute 'view' := '") + (is(diagram, "LD") ? "ladder" : "fbd") + "'}\n" + owner.declaration;
    std::string body = trimmedLines(text.statements);
    nlohmann::ordered_json& kept = out.side["units"][unit]["body"];
    kept["language"] = localName(diagram);
    kept["text"] = hashOf(body);
    kept["xml"] = toXml(diagram);
    return body;
}

std::string chartBody(pugi::xml_node chart, const XmlFile& file, const std::string& unit,
                      const std::map<std::string, std::string>& transitions, Piece& owner, Imported& out) {
    const ChartText text = chartText(chart, file, unit, transitions, namesOf(owner), out.report);
    declareIn(owner, text.variables);
    for (const auto& [name, body] : text.actions) {
        Piece action;
        action.kind = PieceKind::Action;
        action.name = name;
        action.body = body;
        owner.members.push_back(std::move(action));
    }
    return text.text;
}

} // namespace plc::exchange
