// Holds the ranges of bars, gauges and charts against what their values really were in a recording: what leaves its
// range is cut off, and nobody sees it. Function over a session that has run; main thread.
#pragma once
#include "hmi/station/panel_project.h"
#include "projects/session/session.h"

namespace plc::hmi {

std::vector<Finding> checkRanges(const PanelProject& project, session::Session& session);

} // namespace plc::hmi
