// The tuning dock as one works with it: find the steps, look at the model, move the sliders, write the parameters in
// one scan, take them back.
#include "editor/plot/figure_view.h"
#include "editor/tuning/tuning_view.h"
#include "tests/app/studio_fixture.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTreeWidget>

namespace plc::app {
namespace {

const char* const kLoop = R"(PROGRAM Main
VAR
    Kp : REAL := 1.5;
    Tn : REAL := 900.0;
    SetPoint : REAL;
    Measured : REAL;
    pid : FB_PID;
    parameters : stPid := (xActValType := TRUE, rTargCyclTime := 10.0, rLowLim := -1000.0, rHighLim := 1000.0);
    first : REAL;
    scan : UDINT;
END_VAR
scan := scan + 1;
SetPoint := DINT_TO_REAL(UDINT_TO_DINT(scan / 1500) MOD 2) * 10.0;
pid(i_xEn := TRUE, i_rSp := SetPoint, i_rPv1 := Measured, i_rKp := Kp, i_rTn := Tn, i_rTd := 60.0, i_stPid := parameters);
first := first + (pid.q_rPidOput * 2.0 - first) * 0.02;
Measured := Measured + (first - Measured) * 0.005;
END_PROGRAM
CONFIGURATION Plc
    RESOURCE Cpu ON Pc
        TASK Fast(INTERVAL := T#10ms, PRIORITY := 1);
        PROGRAM Main WITH Fast : Main;
    END_RESOURCE
END_CONFIGURATION
)";

class TuningDock : public StudioTest {
protected:
    void SetUp() override {
        StudioTest::SetUp();
        put("project.json", "{\n  \"name\": \"Loop\",\n  \"libraries\": [\"toolbox\"]\n}\n");
        put("src/main.st", kLoop);
        ASSERT_TRUE(window->openProject(m_other.path()));
        ASSERT_TRUE(waitFor([&] { return window->workspace().model() != nullptr; }));
        control().setMode({session::Pace::Fastest, 1.0});
        control().start();
        ASSERT_TRUE(waitFor([&] { return control().status().scans > 12'000; }));
        control().pause();
        ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Paused; }));
        const auto toggles = window->findChildren<QAction*>("dock.tuning");
        ASSERT_EQ(toggles.size(), 1);
        if (!toggles.front()->isChecked()) toggles.front()->trigger();
        view = window->findChild<editor::TuningView*>();
        ASSERT_TRUE(view);
        view->parentWidget()->raise();
    }
    void put(const QString& path, const QByteArray& text) {
        QFile file(m_other.path() + "/" + path);
        QDir().mkpath(QFileInfo(file).path());
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    editor::RunControl& control() { return window->control(); }
    template <class Part> Part* part(const char* name) {
        auto* found = view->findChild<Part*>(name);
        EXPECT_TRUE(found) << name;
        return found;
    }
    void click(const char* name) { QTest::mouseClick(part<QPushButton>(name), Qt::LeftButton); }
    void findSteps() {
        click("tuningFind");
        ASSERT_TRUE(waitFor([&] { return part<QComboBox>("tuningModel")->count() > 0; }, 30'000))
            << part<QLabel>("tuningState")->text().toStdString();
    }
    /// "Proposed" of a row of the table.
    QString proposed(const QString& row) {
        for (QTreeWidgetItem* item : part<QTreeWidget>("tuningFigures")->findItems(row, Qt::MatchExactly))
            return item->text(2);
        return {};
    }
    double value(const char* path) { return control().value(path).text.toDouble(); }
    editor::TuningView* view = nullptr;

private:
    QTemporaryDir m_other;
};

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

TEST_F(TuningDock, WritesAllParametersInOneScanAndTakesThemBack) {
    findSteps();
    control().start();
    ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Running; }));
    click("tuningWrite");
    ASSERT_TRUE(waitFor([&] { return value("Main.Kp") != 1.5 && value("Main.Tn") != 900; }));
    click("tuningBack");
    ASSERT_TRUE(waitFor([&] { return value("Main.Kp") == 1.5 && value("Main.Tn") == 900; }));
    control().pause();
    ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Paused; }));
    const session::Session& session = *control().session();
    const auto change = [&](const char* path, history::Position from) {
        const auto expression = session.expression(path);
        EXPECT_TRUE(expression);
        return session.history().findChange(*expression, session.recompile(path), from,
                                            history::History::Direction::Forward);
    };
    const auto first = session.history().statistics().first;
    const auto written = change("Main.Kp", first);
    ASSERT_TRUE(written);
    EXPECT_EQ(written, change("Main.Tn", first));
    const auto back = change("Main.Kp", *written);
    ASSERT_TRUE(back);
    EXPECT_EQ(back, change("Main.Tn", *written));
    EXPECT_FALSE(part<QPushButton>("tuningBack")->isEnabled());
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
        [&] { return part<QPushButton>("tuningFind")->isEnabled() && part<QLabel>("tuningState")->text() != before; },
        30'000));
}

} // namespace
} // namespace plc::app
