// The life of alarms, their history, and texts of past entries in the operator's language.
#include "hmi/alarms/alarm_book.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

using namespace std::chrono_literals;

AlarmFile file() {
    Result<AlarmFile> parsed = AlarmFile::parse(R"({
      "alarms": [
        {"id": "12004", "condition": "Motor.overload", "class": "fault", "priority": 1, "text": "@load", "values": {"i": "Motor.current"}, "onDelay": 2, "offDelay": 1},
        {"id": "door", "condition": "Door.open", "class": "hint", "priority": 3, "text": "@door", "acknowledge": false}
      ]})",
                                                QStringLiteral("alarms.json"));
    EXPECT_TRUE(parsed);
    return *parsed;
}

AlarmInstant at(int seconds) {
    return {static_cast<quint64>(seconds), static_cast<quint64>(seconds), Nanoseconds(seconds * 1s)};
}

struct AlarmRun {
    AlarmBook book;
    AlarmRun() { book.setFile(file()); }
    void step(int second, Condition overload, Condition door = Condition::False) {
        const Condition conditions[] = {overload, door};
        book.step(at(second), conditions, [&](size_t, const AlarmInstant& when) {
            return std::vector<std::pair<QString, Value>>{
                {QStringLiteral("i"), Value::ofReal(static_cast<double>(when.scan) + 0.5)}};
        });
    }
    AlarmState state() const { return book.lifeCycle().state(0); }
};

TEST(AlarmLife, GoesThroughDelaysReturnAndAcknowledgement) {
    AlarmRun run;
    constexpr Condition on = Condition::True, off = Condition::False;
    const struct {
        int second;
        Condition condition;
        bool acknowledge;
        AlarmState expected;
    } rows[] = {
        {0, on, false, AlarmState::Normal},
        {1, off, false, AlarmState::Normal},
        {2, on, false, AlarmState::Normal},
        {3, on, false, AlarmState::Normal},
        {4, on, false, AlarmState::Unacknowledged},
        {5, off, false, AlarmState::Unacknowledged},
        {6, off, false, AlarmState::Returned},
        {7, off, true, AlarmState::Normal},
        {8, on, false, AlarmState::Normal},
        {10, on, true, AlarmState::Acknowledged},
        {11, Condition::Unknown, false, AlarmState::Acknowledged},
        {12, off, false, AlarmState::Acknowledged},
        {13, off, false, AlarmState::Normal},
        {14, on, false, AlarmState::Normal},
        {16, on, false, AlarmState::Unacknowledged},
        {17, off, false, AlarmState::Unacknowledged},
        {18, off, false, AlarmState::Returned},
        {19, on, false, AlarmState::Returned},
        {21, on, false, AlarmState::Unacknowledged},
    };
    for (const auto& row : rows) {
        run.step(row.second, row.condition);
        if (row.acknowledge) run.book.acknowledgeAll(at(row.second));
        EXPECT_EQ(run.state(), row.expected) << "at second " << row.second;
    }
}

TEST(AlarmLife, WithoutAcknowledgementItIsGoneWhenItReturns) {
    AlarmRun run;
    run.step(0, Condition::False, Condition::True);
    ASSERT_EQ(run.book.present({}, AlarmOrder::Time).size(), 1u);
    EXPECT_EQ(run.book.present({}, AlarmOrder::Time)[0].state, AlarmState::Acknowledged);
    EXPECT_EQ(run.book.unacknowledgedCount(), 0);
    run.step(1, Condition::False, Condition::False);
    EXPECT_TRUE(run.book.present({}, AlarmOrder::Time).empty());
}

