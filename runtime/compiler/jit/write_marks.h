// Code of programs with a large image says which pages it writes (D2): finding what changed in a scan then does not
// cost the size of the image. Added to finished IR, so that it is in the way of no optimisation. One module at a time,
// any thread.
#pragma once
#include "runtime/image/written_pages.h"

#include <cstdint>

namespace llvm {
class Module;
}

namespace plc::jit {

using image::marksWrites;

/// Before optimising: no function may lose context and image, its first two arguments.
void keepImageArguments(llvm::Module& module);
/// After optimising: a mark behind everything that may write to the image.
void markWrites(llvm::Module& module, uint32_t imageSize);

} // namespace plc::jit
