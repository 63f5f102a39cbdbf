#include "app/cli/run/commands.h"

#include "app/cli/kit/errors.h"
#include "app/cli/kit/interrupt.h"
#include "app/cli/run/inside_output.h"
#include "app/cli/run/run_output.h"
#include "projects/session/versions.h"
#include "runtime/compiler/driver/driver.h"
#include "runtime/history/history.h"
#include "runtime/inside/words.h"

#include <iostream>

namespace plc::cli {

namespace {

/// The versions of the program that the recording was made with, built again. An expression means something else in
/// each.
class Versions {
public:
    std::shared_ptr<const image::CompiledProgram> build(const history::History::Sources& sources) {
        m_all.push_back(driver::build(session::recordedInput(sources)));
        if (!m_all.back().program)
            m_failure = m_all.back().failure.isEmpty() ? errors::RecordedProgramHasErrors() : m_all.back().failure;
        return m_all.back().program;
    }
    [[nodiscard]] const driver::Built& newest() const { return m_all.back(); }
    [[nodiscard]] const Message& failure() const { return m_failure; }
    [[nodiscard]] Result<expression::Expression> compile(const image::CompiledProgram& program,
                                                         const std::string& text) const {
        for (const driver::Built& built : m_all)
            if (built.program && built.program->version == program.version)
                return driver::compileExpression(built.checked, text);
        return Error{errors::VersionNotRecorded(), text};
    }
    [[nodiscard]] history::Recompile recompile(const std::string& text) const {
        return [this, text](const image::CompiledProgram& program) {
            auto expression = compile(program, text);
            return expression ? *expression : expression::Expression();
        };
    }

private:
    std::vector<driver::Built> m_all;
    Message m_failure;
};

/// The watches as the version meant them that made the scan; those it did not know have no value.
class WatchesAt {
public:
    WatchesAt(const Versions& versions, std::vector<Watch> watches)
        : m_versions(versions), m_watches(std::move(watches)) {}
    const std::vector<Watch>& of(const std::shared_ptr<const image::CompiledProgram>& program) {
        if (program && program != m_program) {
            m_program = program;
            for (Watch& watch : m_watches) watch.expression = m_versions.recompile(watch.text)(*program);
        }
        return m_watches;
    }

private:
    const Versions& m_versions;
    std::vector<Watch> m_watches;
    std::shared_ptr<const image::CompiledProgram> m_program;
};

/// --inside: everything that one scan computed.
int lookInside(const Arguments& arguments, const history::History& history, const std::string& scan) {
    const auto position = positionOf(history, scan);
    if (!position) return wrongUse(position.error());
    Progress work;
    const InterruptCancels ctrlC(work);
    inside::Insight insight(history);
    insight.setCancel([&] { return work.isCancelled(); });
    const auto look = insight.look(*position);
    if (work.isCancelled()) return interruptedAnswer();
    if (!look) return wrongUse(look.error());
    std::cout << (arguments.wantsJson() ? insideJson(**look) + "\n" : insideText(**look));
    return (*look)->isExact() ? kGood : kProgramWrong;
}

/// --writers: every change of a value and who made it.
int listWriters(const Arguments& arguments, const history::History& history, const std::string& text) {
    constexpr size_t kMost = 100'000;
    Progress work;
    const InterruptCancels ctrlC(work);
    inside::Insight insight(history);
    insight.setCancel([&] { return work.isCancelled(); });
    inside::Reasoner reasoner(insight);
    const history::Statistics all = history.statistics();
    const auto writers = reasoner.writers({text, {}}, all.first, all.end, kMost);
    if (work.isCancelled()) return interruptedAnswer();
    if (!writers) return wrongUse({errors::WritersFailed(writers.error().message), text});
    std::string list;
    for (const inside::Writer& writer : *writers)
        list += arguments.wantsJson() ? (list.empty() ? "" : ",") + toJson(writer) : inside::toText(writer);
    if (arguments.wantsJson())
        std::cout << "{\"expression\":" << jsonString(text) << ",\"writers\":[" << list << "]}\n";
    else
        std::cout << (list.empty() ? text + " does not change in this recording\n" : list);
    return kGood;
}

int replay(const Arguments& arguments) {
    if (arguments.paths().size() != 1) return wrongUse({errors::ReplayNeedsRecording(), ""});
    Versions versions;
    const auto loaded = history::History::load(arguments.paths()[0],
                                               [&versions](const auto& sources) { return versions.build(sources); });
    if (!loaded)
        return wrongUse(versions.failure().isEmpty()
                            ? loaded.error()
                            : Error{errors::RecordingNotOpened(versions.failure()), arguments.paths()[0]});
    const history::History& history = **loaded;
    const history::Statistics statistics = history.statistics();
    if (statistics.end == statistics.first) return wrongUse({errors::RecordingEmpty(), arguments.paths()[0]});
    if (const auto scan = arguments.value("--inside")) return lookInside(arguments, history, *scan);
    if (const auto text = arguments.value("--writers")) return listWriters(arguments, history, *text);
    history::Position at = statistics.end - 1;
    if (const auto text = arguments.value("--at")) {
        const auto time = parseDuration(*text);
        if (!time) return wrongUse(time.error());
        const auto found = history.positionAt(*time);
        if (!found) return wrongUse({errors::NoScanBefore(*text), arguments.paths()[0]});
        at = *found;
    }
    std::vector<Watch> watches;
    for (const std::string& text : arguments.values("--watch")) {
        auto expression = driver::compileExpression(versions.newest().checked, text);
        if (!expression) return wrongUse({errors::Option(Verbatim("--watch"), expression.error().message), text});
        watches.push_back({text, *expression});
    }
    if (const auto text = arguments.value("--find")) {
        const auto expression = driver::compileExpression(versions.newest().checked, *text);
        if (!expression) return wrongUse({errors::Option(Verbatim("--find"), expression.error().message), *text});
        if (expression->types().storageKind(expression->type()) != types::TypeKind::Bool)
            return wrongUse({errors::FindNeedsCondition(), *text});
        const auto found =
            history.find(*expression, versions.recompile(*text), arguments.has("--at") ? at : statistics.first,
                         history::History::Direction::Forward);
        if (!found) {
            std::cout << *text << " does not become true\n";
            return kProgramWrong;
        }
        at = *found;
    }
    if (watches.empty()) watches = allVariables(versions.newest());
    WatchesAt seen(versions, watches);
    std::shared_ptr<const image::CompiledProgram> program;
    if (const auto file = arguments.value("--csv")) {
        const std::vector<Watch>& rows = seen.of(nullptr);
        CsvWriter csv(rows);
        if (auto opened = csv.open(*file); !opened) return wrongUse(opened.error());
        for (history::Position position = statistics.first; position < statistics.end; ++position)
            if (const auto stamp = history.stamp(position)) {
                const std::vector<std::byte> image = history.seek(position, &program);
                (void)seen.of(program);
                csv.row(image, stamp->scan, stamp->time);
            }
        if (auto closed = csv.close(); !closed) return wrongUse(closed.error());
    }
    const auto stamp = history.stamp(at);
    const std::vector<std::byte> image = history.seek(at, &program);
    if (image.empty() || !stamp) return wrongUse({errors::ScanNotRecorded(), arguments.paths()[0]});
    watches = seen.of(program);
    if (arguments.wantsJson()) {
        std::cout << "{\"scans\":" << statistics.scans << ",\"scan\":" << stamp->scan
                  << ",\"time_s\":" << secondsText(stamp->time) << ",\"values\":{";
        for (size_t i = 0; i < watches.size(); ++i) {
            const expression::Outcome outcome = watches[i].expression.evaluate(image);
            std::cout << (i ? "," : "") << jsonString(watches[i].text) << ":"
                      << (outcome.hasValue() ? types::toJson(watches[i].expression.types(), outcome.value) : "null");
        }
        std::cout << "}}\n";
        return kGood;
    }
    std::cout << "scan " << stamp->scan << " at " << types::durationText(stamp->time.count()) << " ("
              << statistics.scans << " scans recorded)\n";
    size_t width = 0;
    for (const Watch& watch : watches) width = std::max(width, watch.text.size());
    for (const Watch& watch : watches) {
        const expression::Outcome outcome = watch.expression.evaluate(image);
        std::string name = watch.text;
        name.resize(width + 2, ' ');
        std::cout << name
                  << (outcome.hasValue()           ? types::toText(watch.expression.types(), outcome.value)
                      : watch.expression.isValid() ? "(" + outcome.reason.english() + ")"
                                                   : "(did not exist at that scan)")
                  << "\n";
    }
    return kGood;
}

} // namespace

Command replayCommand() {
    return {{"replay",
             "FILE [OPTIONS]",
             "Inspects a recording made by run --record.",
             {{"--at", "1.5s", "the last scan at or before that PLC time (default: the last)"},
              {"--find", "EXPR", "the first scan (from --at on) in which the expression becomes true"},
              {"--watch", "EXPR", "a value to show (repeatable; default: all variables)"},
              {"--csv", "FILE", "write every recorded scan"},
              {"--inside", "1.5s|150", "every statement of that scan with its values, run again as recorded"},
              {"--writers", "EXPR", "every change of a value and who made it"},
              {"--format", "text|json", "text (default) or one JSON object"}},
             "stepwise replay motor.rec --at 1.5s --watch IO.K1"},
            replay};
}

} // namespace plc::cli
