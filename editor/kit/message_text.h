// A message (fault, error, refusal, finding, fix) in the language of the studio or of a panel: the translated sentences
// of the .def lists, with the arguments put in. Functions; GUI thread.
#pragma once
#include "runtime/base/result.h"

#include <QString>

namespace plc::kit {

/// `language` "de", "da"…: of a panel; empty: the studio's.
[[nodiscard]] QString messageText(const Message& message, const QString& language = {});
/// The same with the place in front.
[[nodiscard]] QString messageText(const Error& error, const QString& language = {});

} // namespace plc::kit
