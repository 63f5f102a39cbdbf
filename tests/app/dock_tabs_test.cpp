// The tabs of docks on a small screen: nothing is cut, each dock is a click away, and the View menu finds those in the
// back.
#include "app/frame/dock_tabs.h"
#include "app/settings/translation.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QDockWidget>
#include <QLineEdit>
#include <QStyle>
#include <QTabBar>

namespace plc::app {
namespace {

class DockTabsTest : public StudioTest {
protected:
    void TearDown() override {
        StudioTest::TearDown();
        installTranslation(*qApp, "en");
    }
    /// The window in a language, at a size, with every dock in it.
    void show(const char* language, QSize size) {
        window->closeProject();
        window = inOtherLanguage(std::move(window), *qApp, language);
        ASSERT_TRUE(window->openProject(folder.path()));
        window->resetLayout();
        window->resize(size);
        ASSERT_TRUE(waitFor([&] { return window->size() == size && below(); }));
        QTest::qWait(50); // a duration: tab bars settle by queued events of their own
    }
    QList<QTabBar*> bars() const {
        QList<QTabBar*> shown;
        for (QTabBar* bar : window->findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly))
            if (bar->isVisible()) shown << bar;
        return shown;
    }
    /// The one with the ten docks under the editor.
    QTabBar* below() const {
        for (QTabBar* bar : bars())
            if (bar->count() >= 10) return bar;
        return nullptr;
    }
    /// What of the tabs is cut: a name that has not enough room, or a tab outside of its bar.
    static QStringList cut(const QTabBar& bar) {
        QStringList found;
        const int around = bar.style()->pixelMetric(QStyle::PM_TabBarTabHSpace, nullptr, &bar);
        for (int i = 0; i < bar.count(); ++i) {
            const bool isPicture = !bar.tabIcon(i).isNull() && i != bar.currentIndex();
            const int picture = bar.tabIcon(i).isNull() ? 0 : bar.iconSize().width();
            const int wanted =
                isPicture ? picture : picture + around + bar.fontMetrics().horizontalAdvance(bar.tabText(i));
            if (bar.tabRect(i).width() < wanted || bar.tabRect(i).right() > bar.width()) found << bar.tabText(i);
        }
        return found;
    }
    static bool arePictures(const QTabBar& bar) {
        for (int i = 0; i < bar.count(); ++i)
            if (bar.tabIcon(i).isNull()) return false;
        return true;
    }
};

TEST_F(DockTabsTest, NothingIsCutOnASmallScreenInAShortAndALongLanguage) {
    for (const char* language : {"en", "de"}) {
        ASSERT_NO_FATAL_FAILURE(show(language, {1024, 700}));
        for (const QSize size : {QSize(1024, 700), QSize(1366, 768)}) {
            window->resize(size);
            EXPECT_GE(bars().size(), 3);
            for (const QTabBar* bar : bars())
                EXPECT_TRUE(waitFor([&] { return cut(*bar).isEmpty(); }))
                    << language << " at " << size.width() << ": " << cut(*bar).join(", ").toStdString();
        }
    }
}

TEST_F(DockTabsTest, EachPictureSaysItsNameAndBringsItsDockToTheFront) {
    ASSERT_NO_FATAL_FAILURE(show("en", {1024, 700}));
    QTabBar& bar = *below();
    ASSERT_TRUE(waitFor([&] { return arePictures(bar); }));
    for (int i = 0; i < bar.count(); ++i) {
        EXPECT_EQ(bar.tabToolTip(i), bar.tabText(i));
        EXPECT_FALSE(bar.tabText(i).isEmpty()) << "for who hears the window";
        QTest::mouseClick(&bar, Qt::LeftButton, {}, bar.tabRect(i).center());
        EXPECT_EQ(bar.currentIndex(), i);
        for (QDockWidget* dock : window->findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            if (dock->windowTitle() != bar.tabText(i)) continue;
            EXPECT_TRUE(waitFor([&] { return dock->widget()->visibleRegion().boundingRect().width() > 50; }));
        }
        EXPECT_TRUE(waitFor([&] { return cut(bar).isEmpty(); }))
            << "in front: " << bar.tabText(i).toStdString() << ", " << bar.tabRect(i).left() << " to "
            << bar.tabRect(i).right() << " of " << bar.width();
    }
}

TEST_F(DockTabsTest, NamesComeBackWithTheRoomAndGoWithATabMore) {
    ASSERT_NO_FATAL_FAILURE(show("en", {1024, 700}));
    ASSERT_TRUE(waitFor([&] { return arePictures(*below()); }));
    window->resize(1900, 900);
    EXPECT_TRUE(waitFor([&] { return below()->tabIcon(0).isNull() && cut(*below()).isEmpty(); }));
    window->resize(1024, 700);
    ASSERT_TRUE(waitFor([&] { return arePictures(*below()); }));
    for (const char* name : {"why", "slowScan", "devices", "tuning", "tests", "tasks", "search"})
        window->dock(name)->close();
    QTabBar* fewer = nullptr;
    ASSERT_TRUE(waitFor([&] {
        for (QTabBar* bar : bars())
            for (int i = 0; i < bar->count(); ++i)
                if (bar->tabText(i) == "Log") fewer = bar;
        return fewer && fewer->count() == 3;
    }));
    EXPECT_TRUE(waitFor([&] { return fewer->tabIcon(0).isNull(); })) << "three names fit";
    for (const char* name : {"why", "slowScan", "devices", "tuning", "tests", "tasks", "search"})
        window->showDock(name);
    EXPECT_TRUE(waitFor([&] { return below() && arePictures(*below()); }));
}

TEST_F(DockTabsTest, TheViewMenuBringsADockFromTheBackAndClosesTheOneInFront) {
    ASSERT_NO_FATAL_FAILURE(show("en", {1024, 700}));
    QAction* log = window->action("dock.log");
    ASSERT_NE(log, nullptr);
    window->showDock("trace");
    ASSERT_TRUE(waitFor([&] { return !log->isChecked(); })) << "behind the trace";
    log->trigger();
    EXPECT_TRUE(
        waitFor([&] { return log->isChecked() && window->dock("log")->widget()->visibleRegion().isEmpty() == false; }));
    log->trigger();
    EXPECT_TRUE(waitFor([&] { return !window->dock("log")->isVisible() && !log->isChecked(); }));
    log->trigger();
    EXPECT_TRUE(waitFor([&] { return window->dock("log")->isVisible(); }));
}

TEST_F(DockTabsTest, TheFieldsOfTheSearchHaveRoomForWords) {
    ASSERT_NO_FATAL_FAILURE(show("de", {1024, 700}));
    window->showDock("search");
    const auto fields = window->search().findChildren<QLineEdit*>();
    ASSERT_EQ(fields.size(), 2);
    for (const QLineEdit* field : fields) EXPECT_TRUE(waitFor([&] { return field->width() > 180; })) << field->width();
}

} // namespace
} // namespace plc::app
