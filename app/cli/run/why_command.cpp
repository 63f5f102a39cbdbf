#include "app/cli/run/commands.h"

#include "app/cli/kit/errors.h"
#include "app/cli/kit/interrupt.h"
#include "app/cli/run/inside_output.h"
#include "app/cli/run/recorded_run.h"
#include "app/cli/run/run_output.h"
#include "projects/storage/project_file.h"
#include "runtime/inside/words.h"

#include <filesystem>
#include <fstream>
#include <iostream>

namespace plc::cli {

namespace {

int answer(const Arguments& arguments, const history::History& history, const std::string& question) {
    const history::Statistics statistics = history.statistics();
    if (statistics.scans == 0) return wrongUse({errors::NoScanToAsk(), question});
    history::Position at = statistics.end - 1;
    if (const auto text = arguments.value("--at")) {
        const auto position = positionOf(history, *text);
        if (!position) return wrongUse(position.error());
        at = *position;
    }
    Progress work;
    const InterruptCancels ctrlC(work);
    inside::Insight insight(history);
    insight.setCancel([&] { return work.isCancelled(); });
    inside::Reasoner reasoner(insight);
    if (arguments.has("--not")) {
        const auto found = reasoner.whyNot({question, {}}, at);
        if (work.isCancelled()) return interruptedAnswer();
        if (!found) return wrongUse(found.error());
        std::cout << (arguments.wantsJson() ? toJson(*found) + "\n" : inside::toText(*found));
        return found->ways.empty() ? kProgramWrong : kGood;
    }
    const auto found = reasoner.why({question, {}}, at);
    if (work.isCancelled()) return interruptedAnswer();
    if (!found) return wrongUse(found.error());
    std::cout << (arguments.wantsJson() ? toJson(*found) + "\n" : inside::toText(*found));
    return kGood;
}

/// Runs the project, up to the scan that is asked about.
int answerByRunning(const Arguments& arguments, const std::string& path, const std::string& question) {
    RecordedRun run;
    run.path = path;
    run.length = std::chrono::seconds(10);
    if (const auto text = arguments.value("--at"); text && !arguments.has("--for"))
        if (const auto time = parseDuration(*text)) run.length = *time + std::chrono::nanoseconds(1);
    run.ask = [&](const history::History& history) { return answer(arguments, history, question); };
    return askRecordedRun(arguments, run);
}

int why(const Arguments& arguments) {
    if (arguments.paths().size() != 2) return wrongUse({errors::WhyNeedsTwo(), ""});
    const std::string& path = arguments.paths()[0];
    const std::string& question = arguments.paths()[1];
    if (!isRecording(path)) return answerByRunning(arguments, path, question);
    const auto loaded = openRecording(path);
    if (!loaded) return wrongUse(loaded.error());
    return answer(arguments, **loaded, question);
}

} // namespace

Command whyCommand() {
    return {{"why",
             "PROJECT|FILE.st|RECORDING EXPR [OPTIONS]",
             "Explains a value: what changed it, what had to hold, or what would change it.",
             {{"--at", "1.5s|150",
               "the last scan at or before that PLC time, or the scan of that number (default: the last)"},
              {"--not", "", "what would change the result of the condition in that scan; each way is verified"},
              {"--for", "10s", "PLC time to run a project (default 10s, or up to --at)"},
              {"--set", "PATH=VALUE[@TIME]", "write before the first scan at or after TIME (repeatable)"},
              {"--force", "PATH=VALUE[@TIME]", "force likewise; VALUE RELEASE ends it (repeatable)"},
              {"--start", "DT#2026-01-01-06:00:00", "calendar at the first scan"},
              {"--library", "NAME", "a library the files use, in addition to the standard library (repeatable)"},
              {"--format", "text|json", "text (default) or one JSON object"}},
             "stepwise why projects/examples/motor IO.K1 --set 'Plant.StartButton=TRUE@1s' --at 1.5s"},
            why};
}

} // namespace plc::cli
