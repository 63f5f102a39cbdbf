#include "chromium.h"

#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTest>
#include <gtest/gtest.h>

namespace plc::serve {

bool waitUntil(const std::function<bool()>& condition, int milliseconds) {
    QElapsedTimer clock;
    clock.start();
    while (!condition()) {
        if (clock.elapsed() > milliseconds) return false;
        QTest::qWait(2); // a duration: how often it is asked; QTest::qWaitFor asks every 10 ms
    }
    return true;
}

Chromium::Chromium() {
    if (!start() && m_problem.isEmpty()) m_problem = QString::fromLocal8Bit(m_process.readAllStandardError());
}

bool Chromium::start() {
    m_process.setProcessChannelMode(QProcess::SeparateChannels);
    m_process.start(QStringLiteral("chromium"),
                    {"--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
                     "--disable-background-networking", "--disable-extensions", "--disable-sync",
                     "--disable-background-timer-throttling", "--disable-renderer-backgrounding",
                     "--disable-backgrounding-occluded-windows", "--force-color-profile=srgb", "--hide-scrollbars",
                     "--force-device-scale-factor=1", "--ignore-certificate-errors", "--remote-allow-origins=*",
                     "--remote-debugging-port=0", "--user-data-dir=" + m_profile.path(), "about:blank"});
    if (!m_process.waitForStarted(kPatience)) {
        m_problem = QStringLiteral("chromium cannot be started: ") + m_process.errorString();
        return false;
    }
    QStringList lines;
    const QString file = m_profile.filePath(QStringLiteral("DevToolsActivePort"));
    const bool isThere = waitUntil([&] {
        QFile port(file);
        if (!port.open(QIODevice::ReadOnly)) return false;
        lines = QString::fromUtf8(port.readAll()).split(u'\n');
        return lines.size() >= 2 && !lines[1].isEmpty();
    });
    if (!isThere) return false;
    QObject::connect(&m_socket, &QWebSocket::textMessageReceived, &m_socket, [this](const QString& text) {
        const QJsonObject message = QJsonDocument::fromJson(text.toUtf8()).object();
        if (message.contains("id")) m_answers.insert(message["id"].toInt(), message);
    });
    m_socket.open(QUrl(QStringLiteral("ws://127.0.0.1:%1%2").arg(lines[0], lines[1])));
    return waitUntil([this] { return isRunning(); });
}

Chromium::~Chromium() {
    if (isRunning()) call(QStringLiteral("Browser.close"), {});
    if (m_process.state() != QProcess::NotRunning && !m_process.waitForFinished(10'000)) {
        m_process.kill();
        m_process.waitForFinished(10'000);
    }
}

QJsonObject Chromium::call(const QString& method, const QJsonObject& parameters, const QString& session) {
    const int id = ++m_last;
    QJsonObject message{{"id", id}, {"method", method}, {"params", parameters}};
    if (!session.isEmpty()) message["sessionId"] = session;
    m_socket.sendTextMessage(QString::fromUtf8(QJsonDocument(message).toJson(QJsonDocument::Compact)));
    EXPECT_TRUE(waitUntil([&] { return m_answers.contains(id) || !isRunning(); })) << method.toStdString();
    const QJsonObject answer = m_answers.take(id);
    EXPECT_FALSE(answer.contains("error")) << QJsonDocument(answer).toJson().toStdString();
    return answer["result"].toObject();
}

std::unique_ptr<Page> Chromium::open(const QString& url, QSize size) {
    const QString target =
        call(QStringLiteral("Target.createTarget"), {{"url", "about:blank"}, {"newWindow", true}})["targetId"]
            .toString();
    const QString session =
        call(QStringLiteral("Target.attachToTarget"), {{"targetId", target}, {"flatten", true}})["sessionId"]
            .toString();
    call(QStringLiteral("Emulation.setDeviceMetricsOverride"),
         {{"width", size.width()}, {"height", size.height()}, {"deviceScaleFactor", 1}, {"mobile", false}}, session);
    call(QStringLiteral("Page.navigate"), {{"url", url}}, session);
    return std::make_unique<Page>(*this, target, session);
}

QHash<QString, double> Chromium::processorSeconds() {
    QHash<QString, double> out;
    const QJsonObject answer = call(QStringLiteral("SystemInfo.getProcessInfo"), {});
    for (const QJsonValue& process : answer["processInfo"].toArray())
        out[process["type"].toString()] += process["cpuTime"].toDouble();
    return out;
}

Page::Page(Chromium& browser, QString target, QString session)
    : m_browser(browser), m_target(std::move(target)), m_session(std::move(session)) {}

Page::~Page() {
    if (m_browser.isRunning()) m_browser.call(QStringLiteral("Target.closeTarget"), {{"targetId", m_target}});
}

QJsonObject Page::call(const QString& method, const QJsonObject& parameters) {
    return m_browser.call(method, parameters, m_session);
}

QJsonValue Page::evaluate(const QString& expression) {
    const QJsonObject answer = call(QStringLiteral("Runtime.evaluate"),
                                    {{"expression", expression}, {"returnByValue", true}, {"awaitPromise", true}});
    EXPECT_FALSE(answer.contains("exceptionDetails")) << QJsonDocument(answer).toJson().toStdString();
    return answer["result"].toObject()["value"];
}

bool Page::waitFor(const QString& expression, int milliseconds) {
    const QString guarded =
        QStringLiteral("(async () => { try { return !!(%1); } catch (_) { return false; } })()").arg(expression);
    return waitUntil([&] { return evaluate(guarded).toBool(); }, milliseconds);
}

void Page::mouse(const char* type, QPointF at) {
    call(QStringLiteral("Input.dispatchMouseEvent"),
         {{"type", type},
          {"x", at.x()},
          {"y", at.y()},
          {"button", "left"},
          {"buttons", QLatin1String(type) == QLatin1String("mouseReleased") ? 0 : 1},
          {"clickCount", 1}});
}

void Page::click(QPointF at) {
    const auto origin = [&](const char* side) {
        return evaluate(QStringLiteral("document.getElementById('canvas').getBoundingClientRect().%1")
                            .arg(QLatin1String(side)))
            .toDouble();
    };
    at += QPointF(origin("left"), origin("top"));
    mouse("mousePressed", at);
    mouse("mouseReleased", at);
}

void Page::key(const QString& key) {
    QJsonObject down{{"type", "keyDown"}, {"key", key}};
    if (key.size() == 1) down["text"] = key;
    call(QStringLiteral("Input.dispatchKeyEvent"), down);
    call(QStringLiteral("Input.dispatchKeyEvent"), {{"type", "keyUp"}, {"key", key}});
}

QImage Page::canvas() {
    const QString url = evaluate(QStringLiteral("stepwise.display.pictures().then(all => all[0])")).toString();
    return QImage::fromData(QByteArray::fromBase64(url.section(u',', 1).toLatin1()), "PNG");
}

QImage Page::screenshot() {
    const QString data = call(QStringLiteral("Page.captureScreenshot"), {{"format", "png"}})["data"].toString();
    return QImage::fromData(QByteArray::fromBase64(data.toLatin1()), "PNG");
}

} // namespace plc::serve
