// Several values before one scan, or none of them. Scan thread.
#pragma once
#include "projects/session/session.h"
#include "runtime/controller/controller.h"

namespace plc::session {

/// Those that were written before one was refused are put back as they were.
[[nodiscard]] Result<void> writeAllOrNone(controller::Controller& controller, const std::vector<Assignment>& values);

} // namespace plc::session
