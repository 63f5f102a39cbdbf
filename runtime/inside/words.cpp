#include "runtime/inside/words.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace plc::inside {

namespace {

constexpr size_t kLongestStatement = 90;
constexpr uint32_t kDeepestStep = 12;

std::string number(double value) {
    char text[48];
    std::snprintf(text, sizeof text, "%.3f", value);
    std::string shown(text);
    shown.erase(shown.find_last_not_of('0') + 1);
    if (!shown.empty() && shown.back() == '.') shown.pop_back();
    return shown;
}

std::string scanWords(const history::ScanStamp& at) {
    return timeWords(at.time) + " (scan " + std::to_string(at.scan) + ")";
}

} // namespace

std::string timeWords(controller::Nanoseconds time) {
    const auto ns = static_cast<double>(time.count());
    if (std::fabs(ns) < 1e6 && time.count() != 0) return number(ns / 1e3) + " µs";
    if (std::fabs(ns) < 60e9) return number(ns / 1e9) + " s";
    const int64_t minutes = time.count() / 60'000'000'000;
    return std::to_string(minutes) + " min " + number((ns - static_cast<double>(minutes) * 60e9) / 1e9) + " s";
}

std::string blockNote(const Look& look, uint32_t instance, const types::Type& block) {
    const types::TypeTable& types = *look.tree().types;
    const auto read = [&](const char* name) -> std::optional<int64_t> {
        const types::Field* field = block.findField(name);
        if (!field || types.isAggregate(field->type) || types.isText(field->type)) return std::nullopt;
        const size_t offset = instance + field->offset;
        if (offset + types[types.storage(field->type)].size > look.image().size()) return std::nullopt;
        const types::Value value = types::readValue(types, field->type, look.image().subspan(offset), field->bit);
        const auto* integer = std::get_if<int64_t>(&value.data);
        return integer ? std::optional(*integer) : std::nullopt;
    };
    const auto elapsed = read("ET"), preset = read("PT"), counted = read("CV"), target = read("PV"), q = read("Q");
    if (elapsed && preset) {
        const auto in = read("IN");
        if (*elapsed >= *preset && *preset > 0)
            return "its time of " + timeWords(controller::Nanoseconds(*preset)) + " is over";
        if (*elapsed == 0 && in && *in == 0 && (!q || *q == 0)) return "it does not run";
        return "it has run " + timeWords(controller::Nanoseconds(*elapsed)) + " of " +
               timeWords(controller::Nanoseconds(*preset)) + ", " +
               timeWords(controller::Nanoseconds(*preset - *elapsed)) + " to go";
    }
    if (counted && target) return "it has counted " + std::to_string(*counted) + " of " + std::to_string(*target);
    return {};
}

std::string placeWords(const image::CompiledProgram& program, SourceRange range) {
    if (range.file.index() >= program.sources.files.size() || range.end <= range.begin) return {};
    const SourceText& text = program.sources[range.file];
    return text.path() + ":" + std::to_string(text.lineColumn(range.begin).line);
}

std::string statementWords(const image::CompiledProgram& program, SourceRange range) {
    if (range.file.index() >= program.sources.files.size() || range.end <= range.begin) return {};
    std::string shown;
    bool isSpace = false;
    for (const char c : program.sources[range.file].slice(range)) {
        const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
        if (space && isSpace) continue;
        isSpace = space;
        shown += space ? ' ' : c;
        if (shown.size() >= kLongestStatement) return shown + " …";
    }
    return shown;
}

std::string writerWords(const Writer& writer) {
    const std::string from = writer.origin.empty() ? std::string() : " from " + writer.origin;
    switch (writer.kind) {
    case WriterKind::Statement: {
        std::string text = "set by " + statementWords(*writer.program, writer.range);
        if (const std::string place = placeWords(*writer.program, writer.range); !place.empty()) text += "  " + place;
        const std::string who = writer.instance.empty() ? writer.function : writer.instance;
        text += " (" + who + (writer.task.empty() ? "" : ", task " + writer.task) + ")";
        return text;
    }
    case WriterKind::Written:
        return "written" + (from.empty() ? " from outside" : from);
    case WriterKind::Forced:
        return "forced" + from;
    case WriterKind::Reset:
        return "put back by a reset";
    case WriterKind::OnlineChange:
        return "carried over by an online change";
    case WriterKind::Retain:
        return "restored from the retained values";
    case WriterKind::Initial:
        return "its initial value";
    case WriterKind::SafeState:
        return "put into the safe state when the controller stopped";
    case WriterKind::Resumed:
        return "as recorded in the scan that was resumed from";
    case WriterKind::Test:
        return "set by a statement of a test";
    case WriterKind::Unknown:
        break;
    }
    return "not known who set it";
}

std::string toText(const Writer& writer) {
    std::string text = scanWords(writer.at) + "  " + writer.path;
    if (!writer.before.empty()) text += " from " + writer.before;
    if (!writer.value.empty()) text += " to " + writer.value;
    text += ", " + writerWords(writer) + "\n";
    for (size_t i = 1; i < writer.calls.size(); ++i) {
        const CallStep& call = writer.calls[i];
        text += "    called by " + statementWords(*writer.program, call.range);
        if (const std::string place = placeWords(*writer.program, call.range); !place.empty()) text += "  " + place;
        text += "\n";
    }
    return text;
}

