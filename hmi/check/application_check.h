// The part of the panel check that concerns the panels as one application: the frame, start panels, roles, what leads
// where. Functions; any thread.
#pragma once
#include "hmi/check/panel_check.h"

namespace plc::hmi {

std::vector<Finding> checkApplication(const CheckInput& input);
/// Roles and the entries of navigation bars of one panel.
std::vector<Finding> checkAccess(const CheckInput& input, const NamedPanel& panel);

} // namespace plc::hmi
