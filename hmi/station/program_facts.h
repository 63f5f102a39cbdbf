// What the check of panels asks the checked program: bindings, types, a variable of a type. Functions; any thread.
#pragma once
#include "hmi/check/panel_check.h"
#include "runtime/compiler/driver/driver.h"

namespace plc::hmi {

/// What an expression is: its type, in the table that describes it, and whether it is a variable.
struct TypedExpression {
    std::shared_ptr<const types::TypeTable> types;
    types::TypeId type;
    bool isPlace = false;
};
/// Nothing for an expression that is wrong.
std::optional<TypedExpression> typedExpression(const driver::Checked& checked, const QString& expression);
/// A variable of a type of that name, also where the program has none: "REAL", "Valve".
std::optional<TypedExpression> typedVariable(const driver::Checked& checked, const QString& type);
/// What is wrong with binding `expression`, which is that, where something else is wanted; empty: nothing.
Message complaintOn(const TypedExpression& given, const QString& expression, std::string_view wanted, bool isTarget);
/// The answer of the front end to one binding; used by the designer while typing, too.
Message checkBinding(const driver::Checked& checked, const QString& expression, std::string_view wanted, bool isTarget);
/// The type of an expression and what it extends or implements; empty when it is wrong.
QStringList typeNamesOf(const driver::Checked& checked, const QString& expression);
QStringList typeNamesOf(const TypedExpression& given);
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
