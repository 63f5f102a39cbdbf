// The connection of one attached studio or command line: nothing but the code is heard first; then requests under
// limits of size and rate, and scans out only as fast as they are taken. Owned by the server; main thread.
#pragma once
#include "app/serve/gate.h"
#include "projects/remote/door.h"

#include <QHostAddress>
#include <QWebSocket>

namespace plc::serve {

struct AttachSettings {
    QByteArray code;
    bool mayHalt = false; // breakpoints
    size_t studios = 8;
    int messagesPerSecond = 200;
    int codeWithin = 5000;     // ms
    qint64 unsent = 4 << 20;   // bytes
    int silentWithin = 60'000; // ms
};

/// The code must not cross a network that others can listen to.
[[nodiscard]] bool mayAttach(const QHostAddress& peer, bool hasTls);

class AttachLink final : public QObject {
    Q_OBJECT
public:
    AttachLink(QWebSocket* socket, session::Session& session, Gate& gate, const AttachSettings& settings,
               std::string project, QObject* parent);
    ~AttachLink() override;
    /// Answers and scans that are due; times in ms of any epoch, `given` of PeerTime.
    void frame(qint64 now, qint64 given);
    void tell(const QString& refusal);
    bool isIn() const { return m_door != nullptr; }

signals:
    void gone(bool wasHostile);

private:
    void take(const QByteArray& text);
    void logIn(const remote::Json& hello);
    void say(const remote::Json& message);
    void drop(QWebSocketProtocol::CloseCode code, const QString& why);
    bool isTooFast(qint64 now);
    QWebSocket* m_socket;
    session::Session& m_session;
    Gate& m_gate;
    const AttachSettings& m_settings;
    std::string m_project;
    QString m_address;
    std::unique_ptr<remote::Door> m_door;
    qint64 m_budgetAt = -1, m_now = 0;
    qint64 m_since = -1, m_pingAt = -1, m_pongAt = -1, m_given = 0; // of the time it is given
    double m_budget;
    bool m_isGone = false;
};

} // namespace plc::serve
