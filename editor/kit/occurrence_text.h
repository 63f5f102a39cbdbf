// A message for who runs the machine: what happened, without what its programmer should do about it. Functions; GUI
// thread.
#pragma once
#include "runtime/base/result.h"

#include <QString>

namespace plc::kit {

/// "division by zero", of "division by zero; check the divisor first". `language` as for messageText().
[[nodiscard]] QString occurrenceText(const Message& message, const QString& language = {});
/// The same with the place in front.
[[nodiscard]] QString occurrenceText(const Error& error, const QString& language = {});

} // namespace plc::kit
