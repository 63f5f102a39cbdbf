#include "editor/remote/remote_controller.h"

#include "projects/remote/errors.h"

#include <QFile>
#include <QHostAddress>
#include <QSslConfiguration>

namespace plc::editor {

namespace {

using remote::Json;
namespace errors = remote::errors;
constexpr int kShortestWait = 250, kLongestWait = 8000, kSilence = 15'000;
constexpr quint64 kLargestMessage = quint64(256) << 20;

bool isHere(const QUrl& url) {
    const QString host = url.host();
    return host == QLatin1String("localhost") || QHostAddress(host).isLoopback();
}

std::string text(const QString& from) { return from.toStdString(); }

} // namespace

RemoteController::RemoteController(QObject* parent) : QObject(parent) {
    m_again.setSingleShot(true);
    connect(&m_again, &QTimer::timeout, this, &RemoteController::open);
    m_silence.setSingleShot(true);
    m_silence.setInterval(kSilence);
    connect(&m_silence, &QTimer::timeout, this, [this] { lose(errors::NoAnswer(text(host()))); });
}

RemoteController::~RemoteController() {
    if (m_socket) m_socket->disconnect(this);
    if (m_probe) m_probe->disconnect(this);
}

Result<void> RemoteController::attach(Address address) {
    const QString scheme = address.url.scheme();
    if (!address.url.isValid() || address.url.host().isEmpty() ||
        (scheme != QLatin1String("http") && scheme != QLatin1String("https")))
        return Error{errors::NotAnAddress(text(address.url.toString())), {}};
    if (scheme == QLatin1String("http") && !isHere(address.url)) return Error{errors::NotSecure(), {}};
    m_trusted.clear();
    if (!address.trustFile.isEmpty()) {
        QFile file(address.trustFile);
        if (file.open(QIODevice::ReadOnly)) m_trusted = QSslCertificate::fromData(file.readAll());
        if (m_trusted.isEmpty()) return Error{errors::TrustNotRead(text(address.trustFile)), {}};
    }
    m_address = std::move(address);
    m_wait = 0;
    m_comesBack = false;
    open();
    return {};
}

void RemoteController::open() {
    forgetSockets();
    m_socket = std::make_unique<QWebSocket>();
    QWebSocket* socket = m_socket.get();
    socket->setMaxAllowedIncomingFrameSize(kLargestMessage);
    socket->setMaxAllowedIncomingMessageSize(kLargestMessage);
    if (!m_trusted.isEmpty()) {
        QSslConfiguration configuration = QSslConfiguration::defaultConfiguration();
        configuration.addCaCertificates(m_trusted);
        socket->setSslConfiguration(configuration);
        // The very certificate that was named is trusted, whatever name it was made for.
        connect(socket, &QWebSocket::sslErrors, this, [this, socket](const QList<QSslError>& problems) {
            for (const QSslError& problem : problems)
                if (!m_trusted.contains(problem.certificate())) return;
            socket->ignoreSslErrors();
        });
    }
    connect(socket, &QWebSocket::sslErrors, this, [this](const QList<QSslError>& problems) {
        if (!problems.isEmpty())
            m_problem = errors::CertificateUnknown(text(host()), text(problems.front().errorString()));
    });
    m_isReached = false;
    connect(socket, &QWebSocket::bytesWritten, this, [this] {
        if (m_address.url.scheme() == QLatin1String("http")) m_isReached = true; // else it may be for nobody's TLS
    });
    connect(socket, &QWebSocket::connected, this, &RemoteController::greet);
    connect(socket, &QWebSocket::textMessageReceived, this, &RemoteController::take);
    connect(socket, &QWebSocket::binaryMessageReceived, this, &RemoteController::takeBytes);
    connect(socket, &QWebSocket::pong, this, [this] { m_silence.start(); });
    connect(socket, QOverload<QAbstractSocket::SocketError>::of(&QWebSocket::error), this,
            [this, socket](QAbstractSocket::SocketError error) {
                if (error == QAbstractSocket::RemoteHostClosedError) return; // its reason is still to come
                if (error == QAbstractSocket::SslHandshakeFailedError && !m_problem.isEmpty()) return lose(m_problem);
                if (error == QAbstractSocket::SslHandshakeFailedError) return lose(errors::NoTlsThere(place()));
                if (error == QAbstractSocket::ConnectionRefusedError && !socket->peerAddress().isNull())
                    m_isReached = true; // it is the answer that was no WebSocket's
                loseUnlessTls(whyNot(error, socket->errorString()));
            });
    connect(socket, &QWebSocket::disconnected, this, [this, socket] {
        const QString why = socket->closeReason().isEmpty() ? socket->errorString() : socket->closeReason();
        if (m_state == State::Attached) return lose(errors::ConnectionLost(text(host())));
        const bool isRefused = socket->closeCode() == QWebSocketProtocol::CloseCodePolicyViolated;
        if (isRefused) return lose(errors::NoAttaching(text(host()), text(why)));
        if (!m_open.empty()) return lose(errors::ConnectionLost(text(host()))); // while it was greeted
        // What was wrong with the socket is said only after this.
        QTimer::singleShot(0, socket, [this, socket] { loseUnreached(*socket); });
    });
    QUrl url = m_address.url;
    url.setScheme(url.scheme() == QLatin1String("https") ? QStringLiteral("wss") : QStringLiteral("ws"));
    url.setPath(QStringLiteral("/attach"));
    url.setQuery(QString());
    if (m_state != State::Lost) setState(State::Connecting);
    m_silence.start();
    socket->open(url);
}

void RemoteController::greet() {
    const uint64_t id = ++m_last;
    m_open.emplace(id, [this](const Result<Json>& answer) {
        if (!answer) return;
        m_project = QString::fromStdString(remote::textAt(*answer, "project"));
        m_mayHalt = answer->value("may_halt", false);
        m_comesBack = true;
        m_wait = 0;
        m_problem = {};
        setState(State::Attached);
    });
    const Json hello{{"id", id}, {"do", "hello"}, {"code", text(m_address.code)}, {"name", text(m_address.name)}};
    m_socket->sendTextMessage(QString::fromStdString(hello.dump(-1, ' ', false, Json::error_handler_t::replace)));
}

void RemoteController::ask(Json request, Answer then) {
    if (m_state != State::Attached) {
        if (then) then(Error{errors::ConnectionLost(text(host())), {}});
        return;
    }
    const uint64_t id = ++m_last;
    request["id"] = id;
    m_open.emplace(id, std::move(then));
    m_socket->sendTextMessage(QString::fromStdString(request.dump(-1, ' ', false, Json::error_handler_t::replace)));
    m_socket->ping(); // so that silence says something
}

void RemoteController::take(const QString& message) {
    m_silence.start();
    const std::string bytes = message.toStdString();
    const Json json = Json::parse(bytes, nullptr, false);
    if (!json.is_object()) return;
    if (json.contains("event")) return emit eventArrived(json);
    const auto it = m_open.find(remote::numberAt(json, "id"));
    if (it == m_open.end()) return;
    const Answer then = std::move(it->second);
    m_open.erase(it);
    if (const auto ok = json.find("ok"); ok != json.end() && *ok == true) {
        if (then) then(json);
        return;
    }
    const std::string why = remote::textAt(json, "why");
    if (why == "code" || why == "blocked") {
        m_comesBack = false; // another try would be wrong as well
        return lose(why == "code" ? Message(errors::WrongCode()) : Message(errors::TooManyCodes()));
    }
    if (then) then(Error{errors::Plainly(remote::textAt(json, "error")), {}});
}

/// The size that it will have is in front: nobody fills our memory.
void RemoteController::takeBytes(const QByteArray& packed) {
    m_silence.start();
    constexpr uint32_t kLargest = uint32_t(128) << 20;
    if (packed.size() < 4) return;
    uint32_t size = 0;
    for (int i = 0; i < 4; ++i) size = size << 8 | static_cast<uint8_t>(packed[i]);
    if (size > kLargest) return;
    const QByteArray bytes = qUncompress(packed);
    if (!bytes.isEmpty()) emit bytesArrived(bytes);
}

void RemoteController::refuseAll(const Message& why) {
    for (const auto& [id, then] : std::exchange(m_open, {}))
        if (then) then(Error{why, {}});
}

void RemoteController::lose(Message why) {
    if (m_state == State::Detached) return;
    m_silence.stop();
    if (m_socket) {
        m_socket->disconnect(this);
        m_socket->abort();
    }
    forgetSockets();
    m_problem = std::move(why);
    setState(m_comesBack ? State::Lost : State::Detached);
    refuseAll(m_problem);
    if (!m_comesBack) return;
    m_wait = std::clamp(2 * m_wait, kShortestWait, kLongestWait);
    m_again.start(m_wait);
}

/// The line ended before there was a WebSocket.
void RemoteController::loseUnreached(const QWebSocket& socket) {
    if (m_socket.get() != &socket || m_probe) return; // known by now
    const QAbstractSocket::SocketError error = socket.error();
    const bool isNobody =
        error == QAbstractSocket::HostNotFoundError || error == QAbstractSocket::ConnectionRefusedError;
    if (m_address.url.scheme() == QLatin1String("https") && !isNobody)
        return lose(errors::NoTlsThere(place())); // a server without TLS waits for words it knows
    loseUnlessTls(whyNot(error, socket.errorString()));
}

/// Why there was no WebSocket, with what to check: the words of the socket are about its own steps.
Message RemoteController::whyNot(QAbstractSocket::SocketError error, const QString& words) const {
    if (m_isReached) return errors::NotAController(place());
    if (error == QAbstractSocket::ConnectionRefusedError) return errors::NobodyThere(place());
    if (error == QAbstractSocket::HostNotFoundError) return errors::NoSuchHost(text(host()));
    if (error == QAbstractSocket::SocketTimeoutError) return errors::NoAnswer(text(host()));
    return errors::NotReached(text(host()), text(words));
}

int RemoteController::port() const {
    return m_address.url.port(m_address.url.scheme() == QLatin1String("https") ? 443 : 80);
}

std::string RemoteController::place() const { return text(host()) + ":" + std::to_string(port()); }

/// A server that speaks TLS hangs up on plain words without saying why; a handshake tells.
void RemoteController::loseUnlessTls(Message why) {
    if (m_state != State::Connecting || m_address.url.scheme() != QLatin1String("http")) return lose(std::move(why));
    m_socket->disconnect(this);
    m_socket->abort(); // some servers talk to one client at a time
    m_probe = std::make_unique<QSslSocket>();
    QSslSocket* probe = m_probe.get();
    probe->setPeerVerifyMode(QSslSocket::VerifyNone);
    connect(probe, &QSslSocket::encrypted, this, [this] {
        QUrl url = m_address.url;
        url.setScheme(QStringLiteral("https"));
        lose(errors::SpeaksTls(text(host()), text(url.toString())));
    });
    connect(probe, &QSslSocket::errorOccurred, this, [this, why] { lose(why); });
    probe->connectToHostEncrypted(host(), static_cast<quint16>(port()));
}

void RemoteController::forgetSockets() {
    if (m_probe) {
        m_probe->disconnect(this);
        m_probe.release()->deleteLater();
    }
    if (!m_socket) return;
    m_socket->disconnect(this);
    m_socket.release()->deleteLater();
}

void RemoteController::detach() {
    m_comesBack = false;
    m_again.stop();
    m_silence.stop();
    if (m_socket) {
        m_socket->disconnect(this);
        m_socket->close();
    }
    forgetSockets();
    m_problem = {};
    setState(State::Detached);
    refuseAll(errors::ConnectionLost(text(host())));
}

void RemoteController::setState(State state) {
    if (m_state == state) return;
    m_state = state;
    emit stateChanged();
}

} // namespace plc::editor
