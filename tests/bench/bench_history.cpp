// What recording costs a scan, how fast virtual time runs, and how fast an hour of 1 ms scans answers. Prints a table.
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"

#include <chrono>
#include <cstdio>
#include <random>

namespace plc::bench {
namespace {

using namespace std::chrono_literals;

double seconds(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

driver::Built build(const std::string& text) {
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    driver::BuildInput input;
    input.files.push_back({"main.st", text});
    driver::Built built = driver::build(input);
    if (!built.program) {
        for (const auto& d : built.checked.analysis->diagnostics)
            std::fprintf(stderr, "%s\n", d.message.english().c_str());
        std::exit(1);
    }
    if (const Result<void> done = driver::optimise(built); !done)
        std::fprintf(stderr, "%s\n", done.error().message.english().c_str());
    return built;
}

const char* const kSmall = R"(
PROGRAM Main VAR s1, s2, k1 : BOOL; n : INT; END_VAR
  n := n + 1;
  IF s1 OR n = 100 THEN k1 := TRUE; END_IF
  IF s2 OR n > 200 THEN k1 := FALSE; n := 0; END_IF
END_PROGRAM)";

/// A control loop with its plant, timers and counters: about the work of a small real machine.
const char* const kLoop = R"(
FUNCTION_BLOCK Pid VAR_INPUT sp, pv, kp, ti, dt : REAL; END_VAR VAR_OUTPUT y : REAL; END_VAR VAR i, e, last : REAL; END_VAR
  e := sp - pv; i := LIMIT(-100.0, i + e * dt / ti, 100.0); y := LIMIT(0.0, kp * (e + i) + (e - last) * 0.1, 100.0); last := e;
END_FUNCTION_BLOCK
PROGRAM Main
VAR pid : ARRAY[1..8] OF Pid; pv : ARRAY[1..8] OF REAL; t : ARRAY[1..8] OF TON; c : CTU; i : INT; mean : LREAL; phase, wave : REAL; END_VAR
  mean := 0.0; phase := phase + 0.001; wave := 20.0 * SIN(phase);
  FOR i := 1 TO 8 DO
    pid[i](sp := 50.0 + wave + i, pv := pv[i], kp := 2.0, ti := 5.0, dt := 0.01);
    pv[i] := pv[i] + (pid[i].y - pv[i]) * 0.01;
    t[i](IN := pv[i] > 40.0, PT := T#2s);
    mean := mean + pv[i];
  END_FOR
  c(CU := t[3].Q, PV := 10, RESET := c.Q);
END_PROGRAM)";

/// A large image of which little changes.
const char* const kLarge = R"(
PROGRAM Main VAR table : ARRAY[0..262143] OF DINT; i : DINT; sum : DINT; END_VAR
  i := (i + 4099) MOD 262144; table[i] := table[i] + 1; sum := sum + table[i];
END_PROGRAM)";

struct Cost {
    double nsPerScan = 0;
    double bytesPerScan = 0;
};

Cost scanCost(const driver::Built& built, bool records, uint64_t scans) {
    double best = 1e300;
    Cost cost;
    for (int round = 0; round < 3; ++round) {
        session::Settings settings;
        settings.record = records;
        session::Session session(built, settings);
        session.runHere([](const controller::Controller& c) { return c.nextScan() == 1000; });
        const double time = seconds(
            [&] { session.runHere([&](const controller::Controller& c) { return c.nextScan() == 1000 + scans; }); });
        best = std::min(best, time);
        if (records)
            cost.bytesPerScan = static_cast<double>(session.history().statistics().bytes) /
                                static_cast<double>(session.history().statistics().scans);
    }
    cost.nsPerScan = best / static_cast<double>(scans) * 1e9;
    return cost;
}

void recordingTable() {
    std::printf("%-28s %12s %12s %12s %10s %12s %14s\n", "program", "image bytes", "ns/scan off", "ns/scan on",
                "cost ns", "bytes/scan", "scans/s on");
    const std::pair<const char*, std::pair<const char*, uint64_t>> programs[] = {
        {"small", {kSmall, 2'000'000}},
        {"8 control loops", {kLoop, 500'000}},
        {"1 MB image, 3 words change", {kLarge, 20'000}}};
    for (const auto& [name, program] : programs) {
        const driver::Built built = build(program.first);
        const Cost off = scanCost(built, false, program.second);
        const Cost on = scanCost(built, true, program.second);
        std::printf("%-28s %12u %12.0f %12.0f %10.0f %12.1f %14.0f\n", name, built.program->layout.dataEnd,
                    off.nsPerScan, on.nsPerScan, on.nsPerScan - off.nsPerScan, on.bytesPerScan, 1e9 / on.nsPerScan);
    }
}

void hourTable() {
    std::string text = kLoop;
    text += "\nCONFIGURATION C RESOURCE R ON PLC TASK T (INTERVAL := T#1ms, PRIORITY := 1); PROGRAM Main WITH T : "
            "Main; END_RESOURCE END_CONFIGURATION";
    session::Settings settings;
    settings.historyBudget = size_t(4) << 30;
    session::Session session(build(text), settings);
    constexpr uint64_t kHour = 3'600'000;
    const double recorded =
        seconds([&] { session.runHere([&](const controller::Controller& c) { return c.nextScan() == kHour; }); });
    const history::Statistics statistics = session.history().statistics();
    std::printf("\nan hour of 1 ms scans of 8 control loops\n");
    std::printf("  %-44s %10.2f s\n", "run and recorded in", recorded);
    std::printf("  %-44s %10.1f MB (%.1f bytes a scan, %zu segments)\n", "memory",
                static_cast<double>(statistics.bytes) / 1e6,
                static_cast<double>(statistics.bytes) / static_cast<double>(kHour), statistics.segments);
    std::mt19937 dice(1);
    size_t sum = 0;
    const double seek = seconds([&] {
        for (int i = 0; i < 500; ++i) sum += session.history().seek(dice() % kHour).size();
    });
    std::printf("  %-44s %10.3f ms\n", "seek to a random scan", seek / 500 * 1e3);
    const auto report = [&](const char* what, const std::string& expression,
                            const std::function<void(const expression::Expression&)>& work) {
        const Result<expression::Expression> compiled = session.expression(expression);
        if (!compiled) std::exit(1);
        std::printf("  %-44s %10.1f ms\n", what, seconds([&] { work(*compiled); }) * 1e3);
    };
    using Direction = history::History::Direction;
    report("series of a variable, 2,500 buckets", "Main.mean",
           [&](const auto& e) { sum += session.history().series(e, {}, 0, kHour, 2500).size(); });
    report("series of an expression, 2,500 buckets", "Main.pv[1] - Main.pv[2] * 2.0",
           [&](const auto& e) { sum += session.history().series(e, {}, 0, kHour, 2500).size(); });
    report("find over the whole hour (never true)", "Main.mean > 1.0E9",
           [&](const auto& e) { sum += session.history().find(e, {}, 0, Direction::Forward).has_value(); });
    report("find backwards over the whole hour", "Main.mean > 1.0E9",
           [&](const auto& e) { sum += session.history().find(e, {}, kHour, Direction::Backward).has_value(); });
    report("find a change that took place once", "Main.t[3].Q", [&](const auto& e) {
        sum += session.history().findChange(e, {}, kHour - 1, Direction::Backward).has_value();
    });
    if (sum == 0) std::printf("\n");
}

} // namespace
} // namespace plc::bench

int main() {
    plc::bench::recordingTable();
    plc::bench::hourTable();
    return 0;
}
