// protocol::errors::NotJson(line)…: why a message of a client cannot be carried out, from messages.def. For the sources
// that report. Functions, any thread.
#pragma once
#include "runtime/base/messages.h"

namespace plc::protocol::errors {
using namespace plc::errors;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"CommandLine", #Row, Text};
#include "projects/protocol/messages.def"
} // namespace plc::protocol::errors
