#include "runtime/history/segment.h"

#include "runtime/base/assert.h"

#include <cstdlib>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace plc::history {

namespace {

// The thread sanitizer does not see each of the 32 looks at a block, which were most of the time of its tests;
// compareBlocks shows it some instead.
#ifdef PLC_THREAD_SANITIZED
#define PLC_NOT_INSTRUMENTED __attribute__((no_sanitize("thread")))
#else
#define PLC_NOT_INSTRUMENTED
#endif

#ifdef __SSE2__
PLC_NOT_INSTRUMENTED inline __m128i equalWords(const std::byte* a, const std::byte* b, int quarter) {
    return _mm_cmpeq_epi32(_mm_loadu_si128(reinterpret_cast<const __m128i*>(a) + quarter),
                           _mm_loadu_si128(reinterpret_cast<const __m128i*>(b) + quarter));
}
#endif

/// Bit i: the i-th 4-byte word of the 64-byte blocks differs.
PLC_NOT_INSTRUMENTED inline uint16_t changedWords(const std::byte* a, const std::byte* b) {
#ifdef __SSE2__
    const __m128i low = _mm_packs_epi32(equalWords(a, b, 0), equalWords(a, b, 1));
    const __m128i high = _mm_packs_epi32(equalWords(a, b, 2), equalWords(a, b, 3));
    return static_cast<uint16_t>(~_mm_movemask_epi8(_mm_packs_epi16(low, high)));
#else
    if (std::memcmp(a, b, kBlock) == 0) return 0;
    uint16_t mask = 0;
    for (int i = 0; i < 16; ++i)
        if (std::memcmp(a + i * 4, b + i * 4, 4) != 0) mask = static_cast<uint16_t>(mask | 1u << i);
    return mask;
#endif
}

constexpr uint32_t kLargestChunk = 4088; // bytes behind the head
/// Of a large image most blocks that change at all change once in a while.
constexpr uint32_t firstChunk(uint32_t blocks) { return blocks > 2048 ? 24 : 120; }

} // namespace

PagePool::~PagePool() { trim(0); }

void PagePool::trim(size_t keep) {
    for (; m_free.size() > keep; m_free.pop_back()) std::free(m_free.back());
}

PageBytes PagePool::take() {
    if (m_free.empty()) return static_cast<PageBytes>(std::aligned_alloc(kBlock, kPage));
    const PageBytes page = m_free.back();
    m_free.pop_back();
    return page;
}

void SegmentWriter::begin(Segment& segment, const std::byte* bytes, uint64_t scan, int64_t time) {
    m_segment = &segment;
    const size_t size = size_t(segment.blocks) * kBlock;
    if (m_shadowSize != size) {
        m_shadow = std::make_unique<std::byte[]>(size);
        m_shadowSize = size;
    }
    if (bytes != m_shadow.get()) std::memcpy(m_shadow.get(), bytes, size);
    std::memcpy(segment.keyframe.get(), m_shadow.get(), size);
    m_tails.assign(segment.blocks + 2, Tail{});
    m_pageUsed = kPage;
    segment.firstTime = time;
    m_stampIndex = kScansPerSegment; // the first stamp is always written
    stamp(0, scan, time);
    segment.count.store(1, std::memory_order_release);
}

bool SegmentWriter::isFull() const {
    return m_segment->count.load(std::memory_order_relaxed) >= kScansPerSegment || m_segment->pageCount >= m_pageLimit;
}

void SegmentWriter::append(const std::byte* image, uint32_t imageSize, uint64_t scan, int64_t time,
                           std::span<const uint8_t> dirtyPages) {
    const uint32_t index = m_segment->count.load(std::memory_order_relaxed);
    const uint32_t blocks = m_segment->blocks;
    const uint32_t whole = std::min(blocks, imageSize / kBlock);
    const std::byte* before = m_shadow.get();
    if (whole > 0) {
        const auto mask = static_cast<uint16_t>(changedWords(before, image) & ~kClockWords);
        if (mask) writeBlock(0, mask, image, static_cast<uint16_t>(index));
    }
    if (dirtyPages.empty()) {
        compareBlocks(1, whole, image, static_cast<uint16_t>(index));
    } else {
        constexpr uint32_t kBlocksPerPage = image::kDirtyPage / kBlock;
        const auto pages =
            std::min(static_cast<uint32_t>(dirtyPages.size()), (whole + kBlocksPerPage - 1) / kBlocksPerPage);
        for (uint32_t page = 0; page < pages; ++page) {
            uint64_t eight = 1;
            if (page + 8 <= pages && page > 0) std::memcpy(&eight, dirtyPages.data() + page, 8);
            if (eight == 0)
                page += 7;
            else if (page == 0 || dirtyPages[page])
                compareBlocks(std::max(1u, page * kBlocksPerPage), std::min(whole, (page + 1) * kBlocksPerPage), image,
                              static_cast<uint16_t>(index));
        }
    }
    if (whole < blocks) { // an image that ends within a block
        alignas(8) std::byte last[kBlock] = {};
        std::memcpy(last, image + size_t(whole) * kBlock, imageSize - whole * kBlock);
        uint16_t mask = changedWords(before + size_t(whole) * kBlock, last);
        if (whole == 0) mask = static_cast<uint16_t>(mask & ~kClockWords);
        if (mask) writeBlock(whole, mask, last, static_cast<uint16_t>(index));
    }
    stamp(index, scan, time);
    m_segment->count.store(index + 1, std::memory_order_release);
}

