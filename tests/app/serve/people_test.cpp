// Browsers of a project with users: they log in by name and password, have the rights of their roles, are counted when
// they guess, and leave one trail.
#include "chromium.h"
#include "served.h"

#include "hmi/people/audit_trail.h"
#include "hmi/people/password.h"
#include "tests/hmi/running.h"

#include <QDir>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QWebSocket>

namespace plc::serve {
namespace {

constexpr const char* kPassword = "quite secret";

class ServedPeople : public testing::Test {
protected:
    void SetUp() override {
        served.panels = hmi::machineProject();
        served.panels.folder = folder.path();
        served.panels.panels.push_back(
            {QStringLiteral("main"),
             hmi::panelOf(R"({"id": "go", "kind": "button", "rect": [20, 20, 160, 60], "target": "Main.start"},
                {"id": "own", "kind": "button", "rect": [20, 200, 160, 60], "action": "set", "target": "Main.stop", "access": "service"})")});
        served.panels.startPanel = QStringLiteral("main");
        for (const char* role : {"operator", "service"}) served.panels.people.setRole({QLatin1String(role), {}, {}});
        hmi::User anna;
        anna.name = QStringLiteral("anna");
        anna.roles = QStringList{QStringLiteral("operator")};
        anna.password = *hmi::hashOf(QLatin1String(kPassword));
        served.panels.people.setUser(anna);
        driver::BuildInput input;
        input.files.push_back({"main.st", hmi::kMachine});
        served.build(input);
        ServerSettings settings;
        settings.port = 0;
        served.server = std::make_unique<Server>(served.panels, *served.machine, byPeople(served.panels.people),
                                                 std::move(settings));
        ASSERT_TRUE(served.server->start());
        served.machine->startThread({session::Pace::Real});
    }

    struct Guest {
        QWebSocket socket;
        QJsonObject login, panel;
        int answers = 0;
        explicit Guest(const Served& served) {
            QObject::connect(&socket, &QWebSocket::connected, &socket, [this] { say(R"({"t":"hello","n":1})"); });
            QObject::connect(&socket, &QWebSocket::textMessageReceived, &socket, [this](const QString& text) {
                const QJsonObject message = QJsonDocument::fromJson(text.toUtf8()).object();
                if (message["t"] == "login") {
                    login = message;
                    ++answers;
                }
                if (message["t"] == "panel") panel = message;
            });
            QObject::connect(&socket, &QWebSocket::binaryMessageReceived, &socket, [this](const QByteArray& frame) {
                uint32_t number = 0;
                for (qsizetype i = 0, shift = 0; i < frame.size(); ++i, shift += 7) {
                    number |= static_cast<uint32_t>(frame[i] & 127) << shift;
                    if (!(frame[i] & 128)) break;
                }
                say(QStringLiteral(R"({"t":"drawn","n":%1})").arg(number));
            });
            socket.open(QUrl(QStringLiteral("ws://127.0.0.1:%1/panel-stream").arg(served.server->port())));
        }
        void say(const QString& text) { socket.sendTextMessage(text); }
        bool isShown() {
            return waitUntil([&] { return !panel.isEmpty(); });
        }
        bool logIn(const char* name, const char* password) {
            const int before = answers;
            say(QStringLiteral(R"({"t":"login","text":"%1","more":"%2"})")
                    .arg(QLatin1String(password), QLatin1String(name)));
            return waitUntil([&] { return answers > before; }) && login["ok"].toBool();
        }
        void press(int y) { say(QStringLiteral(R"({"t":"down","x":60,"y":%1})").arg(y)); }
    };

    QStringList trail() const {
        QStringList out;
        const auto read = hmi::readAudit(folder.path() + QStringLiteral("/.stepwise/audit.csv"));
        EXPECT_TRUE(read);
        if (!read) return out;
        EXPECT_EQ(read->firstBroken, 0) << "two writers";
        for (const hmi::AuditEntry& one : read->entries) out += one.user + u':' + one.action;
        return out;
    }

    QTemporaryDir folder;
    Served served;
};

TEST_F(ServedPeople, AUserLogsInByNameAndPasswordAndHasTheirOwnRights) {
    Guest anna(served);
    ASSERT_TRUE(anna.isShown());
    EXPECT_TRUE(anna.panel["people"].toBool());
    EXPECT_EQ(anna.panel["operator"].toString(), "");
    anna.press(50);
    EXPECT_FALSE(anna.logIn("anna", "something else"));
    EXPECT_FALSE(anna.logIn("bert", kPassword));
    EXPECT_FALSE(anna.logIn("", kPassword));
    EXPECT_EQ(served.number("Main.start"), 0) << "nobody is logged in";
    ASSERT_TRUE(anna.logIn("anna", kPassword));
    ASSERT_TRUE(waitUntil([&] { return anna.panel["operator"].toString() == "anna"; }));
    anna.press(50);
    EXPECT_TRUE(waitUntil([&] { return served.number("Main.start") == 1; }));
    anna.say(R"({"t":"up","x":60,"y":50})");
    anna.press(230); // for the service only
    anna.say(R"({"t":"up","x":60,"y":230})");
    anna.say(R"({"t":"logout"})");
    EXPECT_TRUE(waitUntil([&] { return anna.panel["operator"].toString().isEmpty(); }));
    EXPECT_EQ(served.number("Main.stop"), 0);
}

TEST_F(ServedPeople, SeveralBrowsersWriteOneUnbrokenTrail) {
    Guest one(served), two(served);
    ASSERT_TRUE(one.isShown() && two.isShown());
    ASSERT_TRUE(one.logIn("anna", kPassword));
    EXPECT_FALSE(two.logIn("anna", "wrong, surely"));
    ASSERT_TRUE(two.logIn("anna", kPassword));
    one.say(R"({"t":"logout"})");
    ASSERT_TRUE(waitUntil([&] { return one.panel["operator"].toString().isEmpty(); }));
    EXPECT_EQ(trail().join(u' ').toStdString(), "anna:log in :log in refused anna:log in anna:log out");
}

TEST_F(ServedPeople, WhoGuessesWaitsWhateverNamesAndConnectionsAreTried) {
    for (int i = 0; i < 10; ++i) {
        Guest stranger(served);
        ASSERT_TRUE(stranger.isShown());
        EXPECT_FALSE(stranger.logIn(i % 2 ? "anna" : "root", "guess"));
    }
    Guest late(served);
    ASSERT_TRUE(late.isShown());
    EXPECT_FALSE(late.logIn("anna", kPassword)) << "ten wrong ones from this address within a minute";
    EXPECT_TRUE(late.login["text"].toString().contains("Too many")) << late.login["text"].toString().toStdString();
}

} // namespace
} // namespace plc::serve
