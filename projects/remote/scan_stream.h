// Scans over a wire: what acted on each from outside, and its image as what differs from the one before, in 64-byte
// blocks. The reader checks every length and place: what it reads was sent by somebody. Each side belongs to one
// thread.
#pragma once
#include "runtime/history/journal.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plc::remote {

/// What the first byte of a binary message says.
enum class Piece : uint8_t { Scans = 1, Standing = 2, Recording = 3 };

struct StreamedScan {
    uint64_t scan = 0;
    std::chrono::nanoseconds time{};
    std::span<const std::byte> image;
    const image::Outside* outside = nullptr; // as it was read; none: nothing acted on it
};

class ScanWriter {
public:
    /// The next scan is sent whole.
    void restart() { m_before.clear(); }
    /// `journal`: the bytes of an entry with its start, or none.
    void write(std::string& out, const StreamedScan& scan, std::span<const std::byte> journal = {});

private:
    std::vector<std::byte> m_before;
};

class ScanReader {
public:
    ScanReader() = default;
    /// `program` runs there, too.
    explicit ScanReader(std::shared_ptr<const image::CompiledProgram> program);
    /// False: they are not scans of that program; nothing can be read after that.
    [[nodiscard]] bool read(std::string_view bytes, const std::function<void(const StreamedScan&)>& visit);

private:
    [[nodiscard]] bool readJournal(std::span<const std::byte> bytes);
    [[nodiscard]] bool readImage(std::string_view& bytes);
    std::shared_ptr<const image::CompiledProgram> m_program;
    std::vector<std::byte> m_image, m_began; // after the scan before; what this one began from
    history::JournalEntry m_journal;
};

void putNumber(std::string& out, uint64_t number);
/// Takes it off the front; false when there is not enough.
[[nodiscard]] bool takeNumber(std::string_view& bytes, uint64_t& number);

} // namespace plc::remote
