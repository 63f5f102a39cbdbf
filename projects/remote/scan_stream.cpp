#include "projects/remote/scan_stream.h"

#include <algorithm>
#include <cstring>

namespace plc::remote {

namespace {

constexpr size_t kBlock = 64;

/// [begin, end) of the next blocks that differ; begin == size: none.
std::pair<size_t, size_t> nextChange(std::span<const std::byte> now, std::span<const std::byte> before, size_t from) {
    const auto differs = [&](size_t at) {
        const size_t length = std::min(kBlock, now.size() - at);
        return std::memcmp(now.data() + at, before.data() + at, length) != 0;
    };
    size_t begin = from;
    while (begin < now.size() && !differs(begin)) begin += kBlock;
    size_t end = begin;
    while (end < now.size() && differs(end)) end += kBlock;
    return {std::min(begin, now.size()), std::min(end, now.size())};
}

bool isWithin(size_t offset, size_t length, size_t size) { return offset <= size && length <= size - offset; }
bool isBit(int16_t bit) { return bit >= -1 && bit < 8; }

/// Whether everything in it has its place in the image of that program: it is put there when the scan is looked into.
bool fits(const history::JournalEntry& entry, const image::Layout& layout) {
    const auto patchFits = [&](const history::Patch& each) {
        return isWithin(each.offset, each.bytes.size(), layout.dataEnd);
    };
    const auto forceFits = [&](const image::ForcedBytes& each) {
        return isWithin(each.offset, each.bytes.size(), layout.dataEnd) && isBit(each.bit) && !each.bytes.empty();
    };
    const auto noteFits = [&](const image::OutsideNote& each) {
        return isWithin(each.offset, each.size, layout.imageSize) && isBit(each.bit) &&
               (each.bytes.size() == each.size || (each.site == 0 && each.bytes.empty()));
    };
    return entry.start && !entry.startIsPartial && std::all_of(entry.patch.begin(), entry.patch.end(), patchFits) &&
           std::all_of(entry.start->forces.begin(), entry.start->forces.end(), forceFits) &&
           std::all_of(entry.notes.begin(), entry.notes.end(), noteFits);
}

} // namespace

void putNumber(std::string& out, uint64_t number) {
    do {
        out += static_cast<char>((number & 127) | (number > 127 ? 128 : 0));
        number >>= 7;
    } while (number > 0);
}

bool takeNumber(std::string_view& bytes, uint64_t& number) {
    number = 0;
    for (unsigned shift = 0; shift < 64 && !bytes.empty(); shift += 7) {
        const auto byte = static_cast<uint8_t>(bytes.front());
        bytes.remove_prefix(1);
        number |= uint64_t(byte & 127) << shift;
        if ((byte & 128) == 0) return true;
    }
    return false;
}

void ScanWriter::write(std::string& out, const StreamedScan& scan, std::span<const std::byte> journal) {
    if (m_before.size() != scan.image.size()) m_before.assign(scan.image.size(), std::byte(0));
    putNumber(out, scan.scan);
    putNumber(out, static_cast<uint64_t>(scan.time.count()));
    putNumber(out, journal.size());
    out.append(reinterpret_cast<const char*>(journal.data()), journal.size());
    size_t at = 0;
    for (;;) {
        const auto [begin, end] = nextChange(scan.image, m_before, at);
        putNumber(out, end - begin); // 0: that was all
        if (begin == end) break;
        putNumber(out, begin - at);
        out.append(reinterpret_cast<const char*>(scan.image.data()) + begin, end - begin);
        at = end;
    }
    std::copy(scan.image.begin(), scan.image.end(), m_before.begin());
}

ScanReader::ScanReader(std::shared_ptr<const image::CompiledProgram> program)
    : m_program(std::move(program)), m_image(m_program->layout.dataEnd) {}

/// None of its bytes: nothing acted.
bool ScanReader::readJournal(std::span<const std::byte> bytes) {
    if (bytes.empty()) return true;
    std::optional<history::JournalEntry> entry = history::readEntry(bytes);
    if (!entry || !fits(*entry, m_program->layout)) return false;
    m_journal = std::move(*entry);
    m_began = m_journal.isFresh ? m_program->initialImage : m_image;
    m_began.resize(m_image.size());
    for (const history::Patch& patch : m_journal.patch)
        std::copy(patch.bytes.begin(), patch.bytes.end(), m_began.begin() + patch.offset);
    return true;
}

bool ScanReader::readImage(std::string_view& bytes) {
    uint64_t length = 0, skipped = 0;
    for (size_t at = 0;;) {
        if (!takeNumber(bytes, length)) return false;
        if (length == 0) return true;
        if (!takeNumber(bytes, skipped) || length > bytes.size()) return false;
        if (!isWithin(skipped, length, m_image.size() - at)) return false;
        at += skipped;
        std::memcpy(m_image.data() + at, bytes.data(), length);
        bytes.remove_prefix(length);
        at += length;
    }
}

bool ScanReader::read(std::string_view bytes, const std::function<void(const StreamedScan&)>& visit) {
    while (!bytes.empty()) {
        uint64_t scan = 0, time = 0, journal = 0;
        if (!takeNumber(bytes, scan) || !takeNumber(bytes, time) || !takeNumber(bytes, journal)) return false;
        if (journal > bytes.size() || !readJournal(std::as_bytes(std::span(bytes.substr(0, journal))))) return false;
        bytes.remove_prefix(journal);
        if (!readImage(bytes)) return false;
        const std::chrono::nanoseconds at(static_cast<int64_t>(time));
        if (journal == 0) {
            visit({scan, at, m_image});
            continue;
        }
        const image::Outside outside{m_began, {}, *m_journal.start, m_journal.notes};
        visit({scan, at, m_image, &outside});
    }
    return true;
}

} // namespace plc::remote
