#include "projects/debug_adapter/debuggee.h"

#include "projects/protocol/errors.h"
#include "projects/session/value_text.h"
#include "projects/session/versions.h"
#include "projects/storage/project_file.h"
#include "runtime/base/text.h"
#include "runtime/debug/frames.h"

#include <thread>

namespace plc::dap {

namespace errors = protocol::errors;
using std::chrono::milliseconds;
using PlcState = controller::State;

Debuggee::~Debuggee() = default;

Result<std::unique_ptr<Debuggee>> Debuggee::launch(const LaunchSettings& settings) {
    auto project = projects::openProject({settings.program});
    if (!project) return project.error();
    for (const std::string& library : settings.libraries) project->libraries.push_back(foldCase(library));
    driver::Built built = driver::build(project->buildInput());
    if (built.checked.analysis->hasErrors) {
        for (const diagnostics::Diagnostic& each : built.checked.analysis->diagnostics)
            if (each.severity == diagnostics::Severity::Error)
                return Error{errors::ProgramWrong(each.message), project->name};
    }
    if (!built.program) return Error{built.failure.isEmpty() ? errors::NothingToRun() : built.failure, project->name};
    if (built.program->tasks.empty()) return Error{errors::NothingToRun(), project->name};
    std::unique_ptr<Debuggee> out(new Debuggee);
    out->m_folder = project->folder;
    out->m_session = std::make_unique<session::Session>(std::move(built));
    out->m_mode = settings.mode;
    out->m_insight = std::make_unique<inside::Insight>(out->m_session->history());
    return out;
}

Result<std::unique_ptr<Debuggee>> Debuggee::open(const std::string& recording, const std::string& folder) {
    Message failure;
    auto loaded = history::History::load(recording, [&](const history::History::Sources& sources) {
        driver::Built built = driver::build(session::recordedInput(sources));
        if (!built.program) failure = built.failure.isEmpty() ? errors::NothingToRun() : built.failure;
        return std::shared_ptr<const image::CompiledProgram>(built.program);
    });
    if (!loaded) return failure.isEmpty() ? loaded.error() : Error{failure, recording};
    if ((*loaded)->statistics().scans == 0) return Error{errors::NothingRecorded(), recording};
    std::unique_ptr<Debuggee> out(new Debuggee);
    out->m_folder = folder;
    out->m_recording = std::move(*loaded);
    out->m_insight = std::make_unique<inside::Insight>(*out->m_recording);
    if (auto shown = out->show(out->m_recording->statistics().end - 1); !shown) return shown.error();
    return out;
}

const history::History& Debuggee::history() const { return m_session ? m_session->history() : *m_recording; }

const image::CompiledProgram& Debuggee::program() const {
    return m_scan ? m_scan->look().program() : *m_session->program();
}

void Debuggee::setBreakpoints(std::vector<debug::Breakpoint> breakpoints) {
    m_breakpoints = std::move(breakpoints);
    if (m_session) m_session->setBreakpoints(m_breakpoints);
    takeLines();
}

// ---------------------------------------------------------------- the live scan

void Debuggee::live(Stop::Why why) {
    m_motion = Motion::Live;
    m_why = why;
    m_snapshot.reset();
}

void Debuggee::begin(bool stopsAtEntry) {
    if (!m_session) { // a recording begins where it ends
        m_scan->goTo(m_scan->stops() > 0 ? m_scan->stops() - 1 : 0);
        m_stop = Stop{Stop::Why::Entry, {}};
        m_motion = Motion::Forward;
        return;
    }
    live(stopsAtEntry ? Stop::Why::Entry : Stop::Why::Breakpoint);
    m_session->startThread(m_mode, true);
    if (stopsAtEntry)
        m_session->step(debug::Step::In);
    else
        m_session->start();
}

void Debuggee::goOn() {
    m_isPauseAsked = false;
    if (m_scan) {
        m_motion = Motion::Forward;
        return;
    }
    live(Stop::Why::Breakpoint);
    m_session->resume();
}

void Debuggee::step(debug::Step how) {
    m_isPauseAsked = false;
    if (!m_scan) {
        live(Stop::Why::Step);
        m_session->step(how);
        return;
    }
    (void)m_scan->step(how);
    if (!m_scan->isAtEnd() || turnTo(behind(m_scan->look().position()), false)) {
        m_motion = Motion::Forward;
        m_stop = Stop{Stop::Why::Step, {}};
        return;
    }
    leavePast(Stop::Why::Step);
}

void Debuggee::pause() {
    m_isPauseAsked = true;
    if (m_motion != Motion::Live) return;
    m_why = Stop::Why::Pause;
    m_session->step(debug::Step::In);
}

std::optional<Stop> Debuggee::stand(Stop::Why why, Message text) {
    m_motion = Motion::None;
    m_isPauseAsked = false;
    return Stop{why, std::move(text)};
}

std::optional<Stop> Debuggee::poll() {
    if (m_motion == Motion::None) return std::nullopt;
    if (m_stop) {
        const Stop found = *std::exchange(m_stop, std::nullopt);
        return stand(found.why, found.text);
    }
    switch (m_motion) {
    case Motion::Live:
        return pollLive();
    case Motion::Forward:
        return pollForward();
    case Motion::Back:
        return pollBack();
    case Motion::None:
        break;
    }
    return std::nullopt;
}

std::optional<Stop> Debuggee::pollLive() {
    const session::Status status = m_session->status();
    if (status.state == PlcState::Fault && status.fault) {
        // Its scan was recorded up to the statement that failed: one stands there in the recording.
        if (auto shown = show(history().statistics().end - 1); shown && m_scan->stops() > 0)
            m_scan->goTo(m_scan->stops() - 1);
        return stand(Stop::Why::Fault, status.fault->message);
    }
    if (status.state != PlcState::Halted || status.halts == m_haltsSeen) return std::nullopt;
    m_haltsSeen = status.halts;
    return stand(m_why, m_session->haltProblem());
}

// ---------------------------------------------------------------- what is seen

const session::Snapshot& Debuggee::snapshot() {
    if (!m_snapshot) m_session->latest(m_snapshot.emplace());
    return *m_snapshot;
}

std::optional<controller::Fault> Debuggee::fault() const {
    if (m_session) return m_session->status().fault;
    return m_scan ? m_scan->look().fault() : std::nullopt;
}

std::optional<history::ScanStamp> Debuggee::stamp() const {
    if (m_scan) return m_scan->look().input().stamp;
    return std::nullopt;
}

std::optional<size_t> Debuggee::taskNamed(std::string_view name) const {
    for (size_t i = 0; i < program().tasks.size(); ++i)
        if (program().tasks[i].name == name) return i;
    return std::nullopt;
}

/// The task that runs the program at the bottom of a call path.
std::optional<size_t> Debuggee::taskOf(const controller::FaultFrame& entry) const {
    for (size_t i = 0; i < program().tasks.size(); ++i)
        for (const image::TaskProgram& each : program().tasks[i].programs)
            if (each.function == entry.functionIndex &&
                program().layout.roots[each.root].offset == entry.instanceOffset)
                return i;
    return std::nullopt;
}

std::vector<Frame> Debuggee::frames() {
    std::vector<Frame> out;
    if (m_motion != Motion::None) return out;
    if (m_scan) {
        std::optional<size_t> task;
        for (const inside::SlowScan::Frame& each : m_scan->stackTrace()) {
            out.push_back({each.id, each.function, each.instance, each.range, {}});
            if (!each.task.empty()) task = taskNamed(each.task);
        }
        for (Frame& each : out) each.task = task;
        return out;
    }
    const std::vector<controller::FaultFrame> frames = m_session->haltFrames();
    for (const controller::FaultFrame& each : frames)
        out.push_back(
            {static_cast<uint32_t>(out.size()), each.function, each.instance, each.range, taskOf(frames.back())});
    return out;
}

std::vector<Debuggee::Variable> Debuggee::variables(const Frame& frame) {
    std::vector<Variable> out;
    if (m_scan) {
        for (const inside::SlowScan::Scope& scope : m_scan->scopes(frame.id))
            for (const inside::SlowScan::Variable& each : scope.variables)
                out.push_back(
                    {each.name, each.value, scope.kind == inside::SlowScan::Scope::Kind::Locals, each.isChanged});
        return out;
    }
    const std::vector<controller::FaultFrame> frames = m_session->haltFrames();
    if (frame.id >= frames.size() || !snapshot().isHalted) return out;
    for (debug::FrameVariable& each : debug::frameVariables(program(), snapshot().image, frames[frame.id]))
        out.push_back({std::move(each.name), std::move(each.value), each.isLocal, false});
    return out;
}

Result<types::Value> Debuggee::evaluate(const std::string& text, const std::optional<Frame>& frame) {
    if (m_motion != Motion::None) return Error{errors::IsRunning(), {}};
    if (m_scan) return m_scan->evaluate(text, frame ? frame->id : inside::kNone);
    if (frame)
        for (Variable& each : variables(*frame))
            if (each.isLocal && equalsIgnoringCase(each.name, text)) return std::move(each.value);
    const auto expression = m_session->expression(text, frame ? frame->instance : std::string());
    if (!expression) return expression.error();
    const expression::Outcome outcome = expression->evaluate(snapshot().image);
    if (!outcome.hasValue()) return Error{outcome.reason, {}};
    return outcome.value;
}

Result<types::Value> Debuggee::write(const std::string& path, const std::string& text) {
    if (m_motion != Motion::None) return Error{errors::IsRunning(), {}};
    if (m_scan) return Error{errors::PastIsFixed(), {}};
    const auto place = program().layout.find(path);
    if (!place) return place.error();
    auto value = session::parseValue(m_session->built().checked, place->type, text, path);
    if (!value) return value.error();
    (void)m_session->takeRefusals();
    m_session->write(path, *value, "debugger");
    const auto expression = m_session->expression(path);
    if (!expression) return expression.error();
    for (const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
         std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(milliseconds(1))) {
        if (const std::vector<Error> refusals = m_session->takeRefusals(); !refusals.empty()) return refusals.front();
        m_snapshot.reset();
        if (expression->evaluate(snapshot().image).value == *value) return *value;
    }
    return Error{errors::NotWritten(path), {}};
}

} // namespace plc::dap