namespace {

void addPart(std::string& text, const Part& part, bool isTrigger, uint32_t depth) {
    const std::string indent(2 + 2 * depth, ' ');
    if (part.isClock) {
        text += indent + "time passed.\n";
        return;
    }
    text += indent + part.path;
    if (part.value.empty())
        text += " changed";
    else
        text += (isTrigger ? " became " : " was ") + part.value;
    if (part.writer) {
        text += isTrigger ? "" : " since " + timeWords(part.writer->at.time);
        text += ", " + writerWords(*part.writer);
    }
    text += ".\n";
    if (!part.because.empty()) {
        text += indent + "  because\n";
        for (const Part& deeper : part.because) addPart(text, deeper, true, depth + 2);
    }
}

void addSteps(std::string& text, const image::CompiledProgram& program, const std::vector<Step>& steps,
              uint32_t depth) {
    if (depth > kDeepestStep) return;
    const std::string indent(2 + 2 * depth, ' ');
    const auto shown = [&](const types::Value& value) {
        return value.hasValue() ? types::toText(*program.layout.types, value) : std::string();
    };
    for (const Step& step : steps) {
        const std::string value = shown(step.value);
        std::string line;
        const bool isNamed = step.kind == Step::Kind::Leaf || step.kind == Step::Kind::Block ||
                             !statementWords(program, step.range).empty();
        if (!isNamed) { // made by the compiler
            addSteps(text, program, step.steps, depth);
            continue;
        }
        switch (step.kind) {
        case Step::Kind::Statement:
            line = statementWords(program, step.range) + "   → " + value;
            break;
        case Step::Kind::Guard:
            line = "it ran because " + statementWords(program, step.range) + " was " + value;
            break;
        case Step::Kind::NotReset:
            line = "nothing wrote it later because " + statementWords(program, step.range) + " was " + value;
            break;
        case Step::Kind::Blocked:
            line = "a statement that would write it did not run because " + statementWords(program, step.range) +
                   " was " + value;
            break;
        case Step::Kind::Block:
            line = (step.path.empty() ? step.function : step.path + " (" + step.blockType + ")") +
                   (step.note.empty() ? "" : ": " + step.note);
            break;
        case Step::Kind::Leaf:
            if (step.path.empty() || step.isInternal) continue;
            line = step.path + " was " + value + " when the scan began";
            break;
        }
        if (const std::string place = placeWords(program, step.range); !place.empty()) line += "   " + place;
        text += indent + line + "\n";
        addSteps(text, program, step.steps, depth + 1);
    }
}

} // namespace

std::string toText(const Explanation& answer) {
    std::string text = answer.question.text + " is " + answer.value + " at " + scanWords(answer.asked);
    text +=
        answer.isSinceBegin ? ", as it was when the recording began.\n" : ", since " + scanWords(answer.since) + ".\n";
    if (answer.writer) {
        const bool isInitial = answer.writer->kind == WriterKind::Initial;
        text += (isInitial ? "It has " : "It was ") + writerWords(*answer.writer) + ".\n";
        for (size_t i = 1; i < answer.writer->calls.size(); ++i) {
            const CallStep& call = answer.writer->calls[i];
            text += "  called by " + statementWords(*answer.writer->program, call.range) + "   " +
                    placeWords(*answer.writer->program, call.range) + "\n";
        }
    }
    if (!answer.triggers.empty()) {
        text += "It became " + answer.value + " because\n";
        for (const Part& part : answer.triggers) addPart(text, part, true, 0);
    }
    if (!answer.enablers.empty()) {
        text += answer.triggers.empty() ? "It needs\n" : "This needed\n";
        for (const Part& part : answer.enablers) addPart(text, part, false, 0);
    }
    if (!answer.holding.empty()) {
        text += "It stays so because\n";
        for (const Part& part : answer.holding) addPart(text, part, false, 0);
    }
    if (!answer.steps.empty()) {
        text += "Step by step\n";
        addSteps(text, *answer.program, answer.steps, 0);
    }
    if (!answer.doubt.empty()) text += "Note: " + answer.doubt + ".\n";
    return text;
}

std::string toText(const WhyNot& answer) {
    std::string text = answer.question.text + " is " + answer.value + " at " + scanWords(answer.asked) + ".\n";
    if (answer.ways.empty())
        text += "No change of up to three variables makes it " + answer.wanted + " in this scan.\n";
    for (size_t i = 0; i < answer.ways.size(); ++i) {
        text += i == 0 ? "It would be " + answer.wanted + " if " : "or if ";
        for (size_t k = 0; k < answer.ways[i].size(); ++k) {
            const Change& change = answer.ways[i][k];
            text += (k == 0 ? "" : " and ") + change.path + " were " + change.to + " (it is " + change.from + ")";
        }
        text += i + 1 < answer.ways.size() ? ",\n" : ".\n";
    }
    if (!answer.steps.empty()) {
        text += "What keeps it " + answer.value + "\n";
        addSteps(text, *answer.program, answer.steps, 0);
    }
    if (!answer.doubt.empty()) text += "Note: " + answer.doubt + ".\n";
    return text;
}

} // namespace plc::inside
