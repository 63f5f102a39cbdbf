// Users, roles, passwords, the door and the audit trail, without a panel.
#include "hmi/people/audit_trail.h"
#include "hmi/people/log_in.h"
#include "hmi/people/password.h"

#include <QFile>
#include <QTemporaryDir>
#include <gtest/gtest.h>

namespace plc::hmi {
namespace {

using std::chrono::seconds;

PeopleFile people(const std::string& users = {}) {
    const auto parsed = PeopleFile::parse(
        R"({"timeout": 60, "roles": [{"name": "operator", "startPanel": "main"}, {"name": "engineer"}], "users": [)" +
            users + "]}",
        QStringLiteral("hmi/people.json"));
    EXPECT_TRUE(parsed) << (parsed ? "" : parsed.error().english());
    return parsed ? *parsed : PeopleFile();
}

PeopleFile annaAndBert() {
    PeopleFile out = people();
    out.setUser({QStringLiteral("anna"), {QStringLiteral("operator")}, *hashOf(QStringLiteral("4711x"))});
    out.setUser({QStringLiteral("bert"), {QStringLiteral("engineer")}, *hashOf(QStringLiteral("secret"))});
    return out;
}

TEST(Password, IsKeptSaltedAndSlowAndNeverAsItIs) {
    const auto one = hashOf(QStringLiteral("hemmelig ø")), other = hashOf(QStringLiteral("hemmelig ø"));
    ASSERT_TRUE(one && other);
    EXPECT_NE(*one, *other); // another salt
    EXPECT_TRUE(one->startsWith(QStringLiteral("$y$")));
    EXPECT_FALSE(one->contains(QStringLiteral("hemmelig")));
    EXPECT_TRUE(isPassword(QStringLiteral("hemmelig ø"), *one));
    EXPECT_TRUE(isPassword(QStringLiteral("hemmelig ø"), *other));
    for (const char* wrong : {"", "hemmelig", "hemmelig o", "Hemmelig ø"})
        EXPECT_FALSE(isPassword(QString::fromUtf8(wrong), *one)) << wrong;
    for (const char* broken : {"", "x", "$", "$y$", "*0", "$y$j9T$abc"})
        EXPECT_FALSE(isPassword(QStringLiteral("a"), QString::fromLatin1(broken))) << broken;
    EXPECT_FALSE(weaknessOf(QStringLiteral("123"), QStringLiteral("anna")).isEmpty());
    EXPECT_FALSE(weaknessOf(QStringLiteral("Anna"), QStringLiteral("anna")).isEmpty());
    EXPECT_TRUE(weaknessOf(QStringLiteral("4711"), QStringLiteral("anna")).isEmpty());
}

TEST(People, AreWrittenAsTheyWereReadWithWhatIsUnknown) {
    const std::string text =
        "{\n  \"version\": 1,\n  \"timeout\": 300,\n  \"roles\": [\n    {\n      \"name\": \"a\"\n    }\n  ],\n"
        "  \"users\": [\n    {\n      \"name\": \"u\",\n      \"roles\": [\"a\"],\n      \"badge\": 7\n    }\n  ],\n  "
        "\"site\": \"x\"\n}\n";
    const auto parsed = PeopleFile::parse(text, QStringLiteral("p"));
    ASSERT_TRUE(parsed) << parsed.error().english();
    const std::string written = parsed->write();
    EXPECT_EQ(PeopleFile::parse(written, QStringLiteral("p"))->write(), written);
    EXPECT_NE(written.find("\"badge\": 7"), std::string::npos);
    EXPECT_NE(written.find("\"site\": \"x\""), std::string::npos);
}

TEST(People, AFileWithAMistakeGivesNobodyARight) {
    for (const char* text :
         {"", "[]", R"({"users": {}})", R"({"users": [{"name": "a", "roles": ["gone"]}]})",
          R"({"users": [{"roles": []}]})", R"({"roles": [{"name": "r"}, {"name": "R"}]})",
          R"({"users": [{"name": "a"}, {"name": "A"}]})", R"({"users": [{"name": "a", "roles": 5}]})"}) {
        const auto parsed = PeopleFile::parse(text, QStringLiteral("hmi/people.json"));
        ASSERT_FALSE(parsed) << text;
        EXPECT_EQ(parsed.error().place.rfind("hmi/people.json", 0), 0u);
    }
}

TEST(LogIn, LetsInWithThePasswordAndOutAfterTheTime) {
    const PeopleFile file = annaAndBert();
    LogIn door(file);
    const Moment begin{};
    EXPECT_FALSE(door.isAllowed(QStringLiteral("operator")));
    EXPECT_TRUE(door.isAllowed({}));
    EXPECT_EQ(door.logIn(QStringLiteral("anna"), QStringLiteral("wrong"), begin), LogIn::Answer::Wrong);
    EXPECT_EQ(door.logIn(QStringLiteral("nobody"), QStringLiteral("4711x"), begin), LogIn::Answer::Wrong);
    EXPECT_FALSE(door.isLoggedIn());
    EXPECT_EQ(door.logIn(QStringLiteral("Anna"), QStringLiteral("4711x"), begin), LogIn::Answer::Good);
    EXPECT_EQ(door.user().toStdString(), "anna");
    EXPECT_TRUE(door.isAllowed(QStringLiteral("engineer, Operator")));
    EXPECT_FALSE(door.isAllowed(QStringLiteral("engineer")));
    EXPECT_FALSE(door.expire(begin + seconds(59)));
    door.touched(begin + seconds(59));
    EXPECT_FALSE(door.expire(begin + seconds(118)));
    EXPECT_TRUE(door.expire(begin + seconds(119)));
    EXPECT_FALSE(door.isAllowed(QStringLiteral("operator")));
    const PeopleFile none;
    EXPECT_TRUE(LogIn(none).isAllowed(QStringLiteral("engineer"))); // a project without people
}

TEST(LogIn, ClosesForAWhileAfterTooManyWrongPasswords) {
    const PeopleFile file = annaAndBert();
    LogIn door(file);
    const Moment begin{};
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(door.logIn(QStringLiteral("anna"), QStringLiteral("guess"), begin), LogIn::Answer::Wrong);
    EXPECT_EQ(door.logIn(QStringLiteral("anna"), QStringLiteral("4711x"), begin), LogIn::Answer::Blocked);
    EXPECT_EQ(door.logIn(QStringLiteral("bert"), QStringLiteral("secret"), begin), LogIn::Answer::Good);
    EXPECT_EQ(door.logIn(QStringLiteral("anna"), QStringLiteral("4711x"), begin + seconds(31)), LogIn::Answer::Good);
    EXPECT_EQ(door.confirm(QStringLiteral("secret"), begin + seconds(31)), LogIn::Answer::Wrong);
    EXPECT_EQ(door.confirm(QStringLiteral("4711x"), begin + seconds(31)), LogIn::Answer::Good);
}

AuditEntry entry(int second, const char* user, const char* to) {
    return {QDateTime(QDate(2026, 1, 2), QTime(3, 4, second), Qt::UTC),
            QString::fromUtf8(user),
            QStringLiteral("write"),
            QStringLiteral("Main.Speed"),
            QStringLiteral("1.0"),
            QString::fromUtf8(to),
            QStringLiteral("main, entry1"),
            {}};
}

TEST(AuditTrail, SurvivesARestartAndShowsEveryChange) {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("deep/audit.csv"));
    {
        AuditTrail trail;
        ASSERT_TRUE(trail.open(path));
    }
    {
        AuditTrail trail;
        ASSERT_TRUE(trail.open(path));
        ASSERT_TRUE(trail.add(entry(1, "anna", "2.5")));
        ASSERT_TRUE(trail.add(entry(2, "Jens \"the\" Ø, jr.\n", "'a, b'")));
    }
    {
        AuditTrail trail;
        ASSERT_TRUE(trail.open(path));
        ASSERT_TRUE(trail.add(entry(3, "", "4.0")));
    }
    const auto read = readAudit(path);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->firstBroken, 0);
    ASSERT_EQ(read->entries.size(), 3u);
    EXPECT_EQ(read->entries[0], entry(1, "anna", "2.5"));
    EXPECT_EQ(read->entries[1].to.toStdString(), "'a, b'");
    EXPECT_EQ(read->entries[1].user.toStdString(), "Jens \"the\" Ø, jr. ");
    const std::string csv = auditToCsv(read->entries);
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);

    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadWrite));
    QByteArray bytes = file.readAll();
    const QByteArray good = bytes;
    const auto brokenAt = [&](const QByteArray& changed) {
        file.resize(0);
        file.seek(0);
        file.write(changed);
        file.flush();
        return readAudit(path)->firstBroken;
    };
    EXPECT_EQ(brokenAt(QByteArray(good).replace("2.5", "9.5")), 2);
    QList<QByteArray> lines = good.split('\n');
    lines.removeAt(2);
    EXPECT_EQ(brokenAt(lines.join('\n')), 3); // a line taken out
    EXPECT_EQ(brokenAt(good), 0);
    // Cut in the middle of a line by a power failure: said, and the next entry is whole.
    EXPECT_EQ(brokenAt(good.chopped(20)), 4);
    file.close();
    AuditTrail trail;
    ASSERT_TRUE(trail.open(path));
    ASSERT_TRUE(trail.add(entry(5, "bert", "7.0")));
    EXPECT_EQ(readAudit(path)->entries.back(), entry(5, "bert", "7.0"));
    EXPECT_EQ(readAudit(path)->firstBroken, 4);
}

} // namespace
} // namespace plc::hmi
