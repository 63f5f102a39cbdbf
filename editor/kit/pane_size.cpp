#include "editor/kit/pane_size.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QSplitter>

#include <algorithm>

namespace plc::kit {

namespace {

int leastOf(const QWidget& pane, Qt::Orientation along) {
    const QSize least = pane.minimumSize().expandedTo(pane.minimumSizeHint());
    return std::max(1, along == Qt::Horizontal ? least.width() : least.height());
}

/// What the pane gets its neighbour gives: the one behind it, else the one before.
bool resizeInSplitter(QSplitter& splitter, int pane, int pixels) {
    QList<int> sizes = splitter.sizes();
    const auto isShown = [&](int index) {
        return index >= 0 && index < splitter.count() && splitter.widget(index)->isVisible();
    };
    int other = pane + 1;
    while (other < splitter.count() && !isShown(other)) ++other;
    if (!isShown(other))
        for (other = pane - 1; other >= 0 && !isShown(other);) --other;
    if (!isShown(other)) return false;
    const Qt::Orientation along = splitter.orientation();
    const int most = std::max(0, sizes[other] - leastOf(*splitter.widget(other), along));
    const int least = std::min(0, leastOf(*splitter.widget(pane), along) - sizes[pane]);
    const int by = std::clamp(pixels, least, most);
    sizes[pane] += by;
    sizes[other] -= by;
    splitter.setSizes(sizes);
    return true;
}

int sizeOf(const QWidget& widget, Qt::Orientation along) {
    return along == Qt::Horizontal ? widget.width() : widget.height();
}

/// The documents have no edge of their own: a dock beside or below them gives or takes.
bool resizeBesideDocks(QMainWindow& window, Qt::Orientation along, int pixels) {
    for (const Qt::DockWidgetArea area :
         {Qt::RightDockWidgetArea, Qt::LeftDockWidgetArea, Qt::BottomDockWidgetArea, Qt::TopDockWidgetArea}) {
        const bool isBeside = area == Qt::RightDockWidgetArea || area == Qt::LeftDockWidgetArea;
        if (isBeside != (along == Qt::Horizontal)) continue;
        for (QDockWidget* dock : window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            if (dock->isFloating() || dock->visibleRegion().isEmpty() || window.dockWidgetArea(dock) != area) continue;
            window.resizeDocks({dock}, {std::max(leastOf(*dock, along), sizeOf(*dock, along) - pixels)}, along);
            return true;
        }
    }
    return false;
}

} // namespace

bool resizePane(QWidget* inside, Qt::Orientation along, int pixels) {
    for (QWidget* at = inside; at; at = at->parentWidget()) {
        QWidget* outer = at->parentWidget();
        if (auto* splitter = qobject_cast<QSplitter*>(outer); splitter && splitter->orientation() == along)
            if (const int pane = splitter->indexOf(at); pane >= 0 && resizeInSplitter(*splitter, pane, pixels))
                return true;
        auto* window = qobject_cast<QMainWindow*>(outer);
        if (auto* dock = qobject_cast<QDockWidget*>(at); dock && dock->isFloating()) {
            dock->resize(dock->size() + (along == Qt::Horizontal ? QSize(pixels, 0) : QSize(0, pixels)));
            return true;
        } else if (dock && window) {
            window->resizeDocks({dock}, {std::max(leastOf(*dock, along), sizeOf(*dock, along) + pixels)}, along);
            return true;
        }
        if (window && window->centralWidget() == at) return resizeBesideDocks(*window, along, pixels);
        if (at->isWindow()) return false;
    }
    return false;
}

} // namespace plc::kit
