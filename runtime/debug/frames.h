// What a frame of the call path shows: the variables of its instance and its locals, read from a halted image. Pure
// functions, any thread with a copy of the image. Locals are there in the quick tier only.
#pragma once
#include "runtime/controller/fault.h"

namespace plc::debug {

struct FrameVariable {
    std::string name;
    types::Value value; // no value: not connected or not readable
    bool isLocal = false;
};
[[nodiscard]] std::vector<FrameVariable> frameVariables(const image::CompiledProgram& program,
                                                        std::span<const std::byte> image,
                                                        const controller::FaultFrame& frame);

} // namespace plc::debug
