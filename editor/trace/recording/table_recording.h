// A table of measured values as a recording: each column becomes a variable of a program that is written for it, so
// that expressions, triggers, charts and comparing work as on a recording of our own. Functions, any thread.
#pragma once

#include "projects/waveform/table.h"
#include "runtime/base/progress.h"
#include "runtime/compiler/driver/driver.h"
#include "runtime/history/history.h"

#include <memory>

namespace plc::trace {

struct TableRecording {
    driver::Built built;
    std::unique_ptr<history::History> history;
};

[[nodiscard]] bool isTableFile(const std::string& path);
/// "Main.pid.q" stays that path, so that it is laid beneath the variable of that name; what is not a name in ST becomes
/// one ("Flow rate" is Flow_rate).
[[nodiscard]] std::vector<std::string> pathsOf(const waveform::Table& table);
/// The ST text in which those paths are variables.
[[nodiscard]] std::string programFor(const waveform::Table& table, const std::vector<std::string>& paths);
[[nodiscard]] Result<TableRecording> recordTable(const waveform::Table& table, Progress* progress = nullptr);

} // namespace plc::trace
