// Which variables a layout retains: the greatest variables whose every byte is RETAIN or PERSISTENT. Pure functions,
// any thread.
#pragma once
#include "runtime/image/layout.h"

namespace plc::controller {

void forEachRetained(const image::Layout& layout, bool persistentOnly,
                     const std::function<void(const std::string& path, const image::Place&)>& visit);

} // namespace plc::controller
