// `stepwise serve` in a process of its own, for tests that start, ask and kill it. Owned by a test; main thread.
#pragma once
#include "chromium.h"
#include "tests/support/paths.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTcpSocket>
#include <QUrl>
#include <gtest/gtest.h>

#include <unistd.h>

namespace plc::serve {

/// A service in a process of its own, on any free port. STEPWISE_PROGRAM: another build of it, for figures.
struct Service {
    QProcess process;
    QString url;
    explicit Service(const QStringList& words, const QString& port = "0") {
        process.start(qEnvironmentVariable("STEPWISE_PROGRAM", QString::fromStdString(binaryDir() + "/bin/stepwise")),
                      QStringList{"serve", "--port", port} + words);
        EXPECT_TRUE(waitUntil([&] { return process.canReadLine() || process.state() == QProcess::NotRunning; }));
        url = QString::fromUtf8(process.readLine()).section(u' ', -1).trimmed();
        EXPECT_TRUE(url.startsWith("http")) << process.readAllStandardError().toStdString();
    }
    /// Of the service since it began.
    double processorSeconds() const {
        QFile file(QStringLiteral("/proc/%1/stat").arg(process.processId()));
        if (!file.open(QIODevice::ReadOnly)) return 0;
        const QList<QByteArray> fields = file.readAll().split(')').last().simplified().split(' '); // behind the name
        return (fields.value(11).toDouble() + fields.value(12).toDouble()) /
               static_cast<double>(::sysconf(_SC_CLK_TCK));
    }
    QJsonObject status() const {
        QTcpSocket socket;
        const QUrl place(url);
        socket.connectToHost(place.host(), static_cast<quint16>(place.port()));
        socket.write("GET /status HTTP/1.1\r\nHost: x\r\n\r\n");
        QByteArray answer;
        waitUntil([&] {
            answer += socket.readAll();
            return socket.state() == QAbstractSocket::UnconnectedState;
        });
        answer += socket.readAll();
        return QJsonDocument::fromJson(answer.mid(answer.indexOf("\r\n\r\n") + 4)).object();
    }
};

} // namespace plc::serve
