#include "runtime/image/path_reader.h"
#include "runtime/base/messages.h"

#include "runtime/base/text.h"

#include <charconv>
#include <optional>

namespace plc::image {

namespace {

class Reader {
public:
    explicit Reader(std::string_view text) : m_text(text) {}

    Result<std::vector<PathPart>> run() {
        if (m_text.empty()) return Error{errors::PathEmpty(), {}};
        if (!name()) return failure();
        while (m_at < m_text.size()) {
            skipBlanks();
            if (m_at == m_text.size()) break;
            const bool good = m_text[m_at] == '.' ? afterPoint() : m_text[m_at] == '[' ? indices() : false;
            if (!good) return failure();
        }
        return std::move(m_parts);
    }

private:
    void skipBlanks() {
        while (m_at < m_text.size() && (m_text[m_at] == ' ' || m_text[m_at] == '\t')) ++m_at;
    }
    Error failure() const {
        const std::string_view rest = m_text.substr(std::min(m_at, m_text.size()));
        return Error{rest.empty() ? errors::PathIncomplete() : errors::PathUnreadable(rest), std::string(m_text)};
    }
    bool isDigit() const { return m_at < m_text.size() && m_text[m_at] >= '0' && m_text[m_at] <= '9'; }

    bool name() {
        skipBlanks();
        PathPart part;
        if (m_at < m_text.size() && m_text[m_at] == '#') ++m_at;
        if (m_at < m_text.size() && m_text[m_at] == '"') {
            const size_t end = m_text.find('"', m_at + 1);
            if (end == std::string_view::npos || end == m_at + 1) return false;
            part.name = m_text.substr(m_at + 1, end - m_at - 1);
            m_at = end + 1;
        } else {
            const size_t begin = m_at;
            while (m_at < m_text.size()) {
                size_t next = m_at;
                const char32_t c = decodeUtf8(m_text, next);
                const bool inside = c == '_' || isNameLetter(c) || (m_at > begin && c >= '0' && c <= '9');
                if (!inside) break;
                m_at = next;
            }
            if (m_at == begin) return false;
            part.name = m_text.substr(begin, m_at - begin);
        }
        m_parts.push_back(std::move(part));
        return true;
    }

    std::optional<int64_t> number() {
        skipBlanks();
        int64_t value = 0;
        const auto [end, error] = std::from_chars(m_text.data() + m_at, m_text.data() + m_text.size(), value);
        if (error != std::errc()) return std::nullopt;
        m_at = static_cast<size_t>(end - m_text.data());
        return value;
    }

    bool afterPoint() {
        ++m_at;
        skipBlanks();
        unsigned bits = 1;
        if (m_at + 1 < m_text.size() && m_text[m_at] == '%') {
            switch (m_text[m_at + 1]) {
            case 'X':
            case 'x':
                bits = 1;
                break;
            case 'B':
            case 'b':
                bits = 8;
                break;
            case 'W':
            case 'w':
                bits = 16;
                break;
            case 'D':
            case 'd':
                bits = 32;
                break;
            default:
                return false;
            }
            m_at += 2;
            if (!isDigit()) return false;
        }
        if (!isDigit()) return name();
        const std::optional<int64_t> index = number();
        if (!index) return false;
        PathPart part;
        part.kind = PathPart::Kind::Slice;
        part.sliceIndex = static_cast<uint32_t>(std::min<int64_t>(*index, 1 << 20));
        part.sliceBits = bits;
        m_parts.push_back(std::move(part));
        return true;
    }

    bool indices() {
        PathPart part;
        part.kind = PathPart::Kind::Index;
        do {
            ++m_at; // '[' or ','
            const std::optional<int64_t> index = number();
            if (!index) return false;
            part.indices.push_back(*index);
            skipBlanks();
        } while (m_at < m_text.size() && m_text[m_at] == ',');
        if (m_at == m_text.size() || m_text[m_at] != ']') return false;
        ++m_at;
        m_parts.push_back(std::move(part));
        return true;
    }

    std::string_view m_text;
    size_t m_at = 0;
    std::vector<PathPart> m_parts;
};

} // namespace

Result<std::vector<PathPart>> readPath(std::string_view path) { return Reader(path).run(); }

} // namespace plc::image
