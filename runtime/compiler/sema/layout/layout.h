// The image: areas sized by the addresses in use, globals, statics, program instances, and their initial bytes.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

[[nodiscard]] image::AreaRange areaOf(const World& world, image::Area area);
void locate(WorldBuilder& world, Variable& variable, std::string_view path);
void layoutGlobals(WorldBuilder& world);
void finishLayout(WorldBuilder& world);

} // namespace plc::sema
