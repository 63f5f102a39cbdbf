// `stepwise lsp`, `dap` and `mcp` as the processes that a client starts: over real pipes, to their end.
#include "tests/support/paths.h"
#include "tests/support/patience.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace plc {
namespace {

/// A server, asked and answered; it fails the test when an answer does not come.
class Peer {
public:
    Peer(const QStringList& words, bool hasHeads) : m_hasHeads(hasHeads) {
        m_process.start(QString::fromStdString(binaryDir() + "/bin/stepwise"), words);
        EXPECT_TRUE(m_process.waitForStarted(kPatience));
    }
    ~Peer() {
        m_process.kill();
        m_process.waitForFinished(kPatience);
    }
    void send(const QByteArray& message, const QByteArray& next = {}) {
        QByteArray bytes;
        for (const QByteArray& each : {message, next})
            if (!each.isEmpty())
                bytes +=
                    m_hasHeads ? "Content-Length: " + QByteArray::number(each.size()) + "\r\n\r\n" + each : each + "\n";
        m_process.write(bytes);
    }
    const QJsonObject read() { // const: the values in it are not references
        QByteArray message;
        while (!take(message))
            if (!m_process.waitForReadyRead(2 * kPatience) && m_process.bytesAvailable() == 0) {
                ADD_FAILURE() << "no message came; " << m_process.readAllStandardError().toStdString();
                return {};
            }
        return QJsonDocument::fromJson(message).object();
    }
    /// The first message with that value of a field.
    const QJsonObject readUntil(const char* field, const QJsonValue& value) {
        for (;;) {
            const QJsonObject message = read();
            if (message.isEmpty() || message[field] == value) return message;
        }
    }
    int end() {
        m_process.closeWriteChannel();
        EXPECT_TRUE(m_process.waitForFinished(kPatience));
        return m_process.exitCode();
    }
    const QJsonObject call(const char* tool, const QJsonObject& arguments) {
        const QJsonObject request{{"jsonrpc", "2.0"},
                                  {"id", ++m_id},
                                  {"method", "tools/call"},
                                  {"params", QJsonObject{{"name", tool}, {"arguments", arguments}}}};
        send(QJsonDocument(request).toJson(QJsonDocument::Compact));
        return readUntil("id", m_id)["result"].toObject();
    }

private:
    bool take(QByteArray& message) {
        m_bytes += m_process.readAllStandardOutput();
        if (!m_hasHeads) {
            const qsizetype end = m_bytes.indexOf('\n');
            if (end < 0) return false;
            message = m_bytes.left(end);
            m_bytes.remove(0, end + 1);
            return true;
        }
        const qsizetype head = m_bytes.indexOf("\r\n\r\n");
        if (head < 0) return false;
        const qsizetype length = m_bytes.mid(16, head - 16).toLongLong();
        if (m_bytes.size() < head + 4 + length) return false;
        message = m_bytes.mid(head + 4, length);
        m_bytes.remove(0, head + 4 + length);
        return true;
    }
    QProcess m_process;
    bool m_hasHeads;
    QByteArray m_bytes;
    int m_id = 100;
};

QString source(const char* path) { return QString::fromStdString(sourceDir()) + "/" + path; }

std::string textOf(const QJsonObject& result) {
    std::string out;
    for (const QJsonValue& each : result["content"].toArray()) out += each["text"].toString().toStdString() + "\n";
    return out;
}

bool hasPicture(const QJsonObject& result) {
    for (const QJsonValue& each : result["content"].toArray())
        if (each["type"] == "image" &&
            QByteArray::fromBase64(each["data"].toString().toLatin1()).startsWith("\x89PNG\r\n"))
            return true;
    return false;
}

// ---------------------------------------------------------------- editors

TEST(Lsp, EndsAsTheProtocolSays) {
    Peer polite({"lsp", "--stdio"}, true);
    polite.send(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}})");
    EXPECT_EQ(polite.read()["id"], 1);
    polite.send(R"({"jsonrpc":"2.0","id":2,"method":"shutdown"})");
    EXPECT_EQ(polite.read()["id"], 2);
    polite.send(R"({"jsonrpc":"2.0","method":"exit"})");
    EXPECT_EQ(polite.end(), 0);
    Peer sudden({"lsp"}, true);
    EXPECT_EQ(sudden.end(), 1) << "the client went without a word";
}

