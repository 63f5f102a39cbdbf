// An attached controller as a session that the studio shows like its own: builds the program that runs there, mirrors
// its scans and state, and sends it what is asked of the session. Owned by whoever attaches; its thread is the GUI
// thread, orders may come from any.
#pragma once
#include "editor/remote/remote_controller.h"
#include "projects/remote/scan_stream.h"

#include <thread>

namespace plc::editor {

class AttachedRun final : public QObject {
    Q_OBJECT
public:
    explicit AttachedRun(QObject* parent = nullptr);
    ~AttachedRun() override;

    [[nodiscard]] RemoteController& controller() { return m_controller; }
    [[nodiscard]] const RemoteController& controller() const { return m_controller; }
    void setHistoryBudget(size_t bytes) { m_historyBudget = bytes; }

signals:
    /// Made once for an attachment; the receiver takes it with takeSession().
    void sessionReady();
    void failed(const plc::Message& why);

public:
    [[nodiscard]] std::unique_ptr<session::Session> takeSession() { return std::move(m_made); }
    /// The owner of the session lets it go: nothing is fed any more.
    void forget() { m_mirror.reset(), m_session = nullptr, m_made.reset(); }

private:
    class Orders;
    void adopt();
    void fetchProgram();
    struct There {
        uint64_t version = 0, layout = 0; // of the program that runs there, as it names them
    };
    void built(std::shared_ptr<driver::Built> built, There there);
    void hear(const remote::Json& event);
    void takeBytes(const QByteArray& bytes);
    void carry(session::Order order);
    void report(const Result<remote::Json>& answer);
    RemoteController m_controller;
    std::shared_ptr<Orders> m_orders;
    std::unique_ptr<session::Session> m_made;
    session::Session* m_session = nullptr;
    std::optional<session::Mirror> m_mirror;
    remote::ScanReader m_reader;
    uint64_t m_version = 0, m_wanted = 0; // what is followed, and the program that runs there
    uint64_t m_present = 0;               // that the mirror's program is
    size_t m_historyBudget = size_t(256) << 20;
    std::jthread m_builder;
};

} // namespace plc::editor
