// Asks how fast the controller runs: a usual speed, or any factor. GUI thread.
#pragma once
#include "projects/session/session.h"

#include <optional>

class QWidget;

namespace plc::app {

/// What was chosen; nullopt: cancelled.
[[nodiscard]] std::optional<session::RunMode> chooseSpeed(QWidget* parent, session::RunMode now);

} // namespace plc::app
