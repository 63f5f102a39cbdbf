// VAR_INPUT of type ANY, ANY_NUM, … as CODESYS has them: the unit sees where the argument is, how large and of which
// class. One thread checks.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

/// The type of an input that is declared with the name of a family of types; invalid: any other variable.
[[nodiscard]] TypeId anyInputType(WorldBuilder& world, const Variable& variable);
/// What such an input gets for an argument.
[[nodiscard]] Operand anyArgument(Context& context, const Variable& parameter, const syntax::Expr& argument);
/// The argument's place; a value is kept in a local, by statements before. Null: it was reported.
[[nodiscard]] tree::Place* placeOfArgument(Context& context, const syntax::Expr& argument,
                                           std::vector<tree::Stmt*>& before);
/// The number of CODESYS's TYPE_CLASS.
[[nodiscard]] int64_t typeClassOf(const types::TypeTable& types, TypeId type);
[[nodiscard]] bool isAnyInput(const World& world, const Variable& variable);

} // namespace plc::sema
