// Declares, resolves and checks: syntax trees of all files → checked tree, layout, initial image and diagnostics. Also
// the side tables the editor asks (what a name means, what type an expression has). One thread builds; the result is
// immutable.
#pragma once
#include "runtime/compiler/parse/syntax.h"
#include "runtime/compiler/tree/tree.h"
#include "runtime/diagnostics/diagnostic.h"

#include <functional>
#include <memory>
#include <string>
#include <unordered_set>

namespace plc::sema {

enum class SymbolKind : uint8_t {
    Variable,
    Constant,
    Enumerator,
    Type,
    Function,
    FunctionBlock,
    Program,
    Method,
    Property,
    Action,
    Interface,
    Namespace,
    Task,
    Label,
    Step,
    StandardFunction,
    GlobalList
};

/// What a name stands for; the editor's go to definition, hover, rename and colours.
struct Symbol {
    SymbolKind kind = SymbolKind::Variable;
    std::string name;        // first spelling
    std::string owner;       // qualified name of the POU or type it belongs to, "" = global
    SourceRange declaration; // the name in its declaration; file none for the standard's
    types::TypeId type;
    types::FieldSection section = types::FieldSection::Local;
    std::string comment;
    std::string path; // image path when there is exactly one ("Main.x"), else relative to the instance ("x")
    bool isConstant = false;
};
using SymbolId = Id<struct SymbolTag>;

struct Reference {
    SourceRange range;
    SymbolId symbol;
    bool isWrite = false;
    bool isRead = false;
};

/// The result of checking one whole program.
struct Analysis {
    std::vector<std::shared_ptr<const syntax::SyntaxFile>> files; // keeps names and ranges alive
    std::shared_ptr<tree::Program> program;                       // complete only without errors
    std::vector<Symbol> symbols;
    std::vector<Reference> references; // in order of place, project files only
    std::vector<diagnostics::Diagnostic> diagnostics;
    bool hasErrors = false;
    std::shared_ptr<const void> scopes; // name tables, for expressions and completion (sema/scopes.h)
};

struct Options {
    bool strict = false;                           // dialect features of the books warn
    std::unordered_set<std::string> usedElsewhere; // folded names that panels, traces, tests use; ".name": behind a dot
    image::Addressing addressing = image::Addressing::Bytes;
    uint32_t memoryForNew = 0; // bytes for __NEW; 0: there is none
    types::StringCode strings = types::StringCode::Latin1;
    bool wantProgram = true; // false: check only (no bodies of the tree are kept)
};

/// Checks everything together. Library files carry their namespace in SyntaxFile::library.
[[nodiscard]] std::shared_ptr<const Analysis> analyze(const SourceSet& sources,
                                                      std::vector<std::shared_ptr<const syntax::SyntaxFile>> files,
                                                      std::vector<diagnostics::Diagnostic> syntaxDiagnostics,
                                                      const Options& options);

/// Checks one expression as seen from `scope` (a POU instance path such as "Main.pid", or "" = top). Nodes go into
/// `arena`. Instance-relative places are made absolute. Null with diagnostics when it is wrong or has side effects.
struct CheckedExpression {
    tree::Expr* root = nullptr;
    std::vector<diagnostics::Diagnostic> diagnostics;
};
[[nodiscard]] CheckedExpression checkExpression(const Analysis& analysis, const SourceSet& sources,
                                                std::string_view text, std::string_view scope, Arena& arena);

} // namespace plc::sema
