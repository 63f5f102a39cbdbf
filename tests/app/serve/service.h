// `stepwise serve` in a process of its own, for tests that start, ask and kill it. Owned by a test; main thread.
#pragma once
#include "chromium.h"
#include "tests/support/paths.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTcpSocket>
#include <QUrl>
#include <gtest/gtest.h>

namespace plc::serve {

/// A service in a process of its own, on any free port.
struct Service {
    QProcess process;
    QString url;
    explicit Service(const QStringList& words, const QString& port = "0") {
        process.start(QString::fromStdString(binaryDir() + "/bin/stepwise"),
                      QStringList{"serve", "--port", port} + words);
        EXPECT_TRUE(
            waitUntil([&] { return process.canReadLine() || process.state() == QProcess::NotRunning; }, 60'000));
        url = QString::fromUtf8(process.readLine()).section(u' ', -1).trimmed();
        EXPECT_TRUE(url.startsWith("http")) << process.readAllStandardError().toStdString();
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
