// The connection to a controller that `stepwise serve` runs: attaches with the code, asks, hears what comes, and comes
// back by itself when the line is lost. Owned by whoever attaches; its thread's event loop must turn.
#pragma once
#include "projects/remote/state_json.h"

#include <QSslCertificate>
#include <QSslSocket>
#include <QTimer>
#include <QUrl>
#include <QWebSocket>

#include <map>

namespace plc::editor {

class RemoteController final : public QObject {
    Q_OBJECT
public:
    struct Address {
        QUrl url;          // http://127.0.0.1:8080/ or https://…
        QString code;      // of the file attach-code there
        QString trustFile; // PEM: a certificate that is trusted besides those of the system; empty: none
        QString name;      // who attaches, for the journal there
    };
    enum class State { Detached, Connecting, Attached, Lost };

    explicit RemoteController(QObject* parent = nullptr);
    ~RemoteController() override;

    /// What is wrong with the address, found without asking anybody.
    [[nodiscard]] Result<void> attach(Address address);
    void detach();
    [[nodiscard]] State state() const { return m_state; }
    /// Why it is not attached.
    [[nodiscard]] const Message& problem() const { return m_problem; }
    [[nodiscard]] const Address& address() const { return m_address; }
    [[nodiscard]] QString host() const { return m_address.url.host(); }
    [[nodiscard]] QString project() const { return m_project; }
    [[nodiscard]] bool mayHalt() const { return m_mayHalt; }

    using Answer = std::function<void(const Result<remote::Json>& answer)>;
    /// `then` is called once: with the answer, or with why there is none.
    void ask(remote::Json request, Answer then = {});

signals:
    void stateChanged();
    void eventArrived(const plc::remote::Json& event);
    void bytesArrived(const QByteArray& bytes);

private:
    void open();
    void take(const QString& text);
    void takeBytes(const QByteArray& packed);
    void greet();
    void lose(Message why);
    void loseUnlessTls(Message why);
    Message whyNot(QAbstractSocket::SocketError error, const QString& words) const;
    void loseUnreached(const QWebSocket& socket);
    int port() const;
    std::string place() const;
    void forgetSockets();
    void setState(State state);
    void refuseAll(const Message& why);
    Address m_address;
    QList<QSslCertificate> m_trusted;
    State m_state = State::Detached;
    Message m_problem;
    QString m_project;
    bool m_mayHalt = false, m_comesBack = false;
    bool m_isReached = false; // something took what we sent
    std::unique_ptr<QWebSocket> m_socket;
    std::unique_ptr<QSslSocket> m_probe; // asks whether it speaks TLS there
    QTimer m_again, m_silence;
    int m_wait = 0; // ms, before the next try
    uint64_t m_last = 0;
    std::map<uint64_t, Answer> m_open;
};

} // namespace plc::editor
