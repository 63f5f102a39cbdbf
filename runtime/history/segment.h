// A segment of the recording: the image after its first scan, then for each 64-byte block a log of the words that
// changed. Written by the scan thread; read by any thread that holds a pin, up to the number of scans published.
// Private to runtime/history.
//
// A log is a chain of chunks in 64 KB pages. An entry is {index of the scan in the segment, mask of changed 4-byte
// words, those words}. Scan numbers and times are a log of their own: an entry only where they do not go on as
// expected. The header's clock words are left out of block 0 and put back from there.
#pragma once
#include "runtime/history/history.h"

#include <atomic>
#include <bit>
#include <cstring>
#include <memory>

namespace plc::history {

inline constexpr uint32_t kBlock = 64;
inline constexpr uint32_t kPage = 65536;
inline constexpr uint32_t kScansPerSegment = 65536; // an entry's index has 16 bits
inline constexpr uint16_t kClockWords = 0x3f;       // timeNs, calendarNs and scan of the header, in block 0

using PageBytes = std::byte*;

/// Pages are kept for the next segment when one is evicted. Scan thread.
class PagePool {
public:
    ~PagePool();
    [[nodiscard]] PageBytes take();
    void giveBack(PageBytes page) { m_free.push_back(page); }
    void trim(size_t keep);

private:
    std::vector<PageBytes> m_free;
};

struct ChunkHead {
    std::atomic<uint32_t> next{0}; // chunk id: page << 16 | offset; 0 = none
    std::atomic<uint32_t> used{0}; // bytes behind the head that are complete
};
struct EntryHead {
    uint16_t index;
    uint16_t mask;
};
/// From scan `index` on: time + n × step, scan + n.
struct StampEntry {
    int64_t time;
    int64_t step;
    uint64_t scan;
    uint32_t index;
    uint32_t unused;
};

/// A part of the journal of scan `index`, in a log of its own behind the stamps; `size` bytes follow.
struct JournalHead {
    uint32_t index;
    uint16_t size;
    uint16_t isLast;
};
inline constexpr uint32_t kJournalPart = 4000;

struct Segment {
    uint64_t number = 0;
    Position first = 0;
    uint32_t dataEnd = 0, blocks = 0; // bytes of the image that are recorded
    int64_t firstTime = 0, calendarOffset = 0;
    std::shared_ptr<const image::CompiledProgram> program;
    std::unique_ptr<std::byte[]> keyframe;          // blocks × 64 bytes
    std::unique_ptr<std::atomic<uint32_t>[]> heads; // first chunk of each block's log; then stamps, journal
    std::unique_ptr<PageBytes[]> pages;
    uint32_t pageCapacity = 0;
    uint32_t pageCount = 0;         // writer
    std::atomic<uint32_t> count{0}; // scans published
    [[nodiscard]] size_t fixedBytes() const {
        return size_t(blocks) * (kBlock + 4) + sizeof(Segment) + pageCapacity * sizeof(PageBytes);
    }
    [[nodiscard]] Position end() const { return first + count.load(std::memory_order_acquire); }
};

/// Writes the newest segment. Scan thread.
class SegmentWriter {
public:
    explicit SegmentWriter(PagePool& pool) : m_pool(pool) {}
    /// Begins with a keyframe; `bytes` holds segment.blocks × 64 bytes.
    void begin(Segment& segment, const std::byte* bytes, uint64_t scan, int64_t time);
    /// Records the next scan. The segment was not full before the journal of that scan was added; the journal itself
    /// may have taken the last page of the limit, and the scan still belongs to this segment.
    void append(const std::byte* image, uint32_t imageSize, uint64_t scan, int64_t time,
                std::span<const uint8_t> dirtyPages);
    /// The next scan begins a new segment.
    [[nodiscard]] bool isFull() const;
    /// A journal of so many pages could not be kept behind what a scan may change.
    [[nodiscard]] bool lacksRoom(uint32_t journalPages) const {
        return m_segment->pageCount + journalPages + m_segment->blocks / 15 + 4 > m_segment->pageCapacity;
    }
    void setPageLimit(uint32_t pages) { m_pageLimit = pages; }
    /// The journal of scan `index`, before that scan is published.
    void addJournal(uint32_t index, std::span<const std::byte> entry);
    /// For loading: one entry as it was written.
    void addEntry(uint32_t log, const void* bytes, uint32_t size);
    /// For loading, before anyone reads: begin() had to guess the step of the clock.
    void replaceFirstStamp(const StampEntry& stamp);
    [[nodiscard]] const std::byte* shadow() const { return m_shadow.get(); }

private:
    struct Tail {
        std::byte* chunk = nullptr;
        uint32_t used = 0, size = 0; // without the head
    };
    void compareBlocks(uint32_t first, uint32_t end, const std::byte* image, uint16_t index);
    void writeBlock(uint32_t block, uint16_t mask, const std::byte* now, uint16_t index);
    void stamp(uint32_t index, uint64_t scan, int64_t time);
    [[nodiscard]] std::byte* room(uint32_t log, uint32_t size);
    void publish(uint32_t log, uint32_t size);
    [[nodiscard]] uint32_t takeChunk(uint32_t size, std::byte*& bytes);

