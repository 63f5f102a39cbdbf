// The words for severities where everything is English: the command line, JSON, documents. The studio translates its
// own. Any thread.
#pragma once
#include "runtime/diagnostics/diagnostic.h"

#include <string_view>

namespace plc::diagnostics {

[[nodiscard]] std::string_view severityName(Severity severity);

} // namespace plc::diagnostics
