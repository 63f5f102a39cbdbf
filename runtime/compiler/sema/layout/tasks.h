// TASKs: what their declarations say, the programs each runs with their connections, and what runs where nothing is
// configured.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

void buildTasks(WorldBuilder& world);

} // namespace plc::sema
