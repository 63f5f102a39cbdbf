// What a standard function gives: its operands brought to one type, and the type of the result.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

/// Of a function that is an intrinsic; the operands are all good.
Operand signatureResult(Context& context, const library::Signature& signature, std::vector<Operand> operands,
                        const syntax::Expr& e, TypeId hint);

} // namespace plc::sema
