// The Tab key: around every dialog, and through every dock in the order of reading; what it skips is a command.
#include "app/main_window.h"
#include "tests/app/all_windows.h"
#include "tests/support/settle.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QLineEdit>
#include <QRadioButton>
#include <QToolBar>
#include <QToolButton>

#include <set>

namespace plc::app {
namespace {

using TabOrderTest = AllWindowsTest;

/// What the Tab key must reach: not the parts of a field, of a list or of a group of choices.
std::vector<QWidget*> tabStopsOf(QWidget& window) {
    std::vector<QWidget*> out;
    for (QWidget* widget : widgetsOf(window)) {
        if (widget == &window || !(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy()) continue;
        if (!widget->isVisibleTo(&window) || !widget->isEnabled()) continue;
        if (auto* choice = qobject_cast<QRadioButton*>(widget); choice && !choice->isChecked()) continue;
        if (qobject_cast<QComboBox*>(widget->parentWidget())) continue;
        out.push_back(widget);
    }
    return out;
}

/// Where Tab goes from the first field until it comes back, by the keyboard.
std::vector<QWidget*> visitedByTab(QWidget& dialog, size_t atMost) {
    std::vector<QWidget*> out;
    for (size_t i = 0; i < atMost; ++i) {
        QWidget* at = dialog.focusWidget();
        if (!at) at = &dialog;
        if (std::find(out.begin(), out.end(), at) == out.end()) out.push_back(at);
        QTest::keyClick(at, Qt::Key_Tab);
    }
    return out;
}

QRect placeOf(const QWidget& widget) { return {widget.mapToGlobal(QPoint()), widget.size()}; }

/// On the same line to the left, or on a line above.
bool isReadBefore(const QRect& a, const QRect& b) {
    const bool isSameLine = a.top() <= b.center().y() && b.top() <= a.center().y();
    return isSameLine ? a.left() < b.left() : a.top() < b.top();
}

/// The stops in the order of Qt's chain of focus, from the top left one.
std::vector<QWidget*> chainOf(const std::vector<QWidget*>& stops) {
    std::vector<QWidget*> out;
    if (stops.empty()) return out;
    const std::set<QWidget*> all(stops.begin(), stops.end());
    const auto isBefore = [](const QWidget* a, const QWidget* b) { return isReadBefore(placeOf(*a), placeOf(*b)); };
    QWidget* const first = *std::min_element(stops.begin(), stops.end(), isBefore);
    QWidget* at = first;
    do {
        if (all.contains(at)) out.push_back(at);
        at = at->nextInFocusChain();
    } while (at != first);
    return out;
}

QString nameOf(const QWidget& widget) {
    return QString::fromLatin1(widget.metaObject()->className()) + " “" + widget.objectName() + "” " +
           widget.accessibleName() + ' ' + widget.property("text").toString() + ' ' + widget.toolTip();
}

QString namesOf(const std::vector<QWidget*>& widgets) {
    QStringList out;
    for (const QWidget* each : widgets) out << nameOf(*each);
    return out.join(", ");
}

/// Against the direction of reading: above in the same column, or on the same line to the left.
bool goesBack(const QWidget& from, const QWidget& to) {
    const QRect a = placeOf(from), b = placeOf(to);
    if (b.bottom() < a.top()) return b.left() <= a.right() && a.left() <= b.right();
    return b.top() <= a.center().y() && b.bottom() >= a.center().y() && b.right() < a.left();
}

void expectOrderOfReading(const std::vector<QWidget*>& visited, const QString& name) {
    for (size_t i = 1; i < visited.size(); ++i)
        EXPECT_FALSE(visited[i] != visited.front() && goesBack(*visited[i - 1], *visited[i]))
            << name.toStdString() << ": Tab goes back from " << nameOf(*visited[i - 1]).toStdString() << " to "
            << nameOf(*visited[i]).toStdString();
}

TEST_F(TabOrderTest, TabVisitsEveryFieldOfADialogInTheOrderOfReading) {
    open();
    window->action("run.start")->trigger();
    ASSERT_TRUE(waitFor([&] { return window->control().status().scans > 20; }));
    size_t dialogs = 0;
    lookAtAllDialogs(*window, [&](QWidget& dialog, const QString& name) {
        if (&dialog == window.get()) return; // as it looks during a walk: in an editor Tab is a character
        ++dialogs;
        const std::vector<QWidget*> wanted = tabStopsOf(dialog);
        const std::vector<QWidget*> visited = visitedByTab(dialog, 2 * wanted.size() + 3);
        for (const QWidget* each : wanted)
            EXPECT_TRUE(std::find(visited.begin(), visited.end(), each) != visited.end())
                << name.toStdString() << ": Tab does not reach " << nameOf(*each).toStdString() << " but "
                << namesOf(visited).toStdString();
        expectOrderOfReading(chainOf(wanted), name);
    });
    EXPECT_GT(dialogs, 15u);
}

TEST_F(TabOrderTest, TabGoesThroughEveryDockInTheOrderOfReading) {
    open();
    window->resize(1440, 900);
    write("README.md", "# Test\n\nSee [the program](src/main.st).\n");
    ASSERT_TRUE(window->openProject(folder.path()));
    size_t stops = 0;
    for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
        window->showDock(dock->objectName());
        settle();
        const std::vector<QWidget*> wanted = tabStopsOf(*dock->widget());
        stops += wanted.size();
        EXPECT_TRUE(!wanted.empty() || (dock->widget()->focusPolicy() & Qt::TabFocus))
            << dock->objectName().toStdString() << " is out of the keyboard's reach";
        expectOrderOfReading(chainOf(wanted), dock->objectName());
    }
    EXPECT_GT(stops, 30u);
}

/// Parts of a field, of a list, and what keys reach in a way of their own: arrows choose in the palette below its
/// field, and the menu Time has every button of the slider.
bool isPartOfAnother(const QWidget& widget) {
    const QWidget* parent = widget.parentWidget();
    return qobject_cast<const QAbstractSpinBox*>(parent) || qobject_cast<const QComboBox*>(parent) ||
           qobject_cast<const QLineEdit*>(parent) || parent->inherits("QTabBar") || parent->inherits("QTabWidget") ||
           parent->inherits("plc::trace::TimeSlider") || parent->inherits("plc::kit::CommandPalette") ||
           widget.inherits("QHeaderView") || widget.inherits("QTableCornerButton") ||
           widget.inherits("QDockWidgetTitleButton") || widget.inherits("QMenuBarExtension") ||
           widget.inherits("QToolBarExtension") || widget.objectName().startsWith("qt_");
}

/// A button of a tool bar whose command is in a menu or has a key.
bool isCommand(const QWidget& widget, const QSet<QAction*>& commands) {
    const auto* button = qobject_cast<const QToolButton*>(&widget);
    if (!button || !button->defaultAction()) return false;
    return commands.contains(button->defaultAction()) || !button->defaultAction()->shortcut().isEmpty() ||
           qobject_cast<const QToolBar*>(button->parentWidget());
}

TEST_F(TabOrderTest, WhatOnlyAMouseReachesIsACommandAsWell) {
    open();
    const QList<QAction*> all = window->allActions();
    const QSet<QAction*> commands(all.begin(), all.end());
    std::set<QString> out;
    size_t seen = 0;
    lookAtAll([&](QWidget& shown, const QString& name) {
        for (QWidget* widget : widgetsOf(shown)) {
            const bool takesInput = qobject_cast<QAbstractButton*>(widget) || qobject_cast<QLineEdit*>(widget) ||
                                    qobject_cast<QComboBox*>(widget) || qobject_cast<QAbstractItemView*>(widget);
            if (!takesInput || widget == &shown || !widget->isVisibleTo(&shown) || isPartOfAnother(*widget)) continue;
            ++seen;
            if ((widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy() || isCommand(*widget, commands))
                continue;
            const auto* parent = widget->parentWidget();
            out.insert(QString("%1: %2 in %3 %4")
                           .arg(name.section(':', 0, 0), nameOf(*widget), parent->metaObject()->className(),
                                parent->objectName()));
        }
    });
    for (const QString& each : out) ADD_FAILURE() << each.toStdString();
    EXPECT_GT(seen, 500u);
}

} // namespace
} // namespace plc::app
