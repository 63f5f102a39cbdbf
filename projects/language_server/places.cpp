#include "projects/language_server/places.h"

#include "runtime/base/text.h"

#include <algorithm>
#include <filesystem>

namespace plc::lsp {

namespace {

uint32_t unitsOf(char32_t character) { return character > 0xffff ? 2 : 1; }

int hexOf(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

std::string decoded(std::string_view text) {
    std::string out;
    for (size_t i = 0; i < text.size(); ++i) {
        const bool isEscape =
            text[i] == '%' && i + 2 < text.size() && hexOf(text[i + 1]) >= 0 && hexOf(text[i + 2]) >= 0;
        out += isEscape ? static_cast<char>(hexOf(text[i + 1]) * 16 + hexOf(text[i + 2])) : text[i];
        if (isEscape) i += 2;
    }
    return out;
}

} // namespace

Places::Places(std::string text) : m_text(std::move(text)), m_begins{0} {
    for (uint32_t i = 0; i < m_text.size(); ++i) {
        const bool isPair = m_text[i] == '\r' && i + 1 < m_text.size() && m_text[i + 1] == '\n';
        if (m_text[i] == '\n' || (m_text[i] == '\r' && !isPair)) m_begins.push_back(i + 1);
    }
}

uint32_t Places::endOf(uint32_t line) const {
    if (line + 1 >= m_begins.size()) return static_cast<uint32_t>(m_text.size());
    uint32_t end = m_begins[line + 1] - 1;
    if (end > m_begins[line] && m_text[end] == '\n' && m_text[end - 1] == '\r') --end;
    return end;
}

Position Places::positionOf(uint32_t offset) const {
    offset = std::min(offset, static_cast<uint32_t>(m_text.size()));
    const auto next = std::upper_bound(m_begins.begin(), m_begins.end(), offset);
    Position position{static_cast<uint32_t>(next - m_begins.begin()) - 1, 0};
    for (size_t at = m_begins[position.line]; at < offset;) position.character += unitsOf(decodeUtf8(m_text, at));
    return position;
}

uint32_t Places::offsetOf(Position position) const {
    if (position.line >= m_begins.size()) return static_cast<uint32_t>(m_text.size());
    const uint32_t end = endOf(position.line);
    size_t at = m_begins[position.line];
    for (uint32_t units = 0; at < end && units < position.character;) {
        size_t behind = at;
        units += unitsOf(decodeUtf8(m_text, behind));
        if (units > position.character) break; // between the halves of a pair
        at = behind;
    }
    return std::min(static_cast<uint32_t>(at), end);
}

Json Places::range(uint32_t begin, uint32_t end) const {
    return {{"start", toJson(positionOf(begin))}, {"end", toJson(positionOf(std::max(begin, end)))}};
}

Json toJson(Position position) { return {{"line", position.line}, {"character", position.character}}; }

std::optional<Position> positionAt(const Json& json, std::string_view path) {
    const Json* at = protocol::find(json, path);
    if (!at) return std::nullopt;
    const auto line = protocol::integerAt(*at, "line"), character = protocol::integerAt(*at, "character");
    if (!line || !character || *line < 0 || *character < 0) return std::nullopt;
    const auto limited = [](int64_t number) { return static_cast<uint32_t>(std::min<int64_t>(number, UINT32_MAX)); };
    return Position{limited(*line), limited(*character)};
}

std::optional<std::string> pathOfUri(std::string_view uri) {
    constexpr std::string_view kScheme = "file://";
    if (!uri.starts_with(kScheme)) return std::nullopt;
    const size_t slash = uri.find('/', kScheme.size()); // behind the host
    if (slash == std::string_view::npos) return std::nullopt;
    std::string path = decoded(uri.substr(slash));
    if (path.find('\0') != std::string::npos) return std::nullopt;
    return std::filesystem::path(path).lexically_normal().string();
}

std::string uriOfPath(std::string_view path) {
    static constexpr char kDigits[] = "0123456789ABCDEF";
    if (!path.starts_with('/')) return std::string(path); // a text without a file is known by its URI
    std::string out = "file://";
    for (const char c : path) {
        const auto byte = static_cast<unsigned char>(c);
        const bool isPlain =
            (byte < 0x80 && std::isalnum(byte)) || std::string_view("/-._~").find(c) != std::string::npos;
        if (isPlain)
            out += c;
        else
            out += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
    }
    return out;
}

} // namespace plc::lsp
