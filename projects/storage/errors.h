// errors::EncodingUnknown(name, known)…: what reading and writing a project reports, from messages.def and those of the
// base. For the sources that report. Functions, any thread.
#pragma once
#include "runtime/base/messages.h"

namespace plc::projects::errors {
using namespace plc::errors;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"Storage", #Row, Text};
#include "projects/storage/messages.def"
} // namespace plc::projects::errors
