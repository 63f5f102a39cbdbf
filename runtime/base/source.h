// Source texts: a file's UTF-8 text, byte ranges into it, and line/column of a byte. Immutable after construction, so
// any thread may read; copies share the text, and what views it stays valid as long as one of them lives.
#pragma once
#include "runtime/base/ids.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace plc {

using FileId = Id<struct FileTag>;

/// Half-open range of bytes in one file.
struct SourceRange {
    FileId file;
    uint32_t begin = 0;
    uint32_t end = 0;
    [[nodiscard]] uint32_t length() const { return end - begin; }
    [[nodiscard]] bool contains(uint32_t at) const { return at >= begin && at < end; }
    bool operator==(const SourceRange&) const = default;
};
/// From the begin of `first` to the end of `last` (same file).
inline SourceRange joined(SourceRange first, SourceRange last) { return {first.file, first.begin, last.end}; }

/// 1-based; columns count Unicode characters.
struct LineColumn {
    uint32_t line = 1;
    uint32_t column = 1;
    bool operator==(const LineColumn&) const = default;
};

class SourceText {
public:
    SourceText(std::string path, std::string text);
    [[nodiscard]] const std::string& path() const { return m_path; }
    [[nodiscard]] std::string_view text() const { return m_content->text; }
    [[nodiscard]] std::string_view slice(SourceRange range) const;
    [[nodiscard]] LineColumn lineColumn(uint32_t offset) const;
    /// Offset of the first byte of the 1-based line; the text's size past the last line.
    [[nodiscard]] uint32_t lineBegin(uint32_t line) const;
    [[nodiscard]] std::string_view line(uint32_t line) const; // without its line end
    [[nodiscard]] uint32_t lineCount() const { return static_cast<uint32_t>(m_content->lineBegins.size()); }

private:
    struct Content {
        std::string text;
        std::vector<uint32_t> lineBegins;
    };
    std::string m_path;
    std::shared_ptr<const Content> m_content;
};

/// The files of one compilation; FileId indexes `files`.
struct SourceSet {
    std::vector<SourceText> files;
    FileId add(std::string path, std::string text);
    [[nodiscard]] const SourceText& operator[](FileId id) const { return files[id.index()]; }
};

} // namespace plc
