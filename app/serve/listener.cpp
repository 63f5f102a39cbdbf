#include "app/serve/listener.h"

#include <QSslSocket>
#include <QTimer>

namespace plc::serve {

namespace {
constexpr const char* kHeadTimer = "head";
}

Listener::Listener(ListenerLimits limits, QObject* parent) : QTcpServer(parent), m_limits(limits) {
    setMaxPendingConnections(limits.connections);
}

void Listener::incomingConnection(qintptr descriptor) {
    QTcpSocket* socket = m_tls ? new QSslSocket(this) : new QTcpSocket(this);
    if (!socket->setSocketDescriptor(descriptor)) return delete socket;
    const QString address = socket->peerAddress().toString();
    if (m_count >= m_limits.connections || m_byAddress.value(address) >= m_limits.perAddress) {
        ++m_refusals;
        socket->abort();
        return delete socket;
    }
    ++m_count;
    ++m_byAddress[address];
    connect(socket, &QObject::destroyed, this, [this, address] {
        --m_count;
        if (--m_byAddress[address] <= 0) m_byAddress.remove(address);
    });
    connect(socket, &QTcpSocket::disconnected, socket, &QObject::deleteLater);
    socket->setReadBufferSize(kLargestHead); // nobody fills our memory
    auto* timer = new QTimer(socket);
    timer->setObjectName(QLatin1String(kHeadTimer));
    timer->setSingleShot(true);
    connect(timer, &QTimer::timeout, socket, [this, socket] {
        ++m_refusals;
        socket->abort();
        socket->deleteLater();
    });
    timer->start(m_limits.headMilliseconds);
    connect(socket, &QTcpSocket::readyRead, this, [this, socket] { readHead(socket); });
    if (auto* secure = qobject_cast<QSslSocket*>(socket)) {
        secure->setSslConfiguration(*m_tls);
        secure->startServerEncryption();
    }
}

void Listener::readHead(QTcpSocket* socket) {
    const HttpHead head = parseHead(socket->peek(kLargestHead));
    if (head.state == HeadState::Incomplete) return;
    if (auto* timer = socket->findChild<QTimer*>(QLatin1String(kHeadTimer))) timer->stop();
    disconnect(socket, &QTcpSocket::readyRead, this, nullptr);
    if (head.state == HeadState::Bad) {
        ++m_refusals;
        return answer(socket,
                      {400, "text/plain; charset=utf-8", "This is no request that the server understands.\n", {}});
    }
    if (head.request.isWebSocket()) {
        if (head.request.path == kAttachPath) {
            if (!mayAttach || !mayAttach(socket->peerAddress()) || !head.request.field("origin").isEmpty()) {
                ++m_refusals;
                return answer(socket, {403, "text/plain; charset=utf-8", "Attaching needs TLS and a studio.\n", {}});
            }
            disconnect(socket, &QTcpSocket::disconnected, socket, nullptr);
            socket->setReadBufferSize(0);
            return onWebSocket(socket);
        }
        if (!head.request.isSameOrigin() || head.request.path != "/panel-stream") {
            ++m_refusals;
            return answer(socket,
                          {403, "text/plain; charset=utf-8", "Panels are only open to pages of this server.\n", {}});
        }
        disconnect(socket, &QTcpSocket::disconnected, socket, nullptr);
        socket->setReadBufferSize(0);
        return onWebSocket(socket);
    }
    if (head.request.method != "GET" && head.request.method != "HEAD")
        return answer(socket, {405, "text/plain; charset=utf-8", "Only GET is possible here.\n", {}});
    answer(socket, onRequest(head.request), head.request.method == "GET");
}

void Listener::answer(QTcpSocket* socket, const HttpAnswer& answer, bool withBody) {
    socket->write(toBytes(answer, withBody));
    socket->disconnectFromHost(); // when all is written
    // Whoever does not read the answer is not waited for.
    QTimer::singleShot(m_limits.headMilliseconds, socket, [socket] {
        socket->abort();
        socket->deleteLater();
    });
}

} // namespace plc::serve
