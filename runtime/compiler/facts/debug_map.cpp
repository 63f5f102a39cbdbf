#include "runtime/compiler/facts/debug_map.h"

#include "runtime/compiler/facts/frames.h"
#include "runtime/compiler/facts/sites.h"

namespace plc::facts {

using tree::Function;
using tree::Local;

DebugMap makeDebugMap(const tree::Program& program) {
    DebugMap map;
    map.sites = SiteTable(program).sites;
    map.functions.resize(program.functions.size());
    for (size_t f = 1; f < program.functions.size(); ++f) {
        const Function& function = program.functions[f];
        image::FunctionInfo& info = map.functions[f];
        info.name = function.name;
        info.library = function.library;
        info.instanceType = function.instanceType;
        info.declaration = function.declaration;
        const FrameLayout layout =
            layFrameOut(*program.types, function, std::vector<bool>(function.locals.size(), true));
        info.frameSize = static_cast<uint32_t>(std::min(layout.size, kMaximumFrame));
        for (size_t i = 0; i < function.locals.size(); ++i) {
            const Local& local = function.locals[i];
            info.locals.push_back({local.name, local.type, layout.offsets[i], local.isInOut, local.isHidden});
        }
    }
    return map;
}

} // namespace plc::facts
