// Studios and command lines at a served controller: what they can do, and that strangers get nowhere.
#include "service.h"

#include "editor/remote/attached_run.h"
#include "projects/remote/errors.h"
#include "projects/session/value_text.h"
#include "runtime/debug/sites.h"
#include "served.h"
#include "tests/hmi/running.h"
#include "tests/support/patience.h"

#include <QFile>
#include <QTcpServer>
#include <QTcpSocket>
#include <QWebSocket>
#include <array>
#include <csignal>

namespace plc::serve {
namespace {

using editor::AttachedRun;
using editor::RemoteController;
using remote::Json;
using State = RemoteController::State;

constexpr const char* kAttachCode = "attach by this";
constexpr const char* kPlant = R"(
PROGRAM Main
VAR RETAIN n : DINT; END_VAR
VAR speed : REAL := 1.5; lamp : BOOL; text : STRING(20) := 'idle'; END_VAR
VAR CONSTANT k : INT := 3; END_VAR
n := n + 1;
lamp := n MOD 2 = 0;
END_PROGRAM
CONFIGURATION C RESOURCE R ON PLC
    TASK T(INTERVAL := T#5ms, PRIORITY := 1);
    PROGRAM Main WITH T : Main;
END_RESOURCE END_CONFIGURATION
)";

/// A controller in this process that studios can attach to.
struct Plant : Served {
    explicit Plant(AttachSettings attach = {kAttachCode}, ServerSettings settings = {}) {
        settings.name = "plant";
        settings.attach = attach;
        driver::BuildInput input;
        input.files.push_back({"main.st", kPlant});
        build(input, std::move(settings));
        machine->startThread({session::Pace::Real});
    }
    RemoteController::Address address(const QString& code = kAttachCode) const {
        return {QUrl(server->url()), code, {}, "test"};
    }
};

/// What is said to one request, the event loop turning meanwhile.
Result<Json> ask(RemoteController& controller, const Json& request) {
    std::optional<Result<Json>> out;
    controller.ask(request, [&](const Result<Json>& answer) { out = answer; });
    EXPECT_TRUE(waitUntil([&] { return out.has_value(); }));
    return out ? *out : Result<Json>(Error{remote::errors::NotUnderstood(), {}});
}

/// Of braces alone nlohmann::json would make an object.
Json pairs(const std::vector<std::array<const char*, 2>>& all) {
    Json out = Json::array();
    for (const auto& [path, text] : all) out.push_back(Json::array({path, text}));
    return out;
}

bool isAttached(RemoteController& controller, const RemoteController::Address& address) {
    EXPECT_TRUE(controller.attach(address));
    return waitUntil([&] { return controller.state() == State::Attached || controller.state() == State::Detached; }) &&
           controller.state() == State::Attached;
}

TEST(Attach, ReadsWritesForcesAndReleases) {
    const Plant plant;
    RemoteController controller;
    ASSERT_TRUE(isAttached(controller, plant.address()));
    EXPECT_EQ(controller.project(), "plant");
    const auto listed = ask(controller, {{"do", "list"}, {"filter", "SPEED"}});
    ASSERT_TRUE(listed);
    EXPECT_EQ((*listed)["variables"].dump(), R"([["Main.speed","REAL"]])");
    ASSERT_TRUE(ask(controller, {{"do", "write"}, {"values", pairs({{"Main.speed", "2.25"}, {"Main.text", "'on'"}})}}));
    const auto values = ask(controller, {{"do", "read"}, {"watch", {"Main.speed * 2", "Main.text", "Main.none"}}});
    ASSERT_TRUE(values);
    EXPECT_EQ((*values)["values"][0]["value"], "4.5");
    EXPECT_EQ((*values)["values"][1]["value"], "'on'");
    EXPECT_TRUE((*values)["values"][2].contains("reason"));
    ASSERT_TRUE(ask(controller, {{"do", "force"}, {"values", pairs({{"Main.lamp", "TRUE"}})}}));
    EXPECT_TRUE(waitUntil([&] { return plant.machine->forces().size() == 1; }));
    const auto refused = ask(controller, {{"do", "write"}, {"values", pairs({{"Main.lamp", "FALSE"}})}});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().english().find("is forced"), std::string::npos);
    ASSERT_TRUE(ask(controller, {{"do", "unforce"}, {"path", "main.LAMP"}}));
    EXPECT_TRUE(waitUntil([&] { return plant.machine->forces().empty(); }));
    for (const Json& wrong : {Json{{"do", "write"}, {"values", pairs({{"Main.speed", "many"}})}},
                              Json{{"do", "write"}, {"values", pairs({{"Main.none", "1"}})}}, Json{{"do", "write"}},
                              Json{{"do", "force"}, {"values", 7}}, Json{{"do", "unforce"}, {"path", "Main.speed"}},
                              Json{{"do", "reset"}, {"kind", "sideways"}}, Json{{"do", "dance"}}, Json::object()})
        EXPECT_FALSE(ask(controller, wrong)) << wrong.dump();
    EXPECT_EQ(controller.state(), State::Attached) << "a wrong request is answered, not punished";
}

TEST(Attach, AStudioIsNotDroppedForTheSilenceOfTheServerItself) {
    ServerSettings settings;
    SleepingClock clock(settings);
    const Plant plant({kAttachCode}, std::move(settings));
    RemoteController controller;
    ASSERT_TRUE(isAttached(controller, plant.address()));
    ASSERT_TRUE(clock.sleep(0)); // until frames of this studio have passed
    ASSERT_TRUE(clock.sleep(200'000));
    EXPECT_TRUE(ask(controller, {{"do", "list"}, {"filter", "speed"}}));
    EXPECT_EQ(plant.server->figures().droppedBrowsers, 0u) << "it would have come back by itself";
}

TEST(Attach, TheMirrorRecordsTheSameScansBitForBit) {
    const Plant plant;
    AttachedRun run;
    std::unique_ptr<session::Session> mirror;
    QObject::connect(&run, &AttachedRun::sessionReady, &run, [&] { mirror = run.takeSession(); });
    ASSERT_TRUE(isAttached(run.controller(), plant.address()));
    ASSERT_TRUE(waitUntil([&] { return mirror != nullptr; }));
    EXPECT_TRUE(mirror->isMirror());
    ASSERT_TRUE(waitUntil([&] { return mirror->history().statistics().scans > 100; }));
    const history::Statistics here = mirror->history().statistics();
    size_t compared = 0;
    for (history::Position at = here.first; at < here.end; ++at) {
        const auto stamp = mirror->history().stamp(at);
        ASSERT_TRUE(stamp);
        const auto there = plant.machine->history().positionOfScan(stamp->scan);
        ASSERT_TRUE(there);
        EXPECT_EQ(plant.machine->history().seek(*there), mirror->history().seek(at)) << "scan " << stamp->scan;
        EXPECT_EQ(plant.machine->history().stamp(*there)->time, stamp->time);
        ++compared;
    }
    EXPECT_GT(compared, 100u);
    const session::Status status = mirror->status();
    EXPECT_EQ(status.state, controller::State::Running);
    EXPECT_FALSE(mirror->taskStatistics().empty());
    run.forget();
}

TEST(Attach, WhatIsAskedOfTheMirrorHappensThere) {
    const Plant plant;
    AttachedRun run;
    std::unique_ptr<session::Session> mirror;
    QObject::connect(&run, &AttachedRun::sessionReady, &run, [&] { mirror = run.takeSession(); });
    ASSERT_TRUE(isAttached(run.controller(), plant.address()));
    ASSERT_TRUE(waitUntil([&] { return mirror != nullptr; }));
    const auto valueOf = [&](const char* path) {
        const auto place = mirror->program()->layout.find(path);
        EXPECT_TRUE(place);
        return session::parseValue(mirror->built().checked, place->type, "7", path);
    };
    mirror->write("Main.speed", *valueOf("Main.speed"), "studio");
    EXPECT_TRUE(waitUntil([&] { return plant.number("Main.speed") == 7; }));
    mirror->force("Main.n", *valueOf("Main.n"), "studio");
    EXPECT_TRUE(waitUntil([&] { return mirror->forces().size() == 1; })) << "it comes back as the state from there";
    mirror->unforceAll();
    EXPECT_TRUE(waitUntil([&] { return plant.machine->forces().empty(); }));
    mirror->stop();
    EXPECT_TRUE(waitUntil([&] { return mirror->status().state == controller::State::Stopped; }));
    EXPECT_EQ(plant.machine->status().state, controller::State::Stopped);
    mirror->write("Main.speed", *valueOf("Main.speed"), "studio"); // seen although no scan is made
    mirror->start();
    EXPECT_TRUE(waitUntil([&] { return mirror->status().state == controller::State::Running; }));
    EXPECT_FALSE(mirror->resumeFrom(0)) << "a plant is not put back in time";
    mirror->setBreakpoints({session::Breakpoint{FileId(0u), 6}});
    std::vector<Error> refusals;
    EXPECT_TRUE(waitUntil([&] { return !(refusals = mirror->takeRefusals()).empty(); }));
    EXPECT_NE(refusals.front().english().find("--allow-breakpoints"), std::string::npos);
    driver::BuildInput next = *mirror->built().input;
    const auto at = next.files[0].text.find("n := n + 1;");
    next.files[0].text.replace(at, 11, "n := n + 1000;");
    std::optional<controller::OnlineChangeReport> report;
    mirror->changeProgram(driver::build(next), [&](const controller::OnlineChangeReport& made) { report = made; });
    ASSERT_TRUE(waitUntil([&] { return report.has_value(); }));
    EXPECT_TRUE(report->refusal.isEmpty()) << report->refusal.english();
    EXPECT_GT(report->kept.size(), 0u);
    EXPECT_TRUE(waitUntil([&] {
        return std::any_of(mirror->program()->sources.files.begin(), mirror->program()->sources.files.end(),
                           [](const SourceText& file) { return file.text().find("n + 1000") != std::string::npos; });
    })) << "the mirror follows";
    const auto scans = mirror->history().statistics().end;
    EXPECT_TRUE(waitUntil([&] { return mirror->history().statistics().end > scans + 10; }));
    run.forget();
}

TEST(Attach, BreakpointsHaltWhereTheyAreAllowedAndNeverOutliveTheLine) {
    const Plant plant({.code = kAttachCode, .mayHalt = true});
    AttachedRun run;
    std::unique_ptr<session::Session> mirror;
    QObject::connect(&run, &AttachedRun::sessionReady, &run, [&] { mirror = run.takeSession(); });
    ASSERT_TRUE(isAttached(run.controller(), plant.address()));
    ASSERT_TRUE(waitUntil([&] { return mirror != nullptr; }));
    const FileId file = debug::fileOfPath(*mirror->program(), "main.st");
    ASSERT_TRUE(file.isValid());
    mirror->setBreakpoints({session::Breakpoint{file, 7}});
    ASSERT_TRUE(waitUntil([&] { return mirror->status().state == controller::State::Halted; }));
    ASSERT_TRUE(waitUntil([&] { return !mirror->haltFrames().empty(); }));
    EXPECT_EQ(mirror->haltFrames().front().function, "Main");
    mirror->step(session::Step::Over);
    EXPECT_TRUE(waitUntil([&] { return mirror->status().halts >= 2; }));
    run.controller().detach(); // the cable is pulled
    EXPECT_TRUE(waitUntil([&] { return plant.machine->status().state == controller::State::Running; }));
    const uint64_t scans = plant.machine->status().scans;
    EXPECT_TRUE(waitUntil([&] { return plant.machine->status().scans > scans + 20; })) << "no breakpoint is left";
    run.forget();
}

TEST(Attach, AWrongCodeGetsNowhereAndGuessesAreSlowedDown) {
    const Plant plant;
    RemoteController wrong;
    EXPECT_FALSE(isAttached(wrong, plant.address("attach by that")));
    EXPECT_NE(wrong.problem().english().find("The code is wrong"), std::string::npos);
    for (int i = 0; i < 10; ++i) {
        RemoteController guess;
        EXPECT_FALSE(isAttached(guess, plant.address("guess")));
    }
    RemoteController right;
    EXPECT_FALSE(isAttached(right, plant.address())) << "from this address nobody is heard for a while";
    EXPECT_NE(right.problem().english().find("too many wrong codes"), std::string::npos);
    EXPECT_GE(plant.server->figures().refusedLogIns, 11u);
    EXPECT_EQ(plant.server->figures().studios, 0u);
}

/// What somebody says who does not use our program.
struct Stranger {
    QWebSocket socket;
    int answers = 0;
    explicit Stranger(const Plant& plant, const QList<QString>& words, const QString& origin = {}) : socket(origin) {
        QObject::connect(&socket, &QWebSocket::connected, &socket, [this, words] {
            for (const QString& word : words) socket.sendTextMessage(word);
        });
        QObject::connect(&socket, &QWebSocket::textMessageReceived, &socket, [this] { ++answers; });
        socket.open(QUrl(QStringLiteral("ws://127.0.0.1:%1/attach").arg(plant.server->port())));
    }
    bool isClosed() const { return socket.state() == QAbstractSocket::UnconnectedState; }
};

TEST(Attach, StrangersFloodsAndNonsenseAreClosed) {
    AttachSettings settings{kAttachCode};
    settings.codeWithin = 300;
    const Plant plant(settings);
    const QString hello = QStringLiteral(R"({"id":1,"do":"hello","code":"%1"})").arg(kAttachCode);
    for (const QList<QString>& words : {QList<QString>{},
                                        {R"({"id":1,"do":"state"})"},
                                        {"nonsense"},
                                        {"[]"},
                                        {"7"},
                                        {QString(100'000, u'x')},
                                        {QStringLiteral(R"({"do":"hello","code":["%1"]})").arg(kAttachCode)},
                                        {QStringLiteral(R"({"do":"hello"})")},
                                        {QString(3000, u'[')}}) {
        const Stranger stranger(plant, words);
        EXPECT_TRUE(waitUntil([&] { return stranger.isClosed(); })) << words.join(u'|').left(60).toStdString();
        EXPECT_LE(stranger.answers, 1);
    }
    QList<QString> flood{hello};
    for (int i = 0; i < 5000; ++i) flood.append(R"({"id":2,"do":"read","watch":["Main.n"]})");
    const Stranger flooding(plant, flood);
    EXPECT_TRUE(waitUntil([&] { return flooding.isClosed(); }));
    const Stranger page(plant, {hello}, "http://127.0.0.1");
    EXPECT_TRUE(waitUntil([&] { return page.isClosed(); })) << "no page in a browser may attach";
    EXPECT_EQ(page.answers, 0);
    EXPECT_TRUE(waitUntil([&] { return plant.server->figures().studios == 0; }));
    EXPECT_EQ(plant.machine->status().state, controller::State::Running);
    // Not that none was left out: a machine that does other things as well leaves some out by itself.
    const uint64_t scans = plant.machine->status().scans;
    EXPECT_TRUE(waitUntil([&] { return plant.machine->status().scans > scans + 20; })) << "no scan waits for them";
}

TEST(Attach, TheCodeNeverCrossesANetworkUnprotected) {
    EXPECT_TRUE(mayAttach(QHostAddress("127.0.0.1"), false));
    EXPECT_TRUE(mayAttach(QHostAddress("::1"), false));
    EXPECT_FALSE(mayAttach(QHostAddress("192.168.1.9"), false));
    EXPECT_FALSE(mayAttach(QHostAddress("fe80::9"), false));
    EXPECT_TRUE(mayAttach(QHostAddress("192.168.1.9"), true));
    RemoteController controller;
    const auto refused = controller.attach({QUrl("http://192.168.1.9:8080/"), kAttachCode, {}, "test"});
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().english().find("unencrypted"), std::string::npos);
    for (const char* wrong : {"", "ftp://plant/", "http://", "plant"})
        EXPECT_FALSE(controller.attach({QUrl(wrong), kAttachCode, {}, "test"})) << wrong;
}

/// A certificate that no authority has signed.
struct Certificate {
    QTemporaryDir folder;
    QString file = folder.filePath("plant.pem"), key = folder.filePath("plant.key");
    explicit Certificate(const QStringList& kind = {"ec", "-pkeyopt", "ec_paramgen_curve:prime256v1"}) {
        QProcess make;
        make.start("openssl",
                   QStringList{"req", "-x509", "-newkey"} + kind +
                       QStringList{"-nodes", "-days", "2", "-subj", "/CN=plant", "-keyout", key, "-out", file});
        EXPECT_TRUE(make.waitForFinished(kPatience));
        EXPECT_EQ(make.exitCode(), 0) << make.readAllStandardError().toStdString();
    }
};

TEST(Attach, ByTlsOnlyWithACertificateThatIsTrusted) {
    const Certificate certificate, other;
    ServerSettings settings;
    settings.certificate = certificate.file;
    settings.key = certificate.key;
    const Plant plant({kAttachCode}, settings);
    RemoteController trusting;
    RemoteController::Address address = plant.address();
    ASSERT_EQ(address.url.scheme(), "https");
    address.trustFile = certificate.file;
    EXPECT_TRUE(isAttached(trusting, address)) << trusting.problem().english();
    RemoteController strict;
    address.trustFile.clear();
    EXPECT_FALSE(isAttached(strict, address));
    EXPECT_NE(strict.problem().english().find("is not trusted"), std::string::npos) << strict.problem().english();
    RemoteController misled;
    address.trustFile = other.file;
    EXPECT_FALSE(isAttached(misled, address));
    RemoteController plain;
    address.url.setScheme("http");
    EXPECT_FALSE(isAttached(plain, address)) << "nothing is said without TLS";
    EXPECT_EQ(plant.server->figures().refusedLogIns, 0u) << "the code was not even heard";
    const std::string port = std::to_string(address.url.port());
    EXPECT_EQ(plain.problem().english(),
              "127.0.0.1 speaks TLS on this port; use the address https://127.0.0.1:" + port + "/");
}

TEST(Attach, WhereNobodySpeaksTlsIsSaidToo) {
    const Plant plant;
    RemoteController secure;
    RemoteController::Address address = plant.address();
    address.url.setScheme("https");
    EXPECT_FALSE(isAttached(secure, address));
    const std::string why = secure.problem().english();
    EXPECT_TRUE(
        why.starts_with("The server at 127.0.0.1:" + std::to_string(address.url.port()) + " does not speak TLS; "))
        << why;
    EXPECT_NE(why.find("--certificate"), std::string::npos) << why;
    RemoteController nobody; // nor anybody at all: the probe changes nothing about that
    QTcpServer free;
    ASSERT_TRUE(free.listen(QHostAddress::LocalHost));
    address.url = QUrl(QStringLiteral("http://127.0.0.1:%1/").arg(free.serverPort()));
    free.close();
    address.url.setScheme("https");
    EXPECT_FALSE(isAttached(nobody, address));
    EXPECT_EQ(nobody.problem().english(), "Nothing answers at 127.0.0.1:" + std::to_string(address.url.port()) +
                                              "; check the port, and whether `stepwise serve` runs there");
    address.url.setScheme("http");
    EXPECT_FALSE(isAttached(nobody, address));
    EXPECT_EQ(nobody.problem().english(), "Nothing answers at 127.0.0.1:" + std::to_string(address.url.port()) +
                                              "; check the port, and whether `stepwise serve` runs there");
}

TEST(Attach, AForeignServerIsNamedInWordsWithWhatToCheck) {
    for (const QByteArray& words :
         {QByteArray("HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n"), QByteArray("SSH-2.0-OpenSSH_9.2\r\n"),
          QByteArray("HTTP/1.1 302 Found\r\nLocation: /login\r\nContent-Length: 0\r\n\r\n"), QByteArray()}) {
        QTcpServer foreign;
        ASSERT_TRUE(foreign.listen(QHostAddress::LocalHost));
        QObject::connect(&foreign, &QTcpServer::newConnection, &foreign, [&] {
            QTcpSocket* client = foreign.nextPendingConnection();
            QObject::connect(client, &QTcpSocket::readyRead, client, [client, words] {
                client->readAll();
                client->write(words);
                client->disconnectFromHost();
            });
        });
        const std::string port = std::to_string(foreign.serverPort());
        RemoteController controller;
        EXPECT_FALSE(isAttached(
            controller,
            {QUrl(QStringLiteral("http://127.0.0.1:%1/").arg(foreign.serverPort())), kAttachCode, {}, "test"}));
        EXPECT_EQ(controller.problem().english(), "The server at 127.0.0.1:" + port +
                                                      " is not a controller started with `stepwise serve`; check the "
                                                      "host and the port")
            << words.toStdString();
    }
}

TEST(Attach, ACertificateServesWithItsOwnKeyOnly) {
    const QStringList curve384 = {"ec", "-pkeyopt", "ec_paramgen_curve:secp384r1"};
    for (const QStringList& kind : {QStringList{"ec", "-pkeyopt", "ec_paramgen_curve:prime256v1"}, curve384,
                                    QStringList{"rsa:2048"}, QStringList{"rsa:3072"}}) {
        const Certificate certificate(kind), other(kind);
        ServerSettings settings;
        settings.certificate = certificate.file;
        settings.key = certificate.key;
        const Plant plant({kAttachCode}, settings);
        RemoteController controller;
        RemoteController::Address address = plant.address();
        address.trustFile = certificate.file;
        EXPECT_TRUE(isAttached(controller, address)) << controller.problem().english();
        settings.key = other.key;
        Server mistaken(plant.panels, *plant.machine, byAccessCode(kCode), settings);
        const auto started = mistaken.start();
        ASSERT_FALSE(started) << kind.join(' ').toStdString();
        EXPECT_NE(started.error().english().find("does not belong to"), std::string::npos);
    }
}

struct Words {
    QByteArray out, err;
    int code = -1;
};
Words stepwise(const QStringList& words) {
    QProcess process;
    process.start(QString::fromStdString(binaryDir() + "/bin/stepwise"), words);
    EXPECT_TRUE(waitUntil([&] { return process.state() == QProcess::NotRunning; }, 2 * kPatience));
    return {process.readAllStandardOutput(), process.readAllStandardError(), process.exitCode()};
}

/// In processes of their own, on any free port.
struct Outside {
    QTemporaryDir folder;
    QString program = folder.filePath("main.st"), state = folder.filePath("state"), code = state + "/attach-code";
    Outside() { write(program, kPlant); }
    static void write(const QString& path, const QByteArray& text) {
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
};

TEST(AttachCommand, DoesItsWorkFromASecondProcessUnderLoad) {
    const Outside files;
    Service service({files.program, "--state", files.state});
    const auto attach = [&](QStringList words) {
        return stepwise(QStringList{"attach", service.url} + words + QStringList{"--code", files.code});
    };
    // Four that read as fast as they can, meanwhile.
    QFile code(files.code);
    ASSERT_TRUE(code.open(QIODevice::ReadOnly));
    const QString secret = QString::fromUtf8(code.readAll()).trimmed();
    std::vector<std::unique_ptr<AttachedRun>> others;
    for (int i = 0; i < 4; ++i) {
        others.push_back(std::make_unique<AttachedRun>());
        EXPECT_TRUE(isAttached(others.back()->controller(), {QUrl(service.url), secret, {}, "load"}));
    }
    EXPECT_TRUE(attach({}).out.startsWith("running, "));
    EXPECT_TRUE(attach({"list", "speed"}).out.contains("Main.speed : REAL\n"));
    EXPECT_EQ(attach({"write", "Main.speed", "8.5"}).code, 0);
    EXPECT_EQ(attach({"read", "Main.speed"}).out, "Main.speed = 8.5\n");
    EXPECT_EQ(attach({"force", "Main.text", "'held'"}).code, 0);
    EXPECT_TRUE(attach({"state"}).out.contains("forced: Main.text := 'held'"));
    EXPECT_EQ(attach({"release"}).code, 0);
    EXPECT_FALSE(attach({"state"}).out.contains("forced"));
    const Words watched = attach({"watch", "Main.n", "Main.speed", "--every", "20ms", "--for", "300ms"});
    EXPECT_TRUE(watched.out.startsWith("scan\tMain.n\tMain.speed\n")) << watched.out.toStdString();
    EXPECT_GE(watched.out.count('\n'), 3);
    const QString recording = files.folder.filePath("fetched.rec");
    EXPECT_EQ(attach({"recording", recording}).code, 0);
    const Words replayed = stepwise({"replay", recording, "--watch", "Main.speed"});
    EXPECT_EQ(replayed.code, 0) << replayed.err.toStdString();
    EXPECT_TRUE(replayed.out.contains("8.5")) << replayed.out.toStdString();
    EXPECT_EQ(attach({"sources", files.folder.filePath("copy")}).code, 0);
    QByteArray changed = kPlant;
    changed.replace("speed : REAL", "fresh : INT := 42; speed : REAL");
    Outside::write(files.program, changed);
    const Words change = attach({"change", files.program});
    EXPECT_EQ(change.code, 0) << change.err.toStdString();
    EXPECT_TRUE(change.out.contains(" 1 new")) << change.out.toStdString();
    EXPECT_EQ(attach({"read", "Main.fresh", "Main.speed"}).out, "Main.fresh = 42\nMain.speed = 8.5\n");
    EXPECT_EQ(attach({"stop"}).code, 0);
    EXPECT_TRUE(attach({"state"}).out.startsWith("stopped, "));
    EXPECT_EQ(attach({"start"}).code, 0);
    // Wrong use says what is wrong.
    EXPECT_EQ(attach({"write", "Main.speed", "fast"}).code, 2);
    EXPECT_EQ(attach({"dance"}).code, 2);
    EXPECT_EQ(attach({"write", "Main.speed"}).code, 2);
    Outside::write(files.folder.filePath("wrong"), "nonsense\n");
    const Words wrong = stepwise({"attach", service.url, "--code", files.folder.filePath("wrong")});
    EXPECT_EQ(wrong.code, 2);
    EXPECT_TRUE(wrong.err.contains("The code is wrong")) << wrong.err.toStdString();
    EXPECT_EQ(stepwise({"attach", service.url}).code, 2);
    ::kill(static_cast<pid_t>(service.process.processId()), SIGTERM);
    EXPECT_TRUE(service.process.waitForFinished(kPatience));
}

TEST(Attach, ComesBackByItselfWhenTheControllerWasRestarted) {
    const Outside files;
    auto service = std::make_unique<Service>(QStringList{files.program, "--state", files.state});
    QFile code(files.code);
    ASSERT_TRUE(code.open(QIODevice::ReadOnly));
    AttachedRun run;
    std::unique_ptr<session::Session> mirror;
    QObject::connect(&run, &AttachedRun::sessionReady, &run, [&] { mirror = run.takeSession(); });
    ASSERT_TRUE(
        isAttached(run.controller(), {QUrl(service->url), QString::fromUtf8(code.readAll()).trimmed(), {}, ""}));
    ASSERT_TRUE(waitUntil([&] { return mirror && mirror->history().statistics().scans > 20; }));
    const QString port = QString::number(QUrl(service->url).port());
    service->process.kill();
    service->process.waitForFinished(kPatience);
    ASSERT_TRUE(waitUntil([&] { return run.controller().state() == State::Lost; }));
    EXPECT_FALSE(run.controller().problem().isEmpty());
    service = std::make_unique<Service>(QStringList{files.program, "--state", files.state}, port);
    ASSERT_TRUE(waitUntil([&] { return run.controller().state() == State::Attached; }));
    const auto recorded = mirror->history().statistics().end;
    EXPECT_TRUE(waitUntil([&] { return mirror->history().statistics().end > recorded + 20; }));
    EXPECT_GE(mirror->history().branches().size(), 1u) << "what was recorded before stays";
    run.forget();
}

} // namespace
} // namespace plc::serve
