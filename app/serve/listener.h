// Accepts connections and gets each one's request: plain or TLS, so many at once and no more, a head within its size
// and time. Then hands the socket on. Owned by the server; main thread.
#pragma once
#include "app/serve/http.h"

#include <QHostAddress>
#include <QSslConfiguration>
#include <QTcpServer>
#include <QTcpSocket>

#include <functional>

namespace plc::serve {

inline constexpr const char* kAttachPath = "/attach";

struct ListenerLimits {
    int connections = 256;
    int perAddress = 64;
    int headMilliseconds = 5000;
};

class Listener final : public QTcpServer {
    Q_OBJECT
public:
    explicit Listener(ListenerLimits limits, QObject* parent = nullptr);
    void setTls(const QSslConfiguration& configuration) { m_tls = configuration; }
    bool hasTls() const { return m_tls.has_value(); }
    int connectionCount() const { return m_count; }
    uint64_t refusals() const { return m_refusals; }

    /// Answers a request; the socket is closed behind it.
    std::function<HttpAnswer(const HttpRequest&)> onRequest;
    /// Whether a studio at that address may try to attach; never a page in a browser.
    std::function<bool(const QHostAddress&)> mayAttach;
    /// Takes over a socket whose request to become a WebSocket has not been read yet.
    std::function<void(QTcpSocket*)> onWebSocket;

protected:
    void incomingConnection(qintptr descriptor) override;

private:
    void readHead(QTcpSocket* socket);
    void answer(QTcpSocket* socket, const HttpAnswer& answer, bool withBody = true);
    ListenerLimits m_limits;
    std::optional<QSslConfiguration> m_tls;
    QHash<QString, int> m_byAddress;
    int m_count = 0;
    uint64_t m_refusals = 0;
};

} // namespace plc::serve
