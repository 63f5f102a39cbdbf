#include "projects/debug_adapter/adapter.h"

#include "projects/protocol/errors.h"
#include "runtime/debug/sites.h"

#include <charconv>
#include <filesystem>

namespace plc::dap {

namespace errors = protocol::errors;
namespace fs = std::filesystem;
using debug::Step;

Adapter::~Adapter() = default;

Adapter::Method Adapter::methodOf(std::string_view name) {
    static const std::map<std::string_view, Method> methods = {
        {"initialize", &Adapter::initialize},
        {"launch", &Adapter::launch},
        {"attach", &Adapter::attach},
        {"configurationDone", &Adapter::configurationDone},
        {"restart", &Adapter::restart},
        {"disconnect", &Adapter::disconnect},
        {"terminate", &Adapter::disconnect},
        {"setBreakpoints", &Adapter::setBreakpoints},
        {"setExceptionBreakpoints", &Adapter::setExceptionBreakpoints},
        {"continue", &Adapter::goOn},
        {"next", &Adapter::next},
        {"stepIn", &Adapter::stepIn},
        {"stepOut", &Adapter::stepOut},
        {"pause", &Adapter::pause},
        {"stepBack", &Adapter::stepBack},
        {"reverseContinue", &Adapter::reverseContinue},
        {"threads", &Adapter::threads},
        {"stackTrace", &Adapter::stackTrace},
        {"scopes", &Adapter::scopes},
        {"variables", &Adapter::variables},
        {"evaluate", &Adapter::evaluate},
        {"setVariable", &Adapter::setVariable},
        {"setExpression", &Adapter::setExpression},
        {"exceptionInfo", &Adapter::exceptionInfo},
        {"source", &Adapter::source},
    };
    const auto it = methods.find(name);
    return it == methods.end() ? nullptr : it->second;
}

// ---------------------------------------------------------------- messages

void Adapter::event(std::string_view name, Json body) {
    Json message{{"seq", ++m_sequence}, {"type", "event"}, {"event", name}};
    if (!body.is_null()) message["body"] = std::move(body);
    m_send(message);
}

void Adapter::respond(const Json& request, const Body& body) {
    Json message{{"seq", ++m_sequence},
                 {"type", "response"},
                 {"request_seq", protocol::integerAt(request, "seq").value_or(0)},
                 {"success", static_cast<bool>(body)},
                 {"command", protocol::textAt(request, "command").value_or("")}};
    if (!body) {
        message["message"] = body.error().english();
        message["body"]["error"] = {{"id", 1}, {"format", body.error().english()}, {"showUser", true}};
    } else if (!body->is_null()) {
        message["body"] = *body;
    }
    m_send(message);
}

void Adapter::receive(const Result<std::string>& message) {
    if (!message) return respond(Json::object(), message.error());
    const std::variant<Json, protocol::Failure> parsed = protocol::parseJson(*message);
    if (const auto* failure = std::get_if<protocol::Failure>(&parsed))
        return respond(Json::object(), Error{failure->message, {}});
    const Json& request = std::get<Json>(parsed);
    const auto command = protocol::textAt(request, "command");
    if (protocol::textAt(request, "type") != "request" || !command || !protocol::integerAt(request, "seq"))
        return respond(request.is_object() ? request : Json::object(), Error{errors::NotAMessage(), {}});
    static const Json kNone = Json::object();
    const Json* arguments = protocol::find(request, "arguments");
    respond(request, answer(*command, arguments ? *arguments : kNone));
    if (*command == "launch" || *command == "attach")
        if (m_debuggee && !m_isConfigured) event("initialized", nullptr);
}

Adapter::Body Adapter::answer(const std::string& command, const Json& arguments) {
    const Method method = methodOf(command);
    if (!method) return Error{errors::NoSuchMethod(command), {}};
    const bool isFirst = command == "initialize" || command == "launch" || command == "attach" ||
                         command == "disconnect" || command == "terminate" || command == "setExceptionBreakpoints";
    if (!isFirst && !m_debuggee) return Error{errors::NotLaunched(), {}};
    return (this->*method)(arguments);
}

// ---------------------------------------------------------------- life

Adapter::Body Adapter::initialize(const Json& arguments) {
    m_firstLine = protocol::flagAt(arguments, "linesStartAt1", true) ? 1 : 0;
    m_firstColumn = protocol::flagAt(arguments, "columnsStartAt1", true) ? 1 : 0;
    Json can;
    for (const char* each : {"supportsConfigurationDoneRequest", "supportsConditionalBreakpoints",
                             "supportsHitConditionalBreakpoints", "supportsEvaluateForHovers", "supportsStepBack",
                             "supportsSetVariable", "supportsSetExpression", "supportsRestartRequest",
                             "supportsExceptionInfoRequest", "supportsTerminateRequest", "supportTerminateDebuggee"})
        can[each] = true;
    can["exceptionBreakpointFilters"] =
        Json::array({{{"filter", "faults"}, {"label", errors::FaultsOfProgram().english()}, {"default", true}}});
    return can;
}

Result<void> Adapter::load(const Json& arguments) {
    LaunchSettings settings;
    if (m_isAttached) {
        const auto recording = protocol::textAt(arguments, "recording");
        if (!recording) return Error{errors::WrongParameter(Verbatim("attach"), Verbatim("recording")), {}};
        auto opened = Debuggee::open(*recording, protocol::textAt(arguments, "program").value_or(""));
        if (!opened) return opened.error();
        m_debuggee = std::move(*opened);
        return {};
    }
    const auto program = protocol::textAt(arguments, "program");
    if (!program) return Error{errors::WrongParameter(Verbatim("launch"), Verbatim("program")), {}};
    settings.program = *program;
    settings.libraries = protocol::textsAt(arguments, "libraries");
    const std::string pace = protocol::textAt(arguments, "pace").value_or("real");
    if (pace != "real" && pace != "fastest") return Error{errors::PaceIs(pace), {}};
    if (pace == "fastest") settings.mode.pace = session::Pace::Fastest;
    auto launched = Debuggee::launch(settings);
    if (!launched) return launched.error();
    m_debuggee = std::move(*launched);
    return {};
}

Adapter::Body Adapter::launch(const Json& arguments) {
    if (m_debuggee) return Error{errors::LaunchedTwice(), {}};
    m_launched = arguments;
    if (auto loaded = load(arguments); !loaded) return loaded.error();
    return Json();
}

Adapter::Body Adapter::attach(const Json& arguments) {
    if (m_debuggee) return Error{errors::LaunchedTwice(), {}};
    m_isAttached = true;
    Body done = launch(arguments);
    if (!done) m_isAttached = false;
    return done;
}

Adapter::Body Adapter::configurationDone(const Json&) {
    if (std::exchange(m_isConfigured, true)) return Json();
    applyBreakpoints();
    m_debuggee->begin(protocol::flagAt(m_launched, "stopOnEntry"));
    return Json();
}

Adapter::Body Adapter::restart(const Json& arguments) {
    if (const Json* fresh = protocol::find(arguments, "arguments"); fresh && fresh->is_object()) m_launched = *fresh;
    forget();
    std::unique_ptr<Debuggee> before = std::exchange(m_debuggee, nullptr);
    if (auto loaded = load(m_launched); !loaded) { // the one that runs goes on
        m_debuggee = std::move(before);
        return loaded.error();
    }
    before.reset();
    applyBreakpoints();
    m_debuggee->begin(protocol::flagAt(m_launched, "stopOnEntry"));
    return Json();
}

Adapter::Body Adapter::disconnect(const Json&) {
    forget();
    if (std::exchange(m_debuggee, nullptr)) event("terminated", nullptr);
    m_isOver = true;
    return Json();
}

// ---------------------------------------------------------------- breakpoints

FileId Adapter::fileOf(const std::string& path) const {
    const image::CompiledProgram& program = m_debuggee->program();
    if (const FileId file = debug::fileOfPath(program, path); file.isValid()) return file;
    const std::string& folder = m_debuggee->folder();
    if (!folder.empty()) return debug::fileOfPath(program, fs::path(path).lexically_relative(folder).generic_string());
    for (size_t i = 0; i < program.sources.files.size(); ++i) { // a loose file, or a recording made elsewhere
        const fs::path known(program.sources.files[i].path());
        const std::string ending = "/" + known.lexically_normal().generic_string();
        if (fs::absolute(known).lexically_normal() == path || (m_isAttached && path.ends_with(ending)))
            return FileId(i);
    }
    return {};
}

Json Adapter::place(const std::string& path, const Wanted& wanted, std::vector<debug::Breakpoint>& out) const {
    Json json{{"id", wanted.id}, {"verified", false}, {"line", wanted.line - 1 + m_firstLine}};
    const auto refused = [&](const Message& why) {
        json["message"] = why.english();
        return json;
    };
    debug::Breakpoint breakpoint;
    breakpoint.file = fileOf(path);
    if (!breakpoint.file.isValid()) return refused(errors::NoSuchFileInProgram());
    const debug::SitesOfLine sites = debug::sitesOfLine(m_debuggee->program(), breakpoint.file, wanted.line);
    if (sites.line == 0) return refused(errors::NoStatementThere());
    breakpoint.line = sites.line;
    breakpoint.condition = wanted.condition;
    const std::string& hits = wanted.hits;
    const auto [rest, problem] = std::from_chars(hits.data(), hits.data() + hits.size(), breakpoint.hitCount);
    if (!hits.empty() && (problem != std::errc() || rest != hits.data() + hits.size()))
        return refused(errors::HitsIsNumber());
    out.push_back(breakpoint);
    json["verified"] = true;
    json["line"] = sites.line - 1 + m_firstLine;
    return json;
}

Adapter::Body Adapter::setBreakpoints(const Json& arguments) {
    const auto path = protocol::textAt(arguments, "source.path");
    if (!path) return Error{errors::WrongParameter(Verbatim("setBreakpoints"), Verbatim("source.path")), {}};
    std::vector<Wanted>& wanted = m_wanted[*path];
    wanted.clear();
    Json placed = Json::array();
    std::vector<debug::Breakpoint> ignored;
    const Json* list = protocol::find(arguments, "breakpoints");
    for (const Json& each : list && list->is_array() ? *list : Json::array()) {
        const int64_t line = protocol::integerAt(each, "line").value_or(-1) + 1 - m_firstLine;
        wanted.push_back({line > 0 && line < UINT32_MAX ? static_cast<uint32_t>(line) : 0,
                          protocol::textAt(each, "condition").value_or(""),
                          protocol::textAt(each, "hitCondition").value_or(""), ++m_lastId});
        placed.push_back(place(*path, wanted.back(), ignored));
    }
    applyBreakpoints();
    return Json{{"breakpoints", std::move(placed)}};
}

void Adapter::applyBreakpoints() {
    std::vector<debug::Breakpoint> all;
    for (const auto& [path, list] : m_wanted)
        for (const Wanted& each : list) (void)place(path, each, all);
    m_debuggee->setBreakpoints(std::move(all));
}

Adapter::Body Adapter::setExceptionBreakpoints(const Json&) { return Json(); } // a fault always stops the program

// ---------------------------------------------------------------- moving

void Adapter::forget() {
    m_variables.clear();
    m_frames.reset();
}

Adapter::Body Adapter::goOn(const Json&) {
    if (m_debuggee->isMoving()) return Error{errors::IsRunning(), {}};
    forget();
    m_debuggee->goOn();
    return Json{{"allThreadsContinued", true}};
}

Adapter::Body Adapter::next(const Json&) {
    if (m_debuggee->isMoving()) return Error{errors::IsRunning(), {}};
    forget();
    m_debuggee->step(Step::Over);
    return Json();
}

Adapter::Body Adapter::stepIn(const Json&) {
    if (m_debuggee->isMoving()) return Error{errors::IsRunning(), {}};
    forget();
    m_debuggee->step(Step::In);
    return Json();
}

Adapter::Body Adapter::stepOut(const Json&) {
    if (m_debuggee->isMoving()) return Error{errors::IsRunning(), {}};
    forget();
    m_debuggee->step(Step::Out);
    return Json();
}

Adapter::Body Adapter::pause(const Json&) {
    m_debuggee->pause();
    return Json();
}

Adapter::Body Adapter::stepBack(const Json&) {
    if (m_debuggee->isMoving()) return Error{errors::IsRunning(), {}};
    forget();
    m_debuggee->stepBack();
    return Json();
}

Adapter::Body Adapter::reverseContinue(const Json&) {
    if (m_debuggee->isMoving()) return Error{errors::IsRunning(), {}};
    forget();
    m_debuggee->reverseContinue();
    return Json();
}

void Adapter::work() {
    if (!m_debuggee) return;
    if (const auto stop = m_debuggee->poll()) stopped(*stop);
}

namespace {

const char* reasonOf(Stop::Why why) {
    switch (why) {
    case Stop::Why::Entry:
        return "entry";
    case Stop::Why::Breakpoint:
        return "breakpoint";
    case Stop::Why::Step:
    case Stop::Why::Begin:
        return "step";
    case Stop::Why::Pause:
        return "pause";
    case Stop::Why::Fault:
        return "exception";
    }
    return "step";
}

} // namespace

void Adapter::stopped(const Stop& stop) {
    forget();
    m_stop = stop;
    const std::vector<Frame>& all = frames();
    Json body{{"reason", reasonOf(stop.why)}};
    if (!stop.text.isEmpty()) body["description"] = body["text"] = stop.text.english();
    body["threadId"] = !all.empty() && all.front().task ? *all.front().task + 1 : 1;
    body["allThreadsStopped"] = true;
    event("stopped", std::move(body));
}

} // namespace plc::dap
