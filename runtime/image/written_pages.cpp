#include "runtime/image/written_pages.h"

#include "runtime/image/runtime_context.h"

#include <algorithm>

namespace plc::image {

void markWritten(uint8_t* dirtyPages, int64_t offset, int64_t length, int64_t pages) {
    if (length <= 0) return;
    const auto page = [&](int64_t at) {
        return std::min<uint64_t>(static_cast<uint64_t>(at) / kDirtyPage, static_cast<uint64_t>(pages));
    };
    for (uint64_t p = page(offset), last = page(offset + length - 1); p <= last; ++p) dirtyPages[p] = 1;
}

} // namespace plc::image
