// The times of alarms: one clock everywhere, over runs of the controller that began at different calendars; what a
// restart leaves behind; the history as a table.
#include "hmi/alarms/alarm_book.h"
#include "hmi/alarms/alarm_export.h"

#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

constexpr qint64 kSecond = 1'000'000'000, kIn2000 = 946684800 * kSecond, kIn2026 = 1772000000 * kSecond;

AlarmFile file() {
    Result<AlarmFile> parsed = AlarmFile::parse(
        R"({"alarms": [{"id": "load", "condition": "x", "priority": 1, "text": "Overload, motor 1"}]})", QString());
    EXPECT_TRUE(parsed);
    return *parsed;
}

AlarmRecord record(AlarmEventKind kind, int second) {
    AlarmRecord out;
    out.alarm = QStringLiteral("load");
    out.kind = kind;
    out.at = {static_cast<quint64>(second), static_cast<quint64>(second), Nanoseconds(second * kSecond)};
    return out;
}

/// One start of a controller with its calendar, over the same file.
struct Start {
    AlarmBook book;
    Start(const QString& path, const char* name, qint64 clockAtZero) {
        book.setFile(file());
        book.setRun(QLatin1String(name));
        EXPECT_TRUE(book.openStore(path));
        book.setClockAtZero(clockAtZero);
    }
    void happens(AlarmEventKind kind, int second) {
        const AlarmRecord one = record(kind, second);
        book.take({&one, 1});
    }
};

TEST(AlarmClock, EachOccurrenceKeepsTheCalendarOfItsRunAndTheHistoryIsInTimeOrder) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("alarms.sqlite");
    {
        Start later(path, "a", kIn2026);
        later.happens(AlarmEventKind::Raised, 10);
        later.happens(AlarmEventKind::Returned, 12);
        later.happens(AlarmEventKind::Acknowledged, 13);
    }
    Start virtualTime(path, "b", kIn2000);
    virtualTime.happens(AlarmEventKind::Raised, 5);
    const std::vector<AlarmEntry> all = virtualTime.book.history({}, 10);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].raisedClock, kIn2026 + 10 * kSecond);
    EXPECT_EQ(all[0].returnedClock, kIn2026 + 12 * kSecond);
    EXPECT_EQ(all[0].acknowledgedClock, kIn2026 + 13 * kSecond);
    EXPECT_EQ(all[1].raisedClock, kIn2000 + 5 * kSecond);
    EXPECT_EQ(virtualTime.book.present({}, AlarmOrder::Time).front().raisedClock, kIn2000 + 5 * kSecond);
}

TEST(AlarmClock, WhatARestartLeftUnacknowledgedIsToldApartFromWhatIsPresent) {
    const QTemporaryDir folder;
    const QString path = folder.filePath("alarms.sqlite");
    {
        Start before(path, "a", kIn2000);
        before.happens(AlarmEventKind::Raised, 10);
    }
    Start after(path, "b", kIn2026);
    EXPECT_TRUE(after.book.present({}, AlarmOrder::Time).empty());
    after.happens(AlarmEventKind::Raised, 1);
    after.happens(AlarmEventKind::Returned, 2);
    const std::vector<AlarmEntry> all = after.book.history({}, 10);
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].state, AlarmState::Returned);
    EXPECT_FALSE(all[0].isOfEarlierRun);
    EXPECT_EQ(all[1].state, AlarmState::Unacknowledged);
    EXPECT_FALSE(all[1].returnedClock) << "the return of the next run is not its own";
    EXPECT_TRUE(all[1].isOfEarlierRun);
}

TEST(AlarmClock, TheHistoryIsExportedAsATable) {
    const QTemporaryDir folder;
    Start run(folder.filePath("alarms.sqlite"), "a", kIn2000);
    run.happens(AlarmEventKind::Raised, 10);
    run.happens(AlarmEventKind::Returned, 12);
    EXPECT_EQ(alarmsAsCsv(run.book.history({}, 10), TextCatalog(), "en"),
              "raised,gone,acknowledged,state,run,id,class,priority,text\n"
              "2000-01-01 00:00:10.000,2000-01-01 00:00:12.000,,gone unacknowledged,present,load,,1,"
              "\"Overload, motor 1\"\n");
}

} // namespace
} // namespace plc::hmi
