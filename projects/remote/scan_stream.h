// Scans over a wire: each image as what differs from the one before, in 64-byte blocks. The reader checks every length:
// what it reads was sent by somebody. Each side belongs to one thread.
#pragma once
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
};

class ScanWriter {
public:
    /// The next scan is sent whole.
    void restart() { m_before.clear(); }
    void write(std::string& out, const StreamedScan& scan);

private:
    std::vector<std::byte> m_before;
};

class ScanReader {
public:
    ScanReader() = default;
    /// `size`: of the images of the program that runs there.
    explicit ScanReader(size_t size) : m_image(size) {}
    /// False: they are not scans of that program; nothing can be read after that.
    [[nodiscard]] bool read(std::string_view bytes, const std::function<void(const StreamedScan&)>& visit);

private:
    std::vector<std::byte> m_image;
};

void putNumber(std::string& out, uint64_t number);
/// Takes it off the front; false when there is not enough.
[[nodiscard]] bool takeNumber(std::string_view& bytes, uint64_t& number);

} // namespace plc::remote
