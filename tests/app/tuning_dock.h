// A project with one control loop that has run a while, with the tuning dock in front. Shared by the dock's tests.
#pragma once
#include "app/panels/live_views.h"
#include "editor/plot/figure_view.h"
#include "editor/tuning/tuning_view.h"
#include "tests/app/studio_fixture.h"
#include "tests/support/settle.h"

#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

namespace plc::app {

inline const char* const kTunedLoop = R"(PROGRAM Main
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
    virtual QByteArray program() const { return kTunedLoop; }
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
        ASSERT_TRUE(waitFor([&] { return part<QComboBox>("tuningModel")->count() > 0; }))
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
    /// What is written is seen at once, and recorded with the next scan.
    void waitForScan() {
        const uint64_t before = control().status().scans;
        ASSERT_TRUE(waitFor([&] { return control().status().scans > before; }));
    }
    void pause() {
        control().pause();
        ASSERT_TRUE(waitFor([&] { return control().status().state == controller::State::Paused; }));
    }
    double value(const char* path) { return control().value(path).text.toDouble(); }
    const waveform::Chart& chart(const char* figure) { return part<plot::FigureView>(figure)->figure().charts.front(); }
    bool waitForTrial() {
        return waitFor([&] {
            const auto& charts = part<plot::FigureView>("tuningTrial")->figure().charts;
            return !charts.empty() && charts.front().curves.size() == 2;
        });
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

} // namespace plc::app
