// What a recorded scan began with beside its image, where the recording leaves that to the image: the flags of the
// first scan and the triggers of event tasks. Values; any thread.
#pragma once
#include "runtime/image/journal.h"
#include "runtime/image/program.h"

namespace plc::controller {

/// `start` as it was recorded, `image` as the scan began from it.
[[nodiscard]] image::ScanStart completed(image::ScanStart start, const image::CompiledProgram& program,
                                         const std::byte* image);

} // namespace plc::controller
