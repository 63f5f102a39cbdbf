// Calls of functions, methods and accessors: arguments are matched with parameters, defaults made explicit, dispatch
// chosen.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

Matched match(Context& context, const syntax::Expr& call, const std::string& name,
              const std::vector<Variable*>& parameters);
tree::Expr* held(Context& context, tree::Expr* value, std::vector<tree::Stmt*>& before);
/// Indices and pointers of a place that is used several times, held where the text calls something to find it.
void holdPlace(Context& context, tree::Place* place, const syntax::Expr& text, std::vector<tree::Stmt*>& before);
tree::Place* inOutTarget(Context& context, Variable& parameter, const syntax::Argument& argument,
                         std::vector<tree::Stmt*>& before, std::vector<tree::Stmt*>& after);
void prepareCall(Context& context, tree::Call& call, const Denoted& callee, SourceRange range);
Operand callUnit(Context& context, const Denoted& callee, const syntax::Expr& e);
Operand withEnable(Context& context, Operand value, const StandardArguments& arguments, SourceRange range);
Operand propertyValue(Context& context, const Denoted& denoted, SourceRange range);
/// Of a call that is wrong itself: what is wrong inside its arguments, and what they use.
void checkArguments(Context& context, const syntax::Expr& call);
Operand call(Context& context, const syntax::Expr& e, TypeId hint);

} // namespace plc::sema
