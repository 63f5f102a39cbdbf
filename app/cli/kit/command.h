// What a command of the command line is, and what the commands share: opening the project, printing diagnostics,
// progress and Ctrl+C. Exit codes: 0 good, 1 the program has errors or faulted, 2 wrong use. Functions, main thread.
#pragma once
#include "app/cli/kit/arguments.h"
#include "projects/model/project.h"

#include <iosfwd>
#include <thread>

namespace plc::cli {

enum ExitCode : int { kGood = 0, kProgramWrong = 1, kWrongUse = 2 };

struct Command {
    CommandSpec spec;
    int (*run)(const Arguments& arguments);
};

/// Whether several programs without a CONFIGURATION are an error: nothing runs them, but each can be checked.
enum class Entry : uint8_t { Needed, Optional };
int wrongUse(const Error& error);
/// Opens PATH… with the libraries of --library added.
[[nodiscard]] Result<projects::Project> openNamedProject(const Arguments& arguments);
[[nodiscard]] Result<projects::Project> openNamedProject(const Arguments& arguments,
                                                         const std::vector<std::string>& paths);
/// Prints diagnostics to stderr (text) or stdout (json list, with the objects of `moreJson` behind); true when there
/// are errors.
bool printDiagnostics(const driver::Checked& checked, bool asJson, bool withInfos,
                      const std::vector<std::string>& moreJson = {}, Entry entry = Entry::Needed);
/// Colours only on a terminal and without NO_COLOR.
[[nodiscard]] bool wantsColours(int fileDescriptor);
/// Charts and panels need an application object, but no display.
void needApplication();
/// Set by Ctrl+C (once; a second one ends the program).
[[nodiscard]] bool isInterrupted();
void catchInterrupt();
[[nodiscard]] std::string jsonString(std::string_view text);

/// A progress line on the terminal once something takes over a second; erased at the end.
class ProgressLine {
public:
    ~ProgressLine();
    void show(const std::string& text); // at most ten times a second
private:
    std::chrono::steady_clock::time_point m_begin = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point m_last{};
    bool m_isShown = false;
};

/// The progress line of work that cannot report itself: what is done and for how long, until this ends.
class Busy {
public:
    explicit Busy(std::string what);

private:
    std::jthread m_thread;
};

} // namespace plc::cli
