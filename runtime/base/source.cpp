#include "runtime/base/source.h"

#include <algorithm>

namespace plc {

SourceText::SourceText(std::string path, std::string text) : m_path(std::move(path)) {
    auto content = std::make_shared<Content>();
    content->text = std::move(text);
    content->lineBegins.push_back(0);
    for (size_t at = content->text.find('\n'); at != std::string::npos; at = content->text.find('\n', at + 1))
        content->lineBegins.push_back(static_cast<uint32_t>(at + 1));
    m_content = std::move(content);
}

std::string_view SourceText::slice(SourceRange range) const {
    const size_t begin = std::min<size_t>(range.begin, text().size());
    const size_t end = std::clamp<size_t>(range.end, begin, text().size());
    return text().substr(begin, end - begin);
}

LineColumn SourceText::lineColumn(uint32_t offset) const {
    offset = std::min<uint32_t>(offset, static_cast<uint32_t>(text().size()));
    const auto after = std::upper_bound(m_content->lineBegins.begin(), m_content->lineBegins.end(), offset);
    const uint32_t line = static_cast<uint32_t>(after - m_content->lineBegins.begin());
    uint32_t column = 1;
    for (uint32_t i = m_content->lineBegins[line - 1]; i < offset; ++i)
        if ((static_cast<unsigned char>(text()[i]) & 0xc0) != 0x80) ++column;
    return {line, column};
}

uint32_t SourceText::lineBegin(uint32_t line) const {
    if (line == 0) return 0;
    return line <= m_content->lineBegins.size() ? m_content->lineBegins[line - 1]
                                                : static_cast<uint32_t>(text().size());
}

std::string_view SourceText::line(uint32_t line) const {
    const uint32_t begin = lineBegin(line);
    uint32_t end = lineBegin(line + 1);
    while (end > begin && (text()[end - 1] == '\n' || text()[end - 1] == '\r')) --end;
    return text().substr(begin, end - begin);
}

FileId SourceSet::add(std::string path, std::string text) {
    files.emplace_back(std::move(path), std::move(text));
    return FileId(files.size() - 1);
}

} // namespace plc
