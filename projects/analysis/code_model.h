// What the editor asks about a project's text: colours, hover, definition, references, completion, rename. Made from
// one check of all files; an immutable value, so the window reads it while the worker makes the next one (D3, flow 1).
#pragma once
#include "projects/analysis/instruction_lists.h"
#include "runtime/base/result.h"
#include "runtime/compiler/driver/driver.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace plc::analysis {

/// What the editor colours.
enum class TokenClass : uint8_t {
    Plain,
    Keyword,
    Type,
    Number,
    Text,
    Comment,
    Pragma,
    Operator,
    Constant,
    EnumValue,
    Input,
    Output,
    InOut,
    Local,
    Global,
    Instance,
    Function,
    Label,
    Address,
    Step,
    Error
};
struct ColouredToken {
    uint32_t begin = 0, end = 0;
    TokenClass kind = TokenClass::Plain;
};

enum class ItemKind : uint8_t {
    Keyword,
    Snippet,
    Variable,
    Constant,
    EnumValue,
    Type,
    Function,
    Block,
    Program,
    Method,
    Property,
    Parameter,
    Namespace
};
struct CompletionItem {
    std::string text;   // what is inserted; a snippet holds | where the cursor goes
    std::string detail; // type or parameters
    std::string comment;
    ItemKind kind = ItemKind::Variable;
    int rank = 0; // lower first
};
struct Completion {
    uint32_t replaceBegin = 0, replaceEnd = 0; // the word being typed
    std::vector<CompletionItem> items;         // by rank, then name
};

struct ParameterHelp {
    std::string callee;
    struct Parameter {
        std::string name, type, comment;
        types::FieldSection section = types::FieldSection::Input;
        bool isGiven = false;
    };
    std::vector<Parameter> parameters;
    size_t current = 0;
};

struct Hover {
    SourceRange range;
    std::string declaration; // "Speed : REAL" with its section
    std::string comment;
    std::string path; // to show the live value; relative to the POU when `isRelative`
    bool isRelative = false;
    std::string pou; // POU the place lies in
};

struct OutlineItem {
    std::string name, detail, comment;
    sema::SymbolKind kind = sema::SymbolKind::Program;
    SourceRange range, nameRange;
    bool isSimulation = false, isTest = false;
    bool isHidden = false; // {attribute 'hide'}
    std::vector<OutlineItem> children;
};

struct Use {
    SourceRange range;
    bool isWrite = false, isRead = false, isDeclaration = false;
};

struct FileEdits {
    FileId file;
    std::vector<diagnostics::TextEdit> edits; // by place, not overlapping
};

class CodeModel {
public:
    [[nodiscard]] static std::shared_ptr<const CodeModel> make(const driver::BuildInput& input, uint64_t revision = 0);
    /// As make; reads only the files that changed since `kept` was used last.
    [[nodiscard]] static std::shared_ptr<const CodeModel> make(const driver::BuildInput& input, uint64_t revision,
                                                               driver::KeptFiles& kept);

    [[nodiscard]] uint64_t revision() const { return m_revision; }
    [[nodiscard]] const driver::Checked& checked() const { return m_checked; }
    [[nodiscard]] const SourceSet& sources() const { return *m_checked.sources; }
    [[nodiscard]] const std::vector<diagnostics::Diagnostic>& diagnostics() const {
        return m_checked.analysis->diagnostics;
    }
    [[nodiscard]] std::optional<FileId> fileOf(std::string_view path) const;

    [[nodiscard]] std::vector<ColouredToken> colours(FileId file) const;
    /// Where the lines of instruction lists keep their current result; names are those of the unit at the place.
    [[nodiscard]] std::vector<AccumulatorPlace> accumulators(FileId file) const;
    [[nodiscard]] std::optional<Hover> hover(FileId file, uint32_t offset) const;
    [[nodiscard]] std::optional<SourceRange> definition(FileId file, uint32_t offset) const;
    /// Declaration and every use of what stands at `offset`, in order of place.
    [[nodiscard]] std::vector<Use> uses(FileId file, uint32_t offset) const;
    [[nodiscard]] std::optional<sema::SymbolId> symbolAt(FileId file, uint32_t offset,
                                                         SourceRange* range = nullptr) const;
    [[nodiscard]] const sema::Symbol& symbol(sema::SymbolId id) const {
        return m_checked.analysis->symbols[id.index()];
    }
    /// Edits in every file; refuses keywords, invalid names, names that exist in the scope, and library names.
    [[nodiscard]] Result<std::vector<FileEdits>> rename(FileId file, uint32_t offset, std::string_view newName) const;
    /// Takes the unit whose name begins at `offset` out, with the comments and pragmas directly above it; what refers
    /// to it becomes a comment when wanted: the statement, the declaration, never half of one.
    [[nodiscard]] std::vector<FileEdits> removal(FileId file, uint32_t offset, bool commentsOutUses) const;
    [[nodiscard]] std::vector<OutlineItem> outline(FileId file) const;
    [[nodiscard]] Completion complete(FileId file, std::string_view text, uint32_t offset) const;
    /// For watches and bindings: paths from the top.
    [[nodiscard]] Completion completePath(std::string_view text, uint32_t offset) const;
    [[nodiscard]] std::optional<ParameterHelp> parameterHelp(FileId file, std::string_view text, uint32_t offset) const;
    /// The POU (qualified name: "Motor", "Motor.Start") around a place; empty outside.
    [[nodiscard]] std::string pouAt(FileId file, uint32_t offset) const;
    /// Declares `name` in a section of the POU at `offset` with the type that its use suggests; Global: in the first
    /// list of the project's globals.
    [[nodiscard]] std::optional<diagnostics::TextEdit>
    autoDeclare(FileId file, uint32_t offset, std::string_view name,
                syntax::SectionKind section = syntax::SectionKind::Var) const;
    /// Declares the member `name` in a unit of the project: an input of a block or program, a field of a structure.
    [[nodiscard]] std::optional<diagnostics::TextEdit>
    declareMember(FileId file, uint32_t offset, std::string_view owner, std::string_view name) const;

private:
    [[nodiscard]] const sema::Symbol* findVisible(std::string_view name, const std::string& pou) const;
    [[nodiscard]] std::optional<types::TypeId> typeOfChain(const std::vector<std::string>& names,
                                                           const std::string& pou) const;
    [[nodiscard]] std::string suggestedType(FileId file, uint32_t offset) const;
    void addMembers(types::TypeId type, std::vector<CompletionItem>& items) const;
    void addScope(const std::string& pou, std::vector<CompletionItem>& items) const;
    void addWords(std::vector<CompletionItem>& items) const;
    void addTestWords(const std::string& pou, std::vector<CompletionItem>& items) const;

    uint64_t m_revision = 0;
    driver::Checked m_checked;
    std::unordered_map<std::string, std::vector<uint32_t>> m_byOwner; // folded owner → symbols
    std::unordered_map<std::string, std::vector<uint32_t>> m_byName;  // folded name → symbols
    std::vector<bool> m_isHidden;                      // symbol: a library's {attribute 'hide'}, not offered
    std::vector<std::vector<uint32_t>> m_referencesOf; // symbol → references
};

} // namespace plc::analysis
