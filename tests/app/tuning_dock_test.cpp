// The tuning dock as one works with it: find the steps, look at the model, move the sliders, write the parameters in
// one scan, take them back.
#include "app/panels/live_views.h"
#include "app/settings/translation.h"
#include "editor/kit/theme.h"
#include "editor/plot/figure_view.h"
#include "editor/tuning/tuning_view.h"
#include "projects/loops/loops.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/settle.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTabWidget>
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
    /// The loop as it is written; tests change a word of it.
    virtual QByteArray program() const { return kLoop; }
    virtual QByteArray libraries() const { return "toolbox"; }
    void SetUp() override {
        StudioTest::SetUp();
        put("project.json", "{\n  \"name\": \"Loop\",\n  \"libraries\": [\"" + libraries() + "\"]\n}\n");
        put("src/main.st", program());
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
        for (QWidget* each = view; each; each = each->parentWidget())
            if (qobject_cast<QDockWidget*>(each)) each->raise(); // in front of the other tabs
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
    QString proposed(const QString& row) { return cell(row, 2); }
    QString now(const QString& row) { return cell(row, 1); }
    QString cell(const QString& row, int column) {
        for (QTreeWidgetItem* item : part<QTreeWidget>("tuningFigures")->findItems(row, Qt::MatchExactly))
            return item->text(column);
        return {};
    }
    double value(const char* path) { return control().value(path).text.toDouble(); }
    const waveform::Chart& chart(const char* figure) { return part<plot::FigureView>(figure)->figure().charts.front(); }
    bool waitForTrial() {
        return waitFor(
            [&] {
                const auto& charts = part<plot::FigureView>("tuningTrial")->figure().charts;
                return !charts.empty() && charts.front().curves.size() == 2;
            },
            20'000);
    }
    /// With STEPWISE_PICTURES=FOLDER the window is saved there, for a look.
    void keepPicture(const QString& name) {
        const QString folder = qEnvironmentVariable("STEPWISE_PICTURES");
        if (folder.isEmpty()) return;
        settle();
        EXPECT_TRUE(window->grab().save(folder + "/" + name + ".png"));
        view->setFixedSize(1000, 640); // as a window of its own on a small screen
        settle();
        EXPECT_TRUE(view->grab().save(folder + "/" + name + "_alone.png"));
        view->setMinimumSize(0, 0);
        view->setMaximumSize(QWIDGETSIZE_MAX, QWIDGETSIZE_MAX);
    }
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

/// The output is at its limit whatever the set point does: nothing to make a model from.
class TuningDockAtLimit : public TuningDock {
    QByteArray program() const override {
        QByteArray text = kLoop;
        text.replace("rLowLim := -1000.0, rHighLim := 1000.0", "rLowLim := 0.0, rHighLim := 0.001");
        return text;
    }
};

TEST_F(TuningDockAtLimit, WithoutAModelTheChangesAndTheHealthAreShown) {
    click("tuningFind");
    auto* steps = part<QTreeWidget>("tuningSteps");
    ASSERT_TRUE(waitFor([&] { return steps->topLevelItemCount() > 0; }, 30'000));
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

/// A load that is switched while the set point rests.
class TuningDockWithLoad : public TuningDock {
    QByteArray program() const override {
        QByteArray text = kLoop;
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
    ASSERT_TRUE(
        waitFor([&] { return chart("tuningTrial").title == "The recorded disturbance with these settings"; }, 20'000))
        << chart("tuningTrial").title;
    ASSERT_EQ(chart("tuningTrial").curves.size(), 2U);
    const auto& recorded = chart("tuningTrial").curves[0];
    EXPECT_NEAR(recorded.x.front(), 90, 10); // scan 9000 of 10 ms
    EXPECT_NE(recorded.y, chart("tuningTrial").curves[1].y);
}

/// Parameters that are constants of the call.
class TuningDockWithConstants : public TuningDock {
    QByteArray program() const override {
        QByteArray text = kLoop;
        text.replace("i_rTn := Tn", "i_rTn := 900.0");
        return text;
    }

protected:
    std::string source() { return window->workspace().text("src/main.st"); }
};

TEST_F(TuningDockWithConstants, AreWrittenInTheTextWithAnOnlineChangeAndTakenBack) {
    findSteps();
    EXPECT_TRUE(part<QLabel>("tuningConstants")->isVisibleTo(view));
    EXPECT_TRUE(part<QLabel>("tuningConstants")->text().contains("i_rTn"));
    ASSERT_TRUE(waitForTrial()) << chart("tuningTrial").title;
    const std::string before = source();
    ASSERT_NE(before.find("i_rTn := 900.0"), std::string::npos);
    control().start();
    ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Running; }));
    const uint64_t scans = control().status().scans;
    click("tuningWrite");
    ASSERT_TRUE(waitFor([&] { return value("Main.pid.i_rTn") != 900 && value("Main.Kp") != 1.5; }, 30'000));
    EXPECT_EQ(source().find("i_rTn := 900.0"), std::string::npos);
    EXPECT_GT(control().status().scans, scans); // it went on
    EXPECT_EQ(control().status().state, controller::State::Running);
    ASSERT_TRUE(waitFor([&] { return control().isUpToDate() && part<QPushButton>("tuningBack")->isEnabled(); }));
    click("tuningBack");
    ASSERT_TRUE(waitFor([&] { return value("Main.pid.i_rTn") == 900 && value("Main.Kp") == 1.5; }, 30'000));
    EXPECT_EQ(source(), before);
}

/// Gain and integral time are constants: an online change writes them.
class TuningDockWithGainConstant : public TuningDock {
    QByteArray program() const override {
        QByteArray text = kLoop;
        text.replace("i_rKp := Kp, i_rTn := Tn", "i_rKp := 1.5, i_rTn := 900.0");
        return text.replace("MOD 2) * 10.0;", "MOD 2) * 10.0 + 10.0;"); // at rest the output is 5 or 10, never 0
    }

protected:
    /// By how much the controller's output moves in the scan in which a pin changes.
    double bumpAt(const char* pin, history::Position& from) {
        const session::Session& session = *control().session();
        const auto at = [&](const char* path, history::Position position) {
            return loops::numberAt(*session.program(), session.history().seek(position), path).value_or(1e9);
        };
        const auto expression = session.expression(pin);
        EXPECT_TRUE(expression);
        const auto changed = session.history().findChange(*expression, session.recompile(pin), from,
                                                          history::History::Direction::Forward);
        EXPECT_TRUE(changed) << pin;
        if (!changed) return 1e9;
        from = *changed;
        return std::abs(at("Main.pid.q_rPidOput", *changed) - at("Main.pid.q_rPidOput", *changed - 1));
    }
};

TEST_F(TuningDockWithGainConstant, TheOutputGoesOnWhereItIs) {
    findSteps();
    const double gain = value("Main.pid.i_rKp");
    control().setMode({session::Pace::Real, 1.0}); // as a plant runs: what is seen on the screen is hardly older
    control().start();
    ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Running; }));
    click("tuningWrite");
    ASSERT_TRUE(waitFor([&] { return value("Main.pid.i_rKp") != gain; }, 30'000));
    control().pause();
    ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Paused; }));
    history::Position from = control().session()->history().statistics().first;
    const double bump = bumpAt("Main.pid.i_rKp", from);
    history::Position same = control().session()->history().statistics().first;
    bumpAt("Main.pid.i_rTn", same);
    EXPECT_EQ(from, same); // both in one scan
    EXPECT_GT(std::abs(value("Main.pid.i_rKp") / gain - 1),
              0.2); // with the integral part as it was, it would jump by 1
    EXPECT_LT(bump, 0.3);
}

TEST_F(TuningDockWithConstants, OneUndoTakesTheTextBack) {
    findSteps();
    const std::string before = source();
    click("tuningWrite");
    ASSERT_NE(source(), before);
    window->tabs().undo();
    EXPECT_EQ(source(), before);
}

TEST_F(TuningDock, WritesAllParametersInOneScanAndTakesThemBack) {
    findSteps();
    control().start();
    ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Running; }));
    EXPECT_EQ(now("Gain"), "1.5");
    click("tuningWrite");
    ASSERT_TRUE(waitFor([&] { return value("Main.Kp") != 1.5 && value("Main.Tn") != 900; }));
    EXPECT_EQ(now("Gain"), proposed("Gain")); // in force by now
    EXPECT_EQ(now("Sensitivity Ms"), proposed("Sensitivity Ms"));
    click("tuningBack");
    EXPECT_EQ(now("Gain"), "1.5");
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

/// Each controller block that can be tuned, with parameters in variables.
struct DockBlock {
    const char* name;
    const char* loop; // in the list
    const char* library;
    const char* declaration; // with the gain in Kp, or in para
    const char* call;
    const char* output;
    const char* gain; // path
};

const DockBlock kDockBlocks[] = {
    {"P", "Main.c", "toolbox", "c : FB_P;", "c(i_xEn := TRUE, i_rSp := SetPoint, i_rActVal := Measured, i_rKp := Kp);",
     "c.q_rOput", "Main.Kp"},
    {"Pi", "Main.c", "toolbox",
     "c : FB_PI; para : stPiPara := (tCyclTime := T#10ms, tTn := T#900ms, rKp := 1.5, rMaxLim := 1000.0, rMinLim := "
     "-1000.0);",
     "c(i_xEn := TRUE, i_rSp := SetPoint, i_rActVal := Measured, i_stPara := para);", "c.q_rOput", "Main.para.rKp"},
    {"Pid", "Main.c", "toolbox",
     "c : FB_PID; para : stPid := (xActValType := TRUE, rTargCyclTime := 10.0, rLowLim := -1000.0, rHighLim := "
     "1000.0);",
     "c(i_xEn := TRUE, i_rSp := SetPoint, i_rPv1 := Measured, i_rKp := Kp, i_rTn := Tn, i_rTd := 60.0, i_stPid := "
     "para);",
     "c.q_rPidOput", "Main.Kp"},
    {"Cascade", "Main.c.PID", "toolbox",
     "c : FB_PI_PID; inner : stPIPIDOutLoop := (rKp := 1.5, tTn := T#900ms, tTd := T#60ms, rMaxLim := 1000.0, rMinLim "
     ":= -1000.0); outer : stPIPIDInLoop := (tCyclTime := T#10ms, rKp := 0.5, tTn := T#2s, rMaxLim := 100.0, rMinLim "
     ":= -100.0);",
     "c(i_xEn := TRUE, i_xManModePI := TRUE, i_rManValPI := SetPoint, i_rActValPID := Measured, i_stParaPID := inner, "
     "i_stParaPI := outer);",
     "c.q_rOput", "Main.inner.rKp"},
    {"Util", "Main.c", "util", "c : util.PID;",
     "c(ACTUAL := Measured, SET_POINT := SetPoint, KP := Kp, TN := Seconds, TV := 0.0, Y_MIN := -1000.0, Y_MAX := "
     "1000.0);",
     "c.Y", "Main.Kp"},
    {"UtilFixed", "Main.c", "util", "c : util.PID_FIXCYCLE;",
     "c(ACTUAL := Measured, SET_POINT := SetPoint, KP := Kp, TN := Seconds, TV := 0.0, Y_MIN := -1000.0, Y_MAX := "
     "1000.0, CYCLE := 0.01);",
     "c.Y", "Main.Kp"},
    {"AnnexF", "Main.c", "analog", "c : analog.PID; Reversed : REAL := -1.5;",
     "c(AUTO := TRUE, PV := Measured, SP := SetPoint, KP := Reversed, TR := Seconds, TD := 0.0, CYCLE := T#10ms);",
     "c.XOUT", "Main.Reversed"},
};

class TuningDockBlocks : public TuningDock, public ::testing::WithParamInterface<DockBlock> {
protected:
    QByteArray program() const override {
        QByteArray text = kLoop;
        const int call = text.indexOf("pid(i_xEn"), end = text.indexOf('\n', call);
        text.replace(call, end - call, GetParam().call);
        const int declaration = text.indexOf("    pid : FB_PID;"), first = text.indexOf("    first : REAL;");
        text.replace(declaration, first - declaration,
                     QByteArray("    Seconds : REAL := 0.9;\n    ") + GetParam().declaration + "\n");
        return text.replace("pid.q_rPidOput", GetParam().output);
    }
    QByteArray libraries() const override { return GetParam().library; }
};

TEST_P(TuningDockBlocks, IsFoundWrittenAndTakenBack) {
    const DockBlock& block = GetParam();
    auto* loop = part<QComboBox>("tuningLoop");
    loop->setCurrentIndex(loop->findText(block.loop));
    ASSERT_EQ(loop->currentText(), block.loop);
    findSteps();
    ASSERT_TRUE(waitForTrial()) << chart("tuningTrial").title;
    const double before = value(block.gain);
    control().start();
    ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Running; }));
    ASSERT_TRUE(part<QPushButton>("tuningWrite")->isEnabled());
    click("tuningWrite");
    ASSERT_TRUE(waitFor([&] { return value(block.gain) != before; }));
    EXPECT_EQ(value(block.gain) < 0, before < 0);
    click("tuningBack");
    ASSERT_TRUE(waitFor([&] { return value(block.gain) == before; }));
}

