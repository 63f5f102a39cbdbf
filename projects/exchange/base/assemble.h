// Puts the pieces of a unit (declaration, body, members) together to the text of a source file, the same way for every
// format that stores them apart. Pure functions, any thread.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace plc::exchange {

enum class PieceKind : uint8_t {
    Program,
    Function,
    FunctionBlock,
    Interface,
    Method,
    Property,
    PropertyGet,
    PropertySet,
    Action,
    Type,
    Globals,
    Unknown
};

struct Piece {
    PieceKind kind = PieceKind::Unknown;
    std::string name;        // of an action, where no declaration says it
    std::string declaration; // "FUNCTION_BLOCK Fb EXTENDS Base\nVAR … END_VAR", comments and pragmas as they were
    std::string body;
    std::vector<Piece> members; // methods, properties, their accessors, actions
};

/// The kind that a declaration's first word says, behind comments, pragmas and blanks.
[[nodiscard]] PieceKind kindOfDeclaration(std::string_view declaration);
/// The unit's name in its declaration; empty when there is none.
[[nodiscard]] std::string nameInDeclaration(std::string_view declaration);
[[nodiscard]] std::string_view keywordOf(PieceKind kind);
[[nodiscard]] bool needsEnd(std::string_view declaration, PieceKind kind);
/// A text as a comment in front of a declaration, ending with a line end; empty for an empty text.
[[nodiscard]] std::string commentLines(const std::string& text, const std::string& indent);
/// Ends with a line end.
[[nodiscard]] std::string assemble(const Piece& piece);

} // namespace plc::exchange
