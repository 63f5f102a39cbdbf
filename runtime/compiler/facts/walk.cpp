#include "runtime/compiler/facts/walk.h"

namespace plc::facts {

using tree::Expr;
using tree::Place;
using tree::PlaceKind;
using tree::Stmt;

void Walker::walkFunction(const tree::Function& function) {
    for (const tree::Local& local : function.locals) walk(local.initial);
    walkBody(function.body);
}

void Walker::walkBody(const std::vector<Stmt*>& body) {
    for (const Stmt* stmt : body)
        if (stmt) walk(*stmt);
}

/// A row of ELSIFs is a chain of IFs, each in the ELSE of the one before; it may be as long as it likes, so it is
/// walked without recursion.
void Walker::walk(const Stmt& first) {
    if (!elseIf(first)) {
        walkParts(first);
        walkBody(first.elseBody);
        afterStmt(first);
        return;
    }
    std::vector<const Stmt*> row;
    for (const Stmt* stmt = &first; stmt; stmt = elseIf(*stmt)) {
        walkParts(*stmt);
        row.push_back(stmt);
    }
    walkBody(row.back()->elseBody);
    for (auto stmt = row.rbegin(); stmt != row.rend(); ++stmt) afterStmt(**stmt);
}

/// All but the ELSE branch.
void Walker::walkParts(const Stmt& stmt) {
    onStmt(stmt);
    walk(stmt.a);
    walk(stmt.b);
    walk(stmt.c);
    if (stmt.place) walk(stmt.place, Use::Write);
    if (stmt.target) walk(stmt.target, Use::Address);
    walkBody(stmt.body);
    for (const tree::CaseArm& arm : stmt.arms) walkBody(arm.body);
}

void Walker::walk(const Expr* expr) {
    if (!expr) return;
    onExpr(*expr);
    if (expr->place) {
        const bool escapes = expr->kind == tree::ExprKind::AddressOf || expr->kind == tree::ExprKind::InterfaceOf;
        walk(expr->place, escapes ? Use::Address : Use::Read);
    }
    walk(expr->a);
    walk(expr->b);
    walk(expr->c);
    for (const Expr* operand : expr->operands) walk(operand);
    if (expr->ok) walk(expr->ok, Use::Write);
    walkBody(expr->statements);
    if (const tree::Call* call = expr->call) {
        if (call->instance) walk(call->instance, Use::Address);
        walk(call->interface);
        for (const tree::CallArgument& argument : call->arguments) {
            walk(argument.value);
            if (argument.place)
                walk(argument.place, argument.mode == tree::ArgumentMode::InOut ? Use::Address : Use::Write);
        }
    }
}

void Walker::walk(const Place* place, Use use) {
    if (!place) return;
    onPlace(*place, use);
    for (const Place* p = place; p; p = p->base) {
        for (const Expr* index : p->indices) walk(index);
        walk(p->pointer);
        walk(p->value);
    }
}

const Stmt* elseIf(const Stmt& stmt) {
    if (stmt.kind != tree::StmtKind::If || stmt.elseBody.size() != 1) return nullptr;
    const Stmt* other = stmt.elseBody[0];
    return other && other->kind == tree::StmtKind::If ? other : nullptr;
}

const Place& rootOf(const Place& place) {
    const Place* p = &place;
    while (p->base && p->kind != PlaceKind::InOutSlot) p = p->base;
    return *p;
}

namespace {
class EffectFinder : public Walker {
public:
    bool found = false;

protected:
    void onStmt(const Stmt&) override { found = true; }
    void onExpr(const Expr& expr) override {
        if (expr.kind == tree::ExprKind::Call || expr.ok) found = true;
    }
};
} // namespace

bool hasEffects(const Expr* expr) {
    EffectFinder finder;
    finder.walk(expr);
    return finder.found;
}

bool hasEffects(const Place* place) {
    EffectFinder finder;
    finder.walk(place, Use::Read);
    return finder.found;
}

} // namespace plc::facts
