// Times and dates as IEC text, written into a ScalarText. Nanoseconds as in `elementary.def`. Pure functions, any
// thread.
#pragma once
#include "runtime/types/scalar_text.h"

namespace plc::types {

constexpr int64_t kSecond = 1'000'000'000; // ns
constexpr int64_t kDay = 86'400 * kSecond; // ns

void appendDuration(ScalarText& out, int64_t nanoseconds, bool isLong);
void appendDate(ScalarText& out, int64_t nanoseconds, bool isLong);
void appendTimeOfDay(ScalarText& out, int64_t nanoseconds, bool isLong);
void appendDateTime(ScalarText& out, int64_t nanoseconds, bool isLong);

} // namespace plc::types
