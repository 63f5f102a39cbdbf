// The menu of StEditor: what is meant is the place of the click, or of the caret when a key asks for it.
#include "editor/kit/ask_why.h"
#include "editor/kit/icons.h"
#include "editor/text/st_editor.h"

#include <QContextMenuEvent>
#include <QCoreApplication>
#include <QMenu>

#include <algorithm>

namespace plc::editor {

using S = QsciScintillaBase;

namespace {

/// The words that Qt has for every text field; those of QScintilla exist in three languages.
QString wordOfQt(const char* english) { return QCoreApplication::translate("QWidgetTextControl", english); }

/// A click outside of the selection moves the caret, as F12, F9 and all else in the menu speak of it.
void takeClickedPlace(StEditor& editor, const QPoint& inside) {
    const long at = editor.SendScintilla(S::SCI_POSITIONFROMPOINT, static_cast<unsigned long>(std::max(0, inside.x())),
                                         static_cast<long>(inside.y()));
    const bool isInSelection = editor.hasSelectedText() && at >= editor.SendScintilla(S::SCI_GETSELECTIONSTART) &&
                               at <= editor.SendScintilla(S::SCI_GETSELECTIONEND);
    if (!isInSelection) editor.SendScintilla(S::SCI_SETEMPTYSELECTION, static_cast<unsigned long>(at));
}

QPoint underCaret(StEditor& editor) {
    editor.ensureCursorVisible();
    const long at = editor.SendScintilla(S::SCI_GETCURRENTPOS);
    const long line = editor.SendScintilla(S::SCI_LINEFROMPOSITION, static_cast<unsigned long>(at));
    const long x = editor.SendScintilla(S::SCI_POINTXFROMPOSITION, 0ul, at);
    const long y = editor.SendScintilla(S::SCI_POINTYFROMPOSITION, 0ul, at) +
                   editor.SendScintilla(S::SCI_TEXTHEIGHT, static_cast<unsigned long>(line));
    return editor.viewport()->mapToGlobal(QPoint(static_cast<int>(x), static_cast<int>(y)));
}

void addCommands(QMenu& menu, StEditor& editor) {
    const auto add = [&](kit::Icon icon, const QString& text, const QKeySequence& keys, auto&& run) {
        QAction* action = menu.addAction(kit::icon(icon), text);
        action->setShortcut(keys);
        QObject::connect(action, &QAction::triggered, &editor, run);
    };
    const uint32_t at = editor.cursorOffset();
    add(kit::Icon::Forward, StEditor::tr("Go to Definition"), Qt::Key_F12,
        [&editor, at] { emit editor.definitionRequested(editor.file(), at); });
    add(kit::Icon::Find, StEditor::tr("Find References"), Qt::SHIFT | Qt::Key_F12,
        [&editor, at] { emit editor.usesRequested(editor.file(), at); });
    add(kit::Icon::Rename, StEditor::tr("Rename…"), Qt::Key_F2,
        [&editor, at] { emit editor.renameRequested(editor.file(), at); });
    menu.addSeparator();
    add(kit::Icon::Breakpoint, StEditor::tr("Toggle Breakpoint"), Qt::Key_F9, [&editor] {
        int line = 0, column = 0;
        editor.getCursorPosition(&line, &column);
        emit editor.breakpointToggled(editor.file(), line + 1);
    });
    add(kit::Icon::Watch, StEditor::tr("Add to Watch"), {}, [&editor] {
        emit editor.watchRequested(editor.hasSelectedText() ? editor.selectedText() : editor.wordUnderCursor());
    });
}

void addValueCommands(QMenu& menu, StEditor& editor, const StEditor::NamedValue& variable) {
    const auto add = [&](kit::Icon icon, const QString& text, auto signal) {
        QObject::connect(menu.addAction(kit::icon(icon), text), &QAction::triggered, &editor,
                         [&editor, signal, variable] { emit(editor.*signal)(variable.name, variable.pou); });
    };
    add(kit::Icon::Write, StEditor::tr("Write a Value…"), &StEditor::writeRequested);
    add(kit::Icon::Force, StEditor::tr("Force…"), &StEditor::forceRequested);
    add(kit::Icon::Unforce, StEditor::tr("Release the Force"), &StEditor::unforceRequested);
}

/// Undo and redo are those of the project, where changes of several files belong together.
void addTextCommands(QMenu& menu, StEditor& editor, const std::function<void()>& undo,
                     const std::function<void()>& redo) {
    const auto add = [&](const char* english, const QKeySequence& keys, bool isPossible, auto&& run) {
        QAction* action = menu.addAction(wordOfQt(english));
        action->setShortcut(keys);
        action->setEnabled(isPossible);
        QObject::connect(action, &QAction::triggered, &editor, run);
    };
    const bool mayWrite = !editor.isReadOnly(), hasSelection = editor.hasSelectedText();
    add("&Undo", QKeySequence::Undo, mayWrite && (undo || editor.isUndoAvailable()),
        [&editor, undo] { undo ? undo() : editor.undo(); });
    add("&Redo", Qt::CTRL | Qt::Key_Y, mayWrite && (redo || editor.isRedoAvailable()),
        [&editor, redo] { redo ? redo() : editor.redo(); });
    menu.addSeparator();
    add("Cu&t", QKeySequence::Cut, mayWrite && hasSelection, [&editor] { editor.cut(); });
    add("&Copy", QKeySequence::Copy, hasSelection, [&editor] { editor.copy(); });
    add("&Paste", QKeySequence::Paste, mayWrite && editor.SendScintilla(S::SCI_CANPASTE) != 0,
        [&editor] { editor.paste(); });
    add("Delete", {}, mayWrite && hasSelection, [&editor] { editor.removeSelectedText(); });
    menu.addSeparator();
    add("Select All", QKeySequence::SelectAll, editor.length() > 0, [&editor] { editor.selectAll(); });
}

} // namespace

void StEditor::contextMenuEvent(QContextMenuEvent* event) {
    const bool isByKey = event->reason() != QContextMenuEvent::Mouse;
    if (!isByKey) takeClickedPlace(*this, viewport()->mapFromGlobal(event->globalPos()));
    QMenu menu;
    const auto variable = m_onlineValues ? variableAt(cursorOffset()) : std::nullopt;
    if (variable && !m_onlineValues({{variable->name, variable->pou}}).empty()) {
        addValueCommands(menu, *this, *variable);
        menu.addSeparator();
    }
    if (const auto asked = m_onlineValues ? askedAbout() : std::nullopt) {
        kit::addWhyActions(
            menu, [this, asked](kit::AskWhy question) { emit whyRequested(question, asked->name, asked->pou); });
        menu.addSeparator();
    }
    addCommands(menu, *this);
    menu.addSeparator();
    addTextCommands(menu, *this, m_undo, m_redo);
    menu.exec(isByKey ? underCaret(*this) : event->globalPos());
}

} // namespace plc::editor
