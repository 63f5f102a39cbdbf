#include "app/cli/run/inside_output.h"

#include "app/cli/kit/command.h"
#include "app/cli/kit/errors.h"
#include "projects/session/versions.h"
#include "runtime/inside/words.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace plc::cli {

using inside::Reason;
using Json = nlohmann::ordered_json;

namespace {

Json stampJson(const history::ScanStamp& at) {
    return {{"scan", at.scan}, {"time_s", static_cast<double>(at.time.count()) / 1e9}};
}

void addPlace(Json& json, const image::CompiledProgram& program, SourceRange range) {
    const std::string place = inside::placeWords(program, range);
    if (place.empty()) return;
    json["at"] = place;
    json["text"] = inside::statementWords(program, range);
}

const char* word(inside::WriterKind kind) {
    using inside::WriterKind;
    switch (kind) {
    case WriterKind::Statement:
        return "statement";
    case WriterKind::Written:
        return "written";
    case WriterKind::Forced:
        return "forced";
    case WriterKind::Reset:
        return "reset";
    case WriterKind::OnlineChange:
        return "online change";
    case WriterKind::Retain:
        return "retain";
    case WriterKind::Initial:
        return "initial value";
    case WriterKind::SafeState:
        return "safe state";
    case WriterKind::Resumed:
        return "resumed";
    case WriterKind::Test:
        return "test";
    case WriterKind::Unknown:
        break;
    }
    return "unknown";
}

Json writerJson(const inside::Writer& writer) {
    Json json{{"kind", word(writer.kind)}, {"path", writer.path}};
    json.update(stampJson(writer.at));
    if (!writer.before.empty()) json["from"] = writer.before;
    if (!writer.value.empty()) json["to"] = writer.value;
    if (!writer.origin.empty()) json["origin"] = writer.origin;
    if (writer.kind != inside::WriterKind::Statement) return json;
    addPlace(json, *writer.program, writer.range);
    json["function"] = writer.function;
    json["instance"] = writer.instance;
    json["task"] = writer.task;
    Json calls = Json::array();
    for (const inside::CallStep& call : writer.calls) {
        Json step{{"function", call.function}, {"instance", call.instance}};
        addPlace(step, *writer.program, call.range);
        calls.push_back(std::move(step));
    }
    json["calls"] = std::move(calls);
    return json;
}

Json partsJson(const std::vector<inside::Part>& parts) {
    Json all = Json::array();
    for (const inside::Part& part : parts) {
        Json json{{"path", part.isClock       ? "time"
                           : part.isFirstScan ? "first scan"
                           : part.isForces    ? "forces"
                                              : part.path}};
        if (!part.value.empty()) json["value"] = part.value;
        if (!part.before.empty()) json["before"] = part.before;
        if (!part.condition.empty()) json["condition"] = part.condition;
        json["verified"] = part.isVerified;
        if (part.writer) json["writer"] = writerJson(*part.writer);
        if (!part.because.empty()) json["because"] = partsJson(part.because);
        all.push_back(std::move(json));
    }
    return all;
}

Json stepsJson(const image::CompiledProgram& program, const std::vector<Reason>& steps) {
    static constexpr const char* kKinds[] = {"statement", "guard", "not reset", "blocked", "block", "variable"};
    Json all = Json::array();
    for (const Reason& step : steps) {
        if (step.kind == Reason::Kind::Leaf && step.path.empty()) continue;
        Json json{{"kind", kKinds[static_cast<size_t>(step.kind)]}};
        if (!step.path.empty()) json["path"] = step.path;
        if (step.value.hasValue()) json["value"] = types::toText(*program.layout.types, step.value);
        if (!step.note.isEmpty()) json["note"] = step.note.english();
        if (!step.instance.empty()) json["instance"] = step.instance;
        addPlace(json, program, step.range);
        if (!step.steps.empty()) json["steps"] = stepsJson(program, step.steps);
        all.push_back(std::move(json));
    }
    return all;
}

} // namespace

