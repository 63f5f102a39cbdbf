// What looking into a scan costs: the first look and the next, "who set this?" over an hour, "why?", and what the
// journal adds to a recording. Prints a table.
#include "projects/session/session.h"
#include "runtime/compiler/jit/jit.h"
#include "runtime/inside/scan_text.h"
#include "runtime/inside/why.h"
#include "tests/bench/program_generator.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace plc::bench {
namespace {

double milliseconds(const std::function<void()>& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

driver::Built build(const std::string& text) {
    jit::setRuntimeSymbols(controller::runtimeSymbols());
    driver::BuildInput input;
    input.files.push_back({"main.st", text});
    driver::Built built = driver::build(input);
    if (!built.program) std::exit(1);
    if (const Result<void> done = driver::optimise(built); !done) std::exit(1);
    return built;
}

void row(const char* what, double value, const char* unit) { std::printf("  %-58s %10.2f %s\n", what, value, unit); }

void lookTable() {
    const driver::Built built = build(generateProgram(10'000));
    session::Session session(built);
    session.runHere([](const controller::Controller& c) { return c.nextScan() == 200; });
    std::printf("a program of 10,000 lines, %zu functions\n", built.program->functions.size());
    inside::Insight insight(session.history());
    std::shared_ptr<const inside::Look> look;
    row("first look into a scan, everything watched", milliseconds([&] { look = *insight.look(100); }), "ms");
    row("the next scan", milliseconds([&] { look = *insight.look(101); }), "ms");
    row("reports of that scan", static_cast<double>(look->events().size()), "");
    row("as recorded", look->isExact() ? 1 : 0, "");
    inside::Insight fresh(session.history());
    inside::LookOptions one;
    one.functions = {static_cast<uint32_t>(built.program->tasks.at(0).programs.at(0).function)};
    row("first look, one program watched", milliseconds([&] { look = *fresh.look(100, one); }), "ms");
    row("the next scan", milliseconds([&] { look = *fresh.look(101, one); }), "ms");
}

/// What exact values beside 60 visible lines of a running program cost, ten times a second.
void liveTable() {
    const driver::Built built = build(generateProgram(10'000));
    session::Session session(built);
    session.runHere([](const controller::Controller& c) { return c.nextScan() == 200; });
    inside::Insight insight(session.history());
    const tree::Program& tree = *driver::treeOf(built.program);
    inside::TextPart part;
    part.file = FileId(size_t(0));
    const std::string_view text = built.program->sources[part.file].text();
    part.begin = static_cast<uint32_t>(text.size() / 2);
    part.end = part.begin;
    for (int line = 0; line < 60 && part.end < text.size(); ++line)
        part.end = static_cast<uint32_t>(std::min(text.size(), text.find('\n', part.end) + 1));
    inside::LookOptions options;
    options.functions = inside::functionsIn(tree, part.file, part.begin, part.end);
    size_t values = 0;
    const auto sample = [&](inside::Position at) {
        values = inside::textOf(**insight.look(at, options), part).values.size();
    };
    std::printf("\nlive exact values of 60 lines of 10,000\n");
    row("first sample", milliseconds([&] { sample(99); }), "ms");
    const double each = milliseconds([&] {
                            for (inside::Position at = 100; at < 200; ++at) sample(at);
                        }) /
                        100;
    row("values of a sample", static_cast<double>(values), "");
    row("a sample", each, "ms");
    row("ten samples a second, of a core", each * 10 / 1000 * 100, "%");
}

const char* const kPlant = R"(
VAR_GLOBAL start, stop : BOOL; k1 : BOOL; level : REAL; END_VAR
PROGRAM Main VAR run : TON; n : DINT; END_VAR
  n := n + 1;
  IF k1 THEN level := level + 0.01; ELSE level := level - 0.005; END_IF
  run(IN := level < 40.0, PT := T#2s);
  k1 := (run.Q OR k1) AND level < 80.0;
END_PROGRAM
CONFIGURATION C RESOURCE R ON PLC TASK T (INTERVAL := T#1ms, PRIORITY := 1); PROGRAM Main WITH T : Main; END_RESOURCE
END_CONFIGURATION)";

void hourTable() {
    session::Settings settings;
    settings.historyBudget = size_t(4) << 30;
    session::Session session(build(kPlant), settings);
    session.runHere([](const controller::Controller& c) { return c.nextScan() == 3'600'000; });
    inside::Insight insight(session.history());
    inside::Reasoner reasoner(insight);
    const inside::Position last = session.history().statistics().end - 1;
    std::printf("\nan hour of 1 ms scans\n");
    row("who set k1 last, first question", milliseconds([&] { (void)reasoner.lastWriter({"k1", {}}, last); }), "ms");
    row("who set k1 last, the next", milliseconds([&] { (void)reasoner.lastWriter({"k1", {}}, last - 5); }), "ms");
    size_t count = 0;
    row("every change of k1 with its writer", milliseconds([&] {
            count = reasoner.writers({"k1", {}}, 0, last + 1, 100'000)->size();
        }),
        "ms");
    row("changes", static_cast<double>(count), "");
    row("why k1", milliseconds([&] { (void)reasoner.why({"k1", {}}, last); }), "ms");
    row("why not k1", milliseconds([&] { (void)reasoner.whyNot({"k1", {}}, last); }), "ms");
}

void journalTable() {
    const driver::Built built = build(kPlant);
    const auto place = built.program->layout.find("start");
    std::printf("\nrecording with its journal, 1,000,000 scans\n");
    for (const int every : {0, 1000, 10}) {
        double best = 1e300, bytes = 0;
        for (int round = 0; round < 3; ++round) {
            session::Settings settings;
            settings.historyBudget = size_t(2) << 30;
            session::Session session(built, settings);
            controller::Controller& controller = session.controller();
            controller.start();
            types::Value value{place->type, int64_t(0)};
            const double time = milliseconds([&] {
                for (int i = 0; i < 1'000'000; ++i) {
                    if (every > 0 && i % every == 0) {
                        value.data = int64_t(i / every % 2);
                        (void)controller.write(*place, value);
                    }
                    controller.scan();
                }
            });
            best = std::min(best, time);
            bytes = static_cast<double>(session.history().statistics().bytes) / 1e6;
        }
        const std::string what =
            every == 0 ? "nothing acts from outside" : "a write every " + std::to_string(every) + " scans";
        row((what + ", ns a scan").c_str(), best, "ns");
        row((what + ", memory").c_str(), bytes, "MB");
    }
}

/// The same images appended to a history again, with and without somebody who writes: what the journal adds to each.
void journalShareTable() {
    session::Settings settings;
    settings.historyBudget = size_t(2) << 30;
    session::Session session(build(kPlant), settings);
    constexpr uint64_t kScans = 200'000, kImages = 1'000;
    session.runHere([](const controller::Controller& c) { return c.nextScan() == kImages; });
    std::vector<std::vector<std::byte>> images;
    for (uint64_t scan = 0; scan < kImages; ++scan) images.push_back(session.history().seek(scan));
    const image::Place place = *session.program()->layout.find("start");
    image::OutsideNote note{image::OutsideKind::Write, place.offset, 1};
    note.origin = "panel Main, button Start";
    const std::vector<image::OutsideNote> notes{note};
    image::ScanStart start;
    start.plcRuns = true;
    const auto nanosecondsFor = [&](uint64_t every) {
        double best = 1e300;
        for (int round = 0; round < 5; ++round) {
            history::History history(settings.historyBudget);
            history.beginProgram(session.program());
            best = std::min(best, milliseconds([&] {
                                for (uint64_t scan = 0; scan < kScans; ++scan) {
                                    if (every > 0 && scan % every == every - 1)
                                        history.outsideActed({images[scan % kImages], {}, start, notes});
                                    history.append(images[scan % kImages], scan,
                                                   history::Nanoseconds{static_cast<int64_t>(scan)} * 1'000'000);
                                }
                            }));
        }
        return best * 1e6 / static_cast<double>(kScans);
    };
    std::printf("\nthe same 200,000 images appended again, without the controller\n");
    const double without = nanosecondsFor(0);
    row("no journal at all, ns a scan", without, "ns");
    for (const uint64_t every : {1000, 100, 10}) {
        const double with = nanosecondsFor(every);
        row(("a journal every " + std::to_string(every) + " scans, ns a scan").c_str(), with, "ns");
        row("  more than without", (with / without - 1) * 100, "%");
    }
}

} // namespace
} // namespace plc::bench

int main() {
    plc::bench::lookTable();
    plc::bench::liveTable();
    plc::bench::hourTable();
    plc::bench::journalTable();
    plc::bench::journalShareTable();
}
