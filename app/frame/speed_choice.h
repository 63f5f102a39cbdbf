// Asks how fast the controller runs: a usual speed, or any factor. GUI thread.
#pragma once
#include "projects/session/session.h"

#include <QString>

#include <optional>

class QWidget;

namespace plc::app {

struct SpeedChoice {
    std::optional<session::RunMode> mode; // nothing: it stays as it is
    QString refusal;                      // of what was entered
};
[[nodiscard]] SpeedChoice chooseSpeed(QWidget* parent, session::RunMode now);

} // namespace plc::app
