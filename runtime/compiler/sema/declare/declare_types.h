// First pass, of types and lists of globals; nothing is resolved yet.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

[[nodiscard]] bool hasAttribute(const std::vector<syntax::Pragma>& pragmas, std::string_view key);
void declareType(WorldBuilder& world, const syntax::TypeDecl& type, Space& space, const syntax::SyntaxFile& file);
/// Enumerations written in a VAR or a field: their values are seen where the variable is.
void declareInlineEnums(WorldBuilder& world, const syntax::TypeSpec* spec, const Scope& scope,
                        std::unordered_map<NameId, std::vector<EnumeratorRef>>& table);

} // namespace plc::sema
