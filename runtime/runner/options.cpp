#include "runtime/runner/options.h"

#include "runtime/runner/errors.h"
#include "runtime/types/value.h"

#include <algorithm>
#include <charconv>
#include <string_view>

namespace plc::runner {

namespace {

struct Option {
    std::string_view name, value, help; // value empty: a flag
    Result<void> (*take)(Options& out, const std::string& name, const std::string& text);
};

Result<std::chrono::nanoseconds> duration(const std::string& name, const std::string& text) {
    const auto length = types::parseDuration(text);
    if (!length || *length < 0) return Error{errors::NotADuration(name, text), ""};
    return std::chrono::nanoseconds(*length);
}

Result<void> takeScans(Options& out, const std::string& name, const std::string& text) {
    uint64_t number = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (problem != std::errc() || end != text.data() + text.size()) return Error{errors::NotACount(name, text), ""};
    out.scans = number;
    return {};
}

Result<void> takeLength(Options& out, const std::string& name, const std::string& text) {
    const auto length = duration(name, text);
    if (!length) return length.error();
    out.length = *length;
    return {};
}

Result<void> takeStart(Options& out, const std::string&, const std::string& text) {
    out.calendarStartNs = types::parseDateTime(text);
    if (!out.calendarStartNs) return Error{errors::NotADateAndTime(text), ""};
    return {};
}

/// The last @ is the time, unless it is inside a text literal.
Result<void> takeWrite(Options& out, const std::string& name, const std::string& word) {
    const size_t equals = word.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == word.size())
        return Error{errors::NotAWrite(word), ""};
    Write write{word.substr(0, equals), word.substr(equals + 1), {}, name == "--force"};
    const size_t at = write.text.rfind('@');
    if (at != std::string::npos &&
        std::count(write.text.begin() + static_cast<std::ptrdiff_t>(at), write.text.end(), '\'') % 2 == 0) {
        const auto time = duration(name, write.text.substr(at + 1));
        if (!time) return time.error();
        write.at = *time;
        write.text.erase(at);
    }
    out.writes.push_back(std::move(write));
    return {};
}

const Option kOptions[] = {
    {"--for", "10s", "PLC time to run (default: until it is interrupted with --real, else 10s)", takeLength},
    {"--scans", "N", "number of scans to run", takeScans},
    {"--real", "", "in real time instead of as fast as possible",
     [](Options& out, const std::string&, const std::string&) -> Result<void> {
         out.isReal = true;
         return {};
     }},
    {"--set", "PATH=VALUE[@TIME]", "write before the first scan at or after TIME (repeatable)", takeWrite},
    {"--force", "PATH=VALUE[@TIME]", "force likewise; VALUE RELEASE ends it (repeatable)", takeWrite},
    {"--watch", "PATH", "a variable to show at the end (repeatable)",
     [](Options& out, const std::string&, const std::string& text) -> Result<void> {
         out.watches.push_back(text);
         return {};
     }},
    {"--record", "FILE", "save the recording of every scan, for the studio and `stepwise replay`",
     [](Options& out, const std::string&, const std::string& text) -> Result<void> {
         out.recordFile = text;
         return {};
     }},
    {"--retain", "FILE", "restore retained variables from FILE, save them there at the end",
     [](Options& out, const std::string&, const std::string& text) -> Result<void> {
         out.retainFile = text;
         return {};
     }},
    {"--start", "DT#2026-01-01-06:00:00", "calendar at the first scan", takeStart},
    {"--version", "", "what it was built by",
     [](Options& out, const std::string&, const std::string&) -> Result<void> {
         out.wantsVersion = true;
         return {};
     }},
    {"--help", "", "this text",
     [](Options& out, const std::string&, const std::string&) -> Result<void> {
         out.wantsHelp = true;
         return {};
     }},
};

} // namespace

Result<Options> parseOptions(const std::vector<std::string>& words) {
    Options out;
    for (size_t i = 0; i < words.size(); ++i) {
        const size_t equals = words[i].starts_with("--") ? words[i].find('=') : std::string::npos;
        const std::string name = words[i].substr(0, equals);
        const auto* option = std::find_if(std::begin(kOptions), std::end(kOptions),
                                          [&](const Option& each) { return each.name == name; });
        if (option == std::end(kOptions)) return Error{errors::NoOption(name), ""};
        const bool hasValue = !option->value.empty();
        if (!hasValue && equals != std::string::npos) return Error{errors::OptionTakesNoValue(name), ""};
        if (hasValue && equals == std::string::npos && i + 1 == words.size())
            return Error{errors::OptionNeedsValue(name), ""};
        std::string text;
        if (hasValue) text = equals != std::string::npos ? words[i].substr(equals + 1) : words[++i];
        if (auto taken = option->take(out, name, text); !taken) return taken.error();
    }
    std::stable_sort(out.writes.begin(), out.writes.end(),
                     [](const Write& a, const Write& b) { return a.at != b.at ? a.at < b.at : a.isForce > b.isForce; });
    return out;
}

std::string helpText(const std::string& program) {
    std::string out = program + ": a controller built by Stepwise.\n\nOptions:\n";
    for (const Option& option : kOptions) {
        std::string head = std::string(option.name) + (option.value.empty() ? "" : " " + std::string(option.value));
        head.resize(std::max<size_t>(head.size() + 2, 32), ' ');
        out += "  " + head + std::string(option.help) + "\n";
    }
    return out;
}

} // namespace plc::runner
