// The connection of one browser: messages in under limits of size and rate, frames out only as fast as they are drawn
// there. A browser that hangs gets nothing more and is dropped in the end. Owned by the server; main thread.
#pragma once
#include "app/serve/gate.h"
#include "hmi/web/web_panel.h"

#include <QWebSocket>

namespace plc::serve {

struct LinkLimits {
    int messagesPerSecond = 200;
    int framesAhead = 2;      // sent and not drawn yet
    int drawnWithin = 15'000; // ms, else the browser is gone
    qint64 unsent = 4 << 20;  // bytes
};

class PanelLink final : public QObject {
    Q_OBJECT
public:
    PanelLink(QWebSocket* socket, const hmi::PanelProject& project, session::Run& run, hmi::web::PaintStore& store,
              hmi::OperatorStation& keeper, Gate& gate, LinkLimits limits, QObject* parent);
    ~PanelLink() override;

    /// Sends what is new, if the browser is ready for it; times in ms of any epoch, `given` of PeerTime.
    void frame(qint64 now, qint64 given);
    uint64_t sentBytes() const { return m_sentBytes; }
    uint64_t sentFrames() const { return m_sentFrames; }
    void tell(const QString& reason) { m_panel.tell(reason); }
    bool isOperator() const { return m_panel.isOperator(); }

signals:
    void gone(bool wasHostile);

private:
    void take(const QByteArray& text);
    void logIn(const hmi::web::ClientMessage& message);
    void drop(QWebSocketProtocol::CloseCode code, const QString& why);
    bool isTooFast(qint64 now);
    QWebSocket* m_socket;
    hmi::web::WebPanel m_panel;
    Gate& m_gate;
    LinkLimits m_limits;
    QString m_address;
    QList<QByteArray> m_answers;
    uint32_t m_drawn = 0;
    qint64 m_budgetAt = -1, m_now = 0;
    qint64 m_drawnAt = -1, m_pingAt = -1, m_pongAt = -1, m_given = 0; // of the time it is given
    double m_budget = 0;
    uint64_t m_sentBytes = 0, m_sentFrames = 0;
    bool m_isGone = false, m_isHostile = false;
};

} // namespace plc::serve