INSTANTIATE_TEST_SUITE_P(All, TuningDockBlocks, ::testing::ValuesIn(kDockBlocks),
                         [](const auto& info) { return std::string(info.param.name); });

/// The set point goes up and down without rest, so that there is an error in every scan and the output always moves.
class TuningDockMoving : public TuningDockBlocks {
protected:
    QByteArray program() const override {
        QByteArray text = TuningDockBlocks::program();
        text.replace("    scan : UDINT;", "    scan : UDINT;\n    Waves : BOOL;");
        return text.replace("MOD 2) * 10.0;",
                            "MOD 2) * 10.0;\nIF Waves THEN\n    SetPoint := ABS(UDINT_TO_REAL(scan MOD 400) - 200.0) / "
                            "10.0;\nEND_IF");
    }
    void startWaves() {
        control().start();
        ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Running; }));
        ASSERT_TRUE(control().write("Main.Waves", "TRUE"));
        ASSERT_TRUE(waitFor([&] { return control().value("Main.Waves").text == "TRUE"; }));
        waitForScans();
    }
    /// Enough of them to see how the loop moves with the settings of now.
    void waitForScans() {
        const uint64_t now = control().status().scans;
        ASSERT_TRUE(waitFor([&] { return control().status().scans > now + 3000; }));
    }
    void changeGain(const char* button, const std::string& pin) {
        ASSERT_TRUE(waitFor([&] { return part<QPushButton>(button)->isEnabled() && control().isUpToDate(); }, 30'000));
        const double before = value(pin.c_str());
        click(button);
        ASSERT_TRUE(waitFor([&] { return value(pin.c_str()) != before; }, 30'000)) << button;
        waitForScans();
    }
    /// Writes and takes back a few times at full speed; then the output's move in each scan in which the gain changed
    /// is compared with its greatest move in the scans around.
    void writeAndTakeBackWithoutABump() {
        auto* list = part<QComboBox>("tuningLoop");
        list->setCurrentIndex(list->findText(GetParam().loop));
        findSteps();
        startWaves();
        const auto loop = loops::findLoop(*control().session()->program(), GetParam().loop);
        ASSERT_TRUE(loop);
        const std::string gain = loop->pin(loop->form->parameters.front().member);
        const std::string output = loop->pin(loop->form->input);
        const history::Position begin = control().status().position;
        for (int i = 0; i < 3; ++i) {
            changeGain("tuningWrite", gain);
            changeGain("tuningBack", gain);
        }
        control().pause();
        ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Paused; }));
        const session::Session& session = *control().session();
        const auto expression = session.expression(gain), moved = session.expression(output);
        ASSERT_TRUE(expression && moved);
        history::Position from = begin;
        for (int i = 0; i < 6; ++i) {
            const auto changed = session.history().findChange(*expression, session.recompile(gain), from,
                                                              history::History::Direction::Forward);
            ASSERT_TRUE(changed) << "change " << i;
            from = *changed;
            double there = 0, around = 0, last = 0;
            const auto samples = session.history().samples(*moved, session.recompile(output), from - 1000, from + 1000);
            ASSERT_EQ(samples.size(), 2000U);
            for (size_t s = 0; s < samples.size(); last = samples[s++].value)
                if (s > 0)
                    (s == 1000 ? there : around) = std::max(s == 1000 ? 0 : around, std::abs(samples[s].value - last));
            EXPECT_GT(around, 0.01) << "nothing moves: nothing is compared";
            EXPECT_LE(there, around * 1.01) << "change " << i;
        }
    }
};