std::string toJson(const inside::Writer& writer) { return writerJson(writer).dump(); }

std::string toJson(const inside::Explanation& answer) {
    Json json{{"question", answer.question.text}, {"value", answer.value}};
    json["asked"] = stampJson(answer.asked);
    json["since"] = stampJson(answer.since);
    json["since_begin"] = answer.isSinceBegin;
    if (answer.writer) json["writer"] = writerJson(*answer.writer);
    json["triggers"] = partsJson(answer.triggers);
    json["enablers"] = partsJson(answer.enablers);
    json["holding"] = partsJson(answer.holding);
    json["steps"] = stepsJson(*answer.program, answer.steps);
    if (!answer.doubt.isEmpty()) json["doubt"] = answer.doubt.english();
    return json.dump();
}

std::string toJson(const inside::WhyNot& answer) {
    Json json{{"question", answer.question.text}, {"value", answer.value}, {"wanted", answer.wanted}};
    json["asked"] = stampJson(answer.asked);
    Json ways = Json::array();
    for (const std::vector<inside::Change>& way : answer.ways) {
        Json changes = Json::array();
        for (const inside::Change& change : way)
            changes.push_back({{"path", change.path}, {"from", change.from}, {"to", change.to}});
        ways.push_back(std::move(changes));
    }
    json["ways"] = std::move(ways);
    json["steps"] = stepsJson(*answer.program, answer.steps);
    if (!answer.doubt.isEmpty()) json["doubt"] = answer.doubt.english();
    return json.dump();
}

// ---------------------------------------------------------------- a whole scan

namespace {

/// One line of a scan: a statement that ran, with what it used and wrote.
struct Line {
    SourceRange range;
    uint32_t activation = 0;
    std::vector<uint64_t> passes;
    std::vector<std::string> values; // "S1 = TRUE"
    std::vector<std::string> writes; // "K1 := TRUE"
};

bool isRead(const inside::Event& event) {
    using image::WatchKind;
    return (event.kind == WatchKind::Value || event.kind == WatchKind::Text) &&
           event.expr()->kind == tree::ExprKind::Load;
}

std::vector<Line> linesOf(const inside::Look& look) {
    using image::WatchKind;
    const types::TypeTable& types = *look.program().layout.types;
    std::vector<Line> lines;
    std::vector<size_t> open(look.activations().size(), SIZE_MAX); // the line that runs in each
    const auto shown = [&](const inside::Event& event) { return types::toText(types, look.valueOf(event)); };
    for (inside::EventIndex i = 0; i < look.events().size(); ++i) {
        const inside::Event& event = look.events()[i];
        if (event.kind == WatchKind::Statement) {
            const tree::Stmt& stmt = *event.stmt();
            const bool isNamed = !inside::placeWords(look.program(), stmt.range).empty();
            if (!isNamed) continue;
            // The call of a block is several statements of one text.
            const size_t before = open[event.activation];
            if (before != SIZE_MAX && lines[before].range == stmt.range && lines[before].passes == look.passesAt(i))
                continue;
            open[event.activation] = lines.size();
            lines.push_back({stmt.range, event.activation, look.passesAt(i), {}, {}});
            continue;
        }
        if (open[event.activation] == SIZE_MAX) continue;
        Line& line = lines[open[event.activation]];
        if (isRead(event)) {
            const std::string name = inside::statementWords(look.program(), event.expr()->range);
            const std::string text = name + " = " + shown(event);
            if (!name.empty() && std::find(line.values.begin(), line.values.end(), text) == line.values.end())
                line.values.push_back(text);
        }
        if (event.kind == WatchKind::Write && event.node && event.offset < look.program().layout.dataEnd) {
            const types::Value value = look.valueOf(event);
            const image::Place place{event.stmt()->place ? event.stmt()->place->type : types::TypeId(), event.offset,
                                     event.bit};
            if (!value.hasValue() || !place.type.isValid()) continue;
            line.writes.push_back(inside::nameOf(look.program().layout, place) + " := " + types::toText(types, value));
        }
    }
    return lines;
}

std::string joined(const std::vector<std::string>& parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
    return text;
}

uint32_t depthOf(const inside::Look& look, uint32_t activation) {
    uint32_t depth = 0;
    for (; look.activations()[activation].parent != inside::kNone; activation = look.activations()[activation].parent)
        ++depth;
    return depth;
}

} // namespace

