// Every scan that was made, as segments: a keyframe and, for each block of the image, what changed scan by scan. One
// thread appends (the scan's), any thread reads without a lock: a segment is published when it can be read and given
// back only when no reader can hold it any more (epochs).
#include "runtime/history/history.h"

#include "runtime/history/history_state.h"

#include <algorithm>

namespace plc::history {

namespace {

constexpr size_t kPageBytes = kPage;
constexpr std::ptrdiff_t kMarksKept = 100'000;

uint32_t pageLimitFor(size_t budget, uint32_t blocks) {
    // A segment is long enough that its keyframe weighs little, and short enough that eviction goes in small steps.
    const size_t keyframePages = size_t(blocks) * kBlock / kPageBytes;
    const size_t wanted = std::max<size_t>(16, 2 * keyframePages);
    return static_cast<uint32_t>(std::clamp<size_t>(budget / kPageBytes / 16, 2, wanted));
}

} // namespace

History::History(size_t budgetBytes) : m(std::make_unique<State>(budgetBytes)) {}
History::~History() = default;

History::State::~State() {
    const auto freePages = [&](Segment& s) {
        for (uint32_t i = 0; i < s.pageCount; ++i) pool.giveBack(s.pages[i]);
    };
    // Pages belong to the pool and not to the segment.
    for (Retired& r : retired) freePages(*r.segment);
    for (uint64_t n = firstSegment.load(); n < endSegment.load(); ++n) {
        Segment* s = slots[n % kDirectorySize].load();
        freePages(*s);
        delete s;
    }
}

// ---------------------------------------------------------------- the scan thread

Segment& History::State::beginSegment(uint32_t dataEnd, uint32_t journalPages) {
    auto fresh = std::make_unique<Segment>();
    fresh->number = endSegment.load(std::memory_order_relaxed);
    fresh->first = end.load(std::memory_order_relaxed);
    fresh->dataEnd = dataEnd;
    fresh->blocks = (dataEnd + kBlock - 1) / kBlock;
    fresh->program = program;
    fresh->calendarOffset = calendarOffset;
    fresh->keyframe = std::make_unique<std::byte[]>(size_t(fresh->blocks) * kBlock);
    fresh->heads = std::make_unique<std::atomic<uint32_t>[]>(fresh->blocks + 2);
    const uint32_t limit = pageLimitFor(budget.load(std::memory_order_relaxed), fresh->blocks);
    writer.setPageLimit(limit);
    // The list of pages never grows while readers look at it, so it is as long as it can get.
    fresh->pageCapacity = limit + fresh->blocks / 15 + 6 + journalPages; // one more scan may change every block
    fresh->pages = std::make_unique<PageBytes[]>(fresh->pageCapacity);
    accountedPages = 0;
    programChanged = false;
    // Owned by the directory from publishSegment on, by `retired` after its eviction.
    current = fresh.release();
    bytes.fetch_add(current->fixedBytes(), std::memory_order_relaxed);
    return *current;
}

/// Makes the current segment visible; it holds at least its keyframe.
void History::State::publishSegment() {
    if (endSegment.load(std::memory_order_relaxed) - firstSegment.load(std::memory_order_relaxed) + 1 >= kDirectorySize)
        evictOver(0);
    // First the slot, then the end: who sees the end sees the segment.
    slots[current->number % kDirectorySize].store(current, std::memory_order_seq_cst);
    endSegment.store(current->number + 1, std::memory_order_seq_cst);
}

void History::State::account() {
    if (current->pageCount != accountedPages) {
        bytes.fetch_add((current->pageCount - accountedPages) * kPageBytes, std::memory_order_relaxed);
        accountedPages = current->pageCount;
    } else if (bytes.load(std::memory_order_relaxed) <= budget.load(std::memory_order_relaxed)) {
        return;
    }
    const size_t limit = budget.load(std::memory_order_relaxed);
    if (bytes.load(std::memory_order_relaxed) > limit) evictOver(limit);
    collect();
}

/// Oldest first, never the current one; limit 0: one segment.
void History::State::evictOver(size_t limit) {
    while (bytes.load(std::memory_order_relaxed) > limit) {
        const uint64_t number = firstSegment.load(std::memory_order_relaxed);
        if (number >= endSegment.load(std::memory_order_relaxed)) return;
        Segment* oldest = slots[number % kDirectorySize].load(std::memory_order_relaxed);
        // A budget that is smaller than one segment keeps that one.
        if (oldest == current) return;
        // Before it is retired: a reader that pins from now on does not find it.
        firstSegment.store(number + 1, std::memory_order_seq_cst);
        bytes.fetch_sub(oldest->fixedBytes() + oldest->pageCount * kPageBytes, std::memory_order_relaxed);
        retired.push_back({epochs.current(), std::unique_ptr<Segment>(oldest)});
        // One is enough: it was called for room in the directory.
        if (limit == 0) return;
    }
}

/// Takes back what no reader can see any more.
void History::State::collect() {
    if (retired.empty()) return;
    epochs.tryAdvance();
    const uint64_t now = epochs.current();
    size_t done = 0;
    // Two epochs on, every reader that could have seen it has let go of its pin.
    while (done < retired.size() && retired[done].epoch + 2 <= now) {
        Segment& s = *retired[done].segment;
        for (uint32_t i = 0; i < s.pageCount; ++i) pool.giveBack(s.pages[i]);
        ++done;
    }
    retired.erase(retired.begin(), retired.begin() + static_cast<std::ptrdiff_t>(done));
    pool.trim(64);
}

void History::State::openBranch() {
    const std::lock_guard lock(mutex);
    branches.push_back({end.load(std::memory_order_relaxed), *pendingBranch});
    pendingBranch.reset();
}

void History::beginProgram(std::shared_ptr<const image::CompiledProgram> program) {
    if (m->program == program) return;
    m->program = std::move(program);
    m->programChanged = true;
    const std::lock_guard lock(m->mutex);
    const auto known = std::find_if(m->origins.begin(), m->origins.end(),
                                    [&](const ProgramOrigin& o) { return o.program == m->program; });
    if (known == m->origins.end()) m->origins.push_back({m->program, {}, {}, {}});
}

void History::beginBranch(Position parent) { m->pendingBranch = parent; }

void History::append(std::span<const std::byte> image, uint64_t scan, Nanoseconds time,
                     std::span<const uint8_t> dirtyPages) {
    State& s = *m;
    const int64_t now = time.count();
    uint32_t dataEnd = s.current && !s.programChanged ? s.current->dataEnd : static_cast<uint32_t>(image.size());
    if (s.programChanged && s.program)
        // Frames are not recorded: between scans nothing in them means anything.
        dataEnd = std::min<uint32_t>(s.program->layout.dataEnd, static_cast<uint32_t>(image.size()));
    int64_t calendar = s.calendarOffset;
    if (image.size() >= 24) {
        int64_t clock[2];
        std::memcpy(clock, image.data(), sizeof clock);
        // The header's two clocks differ by a constant, which a segment keeps once.
        calendar = clock[1] - now;
    }
    const Position position = s.end.load(std::memory_order_relaxed);
    // The PLC's clock went back without a word: it was reset to its origin.
    if (!s.pendingBranch && s.lastTime >= now && position > 0) s.pendingBranch = kNoParent;
    bool beginsSegment = s.isNewBeginning() || calendar != s.calendarOffset || s.writer.isFull();
    if (!s.pendingJournal.isEmpty()) [[unlikely]] {
        s.takeJournal(true);
        beginsSegment = beginsSegment || s.writer.lacksRoom(State::pagesFor(s.journalBytes.size()));
    }
    if (beginsSegment) [[unlikely]] {
        // What happened since the last scan belongs to the first scan of the new segment.
        if (s.journalBytes.empty()) s.takeJournal(true);
        if (s.pendingBranch) s.openBranch();
        s.calendarOffset = calendar;
        Segment& fresh = s.beginSegment(dataEnd, State::pagesFor(s.journalBytes.size()));
        if (size_t(fresh.blocks) * kBlock > image.size()) {
            // The writer reads whole blocks.
            std::vector<std::byte> padded(size_t(fresh.blocks) * kBlock);
            std::memcpy(padded.data(), image.data(), std::min<size_t>(image.size(), padded.size()));
            s.writer.begin(fresh, padded.data(), scan, now);
        } else {
            s.writer.begin(fresh, image.data(), scan, now);
        }
        if (!s.journalBytes.empty()) s.writer.addJournal(0, s.journalBytes);
        s.publishSegment();
    } else {
        if (!s.journalBytes.empty()) [[unlikely]]
            s.writer.addJournal(s.current->count.load(std::memory_order_relaxed), s.journalBytes);
        s.writer.append(image.data(), static_cast<uint32_t>(image.size()), scan, now, dirtyPages);
    }
    s.journalBytes.clear();
    s.lastTime = now;
    // Last: a position that can be seen can be read.
    s.end.store(position + 1, std::memory_order_release);
    s.account();
}

void History::mark(int kind, Message text, Nanoseconds time) {
    const std::lock_guard lock(m->mutex);
    const Position end = m->end.load(std::memory_order_relaxed);
    // Half at once, so that a program which faults in each scan does not move the list each time.
    if (m->marks.size() >= size_t(kMarksKept)) m->marks.erase(m->marks.begin(), m->marks.begin() + kMarksKept / 2);
    m->marks.push_back({end > 0 ? end - 1 : 0, time, kind, std::move(text)});
}

// ---------------------------------------------------------------- any thread

void History::describeProgram(std::shared_ptr<const image::CompiledProgram> program,
                              std::vector<std::pair<std::string, std::string>> sources,
                              std::vector<std::string> libraries,
                              std::vector<std::pair<std::string, std::string>> libraryTexts) {
    const std::lock_guard lock(m->mutex);
    for (ProgramOrigin& origin : m->origins) {
        if (origin.program != program) continue;
        origin.sources = std::move(sources);
        origin.libraries = std::move(libraries);
        origin.libraryTexts = std::move(libraryTexts);
        return;
    }
    m->origins.push_back({std::move(program), std::move(sources), std::move(libraries), std::move(libraryTexts)});
}

void History::setBudget(size_t bytes) { m->budget.store(bytes, std::memory_order_relaxed); }

Position History::State::oldest() const {
    for (uint64_t n = firstSegment.load(std::memory_order_seq_cst); n < endSegment.load(std::memory_order_seq_cst); ++n)
        if (const Segment* s = segment(n)) return s->first;
    return end.load(std::memory_order_acquire);
}

Segment* History::State::containing(Position position) const {
    if (position >= end.load(std::memory_order_acquire)) return nullptr;
    uint64_t low = firstSegment.load(std::memory_order_seq_cst);
    uint64_t high = endSegment.load(std::memory_order_seq_cst);
    while (low < high) { // first segment that begins behind the position
        const uint64_t middle = low + (high - low) / 2;
        // Null: evicted since firstSegment was read.
        const Segment* s = segment(middle);
        if (!s || s->first <= position)
            low = middle + 1; // an evicted one lies before
        else
            high = middle;
    }
    if (low == 0) return nullptr;
    Segment* s = segment(low - 1);
    return s && position >= s->first && position < s->end() ? s : nullptr;
}

Statistics History::statistics() const {
    const Epochs::Pin pin = m->epochs.pin();
    Statistics statistics;
    // The oldest first: read after the end, it could have moved past it, and a full history would look empty.
    const Position oldest = m->oldest();
    statistics.end = m->end.load(std::memory_order_acquire);
    statistics.first = std::min(statistics.end, oldest);
    statistics.scans = statistics.end - statistics.first;
    statistics.bytes = m->bytes.load(std::memory_order_relaxed);
    statistics.budget = m->budget.load(std::memory_order_relaxed);
    statistics.segments = m->endSegment.load() - m->firstSegment.load();
    return statistics;
}

std::vector<Branch> History::branches() const { return m->branchList(); }

std::vector<Mark> History::marks() const {
    const std::lock_guard lock(m->mutex);
    return m->marks;
}

std::vector<std::shared_ptr<const image::CompiledProgram>> History::programs() const {
    std::vector<std::shared_ptr<const image::CompiledProgram>> all;
    const Epochs::Pin pin = m->epochs.pin();
    for (uint64_t n = m->firstSegment.load(); n < m->endSegment.load(); ++n) {
        const Segment* s = m->segment(n);
        if (s && s->program && std::find(all.begin(), all.end(), s->program) == all.end()) all.push_back(s->program);
    }
    return all;
}

void History::State::restore(const Segment& segment, uint32_t index, std::byte* image) {
    for (uint32_t block = 0; block < segment.blocks; ++block) {
        alignas(8) std::byte bytes[kBlock]; // the last block may lie over the end
        std::memcpy(bytes, segment.keyframe.get() + size_t(block) * kBlock, kBlock);
        for (BlockCursor cursor(segment, block); cursor.index() <= index;) cursor.applyToBlock(bytes);
        std::memcpy(image + size_t(block) * kBlock, bytes,
                    std::min<size_t>(kBlock, segment.dataEnd - size_t(block) * kBlock));
    }
    putClock(segment, StampCursor(segment).at(index), image);
}

std::vector<std::byte> History::seek(Position position, std::shared_ptr<const image::CompiledProgram>* program) const {
    const Epochs::Pin pin = m->epochs.pin();
    const Segment* s = m->containing(position);
    if (!s) return {};
    // With room for frames: whoever evaluates expressions on it needs them.
    const size_t size = s->program ? std::max(s->program->layout.imageSize, s->dataEnd) : s->dataEnd;
    std::vector<std::byte> image(size);
    State::restore(*s, static_cast<uint32_t>(position - s->first), image.data());
    if (program) *program = s->program;
    return image;
}

std::optional<ScanStamp> History::stamp(Position position) const {
    const Epochs::Pin pin = m->epochs.pin();
    const Segment* s = m->containing(position);
    if (!s) return std::nullopt;
    return StampCursor(*s).at(static_cast<uint32_t>(position - s->first));
}

std::vector<PositionRange> chainTo(const std::vector<Branch>& branches, Position end) {
    std::vector<PositionRange> chain; // newest first, turned at the end
    for (Position until = end; until > 0;) {
        // The branch that `until` is in: the last that begins before it.
        const auto behind = std::find_if(branches.rbegin(), branches.rend(),
                                         [&](const Branch& branch) { return branch.first < until; });
        if (behind == branches.rend()) {
            chain.push_back({0, until});
            break;
        }
        chain.push_back({behind->first, until});
        // A run that began again from its origin has no past of its own.
        if (behind->parent == kNoParent || behind->first == 0) break;
        until = std::min(behind->parent + 1, behind->first);
    }
    std::reverse(chain.begin(), chain.end());
    return chain;
}

namespace {

/// The last scan of the segment, before `limit`, whose key is at or before `wanted`.
template <class Key> std::optional<Position> lastUpTo(const Segment& segment, Position limit, int64_t wanted, Key key) {
    uint32_t low = 0;
    uint32_t high = static_cast<uint32_t>(std::min<Position>(segment.end(), limit) - segment.first);
    if (high == 0 || key(StampCursor(segment).at(0)) > wanted) return std::nullopt;
    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        if (key(StampCursor(segment).at(middle)) <= wanted)
            low = middle;
        else
            high = middle;
    }
    return segment.first + low;
}

/// Segment by segment backwards, so evicted ranges and what was left behind by going back are never looked at.
template <class State, class Key> std::optional<Position> searchLineage(const State& state, int64_t wanted, Key key) {
    std::vector<PositionRange> ranges = chainTo(state.branchList(), state.end.load(std::memory_order_acquire));
    std::reverse(ranges.begin(), ranges.end());
    const Epochs::Pin pin = state.epochs.pin();
    for (const auto& [begin, end] : ranges) {
        for (const Segment* s = state.containing(end - 1); s && s->end() > begin;
             s = s->number > 0 ? state.segment(s->number - 1) : nullptr) {
            if (const std::optional<Position> found = lastUpTo(*s, end, wanted, key)) return found;
        }
    }
    return std::nullopt;
}

} // namespace

std::optional<Position> History::positionAt(Nanoseconds time) const {
    return searchLineage(*m, time.count(), [](const ScanStamp& stamp) { return stamp.time.count(); });
}

std::optional<Position> History::positionOfScan(uint64_t scan) const {
    const std::optional<Position> found = searchLineage(
        *m, static_cast<int64_t>(scan), [](const ScanStamp& stamp) { return static_cast<int64_t>(stamp.scan); });
    const std::optional<ScanStamp> at = found ? stamp(*found) : std::nullopt;
    return at && at->scan == scan ? found : std::nullopt;
}

} // namespace plc::history
