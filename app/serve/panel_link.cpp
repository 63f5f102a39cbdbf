#include "app/serve/panel_link.h"

#include <QHostAddress>
#include <nlohmann/json.hpp>

namespace plc::serve {

using hmi::web::ClientMessage;
using hmi::web::ClientWord;

namespace {
hmi::LogIn::Answer answerOf(const Gate::Outcome& outcome) {
    switch (outcome.answer) {
    case Gate::Answer::Open:
        return hmi::LogIn::Answer::Good;
    case Gate::Answer::Wrong:
        return hmi::LogIn::Answer::Wrong;
    case Gate::Answer::TooOften:
        return hmi::LogIn::Answer::Blocked;
    }
    return hmi::LogIn::Answer::Wrong;
}
} // namespace

PanelLink::PanelLink(QWebSocket* socket, const hmi::PanelProject& project, session::Run& run,
                     hmi::web::PaintStore& store, hmi::OperatorStation& keeper, Gate& gate, LinkLimits limits,
                     QObject* parent)
    : QObject(parent), m_socket(socket), m_panel(project, run, store, keeper), m_gate(gate), m_limits(limits),
      m_address(socket->peerAddress().toString()), m_budget(limits.messagesPerSecond) {
    socket->setParent(this);
    m_panel.setDoor([this](const QString& user, const QString& password) {
        return answerOf(m_gate.ask(m_address, user, password, m_now));
    });
    socket->setMaxAllowedIncomingFrameSize(hmi::web::kLargestClientMessage);
    socket->setMaxAllowedIncomingMessageSize(hmi::web::kLargestClientMessage);
    connect(socket, &QWebSocket::textMessageReceived, this, [this](const QString& text) { take(text.toUtf8()); });
    connect(socket, &QWebSocket::binaryMessageReceived, this,
            [this] { drop(QWebSocketProtocol::CloseCodeDatatypeNotSupported, QStringLiteral("text only")); });
    connect(socket, &QWebSocket::pong, this, [this] { m_pongAt = m_given; });
    connect(socket, &QWebSocket::disconnected, this, [this] {
        if (std::exchange(m_isGone, true)) return;
        emit gone(m_isHostile);
    });
}

PanelLink::~PanelLink() { m_socket->disconnect(this); }

void PanelLink::drop(QWebSocketProtocol::CloseCode code, const QString& why) {
    if (m_isGone) return;
    m_isGone = true;
    m_isHostile = true;
    m_socket->close(code, why);
    emit gone(true);
}

/// A bucket that fills with time: short bursts are ordinary, floods are not.
bool PanelLink::isTooFast(qint64 now) {
    const double full = 2.0 * m_limits.messagesPerSecond;
    if (m_budgetAt >= 0)
        m_budget = std::min(full, m_budget + static_cast<double>(now - m_budgetAt) * m_limits.messagesPerSecond / 1000);
    m_budgetAt = now;
    m_budget -= 1;
    return m_budget < 0;
}

void PanelLink::take(const QByteArray& text) {
    if (m_isGone) return;
    if (isTooFast(m_now)) return drop(QWebSocketProtocol::CloseCodePolicyViolated, QStringLiteral("too many messages"));
    const std::optional<ClientMessage> message = hmi::web::parseClientMessage(text);
    if (!message || !m_panel.take(*message))
        return drop(QWebSocketProtocol::CloseCodeProtocolError, QStringLiteral("not understood"));
    switch (message->word) {
    case ClientWord::Drawn:
        if (message->number < m_drawn || message->number > m_panel.frameNumber())
            return drop(QWebSocketProtocol::CloseCodeProtocolError, QStringLiteral("no such frame"));
        m_drawn = static_cast<uint32_t>(message->number);
        m_drawnAt = m_given;
        break;
    case ClientWord::LogIn:
        logIn(*message);
        break;
    case ClientWord::LogOut:
        m_panel.logOut();
        break;
    default:
        break;
    }
}

void PanelLink::logIn(const ClientMessage& message) {
    using Answer = hmi::LogIn::Answer;
    Answer answer = Answer::Wrong;
    if (m_panel.hasPeople()) {
        answer = m_panel.logIn(message.more, message.text);
    } else {
        const Gate::Outcome outcome = m_gate.ask(m_address, message.more, message.text, m_now);
        if (outcome.answer == Gate::Answer::Open) m_panel.setOperator(outcome.name);
        answer = answerOf(outcome);
    }
    const hmi::SystemText why = answer == Answer::Blocked ? hmi::SystemText::TooManyTries
                                : m_panel.hasPeople()     ? hmi::SystemText::WrongPassword
                                                          : hmi::SystemText::WrongAccessCode;
    const bool isOpen = answer == Answer::Good;
    const nlohmann::json reply = {
        {"t", "login"}, {"ok", isOpen}, {"text", isOpen ? std::string() : m_panel.words(why).toStdString()}};
    m_answers += QByteArray::fromStdString(reply.dump());
}

void PanelLink::frame(qint64 now, qint64 given) {
    m_now = now;
    m_given = given;
    if (m_isGone) return;
    constexpr qint64 kPingEvery = 20'000, kPongWithin = 60'000;
    if (m_pingAt < 0) m_pingAt = m_pongAt = m_drawnAt = given;
    if (given - m_pingAt >= kPingEvery) {
        m_pingAt = given;
        m_socket->ping();
    }
    if (given - m_pongAt > kPongWithin)
        return drop(QWebSocketProtocol::CloseCodeGoingAway, QStringLiteral("no answer"));
    const bool isBehind = m_panel.frameNumber() - m_drawn >= static_cast<uint32_t>(m_limits.framesAhead);
    if (isBehind || m_socket->bytesToWrite() > m_limits.unsent) {
        if (given - m_drawnAt > m_limits.drawnWithin)
            drop(QWebSocketProtocol::CloseCodeGoingAway, QStringLiteral("nothing is drawn"));
        return; // what changes meanwhile goes into the next frame
    }
    if (m_panel.frameNumber() == m_drawn) m_drawnAt = given;
    hmi::web::WebPanel::Output out = m_panel.next(now);
    for (const QByteArray& text : std::exchange(m_answers, {}) + out.texts)
        m_sentBytes += static_cast<uint64_t>(std::max<qint64>(0, m_socket->sendTextMessage(QString::fromUtf8(text))));
    if (out.frame.isEmpty()) return;
    m_sentBytes += static_cast<uint64_t>(std::max<qint64>(0, m_socket->sendBinaryMessage(out.frame)));
    ++m_sentFrames;
}

} // namespace plc::serve
