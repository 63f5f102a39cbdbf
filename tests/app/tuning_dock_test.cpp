// The tuning dock as one works with it: find the steps, look at the model and its pictures, move the sliders.
#include "tests/app/tuning_dock.h"

#include "editor/kit/theme.h"

#include <QSlider>
#include <QTabWidget>

namespace plc::app {
namespace {

TEST_F(TuningDock, FindsTheStepsAndModelsTheProcess) {
    EXPECT_EQ(part<QComboBox>("tuningLoop")->currentText(), "Main.pid");
    EXPECT_FALSE(part<QPushButton>("tuningWrite")->isEnabled());
    findSteps();
    EXPECT_GE(part<QTreeWidget>("tuningSteps")->topLevelItemCount(), 5);
    EXPECT_FALSE(part<plot::FigureView>("tuningData")->figure().charts.front().curves.empty());
    EXPECT_EQ(part<plot::FigureView>("tuningSetPoint")->figure().charts.front().curves.size(), 2U); // now and proposed
    EXPECT_TRUE(waitFor([&] {
        const auto& charts = part<plot::FigureView>("tuningTrial")->figure().charts;
        return !charts.empty() && charts.front().curves.size() == 2;
    }));
    EXPECT_FALSE(part<QLabel>("tuningWords")->text().isEmpty());
}

TEST_F(TuningDock, TheSlidersMoveTheSettings) {
    findSteps();
    const double middle = proposed("Gain").toDouble();
    ASSERT_GT(middle, 0);
    auto* brisk = part<QSlider>("tuningBrisk");
    brisk->setFocus();
    QTest::keyClick(brisk, Qt::Key_End);
    const double most = proposed("Gain").toDouble();
    QTest::keyClick(brisk, Qt::Key_Home);
    const double least = proposed("Gain").toDouble();
    EXPECT_GT(most, middle);
    EXPECT_LT(least, middle);
    auto* rule = part<QComboBox>("tuningRule");
    rule->setFocus();
    QTest::keyClick(rule, Qt::Key_End); // Ziegler-Nichols: with a warning
    EXPECT_TRUE(part<QLabel>("tuningWords")->text().contains("Ziegler-Nichols"));
}

TEST_F(TuningDock, TheSliderFromDisturbanceToSetPointMovesBothResponses) {
    findSteps();
    auto* kind = part<QComboBox>("tuningKind");
    for (const int rule : {0, 2}) { // SIMC and the optimum
        part<QComboBox>("tuningRule")->setCurrentIndex(rule);
        kind->setCurrentIndex(1);
        auto* tracking = part<QSlider>("tuningTracking");
        tracking->setFocus();
        QTest::keyClick(tracking, Qt::Key_Home);
        const std::vector<double> setPoint = chart("tuningSetPoint").curves.back().y;
        const double loadError = proposed("Error after a load step").toDouble();
        const double overshoot = proposed("Overshoot").section(' ', 0, 0).toDouble();
        QTest::keyClick(tracking, Qt::Key_End);
        EXPECT_NE(chart("tuningSetPoint").curves.back().y, setPoint) << rule;
        // less for the disturbance, less overshoot at the set point
        EXPECT_GT(proposed("Error after a load step").toDouble(), loadError * 1.05) << rule;
        EXPECT_LE(proposed("Overshoot").section(' ', 0, 0).toDouble(), overshoot) << rule;
        // with the mouse too: a click in the middle of the groove moves a page towards it
        const int end = tracking->value();
        QTest::mouseClick(tracking, Qt::LeftButton, {}, tracking->rect().center());
        EXPECT_LT(tracking->value(), end) << rule;
    }
}

TEST_F(TuningDock, TheBodePlotHasTheMarginsOfTheTable) {
    findSteps();
    auto* tabs = part<QTabWidget>("tuningCharts");
    ASSERT_EQ(tabs->count(), 4);
    QTest::mouseClick(tabs->tabBar(), Qt::LeftButton, {}, tabs->tabBar()->tabRect(2).center());
    auto* bode = part<plot::FigureView>("tuningBode");
    EXPECT_TRUE(bode->isVisible());
    ASSERT_EQ(bode->figure().charts.size(), 2U);
    ASSERT_FALSE(bode->figure().charts[1].notes.empty());
    const QString margin = proposed("Phase margin");
    EXPECT_TRUE(QString::fromStdString(bode->figure().charts[1].notes.front().text).endsWith(margin))
        << bode->figure().charts[1].notes.front().text << " and " << margin.toStdString();
    const auto before = bode->figure().charts[0].notes.front().x;
    auto* brisk = part<QSlider>("tuningBrisk");
    brisk->setFocus();
    QTest::keyClick(brisk, Qt::Key_Home);
    EXPECT_LT(bode->figure().charts[0].notes.front().x, before); // calm: crosses over at less
}

TEST_F(TuningDock, AStepFoundWhileTheControllerRunsIsTriedOnItsOwnScans) {
    control().setMode({session::Pace::Factor, 300}); // a search makes many scans old, and none is forgotten meanwhile
    control().start();
    ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Running; }));
    findSteps();
    control().pause();
    ASSERT_TRUE(waitForTrial()) << chart("tuningTrial").title;
    auto* steps = part<QTreeWidget>("tuningSteps");
    ASSERT_TRUE(steps->currentItem());
    // the change is at 1,500 scans or a multiple of it, and the curve around it shows it
    const std::vector<double>& times = chart("tuningTrial").curves.front().x;
    const QString moment = steps->currentItem()->text(1);
    EXPECT_TRUE(std::any_of(times.begin(), times.end(),
                            [&](double time) { return plot::momentText(std::llround(time * 1e9)) == moment; }))
        << moment.toStdString() << " is not between " << times.front() << " and " << times.back() << " s";
}

