// What the window does, the command line does (D9): one file per command, all on the same libraries, none needs a
// display. Exit codes: 0 good, 1 the program has errors or faulted, 2 wrong use.
#pragma once
#include "app/cli/arguments.h"
#include "projects/model/project.h"

#include <iosfwd>
#include <thread>

namespace plc::cli {

enum ExitCode : int { kGood = 0, kProgramWrong = 1, kWrongUse = 2 };

struct Command {
    CommandSpec spec;
    int (*run)(const Arguments& arguments);
};
[[nodiscard]] const std::vector<Command>& commands();

/// Runs `stepwise WORDS…`; the words do not hold the program's name.
int runCommandLine(const std::vector<std::string>& words);

// One file each.
[[nodiscard]] Command checkCommand();
[[nodiscard]] Command runCommand();
[[nodiscard]] Command formatCommand();
[[nodiscard]] Command testCommand();
[[nodiscard]] Command traceCommand();
[[nodiscard]] Command replayCommand();
[[nodiscard]] Command panelCommand();
[[nodiscard]] Command docCommand();
[[nodiscard]] Command explainCommand();
[[nodiscard]] Command convertCommand();
[[nodiscard]] Command importCommand();
[[nodiscard]] Command exportCommand();
[[nodiscard]] Command ladderCommand();
[[nodiscard]] Command whyCommand();
[[nodiscard]] Command tuneCommand();
[[nodiscard]] Command serveCommand();
[[nodiscard]] Command attachCommand();
[[nodiscard]] Command textsCommand();
[[nodiscard]] Command recipeCommand();
[[nodiscard]] Command peopleCommand();
[[nodiscard]] Command alarmsCommand();
[[nodiscard]] Command devicesCommand();
[[nodiscard]] Command lspCommand();
[[nodiscard]] Command dapCommand();
[[nodiscard]] Command mcpCommand();
[[nodiscard]] Command buildCommand();

// --- shared by the commands
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
