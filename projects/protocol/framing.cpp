#include "projects/protocol/framing.h"

#include "projects/protocol/errors.h"
#include "runtime/base/chars.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <charconv>

namespace plc::protocol {

namespace {

/// The one Content-Length of a head.
std::optional<uint64_t> lengthOf(std::string_view head) {
    std::optional<uint64_t> length;
    while (!head.empty()) {
        const size_t end = std::min(head.find('\n'), head.size());
        const std::string_view line = trimmed(head.substr(0, end));
        head.remove_prefix(std::min(end + 1, head.size()));
        const size_t colon = line.find(':');
        if (colon == std::string_view::npos) return std::nullopt;
        if (!equalsIgnoringCase(trimmed(line.substr(0, colon)), "Content-Length")) continue;
        const std::string_view digits = trimmed(line.substr(colon + 1));
        uint64_t number = 0;
        const auto [rest, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
        if (length || problem != std::errc() || rest != digits.data() + digits.size()) return std::nullopt;
        length = number;
    }
    return length;
}

} // namespace

void MessageReader::feed(std::string_view bytes) {
    if (m_isBroken) return;
    const auto skipped = static_cast<size_t>(std::min<uint64_t>(m_skip, bytes.size()));
    m_skip -= skipped;
    m_bytes.append(bytes.substr(skipped));
}

void MessageReader::drop(size_t bytes) {
    m_begin += bytes;
    if (m_begin < m_bytes.size() && m_begin < (size_t(1) << 16)) return;
    m_bytes.erase(0, m_begin);
    m_begin = 0;
}

Error MessageReader::broken(Message why) {
    m_isBroken = true;
    m_bytes.clear();
    m_begin = 0;
    return {std::move(why), {}};
}

std::optional<Result<std::string>> MessageReader::next() {
    if (m_isBroken) return std::nullopt;
    return m_framing == Framing::Heads ? nextWithHead() : nextLine();
}

std::optional<Result<std::string>> MessageReader::nextWithHead() {
    const std::string_view rest = std::string_view(m_bytes).substr(m_begin);
    if (rest.empty()) return std::nullopt;
    const size_t end = rest.substr(0, m_limits.head).find("\r\n\r\n");
    if (end == std::string_view::npos) {
        if (rest.size() < m_limits.head) return std::nullopt;
        return broken(errors::HeadTooLong(m_limits.head));
    }
    const std::optional<uint64_t> length = lengthOf(rest.substr(0, end));
    if (!length) return broken(errors::HeadUnreadable());
    const size_t body = end + 4;
    if (*length > m_limits.message) {
        const uint64_t here = std::min<uint64_t>(*length, rest.size() - body);
        m_skip = *length - here;
        drop(body + static_cast<size_t>(here));
        return Error{errors::MessageTooLong(m_limits.message), {}};
    }
    if (rest.size() - body < *length) return std::nullopt;
    std::string text(rest.substr(body, static_cast<size_t>(*length)));
    drop(body + text.size());
    return text;
}

std::optional<Result<std::string>> MessageReader::nextLine() {
    for (;;) {
        const std::string_view rest = std::string_view(m_bytes).substr(m_begin);
        const size_t end = rest.find('\n', m_searched);
        if (end == std::string_view::npos) {
            m_searched = rest.size();
            if (!m_skipsLine && rest.size() <= m_limits.message) return std::nullopt;
            drop(rest.size());
            m_searched = 0;
            if (std::exchange(m_skipsLine, true)) return std::nullopt;
            return Error{errors::MessageTooLong(m_limits.message), {}};
        }
        std::string line(trimmed(rest.substr(0, end)));
        drop(end + 1);
        m_searched = 0;
        if (std::exchange(m_skipsLine, false) || line.empty()) continue;
        if (line.size() > m_limits.message) return Error{errors::MessageTooLong(m_limits.message), {}};
        return line;
    }
}

std::string framed(Framing framing, std::string_view text) {
    if (framing == Framing::Lines) return std::string(text) + "\n";
    return "Content-Length: " + std::to_string(text.size()) + "\r\n\r\n" + std::string(text);
}

} // namespace plc::protocol
