// What someone sees who starts the studio for the first time: a loop with its trace and its panel, a tour that says
// what to press, and a start page on which every machine has a picture.
#include "app/main_window.h"
#include "app/panels/live_views.h"
#include "app/settings/settings.h"
#include "app/start/start_page.h"
#include "app/start/tour.h"
#include "hmi/player/panel_player.h"
#include "tests/support/paths.h"
#include "tests/support/patience.h"
#include "tests/support/settle.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollBar>
#include <QSettings>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>

#include <gtest/gtest.h>

#include <filesystem>

namespace plc::app {
namespace {

TEST(StartPageTest, SeesTraceAndPanelAndIsToldWhatToPress) {
    QSettings("Stepwise", "Stepwise").clear();
    QTemporaryDir folder; // a copy: what a run retains belongs to its project
    QElapsedTimer timer;
    timer.start();
    MainWindow window;
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&window, kPatience));
    EXPECT_FALSE(window.settings().sawTour());
    const std::string copy = folder.path().toStdString() + "/pid_pt1";
    std::filesystem::copy(plc::sourceDir() + "/projects/examples/pid_pt1", copy,
                          std::filesystem::copy_options::recursive);
    ASSERT_TRUE(window.openProject(QString::fromStdString(copy)));
    window.startTour();
    const auto waitFor = [&](const std::function<bool()>& condition) { return QTest::qWaitFor(condition, kPatience); };
    EXPECT_TRUE(waitFor([&] {
        return window.live().player() && window.live().player()->isVisible() && window.live().traceView().isVisible();
    }));
    EXPECT_EQ(window.live().player()->panelName(), "loop");
    EXPECT_GT(window.live().player()->height(), 200) << "large enough to read";
    auto* tour = window.findChild<Tour*>();
    ASSERT_TRUE(tour && tour->isVisible());
    bool saysWhatToPress = false;
    for (const QLabel* label : tour->findChildren<QLabel*>()) saysWhatToPress |= label->text().contains("F5");
    EXPECT_TRUE(saysWhatToPress);
    QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : &window, Qt::Key_F5);
    EXPECT_TRUE(waitFor([&] { return window.control().status().scans > 20; })) << "F5 works while the tour stands";
    EXPECT_TRUE(waitFor(
        [&] { return window.live().player()->values() && window.live().player()->values()->status().scans > 20; }));
    window.control().disconnectSession();
    Settings().setSawTour();
}

TEST(StartPageTest, FindsAPictureOfEveryExampleOnTheStartPage) {
    Settings settings;
    StartPage page(settings);
    page.resize(1200, 8000); // room for every card
    page.show();
    const QListWidgetItem* last = page.examples().item(page.examples().count() - 1);
    ASSERT_TRUE(QTest::qWaitFor([&] { return last->data(StartPage::kPictureRole).isValid(); }, kPatience));
    const QDir folder(StartPage::examplesFolder());
    EXPECT_EQ(page.examples().count(), folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot).size());
    for (int row = 0; row < page.examples().count(); ++row) {
        const QListWidgetItem* item = page.examples().item(row);
        const QString project = item->data(Qt::UserRole).toString();
        EXPECT_TRUE(QFile::exists(project + "/docs/panel.png")) << project.toStdString();
        EXPECT_FALSE(item->data(StartPage::kPictureRole).value<QPixmap>().isNull()) << project.toStdString();
        EXPECT_FALSE(item->data(Qt::UserRole + 2).toString().isEmpty()) << project.toStdString();
    }
}

TEST(StartPageTest, AForeignProjectIsImportedWithoutOneThatIsOpen) {
    MainWindow window;
    EXPECT_TRUE(window.action("file.import")->isEnabled());
    EXPECT_FALSE(window.action("file.export")->isEnabled());
}

int picturesOf(StartPage& page) {
    int count = 0;
    for (int row = 0; row < page.examples().count(); ++row)
        count += page.examples().item(row)->data(StartPage::kPictureRole).isValid() ? 1 : 0;
    return count;
}

