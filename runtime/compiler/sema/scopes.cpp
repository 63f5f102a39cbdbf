
#include "runtime/compiler/sema/scopes.h"
#include "runtime/compiler/sema/context.h"

#include "runtime/base/text.h"

namespace plc::sema {

namespace {

// Each identifier of a program is looked up, most of them several times, at each keystroke. Beyond ASCII, case folding
// may change the length, so foldCase does it.
/// Folds short ASCII names without allocating.
struct Folded {
    explicit Folded(std::string_view spelling) {
        if (spelling.size() <= sizeof buffer) {
            bool ascii = true;
            for (size_t i = 0; i < spelling.size(); ++i) {
                const char c = spelling[i];
                ascii = ascii && static_cast<unsigned char>(c) < 0x80;
                buffer[i] = c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
            }
            if (ascii) {
                view = {buffer, spelling.size()};
                return;
            }
        }
        text = foldCase(spelling);
        view = text;
    }
    char buffer[64];
    std::string text;
    std::string_view view;
};

} // namespace

NameId Names::intern(std::string_view spelling) {
    const Folded folded(spelling);
    if (const auto it = m_ids.find(folded.view); it != m_ids.end()) return NameId(it->second);
    const auto id = static_cast<uint32_t>(m_texts.size());
    m_texts.emplace_back(folded.view);
    // The key points into m_texts, whose elements never move.
    m_ids.emplace(m_texts.back(), id);
    return NameId(id);
}

NameId Names::find(std::string_view spelling) const {
    const Folded folded(spelling);
    const auto it = m_ids.find(folded.view);
    return it == m_ids.end() ? NameId() : NameId(it->second);
}

} // namespace plc::sema
