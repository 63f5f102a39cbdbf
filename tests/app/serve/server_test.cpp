// The server seen from outside: pages, status, metrics; strangers, floods and browsers that hang.
#include "chromium.h"
#include "served.h"

#include "tests/hmi/running.h"

#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTcpSocket>

namespace plc::serve {
namespace {

void openMachine(Served& served, ServerSettings settings = {}) {
    served.panels = hmi::machineProject();
    served.panels.panels.push_back(
        {QStringLiteral("main"),
         hmi::panelOf(R"({"id": "go", "kind": "button", "rect": [20, 20, 160, 60], "target": "Main.start"},
            {"id": "n", "kind": "number", "rect": [20, 100, 160, 60], "value": "Main.count"})")});
    served.panels.startPanel = QStringLiteral("main");
    driver::BuildInput input;
    input.files.push_back({"main.st", hmi::kMachine});
    served.build(input, std::move(settings));
}

/// What the server answers to bytes; all of it, until it closes.
QByteArray ask(const Served& served, const QByteArray& bytes) {
    QTcpSocket socket;
    socket.connectToHost(QStringLiteral("127.0.0.1"), served.server->port());
    socket.write(bytes);
    QByteArray answer;
    EXPECT_TRUE(waitUntil([&] {
        answer += socket.readAll();
        return socket.state() == QAbstractSocket::UnconnectedState;
    }));
    return answer + socket.readAll();
}
QByteArray get(const Served& served, const QByteArray& path) {
    return ask(served, "GET " + path + " HTTP/1.1\r\nHost: x\r\n\r\n");
}

/// A browser without a screen: it draws on request.
struct Client {
    QWebSocket socket;
    QList<QJsonObject> texts;
    int frames = 0;
    qint64 bytes = 0;
    uint32_t last = 0;
    bool draws = true;
    explicit Client(const Served& served, const QString& hello = QStringLiteral(R"({"t":"hello","n":1})")) {
        QObject::connect(&socket, &QWebSocket::textMessageReceived, &socket, [this](const QString& text) {
            bytes += text.size();
            texts += QJsonDocument::fromJson(text.toUtf8()).object();
        });
        QObject::connect(&socket, &QWebSocket::binaryMessageReceived, &socket, [this](const QByteArray& frame) {
            bytes += frame.size();
            ++frames;
            last = 0;
            for (qsizetype i = 0, shift = 0; i < frame.size(); ++i, shift += 7) {
                last |= static_cast<uint32_t>(frame[i] & 127) << shift;
                if (!(frame[i] & 128)) break;
            }
            if (draws) say(QStringLiteral(R"({"t":"drawn","n":%1})").arg(last));
        });
        QObject::connect(&socket, &QWebSocket::connected, &socket, [this, hello] { say(hello); });
        socket.open(QUrl(QStringLiteral("ws://127.0.0.1:%1/panel-stream").arg(served.server->port())));
    }
    void say(const QString& text) { socket.sendTextMessage(text); }
    bool isClosed() const { return socket.state() == QAbstractSocket::UnconnectedState; }
};

TEST(Pages, AreThoseThatPeopleOpenTheStartPanelFirst) {
    hmi::PanelProject project;
    for (const auto& [name, fields] : {std::pair{"alarms", "{}"},
                                       {"detail", R"({"parameters": [{"name": "valve"}]})"},
                                       {"frame", "{}"},
                                       {"main", "{}"}})
        project.panels.push_back({QLatin1String(name), *hmi::Panel::parse(fields, QLatin1String(name))});
    project.frame = QStringLiteral("frame");
    project.startPanel = QStringLiteral("main");
    EXPECT_EQ(hmi::web::pagesOf(project), (QStringList{"main", "alarms"}));
    project.startPanel = QStringLiteral("detail");
    EXPECT_EQ(hmi::web::pagesOf(project), (QStringList{"alarms", "main"}));
}

TEST(Server, PagesStatusAndMetricsSayWhatRuns) {
    Served served;
    ServerSettings settings;
    settings.name = "machine <1>";
    openMachine(served, settings);
    served.machine->startThread({session::Pace::Real});
    ASSERT_TRUE(waitUntil([&] { return served.machine->status().scans > 20; }));
    EXPECT_TRUE(get(served, "/").contains("machine &lt;1&gt;"));
    const QByteArray status = get(served, "/status");
    const QJsonObject json = QJsonDocument::fromJson(status.mid(status.indexOf("\r\n\r\n") + 4)).object();
    EXPECT_EQ(json["state"].toString(), "running") << status.toStdString();
    EXPECT_GT(json["scans"].toInt(), 20);
    EXPECT_EQ(json["tasks"].toArray()[0].toObject()["name"].toString(), "T");
    const QByteArray metrics = get(served, "/metrics");
    for (const char* line :
         {"stepwise_state{state=\"running\"} 1\n", "# TYPE stepwise_task_duration_seconds histogram\n",
          "stepwise_task_duration_seconds_bucket{task=\"T\",le=\"+Inf\"}"})
        EXPECT_TRUE(metrics.contains(line)) << line << metrics.toStdString();
    EXPECT_TRUE(get(served, "/panel").contains("302 Found\r\n"));
    EXPECT_TRUE(get(served, "/panel/main").contains("<canvas"));
    EXPECT_TRUE(get(served, "/panel/none").startsWith("HTTP/1.1 404"));
    EXPECT_TRUE(ask(served, "POST / HTTP/1.1\r\nHost: x\r\n\r\n").startsWith("HTTP/1.1 405"));
    EXPECT_TRUE(ask(served, "nonsense\r\n\r\n").startsWith("HTTP/1.1 400"));
}

TEST(Server, AStrangersPageGetsNoPanel) {
    Served served;
    openMachine(served);
    const QByteArray answer =
        ask(served,
            "GET /panel-stream HTTP/1.1\r\nHost: plant\r\nOrigin: http://elsewhere\r\nUpgrade: websocket\r\n"
            "Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n");
    EXPECT_TRUE(answer.startsWith("HTTP/1.1 403")) << answer.toStdString();
}

TEST(Server, WhoDoesNotSpeakLikeABrowserIsClosed) {
    Served served;
    openMachine(served);
    for (const char* bad : {"nonsense", R"({"t":"down","x":1})", R"({"t":"down","x":1e8,"y":0})",
                            R"({"t":"drawn","n":4000})", R"({"t":"hello","n":1})"}) {
        Client client(served);
        ASSERT_TRUE(waitUntil([&] { return client.frames > 0; }));
        client.say(QLatin1String(bad));
        EXPECT_TRUE(waitUntil([&] { return client.isClosed(); })) << bad;
    }
    Client early(served, QStringLiteral(R"({"t":"cancel"})"));
    EXPECT_TRUE(waitUntil([&] { return early.isClosed(); }));
    Client large(served);
    ASSERT_TRUE(waitUntil([&] { return large.frames > 0; }));
    large.say(QString(100'000, u'x'));
    EXPECT_TRUE(waitUntil([&] { return large.isClosed(); }));
    Client flood(served);
    ASSERT_TRUE(waitUntil([&] { return flood.frames > 0; }));
    for (int i = 0; i < 5000; ++i) flood.say(QStringLiteral(R"({"t":"move","x":1,"y":1})"));
    EXPECT_TRUE(waitUntil([&] { return flood.isClosed(); }));
    EXPECT_TRUE(waitUntil([&] { return served.server->figures().browsers == 0; }));
    EXPECT_GE(served.server->figures().droppedBrowsers, 7u);
}

TEST(Server, ABrowserThatHangsGetsNothingMoreAndComesBackWithTheWholePicture) {
    Served served;
    ServerSettings settings;
    settings.link.drawnWithin = 600'000;
    openMachine(served, settings);
    served.machine->startThread({session::Pace::Real});
    Client hanging(served), other(served);
    ASSERT_TRUE(waitUntil([&] { return hanging.frames > 2 && other.frames > 2; }));
    hanging.draws = false;
    const int frames = hanging.frames;
    const uint64_t scans = served.machine->status().scans;
    ASSERT_TRUE(waitUntil([&] { return other.frames > 60; }));
    EXPECT_LE(hanging.frames, frames + 3);
    EXPECT_GT(served.machine->status().scans, scans + 50);
    hanging.draws = true;
    hanging.say(QStringLiteral(R"({"t":"drawn","n":%1})").arg(hanging.last));
    EXPECT_TRUE(waitUntil([&] { return hanging.frames > frames + 10; }));
}

/// What one browser had recorded is the other's as well only if both are at the same moment. A clock that gives each
/// that asks another half of the blinking would show the lamp on to one of them for ever, and off to the other.
TEST(Server, AllBrowsersAreAtTheSameMoment) {
    Served served;
    ServerSettings settings;
    qint64 asked = 0;
    settings.clock = [&asked] { return asked++ % 2 * 500; };
    served.panels = hmi::machineProject();
    served.panels.panels.push_back(
        {QStringLiteral("main"),
         hmi::panelOf(R"({"id": "l", "kind": "lamp", "rect": [20, 20, 60, 60], "value": "TRUE", "blink": true})")});
    served.panels.startPanel = QStringLiteral("main");
    driver::BuildInput input;
    input.files.push_back({"main.st", hmi::kMachine});
    served.build(input, std::move(settings));
    served.machine->startThread({session::Pace::Real});
    Client one(served), two(served);
    ASSERT_TRUE(waitUntil([&] { return one.frames > 0 && two.frames > 0; }));
    const int first = one.frames, second = two.frames;
    EXPECT_TRUE(waitUntil([&] { return one.frames > first + 6 && two.frames > second + 6; }));
}

/// Waits without turning the event loop: the server does nothing meanwhile.
bool scansGoOn(const session::Session& machine, uint64_t count) {
    const uint64_t before = machine.status().scans;
    QElapsedTimer clock;
    clock.start();
    while (machine.status().scans < before + count)
        if (clock.elapsed() > kPatience) return false;
    return true;
}

TEST(Server, AClientThatHangsCostsTheScanNothing) {
    Served served;
    ServerSettings settings;
    settings.link.drawnWithin = 600'000;
    openMachine(served, settings);
    served.machine->startThread({session::Pace::Real});
    // This one opens a panel and never takes a byte off the line.
    QTcpSocket deaf;
    deaf.setReadBufferSize(1);
    deaf.connectToHost(QStringLiteral("127.0.0.1"), served.server->port());
    deaf.write("GET /panel-stream HTTP/1.1\r\nHost: x\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
               "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n");
    deaf.write(QByteArray("\x81\x93", 2) + QByteArray(4, 0) + R"({"t":"hello","n":1})"); // a masked text of 19 bytes
    Client other(served);
    ASSERT_TRUE(waitUntil([&] { return other.frames > 2 && served.server->figures().browsers == 2; }));
    ASSERT_TRUE(waitUntil([&] { return other.frames > 30; }));
    const uint64_t toDeaf = served.server->figures().sentFrames - static_cast<uint64_t>(other.frames);
    EXPECT_LE(toDeaf, 4u) << "it gets what is drawn, and it draws nothing";
    // Even a server that comes to nothing at all leaves the controller alone: it scans in a thread of its own.
    EXPECT_TRUE(scansGoOn(*served.machine, 50));
    EXPECT_FALSE(served.machine->status().fault);
    for (const controller::TaskStatistics& task : served.machine->taskStatistics())
        EXPECT_GT(task.count, 50u) << task.name;
}

TEST(Server, ABrowserThatNeverDrawsIsDroppedInTheEnd) {
    Served served;
    ServerSettings settings;
    settings.link.drawnWithin = 300;
    openMachine(served, settings);
    served.machine->startThread({session::Pace::Real});
    Client hanging(served);
    hanging.draws = false;
    EXPECT_TRUE(waitUntil([&] { return hanging.frames > 0 && hanging.isClosed(); }));
}

/// A machine that has other work for minutes, or is suspended, hears nobody meanwhile.
TEST(Server, ABrowserIsNotDroppedForTheSilenceOfTheServerItself) {
    Served served;
    ServerSettings settings;
    SleepingClock clock(settings);
    openMachine(served, settings);
    served.machine->startThread({session::Pace::Real});
    Client client(served);
    client.draws = false;
    ASSERT_TRUE(waitUntil([&] { return client.frames == settings.link.framesAhead; }));
    ASSERT_TRUE(clock.sleep(200'000)) << "it goes on before it hears what the browser says";
    client.draws = true;
    client.say(QStringLiteral(R"({"t":"drawn","n":%1})").arg(client.last));
    const int frames = client.frames;
    ASSERT_TRUE(waitUntil([&] { return client.frames > frames + 3 || client.isClosed(); }));
    EXPECT_FALSE(client.isClosed()) << client.socket.closeReason().toStdString();
}

TEST(Server, TheCodeLetsOperateAndNothingElseDoes) {
    Served served;
    openMachine(served);
    served.machine->startThread({session::Pace::Real});
    Client client(served);
    ASSERT_TRUE(waitUntil([&] { return client.frames > 0; }));
    const auto press = [&] {
        client.say(QStringLiteral(R"({"t":"down","x":60,"y":50})"));
        client.say(QStringLiteral(R"({"t":"up","x":60,"y":50})"));
    };
    const auto has = [&](const char* kind) {
        return waitUntil([&] {
            return std::any_of(client.texts.begin(), client.texts.end(),
                               [&](const QJsonObject& o) { return o["t"] == kind; });
        });
    };
    press();
    EXPECT_TRUE(has("refused"));
    client.say(QStringLiteral(R"({"t":"login","text":"correct hors"})"));
    EXPECT_TRUE(has("login"));
    EXPECT_EQ(served.server->figures().refusedLogIns, 1u);
    EXPECT_EQ(served.number("Main.presses"), 0);
    client.say(QStringLiteral(R"({"t":"login","text":"correct horse"})"));
    EXPECT_TRUE(waitUntil([&] { return served.server->figures().operators == 1; }));
    press();
    EXPECT_TRUE(waitUntil([&] { return served.number("Main.presses") == 1; }));
    client.say(QStringLiteral(R"({"t":"down","x":60,"y":50})"));
    EXPECT_TRUE(waitUntil([&] { return served.number("Main.start") == 1; }));
    client.socket.abort(); // the cable is pulled while the button is down
    EXPECT_TRUE(waitUntil([&] { return served.number("Main.start") == 0; }));
}

TEST(Server, SlowAndManyConnectionsGetNowhere) {
    Served served;
    ServerSettings settings;
    settings.listener = {8, 8, 200};
    openMachine(served, settings);
    std::vector<std::unique_ptr<QTcpSocket>> sockets;
    for (int i = 0; i < 20; ++i) {
        sockets.push_back(std::make_unique<QTcpSocket>());
        sockets.back()->connectToHost(QStringLiteral("127.0.0.1"), served.server->port());
        sockets.back()->write("GET / HT"); // and nothing more
    }
    EXPECT_TRUE(waitUntil([&] {
        return std::all_of(sockets.begin(), sockets.end(),
                           [](const auto& one) { return one->state() == QAbstractSocket::UnconnectedState; });
    }));
    EXPECT_GE(served.server->figures().refusedConnections, 20u);
    EXPECT_TRUE(waitUntil([&] { return get(served, "/").startsWith("HTTP/1.1 200"); }));
}

} // namespace
} // namespace plc::serve
