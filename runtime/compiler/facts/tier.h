// The two kinds of code a back end makes of a program.
#pragma once
#include <cstdint>

namespace plc::facts {

/// Quick keeps every local in the frame area and stops at sites (debugging, first scan); Optimised keeps what it can in
/// registers.
enum class Tier : uint8_t { Quick, Optimised };

} // namespace plc::facts
