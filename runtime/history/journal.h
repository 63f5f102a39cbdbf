// What acted from outside on recorded scans, as the history keeps it (D13). Values; History hands them out.
#pragma once
#include "runtime/image/journal.h"
#include "runtime/image/program.h"

#include <optional>
#include <span>

namespace plc::history {

/// Bytes that differ between the image after the scan before and the image the scan began from.
struct Patch {
    uint32_t offset = 0;
    std::vector<std::byte> bytes;
};

/// The journal of one scan. Scans without one went on from the image before, with what was in force.
struct JournalEntry {
    bool isFresh = false; // nothing before it counts: the patch is on the program's initial image
    /// All it depends on; of the first scan of a segment that nothing acted on only what does not lie in the image
    /// (`startIsPartial`).
    std::optional<image::ScanStart> start;
    bool startIsPartial = false;
    std::vector<image::OutsideNote> notes;
    std::vector<Patch> patch;
    [[nodiscard]] bool isEmpty() const { return !isFresh && !start && notes.empty() && patch.empty(); }
};

[[nodiscard]] std::vector<std::byte> toBytes(const JournalEntry& entry);
/// None: these bytes are no entry.
[[nodiscard]] std::optional<JournalEntry> readEntry(std::span<const std::byte> bytes);

/// What of [begin, end) of `now` differs from `before` (zero behind its end), looked for in the touched pages only;
/// empty = all.
[[nodiscard]] std::vector<Patch> difference(std::span<const std::byte> before, std::span<const std::byte> now,
                                            uint32_t begin, uint32_t end, std::span<const uint8_t> touchedPages);

} // namespace plc::history
