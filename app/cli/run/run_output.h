// What `run` and `replay` print: watches as a table or JSON, rows as CSV (RFC 4180). One thread.
#pragma once
#include "projects/session/session.h"

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

namespace plc::cli {

/// Bytes of a variable whose value is written out: one that was not asked for, one that was.
inline constexpr uint32_t kLargestListed = 16 * 1024, kLargestWatched = 1024 * 1024;

struct Watch {
    std::string text;
    expression::Expression expression;
    uint32_t largest = kLargestWatched;
};

/// Every variable of programs and globals that is not hidden or a constant, in order of declaration.
[[nodiscard]] std::vector<Watch> allVariables(const driver::Built& built);
/// "DT#…" → nanoseconds since 1970; none for an empty text.
[[nodiscard]] Result<std::optional<int64_t>> calendarStart(const std::string& text);
/// Times and enums as in JSON, text without quotes, REAL shortest: what a CSV cell holds.
[[nodiscard]] std::string csvValue(const types::TypeTable& types, const types::Value& value);
/// Quoted when it holds a comma, quote or line end.
[[nodiscard]] std::string csvCell(std::string_view text);

class CsvWriter {
public:
    explicit CsvWriter(const std::vector<Watch>& watches) : m_watches(watches) {}
    ~CsvWriter();
    void setInterval(std::chrono::nanoseconds interval) { m_interval = interval; }
    Result<void> open(const std::string& path); // "-": standard output; writes to a side file; close() puts it in place
    void row(std::span<const std::byte> image, uint64_t scan, std::chrono::nanoseconds time);
    void scanFinished(const controller::Controller& controller);
    Result<void> close();

private:
    const std::vector<Watch>& m_watches;
    std::string m_path;
    std::FILE* m_file = nullptr;
    bool m_isDirect = false; // a device or pipe: written as it is
    std::chrono::nanoseconds m_interval{0};
    std::optional<std::chrono::nanoseconds> m_next;
};

struct RunReport {
    const controller::Controller& controller;
    const driver::Built& built;
    const std::vector<Watch>& watches;
    bool withStatistics;
    [[nodiscard]] std::string toText(bool colours) const;
    [[nodiscard]] std::string toJson() const;
};

/// "12.01": seconds without trailing zeros.
[[nodiscard]] std::string secondsText(std::chrono::nanoseconds time);

} // namespace plc::cli
