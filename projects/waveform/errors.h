// errors::CsvHasNoTime(), errors::SpectrumTooShort()…: what the work on recorded signals reports, from messages.def.
// For the sources that report. Functions, any thread.
#pragma once
#include "runtime/base/messages.h"

namespace plc::waveform::errors {
using namespace plc::errors;
#define PLC_MESSAGE(Row, Text, ...) inline constexpr messages::TypedForm<__VA_ARGS__> Row{"Waveform", #Row, Text};
#include "projects/waveform/messages.def"
} // namespace plc::waveform::errors
