// errors::NoOption(name)…: what a program made by `stepwise build` reports, from errors.def. For the sources that
// report. Functions, any thread.
#pragma once
#include "runtime/base/messages.h"

namespace plc::runner::errors {
using namespace plc::errors;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"Runner", #Row, Text};
#include "runtime/runner/errors.def"
} // namespace plc::runner::errors