TEST_F(TuningDock, OneStepAloneCanBeChosen) {
    findSteps();
    auto* steps = part<QTreeWidget>("tuningSteps");
    std::vector<QTreeWidgetItem*> used;
    for (int i = 0; i < steps->topLevelItemCount(); ++i)
        if (steps->topLevelItem(i)->checkState(0) == Qt::Checked) used.push_back(steps->topLevelItem(i));
    ASSERT_GE(used.size(), 2U);
    const QString before = part<QLabel>("tuningState")->text();
    const QRect row = steps->visualItemRect(used.front());
    QTest::mouseClick(steps->viewport(), Qt::LeftButton, {}, {row.left() + 12, row.center().y()});
    if (used.front()->checkState(0) == Qt::Checked)
        used.front()->setCheckState(0, Qt::Unchecked); // a style with other margins
    EXPECT_TRUE(waitFor(
        [&] { return part<QPushButton>("tuningFind")->isEnabled() && part<QLabel>("tuningState")->text() != before; }));
}

TEST_F(TuningDock, PicturesForALook) {
    findSteps();
    ASSERT_TRUE(waitForTrial());
    auto* tabs = part<QTabWidget>("tuningCharts");
    for (const bool isDark : {false, true}) {
        kit::Theme::current().setChoice(isDark ? kit::ThemeChoice::Dark : kit::ThemeChoice::Light);
        for (const QSize size : {QSize(1600, 1000), QSize(1024, 700)}) {
            window->resize(size);
            const char* const figures[] = {"tuningData", "tuningTrial", "tuningBode", "tuningRecorded"};
            for (int tab = 0; tab < 4; ++tab) {
                tabs->setCurrentIndex(tab);
                keepPicture(QString("tuning_%1_%2_%3").arg(size.width()).arg(tab).arg(isDark));
                const auto frames = part<plot::FigureView>(figures[tab])->frames();
                ASSERT_FALSE(frames.empty()) << figures[tab];
                EXPECT_GT(frames.front().area.height(), 20) << figures[tab];
            }
        }
    }
    kit::Theme::current().setChoice(kit::ThemeChoice::Light);
}

/// A load that is switched while the set point rests.
class TuningDockWithLoad : public TuningDock {
    QByteArray program() const override {
        QByteArray text = kTunedLoop;
        text.replace("scan / 1500) MOD 2) * 10.0", "scan / 6000) MOD 2) * 10.0");
        text.replace("(pid.q_rPidOput * 2.0 - first)", "(pid.q_rPidOput * 2.0 + SEL(scan > 9000, 0.0, -4.0) - first)");
        return text;
    }
};

TEST_F(TuningDockWithLoad, ADisturbanceIsListedAndTried) {
    findSteps();
    auto* steps = part<QTreeWidget>("tuningSteps");
    const auto found = steps->findItems("disturbance", Qt::MatchExactly, 2);
    ASSERT_EQ(found.size(), 1);
    EXPECT_FALSE(found.front()->data(0, Qt::CheckStateRole).isValid()); // no model is made from it
    EXPECT_EQ(found.front()->text(5), "usable");
    ASSERT_TRUE(waitForTrial());
    EXPECT_EQ(chart("tuningTrial").title, "The recorded step with these settings");
    steps->scrollToItem(found.front());
    QTest::mouseClick(steps->viewport(), Qt::LeftButton, {}, steps->visualItemRect(found.front()).center());
    ASSERT_EQ(steps->currentItem(), found.front());
    ASSERT_TRUE(waitFor([&] { return chart("tuningTrial").title == "The recorded disturbance with these settings"; }))
        << chart("tuningTrial").title;
    ASSERT_EQ(chart("tuningTrial").curves.size(), 2U);
    const auto& recorded = chart("tuningTrial").curves[0];
    EXPECT_NEAR(recorded.x.front(), 90, 10); // scan 9000 of 10 ms
    EXPECT_NE(recorded.y, chart("tuningTrial").curves[1].y);
}

} // namespace
} // namespace plc::app
