// Initial values: what is constant becomes bytes, the rest (references, FB_Init, expressions over variables) becomes
// code.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

bool needsConstruction(const World& world, TypeId type);
void writeConstant(const World& world, InitialValue& out, TypeId type, uint32_t offset, int16_t bit,
                   const types::Value& value);
void initialise(const Check& check, InitialValue& out, TypeId type, uint32_t offset, int16_t bit,
                const syntax::Expr* value, const Scope& scope, const std::vector<syntax::Argument>* constructor);
bool hasConstructor(const syntax::TypeSpec* spec);
void initialiseDeclared(const Check& check, InitialValue& out, TypeId type, uint32_t offset, int16_t bit,
                        const syntax::Expr* value, const Scope& scope, const syntax::TypeSpec* spec);
void setInitial(WorldBuilder& world, InitialValue& out, Variable& variable, uint32_t offset);
void emitDynamics(Context& checker, const std::vector<DynamicInit>& dynamics,
                  const std::function<tree::Place*(const DynamicInit&)>& place, std::vector<tree::Stmt*>& out);
void buildInitialiser(WorldBuilder& world);

} // namespace plc::sema
