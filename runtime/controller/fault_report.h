// Turns the context a fault left behind into what the user reads: place, message, call path. Pure functions, scan
// thread.
#pragma once
#include "runtime/controller/fault.h"

namespace plc::controller {

/// The live calls, innermost first. `entry` is the function and instance the task began with.
[[nodiscard]] std::vector<FaultFrame> callPathOf(const image::CompiledProgram& program,
                                                 const image::RuntimeContext& context, uint32_t site,
                                                 image::CallRecord entry);
/// "index 7 is outside 1..5".
[[nodiscard]] Message faultMessage(const image::RuntimeContext& context);

} // namespace plc::controller