    PagePool& m_pool;
    Segment* m_segment = nullptr;
    std::unique_ptr<std::byte[]> m_shadow; // the image as last recorded
    size_t m_shadowSize = 0;
    std::vector<Tail> m_tails;
    uint32_t m_pageUsed = kPage;
    uint32_t m_pageLimit = 16;
    uint32_t m_stampIndex = 0;
    uint64_t m_stampScan = 0;
    int64_t m_stampTime = 0, m_stampStep = 0, m_lastTime = 0;
};

/// Walks one log of a segment. Reader, pinned.
class LogCursor {
public:
    LogCursor(const Segment& segment, uint32_t log)
        : m_segment(&segment), m_next(segment.heads[log].load(std::memory_order_acquire)) {}
    /// The next complete entry's bytes, or null at the end. Entries never change once complete.
    [[nodiscard]] const std::byte* peek() {
        for (;;) {
            if (m_at < m_used) return m_chunk + m_at;
            if (m_chunk) {
                const auto* head = reinterpret_cast<const ChunkHead*>(m_chunk - sizeof(ChunkHead));
                m_used = head->used.load(std::memory_order_acquire);
                if (m_at < m_used) return m_chunk + m_at;
                m_next = head->next.load(std::memory_order_acquire);
                // More may have been written between the two looks before the chunk was closed.
                m_used = head->used.load(std::memory_order_acquire);
                if (m_at < m_used) return m_chunk + m_at;
            }
            if (m_next == 0) return nullptr;
            m_chunk = m_segment->pages[m_next >> 16] + (m_next & 0xffff) + sizeof(ChunkHead);
            m_at = m_used = 0;
        }
    }
    void skip(uint32_t bytes) { m_at += bytes; }

private:
    const Segment* m_segment;
    uint32_t m_next;
    const std::byte* m_chunk = nullptr;
    uint32_t m_at = 0, m_used = 0;
};

/// Blocks, chunks and their entries begin at multiples of four. Said so, a sanitizer checks the word at once.
inline void copyWord(std::byte* to, const std::byte* from) {
    std::memcpy(std::assume_aligned<4>(to), std::assume_aligned<4>(from), 4);
}

/// One block's log: entry by entry onto the block's bytes.
class BlockCursor {
public:
    static constexpr uint32_t kEnd = ~0u;
    BlockCursor(const Segment& segment, uint32_t block) : m_log(segment, block), block(block) { read(); }
    [[nodiscard]] uint32_t index() const { return m_index; } // of the next entry; kEnd = none
    [[nodiscard]] uint16_t mask() const { return m_mask; }
    void apply(std::byte* image) { applyToBlock(image + size_t(block) * kBlock); }
    /// `target`: the block alone.
    void applyToBlock(std::byte* target) {
        const std::byte* word = m_entry + sizeof(EntryHead);
        for (unsigned rest = m_mask; rest != 0; rest &= rest - 1, word += 4)
            copyWord(target + std::countr_zero(rest) * 4, word);
        m_log.skip(static_cast<uint32_t>(word - m_entry));
        read();
    }

private:
    void read() {
        m_entry = m_log.peek();
        if (!m_entry) {
            m_index = kEnd;
            return;
        }
        EntryHead head;
        std::memcpy(&head, std::assume_aligned<4>(m_entry), sizeof head);
        m_index = head.index;
        m_mask = head.mask;
    }
    LogCursor m_log;
    const std::byte* m_entry = nullptr;
    uint32_t m_index = kEnd;
    uint16_t m_mask = 0;

public:
    uint32_t block;
};

/// Scan numbers and times of a segment, forwards.
class StampCursor {
public:
    explicit StampCursor(const Segment& segment) : m_segment(&segment), m_log(segment, segment.blocks) { advance(0); }
    /// Stamp of scan `index`; indices must not go back.
    [[nodiscard]] ScanStamp at(uint32_t index) {
        advance(index);
        const int64_t n = static_cast<int64_t>(index) - m_now.index;
        return {m_segment->first + index, m_now.scan + static_cast<uint64_t>(n),
                Nanoseconds(m_now.time + n * m_now.step)};
    }

private:
    void advance(uint32_t index) {
        while (const std::byte* entry = m_log.peek()) {
            StampEntry next;
            std::memcpy(&next, entry, sizeof next);
            if (next.index > index) return;
            m_now = next;
            m_log.skip(sizeof next);
        }
    }
    const Segment* m_segment;
    LogCursor m_log;
    StampEntry m_now{};
};

/// Time, calendar and scan number into the header of a reconstructed image.
void putClock(const Segment& segment, const ScanStamp& stamp, std::byte* image);

} // namespace plc::history
