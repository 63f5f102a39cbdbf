// Sites and frames of every function, as debugger and call path see them. Both tiers of a back end follow them; made
// once per program, any thread.
#pragma once
#include "runtime/compiler/tree/tree.h"
#include "runtime/image/program.h"

namespace plc::facts {

struct DebugMap {
    std::vector<image::Site> sites;             // 0 unused
    std::vector<image::FunctionInfo> functions; // by FunctionId; 0 unused
};
[[nodiscard]] DebugMap makeDebugMap(const tree::Program& program);

} // namespace plc::facts
