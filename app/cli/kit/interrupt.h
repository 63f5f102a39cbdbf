// Work that Ctrl+C cancels, so that what is done by then is still reported. Main thread.
#pragma once
#include "runtime/base/progress.h"

namespace plc::cli {

/// Exit code of a command that Ctrl+C ended before its answer was known, as shells count it.
inline constexpr int kInterrupted = 130;

/// While this lives, Ctrl+C cancels that work (a second one ends the program). What was pressed before does not count:
/// it ended something else.
class InterruptCancels {
public:
    explicit InterruptCancels(Progress& work);
    ~InterruptCancels();
    InterruptCancels(const InterruptCancels&) = delete;
    InterruptCancels& operator=(const InterruptCancels&) = delete;
};

/// Says that Ctrl+C came before the answer; the exit code.
int interruptedAnswer();

} // namespace plc::cli
