// Places: how storage is named in the checked tree. Constant offsets are added up as far as they go.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

tree::Place* absolutePlace(Context& context, uint32_t offset, TypeId type, int16_t bit, SourceRange range);
tree::Place* localPlace(Context& context, uint32_t local, TypeId type, SourceRange range);
tree::Place* thisPlace(Context& context, SourceRange range);
tree::Place* fieldPlace(Context& context, tree::Place* base, uint32_t offset, TypeId type, int16_t bit,
                        SourceRange range);
tree::Place* dereferenced(Context& context, tree::Place* reference, SourceRange range);
/// What a returned REFERENCE TO refers to: a variable elsewhere, which can be written.
tree::Place* referredBy(Context& context, const Operand& reference, SourceRange range);
tree::Place* temporary(Context& context, const Operand& operand);
[[nodiscard]] tree::Place* rootOf(tree::Place* place);
void takeAddress(Context& context, tree::Place* place);
[[nodiscard]] bool hasAddress(const tree::Place* place);
uint32_t newLocal(Context& context, std::string name, TypeId type, bool isInOut = false);
uint32_t temporaryOf(Context& context, Variable& variable);

} // namespace plc::sema
