// The memory of __NEW and __DELETE: an array of the program and two functions over it, written in ST, so that it is
// recorded, bounded and guarded as any variable (docs/decisions/018-memory-for-new.md). Function, any thread.
#pragma once
#include <cstdint>
#include <string>

namespace plc::driver {

/// A text of the standard library for so many bytes.
[[nodiscard]] std::string dynamicMemoryText(uint32_t bytes);

} // namespace plc::driver
