#include "editor/debug/text_place.h"

#include "editor/debug/line_map.h"

namespace plc::editor {

std::optional<TextPlace> placeInText(SourceRange range, const image::CompiledProgram& program, const TextNow& textNow) {
    if (!range.file.isValid() || range.file.index() >= program.sources.files.size()) return std::nullopt;
    const SourceText& built = program.sources[range.file];
    TextPlace place;
    place.file = QString::fromStdString(built.path());
    place.line = static_cast<int>(built.lineColumn(range.begin).line);
    place.offset = range.begin;
    place.length = range.length();
    const std::string now = textNow(place.file, built);
    if (now == built.text()) return place;
    const uint32_t column = range.begin - built.lineBegin(static_cast<uint32_t>(place.line));
    const LineMap map(built.text(), now);
    const bool isSame = map.exact(place.line).has_value();
    place.line = map.nearest(place.line);
    size_t begin = 0;
    for (int line = 1; line < place.line && begin != std::string::npos; ++line) begin = now.find('\n', begin) + 1;
    place.offset = static_cast<uint32_t>(begin) + (isSame ? column : 0);
    if (!isSame) place.length = 0;
    return place;
}

} // namespace plc::editor
