// A forced variable. A value; any thread with a copy.
#pragma once
#include "runtime/image/layout.h"

#include <string>

namespace plc::controller {

struct Forced {
    std::string path;
    image::Place place;
    types::Value value;
};

} // namespace plc::controller
