#include "projects/exchange/base/c_code.h"

#include "projects/exchange/base/xml.h"
#include "runtime/base/text.h"
#include "runtime/compiler/lex/token.h"
#include "runtime/diagnostics/diagnostic.h"

namespace plc::exchange {

namespace {

std::string commentOf(std::string code) {
    for (size_t star = 0; (star = code.find("*)", star)) != std::string::npos;) code.insert(star + 1, " ");
    for (size_t star = 0; (star = code.find("(*", star)) != std::string::npos;) code.insert(star + 1, " ");
    return "(* C:" + code + "*)";
}

/// MATIEC takes what a pragma holds for C: statements, or its macros for variables.
bool holdsC(std::string_view pragma) {
    const std::string word = foldCase(trimmed(pragma.substr(0, pragma.find_first_of(" '\t"))));
    if (word == "attribute" || word == "text" || word == "info" || word == "warning" || word == "error") return false;
    return pragma.find(';') != std::string_view::npos || pragma.find("__SET_VAR") != std::string_view::npos ||
           pragma.find("__GET_VAR") != std::string_view::npos;
}

bool commentOutPragmas(std::string& text) {
    diagnostics::Sink sink;
    const lex::TokenList list = lex::tokenize(FileId(0), text, sink);
    bool found = false;
    for (auto token = list.tokens.rbegin(); token != list.tokens.rend(); ++token) {
        if (token->kind != lex::TokenKind::Pragma || token->end < token->begin + 2) continue;
        const std::string code = text.substr(token->begin + 1, token->end - token->begin - 2);
        if (!holdsC(code)) continue;
        text.replace(token->begin, token->end - token->begin, commentOf(code));
        found = true;
    }
    return found;
}

} // namespace

bool commentOutC(std::string& text) {
    bool found = false;
    for (size_t at = text.find("{{"); at != std::string::npos; at = text.find("{{", at)) {
        const size_t end = text.find("}}", at);
        if (end == std::string::npos) break;
        const std::string comment = commentOf(text.substr(at + 2, end - at - 2));
        text.replace(at, end + 2 - at, comment);
        at += comment.size();
        found = true;
    }
    if (text.find('{') != std::string::npos) found |= commentOutPragmas(text);
    return found;
}

} // namespace plc::exchange
