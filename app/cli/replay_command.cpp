#include "app/cli/command.h"
#include "app/cli/run_output.h"

#include "runtime/compiler/driver/driver.h"
#include "runtime/history/history.h"

#include <iostream>

namespace plc::cli {

namespace {

/// What the recording was made with, built again.
struct Rebuilt {
    driver::Built built;
    std::shared_ptr<const image::CompiledProgram> operator()(const std::vector<std::pair<std::string, std::string>>& sources, const std::vector<std::string>& libraries) {
        driver::BuildInput input;
        for (const auto& [path, text] : sources) input.files.push_back({path, text});
        input.libraries = libraries;
        built = driver::build(input);
        return built.program;
    }
};

int replay(const Arguments& arguments) {
    if (arguments.paths().size() != 1) return wrongUse({"replay needs one recording (made by stepwise run --record)", ""});
    auto rebuilt = std::make_shared<Rebuilt>();
    const auto loaded = history::History::load(arguments.paths()[0], [rebuilt](const auto& sources, const auto& libraries) { return (*rebuilt)(sources, libraries); });
    if (!loaded) return wrongUse(loaded.error());
    const history::History& history = **loaded;
    const history::Statistics statistics = history.statistics();
    if (statistics.end == statistics.first) return wrongUse({"The recording holds no scan", arguments.paths()[0]});
    history::Position at = statistics.end - 1;
    if (const auto text = arguments.value("--at")) {
        const auto time = parseDuration(*text);
        if (!time) return wrongUse(time.error());
        const auto found = history.positionAt(*time);
        if (!found) return wrongUse({"The recording has no scan at or before " + *text, arguments.paths()[0]});
        at = *found;
    }
    std::vector<Watch> watches;
    for (const std::string& text : arguments.values("--watch")) {
        auto expression = driver::compileExpression(rebuilt->built.checked, text);
        if (!expression) return wrongUse({"--watch: " + expression.error().message, text});
        watches.push_back({text, *expression});
    }
    if (const auto text = arguments.value("--find")) {
        const auto expression = driver::compileExpression(rebuilt->built.checked, *text);
        if (!expression) return wrongUse({"--find: " + expression.error().message, *text});
        const auto found = history.find(*expression, {}, arguments.has("--at") ? at : statistics.first, history::History::Direction::Forward);
        if (!found) {
            std::cout << *text << " does not become true\n";
            return kProgramWrong;
        }
        at = *found;
    }
    if (watches.empty()) watches = allVariables(rebuilt->built);
    if (const auto file = arguments.value("--csv")) {
        CsvWriter csv(watches);
        if (auto opened = csv.open(*file); !opened) return wrongUse(opened.error());
        for (history::Position position = statistics.first; position < statistics.end; ++position)
            if (const auto stamp = history.stamp(position)) csv.row(history.seek(position), stamp->scan, stamp->time);
        if (auto closed = csv.close(); !closed) return wrongUse(closed.error());
    }
    const auto stamp = history.stamp(at);
    const std::vector<std::byte> image = history.seek(at);
    if (image.empty() || !stamp) return wrongUse({"This scan is not in the recording any more", arguments.paths()[0]});
    if (arguments.wantsJson()) {
        std::cout << "{\"scans\":" << statistics.scans << ",\"scan\":" << stamp->scan << ",\"time_s\":" << secondsText(stamp->time) << ",\"values\":{";
        for (size_t i = 0; i < watches.size(); ++i) {
            const expression::Outcome outcome = watches[i].expression.evaluate(image);
            std::cout << (i ? "," : "") << jsonString(watches[i].text) << ":" << (outcome.hasValue() ? types::toJson(watches[i].expression.types(), outcome.value) : "null");
        }
        std::cout << "}}\n";
        return kGood;
    }
    std::cout << "scan " << stamp->scan << " at " << types::durationText(stamp->time.count()) << " (" << statistics.scans << " scans recorded)\n";
    size_t width = 0;
    for (const Watch& watch : watches) width = std::max(width, watch.text.size());
    for (const Watch& watch : watches) {
        const expression::Outcome outcome = watch.expression.evaluate(image);
        std::string name = watch.text;
        name.resize(width + 2, ' ');
        std::cout << name << (outcome.hasValue() ? types::toText(watch.expression.types(), outcome.value) : "(" + outcome.reason + ")") << "\n";
    }
    return kGood;
}

} // namespace

Command replayCommand() {
    return {{"replay", "FILE [OPTIONS]", "Looks into a recording made by run --record.",
             {{"--at", "1.5s", "the last scan at or before that PLC time (default: the last)"},
              {"--find", "EXPR", "the first scan (from --at on) in which the expression becomes true"},
              {"--watch", "EXPR", "a value to show (repeatable; default: all variables)"},
              {"--csv", "FILE", "write every recorded scan"},
              {"--format", "text|json", "text (default) or one JSON object"}},
             "stepwise replay motor.rec --at 1.5s --watch Main.K1"},
            replay};
}

} // namespace plc::cli
