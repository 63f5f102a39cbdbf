// The web side of a served controller: pages, status and metrics over HTTP, panels over WebSockets, all on one port.
// The scan thread is only read and posted to, so nothing here can hold it up. Main thread; session and project must
// outlive it.
#pragma once
#include "app/serve/attach_link.h"
#include "app/serve/frame_pace.h"
#include "app/serve/listener.h"
#include "app/serve/metrics.h"
#include "app/serve/panel_link.h"

#include <QElapsedTimer>
#include <QHostAddress>
#include <QTimer>
#include <QWebSocketServer>

namespace plc::serve {

struct ServerSettings {
    std::string name; // of the project
    QHostAddress address = QHostAddress::LocalHost;
    quint16 port = 8080; // 0: any that is free
    QString certificate, key;
    ListenerLimits listener;
    LinkLimits link;
    size_t browsers = 64;
    std::optional<AttachSettings> attach; // nothing: no studio can attach
    std::function<qint64()> clock;        // ms for blinking and animation; empty: since the start
};

class Server final : public QObject {
    Q_OBJECT
public:
    Server(const hmi::PanelProject& project, session::Session& session, LogIn logIn, ServerSettings settings);
    ~Server() override;

    [[nodiscard]] Result<void> start();
    quint16 port() const { return m_listener.serverPort(); }
    /// "http://127.0.0.1:8080/"
    QString url() const;
    ServerFigures figures() const;
    /// The recording on disk, as `/status` tells it.
    std::function<void(ServerFigures&)> describeRecording;

private:
    Result<void> useTls();
    HttpAnswer answer(const HttpRequest& request);
    QByteArray overview() const;
    void accept();
    void acceptStudio(QWebSocket* socket);
    void frames();
    qint64 now() const { return m_settings.clock ? m_settings.clock() : m_clock.elapsed(); }
    const hmi::PanelProject& m_project;
    session::Session& m_session;
    ServerSettings m_settings;
    Gate m_gate;
    hmi::web::PaintStore m_store;
    hmi::OperatorStation m_keeper; // of the alarms; nobody looks at it
    Listener m_listener;
    QWebSocketServer m_sockets;
    std::vector<PanelLink*> m_links;
    Gate m_attachGate;
    std::vector<AttachLink*> m_attached;
    QTimer m_timer;
    FramePace m_pace;
    PeerTime m_peerTime;
    QElapsedTimer m_clock;
    uint64_t m_goneBytes = 0, m_goneFrames = 0, m_dropped = 0;
};

} // namespace plc::serve
