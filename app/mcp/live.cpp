#include "app/mcp/live.h"

#include "projects/protocol/errors.h"
#include "projects/session/value_text.h"
#include "projects/storage/project_file.h"

#include <thread>

namespace plc::mcp {

namespace errors = protocol::errors;
using std::chrono::milliseconds;

const std::vector<LiveTool>& liveTools() {
    static const Field path{"path", FieldType::Text, "--", "the variable, for example Plant.StartButton", true};
    static const Field value{"value", FieldType::Text, "--", "as ST writes it: TRUE, 5, T#1s", true};
    static const std::vector<LiveTool> all = {
        {"live_start",
         "Starts a project's controller in real time inside this server; one runs at a time.",
         {{"project", FieldType::Text, "", "folder of the project, or an ST file", true}},
         false},
        {"live_values",
         "State, time and values of the running controller.",
         {{"watch", FieldType::Texts, "--", "ST expressions", true}},
         false},
        {"live_write",
         "Writes a variable of the running controller. Needs `stepwise mcp --allow-writes`.",
         {path, value},
         true},
        {"live_force",
         "Forces a variable of the running controller; value RELEASE ends it. Needs `stepwise mcp --allow-writes`.",
         {path, value},
         true},
        {"live_stop", "Stops the running controller; its outputs go to their safe state.", {}, false},
    };
    return all;
}

Result<std::string> Live::call(std::string_view tool, const Json& arguments) {
    if (tool == "live_start") return start(arguments);
    if (!m_session) return Error{errors::NothingLive(), {}};
    if (tool == "live_values") return values(arguments);
    if (tool == "live_stop") return stop();
    if (!m_allowsWrites) return Error{errors::WritesNeedLeave(), {}};
    return write(arguments, tool == "live_force");
}

Result<std::string> Live::start(const Json& arguments) {
    if (m_session) return Error{errors::IsLive(m_name), {}};
    const auto project = projects::openProject({arguments["project"].get<std::string>()});
    if (!project) return project.error();
    driver::Built built = driver::build(project->buildInput());
    if (!built.program || built.program->tasks.empty())
        return Error{built.failure.isEmpty() ? errors::NothingToRun() : built.failure, project->name};
    m_session = std::make_unique<session::Session>(std::move(built));
    m_session->startThread({session::Pace::Real, 1.0});
    m_name = project->name;
    return errors::LiveStarted(m_name).english();
}

Result<std::string> Live::values(const Json& arguments) {
    static constexpr const char* kStates[] = {"stopped", "running", "paused", "halted", "fault"};
    const session::Status status = m_session->status();
    session::Snapshot now;
    m_session->latest(now);
    Json out{{"state", kStates[static_cast<size_t>(status.state)]}, {"scan", now.scan}};
    out["time_s"] = static_cast<double>(now.time.count()) / 1e9;
    if (status.fault) out["fault"] = status.fault->message.english();
    for (const Json& each : arguments["watch"]) {
        const auto text = each.get<std::string>();
        const auto expression = m_session->expression(text);
        if (!expression) return Error{expression.error().message, text};
        const expression::Outcome outcome = expression->evaluate(now.image);
        out["values"][text] = outcome.hasValue() ? types::toText(expression->types(), outcome.value)
                                                 : "(" + outcome.reason.english() + ")";
    }
    return protocol::toText(out);
}

Result<std::string> Live::write(const Json& arguments, bool isForce) {
    const auto path = arguments["path"].get<std::string>(), text = arguments["value"].get<std::string>();
    const auto place = m_session->program()->layout.find(path);
    if (!place) return place.error();
    (void)m_session->takeRefusals();
    if (isForce && text == "RELEASE") {
        m_session->unforce(path);
    } else {
        auto value = session::parseValue(m_session->built().checked, place->type, text, path);
        if (!value) return value.error();
        if (isForce)
            m_session->force(path, std::move(*value), "assistant");
        else
            m_session->write(path, std::move(*value), "assistant");
    }
    const uint64_t scans = m_session->status().scans; // it is done when two more have been made
    for (const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
         std::chrono::steady_clock::now() < end && m_session->status().scans < scans + 2 &&
         m_session->status().state == controller::State::Running;)
        std::this_thread::sleep_for(milliseconds(1));
    if (const std::vector<Error> refusals = m_session->takeRefusals(); !refusals.empty()) return refusals.front();
    return errors::LiveWritten(path, text).english();
}

Result<std::string> Live::stop() {
    m_session->stop();
    m_session.reset();
    return errors::LiveStopped(m_name).english();
}

} // namespace plc::mcp
