#include "app/frame/perspectives.h"

#include <QDockWidget>
#include <QMainWindow>

#include <utility>

namespace plc::app {

Perspectives::Perspectives(QMainWindow& window) : QObject(&window), m_window(window) {}

QStringList Perspectives::docksOf(Perspective perspective) {
    switch (perspective) {
    case Perspective::Editing:
        return {"project", "problems", "search", "log"};
    case Perspective::Debugging:
        return {"project", "watch", "forces", "callPath", "breakpoints", "trace", "why", "log", "tasks"};
    case Perspective::PanelDesign:
        return {"project"}; // what is wrong with a panel is listed below it
    }
    return {};
}

void Perspectives::show(Perspective wanted) {
    leaveMaximised();
    if (m_shown) m_left[static_cast<int>(*m_shown)] = m_window.saveState();
    m_shown = wanted;
    if (const QByteArray before = m_left.value(static_cast<int>(wanted)); !before.isEmpty()) {
        m_window.restoreState(before);
        return;
    }
    const QStringList wantedDocks = docksOf(wanted);
    const auto docks = m_window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly);
    for (QDockWidget* dock : docks)
        if (!dock->property("hidesItself").toBool()) dock->setVisible(wantedDocks.contains(dock->objectName()));
    for (qsizetype i = wantedDocks.size(); i-- > 0;) // the first is raised last
        if (auto* dock = m_window.findChild<QDockWidget*>(wantedDocks[i])) dock->raise();
    if (wanted != Perspective::Debugging) // problems are a few lines
        m_window.resizeDocks({m_window.findChild<QDockWidget*>("problems")}, {m_window.height() / 5}, Qt::Vertical);
}

void Perspectives::toggleMaximised() {
    if (isMaximised()) return leaveMaximised();
    m_beforeMaximised = m_window.saveState();
    for (QDockWidget* dock : m_window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) dock->hide();
}

void Perspectives::leaveMaximised() {
    if (isMaximised()) m_window.restoreState(std::exchange(m_beforeMaximised, {}));
}

} // namespace plc::app
