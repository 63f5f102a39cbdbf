// Messages out of a stream of bytes that anybody may have sent, and back: each behind a head with its length (LSP, DAP)
// or each on a line of its own (MCP). A message that is too long is skipped, never kept. Belongs to one thread.
#pragma once
#include "runtime/base/result.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace plc::protocol {

enum class Framing : uint8_t { Heads, Lines };

struct FramingLimits {
    size_t head = 4096;
    size_t message = size_t(64) << 20;
};

class MessageReader {
public:
    explicit MessageReader(Framing framing, FramingLimits limits = {}) : m_framing(framing), m_limits(limits) {}
    void feed(std::string_view bytes);
    /// The next whole message, or why there is none in its place; nothing: more bytes are needed.
    [[nodiscard]] std::optional<Result<std::string>> next();
    /// Where the next message begins is not known any more.
    [[nodiscard]] bool isBroken() const { return m_isBroken; }

private:
    [[nodiscard]] std::optional<Result<std::string>> nextWithHead();
    [[nodiscard]] std::optional<Result<std::string>> nextLine();
    [[nodiscard]] Error broken(Message why);
    void drop(size_t bytes);

    Framing m_framing;
    FramingLimits m_limits;
    std::string m_bytes;
    size_t m_begin = 0;       // of what is not read yet
    uint64_t m_skip = 0;      // bytes of a message that is left out
    bool m_skipsLine = false; // likewise, to the end of the line
    size_t m_searched = 0;    // of the line, without an end
    bool m_isBroken = false;
};

/// As it goes over the wire. `text` holds no line end for Lines.
[[nodiscard]] std::string framed(Framing framing, std::string_view text);

} // namespace plc::protocol
