// An hour of 1 ms scans of a loop: the time to read its signals from the recording, to find the steps and to model the
// process; what a move of a slider costs; and the diagnosis of a loop whose valve sticks.
#include "projects/loops/loops.h"
#include "projects/session/session.h"
#include "projects/tuning/health.h"
#include "projects/tuning/proposal.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace plc;

namespace {

const char* const kLoop = R"(
PROGRAM Main
VAR
    SetPoint : REAL;
    Measured : REAL;
    pid : FB_PID;
    parameters : stPid := (xActValType := TRUE, rTargCyclTime := 1.0, rLowLim := -1000.0, rHighLim := 1000.0);
    first, second : REAL;
    scan : UDINT;
END_VAR
scan := scan + 1;
SetPoint := DINT_TO_REAL(UDINT_TO_DINT(scan / 60000) MOD 2) * 10.0;
pid(i_xEn := TRUE, i_rSp := SetPoint, i_rPv1 := Measured, i_rKp := 2.0, i_rTn := 3000.0, i_rTd := 60.0, i_stPid := parameters);
first := first + (pid.q_rPidOput - first) * 0.0005;
second := second + (first - second) * 0.001;
Measured := second;
END_PROGRAM
CONFIGURATION Plc
    RESOURCE Cpu ON Pc
        TASK Fast(INTERVAL := T#1ms, PRIORITY := 1);
        PROGRAM Main WITH Fast : Main;
    END_RESOURCE
END_CONFIGURATION
)";

class Stopwatch {
public:
    [[nodiscard]] double milliseconds() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - m_begin).count();
    }

private:
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
};

void print(const char* what, double milliseconds) { std::printf("%-52s %10.2f ms\n", what, milliseconds); }

/// A PI controller behind whose output a valve sticks, before a lag: it oscillates.
tuning::LoopSeries stickingLoop(int samples) {
    constexpr double kCycle = 0.1, kLag = 1.5, kStick = 1.5;
    tuning::LoopSeries out;
    double integral = 0, valve = 0, measured = 0;
    for (int i = 0; i < samples; ++i) {
        const double error = 10 - measured;
        integral += 0.3 * error * kCycle / 4;
        const double wanted = 0.3 * error + integral;
        if (std::abs(wanted - valve) >= kStick) valve = wanted;
        out.time.push_back(i * kCycle);
        out.input.push_back(wanted);
        out.output.push_back(measured);
        out.setPoint.push_back(10);
        measured += (1.5 * valve - measured) * kCycle / kLag;
    }
    return out;
}

} // namespace

int main(int argc, char** argv) {
    const uint64_t scans = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 3'600'000;
    driver::BuildInput input;
    input.files = {{"main.st", kLoop}};
    input.libraries = {"toolbox"};
    driver::Built built = driver::build(input);
    if (!built.program) return 1;
    (void)driver::optimise(built);
    session::Settings settings;
    settings.historyBudget = size_t(2) << 30;
    session::Session session(built, settings);
    session.runHere([&](const controller::Controller& c) { return c.nextScan() >= scans; });
    const auto loop = loops::findLoop(*built.program, "Main.pid");
    if (!loop) return 1;
    std::printf("%llu scans recorded, %zu MB\n", static_cast<unsigned long long>(session.history().statistics().scans),
                session.history().statistics().bytes >> 20);

    const Stopwatch all;
    const Stopwatch reading;
    const auto recorded = loops::seriesOf(session.history(), loops::signalsOf(*loop));
    if (!recorded) return 1;
    print("read the three signals from the recording", reading.milliseconds());
    const Stopwatch finding;
    const auto steps = tuning::findSteps(recorded->series);
    print("find the steps", finding.milliseconds());
    const Stopwatch modelling;
    const auto study = tuning::study(recorded->series);
    if (!study) return 1;
    print("find and model", modelling.milliseconds());
    print("all together (goal: 2000 ms)", all.milliseconds());
    std::printf("%zu steps, %s\n", steps.size(), formula(study->models.front().model).c_str());

    constexpr int kMoves = 50;
    const Stopwatch moving;
    for (int i = 0; i < kMoves; ++i) {
        const tuning::Wish wish{tuning::ControllerKind::Pi, i / static_cast<double>(kMoves), 0.5, 0.0005};
        const auto gains = tuning::tune(study->models.front().model, tuning::Rule::Optimum, wish);
        if (gains) (void)tuning::assess(study->models.front().model, *gains, {0.001, 0, 0});
    }
    print("a move of a slider (goal: a frame, 16 ms)", moving.milliseconds() / kMoves);

    const tuning::LoopSeries sticking = stickingLoop(24'000);
    const Stopwatch diagnosing;
    constexpr int kDiagnoses = 10;
    bool isFound = true;
    for (int i = 0; i < kDiagnoses; ++i) isFound = isFound && tuning::healthOf(sticking, {}).oscillation.has_value();
    if (!isFound) return 1;
    print("the diagnosis of an oscillating loop", diagnosing.milliseconds() / kDiagnoses);
    return 0;
}
