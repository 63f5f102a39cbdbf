// A headless Chromium that a test drives by the DevTools protocol: opens pages, runs scripts in them, presses and
// types. The calls turn the event loop meanwhile, so a server in the same process goes on. Owned by a test; main
// thread.
#pragma once
#include "tests/support/patience.h"

#include <QImage>
#include <QJsonObject>
#include <QJsonValue>
#include <QPointF>
#include <QProcess>
#include <QTemporaryDir>
#include <QWebSocket>

#include <functional>
#include <memory>

namespace plc::serve {

/// Turns the event loop until it is so; false after the time.
bool waitUntil(const std::function<bool()>& condition, int milliseconds = kPatience);

class Chromium;

/// One page of the browser.
class Page {
public:
    Page(Chromium& browser, QString target, QString session);
    ~Page();
    /// The value of a JavaScript expression; a promise is waited for.
    QJsonValue evaluate(const QString& expression);
    bool waitFor(const QString& expression, int milliseconds = kPatience);
    void mouse(const char* type, QPointF at);
    /// A place of the canvas.
    void click(QPointF at);
    void key(const QString& key);
    /// The pixels of the page's canvas.
    QImage canvas();
    QImage screenshot();

private:
    QJsonObject call(const QString& method, const QJsonObject& parameters);
    Chromium& m_browser;
    QString m_target, m_session;
};

class Chromium {
public:
    Chromium();
    ~Chromium();
    bool isRunning() const { return m_socket.state() == QAbstractSocket::ConnectedState; }
    QString problem() const { return m_problem; }
    std::unique_ptr<Page> open(const QString& url, QSize size = {1280, 900});
    QJsonObject call(const QString& method, const QJsonObject& parameters, const QString& session = {});
    /// Processor time of its processes so far, by kind: renderer, GPU, browser …
    QHash<QString, double> processorSeconds();

private:
    bool start();
    QTemporaryDir m_profile;
    QProcess m_process;
    QWebSocket m_socket;
    QHash<int, QJsonObject> m_answers;
    QString m_problem;
    int m_last = 0;
};

} // namespace plc::serve
