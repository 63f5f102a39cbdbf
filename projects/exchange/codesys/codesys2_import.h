// .EXP, the text export of CODESYS 2.3. Functions, any thread.
#pragma once
#include "projects/exchange/base/tasks.h"

namespace plc::exchange {

/// CODESYS 2.3 marks objects by comments: (* @PATH := … *), (* @END_DECLARATION := … *).
[[nodiscard]] bool isCodesys2Text(std::string_view text);
void importCodesys2Text(const std::string& text, const std::string& place, Imported& imported, ForeignTasks& tasks);

} // namespace plc::exchange
