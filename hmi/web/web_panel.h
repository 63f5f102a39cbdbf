// One browser's panel: a player of its own with panel, language and rights, what the browser does there, and what it
// must be sent. Knows no network: the server hands messages in and takes frames out. Main thread; project, session and
// store must outlive it.
#pragma once
#include "hmi/player/keypad.h"
#include "hmi/web/client_message.h"
#include "hmi/web/panel_stream.h"

#include <QObject>
#include <QPointer>

namespace plc::hmi::web {

/// What people open: the start panel, then the others; not the frame, nor what is only placed or opened with
/// parameters.
QStringList pagesOf(const PanelProject& project);

class WebPanel final : public QObject {
    Q_OBJECT
public:
    /// `keeper` keeps the alarms of all browsers.
    WebPanel(const PanelProject& project, session::Run& run, PaintStore& store, OperatorStation& keeper);
    ~WebPanel() override;

    /// False: the message makes no sense here, and who sends it is not a browser of ours.
    [[nodiscard]] bool take(const ClientMessage& message);
    /// Whether this browser may operate, since somebody logged in; `name` is shown and recorded.
    void setOperator(const QString& name);
    /// A note for whoever operates here: the controller refused a write.
    void tell(const QString& reason);
    bool isOperator() const { return !m_station.isLocked(); }
    /// The project has users: they log in by name and password, on the page or on the panel, and have their rights.
    bool hasPeople() const { return !m_project.people.isEmpty(); }
    /// Who checks their passwords.
    void setDoor(OperatorStation::Door door) { m_station.setDoor(std::move(door)); }
    LogIn::Answer logIn(const QString& user, const QString& password) { return m_player.logIn(user, password); }
    void logOut();
    QString words(SystemText text) const { return m_station.say(text); }

    struct Output {
        QList<QByteArray> texts; // JSON
        QByteArray frame;        // drawing commands; empty: nothing changed
        bool isEmpty() const { return texts.isEmpty() && frame.isEmpty(); }
    };
    /// What is new since the last call, at a time in ms of any epoch.
    Output next(qint64 milliseconds);
    uint32_t frameNumber() const { return m_stream.number(); }
    PanelPlayer& player() { return m_player; }

private:
    bool isInside(QPointF at) const;
    bool point(const ClientMessage& message);
    void pointOverlay(const ClientMessage& message, Overlay& overlay);
    void key(const QString& name);
    void activate(size_t index);
    void letGo();
    QByteArray describe();
    /// What decides how the panel looks, for those who only watch; empty: it is this person's own.
    QString viewName() const;
    void tellState(const QString& state, bool isBad, Output& out);
    /// What is touched must be what the values are now.
    void catchUp();
    const PanelProject& m_project;
    PanelPlayer m_player;       // draws
    OperatorStation& m_station; // what is done on it
    PanelStream m_stream;
    QString m_operator, m_refusal, m_state;
    QPointer<QWidget> m_held; // of an overlay
    bool m_isStarted = false, m_isNew = true, m_isBad = false;
    bool m_isTouched = false; // since the panel is shown: pages and lists may be other ones than on other screens
    bool m_isBehind = false;  // the last frame was another browser's
    int m_sharpness = 1;
    qint64 m_wordsAt = -1, m_at = 0;
};

} // namespace plc::hmi::web
