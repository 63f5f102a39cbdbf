// CASE: labels, their overlaps, the values of an enumeration that have no branch.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void caseStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);

} // namespace plc::sema
