// The libraries as the parser reads them, for the tests that hold their declarations against something.
#pragma once
#include "runtime/base/text.h"
#include "runtime/compiler/parse/parser.h"
#include "runtime/library/sources.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace plc::test {

struct ParsedLibrary {
    struct File {
        library::Source source;
        std::unique_ptr<syntax::SyntaxFile> tree;
    };
    std::vector<File> files;
    std::vector<diagnostics::Diagnostic> diagnostics;
    std::map<std::string, std::pair<const syntax::Pou*, const File*>> pous; // folded names
    std::map<std::string, std::pair<const syntax::TypeDecl*, const File*>> types;
};

inline ParsedLibrary parseLibrary(std::string_view name) {
    ParsedLibrary parsed;
    const auto sources = library::sourcesOf(name);
    parsed.files.reserve(sources.size());
    for (const library::Source& source : sources) {
        diagnostics::Sink sink;
        parsed.files.push_back({source, parse::parseFile(FileId{}, source.text, sink)});
        for (diagnostics::Diagnostic& diagnostic : sink.take()) parsed.diagnostics.push_back(std::move(diagnostic));
        const ParsedLibrary::File& file = parsed.files.back();
        for (const syntax::Decl* declaration : file.tree->declarations) {
            if (declaration->pou) parsed.pous[foldCase(declaration->pou->name.text)] = {declaration->pou, &file};
            if (declaration->type) parsed.types[foldCase(declaration->type->name.text)] = {declaration->type, &file};
        }
    }
    return parsed;
}

} // namespace plc::test
