// The retain file: RETAIN and PERSISTENT values by path and type, so that an edited program takes back what still fits.
// Written atomically (a new file takes the old one's name when it is complete). Scan thread, or any thread with a copy
// of the values.
#pragma once
#include "runtime/base/result.h"
#include "runtime/image/layout.h"

namespace plc::controller {

class Controller;

/// One leaf as the file holds it.
struct RetainedLeaf {
    std::string path, type; // type as spelled: "INT", "STRING(20)", "Colour"
    std::vector<std::byte> bytes;
};
struct RetainOutcome {
    size_t restored = 0;
    std::vector<std::string> lost; // paths that are gone or have another type now
};

[[nodiscard]] std::vector<RetainedLeaf> retainedLeaves(const image::Layout& layout, std::span<const std::byte> image);
[[nodiscard]] Result<void> saveRetain(const std::string& file, const std::vector<RetainedLeaf>& leaves);
/// No values when there is no file yet.
[[nodiscard]] Result<std::vector<RetainedLeaf>> loadRetain(const std::string& file);
/// Puts the values that still fit into the controller's image.
RetainOutcome restoreRetained(Controller& controller, const std::vector<RetainedLeaf>& leaves);

} // namespace plc::controller
