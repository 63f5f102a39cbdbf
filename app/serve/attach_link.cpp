#include "app/serve/attach_link.h"

#include "projects/remote/errors.h"

namespace plc::serve {

namespace {
constexpr quint64 kLargestHello = 4096, kLargestRequest = 64 << 20;
constexpr size_t kPiece = 256 << 10;
} // namespace

bool mayAttach(const QHostAddress& peer, bool hasTls) { return hasTls || peer.isLoopback(); }

AttachLink::AttachLink(QWebSocket* socket, session::Session& session, Gate& gate, const AttachSettings& settings,
                       std::string project, QObject* parent)
    : QObject(parent), m_socket(socket), m_session(session), m_gate(gate), m_settings(settings),
      m_project(std::move(project)), m_address(socket->peerAddress().toString()), m_budget(settings.messagesPerSecond) {
    socket->setParent(this);
    socket->setMaxAllowedIncomingFrameSize(kLargestHello);
    socket->setMaxAllowedIncomingMessageSize(kLargestHello);
    connect(socket, &QWebSocket::textMessageReceived, this, [this](const QString& text) { take(text.toUtf8()); });
    connect(socket, &QWebSocket::binaryMessageReceived, this,
            [this] { drop(QWebSocketProtocol::CloseCodeDatatypeNotSupported, QStringLiteral("text only")); });
    connect(socket, &QWebSocket::pong, this, [this] { m_pongAt = m_given; });
    connect(socket, &QWebSocket::disconnected, this, [this] {
        if (std::exchange(m_isGone, true)) return;
        m_door.reset();
        emit gone(false);
    });
}

AttachLink::~AttachLink() { m_socket->disconnect(this); }

void AttachLink::drop(QWebSocketProtocol::CloseCode code, const QString& why) {
    if (std::exchange(m_isGone, true)) return;
    m_door.reset();
    m_socket->close(code, why);
    emit gone(true);
}

void AttachLink::say(const remote::Json& message) {
    m_socket->sendTextMessage(
        QString::fromStdString(message.dump(-1, ' ', false, remote::Json::error_handler_t::replace)));
}

void AttachLink::tell(const QString& refusal) {
    if (m_door) m_door->tell(refusal.toStdString());
}

/// A bucket that fills with time: short bursts are ordinary, floods are not.
bool AttachLink::isTooFast(qint64 now) {
    const double full = 2.0 * m_settings.messagesPerSecond;
    if (m_budgetAt >= 0)
        m_budget =
            std::min(full, m_budget + static_cast<double>(now - m_budgetAt) * m_settings.messagesPerSecond / 1000);
    m_budgetAt = now;
    m_budget -= 1;
    return m_budget < 0;
}

void AttachLink::take(const QByteArray& text) {
    if (m_isGone) return;
    if (isTooFast(m_now)) return drop(QWebSocketProtocol::CloseCodePolicyViolated, QStringLiteral("too many messages"));
    const remote::Json request = remote::Json::parse(text.begin(), text.end(), nullptr, false);
    if (!request.is_object()) return drop(QWebSocketProtocol::CloseCodeProtocolError, QStringLiteral("not understood"));
    if (!m_door) return logIn(request);
    if (const auto answer = m_door->answer(request)) say(*answer);
}

void AttachLink::logIn(const remote::Json& hello) {
    if (remote::textAt(hello, "do") != "hello")
        return drop(QWebSocketProtocol::CloseCodePolicyViolated, QStringLiteral("the code comes first"));
    const Gate::Outcome outcome =
        m_gate.ask(m_address, {}, QString::fromStdString(remote::textAt(hello, "code")), m_now);
    remote::Json answer{{"id", remote::numberAt(hello, "id")}, {"ok", outcome.answer == Gate::Answer::Open}};
    if (outcome.answer != Gate::Answer::Open) {
        const bool isBlocked = outcome.answer == Gate::Answer::TooOften;
        answer["error"] = (isBlocked ? remote::errors::TooManyCodes() : remote::errors::WrongCode()).english();
        answer["why"] = isBlocked ? "blocked" : "code";
        say(answer);
        return drop(QWebSocketProtocol::CloseCodePolicyViolated, QStringLiteral("wrong code"));
    }
    m_socket->setMaxAllowedIncomingFrameSize(kLargestRequest);
    m_socket->setMaxAllowedIncomingMessageSize(kLargestRequest);
    constexpr size_t kLongestName = 60;
    const std::string name = remote::textAt(hello, "name").substr(0, kLongestName);
    m_door = std::make_unique<remote::Door>(m_session, name + " at " + m_address.toStdString(),
                                            remote::Rights{m_settings.mayHalt});
    answer["project"] = m_project;
    answer["may_halt"] = m_settings.mayHalt;
    say(answer);
}

void AttachLink::frame(qint64 now, qint64 given) {
    m_now = now;
    m_given = given;
    if (m_isGone) return;
    constexpr qint64 kPingEvery = 20'000;
    if (m_since < 0) m_since = m_pingAt = m_pongAt = given;
    if (given - m_pingAt >= kPingEvery) {
        m_pingAt = given;
        m_socket->ping();
    }
    if (given - m_pongAt > m_settings.silentWithin)
        return drop(QWebSocketProtocol::CloseCodeGoingAway, QStringLiteral("no answer"));
    if (!m_door) {
        if (given - m_since > m_settings.codeWithin)
            drop(QWebSocketProtocol::CloseCodePolicyViolated, QStringLiteral("no code"));
        return;
    }
    if (m_socket->bytesToWrite() > m_settings.unsent) return; // who reads slowly gets less
    for (const remote::Json& message : m_door->due()) say(message);
    const std::string bytes = m_door->bytes(kPiece);
    if (!bytes.empty())
        m_socket->sendBinaryMessage(
            qCompress(reinterpret_cast<const uchar*>(bytes.data()), static_cast<qsizetype>(bytes.size()), 1));
}

} // namespace plc::serve
