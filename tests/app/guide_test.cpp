// An example says what to press: its README is beside it, in sight with its panel; and the tour is about the project at
// hand and above what it speaks of.
#include "app/start/guide_view.h"
#include "app/start/start_page.h"
#include "app/start/tour.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/settle.h"

#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTextBlock>

namespace plc::app {
namespace {

class GuideTest : public StudioTest {};

TEST_F(GuideTest, AnExampleOpensWithItsReadmeAndAPanelThatCanBeRead) {
    window->resize(1600, 1000);
    ASSERT_TRUE(window->openExample(StartPage::examplesFolder() + "/pid_pt1", true));
    QApplication::processEvents();
    EXPECT_FALSE(window->guide().toPlainText().isEmpty());
    EXPECT_TRUE(window->guide().isVisible());
    auto* panel = window->findChild<QDockWidget*>("panel");
    ASSERT_TRUE(panel);
    EXPECT_GT(panel->width(), 560);
    EXPECT_GT(panel->height(), 330);
}

TEST_F(GuideTest, OnlyHeadingsAreHeadingsAlsoAfterTheWidthHasChanged) {
    write("README.md", "# A machine\n\nIt runs. Press Start.\n");
    GuideView view;
    view.show();
    view.resize(300, 200);
    ASSERT_TRUE(view.showProject(folder.path()));
    view.resize(500, 200);
    QApplication::processEvents();
    const QTextBlock first = view.document()->firstBlock();
    EXPECT_EQ(first.blockFormat().headingLevel(), 1);
    EXPECT_EQ(first.next().text(), "It runs. Press Start.");
    EXPECT_EQ(first.next().blockFormat().headingLevel(), 0);
    EXPECT_NE(first.next().begin().fragment().charFormat().fontWeight(), QFont::Bold);
    EXPECT_EQ(GuideView::summaryOf(folder.path()), "It runs. Press Start.");
}

TEST_F(GuideTest, AReadmeInTheStudiosLanguageIsShownInsteadOfTheEnglishOne) {
    write("README.md", "# A machine\n\nIt runs.\n");
    write("README.de.md", "# Eine Maschine\n\nSie läuft.\n");
    const QLocale before;
    for (const auto& [language, summary] :
         {std::pair("de", "Sie läuft."), std::pair("en", "It runs."), std::pair("fr", "It runs.")}) {
        QLocale::setDefault(QLocale(language));
        GuideView view;
        ASSERT_TRUE(view.showProject(folder.path()));
        EXPECT_EQ(GuideView::summaryOf(folder.path()), summary);
        EXPECT_TRUE(view.toPlainText().contains(summary)) << language;
    }
    QLocale::setDefault(before);
}

TEST_F(GuideTest, FilesThatTheReadmeNamesOpenAndOtherPlacesAreLeftAlone) {
    QString wanted;
    GuideView view;
    QObject::connect(&view, &GuideView::fileRequested, [&](const QString& file) { wanted = file; });
    emit view.anchorClicked(QUrl("src/main.st"));
    EXPECT_EQ(wanted, "src/main.st");
}

TEST_F(GuideTest, TheFirstStopOfTheTourShowsAllOfItsTextAndTheWindowKeepsItsSize) {
    window->closeProject();
    window->resize(1024, 700);
    ASSERT_TRUE(waitFor([&] { return window->size() == QSize(1024, 700); }));
    ASSERT_TRUE(window->openExample(StartPage::examplesFolder() + "/pid_pt1", true));
    window->startTour();
    auto* tour = window->findChild<Tour*>();
    ASSERT_TRUE(tour && tour->isVisible());
    settle();
    for (const QLabel* label : tour->findChildren<QLabel*>())
        EXPECT_GE(label->height(), label->hasHeightForWidth() ? label->heightForWidth(label->width()) : 0)
            << "cut: " << label->text().toStdString();
    EXPECT_TRUE(waitFor([&] { return window->size() == QSize(1024, 700); }))
        << window->width() << " x " << window->height();
}

TEST_F(GuideTest, TheTourIsAboutTheProjectAtHandAndStaysAboveItsDocks) {
    window->startTour();
    auto* tour = window->findChild<Tour*>();
    ASSERT_TRUE(tour && tour->isVisible());
    QString first;
    for (const QLabel* label : tour->findChildren<QLabel*>()) first += label->text() + '\n';
    EXPECT_FALSE(first.contains("PID")) << first.toStdString();
    for (int i = 0; i + 1 < tour->count(); ++i) {
        tour->next();
        QApplication::processEvents();
        for (const QLabel* label : tour->findChildren<QLabel*>())
            EXPECT_GE(label->height(), label->hasHeightForWidth() ? label->heightForWidth(label->width()) : 0)
                << "cut: " << label->text().toStdString();
        QWidget* top = window->childAt(tour->rect().center());
        EXPECT_TRUE(top && (top == tour || tour->isAncestorOf(top))) << "stop " << i + 1;
    }
    tour->next();
}

TEST_F(GuideTest, TheTourStaysAboveTheDocksThatAFaultShows) {
    window->workspace().setText("src/main.st", "PROGRAM Main\nVAR a : INT; END_VAR\na := 1 / a;\nEND_PROGRAM\n");
    ASSERT_TRUE(window->workspace().save("src/main.st"));
    analysed();
    window->startTour();
    auto* tour = window->findChild<Tour*>();
    ASSERT_TRUE(tour && tour->isVisible());
    QTest::keyClick(window.get(), Qt::Key_F5); // as its first stop offers
    ASSERT_TRUE(waitFor([&] { return window->control().status().state == controller::State::Fault; }));
    ASSERT_TRUE(waitFor([&] { return window->dock("callPath")->isVisible(); }));
    settle();
    for (const QDockWidget* dock : window->findChildren<QDockWidget*>()) {
        if (!dock->isVisible() || dock->isFloating()) continue;
        const QPoint inside = dock->mapTo(window.get(), dock->rect().center());
        if (!window->rect().contains(inside)) continue;
        QWidget* top = window->childAt(inside);
        EXPECT_TRUE(top == tour || tour->isAncestorOf(top)) << dock->objectName().toStdString();
    }
    QTest::keyClick(tour, Qt::Key_Escape);
    EXPECT_FALSE(tour->isVisible());
}

} // namespace
} // namespace plc::app
