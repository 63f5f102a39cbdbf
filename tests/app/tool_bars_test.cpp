// Every tool bar on a small screen: what it has no room for is in the menu at its end, and nothing else is lost.
#include "app/main_window.h"
#include "app/settings/translation.h"
#include "tests/app/all_windows.h"
#include "tests/support/answer.h"
#include "tests/support/settle.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QToolBar>
#include <QToolButton>

#include <map>

namespace plc::app {
namespace {

class ToolBarsTest : public AllWindowsTest {
protected:
    void SetUp() override { open(); }
    void TearDown() override {
        StudioTest::TearDown();
        installTranslation(*qApp, "en");
    }
    static QWidget* restButton(const QToolBar& bar) {
        return bar.findChild<QWidget*>("qt_toolbar_ext_button", Qt::FindDirectChildrenOnly);
    }
    /// A field that hides behind the end of its bar: the menu there has actions only.
    static QString lostIn(const QToolBar& bar) {
        for (QAction* action : bar.actions()) {
            const QWidget* widget = bar.widgetForAction(action);
            if (!action->isVisible() || action->isSeparator() || !widget || qobject_cast<const QLabel*>(widget) ||
                widget->metaObject() == &QWidget::staticMetaObject)
                continue;
            if (widget->isVisible() && bar.rect().contains(widget->geometry())) continue;
            const bool isWidget = action->inherits("QWidgetAction");
            const QWidget* rest = restButton(bar);
            if (isWidget || !rest || !rest->isVisible() || !bar.rect().contains(rest->geometry()))
                return widget->accessibleName() + " " + action->text() + " of " +
                       bar.parentWidget()->metaObject()->className();
        }
        return {};
    }
    void lookAtBars(QWidget& shown, const QString& where) {
        settle();
        for (const QToolBar* bar : shown.findChildren<QToolBar*>()) {
            if (!bar->isVisible()) continue;
            if (const QString lost = lostIn(*bar); !lost.isEmpty())
                m_lost.emplace(lost.toStdString(), where.toStdString());
        }
    }
    std::map<std::string, std::string> m_lost; // and where first
};

TEST_F(ToolBarsTest, NothingIsLostOnASmallScreen) {
    for (const char* language : {"en", "de"}) {
        window->closeProject();
        window = inOtherLanguage(std::move(window), *qApp, language);
        ASSERT_TRUE(window->openProject(folder.path()));
        window->resetLayout();
        window->resize(1024, 700);
        ASSERT_TRUE(waitFor([&] { return window->width() == 1024 && window->workspace().model(); }));
        lookAtAllDocuments(*window,
                           [&](QWidget&, const QString& name) { lookAtBars(*window, language + (" " + name)); });
        for (QDockWidget* dock : window->findChildren<QDockWidget*>()) {
            window->showDock(dock->objectName());
            lookAtBars(*window, language + (" " + dock->objectName()));
        }
        window->control().disconnectSession();
    }
    std::string all;
    for (const auto& [lost, where] : m_lost) all += where + ": " + lost + "\n";
    EXPECT_EQ(all, "");
}

/// By the mouse: the menu of the rest, and a menu of the bar in it.
TEST_F(ToolBarsTest, TheLastMenusOfTheTraceAreReachedOnASmallScreen) {
    window->resetLayout();
    window->resize(1024, 700);
    window->showDock("trace");
    settle();
    QToolBar* bar = nullptr;
    for (QToolBar* each : window->findChildren<QToolBar*>())
        if (each->parentWidget()->inherits("plc::trace::TraceView")) bar = each;
    ASSERT_NE(bar, nullptr);
    bar->parentWidget()->setFixedWidth(420); // narrower than any language needs
    QWidget* rest = restButton(*bar);
    ASSERT_TRUE(rest && waitFor([&] { return rest->isVisible(); }));
    QStringList seen;
    inNextMenu(window.get(), [&](QMenu& menu) {
        for (QAction* action : menu.actions())
            if (action->menu()) seen << action->text() + ": " + QString::number(action->menu()->actions().size());
        menu.close();
    });
    QTest::mouseClick(rest, Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return !seen.isEmpty(); }));
    EXPECT_EQ(seen.filter("Trace configuration").size(), 1) << seen.join(", ").toStdString();
    EXPECT_EQ(seen.filter("Export: 6").size(), 1) << seen.join(", ").toStdString();
    EXPECT_EQ(seen.filter("XY plot").size(), 1) << seen.join(", ").toStdString();
}

} // namespace
} // namespace plc::app
