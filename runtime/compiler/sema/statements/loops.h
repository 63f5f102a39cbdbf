// FOR, WHILE and REPEAT: what they count, and what they leave of the flow behind them.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void forStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
void whileStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);
void repeatStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);

} // namespace plc::sema
