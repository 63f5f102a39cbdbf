// `stepwise serve` as a process: started, asked, stopped, killed.
#include "chromium.h"
#include "served.h"
#include "service.h"

#include "projects/session/versions.h"

#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QProcess>
#include <QTcpSocket>
#include <csignal>

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
        ASSERT_TRUE(service.process.waitForFinished(20'000));
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
        ASSERT_TRUE(service.process.waitForFinished());
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
        EXPECT_TRUE(process.waitForFinished(60'000));
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
    EXPECT_NE(answer({"--state", files.folder.filePath("other"), "--port", port}).find("Nothing can listen at"),
              std::string::npos);
}

} // namespace
} // namespace plc::serve
