#include "runtime/history/replay.h"

namespace plc::history {

Watched watchedBytes(const std::vector<image::AreaRange>& ranges, bool isComplete, uint32_t dataEnd) {
    Watched watched;
    const uint32_t blocks = (dataEnd + kBlock - 1) / kBlock;
    if (!isComplete) {
        for (uint32_t b = 0; b < blocks; ++b) watched.blocks.push_back({b, 0xffff});
        watched.everyScan = true;
        return watched;
    }
    std::vector<uint16_t> masks(blocks);
    for (const image::AreaRange& range : ranges) {
        if (range.size == 0) continue;
        if (range.begin < 24) watched.everyScan = true;
        for (uint32_t word = range.begin / 4; word <= (range.begin + range.size - 1) / 4 && word / 16 < blocks; ++word)
            masks[word / 16] = static_cast<uint16_t>(masks[word / 16] | 1u << (word % 16));
    }
    for (uint32_t b = 0; b < blocks; ++b)
        if (masks[b]) watched.blocks.push_back({b, masks[b]});
    return watched;
}

} // namespace plc::history
