// A reference for what an edit means: runs the statements of a body over plain numbers, with changes made to the tree's
// values instead of to the text. Knows nothing of edits as text. One thread.
#pragma once
#include "runtime/base/text.h"
#include "runtime/compiler/ladder/diagram.h"

#include <functional>
#include <map>
#include <string>

namespace plc::ladder {

using State = std::map<std::string, int>;

class Reference {
public:
    explicit Reference(std::string_view text) : m_text(text) {}

    /// A step is a statement of the text, or something that an edit adds.
    using Step = std::function<void(State&)>;
    [[nodiscard]] Step stepOf(const syntax::Stmt& stmt) const {
        return [this, &stmt](State& state) { run(stmt, state); };
    }
    /// The value of this expression passes through `change`.
    std::map<const syntax::Expr*, std::function<int(int, const State&)>> changes;
    /// Of assignments: another coil.
    std::map<const syntax::Stmt*, CoilKind> coils;

    [[nodiscard]] int value(const syntax::Expr& expr, const State& state) const {
        const int plain = valueOf(expr, state);
        const auto change = changes.find(&expr);
        return change == changes.end() ? plain : change->second(plain, state);
    }

    void run(const syntax::Stmt& stmt, State& state) const {
        switch (stmt.kind) {
        case syntax::StmtKind::Assign:
            return assign(stmt, state);
        case syntax::StmtKind::Call: // any block hands its first input on
            state[name(stmt.value->base->range) + ".q"] = value(*stmt.value->arguments[0].value, state);
            return;
        case syntax::StmtKind::If:
            for (const syntax::IfBranch& branch : stmt.branches)
                if (!branch.condition || value(*branch.condition, state)) {
                    for (const syntax::Stmt* inner : branch.body) run(*inner, state);
                    return;
                }
            return;
        default:
            return;
        }
    }

private:
    [[nodiscard]] std::string name(SourceRange range) const {
        return foldCase(m_text.substr(range.begin, range.length()));
    }

    void assign(const syntax::Stmt& stmt, State& state) const {
        int& target = state[name(stmt.target->range)];
        const syntax::Expr* value = stmt.value;
        const auto coil = coils.find(&stmt);
        if (coil == coils.end()) {
            const int v = this->value(*value, state);
            if (stmt.op == lex::TokenKind::Assign) target = v;
            if (stmt.op == lex::TokenKind::SetAssign && v) target = 1;
            if (stmt.op == lex::TokenKind::ResetAssign && v) target = 0;
            return;
        }
        // what the coil asks: without the NOT of a negated one
        const bool negated = stmt.op == lex::TokenKind::Assign && value->kind == syntax::ExprKind::Unary &&
                             value->base->parenthesised && !value->parenthesised;
        const int power = this->value(negated ? *value->base : *value, state);
        if (coil->second == CoilKind::Normal) target = power;
        if (coil->second == CoilKind::Negated) target = !power;
        if (coil->second == CoilKind::Set && power) target = 1;
        if (coil->second == CoilKind::Reset && power) target = 0;
    }

    [[nodiscard]] int valueOf(const syntax::Expr& e, const State& state) const {
        using lex::TokenKind;
        switch (e.kind) {
        case syntax::ExprKind::NameRef:
        case syntax::ExprKind::Member: {
            std::string inner = name(e.range);
            std::erase_if(inner, [](char c) { return c == '(' || c == ')' || c == ' '; });
            const auto at = state.find(inner);
            return at == state.end() ? 0 : at->second;
        }
        case syntax::ExprKind::Literal:
            return e.op == TokenKind::True ? 1 : e.op == TokenKind::False ? 0 : std::stoi(std::string(e.text));
        case syntax::ExprKind::Unary:
            return e.op == TokenKind::Not ? !value(*e.base, state) : -value(*e.base, state);
        case syntax::ExprKind::Binary: {
            const int left = value(*e.base, state), right = value(*e.right, state);
            switch (e.op) {
            case TokenKind::And:
            case TokenKind::AndThen:
                return left && right;
            case TokenKind::Or:
            case TokenKind::OrElse:
                return left || right;
            case TokenKind::Xor:
                return left != right;
            case TokenKind::Greater:
                return left > right;
            case TokenKind::Plus:
                return left + right;
            default:
                return left == right;
            }
        }
        default:
            return 0;
        }
    }

    std::string_view m_text;
};

} // namespace plc::ladder
