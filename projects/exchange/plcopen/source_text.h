// Where the parts of a unit are in its source text: what stands above it, its declaration, its body, its members. A
// view of one parsed file, which must outlive it; any thread.
#pragma once
#include "runtime/compiler/parse/syntax.h"

#include <string>

namespace plc::exchange {

struct UnitText {
    std::string declaration; // with the comments and pragmas above, up to the end of the last section
    std::string body;
};

class SourceView {
public:
    SourceView(const syntax::SyntaxFile& file, std::string_view text) : m_file(file), m_text(text) {}

    [[nodiscard]] std::string_view slice(SourceRange range) const {
        return m_text.substr(range.begin, range.end - range.begin);
    }
    /// The text of an expression, a path or a type as written.
    [[nodiscard]] std::string text(const syntax::Expr* expr) const {
        return expr ? std::string(slice(expr->range)) : "";
    }
    /// Where the comments and pragmas above a unit begin; comments behind the code before it stay there.
    [[nodiscard]] uint32_t leadingBegin(uint32_t begin) const;
    /// As leadingBegin, but a comment above a blank line belongs to what is before it.
    [[nodiscard]] uint32_t attachedBegin(uint32_t begin) const;
    /// The end of the line's comments behind `end`, when nothing else is there.
    [[nodiscard]] uint32_t trailingEnd(uint32_t end) const;
    [[nodiscard]] UnitText textOf(const syntax::Pou& pou) const;
    [[nodiscard]] UnitText textOf(const syntax::ActionDecl& action) const;
    [[nodiscard]] std::string declarationOf(const syntax::Property& property) const;
    /// The comments between two bytes that belong to nothing there.
    [[nodiscard]] std::string commentsBetween(uint32_t begin, uint32_t end) const;
    [[nodiscard]] std::string_view all() const { return m_text; }
    [[nodiscard]] const std::vector<lex::Comment>& comments() const { return m_file.tokens.comments; }

private:
    [[nodiscard]] uint32_t endWord(SourceRange range) const; // where END_… of the unit begins
    const syntax::SyntaxFile& m_file;
    std::string_view m_text;
};

} // namespace plc::exchange