TEST(Lsp, AnswersACancelledRequestWithoutWorkingOnIt) {
    Peer peer({"lsp"}, true);
    peer.send(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}})");
    EXPECT_EQ(peer.read()["id"], 1);
    // Both in one piece: the second is there when the first is begun.
    peer.send(R"({"jsonrpc":"2.0","id":7,"method":"workspace/symbol","params":{}})",
              R"({"jsonrpc":"2.0","method":"$/cancelRequest","params":{"id":7}})");
    EXPECT_EQ(peer.read()["error"]["code"], -32800);
}

TEST(Lsp, ShowsTheValuesOfARunningController) {
    QTemporaryDir folder;
    const QString program = folder.filePath("main.st"), state = folder.filePath("state");
    const QByteArray text = "PROGRAM Main\nVAR n : DINT := 7; END_VAR\nn := n;\nEND_PROGRAM\n";
    QFile file(program);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    file.close();
    QProcess service;
    service.start(QString::fromStdString(binaryDir() + "/bin/stepwise"),
                  {"serve", program, "--port", "0", "--state", state});
    while (service.state() != QProcess::NotRunning && !service.canReadLine()) service.waitForReadyRead(1000);
    const QString url = QString::fromUtf8(service.readLine()).section(u' ', -1).trimmed();
    ASSERT_TRUE(url.startsWith("http")) << service.readAllStandardError().toStdString();
    Peer peer({"lsp", "--attach", url, "--code", state + "/attach-code"}, true);
    peer.send(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":)"
              R"({"workspace":{"inlayHint":{"refreshSupport":true}}}}})");
    EXPECT_TRUE(peer.readUntil("id", 1)["result"]["capabilities"]["inlayHintProvider"].toBool());
    const QJsonObject document{{"uri", "file://" + program}, {"version", 1}, {"text", QString::fromUtf8(text)}};
    const QJsonObject opened{
        {"jsonrpc", "2.0"}, {"method", "textDocument/didOpen"}, {"params", QJsonObject{{"textDocument", document}}}};
    peer.send(QJsonDocument(opened).toJson(QJsonDocument::Compact));
    const auto hints = [&](int id) {
        peer.send(QByteArray(R"({"jsonrpc":"2.0","id":)") + QByteArray::number(id) +
                  R"(,"method":"textDocument/inlayHint","params":{"textDocument":{"uri":"file://)" + program.toUtf8() +
                  R"("},"range":{"start":{"line":2,"character":0},"end":{"line":3,"character":0}}}})");
        return peer.readUntil("id", id)["result"].toArray();
    };
    EXPECT_TRUE(hints(2).isEmpty()) << "what is wanted is only known now";
    EXPECT_EQ(peer.readUntil("method", "workspace/inlayHint/refresh")["method"], "workspace/inlayHint/refresh");
    EXPECT_EQ(hints(3).at(0).toObject()["label"], "n = 7");
    service.kill();
    service.waitForFinished(kPatience);
    EXPECT_EQ(peer.readUntil("method", "workspace/inlayHint/refresh")["method"], "workspace/inlayHint/refresh");
    EXPECT_TRUE(hints(4).isEmpty()) << "it is gone";
}

TEST(Lsp, SaysWhatIsMissingToAttach) {
    QProcess process;
    process.start(QString::fromStdString(binaryDir() + "/bin/stepwise"), {"lsp", "--attach", "http://127.0.0.1:1/"});
    ASSERT_TRUE(process.waitForFinished(kPatience));
    EXPECT_EQ(process.exitCode(), 2);
    EXPECT_TRUE(process.readAllStandardError().contains("--code"));
}

