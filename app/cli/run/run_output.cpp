#include "app/cli/run/run_output.h"

#include "app/cli/kit/command.h"
#include "app/cli/kit/errors.h"
#include "runtime/image/variable_tree.h"
#include "runtime/platform/streams.h"
#include "runtime/types/conversion.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace plc::cli {

using types::Value;

namespace {
/// Of the project itself, not of a library.
bool isOfProject(const driver::Built& built, const image::Root& root) {
    if (root.space.empty()) return true;
    const std::string& file =
        root.declaration.file.isValid() ? built.program->sources[root.declaration.file].path() : root.space;
    return std::any_of(built.input->files.begin(), built.input->files.end(),
                       [&](const driver::SourceFile& source) { return source.path == file; });
}
} // namespace

std::vector<Watch> allVariables(const driver::Built& built) {
    std::vector<Watch> out;
    const auto add = [&](const image::VariableNode& node) {
        if (node.isConstant || node.isInOut) return;
        if (auto expression = driver::compileExpression(built.checked, node.path))
            out.push_back({node.path, *expression, kLargestListed});
    };
    const image::VariableTree tree(built.program->layout);
    for (const image::VariableNode& node : tree.declared()) {
        if (!isOfProject(built, *node.root)) continue;
        if (node.kind != image::VariableKind::Program)
            add(node);
        else
            for (const image::VariableNode& member : tree.members(node)) add(member);
    }
    return out;
}

Result<std::optional<int64_t>> calendarStart(const std::string& text) {
    if (text.empty()) return std::optional<int64_t>();
    int year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0;
    const char* begin = text.c_str();
    if (const char* hash = std::strchr(begin, '#')) begin = hash + 1;
    const int fields = std::sscanf(begin, "%d-%d-%d%*[-T ]%d:%d:%d", &year, &month, &day, &hour, &minute, &second);
    if ((fields != 3 && fields != 5 && fields != 6) || !types::isValidDate({year, month, day}) || hour < 0 ||
        hour > 23 || minute < 0 || minute > 59 || second < 0 || second > 59)
        return Error{errors::NotADateAndTime(text), ""};
    return std::optional<int64_t>(((types::daysFromCivil({year, month, day}) * 24 + hour) * 60 + minute) *
                                      60'000'000'000 +
                                  second * 1'000'000'000ll);
}

std::string csvValue(const types::TypeTable& types, const Value& value) {
    if (!value.hasValue()) return {};
    if (types.isText(value.type) || types.family(value.type) == types::Family::Character) {
        std::string json = types::toJson(types, value);
        return json.size() >= 2 && json.front() == '"' ? nlohmann::json::parse(json, nullptr, false).get<std::string>()
                                                       : json;
    }
    return types::toText(types, value);
}

std::string csvCell(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"') out += '"';
        out += c;
    }
    return out + '"';
}

