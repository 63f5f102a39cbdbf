// How the loop is doing: a tab of the tuning dock and a page in a file, also from a recording and without a model.
#include "app/settings/translation.h"
#include "tests/app/tuning_dock.h"

#include <QSignalSpy>
#include <QTabWidget>

namespace plc::app {
namespace {

TEST_F(TuningDock, HowTheLoopIsDoingIsATabAndAPageInAFile) {
    EXPECT_FALSE(part<QPushButton>("tuningReport")->isEnabled());
    findSteps();
    auto* tabs = part<QTabWidget>("tuningCharts");
    QTest::mouseClick(tabs->tabBar(), Qt::LeftButton, {}, tabs->tabBar()->tabRect(3).center());
    EXPECT_TRUE(part<QLabel>("tuningHealthWords")->isVisible());
    EXPECT_TRUE(part<QLabel>("tuningHealthWords")->text().contains("oscillate"));
    EXPECT_EQ(part<QTreeWidget>("tuningHealthFigures")->topLevelItemCount(), 6);
    EXPECT_EQ(part<plot::FigureView>("tuningRecorded")->figure().charts.size(), 2U);
    EXPECT_TRUE(part<QPushButton>("tuningReport")->isEnabled());
    view->writeReport(folder.path() + "/loop.html");
    QFile page(folder.path() + "/loop.html");
    ASSERT_TRUE(page.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(page.readAll());
    for (const char* expected : {"<h1>Main.pid</h1>", "Loop health", "Main.Measured", "<polyline", "SIMC", "i_rKp"})
        EXPECT_TRUE(text.contains(expected)) << expected;
    EXPECT_FALSE(text.contains("nan"));
    view->writeReport(folder.path() + "/loop.pdf");
    QFile pdf(folder.path() + "/loop.pdf");
    ASSERT_TRUE(pdf.open(QIODevice::ReadOnly));
    EXPECT_TRUE(pdf.read(5) == "%PDF-");
    QSignalSpy said(view, &editor::TuningView::message);
    view->writeReport("/nowhere/loop.html");
    ASSERT_EQ(said.size(), 1);
    EXPECT_TRUE(said.front().at(1).toBool());
}

TEST_F(TuningDock, TheReportIsInTheLanguageOfTheStudio) {
    findSteps();
    const QString pictures = qEnvironmentVariable("STEPWISE_PICTURES"); // kept there, for a look
    for (const auto& [language, words] :
         {std::pair{"de", std::vector<const char*>{"<html lang=\"de", "Modell", "Verstärkung", "Ausgang"}},
          std::pair{"zh_CN", std::vector<const char*>{"<html lang=\"zh", "模型", "增益"}}}) {
        installTranslation(*qApp, language);
        for (const char* suffix : {"html", "pdf"})
            view->writeReport((pictures.isEmpty() ? folder.path() : pictures) + "/report_" + language + "." + suffix);
        QFile page((pictures.isEmpty() ? folder.path() : pictures) + "/report_" + language + ".html");
        ASSERT_TRUE(page.open(QIODevice::ReadOnly));
        const QString text = QString::fromUtf8(page.readAll());
        for (const char* expected : words) EXPECT_TRUE(text.contains(expected)) << expected;
        for (const char* english : {"Loop health", "settling time", "recorded", "verdict", "phase margin"})
            EXPECT_FALSE(text.contains(english)) << language << " " << english;
    }
    installTranslation(*qApp, "en");
}

TEST_F(TuningDock, ARecordingFromAFileIsLookedAtWithoutAController) {
    const QString path = folder.path() + "/loop.rec";
    ASSERT_TRUE(window->live().saveRecording(path));
    control().disconnectSession();
    ASSERT_FALSE(part<QPushButton>("tuningFind")->isEnabled());
    ASSERT_TRUE(window->live().openRecording(path));
    ASSERT_TRUE(waitFor([&] { return part<QComboBox>("tuningLoop")->count() == 1; }));
    findSteps();
    EXPECT_TRUE(waitForTrial()) << chart("tuningTrial").title;
    EXPECT_FALSE(part<QPushButton>("tuningWrite")->isEnabled()); // nothing to write to
    EXPECT_FALSE(part<QPushButton>("tuningBack")->isEnabled());
}

/// The output is at its limit whatever the set point does: nothing to make a model from.
class TuningDockAtLimit : public TuningDock {
    QByteArray program() const override {
        QByteArray text = kTunedLoop;
        text.replace("rLowLim := -1000.0, rHighLim := 1000.0", "rLowLim := 0.0, rHighLim := 0.001");
        return text;
    }
};

TEST_F(TuningDockAtLimit, WithoutAModelTheChangesAndTheHealthAreShown) {
    click("tuningFind");
    auto* steps = part<QTreeWidget>("tuningSteps");
    ASSERT_TRUE(waitFor([&] { return steps->topLevelItemCount() > 0; }));
    EXPECT_TRUE(part<QLabel>("tuningState")->text().contains("usable"))
        << part<QLabel>("tuningState")->text().toStdString();
    EXPECT_FALSE(part<QLabel>("tuningHealthWords")->text().isEmpty());
    EXPECT_FALSE(part<QPushButton>("tuningWrite")->isEnabled());
    EXPECT_EQ(part<QTreeWidget>("tuningFigures")->topLevelItemCount(), 0);
    view->writeReport(folder.path() + "/loop.html");
    QFile page(folder.path() + "/loop.html");
    ASSERT_TRUE(page.open(QIODevice::ReadOnly));
    EXPECT_TRUE(QString::fromUtf8(page.readAll()).contains("No model: "));
}

} // namespace
} // namespace plc::app
