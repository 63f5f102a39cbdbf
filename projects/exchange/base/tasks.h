// Tasks that other tools keep beside the units, and the CONFIGURATION they become when all files are read. Values, any
// thread.
#pragma once
#include "projects/exchange/base/imported.h"

namespace plc::exchange {

struct ForeignTask {
    std::string name, interval, priority;
    std::vector<std::string> programs;
};
using ForeignTasks = std::vector<ForeignTask>;

/// Nothing without tasks.
void addConfiguration(const ForeignTasks& tasks, Imported& imported);

} // namespace plc::exchange
