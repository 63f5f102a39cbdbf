// What a journal of alarms says about the alarm system (ISA-18.2): how many per hour, floods, those that stand or
// chatter, the most frequent ones. Pure functions over records; any thread.
#pragma once
#include "hmi/alarms/alarm_store.h"

namespace plc::hmi {

struct AlarmLimits {
    int floodCount = 10; // new alarms within…
    Nanoseconds floodSpan = std::chrono::minutes(10);
    int chatterCount = 3;
    Nanoseconds chatterSpan = std::chrono::minutes(1);
    Nanoseconds standing = std::chrono::hours(24);
};

struct AlarmFlood {
    Nanoseconds from{}, to{};
    int count = 0; // raised in it
};
struct AlarmCount {
    QString alarm;
    int count = 0;
};
struct AlarmStatistics {
    Nanoseconds from{}, to{};
    int raised = 0, acknowledged = 0;
    double perHour = 0;
    double secondsToAcknowledge = 0; // on the average
    double shareInFlood = 0;         // of the time, 0…1
    std::vector<AlarmFlood> floods;
    std::vector<AlarmCount> mostFrequent; // ten at most
    std::vector<AlarmCount> chattering;   // how often they did
    std::vector<QString> standing;        // raised and not returned for so long at `to`
};

/// `records` in any order; `to`: the end of the time looked at (PLC time).
AlarmStatistics statisticsOf(std::vector<AlarmRecord> records, Nanoseconds from, Nanoseconds to,
                             const AlarmLimits& limits = {});

} // namespace plc::hmi
