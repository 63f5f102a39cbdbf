#include "app/cli/tune/commands.h"

#include "app/cli/kit/errors.h"
#include "app/cli/kit/written_file.h"
#include "app/cli/run/inside_output.h"
#include "app/cli/run/recorded_run.h"
#include "app/cli/run/run_output.h"
#include "app/cli/tune/tune_output.h"
#include "editor/plot/page_pdf.h"
#include "projects/loops/trial.h"
#include "projects/session/session.h"
#include "projects/storage/project_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace plc::cli {

namespace {

using tuning::ControllerKind;

bool isTable(const std::string& path) {
    const std::string extension = std::filesystem::path(path).extension().string();
    return extension == ".csv" || extension == ".tsv" || extension == ".txt" || extension == ".trace";
}

/// What was asked for, checked before anything long runs.
struct Question {
    std::optional<std::string> loop;
    loops::Signals channels;
    tuning::Rule rule = tuning::Rule::Simc;
    std::optional<ControllerKind> kind;
    double briskness = 0.5, setPoint = 0.5;
    std::optional<double> cycle;
    std::vector<size_t> steps; // from 1
};

Result<double> shareOf(const Arguments& arguments, std::string_view option) {
    const auto text = arguments.value(option);
    if (!text) return 0.5;
    char* end = nullptr;
    const double value = std::strtod(text->c_str(), &end);
    if (end == text->c_str() || *end || !(value >= 0 && value <= 1))
        return Error{errors::ShareRange(Verbatim(option)), *text};
    return value;
}

Result<Question> questionOf(const Arguments& arguments) {
    Question out;
    out.loop = arguments.value("--loop");
    out.channels = {arguments.value("--input").value_or(""), arguments.value("--output").value_or(""),
                    arguments.value("--setpoint").value_or("")};
    if (out.channels.input.empty() != out.channels.output.empty()) return Error{errors::TuneNeedsBoth(), ""};
    if (!out.channels.input.empty() && out.channels.input == out.channels.output)
        return Error{errors::TuneSameSignal(Verbatim(out.channels.input)), ""};
    if (out.loop && !out.channels.input.empty()) return Error{errors::TuneLoopOrSignals(), ""};
    if (const auto text = arguments.value("--rule")) {
        const auto rule = tuning::parseRule(*text);
        if (!rule) return Error{errors::RuleIs(*text), ""};
        out.rule = *rule;
    }
    if (const auto text = arguments.value("--kind")) {
        if (*text == "p")
            out.kind = ControllerKind::P;
        else if (*text == "pi")
            out.kind = ControllerKind::Pi;
        else if (*text == "pid")
            out.kind = ControllerKind::Pid;
        else
            return Error{errors::KindIs(*text), ""};
    }
    for (const auto& [option, target] :
         {std::pair{"--brisk", &out.briskness}, std::pair{"--tracking", &out.setPoint}}) {
        const auto share = shareOf(arguments, option);
        if (!share) return share.error();
        *target = *share;
    }
    if (const auto text = arguments.value("--cycle")) {
        const auto time = parseDuration(*text);
        if (!time) return time.error();
        if (time->count() <= 0) return Error{errors::CycleAboveZero(), *text};
        out.cycle = std::chrono::duration<double>(*time).count();
    }
    for (const std::string& text : arguments.values("--step")) {
        const auto number = parseCount(text);
        if (!number) return number.error();
        out.steps.push_back(*number);
    }
    return out;
}

Result<void> studyInto(const Question& question, TuneReport& report) {
    auto study = tuning::study(report.series);
    if (study && !question.steps.empty()) {
        std::vector<size_t> chosen;
        for (const size_t number : question.steps) {
            if (number < 1 || number > study->steps.size())
                return Error{errors::NoStepOfNumber(number, study->steps.size()), ""};
            chosen.push_back(number - 1);
        }
        std::vector<tuning::FoundStep> steps = study->steps;
        study = tuning::study(report.series, std::move(steps), chosen);
    }
    if (!study) return study.error();
    report.study = std::move(*study);
    return {};
}

ControllerKind kindFor(const Question& question, const std::optional<loops::Loop>& loop) {
    if (!loop) return question.kind.value_or(ControllerKind::Pi);
    const auto kinds = loop->form->kinds();
    if (question.kind && std::find(kinds.begin(), kinds.end(), *question.kind) != kinds.end()) return *question.kind;
    return kinds.size() > 1 ? ControllerKind::Pi : ControllerKind::P;
}

/// As its ending says: .pdf, else HTML.
Result<void> writeReport(const TuneReport& report, const std::string& path) {
    if (std::filesystem::path(path).extension() != ".pdf") return writeFile(path, pageOf(report));
    needApplication();
    return plot::exportPage(pageOf(report), report.name, path);
}

/// Without a step there is no model, but how the loop is doing can be said.
int reportHealth(const TuneReport& report, const std::string& path) {
    if (auto written = writeReport(report, path); !written) return wrongUse(written.error());
    std::cout << healthText(report);
    return kGood;
}

tuning::Health healthOf(const TuneReport& report) {
    return tuning::healthOf(
        report.series, tuning::limitsOf(report.series, report.now ? std::optional(report.now->figures) : std::nullopt));
}

/// Models and settings from what is in the report already: channels, series, loop and its present settings.
int answer(const Arguments& arguments, const Question& question, TuneReport& report,
           const std::optional<loops::Settings>& settings) {
    const auto page = arguments.value("--report");
    if (auto studied = studyInto(question, report); !studied) {
        if (!page) return wrongUse(studied.error());
        report.study.steps = tuning::findSteps(report.series);
        report.whyNoModel = studied.error().message;
        report.health = healthOf(report);
        return reportHealth(report, *page);
    }
    report.cycle = question.cycle.value_or(settings && settings->cycle > 0 ? settings->cycle
                                                                           : tuning::usualInterval(report.series));
    report.kind = kindFor(question, report.loop);
    report.rule = question.rule;
    const tuning::ProcessModel& process = report.best().model;
    tuning::LoopConditions conditions{report.cycle, tuning::noiseOf(report.series.output), 0};
    const tuning::Wish wish{report.kind, question.briskness, question.setPoint, tuning::samplingDelay(report.cycle)};
    for (const tuning::Rule rule : tuning::allRules())
        if (const auto gains = tuning::tune(process, rule, wish))
            report.answers.push_back({rule, tuning::assess(process, *gains, conditions)});
    if (settings) report.now = tuning::assess(process, settings->gains, conditions);
    if (const RuleAnswer* chosen = report.answer(); chosen && report.loop)
        report.parameters = tuning::parametersOf(*report.loop->form, chosen->assessment.gains, report.cycle);
    for (const auto& [option, draw] : {std::pair{"--picture", &pictureOf}, std::pair{"--bode", &bodePictureOf}})
        if (const auto path = arguments.value(option))
            if (auto written = writeFile(*path, draw(report, arguments.has("--dark"))); !written)
                return wrongUse(written.error());
    if (page) {
        report.health = healthOf(report);
        if (auto written = writeReport(report, *page); !written) return wrongUse(written.error());
    }
    std::cout << (arguments.wantsJson() ? jsonOf(report) : textOf(report));
    return report.answer() ? kGood : kProgramWrong;
}

int tuneTable(const Arguments& arguments, const Question& question, const std::string& path) {
    if (question.channels.input.empty()) {
        const auto columns = tuning::csvColumns(path);
        if (!columns) return wrongUse(columns.error());
        return wrongUse({errors::TuneTableNeedsSignals(*columns), path});
    }
    std::vector<Message> notes;
    auto series =
        tuning::readCsv(path, {question.channels.input, question.channels.output, question.channels.setPoint}, &notes);
    if (!series) return wrongUse(series.error());
    for (const Message& note : notes) std::cerr << path << ": " << note.english() << "\n";
    TuneReport report;
    report.name = std::filesystem::path(path).filename().string();
    report.channels = question.channels;
    report.measuredName = question.channels.output;
    report.inputName = question.channels.input;
    report.series = std::move(*series);
    return answer(arguments, question, report, std::nullopt);
}

/// The loop that was named, or the only one there is.
Result<std::optional<loops::Loop>> loopFor(const Question& question, const image::CompiledProgram& program) {
    if (!question.channels.input.empty()) return std::optional<loops::Loop>();
    if (question.loop) {
        auto found = loops::findLoop(program, *question.loop);
        if (!found) return found.error();
        return std::optional(*found);
    }
    const auto all = loops::loopsOf(program);
    if (all.size() == 1) return std::optional(all.front());
    std::vector<std::string> names;
    for (const loops::Loop& loop : all) names.push_back(loop.name);
    return Error{names.empty() ? errors::TuneNeedsSignals() : errors::TuneNeedsLoop(names), ""};
}

int tuneHistory(const Arguments& arguments, const Question& question, const history::History& history) {
    const auto programs = history.programs();
    if (programs.empty()) return wrongUse({errors::RecordingEmpty(), arguments.paths()[0]});
    const auto loop = loopFor(question, *programs.back());
    if (!loop) return wrongUse(loop.error());
    TuneReport report;
    report.loop = *loop;
    report.name = report.loop ? report.loop->name : arguments.paths()[0];
    report.channels = report.loop ? loops::signalsOf(*report.loop) : question.channels;
    report.measuredName = report.channels.output;
    report.inputName = report.channels.input;
    if (report.loop)
        if (std::string source = loops::sourceOf(*report.loop, programs.back(), report.loop->form->output);
            !source.empty())
            report.measuredName = std::move(source);
    auto recorded = loops::seriesOf(history, report.channels);
    if (!recorded) return wrongUse(recorded.error());
    report.series = std::move(recorded->series);
    std::optional<loops::Settings> settings;
    if (report.loop) {
        const history::Statistics all = history.statistics();
        settings = loops::settingsOf(*report.loop, *programs.back(), history.seek(all.end - 1));
        report.series.low = settings->low;
        report.series.high = settings->high;
        report.targets = loops::targetsOf(*report.loop, programs.back());
        report.constants = loops::callConstants(*report.loop, programs.back());
    }
    return answer(arguments, question, report, settings);
}

int tuneProject(const Arguments& arguments, const Question& question, const std::string& path) {
    RecordedRun run;
    run.path = path;
    run.length = std::chrono::seconds(60);
    run.check = [&](const driver::Built& built) -> Result<void> {
        if (const auto loop = loopFor(question, *built.program); !loop) return loop.error();
        return {};
    };
    run.ask = [&](const history::History& history) { return tuneHistory(arguments, question, history); };
    return askRecordedRun(arguments, run);
}

int tune(const Arguments& arguments) {
    if (arguments.paths().size() != 1) return wrongUse({errors::TuneNeedsOne(), ""});
    const auto question = questionOf(arguments);
    if (!question) return wrongUse(question.error());
    for (const char* option : {"--report", "--picture", "--bode"})
        if (const auto file = arguments.value(option))
            if (auto good = checkPlace(*file); !good) return wrongUse(good.error());
    const std::string& path = arguments.paths()[0];
    if (isTable(path)) return tuneTable(arguments, *question, path);
    if (!isRecording(path)) return tuneProject(arguments, *question, path);
    const auto loaded = openRecording(path);
    if (!loaded) return wrongUse(loaded.error());
    return tuneHistory(arguments, *question, **loaded);
}

} // namespace

