// errors::NoLoop(name, others)…: what the search for control loops reports, from messages.def. For the sources that
// report. Functions, any thread.
#pragma once
#include "runtime/base/messages.h"

namespace plc::loops::errors {
using namespace plc::errors;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"Loops", #Row, Text};
#include "projects/loops/messages.def"
} // namespace plc::loops::errors
