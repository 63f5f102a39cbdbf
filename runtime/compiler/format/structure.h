// What the formatter knows of a text beyond its tokens: how deep each place lies, where statements and declarations
// begin, which colons stand behind labels, what must stay as it is. From the syntax tree; one format call, one use.
#pragma once
#include "runtime/compiler/parse/syntax.h"

#include <unordered_set>

namespace plc::format {

class Structure {
public:
    Structure(const syntax::SyntaxFile& file, std::string_view text,
              const std::vector<diagnostics::Diagnostic>& diagnostics);

    [[nodiscard]] int depthAt(uint32_t offset) const;
    [[nodiscard]] bool beginsHere(uint32_t offset) const { return m_begins.contains(offset); }
    [[nodiscard]] bool beginsDeclaration(uint32_t offset) const { return m_declarations.contains(offset); }
    [[nodiscard]] bool isLabelColon(uint32_t offset) const { return m_labelColons.contains(offset); }
    [[nodiscard]] bool isSoftKeyword(uint32_t offset) const { return m_softKeywords.contains(offset); }
    [[nodiscard]] bool isFrozen(uint32_t begin, uint32_t end) const;

private:
    void declarations(const std::vector<syntax::Decl*>& list);
    void unit(const syntax::Pou& pou);
    void property(const syntax::Property& property);
    void action(const syntax::ActionDecl& action);
    void section(const syntax::VarSection& section);
    void variable(const syntax::VarDecl& decl);
    void type(const syntax::TypeSpec* spec);
    void body(const syntax::Body& body);
    void block(const syntax::Block& block);
    void statement(const syntax::Stmt& stmt);
    void chart(const syntax::SfcBody& chart);
    void configuration(const syntax::ConfigurationDecl& configuration);

    void begins(uint32_t offset) { m_begins.insert(offset); }
    void soft(uint32_t offset) { m_softKeywords.insert(offset); }
    /// From behind the first token of `range` to its last word (END_…).
    void inside(SourceRange range);
    void region(uint32_t begin, uint32_t end);
    [[nodiscard]] size_t tokenAt(uint32_t offset) const; // the first that begins at or behind
    [[nodiscard]] size_t lastTokenOf(SourceRange range) const;
    void labelColonBehind(uint32_t offset);
    void softWordsIn(SourceRange range);

    const std::vector<lex::Token>& m_tokens;
    std::string_view m_text;
    std::vector<uint32_t> m_regionBegins, m_regionEnds;
    std::unordered_set<uint32_t> m_begins, m_declarations, m_labelColons, m_softKeywords;
    std::vector<std::pair<uint32_t, uint32_t>> m_frozen;
};

} // namespace plc::format
