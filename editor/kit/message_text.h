// What the layers without a window say (faults, errors, refused commands, findings of the compiler) in the language of
// the studio or of a panel: the English sentence is found again in messages.def and diagnostics.def, and its template
// translated with the arguments put in. A sentence that stands in neither stays as it is. Functions; GUI thread.
#pragma once
#include "runtime/base/result.h"

#include <QString>

namespace plc::kit {

/// `language` "de", "da"…: of a panel; empty: the studio's.
[[nodiscard]] QString messageText(const std::string& english, const QString& language = {});
/// The same with the place in front.
[[nodiscard]] QString messageText(const Error& error, const QString& language = {});

} // namespace plc::kit
