// errors::PanelNotJson(), errors::KeyMissing(key)…: what panels, texts and alarms report, from errors.def. For the
// sources that report. Functions, any thread.
#pragma once
#include "hmi/model/json.h"
#include "runtime/base/messages.h"

namespace plc::errors {
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"Errors", #Row, Text};
#include "hmi/model/errors.def"
} // namespace plc::errors
