// Registers the tests that break every golden at its tokens.
#pragma once

namespace plc::golden {

void registerBroken();

} // namespace plc::golden
