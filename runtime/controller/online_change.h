// Carries the values of a running image over into the image of another version of the program. Pure function over two
// images; scan thread.
#pragma once
#include "runtime/controller/online_change_report.h"
#include "runtime/image/layout.h"

namespace plc::controller {

/// `fresh` holds the new version's initial values; what has the same path and type in `old` replaces them. References
/// go by what they pointed to. Constants and the header are left alone.
[[nodiscard]] OnlineChangeReport carryOver(const image::Layout& from, std::span<const std::byte> old,
                                           const image::Layout& to, std::span<std::byte> fresh);

} // namespace plc::controller
