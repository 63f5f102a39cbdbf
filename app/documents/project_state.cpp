#include "app/documents/project_state.h"

#include <QVariant>

#include <algorithm>

namespace plc::app {

namespace {
constexpr QChar kField{0x1F}; // between the parts of a breakpoint: a condition may hold any other character

/// "src/main.st|120|Chart"
QString placeOf(StPage& page) {
    return QStringList{page.file(), QString::number(page.first().cursorOffset()),
                       page.chart() && page.chart()->isVisible() ? page.chart()->unit() : QString()}
        .join('|');
}

QString textOf(const editor::EditorBreakpoint& b) {
    return QStringList{b.file,     QString::number(b.line), b.condition, QString::number(b.hitCount),
                       b.instance, b.isEnabled ? "1" : "0"}
        .join(kField);
}
} // namespace

QVariant ProjectState::value(const char* name) const {
    return m_parts.settings.projectValue(m_parts.workspace.folder(), name);
}

void ProjectState::keep(const char* name, const QVariant& value) {
    m_parts.settings.setProjectValue(m_parts.workspace.folder(), name, value);
}

void ProjectState::save(const QByteArray& layout, const QStringList& docksThatHide) {
    QStringList pages;
    for (int i = 0; i < m_parts.tabs.count(); ++i) {
        if (auto* page = qobject_cast<StPage*>(m_parts.tabs.widget(i)))
            pages << placeOf(*page);
        else if (const QString key = m_parts.tabs.widget(i)->property("pageKey").toString();
                 !key.startsWith("library:") && !key.startsWith("text:"))
            pages << key;
    }
    keep("pages", pages);
    keep("currentPage", m_parts.tabs.currentIndex());
    keep("watchLists", m_parts.watch.stored());
    keep("layout", layout);
    keep("docksThatHide", docksThatHide);
    QStringList breakpoints;
    for (const editor::EditorBreakpoint& each : m_parts.control.breakpoints()) breakpoints << textOf(each);
    keep("breakpoints", breakpoints);
}

QByteArray ProjectState::layout() const { return value("layout").toByteArray(); }

QStringList ProjectState::docksThatHide() const { return value("docksThatHide").toStringList(); }

void ProjectState::restorePages() {
    EditorTabs& tabs = m_parts.tabs;
    for (const QString& page : value("pages").toStringList()) {
        if (DesignPages::isKey(page))
            m_parts.designs.open(page);
        else if (StPage* opened = tabs.openFile(page.section('|', 0, 0))) {
            opened->first().goTo(page.section('|', 1, 1).toUInt());
            if (const QString unit = page.section('|', 2); !unit.isEmpty()) opened->showChart(unit);
        }
    }
    if (tabs.count() > 0) tabs.setCurrentIndex(std::clamp(value("currentPage").toInt(), 0, tabs.count() - 1));
    const QStringList files = m_parts.workspace.files();
    if (tabs.count() == 0 && !files.isEmpty())
        tabs.openFile(files.contains("src/main.st") ? "src/main.st" : files.first());
    if (QWidget* page = tabs.currentWidget()) page->setFocus();
}

void ProjectState::restoreWatches(const QString& nameOfFirst) {
    const QStringList lists = value("watchLists").toStringList();
    m_parts.watch.restore(lists.isEmpty() ? QStringList{"0", nameOfFirst} : lists);
}

void ProjectState::restoreBreakpoints() {
    std::vector<editor::EditorBreakpoint> breakpoints;
    for (const QString& text : value("breakpoints").toStringList()) {
        const QStringList parts = text.split(kField);
        if (parts.size() == 6)
            breakpoints.push_back({parts[0], parts[1].toInt(), parts[2], parts[3].toInt(), parts[4], parts[5] == "1"});
    }
    m_parts.control.setBreakpoints(breakpoints);
}

} // namespace plc::app
