#include "editor/kit/edit_history.h"

#include "editor/kit/icons.h"

#include <QAction>
#include <QCoreApplication>

namespace plc::kit {

QAction* makeUndoAction(QUndoStack& stack, QObject* parent) {
    QAction* action = stack.createUndoAction(parent, QCoreApplication::translate("EditHistory", "&Undo"));
    action->setObjectName("undo"); // found by it from the menu
    action->setIcon(icon(Icon::Undo));
    action->setShortcut(QKeySequence::Undo);
    return action;
}

QAction* makeRedoAction(QUndoStack& stack, QObject* parent) {
    QAction* action = stack.createRedoAction(parent, QCoreApplication::translate("EditHistory", "&Redo"));
    action->setObjectName("redo");
    action->setIcon(icon(Icon::Redo));
    action->setShortcuts({QKeySequence(Qt::CTRL | Qt::Key_Y), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z)});
    return action;
}

} // namespace plc::kit
