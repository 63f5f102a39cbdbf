#include "projects/exchange/base/own_namespaces.h"

#include "runtime/base/text.h"
#include "runtime/compiler/lex/token.h"
#include "runtime/diagnostics/diagnostic.h"

#include <algorithm>
#include <filesystem>
#include <map>

namespace plc::exchange {

namespace {

using lex::TokenKind;

/// Folded name of a library → as it is spelled; those that are also something else in the project are left out.
using Libraries = std::map<std::string, std::string>;

/// The library in which CODESYS and TwinCAT keep the names of types of ANY inputs.
constexpr std::string_view kTypeClasses = "ibaselibrary";

std::string_view tokenText(const lex::Token& token, std::string_view text) {
    return text.substr(token.begin, token.end - token.begin);
}

void leaveOutDeclared(const ImportedFile& file, Libraries& libraries) {
    libraries.erase(foldCase(std::filesystem::path(file.path).stem().string())); // a unit or list of that name
    diagnostics::Sink sink;
    const lex::TokenList list = lex::tokenize(FileId(0), file.text, sink);
    for (size_t i = 0; i + 1 < list.tokens.size(); ++i)
        if (list.tokens[i].kind == TokenKind::Identifier && list.tokens[i + 1].kind == TokenKind::Colon)
            libraries.erase(foldCase(tokenText(list.tokens[i], file.text)));
}

/// From the last to the first, so that the places of the others stay.
void dropIn(ImportedFile& file, const Libraries& libraries, std::set<std::string>& dropped) {
    diagnostics::Sink sink;
    const std::string before = file.text;
    const lex::TokenList list = lex::tokenize(FileId(0), before, sink);
    for (size_t i = list.tokens.size(); i-- > 0;) {
        const lex::Token& token = list.tokens[i];
        if (token.kind != TokenKind::Identifier || i + 2 >= list.tokens.size()) continue;
        if (list.tokens[i + 1].kind != TokenKind::Dot || list.tokens[i + 2].kind != TokenKind::Identifier) continue;
        if (i > 0 && list.tokens[i - 1].kind == TokenKind::Dot) continue;
        const auto library = libraries.find(foldCase(tokenText(token, before)));
        if (library == libraries.end()) continue;
        dropped.insert(library->second);
        if (library->first == kTypeClasses) { // there by another name
            const std::string name = foldCase(tokenText(list.tokens[i + 2], before));
            if (name == "typeclass")
                file.text.replace(token.begin, list.tokens[i + 2].end - token.begin, "__SYSTEM.TYPE_CLASS");
            else if (name.starts_with("type_"))
                file.text.replace(token.begin, list.tokens[i + 1].begin - token.begin, "__SYSTEM.TYPE_CLASS");
            continue;
        }
        file.text.erase(token.begin, list.tokens[i + 2].begin - token.begin);
    }
}

/// A look at the bytes: most projects name no library, and reading every word of 100,000 lines takes its time.
bool mayName(const ImportedFile& file, const Libraries& libraries) {
    const std::string folded = foldCase(file.text);
    return std::any_of(libraries.begin(), libraries.end(), [&](const auto& each) {
        for (size_t at = folded.find(each.first); at != std::string::npos; at = folded.find(each.first, at + 1)) {
            const size_t end = folded.find_first_not_of(" \t\r\n", at + each.first.size());
            if (end != std::string::npos && (folded[end] == '.' || folded[end] == '(' || folded[end] == '/'))
                return true;
        }
        return false;
    });
}

} // namespace

void dropOwnNamespaces(Imported& imported) {
    Libraries libraries = {{std::string(kTypeClasses), "IBaseLibrary"}};
    for (const std::string& name : imported.namespaces) libraries.emplace(foldCase(name), name);
    for (const std::string& name : imported.coveredNamespaces) libraries.emplace(foldCase(name), name);
    for (const auto& [alias, library] : imported.aliases)
        if (imported.projectNames.count(foldCase(library))) {
            imported.namespaces.insert(alias);
            libraries.emplace(foldCase(alias), alias);
        }
    std::vector<ImportedFile*> naming;
    for (ImportedFile& file : imported.files)
        if (mayName(file, libraries)) naming.push_back(&file);
    if (naming.empty()) return;
    for (const ImportedFile& file : imported.files) leaveOutDeclared(file, libraries);
    std::set<std::string> dropped;
    for (ImportedFile* file : naming) dropIn(*file, libraries, dropped);
    for (const std::string& name : dropped)
        imported.report.add(name, imported.namespaces.count(name) ? remarks::OwnNamespaceDropped(name)
                                                                  : remarks::CoveredNamespaceDropped(name));
}

} // namespace plc::exchange
