// What an online change did to the variables. A value; any thread with a copy.
#pragma once
#include "runtime/base/message.h"

#include <string>
#include <vector>

namespace plc::controller {

struct OnlineChangeReport {
    std::vector<std::string> kept, initialised, lost, nulled; // paths (roots and members, arrays summed up)
    std::vector<std::string> lostForces;
    Message refusal; // not empty: the new program could not enter, the old one goes on
};

} // namespace plc::controller
