// Visits every statement, expression and place of a checked tree in one fixed order (sites are numbered in it).
// Owned by the pass that derives from it; one thread.
#pragma once
#include "runtime/compiler/tree/tree.h"

namespace plc::facts {

/// What happens to the storage a place names. Address: it escapes (IN_OUT, reference, THIS of a call).
enum class Use : uint8_t { Read, Write, Address };

class Walker {
public:
    virtual ~Walker() = default;
    void walkFunction(const tree::Function& function);
    void walkBody(const std::vector<tree::Stmt*>& body);
    void walk(const tree::Stmt& stmt);
    void walk(const tree::Expr* expr);
    void walk(const tree::Place* place, Use use);

protected:
    virtual void onStmt(const tree::Stmt&) {}
    virtual void onExpr(const tree::Expr&) {}
    virtual void onPlace(const tree::Place&, Use) {}
    virtual void afterStmt(const tree::Stmt&) {}

private:
    void walkParts(const tree::Stmt& stmt);
};

/// The IF that alone is the ELSE branch of an IF, as ELSIF is in the checked tree; else null.
[[nodiscard]] const tree::Stmt* elseIf(const tree::Stmt& stmt);

/// The innermost base: Absolute, Instance, Local, InOutSlot, Deref or Temporary.
[[nodiscard]] const tree::Place& rootOf(const tree::Place& place);
/// Whether evaluating has effects beyond its value: calls or statements inside.
[[nodiscard]] bool hasEffects(const tree::Expr* expr);
[[nodiscard]] bool hasEffects(const tree::Place* place);

} // namespace plc::facts
