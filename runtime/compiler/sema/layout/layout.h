// The image: areas sized by the addresses in use, globals, statics, program instances, and their initial bytes.
#pragma once
#include "runtime/compiler/sema/context.h"

namespace plc::sema {

[[nodiscard]] image::AreaRange areaOf(const World& world, image::Area area);
void locate(World& world, Variable& variable, std::string_view path);
void layoutGlobals(World& world);
void finishLayout(World& world);

} // namespace plc::sema
