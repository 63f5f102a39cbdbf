#include "runtime/base/source.h"

#include <algorithm>

namespace plc {

SourceText::SourceText(std::string path, std::string text) : m_path(std::move(path)), m_text(std::move(text)) {
    m_lineBegins.push_back(0);
    for (uint32_t i = 0; i < m_text.size(); ++i)
        if (m_text[i] == '\n') m_lineBegins.push_back(i + 1);
}

std::string_view SourceText::slice(SourceRange range) const {
    const size_t begin = std::min<size_t>(range.begin, m_text.size());
    const size_t end = std::clamp<size_t>(range.end, begin, m_text.size());
    return text().substr(begin, end - begin);
}

LineColumn SourceText::lineColumn(uint32_t offset) const {
    offset = std::min<uint32_t>(offset, static_cast<uint32_t>(m_text.size()));
    const auto after = std::upper_bound(m_lineBegins.begin(), m_lineBegins.end(), offset);
    const uint32_t line = static_cast<uint32_t>(after - m_lineBegins.begin());
    uint32_t column = 1;
    for (uint32_t i = m_lineBegins[line - 1]; i < offset; ++i)
        if ((static_cast<unsigned char>(m_text[i]) & 0xc0) != 0x80) ++column;
    return {line, column};
}

uint32_t SourceText::lineBegin(uint32_t line) const {
    if (line == 0) return 0;
    return line <= m_lineBegins.size() ? m_lineBegins[line - 1] : static_cast<uint32_t>(m_text.size());
}

std::string_view SourceText::line(uint32_t line) const {
    const uint32_t begin = lineBegin(line);
    uint32_t end = lineBegin(line + 1);
    while (end > begin && (m_text[end - 1] == '\n' || m_text[end - 1] == '\r')) --end;
    return text().substr(begin, end - begin);
}

FileId SourceSet::add(std::string path, std::string text) {
    files.emplace_back(std::move(path), std::move(text));
    return FileId(files.size() - 1);
}

} // namespace plc
