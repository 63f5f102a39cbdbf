// The part of the panel check that holds panels against ISA-101 and ISA-18.2 (standard_rules.def): colours, sizes,
// places, ways, writes. Where a finding can be corrected without a decision, it carries the edit. Functions; main
// thread (texts are measured).
#pragma once
#include "hmi/check/panel_check.h"

namespace plc::hmi {

/// What one panel says by itself.
std::vector<Finding> checkStandard(const CheckInput& input, const NamedPanel& panel);
/// What the panels say together: ways, places, alarms, and what is wrong with the settings of the check.
std::vector<Finding> checkStandardOfAll(const CheckInput& input);

/// The fixes of all findings in a file, as one edit of its panel.
Edit fixesOf(const std::vector<Finding>& findings, const QString& file, const Panel& panel);

} // namespace plc::hmi
