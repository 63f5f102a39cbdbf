// A recording on disk: what the programs were built from, then the segments as they lie in memory, each log in one
// piece. All numbers are little endian, as the image is. Written aside and renamed when complete; a checksum at the end
// tells a damaged file.
#include "runtime/base/messages.h"
#include "runtime/history/history_state.h"
#include "runtime/platform/files.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>

namespace plc::history {

namespace {

/// 01: without journal and library texts; still read.
constexpr char kMagic[8] = {'S', 'T', 'W', 'R', 'E', 'C', '0', '2'};
constexpr char kMagicBefore[8] = {'S', 'T', 'W', 'R', 'E', 'C', '0', '1'};

uint64_t mix(uint64_t hash, const void* bytes, size_t size) {
    const auto* at = static_cast<const unsigned char*>(bytes);
    for (; size >= 8; size -= 8, at += 8) {
        uint64_t word;
        std::memcpy(&word, at, 8);
        hash = (hash ^ word) * 1099511628211ull;
        hash ^= hash >> 29;
    }
    for (; size > 0; --size, ++at) hash = (hash ^ *at) * 1099511628211ull;
    return hash;
}

/// Where everything lies: a recording can only be shown by a program whose variables lie where they lay.
uint64_t layoutPrint(const image::Layout& layout) {
    uint64_t hash = mix(14695981039346656037ull, &layout.dataEnd, 4);
    for (const image::Root& root : layout.roots) {
        const std::string path = image::Layout::pathOf(root);
        hash = mix(mix(mix(hash, path.data(), path.size()), &root.offset, 4), &root.bit, 2);
        const types::Type& type = (*layout.types)[root.type];
        hash = mix(mix(hash, type.name.data(), type.name.size()), &type.size, 4);
        for (const types::Field& field : type.fields)
            hash = mix(mix(hash, field.name.data(), field.name.size()), &field.offset, 4);
    }
    return hash;
}

class Writer {
public:
    explicit Writer(int file) : m_file(file) { m_buffer.reserve(1 << 20); }
    void bytes(const void* data, size_t size) {
        m_hash = mix(m_hash, data, size);
        const auto* at = static_cast<const char*>(data);
        while (size > 0) {
            const size_t part = std::min(size, m_buffer.capacity() - m_buffer.size());
            m_buffer.insert(m_buffer.end(), at, at + part);
            at += part;
            size -= part;
            if (m_buffer.size() == m_buffer.capacity()) flush();
        }
    }
    template <class T> void number(T value) { bytes(&value, sizeof value); }
    void text(const std::string& value) {
        number(static_cast<uint64_t>(value.size()));
        bytes(value.data(), value.size());
    }
    [[nodiscard]] bool finish() {
        const uint64_t hash = m_hash;
        number(hash);
        flush();
        return m_isGood;
    }

private:
    void flush() {
        m_isGood = m_isGood && platform::writeAll(m_file, {m_buffer.data(), m_buffer.size()});
        m_buffer.clear();
    }
    int m_file;
    std::vector<char> m_buffer;
    uint64_t m_hash = 14695981039346656037ull;
    bool m_isGood = true;
};

class Reader {
public:
    explicit Reader(std::istream& in) : m_in(in) {}
    bool bytes(void* data, size_t size) {
        if (!m_isGood || !m_in.read(static_cast<char*>(data), static_cast<std::streamsize>(size))) {
            m_isGood = false;
            return false;
        }
        m_hash = mix(m_hash, data, size);
        return true;
    }
    template <class T> T number() {
        T value{};
        return bytes(&value, sizeof value) ? value : T{};
    }
    /// A count that cannot be true in a file of this size is damage.
    uint64_t count(uint64_t limit) {
        const auto value = number<uint64_t>();
        if (value > limit) m_isGood = false;
        return m_isGood ? value : 0;
    }
    std::string text(uint64_t limit) {
        std::string value(count(limit), '\0');
        return bytes(value.data(), value.size()) ? value : std::string();
    }
    [[nodiscard]] bool isGood() const { return m_isGood; }
    [[nodiscard]] uint64_t hash() const { return m_hash; }

private:
    std::istream& m_in;
    uint64_t m_hash = 14695981039346656037ull;
    bool m_isGood = true;
};

/// Index and size of the entry at `at` of that log; false when `room` bytes are too few for one.
bool measure(const Segment& s, uint32_t log, const std::byte* at, size_t room, uint32_t& index, uint32_t& size) {
    const auto head = [&](auto& value) {
        if (room < sizeof value) return false;
        std::memcpy(&value, at, sizeof value);
        index = value.index;
        return true;
    };
    if (log == s.blocks) {
        StampEntry stamp;
        size = sizeof stamp;
        return head(stamp);
    }
    if (log == s.blocks + 1) {
        JournalHead part;
        if (!head(part)) return false;
        size = static_cast<uint32_t>(sizeof part) + part.size;
        return size <= room && part.size <= kJournalPart;
    }
    EntryHead change;
    if (!head(change)) return false;
    size = static_cast<uint32_t>(sizeof change + 4 * std::popcount(change.mask));
    return size <= room;
}

/// A log's complete entries that lie before `count`, in one piece.
void collectLog(const Segment& s, uint32_t log, uint32_t count, std::vector<std::byte>& out) {
    out.clear();
    LogCursor cursor(s, log);
    while (const std::byte* entry = cursor.peek()) {
        uint32_t index = 0, size = 0;
        (void)measure(s, log, entry, kPage, index, size);
        if (index >= count) return;
        out.insert(out.end(), entry, entry + size);
        cursor.skip(size);
    }
}

/// False when it was cancelled halfway.
bool writeSegment(Writer& out, const Segment& s, uint64_t program, const Progress* progress) {
    const uint32_t count = s.count.load(std::memory_order_acquire);
    out.number(program);
    out.number(s.first);
    out.number(count);
    out.number(s.dataEnd);
    out.number(s.calendarOffset);
    out.bytes(s.keyframe.get(), size_t(s.blocks) * kBlock);
    std::vector<std::byte> log;
    for (uint32_t i = 0; i <= s.blocks + 1; ++i) {
        if (isCancelled(progress)) return false;
        collectLog(s, i, count, log);
        out.number(static_cast<uint64_t>(log.size()));
        out.bytes(log.data(), log.size());
    }
    return true;
}

} // namespace

Result<void> History::save(const std::string& path, Progress* progress) const {
    const Result<Position> saved = saveRange(path, {0, ~Position(0)}, progress);
    return saved ? Result<void>() : saved.error();
}

Result<Position> History::saveRange(const std::string& path, PositionRange range, Progress* progress) const {
    std::error_code none;
    if (std::filesystem::exists(path, none) && !std::filesystem::is_regular_file(path, none))
        return Error{errors::NotReplaceable(), path};
    const std::string aside = path + ".new";
    const auto refused = [&](int handle) -> Error {
        Error error{errors::RecordingNotWritten(errors::ofSystem(errno)), path};
        if (handle >= 0) (void)platform::closeFile(handle);
        platform::removeFile(aside);
        return error;
    };
    const int handle = platform::openToWrite(aside, platform::Existing::Emptied);
    if (handle < 0) return refused(handle);
    std::vector<ProgramOrigin> origins;
    std::vector<Branch> branches;
    std::vector<Mark> marks;
    {
        const std::lock_guard lock(m->mutex);
        origins = m->origins;
        branches = m->branches;
        marks = m->marks;
    }
    Writer out(handle);
    out.bytes(kMagic, sizeof kMagic);
    out.number(static_cast<uint64_t>(origins.size()));
    for (const ProgramOrigin& origin : origins) {
        out.number(origin.program ? layoutPrint(origin.program->layout) : uint64_t(0));
        out.number(static_cast<uint64_t>(origin.sources.size()));
        for (const auto& [name, text] : origin.sources) {
            out.text(name);
            out.text(text);
        }
        out.number(static_cast<uint64_t>(origin.libraries.size()));
        for (const std::string& library : origin.libraries) out.text(library);
        out.number(static_cast<uint64_t>(origin.libraryTexts.size()));
        for (const auto& [name, text] : origin.libraryTexts) {
            out.text(name);
            out.text(text);
        }
    }
    out.number(static_cast<uint64_t>(branches.size()));
    for (const Branch& branch : branches) {
        out.number(branch.first);
        out.number(branch.parent);
    }
    out.number(static_cast<uint64_t>(marks.size()));
    for (const Mark& mark : marks) {
        out.number(mark.position);
        out.number(static_cast<int64_t>(mark.time.count()));
        out.number(static_cast<int32_t>(mark.kind));
        out.text(errors::packed(mark.text));
    }
    const auto cancelled = [&] {
        (void)platform::closeFile(handle);
        platform::removeFile(aside);
        return Error{errors::Cancelled(), path};
    };
    Position last = range.begin;
    const uint64_t begin = m->firstSegment.load(), end = m->endSegment.load();
    for (uint64_t n = begin; n < end; ++n) {
        if (!goesOn(progress, static_cast<double>(n - begin) / static_cast<double>(end - begin))) return cancelled();
        const Epochs::Pin pin = m->epochs.pin();
        const Segment* s = m->segment(n);
        if (!s) continue; // evicted meanwhile
        if (s->first >= range.end || s->first + s->count.load(std::memory_order_acquire) <= range.begin) continue;
        last = s->first;
        const auto known = std::find_if(origins.begin(), origins.end(),
                                        [&](const ProgramOrigin& o) { return o.program == s->program; });
        if (!writeSegment(out, *s, static_cast<uint64_t>(known - origins.begin()), progress)) return cancelled();
    }
    out.number(~uint64_t(0)); // no more segments
    if (isCancelled(progress)) return cancelled();
    if (!out.finish() || !platform::syncFile(handle)) return refused(handle);
    if (!platform::closeFile(handle) || !platform::replaceFile(aside, path)) return refused(-1);
    return last;
}

namespace {

/// Puts a log read from the file into the segment, entry by entry; false when it makes no sense.
bool restoreLog(SegmentWriter& writer, const Segment& s, uint32_t log, uint32_t count,
                const std::vector<std::byte>& bytes) {
    size_t at = 0;
    uint32_t before = 0;
    while (at < bytes.size()) {
        uint32_t index = 0, size = 0;
        if (!measure(s, log, bytes.data() + at, bytes.size() - at, index, size)) return false;
        const bool isJournal = log == s.blocks + 1;
        // The first stamp was made by begin().
        if (log != s.blocks || at > 0) writer.addEntry(log, bytes.data() + at, size);
        if (index >= count || (at > 0 && (isJournal ? index < before : index <= before))) return false;
        before = index;
        at += size;
    }
    return true;
}

} // namespace

Result<std::unique_ptr<History>> History::load(const std::string& path, const Rebuild& rebuild, Progress* progress) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) return Error{errors::RecordingNotRead(errors::ofSystem(errno)), path};
    const auto size = static_cast<uint64_t>(file.tellg());
    file.seekg(0);
    const Error cancelled{errors::Cancelled(), path}, damaged{errors::RecordingDamaged(), path};
    Reader in(file);
    char magic[sizeof kMagic];
    if (!in.bytes(magic, sizeof magic)) return damaged;
    const bool hasJournal = std::memcmp(magic, kMagic, sizeof magic) == 0;
    if (!hasJournal && std::memcmp(magic, kMagicBefore, sizeof magic) != 0) return damaged;
    auto history = std::make_unique<History>(std::max<size_t>(size * 4, size_t(256) << 20));
    State& state = *history->m;
    std::vector<std::shared_ptr<const image::CompiledProgram>> programs;
    const uint64_t versions = in.count(size);
    for (uint64_t n = 0; n < versions && in.isGood(); ++n) {
        constexpr double kBuilt = 0.6; // of the whole; the rest is reading
        if (progress)
            progress->enter(kBuilt * static_cast<double>(n) / static_cast<double>(versions),
                            kBuilt * static_cast<double>(n + 1) / static_cast<double>(versions));
        const auto print = in.number<uint64_t>();
        ProgramOrigin origin;
        for (uint64_t i = in.count(size); i > 0 && in.isGood(); --i) {
            std::string name = in.text(size);
            origin.sources.emplace_back(std::move(name), in.text(size));
        }
        for (uint64_t i = in.count(size); i > 0 && in.isGood(); --i) origin.libraries.push_back(in.text(size));
        for (uint64_t i = hasJournal ? in.count(size) : 0; i > 0 && in.isGood(); --i) {
            std::string name = in.text(size);
            origin.libraryTexts.emplace_back(std::move(name), in.text(size));
        }
        if (!in.isGood()) return damaged;
        origin.program = rebuild({origin.sources, origin.libraries, origin.libraryTexts});
        if (isCancelled(progress)) return cancelled;
        if (!origin.program) return Error{errors::RecordingNotBuilt(), path};
        if (layoutPrint(origin.program->layout) != print) return Error{errors::RecordingLayoutDiffers(), path};
        programs.push_back(origin.program);
        state.origins.push_back(std::move(origin));
    }
    for (uint64_t n = in.count(size); n > 0 && in.isGood(); --n) {
        const auto first = in.number<Position>();
        state.branches.push_back({first, in.number<Position>()});
    }
    for (uint64_t n = in.count(size); n > 0 && in.isGood(); --n) {
        Mark mark;
        mark.position = in.number<Position>();
        mark.time = Nanoseconds(in.number<int64_t>());
        mark.kind = in.number<int32_t>();
        mark.text = errors::unpacked(in.text(size));
        state.marks.push_back(std::move(mark));
    }
    bool isFirst = true;
    if (progress) progress->enter(progress->share(), 1);
    for (;;) {
        if (!goesOn(progress, static_cast<double>(file.tellg()) / static_cast<double>(size))) return cancelled;
        const auto program = in.number<uint64_t>();
        if (!in.isGood()) return damaged;
        if (program == ~uint64_t(0)) break;
        const auto first = in.number<Position>();
        const auto count = in.number<uint32_t>();
        const auto dataEnd = in.number<uint32_t>();
        state.calendarOffset = in.number<int64_t>();
        if (!in.isGood() || program >= programs.size() || count == 0 || count > kScansPerSegment ||
            dataEnd != programs[program]->layout.dataEnd || dataEnd > size)
            return damaged;
        if (!isFirst && first < state.end.load()) return damaged;
        isFirst = false;
        state.program = programs[program];
        state.end.store(first);
        std::vector<std::byte> keyframe((size_t(dataEnd) + kBlock - 1) / kBlock * kBlock);
        if (!in.bytes(keyframe.data(), keyframe.size())) return damaged;
        std::vector<std::vector<std::byte>> logs(keyframe.size() / kBlock + (hasJournal ? 2 : 1));
        size_t total = 0;
        for (std::vector<std::byte>& log : logs) {
            log.resize(in.count(size));
            if (!log.empty() && !in.bytes(log.data(), log.size())) return damaged;
            total += log.size();
        }
        StampEntry stamp{};
        const std::vector<std::byte>& stamps = logs[keyframe.size() / kBlock];
        if (stamps.size() < sizeof stamp) return damaged;
        std::memcpy(&stamp, stamps.data(), sizeof stamp);
        Segment& s = state.beginSegment(dataEnd);
        const auto pages = static_cast<uint32_t>(total / (kPage / 2) + s.blocks / 15 + 8);
        if (pages > s.pageCapacity) {
            s.pageCapacity = pages;
            s.pages = std::make_unique<PageBytes[]>(pages);
        }
        state.writer.begin(s, keyframe.data(), stamp.scan, stamp.time);
        // begin() guessed the step; take the recorded first stamp as it was.
        state.writer.replaceFirstStamp(stamp);
        bool isGood = true;
        for (uint32_t i = 0; i < logs.size() && isGood; ++i) isGood = restoreLog(state.writer, s, i, count, logs[i]);
        s.count.store(count, std::memory_order_release);
        state.publishSegment();
        state.bytes.fetch_add(s.pageCount * size_t(kPage));
        state.end.store(first + count);
        if (!isGood) return damaged;
    }
    const uint64_t hash = in.hash();
    if (in.number<uint64_t>() != hash || !in.isGood()) return damaged;
    state.programChanged = true; // whatever is appended begins a segment of its own
    return history;
}

} // namespace plc::history
