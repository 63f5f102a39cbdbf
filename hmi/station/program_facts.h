// What the check of panels asks the checked program: bindings, types, a variable of a type. Functions; any thread.
#pragma once
#include "hmi/check/panel_check.h"
#include "runtime/compiler/driver/driver.h"

namespace plc::hmi {

/// The answer of the front end to one binding; used by the designer while typing, too.
Message checkBinding(const driver::Checked& checked, const QString& expression, std::string_view wanted, bool isTarget);
/// The type of an expression and what it extends or implements; empty when it is wrong.
QStringList typeNamesOf(const driver::Checked& checked, const QString& expression);
/// The path of a variable of that type, also one deep in a block or the first of an array; empty: there is none.
QString instanceOf(const driver::Checked& checked, const QString& type);
/// Lets the check ask this program, which must outlive the input.
void askProgram(CheckInput& input, const driver::Checked& checked);
/// The arrays of the program whose elements are of that type: "Plant.Valves".
QStringList arraysOf(const driver::Checked& checked, const QString& type);
/// First and last index of an array's first dimension.
std::optional<std::pair<int, int>> boundsOf(const driver::Checked& checked, const QString& array);
/// The program with a variable for each type that only parameters of panels have, so that a faceplate which nobody
/// places is checked, too. The program as it is where none is needed.
driver::Checked checkedForPanels(const driver::BuildInput& input, const driver::Checked& checked,
                                 const std::vector<NamedPanel>& panels);

} // namespace plc::hmi
