// Type specifications → TypeIds. A name is resolved when asked for; sizes are completed separately (completeType), so
// that a pointer may name a type that holds it.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

[[nodiscard]] std::optional<int64_t> constantInteger(World& world, const syntax::Expr* expr, const Scope& scope);
TypeId resolveNamed(World& world, const syntax::Path& path, const Scope& scope, SourceRange range);
TypeId resolveDeclared(World& world, DeclaredType& type);
TypeId resolveSpec(World& world, const syntax::TypeSpec* spec, const Scope& scope, std::string_view anonymousName = {});
[[nodiscard]] uint32_t nestingOf(const World& world, TypeId type);
void noteNesting(World& world, TypeId type, uint32_t nesting);
bool checkSize(World& world, TypeId type, SourceRange range);
TypeId typeOf(World& world, Variable& variable);
[[nodiscard]] bool sameType(const World& world, TypeId a, TypeId b);
void reportCycle(World& world, TypeId type, SourceRange usedAt);
bool completeType(World& world, TypeId type, SourceRange usedAt);
void completeEnum(World& world, EnumType& type);
[[nodiscard]] const types::Field* fieldOf(const World& world, TypeId type, std::string_view name);
void completeStruct(World& world, StructType& type);

} // namespace plc::sema
