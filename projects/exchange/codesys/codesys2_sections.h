// Sections of CODESYS 2.3's text export that are no program units: the libraries, the tasks, and the names that the
// configuration of the devices gives to inputs and outputs. Functions, any thread.
#pragma once
#include "projects/exchange/base/tasks.h"

namespace plc::exchange {

/// The word that ends a section which begins with `word`; empty when it begins none.
[[nodiscard]] std::string endOfSection(std::string_view word);
/// `section` has the lines between the first and the last word; what it says of tasks goes to `tasks`.
void readCodesys2Section(std::string_view word, const std::string& section, const std::string& place,
                         Imported& imported, ForeignTasks& tasks);

} // namespace plc::exchange
