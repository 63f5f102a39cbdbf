// Which pages of the image generated code wrote to, said by itself (Code::marksWrites); a function that it calls. Any
// thread, on the scan's own bytes.
#pragma once
#include "runtime/image/layout.h"

#include <cstdint>

namespace plc::image {

/// Below this comparing everything is as quick as marking.
inline constexpr uint32_t kMarkedImage = 64 * 1024;
[[nodiscard]] inline bool marksWrites(const Layout& layout) { return layout.dataEnd >= kMarkedImage; }

/// For writes of a length: offset and length in bytes; what is beyond `pages` goes to the byte behind.
void markWritten(uint8_t* dirtyPages, int64_t offset, int64_t length, int64_t pages);

} // namespace plc::image
