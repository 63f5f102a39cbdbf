// errors::TooFewSamples(count)…: what the search for models reports, from messages.def. For the sources that report.
// Functions, any thread.
#pragma once
#include "runtime/base/messages.h"

namespace plc::tuning::errors {
using namespace plc::errors;
using messages::Real;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"Tuning", #Row, Text};
#include "projects/tuning/model/messages.def"
} // namespace plc::tuning::errors
