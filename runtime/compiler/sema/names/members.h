// `a.b`: what a member stands for.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

Denoted denoteMember(Context& context, const syntax::Expr& e, Access access, TypeId hint);

} // namespace plc::sema
