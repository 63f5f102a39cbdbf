// Where each statement lies in its function: what decides whether it runs. Made once for a program; immutable.
#pragma once
#include "runtime/compiler/tree/tree.h"

#include <unordered_map>
#include <unordered_set>

namespace plc::inside {

class StatementMap {
public:
    explicit StatementMap(const tree::Program& tree);

    struct Around {
        const tree::Stmt* parent = nullptr; // IF, CASE, loop or block it lies in; null: the function's body
        const std::vector<tree::Stmt*>* siblings = nullptr;
        uint32_t function = 0;
        int64_t arm = 0; // of IF: 1 then, 0 else; of CASE: its number, -1 else
    };
    [[nodiscard]] const Around* around(const tree::Stmt& stmt) const;
    /// Statements that assign, by function.
    [[nodiscard]] const std::vector<const tree::Stmt*>& assignments(uint32_t function) const {
        return m_assignments[function];
    }
    /// IF and CASE statements, by function.
    [[nodiscard]] const std::vector<const tree::Stmt*>& branches(uint32_t function) const {
        return m_branches[function];
    }
    /// Whether anything in these statements calls a function.
    [[nodiscard]] bool calls(const std::vector<tree::Stmt*>& body) const;
    /// IF and CASE statements of a function that may leave it (RETURN) or its loop.
    [[nodiscard]] bool mayLeave(const tree::Stmt& stmt) const;

private:
    void add(const std::vector<tree::Stmt*>& body, const tree::Stmt* parent, uint32_t function, int64_t arm);
    void addCalls(const tree::Expr* expr, const tree::Stmt& stmt, uint32_t function);
    std::unordered_map<const tree::Stmt*, Around> m_around;
    std::vector<std::vector<const tree::Stmt*>> m_assignments, m_branches; // by function
    std::unordered_set<const tree::Stmt*> m_callers;
};

} // namespace plc::inside
