// Replays a segment for a reader that looks at some bytes only: calls back once for each span of scans in which those
// bytes stay as they are. Reader, pinned.
#pragma once
#include "runtime/history/segment.h"

#include <algorithm>

namespace plc::history {

/// Which words of which blocks matter.
struct Watched {
    struct Words {
        uint32_t block;
        uint16_t mask;
    };
    std::vector<Words> blocks; // ascending
    bool everyScan = false;    // reads the clock: no two scans are the same
};

[[nodiscard]] Watched watchedBytes(const std::vector<image::AreaRange>& ranges, bool isComplete, uint32_t dataEnd);

/// onSpan(begin, end) with indices in the segment: `image` then holds the watched blocks as after each scan in [begin,
/// end). Returns false when onSpan did, to stop.
template <class OnSpan>
bool replay(const Segment& segment, const Watched& watched, uint32_t from, uint32_t to, std::byte* image,
            OnSpan&& onSpan) {
    if (from >= to) return true;
    struct Source {
        BlockCursor cursor;
        uint16_t mask;
    };
    std::vector<Source> sources;
    sources.reserve(watched.blocks.size());
    for (const Watched::Words& words : watched.blocks) {
        if (words.block >= segment.blocks) continue;
        const size_t at = size_t(words.block) * kBlock;
        std::memcpy(image + at, segment.keyframe.get() + at, kBlock);
        Source source{BlockCursor(segment, words.block), words.mask};
        while (source.cursor.index() <= from) source.cursor.apply(image);
        sources.push_back(std::move(source));
    }
    StampCursor stamps(segment);
    const auto tell = [&](uint32_t begin, uint32_t end) {
        if (!watched.everyScan) return onSpan(begin, end);
        for (uint32_t i = begin; i < end; ++i) {
            putClock(segment, stamps.at(i), image);
            if (!onSpan(i, i + 1)) return false;
        }
        return true;
    };
    uint32_t begin = from;
    if (sources.size() == 1) { // the usual case: one variable, one log
        Source& source = sources.front();
        for (; source.cursor.index() < to; source.cursor.apply(image)) {
            if (!(source.cursor.mask() & source.mask)) continue;
            const uint32_t change = source.cursor.index();
            if (!tell(begin, change)) return false;
            begin = change;
        }
        return tell(begin, to);
    }
    const auto later = [&](uint32_t a, uint32_t b) { return sources[a].cursor.index() > sources[b].cursor.index(); };
    std::vector<uint32_t> heap;
    for (uint32_t i = 0; i < sources.size(); ++i)
        if (sources[i].cursor.index() < to) heap.push_back(i);
    std::make_heap(heap.begin(), heap.end(), later);
    std::vector<uint32_t> changed;
    while (!heap.empty()) {
        const uint32_t change = sources[heap.front()].cursor.index();
        bool matters = false;
        changed.clear();
        while (!heap.empty() && sources[heap.front()].cursor.index() == change) {
            std::pop_heap(heap.begin(), heap.end(), later);
            changed.push_back(heap.back());
            heap.pop_back();
            matters = matters || (sources[changed.back()].cursor.mask() & sources[changed.back()].mask) != 0;
        }
        if (matters) {
            if (!tell(begin, change)) return false;
            begin = change;
        }
        for (const uint32_t i : changed) {
            sources[i].cursor.apply(image);
            if (sources[i].cursor.index() >= to) continue;
            heap.push_back(i);
            std::push_heap(heap.begin(), heap.end(), later);
        }
    }
    return tell(begin, to);
}

} // namespace plc::history