Command tuneCommand() {
    return {
        {"tune",
         "PROJECT|RECORDING|TABLE.csv [OPTIONS]",
         "Finds steps in a recording, fits a process model and proposes controller settings.",
         {{"--loop", "NAME", "the controller block, for example Main.pid (default: the only one there is)"},
          {"--input", "EXPR", "the controller output, instead of --loop; for a table the name of a column"},
          {"--output", "EXPR", "the measured value"},
          {"--setpoint", "EXPR", "the set point, if there is one"},
          {"--rule", "simc|amigo|optimum|chr|zn", "the rule whose settings are printed (default simc)"},
          {"--kind", "p|pi|pid", "the kind of controller (default pi, or what the block can do)"},
          {"--brisk", "0.5", "from 0, calm, to 1, brisk"},
          {"--tracking", "0.5", "from 0, for disturbances, to 1, for the set point"},
          {"--cycle", "100ms", "interval of the calls (default: as the program says, or that of the samples)"},
          {"--step", "3", "use this step for the model (repeatable; default: the clearest ones)"},
          {"--picture", "out.svg", "draw data and model, the responses and the Bode plot"},
          {"--bode", "out.svg", "draw the Bode plot of process and loop, crossover and margins marked"},
          {"--report", "out.html",
           "write a page on how the loop is doing, with charts, model and settings (.html or .pdf)"},
          {"--dark", "", "draw on a dark ground"},
          {"--for", "60s", "PLC time to run a project (default 60s)"},
          {"--set", "PATH=VALUE[@TIME]", "write before the first scan at or after TIME (repeatable)"},
          {"--force", "PATH=VALUE[@TIME]", "force likewise; VALUE RELEASE ends it (repeatable)"},
          {"--start", "DT#2026-01-01-06:00:00", "calendar at the first scan"},
          {"--library", "NAME", "a library the files use, in addition to the standard library (repeatable)"},
          {"--format", "text|json", "text (default) or one JSON object"}},
         "stepwise tune projects/examples/cascade --loop Main.controller.PI --set Main.SetPoint=24.0@200s --for 600s"},
        tune};
}

} // namespace plc::cli
