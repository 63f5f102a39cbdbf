// First pass: every name of every file gets its entity; nothing is resolved yet, so order does not matter.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void declareFile(World& world, const syntax::SyntaxFile& file);
void resolveUsings(World& world);
Unit* declareUnit(World& world, const syntax::Pou& pou, Space& space, const syntax::SyntaxFile& file);
void declareGlobals(World& world, const syntax::GlobalList& list, Space& space, const syntax::SyntaxFile& file,
                    std::string_view name);
TypeId declareStruct(World& world, const syntax::TypeSpec& spec, std::string name, const Scope& scope);

} // namespace plc::sema
