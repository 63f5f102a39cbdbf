// texts::ItBecame(value)…: the sentences of "who set this?", "why?" and "why not?", from texts.def. For the sources
// that answer. Functions, any thread.
#pragma once
#include "runtime/base/result.h"

namespace plc::inside::texts {
using messages::Integer, messages::Name, messages::Nested, messages::Real, messages::Thing;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"Inside", #Row, Text};
#include "runtime/inside/texts.def"
} // namespace plc::inside::texts
