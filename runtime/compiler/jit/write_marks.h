// Code of programs with a large image says which pages it writes (D2): finding what changed in a scan then does not
// cost the size of the image. Added to finished IR, so that it is in the way of no optimisation. One module at a time,
// any thread.
#pragma once
#include "runtime/image/program.h"

#include <cstdint>

namespace llvm {
class Module;
}

namespace plc::jit {

/// Below this comparing everything is as quick as marking.
inline constexpr uint32_t kMarkedImage = 64 * 1024;
[[nodiscard]] inline bool marksWrites(const image::Layout& layout) { return layout.dataEnd >= kMarkedImage; }

/// Before optimising: no function may lose context and image, its first two arguments.
void keepImageArguments(llvm::Module& module);
/// After optimising: a mark behind everything that may write to the image.
void markWrites(llvm::Module& module, uint32_t imageSize);

/// Called by generated code for writes of a length: offset and length in bytes; beyond `pages` goes to the byte behind.
void markWritten(uint8_t* dirtyPages, int64_t offset, int64_t length, int64_t pages);

} // namespace plc::jit
