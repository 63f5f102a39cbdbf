#include "editor/kit/own_keys.h"

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QWidget>

#include <utility>

namespace plc::kit {

namespace {
QAction* actionWith(const QWidget& place, const QKeySequence& keys) {
    for (QAction* action : place.actions())
        if (action->shortcuts().contains(keys)) return action;
    return nullptr;
}

QAction* actionIn(const QWidget& place, const QKeyEvent& event) {
    if (QAction* exact = actionWith(place, QKeySequence(event.keyCombination()))) return exact;
    // Ctrl++ needs Shift on many keyboards and may come from the number pad: the same key to whoever presses it.
    const bool isSign = event.key() >= Qt::Key_Exclam && event.key() <= Qt::Key_Slash;
    const Qt::KeyboardModifiers without = event.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier);
    return isSign ? actionWith(place, QKeySequence(QKeyCombination(without, static_cast<Qt::Key>(event.key()))))
                  : nullptr;
}
} // namespace

QAction* actionOfKey(const QWidget* place, const QKeyEvent& event) {
    for (const QWidget* each = place; each; each = each->parentWidget())
        if (QAction* found = actionIn(*each, event); found && found->shortcutContext() != Qt::WidgetShortcut)
            return found;
    return nullptr;
}

OwnKeys::OwnKeys(QWidget* place) : QObject(place), m_place(place) { place->installEventFilter(this); }

bool OwnKeys::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride && watched == m_place) {
        m_pressed = actionIn(*m_place, *static_cast<QKeyEvent*>(event));
        if (!m_pressed) return false;
        event->accept(); // also while it is disabled: the window's action of that key means something else
        // The key comes to the widget with the focus next, which may have a use of its own for it (a list copies).
        QCoreApplication::instance()->installEventFilter(this);
        return true;
    }
    if (event->type() != QEvent::KeyPress || !m_pressed) return false;
    QCoreApplication::instance()->removeEventFilter(this);
    const QPointer<QAction> action = std::exchange(m_pressed, nullptr);
    action->trigger();
    return true;
}

} // namespace plc::kit
