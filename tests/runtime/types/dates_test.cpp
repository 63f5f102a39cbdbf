#include "runtime/types/value.h"

#include <gtest/gtest.h>

#include <limits>

using namespace plc::types;

namespace {
constexpr int64_t kMs = 1'000'000, kSecond = 1'000 * kMs, kMinute = 60 * kSecond, kHour = 60 * kMinute,
                  kDay = 24 * kHour;
}

TEST(Duration, TextShowsOnlyTheUnitsThatAreThere) {
    struct Row {
        int64_t nanoseconds;
        const char* text;
    };
    for (const auto& [nanoseconds, text] : {
             Row{0, "T#0s"},
             Row{1, "T#1ns"},
             Row{kMs, "T#1ms"},
             Row{1'500 * kMs, "T#1s500ms"},
             Row{kDay + 2 * kHour, "T#1d2h"},
             Row{-1'500 * kMs, "T#-1s500ms"},
             Row{kDay + 2 * kHour + 3 * kMinute + 4 * kSecond + 5 * kMs + 6'007, "T#1d2h3m4s5ms6us7ns"},
             Row{INT64_MAX, "T#106751d23h47m16s854ms775us807ns"},
             Row{INT64_MIN, "T#-106751d23h47m16s854ms775us808ns"},
         }) {
        EXPECT_EQ(durationText(nanoseconds), text);
        EXPECT_EQ(parseDuration(text), nanoseconds != INT64_MIN ? std::optional(nanoseconds) : std::nullopt) << text;
    }
    EXPECT_EQ(durationText(kSecond, true), "LTIME#1s");
}

TEST(Duration, EverySpellingReadsTheSame) {
    struct Row {
        const char* text;
        int64_t nanoseconds;
    };
    for (const auto& [text, nanoseconds] : {
             Row{"T#100ms", 100 * kMs},
             Row{"T#10S", 10 * kSecond},
             Row{"t#0s", 0},
             Row{"TIME#10s", 10 * kSecond},
             Row{"ltime#1us", 1'000},
             Row{"LT#5ns", 5},
             Row{"T#10d14h11m23s", 10 * kDay + 14 * kHour + 11 * kMinute + 23 * kSecond},
             Row{"T#5s12ms23us300ns", 5'012'023'300},
             Row{"T#14.7s", 14'700 * kMs},
             Row{"T#1.5h", 90 * kMinute},
             Row{"T#25h_15m", 25 * kHour + 15 * kMinute},
             Row{"T#1_000ms", kSecond},
             Row{"T#-5s", -5 * kSecond},
             Row{"-T#5s", -5 * kSecond},
             Row{"1s500ms", 1'500 * kMs},
             Row{"T#3m", 3 * kMinute},
             Row{"T#3ms", 3 * kMs},
             Row{"T#0.000001s", 1'000},
             Row{" T#1d ", kDay},
             Row{"T#90m", 90 * kMinute},
         })
        EXPECT_EQ(parseDuration(text), nanoseconds) << text;
}

TEST(Duration, WhatIsNoneIsRefused) {
    for (const char* text : {"", "T#", "T#5", "T#5x", "D#5s", "T#s", "T#1.5h30m", "T#5ms3s", "T#1s1s", "T#--5s",
                             "T#200000d", "T#.5s", "5", "T#1e3s"})
        EXPECT_EQ(parseDuration(text), std::nullopt) << text;
}

TEST(Date, DaysAreCountedFrom1970) {
    struct Row {
        CivilDate date;
        int64_t days;
    };
    for (const auto& [date, days] :
         {Row{{1970, 1, 1}, 0}, Row{{1970, 1, 2}, 1}, Row{{1969, 12, 31}, -1}, Row{{2000, 2, 29}, 11'016},
          Row{{2000, 3, 1}, 11'017}, Row{{1996, 3, 15}, 9'570}, Row{{2038, 1, 19}, 24'855}, Row{{2100, 3, 1}, 47'541},
          Row{{1600, 1, 1}, -135'140}}) {
        EXPECT_EQ(daysFromCivil(date), days);
        const CivilDate back = civilFromDays(days);
        EXPECT_EQ(back.year, date.year);
        EXPECT_EQ(back.month, date.month);
        EXPECT_EQ(back.day, date.day);
    }
}

TEST(Date, EveryDayOfFourCenturiesComesBack) {
    for (int64_t day = daysFromCivil({1800, 1, 1}); day <= daysFromCivil({2200, 12, 31}); ++day)
        ASSERT_EQ(daysFromCivil(civilFromDays(day)), day);
}

TEST(Date, OnlyDaysOfTheCalendarAreValid) {
    EXPECT_TRUE(isValidDate({2024, 2, 29}));
    EXPECT_TRUE(isValidDate({2000, 2, 29}));
    EXPECT_FALSE(isValidDate({1900, 2, 29}));
    EXPECT_FALSE(isValidDate({2023, 2, 29}));
    EXPECT_FALSE(isValidDate({2024, 4, 31}));
    EXPECT_FALSE(isValidDate({2024, 13, 1}));
    EXPECT_FALSE(isValidDate({2024, 0, 1}));
    EXPECT_FALSE(isValidDate({2024, 1, 0}));
}

TEST(Date, TextsReadBack) {
    EXPECT_EQ(parseDate("D#1996-3-15"), 9'570 * kDay);
    EXPECT_EQ(parseDate("DATE#1996-03-15"), 9'570 * kDay);
    EXPECT_EQ(parseDate("ldate#1996-03-15"), 9'570 * kDay);
    EXPECT_EQ(dateText(9'570 * kDay), "D#1996-03-15");
    EXPECT_EQ(dateText(-1), "D#1969-12-31");
    EXPECT_EQ(dateText(0, true), "LDATE#1970-01-01");
    EXPECT_EQ(parseTimeOfDay("TOD#1:10:3.3"), kHour + 10 * kMinute + 3'300 * kMs);
    EXPECT_EQ(parseTimeOfDay("TIME_OF_DAY#23:59:59.999"), kDay - kMs);
    EXPECT_EQ(parseTimeOfDay("tod#12:30"), 12 * kHour + 30 * kMinute);
    EXPECT_EQ(timeOfDayText(kHour + 10 * kMinute + 3'300 * kMs), "TOD#01:10:03.300");
    EXPECT_EQ(timeOfDayText(kHour, true), "LTOD#01:00:00");
    EXPECT_EQ(timeOfDayText(1), "TOD#00:00:00.000000001");
    EXPECT_EQ(parseDateTime("DT#1996-3-15-1:10:3.3"), 9'570 * kDay + kHour + 10 * kMinute + 3'300 * kMs);
    EXPECT_EQ(parseDateTime("DATE_AND_TIME#1970-01-01-00:00:00"), 0);
    EXPECT_EQ(dateTimeText(9'570 * kDay + kHour), "DT#1996-03-15-01:00:00");
    EXPECT_EQ(dateTimeText(-kSecond), "DT#1969-12-31-23:59:59");
    // The oldest moment: its midnight lies outside 64 bits.
    EXPECT_EQ(dateTimeText(std::numeric_limits<int64_t>::min(), true), "LDT#1677-09-21-00:12:43.145224192");
    EXPECT_EQ(timeOfDayText(std::numeric_limits<int64_t>::min()), "TOD#00:12:43.145224192");
    EXPECT_EQ(parseDate("D#1677-9-22"), -106'751 * kDay);
    EXPECT_FALSE(parseDate("D#1677-9-21")); // beyond 64 bits of nanoseconds
    EXPECT_FALSE(parseDateTime("LDT#1500-1-1-0:0:0"));
    for (const char* text : {"D#1996-3", "D#1996-13-1", "D#2023-2-29", "D#1996-3-15x", "T#1996-3-15", "D#99999-1-1"})
        EXPECT_FALSE(parseDate(text)) << text;
    for (const char* text : {"TOD#24:00:00", "TOD#1:60:0", "TOD#1:0:60", "TOD#1", "TOD#1:2:3."})
        EXPECT_FALSE(parseTimeOfDay(text)) << text;
    for (const char* text : {"DT#1996-3-15", "DT#1996-3-15-", "DT#1996-3-15 1:10:3"})
        EXPECT_FALSE(parseDateTime(text)) << text;
}
