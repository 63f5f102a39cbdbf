// The alarm history as a table for other programs: one line per occurrence, with the times of raising, return and
// acknowledgement and the text in one language. Pure functions, any thread.
#pragma once
#include "hmi/alarms/alarm_book.h"

namespace plc::hmi {

/// CSV with a header, newest first; times as "2026-03-07 14:02:11.250" by the controller's calendar.
[[nodiscard]] std::string alarmsAsCsv(const std::vector<AlarmEntry>& entries, const TextCatalog& texts,
                                      const QString& language);

} // namespace plc::hmi
