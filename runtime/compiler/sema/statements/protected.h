// __TRY … __CATCH … __FINALLY … __ENDTRY of CODESYS.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void tryStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);

} // namespace plc::sema
