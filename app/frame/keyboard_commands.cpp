#include "app/frame/keyboard_commands.h"

#include "app/frame/side_bars.h"
#include "editor/kit/column_menu.h"
#include "editor/kit/pane_size.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QDialog>
#include <QDockWidget>
#include <QHeaderView>
#include <QKeyEvent>
#include <QKeySequence>
#include <QMainWindow>
#include <QMenu>

#include <algorithm>
#include <vector>

namespace plc::app {

namespace {

constexpr int kStep = 24; // pixels

QDockWidget* focusedDock(SideBars& bars) {
    if (bars.revealed()) return bars.revealed();
    for (QWidget* at = QApplication::focusWidget(); at; at = at->parentWidget())
        if (auto* dock = qobject_cast<QDockWidget*>(at)) return dock;
    return nullptr;
}

/// What had the focus in it last, else the first place that takes it.
void focusInside(QWidget& pane) {
    QWidget* last = pane.focusWidget();
    if (last && last->isVisible() && pane.isAncestorOf(last)) return last->setFocus(Qt::OtherFocusReason);
    if (pane.focusPolicy() & Qt::TabFocus) return pane.setFocus(Qt::OtherFocusReason);
    for (QWidget* at = pane.nextInFocusChain(); at && at != &pane; at = at->nextInFocusChain())
        if (pane.isAncestorOf(at) && at->isVisible() && at->isEnabled() && (at->focusPolicy() & Qt::TabFocus))
            return at->setFocus(Qt::OtherFocusReason);
}

} // namespace

void focusNextPane(QMainWindow& window, SideBars& bars, int by) {
    std::vector<QWidget*> panes{window.centralWidget()};
    for (QDockWidget* dock : window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        const bool isInSight = dock->isVisible() && (dock->isFloating() || !dock->visibleRegion().isEmpty());
        if (dock->widget() && isInSight) panes.push_back(dock->widget());
    }
    std::sort(panes.begin() + 1, panes.end(), [&](const QWidget* a, const QWidget* b) { // as they are read
        const QPoint left = a->mapToGlobal(QPoint()), right = b->mapToGlobal(QPoint());
        return std::pair(left.x(), left.y()) < std::pair(right.x(), right.y());
    });
    bars.conceal();
    const QWidget* focus = QApplication::focusWidget();
    const auto now = std::find_if(panes.begin(), panes.end(), [&](const QWidget* pane) {
        return focus && (pane == focus || pane->isAncestorOf(focus));
    });
    const auto count = static_cast<std::ptrdiff_t>(panes.size());
    const auto index = now == panes.end() ? (by > 0 ? -1 : 0) : now - panes.begin();
    QWidget* next = panes[static_cast<size_t>((index + by + count) % count)];
    next->window()->activateWindow();
    focusInside(*next);
}

void showContextMenu() {
    QWidget* focus = QApplication::focusWidget();
    if (!focus) return;
    // As Qt does it for the menu key.
    const QPoint at = focus->inputMethodQuery(Qt::ImCursorRectangle).toRect().center();
    QContextMenuEvent event(QContextMenuEvent::Keyboard, at, focus->mapToGlobal(at));
    QApplication::sendEvent(focus, &event);
}

QMenu* makeColumnMenu() {
    QHeaderView* head = kit::ColumnMenu::headOf(QApplication::focusWidget());
    return head ? kit::ColumnMenu::make(*head, head->parentWidget()) : nullptr;
}

void moveFocusedDock(QMainWindow& window, SideBars& bars) {
    QDockWidget* dock = focusedDock(bars);
    if (!dock) return;
    QWidget* focus = QApplication::focusWidget();
    if (bars.hidesItself(*dock)) bars.setHidesItself(*dock, false);
    const Qt::DockWidgetArea now = window.dockWidgetArea(dock);
    const Qt::DockWidgetArea next = now == Qt::LeftDockWidgetArea     ? Qt::BottomDockWidgetArea
                                    : now == Qt::BottomDockWidgetArea ? Qt::RightDockWidgetArea
                                                                      : Qt::LeftDockWidgetArea;
    dock->setFloating(false);
    window.addDockWidget(next, dock);
    dock->show();
    dock->raise();
    if (focus) focus->setFocus(Qt::OtherFocusReason);
}

void floatFocusedDock(SideBars& bars) {
    QDockWidget* dock = focusedDock(bars);
    if (!dock) return;
    QWidget* focus = QApplication::focusWidget();
    if (bars.hidesItself(*dock)) bars.setHidesItself(*dock, false);
    dock->setFloating(!dock->isFloating());
    dock->activateWindow();
    if (focus) focus->setFocus(Qt::OtherFocusReason);
}

PaneKeys::PaneKeys(QObject* window, std::function<QKeySequence(Change)> keys)
    : QObject(window), m_keys(std::move(keys)) {
    qApp->installEventFilter(this);
}

void PaneKeys::change(Change change) {
    const bool isWidth = change == Change::Wider || change == Change::Narrower;
    const bool isMore = change == Change::Wider || change == Change::Taller;
    kit::resizePane(QApplication::focusWidget(), isWidth ? Qt::Horizontal : Qt::Vertical, isMore ? kStep : -kStep);
}

bool PaneKeys::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress || watched != QApplication::focusWidget()) return false;
    const auto* dialog = qobject_cast<QDialog*>(static_cast<QWidget*>(watched)->window());
    if (!dialog) return false; // in the window its commands do it
    const QKeySequence pressed(static_cast<QKeyEvent*>(event)->keyCombination());
    for (const Change each : {Change::Wider, Change::Narrower, Change::Taller, Change::Shorter})
        if (m_keys(each) == pressed) {
            change(each);
            return true;
        }
    return false;
}

} // namespace plc::app