TEST(AlarmBook, SortsFiltersAndShowsAPastScan) {
    AlarmRun run;
    run.step(0, Condition::True, Condition::False);
    run.step(2, Condition::True, Condition::False);
    run.step(3, Condition::True, Condition::True);
    const auto byPriority = run.book.present({}, AlarmOrder::Priority), byTime = run.book.present({}, AlarmOrder::Time);
    ASSERT_EQ(byPriority.size(), 2u);
    EXPECT_EQ(byPriority[0].id.toStdString(), "12004");
    EXPECT_EQ(byTime[0].id.toStdString(), "door");
    EXPECT_EQ(run.book.present({QStringLiteral("hint")}, AlarmOrder::Time).size(), 1u);
    EXPECT_EQ(run.book.presentAt(2, {}, AlarmOrder::Time).size(), 1u);
    EXPECT_EQ(run.book.presentAt(1, {}, AlarmOrder::Time).size(), 0u);
    run.book.rewind(2);
    EXPECT_EQ(run.book.present({}, AlarmOrder::Time).size(), 1u);
}

TEST(AlarmBook, PastEntriesFollowTheLanguageBecauseOnlyValuesAreStored) {
    AlarmRun run;
    ASSERT_TRUE(run.book.openStore(QStringLiteral(":memory:")));
    run.step(0, Condition::True);
    run.step(2, Condition::True);
    run.book.acknowledgeAll(at(3));
    run.step(4, Condition::False);
    run.step(5, Condition::False);
    const std::vector<AlarmEntry> past = run.book.history({}, 10);
    ASSERT_EQ(past.size(), 1u);
    EXPECT_EQ(past[0].state, AlarmState::Normal);
    EXPECT_EQ(past[0].acknowledged->scan, 3u);
    EXPECT_EQ(past[0].returned->scan, 5u);
    LanguageSettings settings;
    settings.languages = QStringList{"en", "da"};
    const TextCatalog texts(
        *TextTable::parse("key,comment,en,da\nload,,Overload at {i:%.1f} A,\"Overbelastet ved {i:%.1f} A\"\n",
                          QString()),
        settings);
    EXPECT_EQ(AlarmBook::render(past[0], texts, QStringLiteral("en")).toStdString(), "Overload at 2.5 A");
    EXPECT_EQ(AlarmBook::render(past[0], texts, QStringLiteral("da")).toStdString(), "Overbelastet ved 2,5 A");
}

TEST(AlarmStore, KeepsKindTimeAndValuesOnDisk) {
    const QString path =
        QDir::tempPath() + QStringLiteral("/stepwise_alarm_test_%1.sqlite").arg(QCoreApplication::applicationPid());
    QFile::remove(path);
    {
        AlarmStore store;
        ASSERT_TRUE(store.open(path));
        const AlarmRecord records[] = {
            {0,
             QStringLiteral("a"),
             AlarmEventKind::Raised,
             at(1),
             7,
             {{QStringLiteral("x"), Value::ofReal(0.1)}, {QStringLiteral("t"), Value::ofInstant(ValueKind::Time, 5)}},
             {}},
            {0, QStringLiteral("a"), AlarmEventKind::Acknowledged, at(2), 8, {}, QStringLiteral("operator")}};
        ASSERT_TRUE(store.append(records));
    }
    AlarmStore store;
    ASSERT_TRUE(store.open(path));
    const std::vector<AlarmRecord> all = store.query({});
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].user.toStdString(), "operator");
    EXPECT_EQ(all[1].values[0].second, Value::ofReal(0.1));
    EXPECT_EQ(all[1].values[1].second, Value::ofInstant(ValueKind::Time, 5));
    EXPECT_EQ(all[1].at.time, 1s);
    store.trim(1);
    EXPECT_EQ(store.count(), 1);
    QFile::remove(path);
}

TEST(AlarmFile, LoadingAndSavingChangesNoByte) {
    const std::string text = "{\n  \"version\": 1,\n  \"classes\": [\n    {\n      \"name\": \"fault\"\n    }\n  ],\n  "
                             "\"alarms\": [\n    {\n      \"id\": \"a\",\n      \"condition\": \"x\",\n"
                             "      \"note\": [1]\n    }\n  ],\n  \"later\": true\n}\n";
    Result<AlarmFile> parsed = AlarmFile::parse(text, QString());
    ASSERT_TRUE(parsed);
    EXPECT_EQ(parsed->write(), text);
}

} // namespace
} // namespace plc::hmi
