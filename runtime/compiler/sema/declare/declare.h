// First pass: every name of every file gets its entity; nothing is resolved yet, so order does not matter.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void declareFile(WorldBuilder& world, const syntax::SyntaxFile& file);
void resolveUsings(WorldBuilder& world);
Unit* declareUnit(WorldBuilder& world, const syntax::Pou& pou, Space& space, const syntax::SyntaxFile& file);
void declareGlobals(WorldBuilder& world, const syntax::GlobalList& list, Space& space, const syntax::SyntaxFile& file,
                    std::string_view name);
TypeId declareStruct(WorldBuilder& world, const syntax::TypeSpec& spec, std::string name, const Scope& scope);

} // namespace plc::sema
