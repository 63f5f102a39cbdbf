#include "app/cli/kit/arguments.h"

#include "app/cli/kit/errors.h"
#include "runtime/base/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace plc::cli {

namespace {
const OptionSpec* findOption(const CommandSpec& spec, std::string_view name) {
    for (const OptionSpec& option : spec.options)
        if (option.name == name) return &option;
    return nullptr;
}
} // namespace

Result<Arguments> Arguments::parse(const CommandSpec& spec, const std::vector<std::string>& words) {
    Arguments out;
    bool onlyPaths = false;
    for (size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (onlyPaths || word.size() < 2 || word[0] != '-') {
            out.m_paths.push_back(word);
            continue;
        }
        if (word == "--") {
            onlyPaths = true;
            continue;
        }
        if (word == "--help" || word == "-h") {
            out.m_help = true;
            continue;
        }
        const size_t equals = word.starts_with("--") ? word.find('=') : std::string::npos;
        const std::string name = word.substr(0, equals);
        const OptionSpec* option = findOption(spec, name);
        if (!option) {
            std::vector<std::string> known;
            for (const OptionSpec& each : spec.options) known.emplace_back(each.name);
            const auto near = nearestName(name, known);
            return Error{near ? errors::NoOptionSuggest(name, *near, spec.name) : errors::NoOption(name, spec.name),
                         ""};
        }
        if (option->value.empty()) {
            if (equals != std::string::npos) return Error{errors::OptionTakesNoValue(name), ""};
            out.m_options.emplace_back(name, "");
        } else if (equals != std::string::npos) {
            out.m_options.emplace_back(name, word.substr(equals + 1));
        } else if (i + 1 < words.size()) {
            out.m_options.emplace_back(name, words[++i]);
        } else {
            return Error{errors::OptionNeedsValue(name, option->value), ""};
        }
    }
    return out;
}

bool Arguments::has(std::string_view option) const {
    return std::any_of(m_options.begin(), m_options.end(), [&](const auto& pair) { return pair.first == option; });
}

std::optional<std::string> Arguments::value(std::string_view option) const {
    const auto all = values(option);
    return all.empty() ? std::nullopt : std::optional(all.back());
}

std::vector<std::string> Arguments::values(std::string_view option) const {
    std::vector<std::string> out;
    for (const auto& [name, value] : m_options)
        if (name == option) out.push_back(value);
    return out;
}

std::string helpText(const CommandSpec& spec) {
    std::string out = std::string(spec.summary) + "\n\nUsage: stepwise " + std::string(spec.name) + " " +
                      std::string(spec.usage) + "\n";
    size_t width = 0;
    for (const OptionSpec& option : spec.options) width = std::max(width, option.name.size() + 1 + option.value.size());
    if (!spec.options.empty()) out += "\nOptions:\n";
    for (const OptionSpec& option : spec.options) {
        std::string head = std::string(option.name) + (option.value.empty() ? "" : " " + std::string(option.value));
        head.resize(width + 2, ' ');
        out += "  " + head + std::string(option.help) + "\n";
    }
    return out + "\nExample:\n  " + std::string(spec.example) + "\n";
}

Result<std::chrono::nanoseconds> parseDuration(std::string_view text) {
    const Error wrong{errors::NotADuration(text), ""};
    std::string rest = foldCase(text);
    for (const std::string_view prefix : {"ltime#", "time#", "lt#", "t#"})
        if (rest.starts_with(prefix)) {
            rest.erase(0, prefix.size());
            break;
        }
    std::erase(rest, '_');
    double total = 0;
    bool any = false;
    for (const char *at = rest.data(), *end = at + rest.size(); at < end; any = true) {
        double number = 0;
        const auto [after, error] = std::from_chars(at, end, number, std::chars_format::fixed);
        if (error != std::errc() || number < 0) return wrong;
        const char* unitEnd = after;
        while (unitEnd < end && *unitEnd >= 'a' && *unitEnd <= 'z') ++unitEnd;
        const std::string_view unit(after, static_cast<size_t>(unitEnd - after));
        const double scale = unit == "d"                    ? 86400e9
                             : unit == "h"                  ? 3600e9
                             : unit == "m" || unit == "min" ? 60e9
                             : unit == "s"                  ? 1e9
                             : unit == "ms"                 ? 1e6
                             : unit == "us"                 ? 1e3
                             : unit == "ns"                 ? 1
                                                            : 0;
        if (scale == 0) return wrong;
        total += number * scale;
        at = unitEnd;
    }
    if (!any || total > 9e18) return wrong;
    return std::chrono::nanoseconds(std::llround(total));
}

Result<uint64_t> parseCount(std::string_view text) {
    uint64_t number = 0;
    const auto [after, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || after != text.data() + text.size()) return Error{errors::NotAnInteger(text), ""};
    return number;
}

} // namespace plc::cli
