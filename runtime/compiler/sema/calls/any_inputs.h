// VAR_INPUT of type ANY, ANY_NUM, … as CODESYS has them: the unit sees where the argument is, how large and of which
// class. One thread checks.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

/// The type of an input that is declared with the name of a family of types; invalid: any other variable.
[[nodiscard]] TypeId anyInputType(WorldBuilder& world, const Variable& variable);
/// What such an input gets for an argument.
[[nodiscard]] Operand anyArgument(Context& context, const Variable& parameter, const syntax::Expr& argument);
[[nodiscard]] bool isAnyInput(const World& world, const Variable& variable);

} // namespace plc::sema
