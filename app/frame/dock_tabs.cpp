#include "app/frame/dock_tabs.h"

#include "editor/kit/studio_style.h"

#include <QChildEvent>
#include <QDockWidget>
#include <QMainWindow>
#include <QStyle>
#include <QTabBar>
#include <QTimer>

namespace plc::app {

namespace {

int widthOfNames(const QTabBar& bar) {
    int width = 0;
    for (int i = 0; i < bar.count(); ++i)
        width += bar.fontMetrics().size(Qt::TextShowMnemonic, bar.tabText(i)).width() +
                 bar.style()->pixelMetric(QStyle::PM_TabBarTabHSpace, nullptr, &bar);
    return width;
}

/// Qt keeps the dock of a tab as the tab's data.
const QDockWidget* dockOf(const QMainWindow& window, const QTabBar& bar, int tab) {
    for (const QDockWidget* dock : window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
        if (bar.tabData(tab).toULongLong() == reinterpret_cast<quintptr>(dock)) return dock;
    return nullptr;
}

} // namespace

DockTabs::DockTabs(QMainWindow& window) : QObject(&window), m_window(window) { window.installEventFilter(this); }

void DockTabs::fit(QTabBar& bar) const {
    if (bar.width() <= 0 || bar.count() == 0) return;
    const bool areNarrow = widthOfNames(bar) > bar.width();
    const bool wereNarrow = bar.property(kit::kNarrowTabs).toBool();
    bar.setProperty(kit::kNarrowTabs, areNarrow);
    for (int i = 0; i < bar.count(); ++i) {
        if (bar.tabIcon(i).isNull() == !areNarrow) continue;
        const QDockWidget* dock = areNarrow ? dockOf(m_window, bar, i) : nullptr;
        bar.setTabIcon(i, dock ? dock->windowIcon() : QIcon());
    }
    if (areNarrow == wereNarrow) return;
    const Qt::TextElideMode mode = bar.elideMode(); // laid out again
    bar.setElideMode(mode == Qt::ElideNone ? Qt::ElideRight : Qt::ElideNone);
    bar.setElideMode(mode);
}

bool DockTabs::eventFilter(QObject* watched, QEvent* event) {
    if (watched == &m_window) {
        const bool isNew = event->type() == QEvent::ChildPolished; // the window makes the bars as it needs them
        if (auto* bar = isNew ? qobject_cast<QTabBar*>(static_cast<QChildEvent*>(event)->child()) : nullptr)
            bar->installEventFilter(this);
        return QObject::eventFilter(watched, event);
    }
    auto* bar = qobject_cast<QTabBar*>(watched);
    if (!bar) return QObject::eventFilter(watched, event);
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show) fit(*bar);
    // Nothing else says that a tab has come or gone, and a bar must not be laid out while it is painted.
    if (event->type() == QEvent::Paint) QTimer::singleShot(0, bar, [this, bar] { fit(*bar); });
    return QObject::eventFilter(watched, event);
}

} // namespace plc::app
