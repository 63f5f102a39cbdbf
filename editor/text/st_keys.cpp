#include "editor/text/st_keys.h"

#include "editor/text/st_editor.h"

#include <QApplication>
#include <QHelpEvent>

namespace plc::editor {

using S = QsciScintillaBase;

void toggleFold(StEditor& editor) {
    const auto at = static_cast<unsigned long>(editor.SendScintilla(S::SCI_GETCURRENTPOS));
    const long line = editor.SendScintilla(S::SCI_LINEFROMPOSITION, at);
    const bool isHead =
        editor.SendScintilla(S::SCI_GETFOLDLEVEL, static_cast<unsigned long>(line)) & S::SC_FOLDLEVELHEADERFLAG;
    const long head = isHead ? line : editor.SendScintilla(S::SCI_GETFOLDPARENT, static_cast<unsigned long>(line));
    if (head < 0) return;
    if (head != line) editor.setCursorPosition(static_cast<int>(head), 0); // its line will not be seen
    editor.SendScintilla(S::SCI_TOGGLEFOLD, static_cast<unsigned long>(head));
}

void showInformation(StEditor& editor) {
    const auto at = static_cast<unsigned long>(editor.SendScintilla(S::SCI_GETCURRENTPOS));
    const auto pointOf = [&](unsigned long position) {
        const long x = editor.SendScintilla(S::SCI_POINTXFROMPOSITION, 0ul, static_cast<long>(position));
        const long y = editor.SendScintilla(S::SCI_POINTYFROMPOSITION, 0ul, static_cast<long>(position));
        return QPoint(static_cast<int>(x), static_cast<int>(y));
    };
    QPoint place = pointOf(at);
    // Behind a word there is nothing under the point: its last letter is meant.
    if (editor.wordUnderCursor().isEmpty() ||
        editor.SendScintilla(S::SCI_WORDENDPOSITION, at, 1l) == static_cast<long>(at))
        if (const long before = editor.SendScintilla(S::SCI_POSITIONBEFORE, at);
            pointOf(static_cast<unsigned long>(before)).y() == place.y())
            place = pointOf(static_cast<unsigned long>(before));
    const long line = editor.SendScintilla(S::SCI_LINEFROMPOSITION, at);
    place += QPoint(1, static_cast<int>(editor.SendScintilla(S::SCI_TEXTHEIGHT, static_cast<unsigned long>(line))) / 2);
    const QPoint inEditor = editor.viewport()->mapTo(&editor, place);
    QHelpEvent rests(QEvent::ToolTip, inEditor, editor.mapToGlobal(inEditor));
    QApplication::sendEvent(&editor, &rests);
}

void changePass(StEditor& editor, int by) {
    if (!editor.exactText()) return;
    const ExactText::Loop* nearest = nullptr;
    for (const ExactText::Loop& each : editor.exactText()->loops)
        if (each.begin <= editor.cursorOffset() && (!nearest || each.begin > nearest->begin)) nearest = &each;
    if (!nearest && !editor.exactText()->loops.empty()) nearest = &editor.exactText()->loops.front();
    if (!nearest) return;
    if (by < 0 && nearest->pass > 0) emit editor.passRequested(nearest->begin, nearest->pass - 1);
    if (by > 0 && nearest->pass + 1 < nearest->count) emit editor.passRequested(nearest->begin, nearest->pass + 1);
}

} // namespace plc::editor
