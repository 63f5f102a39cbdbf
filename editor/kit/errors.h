// errors::TraceNotObject(), errors::PastReadOnly()…: what the editor's parts report, from errors.def. For the sources
// that report. Functions, any thread.
#pragma once
#include "runtime/base/messages.h"
#include "runtime/base/phrases.h"

namespace plc::errors {
using messages::Phrase;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"Errors", #Row, Text};
#include "editor/kit/errors.def"
} // namespace plc::errors
