// Checked expression tree → the small code of runtime/expression (D7). Pure function, any thread.
#pragma once
#include "runtime/compiler/tree/tree.h"
#include "runtime/expression/expression.h"

namespace plc::driver {

/// `root` comes from sema::checkExpression: absolute places, no side effects. The result does not refer to the tree.
[[nodiscard]] Result<expression::Expression> compile(const tree::Expr& root,
                                                     std::shared_ptr<const types::TypeTable> types, std::string text);

} // namespace plc::driver
