// Statements → checked statements; reachability and "is the result set" are followed on the way.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

tree::Stmt* newStmt(Context& context, tree::StmtKind kind, SourceRange range);
tree::Stmt* assignStmt(Context& context, tree::Place* place, tree::Expr* value, SourceRange range);
void statements(Context& context, const syntax::Block& block, std::vector<tree::Stmt*>& out);
Denoted target(Context& context, const syntax::Expr& e, TypeId* type = nullptr);
/// A block that writes its own VAR_INPUT CONSTANT, as TwinCAT and CODESYS compile it.
void tellConstantInput(Context& context, const Denoted& denoted, const syntax::Expr& e);
void assignTo(Context& context, const Denoted& target, Operand value, SourceRange range, std::vector<tree::Stmt*>& out,
              bool isHidden = false);
void bindReference(Context& context, tree::Place* target, const syntax::Expr& value, SourceRange range,
                   std::vector<tree::Stmt*>& out);
void assignAggregate(Context& context, tree::Place* target, const syntax::Expr& value, SourceRange range,
                     std::vector<tree::Stmt*>& out);
void assignment(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
void declareLabels(Context& context, const syntax::Block& block);

} // namespace plc::sema
