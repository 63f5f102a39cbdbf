// Shelved alarms and those out of service; what the journal says about the alarm system.
#include "hmi/alarms/statistics.h"
#include "hmi/alarms/suppression.h"

#include <QFile>
#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

using namespace std::chrono_literals;

AlarmRecord at(const char* alarm, AlarmEventKind kind, Nanoseconds time) {
    AlarmRecord record;
    record.alarm = QString::fromLatin1(alarm);
    record.kind = kind;
    record.at.time = time;
    return record;
}

TEST(AlarmStatistics, CountsPerHourAndTheMostFrequent) {
    std::vector<AlarmRecord> records;
    for (int i = 0; i < 6; ++i) records.push_back(at("often", AlarmEventKind::Raised, 20min * i));
    records.push_back(at("once", AlarmEventKind::Raised, 30min));
    records.push_back(at("once", AlarmEventKind::Acknowledged, 30min + 90s));
    records.push_back(at("later", AlarmEventKind::Raised, 3h)); // behind the end
    const AlarmStatistics found = statisticsOf(records, 0s, 2h);
    EXPECT_EQ(found.raised, 7);
    EXPECT_DOUBLE_EQ(found.perHour, 3.5);
    EXPECT_EQ(found.acknowledged, 1);
    EXPECT_DOUBLE_EQ(found.secondsToAcknowledge, 90);
    ASSERT_EQ(found.mostFrequent.size(), 2u);
    EXPECT_EQ(found.mostFrequent[0].alarm.toStdString(), "often");
    EXPECT_EQ(found.mostFrequent[0].count, 6);
    EXPECT_TRUE(found.floods.empty());
    EXPECT_TRUE(found.chattering.empty());
    for (int i = 0; i < 15; ++i)
        records.push_back(at(("a" + std::to_string(i)).c_str(), AlarmEventKind::Raised, 1min * i));
    EXPECT_EQ(statisticsOf(records, 0s, 2h).mostFrequent.size(), 10u);
    EXPECT_EQ(statisticsOf({}, 0s, 0s).perHour, 0);
}

TEST(AlarmStatistics, AFloodBeginsWithTenInTenMinutesAndEndsWhenItIsQuiet) {
    std::vector<AlarmRecord> records;
    for (int i = 0; i < 9; ++i) records.push_back(at("a", AlarmEventKind::Raised, 1h + 30s * i));
    EXPECT_TRUE(statisticsOf(records, 0s, 5h).floods.empty());
    for (int i = 9; i < 12; ++i) records.push_back(at("a", AlarmEventKind::Raised, 1h + 30s * i));
    const AlarmStatistics found = statisticsOf(records, 0s, 5h);
    ASSERT_EQ(found.floods.size(), 1u);
    EXPECT_EQ(found.floods[0].from, Nanoseconds(1h));
    EXPECT_EQ(found.floods[0].count, 12);
    EXPECT_EQ(found.floods[0].to, Nanoseconds(1h + 30s * 7 + 10min)); // when 4 of them are left in the window
    EXPECT_NEAR(found.shareInFlood, (13.5 / 60) / 5, 1e-9);
    EXPECT_EQ(statisticsOf(records, 0s, 1h + 6min).floods[0].to, Nanoseconds(1h + 6min)); // it goes on
}

TEST(AlarmStatistics, ChatteringAndStandingAlarmsAreNamed) {
    std::vector<AlarmRecord> records;
    for (int i = 0; i < 7; ++i) {
        records.push_back(at("flutter", AlarmEventKind::Raised, 10s * i));
        records.push_back(at("flutter", AlarmEventKind::Returned, 10s * i + 5s));
    }
    for (int i = 0; i < 7; ++i) records.push_back(at("calm", AlarmEventKind::Raised, 31s * i));
    records.push_back(at("old", AlarmEventKind::Raised, 1h));
    records.push_back(at("gone", AlarmEventKind::Raised, 1h));
    records.push_back(at("gone", AlarmEventKind::Returned, 2h));
    const AlarmStatistics found = statisticsOf(records, 0s, 26h);
    ASSERT_EQ(found.chattering.size(), 1u);
    EXPECT_EQ(found.chattering[0].alarm.toStdString(), "flutter");
    EXPECT_EQ(found.chattering[0].count, 1); // six of seven within a minute, the seventh alone
    ASSERT_EQ(found.standing.size(), 2u);
    EXPECT_EQ(found.standing[0].toStdString(), "calm");
    EXPECT_EQ(found.standing[1].toStdString(), "old");
    // What was raised before the time looked at is still standing at its end.
    EXPECT_EQ(statisticsOf(records, 20h, 26h).standing.size(), 2u);
    EXPECT_EQ(statisticsOf(records, 20h, 26h).raised, 0);
}

TEST(AlarmSuppression, AShelvedAlarmComesBackByItselfOneOutOfServiceDoesNot) {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral(".stepwise/aside.json"));
    const QDateTime now(QDate(2026, 1, 2), QTime(3, 0), Qt::UTC);
    {
        AlarmSuppression aside;
        ASSERT_TRUE(aside.open(path));
        ASSERT_TRUE(aside.shelve(QStringLiteral("a"), 1800, QStringLiteral("anna"), QStringLiteral("sensor ø"), now));
        ASSERT_TRUE(aside.takeOutOfService(QStringLiteral("b"), QStringLiteral("bert"), {}, now));
        ASSERT_TRUE(aside.shelve(QStringLiteral("c"), 1000000, {}, {}, now));
    }
    AlarmSuppression aside; // after a restart
    ASSERT_TRUE(aside.open(path));
    ASSERT_TRUE(aside.find(QStringLiteral("a")));
    EXPECT_EQ(aside.find(QStringLiteral("a"))->user.toStdString(), "anna");
    EXPECT_EQ(aside.find(QStringLiteral("a"))->reason.toStdString(), "sensor ø");
    EXPECT_EQ(*aside.find(QStringLiteral("c"))->until, now.addDays(1)); // no longer than a day
    EXPECT_TRUE(aside.expire(now.addSecs(1799)).empty());
    EXPECT_EQ(aside.expire(now.addSecs(1800)), std::vector<QString>{QStringLiteral("a")});
    EXPECT_FALSE(aside.isAside(QStringLiteral("a")));
    EXPECT_EQ(aside.expire(now.addDays(400)), std::vector<QString>{QStringLiteral("c")});
    EXPECT_TRUE(aside.isAside(QStringLiteral("b")));
    ASSERT_TRUE(aside.putBack(QStringLiteral("b")));
    AlarmSuppression last;
    ASSERT_TRUE(last.open(path));
    EXPECT_TRUE(last.all().empty());
}

TEST(AlarmSuppression, AFileThatIsDamagedKeepsNoAlarmAway) {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("aside.json"));
    for (const char* bytes : {"", "[", "{}", "[5, {\"alarm\": \"\"}, {\"alarm\": \"a\", \"until\": \"soon\"}]"}) {
        QFile file(path);
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(bytes);
        file.close();
        AlarmSuppression aside;
        (void)aside.open(path);
        EXPECT_TRUE(aside.all().empty()) << bytes;
    }
}

} // namespace
} // namespace plc::hmi
