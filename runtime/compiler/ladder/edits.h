// Edits of a ladder or function block diagram as replacements in its text, minimal and byte preserving: comments,
// parentheses and the order of operands stay as they are. Pure functions over a text, the tree parsed from it and its
// diagram; any thread.
#pragma once
#include "runtime/base/result.h"
#include "runtime/compiler/ladder/diagram.h"
#include "runtime/diagnostics/text_edits.h"

#include <functional>

namespace plc::ladder {

using diagnostics::applyEdits;
using diagnostics::Edits;
using diagnostics::inverseOf;
using diagnostics::TextEdit;

enum class Place : uint8_t { Before, After };

class LadderEditor {
public:
    LadderEditor(std::string_view text, const syntax::SyntaxFile& file, const Unit& unit, const Diagram& diagram,
                 const DeclaredTypes& types);

    // contacts; `operand` is any Boolean expression: x, NOT x, a > b
    /// In series with a contact, on its left or right.
    [[nodiscard]] Result<Edits> insertContact(NodeId beside, Place place, std::string_view operand) const;
    /// In parallel with a contact, a series or a whole parallel.
    [[nodiscard]] Result<Edits> insertParallel(NodeId with, std::string_view operand) const;
    /// The last contact before the outputs; the only one when the rung comes straight from the rail.
    [[nodiscard]] Result<Edits> appendContact(RungId rung, std::string_view operand) const;
    /// To another place of the same or another rung: beside a contact, or behind a rung's last one.
    [[nodiscard]] Result<Edits> moveContact(NodeId node, NodeId beside, Place place) const;
    [[nodiscard]] Result<Edits> moveContact(NodeId node, RungId rung) const;
    /// Contact, coil or output; the last output takes its rung with it.
    [[nodiscard]] Result<Edits> remove(NodeId node) const;
    [[nodiscard]] Result<Edits> negate(NodeId node) const;
    /// Of a contact, comparison, edge, coil or pin.
    [[nodiscard]] Result<Edits> setOperand(NodeId node, std::string_view operand) const;
    [[nodiscard]] Result<Edits> setCoil(NodeId coil, CoilKind kind) const;
    [[nodiscard]] Result<Edits> addCoil(RungId rung, std::string_view target) const;
    /// A call of `instance` between the power of a rung and what it drives; declared as `type` when it is new.
    [[nodiscard]] Result<Edits> insertBlock(RungId rung, std::string_view instance, std::string_view type) const;

    // rungs
    /// `statement` with its semicolon; none for `beside`: the only rung of an empty body.
    [[nodiscard]] Result<Edits> insertRung(RungId beside, Place place, std::string_view statement) const;
    [[nodiscard]] Result<Edits> removeRung(RungId rung) const;
    /// Within the same block of statements.
    [[nodiscard]] Result<Edits> moveRung(RungId rung, Place place, RungId anchor) const;
    /// The comment above; empty removes it.
    [[nodiscard]] Result<Edits> setComment(RungId rung, std::string_view comment) const;
    /// The text of an ST box.
    [[nodiscard]] Result<Edits> setText(RungId rung, std::string_view statements) const;

    /// A declaration in the unit's VAR; none when the name is declared.
    [[nodiscard]] Edits declare(std::string_view name, std::string_view type) const;
    /// The words of a rung's power: "a AND b"; "TRUE" when it comes straight from the rail.
    [[nodiscard]] std::string powerText(RungId rung) const;
    [[nodiscard]] RungId rungOf(NodeId node) const;

private:
    struct Operand {
        std::string text;
        int level = 9; // of precedence: 1 OR … 8 **, 9 anything tighter
        bool isPlace = false;
    };
    /// In series with the expressions that have exactly these texts.
    [[nodiscard]] Result<Edits> insertAt(const std::vector<SourceRange>& places, Place place,
                                         const std::string& operand) const;
    using Insert =
        std::function<Result<Edits>(const LadderEditor& left, const Edits& removed, const std::string& operand)>;
    /// Takes it away, then inserts it into what is left.
    [[nodiscard]] Result<Edits> moveWith(NodeId node, const Insert& insert) const;
    [[nodiscard]] Result<Operand> parsed(std::string_view operand) const;
    [[nodiscard]] static std::string fitted(const Operand& operand, int level);
    [[nodiscard]] std::string slice(SourceRange range) const {
        return std::string(m_text.substr(range.begin, range.length()));
    }
    [[nodiscard]] std::string lineEnd() const;
    [[nodiscard]] std::string indentOf(uint32_t at) const;
    [[nodiscard]] uint32_t lineBegin(uint32_t at) const;
    [[nodiscard]] uint32_t lineBehind(uint32_t at) const;
    /// Whole lines with the comment above and the rest of the last line, when nothing else is written there.
    [[nodiscard]] SourceRange extentOf(const Rung& rung) const;
    [[nodiscard]] SourceRange statementLines(SourceRange range) const;
    [[nodiscard]] const syntax::Expr* parentOf(const syntax::Expr& expr, const Rung& rung) const;
    /// `expr` and the same expression of the rung's other statements when they share their contacts.
    [[nodiscard]] std::vector<const syntax::Expr*> sameIn(const Rung& rung, NodeId node) const;
    [[nodiscard]] Edits removal(const syntax::Expr& expr, const Rung& rung) const;
    [[nodiscard]] TextEdit combined(const syntax::Expr& expr, const Rung& rung, const Operand& operand, int level,
                                    Place place) const;
    [[nodiscard]] Result<Edits> setConditionalCoil(const Rung& rung, const Node& node, CoilKind kind) const;
    [[nodiscard]] Result<Edits> removeOutput(NodeId node) const;
    [[nodiscard]] bool writesItsPower(const Rung& rung, const std::string& power) const;
    [[nodiscard]] const syntax::Stmt* firstWithPower(const Rung& rung) const;
    [[nodiscard]] const syntax::Expr* powerOf(const syntax::Stmt& stmt) const;
    [[nodiscard]] static Result<Edits> finish(Edits edits);

    std::string_view m_text;
    const syntax::SyntaxFile& m_file;
    const Unit& m_unit;
    const Diagram& m_diagram;
    const DeclaredTypes& m_types;
};

} // namespace plc::ladder
