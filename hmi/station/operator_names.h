// What an operator calls a variable: the text of the panel element that shows or writes it, in the panel's language. An
// answer about the program then speaks of "Start" and not of Main.xStartButton. Pure functions; main thread.
#pragma once
#include "hmi/station/panel_project.h"
#include "runtime/base/message.h"
#include "runtime/image/program.h"

#include <map>
#include <string>

namespace plc::hmi {

/// By the variable's path as the program's layout writes it. Of elements that write it first, then of those that show
/// it; variables without an element that has a text are left out.
using OperatorNames = std::map<std::string, std::string>;
[[nodiscard]] OperatorNames operatorNames(const PanelProject& project, const image::CompiledProgram& program,
                                          const QString& language);

/// The message with the names that it mentions as the operator knows them, in quotation marks.
[[nodiscard]] Message inOperatorsWords(const Message& message, const OperatorNames& names);

} // namespace plc::hmi
