// `stepwise serve` as a process: started, asked, stopped, killed.
#include "chromium.h"
#include "served.h"
#include "service.h"
#include "tests/support/patience.h"

#include "projects/session/versions.h"
#include "runtime/controller/retain.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QJsonDocument>
#include <QProcess>
#include <QTcpServer>
#include <QTcpSocket>
#include <csignal>
#include <cstring>
#include <iostream>

namespace plc::serve {
namespace {

constexpr const char* kKeeper = R"(
PROGRAM Main
VAR RETAIN n : DINT; END_VAR
n := n + 1;
END_PROGRAM
CONFIGURATION C RESOURCE R ON PLC
    TASK T(INTERVAL := T#10ms, PRIORITY := 1);
    PROGRAM Main WITH T : Main;
END_RESOURCE END_CONFIGURATION
)";

struct Files {
    QTemporaryDir folder;
    QString program = folder.filePath("main.st"), state = folder.filePath("state");
    Files() {
        QFile file(program);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(kKeeper);
    }
};

TEST(ServeCommand, RunsUntilItIsAskedToStopAndKeepsEverything) {
    const Files files;
    for (int start = 0; start < 2; ++start) {
        Service service({files.program, "--state", files.state});
        ASSERT_TRUE(waitUntil([&] { return service.status()["scans"].toDouble() > 50; }));
        ::kill(static_cast<pid_t>(service.process.processId()), SIGTERM);
        ASSERT_TRUE(service.process.waitForFinished(kPatience));
        EXPECT_EQ(service.process.exitCode(), 0);
        EXPECT_TRUE(service.process.readAllStandardOutput().contains("stopped after "));
        EXPECT_EQ(QDir(files.state + "/recording").entryList({"*.rec"}).size(), start + 1);
    }
    QFile code(files.state + "/access-code");
    ASSERT_TRUE(code.open(QIODevice::ReadOnly));
    EXPECT_EQ(code.readAll().size(), 17);
    EXPECT_EQ(code.permissions() & (QFile::ReadGroup | QFile::ReadOther), QFile::Permissions());
}

/// The number of the newest scan that a recording holds.
double lastScanOf(const QString& path) {
    driver::Built built;
    const auto loaded = history::History::load(path.toStdString(), [&](const history::History::Sources& sources) {
        built = driver::build(session::recordedInput(sources));
        return built.program;
    });
    EXPECT_TRUE(loaded) << path.toStdString();
    if (!loaded || (*loaded)->statistics().end == 0) return -1;
    return static_cast<double>((*loaded)->stamp((*loaded)->statistics().end - 1)->scan);
}

TEST(ServeCommand, KilledAtAnyMomentItHasLostNoMoreThanASecond) {
    const Files files;
    const int kills = qEnvironmentVariableIsSet("STEPWISE_LONG") ? 100 : 3;
    double atLeast = 0;
    for (int i = 0; i < kills; ++i) {
        Service service({files.program, "--state", files.state});
        EXPECT_TRUE(service.status()["retain_problem"].isNull());
        const double want = 330 + 37 * (i % 5); // scans of 10 ms: past some saves
        double scans = 0;
        ASSERT_TRUE(waitUntil([&] { return (scans = service.status()["scans"].toDouble()) >= want; }));
        service.process.kill();
        ASSERT_TRUE(service.process.waitForFinished(kPatience));
        // A second, and as much again for a machine that does other things as well.
        constexpr double kLost = 200;
        atLeast += scans - kLost;
        const QFileInfoList written =
            QDir(files.state + "/recording").entryInfoList({"*.rec"}, QDir::Files, QDir::Name);
        ASSERT_FALSE(written.isEmpty());
        EXPECT_GE(lastScanOf(written.last().filePath()), scans - kLost) << "kill " << i;
    }
    // What was retained goes on from start to start.
    session::Settings settings;
    settings.retainFile = (files.state + "/retained").toStdString();
    driver::BuildInput input;
    input.files.push_back({"main.st", kKeeper});
    session::Session session(driver::build(input), settings);
    EXPECT_TRUE(session.status().retainProblem.isEmpty()) << session.status().retainProblem.english();
    const auto value = session.controller().read("Main.n");
    ASSERT_TRUE(value);
    EXPECT_GE(std::get<int64_t>(value->data), static_cast<int64_t>(atLeast));
    // Every recording opens.
    for (const QFileInfo& file : QDir(files.state + "/recording").entryInfoList({"*.rec"})) {
        driver::Built built;
        const auto loaded =
            history::History::load(file.filePath().toStdString(), [&](const history::History::Sources& sources) {
                driver::BuildInput again;
                for (const auto& [name, text] : sources.files) again.files.push_back({name, text});
                built = driver::build(again);
                return built.program;
            });
        EXPECT_TRUE(loaded) << file.fileName().toStdString();
    }
}

TEST(ServeCommand, SaysWhyItCannotStart) {
    const Files files;
    const auto answer = [&](const QStringList& words) {
        QProcess process;
        process.start(QString::fromStdString(binaryDir() + "/bin/stepwise"),
                      QStringList{"serve", files.program} + words);
        EXPECT_TRUE(process.waitForFinished(kPatience));
        EXPECT_EQ(process.exitCode(), 2);
        return process.readAllStandardError().toStdString();
    };
    EXPECT_NE(answer({"--port", "70000"}).find("is not a port"), std::string::npos);
    EXPECT_NE(answer({"--address", "here"}).find("is not an address"), std::string::npos);
    EXPECT_NE(answer({"--certificate", "x"}).find("belong together"), std::string::npos);
    EXPECT_NE(answer({"--state", "/proc/x"}).find("cannot be created"), std::string::npos);
    EXPECT_NE(answer({"--state", files.state, "--certificate", "no.pem", "--key", "no.pem"})
                  .find("The certificate cannot be read"),
              std::string::npos);
    const Service service({files.program, "--state", files.state});
    const QString port = QString::number(QUrl(service.url).port());
    EXPECT_NE(answer({"--state", files.state}).find("Another server already works"), std::string::npos);
    EXPECT_NE(answer({"--state", files.folder.filePath("other"), "--port", port}).find("cannot be used"),
              std::string::npos);
}

// ---------------------------------------------------------------- a day in test time

constexpr const char* kPlant = R"(
PROGRAM Main
VAR RETAIN n : DINT; END_VAR
VAR level AT %IW0 : INT; set AT %QW0 : INT; isGood : BOOL; heard : DINT; END_VAR
n := n + 1;
set := DINT_TO_INT(n MOD 30_000);
IF isGood AND level > 0 THEN heard := heard + 1; END_IF;
END_PROGRAM
CONFIGURATION C RESOURCE R ON PLC
    TASK T(INTERVAL := T#10ms, PRIORITY := 1);
    PROGRAM Main WITH T : Main;
END_RESOURCE END_CONFIGURATION
)";

/// A plant with two devices: a server that shows what it sets, and a client that reads it there again.
struct Plant {
    QTemporaryDir folder;
    QString project = folder.filePath("plant"), state = folder.filePath("state");
    Plant() {
        QTcpServer probe;
        EXPECT_TRUE(probe.listen(QHostAddress::LocalHost));
        const QString port = QString::number(probe.serverPort());
        probe.close();
        EXPECT_TRUE(QDir().mkpath(project + "/src"));
        write("project.json", "{\"name\": \"Plant\"}\n");
        write("src/main.st", kPlant);
        write("devices.json",
              R"({"devices": [{"name": "Panel", "protocol": "modbus-server", "host": "127.0.0.1", "port": %1,
                    "channels": [{"name": "Set", "variable": "%QW0", "address": 0}]},
                   {"name": "Pump", "protocol": "modbus-tcp", "host": "127.0.0.1", "port": %1, "poll": "20ms",
                    "channels": [{"name": "Level", "variable": "%IW0", "address": 0, "quality": "Main.isGood"}]}]})");
        replace("devices.json", port);
    }
    void write(const QString& name, const QByteArray& text) const {
        QFile file(project + "/" + name);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    void replace(const QString& name, const QString& port) const {
        QFile file(project + "/" + name);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll().replace("\"port\": %1", "\"port\": " + port.toUtf8());
        file.close();
        write(name, text);
    }
};

