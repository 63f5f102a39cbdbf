// The model of ladder and function block diagrams over the text (D4, D14): the statements of one ST body as rungs,
// their expressions as contacts, wires, boxes and coils. Total: what has no picture is a text in its place. A
// projection of a syntax tree and its text, which must outlive it; built by one thread, then immutable.
#pragma once
#include "runtime/compiler/ladder/declared_types.h"
#include "runtime/compiler/ladder/units.h"

#include <array>

namespace plc::ladder {

using NodeId = Id<struct NodeTag>;
using RungId = Id<struct RungTag>;

enum class Form : uint8_t { Ladder, Blocks };

enum class NodeKind : uint8_t {
    Contact,  // a Boolean operand, or an expression that has no picture of its own
    Compare,  // two operands, the operator between them
    Edge,     // R_TRIG or F_TRIG called just before, its Q used here: the contact shows what it watches
    Series,   // AND
    Parallel, // OR
    Invert,   // NOT of what is to its left
    Box,      // operator, function or block
    Operand,  // at a pin
    Coil,
    Jump,
    Return,
    Exit,
    Continue,
};
enum class CoilKind : uint8_t { Normal, Negated, Set, Reset };

struct Pin {
    std::string name; // empty: an operator's
    NodeId node;      // none: power, or left open
    bool negated = false;
    SourceRange range;    // of the argument
    bool isPower = false; // the wire that comes from the left
};
struct OutputPin {
    std::string name;
    std::string target; // what is written; empty: nothing, or the wire that goes on
    bool negated = false;
    bool isFlow = false; // the wire that goes on to the right
    SourceRange range;
    SourceRange source{}; // of the expression whose value is written
};

struct Node {
    NodeKind kind = NodeKind::Contact;
    const syntax::Expr* expr = nullptr; // all of it, with NOT and parentheses; null: made from a statement
    const syntax::Expr* operand =
        nullptr; // Contact: without NOT and parentheses; Compare: the left one; Coil: the target
    const syntax::Expr* right = nullptr; // Compare
    const syntax::Stmt* stmt = nullptr;  // Coil, Jump, Return, a block's call, Edge: the call
    SourceRange range;
    bool negated = false;
    bool isShort = false;         // AND_THEN, OR_ELSE: drawn as double lines
    bool isFalling = false;       // Edge
    bool isFeedback = false;      // reads what this rung or a later one writes: the value of the scan before
    bool isFeedbackBelow = false; // Compare: so does its right operand
    bool isTemporary = false;     // reads a VAR_TEMP: a result that was kept for use further down
    bool isConditional = false;   // Coil: written as IF … THEN y := TRUE; END_IF
    CoilKind coil = CoilKind::Normal;
    std::string address, comment; // of the variable, as it is declared; empty: none
    std::string label;            // operand, title of a box, target of a jump
    std::string op;               // Compare
    std::string below;            // Compare: the right operand
    std::string instance;         // Box: of a block; Edge
    std::vector<NodeId> children; // Series, Parallel, Invert
    std::vector<Pin> inputs;
    std::vector<OutputPin> outputs;
    int order = 0; // Box: when it is executed, from 1
};

enum class RungKind : uint8_t {
    Logic,
    Text,    // ST without a picture
    Head,    // of a frame: IF, ELSIF, ELSE, CASE, a label of it, FOR, WHILE, REPEAT
    Tail,    // END_IF …, UNTIL
    Label,   // of a jump
    Comment, // below the last statement of a block
};

/// From where the power branches: more contacts, then what it drives.
struct Branch {
    NodeId tail; // may be none
    NodeId output;
};

struct Rung {
    RungKind kind = RungKind::Logic;
    int depth = 0;
    std::vector<const syntax::Stmt*> statements; // in order of the text; of Head and Tail the one they belong to
    SourceRange range;                           // of the statements; Head: up to THEN, OF, DO
    SourceRange comment;                         // the comment lines above; empty without one
    SourceRange trailing;                        // the comment behind, on the last line
    std::string note;                            // what both say, without markers
    std::string title;                           // {network 'title'} above
    NodeId power;                                // none: straight from the rail
    std::vector<Branch> branches;
    std::string text; // Text, Head, Tail, Label
};

/// How the statements of a body are drawn; nested ones are counted, too.
struct Share {
    size_t drawn = 0;  // contacts, coils, boxes, jumps
    size_t framed = 0; // IF, CASE, FOR, WHILE, REPEAT around drawn rungs
    size_t text = 0;   // ST boxes
    [[nodiscard]] size_t total() const { return drawn + framed + text; }
    Share& operator+=(const Share& other);
};

struct Diagram {
    Form form = Form::Ladder;
    std::vector<Node> nodes;
    std::vector<Rung> rungs;
    Share share;

    [[nodiscard]] const Node& operator[](NodeId id) const { return nodes[id.index()]; }
    [[nodiscard]] const Rung& operator[](RungId id) const { return rungs[id.index()]; }
    /// The smallest part drawn at a place of the text, and its rung; none where there is none.
    [[nodiscard]] NodeId nodeAt(uint32_t offset) const;
    [[nodiscard]] RungId rungAt(uint32_t offset) const;
    /// Every node of a rung, children before their parents.
    [[nodiscard]] std::vector<NodeId> nodesOf(const Rung& rung) const;
};

/// `text` and `file` belong together; `unit` is one of the file's.
[[nodiscard]] Diagram project(std::string_view text, const syntax::SyntaxFile& file, const Unit& unit,
                              const DeclaredTypes& types, Form form);

/// What a picture shows, in one line each: tests compare it before and after an edit.
[[nodiscard]] std::string describe(const Diagram& diagram);

} // namespace plc::ladder
