// Turns the statements and expressions of one body into a diagram's rungs and nodes. Lives for one projection.
#pragma once
#include "runtime/compiler/ladder/diagram.h"

#include <optional>

namespace plc::ladder {

class Projector {
public:
    Projector(std::string_view text, const syntax::SyntaxFile& file, const Unit& unit, const DeclaredTypes& types,
              Form form);
    [[nodiscard]] Diagram run();

private:
    /// A block that was called just before: the statement that begins with one of its outputs continues its rung.
    struct Waiting {
        NodeId box;           // gets the output pin
        NodeId chain;         // with what stands before it
        std::string instance; // folded, without blanks
        bool isUsed = false;
    };
    struct Watched { // an edge detector that was called just before
        const syntax::Stmt* call = nullptr;
        const syntax::Expr* clock = nullptr;
        std::string output; // "trig.q", folded
        bool isFalling = false;
        bool isUsed = false;
    };

    // frames, comments, text (projector_frames.cpp)
    void block(const syntax::Block& block, int depth, uint32_t begin, uint32_t end);
    size_t logicRung(const syntax::Block& block, size_t at, int depth);
    void frame(const syntax::Stmt& stmt, int depth);
    void ifFrame(const syntax::Stmt& stmt, int depth);
    void caseFrame(const syntax::Stmt& stmt, int depth);
    void head(const syntax::Stmt& stmt, int depth, std::string text, SourceRange range, const syntax::Expr* condition);
    void tail(const syntax::Stmt& stmt, int depth, std::string text, const syntax::Expr* condition = nullptr);
    void textRung(const syntax::Stmt& stmt, int depth);
    void closingComment(uint32_t begin, uint32_t end, int depth);
    Rung& addRung(RungKind kind, int depth);
    void annotate(Rung& rung, uint32_t floor);
    [[nodiscard]] bool isSimpleIf(const syntax::Stmt& stmt) const;
    [[nodiscard]] bool isLogic(const syntax::Stmt& stmt) const;
    [[nodiscard]] bool isInstanceCall(const syntax::Stmt& stmt) const;
    [[nodiscard]] bool areNeighbours(const syntax::Stmt& first, const syntax::Stmt& second) const;
    [[nodiscard]] bool hasComments(uint32_t begin, uint32_t end) const;
    void takeEdges(const syntax::Block& block, size_t& at, Rung& rung);
    [[nodiscard]] bool usesOutput(const syntax::Stmt& stmt, const std::string& output) const;
    [[nodiscard]] const syntax::Expr* powerOf(const syntax::Stmt& stmt) const;
    [[nodiscard]] bool beginsWithWaiting(const syntax::Stmt& stmt) const;
    void fill(Rung& rung, const syntax::Stmt& stmt);
    bool joins(Rung& rung, const syntax::Stmt& stmt);
    [[nodiscard]] bool writesInto(const std::vector<const syntax::Stmt*>& statements, const std::string& reads) const;

    // outputs (projector_outputs.cpp)
    [[nodiscard]] bool isBoolAssignment(const syntax::Stmt& stmt) const;
    void outputsOf(const syntax::Stmt& stmt, std::vector<Branch>& out, bool hasPower);
    void coils(const syntax::Stmt& stmt, std::vector<Branch>& out);
    [[nodiscard]] NodeId conditionalCoil(const syntax::Stmt& stmt, bool value);
    [[nodiscard]] NodeId assignBox(const syntax::Stmt& stmt, bool hasPower);
    [[nodiscard]] NodeId callBox(const syntax::Expr& call, const syntax::Stmt* stmt, bool hasPower);
    void addArguments(Node& box, const syntax::Expr& call, const syntax::Pou* callee, const syntax::Expr* power);
    [[nodiscard]] const syntax::Expr* powerArgument(const syntax::Expr& call) const;
    [[nodiscard]] bool isPowerFormal(const syntax::Expr& call, const syntax::Argument& argument, size_t index) const;
    [[nodiscard]] NodeId control(const syntax::Stmt& stmt);

    // expressions (projector_expressions.cpp)
    [[nodiscard]] NodeId power(const syntax::Expr& expr);
    [[nodiscard]] NodeId logic(const syntax::Expr& expr, bool atRail, bool isFirst);
    [[nodiscard]] NodeId chain(const syntax::Expr& expr, NodeKind kind, bool atRail, bool isFirst);
    [[nodiscard]] NodeId notOf(const syntax::Expr& expr, bool atRail);
    [[nodiscard]] NodeId compare(const syntax::Expr& expr);
    [[nodiscard]] NodeId contact(const syntax::Expr& expr, const syntax::Expr& operand, bool negated);
    [[nodiscard]] NodeId edgeContact(const syntax::Expr& expr, Watched& watched, bool negated);
    [[nodiscard]] NodeId value(const syntax::Expr& expr);
    [[nodiscard]] NodeId operatorBox(const syntax::Expr& expr);
    [[nodiscard]] NodeId operandNode(const syntax::Expr& expr, const syntax::Expr& operand, bool negated);
    [[nodiscard]] NodeId pinValue(const syntax::Expr& expr);
    [[nodiscard]] NodeId takeWaiting(const syntax::Expr& leaf);
    [[nodiscard]] Watched* watchedBy(const syntax::Expr& leaf);

    /// By rung.
    void numberBoxes(const std::vector<std::vector<NodeId>>& nodes);
    void markReads(const std::vector<std::vector<NodeId>>& nodes);
    void describeVariables();

    [[nodiscard]] NodeId add(Node node);
    [[nodiscard]] std::string slice(SourceRange range) const;
    [[nodiscard]] std::string plain(const syntax::Expr& expr) const; // one line, without its parentheses
    [[nodiscard]] std::string folded(SourceRange range) const;       // in one spelling: for comparison

    std::string_view m_text;
    const syntax::SyntaxFile& m_file;
    const Unit& m_unit;
    const DeclaredTypes& m_types;
    DeclaredTypes::Scope m_scope;
    Diagram m_diagram;
    std::optional<Waiting> m_waiting;
    std::vector<Watched> m_watched;
    std::vector<const syntax::Expr*> m_prefix; // the contacts behind which a rung's outputs branch
    bool m_isShared = false;                   // several outputs stand behind all of m_prefix
    uint32_t m_floor = 0;                      // where the text of the next rung may begin: behind the statement before
};

/// Without parentheses around all of it.
[[nodiscard]] std::string unparenthesised(std::string text);
[[nodiscard]] bool isLeaf(const syntax::Expr& expr);
[[nodiscard]] inline bool isNot(const syntax::Expr& expr) {
    return expr.kind == syntax::ExprKind::Unary && expr.op == lex::TokenKind::Not;
}
/// The operands of AND in order; anything else is its only part.
void andParts(const syntax::Expr& expr, std::vector<const syntax::Expr*>& out);
/// The text between the parentheses around an expression; all of it without them.
[[nodiscard]] SourceRange innerRange(const syntax::Expr& expr, std::string_view text);
/// With those inside them; empty ones do not count.
[[nodiscard]] size_t countStatements(const syntax::Stmt& stmt);
[[nodiscard]] size_t countStatements(const syntax::Block& block);

} // namespace plc::ladder
