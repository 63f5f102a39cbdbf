// `a.b`: what a member stands for.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

/// A field of the structure whose initial values are checked, by its name alone.
std::optional<Denoted> fieldOfThis(Context& context, const syntax::Name& name, Access access);
Denoted denoteMember(Context& context, const syntax::Expr& e, Access access, TypeId hint);

} // namespace plc::sema
