// From texts to lowered syntax trees, the libraries' included: what checking begins with. A keeper remembers what it
// read, so that a keystroke costs the file it is in. Functions and a keeper of one thread; what it hands out is
// immutable and any thread may keep it.
#pragma once
#include "runtime/base/progress.h"
#include "runtime/base/source.h"
#include "runtime/compiler/parse/syntax.h"
#include "runtime/diagnostics/diagnostic.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plc::sema {
class KeptBodies;
}

namespace plc::driver {

struct BuildInput;

struct LibraryText {
    std::string name; // "toolbox/valves.st"
    std::string_view text;
};
/// The texts that the build uses; they are views of `input` or of the program's own.
[[nodiscard]] std::vector<LibraryText> libraryTextsOf(const BuildInput& input);

/// All files of a build, by FileId: the project's, then the libraries'.
struct ReadFiles {
    std::shared_ptr<const SourceSet> sources;
    std::vector<std::shared_ptr<const syntax::SyntaxFile>> trees; // lowered
    std::vector<diagnostics::Diagnostic> diagnostics;             // of lexer, parser and lowering
};

/// What one check leaves to the next: files as they were read, bodies as they were checked.
class KeptFiles {
public:
    KeptFiles();
    /// Reads what is not the same as the last time; nothing when it was cancelled.
    [[nodiscard]] std::optional<ReadFiles> read(const BuildInput& input, Progress* progress = nullptr);
    /// How many files the last call had to read.
    [[nodiscard]] size_t readLast() const { return m_readLast; }
    /// How many bodies the last check had to check.
    [[nodiscard]] size_t checkedLast() const;
    [[nodiscard]] sema::KeptBodies& bodies() { return *m_bodies; }

private:
    struct File {
        SourceText text;
        std::string library; // its namespace; empty: a file of the project
        std::shared_ptr<const syntax::SyntaxFile> tree;
        std::vector<diagnostics::Diagnostic> diagnostics;
    };
    struct Reading; // a file that is being read
    [[nodiscard]] bool isKept(size_t index, const Reading& wanted) const;

    std::vector<File> m_files; // by FileId
    std::vector<std::string> m_defines;
    bool m_keepsEveryResult = true;
    size_t m_readLast = 0;
    std::shared_ptr<sema::KeptBodies> m_bodies;
};

} // namespace plc::driver
