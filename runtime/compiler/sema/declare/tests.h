// TESTs of a project: declared as hidden blocks, their own statements, and names that only tests have.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void declareTest(WorldBuilder& world, const syntax::TestDecl& test, Space& space, const syntax::SyntaxFile& file);
void checkTestNames(WorldBuilder& world);
/// of a VAR_ACCESS
[[nodiscard]] bool isAccessName(const World& world, std::string_view name);
/// tests.cpp
void testStatement(Context& context, const syntax::Stmt& stmt, std::vector<tree::Stmt*>& out);

} // namespace plc::sema
