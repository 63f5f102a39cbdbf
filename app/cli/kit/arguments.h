// The words of a command line, checked against what a command knows: options with or without a value, paths, --help.
// Wrong use names the word, the nearest known one and the way to the help. Values, any thread.
#pragma once
#include "runtime/base/result.h"

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plc::cli {

struct OptionSpec {
    std::string_view name;  // "--for"
    std::string_view value; // "10s" (shown in the help); empty: a flag
    std::string_view help;
};

struct CommandSpec {
    std::string_view name;
    std::string_view usage;   // "PATH…"
    std::string_view summary; // one line
    std::vector<OptionSpec> options;
    std::string_view example;
};

class Arguments {
public:
    /// `words` without the program's and the command's name.
    [[nodiscard]] static Result<Arguments> parse(const CommandSpec& spec, const std::vector<std::string>& words);
    [[nodiscard]] bool wantsHelp() const { return m_help; }
    [[nodiscard]] const std::vector<std::string>& paths() const { return m_paths; }
    [[nodiscard]] bool has(std::string_view option) const;
    [[nodiscard]] std::optional<std::string> value(std::string_view option) const; // the last one given
    [[nodiscard]] std::vector<std::string> values(std::string_view option) const;
    [[nodiscard]] bool wantsJson() const { return value("--format") == "json"; }

private:
    std::vector<std::pair<std::string, std::string>> m_options;
    std::vector<std::string> m_paths;
    bool m_help = false;
};

[[nodiscard]] std::string helpText(const CommandSpec& spec);
/// "10s", "1m30s", "100ms", "T#1s500ms", "1h", "250us"; a bare number is refused with the units that are possible.
[[nodiscard]] Result<std::chrono::nanoseconds> parseDuration(std::string_view text);
[[nodiscard]] Result<uint64_t> parseCount(std::string_view text);

} // namespace plc::cli
