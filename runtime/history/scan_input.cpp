// The journal as the scan thread writes it and as readers find it again (D13).
#include "runtime/base/messages.h"
#include "runtime/history/history_state.h"

#include <algorithm>

namespace plc::history {

// ---------------------------------------------------------------- the scan thread

void History::outsideActed(const image::Outside& outside) {
    State& s = *m;
    JournalEntry& entry = s.pendingJournal;
    const bool wentBack = outside.start.timeBefore < 0;
    entry.isFresh = s.isNewBeginning() || wentBack;
    entry.start = outside.start;
    entry.startIsPartial = false;
    // What acted on a scan that was abandoned acted on this one.
    entry.notes.insert(entry.notes.end(), outside.notes.begin(), outside.notes.end());
    const auto size = static_cast<uint32_t>(outside.image.size());
    constexpr uint32_t kBehindClock = 24;
    if (entry.isFresh) {
        const std::vector<std::byte> none;
        const uint32_t end = s.program ? std::min(size, s.program->layout.dataEnd) : size;
        entry.patch = difference(s.program ? s.program->initialImage : none, outside.image, kBehindClock, end, {});
    } else {
        const std::span<const std::byte> before(s.writer.shadow(), s.current->dataEnd);
        entry.patch = difference(before, outside.image, kBehindClock, s.current->dataEnd, outside.touchedPages);
    }
}

void History::actedWhileHalted(std::span<const image::OutsideNote> notes) {
    m->pendingJournal.notes.insert(m->pendingJournal.notes.end(), notes.begin(), notes.end());
}

void History::State::takeJournal(bool beginsSegment) {
    if (pendingJournal.start) lastStart = pendingJournal.start;
    if (beginsSegment && !pendingJournal.start && lastStart) {
        pendingJournal.start = lastStart;
        pendingJournal.startIsPartial = true;
    }
    journalBytes = pendingJournal.isEmpty() ? std::vector<std::byte>() : toBytes(pendingJournal);
    pendingJournal = {};
}

// ---------------------------------------------------------------- readers

namespace {

/// Walks the journals of a segment: onEntry(index, bytes) until it says false.
template <class OnEntry> void walkJournal(const Segment& segment, OnEntry&& onEntry) {
    std::vector<std::byte> whole;
    LogCursor cursor(segment, segment.blocks + 1);
    const uint32_t count = segment.count.load(std::memory_order_acquire);
    while (const std::byte* at = cursor.peek()) {
        JournalHead head;
        std::memcpy(&head, at, sizeof head);
        if (head.index >= count) return;
        whole.insert(whole.end(), at + sizeof head, at + sizeof head + head.size);
        cursor.skip(static_cast<uint32_t>(sizeof head) + head.size);
        if (head.isLast == 0) continue;
        if (!onEntry(head.index, std::span<const std::byte>(whole))) return;
        whole.clear();
    }
}

} // namespace

JournalEntry History::State::journalAt(const Segment& segment, uint32_t index,
                                       std::optional<image::ScanStart>& inForce) {
    JournalEntry found;
    walkJournal(segment, [&](uint32_t at, std::span<const std::byte> bytes) {
        if (at > index) return false;
        std::optional<JournalEntry> entry = readEntry(bytes);
        if (!entry) return true;
        if (entry->start) inForce = entry->start;
        if (at == index) found = std::move(*entry);
        return true;
    });
    return found;
}

Result<ScanInput> History::inputOf(Position position) const {
    const Error gone{errors::ScanNoLongerRecorded(), {}};
    const Error noBefore{errors::ScanBeforeNotRecorded(), {}};
    ScanInput input;
    JournalEntry entry;
    {
        const Epochs::Pin pin = m->epochs.pin();
        const Segment* s = m->containing(position);
        if (!s) return gone;
        const auto index = static_cast<uint32_t>(position - s->first);
        std::optional<image::ScanStart> inForce;
        entry = State::journalAt(*s, index, inForce);
        input.program = s->program;
        input.stamp = StampCursor(*s).at(index);
        input.calendarStartNs = s->calendarOffset;
        input.hasJournal = inForce.has_value();
        if (inForce) input.start = *inForce;
        input.startIsPartial = !entry.start || entry.startIsPartial;
    }
    if (!input.program) return Error{errors::ProgramOfScanUnknown(), {}};
    if (!input.hasJournal) input.start.plcRuns = true;
    if (entry.isFresh) {
        input.image = input.program->initialImage;
    } else {
        std::shared_ptr<const image::CompiledProgram> before;
        const std::optional<ScanStamp> stampBefore = position > 0 ? stamp(position - 1) : std::nullopt;
        if (position > 0) input.image = seek(position - 1, &before);
        if (input.image.empty() || before != input.program || !stampBefore) return noBefore;
        if (input.startIsPartial) input.start.timeBefore = stampBefore->time.count();
    }
    input.image.resize(std::max<size_t>(input.program->layout.imageSize, input.image.size()));
    for (const Patch& patch : entry.patch)
        if (patch.offset + patch.bytes.size() <= input.image.size())
            std::copy(patch.bytes.begin(), patch.bytes.end(), input.image.begin() + patch.offset);
    input.notes = std::move(entry.notes);
    return input;
}

void History::forEachJournal(Position from, Position to,
                             const std::function<bool(Position, const JournalEntry&)>& visit) const {
    const Epochs::Pin pin = m->epochs.pin();
    bool goesOn = true;
    for (uint64_t n = m->firstSegment.load(); n < m->endSegment.load() && goesOn; ++n) {
        const Segment* s = m->segment(n);
        if (!s || s->end() <= from) continue;
        if (s->first >= to) return;
        walkJournal(*s, [&](uint32_t index, std::span<const std::byte> bytes) {
            const Position position = s->first + index;
            if (position < from) return true;
            if (position >= to) return false;
            const std::optional<JournalEntry> entry = readEntry(bytes);
            if (entry && !(entry->startIsPartial && entry->notes.empty())) goesOn = visit(position, *entry);
            return goesOn;
        });
    }
}

} // namespace plc::history