TEST(StartPageTest, ReadsOnlyThePicturesThatAreSeen) {
    Settings settings;
    StartPage page(settings);
    page.resize(1200, 500);
    settle();
    EXPECT_EQ(picturesOf(page), 0) << "nobody sees the page";
    page.show();
    QListWidget& examples = page.examples();
    const auto has = [&](int row) { return examples.item(row)->data(StartPage::kPictureRole).isValid(); };
    ASSERT_TRUE(QTest::qWaitFor([&] { return has(0); }, kPatience));
    settle();
    EXPECT_LT(picturesOf(page), examples.count() / 2);
    examples.scrollToBottom();
    ASSERT_TRUE(QTest::qWaitFor([&] { return has(examples.count() - 1); }, kPatience)) << "those that scroll into view";
    page.reload(); // the list is another one then
    examples.scrollToTop();
    ASSERT_TRUE(QTest::qWaitFor([&] { return has(0); }, kPatience));
}

TEST(StartPageTest, ALongFolderOfARecentProjectIsElided) {
    QTemporaryDir folder;
    const QString deep = folder.path() + "/" + QString(120, 'a') + "/" + QString(120, 'b');
    ASSERT_TRUE(QDir().mkpath(deep));
    QFile project(deep + "/project.json");
    ASSERT_TRUE(project.open(QIODevice::WriteOnly));
    project.write("{}");
    project.close();
    Settings settings;
    settings.addRecent(deep);
    StartPage page(settings);
    page.resize(900, 600);
    page.show();
    settle();
    auto* recent = page.findChild<QListWidget*>("recentProjects");
    ASSERT_TRUE(recent);
    ASSERT_GT(recent->count(), 0);
    EXPECT_TRUE(recent->item(0)->text().contains(QDir::toNativeSeparators(deep)));
    EXPECT_FALSE(recent->horizontalScrollBar()->isVisible());
    EXPECT_LE(recent->visualItemRect(recent->item(0)).right(), recent->viewport()->width());
}

/// STEPWISE_EXAMPLES as long as this lives.
class ExamplesIn {
public:
    explicit ExamplesIn(const QString& folder) { qputenv("STEPWISE_EXAMPLES", folder.toUtf8()); }
    ~ExamplesIn() {
        if (m_before.isNull())
            qunsetenv("STEPWISE_EXAMPLES");
        else
            qputenv("STEPWISE_EXAMPLES", m_before);
    }
    ExamplesIn(const ExamplesIn&) = delete;
    ExamplesIn& operator=(const ExamplesIn&) = delete;

private:
    const QByteArray m_before = qgetenv("STEPWISE_EXAMPLES");
};

bool offersTheTour(const QWidget& page) {
    for (const QPushButton* button : page.findChildren<QPushButton*>())
        if (button->text() == "Take the Tour") return !button->isHidden();
    return false;
}

TEST(StartPageTest, WithoutExamplesSaysWhereTheyWereLookedForAndOffersNothingThatNeedsThem) {
    QTemporaryDir empty;
    Settings settings;
    for (const QString& folder : {empty.path(), empty.path() + "/missing"}) {
        const ExamplesIn there(folder);
        StartPage page(settings);
        const auto* note = page.findChild<QLabel*>("noExamples");
        ASSERT_TRUE(note);
        EXPECT_FALSE(note->isHidden());
        EXPECT_TRUE(note->text().contains(folder)) << note->text().toStdString();
        EXPECT_TRUE(note->text().contains("STEPWISE_EXAMPLES")) << note->text().toStdString();
        EXPECT_EQ(page.examples().count(), 0);
        EXPECT_FALSE(offersTheTour(page));
        bool saysToOpenOne = false;
        for (const QLabel* label : page.findChildren<QLabel*>()) saysToOpenOne |= label->text().contains("open one");
        EXPECT_FALSE(saysToOpenOne);
        MainWindow window; // the tour is in the menu, too
        window.startTour();
        EXPECT_FALSE(window.workspace().isOpen());
        EXPECT_TRUE(window.statusBar()->currentMessage().contains("open or create a project"))
            << window.statusBar()->currentMessage().toStdString();
    }
    StartPage page(settings); // with the shipped ones
    EXPECT_TRUE(page.findChild<QLabel*>("noExamples")->isHidden());
    EXPECT_TRUE(offersTheTour(page));
}

} // namespace
} // namespace plc::app
