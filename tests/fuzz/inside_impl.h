// What is said of recorded scans of small programs: they come out as recorded, a scan that is walked through reads at
// each moment what the moment has there, walked back it begins where it began, and every question has an answer.
// Included once per program; a broken promise aborts.
#pragma once
#include "tests/fuzz/entries_impl.h"

#include "projects/session/session.h"
#include "runtime/inside/coverage.h"
#include "runtime/inside/place_values.h"
#include "runtime/inside/scan_text.h"
#include "runtime/inside/slow_scan.h"
#include "runtime/inside/why.h"
#include "runtime/inside/words.h"

namespace plc::fuzz {

/// Paths of variables with an elementary value, at most `most` of them.
inline std::vector<std::string> somePaths(const image::Layout& layout, size_t most) {
    std::vector<std::string> out;
    for (const image::Root& root : layout.roots) {
        if (root.constant || root.isHidden) continue;
        layout.forEachLeaf(image::Layout::pathOf(root), {root.type, root.offset, root.bit},
                           [&](const std::string& path, const image::Place&) {
                               out.push_back(path);
                               return out.size() < most;
                           });
        if (out.size() >= most) break;
    }
    return out;
}

/// Twelve scans; somebody writes and forces what variables were before, as an operator would.
inline void operatedScans(controller::Controller& controller, std::string_view bytes) {
    const std::vector<std::string> paths = somePaths(controller.program().layout, 64);
    const auto valueOf = [&](const std::string& path) {
        const image::Layout& layout = controller.program().layout;
        const auto at = layout.find(path);
        return at ? types::readValue(*layout.types, at->type, controller.image().subspan(at->offset), at->bit)
                  : types::Value();
    };
    const uint32_t chosen = hashOf(bytes);
    std::string path;
    types::Value before;
    for (uint32_t scan = 0; scan < 12 && controller.state() == controller::State::Running; ++scan) {
        if (scan % 4 == 1 && !paths.empty()) {
            path = paths[chosen / (scan + 1) % paths.size()];
            before = valueOf(path);
        }
        if (scan == 3 && !path.empty()) (void)controller.write(path, before);
        if (scan == 7 && !path.empty()) (void)controller.force(path, before);
        controller.scan();
    }
}

/// What the statement that runs next reads first is what the moment has there.
inline void readsWhatIsThere(const inside::SlowScan& scan) {
    const std::span<const inside::Event> events = scan.look().events();
    const std::span<const std::byte> now = scan.image();
    for (size_t i = scan.event() + 1; i < events.size(); ++i) {
        const inside::Event& event = events[i];
        if (event.kind == image::WatchKind::Write || event.kind == image::WatchKind::Statement) return;
        if (event.kind != image::WatchKind::Read || size_t(event.offset) + event.size > scan.look().image().size())
            continue; // of a frame
        uint64_t there = 0;
        std::memcpy(&there, now.data() + event.offset, std::min<size_t>(sizeof there, event.size));
        promise(event.bit < 0 ? there == event.bits : ((there ^ event.bits) >> event.bit & 1) == 0);
    }
}

inline void walk(const std::shared_ptr<const inside::Look>& look) {
    constexpr size_t kMostStops = 300;
    inside::SlowScan scan(look);
    std::vector<std::vector<std::byte>> images;
    const auto now = [&] { return std::vector<std::byte>(scan.image().begin(), scan.image().end()); };
    while (!scan.isAtEnd() && images.size() < kMostStops) {
        images.push_back(now());
        readsWhatIsThere(scan);
        const std::vector<inside::SlowScan::Frame> frames = scan.stackTrace();
        promise(!frames.empty());
        if (scan.at() % 16 == 0)
            for (const inside::SlowScan::Frame& frame : frames) (void)scan.scopes(frame.id);
        promise(scan.step(debug::Step::In));
    }
    while (!images.empty()) {
        promise(scan.stepBack(debug::Step::In));
        promise(now() == images.back());
        images.pop_back();
    }
    promise(!scan.stepBack(debug::Step::In));
    scan.goTo(scan.stops());
    while (scan.stepBack(debug::Step::Out)) {
    }
    while (scan.step(debug::Step::Over)) {
    }
}

inline void ask(inside::Insight& insight, const image::CompiledProgram& program, inside::Position at,
                std::string_view bytes) {
    const std::vector<std::string> paths = somePaths(program.layout, 64);
    if (paths.empty()) return;
    inside::Reasoner reasoner(insight);
    for (const size_t chosen : {hashOf(bytes) % paths.size(), hashOf(bytes) / 64 % paths.size()}) {
        const inside::Question question{paths[chosen], {}};
        if (const auto answer = reasoner.why(question, at)) (void)inside::toText(*answer);
        if (const auto answer = reasoner.whyNot(question, at)) (void)inside::toText(*answer);
        if (const auto writers = reasoner.writersBackFrom(question, at, 8))
            for (const inside::Writer& writer : *writers) (void)inside::toText(writer);
    }
}

inline void showText(const std::shared_ptr<const inside::Look>& look, size_t length) {
    inside::TextPart part;
    part.file = FileId(size_t(0));
    part.end = static_cast<uint32_t>(length);
    (void)inside::PlaceValues(look, part.file, {});
    (void)inside::textOf(*look, part);
}

inline void reportCoverage(const image::CompiledProgram& program,
                           const std::vector<inside::FunctionCoverage>& functions) {
    for (const inside::FunctionCoverage& function : functions) {
        promise(function.statementsRun() <= function.statements.size());
        promise(function.branchesTaken() <= function.branches.size());
        promise(function.conditionsMet() <= function.conditionCount());
    }
    (void)inside::coberturaXml(program, functions);
    (void)inside::coverageHtml(program, functions);
}

/// Meant: it ran.
Reach lookInside(std::string_view bytes) {
    driver::Built built = driver::build(inputOf(bytes));
    if (!built.program) return Reach::Short;
    session::Settings settings;
    settings.controller = boundedSettings();
    settings.historyBudget = size_t(8) << 20;
    session::Session session(std::move(built), settings);
    session.controller().start();
    operatedScans(session.controller(), bytes);
    const history::Statistics recorded = session.history().statistics();
    // A run again has the budget of a studio, and does not end where a small one was used up.
    const std::optional<controller::Fault>& fault = session.controller().fault();
    const bool endedByBudget = fault && fault->code == image::FaultCode::Watchdog;
    const inside::Position end = recorded.end - (endedByBudget ? 1 : 0);
    if (end <= recorded.first) return Reach::Short;

    inside::Insight insight(session.history());
    inside::Coverage coverage(session.program());
    for (inside::Position at = recorded.first; at < end; ++at) {
        const auto look = insight.look(at);
        promise(look && (*look)->isExact());
        promise(bool(coverage.add(insight, at)));
        if (at != recorded.first && at + 1 != end) continue;
        walk(*look);
        showText(*look, bytes.size());
    }
    ask(insight, *session.program(), end - 1, bytes);
    reportCoverage(*session.program(), coverage.functions());
    return Reach::Meant;
}

} // namespace plc::fuzz
