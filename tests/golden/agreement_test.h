// Registers the tests that hold constant folder, both tiers of code and the expression evaluator against each other.
#pragma once

namespace plc::golden {

void registerAgreement();

} // namespace plc::golden
