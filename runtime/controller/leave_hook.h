// How a scan that takes long is left on request (stop, reset, the end of the program), in its middle. Scan thread only.
#pragma once
#include <functional>

namespace plc::controller {

class Controller;

/// `wantsToLeave` is asked every few milliseconds of a long scan; true leaves it as Controller::abandonScan does.
void setLeaveHook(Controller& controller, std::function<bool()> wantsToLeave);

} // namespace plc::controller
