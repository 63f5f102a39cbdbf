// Calls as statements: instances of blocks, programs, actions; functions whose result nobody takes.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void callStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);

} // namespace plc::sema