TEST_P(TuningDockMoving, TheOutputGoesOnAtFullSpeed) { writeAndTakeBackWithoutABump(); }

// FB_P has no integral part: its output is its gain times the error
INSTANTIATE_TEST_SUITE_P(All, TuningDockMoving, ::testing::ValuesIn(std::begin(kDockBlocks) + 1, std::end(kDockBlocks)),
                         [](const auto& info) { return std::string(info.param.name); });

/// The same with constants in the call: an online change writes them.
class TuningDockMovingConstants : public TuningDockMoving {
    QByteArray program() const override {
        QByteArray text = TuningDockMoving::program();
        text.replace("i_rKp := Kp, i_rTn := Tn", "i_rKp := 1.5, i_rTn := 900.0");
        text.replace("KP := Kp, TN := Seconds", "KP := 1.5, TN := 0.9");
        return text.replace("KP := Reversed, TR := Seconds", "KP := -1.5, TR := 0.9");
    }
};

TEST_P(TuningDockMovingConstants, TheOutputGoesOnAtFullSpeed) { writeAndTakeBackWithoutABump(); }

INSTANTIATE_TEST_SUITE_P(All, TuningDockMovingConstants,
                         ::testing::Values(kDockBlocks[2], kDockBlocks[4], kDockBlocks[5], kDockBlocks[6]),
                         [](const auto& info) { return std::string(info.param.name); });

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
