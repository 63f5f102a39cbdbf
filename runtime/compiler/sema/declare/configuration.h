// CONFIGURATION: globals, program instances, VAR_CONFIG and VAR_ACCESS.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void forEachResource(const World& world,
                     const std::function<void(const Configuration&, const syntax::ResourceDecl&)>& visit);
void declareConfigurations(WorldBuilder& world);
void applyVarConfig(WorldBuilder& world);

/// The global that a VAR_EXTERNAL means: where several RESOURCEs have the name, that of the one its program runs in.
[[nodiscard]] Variable* globalOf(WorldBuilder& world, const Variable& external);

} // namespace plc::sema
