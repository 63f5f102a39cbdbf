// A built program as an object file for another machine, with all that the runner (runtime/runner) has to know of it.
// Functions, any thread.
#pragma once
#include "runtime/compiler/driver/driver.h"

#include <string>

namespace plc::driver {

/// For `stepwise build`: the machine an object file is for, and what the program is called there.
struct ObjectWanted {
    std::string triple;          // "aarch64-linux-gnu"
    std::string cpu;             // "generic"
    std::string name;            // of the project
    int64_t calendarStartNs = 0; // at the first scan
};
/// The optimised code as an object file that the runner (runtime/runner) is linked with, and all it knows of the
/// program.
[[nodiscard]] Result<std::string> compileObject(const Built& built, const ObjectWanted& wanted);

} // namespace plc::driver
