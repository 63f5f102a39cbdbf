#include "runtime/history/journal.h"

#include <algorithm>
#include <cstring>

namespace plc::history {

namespace {

constexpr uint8_t kFresh = 1, kStart = 2, kPartial = 4;

class Out {
public:
    template <class T> void number(T value) { raw(&value, sizeof value); }
    void bytes(std::span<const std::byte> value) {
        number(static_cast<uint32_t>(value.size()));
        raw(value.data(), value.size());
    }
    void text(const std::string& value) { bytes(std::as_bytes(std::span(value))); }
    std::vector<std::byte> all;

private:
    void raw(const void* from, size_t size) {
        const auto* first = static_cast<const std::byte*>(from);
        all.insert(all.end(), first, first + size);
    }
};

class In {
public:
    explicit In(std::span<const std::byte> bytes) : m_bytes(bytes) {}
    template <class T> T number() {
        T value{};
        if (m_bytes.size() < sizeof value) return isGood = false, T{};
        std::memcpy(&value, m_bytes.data(), sizeof value);
        m_bytes = m_bytes.subspan(sizeof value);
        return value;
    }
    std::vector<std::byte> bytes() {
        const auto size = number<uint32_t>();
        if (size > m_bytes.size()) return isGood = false, std::vector<std::byte>();
        std::vector<std::byte> value(m_bytes.begin(), m_bytes.begin() + size);
        m_bytes = m_bytes.subspan(size);
        return value;
    }
    std::string text() {
        const std::vector<std::byte> value = bytes();
        return {reinterpret_cast<const char*>(value.data()), value.size()};
    }
    /// How many of at least one byte each follow.
    size_t count() {
        const auto value = number<uint32_t>();
        if (value > m_bytes.size()) isGood = false;
        return isGood ? value : 0;
    }
    bool isGood = true;

private:
    std::span<const std::byte> m_bytes;
};

void put(Out& out, const image::ScanStart& start) {
    out.number(static_cast<uint8_t>((start.plcRuns ? 1 : 0) | (start.isFirst ? 2 : 0) |
                                    (start.isSimulationFirst ? 4 : 0) | (start.hasSimulationFault ? 8 : 0)));
    out.number(start.timeBefore);
    out.number(start.pendingEvents);
    out.number(start.triggersBefore);
    out.number(static_cast<uint32_t>(start.forces.size()));
    for (const image::ForcedBytes& forced : start.forces) {
        out.number(forced.offset);
        out.number(forced.bit);
        out.text(forced.path);
        out.bytes(forced.bytes);
    }
}

image::ScanStart readStart(In& in) {
    image::ScanStart start;
    const auto flags = in.number<uint8_t>();
    start.plcRuns = (flags & 1) != 0;
    start.isFirst = (flags & 2) != 0;
    start.isSimulationFirst = (flags & 4) != 0;
    start.hasSimulationFault = (flags & 8) != 0;
    start.timeBefore = in.number<int64_t>();
    start.pendingEvents = in.number<uint64_t>();
    start.triggersBefore = in.number<uint64_t>();
    for (size_t n = in.count(); n > 0 && in.isGood; --n) {
        image::ForcedBytes forced;
        forced.offset = in.number<uint32_t>();
        forced.bit = in.number<int16_t>();
        forced.path = in.text();
        forced.bytes = in.bytes();
        forced.size = static_cast<uint32_t>(forced.bytes.size());
        start.forces.push_back(std::move(forced));
    }
    return start;
}

void put(Out& out, const image::OutsideNote& note) {
    out.number(static_cast<uint8_t>(note.kind));
    out.number(note.offset);
    out.number(note.size);
    out.number(note.bit);
    out.text(note.text);
    out.text(note.origin);
    out.number(note.site);
    out.number(note.instance);
    out.bytes(note.bytes);
}

image::OutsideNote readNote(In& in) {
    image::OutsideNote note;
    const auto kind = in.number<uint8_t>();
    if (kind > static_cast<uint8_t>(image::OutsideKind::Function)) in.isGood = false;
    note.kind = static_cast<image::OutsideKind>(kind);
    note.offset = in.number<uint32_t>();
    note.size = in.number<uint32_t>();
    note.bit = in.number<int16_t>();
    note.text = in.text();
    note.origin = in.text();
    note.site = in.number<uint32_t>();
    note.instance = in.number<uint32_t>();
    note.bytes = in.bytes();
    return note;
}

} // namespace

std::vector<std::byte> toBytes(const JournalEntry& entry) {
    Out out;
    out.number(static_cast<uint8_t>((entry.isFresh ? kFresh : 0) | (entry.start ? kStart : 0) |
                                    (entry.startIsPartial ? kPartial : 0)));
    if (entry.start) put(out, *entry.start);
    out.number(static_cast<uint32_t>(entry.notes.size()));
    for (const image::OutsideNote& note : entry.notes) put(out, note);
    out.number(static_cast<uint32_t>(entry.patch.size()));
    for (const Patch& patch : entry.patch) {
        out.number(patch.offset);
        out.bytes(patch.bytes);
    }
    return std::move(out.all);
}

std::optional<JournalEntry> readEntry(std::span<const std::byte> bytes) {
    In in(bytes);
    JournalEntry entry;
    const auto flags = in.number<uint8_t>();
    entry.isFresh = (flags & kFresh) != 0;
    entry.startIsPartial = (flags & kPartial) != 0;
    if ((flags & kStart) != 0) entry.start = readStart(in);
    for (size_t n = in.count(); n > 0 && in.isGood; --n) entry.notes.push_back(readNote(in));
    for (size_t n = in.count(); n > 0 && in.isGood; --n) {
        Patch patch;
        patch.offset = in.number<uint32_t>();
        patch.bytes = in.bytes();
        entry.patch.push_back(std::move(patch));
    }
    if (!in.isGood) return std::nullopt;
    return entry;
}

std::vector<Patch> difference(std::span<const std::byte> before, std::span<const std::byte> now, uint32_t begin,
                              uint32_t end, std::span<const uint8_t> touchedPages) {
    std::vector<Patch> patches;
    end = std::min(end, static_cast<uint32_t>(now.size()));
    const auto differs = [&](uint32_t at) {
        const std::byte old = at < before.size() ? before[at] : std::byte{};
        return old != now[at];
    };
    for (uint32_t page = begin / image::kDirtyPage * image::kDirtyPage; page < end; page += image::kDirtyPage) {
        const uint32_t first = std::max(begin, page), last = std::min(end, page + image::kDirtyPage);
        const uint32_t number = page / image::kDirtyPage;
        if (!touchedPages.empty() && (number >= touchedPages.size() || touchedPages[number] == 0)) continue;
        if (last <= before.size() && std::memcmp(before.data() + first, now.data() + first, last - first) == 0)
            continue;
        for (uint32_t at = first; at < last; ++at) {
            if (!differs(at)) continue;
            if (patches.empty() || patches.back().offset + patches.back().bytes.size() != at)
                patches.push_back({at, {}});
            patches.back().bytes.push_back(now[at]);
        }
    }
    return patches;
}

} // namespace plc::history
