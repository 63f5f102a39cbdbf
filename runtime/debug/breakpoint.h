// A breakpoint and the kinds of step, as everyone above the debugger names them. Values; any thread.
#pragma once
#include "runtime/base/source.h"

#include <cstdint>
#include <string>

namespace plc::debug {

struct Breakpoint {
    FileId file;
    uint32_t line = 1;
    std::string condition; // ST expression, seen from the instance; empty = always
    uint32_t hitCount = 0; // halts at the n-th hit and each later one; 0 = every
    std::string instance;  // only this instance path; empty = any
    bool isEnabled = true;
};

enum class Step : uint8_t { In, Over, Out };

} // namespace plc::debug
