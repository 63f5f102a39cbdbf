// Registers the tests with random programs.
#pragma once

namespace plc::golden {

void registerRandom();

} // namespace plc::golden
