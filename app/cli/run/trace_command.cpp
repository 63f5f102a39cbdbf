#include "app/cli/run/commands.h"

#include "app/cli/kit/errors.h"
#include "app/cli/run/timed_write.h"
#include "editor/kit/theme.h"
#include "editor/trace/curves/trace_picture.h"
#include "editor/trace/recording/run_recording.h"
#include "projects/session/session.h"

#include <QApplication>

#include <algorithm>
#include <filesystem>
#include <iostream>

namespace plc::cli {

namespace {

using std::chrono::nanoseconds;

/// Splits at commas that stand outside brackets and texts.
std::vector<std::string> splitExpressions(const std::string& list) {
    std::vector<std::string> out(1);
    int depth = 0;
    char quote = 0;
    for (const char c : list) {
        if (quote)
            quote = c == quote ? 0 : quote;
        else if (c == '\'' || c == '"')
            quote = c;
        else if (c == '(' || c == '[')
            ++depth;
        else if (c == ')' || c == ']')
            --depth;
        if (c == ',' && depth == 0 && !quote)
            out.emplace_back();
        else
            out.back() += c;
    }
    for (std::string& text : out) {
        text.erase(0, text.find_first_not_of(' '));
        text.erase(text.find_last_not_of(' ') + 1);
    }
    std::erase(out, std::string());
    return out;
}

constexpr std::pair<const char*, trace::FigureKind> kFigures[] = {{"--xy", trace::FigureKind::Xy},
                                                                  {"--spectrum", trace::FigureKind::Spectrum},
                                                                  {"--response", trace::FigureKind::Response},
                                                                  {"--runs", trace::FigureKind::Runs}};

/// The figure that was asked for, and the expressions it is of.
Result<std::vector<std::string>> figureOf(const Arguments& arguments, trace::FigureSetup& figure) {
    std::vector<std::string> expressions;
    for (const auto& [option, kind] : kFigures) {
        if (!arguments.has(option) && !arguments.value(option)) continue;
        if (figure.kind != trace::FigureKind::None) return Error{errors::OneFigure(), option};
        figure.kind = kind;
        for (const std::string& list : arguments.values(option))
            for (std::string& text : splitExpressions(list)) expressions.push_back(std::move(text));
        const bool needsTwo = kind == trace::FigureKind::Xy || kind == trace::FigureKind::Response;
        if (needsTwo && expressions.size() < 2) return Error{errors::FigureNeedsTwo(Verbatim(option)), ""};
        if (needsTwo) figure.x = expressions.front();
    }
    if (const auto window = arguments.value("--window")) {
        if (*window == "hann")
            figure.window = trace::FigureWindow::Hann;
        else if (*window == "flat-top")
            figure.window = trace::FigureWindow::FlatTop;
        else if (*window == "none")
            figure.window = trace::FigureWindow::Rectangular;
        else
            return Error{errors::WindowIs(*window), ""};
    }
    if (arguments.has("--linear")) figure.isLogarithmic = false;
    return expressions;
}

/// "TIME=text".
Result<trace::NoteSetup> noteOf(const std::string& text) {
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals + 1 == text.size()) return Error{errors::NoteNeedsText(), text};
    const auto time = parseDuration(text.substr(0, equals));
    if (!time) return time.error();
    trace::NoteSetup note;
    note.time = time->count();
    note.text = text.substr(equals + 1);
    return note;
}

/// "FILE=EXPR,…": channels of another recording or table.
Result<void> addMeasured(const std::string& text, trace::TraceSetup& setup) {
    const size_t equals = text.find('=');
    const auto expressions = splitExpressions(equals == std::string::npos ? "" : text.substr(equals + 1));
    if (expressions.empty()) return Error{errors::MeasuredNeedsChannels(), text};
    for (const std::string& expression : expressions) {
        trace::ChannelSetup channel;
        channel.expression = expression;
        channel.recording = text.substr(0, equals);
        channel.label = expression + " (" + std::filesystem::path(channel.recording).stem().string() + ")";
        setup.channels.push_back(std::move(channel));
    }
    return {};
}

Result<trace::TraceSetup> setupOf(const Arguments& arguments, const projects::Project* project) {
    trace::TraceSetup setup;
    std::vector<std::string> expressions;
    for (const std::string& list : arguments.values("--channels"))
        for (std::string& text : splitExpressions(list)) expressions.push_back(std::move(text));
    trace::FigureSetup figure;
    const auto ofFigure = figureOf(arguments, figure);
    if (!ofFigure) return ofFigure.error();
    for (const std::string& text : *ofFigure)
        if (std::find(expressions.begin(), expressions.end(), text) == expressions.end()) expressions.push_back(text);
    std::optional<std::string> name = arguments.value("--setup");
    if (!name && expressions.empty() && project && project->traces.size() == 1) name = project->traces[0];
    if (name) {
        namespace fs = std::filesystem;
        fs::path path = *name;
        if (!fs::is_regular_file(path) && project) {
            std::string file = *name;
            if (!file.ends_with(".trace.json")) file += ".trace.json";
            path = fs::path(project->folder) / "traces" / file;
        }
        auto loaded = trace::loadSetup(path.string());
        if (!loaded) return loaded;
        setup = std::move(*loaded);
    }
    if (setup.channels.empty() && expressions.empty() && arguments.values("--measured").empty()) {
        std::vector<std::string> known;
        if (project)
            for (const std::string& trace : project->traces)
                known.push_back(trace.substr(0, trace.find(".trace.json")));
        return Error{known.empty() ? errors::TraceNeedsChannels() : errors::TraceNeedsChannelsKnown(std::move(known)),
                     ""};
    }
    for (trace::ChannelSetup& channel : trace::setupOf(expressions).channels)
        setup.channels.push_back(std::move(channel));
    for (const std::string& text : arguments.values("--measured"))
        if (auto added = addMeasured(text, setup); !added) return added.error();
    if (figure.kind != trace::FigureKind::None) {
        figure.origin = setup.figure.origin;
        setup.figure = figure;
    }
    for (const std::string& text : arguments.values("--note")) {
        auto note = noteOf(text);
        if (!note) return note.error();
        setup.notes.push_back(std::move(*note));
    }
    if (const auto trigger = arguments.value("--trigger")) {
        setup.trigger.expression = *trigger;
        if (setup.trigger.mode == trace::TriggerMode::Off) setup.trigger.mode = trace::TriggerMode::Single;
    }
    for (const auto& [option, target] :
         {std::pair{"--before", &setup.trigger.before}, std::pair{"--after", &setup.trigger.after}})
        if (const auto text = arguments.value(option)) {
            const auto time = parseDuration(*text);
            if (!time) return time.error();
            *target = time->count();
        }
    if (const auto text = arguments.value("--cursors")) {
        const size_t comma = text->find(',');
        if (comma == std::string::npos) return Error{errors::CursorsNeedTimes(), *text};
        const auto a = parseDuration(text->substr(0, comma)), b = parseDuration(text->substr(comma + 1));
        if (!a || !b) return !a ? a.error() : b.error();
        setup.cursorA = a->count();
        setup.cursorB = b->count();
        setup.hasTable = true;
    }
    return setup;
}

Result<trace::TraceOutput> outputOf(const Arguments& arguments, trace::TraceSetup setup) {
    trace::TraceOutput out;
    out.setup = std::move(setup);
    out.picture = QString::fromStdString(arguments.value("--picture").value_or(""));
    out.csv = QString::fromStdString(arguments.value("--csv").value_or(""));
    out.isDark = arguments.has("--dark");
    out.wantsStatistics = arguments.has("--statistics");
    out.onlyFigure = std::any_of(std::begin(kFigures), std::end(kFigures),
                                 [&](const auto& figure) { return !arguments.values(figure.first).empty(); });
    for (const auto& [option, target] : {std::pair{"--from", &out.from}, std::pair{"--to", &out.to}})
        if (const auto text = arguments.value(option)) {
            const auto time = parseDuration(*text);
            if (!time) return time.error();
            *target = time->count();
        }
    if (const auto text = arguments.value("--size")) {
        int width = 0, height = 0, used = 0;
        if (std::sscanf(text->c_str(), "%dx%d%n", &width, &height, &used) != 2 ||
            static_cast<size_t>(used) != text->size() || width < 200 || height < 120 || width > 20'000 ||
            height > 20'000)
            return Error{errors::SizeNeedsTwo(), *text};
        out.size = QSize(width, height);
    }
    if (const auto text = arguments.value("--scale")) {
        out.scale = std::atof(text->c_str());
        if (!(out.scale >= 0.5 && out.scale <= 8)) return Error{errors::TraceScaleRange(), *text};
    }
    const bool hasFigure = out.setup.figure.kind != trace::FigureKind::None; // which has figures of its own
    if (out.picture.isEmpty() && out.csv.isEmpty() && !out.wantsStatistics && !hasFigure) out.wantsStatistics = true;
    return out;
}

int finish(const trace::Recording& recording, const trace::TraceOutput& output) {
    const auto text = trace::renderTrace(recording, output);
    if (!text) return wrongUse(text.error());
    std::cout << *text;
    return kGood;
}

/// What a table was not like is said beside the result.
Result<std::shared_ptr<trace::RunRecording>> openFile(const std::string& file) {
    auto out = trace::RunRecording::open(file);
    if (out)
        for (const Message& note : (*out)->notes()) std::cerr << file << ": " << note.english() << "\n";
    return out;
}

/// Files that channels name: as given, else in the project.
trace::OtherRecordings::Open openIn(const std::string& folder) {
    return [folder](const std::string& file) {
        namespace fs = std::filesystem;
        return openFile(fs::exists(file) ? file : (fs::path(folder) / file).string());
    };
}

int traceRecording(const Arguments& arguments, const std::string& file) {
    const auto setup = setupOf(arguments, nullptr);
    if (!setup) return wrongUse(setup.error());
    auto output = outputOf(arguments, *setup);
    if (!output) return wrongUse(output.error());
    output->openOther = openIn({});
    const auto recording = openFile(file);
    if (!recording) return wrongUse(recording.error());
    needApplication();
    return finish(**recording, *output);
}

int runTrace(const Arguments& arguments) {
    if (const auto file = arguments.value("--recording")) return traceRecording(arguments, *file);
    if (arguments.paths().empty()) return wrongUse({errors::NeedsProject(Verbatim("trace")), ""});
    const auto project = openNamedProject(arguments);
    if (!project) return wrongUse(project.error());
    const auto setup = setupOf(arguments, &*project);
    if (!setup) return wrongUse(setup.error());
    auto output = outputOf(arguments, *setup);
    if (!output) return wrongUse(output.error());
    const driver::Built built = driver::build(project->buildInput());
    printDiagnostics(built.checked, false, false);
    if (built.checked.analysis->hasErrors) return kProgramWrong;
    if (!built.program)
        return wrongUse({built.failure.isEmpty() ? errors::NothingToRun() : built.failure, project->name});
    if (auto optimised = driver::optimise(built); !optimised) return wrongUse(optimised.error());
    session::Settings settings;
    settings.historyBudget = size_t(2) << 30;
    catchInterrupt();
    session::Session session(built, settings);
    if (auto ran = runProject(arguments, built, session, std::chrono::seconds(10), "--for"); !ran)
        return wrongUse(ran.error());
    const bool faulted = session.controller().state() == controller::State::Fault;
    if (faulted && session.controller().fault())
        std::cerr << "stepwise: " << session.controller().fault()->message << "\n";
    needApplication();
    std::shared_ptr<trace::RunRecording> beneath;
    std::optional<std::string> file = arguments.value("--beneath");
    if (!file && !setup->compareWith.empty())
        file = (std::filesystem::path(project->folder) / setup->compareWith).string();
    if (file) {
        const auto older = openFile(*file);
        if (!older) return wrongUse(older.error());
        beneath = *older;
        output->beneath = beneath.get();
    }
    output->openOther = openIn(project->folder);
    const trace::RunRecording recording(session);
    const int done = finish(recording, *output);
    return faulted ? kProgramWrong : done;
}

} // namespace

Command traceCommand() {
    return {
        {"trace",
         "PATH… [OPTIONS]",
         "Runs a project and draws its charts: picture, CSV, statistics.",
         {{"--channels", "EXPR,…",
           "variables or expressions to draw; DERIVATIVE(…), INTEGRAL(…), FILTER(…, T#1s) around them (repeatable)"},
          {"--setup", "NAME", "the project's traces/NAME.trace.json, or a file (default: its only one)"},
          {"--for", "10s", "PLC time to run (default 10s)"},
          {"--set", "PATH=VALUE[@TIME]", "write before the first scan at or after TIME (repeatable)"},
          {"--force", "PATH=VALUE[@TIME]", "force likewise (repeatable)"},
          {"--recording", "FILE", "draw a recording made by run --record, or a table (.csv), instead of running"},
          {"--beneath", "FILE", "an older recording or a table, drawn faintly in the background"},
          {"--measured", "FILE=EXPR,…", "channels of another recording or table beside the others (repeatable)"},
          {"--xy", "X,Y…", "draw Y over X instead of over time"},
          {"--spectrum", "EXPR,…", "draw the spectrum and print its peaks"},
          {"--window", "hann|flat-top|none", "window of the spectrum (default hann)"},
          {"--linear", "", "linear axes of the spectrum"},
          {"--response", "INPUT,OUTPUT…", "draw the frequency response from one to the other (Bode plot, coherence)"},
          {"--runs", "EXPR,…", "lay the stretches around each edge of --trigger over each other"},
          {"--note", "TIME=TEXT", "a note in the picture (repeatable)"},
          {"--picture", "FILE", "the charts as .png, .svg or .pdf"},
          {"--csv", "FILE", "every sample shown, a row per scan"},
          {"--statistics", "", "a table: values at the cursors (or ends), least, greatest, mean, RMS, step response"},
          {"--cursors", "1s,2s", "two cursors in the picture, with the measuring table beneath"},
          {"--trigger", "EXPR", "show what is around its rising edge (or as the set-up says)"},
          {"--before", "1s", "time shown before the trigger"},
          {"--after", "1s", "time shown after it"},
          {"--from", "0s", "first time shown"},
          {"--to", "10s", "last time shown"},
          {"--size", "1200x700", "size of the picture"},
          {"--scale", "1", "pixels per unit of a .png"},
          {"--dark", "", "dark colours"},
          {"--library", "NAME", "a library the files use, in addition to the standard library (repeatable)"}},
         "stepwise trace projects/examples/pid_pt1 --channels Main.SetPoint,IO.Measured --for 20s --picture loop.png "
         "--statistics"},
        runTrace};
}

} // namespace plc::cli
