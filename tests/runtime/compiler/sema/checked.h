// One text through lexer, parser, lowering and checker, for the tests of the checker.
#pragma once
#include "runtime/compiler/lower/lower.h"
#include "runtime/compiler/parse/parser.h"
#include "runtime/compiler/sema/sema.h"
#include "runtime/library/sources.h"

#include <string>
#include <vector>

namespace plc::sema_test {

struct Source {
    std::string path;
    std::string text;
    std::string library; // namespace; empty: the project
};

struct CheckedText {
    std::shared_ptr<SourceSet> sources;
    std::shared_ptr<const sema::Analysis> analysis;
    /// "P2001 'name'" for each message about the project's own files: code and the text it points at.
    [[nodiscard]] std::vector<std::string> messages(bool withInfos = true) const {
        std::vector<std::string> out;
        for (const diagnostics::Diagnostic& diagnostic : analysis->diagnostics) {
            if (!withInfos && diagnostic.severity == diagnostics::Severity::Info) continue;
            std::string line(diagnostics::codeOf(diagnostic.kind));
            if (diagnostic.range.file.isValid())
                line += " '" + std::string((*sources)[diagnostic.range.file].slice(diagnostic.range)) + "'";
            out.push_back(std::move(line));
        }
        return out;
    }
    [[nodiscard]] std::string all() const {
        std::string out;
        for (const diagnostics::Diagnostic& diagnostic : analysis->diagnostics)
            out += diagnostics::renderText(*sources, diagnostic, false);
        return out;
    }
};

inline CheckedText check(const std::vector<Source>& files, bool withStandard = true) {
    CheckedText out;
    out.sources = std::make_shared<SourceSet>();
    out.sources->files.reserve(files.size() + library::sources().size());
    std::vector<std::string> libraries;
    for (const Source& file : files) {
        out.sources->add(file.path, file.text);
        libraries.push_back(file.library);
    }
    if (withStandard) {
        for (const library::Source& source : library::sourcesOf("standard")) {
            out.sources->add("standard/" + std::string(source.fileName), std::string(source.text));
            libraries.push_back("Standard");
        }
    }
    diagnostics::Sink sink;
    std::vector<std::shared_ptr<const syntax::SyntaxFile>> trees;
    for (size_t i = 0; i < out.sources->files.size(); ++i) {
        auto tree = parse::parseFile(FileId(i), (*out.sources)[FileId(i)].text(), sink);
        tree->library = libraries[i];
        lower::lowerFile(*tree, sink);
        trees.push_back(std::move(tree));
    }
    out.analysis = sema::analyze(*out.sources, std::move(trees), sink.take(), {});
    return out;
}

inline CheckedText check(const std::string& text) { return check({{"test.st", text, ""}}); }

} // namespace plc::sema_test
