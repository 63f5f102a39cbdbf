#include "runtime/diagnostics/text_edits.h"

namespace plc::diagnostics {

std::string applyEdits(std::string_view text, const Edits& edits) {
    std::string out;
    size_t at = 0;
    for (const TextEdit& edit : edits) {
        out.append(text.substr(at, edit.range.begin - at));
        out += edit.text;
        at = edit.range.end;
    }
    out.append(text.substr(at));
    return out;
}

Edits inverseOf(std::string_view text, const Edits& edits) {
    Edits out;
    int64_t shift = 0;
    for (const TextEdit& edit : edits) {
        const auto begin = static_cast<uint32_t>(edit.range.begin + shift);
        out.push_back({{edit.range.file, begin, begin + static_cast<uint32_t>(edit.text.size())},
                       std::string(text.substr(edit.range.begin, edit.range.length()))});
        shift += static_cast<int64_t>(edit.text.size()) - edit.range.length();
    }
    return out;
}

} // namespace plc::diagnostics
