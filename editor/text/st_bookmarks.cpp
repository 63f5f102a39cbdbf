// Bookmarks: marks of lines that one comes back to.
#include "editor/text/st_editor.h"
#include "editor/text/st_marks.h"

namespace plc::editor {

using S = QsciScintillaBase;

void StEditor::toggleBookmark(int line) {
    const auto at = static_cast<unsigned long>(line);
    const bool isSet = SendScintilla(S::SCI_MARKERGET, at) & (1 << kBookmark);
    SendScintilla(isSet ? S::SCI_MARKERDELETE : S::SCI_MARKERADD, at, static_cast<long>(kBookmark));
    emit bookmarksChanged();
}

std::set<int> StEditor::bookmarks() const {
    std::set<int> out;
    for (long line = 0;
         (line = SendScintilla(S::SCI_MARKERNEXT, static_cast<unsigned long>(line), 1L << kBookmark)) >= 0; ++line)
        out.insert(static_cast<int>(line) + 1);
    return out;
}

void StEditor::goToBookmark(int direction) {
    const std::set<int> all = bookmarks();
    if (all.empty()) return;
    const int here =
        static_cast<int>(SendScintilla(S::SCI_LINEFROMPOSITION, static_cast<unsigned long>(cursorOffset()))) + 1;
    if (direction > 0) {
        const auto next = all.upper_bound(here);
        return goToLine(next == all.end() ? *all.begin() : *next);
    }
    const auto from = all.lower_bound(here);
    goToLine(from == all.begin() ? *all.rbegin() : *std::prev(from));
}

} // namespace plc::editor
