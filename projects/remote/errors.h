// remote::errors::WrongCode()…: why a served controller cannot be attached to or refuses something, from messages.def.
// For the sources that report. Functions, any thread.
#pragma once
#include "runtime/base/messages.h"

namespace plc::remote::errors {
using namespace plc::errors;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"Remote", #Row, Text};
#include "projects/remote/messages.def"
} // namespace plc::remote::errors
