// What a History keeps, for the files that implement it. The directory of segments is read without locks under a pin;
// branches, marks and the descriptions of programs change seldom and lie behind a mutex that append() never takes.
#pragma once
#include "runtime/base/epoch.h"
#include "runtime/history/journal.h"
#include "runtime/history/segment.h"

#include <mutex>

namespace plc::history {

inline constexpr uint64_t kDirectorySize = 1 << 16;

struct ProgramOrigin {
    std::shared_ptr<const image::CompiledProgram> program;
    std::vector<std::pair<std::string, std::string>> sources;
    std::vector<std::string> libraries;
    std::vector<std::pair<std::string, std::string>> libraryTexts; // "toolbox/valves.st"
};

struct History::State {
    explicit State(size_t bytes)
        : budget(bytes), slots(std::make_unique<std::atomic<Segment*>[]>(kDirectorySize)), writer(pool) {}
    ~State();

    // --- any thread
    std::atomic<size_t> budget;
    std::atomic<size_t> bytes{0};
    std::unique_ptr<std::atomic<Segment*>[]> slots; // ring by segment number
    std::atomic<uint64_t> firstSegment{0}, endSegment{0};
    std::atomic<Position> end{0};
    Epochs epochs;

    mutable std::mutex mutex;
    std::vector<Branch> branches;
    std::vector<Mark> marks;
    std::vector<ProgramOrigin> origins;

    // --- the scan thread
    PagePool pool;
    SegmentWriter writer;
    Segment* current = nullptr;
    std::shared_ptr<const image::CompiledProgram> program;
    bool programChanged = true;
    std::optional<Position> pendingBranch; // its parent
    int64_t lastTime = -1, calendarOffset = 0;
    struct Retired {
        uint64_t epoch;
        std::unique_ptr<Segment> segment;
    };
    std::vector<Retired> retired;
    JournalEntry pendingJournal; // of the scan to come
    std::optional<image::ScanStart> lastStart;
    std::vector<std::byte> journalBytes; // of the scan that is appended
    uint32_t accountedPages = 0;         // of the current segment, in `bytes`

    Segment& beginSegment(uint32_t dataEnd, uint32_t journalPages = 0);
    /// Pages that the journal of a scan may take.
    [[nodiscard]] static uint32_t pagesFor(size_t journalBytes) {
        return journalBytes == 0 ? 0 : static_cast<uint32_t>(journalBytes / (kPage / 2)) + 1;
    }
    [[nodiscard]] bool isNewBeginning() const { return pendingBranch || programChanged || !current; }
    void takeJournal(bool beginsSegment);
    void publishSegment();
    void account();
    void evictOver(size_t limit);
    void collect();
    void openBranch();

    // --- readers, while pinned
    [[nodiscard]] Segment* segment(uint64_t number) const {
        if (number < firstSegment.load(std::memory_order_seq_cst) ||
            number >= endSegment.load(std::memory_order_seq_cst))
            return nullptr;
        Segment* found = slots[number % kDirectorySize].load(std::memory_order_seq_cst);
        return found && found->number == number ? found : nullptr;
    }
    [[nodiscard]] Segment* containing(Position position) const;
    [[nodiscard]] Position oldest() const;
    /// Replays the segment up to scan `index` into `image` (at least dataEnd bytes).
    static void restore(const Segment& segment, uint32_t index, std::byte* image);

    /// The journal of scan `index`, and what was in force there.
    [[nodiscard]] static JournalEntry journalAt(const Segment& segment, uint32_t index,
                                                std::optional<image::ScanStart>& inForce);

    [[nodiscard]] std::vector<Branch> branchList() const {
        const std::lock_guard lock(mutex);
        return branches;
    }
};

} // namespace plc::history
