// Parts of variables: elements of arrays and texts, what pointers point to, bits and bytes, direct addresses.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

Denoted denoteIndex(Context& context, const syntax::Expr& e, Access access);
Denoted denoteDeref(Context& context, const syntax::Expr& e, Access access);
Denoted denoteBit(Context& context, const syntax::Expr& e, Access access);
Denoted denoteAddress(Context& context, const syntax::Expr& e);

} // namespace plc::sema
