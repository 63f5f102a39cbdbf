// What the command line of a built program asks for: the options of `stepwise run` that make sense without a compiler.
// Values, main thread.
#pragma once
#include "runtime/base/result.h"

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace plc::runner {

/// PATH=VALUE@TIME: written or forced before the first scan at or after the time.
struct Write {
    std::string path, text;
    std::chrono::nanoseconds at{0};
    bool isForce = false;
};

struct Options {
    std::optional<uint64_t> scans;
    std::optional<std::chrono::nanoseconds> length;
    std::optional<int64_t> calendarStartNs;
    std::vector<Write> writes; // by time, forces first
    std::vector<std::string> watches;
    std::string recordFile, retainFile;
    bool isReal = false, wantsHelp = false, wantsVersion = false;
};

[[nodiscard]] Result<Options> parseOptions(const std::vector<std::string>& words);
[[nodiscard]] std::string helpText(const std::string& program);

} // namespace plc::runner