std::string secondsText(std::chrono::nanoseconds time) {
    const int64_t ns = time.count();
    std::string out = std::to_string(ns / 1'000'000'000);
    std::string fraction = std::to_string(ns % 1'000'000'000);
    fraction.insert(0, 9 - fraction.size(), '0');
    while (!fraction.empty() && fraction.back() == '0') fraction.pop_back();
    return fraction.empty() ? out : out + "." + fraction;
}

namespace {
/// The value in the image, unless it is too large to be of use to anybody.
expression::Outcome shownValue(const Watch& watch, std::span<const std::byte> image) {
    if (!watch.expression.type().isValid()) return watch.expression.evaluate(image); // not of this version
    const types::Type& type = watch.expression.types()[watch.expression.type()];
    if (type.size <= watch.largest) return watch.expression.evaluate(image);
    expression::Outcome outcome;
    outcome.reason = errors::TooLargeToShow(type.size);
    return outcome;
}
} // namespace

CsvWriter::~CsvWriter() {
    if (m_file) (void)close();
}

Result<void> CsvWriter::open(const std::string& path) {
    m_path = path;
    std::error_code ignored;
    const bool isOutput = path == "-";
    m_isDirect =
        isOutput || (std::filesystem::exists(m_path, ignored) && !std::filesystem::is_regular_file(m_path, ignored));
    if (std::filesystem::is_directory(m_path, ignored)) return Error{errors::CsvNotWritten(errors::IsAFolder()), path};
    m_file =
        isOutput ? platform::openStandardOutput() : std::fopen((m_path + (m_isDirect ? "" : ".part")).c_str(), "wb");
    if (!m_file) return Error{errors::CsvNotWritten(errors::ofSystem(errno)), path};
    std::string head = "time_s,scan";
    for (const Watch& watch : m_watches) head += "," + csvCell(watch.text);
    head += "\r\n";
    std::fwrite(head.data(), 1, head.size(), m_file);
    return {};
}

void CsvWriter::row(std::span<const std::byte> image, uint64_t scan, std::chrono::nanoseconds time) {
    if (!m_file) return;
    std::string line = secondsText(time) + "," + std::to_string(scan);
    for (const Watch& watch : m_watches) {
        const expression::Outcome outcome = shownValue(watch, image);
        line += "," + (outcome.hasValue() ? csvCell(csvValue(watch.expression.types(), outcome.value)) : std::string());
    }
    line += "\r\n";
    std::fwrite(line.data(), 1, line.size(), m_file);
}

void CsvWriter::scanFinished(const controller::Controller& controller) {
    if (!m_file) return;
    const auto time = controller.lastTime();
    if (m_interval.count() > 0) {
        if (m_next && time < *m_next) return;
        m_next = m_interval * (time / m_interval + 1);
    }
    row(controller.image(), controller.nextScan() - 1, time);
}

Result<void> CsvWriter::close() {
    if (!m_file) return {};
    const bool bad = std::fflush(m_file) != 0 || std::ferror(m_file);
    const int code = errno;
    std::fclose(m_file);
    m_file = nullptr;
    const std::string part = m_path + ".part";
    if (bad) {
        if (!m_isDirect) std::remove(part.c_str());
        return Error{errors::CsvNotWritten(errors::ofSystem(code)), m_path};
    }
    if (m_isDirect) return {};
    if (std::rename(part.c_str(), m_path.c_str()) != 0)
        return Error{errors::CsvNotReplaced(errors::ofSystem(errno)), m_path};
    return {};
}

namespace {
std::string placeText(const driver::Built& built, SourceRange range) {
    if (!range.file.isValid()) return {};
    const SourceText& file = built.program->sources[range.file];
    return file.path() + ":" + std::to_string(file.lineColumn(range.begin).line);
}
std::string valueText(const types::TypeTable& types, const expression::Outcome& outcome) {
    return outcome.hasValue() ? types::toText(types, outcome.value) : "(" + outcome.reason.english() + ")";
}
} // namespace

std::string RunReport::toText(bool colours) const {
    std::string out;
    size_t width = 0;
    for (const Watch& watch : watches) width = std::max(width, watch.text.size());
    for (const Watch& watch : watches) {
        std::string name = watch.text;
        name.resize(width + 2, ' ');
        out += name + valueText(watch.expression.types(), shownValue(watch, controller.image())) + "\n";
    }
    const auto& fault = controller.fault();
    if (fault) {
        out += (colours ? std::string("\033[1;31m") : std::string()) + "fault" + (colours ? "\033[0m" : "") + ": " +
               fault->message.english() + "\n";
        const std::string place = " at " + placeText(built, fault->range);
        if (fault->task.empty()) // before the first scan no task runs
            out += "  while initial values were applied," + place + "\n";
        else
            out += "  in task " + fault->task + place + ", scan " + std::to_string(fault->scan) + ", " +
                   types::durationText(fault->time.count()) + "\n";
        constexpr size_t kFirst = 12, kLast = 4; // of a recursion the ends tell what the middle repeats
        const size_t count = fault->calls.size();
        for (size_t i = 0; i < count; ++i) {
            if (i == kFirst && count > kFirst + kLast + 1) {
                i = count - kLast;
                out += "  … " + std::to_string(i - kFirst) + " more calls …\n";
            }
            const controller::FaultFrame& frame = fault->calls[i];
            if (!frame.range.file.isValid()) continue; // what the compiler adds
            out += "  " + frame.function + (frame.instance.empty() ? "" : " (" + frame.instance + ")") + " at " +
                   placeText(built, frame.range) + "\n";
        }
    }
    if (controller.simulationFault())
        out += "simulation stopped: " + controller.simulationFault()->message.english() + " at " +
               placeText(built, controller.simulationFault()->range) + "\n";
    out += std::to_string(controller.nextScan()) + " scans, last at " +
           types::durationText(controller.lastTime().count()) + "\n";
    if (!withStatistics) return out;
    char line[200];
    std::snprintf(line, sizeof line, "build: %.1f ms (check %.1f ms, code %.1f ms)\n", built.checkMs + built.codeMs,
                  built.checkMs, built.codeMs);
    out += line;
    for (const controller::TaskStatistics& task : controller.statistics()) {
        std::snprintf(line, sizeof line,
                      "task %-16s %10llu runs   mean %.0f ns   min %lld ns   max %lld ns   overruns %llu\n",
                      task.name.c_str(), static_cast<unsigned long long>(task.count), task.meanNs,
                      static_cast<long long>(task.minNs), static_cast<long long>(task.maxNs),
                      static_cast<unsigned long long>(task.overruns));
        out += line;
    }
    return out;
}

std::string RunReport::toJson() const {
    const auto& fault = controller.fault();
    std::string out = "{\"state\":" + jsonString(fault ? "fault" : "stopped") +
                      ",\"scans\":" + std::to_string(controller.nextScan()) +
                      ",\"time_s\":" + secondsText(controller.lastTime()) + ",\"values\":{";
    bool isFirst = true;
    for (const Watch& watch : watches) {
        const expression::Outcome outcome = shownValue(watch, controller.image());
        out += (isFirst ? "" : ",") + jsonString(watch.text) + ":" +
               (outcome.hasValue() ? types::toJson(watch.expression.types(), outcome.value) : "null");
        isFirst = false;
    }
    out += "},\"fault\":";
    if (fault) {
        const bool known = fault->range.file.isValid();
        const auto lineOf = [&](SourceRange range) {
            return range.file.isValid()
                       ? std::to_string(built.program->sources[range.file].lineColumn(range.begin).line)
                       : "null";
        };
        const auto fileOf = [&](SourceRange range) {
            return range.file.isValid() ? jsonString(built.program->sources[range.file].path()) : "null";
        };
        out += "{\"code\":" + jsonString(controller::name(fault->code)) +
               ",\"message\":" + jsonString(fault->message.english()) +
               ",\"file\":" + (known ? fileOf(fault->range) : "null") + ",\"line\":" + lineOf(fault->range) +
               ",\"calls\":[";
        for (size_t i = 0; i < fault->calls.size(); ++i) {
            const controller::FaultFrame& frame = fault->calls[i];
            out += (i ? "," : "") + std::string("{\"function\":") + jsonString(frame.function) +
                   ",\"instance\":" + jsonString(frame.instance) + ",\"file\":" + fileOf(frame.range) +
                   ",\"line\":" + lineOf(frame.range) + "}";
        }
        out += "]}";
    } else {
        out += "null";
    }
    char number[64];
    std::snprintf(number, sizeof number, "%.3f", built.checkMs + built.codeMs);
    out += ",\"stats\":{\"build_ms\":" + std::string(number) + ",\"tasks\":[";
    isFirst = true;
    for (const controller::TaskStatistics& task : controller.statistics()) {
        std::snprintf(number, sizeof number, "%.1f", task.meanNs);
        out += (isFirst ? "{" : ",{") + std::string("\"name\":") + jsonString(task.name) +
               ",\"count\":" + std::to_string(task.count) + ",\"mean_ns\":" + number +
               ",\"max_ns\":" + std::to_string(task.maxNs) + "}";
        isFirst = false;
    }
    return out + "]}}\n";
}

} // namespace plc::cli