/// What the process holds in memory, in bytes.
double residentOf(const QProcess& process) {
    QFile file(QStringLiteral("/proc/%1/statm").arg(process.processId()));
    if (!file.open(QIODevice::ReadOnly)) return 0;
    return file.readAll().split(' ').value(1).toDouble() * 4096;
}

double bytesBelow(const QString& folder) {
    double bytes = 0;
    for (QDirIterator it(folder, QDir::Files, QDirIterator::Subdirectories); it.hasNext();) {
        it.next();
        bytes += static_cast<double>(it.fileInfo().size());
    }
    return bytes;
}

double retainedCount(const QString& state) {
    const auto leaves = controller::loadRetain((state + "/retained").toStdString());
    EXPECT_TRUE(leaves);
    if (!leaves || leaves->empty()) return -1;
    int32_t count = 0;
    EXPECT_EQ(leaves->front().bytes.size(), sizeof count);
    std::memcpy(&count, leaves->front().bytes.data(), sizeof count);
    return count;
}

/// The whole service in virtual time, with its devices, ring, retain and pages: every scan of the task is made, memory
/// and disk stay within what they may take, and the end is as exact as any.
TEST(ServeCommand, ADayOnTrialIsWholeAndStaysWithinItsLimits) {
    const Plant plant;
    const int hours = qEnvironmentVariableIsSet("STEPWISE_LONG") ? 24 : 1;
    const double scans = hours * 3600 * 100.0, limit = 4 << 20;
    Service service({plant.project, "--state", plant.state, "--devices", "--recording-size", "4M", "--trial",
                     QStringLiteral("%1h").arg(hours)});
    double most = 0, early = 0, disk = 0;
    ASSERT_TRUE(waitUntil(
        [&] {
            most = std::max(most, residentOf(service.process));
            disk = std::max(disk, bytesBelow(plant.state));
            if (early == 0 && service.process.state() == QProcess::Running &&
                service.status()["scans"].toDouble() >= scans / 4)
                early = most;
            return service.process.state() == QProcess::NotRunning;
        },
        20 * kPatience));
    EXPECT_EQ(service.process.exitCode(), 0) << service.process.readAllStandardError().toStdString();
    const QString said = QString::fromUtf8(service.process.readAllStandardOutput());
    const double done = said.section("stopped after ", 1).section(' ', 0, 0).toDouble();
    EXPECT_EQ(done, scans + 1) << "from the first scan at 0 to the one at the end: " << said.toStdString();
    EXPECT_EQ(retainedCount(plant.state), done) << "what is retained is of the last scan";
    const QFileInfoList files = QDir(plant.state + "/recording").entryInfoList({"*.rec"}, QDir::Files, QDir::Name);
    ASSERT_FALSE(files.isEmpty());
    EXPECT_EQ(lastScanOf(files.last().filePath()), done - 1) << "the recording has the last scan";
    std::cout << done << " scans; memory " << early / 1048576 << " MB early, " << most / 1048576 << " MB at most; disk "
              << disk / 1048576 << " MB at most\n";
    constexpr double kHistory = 64 << 20, kSlack = 24 << 20;
    if (early > 0) {
        EXPECT_LE(most, early + kHistory + kSlack);
    }
    EXPECT_LE(disk, 3 * limit) << "the ring, the file that is being written, and the ten worst scans";
}

/// An example of the package is not written into.
TEST(ServeCommand, SaysWhereItKeepsWhatOutlivesIt) {
    const Files files;
    Service service({files.program, "--state", files.state});
    ASSERT_TRUE(waitUntil([&] { return service.status()["scans"].toDouble() > 0; }));
    ::kill(static_cast<pid_t>(service.process.processId()), SIGTERM);
    ASSERT_TRUE(service.process.waitForFinished(kPatience));
    EXPECT_TRUE(service.process.readAllStandardOutput().contains("retained variables and the recording are in " +
                                                                 files.state.toUtf8()));
}

} // namespace
} // namespace plc::serve
