// CONFIGURATION: globals, program instances, VAR_CONFIG and VAR_ACCESS.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void forEachResource(const World& world,
                     const std::function<void(const Configuration&, const syntax::ResourceDecl&)>& visit);
void declareConfigurations(World& world);
void applyVarConfig(World& world);

} // namespace plc::sema
