// Parts of variables: elements of arrays and texts, what pointers point to, bits and bytes, direct addresses.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

Denoted denoteIndex(Context& context, const syntax::Expr& e, Access access);
Denoted denoteDeref(Context& context, const syntax::Expr& e, Access access);
Denoted denoteBit(Context& context, const syntax::Expr& e, Access access);
Denoted denoteAddress(Context& context, const syntax::Expr& e);

/// w.Enable with a constant Enable: the bit of its number. Nothing: no integer constant has the name.
[[nodiscard]] std::optional<Denoted> namedBit(Context& context, const Denoted& from, tree::Place* base,
                                              const syntax::Name& name, SourceRange range);

} // namespace plc::sema
