#include "app/serve/server.h"

#include "app/serve/errors.h"
#include "editor/kit/occurrence_text.h"
#include "hmi/web/web_panel.h"

#include <QFile>
#include <QSslCertificate>
#include <QSslKey>
#include <QUrl>

// Outside the namespace, as the macro asks: a static library's resources are registered by hand.
static void registerPages() { Q_INIT_RESOURCE(web_client); }

namespace plc::serve {

namespace {

QByteArray page(const char* name) {
    QFile file(QStringLiteral(":/web/") + QLatin1String(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QByteArray escaped(const QString& text) { return text.toHtmlEscaped().toUtf8(); }

} // namespace

Server::Server(const hmi::PanelProject& project, session::Session& session, LogIn logIn, ServerSettings settings)
    : m_project(project), m_session(session), m_settings(std::move(settings)), m_gate(std::move(logIn)),
      m_keeper(project, &session), m_listener(m_settings.listener),
      m_sockets(QStringLiteral("Stepwise"), QWebSocketServer::NonSecureMode),
      m_attachGate(m_settings.attach ? byAccessCode(m_settings.attach->code) : LogIn()) {
    [[maybe_unused]] static const bool registered = (registerPages(), true);
    m_listener.onRequest = [this](const HttpRequest& request) { return answer(request); };
    m_listener.mayAttach = [this](const QHostAddress& peer) {
        return m_settings.attach && mayAttach(peer, m_listener.hasTls());
    };
    m_listener.onWebSocket = [this](QTcpSocket* socket) { m_sockets.handleConnection(socket); };
    connect(&m_sockets, &QWebSocketServer::newConnection, this, &Server::accept);
    // Writes that the scan refused do not say who asked for them.
    connect(&m_keeper, &hmi::OperatorStation::writeRefused, this, [this](const QString& reason) {
        for (PanelLink* link : m_links) link->tell(reason);
        for (AttachLink* link : m_attached) link->tell(reason);
    });
    m_timer.setTimerType(Qt::PreciseTimer);
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &Server::frames);
    m_clock.start();
}

Server::~Server() {
    for (PanelLink* link : m_links) delete link;
    for (AttachLink* link : m_attached) delete link;
}

namespace {

/// A private key file holds the public half as well, in the very bytes that end the certificate's public key.
bool belongTogether(const QSslCertificate& certificate, const QSslKey& key) {
    constexpr qsizetype kEnough = 48; // of an elliptic key it is the point, of an RSA key the end of the modulus
    return key.toDer().contains(certificate.publicKey().toDer().right(kEnough));
}

} // namespace

Result<void> Server::useTls() {
    if (!QSslSocket::supportsSsl()) return Error{errors::TlsMissing(), {}};
    QFile certificateFile(m_settings.certificate), keyFile(m_settings.key);
    const QList<QSslCertificate> chain = certificateFile.open(QIODevice::ReadOnly)
                                             ? QSslCertificate::fromData(certificateFile.readAll())
                                             : QList<QSslCertificate>();
    if (chain.isEmpty()) return Error{errors::CertificateNotRead(m_settings.certificate.toStdString()), {}};
    const QByteArray pem = keyFile.open(QIODevice::ReadOnly) ? keyFile.readAll() : QByteArray();
    for (const QSsl::KeyAlgorithm algorithm : {QSsl::Rsa, QSsl::Ec}) {
        const QSslKey key(pem, algorithm);
        if (key.isNull()) continue;
        if (!belongTogether(chain.front(), key))
            return Error{errors::KeyOfAnother(m_settings.key.toStdString(), m_settings.certificate.toStdString()), {}};
        QSslConfiguration configuration = QSslConfiguration::defaultConfiguration();
        configuration.setLocalCertificateChain(chain);
        configuration.setPrivateKey(key);
        configuration.setPeerVerifyMode(QSslSocket::VerifyNone); // browsers show no certificate
        configuration.setProtocol(QSsl::TlsV1_2OrLater);
        m_listener.setTls(configuration);
        return {};
    }
    return Error{errors::KeyNotRead(m_settings.key.toStdString()), {}};
}

Result<void> Server::start() {
    if (!m_settings.certificate.isEmpty())
        if (auto good = useTls(); !good) return good;
    if (!m_listener.listen(m_settings.address, m_settings.port)) {
        const QString place = m_settings.address.toString() + u':' + QString::number(m_settings.port);
        return Error{errors::PortNotFree(place.toStdString(), m_listener.errorString().toStdString()), {}};
    }
    m_timer.start(static_cast<int>(FramePace::kFrame));
    return {};
}

QString Server::url() const {
    const bool isAny = m_settings.address == QHostAddress::Any || m_settings.address == QHostAddress::AnyIPv4 ||
                       m_settings.address == QHostAddress::AnyIPv6;
    QUrl url;
    url.setScheme(m_listener.hasTls() ? QStringLiteral("https") : QStringLiteral("http"));
    url.setHost(isAny ? QStringLiteral("localhost") : m_settings.address.toString());
    url.setPort(port());
    url.setPath(QStringLiteral("/"));
    return url.toString();
}

HttpAnswer Server::answer(const HttpRequest& request) {
    const auto resource = [](const char* name, const char* type) { return HttpAnswer{200, type, page(name), {}}; };
    if (request.path == "/") return {200, "text/html; charset=utf-8", overview(), {}};
    if (request.path == "/status") return {200, "application/json", statusJson(m_session, figures()), {}};
    if (request.path == "/metrics") return {200, "text/plain; version=0.0.4", prometheusText(m_session, figures()), {}};
    if (request.path == "/client/panel.css") return resource("panel.css", "text/css");
    for (const char* script : {"reader.js", "ink.js", "words.js", "commands.js", "elements.js", "paint.js", "easel.js",
                               "display.js", "worker.js", "panel.js"})
        if (request.path == QByteArray("/client/") + script) return resource(script, "text/javascript");
    if (request.path == "/panel" || request.path == "/panel/") {
        const QString start = m_project.find(m_project.startPanel) || m_project.panels.empty()
                                  ? m_project.startPanel
                                  : m_project.panels.front().name;
        if (!m_project.find(start)) return {404, "text/plain; charset=utf-8", "The project has no panel.\n", {}};
        const QByteArray query = request.query.isEmpty() ? QByteArray() : '?' + request.query;
        return {302, "text/plain; charset=utf-8", {}, "/panel/" + QUrl::toPercentEncoding(start) + query};
    }
    if (request.path.startsWith("/panel/") && m_project.find(QString::fromUtf8(request.path.sliced(7))))
        return resource("panel.html", "text/html; charset=utf-8");
    return {404, "text/plain; charset=utf-8", "There is no such page; / lists the panels.\n", {}};
}

QByteArray Server::overview() const {
    const session::Status status = m_session.status();
    const QString name = QString::fromStdString(m_settings.name);
    QByteArray out =
        "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width, initial-scale=1\"><meta name=\"color-scheme\" content=\"light dark\"><title>" +
        escaped(name) +
        "</title><link rel=\"icon\" href=\"data:,\"><style>body{font:16px system-ui,sans-serif;max-width:"
        "42em;margin:2em auto;padding:0 1em}a{display:inline-block;padding:10px 0}</style></head><body><h1>" +
        escaped(name) + "</h1><h2>Panels</h2><ul>";
    const QStringList pages = hmi::web::pagesOf(m_project);
    if (pages.isEmpty()) out += "<li>The project has no panel.</li>";
    for (const QString& page : pages) {
        const QByteArray place = "/panel/" + QUrl::toPercentEncoding(page);
        out += "<li><a href=\"" + place + "\">" + escaped(page) + "</a>";
        if (m_project.texts.settings().languages.size() > 1)
            for (const QString& tag : m_project.texts.settings().languages)
                out +=
                    " <a href=\"" + place + "?language=" + QUrl::toPercentEncoding(tag) + "\">" + escaped(tag) + "</a>";
        out += "</li>";
    }
    out += "</ul><h2>Controller</h2><p>" + QByteArray::number(static_cast<qulonglong>(status.scans)) + " scans, load " +
           QByteArray::number(status.load * 100, 'f', 1) + " %</p>";
    if (status.fault)
        out +=
            "<p><strong>" + escaped(kit::occurrenceText(status.fault->message, QStringLiteral("en"))) + "</strong></p>";
    return out + "<p><a href=\"/status\">status</a> (JSON), <a href=\"/metrics\">metrics</a> "
                 "(Prometheus)</p></body></html>\n";
}

void Server::accept() {
    while (QWebSocket* socket = m_sockets.nextPendingConnection()) {
        if (socket->requestUrl().path() == QLatin1String(kAttachPath)) {
            acceptStudio(socket);
            continue;
        }
        if (m_links.size() >= m_settings.browsers || m_project.panels.empty()) {
            ++m_dropped;
            socket->close(QWebSocketProtocol::CloseCodePolicyViolated, QStringLiteral("too many browsers"));
            connect(socket, &QWebSocket::disconnected, socket, &QObject::deleteLater);
            continue;
        }
        auto* link = new PanelLink(socket, m_project, m_session, m_store, m_keeper, m_gate, m_settings.link, this);
        m_links.push_back(link);
        connect(link, &PanelLink::gone, this, [this, link](bool wasHostile) {
            m_goneBytes += link->sentBytes();
            m_goneFrames += link->sentFrames();
            m_dropped += wasHostile ? 1 : 0;
            std::erase(m_links, link);
            link->deleteLater();
        });
    }
}

void Server::acceptStudio(QWebSocket* socket) {
    if (!m_settings.attach || m_attached.size() >= m_settings.attach->studios) {
        ++m_dropped;
        socket->close(QWebSocketProtocol::CloseCodePolicyViolated, QStringLiteral("too many studios"));
        connect(socket, &QWebSocket::disconnected, socket, &QObject::deleteLater);
        return;
    }
    auto* link = new AttachLink(socket, m_session, m_attachGate, *m_settings.attach, m_settings.name, this);
    m_attached.push_back(link);
    connect(link, &AttachLink::gone, this, [this, link](bool wasHostile) {
        m_dropped += wasHostile ? 1 : 0;
        std::erase(m_attached, link);
        link->deleteLater();
    });
}

void Server::frames() {
    const qint64 begin = m_clock.elapsed();
    m_keeper.frame(std::chrono::steady_clock::now());
    const qint64 at = now(); // one moment for all: browsers that see the same share what is recorded of it
    const qint64 given = m_peerTime.at(at);
    for (PanelLink* link : std::vector(m_links)) link->frame(at, given);
    for (AttachLink* link : std::vector(m_attached)) link->frame(at, given);
    m_timer.start(static_cast<int>(m_pace.waitAfter(begin, m_clock.elapsed())));
}

ServerFigures Server::figures() const {
    ServerFigures out;
    out.project = m_settings.name;
    out.browsers = m_links.size();
    out.sentBytes = m_goneBytes;
    out.sentFrames = m_goneFrames;
    for (const PanelLink* link : m_links) {
        out.operators += link->isOperator() ? 1 : 0;
        out.sentBytes += link->sentBytes();
        out.sentFrames += link->sentFrames();
    }
    out.refusedConnections = m_listener.refusals();
    for (const AttachLink* link : m_attached) out.studios += link->isIn() ? 1 : 0;
    out.refusedLogIns = m_gate.refusals() + m_attachGate.refusals();
    out.droppedBrowsers = m_dropped;
    out.uptimeSeconds = static_cast<double>(m_clock.elapsed()) * 1e-3;
    if (describeRecording) describeRecording(out);
    return out;
}

} // namespace plc::serve