void SegmentWriter::compareBlocks(uint32_t first, uint32_t end, const std::byte* image, uint16_t index) {
    const std::byte* before = m_shadow.get();
#if defined(PLC_SANITIZED) && !defined(PLC_THREAD_SANITIZED)
    // A sanitizer that checks each look at a block checks a long one nearly as fast, and most blocks have not changed.
    if (end > first + 1) {
        if (std::memcmp(before + size_t(first) * kBlock, image + size_t(first) * kBlock, (end - first) * kBlock) == 0)
            return;
        const uint32_t middle = first + (end - first) / 2;
        compareBlocks(first, middle, image, index);
        compareBlocks(middle, end, image, index);
        return;
    }
#endif
    for (uint32_t block = first; block < end; ++block) {
#ifdef PLC_THREAD_SANITIZED
        // Other 8 bytes of each eighth block in each scan: in 64 scans, all that somebody else may write.
        if ((block + index) % 8 == 0)
            (void)*static_cast<const volatile std::byte*>(image + size_t(block) * kBlock + index / 8 % 8 * 8);
#endif
        const uint16_t mask = changedWords(before + size_t(block) * kBlock, image + size_t(block) * kBlock);
        if (mask) [[unlikely]]
            writeBlock(block, mask, image + size_t(block) * kBlock, index);
    }
}

void SegmentWriter::writeBlock(uint32_t block, uint16_t mask, const std::byte* now, uint16_t index) {
    const EntryHead head{index, mask};
    const auto size = static_cast<uint32_t>(sizeof head + 4 * std::popcount(mask));
    std::byte* out = room(block, size);
    std::memcpy(std::assume_aligned<4>(out), &head, sizeof head);
    out += sizeof head;
    for (unsigned rest = mask; rest != 0; rest &= rest - 1, out += 4) copyWord(out, now + std::countr_zero(rest) * 4);
    std::memcpy(m_shadow.get() + size_t(block) * kBlock, now, kBlock);
    publish(block, size);
}

void SegmentWriter::stamp(uint32_t index, uint64_t scan, int64_t time) {
    const int64_t step = time - m_lastTime;
    m_lastTime = time;
    if (m_stampIndex < index) {
        const auto n = static_cast<int64_t>(index - m_stampIndex);
        if (time == m_stampTime + n * m_stampStep && scan == m_stampScan + static_cast<uint64_t>(n)) return;
    }
    const StampEntry entry{time, step, scan, index, 0};
    m_stampIndex = index;
    m_stampScan = scan;
    m_stampTime = time;
    m_stampStep = step;
    addEntry(m_segment->blocks, &entry, sizeof entry);
}

void SegmentWriter::addEntry(uint32_t log, const void* bytes, uint32_t size) {
    std::memcpy(room(log, size), bytes, size);
    publish(log, size);
}

void SegmentWriter::addJournal(uint32_t index, std::span<const std::byte> entry) {
    std::byte part[sizeof(JournalHead) + kJournalPart];
    do {
        const size_t size = std::min<size_t>(entry.size(), kJournalPart);
        const JournalHead head{index, static_cast<uint16_t>(size), size == entry.size()};
        std::memcpy(part, &head, sizeof head);
        std::memcpy(part + sizeof head, entry.data(), size);
        addEntry(m_segment->blocks + 1, part, static_cast<uint32_t>(sizeof head + size));
        entry = entry.subspan(size);
    } while (!entry.empty());
}

void SegmentWriter::replaceFirstStamp(const StampEntry& stamp) {
    std::memcpy(m_tails[m_segment->blocks].chunk, &stamp, sizeof stamp);
}

void SegmentWriter::publish(uint32_t log, uint32_t size) {
    Tail& tail = m_tails[log];
    tail.used += size;
    reinterpret_cast<ChunkHead*>(tail.chunk - sizeof(ChunkHead))->used.store(tail.used, std::memory_order_release);
}

std::byte* SegmentWriter::room(uint32_t log, uint32_t size) {
    Tail& tail = m_tails[log];
    if (tail.used + size <= tail.size) [[likely]]
        return tail.chunk + tail.used;
    // A block that changes often gets longer chunks.
    const uint32_t wanted = tail.chunk ? std::max(size, std::min(kLargestChunk, tail.size * 2 + 8))
                                       : std::max(size, firstChunk(m_segment->blocks));
    std::byte* bytes = nullptr;
    const uint32_t id = takeChunk(wanted, bytes);
    if (tail.chunk)
        reinterpret_cast<ChunkHead*>(tail.chunk - sizeof(ChunkHead))->next.store(id, std::memory_order_release);
    else
        m_segment->heads[log].store(id, std::memory_order_release);
    tail = Tail{bytes, 0, wanted};
    return bytes;
}

uint32_t SegmentWriter::takeChunk(uint32_t size, std::byte*& bytes) {
    const uint32_t need = (size + uint32_t(sizeof(ChunkHead)) + 7) / 8 * 8;
    if (m_pageUsed + need > kPage) {
        PLC_ASSERT(m_segment->pageCount < m_segment->pageCapacity,
                   --m_segment->pageCount); // keeps the process alive, loses exactness
        m_segment->pages[m_segment->pageCount++] = m_pool.take();
        m_pageUsed = m_segment->pageCount == 1 ? 8 : 0; // id 0 means none
    }
    std::byte* at = m_segment->pages[m_segment->pageCount - 1] + m_pageUsed;
    const uint32_t id = (m_segment->pageCount - 1) << 16 | m_pageUsed;
    m_pageUsed += need;
    new (at) ChunkHead;
    bytes = at + sizeof(ChunkHead);
    return id;
}

void putClock(const Segment& segment, const ScanStamp& stamp, std::byte* image) {
    if (segment.dataEnd < 24) return;
    const int64_t time = stamp.time.count();
    const int64_t calendar = time + segment.calendarOffset;
    std::memcpy(image, &time, 8);
    std::memcpy(image + 8, &calendar, 8);
    std::memcpy(image + 16, &stamp.scan, 8);
}

} // namespace plc::history
