#include "projects/loops/trial.h"

#include "projects/loops/errors.h"
#include "runtime/controller/controller.h"

#include <algorithm>
#include <cmath>

namespace plc::loops {

namespace {

using controller::Controller;

/// The value of a path in an image, exactly.
types::Value exactly(const image::CompiledProgram& program, std::span<const std::byte> image,
                     const image::Place& place) {
    return types::readValue(*program.layout.types, place.type, image.subspan(place.offset), place.bit);
}

double numberOf(const types::Value& value) {
    if (const auto* number = std::get_if<double>(&value.data)) return *number;
    if (const auto* number = std::get_if<int64_t>(&value.data)) return static_cast<double>(*number);
    return 0;
}

Result<image::Place> placeOf(const image::CompiledProgram& program, const std::string& path) {
    auto place = program.layout.find(path);
    if (!place) return Error{place.error().message, path};
    return place;
}

/// What was recorded of a variable, scan by scan, as the variable holds it.
struct Played {
    std::string path;
    std::vector<types::Value> values;
};

types::Value asHeld(const image::CompiledProgram& program, const image::Place& place, const history::Sample& sample) {
    switch (program.layout.types->family(place.type)) {
    case types::Family::Real:
        return {place.type, sample.value};
    case types::Family::Duration:
    case types::Family::Date:
    case types::Family::TimeOfDay:
    case types::Family::DateTime:
        return {place.type, sample.integer};
    case types::Family::Bool:
    case types::Family::Bits:
    case types::Family::Signed:
    case types::Family::Unsigned:
    case types::Family::Character:
    case types::Family::Other:
        break;
    }
    constexpr double kExact = 9007199254740992.0;
    const bool isExact = std::abs(sample.value) < kExact;
    return {place.type, isExact ? static_cast<int64_t>(sample.value) : sample.integer};
}

Result<Played> playedOf(const history::History& history, const ProgramPointer& program, const std::string& path,
                        const TrialPlan& plan) {
    const auto place = placeOf(*program, path);
    if (!place) return place.error();
    const auto expression = driver::compileExpression(driver::checkedOf(program), path);
    if (!expression) return expression.error();
    Played out{path, {}};
    const auto onlyThis = [&](const image::CompiledProgram& of) {
        return &of == program.get() ? *expression : expression::Expression();
    };
    for (const history::Sample& sample : history.samples(*expression, onlyThis, plan.from + 1, plan.to)) {
        const bool isNext = sample.at.position == plan.from + 1 + out.values.size();
        if (!sample.hasValue || !isNext) return Error{errors::TrialAcrossVersions(), path};
        out.values.push_back(asHeld(*program, *place, sample));
    }
    // the oldest scans may be forgotten between one variable and the next
    if (plan.from + 1 + out.values.size() != plan.to) return Error{errors::TrialAcrossVersions(), path};
    return out;
}

void append(tuning::LoopSeries& series, double time, double input, double output) {
    series.time.push_back(time);
    series.input.push_back(input);
    series.output.push_back(output);
}

/// A controller at the first scan of the stretch, with the new parameters.
Result<std::unique_ptr<Controller>> controllerAt(const history::ScanInput& input, std::span<const std::byte> image,
                                                 const history::ScanStamp& stamp, const TrialPlan& plan) {
    controller::Settings settings;
    settings.calendarStartNs = input.calendarStartNs;
    const auto& program = plan.program ? plan.program : input.program;
    auto out = std::make_unique<Controller>(program, settings);
    out->resumeFrom(program, image, stamp.scan, stamp.time);
    for (const ParameterWrite& write : plan.writes) {
        const auto value = valueFor(*program, write.path, write.value);
        if (!value) return value.error();
        if (auto written = out->write(write.path, *value); !written) return written.error();
    }
    out->start();
    return out;
}

} // namespace

Result<types::Value> valueFor(const image::CompiledProgram& program, const std::string& path, double value) {
    const auto place = placeOf(program, path);
    if (!place) return place.error();
    switch (program.layout.types->family(place->type)) {
    case types::Family::Real:
        return types::Value{place->type, value};
    case types::Family::Duration:
        return types::Value{place->type, static_cast<int64_t>(std::llround(value * 1e9))};
    case types::Family::Signed:
    case types::Family::Unsigned:
    case types::Family::Bits:
    case types::Family::Bool:
        return types::Value{place->type, static_cast<int64_t>(std::llround(value))};
    case types::Family::Date:
    case types::Family::TimeOfDay:
    case types::Family::DateTime:
    case types::Family::Character:
    case types::Family::Other:
        break;
    }
    return Error{errors::NotASignal(), path};
}

namespace {

/// What the process does differently from the recording, because the input does.
class Deviation {
public:
    explicit Deviation(const std::optional<tuning::ProcessModel>& process) : m_process(process) {}
    /// At the next scan, after the input differed by so much from the recorded one.
    double next(double time, double difference) {
        if (!m_process) return 0;
        if (m_time && !m_sampled) m_sampled.emplace(*m_process, time - *m_time);
        m_time = time;
        if (!m_sampled) return 0;
        m_sampled->advance(difference);
        return m_sampled->output();
    }

private:
    const std::optional<tuning::ProcessModel>& m_process;
    std::optional<tuning::SampledProcess> m_sampled;
    std::optional<double> m_time;
};

struct Stage {
    std::unique_ptr<Controller> controller;
    Played measured, input;
    std::vector<Played> others;
    ProgramPointer program;
    double start = 0; // time of the scan before the first
};

/// What the call saw where the program computes the measured value after it: that of the scan before.
void delayByAScan(Stage& stage, std::span<const std::byte> first) {
    const auto delay = [&](Played& played) {
        const auto place = stage.program->layout.find(played.path);
        if (!place || played.values.empty()) return;
        played.values.insert(played.values.begin(), exactly(*stage.program, first, *place));
        played.values.pop_back();
    };
    delay(stage.measured);
    for (Played& one : stage.others) delay(one);
}

Result<Stage> stageFor(const history::History& history, const TrialPlan& plan, bool isDelayed) {
    const auto input = history.inputOf(plan.from + 1);
    if (!input) return input.error();
    Stage out;
    const auto stamp = history.stamp(plan.from);
    const std::vector<std::byte> first = history.seek(plan.from, &out.program);
    if (!stamp || first.empty() || out.program != input->program) return Error{errors::TrialAcrossVersions(), ""};
    out.start = std::chrono::duration<double>(stamp->time).count();
    auto measured = playedOf(history, out.program, plan.measured, plan);
    auto driven = playedOf(history, out.program, plan.input, plan);
    if (!measured || !driven) return (!measured ? measured : driven).error();
    out.measured = std::move(*measured);
    out.input = std::move(*driven);
    for (const std::string& path : plan.played) {
        auto played = playedOf(history, out.program, path, plan);
        if (!played) return played.error();
        out.others.push_back(std::move(*played));
    }
    if (isDelayed) delayByAScan(out, first);
    auto controller = controllerAt(*input, first, *stamp, plan);
    if (!controller) return controller.error();
    out.controller = std::move(*controller);
    return out;
}

} // namespace

namespace {

Result<TrialRun> tryOutOn(const history::History& history, const TrialPlan& plan,
                          const std::optional<tuning::ProcessModel>& process, bool isDelayed) {
    auto stage = stageFor(history, plan, isDelayed);
    if (!stage) return stage.error();
    Controller& controller = *stage->controller;
    const auto driven = placeOf(*stage->program, plan.input);
    Deviation deviation(process);
    (void)deviation.next(stage->start, 0);
    TrialRun out;
    double difference = 0;
    for (size_t i = 0; i < stage->measured.values.size(); ++i) {
        const double time = std::chrono::duration<double>(controller.nextDue()).count();
        for (const Played& one : stage->others)
            if (auto done = controller.force(one.path, one.values[i]); !done) return done.error();
        types::Value value = stage->measured.values[i];
        const double was = numberOf(value);
        if (const double moved = deviation.next(time, difference); moved != 0) {
            auto changed = valueFor(*stage->program, plan.measured, was + moved);
            if (!changed) return changed.error();
            value = std::move(*changed);
        }
        if (auto done = controller.force(plan.measured, value); !done) return done.error();
        if (!controller.scan()) return Error{controller.fault() ? controller.fault()->message : Message(), ""};
        const types::Value before = stage->input.values[i], now = exactly(*stage->program, controller.image(), *driven);
        if (!out.firstDifference && !(before.data == now.data)) out.firstDifference = controller.nextScan() - 1;
        difference = numberOf(now) - numberOf(before);
        append(out.before, time, numberOf(before), was);
        append(out.series, time, numberOf(now), numberOf(value));
        ++out.scans;
    }
    return out;
}

/// Whether only what the scan before left explains what the controller did; a short look without new settings says it.
bool seesTheScanBefore(const history::History& history, TrialPlan plan) {
    constexpr history::Position kLook = 200;
    plan.to = std::min(plan.to, plan.from + kLook);
    plan.writes.clear();
    plan.program.reset();
    const auto repeats = [&](bool isDelayed) {
        const auto run = tryOutOn(history, plan, std::nullopt, isDelayed);
        return run && !run->firstDifference;
    };
    return !repeats(false) && repeats(true);
}

} // namespace

Result<TrialRun> tryOut(const history::History& history, const TrialPlan& plan,
                        const std::optional<tuning::ProcessModel>& process) {
    return tryOutOn(history, plan, process, seesTheScanBefore(history, plan));
}

Result<TrialPlan> planFor(const Loop& loop, const history::History& history, history::Position from,
                          history::Position to) {
    TrialPlan plan;
    std::shared_ptr<const image::CompiledProgram> program;
    if (history.seek(from, &program).empty()) return Error{errors::TrialAcrossVersions(), ""};
    plan.from = from;
    plan.to = to;
    plan.input = loop.pin(loop.form->input);
    plan.measured = sourceOf(loop, program, loop.form->output);
    if (plan.measured.empty()) return Error{errors::MeasuredIsExpression(loop.pin(loop.form->output)), ""};
    // a cascade needs what its other loop sees, too
    for (const tuning::BlockForm& form : tuning::blockForms()) {
        if (form.type != loop.form->type) continue;
        for (const std::string_view pin : {form.output, form.setPoint}) {
            const std::string source = sourceOf(loop, program, pin);
            const bool isKnown = source == plan.measured ||
                                 std::find(plan.played.begin(), plan.played.end(), source) != plan.played.end();
            if (!source.empty() && source != loop.pin(pin) && !isKnown) plan.played.push_back(source);
        }
    }
    return plan;
}

std::vector<ParameterWrite> writesOf(const Loop& loop, const ProgramPointer& program,
                                     const std::vector<tuning::ParameterValue>& parameters,
                                     std::vector<std::string>* missing) {
    std::vector<ParameterWrite> out;
    const std::vector<Target> targets = targetsOf(loop, program);
    for (size_t i = 0; i < parameters.size() && i < targets.size(); ++i) {
        const bool isMilliseconds = loop.form->parameters[i].unit == tuning::Unit::Milliseconds;
        if (!targets[i].path.empty())
            out.push_back({targets[i].path, parameters[i].value * (isMilliseconds ? 1e3 : 1)});
        else if (missing)
            missing->push_back(targets[i].member);
    }
    return out;
}

std::vector<ParameterWrite> bumplessWrites(const Loop& loop, const image::CompiledProgram& program) {
    if (loop.form->resumes.empty()) return {};
    const std::string path = loop.pin(loop.form->resumes);
    if (!program.layout.find(path)) return {}; // of a recording with an older library
    return {{path, 1}};
}

} // namespace plc::loops
