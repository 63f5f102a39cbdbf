// Type specifications → TypeIds. A name is resolved when asked for; sizes are completed separately (completeType), so
// that a pointer may name a type that holds it.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

[[nodiscard]] std::optional<int64_t> constantInteger(const Check& check, const syntax::Expr* expr, const Scope& scope);
TypeId resolveNamed(const Check& check, const syntax::Path& path, const Scope& scope, SourceRange range);
TypeId resolveDeclared(WorldBuilder& world, DeclaredType& type);
[[nodiscard]] TypeId resolveDeclared(const Check& check, DeclaredType& type);
TypeId resolveSpec(WorldBuilder& world, const syntax::TypeSpec* spec, const Scope& scope,
                   std::string_view anonymousName = {});
TypeId resolvePart(WorldBuilder& world, const syntax::TypeSpec* spec, const Scope& scope);
[[nodiscard]] uint32_t nestingOf(const World& world, TypeId type);
void noteNesting(WorldBuilder& world, TypeId type, uint32_t nesting);
bool checkSize(WorldBuilder& world, TypeId type, SourceRange range);
TypeId typeOf(WorldBuilder& world, Variable& variable);
[[nodiscard]] TypeId typeOf(const Check& check, Variable& variable);
[[nodiscard]] bool sameType(const World& world, TypeId a, TypeId b);
void reportCycle(WorldBuilder& world, TypeId type, SourceRange usedAt);
bool completeType(WorldBuilder& world, TypeId type, SourceRange usedAt);
bool completeType(const Check& check, TypeId type, SourceRange usedAt);
void completeEnum(WorldBuilder& world, EnumType& type);
void completeEnum(const Check& check, EnumType& type);
[[nodiscard]] const types::Field* fieldOf(const World& world, TypeId type, std::string_view name);
void completeStruct(WorldBuilder& world, StructType& type);

} // namespace plc::sema