TEST(Dap, StopsAtTheEntryAndStepsBack) {
    Peer peer({"dap"}, true);
    peer.send(R"({"seq":1,"type":"request","command":"initialize","arguments":{}})");
    EXPECT_TRUE(peer.read()["body"]["supportsStepBack"].toBool());
    const QJsonObject launch{
        {"seq", 2},
        {"type", "request"},
        {"command", "launch"},
        {"arguments", QJsonObject{{"program", source("tests/projects/debug_adapter/plant")}, {"stopOnEntry", true}}}};
    peer.send(QJsonDocument(launch).toJson(QJsonDocument::Compact));
    (void)peer.readUntil("event", "initialized");
    peer.send(R"({"seq":3,"type":"request","command":"configurationDone"})");
    EXPECT_EQ(peer.readUntil("event", "stopped")["body"]["reason"], "entry");
    int sequence = 3;
    for (const char* command : {"next", "next", "stepBack"}) {
        const QJsonObject request{{"seq", ++sequence},
                                  {"type", "request"},
                                  {"command", command},
                                  {"arguments", QJsonObject{{"threadId", 1}}}};
        peer.send(QJsonDocument(request).toJson(QJsonDocument::Compact));
        EXPECT_EQ(peer.readUntil("event", "stopped")["body"]["reason"], "step") << command;
    }
    peer.send(R"({"seq":9,"type":"request","command":"evaluate","arguments":{"expression":"Main.scans"}})");
    EXPECT_EQ(peer.readUntil("request_seq", 9)["body"]["result"], "1");
    peer.send(R"({"seq":10,"type":"request","command":"disconnect"})");
    EXPECT_TRUE(peer.readUntil("request_seq", 10)["success"].toBool());
    EXPECT_EQ(peer.end(), 0);
}

// ---------------------------------------------------------------- assistants

TEST(Mcp, ChecksRunsTestsAndExplains) {
    Peer peer({"mcp"}, false);
    peer.send(R"({"jsonrpc":"2.0","id":1,"method":"initialize","params":{"protocolVersion":"2025-06-18"}})");
    EXPECT_EQ(peer.read()["result"]["serverInfo"]["name"], "stepwise");
    peer.send(R"({"jsonrpc":"2.0","method":"notifications/initialized"})");
    peer.send(R"({"jsonrpc":"2.0","id":2,"method":"tools/list"})");
    const QJsonArray tools = peer.read()["result"]["tools"].toArray();
    EXPECT_EQ(tools.size(), 13);
    const QString motor = source("projects/examples/motor");
    EXPECT_EQ(textOf(peer.call("check", {{"project", motor}})), "[]\n\n");
    const std::string run = textOf(peer.call("run", {{"project", motor},
                                                     {"for", "2s"},
                                                     {"set", QJsonArray{"Plant.StartButton=TRUE@1s"}},
                                                     {"watch", QJsonArray{"IO.K1"}}}));
    EXPECT_NE(run.find("\"IO.K1\":true"), std::string::npos) << run;
    const QJsonObject test = peer.call("test", {{"project", motor}});
    EXPECT_NE(textOf(test).find("starts, holds and stops"), std::string::npos) << textOf(test);
    const std::string why = textOf(peer.call("why", {{"project", motor},
                                                     {"expression", "IO.K1"},
                                                     {"at", "1.5s"},
                                                     {"set", QJsonArray{"Plant.StartButton=TRUE@1s"}}}));
    EXPECT_NE(why.find("Plant.StartButton"), std::string::npos) << why;
    const std::string mistaken = textOf(peer.call("library", {{"name", "TON"}}));
    EXPECT_NE(mistaken.find("has no argument name; it takes words"), std::string::npos) << mistaken;
    const std::string found = textOf(peer.call("library", {{"words", "TON"}}));
    EXPECT_NE(found.find("TON"), std::string::npos);
    EXPECT_EQ(peer.end(), 0);
}

