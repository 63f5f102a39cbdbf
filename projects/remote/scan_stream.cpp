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

void ScanWriter::write(std::string& out, const StreamedScan& scan) {
    if (m_before.size() != scan.image.size()) m_before.assign(scan.image.size(), std::byte(0));
    putNumber(out, scan.scan);
    putNumber(out, static_cast<uint64_t>(scan.time.count()));
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

bool ScanReader::read(std::string_view bytes, const std::function<void(const StreamedScan&)>& visit) {
    while (!bytes.empty()) {
        uint64_t scan = 0, time = 0, length = 0, skipped = 0;
        if (!takeNumber(bytes, scan) || !takeNumber(bytes, time)) return false;
        for (size_t at = 0;;) {
            if (!takeNumber(bytes, length)) return false;
            if (length == 0) break;
            if (!takeNumber(bytes, skipped) || length > bytes.size()) return false;
            if (skipped > m_image.size() - at || length > m_image.size() - at - skipped) return false;
            at += skipped;
            std::memcpy(m_image.data() + at, bytes.data(), length);
            bytes.remove_prefix(length);
            at += length;
        }
        visit({scan, std::chrono::nanoseconds(static_cast<int64_t>(time)), m_image});
    }
    return true;
}

} // namespace plc::remote
