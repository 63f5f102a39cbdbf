// phrases::AnIndex(), phrases::ConstantVariable(name)…: words of ours inside other messages. Values, any thread.
#pragma once
#include "runtime/base/message.h"

namespace plc::phrases {
using messages::Integer, messages::Name, messages::Names;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::PhraseForm<__VA_ARGS__> Row{"Phrases", #Row, Text};
#include "runtime/base/phrases.def"
} // namespace plc::phrases
