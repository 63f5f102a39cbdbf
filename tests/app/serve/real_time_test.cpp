// `stepwise serve` as a service of systemd and in real time: what it reports to the service manager, what it asks of
// the machine, and its figures of late scans.
#include "chromium.h"
#include "served.h"
#include "tests/support/patience.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <csignal>
#include <sched.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace plc::serve {
namespace {

/// The service manager's end of NOTIFY_SOCKET.
class Manager {
public:
    explicit Manager(const QString& path) : m_socket(::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::strncpy(address.sun_path, path.toUtf8().constData(), sizeof address.sun_path - 1);
        EXPECT_EQ(::bind(m_socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    }
    ~Manager() { ::close(m_socket); }
    /// How often a message with these words has come.
    int count(const QByteArray& words) {
        char text[4096];
        for (ssize_t n = 0; (n = ::recv(m_socket, text, sizeof text, 0)) > 0;) m_all.push_back({text, int(n)});
        return static_cast<int>(
            std::count_if(m_all.begin(), m_all.end(), [&](const auto& m) { return m.contains(words); }));
    }

private:
    int m_socket;
    std::vector<QByteArray> m_all;
};

class RealTime : public ::testing::Test {
protected:
    void start(const QStringList& words, const QMap<QString, QString>& variables = {}) {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        for (auto it = variables.begin(); it != variables.end(); ++it) environment.insert(it.key(), it.value());
        process.setProcessEnvironment(environment);
        process.start(QString::fromStdString(binaryDir() + "/bin/stepwise"),
                      QStringList{"serve", QString::fromStdString(exampleFolder("motor")), "--port", "0", "--state",
                                  folder.filePath("state")} +
                          words);
        ASSERT_TRUE(waitUntil([&] {
            said += process.readAllStandardOutput();
            return said.contains("access-code") || process.state() == QProcess::NotRunning;
        })) << said.toStdString();
        ASSERT_EQ(process.state(), QProcess::Running) << process.readAllStandardError().toStdString();
    }
    void stop() {
        ::kill(static_cast<pid_t>(process.processId()), SIGTERM);
        ASSERT_TRUE(process.waitForFinished(kPatience));
        said += process.readAllStandardOutput();
        EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    }
    [[nodiscard]] std::optional<pid_t> scanThread() const {
        const QString tasks = QString("/proc/%1/task").arg(process.processId());
        for (const QString& task : QDir(tasks).entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
            QFile name(tasks + "/" + task + "/comm");
            if (name.open(QIODevice::ReadOnly) && name.readAll().trimmed() == "scan") return task.toInt();
        }
        return {};
    }
    QTemporaryDir folder;
    QProcess process;
    QByteArray said;
};

TEST_F(RealTime, TheServiceManagerHearsThatItIsReadyAliveAndStopping) {
    const QString path = folder.filePath("notify");
    Manager manager(path);
    start({}, {{"NOTIFY_SOCKET", path}, {"WATCHDOG_USEC", "600000"}});
    EXPECT_TRUE(waitUntil([&] { return manager.count("READY=1") == 1; }));
    EXPECT_EQ(manager.count("STATUS=serving Motor"), 1);
    EXPECT_TRUE(waitUntil([&] { return manager.count("WATCHDOG=1") >= 3; }));
    EXPECT_EQ(manager.count("STOPPING=1"), 0);
    stop();
    EXPECT_EQ(manager.count("STOPPING=1"), 1);
}

TEST_F(RealTime, WithoutAWatchdogNobodyIsTold) {
    const QString path = folder.filePath("notify");
    Manager manager(path);
    start({}, {{"NOTIFY_SOCKET", path}});
    stop();
    EXPECT_EQ(manager.count("READY=1"), 1);
    EXPECT_EQ(manager.count("WATCHDOG=1"), 0);
}

TEST_F(RealTime, WhatTheMachineGrantsIsSoAndEveryWishIsAnswered) {
    start({"--core", "0"});
    for (const char* wish : {"memory locked: ", "scan thread on core 0: ", "scan thread at SCHED_FIFO priority 60: "}) {
        const qsizetype at = said.indexOf(wish);
        ASSERT_GE(at, 0) << said.toStdString();
        const QByteArray answer = said.mid(at + static_cast<qsizetype>(std::strlen(wish)));
        EXPECT_TRUE(answer.startsWith("granted\n") || answer.startsWith("not granted (")) << said.toStdString();
    }
    std::optional<pid_t> thread;
    ASSERT_TRUE(waitUntil([&] { return (thread = scanThread()).has_value(); }));
    if (said.contains("priority 60: granted")) {
        EXPECT_EQ(::sched_getscheduler(*thread), SCHED_FIFO);
    }
    cpu_set_t cores;
    ASSERT_EQ(::sched_getaffinity(*thread, sizeof cores, &cores), 0);
    if (said.contains("core 0: granted")) {
        EXPECT_EQ(CPU_COUNT(&cores), 1);
    }
    stop();
}

TEST_F(RealTime, StatisticsHaveWakeUpExecutionAndEndOfScan) {
    start({"--stats"});
    std::optional<pid_t> thread; // has its name a moment after the start
    EXPECT_TRUE(waitUntil([&] { return (thread = scanThread()).has_value(); }));
    EXPECT_TRUE(waitUntil([&, begin = std::chrono::steady_clock::now()] {
        return std::chrono::steady_clock::now() - begin > std::chrono::milliseconds(500);
    }));
    stop();
    for (const char* words : {"wake-up: mean ", "execution: mean ", "end of scan: mean ", " us late and ran "})
        EXPECT_TRUE(said.contains(words)) << words << "\n" << said.toStdString();
}

TEST(ScanTimes, TheWorstAreKeptAndTheHistogramsCountAll) {
    session::ScanTimes times;
    for (uint64_t n = 0; n < 1000; ++n)
        times.add({n, std::chrono::milliseconds(n), static_cast<int64_t>((n * 7919) % 1000) * 1000, 500});
    EXPECT_EQ(times.wakeUp.count(), 1000u);
    EXPECT_EQ(times.wakeUp.mostNs(), 999'000);
    EXPECT_EQ(times.execution.buckets()[0], 1000u) << "below a microsecond";
    uint64_t all = 0;
    for (const uint64_t count : times.end.buckets()) all += count;
    EXPECT_EQ(all, 1000u);
    ASSERT_EQ(times.worst.size(), session::ScanTimes::kWorst);
    for (size_t i = 0; i < times.worst.size(); ++i)
        EXPECT_EQ(times.worst[i].wakeUpNs, static_cast<int64_t>(999 - i) * 1000);
}

} // namespace
} // namespace plc::serve