std::string insideText(const inside::Look& look) {
    std::string text = "scan " + std::to_string(look.input().stamp.scan) + " at " +
                       inside::timeWords(look.input().stamp.time).english() +
                       (look.isExact() ? ", run again exactly as recorded" : ", NOT as recorded") + "\n";
    for (const inside::Difference& difference : look.differences())
        text += "  differs: " + (difference.path.empty() ? std::to_string(difference.offset) : difference.path) + "\n";
    if (!look.doubt().isEmpty()) text += "  " + look.doubt().english() + "\n";
    uint32_t activation = inside::kNone;
    for (const Line& line : linesOf(look)) {
        if (line.activation != activation) {
            activation = line.activation;
            const inside::Activation& a = look.activations()[activation];
            text += std::string(2 * depthOf(look, activation), ' ') + look.program().functions[a.function].name;
            const std::string instance = look.instanceOf(activation);
            if (!instance.empty()) text += " on " + instance;
            if (a.parent == inside::kNone && a.task != inside::kNone)
                text += ", task " + look.program().tasks[a.task].name;
            text += "\n";
        }
        text += std::string(2 * depthOf(look, activation) + 2, ' ') + inside::placeWords(look.program(), line.range) +
                "  " + inside::statementWords(look.program(), line.range);
        for (const uint64_t pass : line.passes) text += "  pass " + std::to_string(pass + 1);
        if (!line.values.empty()) text += "   { " + joined(line.values) + " }";
        if (!line.writes.empty()) text += "   → " + joined(line.writes);
        text += "\n";
    }
    if (look.leftOut() > 0) text += std::to_string(look.leftOut()) + " reports more are left out\n";
    return text;
}

std::string insideJson(const inside::Look& look) {
    Json json = stampJson(look.input().stamp);
    json["exact"] = look.isExact();
    Json lines = Json::array();
    for (const Line& line : linesOf(look)) {
        Json one{{"at", inside::placeWords(look.program(), line.range)},
                 {"text", inside::statementWords(look.program(), line.range)},
                 {"instance", look.instanceOf(line.activation)}};
        if (!line.passes.empty()) one["passes"] = line.passes;
        one["values"] = line.values;
        one["writes"] = line.writes;
        lines.push_back(std::move(one));
    }
    json["statements"] = std::move(lines);
    json["left_out"] = look.leftOut();
    return json.dump();
}

// ---------------------------------------------------------------- recordings

Result<history::Position> positionOf(const history::History& history, const std::string& text) {
    const bool isNumber =
        !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (isNumber) {
        const auto scan = parseCount(text);
        if (!scan) return scan.error();
        const auto found = history.positionOfScan(*scan);
        if (!found) return Error{errors::NoScanOfNumber(), text};
        return *found;
    }
    const auto time = parseDuration(text);
    if (!time) return Error{errors::OrScanNumber(time.error().message), text};
    const auto found = history.positionAt(*time);
    if (!found) return Error{errors::NoScanBefore(text), text};
    return *found;
}

Result<std::unique_ptr<history::History>> openRecording(const std::string& path) {
    Message failure;
    auto loaded = history::History::load(path, [&](const history::History::Sources& sources) {
        driver::Built built = driver::build(session::recordedInput(sources));
        if (!built.program) failure = built.failure.isEmpty() ? errors::RecordedProgramHasErrors() : built.failure;
        return std::shared_ptr<const image::CompiledProgram>(built.program);
    });
    if (!loaded && !failure.isEmpty()) return Error{errors::RecordingNotOpened(failure), path};
    return loaded;
}

} // namespace plc::cli