TEST(Mcp, DrawsTracesAndPanels) {
    Peer peer({"mcp"}, false);
    const QJsonObject trace = peer.call(
        "trace",
        {{"project", source("projects/examples/pid_pt1")}, {"channels", QJsonArray{"IO.Measured"}}, {"for", "5s"}});
    EXPECT_TRUE(hasPicture(trace)) << textOf(trace);
    EXPECT_NE(textOf(trace).find("IO.Measured"), std::string::npos) << textOf(trace);
    const QString texts = source("projects/examples/alarm_texts");
    const QJsonObject panels = peer.call("panel", {{"project", texts}, {"at", "1s"}});
    EXPECT_TRUE(hasPicture(panels));
    EXPECT_NE(textOf(panels).find(".png"), std::string::npos) << textOf(panels);
    EXPECT_EQ(textOf(panels).find('/'), std::string::npos) << "a folder that is gone: " << textOf(panels);
    EXPECT_FALSE(peer.call("panel_findings", {{"project", texts}})["isError"].toBool());
}

TEST(Mcp, WritesToARunningControllerOnlyWithLeave) {
    const QJsonObject motor{{"project", source("projects/examples/motor")}};
    const QJsonObject press{{"path", "Plant.StartButton"}, {"value", "TRUE"}};
    const QJsonObject watch{{"watch", QJsonArray{"Plant.StartButton"}}};
    for (const bool allows : {false, true}) {
        Peer peer(allows ? QStringList{"mcp", "--allow-writes"} : QStringList{"mcp"}, false);
        EXPECT_TRUE(peer.call("live_values", watch)["isError"].toBool()) << "nothing runs";
        EXPECT_FALSE(peer.call("live_start", motor)["isError"].toBool());
        for (const char* tool : {"live_write", "live_force"}) {
            const QJsonObject done = peer.call(tool, press);
            EXPECT_EQ(done["isError"].toBool(), !allows) << textOf(done);
        }
        const std::string values = textOf(peer.call("live_values", watch));
        EXPECT_NE(values.find(allows ? "\"Plant.StartButton\":\"TRUE\"" : "\"Plant.StartButton\":\"FALSE\""),
                  std::string::npos)
            << values;
        EXPECT_FALSE(peer.call("live_stop", {})["isError"].toBool());
    }
}

TEST(Mcp, RefusesWhatIsNoCallAndEndsWhatTakesTooLong) {
    Peer peer({"mcp", "--timeout", "1s"}, false);
    peer.send("this is not JSON");
    EXPECT_EQ(peer.read()["error"]["code"], -32700);
    peer.send(R"({"jsonrpc":"2.0","id":1,"method":"tools/call","params":{"name":"format_disk"}})");
    EXPECT_EQ(peer.read()["error"]["code"], -32602);
    const QString motor = source("projects/examples/motor");
    for (const QJsonObject& arguments :
         {QJsonObject{}, QJsonObject{{"project", 5}}, QJsonObject{{"project", "--record=x"}},
          QJsonObject{{"project", motor}, {"record", "x"}}, QJsonObject{{"project", motor}, {"watch", "IO.K1"}},
          QJsonObject{{"project", "/nowhere"}}})
        EXPECT_TRUE(peer.call("run", arguments)["isError"].toBool()) << QJsonDocument(arguments).toJson().toStdString();
    const QJsonObject endless = peer.call("run", {{"project", motor}, {"for", "100000h"}});
    EXPECT_TRUE(endless["isError"].toBool());
    EXPECT_NE(textOf(endless).find("took longer than 1 s"), std::string::npos) << textOf(endless);
}

} // namespace
} // namespace plc
