// How the tool bar of every editor of the design starts: undo and redo of what it edits, which belong to it while it
// has the keyboard. For the editors' constructors; GUI thread.
#pragma once
#include "editor/kit/edit_history.h"
#include "editor/kit/own_keys.h"

#include <QAction>
#include <QToolBar>

namespace plc::hmi {

/// More actions are added behind the separator; the caller places the bar.
inline QToolBar* makeEditBar(QUndoStack& undo, QWidget* editor) {
    auto* bar = new QToolBar;
    bar->setIconSize(QSize(16, 16));
    for (QAction* action : {kit::makeUndoAction(undo, editor), kit::makeRedoAction(undo, editor)}) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        bar->addAction(action);
        editor->addAction(action);
    }
    new kit::OwnKeys(editor);
    bar->addSeparator();
    return bar;
}

} // namespace plc::hmi
