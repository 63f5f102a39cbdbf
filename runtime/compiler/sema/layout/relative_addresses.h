// Members of a structure that have an address in it (IEC 61131-3 edition 3, table 11): `a AT %B0 : INT; b AT %X2.1 :
// BOOL`.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void locateMembers(WorldBuilder& world, const StructType& type, std::vector<types::Field>& fields, size_t inherited,
                   const std::vector<const syntax::VarDecl*>& declarations);

} // namespace plc::sema
