// Expressions of a diagram while it is read: conjunctions and disjunctions that share a common beginning are written
// once, everything else is text with its precedence. Values, any thread.
#pragma once
#include <string>
#include <vector>

namespace plc::exchange {

class Flow {
public:
    /// Precedence of the text's outermost operator, as in ST: 1 OR … 8 unary; 9: a name, a literal or a call.
    enum Level : int {
        kUnknown = 0,
        kOr = 1,
        kXor = 2,
        kAnd = 3,
        kEqual = 4,
        kLess = 5,
        kSum = 6,
        kProduct = 7,
        kUnary = 8,
        kPrimary = 9
    };

    Flow() = default;
    Flow(std::string text, int level) : m_text(std::move(text)), m_level(level) {}
    /// Text that a user wrote: in parentheses unless it is a name, a literal or a call.
    [[nodiscard]] static Flow ofUser(std::string text);
    [[nodiscard]] static Flow yes() { return {"TRUE", kPrimary}; }

    [[nodiscard]] bool isEmpty() const { return m_parts.empty() && m_text.empty(); }
    [[nodiscard]] bool isTrue() const { return m_parts.empty() && m_text == "TRUE"; }
    [[nodiscard]] int level() const { return m_level; }
    [[nodiscard]] std::string text() const;
    /// The text as an operand of an operator of that level.
    [[nodiscard]] std::string operand(int level) const;

    [[nodiscard]] static Flow both(const Flow& a, const Flow& b);
    [[nodiscard]] static Flow any(const std::vector<Flow>& all);
    [[nodiscard]] Flow negated() const;

private:
    [[nodiscard]] std::vector<Flow> factors() const;
    [[nodiscard]] static Flow joined(std::vector<Flow> parts, int level);
    std::string m_text;
    int m_level = kPrimary;
    std::vector<Flow> m_parts; // of AND and OR
};

} // namespace plc::exchange
