// Splits the text of a path into its parts: names, indices, bits. Used by Layout::find and whoever else reads paths;
// values that point into the text they were read from.
#pragma once
#include "runtime/base/result.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace plc::image {

struct PathPart {
    enum class Kind : uint8_t { Name, Index, Slice };
    Kind kind = Kind::Name;
    std::string_view name;        // Name, without quotes
    std::vector<int64_t> indices; // Index
    uint32_t sliceIndex = 0;      // Slice: which bit, byte, word…
    unsigned sliceBits = 1;       // and how wide one is
};

/// `a.b[2,3].5` and `"my name".%X4`; the first part is a name.
[[nodiscard]] Result<std::vector<PathPart>> readPath(std::string_view path);

} // namespace plc::image
