#include "app/pages/focus_command.h"

#include "app/pages/editor_tabs.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>

namespace plc::app {

namespace {
/// Lines and texts of dialogs and bars; the editor's own undo belongs to the tabs.
bool runBySlot(QWidget* focus, const QByteArray& command) {
    if (!focus || qobject_cast<editor::StEditor*>(focus)) return false;
    const QByteArray signature = command + "()";
    return focus->metaObject()->indexOfSlot(signature.constData()) >= 0 &&
           QMetaObject::invokeMethod(focus, command.constData(), Qt::DirectConnection);
}

bool runByAction(const QWidget* from, const QString& command) {
    for (const QWidget* each = from; each; each = each->parentWidget())
        for (QAction* action : each->actions())
            if (action->objectName() == command) {
                action->trigger();
                return true;
            }
    return false;
}

void runInText(EditorTabs& tabs, const QString& command) {
    if (command == "undo") return tabs.undo();
    if (command == "redo") return tabs.redo();
    if (editor::StEditor* text = tabs.currentEditor()) {
        if (command == "cut") text->cut();
        if (command == "copy") text->copy();
        if (command == "paste") text->paste();
        if (command == "zoom-in") text->zoomIn();
        if (command == "zoom-out") text->zoomOut();
    }
}
} // namespace

void runInFocus(EditorTabs& tabs, const QString& command) {
    QWidget* focus = QApplication::focusWidget();
    if (runBySlot(focus, command.toLatin1()) || runByAction(focus, command)) return;
    if (!tabs.currentPage() && runByAction(tabs.currentWidget(), command)) return;
    runInText(tabs, command);
}

bool editFocusedCell() {
    auto* view = qobject_cast<QAbstractItemView*>(QApplication::focusWidget());
    if (!view || view->editTriggers() == QAbstractItemView::NoEditTriggers) return false;
    const QModelIndex at = view->currentIndex();
    if (!at.isValid() || !(at.flags() & Qt::ItemIsEditable)) return false;
    view->edit(at);
    return true;
}

} // namespace plc::app
