// How a built program keeps what it was made from: its shared owner's deleter holds it, so that image/program.h need
// not know the compiler. Private to driver.
#pragma once
#include "runtime/compiler/driver/driver.h"

namespace plc::driver {

struct KeepsAnalysis {
    std::shared_ptr<const sema::Analysis> analysis;
    /// Lets go at once: the deleter itself lives as long as the last weak reference, and the analysis has one.
    void operator()(image::CompiledProgram* program) {
        delete program;
        analysis.reset();
    }
};

} // namespace plc::driver
