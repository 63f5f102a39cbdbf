// __TRY … __CATCH … __FINALLY … __ENDTRY of CODESYS: which statements may be in them and what holds behind them.
#include "runtime/compiler/sema/statements/protected.h"

#include "runtime/compiler/sema/names/names.h"
#include "runtime/compiler/sema/names/places.h"
#include "runtime/compiler/sema/statements/statements.h"

namespace plc::sema {

namespace {

enum class Part : uint8_t { Protected, Finally };

/// A protected part runs as a function of its own: nothing jumps into or out of it. And __FINALLY always runs to its
/// end, since a fault may have to go on behind it.
void refuseJumps(Context& context, const syntax::Block& block, Part part) {
    for (const syntax::Stmt* stmt : block) {
        const bool isJump = stmt->kind == syntax::StmtKind::Jump || stmt->kind == syntax::StmtKind::Label;
        const bool isReturn = stmt->kind == syntax::StmtKind::Return && part == Part::Finally;
        if (isJump || isReturn) {
            const char* const word = isReturn ? "RETURN" : stmt->kind == syntax::StmtKind::Jump ? "JMP" : nullptr;
            context.emit(stmt->range, findings::NotAllowedHere(
                                          word ? messages::Thing(Verbatim(word)) : messages::Thing(phrases::ALabel()),
                                          phrases::In(Verbatim(part == Part::Finally ? "__FINALLY" : "__TRY"))));
        }
        refuseJumps(context, stmt->body, part);
        if (stmt->kind == syntax::StmtKind::Try) continue; // reported by itself
        refuseJumps(context, stmt->elseBody, part);
        for (const syntax::IfBranch& branch : stmt->branches) refuseJumps(context, branch.body, part);
        for (const syntax::CaseArm& arm : stmt->arms) refuseJumps(context, arm.body, part);
    }
}

/// The variable that gets the code: an __SYSTEM.ExceptionCode, or a number that holds all of them.
tree::Place* exceptionVariable(Context& context, const syntax::Expr& variable) {
    const Denoted denoted = target(context, variable);
    if (denoted.kind != Denoted::Kind::Place) return nullptr;
    const TypeKind kind = context.types.storageKind(denoted.place->type);
    switch (kind) {
    case TypeKind::Dint:
    case TypeKind::Udint:
    case TypeKind::Dword:
    case TypeKind::Lint:
    case TypeKind::Ulint:
    // Exception codes have 32 bits without a sign; what holds them is accepted.
    case TypeKind::Lword:
        return denoted.place;
    case TypeKind::Unknown:
        return nullptr;
    default:
        context.emit(variable.range, findings::NoExceptionVariable(context.textOf(variable.range)));
        return nullptr;
    }
}

void part(Context& context, const syntax::Block& block, std::vector<tree::Stmt*>& out) {
    refuseJumps(context, block, Part::Protected);
    statements(context, block, out);
}

/// Where __CATCH without a variable puts the code.
tree::Place* unusedCode(Context& context, SourceRange range) {
    const TypeId dword = context.elementary(TypeKind::Dword);
    return localPlace(context, newLocal(context, "code", dword), dword, range);
}

} // namespace

///   ok:    __TRY x := 1 / n; __CATCH(code) x := 0; __FINALLY n := 1; __ENDTRY
///   wrong: __TRY x := 1; __CATCH(text) __ENDTRY  (P2046)   __TRY RETURN; __FINALLY RETURN; __ENDTRY  (P3018)
void tryStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out) {
    constexpr uint32_t kWord = 5; // __TRY
    tree::Stmt* made =
        newStmt(context, tree::StmtKind::Try,
                stmt.range.file.isValid() ? SourceRange{stmt.range.file, stmt.range.begin, stmt.range.begin + kWord}
                                          : stmt.range);
    // A fault may come at any statement, so the handler begins with what held before the protected part.
    const Flow before = context.flow;
    part(context, stmt.branches.front().body, made->body);
    Flow after = context.flow;
    bool isGood = true;
    if (stmt.branches.size() > 1) {
        context.flow = before;
        const syntax::IfBranch& handler = stmt.branches[1];
        made->place =
            handler.condition ? exceptionVariable(context, *handler.condition) : unusedCode(context, stmt.range);
        isGood = made->place != nullptr;
        part(context, handler.body, made->elseBody);
        // After __ENDTRY either part may have run: a result is set if each that can be left has set it.
        after = {after.isReachable || context.flow.isReachable,
                 (after.isResultSet || !after.isReachable) && (context.flow.isResultSet || !context.flow.isReachable)};
    }
    if (stmt.hasElse) {
        context.flow = before;
        // EXIT and CONTINUE are checked as if no loop were around.
        const std::vector<Loop> around = std::exchange(context.loops, {}); // EXIT would leave it
        refuseJumps(context, stmt.elseBody, Part::Finally);
        made->arms.emplace_back();
        statements(context, stmt.elseBody, made->arms.front().body);
        context.loops = around;
        after = {after.isReachable && context.flow.isReachable, after.isResultSet || context.flow.isResultSet};
    }
    context.flow = after;
    if (isGood) out.push_back(made);
}

} // namespace plc::sema
