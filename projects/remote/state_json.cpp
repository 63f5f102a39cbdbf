#include "projects/remote/state_json.h"

#include "projects/session/value_text.h"
#include "projects/session/versions.h"
#include "runtime/base/messages.h"

namespace plc::remote {

namespace {

constexpr const char* kStates[] = {"stopped", "running", "paused", "halted", "fault"};

Message plainly(const std::string& text) { return text.empty() ? Message() : errors::Plainly(text); }

bool boolAt(const Json& json, const char* key) {
    const auto it = json.find(key);
    return it != json.end() && it->is_boolean() && it->get<bool>();
}

double realAt(const Json& json, const char* key) {
    const auto it = json.find(key);
    return it != json.end() && it->is_number() ? it->get<double>() : 0;
}

int64_t signedAt(const Json& json, const char* key) {
    const auto it = json.find(key);
    return it != json.end() && it->is_number_integer() ? it->get<int64_t>() : 0;
}

const Json& listAt(const Json& json, const char* key) {
    static const Json none = Json::array();
    const auto it = json.find(key);
    return it != json.end() && it->is_array() ? *it : none;
}

Json placeJson(SourceRange range) {
    return range.file.isValid() ? Json::array({range.file.value, range.begin, range.end}) : Json();
}

SourceRange readPlace(const Json& json, const char* key, const image::CompiledProgram& program) {
    const Json& list = listAt(json, key);
    for (const Json& each : list)
        if (!each.is_number_unsigned()) return {};
    if (list.size() != 3 || list[0].get<uint64_t>() >= program.sources.files.size()) return {};
    const FileId file(list[0].get<uint32_t>());
    const size_t length = program.sources[file].text().size();
    const auto begin = list[1].get<uint64_t>(), end = list[2].get<uint64_t>();
    if (begin > end || end > length) return {};
    return {file, static_cast<uint32_t>(begin), static_cast<uint32_t>(end)};
}

Json framesJson(const std::vector<controller::FaultFrame>& frames) {
    Json out = Json::array();
    for (const controller::FaultFrame& frame : frames)
        out.push_back({{"function", frame.function},
                       {"instance", frame.instance},
                       {"place", placeJson(frame.range)},
                       {"at", {frame.instanceOffset, frame.frameOffset, frame.functionIndex}}});
    return out;
}

/// Offsets that are not of this program would be read outside the image.
std::vector<controller::FaultFrame> readFrames(const Json& json, const char* key,
                                               const image::CompiledProgram& program) {
    std::vector<controller::FaultFrame> out;
    for (const Json& each : listAt(json, key)) {
        const Json& at = each.is_object() ? listAt(each, "at") : listAt(json, "");
        if (at.size() != 3 || !at[0].is_number_unsigned() || !at[1].is_number_unsigned() || !at[2].is_number_unsigned())
            continue;
        const auto instance = at[0].get<uint64_t>(), frame = at[1].get<uint64_t>(), function = at[2].get<uint64_t>();
        if (instance >= program.layout.imageSize || function >= program.functions.size()) continue;
        if (frame + program.functions[function].frameSize > program.layout.imageSize) continue;
        out.push_back({textAt(each, "function"), textAt(each, "instance"), readPlace(each, "place", program),
                       static_cast<uint32_t>(instance), static_cast<uint32_t>(frame), static_cast<uint32_t>(function)});
    }
    return out;
}

Json faultJson(const std::optional<controller::Fault>& fault) {
    if (!fault) return {};
    return {{"code", static_cast<uint32_t>(fault->code)},
            {"text", fault->message.english()},
            {"task", fault->task},
            {"place", placeJson(fault->range)},
            {"calls", framesJson(fault->calls)},
            {"scan", fault->scan},
            {"time_ns", fault->time.count()},
            {"simulation", fault->isSimulation}};
}

std::optional<controller::Fault> readFault(const Json& json, const char* key, const image::CompiledProgram& program) {
    const auto it = json.find(key);
    if (it == json.end() || !it->is_object()) return {};
    controller::Fault fault;
    const uint64_t code = numberAt(*it, "code");
    if (code <= static_cast<uint64_t>(image::FaultCode::ValueOutOfRange)) fault.code = image::FaultCode(code);
    fault.message = plainly(textAt(*it, "text"));
    fault.task = textAt(*it, "task");
    fault.range = readPlace(*it, "place", program);
    fault.calls = readFrames(*it, "calls", program);
    fault.scan = numberAt(*it, "scan");
    fault.time = session::Nanoseconds(signedAt(*it, "time_ns"));
    fault.isSimulation = boolAt(*it, "simulation");
    return fault;
}

Json tasksJson(const session::Session& session) {
    Json out = Json::array();
    for (const controller::TaskStatistics& task : session.taskStatistics())
        out.push_back({{"name", task.name},
                       {"count", task.count},
                       {"overruns", task.overruns},
                       {"last_ns", task.lastNs},
                       {"min_ns", task.minNs},
                       {"max_ns", task.maxNs},
                       {"mean_ns", task.meanNs},
                       {"jitter_ns", task.jitterNs},
                       {"histogram", task.histogram}});
    return out;
}

controller::TaskStatistics readTask(const Json& json) {
    controller::TaskStatistics task;
    task.name = textAt(json, "name");
    task.count = numberAt(json, "count");
    task.overruns = numberAt(json, "overruns");
    task.lastNs = signedAt(json, "last_ns");
    task.minNs = signedAt(json, "min_ns");
    task.maxNs = signedAt(json, "max_ns");
    task.meanNs = realAt(json, "mean_ns");
    task.jitterNs = signedAt(json, "jitter_ns");
    constexpr size_t kMost = 64;
    for (const Json& each : listAt(json, "histogram"))
        if (each.is_number_unsigned() && task.histogram.size() < kMost) task.histogram.push_back(each.get<uint32_t>());
    return task;
}

std::vector<std::pair<std::string, std::string>> readPairs(const Json& list) {
    std::vector<std::pair<std::string, std::string>> out;
    for (const Json& each : list)
        if (each.is_array() && each.size() == 2 && each[0].is_string() && each[1].is_string())
            out.emplace_back(each[0].get<std::string>(), each[1].get<std::string>());
    return out;
}

} // namespace

const char* nameOf(controller::State state) { return kStates[static_cast<size_t>(state)]; }

std::string textAt(const Json& json, const char* key) {
    if (!json.is_object()) return {};
    const auto it = json.find(key);
    return it != json.end() && it->is_string() ? it->get<std::string>() : std::string();
}

uint64_t numberAt(const Json& json, const char* key) {
    if (!json.is_object()) return 0;
    const auto it = json.find(key);
    return it != json.end() && it->is_number_unsigned() ? it->get<uint64_t>() : 0;
}

Json stateJson(const session::Session& session) {
    const session::Status status = session.status();
    const types::TypeTable& types = *session.program()->layout.types;
    Json forces = Json::array();
    for (const controller::Forced& forced : session.forces())
        forces.push_back({forced.path, types::toText(types, forced.value)});
    return {{"state", nameOf(status.state)},
            {"scans", status.scans},
            {"time_ns", status.time.count()},
            {"load", status.load},
            {"last_scan_ns", status.lastScanNs},
            {"skipped", status.skippedScans},
            {"halts", status.halts},
            {"fault", faultJson(status.fault)},
            {"simulation_fault", faultJson(status.simulationFault)},
            {"retain_problem", status.retainProblem.english()},
            {"forces", forces},
            {"tasks", tasksJson(session)},
            {"frames", framesJson(session.haltFrames())},
            {"halt_problem", session.haltProblem().english()}};
}

session::Mirror::Figures readState(const Json& json, const driver::Built& built) {
    const image::CompiledProgram& program = *built.program;
    session::Mirror::Figures out;
    const std::string state = textAt(json, "state");
    for (size_t i = 0; i < std::size(kStates); ++i)
        if (state == kStates[i]) out.status.state = static_cast<controller::State>(i);
    out.status.scans = numberAt(json, "scans");
    out.status.time = session::Nanoseconds(signedAt(json, "time_ns"));
    out.status.load = realAt(json, "load");
    out.status.lastScanNs = signedAt(json, "last_scan_ns");
    out.status.skippedScans = numberAt(json, "skipped");
    out.status.halts = numberAt(json, "halts");
    out.status.fault = readFault(json, "fault", program);
    out.status.simulationFault = readFault(json, "simulation_fault", program);
    out.status.retainProblem = plainly(textAt(json, "retain_problem"));
    for (const auto& [path, text] : readPairs(listAt(json, "forces"))) {
        const auto place = program.layout.find(path);
        if (!place) continue;
        auto value = session::parseValue(built.checked, place->type, text, path);
        if (value) out.forces.push_back({path, *place, std::move(*value)});
    }
    for (const Json& task : listAt(json, "tasks"))
        if (task.is_object()) out.tasks.push_back(readTask(task));
    out.frames = readFrames(json, "frames", program);
    out.haltProblem = plainly(textAt(json, "halt_problem"));
    return out;
}

Json eventJson(const controller::Event& event) {
    return {{"kind", static_cast<int>(event.kind)},
            {"scan", event.scan},
            {"time_ns", event.time.count()},
            {"text", event.text.english()}};
}

controller::Event readEvent(const Json& json) {
    controller::Event out;
    const uint64_t kind = numberAt(json, "kind");
    if (kind <= static_cast<uint64_t>(controller::EventKind::WentBack)) out.kind = controller::EventKind(kind);
    out.scan = numberAt(json, "scan");
    out.time = session::Nanoseconds(signedAt(json, "time_ns"));
    out.text = plainly(textAt(json, "text"));
    return out;
}

Json sourcesJson(const driver::BuildInput& input) {
    Json files = Json::array(), libraries = Json::array();
    for (const driver::SourceFile& file : input.files) files.push_back({file.path, file.text});
    for (const auto& [name, text] : driver::libraryTexts(input)) libraries.push_back({name, text});
    return {{"files", files}, {"settings", driver::recordedSettings(input)}, {"library_texts", libraries}};
}

driver::BuildInput readSources(const Json& json) {
    history::History::Sources sources;
    sources.files = readPairs(listAt(json, "files"));
    for (const Json& each : listAt(json, "settings"))
        if (each.is_string()) sources.libraries.push_back(each.get<std::string>());
    sources.libraryTexts = readPairs(listAt(json, "library_texts"));
    return session::recordedInput(sources);
}

uint64_t layoutSum(const image::CompiledProgram& program) {
    uint64_t sum = 14695981039346656037ull;
    const auto add = [&](std::string_view bytes) {
        for (const char c : bytes) sum = (sum ^ static_cast<unsigned char>(c)) * 1099511628211ull;
        sum = (sum ^ bytes.size()) * 1099511628211ull;
    };
    const auto number = [&](uint64_t value) { add(std::to_string(value)); };
    const image::Layout& layout = program.layout;
    number(layout.imageSize);
    number(layout.dataEnd);
    for (const image::Root& root : layout.roots) {
        add(root.list);
        add(root.name);
        add((*layout.types)[root.type].name);
        number(root.offset);
    }
    for (const image::FunctionInfo& function : program.functions) {
        add(function.name);
        number(function.frameSize);
    }
    return sum;
}

} // namespace plc::remote
